#include "runs/run_outputs.hpp"

#include "base/errors.hpp"
#include "base/version.hpp"
#include "deck/unit_text.hpp"
#include "dynamics/effect_catalogue.hpp"
#include "dynamics/scene_estimate.hpp"
#include "life/contacts.hpp"
#include "listing/print_fits.hpp"
#include "listing/print_heat.hpp"
#include "listing/solution_tables.hpp"
#include "listing/static_summary.hpp"
#include "results/averages.hpp"
#include "results/channels.hpp"
#include "results/continuation.hpp"
#include "results/file_sums.hpp"
#include "results/restart.hpp"
#include "results/run_json.hpp"
#include "runs/cage_start.hpp"
#include "runs/cage_state.hpp"
#include "runs/changed_equilibrium.hpp"
#include "runs/continued_deck.hpp"
#include "runs/deck_summary.hpp"
#include "runs/equilibrium.hpp"
#include "runs/fault_frequencies.hpp"
#include "runs/key_results.hpp"
#include "runs/law_ranges.hpp"
#include "runs/life_observer.hpp"
#include "runs/missed_tolerance.hpp"
#include "runs/model_table.hpp"
#include "runs/motion_watch.hpp"
#include "runs/output_folder.hpp"
#include "runs/rest_watch.hpp"
#include "runs/restart_progress.hpp"
#include "runs/run_files.hpp"
#include "runs/start_state.hpp"
#include "runs/stored_races.hpp"
#include "runs/user_session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <tuple>

namespace adore::runs {
namespace fs = std::filesystem;
namespace {

using Clock = std::chrono::steady_clock;
using scene::Snapshot;

std::vector<std::string> component_names(const dynamics::System& system) {
  std::vector<std::string> out;
  for (int i = 0; i < system.layout().size(); ++i) out.push_back(system.layout().component_name(i));
  return out;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> out;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = std::min(text.find('\n', from), text.size());
    out.push_back(text.substr(from, end - from));
    from = end + 1;
  }
  return out;
}

const char* status_word(RunStatus status) {
  switch (status) {
    case RunStatus::Done:
      return "done";
    case RunStatus::Interrupted:
      return "interrupted";
    case RunStatus::Untrusted:
      return "untrusted";
    case RunStatus::Failed:
      break;
  }
  return "failed";
}

/// State that a new run from FINAL takes over if races are prescribed as `now`:
/// a free race only with its state, and less than one revolution.
dynamics::PrescribedRaces of_new_run(dynamics::PrescribedRaces races,
                                     const results::FinalState& from,
                                     const dynamics::PrescribedRaces& now) {
  constexpr std::array kStates{"outer race.position", "inner race.position"};
  for (std::size_t j = 0; j < 2; ++j) {
    const double angle = std::remainder(races[j].angle, 2.0 * std::numbers::pi);
    const auto is_state = [&](const std::string& name) { return name.starts_with(kStates[j]); };
    if (std::none_of(from.components.begin(), from.components.end(), is_state)) races[j] = now[j];
    races[j].angle = angle;
    races[j].turned_before = 0.0;
  }
  return races;
}

}  // namespace

/// Why the results are not trusted, or the run failed: the first finding.
void add_ending(results::RunSummary& run) {
  const char* const code = run.status == status_word(RunStatus::Untrusted) ? "end.untrusted"
                           : run.status == status_word(RunStatus::Failed)  ? "end.failed"
                                                                           : nullptr;
  if (code != nullptr) run.findings.insert(run.findings.begin(), make_finding(code, run.message));
}

/// The open files of one run and their data for a continuation.
struct RunOutputs::Impl {
  const Prepared& prepared;
  std::string request;
  bool overwrite;
  const setup::RunControl& control;
  scene::ScenePlan plan;
  deck::UnitSystem units;
  results::ChannelRecorder recorder;
  std::optional<results::ChannelRecorder> user_recorder;  ///< of every counted step, for ADRX9
  results::RunAverages averages;
  results::StepBand band;  ///< since the step stored last
  scene::Look look;
  bool may_jump;  ///< the state or the bearing at a counted step (RunOutputs::sample_state_jump)
  LifeObserver life;
  std::array<std::vector<double>, 2> both_loads;  ///< of balls on split races, as one load [N]
  MotionLimitMonitor watch;
  CageStateMonitor cage_state;
  LawValidityMonitor ranges;
  RunFiles files;
  std::uintmax_t print_bytes = 0;  ///< of a listing that is continued
  std::uintmax_t sol9_bytes = 0;   ///< and of SOL9
  std::optional<LedgerStart> ledger_start;
  Snapshot last;  ///< last stored instant
  std::vector<double> last_y;
  std::vector<Finding> remarks;
  KeyResults key_results;
  Clock::time_point checkpoint = Clock::now();
  long segment = 0;                 ///< step from which maxStps counts
  long restart_step = -1;           ///< of the last checkpoint
  long continued_at = 0;            ///< step at which this process took the run over
  std::vector<int> cage_positions;  ///< first components of the mass centers of cage or segments
  const ThermalRun* thermal = nullptr;
  nlohmann::ordered_json network;  ///< of the last thermal step
  double turned_before = 0.0;      ///< rotation of the shaft beyond speed times time [rad]

