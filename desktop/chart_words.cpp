#include "base/counted.hpp"
#include "desktop/chart_scene_parts.hpp"
#include "desktop/tick_room.hpp"

#include <QFontMetricsF>
#include <QGraphicsTextItem>
#include <QRegularExpression>
#include <QTextDocument>
#include <QTextOption>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <tuple>
#include <utility>

/// Texts of a page of charts: heading, note, ticks, titles, legends, names of marks.
namespace adore::desktop {

namespace {

/// Words side by side up to a width.
QStringList wrapped(const QStringList& words, const QFontMetricsF& metrics, qreal width) {
  QStringList out{QString()};
  const qreal blank = metrics.horizontalAdvance(' ');
  qreal length = 0.0;  // of the last line: no kerning over a blank
  for (QString word : words) {
    qreal more = metrics.horizontalAdvance(word);
    while (more > width && word.size() > 1) {  // a path
      qsizetype part = word.size() - 1;
      while (part > 1 && metrics.horizontalAdvance(word.left(part)) > width) --part;
      if (out.back().isEmpty()) out.pop_back();
      out << word.left(part) << QString();
      word = word.mid(part);
      more = metrics.horizontalAdvance(word);
    }
    if (out.back().isEmpty()) {
      out.back() = word;
      length = more;
    } else if (length + blank + more > width) {
      out << word;
      length = more;
    } else {
      out.back() += ' ' + word;
      length += blank + more;
    }
  }
  return out;
}

/// The same without one or two single words in the last line, in the same number of lines.
QStringList evenly_wrapped(const QStringList& words, const QFontMetricsF& metrics, qreal width) {
  constexpr qsizetype kFew = 3;
  constexpr qreal kNarrower = 0.98, kNarrowest = 0.6;
  const QStringList out = wrapped(words, metrics, width);
  const auto alone = [](const QStringList& lines) { return lines.back().count(' ') + 1 < kFew; };
  if (out.size() < 2 || !alone(out)) return out;
  for (qreal part = kNarrower; part > kNarrowest; part *= kNarrower) {
    QStringList lines = wrapped(words, metrics, part * width);
    if (lines.size() > out.size()) break;
    if (!alone(lines)) return lines;
  }
  return out;
}

/// The words of a note; a number stays together with its unit.
QStringList words_of(const QString& note) {
  static const QRegularExpression kBeforeUnit(
      "(?<=[0-9]) "
      "(?=(?:[pnµmkMG]?(?:m|s|N|W|Hz|Pa|N·m|m/s)|in|lbf|rpm|rev|hr|deg|K|R|%)(?![\\w/]))",
      QRegularExpression::UseUnicodePropertiesOption);
  return QString(note).replace(kBeforeUnit, QString(QChar::Nbsp)).split(' ');
}

/// Sentences, each with its full stop.
QStringList sentences_of(const QString& note) {
  static const QRegularExpression kBetween("(?<=[.!?]) (?=[A-Z0-9])");
  return note.split(kBetween);
}

/// Broken into lines by the window that shows it.
QString tooltip_of(const QString& note) { return "<p>" + note.toHtmlEscaped() + "</p>"; }

/// Between two lines of a note.
qreal line_pitch(int font) { return font + 5.0; }

// A heading always allows two lines of a note, and the rest of the page next to its panels.
constexpr qreal kLeastNote = 34.0, kHead = 66.0, kFoot = 54.0, kLegend = 22.0, kGap = 34.0;
/// Height of a panel with readable numbers and title.
constexpr qreal kPanelRead = 56.0;

}  // namespace

/// As many lines as the panels allow, first in smaller letters; sentences that do not fit are
/// counted, and shown in a tooltip.
ChartScene::NoteLines ChartScene::findNoteLines(qreal right) const {
  const QString note = text_of(noteText());
  if (note.isEmpty() || page_.panels.empty()) return {};
  constexpr int kLargest = 13, kSmallest = 11, kSmallestSaved = 9, kLeft = 24;
  constexpr qreal kFew = 80.0, kMore = 112.0, kPanel = 44.0, kPanelSaved = 34.0;
  const qreal width = size_.width() - kLeft - right;
  const auto panels = static_cast<qreal>(page_.equal_axes ? 3 : page_.panels.size());
  const auto room_beside = [&](qreal panel) {
    return std::max(kLeastNote, size_.height() - kHead - kFoot - kLegend -
                                    mark_labels_height(page_, kLargest - 1, size_.width()) -
                                    panels * (panel + kGap) + kGap);
  };
  const qreal room = room_beside(interactive_ ? kPanelRead : kPanel);
  // A single panel is the main content of a page: it gets at least half of a low picture.
  constexpr qreal kPart = 0.107;
  const qreal few =
      page_.panels.size() == 1 && !page_.equal_axes ? std::min(kFew, kPart * size_.height()) : kFew;
  NoteLines out;
  const auto fits = [&](qreal height) {
    return static_cast<qreal>(out.lines.size()) * line_pitch(out.font) <= height;
  };
  const QStringList words = words_of(note);
  for (const qreal height :
       {std::min(few, room), std::min(kFew, room), std::min(kMore, room), room})
    for (out.font = kLargest; out.font >= kSmallest; --out.font) {
      out.lines = evenly_wrapped(words, QFontMetricsF(ui_font(out.font)), width);
      if (fits(height)) return out;
    }
  // A saved picture has no tooltips: smaller letters are used before text is omitted.
  for (out.font = kSmallest; !interactive_ && out.font >= kSmallestSaved; --out.font) {
    out.lines = evenly_wrapped(words, QFontMetricsF(ui_font(out.font)), width);
    if (fits(room_beside(kPanelSaved))) return out;
  }
  out.font = kSmallest;
  const QFontMetricsF metrics(ui_font(out.font));
  const QStringList sentences = sentences_of(note);
  for (qsizetype told = sentences.size() - 1; told >= 0; --told) {
    const qsizetype left = sentences.size() - told;
    const QString where = interactive_ ? tr(": move the pointer here.") : tr(" not shown.");
    const QString more = (left == 1 ? tr("(1 more sentence%1)").arg(where)
                                    : tr("(%1 more sentences%2)").arg(left).arg(where));
    out.lines =
        evenly_wrapped(words_of((sentences.mid(0, told) << more).join(' ')), metrics, width);
    out.more = true;
    if (fits(room)) break;
  }
  return out;
}

qreal ChartScene::minReadableHeight() const {
  constexpr qreal kOther = 300.0;  // of orbits, studies and messages
  constexpr int kTickFont = 12;
  if (page_.study || page_.equal_axes || page_.panels.empty()) return kOther;
  const auto panels = static_cast<qreal>(page_.panels.size());
  return std::max(kOther, kHead + kLeastNote + kLegend + kFoot +
                              mark_labels_height(page_, kTickFont, size_.width()) +
                              panels * (kPanelRead + kGap) - kGap);
}

std::string ChartScene::noteText() const {
  std::string out = page_.note;
  for (const std::string& more :
       {showsBandNote() ? page_.band_note : std::string(), log_axis_note_})
    if (!more.empty()) out += (out.empty() ? "" : " ") + more;
  return out;
}

const ChartScene::NoteLines& ChartScene::noteLines(qreal right) const {
  const auto key = std::tuple(noteText(), size_.width(), size_.height(), right, interactive_);
  if (!note_lines_ || note_lines_->first != key) note_lines_ = {key, findNoteLines(right)};
  return note_lines_->second;
}

qreal ChartScene::noteHeight(qreal right) const {
  const NoteLines& note = noteLines(right);
  return note.lines.isEmpty() ? 0.0
                              : static_cast<qreal>(note.lines.size()) * line_pitch(note.font) + 2.0;
}

void ChartScene::addHeading(const Metrics& m) {
  const auto line = [&](const QString& text, const QFont& font, const QColor& colour, qreal y) {
    if (text.isEmpty()) return;
    const qreal left = style_ == ChartStyle::Compact ? 12 : 24;
    auto* item =
        addSimpleText(fitted_line(text, QFontMetricsF(font), size_.width() - left - m.right), font);
    item->setBrush(colour);
    item->setPos(left, y);
  };
  if (style_ == ChartStyle::Compact) {
    // Smaller letters before any are omitted, and these from the subject: the part after it, such
    // as the number of a segment, distinguishes pictures.
    constexpr int kLeastTitle = 10;
    const QString title = text_of(page_.title);
    const qreal width = size_.width() - 12 - m.right;
    int letters = m.title_font;
    const auto fits = [&](const QString& text) {
      return QFontMetricsF(ui_font(letters, true)).horizontalAdvance(text) <= width;
    };
    while (letters > kLeastTitle && !fits(title)) --letters;
    QString shown = title;
    const qsizetype subject = title.lastIndexOf(", ");
    for (qsizetype n = subject; n > 1 && !fits(shown); --n)
      shown = title.left(n - 1).trimmed() + QChar(0x2026) + title.mid(subject);
    line(shown, ui_font(letters, true), theme_->text, 8);
    return;
  }
  // A saved title has no tooltip: smaller letters, then two lines, before it is cut.
  const qreal width = size_.width() - 24 - m.right;
  const QString whole = text_of(page_.title);
  constexpr int kLeastTitle = 13, kTwoLines = 12;
  int letters = m.title_font;
  const auto length = [&] {
    return QFontMetricsF(ui_font(letters, true)).horizontalAdvance(whole);
  };
  while (letters > kLeastTitle && length() > width) --letters;
  const qreal title = length();
  const QFont small = ui_font(kTwoLines, true);
  if (QStringList two =
          title > width ? wrapped(whole.split(' '), QFontMetricsF(small), width) : QStringList();
      two.size() > 1) {
    line(two.takeFirst(), small, theme_->text, 5);
    line(two.join(' '), small, theme_->text, 21);
  } else {
    line(whole, ui_font(letters, true), theme_->text, 14 + 0.5 * (m.title_font - letters));
  }
  FittedHeading heading;
  QFont font;
  for (const int size : {m.text_font, m.text_font - 1, m.text_font - 2}) {
    font = ui_font(size);
    heading =
        fitted_heading(text_of(page_.subtitle), QFontMetricsF(font), width, width - title - 24);
    if (!heading.below.contains(QChar(0x2026))) break;  // small letters before dots
  }
  line(heading.below, font, theme_->muted, 40);
  if (!heading.beside.isEmpty()) {
    auto* item = addSimpleText(heading.beside, font);
    item->setBrush(theme_->muted);
    item->setPos(size_.width() - m.right - QFontMetricsF(font).horizontalAdvance(heading.beside),
                 18);
  }
  qreal y = 60;
  const NoteLines& note = noteLines(m.right);
  const QFont note_font = ui_font(note.font);
  for (const QString& text : note.lines) {
    auto* item = addSimpleText(text, note_font);
    item->setBrush(theme_->accent);
    item->setPos(24, y);
    if (note.more) item->setToolTip(tooltip_of(text_of(noteText())));
    y += line_pitch(note.font);
  }
}

void ChartScene::addLabels(const QRectF& area, const AxisScale& x_scale, const AxisScale& y_scale,
                           const QString& x_title, const QString& y_title,
                           const std::vector<AxisTick>& x_ticks,
                           const std::vector<AxisTick>& y_ticks, const Metrics& m) {
  const QFont font = ui_font(m.tick_font), title_font = ui_font(m.text_font);
  const QFontMetricsF metrics(font), title_metrics(title_font);
  const auto add = [&](const QString& text, const QFont& used, const QColor& colour,
                       QPointF position) {
    auto* item = addSimpleText(text, used);
    item->setBrush(colour);
    item->setPos(position);
    return item;
  };
  for (const auto& [value, label] : fit_vertical_ticks(y_ticks, y_scale, area.height(), metrics)) {
    const QString text = text_of(label);
    const qreal y =
        area.bottom() - (value - y_scale.min) / (y_scale.max - y_scale.min) * area.height();
    add(text, font, theme_->muted,
        {area.left() - 8 - metrics.horizontalAdvance(text), y - 0.5 * metrics.height()});
  }
  for (const auto& [value, label] : fit_horizontal_ticks(x_ticks, x_scale, area.width(), metrics)) {
    const QString text = text_of(label);
    const qreal x =
        area.left() + (value - x_scale.min) / (x_scale.max - x_scale.min) * area.width();
    const qreal width = metrics.horizontalAdvance(text);
    add(text, font, theme_->muted,
        {std::min(x - 0.5 * width, size_.width() - width - 2), area.bottom() + 7});
  }
  if (!x_title.isEmpty()) {
    const qreal width = title_metrics.horizontalAdvance(x_title);
    add(x_title, title_font, theme_->text,
        {area.center().x() - 0.5 * width, area.bottom() + 10 + metrics.height()});
  }
  // A title longer than its panel may use the gaps above and below; then its unit gets a separate
  // line, which is never shortened, and its letters get smaller before any are omitted.
  constexpr int kLeastLetters = 10;
  const qreal room = available_title_length(area, m.gap);
  const auto write = [&](const QString& text, qreal left, qreal most) {
    QFont used = title_font;
    for (int size = m.text_font;
         size > kLeastLetters && QFontMetricsF(used).horizontalAdvance(text) > most;)
      used = ui_font(--size);
    const QFontMetricsF letters(used);
    const QString fitted = letters.elidedText(text, Qt::ElideRight, most);
    auto* title = add(fitted, used, theme_->text, {});
    title->setRotation(-90);
    title->setPos(left, area.center().y() + 0.5 * letters.horizontalAdvance(fitted));
  };
  const qsizetype unit = y_title.lastIndexOf(" [");
  if (title_metrics.horizontalAdvance(y_title) <= room || unit < 0) {
    write(y_title, area.left() - m.left + 8, room);
    return;
  }
  constexpr qreal kUnitMore = 8.0;  // nearer to the units of other panels: they are short
  write(y_title.left(unit), area.left() - m.left + 1, room);
  write(y_title.mid(unit + 1), area.left() - m.left + 1 + title_metrics.height() - 2,
        room + kUnitMore);
}

qreal ChartScene::labelsTop(const QRectF& area, const AxisScale& y_axis, const Metrics& m) const {
  const auto ticks = axis_ticks(y_axis);
  if (ticks.empty()) return area.bottom();
  const qreal part = (ticks.back().at - y_axis.min) / (y_axis.max - y_axis.min);
  return area.bottom() - part * area.height() - 0.5 * QFontMetricsF(ui_font(m.tick_font)).height();
}

namespace {

/// Length of the words with which all names begin before their numbers, "element " of "element 1",
/// "element 2"; 0: there are no such words.
std::size_t common_words(const std::vector<ChartCurve>& curves) {
  if (curves.empty()) return 0;
  std::string_view common = curves.front().name;
  for (const ChartCurve& curve : curves) {
    const auto [end, other] =
        std::mismatch(common.begin(), common.end(), curve.name.begin(), curve.name.end());
    common = common.substr(0, static_cast<std::size_t>(end - common.begin()));
  }
  const std::size_t space = common.rfind(' ');
  if (space == std::string_view::npos) return 0;
  const bool numbers = std::all_of(curves.begin(), curves.end(), [&](const ChartCurve& curve) {
    return curve.name.size() > space + 1 && curve.name[space + 1] >= '0' &&
           curve.name[space + 1] <= '9';
  });
  return numbers ? space + 1 : 0;
}

}  // namespace

qreal ChartScene::addLegend(const ChartPanel& panel, const std::vector<ShownCurve>& shown,
                            const QRectF& area, qreal labels_top, const Metrics& m) {
  if (panel.curves.size() < 2) return area.right();
  const QFont font = ui_font(m.text_font);
  const QFontMetricsF metrics(font);
  // Texts that do not fit share the space: first the lines get shorter, then long names are
  // shortened equally.
  const auto count = static_cast<qreal>(panel.curves.size());
  const auto drawn = [&](std::size_t i) {  // null: not
    const auto found = std::find_if(shown.begin(), shown.end(),
                                    [i](const ShownCurve& one) { return one.curve == i; });
    return found == shown.end() ? nullptr : &*found;
  };
  bool brief = false;  // "element 1", "2", "3": the common words only once
  const std::size_t common = common_words(panel.curves);
  const auto called = [&](std::size_t i) {
    return text_of(panel.curves[i].name.substr(brief && i > 0 ? common : 0));
  };
  const auto name_of = [&](std::size_t i, bool whole) {
    const ChartCurve& curve = panel.curves[i];
    const ShownCurve* const one = drawn(i);
    if (one != nullptr && one->hides) {
      const QString sign = one->alike == Alike::Equal  ? "="
                           : one->alike == Alike::Near ? "≈"
                                                       : tr("covers");
      if (one->partly)
        return whole ? tr("%1 (partly %2 %3)").arg(called(i), sign, called(*one->hides))
                     : tr("%1 (partly %2)").arg(called(i), sign);
      return whole ? tr("%1 (%2 %3)").arg(called(i), sign, called(*one->hides))
                   : tr("%1 (%2)").arg(called(i), sign);
    }
    if (std::none_of(curve.y.begin(), curve.y.end(), is_drawable))
      return tr("%1 (none)").arg(called(i));
    return panel.log && has_only_nonpositive_values(curve) ? tr("%1 (not above 0)").arg(called(i))
                                                           : called(i);
  };
  const auto length = [&](bool whole) {
    qreal all = 0.0;
    for (std::size_t i = 0; i < panel.curves.size(); ++i)
      all += metrics.horizontalAdvance(name_of(i, whole));
    return all;
  };
  const qreal room = area.right() - 8.0;  // also over the labels of the axis
  // If there is no space for the name of the hidden curve, only its sign is shown.
  brief = length(false) + count * (14.0 + 8.0) > room;
  const bool whole = length(true) + count * (14.0 + 8.0) <= room;
  const qreal names = length(whole);
  const bool narrow = names + count * (24.0 + 16.0) > room;
  const qreal line = narrow ? 14.0 : 24.0, gap = narrow ? 8.0 : 16.0;
  const qreal most =
      names + count * (line + gap) <= room ? room : std::max(0.0, room / count - line - gap);
  const auto index = static_cast<std::size_t>(&panel - page_.panels.data());
  std::vector<QString> texts, tooltips;
  qreal x = area.right() + gap;
  for (std::size_t i = 0; i < panel.curves.size(); ++i) {
    texts.push_back(metrics.elidedText(name_of(i, whole), Qt::ElideMiddle, most));
    x -= metrics.horizontalAdvance(texts.back()) + line + gap;
    const bool shown_brief = std::exchange(brief, false);
    tooltips.push_back(name_of(i, true));
    brief = shown_brief;
  }
  constexpr qreal kAbove = 3.0, kLabelGap = 8.0;
  const bool over_labels = x < area.left() - kLabelGap + 4.0;
  const qreal foot = over_labels ? std::min(area.top() - kAbove, labels_top) : area.top() - kAbove;
  x = area.right();
  for (std::size_t i = panel.curves.size(); i-- > 0;) {
    const ChartCurve& curve = panel.curves[i];
    const QString& name = texts[i];
    x -= metrics.horizontalAdvance(name);
    auto* label = addSimpleText(name, font);
    label->setBrush(curve.hidden ? theme_->muted : theme_->text);
    label->setToolTip(tooltips[i]);
    label->setPos(x, foot - metrics.height());
    const qreal middle = foot - 0.5 * metrics.height();
    const auto colour = [&](std::size_t of) { return theme_->curves[of % theme_->curves.size()]; };
    QPen pen(curve.hidden ? theme_->frame : colour(i), 2.4);
    if (const QList<qreal> dashes = dash_pattern(*theme_, i); !dashes.isEmpty()) {
      pen.setWidthF(m.line);
      pen.setDashPattern(dashes);
    } else if (curve.dashed) {
      pen.setDashPattern({2.0, 1.5});
    }
    if (const ShownCurve* const one = drawn(i); one != nullptr && one->hides) {
      addLine(QLineF(x - line, middle, x - 6, middle), QPen(colour(*one->hides), 2.4));
      pen.setDashPattern({2.0, 2.0});
      pen.setCapStyle(Qt::FlatCap);
    }
    addLine(QLineF(x - line, middle, x - 6, middle), pen);
    legend_.push_back({QRectF(x - line, foot - metrics.height(),
                              metrics.horizontalAdvance(name) + line, metrics.height()),
                       index, i});
    x -= line + gap;
  }
  return x;
}

void ChartScene::addMessage(const QRectF& area, const QString& text, const Metrics& m) {
  auto* item = addText(text);
  item->setDefaultTextColor(theme_->muted);
  item->document()->setDefaultTextOption(QTextOption(Qt::AlignCenter));
  // In a low panel smaller letters, before text overlaps the axes.
  constexpr int kSmallest = 10;
  const qreal margins = 2.0 * item->document()->documentMargin();
  for (int size = m.text_font + 1; size >= kSmallest; --size) {
    item->setFont(ui_font(size));
    item->setTextWidth(std::min<qreal>(area.width() - 20, 640));
    if (item->boundingRect().height() - margins <= area.height()) break;
  }
  item->setPos(area.center() - item->boundingRect().center());
}

}  // namespace adore::desktop
