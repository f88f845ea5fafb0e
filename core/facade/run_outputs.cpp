#include "facade/run_outputs.hpp"

#include "base/errors.hpp"
#include "base/version.hpp"
#include "dynamics/race_contacts.hpp"
#include "facade/life_observer.hpp"
#include "facade/plan_json.hpp"
#include "life/statistics.hpp"
#include "results/averages.hpp"
#include "results/channels.hpp"
#include "results/continuation.hpp"
#include "results/print_cage.hpp"
#include "results/print_file.hpp"
#include "results/print_fits.hpp"
#include "results/print_imperfections.hpp"
#include "results/restart.hpp"
#include "results/results_h5.hpp"
#include "results/run_json.hpp"
#include "results/sol_writer.hpp"
#include "results/static_cut.hpp"
#include "results/static_summary.hpp"
#include "results/static_tables.hpp"

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
using dynamics::Snapshot;

std::vector<std::string> component_names(const dynamics::System& system) {
  std::vector<std::string> out;
  for (int i = 0; i < system.layout().size(); ++i) out.push_back(system.layout().component_name(i));
  return out;
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

KeyResults dynamic_results(const Snapshot& last, const results::Averages& averages) {
  double load = 0.0, slip = 0.0;
  for (const dynamics::ElementSnapshot& element : last.elements)
    for (const dynamics::RaceContactSnapshot& contact : element.race) {
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
          {"energy_residual_J", last.energy.residual()}};
}

}  // namespace

/// The open files of one run and what they need to go on.
struct RunOutputs::Impl {
  const Prepared& prepared;
  const build::RunControl& control;
  fs::path folder;
  dynamics::ScenePlan plan;
  deck::UnitSystem units;
  results::ChannelRecorder recorder;
  results::RunAverages averages;
  LifeObserver life;
  std::vector<results::SolWriter> elements;  ///< SOL1..SOL6
  std::optional<results::SolWriter> power;   ///< SOL7
  std::optional<results::Sol8Writer> animation;
  std::optional<results::PrintFile> print;
  std::optional<results::H5Writer> all;  ///< RESULTS.h5
  Snapshot last;                         ///< last stored instant
  std::vector<double> last_y;
  std::vector<fs::path> written;
  std::vector<std::string> remarks;
  std::vector<std::pair<std::string, double>> key_results;
  Clock::time_point checkpoint = Clock::now();
  long plotted = -1, animated = -1, printed = -1, saved = -1;  ///< last step in each kind of file
  long lived = -1;                                             ///< last step of the life models
  int cage_position = -1;  ///< first component of the cage's mass centre

  Impl(const Prepared& p, fs::path f)
      : prepared(p),
        control(p.control),
        folder(std::move(f)),
        plan(p.plan),
        units(p.input.deck.units()),
        recorder(p.bearing, units),
        life(p.bearing, p.life.parameters) {}

  [[nodiscard]] fs::path path(const std::string& name) const { return folder / name; }
  [[nodiscard]] fs::path sol_path(std::size_t number) const {
    return folder / control.sol_files[number - 1];
  }

  [[nodiscard]] int cages() const { return prepared.bearing.cage ? 1 : 0; }
  [[nodiscard]] bool writes_animation() const;
  void check_files() const;
  void open_files(bool continued, long last_step, std::uintmax_t print_bytes);
  void print_front(const std::optional<dynamics::Scales>& scales);
  [[nodiscard]] results::FinalState final_state(const dynamics::System& system) const;
  [[nodiscard]] results::StaticSummary static_summary(bool dynamic) const;
  void write_restart(const dynamics::System& system);
  [[nodiscard]] results::RunSummary summary_of_deck() const;
  void close(results::RunSummary& run, const std::optional<results::RunLife>& run_life = {});
};