  Impl(const Prepared& p, RunPlace f, std::string r, bool o)
      : prepared(p),
        request(std::move(r)),
        overwrite(o),
        control(p.control),
        plan(p.plan),
        units(p.input.deck.units()),
        recorder(p.bearing, units, results::ChannelTable(dynamics::energy_terms())),
        may_jump(p.bearing.thermal || p.plan.has(scene::Effect::LightLoadBalance)),
        life(p.bearing, p.life.parameters,
             {p.life.state.factors.film_parameter[0], p.life.state.factors.film_parameter[1]}),
        watch(p.bearing),
        cage_state(p.bearing, results::to_si(1.0, results::unit::kLength, units)),
        ranges(p.bearing),
        files(p, std::move(f)) {
    // Plots compare it with the interval of the stored steps.
    if (p.control.dynamic) dynamics::find_fastest_vibration(plan, p.bearing, p.start);
    if (p.control.dynamic)
      life.set_reference(p.rollers ? life::life_contacts(*p.rollers, p.bearing)
                                   : life::life_contacts(p.start, p.bearing));
  }

  [[nodiscard]] fs::path path(const std::string& name) const { return files.path(name); }
  void remark(Finding finding) {
    finding.file = prepared.input.path.string();
    finding.message = deck::message_in_units(finding.message, prepared.input.deck.units());
    remarks.push_back(std::move(finding));
  }
  void check_quadrature(const scene::QuadratureError& error);
  void make_room();
  void print_front_matter(const std::optional<scene::Scales>& scales);
  [[nodiscard]] results::FinalState final_state(dynamics::System& system, const Snapshot& at,
                                                std::span<const double> y) const;
  [[nodiscard]] listing::StaticSummary static_summary(bool dynamic) const;
  void write_restart(dynamics::System& system, const Snapshot& at, std::span<const double> y,
                     const Resume& resume);
  [[nodiscard]] Snapshot snapshot(dynamics::System& system, const RunPoint& point) const;
  /// The same into a snapshot from before, whose memory is used again.
  void snapshot(dynamics::System& system, const RunPoint& point, Snapshot& out) const;
  /// The channels of RESULTS.h5 at this instant; "_low", "_high" and "_mean" are of it alone.
  [[nodiscard]] user::Session::Channels user_channels(scene::Snapshot snapshot) {
    snapshot.power.life_hours = life.hours();
    if (!user_recorder)
      user_recorder.emplace(prepared.bearing, units,
                            results::ChannelTable(dynamics::energy_terms()));
    const results::StepRecord& record = user_recorder->record(snapshot);
    user::Session::Channels out;
    const auto channels = user_recorder->table().all();
    for (std::size_t c = 0; c < channels.size(); ++c) {
      out.name.push_back(channels[c].id.data());
      out.size.push_back(static_cast<std::int32_t>(record.values[c].size()));
      out.first.push_back(static_cast<std::int64_t>(out.value.size()));
      out.value.insert(out.value.end(), record.values[c].begin(), record.values[c].end());
    }
    return out;
  }
  [[nodiscard]] results::MeanLoad mean_load() const {
    return results::mean_load(averages.averages(), prepared.bearing, plan);
  }
  [[nodiscard]] results::RunSummary summary() const {
    return summary_of_deck(prepared, plan, request, remarks);
  }
  void close(results::RunSummary& run, const std::optional<listing::RunLife>& run_life = {});
};

/// Warns when the nodes of the contact integrals leave more than 5 % of the races' heat: of the
/// heat of the last state or, where that has all but ended, of the run's mean.
void RunOutputs::Impl::check_quadrature(const scene::QuadratureError& error) {
  constexpr double kMaxHeatError = 0.05;
  const std::array<double, 2> mean = mean_race_heat(last, averages.averages());
  // Heat that is less than the rounding of the stored energy is not judged.
  const double stored = last.energy.sum(scene::LedgerKind::Stored);
  const double least = last.time > 0.0 ? results::kHeatFloor * std::abs(stored) / last.time : 0.0;
  const double heat = std::max({error.heat_of_finer, mean[0] + mean[1], least});
  const double off = heat > 0.0 ? (error.heat_of_rule - error.heat_of_finer) / heat : 0.0;
  if (std::abs(off) <= kMaxHeatError) return;
  remark(make_finding(
             "end.quadrature",
             fmt::format("the contact integrals have too few nodes: the heat of the races differs "
                         "by {:.2g} % from the heat with twice as many nodes (at the last state). "
                         "Increase the run options ellipseMajor and ellipseMinor",
                         100.0 * off))
             .measure(100.0 * off, 100.0 * kMaxHeatError));
}

