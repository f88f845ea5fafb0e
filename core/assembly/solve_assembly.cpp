#include "assembly/solve_assembly.hpp"

#include "assembly/assembly_file.hpp"
#include "assembly/set_life.hpp"
#include "base/errors.hpp"
#include "base/interrupted.hpp"
#include "deck/units.hpp"
#include "runs/equilibrium.hpp"
#include "runs/prepare.hpp"
#include "setup/race_motions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>

namespace adore::assembly {
namespace {

namespace fs = std::filesystem;

double result_of(const results::KeyResults& list, std::string_view id) {
  for (const results::KeyResult& one : list)
    if (one.of.id == id) return one.value;
  return std::numeric_limits<double>::quiet_NaN();
}

[[noreturn]] void refuse(const deck::Deck& deck, std::size_t k, std::string_view variable,
                         const std::string& why, const std::string& remedy) {
  Issue issue =
      deck.issue(Severity::Error, variable, fmt::format("row {}: {}", k + 1, why), remedy);
  throw InputError(std::vector<Issue>{std::move(issue)});
}

/// Rows turn with one shaft.
void check_speeds(const std::vector<runs::Prepared>& rows) {
  for (std::size_t k = 1; k < rows.size(); ++k) {
    const deck::Deck& deck = rows[k].input.deck;
    for (const char* name : {"rpm1", "rpm2"})
      if (const double own = deck.si(name), first = rows[0].input.deck.si(name);
          std::abs(own - first) > 1e-9 * std::max(std::abs(own), std::abs(first)))
        refuse(deck, k, name, "the speed differs from that of row 1, but all rows share one shaft",
               "enter the same speed in all decks");
  }
}

runs::Prepared prepare_row(const AssemblyRequest& request, const Assembly& assembly, std::size_t k,
                           const std::stop_token& stop) {
  runs::DeckRequest row = row_request(request, assembly, k);
  const deck::Deck deck = runs::load_deck(row).deck;
  check_row_deck(deck, k);
  row.changes = prescribed_displacement_sets(Vec5::Zero(), deck.units());
  return runs::prepare(row, stop);
}

BearingSet set_of(const std::vector<runs::Prepared>& rows, const Assembly& assembly,
                  const std::vector<double>& at, RowCondition condition) {
  BearingSet out;
  for (std::size_t k = 0; k < rows.size(); ++k)
    out.rows.push_back({RowModel(rows[k], condition), assembly.rows[k].orientation, at[k], 0.0});
  for (const Spacer& spacer : assembly.spacers) out.compliance.push_back(1.0 / spacer.stiffness);
  set_offsets(out, assembly, 0.0);
  return out;
}

/// Load of the assembly about X = 0.
std::array<double, 5> load_at_origin(const Assembly& assembly) {
  std::array<double, 5> out = assembly.load;
  out[3] -= assembly.load_position * out[2];
  out[4] += assembly.load_position * out[1];
  return out;
}

/// The same rows in three conditions.
struct Sets {
  BearingSet unmounted, mounted, operation;
};

/// The offsets of the rows for the preload of the assembly.
void preload_sets(const Assembly& assembly, Sets& sets) {
  double more = 0.0;
  if (assembly.preload.kind == PreloadKind::Offset)
    more = assembly.preload.offset;
  else if (assembly.preload.kind == PreloadKind::Force)
    more = offset_for_force(assembly.preload.in_operation ? sets.operation : sets.unmounted,
                            assembly, assembly.preload.force);
  for (BearingSet* set : {&sets.unmounted, &sets.mounted, &sets.operation})
    set_offsets(*set, assembly, more);
}

void add(results::KeyResults& out, const char* id, double value) {
  if (!std::isnan(value)) out.push_back(results::key_result(id, value));
}

/// Of the models whose rows obey one slope.
void add_lives(AssemblyResult& out, bool rollers) {
  const double slope = rollers ? kRollerSlope : kBallSlope;
  for (const char* id : {"life_lp_hours", "life_iso281_hours", "life_iso16281_hours",
                         "life_iso281_modified_hours"}) {
    std::vector<double> lives;
    for (const RowResult& row : out.rows) lives.push_back(result_of(row.of, id));
    if (const auto life = life_of_set(lives, slope)) add(out.set, id, *life);
  }
}

void add_sums(AssemblyResult& out) {
  for (const char* id : {"friction_torque_Nm", "friction_power_W"}) {
    double sum = 0.0;  // not computed in one row: not computed
    for (const RowResult& row : out.rows) sum += result_of(row.of, id);
    add(out.set, id, sum);
  }
}

void add_race(AssemblyResult& out) {
  constexpr std::array<const char*, 5> kDisplacement{"displacement_x_m", "displacement_y_m",
                                                     "displacement_z_m", "displacement_about_y_rad",
                                                     "displacement_about_z_rad"},
      kLoad{"load_x_N", "load_y_N", "load_z_N", "load_about_y_Nm", "load_about_z_Nm"},
      kStiffness{"stiffness_x_N_per_m", "stiffness_y_N_per_m", "stiffness_z_N_per_m",
                 "stiffness_about_y_Nm_per_rad", "stiffness_about_z_Nm_per_rad"};
  const BearingSetState& at = out.loaded.state;
  for (int k = 0; k < 5; ++k) add(out.set, kDisplacement[static_cast<std::size_t>(k)], at.q(k));
  for (int k = 0; k < 5; ++k) add(out.set, kLoad[static_cast<std::size_t>(k)], at.load(k));
  double load = 0.0, pressure = 0.0;
  for (const RowResult& row : out.rows) {
    load = std::max(load, row.state.largest);
    pressure = std::max(pressure, row.state.pressure);
  }
  add(out.set, "largest_contact_load_N", load);
  add(out.set, "largest_pressure_Pa", pressure);
  for (int k = 0; k < 5; ++k)
    add(out.set, kStiffness[static_cast<std::size_t>(k)], at.stiffness(k, k));
}

void add_preload_results(const Sets& sets, const std::function<void()>& poll, AssemblyResult& out) {
  constexpr std::array<double, 5> kNoLoad{};
  out.offset = total_offset(sets.operation);
  out.preload_unmounted =
      preload_force(sets.unmounted, solve_bearing_set(sets.unmounted, kNoLoad).state);
  out.unloaded = solve_bearing_set(sets.operation, kNoLoad);
  out.preload_operation = preload_force(sets.operation, out.unloaded.state);
  poll();
  const BearingSetState mounted =
      solve_bearing_set(sets.mounted, kNoLoad, out.unloaded.state.q).state;
  out.unloading = unloading_forces(sets.mounted, mounted, poll);
  out.curve = axial_curve(sets.mounted, mounted, out.unloading, kCurvePoints, poll);
  out.preload = preload_curve(sets.unmounted, kPreloadPoints, poll);
}

void add_preload(AssemblyResult& out) {
  if (!out.opposed) return;
  add(out.set, "set_offset_m", out.offset);
  add(out.set, "preload_unmounted_N", out.preload_unmounted);
  add(out.set, "preload_N", out.preload_operation);
  double plus = std::numeric_limits<double>::infinity(), minus = -plus;
  for (const Unloading& one : out.unloading)
    if (one.force > 0.0)
      plus = std::min(plus, one.force);
    else
      minus = std::max(minus, one.force);
  if (std::isfinite(plus)) add(out.set, "unloading_force_plus_N", plus);
  if (std::isfinite(minus)) add(out.set, "unloading_force_minus_N", minus);
}

void add_findings(AssemblyResult& out, const fs::path& file) {
  const auto add_one = [&](Finding finding) {
    finding.file = file.string();
    out.findings.push_back(std::move(finding));
  };
  for (const Finding& note : out.loaded.notes) add_one(note);
  for (std::size_t k = 0; k < out.rows.size(); ++k)
    if (out.rows[k].state.loaded == 0)
      add_one(make_finding("assembly.unloaded_row",
                           fmt::format("row {} carries no load under the load of the set. Increase "
                                       "the preload, or reduce the axial load",
                                       k + 1)));
  if (out.opposed && !(out.preload_operation > 0.0))
    add_one(make_finding("assembly.no_preload",
                         fmt::format("the set has no preload in operation (offset {:.4g} µm)",
                                     1e6 * out.offset))
                .measure(out.preload_operation));
}

/// The row by its own deck, all displacements given.
void solve_row(const AssemblyRequest& request, const Assembly& assembly, std::size_t k,
               const std::stop_token& stop, AssemblyResult& out) {
  RowResult& row = out.rows[k];
  runs::DeckRequest own = row_request(request, assembly, k);
  own.changes = row.changes;
  runs::Equilibrium solution = runs::solve_equilibrium(own, stop);
  row.of = std::move(solution.results);
  for (Finding& finding : solution.remarks) {
    finding.message = fmt::format("row {}: {}", k + 1, finding.message);
    if (!finding.body.empty()) finding.body = fmt::format("row {}, {}", k + 1, finding.body);
    out.findings.push_back(std::move(finding));
  }
}

}  // namespace

runs::DeckRequest row_request(const AssemblyRequest& request, const Assembly& assembly,
                              std::size_t k) {
  runs::DeckRequest out;
  out.deck = assembly_folder(request.folder) / assembly.rows[k].deck;
  out.sets = request.sets;
  out.options = request.options;
  return out;
}

std::vector<std::pair<std::string, std::string>> prescribed_displacement_sets(
    const Vec5& own, deck::UnitSystem system) {
  std::vector<std::pair<std::string, std::string>> out;
  for (const char* flag : {"kFS1", "kFS2", "kFS3", "kFS4", "kFS5"}) out.emplace_back(flag, "1");
  constexpr std::array<const char*, 5> kNames{"appDispX", "appDispY", "appDispZ", "appMis12",
                                              "appMis22"};
  const double length = system == deck::UnitSystem::English ? deck::unit::kLength.en_factor : 1.0;
  for (int k = 0; k < 5; ++k)
    out.emplace_back(kNames[static_cast<std::size_t>(k)],
                     fmt::format("{:.17g}", k < 3 ? own(k) / length : own(k)));
  return out;
}

void check_row_deck(const deck::Deck& deck, std::size_t k) {
  if (deck.integer("mode") >= 0)
    refuse(deck, k, "mode",
           "rows of an assembly are quasi-static; motions of several rows on one "
           "shaft are not available",
           "set mode to -1, in the decks or with --set mode=-1");
  if (deck.has("kTherm") && deck.integer("kTherm") == 1)
    refuse(deck, k, "kTherm", "the thermal analysis of several rows on one shaft is not available",
           "set kTherm to 0 and enter the temperatures");
  if (deck.integer("kStif") > 0)
    refuse(deck, k, "kStif", "the table of stiffness over speed is not available in an assembly",
           "set kStif to 0; the stiffness of the set is among its results");
  if (setup::frame_motion(deck))
    refuse(deck, k, "kRotFrame", "a moving base frame is not available in an assembly",
           "set kRotFrame to 0");
}

AssemblyResult solve_assembly(const AssemblyRequest& request, std::stop_token stop) {
  const auto begin = std::chrono::steady_clock::now();
  const auto poll = [&] {
    if (stop.stop_requested())
      throw Interrupted("interrupted during the search for the equilibrium of the set");
  };
  AssemblyResult out;
  out.assembly = read_assembly_file(request.folder);
  const Assembly& assembly = out.assembly;
  std::vector<runs::Prepared> prepared;
  for (std::size_t k = 0; k < assembly.rows.size(); ++k)
    prepared.push_back(prepare_row(request, assembly, k, stop));
  check_speeds(prepared);
  std::vector<double> widths;
  for (const runs::Prepared& row : prepared) widths.push_back(row.as_built.envelope.race_width[1]);
  const std::vector<double> at = positions(assembly, widths);
  Sets sets{set_of(prepared, assembly, at, RowCondition::Unmounted),
            set_of(prepared, assembly, at, RowCondition::Mounted),
            set_of(prepared, assembly, at, RowCondition::Operation)};
  const BearingSet& operation = sets.operation;
  out.opposed = has_opposed_rows(operation);
  preload_sets(assembly, sets);
  poll();
  if (out.opposed) add_preload_results(sets, poll, out);
  poll();
  out.loaded = solve_bearing_set(operation, load_at_origin(assembly),
                                 out.opposed ? out.unloaded.state.q : Vec5(Vec5::Zero()));
  for (std::size_t k = 0; k < assembly.rows.size(); ++k) {
    const BearingSetRow& row = operation.rows[k];
    RowResult one;
    one.deck = assembly.rows[k].deck;
    one.orientation = row.orientation;
    one.position = row.position;
    one.offset = row.offset;
    one.state = out.loaded.state.elements[k];
    one.load = row_load_in_set_frame(row, one.state);
    one.changes = prescribed_displacement_sets(one.state.own, prepared[k].input.deck.units());
    out.rows.push_back(std::move(one));
    solve_row(request, assembly, k, stop, out);
  }
  add_race(out);
  const bool rollers = operation.rows.front().model.rollers();
  if (std::all_of(operation.rows.begin(), operation.rows.end(),
                  [&](const BearingSetRow& row) { return row.model.rollers() == rollers; }))
    add_lives(out, rollers);
  add_sums(out);
  add_preload(out);
  add_findings(out, assembly_folder(request.folder) / kFileName);
  out.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return out;
}

}  // namespace adore::assembly
