#include "runs/ready_run.hpp"

#include "results/restart.hpp"
#include "runs/judge_steps.hpp"
#include "runs/key_results.hpp"
#include "runs/missed_tolerance.hpp"

#include <fmt/format.h>

namespace adore::runs {
namespace fs = std::filesystem;
namespace {

/// Above kMissedLimit loads may be some per cent off although the energy balance closes:
/// at 1e-3 up to 5 % of loads, 7 % of heat and 20 % of life (tests/hardcases/silent_errors.py,
/// decision 481).
void warn_about_tolerance(Prepared& prepared) {
  const setup::RunControl& control = prepared.control;
  if (control.tolerance <= kMissedLimit || control.step_minimum == control.step_maximum) return;
  add_remark(prepared,
             make_finding(
                 "run.loose_tolerance",
                 fmt::format(
                     "the tolerance of {:g} (tol on record 2.1, or --tol) is loose: errors may "
                     "reach 5 % in loads and 20 % in lives even if the energy balance closes. Use "
                     "{:g} or less for reliable results; `adore run --verify` estimates the errors",
                     control.tolerance, kMissedLimit))
                 .measure(control.tolerance, kMissedLimit));
}

/// The steps that the run takes. A change becomes a remark on the deck and part of its
/// plan.
/// @throws InputError when the method is refused.
StepLimits apply_step_limits(Prepared& prepared, double time_scale) {
  const StepJudgment steps = judge_steps(prepared, time_scale);
  if (steps.limits.action == StepAction::Refused) throw InputError(steps.text);
  prepared.stability = steps.text;
  if (steps.limits.action != StepAction::Kept)
    add_remark(prepared, make_finding("run.steps", steps.text));
  return steps.limits;
}

/// The deck's integrator. @throws InputError when it does not support the deck.
std::unique_ptr<integrators::Stepper> make_checked_stepper(const setup::RunControl& control,
                                                           const SystemOde& ode, bool held,
                                                           bool rollers) {
  auto stepper = integrators::make_stepper(control.integrator);
  if (stepper->name() == "arkode-imex" && rollers)
    throw InputError(
        "arkode-imex treats the normal contacts of balls and races implicitly, but not those of "
        "rollers; use arkode-dirk (intMet 32) or arkode-erk (intMet 31)");

  if (stepper->name() == "arkode-imex" && held)
    throw InputError(
        "arkode-imex does not support elements in force balance (qFac above 0 on record 2.1, or "
        "mode 1 or 2). Set qFac and mode to 0, or use arkode-dirk (intMet 32) or arkode-erk "
        "(intMet 31)");
  if (stepper->name() == "arkode-imex" && !ode.has_stiff_part())
    throw InputError(
        "arkode-imex treats the normal contacts of elements and races implicitly, but this deck "
        "has no such contacts; use arkode-dirk (intMet 32) or arkode-erk (intMet 31)");
  if (control.step_minimum == control.step_maximum && !stepper->can_hold_constant_step())
    throw InputError(
        fmt::format("record 2.1 specifies a constant step (stpMin = stpMax), which {} does not "
                    "support; use intMet 1-7, 11-18 or 31-32, or make stpMin smaller than stpMax",
                    stepper->name()));
  return stepper;
}

/// Temperatures and geometry of the continued run; false: it has none.
bool restore_thermal(ThermalRun& thermal, Prepared& prepared, const fs::path& master) {
  std::error_code error;
  if (!fs::exists(master, error)) return false;
  if (!thermal.restore(results::read_master(master).averages, master)) return false;
  for (const Finding& doubt : move_to(prepared, thermal.operating()))
    add_remark(prepared, renamed(doubt, "thermal.geometry", doubt.message));
  return true;
}

/// Geometry at the speeds of the stored instant; false: that of the start.
bool restore_growth(ReadyRun& run, Prepared& prepared) {
  std::error_code error;
  if (!fs::exists(run.master, error)) return false;
  const results::MasterState master = results::read_master(run.master);
  if (master.last.state.size() != static_cast<std::size_t>(run.system->layout().size()))
    return false;
  const dynamics::PrescribedRaces races =
      run.system->prescribed_races(master.last.time, master.last.state);
  const std::array<double, 2> speed{races[0].speed, races[1].speed};
  const RingGrowth::Levels levels = run.growth->levels(speed);
  if (levels == RingGrowth::Levels{}) return false;
  apply_race_speeds(prepared, run.thermal ? &*run.thermal : nullptr,
                    run.growth->speeds(levels, speed));
  return true;
}

/// Runs a function that may reject the deck's method: names intMet if no record is named and the
/// request does not specify a method.
template <class Check>
auto name_integrator(const RunRequest& request, const deck::Deck& deck, Check&& check) {
  try {
    return check();
  } catch (const InputError& error) {
    std::vector<Issue> issues = error.issues();
    for (Issue& issue : issues) {
      if (!issue.record.empty() || !request.integrator.empty()) continue;
      const Issue named = deck.issue(Severity::Error, "intMet", issue.message, issue.remedy);
      if (issue.file.empty()) issue.file = deck.file;
      issue.line = named.line;
      issue.record = named.record;
      issue.variable = named.variable;
      issue.value = named.value;
    }
    throw InputError(std::move(issues));
  }
}

}  // namespace

ReadyRun::ReadyRun(const RunRequest& request, Prepared& prepared, const RunPlace& place)
    : master(place.path / prepared.control.master_file) {
  const setup::StartState how =
      request.go_on ? setup::StartState::Continue : prepared.control.start;
  const double elastic =
      static_elastic_energy(prepared);  // as the first run had it, before thermal steps
  if (prepared.bearing.thermal) thermal.emplace(prepared);
  system.emplace(make_system(prepared));
  add_approximation_note(prepared.plan, *system);
  ode.emplace(*system, elastic);
  const deck::Deck& deck = prepared.input.deck;
  stepper = name_integrator(request, deck, [&] {
    return make_checked_stepper(
        prepared.control, *ode,
        prepared.plan.light_load_ratio > 0.0 || prepared.plan.has(scene::Effect::ElementBalance),
        prepared.plan.rollers);
  });
  time_scale = system->scales().time;
  span = run_span(request, prepared, time_scale);
  limits = name_integrator(request, deck, [&] { return apply_step_limits(prepared, time_scale); });
  warn_about_tolerance(prepared);
  if (request.go_on && !fs::exists(master))
    throw InputError(
        fmt::format("{}: there is no run to continue: no run was started here, or the run ended "
                    "before its first checkpoint. Start the run without --continue. Add "
                    "--overwrite if the folder still contains files of the earlier run",
                    master.string()));
  outputs.emplace(prepared, place, request_digest(request, prepared.input), request.overwrite);
  growth.emplace(prepared);
  // Times, limits and estimates above are those of the bearing of the deck at the start of
  // the run: a killed run continues with the same steps.
  thermal_restored =
      thermal && how == setup::StartState::Continue && restore_thermal(*thermal, prepared, master);
  if (thermal_restored) system.emplace(make_system(prepared));
  if (how == setup::StartState::Continue && growth->active() && restore_growth(*this, prepared))
    system.emplace(make_system(prepared));
  if (thermal) outputs->set_thermal_run(*thermal);
  start = outputs->find_start_point(*system, how);
}

}  // namespace adore::runs