void RunOutputs::Impl::make_room() {
  Outputs all_outputs = files.outputs();
  // Its state is the start; the first checkpoint takes its place.
  if (control.start != setup::StartState::Statics)
    std::erase(all_outputs.names, control.final_file);
  const fs::path away = runs::make_room(all_outputs, files.folder());
  if (!away.empty())
    remark(make_finding(
        "run.moved_results",
        fmt::format("older result files that this run does not replace were moved to {}",
                    away.string())));
}

results::FinalState RunOutputs::Impl::final_state(dynamics::System& system, const Snapshot& at,
                                                  std::span<const double> y) const {
  results::FinalState out;
  out.version = program_version(prepared.user.get());
  out.run_id = prepared.bearing.run_id;
  out.step = at.step;
  out.time = at.time;
  out.step_size = at.step_size;
  out.shaft_rotation = at.shaft_rotation;
  out.scales = system.scales();
  out.components = component_names(system);
  out.state.assign(y.begin(), y.end());
  store_races(system.prescribed_races(at.time, y), out.extras);
  if (thermal != nullptr) thermal->save(out.extras);
  deck::Deck deck = prepared.input.deck;
  deck.user_lines.clear();  // of user routines: any text
  out.deck = deck::write_deck(deck);
  return out;
}

Snapshot RunOutputs::Impl::snapshot(dynamics::System& system, const RunPoint& point) const {
  Snapshot out;
  snapshot(system, point, out);
  return out;
}

void RunOutputs::Impl::snapshot(dynamics::System& system, const RunPoint& point,
                                Snapshot& out) const {
  system.snapshot(point.time, point.y, out);
  out.step = point.step;
  out.step_size = point.step_size;
  out.shaft_rotation += turned_before;
  if (ledger_start) ledger_start->apply(out);
  if (thermal != nullptr) out.thermal = thermal->shown();
}

void RunOutputs::Impl::write_restart(dynamics::System& system, const Snapshot& at,
                                     std::span<const double> y, const Resume& resume) {
  files.flush();
  results::MasterState master;
  master.last = final_state(system, at, y);
  if (thermal != nullptr) thermal->save(master.averages);
  averages.save(master.averages);
  band.save(master.averages);
  life.save(master.averages);
  recorder.save(master.averages);
  save_progress(master.averages, at, resume, files.steps, segment, control);
  master.files = files.master_entries();
  results::write_final(master.last, files.place(control.final_file));
  results::write_master(master, files.place(control.master_file));
  checkpoint = Clock::now();
  restart_step = at.step;
}

/// Of the equilibrium that PRINT.txt shows: a dynamic run's has the law of its motion.
listing::StaticSummary RunOutputs::Impl::static_summary(bool dynamic) const {
  if (prepared.rollers) return listing::summarize(*prepared.rollers, prepared.bearing);
  return listing::summarize(dynamic ? prepared.start : prepared.statics, prepared.bearing);
}

/// Everything of PRINT.txt that is known before the first step.
void RunOutputs::Impl::print_front_matter(const std::optional<scene::Scales>& scales) {
  listing::PrintFile& print = *files.print;
  print.front({prepared.input.deck, prepared.as_built, scales, summary().options});
  std::vector<std::string> warnings;
  for (Issue issue : shown_findings(prepared.input.warnings)) {
    issue.file.clear();  // the page is about one deck
    warnings.push_back(issue.text());
  }
  print.summary(static_summary(scales.has_value()), prepared.bearing, prepared.life, warnings);
  if (prepared.rollers)
    print.quasi_static(*prepared.rollers, prepared.bearing);
  else
    print.quasi_static(scales ? prepared.start : prepared.statics, prepared.bearing);
  if (prepared.friction) print.friction(*prepared.friction, prepared.rollers ? "roller" : "ball");
  if (prepared.thermal) print.thermal(*prepared.thermal);
  if (prepared.time_line) print.time_line(*prepared.time_line);
  if (prepared.bearing.operating) print.fits(prepared.bearing);
  if (control.stiffness) print.stiffness_table(prepared.stiffness, control.stiffness->share);
  print.life(prepared.life);
  if (const auto lines = fault_frequency_lines(prepared, equilibrium_fault_frequencies(prepared));
      !lines.empty())
    print.texts("PASSING FREQUENCIES OF THE QUASI-STATIC SOLUTION", lines, false);
  if (const auto models = find_model_study(prepared.input))
    print.texts("MODEL ERRORS", lines_of(model_table(*models)), true);
  if (prepared.user && !prepared.user->documentation().empty())
    print.texts("USER ROUTINES", prepared.user->documentation(), true);
}

