#include "desktop/static_pages.hpp"

#include "base/counted.hpp"
#include "desktop/axis_scale.hpp"
#include "desktop/heat_page.hpp"
#include "results/key_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace adore::desktop {
namespace {

using results::StaticColumn;
using results::StaticTable;
using results::StaticTables;

struct CurveChoice {
  std::string column, name;
  bool dashed = false;
};

std::vector<double> shown(const StaticColumn& column, results::UnitSystem units) {
  std::vector<double> out;
  for (const double value : column.values)
    out.push_back(results::from_si(value, *column.unit, units));
  return out;
}

/// One panel with the columns that the table has; none if it has none of them.
std::optional<ChartPanel> panel(const StaticTables& all, const StaticTable& table,
                                std::string title, const std::vector<CurveChoice>& curves) {
  ChartPanel out;
  out.title = std::move(title);
  for (const CurveChoice& choice : curves) {
    const StaticColumn* column = table.find(choice.column);
    if (column == nullptr) continue;
    const std::string_view unit = results::unit_name(*column->unit, all.units);
    out.unit = unit == "-" ? "" : unit;
    out.curves.push_back({choice.name, shown(*column, all.units), {}, choice.dashed});
  }
  if (out.curves.empty()) return std::nullopt;
  return out;
}

void add(ChartPage& page, std::optional<ChartPanel> panel) {
  if (panel) page.panels.push_back(std::move(*panel));
}

std::vector<CurveChoice> both_races(const std::string& quantity) {
  return {{"outer " + quantity, "outer race"}, {"inner " + quantity, "inner race"}};
}

void set_abscissa(ChartPage& page, const StaticTables& all, const StaticTable& table,
                  const std::string& column, const std::string& title) {
  page.x_title = title;
  if (const StaticColumn* x = table.find(column)) {
    page.x_unit = results::unit_name(*x->unit, all.units);
    page.x = shown(*x, all.units);
  }
}

/// Rows in the order of their azimuth in (-180, 180], so that the load zone of a radial load stays
/// in one piece.
StaticTable by_azimuth(StaticTable table) {
  StaticColumn* azimuth = nullptr;
  for (StaticColumn& column : table.columns)
    if (column.name == "azimuth") azimuth = &column;
  if (azimuth == nullptr) return table;
  const double half_turn = std::acos(-1.0);
  for (double& angle : azimuth->values) {
    angle = std::remainder(angle, 2.0 * half_turn);
    if (angle < -half_turn * (1.0 - 1e-12)) angle = half_turn;
  }
  std::vector<std::size_t> order(azimuth->values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return azimuth->values[a] < azimuth->values[b];
  });
  for (StaticColumn& column : table.columns) {
    std::vector<double> sorted;
    for (const std::size_t row : order)
      sorted.push_back(row < column.values.size() ? column.values[row]
                                                  : std::numeric_limits<double>::quiet_NaN());
    column.values = std::move(sorted);
  }
  return table;
}

/// A sorted table whose element at 180 degrees is repeated at -180, so that the axis is a full
/// circle.
StaticTable whole_turn(StaticTable table) {
  const StaticColumn* azimuth = table.find("azimuth");
  const double half_turn = std::acos(-1.0);
  if (azimuth == nullptr || azimuth->values.empty() ||
      std::abs(azimuth->values.back() - half_turn) > 1e-9)
    return table;
  for (StaticColumn& column : table.columns) {
    const double last = column.name == "azimuth" ? -half_turn : column.values.back();
    column.values.insert(column.values.begin(), last);
  }
  return table;
}

/// Loads as marks at that distance from the bearing's axis, seen along +x: +z up, azimuth turning
/// from z toward -y. Marks are not joined: between elements nothing is loaded.
ChartPage load_rose(const StaticTables& all, const StaticTable& elements) {
  ChartPage page;
  page.title = "Load around the bearing";
  page.note =
      "Each mark is an element. Its distance from the center is the contact load (0 at the "
      "center). Azimuth 0 is up, y is to the right.";
  page.equal_axes = true;
  page.closed_outline = true;
  page.points = true;
  page.x_title = "y direction";
  const StaticColumn* azimuth = elements.find("azimuth");
  ChartPanel rose;
  rose.title = "z direction";
  for (const auto& [column, name, dashed] : both_races("load")) {
    const StaticColumn* load = elements.find(column);
    if (load == nullptr || azimuth == nullptr || load->values.empty()) continue;
    rose.unit = results::unit_name(*load->unit, all.units);
    ChartCurve curve{name, {}, {}, dashed};
    const std::vector<double> size = shown(*load, all.units);
    for (std::size_t i = 0; i < size.size(); ++i) {
      const double q = std::isfinite(size[i]) ? size[i] : 0.0;
      curve.x.push_back(-q * std::sin(azimuth->values[i]));
      curve.y.push_back(q * std::cos(azimuth->values[i]));
    }
    rose.curves.push_back(std::move(curve));
  }
  page.panels.push_back(std::move(rose));
  return page;
}

