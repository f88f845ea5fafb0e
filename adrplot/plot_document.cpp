#include "adrplot/plot_document.hpp"

#include "adrplot/accuracy_page.hpp"
#include "adrplot/csv_document.hpp"
#include "adrplot/h5_document.hpp"
#include "adrplot/known_values.hpp"
#include "adrplot/run_beside.hpp"
#include "adrplot/study_document.hpp"
#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "base/json_text.hpp"
#include "desktop/static_pages.hpp"
#include "results/channels.hpp"
#include "results/full_precision.hpp"
#include "results/sweep_table.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>
#include <set>
#include <string>

namespace adore::adrplot {
namespace {

PlotDocument::Entry entry_of(const PageSpec& page) {
  PlotDocument::Entry out{page.title, page.kind};
  for (const PanelSpec& panel : page.panels) out.panels.push_back(panel.title);
  for (const PanelSpec& panel : page.panels) {
    if (page.kind != PageKind::History) continue;
    std::vector<std::string>& names = out.curves.emplace_back();
    for (const CurveSpec& curve : panel.curves) names.push_back(curve.name);
  }
  return out;
}

/// Panels of a page without extremes between their values.
struct Unknown {
  bool all = true;     ///< nothing has any
  std::string titles;  ///< of panels, "\"Gap\" and \"Contact angle\""
};
Unknown unknown_between(const desktop::ChartPage& page) {
  Unknown out;
  std::vector<std::string> titles;
  for (const desktop::ChartPanel& panel : page.panels) {
    bool unknown = false;
    for (const desktop::ChartCurve& curve : panel.curves) {
      const auto has = [](const std::vector<double>& values) {
        return std::any_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
      };
      if (has(curve.high))
        out.all = false;
      else
        unknown = unknown || has(curve.y);
    }
    if (unknown) titles.push_back(panel.title);
  }
  for (std::size_t i = 0; i < titles.size(); ++i) {
    if (i > 0) out.titles += i + 1 == titles.size() ? " and " : ", ";
    out.titles += fmt::format("\"{}\"", titles[i]);
  }
  out.all = out.all && !titles.empty();
  return out;
}

/// A file that omits steps of the run contains no extremes of these steps except those drawn as
/// bands: note for a page with other curves.
std::string between_steps(const desktop::ChartPage& page, const results::SolFile& file) {
  if (file.steps.size() < 2) return {};
  std::vector<long> apart;
  for (std::size_t i = 1; i < file.steps.size(); ++i)
    apart.push_back(file.steps[i].step - file.steps[i - 1].step);
  std::nth_element(apart.begin(), apart.begin() + std::ssize(apart) / 2, apart.end());
  const long every = apart[apart.size() / 2];
  if (every < 2) return {};
  const Unknown unknown = unknown_between(page);
  if (unknown.all)
    return fmt::format("One of every {} steps is stored: peaks between stored steps are missing.",
                       every);
  if (unknown.titles.empty()) return {};
  return fmt::format(
      "One of every {} steps is stored: peaks of {} between stored steps are missing.", every,
      unknown.titles);
}

/// Of a range that passes over stored steps.
std::string left_out(const desktop::ChartPage& page, std::size_t steps, long every) {
  const Unknown unknown = unknown_between(page);
  return fmt::format("Shown: {} of the steps in the file (one of every {}){}.", steps, every,
                     unknown.all ? "; peaks between them are missing"
                     : unknown.titles.empty()
                         ? ""
                         : "; peaks of " + unknown.titles + " between them are missing");
}

/// Steps that are drawn from RESULTS.h5.
struct DigitWords {
  std::string subtitle, note;
};
DigitWords digit_words(const results::SolFile& file, const results::FullPrecisionStatus& digits) {
  const std::string name = file.path.filename().string();
  const std::size_t own = file.steps.size() - digits.added;
  DigitWords out{"full precision (RESULTS.h5)", {}};
  if (digits.added > 0) {
    const long first = file.steps[own].step, last = file.steps.back().step;
    out.note = (first == last
                    ? fmt::format("Step {} is", first)
                    : fmt::format("The last {} steps, {} to {}, are", digits.added, first, last)) +
               fmt::format(" only in RESULTS.h5: {} ends at step {}.", name,
                           std::max(file.last_step, file.steps[own - 1].step));
  }
  if (digits.more)
    out.note += (out.note.empty() ? "" : " ") +
                fmt::format("RESULTS.h5 has more steps after step {} that do not fit in memory.",
                            file.steps.back().step);
  if (digits.exact == own) return out;
  if (digits.from_start) {
    const long last = file.steps[digits.exact - 1].step;
    out.subtitle = fmt::format("full precision (RESULTS.h5) to step {}", last);
    out.note += (out.note.empty() ? "" : " ") +
                fmt::format("RESULTS.h5 ends at step {}: later values have eight digits ({}).",
                            digits.end, name);
  } else {
    out.subtitle = fmt::format("full precision (RESULTS.h5) for {} of {} steps", digits.exact, own);
    out.note += (out.note.empty() ? "" : " ") + fmt::format(
                                                    "RESULTS.h5 lacks {} of the {} steps: the "
                                                    "values of these steps have eight digits ({}).",
                                                    own - digits.exact, own, name);
  }
  return out;
}

/// A file whose pages do not depend on the view.
PlotDocument document_of(const std::filesystem::path& path, std::string subject,
                         std::vector<desktop::ChartPage> pages) {
  PlotDocument out;
  out.path = path;
  out.subject = std::move(subject);
  const auto count = pages.size();
  for (std::size_t i = 0; i < count; ++i) {
    out.pages.push_back({pages[i].title, PageKind::Chart});
    PlotDocument::Entry& entry = out.pages.back();
    for (const desktop::ChartPanel& panel : pages[i].panels) {
      entry.panels.push_back(panel.title);
      if (pages[i].equal_axes || pages[i].study) continue;
      std::vector<std::string>& names = entry.curves.emplace_back();
      for (const desktop::ChartCurve& curve : panel.curves) names.push_back(curve.name);
    }
    pages[i].subtitle +=
        fmt::format("   ·   {}   ·   page {} of {}", path.filename().string(), i + 1, count);
  }
  out.build = [path, pages = std::move(pages)](int number, const PageOptions&) {
    check_page_number(path, number, pages.size());
    return pages[static_cast<std::size_t>(number - 1)];
  };
  return out;
}

/// The pages of a step file. If the values of all pages need too much memory, only those of the
/// current and following pages are read, as many as fit.
class StepPages {
 public:
  StepPages(std::filesystem::path path, const results::SolRange& range, std::size_t most_values,
            results::ReadWatch watch)
      : path_(std::move(path)), range_(range), most_(most_values), watch_(std::move(watch)) {
    results::SolRange one = range;
    one.to = one.from;
    file_ = results::read_sol(path_, one);
    pages_ = plot_pages(file_.kind, file_.header);
    std::error_code ignored;
    // A value needs at least 16 characters.
    const std::uintmax_t stored =
        std::filesystem::file_size(path_, ignored) / (16U * std::max(file_.header.value_count, 1));
    const auto asked = static_cast<std::uintmax_t>((range.to - range.from) / range.every + 1);
    steps_ = static_cast<std::size_t>(std::min(stored, asked)) + 1;
    read(1);
  }
  [[nodiscard]] const results::SolFile& file() const { return file_; }
  [[nodiscard]] const std::vector<PageSpec>& pages() const { return pages_; }
  [[nodiscard]] RunMotion motion() const { return motion_of(file_, context_); }

