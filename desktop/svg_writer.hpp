#pragma once

#include "desktop/pdf_pages.hpp"

#include <QByteArray>
#include <QSizeF>

#include <functional>

class QPainter;

namespace adore::desktop {

/// Output of a painter as an SVG document: paths, text and pictures inside their clips, linear and
/// radial gradients (others by their middle color). The SVG writer of Qt is a module that not every
/// system has.
[[nodiscard]] QByteArray render_svg(QSizeF size, const std::function<void(QPainter&)>& draw,
                                    const Print& print = {});

}  // namespace adore::desktop
