#include "adrplot/plot_document.hpp"

#include "adrplot/static_pages.hpp"
#include "base/errors.hpp"
#include "results/full_precision.hpp"

#include <fmt/format.h>

#include <memory>

namespace adore::adrplot {
namespace {

/// A file whose pages do not depend on the view.
PlotDocument document_of(const std::filesystem::path& path, std::string subject,
                         std::vector<desktop::ChartPage> pages) {
  PlotDocument out;
  out.path = path;
  out.subject = std::move(subject);
  const auto count = pages.size();
  for (std::size_t i = 0; i < count; ++i) {
    out.pages.push_back({pages[i].title, PageKind::Chart});
    pages[i].subtitle +=
        fmt::format("   ·   {}   ·   page {} of {}", path.filename().string(), i + 1, count);
  }
  out.build = [path, pages = std::move(pages)](int number, const PageOptions&) {
    check_page_number(path, number, pages.size());
    return pages[static_cast<std::size_t>(number - 1)];
  };
  return out;
}

}  // namespace

bool has_steps(const std::filesystem::path& path) {
  return path.extension() != ".json" && path.extension() != ".csv";
}

PlotDocument make_document(results::SolFile file) {
  PlotDocument out;
  out.path = file.path;
  out.subject = subject(file.kind, file.header);
  out.note = file.note;
  const std::vector<PageSpec> pages = plot_pages(file.kind, file.header);
  for (const PageSpec& page : pages) out.pages.push_back({page.title, page.kind});
  const auto shared = std::make_shared<const results::SolFile>(std::move(file));
  out.build = [shared, pages](int number, const PageOptions& options) {
    return build_page(*shared, pages, number, options);
  };
  return out;
}

PlotDocument open_document(const std::filesystem::path& path, const results::SolRange& range) {
  if (path.extension() == ".json")
    return document_of(path, "quasi-static solution",
                       static_pages(results::read_static_tables(path)));
  if (path.extension() == ".csv") {
    const results::SweepTable sweep = results::read_sweep(path);
    return document_of(path, "sweep of " + sweep.variable, sweep_pages(sweep));
  }
  results::SolFile file = results::read_sol(path, range);
  const std::string more =
      file.more
          ? fmt::format("Stored steps {} to {}; more follow in the file.", range.from, range.to)
          : std::string();
  const std::string why_not = results::use_full_precision(file);
  std::error_code ignored;
  const bool beside = std::filesystem::exists(path.parent_path() / "RESULTS.h5", ignored);
  PlotDocument out = make_document(std::move(file));
  if (!why_not.empty() && !beside && more.empty()) return out;
  out.build = [build = std::move(out.build), why_not, beside, more](int number,
                                                                    const PageOptions& options) {
    desktop::ChartPage page = build(number, options);
    const auto note = [&page](const std::string& text) {
      page.note += (page.note.empty() ? "" : " ") + text;
    };
    if (!more.empty()) note(more);
    if (why_not.empty())
      page.subtitle += "   ·   all digits from RESULTS.h5";
    else if (beside)
      note("Eight digits: " + why_not + ".");
    return page;
  };
  return out;
}

}  // namespace adore::adrplot