/// Refuses to continue files of another run or layout, before any of them is touched (N3).
void RunOutputs::Impl::check_files() const {
  results::PrintFile::check(path("PRINT.txt"), prepared.bearing.run_id);
  const auto check = [&](std::size_t number, int index) {
    results::SolWriter::check(sol_path(number),
                              results::make_sol_header(prepared.bearing, index, units));
  };
  for (std::size_t k = 0; k < control.monitored.size() && k < 6; ++k)
    check(k + 1, control.monitored[k]);
  check(7, 0);
  if (prepared.options.results_h5) results::H5Writer::check(path("RESULTS.h5"), prepared.bearing);
  if (writes_animation()) results::Sol8Writer::check(sol_path(8), prepared.bearing, units);
}

bool RunOutputs::Impl::writes_animation() const {
  return control.animate && !results::sol8_refusal(prepared.bearing.balls.count, cages());
}

void RunOutputs::Impl::open_files(bool continued, long last_step, std::uintmax_t print_bytes) {
  if (continued) check_files();
  written.push_back(path("PRINT.txt"));
  print = continued ? results::PrintFile::continue_after(path("PRINT.txt"), prepared.bearing.run_id,
                                                         units, print_bytes)
                    : results::PrintFile::create(path("PRINT.txt"), prepared.bearing.run_id, units);
  const auto open = [&](std::size_t number, int index) {
    const results::SolHeader header = results::make_sol_header(prepared.bearing, index, units);
    written.push_back(sol_path(number));
    return continued
               ? results::SolWriter::continue_after(sol_path(number), header, units, last_step)
               : results::SolWriter::create(sol_path(number), header, units);
  };
  for (std::size_t k = 0; k < control.monitored.size() && k < 6; ++k)
    elements.push_back(open(k + 1, control.monitored[k]));
  power = open(7, 0);
  if (prepared.options.results_h5) {
    written.push_back(path("RESULTS.h5"));
    all = continued
              ? results::H5Writer::continue_after(path("RESULTS.h5"), prepared.bearing, last_step)
              : results::H5Writer::create(path("RESULTS.h5"), prepared.bearing);
  }
  if (!control.animate) return;
  if (const auto refusal = results::sol8_refusal(prepared.bearing.balls.count, cages())) {
    remarks.push_back(*refusal);
    return;
  }
  written.push_back(sol_path(8));
  animation = continued ? results::Sol8Writer::continue_after(sol_path(8), prepared.bearing, units,
                                                              last_step)
                        : results::Sol8Writer::create(sol_path(8), prepared.bearing, units);
}

results::FinalState RunOutputs::Impl::final_state(const dynamics::System& system) const {
  results::FinalState out;
  out.version = kProgramVersion;
  out.run_id = prepared.bearing.run_id;
  out.step = last.step;
  out.time = last.time;
  out.step_size = last.step_size;
  out.shaft_rotation = last.shaft_rotation;
  out.scales = system.scales();
  out.components = component_names(system);
  out.state = last_y;
  return out;
}

void RunOutputs::Impl::write_restart(const dynamics::System& system) {
  if (all) all->flush();
  results::MasterState master;
  master.last = final_state(system);
  averages.save(master.averages);
  life.save(master.averages);
  recorder.save(master.averages);
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
}

/// What RUN.json says of the deck before anything has run.
results::RunSummary RunOutputs::Impl::summary_of_deck() const {
  results::RunSummary out;
  out.run_id = prepared.bearing.run_id;
  out.deck_file = prepared.input.path.filename().string();
  out.plan = plan_json(plan);
  for (const build::OptionInfo& info : build::run_option_list()) {
    const auto given = prepared.input.option_values.find(info.name);
    const bool set = given != prepared.input.option_values.end();
    out.options.emplace_back(info.name, set ? given->second : info.default_value);
  }
  out.defaults_used = deck::defaults_used(prepared.input.deck);
  for (const Issue& issue : prepared.input.warnings) out.notes.push_back(issue.text());
  for (const std::string& remark : remarks) out.notes.push_back(remark);
  for (const std::string& note : prepared.race_result().notes) out.notes.push_back(note);
  out.instruction_set = dynamics::race_contact_instruction_set();
  const bearing::Imperfections& imperfections = prepared.bearing.imperfections;
  if (imperfections.elements == bearing::ElementErrors::Random)
    out.seeds.emplace_back("geometric imperfections", static_cast<long>(imperfections.seed));
  out.imperfections = results::imperfections_json(prepared.bearing);
  if (prepared.bearing.operating) {
    out.operating = results::fits_json(*prepared.bearing.operating);
    if (prepared.bearing.cage) out.operating["cage"] = results::cage_json(prepared.bearing);
  }
  out.life["quasi-static"] = results::life_json(prepared.life);
  return out;
}

