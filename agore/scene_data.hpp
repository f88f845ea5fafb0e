#pragma once

#include "agore/view_options.hpp"

#include <cstddef>
#include <string>
#include <utility>

/// Content of the page of the 3D scene (agore/scene_page.hpp).
namespace adore::agore {

/// Data of one frame as text [bytes].
[[nodiscard]] double scene_frame_bytes(const Animation& animation);

/// JSON: shapes of the bodies, then positions and attitudes of all bodies and contacts of all
/// elements at every `every`-th frame, as base64 of little-endian numbers.
/// @param frames first and last, from 0, not behind the end of RESULTS.h5
[[nodiscard]] std::string scene_data(const Animation& animation, const ViewOptions& view,
                                     std::pair<std::size_t, std::size_t> frames, int every);

}  // namespace adore::agore