ChartPage element_page(const StaticTables& all, const StaticTable& elements) {
  ChartPage page;
  page.title = "Contact loads, angles and pressures";
  page.points = true;
  set_abscissa(page, all, elements, "azimuth", "Azimuth");
  add(page, panel(all, elements, "Contact load", both_races("load")));
  add(page, panel(all, elements, "Contact angle", both_races("contact angle")));
  add(page, panel(all, elements, "Largest pressure", both_races("pressure")));
  return page;
}

/// Position of the ellipses of all elements on their grooves.
std::optional<ChartPage> ellipse_page(const StaticTables& all, const StaticTable& elements) {
  ChartPage page;
  page.points = true;
  page.title = "Contact ellipses around the bearing";
  page.note =
      "Angles are measured from the groove bottom. The ellipse should be within the groove.";
  set_abscissa(page, all, elements, "azimuth", "Azimuth");
  for (const std::string race : {"outer ", "inner "})
    add(page, panel(all, elements, race == "outer " ? "Outer groove" : "Inner groove",
                    {{race + "contact angle", "middle"},
                     {race + "ellipse low", "lower edge"},
                     {race + "ellipse high", "upper edge"},
                     {race + "groove end", "end of the groove"}}));
  if (elements.find("outer ellipse low") == nullptr || page.panels.empty()) return std::nullopt;
  return page;
}

/// The outline of a table of the section; empty if the file has none.
ChartCurve outline(const StaticTables& all, const std::string& table, std::string name) {
  ChartCurve out{std::move(name), {}, {}};
  const StaticTable* points = all.find(table);
  if (points == nullptr) return out;
  const StaticColumn *x = points->find("x"), *r = points->find("r");
  if (x == nullptr || r == nullptr) return out;
  out.x = shown(*x, all.units);
  out.y = shown(*r, all.units);
  return out;
}

std::pair<double, double> range(const std::vector<double>& values) {
  if (values.empty()) return {0.0, 0.0};
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return {*low, *high};
}

double only(const StaticTable& table, const std::string& column) {
  const StaticColumn* found = table.find(column);
  return found == nullptr || found->values.empty() ? std::numeric_limits<double>::quiet_NaN()
                                                   : found->values.front();
}