/// Of the equilibrium that PRINT.txt shows: a dynamic run's starts from frozen Hertz constants.
results::StaticSummary RunOutputs::Impl::static_summary(bool dynamic) const {
  if (prepared.rollers) return results::summarise(*prepared.rollers, prepared.bearing);
  return results::summarise(dynamic ? prepared.start : prepared.statics, prepared.bearing);
}

/// Everything of PRINT.txt that is known before the first step.
void RunOutputs::Impl::print_front(const std::optional<dynamics::Scales>& scales) {
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
                             const std::optional<results::RunLife>& run_life) {
  written.push_back(path("RUN.json"));
  for (const fs::path& file : written) run.files.push_back(file.filename().string());
  print->ledgers(run, plan, run_life);
  results::write_run_json(run, path("RUN.json"));
}

RunOutputs::RunOutputs(const Prepared& prepared, const fs::path& folder)
    : impl_(std::make_unique<Impl>(prepared, folder)) {}
RunOutputs::~RunOutputs() = default;

StartPoint RunOutputs::begin(dynamics::System& system, build::StartState start) {
  Impl& s = *impl_;
  StartPoint out;
  out.y = system.initial_state();
  std::uintmax_t print_bytes = 0;
  std::error_code error;
  const bool master_exists = fs::exists(s.path(s.control.master_file), error);
  if (start == build::StartState::Continue && !master_exists) {
    s.remarks.push_back(fmt::format("kIcOpt = 1, and there is no {}: a new run from {}",
                                    s.control.master_file, s.control.final_file));
    start = build::StartState::FromFinal;
  }
  if (start == build::StartState::FromFinal) {
    const results::FinalState from = results::read_final(s.path(s.control.final_file));
    take_state(from, system, out.y);
  } else if (start == build::StartState::Continue) {
    const results::MasterState master = results::read_master(s.path(s.control.master_file));
    results::check_run_id(s.path(s.control.master_file), master.last.run_id,
                          s.prepared.bearing.run_id);
    results::check_layout(master.last, component_names(system), s.path(s.control.master_file));
    system.set_scales(master.last.scales);
    out.y = master.last.state;
    out.time = master.last.time;
    out.step = master.last.step;
    out.step_size = master.last.step_size;
    out.continued = true;
    s.averages.restore(master.averages);
    s.life.restore(master.averages);
    s.recorder.restore(master.averages);
    const results::MasterFile* listing = master.file("PRINT");
    if (listing != nullptr) print_bytes = listing->bytes;
  }
  system.set_start(out.time, out.y);
  s.plan.quadratures = system.layout().size() - system.layout().controlled_size();
  s.open_files(out.continued, out.step, print_bytes);
  if (!out.continued) s.print_front(system.scales());
  for (const dynamics::StateLayout::Group& group : system.layout().groups())
    if (group.name == "cage.position") s.cage_position = group.slice.first;
  s.last_y = out.y;
  return out;
}

bool RunOutputs::wants(long step) const {
  const build::RunControl& c = impl_->control;
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
  s.last = system.snapshot(point.time, point.y);
  s.last.step = point.step;
  s.last.step_size = point.step_size;
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
    s.print->step(s.last, record, s.prepared.bearing, s.averages.averages(),
                  s.control.print_option);
}

