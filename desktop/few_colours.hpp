#pragma once

#include <QImage>

#include <cstddef>

namespace adore::desktop {

/// The picture with at most `most` (1 to 256) colours of its own, chosen where its pixels are. A
/// chart's PNG is a third of its size then; nobody sees a difference.
[[nodiscard]] QImage in_few_colours(const QImage& picture, std::size_t most = 256);

}  // namespace adore::desktop
