#pragma once

#include "drawing/outline.hpp"

#include <QPainterPath>
#include <QString>
#include <QTransform>

#include <string>

/// Shared by the sources of the drawing: sizes in pixels, and outlines in the picture.
namespace adore::adrinput {

inline constexpr double kAxisLeft = 60.0, kAxisBottom = 38.0;  ///< next to a chart
inline constexpr int kText = 11;                               ///< letters

inline QString text_of(const std::string& text) { return QString::fromStdString(text); }

/// A shape with positions from `place`; `close`: its lines bound an area.
[[nodiscard]] QPainterPath path_of(const drawing::Shape& shape, const QTransform& place,
                                   bool close);

}  // namespace adore::adrinput
