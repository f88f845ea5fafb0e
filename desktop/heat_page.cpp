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

/// Places of the nodes: radius upward, medium to the right. Nodes of the middle column that the
/// table does not have leave no gap.
struct Place {
  const char* column;  ///< of the table
  double x, y;
  double text;  ///< side of the label: -1 left, 1 right
};
constexpr Place kPlaces[] = {{"ambient", 0.0, 11.0, -1.0},
                             {"housing outside", 0.0, 10.0, -1.0},
                             {"housing at the outer race", 0.0, 9.0, -1.0},
                             {"outer race at the housing", 0.0, 8.0, -1.0},
                             {"outer raceway", 0.0, 7.0, -1.0},
                             {"film of the outer race", 0.0, 6.0, -1.0},
                             {"rolling elements", 0.0, 5.0, -1.0},
                             {"film of the inner race", 0.0, 4.0, -1.0},
                             {"inner raceway", 0.0, 3.0, -1.0},
                             {"inner race at the shaft", 0.0, 2.0, -1.0},
                             {"shaft at the inner race", 0.0, 1.0, -1.0},
                             {"shaft inside", 0.0, 0.0, -1.0},
                             {"film of the pockets", 4.2, 8.2, 1.0},
                             {"cage", 6.6, 6.6, 1.0},
                             {"coolant inlet", 5.2, 4.2, 1.0},
                             {"coolant mean", 5.2, 3.0, 1.0},
                             {"medium in the bearing", 5.2, 3.0, 1.0},
                             {"coolant exit", 5.2, 1.8, 1.0}};

/// The nodes of the table, without gaps in the middle column.
std::vector<Place> places_in(const StaticTable& network) {
  std::vector<Place> out;
  for (const Place& place : kPlaces)
    if (const StaticColumn* column = network.find(place.column);
        column != nullptr && !column->values.empty())
      out.push_back(place);
  double y = 0.0;
  for (auto place = out.rbegin(); place != out.rend(); ++place)
    if (place->x == 0.0) place->y = y++;
  return out;
}

const Place* place_of(const std::vector<Place>& places, const std::string& name) {
  for (const Place& place : places)
    if (name == place.column) return &place;
  return nullptr;
}

/// "A to B" of the heat from one placed node to another.
std::optional<std::pair<const Place*, const Place*>> link_of(const std::vector<Place>& places,
                                                             const std::string& column) {
  for (std::size_t at = column.find(" to "); at != std::string::npos;
       at = column.find(" to ", at + 1)) {
    constexpr std::size_t kSeparator = 4;
    const Place *from = place_of(places, column.substr(0, at)),
                *to = place_of(places, column.substr(at + kSeparator));
    if (from != nullptr && to != nullptr) return std::pair{from, to};
  }
  return std::nullopt;
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
      "Schematic: the radius increases upward; coolant or medium is at the right. Arrows show the "
      "direction of the heat flow.";
  page.equal_axes = true;
  page.closed_outline = true;
  page.fitted = true;
  page.schematic = true;
  ChartPanel panel;
  ChartCurve nodes{"nodes", {}, {}}, flows{"heat flow", {}, {}}, links{"connection", {}, {}, true};
  flows.heavy = true;
  const std::vector<Place> places = places_in(*network);
  for (const Place& place : places) {
    const StaticColumn* temperature = value(place.column);
    const double x = place.x, y = place.y;
    line(nodes, {{x - kHalf, y - kHalf},
                 {x + kHalf, y - kHalf},
                 {x + kHalf, y + kHalf},
                 {x - kHalf, y + kHalf},
                 {x - kHalf, y - kHalf}});
    page.labels.push_back({x + place.text * 2.0 * kHalf, y, place.text, 0.0,
                           fmt::format("{} {}", place.column, shown(*temperature, all))});
  }
  for (const StaticColumn& heat : network->columns) {
    const auto link = link_of(places, heat.name);
    if (!link || heat.values.empty()) continue;
    const auto& [a, b] = *link;
    const auto ends = between(*a, *b);
    if (heat.values.front() == 0.0)
      line(links, {ends[0], ends[1]});
    else if (heat.values.front() > 0.0)
      arrow(flows, ends[0], ends[1]);
    else
      arrow(flows, ends[1], ends[0]);
    page.labels.push_back({0.5 * (a->x + b->x) + kHalf, 0.5 * (a->y + b->y) + 2.0 * kHalf, 1.0, 0.0,
                           shown(heat, all, std::abs(heat.values.front()))});
  }
  double y = -0.8;
  for (const auto& [column, label] :
       {std::pair{"made at the outer race", "heat generated at the outer race"},
        {"made at the inner race", "heat generated at the inner race"},
        {"made in the pockets", "heat generated in the pockets"},
        {"made by churning", "heat generated by churning"},
        {"mean of the outer race", "mean temperature of the outer race"},
        {"mean of the inner race", "mean temperature of the inner race"}})
    if (const StaticColumn* heat = value(column); heat != nullptr && heat->values.front() != 0.0) {
      page.labels.push_back({0.0, y, 1.0, 0.0, fmt::format("{}: {}", label, shown(*heat, all))});
      y -= 0.5;
    }
  for (ChartCurve* curve : {&nodes, &flows, &links})
    if (!curve->x.empty()) panel.curves.push_back(std::move(*curve));
  page.panels.push_back(std::move(panel));
  return page;
}

}  // namespace adore::desktop
