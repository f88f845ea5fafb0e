#pragma once

#include <QByteArray>
#include <QSizeF>

#include <functional>

class QPainter;

namespace adore::desktop {

/// What a painter draws, as an SVG document: paths, text and pictures inside their clips, linear
/// and radial gradients (others by their middle color). Qt's own SVG writer is a module that not
/// every system has.
[[nodiscard]] QByteArray svg_of(QSizeF size, const std::function<void(QPainter&)>& draw);

}  // namespace adore::desktop
