#include "agore/picture_key.hpp"

#include "agore/view_layout.hpp"
#include "agore/view_scene.hpp"

#include <QFontMetricsF>
#include <QPaintDevice>
#include <QPaintEngine>

#include <algorithm>

namespace adore::agore {

namespace {

constexpr double kKeyIndent = 26.0;

/// A remark in lines that fit, broken between its parts.
QStringList wrapped(const QString& remark, double width) {
  const QFontMetricsF metrics(desktop::ui_font(12));
  QStringList out;
  for (const QString& part : remark.split("  ·  ", Qt::SkipEmptyParts)) {
    const QString longer = out.isEmpty() ? part : out.back() + "  ·  " + part;
    if (!out.isEmpty() && metrics.horizontalAdvance(longer) <= width)
      out.back() = longer;
    else
      out << part;
  }
  return out;
}

}  // namespace

void draw_key(const Scene& s, const std::vector<KeyEntry>& all, const QString& remark) {
  const std::vector<KeyEntry> entries =
      s.sketch.area().height() < kTooLow ? std::vector<KeyEntry>{} : all;
  s.key.draw(s.sketch, entries, remark);
}

void KeyPicture::draw(const Sketch& sketch, const std::vector<KeyEntry>& entries,
                      const QString& remark) {
  QPainter& painter = sketch.painter();
  if (!on_pixels(painter)) {
    paint(painter, sketch.area(), sketch.theme(), entries, remark);
    return;
  }
  const double ratio = painter.device()->devicePixelRatioF();
  if (entries != entries_ || remark != remark_ || sketch.area() != area_ || ratio != ratio_ ||
      sketch.theme().kind != kind_ || image_.isNull()) {
    entries_ = entries, remark_ = remark, area_ = sketch.area(), ratio_ = ratio;
    kind_ = sketch.theme().kind;
    // Measured once without drawing, so that the image is as small as the key.
    QImage nothing(1, 1, QImage::Format_ARGB32_Premultiplied);
    QPainter measuring(&nothing);
    const QRectF box = paint(measuring, area_, sketch.theme(), entries_, remark_);
    place_ = QRectF(box.toAlignedRect());
    image_ = QImage((place_.size() * ratio).toSize(), QImage::Format_ARGB32_Premultiplied);
    image_.setDevicePixelRatio(ratio);
    image_.fill(Qt::transparent);
    QPainter once(&image_);
    once.setRenderHint(QPainter::Antialiasing);
    once.translate(-place_.topLeft());
    paint(once, area_, sketch.theme(), entries_, remark_);
  }
  painter.drawImage(place_.topLeft(), image_);
}

QRectF KeyPicture::paint(QPainter& p, const QRectF& area, const desktop::Theme& theme,
                         const std::vector<KeyEntry>& entries, const QString& remark) {
  p.setFont(desktop::ui_font(12));
  const QFontMetricsF metrics(p.font());
  const double line = key_line(), x = area.left() + 4;
  const QStringList remarks = wrapped(remark, area.width() - 12.0);
  double width = 0.0;
  for (const QString& text : remarks) width = std::max(width, metrics.horizontalAdvance(text));
  for (const auto& entry : entries)
    width = std::max(width, metrics.horizontalAdvance(entry.text) + kKeyIndent);
  width = std::min(width, area.width() - 8);
  const double height =
      line * (static_cast<double>(entries.size()) + static_cast<double>(remarks.size()));
  // What stands below stays readable and does not disturb.
  QColor paper = theme.surface;
  paper.setAlpha(215);
  p.setPen(Qt::NoPen);
  p.setBrush(paper);
  const QRectF box(x - 4, area.bottom() - height - 2, width + 10, height + 2);
  p.drawRoundedRect(box, 4, 4);
  double y = area.bottom() - 6;
  const auto write = [&](const QString& text, double left) {
    p.setPen(theme.muted);
    p.drawText(QPointF(left, y), metrics.elidedText(text, Qt::ElideRight, area.right() - left - 4));
  };
  for (auto text = remarks.rbegin(); text != remarks.rend(); ++text) {
    write(*text, x);
    y -= line;
  }
  for (auto entry = entries.rbegin(); entry != entries.rend(); ++entry) {
    const bool drawn = entry->colour.isValid();
    write(entry->text, drawn ? x + kKeyIndent : x);
    y -= line;
    if (!drawn) continue;
    p.setPen(QPen(entry->colour, 3));
    p.drawLine(QPointF(x, y + line - 4), QPointF(x + 18, y + line - 4));
  }
  return box;
}

}  // namespace adore::agore
