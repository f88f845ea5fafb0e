#include "cli/pictures/gallery.hpp"

#include "adrplot/finding_pages.hpp"
#include "adrplot/plot_document.hpp"
#include "agore/render.hpp"
#include "base/counted.hpp"
#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "base/terminal_text.hpp"
#include "base/write_folder.hpp"
#include "cli/progress.hpp"
#include "deck/templates.hpp"
#include "desktop/bootstrap.hpp"
#include "desktop/chart_scene.hpp"
#include "desktop/command_line.hpp"
#include "desktop/few_colours.hpp"
#include "desktop/findings_bar.hpp"
#include "desktop/image_export.hpp"
#include "desktop/text_faults.hpp"
#include "results/run_findings.hpp"
#include "results/run_folder.hpp"
#include "runs/run.hpp"
#include "runs/temporary_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace adore::cli {

namespace fs = std::filesystem;

namespace {

/// Of charts in a gallery: a third fewer bytes than with 256, and no eye sees the difference.
/// Shaded bodies need them all, and mixtures of them.
constexpr std::size_t kColoursOfPages = 24;

/// Draws into one folder and records the titles of the pictures.
class Gallery {
 public:
  Gallery(WriteFolder folder, const GalleryRequest& request)
      : folder_(std::move(folder)), dark_(request.dark), size_(desktop::parse_size(request.size)) {
    scene_.setTheme(desktop::theme(dark_ ? desktop::ThemeKind::Dark : desktop::ThemeKind::Light));
    scene_.setPageSize(QSizeF(size_.width, size_.height));
  }

  void pages(const fs::path& file) {
    const adrplot::PlotDocument document = adrplot::open_document(file);
    // One rolling element's pages are those of all.
    const bool element = document.subject.starts_with("rolling element");
    if (element && element_drawn_) return;
    element_drawn_ = element_drawn_ || element;
    for (int number = 1; number <= static_cast<int>(document.pages.size()); ++number) {
      const auto& entry = document.pages[static_cast<std::size_t>(number - 1)];
      // The other pockets' pages are the same.
      if (entry.title.starts_with("Pocket ") && !entry.title.starts_with("Pocket 1 ")) continue;
      page(document, number, {}, "", entry.title);
    }
    if (file.filename() == "SOL1" && document.pages.size() > 5) {
      adrplot::PageOptions options;
      options.domain = adrplot::Domain::Spectrum;
      page(document, 6, options, "-spectrum", document.build(6, options).title);
      options.domain = adrplot::Domain::Spectrogram;
      page(document, 6, options, "-spectrogram", document.build(6, options).title);
    }
  }

  void views(const fs::path& file) {
    agore::MotionPicture picture = agore::open_animation(file);
    const agore::Animation& animation = picture.animation();
    const std::vector<Finding> findings = results::run_findings(file);
    const auto frame = static_cast<int>(0.4 * static_cast<double>(picture.frames())) + 1;
    using agore::View;
    const auto draw = [&](const std::string& name, agore::ViewOptions options) {
      options.dark = dark_;
      if (!agore::why_not(options.view, animation).empty()) return;
      const WritePath path(folder_, "view-" + name + ".png");
      desktop::save_image(desktop::dither_colors(desktop::image_with_findings(
                              {size_.width, size_.height}, findings, dark_,
                              [&](QSize size) {
                                return picture.image(size, static_cast<std::size_t>(frame - 1),
                                                     options);
                              })),
                          path);
      list_.emplace_back(path.name(), agore::view_title(options.view));
    };
    const auto plain = [](View view) {
      agore::ViewOptions options;
      options.view = view;
      return options;
    };
    for (const auto& [name, view] : {std::pair<const char*, View>{"bearing", View::Bearing},
                                     {"cage", View::Cage},
                                     {"pocket", View::Pocket},
                                     {"element", View::Element},
                                     {"outer-race", View::OuterRace},
                                     {"inner-race", View::InnerRace},
                                     {"section", View::Section},
                                     {"3d", View::Solid}})
      draw(name, plain(view));
    for (const std::size_t race : {0U, 1U}) {
      if (!agore::has_flange(animation, race, 0) && !agore::has_flange(animation, race, 1))
        continue;
      agore::ViewOptions options = plain(View::Flange);
      options.flange_race = race;
      draw(race == 0 ? "outer-flange" : "inner-flange", options);
    }
    agore::ViewOptions loads = plain(View::Bearing);
    loads.contacts = loads.trails = true;
    loads.colour = agore::ColourBy::Load;
    draw("loads", loads);
    loads.view = View::Solid;
    loads.colour = agore::ColourBy::Slip;
    draw("3d-slip", loads);
    agore::ViewOptions four = plain(View::Bearing);
    for (const View view : {View::Solid, View::Section, View::Pocket})
      if (agore::why_not(view, animation).empty()) four.beside.push_back({view});
    if (!four.beside.empty()) draw("four", four);
  }

