#include "agore/sketch.hpp"

#include "desktop/picture_marks.hpp"

#include <QFontMetricsF>
#include <QPaintEngine>
#include <QPainterPath>
#include <QTransform>

#include <cmath>
#include <numbers>

namespace adore::agore {

namespace {

/// Drawings that are kept.
enum Kind : int { kRing, kDashes, kBall, kRollerEnd, kRail };

/// `colour` over an opaque one.
QColor over(const QColor& paper, const QColor& colour) {
  const auto mix = [part = colour.alphaF()](int below, int above) {
    return static_cast<int>(std::lround(below + part * (above - below)));
  };
  return {mix(paper.red(), colour.red()), mix(paper.green(), colour.green()),
          mix(paper.blue(), colour.blue())};
}

/// Of the cage's side ring, and of its edge.
std::array<QColor, 2> rail_colours(const desktop::Theme& theme) {
  std::array<QColor, 2> out{theme.cage.lighter(106), theme.cage.darker(125)};
  for (QColor& colour : out) colour.setAlpha(110);
  return out;
}

}  // namespace

bool is_raster_target(const QPainter& painter) {
  return painter.paintEngine() != nullptr && painter.paintEngine()->type() == QPaintEngine::Raster;
}

void append_visible_point(QPolygonF& line, QPointF next) {
  if (line.isEmpty() || (next - line.back()).manhattanLength() > 0.5) line.append(next);
}

QColor rotation_mark_color(const desktop::Theme& theme) {
  return theme.kind == desktop::ThemeKind::Dark ? QColor(Qt::black) : theme.text;
}

namespace {

/// Edge that separates a mark from the paths below it: white next to dark marks, dark next to pale
/// marks.
QColor mark_edge(const QColor& colour) {
  return qGray(colour.rgb()) < 128 ? QColor("#f0f0f0") : QColor("#101418");
}
/// Its width, thinner on the small bodies of a key [pixels].
double edge_width(double r) { return std::min(1.0, 0.12 * r); }

bool drawable(const std::array<double, 3>& mark, QPointF middle) {
  return mark != std::array<double, 3>{} &&
         std::isfinite(mark[0] + mark[1] + mark[2] + middle.x() + middle.y());  // else stars
}

}  // namespace

void draw_rotation_mark(QPainter& painter, QPointF middle, double r,
                        const std::array<double, 3>& mark, const QColor& colour) {
  if (!drawable(mark, middle)) return;
  const QPointF way = QPointF(mark[0], -mark[1]) * r * 0.8, tip = middle + way;
  constexpr double kBehind = -0.05;  // clearly: at the edge the sign is determined by rounding
  const double width = std::clamp(0.09 * r, 1.4, 5.0),
               dot = std::clamp(0.15 * r, std::min(2.6, 0.3 * r), 10.0);
  const double ring = std::clamp(0.06 * r, 1.2, 3.0), hole = dot - 0.5 * ring;
  const bool behind = mark[2] < kBehind;
  const double length = std::hypot(way.x(), way.y());
  const auto draw = [&](const QColor& ink, double extra) {
    painter.setPen(
        QPen(ink, (behind ? std::min(width, ring) : width) + extra, Qt::SolidLine, Qt::RoundCap));
    if (!behind)
      painter.drawLine(middle, tip);
    else if (length > hole)
      painter.drawLine(middle, middle + way * (1.0 - hole / length));
    if (behind) {
      painter.setBrush(Qt::NoBrush);
      painter.drawEllipse(tip, hole, hole);
    } else {
      painter.setPen(Qt::NoPen);
      painter.setBrush(ink);
      painter.drawEllipse(tip, dot + 0.5 * extra, dot + 0.5 * extra);
    }
  };
  draw(mark_edge(colour), 2.0 * edge_width(r));
  draw(colour, 0.0);
}

void draw_rotation_sector(QPainter& painter, QPointF middle, double r,
                          const std::array<double, 3>& mark, const QColor& colour) {
  if (!drawable(mark, middle)) return;
  constexpr double kHalf = 26.0, kOuter = 0.86;  // degrees, of the radius
  const double reach = kOuter * r * std::min(1.0, std::hypot(mark[0], mark[1]));
  const double angle = std::atan2(mark[1], mark[0]) * 180.0 / std::numbers::pi;
  QPainterPath sector(middle);
  sector.arcTo(QRectF(middle.x() - reach, middle.y() - reach, 2.0 * reach, 2.0 * reach),
               angle - kHalf, 2.0 * kHalf);
  sector.closeSubpath();
  painter.setBrush(colour);
  painter.setPen(
      QPen(mark_edge(colour), 2.0 * edge_width(r), Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPath(sector);
  painter.setPen(Qt::NoPen);  // over the inner half of its edge
  painter.drawPath(sector);
}

Sketch::Sketch(QPainter& painter, const QRectF& area, double radius, const desktop::Theme& theme,
               QPointF pan, double foot, SpriteCache* stamps, double head)
    : painter_(painter),
      area_(area),
      theme_(theme),
      centre_(area.center() + QPointF(0.0, 0.5 * (head - foot)) +
              QPointF(pan.x() * area.width(), pan.y() * area.height())),
      half_(0.5 * std::min(area.width(), area.height() - foot - head)),
      scale_(half_ / radius),
      sprite_cache_(stamps) {}

void Sketch::stamp(QPointF middle, double reach, const SpriteCache::DrawingAppearance& look,
                   const std::function<void(QPainter&, QPointF)>& paint) const {
  if (!std::isfinite(middle.x() + middle.y())) return;  // stars in the file
  if (sprite_cache_ != nullptr && is_raster_target(painter_))
    sprite_cache_->draw(painter_, middle, reach, look, paint);
  else
    paint(painter_, middle);
}

QPointF Sketch::around(QPointF centre, double radius, double angle) const {
  return at(centre.x() - radius * std::sin(angle), centre.y() + radius * std::cos(angle));
}

void Sketch::ring(QPointF centre, double inner, double outer, const QColor& light,
                  const QColor& dark) const {
  const double out = outer * scale_, in = inner * scale_;
  stamp(at(centre.x(), centre.y()), out + 1.0, {kRing, {out, in}, {light.rgba(), dark.rgba()}},
        [&](QPainter& p, QPointF middle) {
          QPainterPath path;
          path.addEllipse(middle, out, out);
          path.addEllipse(middle, in, in);
          const QPointF corner = QPointF(out, out) * 0.7;
          QLinearGradient shade(middle - corner, middle + corner);
          shade.setColorAt(0, light);
          shade.setColorAt(1, dark);
          p.setPen(QPen(dark.darker(125), 1.0));
          p.setBrush(shade);
          p.drawPath(path);
        });
}

void Sketch::circle(QPointF centre, double radius, const QPen& pen) const {
  painter_.setPen(pen);
  painter_.setBrush(Qt::NoBrush);
  painter_.drawEllipse(at(centre.x(), centre.y()), radius * scale_, radius * scale_);
}

void Sketch::dashed_circle(QPointF centre, double radius, const QColor& colour,
                           double width) const {
  const double r = radius * scale_;
  if (!(r > 0.0)) return;
  constexpr int kFew = 600;
  const QPointF there = at(centre.x(), centre.y());
  stamp(there, r + width + kCasing, {kDashes, {r, width}, {colour.rgba()}},
        [&](QPainter& p, QPointF middle) {
          const int count = std::max(
              8, static_cast<int>(std::lround(2.0 * std::numbers::pi * r / (6.0 * width))));
          const double step = 2.0 * std::numbers::pi / count;
          QVector<QLineF> dashes;
          for (int i = 0; i < count; ++i) {
            const auto end = [&](double part) {
              return r * QPointF(std::sin((i + part) * step), -std::cos((i + part) * step));
            };
            const QLineF dash(end(0.0), end(2.0 / 3.0));
            if (count < kFew || area_.contains(there + dash.p1()) ||
                area_.contains(there + dash.p2()))
              dashes.append(dash.translated(middle));
          }
          for (const auto& [ink, thick] :
               {std::pair{theme_.surface, width + 2.0 * kCasing}, {colour, width}}) {
            p.setPen(QPen(ink, thick, Qt::SolidLine, Qt::FlatCap));
            p.drawLines(dashes);
          }
        });
}

void Sketch::ball(QPointF centre, double radius, const std::array<double, 3>& mark,
                  const QColor& tint) const {
  const QPointF there = at(centre.x(), centre.y());
  if (!std::isfinite(there.x() + there.y())) return;  // stars in the file
  const double r = radius * scale_;
  const QColor rim = theme_.steel_dark.darker(150);
  const auto draw = [&](QPainter& p, QPointF middle) {
    p.setPen(QPen(rim, 1));
    p.setBrush(tint.isValid()
                   ? QBrush(tint)  // as the scale shows it: no light, no shade
                   : desktop::ball_brush(middle, r, QColor("#ffffff"), theme_.steel_light,
                                         theme_.steel_dark.darker(115)));
    p.drawEllipse(middle, r, r);
  };
  if (tint.isValid())
    draw(painter_, there);
  else
    stamp(there, r + 1.0, {kBall, {r}, {rim.rgba(), theme_.steel_light.rgba()}}, draw);
  draw_element_rotation_mark(centre, radius, mark, false);
}

void Sketch::roller_end(QPointF centre, double radius, const std::array<double, 3>& mark,
                        const QColor& tint) const {
  const QPointF there = at(centre.x(), centre.y());
  if (!std::isfinite(there.x() + there.y())) return;  // stars in the file
  const double r = radius * scale_;
  ring(centre, 0.88 * radius, radius, theme_.steel_dark, theme_.steel_dark.darker(130));  // corner
  const auto draw = [&](QPainter& p, QPointF middle) {
    QLinearGradient shade(middle - QPointF(r, r) * 0.7, middle + QPointF(r, r) * 0.7);
    shade.setColorAt(0, theme_.steel_light);
    shade.setColorAt(1, theme_.steel_dark);
    p.setPen(Qt::NoPen);
    p.setBrush(tint.isValid() ? QBrush(tint) : QBrush(shade));
    p.drawEllipse(middle, 0.88 * r, 0.88 * r);
  };
  if (tint.isValid())
    draw(painter_, there);
  else
    stamp(there, r, {kRollerEnd, {r}, {theme_.steel_light.rgba(), theme_.steel_dark.rgba()}}, draw);
  draw_element_rotation_mark(centre, radius, mark, true);
}

void Sketch::draw_element_rotation_mark(QPointF centre, double radius,
                                        const std::array<double, 3>& mark, bool roller) const {
  (roller ? draw_rotation_sector : draw_rotation_mark)(
      painter_, at(centre.x(), centre.y()), radius * scale_, mark, rotation_mark_color(theme_));
}

void Sketch::cage_rail(QPointF centre, const Animation& animation) const {
  const auto& g = animation.file.geometry;
  const double out = g.cage_outer_radius * scale_, in = g.cage_inner_radius * scale_;
  stamp(at(centre.x(), centre.y()), out + 1.0, {kRail, {out, in}, {theme_.cage.rgba()}},
        [&](QPainter& p, QPointF middle) {
          QPainterPath path;
          for (const double radius : {out, in}) path.addEllipse(middle, radius, radius);
          draw_pale_cage(p, path);
        });
}

void Sketch::cage_rail(QPointF centre, const Animation& animation, double begin, double end) const {
  const auto& g = animation.file.geometry;
  constexpr int kParts = 60;
  QPolygonF rail;
  for (int i = 0; i <= kParts; ++i)
    rail.append(around(centre, g.cage_outer_radius, begin + (end - begin) * i / kParts));
  for (int i = kParts; i >= 0; --i)
    rail.append(around(centre, g.cage_inner_radius, begin + (end - begin) * i / kParts));
  QPainterPath path;
  path.addPolygon(rail);
  path.closeSubpath();
  draw_pale_cage(painter_, path);
}

void Sketch::draw_pale_cage(QPainter& painter, const QPainterPath& path) const {
  const auto [colour, edge] = rail_colours(theme_);
  painter.setPen(QPen(edge, 1.0));
  painter.setBrush(colour);
  painter.drawPath(path);
}

void Sketch::cage(QPointF centre, double angle, double outer_radius,
                  const CageOutlines::Outline& outline) const {
  const QPointF middle = at(centre.x(), centre.y());
  QTransform turn = QTransform::fromTranslate(middle.x(), middle.y());
  const double unit = scale_ * outer_radius / CageOutlines::kRadius;
  turn.scale(unit, -unit);
  turn.rotateRadians(angle);
  painter_.setPen(QPen(theme_.cage.darker(145), 1.0));
  // Color in front of its side ring, opaque: translucent fills are slow.
  QColor fill = theme_.cage;
  fill.setAlpha(225);
  painter_.setBrush(over(over(theme_.surface, rail_colours(theme_)[0]), fill));
  QPainterPath whole;
  for (const QPolygonF& piece : outline.pieces) {
    const QPolygonF turned = turn.map(piece);
    if (outline.nested)
      whole.addPolygon(turned);
    else if (turned.boundingRect().intersects(area_))
      painter_.drawPolygon(turned);
  }
  if (!whole.isEmpty()) painter_.drawPath(whole);
}

namespace {

int letters_of(double pixels) { return std::clamp(static_cast<int>(pixels * 0.16), 11, 16); }

}  // namespace

bool Sketch::can_label_frame(double length) const {
  constexpr double kLeast = 28.0;  // pixels: names of shorter axes would overlap
  return length * scale_ >= kLeast;
}

std::array<QPointF, 2> Sketch::frame_label_positions(QPointF centre, double angle, double length,
                                                     double side) const {
  // Next to the tips: parallel frames are on one line.
  const double beside = (0.7 * letters_of(length * scale_) + 5.0) / scale_;
  const double tip = std::hypot(length, beside), turn = side * std::atan2(beside, length);
  return {around(centre, tip, angle + turn),
          around(centre, tip, angle - 0.5 * std::numbers::pi - turn)};
}

void Sketch::frame(QPointF centre, double angle, double length, const QColor& colour,
                   bool named) const {
  const QPointF origin = at(centre.x(), centre.y());
  const double y = (named ? 1.0 : kShorterArm) * length;
  arrow(origin, around(centre, y, angle - 0.5 * std::numbers::pi), colour, 2.4);
  arrow(origin, around(centre, length, angle), colour, 2.4);
}

void Sketch::draw_frame_labels(QPointF centre, double angle, double length, const QColor& colour,
                               double side) const {
  const std::array<QPointF, 2> names = frame_label_positions(centre, angle, length, side);
  for (std::size_t i = 0; i < names.size(); ++i)
    draw_outlined_label(names[i], i == 0 ? "z" : "y", colour, letters_of(length * scale_));
}

void Sketch::arrow(QPointF from, QPointF to, const QColor& colour, double width) const {
  const QPointF along = to - from;
  const double length = std::hypot(along.x(), along.y());
  if (length < 1.0) return;
  const QPointF u = along / length;
  // A short arrow keeps half of its shaft, which is thinner than its head.
  const double head = std::min(0.5 * length, 5.0 + 3.2 * width);
  const double shaft = std::min(width, 0.4 * head);
  const double casing = std::min(kCasing, 0.2 * length);  // at most the length of the arrow
  const QPointF neck = to - u * head * 0.8;
  painter_.setPen(QPen(theme_.surface, shaft + 2.0 * casing, Qt::SolidLine, Qt::FlatCap));
  painter_.drawLine(from, neck);
  desktop::draw_arrow_head(painter_, to, u, head, colour, QPen(theme_.surface, 2.0 * casing));
  painter_.setPen(QPen(colour, shaft, Qt::SolidLine, Qt::FlatCap));
  painter_.drawLine(from, neck);
}

void draw_asterisk(QPainter& painter, QPointF where, double size, const QColor& colour,
                   const QColor& rim) {
  for (const auto& pen : {QPen(rim, 5.0, Qt::SolidLine, Qt::RoundCap),
                          QPen(colour, 2.6, Qt::SolidLine, Qt::RoundCap)}) {
    painter.setPen(pen);
    for (int i = 0; i < 3; ++i) {
      const double a = std::numbers::pi * (i / 3.0 + 0.5);
      const QPointF d(size * std::cos(a), size * std::sin(a));
      painter.drawLine(where - d, where + d);
    }
  }
}

void Sketch::asterisk(QPointF where, double size, const QColor& colour) const {
  draw_asterisk(painter_, where, size, colour, theme_.surface);
}

void Sketch::label(QPointF where, const QString& text, const QColor& colour, int pixel_size,
                   bool bold) const {
  const QFont font = desktop::ui_font(pixel_size, bold);
  const QFontMetricsF metrics(font);
  painter_.setFont(font);
  painter_.setPen(colour);
  painter_.drawText(QPointF(where.x() - 0.5 * metrics.horizontalAdvance(text),
                            where.y() + 0.5 * metrics.capHeight()),
                    text);
}

void Sketch::draw_outlined_label(QPointF where, const QString& text, const QColor& colour,
                                 int pixel_size) const {
  const QFont font = desktop::ui_font(pixel_size, true);
  const QFontMetricsF metrics(font);
  QPainterPath letters;
  letters.addText(QPointF(where.x() - 0.5 * metrics.horizontalAdvance(text),
                          where.y() + 0.5 * metrics.capHeight()),
                  font, text);
  painter_.setPen(
      QPen(theme_.surface, 2.0 * kCasing + 1.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter_.setBrush(Qt::NoBrush);
  painter_.drawPath(letters);
  label(where, text, colour, pixel_size, true);
}

}  // namespace adore::agore
