#pragma once

#include "agore/view_options.hpp"

#include <filesystem>
#include <string>
#include <string_view>

/// The bodies of the 3D view as one HTML file, which plays in a browser without a server or a
/// network. It contains three.js of Debian's package libjs-three with its license.
///
/// Lengths in m, forces in N, pressures in Pa, angles in rad, as in RESULTS.h5. Clearances are
/// magnified as in the 3D view; attitudes of rollers are to scale.
namespace adore::agore {

inline constexpr const char* kThreeFile = "/usr/share/javascript/three/three.min.js";

struct ScenePageOptions {
  ViewOptions view;         ///< element, magnification, theme, viewing direction
  int first = 1, last = 0;  ///< frames of the range, counted from 1; last 0: the end
  int every = 0;            ///< every n-th frame; 0: chosen so that the page stays below kMostBytes
};

/// Size of the page with its data, without three.js [bytes].
inline constexpr double kMostBytes = 8e6;

struct ScenePage {
  std::string html;
  std::size_t frames = 0;
  int every = 1;
  /// "300 frames (one of every 4), 3.1 MB"
  [[nodiscard]] std::string summary() const;
};

/// Is three.js installed?
[[nodiscard]] bool is_threejs_installed();

/// Interval of frames, and size of the file with three.js [bytes], before it is written.
struct ScenePageSize {
  std::size_t frames = 0;
  int every = 1;
  double bytes = 0.0;
};
/// @throws InputError for an invalid range
[[nodiscard]] ScenePageSize scene_page_size(const Animation& animation,
                                            const ScenePageOptions& options);

/// @throws InputError: no dimensions (see why_not()), invalid range, or three.js is not installed
[[nodiscard]] ScenePage scene_page(const Animation& animation, const ScenePageOptions& options,
                                   const std::filesystem::path& three = kThreeFile);

/// @param file NAME.html @throws InputError as scene_page(), or when it cannot be written
ScenePage write_scene_page(const Animation& animation, const ScenePageOptions& options,
                           const std::filesystem::path& file, bool replace);

}  // namespace adore::agore
