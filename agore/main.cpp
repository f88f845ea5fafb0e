#include "agore/agore_window.hpp"
#include "agore/render.hpp"
#include "agore/scene_page.hpp"
#include "base/ending.hpp"
#include "base/errors.hpp"
#include "base/terminal_text.hpp"
#include "command_line/program.hpp"
#include "command_line/tree.hpp"
#include "desktop/behind.hpp"
#include "desktop/bootstrap.hpp"
#include "desktop/command_line.hpp"
#include "desktop/disclaimer.hpp"
#include "desktop/image_export.hpp"
#include "desktop/one_window.hpp"
#include "desktop/project.hpp"
#include "desktop/theme.hpp"
#include "desktop/window_place.hpp"
#include "results/run_folder.hpp"

#include <QApplication>
#include <QFileInfo>
#include <QProgressDialog>
#include <QTimer>
#include <fmt/core.h>

#include <optional>
#include <tuple>

using namespace adore;

namespace {

const std::vector<std::string> kViews{"bearing", "cage",    "pocket", "element", "race",
                                      "flange",  "section", "3d",     "raceways"};

struct Request {
  std::filesystem::path file, folder;
  std::string view = "bearing", race, size = "1280x800", film, colour = "none", scale = "usual";
  std::string beside, project, html;
  int frame = 0, every = 0, rate = 25;
  bool follow = false, behind = false;
  agore::RenderOptions options;
};

int render(int& argc, char** argv, Request& request) {
  if (request.file.empty()) throw InputError("--render needs an animation file (SOL8)");
  exit_on_interrupt();
  const auto app = desktop::make_application(argc, argv, "agore", desktop::Display::Headless);
  agore::MotionPicture picture = agore::open_animation(request.file);
  if (request.race.empty()) agore::choose_flange_race(picture.animation(), request.options.view);
  for (const std::string& note : picture.animation().notes())
    print(stderr, "agore: note: {}: {}\n", request.file.string(), note);
  if (!request.html.empty()) {
    const auto page = request.folder / request.html;
    const agore::ScenePage scene = agore::write_scene_page(
        picture.animation(),
        {request.options.view, request.options.first, request.options.last, request.every}, page,
        false);
    print(stderr, "agore: {}\n", scene.summary());
    print("{}\n", page.string());
    return 0;
  }
  if (!request.film.empty()) {
    const auto film = request.folder / request.film;
    agore::render_movie(picture, std::max(1, request.every), request.rate, film, request.options);
    print("{}\n", film.string());
    return 0;
  }
  if (request.every > 0) {
    for (const auto& path :
         agore::render_frames(picture, request.every, request.folder, request.options))
      print("{}\n", path.string());
    return 0;
  }
  desktop::make_folder(request.folder);
  const int frame = request.frame > 0 ? request.frame : static_cast<int>(picture.frames());
  const auto path =
      request.folder /
      fmt::format("{}-{}-frame-{:05}.png", request.file.filename().string(), request.view, frame);
  agore::render_frame(picture, frame, path, request.options);
  print("{}\n", path.string());
  return 0;
}

/// A file that another program hands over waits while a film of the last one is written.
void show_file(agore::AgoreWindow& window, const QString& name, bool to_front) {
  constexpr int kLater = 300;  // ms
  if (window.findChild<QProgressDialog*>() != nullptr) {
    QTimer::singleShot(kLater, &window, [=, &window] { show_file(window, name, to_front); });
    return;
  }
  window.openFile(name.toStdString());
  if (!to_front) return QApplication::alert(&window);
  window.raise();
  window.activateWindow();
}

int show(int& argc, char** argv, const Request& request) {
  const auto app = desktop::make_application(argc, argv, "agore", desktop::Display::Window);
  std::optional<desktop::OpenWithoutFocusGuard> unasked;
  if (request.behind) unasked.emplace();
  const QString folder = request.project.empty() ? desktop::folder_of(request.file)
                                                 : QString::fromStdString(request.project);
  // Whoever is the second one for a project leaves it to the first.
  const auto left_to_another = [&] {
    QStringList names;
    if (request.behind) names << desktop::kBehind;
    names << QFileInfo(QString::fromStdString(request.file)).absoluteFilePath();
    return !request.project.empty() && !request.file.empty() &&
           desktop::send_to_open_window("agore", folder, names);
  };
  if (left_to_another() || !desktop::ask_for_disclaimer("AGORE")) return 0;
  // For this session: the setting of the window is kept.
  if (request.options.view.dark) desktop::apply_theme(desktop::ThemeKind::Dark);
  agore::AgoreWindow window;
  std::optional<desktop::SingleWindowServer> one;
  if (!request.file.empty())
    one.emplace("agore", folder, nullptr, [&window](const QStringList& names) {
      show_file(window, names.back(), !names.contains(desktop::kBehind));
    });
  if (one && !one->is_listening() && left_to_another()) return 0;  // started at the same moment
  const desktop::WindowGeometryStore memory(window, "agore");
  window.show();
  if (request.file.empty())
    QTimer::singleShot(0, &window, &agore::AgoreWindow::askForFile);
  else if (window.openFile(request.file) && window.picture() != nullptr) {
    agore::ViewOptions view = request.options.view;
    if (request.race.empty()) agore::choose_flange_race(window.picture()->animation(), view);
    window.applyViewOptions(view);
    if (request.follow) window.follow(true);
  }
  return QApplication::exec();
}

}  // namespace

