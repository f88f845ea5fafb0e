#pragma once

#include "desktop/theme.hpp"

#include <QByteArray>
#include <QFontMetricsF>
#include <QRectF>
#include <QRegularExpression>
#include <QString>

#include <vector>

/// Texts of a picture and their places, from its SVG form.
namespace adore::test {

struct Words {
  QString text;
  QRectF place;  ///< of the letters, without the room above and below them
  QString colour;
};

inline std::vector<Words> words_of(const QByteArray& svg) {
  static const QRegularExpression text(
      "<text transform=\"matrix\\(([^)]*)\\)\" [^>]*?font-size=\"([^\"]*)\"([^>]*)>([^<]*)</text>");
  std::vector<Words> out;
  auto found = text.globalMatch(QString::fromUtf8(svg));
  while (found.hasNext()) {
    const auto match = found.next();
    QString words = match.captured(4);
    words.replace("&lt;", "<").replace("&gt;", ">").replace("&quot;", "\"").replace("&amp;", "&");
    if (words.trimmed().isEmpty()) continue;
    const QStringList matrix = match.captured(1).split(' ');
    const bool upright = matrix.value(1).toDouble() == 0.0;
    const int size = static_cast<int>(match.captured(2).toDouble());
    const QFontMetricsF metrics(
        desktop::ui_font(size, match.captured(3).contains("font-weight=\"bold\"")));
    const QPointF at(matrix.value(4).toDouble(), matrix.value(5).toDouble());
    const double width = metrics.horizontalAdvance(words), high = metrics.capHeight();
    const QRectF place = upright ? QRectF(at.x(), at.y() - high, width, high)
                                 : QRectF(at.x() - high, at.y() - width, high, width);
    static const QRegularExpression fill("fill=\"([^\"]*)\"");
    out.push_back({words, place, fill.match(match.captured(3)).captured(1)});
  }
  return out;
}

/// All of it, one after the other: what is written in several lines is found again.
inline QString all_words(const QByteArray& svg) {
  QStringList out;
  for (const Words& words : words_of(svg)) out << words.text.simplified();
  return out.join(' ');
}

/// Unreadable texts: shortened, beyond the edge of the picture, or over other texts. One sentence
/// each.
inline QStringList faults_of(const QByteArray& svg, QSizeF size) {
  const std::vector<Words> words = words_of(svg);
  QStringList out;
  const QRectF page(QPointF(0.0, 0.0), size);
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i].text.contains("…")) out << QString("\"%1\" is shortened").arg(words[i].text);
    if (!page.contains(words[i].place))
      out << QString("\"%1\" is cut off at the edge").arg(words[i].text);
    for (std::size_t k = i + 1; k < words.size(); ++k)
      if (words[i].place.adjusted(0.5, 0.5, -0.5, -0.5).intersects(words[k].place))
        out << QString("\"%1\" lies over \"%2\"").arg(words[k].text, words[i].text);
  }
  return out;
}

}  // namespace adore::test
