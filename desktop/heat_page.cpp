#include "desktop/heat_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace adore::desktop {
namespace {

using results::StaticColumn;
using results::StaticTable;
using results::StaticTables;

constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
constexpr double kHalf = 0.12;  ///< half the side of a node's square

/// Where the nodes stand: radius upwards, coolant to the right.
struct Place {
  const char* column;  ///< of the table
  double x, y;
  double text;  ///< side of the label: -1 left, 1 right
};
constexpr Place kPlaces[] = {
    {"housing outside", 0.0, 6.0, -1.0}, {"outer race at the housing", 0.0, 5.0, -1.0},
    {"outer raceway", 0.0, 4.0, -1.0},   {"rolling elements", 0.0, 3.0, -1.0},
    {"inner raceway", 0.0, 2.0, -1.0},   {"inner race at the shaft", 0.0, 1.0, -1.0},
    {"shaft inside", 0.0, 0.0, -1.0},    {"cage", 2.6, 4.2, -1.0},
    {"coolant inlet", 5.2, 4.2, 1.0},    {"coolant mean", 5.2, 3.0, 1.0},
    {"coolant exit", 5.2, 1.8, 1.0}};

struct Link {
  const char *from, *to;
  const char* heat;  ///< column; null: nothing is said of it
};
constexpr Link kLinks[] = {
    {"outer raceway", "outer race at the housing", "outer raceway to housing"},
    {"outer race at the housing", "housing outside", nullptr},
    {"inner raceway", "inner race at the shaft", "inner raceway to shaft"},
    {"inner race at the shaft", "shaft inside", nullptr},
    {"rolling elements", "outer raceway", nullptr},
    {"rolling elements", "inner raceway", nullptr},
    {"rolling elements", "coolant mean", "rolling elements to coolant"},
    {"cage", "coolant mean", "cage to coolant"},
    {"coolant inlet", "coolant mean", nullptr},
    {"coolant mean", "coolant exit", nullptr}};

const Place* place_of(const std::string& name) {
  for (const Place& place : kPlaces)
    if (name == place.column) return &place;
  return nullptr;
}

std::string shown(const StaticColumn& column, const StaticTables& all, double value) {
  return fmt::format("{:.4g} {}", results::from_si(value, *column.unit, all.units),
                     results::unit_name(*column.unit, all.units));
}
std::string shown(const StaticColumn& column, const StaticTables& all) {
  return shown(column, all, column.values.front());
}

void line(ChartCurve& curve, const std::vector<std::pair<double, double>>& points) {
  for (const auto& [x, y] : points) {
    curve.x.push_back(x);
    curve.y.push_back(y);
  }
  curve.x.push_back(kGap);
  curve.y.push_back(kGap);
}

/// From the edge of one node's square to that of another's.
std::array<std::pair<double, double>, 2> between(const Place& from, const Place& to) {
  const double dx = to.x - from.x, dy = to.y - from.y;
  const double share = kHalf / std::max(std::abs(dx), std::abs(dy));
  return {{{from.x + share * dx, from.y + share * dy}, {to.x - share * dx, to.y - share * dy}}};
}

/// A line with a head at its end.
void arrow(ChartCurve& curve, const std::pair<double, double>& from,
           const std::pair<double, double>& to) {
  constexpr double kLength = 0.2, kWidth = 0.08;
  const double dx = to.first - from.first, dy = to.second - from.second;
  const double x = dx / std::hypot(dx, dy), y = dy / std::hypot(dx, dy);
  const std::pair<double, double> foot{to.first - kLength * x, to.second - kLength * y};
  line(curve, {from, to});
  line(curve, {{foot.first - kWidth * y, foot.second + kWidth * x},
               to,
               {foot.first + kWidth * y, foot.second - kWidth * x}});
}

}  // namespace

std::optional<ChartPage> heat_page(const StaticTables& all) {
  const StaticTable* network = all.find("thermal network");
  if (network == nullptr) return std::nullopt;
  const auto value = [&](const char* name) -> const StaticColumn* {
    const StaticColumn* column = name == nullptr ? nullptr : network->find(name);
    return column == nullptr || column->values.empty() ? nullptr : column;
  };
  ChartPage page;
  page.title = "Thermal network";
  page.note =
      "Schematic: radius upwards, coolant to the right; arrows point where heat flows. Raceways "
      "have the temperature of the rolling elements; half of the heat of a contact goes into "
      "either "
      "body.";
  page.equal_axes = true;
  page.closed_outline = true;
  page.fitted = true;
  page.schematic = true;
  ChartPanel panel;
  ChartCurve nodes{"nodes", {}, {}}, flows{"heat flow", {}, {}}, links{"connection", {}, {}, true};
  flows.heavy = true;
  for (const Place& place : kPlaces) {
    const StaticColumn* temperature = value(place.column);
    if (temperature == nullptr) continue;
    const double x = place.x, y = place.y;
    line(nodes, {{x - kHalf, y - kHalf},
                 {x + kHalf, y - kHalf},
                 {x + kHalf, y + kHalf},
                 {x - kHalf, y + kHalf},
                 {x - kHalf, y - kHalf}});
    page.labels.push_back({x + place.text * 2.0 * kHalf, y, place.text, 0.0,
                           fmt::format("{} {}", place.column, shown(*temperature, all))});
  }
  for (const Link& link : kLinks) {
    if (value(link.from) == nullptr || value(link.to) == nullptr) continue;
    const Place *a = place_of(link.from), *b = place_of(link.to);
    const StaticColumn* heat = value(link.heat);
    const auto ends = between(*a, *b);
    if (heat == nullptr || heat->values.front() == 0.0)
      line(links, {ends[0], ends[1]});
    else if (heat->values.front() > 0.0)
      arrow(flows, ends[0], ends[1]);
    else
      arrow(flows, ends[1], ends[0]);
    if (heat != nullptr)
      page.labels.push_back({0.5 * (a->x + b->x) + kHalf, 0.5 * (a->y + b->y) + 2.0 * kHalf, 1.0,
                             0.0, shown(*heat, all, std::abs(heat->values.front()))});
  }
  double y = -0.8;
  for (const char* made :
       {"made at the outer race", "made at the inner race", "made in the pockets",
        "made by churning", "mean of the outer race", "mean of the inner race"})
    if (const StaticColumn* heat = value(made); heat != nullptr && heat->values.front() != 0.0) {
      page.labels.push_back({0.0, y, 1.0, 0.0, fmt::format("{}: {}", made, shown(*heat, all))});
      y -= 0.5;
    }
  for (ChartCurve* curve : {&nodes, &flows, &links})
    if (!curve->x.empty()) panel.curves.push_back(std::move(*curve));
  page.panels.push_back(std::move(panel));
  return page;
}

}  // namespace adore::desktop