void RunOutputs::Impl::close(results::RunSummary& run,
                             const std::optional<listing::RunLife>& run_life) {
  files.written.push_back(path("RUN.json"));
  for (const fs::path& file : files.written) run.files.push_back(file.filename().string());
  files.print->ledgers(run, plan, run_life);
  files.close();
  std::error_code error;
  for (const fs::path& file : files.written)
    if (file.filename() != "RUN.json" && fs::exists(file, error))
      run.sums.push_back(results::file_checksum(file));
  results::write_run_json(run, files.place("RUN.json"));
}

RunOutputs::RunOutputs(const Prepared& prepared, const RunPlace& place, std::string request,
                       bool overwrite)
    : impl_(std::make_unique<Impl>(prepared, place, std::move(request), overwrite)) {}
RunOutputs::~RunOutputs() = default;

void RunOutputs::set_thermal_run(const ThermalRun& thermal) {
  impl_->thermal = &thermal;
  impl_->recorder.set_bearing(impl_->prepared.bearing);
  if (impl_->user_recorder) impl_->user_recorder->set_bearing(impl_->prepared.bearing);
  impl_->life.update_bearing();
  impl_->ranges.update_bearing();
}

void RunOutputs::thermal_step(const ThermalRun::Step& step, double time) {
  Impl& s = *impl_;
  s.recorder.set_bearing(s.prepared.bearing);
  if (s.user_recorder) s.user_recorder->set_bearing(s.prepared.bearing);
  s.life.update_bearing();
  s.ranges.update_bearing();
  s.files.print->thermal_step(step.heat, step.number, time, step.geometry);
  const bearing::Bearing& bearing = s.prepared.bearing;
  s.network = results::to_json({bearing.run_id,
                                listing::type_name(bearing.type),
                                s.units,
                                {listing::thermal_network_table(step.heat)}});
}

void RunOutputs::remark(Finding finding) { impl_->remark(std::move(finding)); }

