#include "cli/pictures/drawing.hpp"

#include "adrplot/accuracy_page.hpp"
#include "adrplot/render.hpp"
#include "agore/render.hpp"
#include "agore/scene_page.hpp"
#include "base/errors.hpp"
#include "base/terminal_text.hpp"
#include "cli/pictures/gallery.hpp"
#include "cli/pictures/report.hpp"
#include "cli/progress.hpp"
#include "desktop/bootstrap.hpp"
#include "desktop/figure.hpp"
#include "desktop/image_export.hpp"
#include "desktop/lubricant_pages.hpp"
#include "desktop/page_export.hpp"
#include "results/run_folder.hpp"

#include <fmt/format.h>

namespace adore::cli {
namespace {

void print_files(const std::vector<std::filesystem::path>& files) {
  for (const auto& file : files) print("{}\n", file.string());
}

desktop::Figure figure_of(const PlotRequest& request) {
  return {request.width, request.height, request.letters, request.font, request.gray};
}

void plot_lubricant(const PlotRequest& request) {
  calculators::LubricantContact contact;
  contact.code = request.lubricant;
  if (request.temperature > 0.0) contact.temperature = request.temperature;
  const std::filesystem::path folder(request.out);
  desktop::make_folder(folder);
  desktop::ChartScene scene;
  scene.setTheme(
      desktop::theme(request.dark ? desktop::ThemeKind::Dark : desktop::ThemeKind::Light));
  constexpr double kWidth = 1280.0, kHeight = 800.0;
  scene.setPageSize({kWidth, kHeight});
  std::vector<desktop::ChartPage> pages = desktop::lubricant_pages(contact);
  std::vector<std::filesystem::path> files;
  for (std::size_t n = 0; n < pages.size(); ++n) {
    if (request.page > 0 && static_cast<std::size_t>(request.page) != n + 1) continue;
    files.push_back(folder / fmt::format("lubricant-{:02}-{}.{}", request.lubricant,
                                         desktop::kLubricantPages[n], request.format));
    if (const desktop::Figure figure = figure_of(request); figure.is_for_print()) {
      desktop::save_figure(pages[n], files.back(), figure, desktop::Replace::OwnPictures);
      continue;
    }
    scene.setPage(std::move(pages[n]));
    desktop::save_page(scene, files.back(), {kWidth, kHeight}, desktop::Replace::OwnPictures);
  }
  if (files.empty())
    throw InputError(
        fmt::format("--page {}: a lubricant has charts 1 to {}", request.page, pages.size()));
  print_files(files);
}

void plot(const PlotRequest& request) {
  desktop::ensure_headless_application();
  if (request.lubricant != 0) return plot_lubricant(request);
  adrplot::RenderOptions options;
  options.folder = request.out;
  options.page = request.page;
  options.range = request.range;
  options.dark = request.dark;
  options.format = request.format;
  options.figure = figure_of(request);
  options.progress = make_count_progress("file", request.progress);
  options.tell = [](const std::string& sentence) { print(stderr, "adore: note: {}\n", sentence); };
  if (request.abscissa == "time") options.view.abscissa = adrplot::Abscissa::Time;
  adrplot::parse_domain_options(options.view, request.domain, request.curve, request.scale,
                                request.rows, request.band, request.orders_of);
  print_files(adrplot::render_plots({request.files.begin(), request.files.end()}, options));
}

void animate(const AnimateRequest& request) {
  desktop::ensure_headless_application();
  agore::RenderOptions render;
  const std::string race = request.race.empty() ? "inner" : request.race;
  render.view.view = agore::parse_view(request.view, race);
  render.view.element = request.element;
  render.view.flange_race = request.race == "outer" ? 0 : 1;
  render.view.colour = agore::parse_color_quantity(request.colour);
  render.view.scale = agore::parse_color_scale(request.scale);
  render.view.contacts = request.contacts;
  render.view.trails = request.trails;
  render.view.beside = agore::parse_additional_views(request.beside, race);
  render.view.yaw = request.yaw;
  render.view.elevation = request.elevation;
  render.view.dark = request.dark;
  render.slow = request.slow;
  render.first = request.first;
  render.last = request.last;
  render.progress = make_count_progress("frame", request.progress);
  const std::filesystem::path source = results::animation_file(request.file);
  agore::MotionPicture picture = agore::open_animation(source);
  for (const std::string& note : picture.animation().notes())
    print(stderr, "adore: note: {}: {}\n", source.string(), note);
  if (request.race.empty()) agore::choose_flange_race(picture.animation(), render.view);
  const std::filesystem::path folder(request.out);
  if (!request.html.empty()) {
    const std::filesystem::path page = folder / request.html;
    const agore::ScenePage scene = agore::write_scene_page(
        picture.animation(), {render.view, request.first, request.last, request.every}, page,
        false);
    print(stderr, "adore: {}\n", scene.summary());
    print_files({page});
  } else if (!request.movie.empty()) {
    const std::filesystem::path film = folder / request.movie;  // an absolute name is unchanged
    agore::render_movie(picture, request.every, request.frames_per_second, film, render);
    print_files({film});
  } else if (request.frame > 0) {
    desktop::make_folder(folder);
    const std::filesystem::path file =
        folder / fmt::format("{}-{}-frame-{:05}.png", source.filename().string(), request.view,
                             request.frame);
    agore::render_frame(picture, request.frame, file, render);
    print_files({file});
  } else {
    print_files(agore::render_frames(picture, request.every, folder, render));
  }
}

}  // namespace

PictureActions drawing_actions() { return {plot, animate, draw_gallery, draw_report}; }

void draw_accuracy_chart(const std::filesystem::path& table, const std::filesystem::path& picture) {
  std::vector<desktop::ChartPage> pages = adrplot::accuracy_pages(table);
  if (pages.front().x.empty())
    throw InputError(fmt::format("{} contains no completed run", table.string()));
  desktop::check_replaceable(picture);
  desktop::ensure_headless_application();
  constexpr double kWidth = 1280.0, kHeight = 800.0;
  desktop::ChartScene scene;
  scene.setPageSize({kWidth, kHeight});
  scene.setPage(std::move(pages.front()));
  desktop::save_page(scene, picture, {kWidth, kHeight});
}

}  // namespace adore::cli
