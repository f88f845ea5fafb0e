#pragma once

#include "agore/view_options.hpp"

#include <QRectF>

/// How much of a picture's area belongs to the bodies and how much to the key below them.
namespace adore::agore {

/// Heights that are too small for a key of several lines [pixels]: of a single picture, and of one
/// of several, with a common key below.
inline constexpr double kTooLow = 200.0, kTooLowBeside = 330.0;
[[nodiscard]] inline bool is_too_low(const ViewOptions& options, double height) {
  return height < (options.one_of_several ? kTooLowBeside : kTooLow);
}

/// Outer radius of the outer race in the picture: a little beyond its groove if the file has none.
double outer_rim(const results::Sol8Geometry& geometry);

/// Pixels about a ring for the numbers of elements, in a picture of that half size.
double numbers_margin(double half);

/// Space for the color scale in the upper right corner of a picture, and height at the top that a
/// round picture keeps free for it: just enough for its numbers.
[[nodiscard]] QSizeF color_scale_size(const ViewOptions& options, QSizeF size);
[[nodiscard]] double color_scale_top_margin(const Animation& animation, const ViewOptions& options,
                                            QSizeF size);

/// Radius of the circle about the picture's middle that must be seen, in the file's length, in
/// `size` pixels.
double picture_radius(const Animation& animation, const ViewOptions& options, QSizeF size);

/// Height at the bottom of a picture for its key: just enough to keep a round picture out of the
/// corner of the key, and all of the key otherwise.
double legend_height_below(const Animation& animation, const ViewOptions& options, QSizeF size);

}  // namespace adore::agore