StartPoint RunOutputs::find_start_point(dynamics::System& system, setup::StartState start) {
  Impl& s = *impl_;
  StartPoint out;
  std::optional<results::MasterState> kept;
  out.y = system.initial_state();
  if (const auto why = s.files.no_animation()) s.remark(make_finding("run.no_animation", *why));
  std::error_code error;
  const bool master_exists = fs::exists(s.path(s.control.master_file), error);
  const bool final_exists = fs::exists(s.path(s.control.final_file), error);
  const deck::Deck& deck = s.prepared.input.deck;
  if (start == setup::StartState::FromFinal && !final_exists)
    throw InputError({deck.issue(Severity::Error, "kIcOpt",
                                 fmt::format("starts from {}, but this file does not exist",
                                             s.path(s.control.final_file).string()),
                                 "copy the file FINAL of a run to this place, or start from the "
                                 "quasi-static solution (kIcOpt = 0)")});
  if (start == setup::StartState::Continue && !master_exists && !final_exists)
    throw InputError(
        {deck.issue(Severity::Error, "kIcOpt",
                    fmt::format("continues a run, but neither {} nor {} exists: no run was started "
                                "here, or the run ended before its first checkpoint",
                                s.path(s.control.master_file).string(), s.control.final_file),
                    "start the run with kIcOpt = 0; add --overwrite if the folder still contains "
                    "files of the earlier run")});
  if (start == setup::StartState::Continue && !master_exists) {
    s.remark(
        make_finding("run.no_restart_file",
                     fmt::format("kIcOpt = 1, but there is no file {}: a new run starts from {}",
                                 s.control.master_file, s.control.final_file)));
    start = setup::StartState::FromFinal;
  }
  bool changed = false;  // the equilibrium may be another one
  const auto compare = [&](const results::FinalState& stored, const fs::path& file) {
    for (const Issue& note : compare_with_stored(stored.deck, s.prepared.input.deck, file, start)) {
      s.remarks.push_back(make_finding("run.changed_deck", note.message));
      s.remarks.back().file = note.file;
    }
    changed =
        !stored.deck.empty() && may_change_equilibrium(stored.deck, s.prepared.input.deck, start);
  };
  // Moves the state to the equilibrium of this deck. @return it did
  const auto move = [&](const results::FinalState& stored,
                        const std::map<std::string, double>& thermal, const fs::path& file) {
    if (!changed) return false;
    dynamics::EquilibriumChange change;
    try {
      const StoredScene from = stored_scene(stored, thermal, s.prepared, file);
      change =
          dynamics::move_to_equilibrium(moving_scene(from.prepared, *from.system), from.time,
                                        from.y, moving_scene(s.prepared, system), out.time, out.y);
    } catch (const InputError& failure) {
      change.why_not =
          fmt::format("the model of the stored state cannot be built ({})", failure.what());
    } catch (const SolverError& failure) {
      change.why_not =
          fmt::format("the model of the stored state cannot be built ({})", failure.what());
    }
    if (auto excess = equilibrium_change_finding(change, "start from " + file.filename().string(),
                                                 user_routine_motion_text(s.prepared)))
      s.remark(std::move(*excess));
    if (change.moved)
      s.remark(make_finding(
          "run.start_moved",
          fmt::format("the stored state is moved to the equilibrium of this deck: elements and "
                      "races move by up to {:.4g} {}",
                      results::from_si(change.largest_shift, results::unit::kLength, s.units),
                      results::unit_name(results::unit::kLength, s.units))));
    return change.moved;
  };
  if (start == setup::StartState::FromFinal) {
    const fs::path file = s.path(s.control.final_file);
    const results::FinalState from = results::read_final(file);
    results::check_bodies(from, component_names(system), file);
    compare(from, file);
    copy_state(from, system, out.y);
    changed =
        changed || from.extras.contains("thermal.steps") || s.plan.race_motions.has_excitation();
    const auto races = stored_races(from.extras);
    const dynamics::PrescribedRaces now = system.prescribed_races(out.time, out.y);
    if (races) system.go_on(of_new_run(*races, from, now), out.time, out.y);
    const bool moved = move(from, from.extras, file);
    if (races)
      for (const std::string& jump : describe_race_jumps(*races, now, s.plan, s.units, moved))
        s.remark(make_finding("run.start_race_jump", jump));
    out.turned_before = s.turned_before = 0.0 - system.shaft_rotation(out.time, out.y);
  } else if (start == setup::StartState::Continue) {
    const results::MasterState master = results::read_master(s.path(s.control.master_file));
    results::check_run_id(s.path(s.control.master_file), master.last.run_id,
                          s.prepared.bearing.run_id);
    compare(master.last, s.path(s.control.master_file));
    results::check_layout(master.last, component_names(system), s.path(s.control.master_file));
    system.set_scales(master.last.scales);
    out.y = master.last.state;
    out.time = master.last.time;
    out.step = master.last.step;
    out.step_size = master.last.step_size;
    out.continued = true;
    const auto races = stored_races(master.last.extras);
    const dynamics::PrescribedRaces now = system.prescribed_races(out.time, out.y);
    if (races) system.go_on(*races, out.time, out.y);
    const bool moved = move(master.last, master.averages, s.path(s.control.master_file));
    if (races)
      for (const std::string& jump : describe_race_jumps(*races, now, s.plan, s.units, moved))
        s.remark(make_finding("run.start_race_jump", jump));
    // The shaft angle continues.
    system.set_start(out.time, out.y);
    const double turned = master.last.shaft_rotation;
    const double beyond = turned - system.shaft_rotation(out.time, out.y);
    // Not what rounding leaves: runs under one speed join to the same bytes.
    out.turned_before = std::abs(beyond) > 1e-12 * std::abs(turned) ? beyond : 0.0;
    s.turned_before = out.turned_before;
    s.averages.restore(master.averages);
    s.life.restore(master.averages);
    s.recorder.restore(master.averages);
    s.band.restore(master.averages);
    s.files.steps = restore_progress(master, s.control, s.path(s.control.master_file), out);
    s.ledger_start = LedgerStart::of(master);
    kept = master;
    const results::MasterFileEntry* listing = master.file("PRINT");
    if (listing != nullptr) s.print_bytes = listing->bytes;
    if (const results::MasterFileEntry* sol9 = master.file("SOL9")) s.sol9_bytes = sol9->bytes;
    out.complete = results::read_request_status(s.path("RUN.json")).status == "done";
    s.ranges.restore(results::read_run_member(s.path("RUN.json"), "outside_validity"));
  }
  if (start == setup::StartState::Statics) try {
      const auto check = [&] {
        system.set_start(out.time, out.y);
        check_cage_start(s.prepared, system.snapshot(out.time, out.y));
      };
      if (may_start_at_rest(s.prepared)) {
        check();
        out.at_rest = start_at_rest(s.prepared, system, out.y);
      }
      if (!out.at_rest) {
        StartState from = start_state(s.prepared, system);
        out.y = std::move(from.y);
        if (!from.remark.empty()) s.remark(make_finding("run.start_friction", from.remark));
        check();
        if (auto excess = judge_start_energy(s.prepared, system, out.y))
          s.remark(std::move(*excess));
        if (const std::string jumps = user_routine_jumps_text(s.prepared); !jumps.empty())
          s.remark(make_finding("run.specified_jumps", jumps));
      }
    } catch (const SolverError& refused) {
      reject_cage_start(s.prepared, refused);
    }
  if (out.continued) {
    check_names(s.files.outputs());
    s.files.check();
    if (kept) s.files.verify_checksums(*kept);
    std::tie(out.stored_step, out.stored_time) = s.files.last_stored_step(s.print_bytes);
  } else {
    try {
      check_room(s.files.outputs(), s.overwrite);
    } catch (const ResultsExist&) {
      if (start != setup::StartState::FromFinal) throw;
      throw ResultsExist(s.files.outputs().folder,
                         {s.control.final_file + " (the start state of this run, because kIcOpt = "
                                                 "-1; kept until the first checkpoint)",
                          "others"});
    }
  }
  return out;
}

