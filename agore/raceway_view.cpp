#include "agore/ring_profile.hpp"
#include "agore/view_layout.hpp"
#include "agore/view_scene.hpp"
#include "desktop/axis_scale.hpp"

#include <QFontMetricsF>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

/// Both raceways unrolled: azimuth to the right (0: +Z, up), across the raceway upward (+x up).
/// Each contact ellipse has its semi-axes a (across, to scale with the position) and b (in rolling
/// direction, magnified), and the color of its largest pressure.
namespace adore::agore {
namespace {

struct Contact {
  std::size_t element = 0, race = 0;
  double azimuth = 0.0;     ///< 0 to 2 pi
  double across = 0.0;      ///< center, from the middle of the raceway
  double a = 0.0, b = 0.0;  ///< [file unit]
  double pressure = 0.0;
};

/// Balls: arc length in the groove from its bottom. Rollers: along the roller.
double across_of(const Scene& s, std::size_t race, double angle) {
  if (s.animation.file.bearing_type != 1) return 0.0;
  const char* groove = race == 0 ? "outer_groove_radius" : "inner_groove_radius";
  return angle * dimension_in_file_unit(s.animation, groove, s.geometry().element_radius) *
         (race == 0 ? 1.0 : -1.0);
}

std::vector<Contact> contacts_of(const Scene& s) {
  std::vector<Contact> out;
  for (std::size_t k = 0; k < s.frame.elements.size(); ++k)
    for (const std::string of : {"contact.", "second_contact."})
      for (std::size_t race = 0; race < 2; ++race) {
        const auto value = [&](const char* name) {
          return s.animation.value(of + name, s.index, 2 * k + race);
        };
        if (!(value("load") > 0.0)) continue;
        Contact one;
        one.element = k, one.race = race;
        const double turn = 2.0 * kPi;
        one.azimuth =
            s.frame.elements[k].theta - turn * std::floor(s.frame.elements[k].theta / turn);
        one.across = across_of(s, race, value("angle"));
        one.a = value("half_major"), one.b = value("half_minor");
        one.pressure = value("pressure");
        if (std::isfinite(one.across + one.a + one.b)) out.push_back(one);
      }
  return out;
}

/// Half of the width across that all contacts of the run need, and the largest b.
struct Extent {
  double across = 0.0, along = 0.0;
};
Extent extent_of(const Scene& s) {
  Extent out;
  const auto* a = s.animation.motion->channel("contact.half_major");
  const auto* b = s.animation.motion->channel("contact.half_minor");
  const auto* angle = s.animation.motion->channel("contact.angle");
  constexpr std::size_t kMost = 200'000;  // values looked at
  const std::size_t every = a->values.size() / kMost + 1;
  for (std::size_t i = 0; i < a->values.size(); i += every) {
    const std::size_t race = (i % a->width) % 2;
    const double reach =
        a->values[i] + (angle != nullptr ? std::abs(across_of(s, race, angle->values[i])) : 0.0);
    if (std::isfinite(reach) && a->values[i] > 0.0) out.across = std::max(out.across, reach);
    if (std::isfinite(b->values[i])) out.along = std::max(out.along, b->values[i]);
  }
  return out;
}

struct Strip {
  QRectF area;
  double scale = 0.0;  ///< pixels per length, across
};

void draw_strip(const Scene& s, const Strip& strip, std::size_t race) {
  QPainter& p = s.sketch.painter();
  const auto& t = s.sketch.theme();
  p.setPen(QPen(t.frame, 1.0));
  p.setBrush(t.raised);
  p.drawRect(strip.area);
  p.setPen(QPen(t.frame, 1.0, Qt::DashLine));
  p.drawLine(QPointF(strip.area.left(), strip.area.center().y()),
             QPointF(strip.area.right(), strip.area.center().y()));
  p.setFont(desktop::ui_font(12, true));
  p.setPen(race_colour(t, race));
  p.drawText(strip.area.adjusted(0.0, -18.0, 0.0, 0.0), Qt::AlignLeft | Qt::AlignTop,
             race == 0 ? "Outer raceway" : "Inner raceway");
  p.setFont(desktop::ui_font(11));
  p.setPen(t.muted);
  for (const int degrees : {0, 90, 180, 270, 360}) {
    const double x = strip.area.left() + strip.area.width() * degrees / 360.0;
    p.drawLine(QPointF(x, strip.area.bottom()), QPointF(x, strip.area.bottom() + 4.0));
    if (race == 1)
      p.drawText(QRectF(x - 30.0, strip.area.bottom() + 4.0, 60.0, 14.0), Qt::AlignCenter,
                 QString("%1°").arg(degrees));
  }
}

/// "a 1.2 mm, b 0.11 mm, 1.87 GPa"
QString words_of(const Scene& s, const Contact& one) {
  const std::string& length = s.animation.file.units[0];
  const auto* pressure = s.animation.motion->channel("contact.pressure");
  return QString::fromStdString(
      fmt::format("a {}, b {}, {}", desktop::pretty_quantity(one.a, length, 3),
                  desktop::pretty_quantity(one.b, length, 3),
                  desktop::pretty_quantity(one.pressure, pressure->unit, 3)));
}

void draw_bar(const Scene& s, const ElementColors& colours, const QRectF& room) {
  QPainter& p = s.sketch.painter();
  QLinearGradient shade(room.left(), 0.0, room.right(), 0.0);
  constexpr int kStops = 12;
  for (int i = 0; i <= kStops; ++i)
    shade.setColorAt(static_cast<double>(i) / kStops,
                     scale_colour(static_cast<double>(i) / kStops));
  p.setPen(s.sketch.theme().muted);
  p.setBrush(shade);
  p.drawRect(QRectF(room.left(), room.top() + 16.0, room.width(), 9.0));
  p.setFont(desktop::ui_font(12));
  p.drawText(QPointF(room.left(), room.top() + 11.0),
             QString::fromStdString(colours.title + " (" + colours.scale + ")"));
  p.drawText(QPointF(room.left(), room.top() + 38.0),
             QString::fromStdString(colours.low_end_label()));
  const QString most = QString::fromStdString(colours.high_end_label());
  p.drawText(
      QPointF(room.right() - QFontMetricsF(p.font()).horizontalAdvance(most), room.top() + 38.0),
      most);
}

}  // namespace

void draw_raceway_view(const Scene& s) {
  QPainter& p = s.sketch.painter();
  const auto& t = s.sketch.theme();
  const QRectF& whole = s.sketch.area();
  const ElementColors colours =
      element_colors(s.animation, s.index, ColourBy::Pressure, s.options.scale);
  const double foot = legend_height_below(s.animation, s.options, whole.size());
  constexpr double kHead = 46.0, kTitle = 20.0, kAxis = 20.0, kBar = 300.0,
                   kNumbers = 18.0;  // of the elements, between the strips
  p.save();
  // Zoom and displacement as of the other pictures.
  p.translate(whole.center() +
              QPointF(s.options.pan.x() * whole.width(), s.options.pan.y() * whole.height()));
  p.scale(s.options.zoom, s.options.zoom);
  p.translate(-whole.center());
  const QRectF room = whole.adjusted(22.0, kHead, -22.0, -foot - kAxis);
  const double height = 0.5 * (room.height() - 2.0 * kTitle - kNumbers);
  std::vector<PictureLegendEntry> key;
  QString remark;
  if (!colours.any() || !(height > 10.0)) {
    p.setPen(t.muted);
    p.setFont(desktop::ui_font(12));
    p.drawText(room, Qt::AlignCenter | Qt::TextWordWrap, QString::fromStdString(colours.why_none));
    p.restore();
    return draw_legend(s, key, remark);
  }
  draw_bar(s, colours,
           {whole.right() - 22.0 - std::min(kBar, room.width()), whole.top() + 2.0,
            std::min(kBar, room.width()), kHead});
  const Extent extent = extent_of(s);
  const auto n = static_cast<double>(std::max(1, s.animation.file.elements));
  const double across = 0.46 * height / std::max(extent.across, 1e-300);
  // Neighbors do not overlap, and the ellipses keep an upright shape.
  const double along =
      std::min(0.4 * room.width() / n / std::max(extent.along, 1e-300), 20.0 * across);
  std::array<Strip, 2> strips;
  for (std::size_t race = 0; race < 2; ++race) {
    const double top =
        room.top() + kTitle + static_cast<double>(race) * (height + kTitle + kNumbers);
    strips[race] = {QRectF(room.left(), top, room.width(), height), across};
    draw_strip(s, strips[race], race);
  }
  std::array<QString, 2> picked{"no contact", "no contact"};
  p.setFont(desktop::ui_font(11));
  for (const Contact& one : contacts_of(s)) {
    const Strip& strip = strips[one.race];
    const QPointF at(strip.area.left() + strip.area.width() * one.azimuth / (2.0 * kPi),
                     strip.area.center().y() - across * one.across);
    const bool chosen = static_cast<int>(one.element) + 1 == s.options.element;
    p.setPen(QPen(chosen ? t.text : t.steel_dark, chosen ? 2.4 : 1.0));
    p.setBrush(scale_colour((one.pressure - colours.low) / (colours.high - colours.low)));
    p.save();
    p.setClipRect(strip.area, Qt::IntersectClip);
    // 0 and 360 degrees are one place.
    for (const double turn : {-1.0, 0.0, 1.0})
      p.drawEllipse(at + QPointF(turn * strip.area.width(), 0.0), std::max(along * one.b, 1.0),
                    std::max(across * one.a, 1.0));
    p.restore();
    if (chosen) picked[one.race] = words_of(s, one);
  }
  // Numbers between the strips, at the azimuth of their elements.
  for (std::size_t k = 0; k < s.frame.elements.size(); ++k) {
    const double turn = s.frame.elements[k].theta / (2.0 * kPi);
    const double x = room.left() + room.width() * (turn - std::floor(turn));
    s.sketch.label({x, strips[0].area.bottom() + 4.0 + 0.5 * kNumbers}, QString::number(k + 1),
                   static_cast<int>(k) + 1 == s.options.element ? t.text : t.muted, 11,
                   static_cast<int>(k) + 1 == s.options.element);
  }
  p.restore();
  key.push_back({t.text, QString("element %1, outer: %2").arg(s.options.element).arg(picked[0]),
                 LegendMark::None});
  key.push_back({t.text, QString("element %1, inner: %2").arg(s.options.element).arg(picked[1]),
                 LegendMark::None});
  remark = QString::fromStdString(
      fmt::format("axial direction (a) to scale  ·  rolling direction (b) enlarged × {}",
                  desktop::pretty_number(along / across, 3)));
  draw_legend(s, key, remark);
}

}  // namespace adore::agore