void RunOutputs::write_first_checkpoint(dynamics::System& system) { impl_->write_restart(system); }

void RunOutputs::checkpoint_if_due(dynamics::System& system, const RunPoint& point) {
  Impl& s = *impl_;
  if (s.cage_position >= 0) {
    const double* c = point.y.data() + s.cage_position;
    s.averages.add_cage_position({c[0], c[1], c[2]});
  }
  if (std::chrono::duration<double>(Clock::now() - s.checkpoint).count() <
      s.prepared.options.checkpoint_seconds)
    return;
  s.write_restart(system);
}

void RunOutputs::finish(dynamics::System& system, const RunEnd& end) {
  Impl& s = *impl_;
  s.write_restart(system);
  s.written.push_back(s.path(s.control.final_file));
  s.written.push_back(s.path(s.control.master_file));
  results::RunSummary run = s.summary_of_deck();
  run.status = end.status == RunStatus::Done          ? "done"
               : end.status == RunStatus::Interrupted ? "interrupted"
                                                      : "failed";
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
  if (s.plan.has(dynamics::Effect::LightLoadBalance))
    run.counters.emplace_back("changes of held elements", end.held_changes);
  run.energy = s.last.energy;
  if (s.last.momentum) run.momentum = results::momentum_items(*s.last.momentum);
  run.max_quaternion_error = s.last.max_quaternion_error;
  run.quadrature_error = system.quadrature_error(s.last.time, s.last_y);
  run.cost = system.cost().rows();
  run.seconds = end.loop_seconds;
  s.key_results = dynamic_results(s.last, s.averages.averages());
  add_lives(s.key_results, s.prepared.life);
  const results::RunLife run_life = s.life.run_life();
  if (run_life.damage.seconds() > 0.0)
    s.key_results.emplace_back("run_life_hours", run_life.damage.life_hours(run_life.slopes));
  run.summary = s.key_results;
  run.life["run"] = results::run_life_json(run_life);
  s.close(run, run_life);
}

std::vector<std::string> RunOutputs::write_quasi_static() {
  Impl& s = *impl_;
  s.written.push_back(s.path("PRINT.txt"));
  s.print = results::PrintFile::create(s.path("PRINT.txt"), s.prepared.bearing.run_id, s.units);
  s.print_front(std::nullopt);
  results::RunSummary run = s.summary_of_deck();
  run.status = "done";
  s.key_results = static_results(s.prepared);
  if (s.prepared.bearing.operating)
    for (auto& item : results::fits_summary(*s.prepared.bearing.operating))
      s.key_results.push_back(std::move(item));
  add_lives(s.key_results, s.prepared.life);
  run.summary = s.key_results;
  results::StaticTables tables =
      s.prepared.rollers ? results::static_tables(*s.prepared.rollers, s.prepared.bearing, s.units)
                         : results::static_tables(s.prepared.statics, s.prepared.bearing, s.units);
  if (s.prepared.rollers)
    results::add_cut(tables, *s.prepared.rollers, s.prepared.bearing);
  else
    results::add_cut(tables, s.prepared.statics, s.prepared.bearing);
  if (!s.prepared.stiffness.empty())
    tables.tables.push_back(results::stiffness_over_speed(s.prepared.stiffness));
  run.quasi_static = results::to_json(tables);
  s.close(run);
  return results::summary_lines(s.static_summary(false), s.prepared.bearing, s.prepared.life,
                                s.units);
}

std::vector<fs::path> RunOutputs::files() const { return impl_->written; }

std::vector<std::pair<std::string, double>> RunOutputs::summary() const {
  return impl_->key_results;
}

double RunOutputs::energy_residual() const { return impl_->last.energy.residual(); }

double RunOutputs::energy_scale() const { return results::energy_scale(impl_->last.energy); }

}  // namespace adore::facade
