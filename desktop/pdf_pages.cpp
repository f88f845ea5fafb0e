#include "desktop/pdf_pages.hpp"

#include <QBuffer>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>

namespace adore::desktop {

void write_pdf(QIODevice& out, QSizeF size, std::size_t pages,
               const std::function<void(QPainter&, const QRectF&, std::size_t)>& draw,
               const Print& print) {
  constexpr int kPixelsPerInch = 96, kPointsPerInch = 72;
  // Letters of figures on paper are smaller than on a screen.
  const int dpi = print.paper.isEmpty() ? 288 : 1200;
  QPdfWriter pdf(&out);
  pdf.setCreator("Adore");
  if (!print.title.isEmpty()) pdf.setTitle(print.title);
  pdf.setResolution(dpi);
  pdf.setPageSize(print.paper.isEmpty()
                      ? QPageSize(size * kPointsPerInch / kPixelsPerInch, QPageSize::Point)
                      : QPageSize(print.paper, QPageSize::Millimeter));
  pdf.setPageMargins(QMarginsF(0, 0, 0, 0));
  QPainter painter(&pdf);
  for (std::size_t i = 0; i < pages; ++i) {
    if (i > 0) pdf.newPage();
    draw(painter, QRectF(0, 0, pdf.width(), pdf.height()), i);
  }
}

QByteArray render_pdf(QSizeF size, const std::function<void(QPainter&)>& draw, const Print& print) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  write_pdf(
      buffer, size, 1,
      [&](QPainter& painter, const QRectF& page, std::size_t) {
        painter.scale(page.width() / size.width(), page.height() / size.height());
        painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
        draw(painter);
      },
      print);
  return bytes;
}

}  // namespace adore::desktop
