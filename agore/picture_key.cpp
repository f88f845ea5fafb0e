#include "agore/picture_key.hpp"

#include "agore/view_layout.hpp"
#include "agore/view_scene.hpp"

#include <QFontMetricsF>
#include <QPaintDevice>
#include <QPaintEngine>
#include <QPainterPath>

#include <algorithm>
#include <array>

namespace adore::agore {

namespace {

constexpr double kKeyIndent = 26.0;
constexpr double kKeyColumn = 182.0;  // that holds the entries of views with many

void draw_mark(QPainter& p, KeyMark mark, const QColor& colour, QPointF at) {
  const double length = kKeyIndent - 8.0;
  if (mark == KeyMark::Star) {
    draw_asterisk(p, at + QPointF(0.5 * length, 0.0), 5.0, colour);
    return;
  }
  QPen pen(colour, mark == KeyMark::Dashed ? 1.6 : 3.0, Qt::SolidLine, Qt::FlatCap);
  if (mark == KeyMark::Dashed) pen.setDashPattern({4.0, 2.0});
  p.setPen(pen);
  p.drawLine(at, at + QPointF(length, 0.0));
}

/// Of the mark and its words, or of those that stand there in other frames.
double width_of(const KeyEntry& entry, const QFontMetricsF& metrics) {
  return kKeyIndent +
         std::max(metrics.horizontalAdvance(entry.text), metrics.horizontalAdvance(entry.room));
}

/// Words in lines that fit, broken between words.
QStringList in_lines(const QString& text, double width, const QFontMetricsF& metrics) {
  QStringList out;
  for (const QString& word : text.split(' ')) {
    const QString longer = out.isEmpty() ? word : out.back() + " " + word;
    if (!out.isEmpty() && metrics.horizontalAdvance(longer) <= width)
      out.back() = longer;
    else
      out << word;
  }
  return out;
}

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

int key_columns(std::size_t entries, QSizeF size) {
  constexpr double kSmall = 420.0, kTwoColumns = 2.0 * kKeyColumn;
  return entries > 2 && size.height() < kSmall && size.width() >= kTwoColumns ? 2 : 1;
}

void draw_key(const Scene& s, const std::vector<KeyEntry>& all, const QString& remark) {
  const bool low = too_low(s.options, s.sketch.area().height());
  s.key.leaveOut(low ? all : std::vector<KeyEntry>{});
  s.key.draw(s.sketch, low ? std::vector<KeyEntry>{} : all, remark);
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
  constexpr double kGap = 12.0;
  auto columns = static_cast<std::size_t>(key_columns(entries.size(), area.size()));
  // Entries that two columns would cut stand in one, if that leaves the picture its room.
  constexpr double kMostOfHeight = 1.0 / 3.0;
  const auto all = static_cast<double>(entries.size()) + static_cast<double>(remarks.size());
  const auto longest = [&](std::size_t from, std::size_t to) {
    double out = 0.0;
    for (std::size_t i = from; i < to; ++i) out = std::max(out, width_of(entries[i], metrics));
    return out;
  };
  const std::size_t half = (entries.size() + 1) / 2;
  if (longest(0, half) + kGap + longest(half, entries.size()) > area.width() - 8.0 &&
      line * all < kMostOfHeight * area.height())
    columns = 1;
  const std::size_t rows = (entries.size() + columns - 1) / columns;
  std::array<double, 2> column{};
  for (std::size_t i = 0; i < entries.size(); ++i)
    column[i / rows] = std::max(column[i / rows], width_of(entries[i], metrics));
  width = std::max(width, column[0] + (columns == 2 ? kGap + column[1] : 0.0));
  width = std::min(width, area.width() - 8);
  const double height = line * (static_cast<double>(rows) + static_cast<double>(remarks.size()));
  // What stands below stays readable and does not disturb.
  QColor paper = theme.surface;
  paper.setAlpha(215);
  p.setPen(Qt::NoPen);
  p.setBrush(paper);
  const QRectF box(x - 4, area.bottom() - height - 2, width + 10, height + 2);
  // Each line has its own as wide as it is: a box about all of them bites into what is beside.
  QPainterPath behind;
  behind.setFillRule(Qt::WindingFill);
  const auto line_behind = [&](std::size_t row, double long_as) {
    behind.addRoundedRect(QRectF(box.left(), box.top() + line * static_cast<double>(row),
                                 std::min(long_as + 10.0, box.width()), line + 4.0),
                          4, 4);
  };
  for (std::size_t row = 0; row < rows; ++row) {
    double long_as = width_of(entries[row], metrics);
    if (columns == 2 && row + rows < entries.size())
      long_as = column[0] + kGap + width_of(entries[row + rows], metrics);
    line_behind(row, long_as);
  }
  for (qsizetype i = 0; i < remarks.size(); ++i)
    line_behind(rows + static_cast<std::size_t>(i), metrics.horizontalAdvance(remarks[i]));
  p.drawPath(behind);
  double y = area.bottom() - 6;
  const auto write = [&](const QString& text, double left) {
    p.setPen(theme.muted);
    p.drawText(QPointF(left, y), metrics.elidedText(text, Qt::ElideRight, area.right() - left - 4));
  };
  for (auto text = remarks.rbegin(); text != remarks.rend(); ++text) {
    write(*text, x);
    y -= line;
  }
  const double top = y - line * static_cast<double>(rows);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const KeyEntry& entry = entries[i];
    const double left = i < rows ? x : x + column[0] + kGap;
    y = top + line * static_cast<double>(i % rows + 1);
    write(entry.text, entry.colour.isValid() ? left + kKeyIndent : left);
    if (entry.colour.isValid()) draw_mark(p, entry.mark, entry.colour, {left, y - 4});
  }
  return box;
}

double SharedKey::height() { return kLines * key_line() + 4.0; }

void SharedKey::draw(QPainter& painter, const QRectF& place, const desktop::Theme& theme,
                     std::vector<KeyEntry> entries) {
  // A mark that several pictures have is named once; words about what is not drawn say nothing
  // here.
  std::vector<KeyEntry> each;
  for (KeyEntry& entry : entries)
    if (entry.colour.isValid() && std::find(each.begin(), each.end(), entry) == each.end())
      each.push_back(std::move(entry));
  if (!on_pixels(painter)) {
    paint(painter, place, theme, each);
    return;
  }
  const double ratio = painter.device()->devicePixelRatioF();
  if (each != entries_ || place.size() != size_ || ratio != ratio_ || theme.kind != kind_ ||
      image_.isNull()) {
    entries_ = std::move(each), size_ = place.size(), ratio_ = ratio, kind_ = theme.kind;
    image_ = QImage((size_ * ratio).toSize(), QImage::Format_ARGB32_Premultiplied);
    image_.setDevicePixelRatio(ratio);
    image_.fill(Qt::transparent);
    QPainter once(&image_);
    once.setRenderHint(QPainter::Antialiasing);
    paint(once, QRectF(QPointF(0.0, 0.0), size_), theme, entries_);
  }
  painter.drawImage(place.topLeft(), image_);
}

void SharedKey::paint(QPainter& p, const QRectF& place, const desktop::Theme& theme,
                      const std::vector<KeyEntry>& entries) {
  constexpr double kGap = 16.0;
  p.setFont(desktop::ui_font(12));
  const QFontMetricsF metrics(p.font());
  const double line = key_line();
  const auto more = [](std::size_t count) { return QString("%1 more").arg(count); };
  const double kept = metrics.horizontalAdvance(more(entries.size())) + kGap;
  double x = place.left(), y = place.top() + line - 4.0;
  int row = 1;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const KeyEntry& entry = entries[i];
    const double width = width_of(entry, metrics);
    const bool last = i + 1 == entries.size();
    // One that is longer than a line goes on in the next ones.
    const QStringList lines = width > place.width()
                                  ? in_lines(entry.text, place.width() - kKeyIndent, metrics)
                                  : QStringList{entry.text};
    if (x > place.left() && row < kLines && x + width > place.right())
      x = place.left(), y += line, ++row;
    const auto lowest = row + static_cast<int>(lines.size()) - 1;
    const double end = lines.size() > 1 ? place.left() : x + width;
    if (lowest > kLines || (lowest == kLines && end > place.right() - (last ? 0.0 : kept))) {
      p.setPen(theme.muted);
      p.drawText(QPointF(x, y), more(entries.size() - i));
      return;
    }
    draw_mark(p, entry.mark, entry.colour, {x, y - 4.0});
    p.setPen(theme.muted);
    for (qsizetype k = 0; k < lines.size(); ++k) {
      if (k > 0) y += line, ++row;
      p.drawText(QPointF(x + kKeyIndent, y), lines[k]);
    }
    x = lines.size() > 1 ? place.right() : x + width + kGap;
  }
}

}  // namespace adore::agore
