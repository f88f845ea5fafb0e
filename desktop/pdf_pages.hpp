#pragma once

#include <QByteArray>
#include <QSizeF>

#include <cstddef>
#include <functional>

class QIODevice;
class QPainter;
class QRectF;

/// Lines and text on pages of paper.
namespace adore::desktop {

/// Pages of `size` pixels of a picture, each with a separate drawing; `draw` gets the page in
/// document dots, three per pixel.
void write_pdf(QIODevice& out, QSizeF size, std::size_t pages,
               const std::function<void(QPainter&, const QRectF& page, std::size_t)>& draw);

/// One page, drawn as in a picture of `size` pixels (as svg_of is).
[[nodiscard]] QByteArray pdf_of(QSizeF size, const std::function<void(QPainter&)>& draw);

}  // namespace adore::desktop
