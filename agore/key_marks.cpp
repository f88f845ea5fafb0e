#include "agore/picture_key.hpp"
#include "agore/sketch.hpp"
#include "agore/view_scene.hpp"
#include "agore/ways.hpp"
#include "desktop/picture_marks.hpp"

#include <cmath>
#include <numbers>

/// Small drawings of the marks in front of the texts of a key.
namespace adore::agore {
namespace {

void draw_star(QPainter& p, QPointF middle, const QColor& colour) {
  // Without the edge for steel backgrounds: not needed on the page background.
  p.setPen(QPen(colour, 2.0, Qt::SolidLine, Qt::RoundCap));
  for (int i = 0; i < 3; ++i) {
    const double a = std::numbers::pi * (i / 3.0 + 0.5);
    const QPointF d = 5.0 * QPointF(std::cos(a), std::sin(a));
    p.drawLine(middle - d, middle + d);
  }
}

}  // namespace

void draw_legend_mark(QPainter& p, const PictureLegendEntry& entry, const desktop::Theme& theme,
                      QPointF at, double length) {
  const QColor& colour = entry.colour;
  const QPointF middle = at + QPointF(0.5 * length, 0.0), end = at + QPointF(length, 0.0);
  constexpr double kBody = 5.5, kSpot = 3.5;  // pixels
  switch (entry.mark) {
    case LegendMark::None:
      return;
    case LegendMark::Star:
      return draw_star(p, middle, colour);
    case LegendMark::Dots: {
      constexpr double kWidth = 2.0;  // of the paths in the pictures
      for (const double part : {0.1, 0.5, 0.9})
        draw_frame_mark(p, at + QPointF(part * length, 0.0), kWidth, colour);
      return;
    }
    case LegendMark::Spot:
      p.setPen(Qt::NoPen);
      p.setBrush(colour);
      p.drawEllipse(middle, kSpot, kSpot);
      return;
    case LegendMark::Disc:
      p.setPen(QPen(theme.steel_dark.darker(150), 1.0));
      p.setBrush(colour);
      p.drawEllipse(middle, kBody, kBody);
      return;
    case LegendMark::Turning:
    case LegendMark::Sector: {
      const auto body = [&](QPointF at_body, double radius, const QColor& fill, const QColor& ink) {
        p.setPen(QPen(theme.steel_dark.darker(150), 1.0));
        p.setBrush(fill);
        p.drawEllipse(at_body, radius, radius);
        constexpr double kWay = 0.7;  // to the upper right
        (entry.mark == LegendMark::Sector ? draw_rotation_sector : draw_rotation_mark)(
            p, at_body, radius, {kWay, kWay, entry.mark == LegendMark::Sector ? 0.0 : 1.0}, ink);
      };
      return body(middle, kBody, entry.on_colours ? scale_colour(0.5) : theme.steel_light, colour);
    }
    case LegendMark::Scale: {
      QLinearGradient shade(at, end);
      constexpr int kStops = 12;
      for (int i = 0; i <= kStops; ++i)
        shade.setColorAt(static_cast<double>(i) / kStops,
                         scale_colour(static_cast<double>(i) / kStops));
      p.setPen(Qt::NoPen);
      p.setBrush(shade);
      p.drawRect(QRectF(at - QPointF(0.0, 4.0), end + QPointF(0.0, 4.0)));
      return;
    }
    case LegendMark::Arrow: {
      constexpr double kHead = 10.0;
      p.setPen(QPen(colour, 5.0, Qt::SolidLine, Qt::FlatCap));
      p.drawLine(at, end - QPointF(0.8 * kHead, 0.0));
      desktop::draw_arrow_head(p, end, {1.0, 0.0}, kHead, colour);
      return;
    }
    case LegendMark::Contact: {
      constexpr double kHead = 7.0;
      QPen dashes(colour, 1.8, Qt::SolidLine, Qt::FlatCap);
      dashes.setDashPattern({1.9, 1.4});
      p.setPen(dashes);
      p.drawLine(at, middle - QPointF(1.5, 0.0));
      p.setPen(QPen(colour, 2.4, Qt::SolidLine, Qt::FlatCap));
      p.drawLine(end, middle + QPointF(0.8 * kHead - 1.0, 0.0));
      desktop::draw_arrow_head(p, middle - QPointF(1.0, 0.0), {-1.0, 0.0}, kHead, colour);
      return;
    }
    case LegendMark::Frame: {
      constexpr double kLong = 11.0, kHead = 5.0;
      const QPointF origin = at + QPointF(4.0, 0.5 * kLong);
      for (const auto& [way, arm] :
           {std::pair{QPointF(0.0, -1.0), kLong}, {QPointF(1.0, 0.0), kShorterArm * kLong}}) {
        p.setPen(QPen(colour, 1.4, Qt::SolidLine, Qt::FlatCap));
        p.drawLine(origin, origin + (arm - 0.8 * kHead) * way);
        desktop::draw_arrow_head(p, origin + arm * way, way, kHead, colour);
      }
      return;
    }
    case LegendMark::Line:
    case LegendMark::Dashed:
    case LegendMark::Dotted: {
      QPen pen(colour, entry.mark == LegendMark::Line ? 3.0 : 1.6, Qt::SolidLine, Qt::FlatCap);
      if (entry.mark == LegendMark::Dashed) pen.setDashPattern({4.0, 2.0});
      if (entry.mark == LegendMark::Dotted) pen.setDashPattern({1.0, 1.5});
      p.setPen(pen);
      p.drawLine(at, end);
    }
  }
}

}  // namespace adore::agore
