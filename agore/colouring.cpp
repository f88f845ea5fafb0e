#include "agore/view_layout.hpp"
#include "agore/view_scene.hpp"
#include "desktop/axis_scale.hpp"

#include <QFontMetricsF>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace adore::agore {
namespace {

struct Quantity {
  const char* channel;
  const char* title;
};

Quantity quantity_of(ColourBy by) {
  switch (by) {
    case ColourBy::Slip:
      return {"contact.slip", "largest slip"};
    case ColourBy::Heat:
      return {"contact.heat", "contact heat"};
    case ColourBy::Temperature:
      return {"contact.temperature", "contact temperature"};
    case ColourBy::Load:
    case ColourBy::None:
      break;
  }
  return {"contact.load", "contact load"};
}

}  // namespace

Colouring colouring(const Animation& animation, std::size_t frame, ColourBy by) {
  Colouring out;
  if (by == ColourBy::None) return out;
  const Quantity quantity = quantity_of(by);
  out.title = quantity.title;
  const results::MotionChannel* channel =
      animation.motion ? animation.motion->channel(quantity.channel) : nullptr;
  const auto n = static_cast<std::size_t>(animation.file.elements);
  if (channel == nullptr || channel->width != 2 * n) {
    out.why_none = "no colours: " + (animation.no_contacts.empty()
                                         ? std::string("RESULTS.h5 lacks the channel")
                                         : animation.no_contacts);
    return out;
  }
  if (by == ColourBy::Temperature) {
    // A temperature that nothing raises is the deck's own.
    const results::MotionChannel* rise = animation.motion->channel("contact.temperature_rise");
    if (rise != nullptr &&
        std::none_of(rise->values.begin(), rise->values.end(), [](double v) { return v > 0.0; })) {
      out.why_none = "no colours: this run computes no temperature of contacts";
      return out;
    }
  }
  out.unit = channel->unit;
  for (const double value : channel->values)
    if (std::isfinite(value)) out.largest = std::max(out.largest, value);
  for (std::size_t k = 0; k < n; ++k)
    out.value.push_back(std::max(channel->at(frame, 2 * k), channel->at(frame, 2 * k + 1)));
  if (!(out.largest > 0.0)) out.why_none = "no colours: it is zero in the whole run";
  return out;
}

QColor scale_colour(double part) {
  struct Stop {
    double red, green, blue;
  };
  constexpr std::array<Stop, 6> kStops{
      {{68, 1, 84}, {65, 68, 135}, {42, 120, 142}, {34, 168, 132}, {122, 209, 81}, {253, 231, 37}}};
  const double at = std::clamp(part, 0.0, 1.0) * (kStops.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(at), kStops.size() - 2);
  const double t = at - static_cast<double>(i);
  const auto mix = [t](double a, double b) {
    return static_cast<int>(std::lround(a + t * (b - a)));
  };
  return {mix(kStops[i].red, kStops[i + 1].red), mix(kStops[i].green, kStops[i + 1].green),
          mix(kStops[i].blue, kStops[i + 1].blue)};
}

void draw_scale(const Scene& s, const Colouring& colours) {
  const Sketch& sketch = s.sketch;
  QPainter& p = sketch.painter();
  if (s.options.one_of_several && too_low(s.options, sketch.area().height())) return;
  const QRectF& area = sketch.area();
  p.setFont(desktop::ui_font(12));
  const QFontMetricsF metrics(p.font());
  const qreal width = area.width() < 480.0 ? 104.0 : 150.0, left = area.right() - width - 6.0,
              top = area.top() + 20.0;
  p.setPen(sketch.theme().muted);
  if (colours.value.empty() || !(colours.largest > 0.0)) {
    const QString why = QString::fromStdString(colours.why_none);
    p.drawText(QPointF(area.right() - metrics.horizontalAdvance(why) - 6.0, area.top() + 14.0),
               why);
    return;
  }
  QLinearGradient shade(left, 0.0, left + width, 0.0);
  constexpr int kStops = 12;
  for (int i = 0; i <= kStops; ++i)
    shade.setColorAt(static_cast<double>(i) / kStops,
                     scale_colour(static_cast<double>(i) / kStops));
  p.setBrush(shade);
  p.drawRect(QRectF(left, top, width, 9.0));
  p.drawText(QPointF(left, top - 5.0), QString::fromStdString(colours.title));
  p.drawText(QPointF(left, top + 22.0), "0");
  const QString most =
      QString::fromStdString(desktop::pretty_quantity(colours.largest, colours.unit, 3));
  p.drawText(QPointF(left + width - metrics.horizontalAdvance(most), top + 22.0), most);
}

std::vector<KeyEntry> scale_entries(const Scene& s) {
  if (s.options.colour == ColourBy::None || !s.options.one_of_several) return {};
  const Colouring colours = colouring(s.animation, s.index, s.options.colour);
  if (colours.value.empty() || !(colours.largest > 0.0)) return {};
  const QString title = QString::fromStdString(colours.title);
  return {{scale_colour(0.0), title + ": 0"},
          {scale_colour(1.0),
           title + ": " +
               QString::fromStdString(desktop::pretty_quantity(colours.largest, colours.unit, 3))}};
}

}  // namespace adore::agore
