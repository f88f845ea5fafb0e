#include "desktop/beyond_log.hpp"

#include "desktop/axis_scale.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace adore::desktop {
namespace {

struct Share {
  std::string name;
  double part = 0.0;  ///< of its values
};

std::string percent(double part) {
  constexpr double kFew = 0.001, kNearlyAll = 0.99;
  if (part < kFew) return "less than 0.1 %";
  return part > kNearlyAll ? "over 99 %" : pretty_number(100.0 * part, 2) + " %";
}

std::string name_of(const ChartPage& page, const ChartPanel& panel, const ChartCurve& curve) {
  if (curve.name.empty()) return fmt::format("\"{}\"", panel.title);
  return page.panels.size() > 1 ? fmt::format("\"{}\" in \"{}\"", curve.name, panel.title)
                                : fmt::format("\"{}\"", curve.name);
}

/// The curves with some values that cannot be drawn.
std::vector<Share> shares_of(const ChartPage& page) {
  std::vector<Share> out;
  for (const ChartPanel& panel : page.panels) {
    if (!panel.log) continue;
    for (const ChartCurve& curve : panel.curves) {
      if (curve.hidden) continue;
      std::size_t all = 0, below = 0;
      for (const double value : curve.y) {
        if (!is_drawable(value)) continue;
        ++all;
        below += value > 0.0 ? 0 : 1;
      }
      if (below > 0 && below < all)
        out.push_back(
            {name_of(page, panel, curve), static_cast<double>(below) / static_cast<double>(all)});
    }
  }
  return out;
}

}  // namespace

std::string log_axis_note(const ChartPage& page) {
  constexpr std::size_t kNamed = 3;
  std::string out;
  const std::vector<Share> shares = shares_of(page);
  if (!shares.empty()) {
    out = "Not shown on the logarithmic axis (values at or below 0): ";
    const auto most =
        std::max_element(shares.begin(), shares.end(),
                         [](const Share& a, const Share& b) { return a.part < b.part; });
    for (std::size_t i = 0; shares.size() <= kNamed && i < shares.size(); ++i)
      out += fmt::format("{}{} of {}", i > 0 ? ", " : "", percent(shares[i].part), shares[i].name);
    if (shares.size() > kNamed)
      out += fmt::format("parts of {} curves; largest part: {} ({})", shares.size(), most->name,
                         percent(most->part));
    out += ".";
  }
  if (page.log_x && !page.equal_axes) {
    const auto before =
        std::count_if(page.x.begin(), page.x.end(), [](double x) { return x <= 0.0; });
    const std::string gap = out.empty() ? "" : " ";
    if (before == 1)
      out += fmt::format("{}The value at {} is not drawn: the abscissa is logarithmic.", gap,
                         pretty_quantity(*std::find_if(page.x.begin(), page.x.end(),
                                                       [](double x) { return x <= 0.0; }),
                                         page.x_unit, 3));
    else if (before > 1)
      out +=
          fmt::format("{}{} of {} points at or below 0 are not drawn: the abscissa is logarithmic.",
                      gap, before, page.x.size());
  }
  return out;
}

std::vector<double> replace_nonpositive(const std::vector<double>& values, double below) {
  std::vector<double> out = values;
  for (double& value : out)
    if (is_drawable(value) && !(value > 0.0)) value = below;
  return out;
}

}  // namespace adore::desktop