/// The cut through the most loaded element, to scale: both raceways, the element, and its contacts.
std::optional<ChartPage> cut_page(const StaticTables& all) {
  const StaticTable* cut = all.find("cut");
  if (cut == nullptr) return std::nullopt;
  const bool ball = all.bearing == "ball";
  const auto quantity = [&](double value, const results::UnitPair& unit, int digits) {
    return pretty_quantity(results::from_si(value, unit, all.units),
                           results::unit_name(unit, all.units), digits);
  };
  ChartPage page;
  page.title = "Contact ellipses and groove edges";
  page.equal_axes = page.closed_outline = page.fitted = true;
  page.x_title = "Along the bearing axis";
  ChartPanel panel;
  panel.title = "Distance from the axis";
  panel.unit = results::unit_name(results::unit::kLength, all.units);
  for (const auto& [race, title] :
       {std::pair<std::string, const char*>{"outer", "outer race"}, {"inner", "inner race"}})
    panel.curves.push_back(outline(all, "cut " + race + " race", title));
  panel.curves.push_back(outline(all, "cut element", ball ? "ball" : "roller"));
  const auto [left, right] = range(panel.curves.back().x);
  const double middle = 0.5 * (left + right), half_width = std::max(0.5 * (right - left), 1e-300);
  for (const std::string race : {"outer", "inner"}) {
    ChartCurve contact = outline(all, "cut " + race + " contact", race + " contact");
    contact.heavy = true;
    const double up = race == "outer" ? 1.0 : -1.0;
    for (const char* const side : {"-x", "+x"}) {
      if (contact.x.empty()) continue;
      const bool low = std::string_view(side) == "-x";
      const double margin = only(*cut, fmt::format("{} {} margin", race, side));
      ChartLabel label;
      label.x = low ? contact.x.front() : contact.x.back();
      label.y = low ? contact.y.front() : contact.y.back();
      // Away from the contact, but well outside on a ball.
      const double out = (label.x - middle) / half_width;
      label.towards_x = ball && std::abs(out) > 0.38 ? std::copysign(1.0, out) : low ? -1.0 : 1.0;
      label.towards_y = up;
      label.text = !std::isfinite(margin) ? "groove edge not given"
                   : margin > 0.0
                       ? fmt::format("{} to the edge", quantity(margin, results::unit::kLength, 3))
                   : margin == 0.0 ? "reaches the edge"
                                   : fmt::format("{} beyond the edge",
                                                 quantity(-margin, results::unit::kLength, 3));
      page.labels.push_back(std::move(label));
    }
    panel.curves.push_back(std::move(contact));
  }
  page.panels.push_back(std::move(panel));
  page.note = fmt::format(
      "To scale. Most loaded {}: number {:.0f} at azimuth {}, {} on the outer race and {} on the "
      "inner race. Distances are along the raceway{}.",
      ball ? "ball" : "roller", only(*cut, "element"),
      quantity(only(*cut, "azimuth"), results::unit::kAngle, 4),
      quantity(only(*cut, "outer load"), results::unit::kForce, 4),
      quantity(only(*cut, "inner load"), results::unit::kForce, 4),
      ball ? "" : ", to the end of the raceway or the corner of the roller");
  return page;
}

std::optional<ChartPage> tilt_page(const StaticTables& all, const StaticTable& elements) {
  ChartPage page;
  page.title = "Roller attitude and guidance";
  page.points = true;
  set_abscissa(page, all, elements, "azimuth", "Azimuth");
  add(page, panel(all, elements, "Tilt", {{"tilt", ""}}));
  add(page, panel(all, elements, "Contact moment", both_races("moment")));
  add(page, panel(all, elements, "Flange load",
                  {{"outer flange -x load", "outer, −x"},
                   {"outer flange +x load", "outer, +x"},
                   {"inner flange -x load", "inner, −x"},
                   {"inner flange +x load", "inner, +x"}}));
  if (page.panels.empty()) return std::nullopt;
  // One flange alone has no legend: the title names it.
  for (ChartPanel& each : page.panels)
    if (each.curves.size() == 1 && !each.curves[0].name.empty())
      each.title += ", " + each.curves[0].name;
  // Millionths of a degree, of a newton or of a newton meter are rounding, not a picture.
  for (ChartPanel& each : page.panels) each.least_span = 1e-6;
  return page;
}

/// Pressure and load along the most loaded roller.
std::optional<ChartPage> slice_page(const StaticTables& all) {
  const StaticTable* slices = all.find("slices");
  if (slices == nullptr) return std::nullopt;
  ChartPage page;
  page.title = "Along the most loaded roller";
  set_abscissa(page, all, *slices, "position", "Position along the roller");
  add(page, panel(all, *slices, "Pressure", both_races("pressure")));
  add(page, panel(all, *slices, "Load per length", both_races("load per length")));
  return page;
}

std::vector<ChartPage> stiffness_pages(const StaticTables& all) {
  const StaticTable* table = all.find("stiffness over speed");
  if (table == nullptr) return {};
  const auto page = [&](std::string title) {
    ChartPage out;
    out.title = std::move(title);
    const StaticColumn* inner = table->find("inner speed");
    const bool inner_turns =
        inner != nullptr && !inner->values.empty() && inner->values.front() != inner->values.back();
    set_abscissa(out, all, *table, inner_turns ? "inner speed" : "outer speed",
                 inner_turns ? "Inner race speed" : "Outer race speed");
    out.points = true;  // one solution each; lines only join them
    return out;
  };
  const auto entry = [&](const std::string& name) {
    return std::vector<CurveChoice>{{name, "exact"},
                                    {name + " by difference", "by difference", true}};
  };
  std::vector<ChartPage> out;
  out.push_back(page("Stiffness over speed: translation"));
  for (const char* const k : {"Fx/x", "Fy/y", "Fz/z"})
    add(out.back(), panel(all, *table, k, entry(k)));
  out.push_back(page("Stiffness over speed: rotation and coupling"));
  for (const char* const k : {"My/rot y", "Mz/rot z", "Fx/z"})
    add(out.back(), panel(all, *table, k, entry(k)));
  out.push_back(page("Contacts over speed"));
  add(out.back(), panel(all, *table, "Largest contact load", {{"largest load", ""}}));
  add(out.back(),
      panel(all, *table, "Displacement",
            {{"displacement x", "x"}, {"displacement y", "y"}, {"displacement z", "z"}}));
  add(out.back(), panel(all, *table, "Diametral clearance", {{"clearance", ""}}));
  std::erase_if(out, [](const ChartPage& p) { return p.panels.empty(); });
  return out;
}

