#pragma once

#include "agore/motion_picture.hpp"

#include <filesystem>
#include <functional>
#include <vector>

/// Headless pictures and films of a SOL8 file, by the same code as the window. Needs an application
/// object (desktop/bootstrap.hpp).
namespace adore::agore {

struct RenderOptions {
  ViewOptions view;
  int width = 1280, height = 800;
  std::function<void(long done, long total)> progress;  ///< called after each picture; may be empty
  std::function<bool()> stop = {};  ///< called before each picture of a movie; may be empty
  bool replace = false;             ///< any existing file of that name: the user has confirmed
  /// Simulated seconds per second of a movie that shows frames at their times, also with unequal
  /// intervals; 0: one picture per frame.
  double slow = 0.0;
  /// Frames that a film or numbered pictures begin and end with, counted from 1; last 0: the end.
  int first = 1, last = 0;
};

/// Frames of a movie, counted from 0: every `every`-th one or, in slow motion, at equal steps of
/// simulated time the latest frame.
/// @throws InputError for invalid first and last frames, or too many pictures
[[nodiscard]] std::vector<std::size_t> movie_frames(const MotionPicture& picture, int every,
                                                    int frames_per_second,
                                                    const RenderOptions& options);

/// One picture; `frame` counts the file's frames from 1. PNG or JPEG by suffix.
/// @throws InputError for a file that is not ours, a frame that does not exist, or a path that
/// cannot be written.
void render_frame(MotionPicture& picture, int frame, const std::filesystem::path& path,
                  const RenderOptions& options);

/// Every `every`-th frame as <stem>-frame-NNNNN.png in `folder`, which is made when missing.
/// Returns the names in order.
std::vector<std::filesystem::path> render_frames(MotionPicture& picture, int every,
                                                 const std::filesystem::path& folder,
                                                 const RenderOptions& options);

/// A movie of every `every`-th frame, by the suffix: .avi (Motion-JPEG), .gif (256 colors per
/// picture), .mp4 (H.264 by the program ffmpeg in the PATH); without a suffix a folder of that name
/// with numbered PNG files. @throws InputError with the missing part
void render_movie(MotionPicture& picture, int every, int frames_per_second,
                  const std::filesystem::path& film, const RenderOptions& options);

/// Reads a SOL8 file and prepares it. @throws InputError.
MotionPicture open_animation(const std::filesystem::path& sol8, long most_frames = 1'000'000'000);

}  // namespace adore::agore
