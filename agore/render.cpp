#include "agore/render.hpp"

#include "base/errors.hpp"
#include "desktop/avi_writer.hpp"
#include "desktop/gif_writer.hpp"
#include "desktop/image_export.hpp"
#include "desktop/mp4_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace adore::agore {

namespace fs = std::filesystem;

void render_frame(MotionPicture& picture, int frame, const fs::path& path,
                  const RenderOptions& options) {
  if (frame < 1 || frame > static_cast<int>(picture.frames()))
    throw InputError(fmt::format("{} has no frame {}; its frames are 1 to {}",
                                 picture.animation().file.path.string(), frame, picture.frames()));
  desktop::save_image(picture.image({options.width, options.height},
                                    static_cast<std::size_t>(frame - 1), options.view),
                      path);
}

namespace {

void require_interval(int every) {
  if (every < 1)
    throw InputError(fmt::format(
        "an interval of {} frames draws nothing; give 1 for every frame, 2 for every second one",
        every));
}

/// Tells how many of the pictures are drawn.
void tell(const RenderOptions& options, int frame, int every, std::size_t frames) {
  if (!options.progress) return;
  const auto total = (static_cast<long>(frames) + every - 1) / every;
  options.progress(frame / every + 1, total);
}

}  // namespace

std::vector<fs::path> render_frames(MotionPicture& picture, int every, const fs::path& folder,
                                    const RenderOptions& options) {
  require_interval(every);
  desktop::make_folder(folder);
  std::vector<fs::path> written;
  const std::string stem = picture.animation().file.path.filename().string();
  for (int frame = 1; frame <= static_cast<int>(picture.frames()); frame += every) {
    const fs::path path = folder / fmt::format("{}-frame-{:05}.png", stem, frame);
    render_frame(picture, frame, path, options);
    written.push_back(path);
    tell(options, frame - 1, every, picture.frames());
  }
  return written;
}

void render_movie(MotionPicture& picture, int every, int frames_per_second, const fs::path& film,
                  const RenderOptions& options) {
  require_interval(every);
  if (frames_per_second < 1)
    throw InputError(fmt::format("a film of {} pictures per second shows nothing; give at least 1",
                                 frames_per_second));
  std::string suffix = film.extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (suffix.empty()) {
    render_frames(picture, every, film, options);
    return;
  }
  if (suffix != ".avi" && suffix != ".gif" && suffix != ".mp4")
    throw InputError("a film cannot be written as " + film.string() +
                     "; give a name that ends in .avi, .gif or .mp4, or a folder name for numbered "
                     "pictures");
  if (film.has_parent_path()) desktop::make_folder(film.parent_path());
  if (!options.replace) desktop::check_replaceable(film);
  const QSize size(options.width, options.height);
  const auto draw = [&](auto& writer) {
    for (std::size_t frame = 0; frame < picture.frames();
         frame += static_cast<std::size_t>(every)) {
      if (options.stop && options.stop()) return;  // no film
      writer.add(picture.image(size, frame, options.view));
      tell(options, static_cast<int>(frame), every, picture.frames());
    }
    writer.finish();
  };
  if (suffix == ".avi") {
    desktop::AviWriter writer(film, size, frames_per_second);
    draw(writer);
  } else if (suffix == ".gif") {
    desktop::GifWriter writer(film, size, frames_per_second);
    draw(writer);
  } else {
    desktop::Mp4Writer writer(film, size, frames_per_second);
    draw(writer);
  }
}

MotionPicture open_animation(const fs::path& sol8, long most_frames) {
  return MotionPicture(open_motion(sol8, most_frames));
}

}  // namespace adore::agore
