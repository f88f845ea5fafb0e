#include "agore/picture_key.hpp"

#include "agore/view_layout.hpp"
#include "agore/view_scene.hpp"
#include "agore/ways.hpp"

#include <QFontMetricsF>
#include <QPaintDevice>
#include <QPaintEngine>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <optional>

namespace adore::agore {

namespace {

/// Splits a text into parts that must not be broken: "78 N" and "× 10".
QStringList unbroken(const QString& text) {
  QStringList out;
  bool goes_on = false;
  for (const QString& word : text.split(' ')) {
    if (goes_on || (!out.isEmpty() && word.startsWith(QChar(0xd7))))
      out.back() += " " + word;
    else
      out << word;
    const QChar last = word.isEmpty() ? QChar() : word.back();
    const bool number = !word.isEmpty() && word.front().isDigit() && last.isDigit();
    goes_on = number || word == QString(QChar(0xd7)) || word == "≥" || word == "≤";
  }
  return out;
}

}  // namespace

QStringList wrapped_lines(const QString& text, double width, const QFontMetricsF& metrics) {
  QStringList out;
  const auto add = [&](const QString& part) {
    const QString longer = out.isEmpty() ? part : out.back() + " " + part;
    if (!out.isEmpty() && metrics.horizontalAdvance(longer) <= width)
      out.back() = longer;
    else
      out << part;
  };
  for (const QString& part : unbroken(text)) {
    if (metrics.horizontalAdvance(part) <= width)
      add(part);
    else  // no line is wide enough for all of it
      for (const QString& word : part.split(' ')) add(word);
  }
  return out;
}

namespace {

constexpr std::size_t kMany = 6;  // entries of a key in columns, if they fit
/// For texts after their mark, at a font size.
double indent_of(int letters) { return letters < 11 ? 21.0 : 26.0; }
constexpr double kKeyColumn = 182.0;  // width for the entries of views with many

/// A remark in lines that fit, broken between its parts.
QStringList wrapped(const QString& remark, double width, const QFontMetricsF& metrics) {
  QStringList out;
  for (const QString& part : remark.split("  ·  ", Qt::SkipEmptyParts)) {
    const QString longer = out.isEmpty() ? part : out.back() + "  ·  " + part;
    if (!out.isEmpty() && metrics.horizontalAdvance(longer) <= width)
      out.back() = longer;
    else
      out << wrapped_lines(part, width, metrics);  // continues in the next line
  }
  return out;
}

}  // namespace

int legend_column_count(std::size_t entries, QSizeF size) {
  constexpr double kSmall = 420.0, kTwoColumns = 2.0 * kKeyColumn;
  const bool high = entries > kMany || (entries > 2 && size.height() < kSmall);
  return high && size.width() >= kTwoColumns ? 2 : 1;
}

int legend_font_size(std::size_t entries, QSizeF size) {
  constexpr double kMostOfHeight = 0.25;
  constexpr int kUsual = 12, kLeast = 10;
  const auto columns = static_cast<std::size_t>(legend_column_count(entries, size));
  const auto lines = static_cast<double>((entries + columns - 1) / columns + 1);
  int letters = kUsual;
  while (letters > kLeast && lines * legend_line_height(letters) > kMostOfHeight * size.height())
    --letters;
  return letters;
}

double legend_line_height(int letters) {
  return QFontMetricsF(desktop::ui_font(letters)).height() + (letters < 12 ? 1.0 : 2.0);
}

void draw_legend(const Scene& s, const std::vector<PictureLegendEntry>& all,
                 const QString& remark) {
  if (!s.options.shown.key) return s.key.setOmittedEntries({});
  const bool low = is_too_low(s.options, s.sketch.area().height());
  s.key.setOmittedEntries(low ? all : std::vector<PictureLegendEntry>{});
  s.key.draw(s.sketch, low ? std::vector<PictureLegendEntry>{} : all, remark);
}

void PictureLegend::draw(const Sketch& sketch, const std::vector<PictureLegendEntry>& entries,
                         const QString& remark) {
  QPainter& painter = sketch.painter();
  if (!is_raster_target(painter)) {
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

namespace {

/// Position of an entry or a remark: its lines begin in a row of the key.
struct Placed {
  const PictureLegendEntry* entry = nullptr;  ///< null: a remark
  QStringList lines;
  std::size_t row = 0;
  double left = 0.0, right = 0.0;
};

struct Layout {
  int letters = 12;
  double line = 0.0;
  std::size_t rows = 0;
  std::vector<Placed> parts;
  [[nodiscard]] double height() const { return line * static_cast<double>(rows); }
};

Layout empty_layout(int letters) { return {letters, legend_line_height(letters), 0, {}}; }

/// An entry, measured once, to select the best of several layouts.
struct Measured {
  const PictureLegendEntry* entry;
  double width;       ///< of the mark and its text, or of the alternatives in other frames
  QStringList lines;  ///< one, or for entries wider than the available width
};

std::vector<Measured> measured(const std::vector<PictureLegendEntry>& entries, double room,
                               int letters) {
  const QFontMetricsF metrics(desktop::ui_font(letters));
  const double indent = indent_of(letters);
  std::vector<Measured> out;
  for (const PictureLegendEntry& entry : entries) {
    const double words =
        std::max(metrics.horizontalAdvance(entry.text),
                 entry.room.isEmpty() ? 0.0 : metrics.horizontalAdvance(entry.room));
    out.push_back({&entry, indent + words, {entry.text}});
    if (out.back().width > room)
      out.back().lines = wrapped_lines(entry.text, room - indent, metrics);
  }
  return out;
}

/// In columns of their longest entries; nothing if those are too wide.
std::optional<Layout> in_columns(const std::vector<Measured>& entries, std::size_t columns,
                                 double room, int letters) {
  constexpr double kGap = 12.0;
  Layout out = empty_layout(letters);
  out.rows = (entries.size() + columns - 1) / columns;
  double left = 0.0;
  for (std::size_t first = 0; first < entries.size(); first += out.rows) {
    double longest = 0.0;
    for (std::size_t i = first; i < std::min(first + out.rows, entries.size()); ++i) {
      const Measured& one = entries[i];
      longest = std::max(longest, one.width);
      out.parts.push_back({one.entry, {one.entry->text}, i - first, left, left + one.width});
    }
    if (left + longest > room) return std::nullopt;
    left += longest + kGap;
  }
  return out;
}

/// Each starts at the left edge of a column, in the first line with enough space: wide entries
/// extend over the next columns or into the next lines.
Layout at_stops(const std::vector<Measured>& entries, const std::vector<double>& stops, double room,
                int letters) {
  constexpr double kGap = 10.0;
  Layout out = empty_layout(letters);
  std::vector<std::size_t> free;  // of each line: its first column that is
  for (const Measured& one : entries) {
    const auto fits = [&](std::size_t column) {
      return column < stops.size() && stops[column] + one.width <= room;
    };
    const auto line = std::find_if(free.begin(), free.end(), fits);
    const auto row = static_cast<std::size_t>(line - free.begin());
    if (line == free.end()) free.push_back(0);
    const double left = stops[free[row]], right = std::min(left + one.width, room);
    out.parts.push_back({one.entry, one.lines, row, left, right});
    if (left + one.width > room)  // alone in its lines
      free.resize(row + static_cast<std::size_t>(one.lines.size()), stops.size());
    do ++free[row];
    while (free[row] < stops.size() && stops[free[row]] < right + kGap);
  }
  out.rows = free.size();
  return out;
}

/// In as few lines as possible with aligned columns, and as few columns.
Layout aligned(const std::vector<PictureLegendEntry>& entries, double room, int letters) {
  constexpr double kGap = 10.0;
  const std::vector<Measured> all = measured(entries, room, letters);
  Layout best = at_stops(all, {0.0}, room, letters);
  for (const std::size_t columns : {2U, 3U})
    for (const Measured& widest : all) {
      std::vector<double> stops{0.0};
      while (stops.size() < columns) stops.push_back(stops.back() + widest.width + kGap);
      if (stops.back() >= room) continue;
      Layout other = at_stops(all, stops, room, letters);
      if (other.rows < best.rows) best = std::move(other);
    }
  return best;
}

/// Two columns in a small picture or for many entries, else one; in smaller letters, and wide
/// entries over several columns, if otherwise an entry is cut or the key takes too much of the
/// picture.
Layout layout_of(const std::vector<PictureLegendEntry>& entries, QSizeF area) {
  const double width = area.width() - 12.0;
  constexpr double kMostOfHeight = 1.0 / 3.0;
  const auto columns = static_cast<std::size_t>(legend_column_count(entries.size(), area));
  const int usual = legend_font_size(entries.size(), area);
  constexpr int kLeast = 10;
  // Few long entries read better in usual letters, over several columns, than in small ones.
  for (int letters = usual; letters >= (entries.size() > kMany ? kLeast : usual); --letters)
    if (const auto plain = in_columns(measured(entries, width, letters), columns, width, letters))
      if (columns > 1 || plain->height() < kMostOfHeight * area.height()) return *plain;
  Layout out;
  for (int letters = usual; letters >= kLeast; --letters) {
    out = aligned(entries, width, letters);
    if (out.height() < kMostOfHeight * area.height()) break;
  }
  return out;
}

void draw_part(QPainter& p, const Placed& part, const Layout& key, QPointF corner,
               const desktop::Theme& theme) {
  const double line = key.line, indent = indent_of(key.letters);
  double y = corner.y() + line * static_cast<double>(part.row + 1) - 4.0;
  const double left = corner.x() + part.left;
  const bool marked = part.entry != nullptr && part.entry->colour.isValid();
  if (marked)
    draw_legend_mark(p, *part.entry, theme, {left, y - 4.0}, std::min(18.0, indent - 6.0));
  p.setPen(theme.muted);
  for (const QString& text : part.lines) {
    p.drawText(QPointF(marked ? left + indent : left, y), text);
    y += line;
  }
}

}  // namespace

QRectF PictureLegend::paint(QPainter& p, const QRectF& area, const desktop::Theme& theme,
                            const std::vector<PictureLegendEntry>& entries, const QString& remark) {
  Layout key = layout_of(entries, area.size());
  const QFontMetricsF metrics(desktop::ui_font(key.letters));
  for (const QString& text : wrapped(remark, area.width() - 12.0, metrics))
    key.parts.push_back({nullptr, {text}, key.rows++, 0.0, metrics.horizontalAdvance(text)});
  // Text over the picture stays readable. Each line has a separate background of its width: a box
  // around all lines would cover neighboring parts.
  std::vector<double> ends(key.rows, 0.0);
  for (const Placed& part : key.parts)
    for (std::size_t i = 0; i < static_cast<std::size_t>(part.lines.size()); ++i)
      ends[part.row + i] = std::max(ends[part.row + i], part.right);
  const QPointF corner(area.left() + 4.0, area.bottom() - 2.0 - key.height());
  QPainterPath behind;
  behind.setFillRule(Qt::WindingFill);
  double widest = 0.0;
  for (std::size_t row = 0; row < key.rows; ++row) {
    behind.addRoundedRect(QRectF(area.left(), corner.y() + key.line * static_cast<double>(row),
                                 ends[row] + 10.0, key.line + 2.0),
                          4, 4);
    widest = std::max(widest, ends[row]);
  }
  QColor paper = theme.surface;
  paper.setAlpha(215);
  p.setPen(Qt::NoPen);
  p.setBrush(paper);
  p.drawPath(behind);
  p.setFont(desktop::ui_font(key.letters));
  for (const Placed& part : key.parts) draw_part(p, part, key, corner, theme);
  return {area.left(), corner.y(), widest + 10.0, key.height() + 2.0};
}

double SharedLegend::height() { return kLines * legend_line_height() + 4.0; }

void SharedLegend::draw(QPainter& painter, const QRectF& place, const desktop::Theme& theme,
                        std::vector<PictureLegendEntry> entries) {
  // Common entries of several pictures are listed once, with the mark of the first; alternatives
  // that are not drawn are omitted.
  std::vector<PictureLegendEntry> each;
  for (PictureLegendEntry& entry : entries)
    if (entry.colour.isValid() &&
        std::none_of(each.begin(), each.end(),
                     [&](const PictureLegendEntry& e) { return e.text == entry.text; }))
      each.push_back(std::move(entry));
  if (!is_raster_target(painter)) {
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

void SharedLegend::paint(QPainter& p, const QRectF& place, const desktop::Theme& theme,
                         const std::vector<PictureLegendEntry>& entries) {
  Layout key;
  for (const int letters : {12, 11, 10, 9}) {
    key = aligned(entries, place.width(), letters);
    if (key.height() <= place.height()) break;
  }
  p.setFont(desktop::ui_font(key.letters));
  const auto last = static_cast<std::size_t>(place.height() / key.line);
  std::size_t drawn = 0;
  for (const Placed& part : key.parts) {
    const std::size_t end = part.row + static_cast<std::size_t>(part.lines.size());
    if (key.rows > last && end >= last) break;
    draw_part(p, part, key, place.topLeft(), theme);
    p.setPen(theme.muted);
    ++drawn;
  }
  if (drawn == entries.size()) return;
  p.drawText(QPointF(place.left(), place.top() + key.line * static_cast<double>(last) - 4.0),
             QString("%1 more (see the single view, V)").arg(entries.size() - drawn));
}

}  // namespace adore::agore
