#pragma once

#include <QImage>

#include <cstddef>

namespace adore::desktop {

/// The picture with at most `most` (1 to 256) colors of its own, chosen where its pixels are. A
/// chart's PNG is a third of its size then; nobody sees a difference.
[[nodiscard]] QImage in_few_colours(const QImage& picture, std::size_t most = 256);

/// The same of shaded bodies: what lies between the 256 colors is mixed of pixels beside each
/// other (Floyd and Steinberg), so that shading has no stripes. Pixels of those colors, paper and
/// most lines and letters, stay what they are.
[[nodiscard]] QImage in_mixed_colours(const QImage& picture);

}  // namespace adore::desktop