void RunOutputs::open(dynamics::System& system, const StartPoint& start) {
  Impl& s = *impl_;
  system.set_start(start.time, start.y);
  s.plan.quadratures = system.layout().size() - system.layout().controlled_size();
  s.segment = start.segment;
  s.continued_at = start.step;
  if (start.continued)
    remove_leftovers(s.files.outputs(), s.files.folder());
  else
    s.make_room();
  s.files.open(start.continued, s.print_bytes, s.sol9_bytes);
  if (!start.continued) s.print_front_matter(system.scales());
  for (const dynamics::StateLayout::Group& group : system.layout().groups())
    if (group.name.starts_with("cage") && group.name.ends_with(".position"))
      s.cage_positions.push_back(group.slice.first);
  s.cage_state.follow(system.layout());
  s.last_y = start.y;
  // If the process is killed, this identifies the run.
  results::RunSummary run = s.summary();
  run.status = "running";
  if (const auto left = s.ranges.findings(); !left.empty()) run.validity = validity_json(left);
  run.integrator = s.control.integrator;
  run.tolerance = s.control.tolerance;
  for (const fs::path& file : s.files.written) run.files.push_back(file.filename().string());
  results::write_run_json(run, s.files.place("RUN.json"));
  if (!start.continued) return;
  // Until something is stored, the last page is of this point.
  const RunPoint here{start.step, start.time, start.step_size, start.y};
  s.last = s.snapshot(system, here);
  if (s.ledger_start && !s.ledger_start->is_continued_by(s.last.energy)) {
    s.ledger_start.reset();
    s.last = s.snapshot(system, here);
  }
  s.last.power.life_hours = s.life.hours();
}

bool RunOutputs::wants(long step) const {
  const setup::RunControl& c = impl_->control;
  return due(step, c.print_every) || due(step, c.plot_every) || due(step, c.animate_every) ||
         due(step, c.life_every);
}

void RunOutputs::store(dynamics::System& system, const RunPoint& point, bool always) {
  Impl& s = *impl_;
  const RunFiles::StepTargets where = s.files.claim_targets(point.step, always);
  if (!where.any()) return;
  s.snapshot(system, point, s.last);
  s.last_y.assign(point.y.begin(), point.y.end());
  s.watch.check(s.last);
  s.ranges.check(s.last);
  if (where.life) s.life.observe(s.last);
  s.last.power.life_hours = s.life.hours();
  s.averages.add(s.last);
  const bool saved = s.files.saves(where, point.step);
  const results::StepRecord& record = s.recorder.record(s.last, saved ? &s.band : nullptr);
  if (saved) s.band.clear();
  s.files.store(where, s.last, record);
  if (where.print)
    s.files.print->step(s.last, record, s.prepared.bearing, s.averages.averages(),
                        s.control.print_option, s.life.step());
  if (where.print && s.prepared.user)
    if (const auto lines = s.prepared.user->print(point.step, point.time); !lines.empty())
      s.files.print->texts("User routines", lines, false);
}

void RunOutputs::call_user_routines(dynamics::System& system, const RunPoint& point) {
  Impl& s = *impl_;
  user::Session& session = *s.prepared.user;
  if (!s.files.user) {
    session.step(point.step, point.time);
    return;
  }
  const scene::Snapshot snapshot = s.snapshot(system, point);
  const std::string text = session.wants_channels()
                               ? session.step(snapshot, s.user_channels(snapshot))
                               : session.step(snapshot);
  if (!text.empty()) s.files.user->append(text);
}

