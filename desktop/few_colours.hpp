#pragma once

#include <QImage>

#include <cstddef>

namespace adore::desktop {

/// The picture with at most `most` (1 to 256) colors, chosen from its pixels. The PNG file of a
/// chart then has a third of its size, without a visible difference.
[[nodiscard]] QImage reduce_colors(const QImage& picture, std::size_t most = 256);

/// The same for shaded bodies: intermediate colors are mixed from adjacent pixels (Floyd and
/// Steinberg), so that shading has no stripes. Pixels of the palette, background and most lines and
/// letters, are unchanged.
[[nodiscard]] QImage dither_colors(const QImage& picture);

}  // namespace adore::desktop
