#include "agore/render.hpp"

#include "base/errors.hpp"
#include "desktop/avi_writer.hpp"
#include "desktop/findings_bar.hpp"
#include "desktop/gif_writer.hpp"
#include "desktop/image_export.hpp"
#include "desktop/mp4_writer.hpp"
#include "results/run_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace adore::agore {

namespace fs = std::filesystem;

namespace {

std::vector<Finding> findings_of(const MotionPicture& picture) {
  return results::run_findings(picture.animation().file.path);
}

QImage picture_of(MotionPicture& picture, std::size_t frame, const std::vector<Finding>& findings,
                  const RenderOptions& options) {
  ViewOptions view = options.view;
  view.warned = warned_bodies(findings);
  return desktop::image_with_findings({options.width, options.height}, findings, view.dark,
                                      [&](QSize size) { return picture.image(size, frame, view); });
}

}  // namespace

void render_frame(MotionPicture& picture, int frame, const fs::path& path,
                  const RenderOptions& options) {
  if (frame < 1 || frame > static_cast<int>(picture.frames()))
    throw InputError(fmt::format("{} has no frame {}; its frames are 1 to {}",
                                 picture.animation().file.path.string(), frame, picture.frames()));
  desktop::save_image(
      picture_of(picture, static_cast<std::size_t>(frame - 1), findings_of(picture), options),
      path);
}

namespace {

void require_interval(int every) {
  if (every < 1)
    throw InputError(
        fmt::format("an interval of {} frames draws nothing; give 1 for every frame or 2 for every "
                    "second frame",
                    every));
}

}  // namespace

std::vector<std::size_t> movie_frames(const MotionPicture& picture, int every,
                                      int frames_per_second, const RenderOptions& options) {
  const auto all = static_cast<int>(picture.frames());
  const int end = options.last == 0 ? all : options.last;
  for (const int frame : {options.first, end})
    if (frame < 1 || frame > all)
      throw InputError(fmt::format("{} has no frame {}; its frames are 1 to {}",
                                   picture.animation().file.path.string(), frame, all));
  if (options.first > end)
    throw InputError(
        fmt::format("the first frame ({}) is after the last frame ({})", options.first, end));
  const auto first = static_cast<std::size_t>(options.first - 1),
             last = static_cast<std::size_t>(end - 1);
  std::vector<std::size_t> out;
  if (options.slow <= 0.0) {
    for (std::size_t frame = first; frame <= last; frame += static_cast<std::size_t>(every))
      out.push_back(frame);
    return out;
  }
  constexpr double kMost = 1e6;  // pictures: eleven hours of 25 a second
  const std::vector<double>& time = picture.animation().time;
  const double step = options.slow / frames_per_second, span = time[last] - time[first];
  if (!(span / step < kMost))
    throw InputError(
        fmt::format("{:g} s need more than {:g} pictures with a slow motion of {:g}; select a "
                    "larger slow-motion value (--slow)",
                    span, kMost, options.slow));
  const auto pictures = static_cast<std::size_t>(std::ceil(span / step * (1.0 - 1e-12)));
  for (std::size_t i = 0; i < pictures; ++i) {
    // Includes a frame that is later than the time by rounding.
    const double now = time[first] + static_cast<double>(i) * step + 1e-9 * step;
    const auto after = std::upper_bound(time.begin(), time.end(), now);
    out.push_back(static_cast<std::size_t>(after - time.begin()) - 1);
  }
  out.push_back(last);
  return out;
}

namespace {

/// Draws the frames of a movie and reports the progress. @return false: cancelled
template <class Draw>
bool draw_all(const std::vector<std::size_t>& frames, const RenderOptions& options, Draw&& draw) {
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (options.stop && options.stop()) return false;
    draw(frames[i], i);
    if (options.progress)
      options.progress(static_cast<long>(i + 1), static_cast<long>(frames.size()));
  }
  return true;
}

/// Numbers of pictures: by frames of the file, or by those of the movie in slow motion.
std::vector<fs::path> render_pictures(MotionPicture& picture,
                                      const std::vector<std::size_t>& frames,
                                      const fs::path& folder, const RenderOptions& options) {
  desktop::make_folder(folder);
  std::vector<fs::path> written;
  const std::string stem = picture.animation().file.path.filename().string();
  draw_all(frames, options, [&](std::size_t frame, std::size_t number) {
    written.push_back(folder / (options.slow > 0.0
                                    ? fmt::format("{}-picture-{:05}.png", stem, number + 1)
                                    : fmt::format("{}-frame-{:05}.png", stem, frame + 1)));
    render_frame(picture, static_cast<int>(frame + 1), written.back(), options);
  });
  return written;
}

}  // namespace

std::vector<fs::path> render_frames(MotionPicture& picture, int every, const fs::path& folder,
                                    const RenderOptions& options) {
  require_interval(every);
  return render_pictures(picture, movie_frames(picture, every, 1, options), folder, options);
}

void render_movie(MotionPicture& picture, int every, int frames_per_second, const fs::path& film,
                  const RenderOptions& options) {
  require_interval(every);
  if (frames_per_second < 1)
    throw InputError(fmt::format("a movie of {} pictures per second is empty; give at least 1",
                                 frames_per_second));
  std::string suffix = film.extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const std::vector<std::size_t> frames = movie_frames(picture, every, frames_per_second, options);
  if (suffix.empty()) {
    render_pictures(picture, frames, film, options);
    return;
  }
  if (suffix != ".avi" && suffix != ".gif" && suffix != ".mp4")
    throw InputError("a movie cannot be written as " + film.string() +
                     "; give a name that ends in .avi, .gif or .mp4, or a folder name for numbered "
                     "pictures");
  if (film.has_parent_path()) desktop::make_folder(film.parent_path());
  if (!options.replace) desktop::check_replaceable(film);
  const QSize size(options.width, options.height);
  const std::vector<Finding> findings = findings_of(picture);
  const auto draw = [&](auto& writer) {
    if (draw_all(frames, options, [&](std::size_t frame, std::size_t) {
          writer.add(picture_of(picture, frame, findings, options));
        }))
      writer.finish();  // stopped: no film
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
