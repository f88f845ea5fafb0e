#include "agore/picture_key.hpp"
#include "agore/view_layout.hpp"
#include "agore/view_scene.hpp"
#include "desktop/axis_scale.hpp"

#include <QFontMetricsF>
#include <fmt/format.h>

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
    case ColourBy::Pressure:
      return {"contact.pressure", "largest pressure"};
    case ColourBy::Load:
    case ColourBy::None:
      break;
  }
  return {"contact.load", "contact load"};
}

/// `from_lowest`: for temperatures, where zero has no meaning.
void set_scale(ElementColors& out, const RunRange& run, bool from_lowest,
               const ColorScaleChoice& choice) {
  if (!(run.largest > 0.0)) {
    out.why_none = "no colors: all values of the run are 0";
    return;
  }
  const auto words = [&](double value) { return desktop::pretty_quantity(value, out.unit, 3); };
  out.low = from_lowest ? run.lowest : 0.0;
  out.high = run.largest;
  switch (choice.kind) {
    case ColorScaleKind::Usual: {
      // A peak that is no more than twice the usual hides nothing.
      constexpr double kHides = 2.0;
      if (run.largest - out.low > kHides * (run.usual - out.low) && run.usual > out.low)
        out.high = run.usual;
      out.scale = out.high < run.largest ? "top 5 % off scale" : "range of run";
      break;
    }
    case ColorScaleKind::Run:
      out.scale = "range of run";
      break;
    case ColorScaleKind::Moment: {
      double low = std::numeric_limits<double>::infinity(), high = -low;
      for (const double value : out.value)
        if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
      if (from_lowest && std::isfinite(low)) out.low = low;
      out.high = high;
      out.scale = "range of frame";
      if (!(out.high > out.low)) {
        out.why_none = from_lowest ? "no colors: all values are equal in this frame"
                                   : "no colors: all values of this frame are 0";
        return;
      }
      break;
    }
    case ColorScaleKind::Typed:
      out.low = choice.low, out.high = choice.high;
      out.scale = "fixed limits";
      break;
  }
  out.above = run.largest > out.high;
  out.below = run.lowest < out.low;
  const bool usual = choice.kind == ColorScaleKind::Usual;
  if (out.above) out.scale += (usual ? ", max. " : ", max. of run ") + words(run.largest);
  if (out.below) out.scale += ", min. of run " + words(run.lowest);
}

}  // namespace

ElementColors element_colors(const Animation& animation, std::size_t frame, ColourBy by,
                             const ColorScaleChoice& scale) {
  ElementColors out;
  if (by == ColourBy::None) return out;
  const Quantity quantity = quantity_of(by);
  out.title = quantity.title;
  const results::MotionChannel* channel =
      animation.motion ? animation.motion->channel(quantity.channel) : nullptr;
  const auto n = static_cast<std::size_t>(animation.file.elements);
  if (channel == nullptr || channel->width != 2 * n) {
    out.why_none = "no colors: " + (animation.no_contacts.empty()
                                        ? std::string("RESULTS.h5 lacks these values")
                                        : animation.no_contacts);
    return out;
  }
  if (animation.behind(frame)) {
    out.why_none = "no colors: " + animation.sol8_only_note();
    return out;
  }
  if (by == ColourBy::Temperature) {
    // A temperature without rise is an input value.
    const results::MotionChannel* rise = animation.motion->channel("contact.temperature_rise");
    if (rise != nullptr &&
        std::none_of(rise->values.begin(), rise->values.end(), [](double v) { return v > 0.0; })) {
      out.why_none = "no colors: contact temperatures were not computed";
      return out;
    }
  }
  out.unit = channel->unit;
  // Without contact there is no load, slip or heat: these values are not small values of the scale.
  const results::MotionChannel* const load = animation.motion->channel("contact.load");
  const bool loads = load != nullptr && load->width == 2 * n;
  for (std::size_t k = 0; k < n; ++k) {
    double largest = std::numeric_limits<double>::quiet_NaN();
    bool touches = !loads;
    for (const std::size_t at : {2 * k, 2 * k + 1}) {
      if (loads && load->at(frame, at) == 0.0) continue;
      touches = true;
      largest = std::fmax(largest, channel->at(frame, at));
    }
    out.value.push_back(largest);
    out.touches.push_back(touches);
  }
  const auto known = animation.run_ranges.find(quantity.channel);
  set_scale(out, known != animation.run_ranges.end() ? known->second : run_range(*channel),
            by == ColourBy::Temperature, scale);
  return out;
}

QColor ElementColors::of(std::size_t element) const {
  if (!any() || element >= value.size()) return {};
  if (!touches[element]) return no_contact_colour();
  if (!std::isfinite(value[element])) return {};
  return scale_colour((value[element] - low) / (high - low));
}

QColor no_contact_colour() { return {"#dfe3e8"}; }