int main(int argc, char** argv) {
  const auto program = command_line::make_program(
      "AGORE: animation of a bearing from SOL8 or RESULTS.h5, in a window or as pictures and "
      "movies.",
      "agore");
  CLI::App& cli = *program;
  Request request;
  cli.add_option("SOL8", request.file,
                 "animation file, RESULTS.h5, PROJECT.json, or the folder of a run or project")
      ->type_name("PATH");
  CLI::Option* one_window =
      cli.add_option("--project", request.project, "reuse one window for all files of this folder")
          ->type_name("DIR")
          ->check(CLI::ExistingDirectory)
          ->needs(cli.get_option("SOL8"));
  auto* folder = cli.add_option("--render", request.folder,
                                "write pictures to this folder instead of opening a window")
                     ->type_name("DIR");
  command_line::one_of(cli.add_option("--view", request.view, "view to draw")
                           ->capture_default_str()
                           ->type_name("VIEW"),
                       kViews);
  cli.add_option("--beside", request.beside,
                 "additional views of the same frame, separated by commas")
      ->type_name("LIST");
  command_line::one_of(cli.add_option("--race", request.race,
                                      "race of the race view (default: inner) and of the flange "
                                      "view (default: race with a flange)")
                           ->type_name("RACE"),
                       {"outer", "inner"});
  command_line::at_least(
      cli.add_option("--element", request.options.view.element, "number of the element or pocket"),
      1);
  command_line::at_least(cli.add_option("--exaggerate", request.options.view.exaggeration,
                                        "magnification of clearances (1: to scale)"),
                         0.001);
  auto* frame =
      command_line::at_least(cli.add_option("--frame", request.frame,
                                            "frame to draw, counted from 1 (default: last frame)"),
                             1)
          ->needs(folder);
  auto* every =
      command_line::at_least(cli.add_option("--every", request.every, "draw every n-th frame"), 1)
          ->needs(folder)
          ->excludes(frame);
  auto* movie = cli.add_option("--movie", request.film,
                               "movie to write in the folder of --render: NAME.avi, NAME.gif, or "
                               "NAME.mp4 (needs ffmpeg)")
                    ->type_name("FILE")
                    ->needs(folder)
                    ->excludes(frame);
  auto* html = cli.add_option("--html", request.html,
                              "3D scene for a browser, written to the folder of --render: "
                              "NAME.html (needs libjs-three)")
                   ->type_name("FILE")
                   ->needs(folder)
                   ->excludes(frame)
                   ->excludes(movie);
  command_line::at_least(
      cli.add_option("--fps", request.rate, "movie frames per second")->capture_default_str(), 1)
      ->needs(folder);
  command_line::at_least(cli.add_option("--slow", request.options.slow,
                                        "slow motion: simulated seconds per second of the movie, "
                                        "e.g. 0.001 (default: one picture per stored frame)"),
                         1e-12)
      ->needs(movie)
      ->excludes(every);
  for (const auto& [name, number, what] :
       {std::tuple{"--from", &request.options.first,
                   "first frame of the movie or of the pictures of --every, counted from 1"},
        std::tuple{"--to", &request.options.last,
                   "last frame of a movie or of --every (default: last frame of the file)"}})
    command_line::at_least(cli.add_option(name, *number, what), 1)->needs(folder)->excludes(frame);
  cli.add_option("--size", request.size, "picture size in pixels, WIDTHxHEIGHT")
      ->capture_default_str()
      ->type_name("SIZE")
      ->needs(folder);
  command_line::one_of(cli.add_option("--color,--colour", request.colour, "color elements by")
                           ->capture_default_str()
                           ->type_name("WHAT"),
                       {"none", "load", "slip", "heat", "temperature", "pressure"});
  cli.add_option("--scale", request.scale,
                 "color scale: usual (95 % of the values of the run), run (range of the run), "
                 "moment (range of this frame), or limits such as 0:0.02 in the unit of the file")
      ->capture_default_str()
      ->type_name("SCALE");
  cli.add_flag("--contacts", request.options.view.contacts,
               "draw arrows of the race loads on all elements");
  cli.add_flag("--trails", request.options.view.trails,
               "draw the recent path of each element (length: 0.8 of the element spacing)");
  cli.add_flag("--follow", request.follow, "reload the files while a run is active")
      ->excludes(folder);
  cli.add_flag("--behind", request.behind, "open in the background without taking focus")
      ->excludes(folder);
  cli.add_flag("--dark", request.options.view.dark, "dark theme");
  // An existing window accepts only files.
  for (const char* of_first :
       {"--render", "--view", "--beside", "--race", "--element", "--exaggerate", "--color",
        "--scale", "--contacts", "--trails", "--follow", "--dark"})
    one_window->excludes(cli.get_option(of_first));
  if (const auto over = command_line::parse(cli, argc, argv)) return *over;
  return desktop::run_guarded("agore", [&] {
    const bool project = desktop::opens_as_project(request.file);
    if (project && !request.folder.empty())
      throw InputError("--render needs an animation file (SOL8), not a project");
    if (!request.file.empty() && !project) request.file = results::animation_file(request.file);
    const std::string race = request.race.empty() ? "inner" : request.race;
    request.options.view.view = agore::parse_view(request.view, race);
    request.options.view.beside = agore::parse_additional_views(request.beside, race);
    request.options.view.flange_race = request.race == "outer" ? 0 : 1;
    request.options.view.colour = agore::parse_color_quantity(request.colour);
    request.options.view.scale = agore::parse_color_scale(request.scale);
    if ((cli.count("--from") > 0 || cli.count("--to") > 0) && request.film.empty() &&
        html->empty() && request.every == 0)
      throw InputError("--from and --to need --movie, --html or --every");
    const auto pixels = desktop::parse_size(request.size);
    request.options.width = pixels.width;
    request.options.height = pixels.height;
    return request.folder.empty() ? show(argc, argv, request) : render(argc, argv, request);
  });
}
