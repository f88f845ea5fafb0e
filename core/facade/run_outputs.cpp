#include "facade/run_outputs.hpp"

#include "base/errors.hpp"
#include "base/version.hpp"
#include "dynamics/effect_catalogue.hpp"
#include "dynamics/race_contacts.hpp"
#include "facade/cage_start.hpp"
#include "facade/continued_deck.hpp"
#include "facade/life_observer.hpp"
#include "facade/output_folder.hpp"
#include "facade/plan_json.hpp"
#include "life/statistics.hpp"
#include "listing/print_cage.hpp"
#include "listing/print_file.hpp"
#include "listing/print_fits.hpp"
#include "listing/print_imperfections.hpp"
#include "listing/solution_tables.hpp"
#include "listing/static_cut.hpp"
#include "listing/static_summary.hpp"
#include "results/averages.hpp"
#include "results/channels.hpp"
#include "results/continuation.hpp"
#include "results/restart.hpp"
#include "results/results_h5.hpp"
#include "results/run_json.hpp"
#include "results/sol_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

namespace adore::facade {
namespace fs = std::filesystem;
namespace {

using Clock = std::chrono::steady_clock;
using scene::Snapshot;

std::vector<std::string> component_names(const dynamics::System& system) {
  std::vector<std::string> out;
  for (int i = 0; i < system.layout().size(); ++i) out.push_back(system.layout().component_name(i));
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

bool due(long step, int every) { return every > 0 && step % every == 0; }

/// A state of another run as start of this one, component by component: what FINAL does not have
/// (an orientation that only this deck shows) keeps its own start value, and integrals begin at
/// zero.
void take_state(const results::FinalState& from, const dynamics::System& system,
                std::vector<double>& y) {
  std::map<std::string, double> stored;
  for (std::size_t i = 0; i < from.components.size(); ++i)
    stored[from.components[i]] = from.state[i];
  for (int i = 0; i < system.layout().controlled_size(); ++i) {
    const auto found = stored.find(system.layout().component_name(i));
    if (found != stored.end()) y[static_cast<std::size_t>(i)] = found->second;
  }
}

using KeyResults = std::vector<std::pair<std::string, double>>;

/// Life of the bearing by the original theory, and by the model that run option sol7Life asks for
/// if that is another one [hr]: life_lp_hours, life_gz_stle_hours.
void add_lives(KeyResults& out, const life::BearingLife& life) {
  using bearing::LifeModel;
  using bearing::LifeModification;
  static constexpr std::array<const char*, life::kModels> kModels{"lp", "lpu", "gz", "ih"};
  static constexpr std::array<const char*, life::kModifications> kModifications{"", "_stle",
                                                                                "_tallian"};
  const auto add = [&](LifeModel model, LifeModification modification) {
    out.emplace_back(
        fmt::format("life_{}{}_hours", kModels[static_cast<std::size_t>(model)],
                    kModifications[static_cast<std::size_t>(modification)]),
        life::life_hours(life.state.of(model, modification).L_S, life.state.relative_speed));
  };
  add(LifeModel::Original, LifeModification::None);
  const bearing::LifeChoices& choices = life.parameters.choices;
  if (choices.stored_model != LifeModel::Original ||
      choices.stored_modification != LifeModification::None)
    add(choices.stored_model, choices.stored_modification);
}

double largest_pressure(const Prepared& prepared) {
  double pressure = 0.0;
  for (const statics::StaticBall& ball : prepared.statics.balls)
    for (const double p : ball.p_max) pressure = std::max(pressure, p);
  if (prepared.rollers)
    for (const statics::StaticRoller& roller : prepared.rollers->rollers)
      for (const auto& contact : roller.race) pressure = std::max(pressure, contact.peak_pressure);
  return pressure;
}

KeyResults static_results(const Prepared& prepared) {
  const statics::RaceResult& solution = prepared.race_result();
  static constexpr const char* kDirections[] = {"x", "y", "z", "about_y", "about_z"};
  KeyResults out;
  for (std::size_t k = 0; k < 5; ++k)
    out.emplace_back(fmt::format("displacement_{}_{}", kDirections[k], k < 3 ? "m" : "rad"),
                     solution.displacement[k]);
  for (std::size_t k = 0; k < 5; ++k)
    out.emplace_back(fmt::format("load_{}_{}", kDirections[k], k < 3 ? "N" : "Nm"),
                     solution.load[k]);
  out.emplace_back("largest_contact_load_N", solution.max_load);
  out.emplace_back("largest_pressure_Pa", largest_pressure(prepared));
  for (std::size_t k = 0; k < 5; ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    out.emplace_back(
        fmt::format("stiffness_{}_{}", kDirections[k], k < 3 ? "N_per_m" : "Nm_per_rad"),
        solution.stiffness(i, i));
  }
  return out;
}

KeyResults dynamic_results(const Snapshot& last, const results::Averages& averages,
                           const results::MeanLoad& carried) {
  double load = 0.0, slip = 0.0;
  for (const scene::ElementSnapshot& element : last.elements)
    for (const scene::RaceContactSnapshot& contact : element.race) {
      load = std::max(load, contact.load);
      slip = std::max(slip, contact.max_slip);
    }
  return {{"time_s", last.time},
          {"revolutions", last.shaft_rotation / (2.0 * std::numbers::pi)},
          {"largest_contact_load_N", load},
          {"largest_slip_m_per_s", slip},
          {"power_loss_W", last.power.total_loss},
          {"mean_power_loss_W", averages.power_loss},
          {"mean_orbital_ratio", averages.orbital_ratio},
          {"mean_cage_ratio", averages.cage_ratio},
          {"mean_whirl_ratio", averages.whirl_ratio},
          {"mean_load_x_N", carried.mean[0]},
          {"mean_load_y_N", carried.mean[1]},
          {"mean_load_z_N", carried.mean[2]},
          {"load_departure", carried.departure()},
          {"energy_residual_J", last.energy.residual()}};
}

}  // namespace

/// The open files of one run and what they need to go on.
struct RunOutputs::Impl {
  const Prepared& prepared;
  std::string request;
  bool overwrite;
  const setup::RunControl& control;
  fs::path folder;
  scene::ScenePlan plan;
  deck::UnitSystem units;
  results::ChannelRecorder recorder;
  results::RunAverages averages;
  LifeObserver life;
  std::vector<results::SolWriter> elements;  ///< SOL1..SOL6
  std::optional<results::SolWriter> power;   ///< SOL7
  std::optional<results::Sol8Writer> animation;
  std::optional<listing::PrintFile> print;
  std::optional<results::H5Writer> all;  ///< RESULTS.h5
  std::uintmax_t print_bytes = 0;        ///< of a listing that is continued
  /// What the ledgers of a continued run began with, and their residual where it goes on.
  struct LedgerStart {
    double stored = 0.0, residual = 0.0;  ///< [J]
    Eigen::Vector3d linear, angular;      ///< [N s, N m s]
  };
  std::optional<LedgerStart> ledger_start;
  Snapshot last;  ///< last stored instant
  std::vector<double> last_y;
  std::vector<fs::path> written;
  std::vector<Issue> remarks;
  std::vector<std::pair<std::string, double>> key_results;
  Clock::time_point checkpoint = Clock::now();
  long plotted = -1, animated = -1, printed = -1, saved = -1;  ///< last step in each kind of file
  long lived = -1;                                             ///< last step of the life models
  long segment = 0;                                            ///< step from which maxStps counts
  long restart_step = -1;                                      ///< of the last checkpoint
  int cage_position = -1;      ///< first component of the cage's mass centre
  double turned_before = 0.0;  ///< rotation of the shaft beyond speed times time [rad]