  desktop::ChartPage build(int number, const PageOptions& options) {
    check_page_number(path_, number, pages_.size());
    const std::set<std::size_t> wanted = columns_of(number);
    if (!whole_ ||
        (!file_.columns.empty() &&
         !std::includes(file_.columns.begin(), file_.columns.end(), wanted.begin(), wanted.end())))
      read(number);
    read_min_max_bands(file_, curves_of(number), context_);
    desktop::ChartPage page = build_page(file_, pages_, number, options, context_);
    const auto note = [&page](const std::string& text) {
      page.note += (page.note.empty() ? "" : " ") + text;
    };
    const bool history = pages_[static_cast<std::size_t>(number - 1)].kind == PageKind::History &&
                         options.domain == Domain::History;
    if (const std::string lost = between_steps(page, file_);
        history && range_.every == 1 && !lost.empty())
      note(lost);
    if (range_.every > 1) note(left_out(page, file_.steps.size() - digits_.added, range_.every));
    if (!file_.gaps.empty())
      note((file_.part ? "In these steps " : "In this file ") + file_.gaps + ".");
    if (file_.more)
      note(fmt::format("Shown: stored steps {} to {} (the file contains more steps).", range_.from,
                       range_.to));
    else if (range_.from > 1)
      note(fmt::format("Shown: stored steps from number {} to the end.", range_.from));
    std::error_code ignored;
    if (digits_.why_not.empty()) {
      if (const std::string whose = whose_pocket(number); !whose.empty()) note(whose);
      const DigitWords words = digit_words(file_, digits_);
      page.subtitle += "   ·   " + words.subtitle;
      if (!words.note.empty()) note(words.note);
    } else if (std::filesystem::exists(path_.parent_path() / "RESULTS.h5", ignored)) {
      note("The values have eight digits: " + digits_.why_not + ".");
    }
    return page;
  }

