#include "adrplot/render.hpp"
#include "agore/render.hpp"
#include "base/errors.hpp"
#include "cli/commands.hpp"
#include "cli/option_ranges.hpp"
#include "cli/pictures.hpp"
#include "cli/progress.hpp"
#include "command_line/tree.hpp"
#include "desktop/bootstrap.hpp"
#include "desktop/image_export.hpp"
#include "desktop/log_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace adore::cli {
namespace {

void print_files(const std::vector<std::filesystem::path>& files) {
  for (const auto& file : files) fmt::print("{}\n", file.string());
}

CLI::Option* add_progress(CLI::App& command, std::string& style) {
  return command_line::one_of(
      command.add_option("--progress", style, "how progress is shown on stderr")
          ->capture_default_str()
          ->type_name("STYLE"),
      {"auto", "plain", "json", "none"});
}

void add_plot(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "plot", "draw the pages of SOL1-SOL7, a quasi-static RUN.json or SWEEP.csv as PNG files");
  auto files = std::make_shared<std::vector<std::string>>();
  auto out = std::make_shared<std::string>(".");
  auto options = std::make_shared<adrplot::RenderOptions>();
  auto time = std::make_shared<bool>(false);
  auto progress = std::make_shared<std::string>("auto");
  auto abscissa = std::make_shared<std::string>("rev");
  command->add_option("files", *files, "SOL1-SOL7, RUN.json, SWEEP.csv")
      ->required()
      ->type_name("FILE");
  command->add_option("--out", *out, "folder of the pictures")
      ->type_name("DIR")
      ->default_str("here");
  CLI::Option* page = command->add_option("--page", options->page, "one page (all unless given)");
  command->add_option("--from", options->range.from, "first stored step, counted from 1")
      ->capture_default_str();
  CLI::Option* to =
      command->add_option("--to", options->range.to, "last stored step")->default_str("the last");
  command->add_option("--every", options->range.every, "interval of stored steps")
      ->capture_default_str();
  command_line::one_of(command->add_option("--abscissa", *abscissa, "revolutions or time")
                           ->capture_default_str()
                           ->type_name("WHAT"),
                       {"rev", "time"});
  command->add_flag("--time", *time, "the same as --abscissa time")->group("");
  command->add_flag("--dark", options->dark, "dark theme");
  add_progress(*command, *progress);
  command->footer("Example\n  adore plot SOL1 SOL7 --page 1 --out pictures");
  command->callback([=] {
    if (page->count() > 0) check_range("--page", options->page);
    check_range("--from", static_cast<double>(options->range.from));
    if (to->count() > 0) check_range("--to", static_cast<double>(options->range.to));
    check_range("--every", static_cast<double>(options->range.every));
    desktop::ensure_headless_application();
    options->folder = *out;
    options->progress = make_count_progress("file", *progress);
    if (*time || *abscissa == "time") options->view.abscissa = adrplot::Abscissa::Time;
    print_files(adrplot::render_plots({files->begin(), files->end()}, *options));
  });
}

struct AnimateOptions {
  std::string file, out = ".", view = "bearing", race = "inner", colour = "none", movie,
                    progress = "auto";
  int frame = 0, every = 1, frames_per_second = 25, element = 1;
  bool dark = false, contacts = false;
};

void animate(const AnimateOptions& options) {
  desktop::ensure_headless_application();
  agore::RenderOptions render;
  render.view.view = agore::view_named(options.view, options.race);
  render.view.element = options.element;
  render.view.flange_race = options.race == "outer" ? 0 : 1;
  render.view.colour = agore::colour_named(options.colour);
  render.view.contacts = options.contacts;
  render.view.dark = options.dark;
  render.progress = make_count_progress("frame", options.progress);
  agore::MotionPicture picture = agore::open_animation(options.file);
  const std::filesystem::path folder(options.out);
  if (!options.movie.empty()) {
    const std::filesystem::path film = folder / options.movie;  // an absolute name stays as it is
    agore::render_movie(picture, options.every, options.frames_per_second, film, render);
    print_files({film});
  } else if (options.frame > 0) {
    desktop::make_folder(folder);
    const std::filesystem::path file =
        folder / fmt::format("{}-{}-frame-{:05}.png",
                             std::filesystem::path(options.file).filename().string(), options.view,
                             options.frame);
    agore::render_frame(picture, options.frame, file, render);
    print_files({file});
  } else {
    print_files(agore::render_frames(picture, options.every, folder, render));
  }
}