  Impl(const Prepared& p, fs::path f, std::string r, bool o)
      : prepared(p),
        request(std::move(r)),
        overwrite(o),
        control(p.control),
        folder(std::move(f)),
        plan(p.plan),
        units(p.input.deck.units()),
        recorder(p.bearing, units, results::ChannelTable(dynamics::energy_terms())),
        life(p.bearing, p.life.parameters) {}

  [[nodiscard]] fs::path path(const std::string& name) const { return folder / name; }
  [[nodiscard]] fs::path sol_path(std::size_t number) const {
    return folder / control.sol_files[number - 1];
  }

  [[nodiscard]] double shaft_speed() const {
    return prepared.bearing.speed[1] - prepared.bearing.speed[0];
  }
  void remark(std::string text, Severity severity = Severity::Note) {
    Issue issue;
    issue.severity = severity;
    issue.file = prepared.input.path.string();
    issue.message = std::move(text);
    remarks.push_back(std::move(issue));
  }
  [[nodiscard]] int cages() const { return prepared.bearing.cage ? 1 : 0; }
  [[nodiscard]] bool writes_animation() const;
  [[nodiscard]] Outputs outputs() const;
  void check_files() const;
  void open_files(bool continued);
  void make_room();
  void print_front(const std::optional<scene::Scales>& scales);
  [[nodiscard]] results::FinalState final_state(const dynamics::System& system, const Snapshot& at,
                                                std::span<const double> y) const;
  [[nodiscard]] listing::StaticSummary static_summary(bool dynamic) const;
  void write_restart(const dynamics::System& system, const Snapshot& at, std::span<const double> y,
                     const Resume& resume);
  void save_progress(std::map<std::string, double>& state, const Snapshot& at,
                     const Resume& resume) const;
  void restore_progress(const results::MasterState& master, StartPoint& out);
  void restore_ledgers(const results::MasterState& master);
  [[nodiscard]] Snapshot snapshot(dynamics::System& system, const RunPoint& point) const;
  [[nodiscard]] double static_elastic() const;
  [[nodiscard]] results::MeanLoad mean_load() const {
    return results::mean_load(averages.averages(), prepared.bearing);
  }
  [[nodiscard]] results::RunSummary summary_of_deck() const;
  void close(results::RunSummary& run, const std::optional<listing::RunLife>& run_life = {});
};

/// What this run will write, and what it reads.
Outputs RunOutputs::Impl::outputs() const {
  Outputs out;
  out.folder = folder;
  out.inputs = {prepared.input.path, prepared.input.path.parent_path() / "ADORE.json"};
  out.names = {"PRINT.txt", "RUN.json"};
  if (!control.dynamic) return out;
  for (std::size_t k = 0; k < control.monitored.size() && k < 6; ++k)
    out.names.push_back(control.sol_files[k]);
  out.names.push_back(control.sol_files[6]);
  if (writes_animation()) out.names.push_back(control.sol_files[7]);
  if (prepared.options.results_h5) out.names.push_back("RESULTS.h5");
  out.names.push_back(control.final_file);
  out.names.push_back(control.master_file);
  return out;
}

/// Refuses to continue files of another run or layout, before any of them is touched (N3).
void RunOutputs::Impl::check_files() const {
  listing::PrintFile::check(path("PRINT.txt"), prepared.bearing.run_id);
  const auto check = [&](std::size_t number, int index) {
    results::SolWriter::check(sol_path(number),
                              results::make_sol_header(prepared.bearing, index, units));
  };
  for (std::size_t k = 0; k < control.monitored.size() && k < 6; ++k)
    check(k + 1, control.monitored[k]);
  check(7, 0);
  if (prepared.options.results_h5)
    results::H5Writer::check(path("RESULTS.h5"), prepared.bearing, recorder.table());
  if (writes_animation()) results::Sol8Writer::check(sol_path(8), prepared.bearing, units);
}

bool RunOutputs::Impl::writes_animation() const {
  return control.animate && !results::sol8_refusal(prepared.bearing.balls.count, cages());
}

void RunOutputs::Impl::make_room() {
  Outputs all_outputs = outputs();
  // Its state is the start; the first checkpoint takes its place.
  if (control.start != setup::StartState::Statics)
    std::erase(all_outputs.names, control.final_file);
  const fs::path away = facade::make_room(all_outputs);
  if (!away.empty())
    remark(fmt::format("results of an earlier run that this run does not write were moved into {}",
                       away.string()));
}

void RunOutputs::Impl::open_files(bool continued) {
  written.push_back(path("PRINT.txt"));
  print = continued ? listing::PrintFile::continue_after(path("PRINT.txt"), prepared.bearing.run_id,
                                                         units, print_bytes)
                    : listing::PrintFile::create(path("PRINT.txt"), prepared.bearing.run_id, units);
  const auto open = [&](std::size_t number, int index) {
    const results::SolHeader header = results::make_sol_header(prepared.bearing, index, units);
    written.push_back(sol_path(number));
    return continued ? results::SolWriter::continue_after(sol_path(number), header, units, plotted)
                     : results::SolWriter::create(sol_path(number), header, units);
  };
  for (std::size_t k = 0; k < control.monitored.size() && k < 6; ++k)
    elements.push_back(open(k + 1, control.monitored[k]));
  power = open(7, 0);
  if (prepared.options.results_h5) {
    written.push_back(path("RESULTS.h5"));
    all = continued
              ? results::H5Writer::continue_after(path("RESULTS.h5"), prepared.bearing,
                                                  recorder.table(), saved)
              : results::H5Writer::create(path("RESULTS.h5"), prepared.bearing, recorder.table());
  }
  if (!control.animate) return;
  if (const auto refusal = results::sol8_refusal(prepared.bearing.balls.count, cages())) {
    remark(*refusal);
    return;
  }
  written.push_back(sol_path(8));
  animation = continued ? results::Sol8Writer::continue_after(sol_path(8), prepared.bearing, units,
                                                              animated)
                        : results::Sol8Writer::create(sol_path(8), prepared.bearing, units);
}

results::FinalState RunOutputs::Impl::final_state(const dynamics::System& system,
                                                  const Snapshot& at,
                                                  std::span<const double> y) const {
  results::FinalState out;
  out.version = kProgramVersion;
  out.run_id = prepared.bearing.run_id;
  out.step = at.step;
  out.time = at.time;
  out.step_size = at.step_size;
  out.shaft_rotation = at.shaft_rotation;
  out.scales = system.scales();
  out.components = component_names(system);
  out.state.assign(y.begin(), y.end());
  deck::Deck deck = prepared.input.deck;
  deck.user_lines.clear();  // of user routines: any text
  out.deck = deck::write_deck(deck);
  return out;
}

/// Elastic energy of the contacts in the quasi-static solution that the run starts from [J].
double RunOutputs::Impl::static_elastic() const {
  double elastic = 0.0;
  for (const statics::StaticBall& ball : prepared.start.balls)
    for (std::size_t j = 0; j < 2; ++j)
      if (ball.Q[j] > 0.0) elastic += 0.4 * ball.Q[j] * ball.delta[j];
  return elastic;
}

namespace {

/// Names in MASTER.
constexpr std::string_view kStepper = "stepper ";
constexpr const char* kSubsteps = "substeps of the step under way";
constexpr const char* kSegment = "step from which maxStps counts";
constexpr const char* kPlotted = "last step in SOL1-SOL7";
constexpr const char* kAnimated = "last step in SOL8";
constexpr const char* kPrinted = "last step in PRINT";
constexpr const char* kSaved = "last step in RESULTS";
constexpr const char* kLived = "last step of the life models";
constexpr const char* kStored = "ledger stored at start";
constexpr const char* kResidual = "ledger residual";

/// The same ledger with another start.
template <class Value>
void set_start(scene::Ledger<Value>& ledger, const Value& start) {
  scene::Ledger<Value> out;
  for (const auto& item : ledger.items())
    out.add(*item.term, item.term->kind == scene::LedgerKind::Start ? start : item.value, item.race,
            item.rate);
  ledger = std::move(out);
}

std::string momentum_name(std::string_view kind, int axis) {
  return fmt::format("ledger {} momentum at start {}", kind, axis);
}

}  // namespace

/// What a continued run takes up beside the state: places in the files, and the stepper's memory,
/// which belongs to one method with its limits.
void RunOutputs::Impl::save_progress(std::map<std::string, double>& state, const Snapshot& at,
                                     const Resume& resume) const {
  state[kStored] = at.energy.sum(scene::LedgerKind::Start);
  state[kResidual] = at.energy.residual();
  for (int k = 0; at.momentum && k < 3; ++k) {
    state[momentum_name("linear", k)] = at.momentum->linear.sum(scene::LedgerKind::Start)[k];
    state[momentum_name("angular", k)] = at.momentum->angular.sum(scene::LedgerKind::Start)[k];
  }
  const auto whole = [&](const char* name, long value) {
    state[name] = static_cast<double>(value);
  };
  whole(kSubsteps, resume.substeps);
  whole(kSegment, segment);
  whole(kPlotted, plotted);
  whole(kAnimated, animated);
  whole(kPrinted, printed);
  whole(kSaved, saved);
  whole(kLived, lived);
  if (resume.memory.empty()) return;
  const std::string stem(kStepper);
  state[stem + "is " + control.integrator] = 1.0;
  state[stem + "tolerance"] = control.tolerance;
  state[stem + "minimum"] = control.step_minimum;
  state[stem + "maximum"] = control.step_maximum;
  for (const auto& [name, value] : resume.memory) state[stem + "memory " + name] = value;
}

/// The ledgers go on from what the run began with, to the last bit, while their residual is that of
/// MASTER; under other loads or speeds it jumps, and they begin anew.
void RunOutputs::Impl::restore_ledgers(const results::MasterState& master) {
  const std::map<std::string, double>& state = master.averages;
  if (state.count(kStored) == 0 || state.count(kResidual) == 0) return;
  const auto number = [&](const std::string& name) {
    const auto found = state.find(name);
    return found == state.end() ? 0.0 : found->second;
  };
  LedgerStart start;
  start.stored = number(kStored);
  start.residual = number(kResidual);
  for (int k = 0; k < 3; ++k) {
    start.linear[k] = number(momentum_name("linear", k));
    start.angular[k] = number(momentum_name("angular", k));
  }
  ledger_start = start;
}

Snapshot RunOutputs::Impl::snapshot(dynamics::System& system, const RunPoint& point) const {
  Snapshot out = system.snapshot(point.time, point.y);
  out.step = point.step;
  out.step_size = point.step_size;
  out.shaft_rotation += turned_before;
  if (!ledger_start) return out;
  set_start(out.energy, ledger_start->stored);
  if (out.momentum) {
    set_start<Eigen::Vector3d>(out.momentum->linear, ledger_start->linear);
    set_start<Eigen::Vector3d>(out.momentum->angular, ledger_start->angular);
  }
  return out;
}

void RunOutputs::Impl::restore_progress(const results::MasterState& master, StartPoint& out) {
  const std::map<std::string, double>& state = master.averages;
  const auto number = [&](const std::string& name, double otherwise) {
    const auto found = state.find(name);
    return found == state.end() ? otherwise : found->second;
  };
  const auto whole = [&](const char* name, long otherwise) {
    const double value = number(name, static_cast<double>(otherwise));
    return value >= -1.0 && value < 9e15 ? static_cast<long>(value) : otherwise;
  };
  out.resume.substeps = std::clamp(whole(kSubsteps, 0), 0L, control.substeps - 1L);
  out.segment = whole(kSegment, 0);
  // Older files hold the state of the last stored step.
  plotted = whole(kPlotted, out.step);
  animated = whole(kAnimated, out.step);
  printed = whole(kPrinted, out.step);
  saved = whole(kSaved, out.step);
  lived = whole(kLived, out.step);
  const std::string stem(kStepper), memory = stem + "memory ";
  if (number(stem + "is " + control.integrator, 0.0) != 1.0 ||
      number(stem + "tolerance", 0.0) != control.tolerance ||
      number(stem + "minimum", -1.0) != control.step_minimum ||
      number(stem + "maximum", -1.0) != control.step_maximum)
    return;
  for (auto at = state.lower_bound(memory); at != state.end() && at->first.starts_with(memory);
       ++at) {
    if (!std::isfinite(at->second))
      throw InputError(
          fmt::format("{}: \"{}\" is not finite; the file is damaged, restore it or "
                      "start again with --overwrite",
                      path(control.master_file).string(), at->first));
    out.resume.memory[at->first.substr(memory.size())] = at->second;
  }
}

void RunOutputs::Impl::write_restart(const dynamics::System& system, const Snapshot& at,
                                     std::span<const double> y, const Resume& resume) {
  if (all) all->flush();
  results::MasterState master;
  master.last = final_state(system, at, y);
  averages.save(master.averages);
  life.save(master.averages);
  recorder.save(master.averages);
  save_progress(master.averages, at, resume);
  const auto add = [&](const std::string& role, const results::GrowingFile& file) {
    master.files.push_back({role, file.path().filename().string(), file.bytes()});
  };
  add("PRINT", print->file());
  for (std::size_t k = 0; k < elements.size(); ++k)
    add(fmt::format("SOL{}", k + 1), elements[k].file());
  add("SOL7", power->file());
  if (animation) add("SOL8", animation->file());
  if (all) master.files.push_back({"RESULTS", "RESULTS.h5", 0});
  results::write_final(master.last, path(control.final_file));
  results::write_master(master, path(control.master_file));
  checkpoint = Clock::now();
  restart_step = at.step;
}

/// What RUN.json says of the deck before anything has run.
results::RunSummary RunOutputs::Impl::summary_of_deck() const {
  results::RunSummary out;
  out.run_id = prepared.bearing.run_id;
  out.deck_file = prepared.input.path.filename().string();
  out.plan = plan_json(plan, prepared.stability);
  out.stability = prepared.stability;
  out.request = request;
  for (const setup::OptionInfo& info : setup::run_option_list()) {
    const auto given = prepared.input.option_values.find(info.name);
    const bool set = given != prepared.input.option_values.end();
    out.options.emplace_back(info.name, set ? given->second : info.default_value);
  }
  out.defaults_used = deck::defaults_used(prepared.input.deck);
  out.no_part = prepared.no_part;
  for (const Issue& issue : prepared.input.warnings) out.notes.push_back(issue.text());
  for (const Issue& remark : remarks) out.notes.push_back(remark.text());
  for (const std::string& note : prepared.race_result().notes) out.notes.push_back(note);
  out.instruction_set = dynamics::race_contact_instruction_set();
  const bearing::Imperfections& imperfections = prepared.bearing.imperfections;
  if (imperfections.elements == bearing::ElementErrors::Random)
    out.seeds.emplace_back("geometric imperfections", static_cast<long>(imperfections.seed));
  out.imperfections = listing::imperfections_json(prepared.bearing);
  if (prepared.bearing.operating) {
    out.operating = listing::fits_json(*prepared.bearing.operating);
    if (prepared.bearing.cage) out.operating["cage"] = listing::cage_json(prepared.bearing);
  }
  out.life["quasi-static"] = listing::life_json(prepared.life);
  return out;
}

/// Of the equilibrium that PRINT.txt shows: a dynamic run's starts from frozen Hertz constants.
listing::StaticSummary RunOutputs::Impl::static_summary(bool dynamic) const {
  if (prepared.rollers) return listing::summarise(*prepared.rollers, prepared.bearing);
  return listing::summarise(dynamic ? prepared.start : prepared.statics, prepared.bearing);
}

/// Everything of PRINT.txt that is known before the first step.
void RunOutputs::Impl::print_front(const std::optional<scene::Scales>& scales) {
  print->front({prepared.input.deck, prepared.as_built, scales, summary_of_deck().options});
  std::vector<std::string> warnings;
  for (Issue issue : prepared.input.warnings) {
    issue.file.clear();  // the page is about one deck
    warnings.push_back(issue.text());
  }
  print->summary(static_summary(scales.has_value()), prepared.bearing, prepared.life, warnings);
  if (prepared.rollers)
    print->quasi_static(*prepared.rollers, prepared.bearing);
  else
    print->quasi_static(scales ? prepared.start : prepared.statics, prepared.bearing);
  if (prepared.bearing.operating) print->fits(prepared.bearing);
  if (control.stiffness) print->stiffness_table(prepared.stiffness, control.stiffness->share);
  print->life(prepared.life);
}

void RunOutputs::Impl::close(results::RunSummary& run,
                             const std::optional<listing::RunLife>& run_life) {
  written.push_back(path("RUN.json"));
  for (const fs::path& file : written) run.files.push_back(file.filename().string());
  print->ledgers(run, plan, run_life);
  results::write_run_json(run, path("RUN.json"));
}

RunOutputs::RunOutputs(const Prepared& prepared, const fs::path& folder, std::string request,
                       bool overwrite)
    : impl_(std::make_unique<Impl>(prepared, folder, std::move(request), overwrite)) {}
RunOutputs::~RunOutputs() = default;

void RunOutputs::remark(std::string text) { impl_->remark(std::move(text)); }

StartPoint RunOutputs::find_start(dynamics::System& system, setup::StartState start) {
  Impl& s = *impl_;
  StartPoint out;
  out.y = system.initial_state();
  std::error_code error;
  const bool master_exists = fs::exists(s.path(s.control.master_file), error);
  if (start == setup::StartState::Continue && !master_exists) {
    s.remark(fmt::format("kIcOpt = 1, and there is no {}: a new run from {}", s.control.master_file,
                         s.control.final_file));
    start = setup::StartState::FromFinal;
  }
  const auto compare = [&](const results::FinalState& stored, const fs::path& file) {
    for (Issue& note : compare_with_stored(stored.deck, s.prepared.input.deck, file, start))
      s.remarks.push_back(std::move(note));
  };
  if (start == setup::StartState::FromFinal) {
    const fs::path file = s.path(s.control.final_file);
    const results::FinalState from = results::read_final(file);
    results::check_bodies(from, component_names(system), file);
    compare(from, file);
    take_state(from, system, out.y);
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
    // Speeds may have changed: the shaft goes on from where it was.
    const double turned = master.last.shaft_rotation;
    const double beyond = turned - s.shaft_speed() * master.last.time;
    // Not what rounding leaves: runs under one speed join to the same bytes.
    out.turned_before = std::abs(beyond) > 1e-12 * std::abs(turned) ? beyond : 0.0;
    s.turned_before = out.turned_before;
    s.averages.restore(master.averages);
    s.life.restore(master.averages);
    s.recorder.restore(master.averages);
    s.restore_progress(master, out);
    s.restore_ledgers(master);
    const results::MasterFile* listing = master.file("PRINT");
    if (listing != nullptr) s.print_bytes = listing->bytes;
    out.complete = results::read_run_mark(s.path("RUN.json")).status == "done";
  }
  if (start == setup::StartState::Statics) {
    system.set_start(out.time, out.y);
    check_cage_start(s.prepared, system.snapshot(out.time, out.y));
  }
  if (out.continued) {
    check_names(s.outputs());
    s.check_files();
  } else {
    check_room(s.outputs(), s.overwrite);
  }
  return out;
}

void RunOutputs::open(dynamics::System& system, const StartPoint& start) {
  Impl& s = *impl_;
  system.set_start(start.time, start.y);
  s.plan.quadratures = system.layout().size() - system.layout().controlled_size();
  s.segment = start.segment;
  if (start.continued)
    remove_leftovers(s.outputs());
  else
    s.make_room();
  s.open_files(start.continued);
  if (!start.continued) s.print_front(system.scales());
  for (const dynamics::StateLayout::Group& group : system.layout().groups())
    if (group.name == "cage.position") s.cage_position = group.slice.first;
  s.last_y = start.y;
  // Should the process be killed, it says which run that was.
  results::RunSummary run = s.summary_of_deck();
  run.status = "running";
  run.integrator = s.control.integrator;
  run.tolerance = s.control.tolerance;
  for (const fs::path& file : s.written) run.files.push_back(file.filename().string());
  results::write_run_json(run, s.path("RUN.json"));
  if (!start.continued) return;
  // Until something is stored, the last page is of this point.
  const RunPoint here{start.step, start.time, start.step_size, start.y};
  s.last = s.snapshot(system, here);
  if (s.ledger_start && std::abs(s.last.energy.residual() - s.ledger_start->residual) >
                            1e-9 * results::energy_scale(s.last.energy)) {
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
  // No file gets a step twice: the last step may have met an interval already.
  const auto meets = [&](int every, long& last_written) {
    if (!(always || due(point.step, every)) || last_written == point.step) return false;
    last_written = point.step;
    return true;
  };
  const bool plot = meets(s.control.plot_every, s.plotted);
  const bool animate = s.control.animate && meets(s.control.animate_every, s.animated);
  const bool print = meets(s.control.print_every, s.printed);
  const bool life = meets(s.control.life_every, s.lived);
  if (!plot && !animate && !print && !life) return;
  s.last = s.snapshot(system, point);
  s.last_y.assign(point.y.begin(), point.y.end());
  if (life) s.life.observe(s.last);
  s.last.power.life_hours = s.life.hours();
  s.averages.add(s.last);
  const results::StepRecord& record = s.recorder.record(s.last);
  if (plot) {
    for (results::SolWriter& file : s.elements) file.write(record);
    s.power->write(record);
  }
  if (animate && s.animation) s.animation->write(s.last);
  if (s.all && (plot || animate) && s.saved != point.step) {
    s.all->write(record);
    s.saved = point.step;
  }
  if (print)
    s.print->step(s.last, record, s.prepared.bearing, s.averages.averages(), s.control.print_option,
                  s.life.step());
}

void RunOutputs::follow(const RunPoint& point) {
  Impl& s = *impl_;
  if (s.cage_position < 0) return;
  const double* c = point.y.data() + s.cage_position;
  s.averages.add_cage_position({c[0], c[1], c[2]});
}

bool RunOutputs::checkpoint_due() const {
  return std::chrono::duration<double>(Clock::now() - impl_->checkpoint).count() >=
         impl_->prepared.options.checkpoint_seconds;
}

void RunOutputs::checkpoint(dynamics::System& system, const RunPoint& point, Resume resume) {
  impl_->write_restart(system, impl_->snapshot(system, point), point.y, resume);
}

void RunOutputs::store_end(dynamics::System& system, const RunEnd& end) {
  Impl& s = *impl_;
  switch (end.status) {
    case RunStatus::Done:
    case RunStatus::Untrusted:
      store(system, end.point, true);
      checkpoint(system, end.point, end.resume);
      break;
    case RunStatus::Interrupted: {
      // The point at which somebody lost patience is shown, and gone when the run goes on.
      checkpoint(system, end.point, end.resume);
      RunPoint shown = end.point;
      if (end.resume.substeps > 0) ++shown.step;
      store(system, shown, true);
      results::write_final(s.final_state(system, s.last, s.last_y), s.path(s.control.final_file));
      break;
    }
    case RunStatus::Failed:
      // The failed state may be meaningless.
      if (s.last.step > s.restart_step && !s.last_y.empty())
        s.write_restart(system, s.last, s.last_y, {});
      break;
  }
}

void RunOutputs::finish(dynamics::System& system, const RunEnd& end) {
  Impl& s = *impl_;
  s.written.push_back(s.path(s.control.final_file));
  s.written.push_back(s.path(s.control.master_file));
  if (const long missed = end.counters.at_minimum; missed > 0) {
    const double share =
        100.0 * static_cast<double>(missed) / static_cast<double>(std::max(1L, end.counters.steps));
    s.remark(
        fmt::format("{} of {} steps ({:.2g} %) missed the tolerance of {:g}: the smallest step "
                    "that record 2.1 allows is too long for it; make stpMin smaller, or tol "
                    "larger",
                    missed, end.counters.steps, share, s.control.tolerance),
        Severity::Warning);
  }
  results::RunSummary run = s.summary_of_deck();
  run.status = status_word(end.status);
  run.message = end.message;
  run.scales = system.scales();
  run.integrator = s.control.integrator;
  run.tolerance = s.control.tolerance;
  run.steps = s.last.step;
  run.time = s.last.time;
  run.revolutions = s.last.shaft_rotation / (2.0 * std::numbers::pi);
  const integrators::Counters& c = end.counters;
  run.counters = {{"steps", c.steps},
                  {"rejected", c.rejected},
                  {"evaluations", c.evaluations},
                  {"at_minimum", c.at_minimum},
                  {"restarts", c.restarts},
                  {"jacobians", c.jacobians},
                  {"nonlinear_iterations", c.nonlinear_iterations}};
  if (s.plan.has(scene::Effect::LightLoadBalance))
    run.counters.emplace_back("changes of held elements", end.held_changes);
  run.energy = s.last.energy;
  run.load = s.mean_load();
  run.elastic = s.static_elastic();
  if (s.last.momentum) run.momentum = results::momentum_items(*s.last.momentum);
  run.max_quaternion_error = s.last.max_quaternion_error;
  run.quadrature_error = system.quadrature_error(s.last.time, s.last_y);
  run.cost = system.cost().rows();
  run.seconds = end.loop_seconds;
  s.key_results = dynamic_results(s.last, s.averages.averages(), s.mean_load());
  add_lives(s.key_results, s.prepared.life);
  const listing::RunLife run_life = s.life.run_life();
  if (run_life.damage.seconds() > 0.0)
    s.key_results.emplace_back("run_life_hours", run_life.damage.life_hours(run_life.slopes));
  run.summary = s.key_results;
  run.life["run"] = listing::run_life_json(run_life);
  s.close(run, run_life);
}

std::vector<std::string> RunOutputs::write_quasi_static() {
  Impl& s = *impl_;
  check_room(s.outputs(), s.overwrite);
  s.make_room();
  s.written.push_back(s.path("PRINT.txt"));
  s.print = listing::PrintFile::create(s.path("PRINT.txt"), s.prepared.bearing.run_id, s.units);
  s.print_front(std::nullopt);
  results::RunSummary run = s.summary_of_deck();
  run.status = "done";
  s.key_results = static_results(s.prepared);
  if (s.prepared.bearing.operating)
    for (auto& item : listing::fits_summary(*s.prepared.bearing.operating))
      s.key_results.push_back(std::move(item));
  add_lives(s.key_results, s.prepared.life);
  run.summary = s.key_results;
  results::StaticTables tables =
      s.prepared.rollers ? listing::static_tables(*s.prepared.rollers, s.prepared.bearing, s.units)
                         : listing::static_tables(s.prepared.statics, s.prepared.bearing, s.units);
  if (s.prepared.rollers)
    listing::add_cut(tables, *s.prepared.rollers, s.prepared.bearing);
  else
    listing::add_cut(tables, s.prepared.statics, s.prepared.bearing);
  if (!s.prepared.stiffness.empty())
    tables.tables.push_back(listing::stiffness_over_speed(s.prepared.stiffness));
  run.quasi_static = results::to_json(tables);
  s.close(run);
  return listing::summary_lines(s.static_summary(false), s.prepared.bearing, s.prepared.life,
                                s.units);
}

std::vector<fs::path> RunOutputs::files() const { return impl_->written; }

std::vector<std::pair<std::string, double>> RunOutputs::summary() const {
  return impl_->key_results;
}

results::EnergyJudgement RunOutputs::judge_energy() const {
  return results::judge_energy(impl_->last.energy, impl_->static_elastic());
}

std::string RunOutputs::load_warning() const {
  return results::load_warning(impl_->mean_load(), impl_->units);
}
std::vector<Issue> RunOutputs::remarks() const { return impl_->remarks; }

double RunOutputs::energy_residual() const { return impl_->last.energy.residual(); }

double RunOutputs::energy_scale() const { return results::energy_scale(impl_->last.energy); }

}  // namespace adore::facade