/// Runs that specified motion but made no step have loads at rest and no results of a motion.
std::string without_steps(const results::SweepTable& sweep) {
  for (const results::SweepColumn& column : sweep.columns) {
    if (column.label != results::find_key_result("time_s").label) continue;
    const auto still = std::count(column.values.begin(), column.values.end(), 0.0);
    if (still == 0) return {};
    return fmt::format(
        "{} of {} had no motion (maxStps = 0): their loads are static. Mean values, speed ratios "
        "and heat were not computed.",
        still, counted(column.values.size(), "run"));
  }
  return {};
}

}  // namespace

std::vector<ChartPage> static_pages(const StaticTables& all) {
  std::vector<ChartPage> pages;
  if (const StaticTable* table = all.find("elements")) {
    const StaticTable sorted = by_azimuth(*table);
    const StaticTable elements = whole_turn(sorted);
    pages.push_back(load_rose(all, sorted));
    pages.push_back(element_page(all, elements));
    if (auto page = cut_page(all)) pages.push_back(std::move(*page));
    if (auto page = ellipse_page(all, elements)) pages.push_back(std::move(*page));
    if (auto page = tilt_page(all, elements)) pages.push_back(std::move(*page));
  }
  if (auto page = slice_page(all)) pages.push_back(std::move(*page));
  if (auto page = heat_page(all)) pages.push_back(std::move(*page));
  for (ChartPage& page : stiffness_pages(all)) pages.push_back(std::move(page));
  const char* const of = all.find("elements") != nullptr ? "quasi-static" : "last thermal step";
  for (ChartPage& page : pages)
    page.subtitle = fmt::format("{}   ·   {} bearing, {}",
                                all.run_id.empty() ? "(no run name)" : all.run_id, all.bearing, of);
  return pages;
}

std::vector<ChartPage> sweep_pages(const results::SweepTable& sweep) {
  constexpr std::size_t kPanelsPerPage = 3;
  std::vector<ChartPanel> panels;
  for (const results::SweepColumn& column : sweep.columns) {
    const auto same = std::find_if(panels.begin(), panels.end(), [&](const ChartPanel& p) {
      return !column.part.empty() && p.title == column.label && p.unit == column.unit;
    });
    if (same != panels.end())
      same->curves.push_back({column.part, column.values, {}});
    else
      panels.push_back({column.label, column.unit, {{column.part, column.values, {}}}});
  }
  std::vector<ChartPage> pages;
  const std::string still = without_steps(sweep);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    if (i % kPanelsPerPage == 0) {
      ChartPage& page = pages.emplace_back();
      page.subtitle =
          fmt::format("{}{}", counted(sweep.values.size(), "run"),
                      sweep.failed > 0 ? fmt::format(", {} without a result", sweep.failed) : "");
      page.x_title = sweep.variable;
      page.x_unit = sweep.unit;
      page.x = sweep.values;
      page.points = true;  // computed values; lines only join them
      std::string names;
      // Shifts and tilts are both "Displacement", with another unit.
      for (std::size_t k = i; k < std::min(i + kPanelsPerPage, panels.size()); ++k)
        if (k == i || panels[k].title != panels[k - 1].title)
          names += (names.empty() ? "" : ", ") + panels[k].title;
      page.title = names + " over " + sweep.variable;
      page.note = still;
    }
    if (panels[i].title.starts_with("Life"))
      pages.back().note =
          (still.empty() ? "" : still + " ") +
          "The original life model has published constants; the other models are calibrated to "
          "it. STLE life factors are not verified; Tallian-type factors are derived.";
    pages.back().panels.push_back(std::move(panels[i]));
  }
  return pages;
}

}  // namespace adore::desktop
