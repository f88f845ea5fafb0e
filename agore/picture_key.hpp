#pragma once

#include "desktop/theme.hpp"

#include <QColor>
#include <QImage>
#include <QRectF>
#include <QString>
#include <QStringList>

#include <utility>
#include <vector>

class QFontMetricsF;
class QPainter;

namespace adore::agore {

class Sketch;

/// Mark in front of the text of a key entry, as in the picture.
enum class LegendMark {
  Line,
  Dashed,
  Dotted,
  Star,
  Dots,
  Spot,     ///< round: on the face of a race, or where a center is
  Arrow,    ///< a broad one
  Contact,  ///< dashes to a contact, and the arrow that presses on it
  Frame,    ///< two arms, the longer one up
  Turning,  ///< rotation mark of a ball, on steel
  Sector,   ///< that of a roller
  Disc,     ///< a body of that color
  Scale,    ///< the colors of a scale, from end to end
  None      ///< entries of other frames: only their space
};

struct PictureLegendEntry {
  QColor colour;  ///< invalid: entry without a drawn mark
  QString text;
  LegendMark mark = LegendMark::Line;
  QString room{};           ///< alternative texts of other frames: the width of the longest is kept
  bool on_colours = false;  ///< the mark is on colors of the scale
  bool operator==(const PictureLegendEntry&) const = default;
};

/// The mark in front of the text of an entry, centered at a point of the line.
void draw_legend_mark(QPainter& painter, const PictureLegendEntry& entry,
                      const desktop::Theme& theme, QPointF at, double length);

/// Wraps words to lines; a number and its unit stay together.
[[nodiscard]] QStringList wrapped_lines(const QString& text, double width,
                                        const QFontMetricsF& metrics);

/// Number of columns of a key with that many entries in a picture of a size: two for many entries,
/// and in a small picture, where one would need half of it.
[[nodiscard]] int legend_column_count(std::size_t entries, QSizeF size);
/// Letters of a key of that many entries and a line of remarks [pixels]: smaller if it would take
/// more than a quarter of the picture height.
[[nodiscard]] int legend_font_size(std::size_t entries, QSizeF size);
/// Height of its lines [pixels].
[[nodiscard]] double legend_line_height(int letters = 12);

/// The key in the lower left corner of a picture. Its layout takes longer than the rest of a quick
/// picture, so on a screen it is kept as an image until its content changes.
class PictureLegend {
 public:
  void draw(const Sketch& sketch, const std::vector<PictureLegendEntry>& entries,
            const QString& remark);
  /// Last drawing on a screen.
  [[nodiscard]] const std::vector<PictureLegendEntry>& entries() const { return entries_; }
  /// Marks of the view last drawn that its picture was too low to name.
  [[nodiscard]] const std::vector<PictureLegendEntry>& omittedEntries() const {
    return omitted_entries_;
  }
  void setOmittedEntries(std::vector<PictureLegendEntry> entries) {
    omitted_entries_ = std::move(entries);
  }

 private:
  /// Returns the box that the key fills.
  static QRectF paint(QPainter& painter, const QRectF& area, const desktop::Theme& theme,
                      const std::vector<PictureLegendEntry>& entries, const QString& remark);
  std::vector<PictureLegendEntry> entries_, omitted_entries_;
  QString remark_;
  QRectF area_, place_;
  double ratio_ = 0.0;
  desktop::ThemeKind kind_{};
  QImage image_;
};

/// A common key for several small pictures: entries in columns and lines of one height, with
/// letters as small as needed.
class SharedLegend {
 public:
  static constexpr int kLines = 10;
  /// Height of its lines [pixels].
  [[nodiscard]] static double height();
  void draw(QPainter& painter, const QRectF& place, const desktop::Theme& theme,
            std::vector<PictureLegendEntry> entries);

 private:
  static void paint(QPainter& painter, const QRectF& place, const desktop::Theme& theme,
                    const std::vector<PictureLegendEntry>& entries);
  std::vector<PictureLegendEntry> entries_;
  QSizeF size_;
  double ratio_ = 0.0;
  desktop::ThemeKind kind_{};
  QImage image_;
};

}  // namespace adore::agore