std::string ElementColors::low_end_label() const {
  return (below ? "≤ " : "") + (low == 0.0 ? "0" : desktop::pretty_quantity(low, unit, 3));
}

std::string ElementColors::high_end_label() const {
  return (above ? "≥ " : "") + desktop::pretty_quantity(high, unit, 3);
}

QColor scale_colour(double part) {
  struct Stop {
    double red, green, blue;
  };
  constexpr std::array<Stop, 5> kStops{
      {{92, 112, 214}, {40, 155, 165}, {75, 187, 120}, {155, 213, 75}, {253, 231, 37}}};
  const double at = std::clamp(part, 0.0, 1.0) * (kStops.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(at), kStops.size() - 2);
  const double t = at - static_cast<double>(i);
  const auto mix = [t](double a, double b) {
    return static_cast<int>(std::lround(a + t * (b - a)));
  };
  return {mix(kStops[i].red, kStops[i + 1].red), mix(kStops[i].green, kStops[i + 1].green),
          mix(kStops[i].blue, kStops[i + 1].blue)};
}

void draw_color_scale(const Scene& s, const ElementColors& colours) {
  const Sketch& sketch = s.sketch;
  QPainter& p = sketch.painter();
  const QRectF& area = sketch.area();
  const QSizeF room = color_scale_size(s.options, area.size());
  if (room.isEmpty()) return;
  const qreal right = area.right() - 6.0, width = room.width() - 6.0, left = right - width,
              top = area.top() + 20.0;
  p.setPen(sketch.theme().muted);
  const auto write = [&](const QString& text, qreal y) {
    // In smaller letters if a line of one word, or of a number, is longer than the bar.
    for (const int letters : {12, 11, 10}) {
      p.setFont(desktop::ui_font(letters));
      if (QFontMetricsF(p.font()).horizontalAdvance(text) <= width) break;
    }
    p.drawText(QPointF(right - QFontMetricsF(p.font()).horizontalAdvance(text), y), text);
  };
  const QFontMetricsF metrics(desktop::ui_font(12));
  if (!colours.any()) {
    qreal y = area.top() + 14.0;
    for (const QString& line :
         wrapped_lines(QString::fromStdString(colours.why_none), width, metrics)) {
      write(line, y);
      y += 14.0;
    }
    return;
  }
  QLinearGradient shade(left, 0.0, left + width, 0.0);
  constexpr int kStops = 12;
  for (int i = 0; i <= kStops; ++i)
    shade.setColorAt(static_cast<double>(i) / kStops,
                     scale_colour(static_cast<double>(i) / kStops));
  p.setBrush(shade);
  p.drawRect(QRectF(left, top, width, 9.0));
  const QString least = QString::fromStdString(colours.low_end_label()),
                most = QString::fromStdString(colours.high_end_label());
  for (const int letters : {12, 11, 10}) {
    p.setFont(desktop::ui_font(letters));
    if (QFontMetricsF(p.font()).horizontalAdvance(least + "  " + most) <= width) break;
  }
  p.drawText(QPointF(left, top + 22.0), least);
  p.drawText(QPointF(right - QFontMetricsF(p.font()).horizontalAdvance(most), top + 22.0), most);
  p.setFont(desktop::ui_font(12));
  p.drawText(QPointF(left, top - 5.0), QString::fromStdString(colours.title));
  // Broken behind its commas.
  QStringList lines{QString::fromStdString(colours.scale)};
  if (metrics.horizontalAdvance(lines.front()) > width) {
    lines = lines.front().split(", ");
    for (qsizetype i = 0; i + 1 < lines.size(); ++i) lines[i] += ",";
  }
  for (qsizetype i = 0; i < lines.size(); ++i)
    write(lines[i], top + 37.0 + 14.0 * static_cast<double>(i));
}

std::vector<PictureLegendEntry> scale_entries(const Scene& s) {
  if (s.options.colour == ColourBy::None) return {};
  const ElementColors colours =
      element_colors(s.animation, s.index, s.options.colour, s.options.scale);
  if (!colours.any()) {
    if (!color_scale_size(s.options, s.sketch.area().size()).isEmpty()) return {};  // said there
    return {{s.sketch.theme().muted, QString::fromStdString(colours.why_none), LegendMark::None}};
  }
  std::vector<PictureLegendEntry> out;
  if (is_too_low(s.options, s.sketch.area().height()) && s.options.one_of_several)
    out.push_back({scale_colour(0.5),
                   QString::fromStdString(fmt::format("{} {} to {} ({})", colours.title,
                                                      colours.low_end_label(),
                                                      colours.high_end_label(), colours.scale)),
                   LegendMark::Scale});
  // Omitted for runs without such elements.
  if (s.animation.some_free)
    out.push_back(optional_entry(
        no_contact_colour(),
        std::any_of(colours.touches.begin(), colours.touches.end(), [](bool on) { return !on; }),
        "no contact", "all in contact", LegendMark::Disc));
  return out;
}

}  // namespace adore::agore
