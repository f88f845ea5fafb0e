#include "adrplot/render.hpp"

#include "adrplot/folder_files.hpp"
#include "adrplot/waterfall_page.hpp"
#include "base/errors.hpp"
#include "desktop/chart_scene.hpp"
#include "desktop/image_export.hpp"

#include <QImage>
#include <fmt/format.h>

#include <algorithm>

namespace adore::adrplot {

namespace fs = std::filesystem;

void set_domain(PageOptions& view, const std::string& domain, const std::string& curve) {
  view.domain = domain == "waterfall"  ? Domain::Waterfall
                : domain == "spectrum" ? Domain::Spectrum
                                       : Domain::History;
  if (!curve.empty() && view.domain != Domain::Waterfall)
    throw InputError("--curve says which curve a waterfall is of: give --domain waterfall with it");
  view.waterfall_of = curve;
}

namespace {

/// Draws the pages that are wanted; of others, without the curve that is, the curves are noted.
std::vector<fs::path> draw_document(const PlotDocument& document, const std::string& stem,
                                    const RenderOptions& options, std::string& others) {
  std::vector<fs::path> written;
  desktop::ChartScene scene;
  scene.setTheme(
      desktop::theme(options.dark ? desktop::ThemeKind::Dark : desktop::ThemeKind::Light));
  const int first = options.page == 0 ? 1 : options.page;
  const int last = options.page == 0 ? static_cast<int>(document.pages.size()) : options.page;
  for (int number = first; number <= last; ++number) {
    scene.setPageSize(QSizeF(options.width, options.height));
    desktop::ChartPage page = document.build(number, options.view);
    // Of a curve that is asked for by its name the pages that have it are wanted.
    if (!options.view.waterfall_of.empty() && !choice_of(page.choices, options.view.waterfall_of)) {
      for (const std::string& choice : page.choices)
        others += (others.empty() ? "" : "; ") + choice;
      continue;
    }
    if (!document.note.empty() && !page.panels.empty())
      page.note = "Incomplete file: " + document.note + ". " + page.note;
    scene.setPage(std::move(page));
    const fs::path path = options.folder / fmt::format("{}-page-{:02}.png", stem, number);
    desktop::save_image(scene.image({options.width, options.height}), path);
    written.push_back(path);
  }
  return written;
}

void refuse_curve(const std::string& files, const RenderOptions& options,
                  const std::string& others) {
  throw InputError(
      fmt::format("{} has no curve \"{}\" for a waterfall{}{}", files, options.view.waterfall_of,
                  options.page == 0 ? std::string() : fmt::format(" on page {}", options.page),
                  others.empty() ? std::string() : "; it has: " + others));
}

}  // namespace

std::vector<fs::path> render_document(const PlotDocument& document, const std::string& stem,
                                      const RenderOptions& options) {
  std::string others;
  std::vector<fs::path> written = draw_document(document, stem, options, others);
  if (written.empty() && !options.view.waterfall_of.empty())
    refuse_curve(document.path.string(), options, others);
  return written;
}

std::vector<fs::path> render_plots(const std::vector<fs::path>& paths,
                                   const RenderOptions& options) {
  std::vector<fs::path> files;
  for (const fs::path& path : paths)
    for (fs::path& file : files_of(path)) files.push_back(std::move(file));
  desktop::make_folder(options.folder);
  std::vector<fs::path> written;
  std::string others;
  for (const auto& path : files) {
    const PlotDocument document = open_document(path, options.range);
    const bool twin = std::count_if(files.begin(), files.end(), [&](const fs::path& other) {
                        return other.filename() == path.filename();
                      }) > 1;
    const std::string folder = run_folder(path).filename().string();
    fs::path name = path.filename();
    if (name.empty()) name = path.parent_path().filename();  // "clearance.study/"
    const std::string stem = (twin ? folder + "-" : "") + name.string();
    const auto pictures = draw_document(document, stem, options, others);
    written.insert(written.end(), pictures.begin(), pictures.end());
    if (options.progress)
      options.progress(&path - files.data() + 1, static_cast<long>(files.size()));
  }
  if (written.empty() && !options.view.waterfall_of.empty())
    refuse_curve(files.size() == 1 ? files.front().string() : "None of the files", options, others);
  return written;
}

}  // namespace adore::adrplot