void RunOutputs::follow(const RunPoint& point) {
  Impl& s = *impl_;
  if (s.cage_positions.empty()) return;
  s.cage_state.add_step(point.time, point.y);
  scene::Vec3 mean = scene::Vec3::Zero();
  for (const int first : s.cage_positions) {
    const double* c = point.y.data() + first;
    mean += scene::Vec3(c[0], c[1], c[2]) / static_cast<double>(s.cage_positions.size());
  }
  s.averages.add_cage_position(point.time, mean);
}

void RunOutputs::follow_step(const dynamics::System& system, double time, bool stored) {
  Impl& s = *impl_;
  if (s.files.all && (!stored || s.may_jump)) {
    system.look(s.look);
    if (!stored) s.band.look(s.look);
  }
  s.averages.add_loads(time, system.contact_loads(0), system.contact_loads(1));
  std::array<std::span<const double>, 2> loads{system.contact_loads(0), system.contact_loads(1)};
  for (std::size_t j = 0; j < 2; ++j) {
    const std::span<const double> second = system.other_half_loads(j);
    if (second.empty()) continue;
    s.both_loads[j].assign(loads[j].begin(), loads[j].end());
    for (std::size_t i = 0; i < second.size(); ++i)
      s.both_loads[j][i] = life::equivalent_split_race_load(loads[j][i], second[i]);
    loads[j] = s.both_loads[j];
  }
  s.life.follow_step(time, loads[0], loads[1]);
}

bool RunOutputs::life_due() const { return impl_->life.evaluation_due(); }

void RunOutputs::evaluate_life(dynamics::System& system, const RunPoint& point) {
  impl_->life.evaluate(impl_->snapshot(system, point));
}

void RunOutputs::sample_state_jump(const dynamics::System& system, bool stored) {
  Impl& s = *impl_;
  if (!s.files.all) return;
  // The state after the jump is stored.
  if (!stored) system.look(s.look);
  s.band.look(s.look);
}

bool RunOutputs::saves(long step, bool last) const { return impl_->files.will_save(step, last); }

bool RunOutputs::checkpoint_due() const {
  return std::chrono::duration<double>(Clock::now() - impl_->checkpoint).count() >=
         impl_->prepared.options.checkpoint_seconds;
}

void RunOutputs::checkpoint(dynamics::System& system, const RunPoint& point, Resume resume) {
  impl_->write_restart(system, impl_->snapshot(system, point), point.y, resume);
}

void RunOutputs::store_last_point(dynamics::System& system, const RunEnd& end) {
  Impl& s = *impl_;
  switch (end.status) {
    case RunStatus::Done:
    case RunStatus::Untrusted:
      store(system, end.point, true);
      checkpoint(system, end.point, end.resume);
      break;
    case RunStatus::Interrupted: {
      // The point of an interruption is shown, and removed when the run continues.
      checkpoint(system, end.point, end.resume);
      RunPoint shown = end.point;
      if (end.resume.substeps > 0) ++shown.step;
      store(system, shown, true);
      results::write_final(s.final_state(system, s.last, s.last_y),
                           s.files.place(s.control.final_file));
      break;
    }
    case RunStatus::Failed:
      // The failed state may be meaningless.
      if (s.last.step > s.restart_step && !s.last_y.empty())
        s.write_restart(system, s.last, s.last_y, end.resume);
      break;
  }
}

