#pragma once

#include <QByteArray>
#include <QSizeF>
#include <QString>

#include <cstddef>
#include <functional>

class QIODevice;
class QPainter;
class QRectF;

/// Lines and text on pages of paper.
namespace adore::desktop {

/// Title of a document, and its size in millimeters (empty: 96 pixels per inch).
struct Print {
  QString title;
  QSizeF paper;
};

/// Pages of `size` pixels of a picture, each with a separate drawing; `draw` gets the page in
/// document dots, three per pixel.
void write_pdf(QIODevice& out, QSizeF size, std::size_t pages,
               const std::function<void(QPainter&, const QRectF& page, std::size_t)>& draw,
               const Print& print = {});

/// One page, drawn as in a picture of `size` pixels (as render_svg is).
[[nodiscard]] QByteArray render_pdf(QSizeF size, const std::function<void(QPainter&)>& draw,
                                    const Print& print = {});

}  // namespace adore::desktop