 private:
  [[nodiscard]] std::set<std::size_t> curves_of(int number) const {
    std::set<std::string> ids;
    for (const PanelSpec& panel : pages_[static_cast<std::size_t>(number - 1)].panels)
      for (const CurveSpec& curve : panel.curves) ids.insert(curve.column);
    return places_of(ids);
  }
  [[nodiscard]] std::set<std::size_t> places_of(const std::set<std::string>& ids) const {
    const std::vector<results::SolColumn> columns = results::sol_columns(file_.header);
    std::set<std::size_t> out;
    for (std::size_t c = 0; c < columns.size(); ++c)
      if (ids.contains(columns[c].id)) out.insert(c);
    return out;
  }
  /// Number of the pocket of a segment's page, from RESULTS.h5.
  [[nodiscard]] std::string whose_pocket(int number) const {
    if (file_.kind != results::SolKind::Cage || file_.header.segments < 2) return {};
    const std::vector<results::SolColumn> columns = results::sol_columns(file_.header);
    for (const std::size_t c : curves_of(number)) {
      if (!columns[c].id.starts_with("pocket.force.")) continue;
      const auto row = static_cast<int>(columns[c].at) / std::max(file_.header.pocket_surfaces, 1);
      return row < file_.header.elements
                 ? fmt::format("This is the pocket of rolling element {}.", row + 1)
                 : "This pocket is the half pocket at the end of its segment.";
    }
    return {};
  }
  /// Columns of its curves and of its notes.
  [[nodiscard]] std::set<std::size_t> columns_of(int number) const {
    const PageSpec& page = pages_[static_cast<std::size_t>(number - 1)];
    std::set<std::string> ids;
    for (const PanelSpec& panel : page.panels)
      for (const CurveSpec& curve : panel.curves) ids.insert(curve.column);
    for (const std::string& id : auxiliary_columns(file_.kind, page)) ids.insert(id);
    for (const std::string& id : std::set<std::string>(ids))
      for (const std::string& source : ValidColumns::required_columns(id)) ids.insert(source);
    return places_of(ids);
  }
  void read(int first_page) {
    results::SolRange range = range_;
    if (steps_ * static_cast<std::size_t>(std::max(file_.header.value_count, 1)) > most_) {
      std::set<std::size_t> columns = columns_of(first_page);
      for (int number = first_page + 1; number <= static_cast<int>(pages_.size()); ++number) {
        std::set<std::size_t> more = columns_of(number);
        more.insert(columns.begin(), columns.end());
        if (steps_ * more.size() > most_) break;
        columns = std::move(more);
      }
      range.columns.assign(columns.begin(), columns.end());
    }
    whole_ = false;
    file_.steps = {};  // their room is needed
    file_.columns = {};
    file_ = results::read_sol(path_, range, watch_);
    whole_ = true;
    // Only of a whole file its end is known to be the file's.
    const std::size_t held =
        file_.steps.size() *
        std::max<std::size_t>(1, file_.columns.empty()
                                     ? static_cast<std::size_t>(file_.header.value_count)
                                     : file_.columns.size());
    const bool to_the_end = !file_.more && range_.to == results::SolRange().to;
    const std::size_t room = to_the_end && most_ > held && !file_.steps.empty()
                                 ? (most_ - held) / (held / file_.steps.size())
                                 : 0;
    digits_ = results::use_full_precision(file_, room);
    context_ = page_context_of(file_);
  }

