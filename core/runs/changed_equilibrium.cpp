#include "runs/changed_equilibrium.hpp"

#include "runs/continued_deck.hpp"
#include "runs/ring_growth.hpp"
#include "runs/stored_races.hpp"
#include "runs/thermal_run.hpp"
#include "scene/user_laws.hpp"

#include <fmt/format.h>

#include <utility>

namespace adore::runs {

std::string user_routine_motion_text(const Prepared& prepared) {
  const auto& laws = prepared.options.system.user;
  return laws && laws->motion != nullptr ? "routine ADRX1 specifies loads or motions of the races, "
                                           "which the equilibrium does not include"
                                         : std::string();
}

std::string user_routine_jumps_text(const Prepared& prepared) {
  const auto& laws = prepared.options.system.user;
  if (!laws || laws->motion == nullptr) return {};
  const scene::UserMotion::MotionDeclaration& motion_declaration =
      laws->motion->motion_declaration();
  std::string out;
  const auto add = [&](const std::string& text) { out += (out.empty() ? "" : "; ") + text; };
  for (const double kink : motion_declaration.kinks)
    if (kink > 0.0) add(fmt::format("the loads jump at t = {:.4g} s", kink));
  for (std::size_t j = 0; j < 2; ++j) {
    const char* const race = j == 0 ? "outer" : "inner";
    if (const double speed = motion_declaration.start_velocity[j].norm(); speed > 0.0)
      add(fmt::format("the {} race starts with {:.4g} m/s", race, speed));
    if (motion_declaration.start_spin[j] != 0.0)
      add(fmt::format("the {} race starts with an additional speed of {:.4g} rad/s", race,
                      motion_declaration.start_spin[j]));
  }
  return out.empty() ? out
                     : "routine ADRX1 specifies jumps of loads or speeds, which do not count as "
                       "excess energy: " +
                           out;
}

Finding excess_energy_finding(const std::string& text, double ratio) {
  return make_finding("run.start_excess", text)
      .measure(100.0 * ratio, 100.0 * dynamics::kExcessWarned);
}

std::optional<Finding> equilibrium_change_finding(const dynamics::EquilibriumChange& change,
                                                  const std::string& cause,
                                                  const std::string& specified) {
  if (!change.why_not.empty())
    return make_finding("run.start_excess",
                        fmt::format("{}: {}, so the stored state is kept unchanged. The next "
                                    "revolutions contain a vibration",
                                    cause, change.why_not));
  const double ratio = change.ratio();
  if (!(ratio > dynamics::kExcessWarned)) return std::nullopt;
  const std::string text = fmt::format(
      "{}: excess energy = {:.3g} J, {:.0f} % of the elastic energy of the equilibrium ({:.3g} J)",
      cause, change.excess, 100.0 * ratio, change.elastic);
  if (!specified.empty())
    return excess_energy_finding(text + ": " + specified + "; the run continues", ratio);
  if (ratio > dynamics::kExcessRefused)
    throw SolverError(text +
                      ": this change of the bearing acts like an impact on the contacts. Change "
                      "the bearing in smaller steps, or start from the equilibrium (kIcOpt = 0)");
  return excess_energy_finding(text + ", so the loads of the next revolutions contain a vibration",
                               ratio);
}

dynamics::EquilibriumContext moving_scene(const Prepared& prepared, dynamics::System& system) {
  statics::BallStaticsOptions balls = ball_statics_options(prepared);
  balls.curvature = prepared.options.system.moving_angle ? statics::Curvature::Potential
                                                         : statics::Curvature::Fixed;
  balls.fixed_angle = prepared.fixed_angle;
  return {system, prepared.plan, balls, prepared.options.rollers};
}

void copy_state(const results::FinalState& from, const dynamics::System& system,
                std::vector<double>& y) {
  std::map<std::string, double> stored;
  for (std::size_t i = 0; i < from.components.size(); ++i)
    stored[from.components[i]] = from.state[i];
  for (int i = 0; i < system.layout().controlled_size(); ++i) {
    const auto found = stored.find(system.layout().component_name(i));
    if (found != stored.end()) y[static_cast<std::size_t>(i)] = found->second;
  }
}

StoredScene stored_scene(const results::FinalState& stored,
                         const std::map<std::string, double>& thermal, const Prepared& now,
                         const std::filesystem::path& file) {
  LoadedDeck input;
  input.path = file;
  input.deck = read_stored_deck(stored.deck, file);
  input.deck.set("kStif", "0");
  input.option_values = now.input.option_values;
  input.user = now.input.user;
  input.routines = now.input.routines;
  StoredScene out{prepare(std::move(input)), nullptr, stored.time, {}};
  if (out.prepared.bearing.thermal && !thermal.empty()) {
    ThermalRun run(out.prepared);
    if (run.restore(thermal, file)) (void)move_to(out.prepared, run.operating());
  }
  out.system = std::make_unique<dynamics::System>(make_system(out.prepared));
  if (const RingGrowth growth(out.prepared); growth.active()) {
    const dynamics::PrescribedRaces races =
        out.system->prescribed_races(out.time, out.system->initial_state());
    const std::array<double, 2> speed{races[0].speed, races[1].speed};
    apply_race_speeds(out.prepared, nullptr, growth.speeds(growth.levels(speed), speed));
    out.system = std::make_unique<dynamics::System>(make_system(out.prepared));
  }
  out.y = out.system->initial_state();
  copy_state(stored, *out.system, out.y);
  if (const auto races = stored_races(stored.extras)) out.system->go_on(*races, out.time, out.y);
  return out;
}

}  // namespace adore::runs
