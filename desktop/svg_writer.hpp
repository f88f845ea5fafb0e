#pragma once

#include <QByteArray>
#include <QSizeF>

#include <functional>

class QPainter;

namespace adore::desktop {

/// Output of a painter as an SVG document: paths, text and pictures inside their clips, linear and
/// radial gradients (others by their middle color). The SVG writer of Qt is a module that not every
/// system has.
[[nodiscard]] QByteArray svg_of(QSizeF size, const std::function<void(QPainter&)>& draw);

}  // namespace adore::desktop