  std::filesystem::path path_;
  results::SolRange range_;
  std::size_t most_, steps_ = 0;
  results::ReadWatch watch_;
  bool whole_ = false;  ///< else reading was stopped
  std::vector<PageSpec> pages_;
  results::SolFile file_;
  PageContext context_;
  results::FullPrecisionStatus digits_;
};

/// The quasi-static solution; of a run with motion alone its channels.
PlotDocument open_run_json(const std::filesystem::path& path, const results::SolRange& range,
                           std::size_t most_values) {
  const std::filesystem::path channels = path.parent_path() / "RESULTS.h5";
  std::error_code ignored;
  if (path.filename() == "RUN.json" && std::filesystem::exists(channels, ignored)) {
    const nlohmann::json run = parse_json(read_text_file(path), path.string());
    if (run.is_object() && !run.contains("quasi_static") && !run.contains("thermal_network"))
      return open_h5(channels, range, most_values);
  }
  return document_of(path, "quasi-static solution",
                     desktop::static_pages(results::read_static_tables(path)));
}

}  // namespace

bool has_steps(const std::filesystem::path& path) {
  return path.extension() != ".json" && path.extension() != ".h5" &&
         path.extension() != ".adrplot" && path.extension() != ".csv" && !is_study(path);
}

PlotDocument make_document(results::SolFile file) {
  PlotDocument out;
  out.path = file.path;
  out.subject = subject(file.kind, file.header);
  out.note = file.note;
  const std::vector<PageSpec> pages = plot_pages(file.kind, file.header);
  for (const PageSpec& page : pages) out.pages.push_back(entry_of(page));
  const auto shared = std::make_shared<const results::SolFile>(std::move(file));
  out.build = [shared, pages](int number, const PageOptions& options) {
    return build_page(*shared, pages, number, options);
  };
  out.motion = [shared] { return motion_of(*shared, {}); };
  return out;
}

PlotDocument open_document(const std::filesystem::path& path, const results::SolRange& range,
                           std::size_t most_values, const results::ReadWatch& watch) {
  reject_special_file(path);
  if (is_study(path)) return open_study(path);
  if (is_accuracy_file(path)) return document_of(path, "accuracy study", accuracy_pages(path));
  if (path.extension() == ".h5") return open_h5(path, range, most_values);
  if (path.extension() == ".json") return open_run_json(path, range, most_values);
  if (path.extension() == ".csv" && path.filename() != "SWEEP.csv" && !results::is_sweep(path))
    return open_csv(path);
  if (path.extension() == ".csv") {
    const results::SweepTable sweep = results::read_sweep(path);
    return document_of(path, "sweep of " + sweep.variable, desktop::sweep_pages(sweep));
  }
  const auto steps = std::make_shared<StepPages>(path, range, most_values, watch);
  PlotDocument out;
  out.path = path;
  out.subject = subject(steps->file().kind, steps->file().header);
  out.note = steps->file().note;
  for (const PageSpec& page : steps->pages()) out.pages.push_back(entry_of(page));
  out.build = [steps](int number, const PageOptions& options) {
    return steps->build(number, options);
  };
  out.motion = [steps] { return steps->motion(); };
  return out;
}

std::filesystem::path run_folder(const std::filesystem::path& file) {
  return std::filesystem::absolute(file).lexically_normal().parent_path();
}

}  // namespace adore::adrplot