void RunOutputs::finish(dynamics::System& system, const RunEnd& end) {
  Impl& s = *impl_;
  for (Finding& finding : s.watch.findings(s.units)) s.remark(std::move(finding));
  if (auto state = s.cage_state.finding()) s.remark(std::move(*state));
  if (const auto yields = s.watch.cage_yield_finding()) s.ranges.add(*yields);
  const std::vector<validity::Finding> left = s.ranges.findings();
  for (const validity::Finding& one :
       without(left, {"hertz.shoulder", "hertz.yield", "cage.yield"}))
    s.remark(finding_of_range(one));
  if (auto one = s.ranges.friction_coefficient_finding()) s.remark(std::move(*one));
  s.files.written.push_back(s.path(s.control.final_file));
  s.files.written.push_back(s.path(s.control.master_file));
  if (const std::string missed =
          judge_missed_tolerance(s.control, end.resume.counters, end.resume.error_sum).text;
      !missed.empty() && missed != end.message)
    s.remark(make_finding("end.missed_tolerance", missed));
  std::optional<scene::QuadratureError> quadrature;
  // A routine of the user that failed leaves nothing to evaluate; one may refuse now what it took.
  try {
    if (!s.prepared.user || s.prepared.user->failure().empty())
      quadrature = system.quadrature_error(s.last.time, s.last_y);
  } catch (const SolverError&) {
    if (!s.prepared.user) throw;
  }
  if (quadrature) s.check_quadrature(*quadrature);
  results::RunSummary run = s.summary();
  run.status = status_word(end.status);
  run.message = end.message;
  add_ending(run);
  run.scales = system.scales();
  run.integrator = s.control.integrator;
  run.tolerance = s.control.tolerance;
  run.steps = s.last.step;
  run.time = s.last.time;
  run.revolutions = s.last.shaft_rotation / (2.0 * std::numbers::pi);
  const integrators::Counters& c = end.resume.counters;
  run.counters = {{"steps", c.steps},
                  {"rejected", c.rejected},
                  {"repeated_for_energy", c.repeated_for_energy},
                  {"evaluations", c.evaluations},
                  {"at_minimum", c.at_minimum},
                  {"restarts", c.restarts},
                  {"jacobians", c.jacobians},
                  {"nonlinear_iterations", c.nonlinear_iterations}};
  if (end.resume.error_sum > 0.0) {
    run.error_sum = s.control.tolerance * end.resume.error_sum;
    run.error_largest = s.control.tolerance * end.resume.error_largest;
  }
  if (s.plan.has(scene::Effect::LightLoadBalance))
    run.counters.emplace_back("changes of held elements", end.resume.held_changes);
  run.energy = s.last.energy;
  run.load = s.mean_load();
  run.elastic = static_elastic_energy(s.prepared);
  if (s.last.momentum) run.momentum = results::momentum_items(*s.last.momentum);
  run.max_quaternion_error = s.last.max_quaternion_error;
  run.quadrature_error = quadrature;
  run.cost = system.cost().rows();
  run.seconds = end.loop_seconds;
  run.measured_from = s.continued_at;
  s.key_results = dynamic_results(s.last, s.averages.averages(), s.mean_load());
  add_lives(s.key_results, s.prepared.life);
  const listing::RunLife run_life = s.life.run_life();
  if (run_life.damage.seconds() > 0.0) {
    s.key_results.push_back(
        results::key_result("run_life_hours", run_life.damage.life_hours(run_life.slopes)));
    s.key_results.push_back(
        results::key_result("run_life_samples", static_cast<double>(run_life.steps)));
    if (!std::isnan(run_life.relative_error))
      s.key_results.push_back(results::key_result("run_life_spread", run_life.relative_error));
  }
  add_iso_lives(s.key_results, s.prepared.life);
  add_fault_frequencies(s.key_results, s.prepared,
                        motion_fault_frequencies(s.prepared, s.averages.averages()));
  run.summary = s.key_results;
  run.accuracy["means"] = results::mean_errors_json(s.averages.errors());
  run.life["run"] = listing::run_life_json(run_life);
  run.thermal_network = s.network;
  std::vector<validity::Finding> all_left = s.prepared.left_ranges;
  all_left.insert(all_left.end(), left.begin(), left.end());
  if (!all_left.empty()) run.validity = validity_json(all_left);
  s.close(run, run_life);
}

std::vector<std::string> RunOutputs::write_quasi_static() {
  Impl& s = *impl_;
  check_room(s.files.outputs(), s.overwrite);
  s.make_room();
  s.files.open_listing();
  s.print_front_matter(std::nullopt);
  results::RunSummary run = s.summary();
  run.status = "done";
  Equilibrium solution = equilibrium_of(s.prepared);
  s.key_results = solution.results;
  run.summary = s.key_results;
  run.quasi_static = results::to_json(solution.tables);
  if (!s.prepared.left_ranges.empty()) run.validity = validity_json(s.prepared.left_ranges);
  if (const std::string why = untrusted(s.prepared.left_ranges); !why.empty()) {
    run.status = status_word(RunStatus::Untrusted);
    run.message = why;
  }
  add_ending(run);
  s.close(run);
  return solution.lines;
}

std::vector<fs::path> RunOutputs::files() const { return impl_->files.written; }

KeyResults RunOutputs::summary() const { return impl_->key_results; }

results::MeanSeries RunOutputs::means() const { return impl_->averages.series(); }

results::EnergyJudgment RunOutputs::judge_energy() const {
  const bool vibrates = !impl_->prepared.plan.has(scene::Effect::ElementBalance);
  return results::judge_energy(impl_->last.energy,
                               vibrates ? static_elastic_energy(impl_->prepared) : 0.0,
                               impl_->averages.averages().largest_residual);
}

std::string RunOutputs::untrusted_law_reason() const { return untrusted(impl_->ranges.findings()); }

std::string RunOutputs::load_warning() const {
  return results::load_warning(impl_->mean_load(), impl_->units);
}
std::vector<Finding> RunOutputs::remarks() const { return impl_->remarks; }

double RunOutputs::energy_residual() const { return impl_->last.energy.residual(); }

double RunOutputs::energy_scale() const { return results::energy_scale(impl_->last.energy); }

}  // namespace adore::runs
