#include "desktop/chart_scene_parts.hpp"

#include <algorithm>
#include <cmath>

/// Values of the chart scene under the pointer.
namespace adore::desktop {

namespace {

/// "outer race 400 N", "land 1: 400 N".
QString told(const std::string& name, const QString& value) {
  const bool number = !name.empty() && name.back() >= '0' && name.back() <= '9';
  return text_of(name) + (number ? ": " : " ") + value;
}

}  // namespace

namespace {

constexpr int kDigits = 5;

/// So many more digits as a range has fewer of than its largest number.
int digits_for(double low, double high) {
  constexpr int kMost = 12;
  const double largest = std::max(std::abs(low), std::abs(high));
  if (!(high > low) || !std::isfinite(largest)) return kDigits;
  const int more = static_cast<int>(std::floor(std::log10(largest / (high - low))));
  return std::clamp(kDigits + more, kDigits, kMost);
}

}  // namespace

void ChartScene::computeCurveDigits() {
  digits_.clear();
  for (const ChartPanel& panel : page_.panels) {
    auto& of_panel = digits_.emplace_back();
    for (const ChartCurve& curve : panel.curves) {
      Extent extent;
      for (const double v : curve.y) extent.include(v);
      of_panel.push_back(extent.empty() ? kDigits : digits_for(extent.low, extent.high));
    }
  }
}

int ChartScene::digitsOf(std::size_t panel, std::size_t curve) const {
  // A panel without curves has positions under the pointer, too.
  if (panel >= digits_.size() || curve >= digits_[panel].size()) return kDigits;
  int digits = digits_[panel][curve];
  if (panel < y_axes_.size() && !y_axes_[panel].log) {
    const AxisScale& axis = y_axes_[panel];
    digits = std::max(digits, digits_for(axis.value(axis.min), axis.value(axis.max)));
  }
  return digits;
}

QString ChartScene::bandText(std::size_t panel, std::size_t index, std::size_t place) const {
  const ChartPanel& of = page_.panels[panel];
  const ChartCurve& curve = of.curves[index];
  if (place >= curve.low.size() || place >= curve.high.size()) return {};
  const auto text = [&](double v) {
    return text_of(pretty_quantity(v, of.unit, digitsOf(panel, index)));
  };
  const QString low = text(curve.low[place]), high = text(curve.high[place]);
  const bool known = std::isfinite(curve.low[place]) && std::isfinite(curve.high[place]);
  return known && low != high ? tr(" (%1 to %2)").arg(low, high) : QString();
}

QStringList ChartScene::readoutParts(QPointF position) const {
  if (const std::vector<long> runs = runsAt(position); !runs.empty())
    return {runs.size() == 1
                ? tr("run %1. Click to open.").arg(runs.front())
                : tr("%1 runs (first: %2). Click to open.").arg(runs.size()).arg(runs.front())};
  if (isPlane()) return planeReadout(position);
  if (page_.equal_axes || page_.x.empty() || !panelAt(position)) return {};
  return storedPointReadout(mapRowAt(position).value_or(0),
                            nearest_index(page_.x, abscissaAt(position.x())));
}

QStringList ChartScene::storedPointReadout(std::size_t of_orbit, std::size_t i) const {
  if (isPlane()) {
    const ChartCurve& curve = page_.panels.front().curves.at(of_orbit);
    const QString head = i < page_.along.size()
                             ? text_of(pretty_quantity(page_.along[i], page_.along_unit, 5))
                             : text_of(curve.name);
    return {head + ":   " + planeValuesText(curve.x.at(i), curve.y.at(i))};
  }
  const QString place = text_of(pretty_quantity(page_.x[i], page_.x_unit, 5)) + ":";
  QStringList parts;
  for (std::size_t p = 0; p < page_.panels.size(); ++p) {
    const ChartPanel& panel = page_.panels[p];
    if (panel.rows) {
      const std::size_t row = std::min(of_orbit, panel.rows->at.size() - 1);
      parts << "   " +
                   told(panel.title,
                        text_of(pretty_quantity(panel.rows->at[row], panel.rows->unit, 5)) + ": " +
                            text_of(pretty_quantity(panel.curves[row].y[i], panel.unit,
                                                    digitsOf(p, row))));
      continue;
    }
    bool first = true;
    for (std::size_t c = 0; c < panel.curves.size(); ++c) {
      const ChartCurve& curve = panel.curves[c];
      if (i >= curve.y.size() || curve.hidden) continue;
      QString value = text_of(pretty_quantity(curve.y[i], panel.unit, digitsOf(p, c)));
      value += bandText(p, c, i);
      const bool whole = !curve.brief.empty();
      QString part = whole                ? text_of(curve.brief) + ": " + value
                     : curve.name.empty() ? value
                                          : told(curve.name, value);
      const bool titled = page_.panels.size() > 1 || panel.curves.front().name.empty();
      const bool named = !panel.curves.front().name.empty();
      if (first && titled && !whole)
        part = named ? text_of(panel.title) + " " + part : told(panel.title, part);
      parts << (first ? "   " : ", ") + part;
      first = false;
    }
  }
  if (parts.isEmpty()) return {place};
  parts.front().prepend(place);
  return parts;
}

QString ChartScene::readout(QPointF position) const { return readoutParts(position).join(""); }

}  // namespace adore::desktop
