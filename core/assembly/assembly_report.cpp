#include "assembly/assembly_report.hpp"

#include "base/constants.hpp"
#include "base/counted.hpp"
#include "listing/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace adore::assembly {
namespace {

namespace unit = results::unit;
using Json = nlohmann::ordered_json;

double find_result(const results::KeyResults& list, std::string_view id) {
  for (const results::KeyResult& one : list)
    if (one.of.id == id) return one.value;
  return std::numeric_limits<double>::quiet_NaN();
}

double radial(const Vec5& load) { return std::hypot(load(1), load(2)); }

std::string hours(double value) {
  return std::isnan(value)   ? "not computed"
         : std::isinf(value) ? "infinite"
                             : fmt::format("{:.4g} h", value);
}

std::string number_or_dash(double value, double unit) {
  return std::isnan(value) ? "-" : fmt::format("{:.4g}", value / unit);
}

/// "653 N", "1.2 kN"
std::string force_text(double newton) {
  return std::abs(newton) >= 1e4 ? fmt::format("{:.4g} kN", 1e-3 * newton)
                                 : fmt::format("{:.4g} N", newton);
}

char sign_of(int orientation) { return orientation > 0 ? '+' : '-'; }

std::string headline(const AssemblyResult& result) {
  return fmt::format("{}: arrangement {}, {}", result.assembly.name, result.assembly.arrangement,
                     counted(result.rows.size(), "row"));
}

void add_rows(const AssemblyResult& result, std::vector<std::string>& out) {
  out.push_back(fmt::format("{:<4} {:>9} {:>9} {:>10} {:>10} {:>7} {:>13} {:>10} {:>9} {:>10}",
                            "row", "X [mm]", "offs [um]", "axial [N]", "radial [N]", "loaded",
                            "angle o/i [°]", "Qmax [N]", "p [GPa]", "L10r [h]"));
  for (std::size_t k = 0; k < result.rows.size(); ++k) {
    const RowResult& row = result.rows[k];
    const double life = find_result(row.of, "life_iso16281_hours");
    out.push_back(fmt::format(
        "{:<4} {:>9.4g} {:>9.4g} {:>10.4g} {:>10.4g} {:>7} {:>13} {:>10.4g} {:>9.3g} {:>10}",
        fmt::format("{} {}", k + 1, sign_of(row.orientation)), 1e3 * row.position, 1e6 * row.offset,
        axial_load(row.state), radial(row.load), row.state.loaded,
        number_or_dash(row.state.angle[0], kDegree) + " " +
            number_or_dash(row.state.angle[1], kDegree),
        row.state.largest, 1e-9 * row.state.pressure,
        std::isinf(life) ? "infinite" : number_or_dash(life, 1.0)));
  }
}

void add_preload(const AssemblyResult& result, std::vector<std::string>& out) {
  if (!result.opposed) return;
  const Preload& preload = result.assembly.preload;
  out.push_back(fmt::format(
      "preload: {} unmounted, {} in operation; axial offset of the set {:.4g} µm{}{}",
      force_text(result.preload_unmounted), force_text(result.preload_operation),
      1e6 * result.offset, preload.name.empty() ? "" : fmt::format("; class {}", preload.name),
      preload.source.empty() ? "" : fmt::format("; source: {}", preload.source)));
  if (result.unloading.empty())
    out.emplace_back(
        "unloading force: not computed, because no row is loaded without external load");
  for (const Unloading& one : result.unloading)
    out.push_back(
        fmt::format("unloading force at rest: an axial force of {} along x unloads row {} (shaft "
                    "displacement {:.4g} µm)",
                    force_text(one.force), one.row + 1, 1e6 * one.displacement));
}

void add_lives(const AssemblyResult& result, std::vector<std::string>& out) {
  const auto life = [&](const char* id) { return hours(find_result(result.set, id)); };
  out.push_back(fmt::format(
      "life of the set: L10h by ISO 281 {}; L10r by ISO/TS 16281 {}; Lundberg-Palmgren {}",
      life("life_iso281_hours"), life("life_iso16281_hours"), life("life_lp_hours")));
}

/// Matrix with the units of its directions.
std::vector<listing::Report::Row> matrix_rows(const Mat5& matrix) {
  constexpr std::array<const char*, 5> kNames{"force x", "force y", "force z", "about y",
                                              "about z"};
  std::vector<listing::Report::Row> out;
  for (int i = 0; i < 5; ++i) {
    std::vector<double> values;
    for (int j = 0; j < 5; ++j) values.push_back(matrix(i, j));
    out.push_back({kNames[static_cast<std::size_t>(i)], values});
  }
  return out;
}

Json matrix_json(const Mat5& matrix) {
  Json out = Json::array();
  for (int i = 0; i < 5; ++i) {
    Json row = Json::array();
    for (int j = 0; j < 5; ++j) row.push_back(matrix(i, j));
    out.push_back(row);
  }
  return out;
}

Json vector_json(const Vec5& v) { return {v(0), v(1), v(2), v(3), v(4)}; }

Json number_json(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

/// Columns of a table: one entry for each point.
template <class Points, class Value>
std::vector<double> column(const Points& points, const Value& value) {
  std::vector<double> out;
  for (const auto& point : points) out.push_back(value(point));
  return out;
}

results::StaticTable rows_table(const AssemblyResult& result) {
  results::StaticTable out;
  out.name = "rows";
  const auto add = [&](const char* name, const results::UnitPair& unit, const auto& value) {
    out.add(name, unit, column(result.rows, value));
  };
  add("position", unit::kLength, [](const RowResult& r) { return r.position; });
  add("offset", unit::kLength, [](const RowResult& r) { return r.offset; });
  add("axial load", unit::kForce, [](const RowResult& r) { return axial_load(r.state); });
  add("load x", unit::kForce, [](const RowResult& r) { return r.load(0); });
  add("load y", unit::kForce, [](const RowResult& r) { return r.load(1); });
  add("load z", unit::kForce, [](const RowResult& r) { return r.load(2); });
  add("moment y", unit::kMoment, [](const RowResult& r) { return r.load(3); });
  add("moment z", unit::kMoment, [](const RowResult& r) { return r.load(4); });
  add("outer contact angle", unit::kAngle, [](const RowResult& r) { return r.state.angle[0]; });
  add("inner contact angle", unit::kAngle, [](const RowResult& r) { return r.state.angle[1]; });
  add("largest load", unit::kForce, [](const RowResult& r) { return r.state.largest; });
  add("largest pressure", unit::kPressure, [](const RowResult& r) { return r.state.pressure; });
  return out;
}

results::StaticTable curve_table(const AssemblyResult& result) {
  results::StaticTable out;
  out.name = "axial force";
  const auto& points = result.curve;
  out.add("displacement", unit::kLength, column(points, [](auto& p) { return p.displacement; }));
  out.add("axial force", unit::kForce, column(points, [](auto& p) { return p.force; }));
  out.add("axial stiffness", unit::kStiffness, column(points, [](auto& p) { return p.stiffness; }));
  for (std::size_t k = 0; k < result.rows.size() && !points.empty(); ++k)
    out.add(fmt::format("axial load of row {}", k + 1), unit::kForce,
            column(points, [k](auto& p) { return p.row_load[k]; }));
  return out;
}

results::StaticTable preload_table(const AssemblyResult& result) {
  results::StaticTable out;
  out.name = "preload";
  const auto& points = result.preload;
  out.add("offset", unit::kLength, column(points, [](auto& p) { return p.offset; }));
  out.add("preload", unit::kForce, column(points, [](auto& p) { return p.force; }));
  out.add("axial stiffness", unit::kStiffness, column(points, [](auto& p) { return p.stiffness; }));
  return out;
}

/// Columns of a table of RUN.json from `first`, under short titles, in PRINT.txt.
void print_table(listing::Report& page, const results::StaticTable& table, const char* name_title,
                 std::size_t first, const std::vector<std::string>& titles) {
  if (table.columns.size() < first + titles.size()) return;
  std::vector<listing::Report::Column> columns;
  for (std::size_t k = 0; k < titles.size(); ++k)
    columns.push_back({titles[k], table.columns[first + k].unit});
  std::vector<listing::Report::Row> rows;
  for (std::size_t i = 0; i < table.columns.front().values.size(); ++i) {
    listing::Report::Row row{std::to_string(i + 1), {}};
    for (std::size_t k = 0; k < titles.size(); ++k)
      row.values.push_back(table.columns[first + k].values[i]);
    rows.push_back(std::move(row));
  }
  if (!rows.empty()) page.table(name_title, columns, rows, 6);
}

}  // namespace

std::vector<std::string> result_lines(const AssemblyResult& result) {
  std::vector<std::string> out{headline(result)};
  add_rows(result, out);
  const Vec5& q = result.loaded.state.q;
  const Mat5& K = result.loaded.state.stiffness;
  out.push_back(fmt::format(
      "displacement of the shaft: x {:.4g}, y {:.4g}, z {:.4g} µm, about y {:.4g}, about z {:.4g} "
      "µrad",
      1e6 * q(0), 1e6 * q(1), 1e6 * q(2), 1e6 * q(3), 1e6 * q(4)));
  out.push_back(fmt::format(
      "stiffness: x {:.4g}, y {:.4g}, z {:.4g} N/µm, about y {:.4g}, about z {:.4g} N.m/mrad",
      1e-6 * K(0, 0), 1e-6 * K(1, 1), 1e-6 * K(2, 2), 1e-3 * K(3, 3), 1e-3 * K(4, 4)));
  add_preload(result, out);
  add_lives(result, out);
  return out;
}

std::string assembly_listing(const AssemblyResult& result) {
  listing::Report page(result.assembly.name, results::UnitSystem::SI);
  page.new_page("SET OF BEARING ROWS");
  page.text(headline(result));
  page.text(
      "Frame of the set: x along the shaft, z radial upward. The shaft pushes the inner ring of a "
      "+ "
      "row to +x and that of a - row to -x. The axial load of a row is positive if it loads the "
      "row.");
  page.heading("Rows");
  print_table(page, rows_table(result), "row", 0,
              {"x", "offset", "axial load", "load x", "load y", "load z", "moment y", "moment z"});
  page.blank();
  print_table(page, rows_table(result), "row", 8, {"angle o", "angle i", "largest Q", "pressure"});
  for (std::size_t k = 0; k < result.rows.size(); ++k)
    page.text(fmt::format("Row {} {}: {}. Its files are in row-{}/.", k + 1,
                          sign_of(result.rows[k].orientation), result.rows[k].deck, k + 1));
  page.heading("Results of the set");
  for (const results::KeyResult& one : result.set)
    page.item(fmt::format("{}{}{}", one.of.label, one.of.part.empty() ? "" : ", ", one.of.part),
              one.value, *one.of.unit);
  page.heading("Stiffness matrix, rows are forces and moments at x = 0");
  page.table("",
             {{"x", &unit::kStiffness},
              {"y", &unit::kStiffness},
              {"z", &unit::kStiffness},
              {"about y", &unit::kCoupledStiffness},
              {"about z", &unit::kCoupledStiffness}},
             matrix_rows(result.loaded.state.stiffness));
  page.text("Moments per displacement are in N.m/m, moments per rotation in N.m/rad.");
  if (result.opposed) {
    page.new_page("PRELOAD AND UNLOADING");
    std::vector<std::string> lines;
    add_preload(result, lines);
    for (const std::string& line : lines) page.text(line);
    page.heading("Axial force versus displacement of the shaft from the unloaded set");
    std::vector<std::string> titles{"shift", "force", "stiffness"};
    for (std::size_t k = 0; k < result.rows.size(); ++k)
      titles.push_back(fmt::format("row {}", k + 1));
    print_table(page, curve_table(result), "point", 0, titles);
    page.heading("Preload versus axial offset of the set, unmounted");
    print_table(page, preload_table(result), "point", 0, {"offset", "preload", "stiffness"});
  }
  if (!result.findings.empty()) {
    page.heading("Findings");
    for (const Finding& one : shown_findings(result.findings)) page.text(one.text());
  }
  return page.take();
}

nlohmann::ordered_json result_json(const AssemblyResult& result) {
  Json out;
  out["arrangement"] = result.assembly.arrangement;
  out["rows"] = Json::array();
  for (std::size_t k = 0; k < result.rows.size(); ++k) {
    const RowResult& row = result.rows[k];
    Json one;
    one["row"] = k + 1;
    one["deck"] = row.deck;
    one["folder"] = fmt::format("row-{}", k + 1);
    one["orientation"] = std::string(1, sign_of(row.orientation));
    one["position [m]"] = row.position;
    one["offset [m]"] = row.offset;
    one["axial load [N]"] = axial_load(row.state);
    one["load [N, N m]"] = vector_json(row.load);
    one["elements with load"] = row.state.loaded;
    one["contact angles [rad]"] = {number_json(row.state.angle[0]),
                                   number_json(row.state.angle[1])};
    one["summary"] = Json::object();
    for (const results::KeyResult& item : row.of)
      one["summary"][std::string(item.of.id)] =
          std::isinf(item.value) ? Json("infinite") : number_json(item.value);
    out["rows"].push_back(std::move(one));
  }
  out["stiffness [N/m, N/rad, N m/m, N m/rad]"] = matrix_json(result.loaded.state.stiffness);
  if (result.opposed) {
    Json preload{{"offset [m]", result.offset},
                 {"unmounted [N]", result.preload_unmounted},
                 {"in operation [N]", result.preload_operation},
                 {"unloaded stiffness [N/m, N/rad, N m/m, N m/rad]",
                  matrix_json(result.unloaded.state.stiffness)}};
    if (!result.assembly.preload.name.empty()) preload["class"] = result.assembly.preload.name;
    if (!result.assembly.preload.source.empty()) preload["source"] = result.assembly.preload.source;
    out["preload"] = std::move(preload);
    out["unloading"] = Json::array();
    for (const Unloading& one : result.unloading)
      out["unloading"].push_back({{"row", one.row + 1},
                                  {"axial force [N]", one.force},
                                  {"displacement [m]", one.displacement}});
  }
  return out;
}

results::StaticTables result_tables(const AssemblyResult& result) {
  results::StaticTables out;
  out.run_id = result.assembly.name;
  out.bearing = "assembly";
  out.tables = {rows_table(result), curve_table(result), preload_table(result)};
  std::erase_if(out.tables, [](const results::StaticTable& table) {
    return table.columns.empty() || table.columns.front().values.empty();
  });
  return out;
}

}  // namespace adore::assembly