  [[nodiscard]] const std::vector<std::pair<std::string, std::string>>& list() const {
    return list_;
  }

 private:
  void page(const adrplot::PlotDocument& document, int number, const adrplot::PageOptions& options,
            const std::string& ending, const std::string& title) {
    scene_.setPage(document.build(number, options));
    const WritePath path(folder_, fmt::format("{}-page-{:02}{}.png",
                                              document.path.filename().string(), number, ending));
    desktop::save_image(desktop::reduce_colors(desktop::image_with_findings(
                                                   {size_.width, size_.height},
                                                   results::run_findings(document.path), dark_,
                                                   [&](QSize size) {
                                                     scene_.setPageSize(QSizeF(size));
                                                     return scene_.image(size);
                                                   },
                                                   adrplot::page_concerns(title, document.subject)),
                                               kColoursOfPages),
                        path);
    for (const std::string& fault : desktop::text_faults(scene_))
      print(stderr, "adore: note: {}: {}\n", path.path().string(), fault);
    list_.emplace_back(path.name(),
                       fmt::format("{}: {}", document.path.filename().string(), title));
  }

  WriteFolder folder_;
  bool dark_, element_drawn_ = false;
  desktop::PictureSize size_;
  desktop::ChartScene scene_;
  std::vector<std::pair<std::string, std::string>> list_;
};

void make_run(const std::string& deck, const fs::path& folder) {
  desktop::make_folder(folder);
  const fs::path file = folder / "DATA.txt";
  write_file_atomically(file, deck::template_text(deck));
  runs::RunRequest request;
  request.deck = file;
  (void)runs::run(request);
}

/// Drawable parts of a run.
void draw_run(Gallery& gallery, const fs::path& run) {
  const results::PlottableFiles files = results::run_folder(run);
  bool any = !files.plots.empty();
  for (const fs::path& file : files.plots) gallery.pages(file);
  if (files.animation)
    gallery.views(*files.animation), any = true;
  else if (any && fs::exists(run / "RESULTS.h5"))
    gallery.views(run / "RESULTS.h5");
  if (!any && fs::exists(run / "RUN.json")) gallery.pages(run / "RUN.json"), any = true;
  if (!any)
    throw InputError(run.string() +
                     " contains nothing to draw; give folders of runs. Without a folder, the "
                     "example decks are drawn");
}

}  // namespace

void draw_gallery(const GalleryRequest& request) {
  desktop::ensure_headless_application();
  const fs::path out(request.out);
  desktop::make_folder(out);
  const WriteFolder place(out);
  std::vector<std::pair<std::string, fs::path>> runs;
  const runs::TemporaryFolder temporary;
  constexpr std::array<const char*, 9> kExamples{"ball",
                                                 "cylindrical",
                                                 "spherical",
                                                 "tapered",
                                                 "spherical-tapered",
                                                 "deep-groove-6205",
                                                 "cylindrical-nu209",
                                                 "spherical-22210",
                                                 "tapered-30208"};
  if (request.runs.empty()) {
    const fs::path& folder = temporary.path();
    for (const char* name : kExamples) runs.emplace_back(name, folder / name);
  } else {
    for (const std::string& run : request.runs)
      runs.emplace_back(fs::weakly_canonical(run).filename().string(), run);
  }
  const auto progress = make_count_progress("run", request.progress);
  std::string index = fmt::format(
      "# Gallery\n\nAll pages of AdrPlot and all views of AGORE for each run. Created by "
      "`adore gallery --out DIR --size {}{}`.\n",
      request.size, request.dark ? " --dark" : "");
  long done = 0;
  for (const auto& [name, run] : runs) {
    if (request.runs.empty()) make_run(name, run);
    Gallery gallery(place.folder(name), request);
    draw_run(gallery, run);
    index += fmt::format("\n## {}\n\n", name);
    for (const auto& [file, title] : gallery.list())
      index += fmt::format("![{}]({}/{})\n", title, name, file);
    if (progress) progress(++done, static_cast<long>(runs.size()));
    print("{}: {}\n", (out / name).string(), counted(gallery.list().size(), "picture"));
  }
  const WritePath page(place, "README.md");
  check_writable_file(page);
  if (InputFile old(page.path()); old) {
    std::string first;
    if (std::getline(old, first) && first != "# Gallery")
      throw InputError(
          page.path().string() +
          " exists and is not the index of a gallery; move it, or give another folder");
  }
  write_file_atomically(page, index);
}

}  // namespace adore::cli