void add_animate(CLI::App& app) {
  CLI::App* command = app.add_subcommand("animate", "draw frames or a film of SOL8");
  auto options = std::make_shared<AnimateOptions>();
  command->add_option("file", options->file, "SOL8 file, or RESULTS.h5")
      ->required()
      ->type_name("FILE");
  command_line::one_of(command->add_option("--view", options->view, "what is looked at")
                           ->capture_default_str()
                           ->type_name("VIEW"),
                       {"bearing", "cage", "pocket", "element", "race", "flange", "section"});
  command_line::one_of(command->add_option("--race", options->race, "race of the race view")
                           ->capture_default_str()
                           ->type_name("RACE"),
                       {"outer", "inner"});
  command
      ->add_option("--element", options->element, "element or pocket of the single-element views")
      ->capture_default_str();
  CLI::Option* frame = command->add_option("--frame", options->frame,
                                           "one stored frame, counted from 1 (all unless given)");
  CLI::Option* every =
      command->add_option("--every", options->every, "every n-th frame")->capture_default_str();
  CLI::Option* movie = command
                           ->add_option("--movie", options->movie,
                                        "film to write: NAME.avi, NAME.gif, NAME.mp4 (where ffmpeg "
                                        "is), or a folder of numbered "
                                        "pictures")
                           ->type_name("FILE");
  command->add_option("--fps", options->frames_per_second, "pictures per second of the film")
      ->capture_default_str();
  frame->excludes(every)->excludes(movie);
  command->add_option("--out", options->out, "folder of the pictures")
      ->type_name("DIR")
      ->default_str("here");
  command_line::one_of(command->add_option("--colour", options->colour, "what colours the elements")
                           ->capture_default_str()
                           ->type_name("WHAT"),
                       {"none", "load", "slip", "heat", "temperature"});
  command->add_flag("--contacts", options->contacts, "arrows of the race loads on all elements");
  command->add_flag("--dark", options->dark, "dark theme");
  add_progress(*command, options->progress);
  command->footer(
      "Examples\n"
      "  adore animate SOL8 --frame 1 --out pictures\n"
      "  adore animate SOL8 --view cage --every 5 --movie cage.avi");
  command->callback([=] {
    if (frame->count() > 0) check_range("--frame", options->frame);
    check_range("--every", options->every);
    check_range("--fps", options->frames_per_second);
    check_range("--element", options->element);
    animate(*options);
  });
}

}  // namespace

void add_picture_commands(CLI::App& app, int&) {
  add_plot(app);
  add_animate(app);
}

bool has_pictures() noexcept { return true; }

bool draw_accuracy_chart(const facade::AccuracyStudy& study, const std::filesystem::path& file) {
  desktop::ensure_headless_application();
  desktop::LogChart chart;
  chart.title = fmt::format("What accuracy costs: {:.3g} revolutions, reference {}",
                            study.span_revolutions, study.reference);
  chart.x_title = "computing time [s]";
  chart.y_title = "largest scaled error at the end";
  for (const facade::AccuracyRow& row : study.rows) {
    if (!row.failure.empty() || !(row.seconds > 0.0) || !(row.error > 0.0)) continue;
    auto curve = std::find_if(chart.curves.begin(), chart.curves.end(),
                              [&](const desktop::ChartCurve& c) { return c.name == row.method; });
    if (curve == chart.curves.end())
      curve = chart.curves.insert(curve, desktop::ChartCurve{row.method, {}, {}});
    curve->x.push_back(row.seconds);
    curve->y.push_back(row.error);
  }
  return desktop::save_log_chart(chart, file);
}

}  // namespace adore::cli
