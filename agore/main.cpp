#include "agore/agore_window.hpp"
#include "agore/render.hpp"
#include "base/errors.hpp"
#include "desktop/bootstrap.hpp"
#include "desktop/command_line.hpp"
#include "desktop/disclaimer.hpp"
#include "desktop/image_export.hpp"

#include <CLI/CLI.hpp>
#include <QTimer>
#include <fmt/core.h>

using namespace adore;

namespace {

struct Request {
  std::filesystem::path file, folder;
  std::string view = "bearing", race = "inner", size = "1280x800", film;
  int frame = 0, every = 0, rate = 25;
  agore::RenderOptions options;
};

int render(int& argc, char** argv, Request& request) {
  if (request.file.empty()) throw InputError("--render needs an animation file (SOL8) to draw");
  const auto app = desktop::make_application(argc, argv, "agore", desktop::Display::Headless);
  agore::MotionPicture picture = agore::open_animation(request.file);
  const auto& note = picture.animation().file.note;
  if (!note.empty()) fmt::print(stderr, "agore: note: {}: {}\n", request.file.string(), note);
  if (!request.film.empty()) {
    const auto film = request.folder / request.film;
    agore::render_movie(picture, std::max(1, request.every), request.rate, film, request.options);
    fmt::print("{}\n", film.string());
    return 0;
  }
  if (request.every > 0) {
    for (const auto& path :
         agore::render_frames(picture, request.every, request.folder, request.options))
      fmt::print("{}\n", path.string());
    return 0;
  }
  desktop::make_folder(request.folder);
  const int frame = request.frame > 0 ? request.frame : static_cast<int>(picture.frames());
  const auto path =
      request.folder /
      fmt::format("{}-{}-frame-{:05}.png", request.file.filename().string(), request.view, frame);
  agore::render_frame(picture, frame, path, request.options);
  fmt::print("{}\n", path.string());
  return 0;
}

int show(int& argc, char** argv, const Request& request) {
  const auto app = desktop::make_application(argc, argv, "agore", desktop::Display::Window);
  if (!desktop::ask_for_disclaimer("AGORE")) return 0;
  agore::AgoreWindow window;
  window.show();
  if (request.file.empty())
    QTimer::singleShot(0, &window, &agore::AgoreWindow::askForFile);
  else if (window.openFile(request.file))
    window.setView(request.options.view.view, request.options.view.element);
  return QApplication::exec();
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App cli(
      "AGORE: the motion of a bearing from an animation file SOL8. Without --render it opens a "
      "window.",
      "agore");
  Request request;
  cli.add_option("SOL8", request.file, "animation file");
  auto* folder = cli.add_option("--render", request.folder,
                                "write pictures into this folder instead of opening a window");
  cli.add_option("--view", request.view, "bearing, cage, pocket, element or race");
  cli.add_option("--race", request.race, "outer or inner, for the race view");
  cli.add_option("--element", request.options.view.element, "number of the element or pocket")
      ->check(CLI::PositiveNumber);
  cli.add_option("--exaggerate", request.options.view.exaggeration,
                 "factor on clearances; 1 is to scale")
      ->check(CLI::PositiveNumber);
  auto* frame =
      cli.add_option("--frame", request.frame, "one frame, counted from 1 (the last unless given)")
          ->check(CLI::PositiveNumber)
          ->needs(folder);
  cli.add_option("--every", request.every, "every K-th frame")
      ->check(CLI::PositiveNumber)
      ->needs(folder)
      ->excludes(frame);
  cli.add_option("--movie", request.film, "a film of this name (.avi) in the folder")
      ->needs(folder)
      ->excludes(frame);
  cli.add_option("--fps", request.rate, "pictures per second of the film")
      ->check(CLI::Range(1, 120))
      ->needs(folder);
  cli.add_option("--size", request.size, "picture size in pixels, WIDTHxHEIGHT")->needs(folder);
  cli.add_flag("--dark", request.options.view.dark, "dark colours")->needs(folder);
  try {
    cli.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return cli.exit(error) == 0 ? 0 : 2;
  }
  return desktop::guarded("agore", [&] {
    request.options.view.view = agore::view_named(request.view, request.race);
    const auto pixels = desktop::parse_size(request.size);
    request.options.width = pixels.width;
    request.options.height = pixels.height;
    return request.folder.empty() ? show(argc, argv, request) : render(argc, argv, request);
  });
}
