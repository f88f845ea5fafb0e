#include "runs/thermal_run.hpp"

#include "base/errors.hpp"
#include "dynamics/roller_start.hpp"
#include "statics/ball_friction.hpp"
#include "statics/element_places.hpp"
#include "statics/film_doubts.hpp"
#include "statics/kinematics.hpp"
#include "thermal/steady_state.hpp"
#include "thermal/too_cold.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace adore::runs {
namespace {

constexpr std::size_t kHistoryLength = 8;  ///< steps that assess_thermal_steps may look back

/// All heats as one list, for differences and files.
std::array<double, 8> list_of(const thermal::HeatSources& q) {
  return {q.race[0],   q.race[1],   q.land[0],      q.land[1],
          q.flange[0], q.flange[1], q.element_cage, q.churning};
}
thermal::HeatSources of_list(const std::array<double, 8>& v) {
  return {{v[0], v[1]}, {v[2], v[3]}, {v[4], v[5]}, v[6], v[7]};
}

std::string key(const char* what, std::size_t k) { return fmt::format("thermal.{}.{}", what, k); }

/// Of the cage, where there is none of the elements; at its epicyclic speed where it is free.
double cage_speed(const scene::Snapshot& at) {
  if (!at.cages.empty()) return at.cages.front().omega.x();
  double mean = 0.0;
  for (const scene::ElementSnapshot& element : at.elements)
    mean += element.theta_dot / static_cast<double>(at.elements.size());
  return mean;
}

}  // namespace

ThermalRun::ThermalRun(const Prepared& prepared)
    : as_built_bearing_(prepared.as_built),
      part_temperatures_(thermal::BulkTemperatures::in(prepared.as_built)),
      geometry_temperatures_(part_temperatures_),
      transient_(prepared.options.thermal_transient),
      thermal_time_ratio_(prepared.options.thermal_acceleration) {
  shown_.outside = part_temperatures_.race[0];
  shown_.bore = part_temperatures_.race[1];
  shown_.housing = shown_.housing_mean = part_temperatures_.housing;
  shown_.raceway = part_temperatures_.race;
  shown_.film.fill(std::numeric_limits<double>::quiet_NaN());  // of no network yet
  shown_.shaft_mean = part_temperatures_.shaft;
  shown_.medium = part_temperatures_.medium;
  shown_.coolant_in = shown_.coolant_out =
      as_built_bearing_.thermal->base == 2 || as_built_bearing_.thermal->base == 3
          ? as_built_bearing_.thermal->base_temperature
          : part_temperatures_.element;
  relaxation_.least = 0.2;
  relaxation_.most = 1.0;
  relaxation_.quiet = 0.5;
  relaxation_.averages = true;
  const auto field = part_temperatures_.list();
  history_.emplace_back(field.begin(), field.end());
}

thermal::HeatSources ThermalRun::sources(const scene::EnergyLedger& energy) const {
  thermal::HeatSources out;
  std::array<double, 2> guided{};
  if (as_built_bearing_.cage)
    for (const bearing::GuideLand& land : as_built_bearing_.cage->lands) {
      if (land.guide == bearing::GuideLand::Guide::Outer) guided[0] += land.width;
      if (land.guide == bearing::GuideLand::Guide::Inner) guided[1] += land.width;
    }
  const double width = guided[0] + guided[1];
  for (const auto& item : energy.items()) {
    if (item.term->kind != scene::LedgerKind::Heat) continue;
    const std::string_view id = item.term->id;
    const auto halves = [&](std::array<double, 2>& of_races, double outer) {
      of_races[0] += outer * item.value;
      of_races[1] += (1.0 - outer) * item.value;
    };
    const double by_race = item.race == 0 ? 1.0 : 0.0;
    if (id == "heat" || id == "rolling_heat" || id == "contact_damping")
      halves(out.race, by_race);
    else if ((id == "land_heat" || id == "land_film_heat" || id == "land_damping") && width > 0.0)
      halves(out.land, guided[0] / width);
    else if (id == "flange_heat" || id == "flange_damping")
      halves(out.flange, item.term->per_race() ? by_race : 0.5);
    else if (id == "element_drag" || id == "cage_drag")
      out.churning += item.value;
    else  // of pockets, of elements with each other: to the coolant
      out.element_cage += item.value;
  }
  return out;
}

void ThermalRun::start(double time, const scene::EnergyLedger& energy) {
  window_start_time_ = time;
  window_start_heat_ = sources(energy);
}

bool ThermalRun::has_mean_temperatures() const noexcept {
  return settled_ || steps_ >= static_cast<int>(kHistoryLength);
}

bool ThermalRun::due(double time) const noexcept {
  constexpr double kRounding = 1e-9;
  return time - window_start_time_ >= as_built_bearing_.thermal->average_time * (1.0 - kRounding) &&
         time > window_start_time_;
}

void ThermalRun::show(const thermal::BearingHeat& heat) {
  const thermal::NetworkTemperatures& T = heat.temperature;
  const auto film = [&](const char* name) {
    for (const thermal::NodeTemperature& node : heat.nodes)
      if (node.name == name) return node.temperature;
    return std::numeric_limits<double>::quiet_NaN();
  };
  shown_ = {steps_,
            T.coolant_in,
            T.coolant_out,
            T.outer_interface,
            T.inner_interface,
            T.housing,
            heat.sources.total(),
            heat.heat_to_coolant(),
            heat.flows.race,
            {T.outer_raceway, T.inner_raceway},
            {film("film of the outer race"), film("film of the inner race")},
            heat.bulk.housing,
            heat.bulk.shaft,
            T.coolant_mean};
}

ThermalRun::Step ThermalRun::close(const scene::Snapshot& at,
                                   const thermal::RaceConductance& contact) {
  const thermal::HeatSources until = sources(at.energy);
  const std::array<double, 8> now = list_of(until), then = list_of(window_start_heat_);
  std::array<double, 8> mean{};
  for (std::size_t k = 0; k < now.size(); ++k)
    mean[k] = std::max(0.0, (now[k] - then[k]) / (at.time - window_start_time_));
  Step out;
  bearing::Bearing warm = as_built_bearing_;
  part_temperatures_.set(warm);
  const thermal::HeatStep in_time{node_state_,
                                  (at.time - window_start_time_) * thermal_time_ratio_};
  out.heat = thermal::solve_bearing_heat(warm, of_list(mean), cage_speed(at), contact,
                                         transient_ ? &in_time : nullptr);
  node_state_ = out.heat.state;
  ++steps_;
  out.number = steps_;
  overheated_node_ = thermal::describe_overheated_node(out.heat);
  out.window = at.time - window_start_time_;
  const double orbit = std::abs(cage_speed(at));
  if (orbit > 0.0)
    out.passing = 2.0 * std::numbers::pi / (orbit * as_built_bearing_.element_count());
  constexpr double kMinRelaxation = 0.2, kMinRelaxationShortWindow = 0.02,
                   kRelaxationPerPassing = 0.3;
  relaxation_.least = out.window < out.passing
                          ? std::clamp(kRelaxationPerPassing * out.window / out.passing,
                                       kMinRelaxationShortWindow, kMinRelaxation)
                          : kMinRelaxation;
  part_temperatures_ = transient_ ? out.heat.bulk
                                  : thermal::BulkTemperatures::of(relaxation_.step(
                                        part_temperatures_.list(), out.heat.bulk.list()));
  window_start_time_ = at.time;
  window_start_heat_ = until;
  show(out.heat);
  const bearing::ThermalInputs& in = *as_built_bearing_.thermal;
  out.geometry =
      in.geometry_every > 0 && steps_ % in.geometry_every == 0 && at.time >= in.skip_time;
  if (out.geometry) geometry_temperatures_ = part_temperatures_;
  const auto field = part_temperatures_.list();
  history_.emplace_back(field.begin(), field.end());
  if (history_.size() > kHistoryLength) history_.erase(history_.begin());
  thermal::ThermalStepCriteria rules;
  rules.limit = thermal::kHottest;
  out.judged = thermal::assess_thermal_steps(history_, rules);
  // Slow changes of a transient are not a steady state, growing ones no instability.
  if (transient_ && out.judged.reason != "limit")
    out.judged.verdict = thermal::StepVerdict::Undecided;
  double drift = 0.0;
  const double fresh = std::max(relaxation_.least, 1.0 / steps_);
  for (std::size_t k = 0; k < mean_residual_.size(); ++k) {
    mean_residual_[k] += fresh * (relaxation_.residual[k] - mean_residual_[k]);
    drift = std::max(drift, std::abs(mean_residual_[k]));
  }
  constexpr double kMaxDrift = 2.0;  // [K]
  settled_ = out.judged.verdict == thermal::StepVerdict::Stable && drift < kMaxDrift;
  if (const std::string cold = thermal::describe_too_cold_nodes(out.heat); !cold.empty())
    throw SolverError(fmt::format(
        "at t = {:.9g} s, thermal step {}: {}. Give more coolant (cFlowRate), a higher baseTemp, "
        "another location of the base temperature (kBaseTemp), or less load or speed",
        at.time, steps_, cold));
  const std::string hot = thermal::describe_thermal_runaway(part_temperatures_);
  if (!hot.empty() || out.judged.reason == "limit")
    throw SolverError(fmt::format(
        "at t = {:.9g} s, thermal step {}: temperatures run away ({}); heat {:.4g} W, outer race "
        "{:.4g} K, inner race {:.4g} K, elements {:.4g} K. Give more coolant (cFlowRate), more "
        "clearance or less interference (freeIntCls, raceFit1, raceFit2), less load or speed; or a "
        "longer aveTime if the heat is still settling",
        at.time, steps_, hot, out.heat.sources.total(), part_temperatures_.race[0],
        part_temperatures_.race[1], part_temperatures_.element));
  return out;
}

bearing::Bearing ThermalRun::operating() const {
  bearing::Bearing at = as_built_bearing_;
  geometry_temperatures_.set(at);
  at.medium_temperature.reset();
  bearing::Bearing out = thermal::bearing_at_temperatures(at, part_temperatures_, false);
  return out;
}

void ThermalRun::save(std::map<std::string, double>& state) const {
  state["thermal.steps"] = steps_;
  state["thermal.begun"] = window_start_time_;
  state["thermal.settled"] = settled_ ? 1.0 : 0.0;
  const auto now = part_temperatures_.list(), geometry = geometry_temperatures_.list();
  for (std::size_t k = 0; k < now.size(); ++k) {
    state[key("now", k)] = now[k];
    state[key("geometry", k)] = geometry[k];
  }
  state["thermal.nodes"] = static_cast<double>(node_state_.size());
  for (std::size_t k = 0; k < node_state_.size(); ++k) state[key("node", k)] = node_state_[k];
  state["thermal.relaxation"] = relaxation_.factor;
  state["thermal.relaxed"] = relaxation_.begun ? 1.0 : 0.0;
  state["thermal.turns"] = relaxation_.turns;
  for (std::size_t k = 0; k < mean_residual_.size(); ++k)
    state[key("drift", k)] = mean_residual_[k];
  for (std::size_t k = 0; k < now.size(); ++k) state[key("residual", k)] = relaxation_.residual[k];
  const auto heat = list_of(window_start_heat_);
  for (std::size_t k = 0; k < heat.size(); ++k) state[key("heat", k)] = heat[k];
  state["thermal.history"] = static_cast<double>(history_.size());
  for (std::size_t n = 0; n < history_.size(); ++n)
    for (std::size_t k = 0; k < history_[n].size(); ++k)
      state[fmt::format("thermal.history.{}.{}", n, k)] = history_[n][k];
  const double shown[] = {shown_.raceway[0],   shown_.raceway[1],  shown_.housing_mean,
                          shown_.shaft_mean,   shown_.medium,      shown_.coolant_in,
                          shown_.coolant_out,  shown_.outside,     shown_.bore,
                          shown_.housing,      shown_.heat,        shown_.coolant_heat,
                          shown_.race_heat[0], shown_.race_heat[1]};
  for (std::size_t k = 0; k < std::size(shown); ++k) state[key("shown", k)] = shown[k];
  for (std::size_t j = 0; j < 2; ++j)
    if (std::isfinite(shown_.film[j])) state[key("film", j)] = shown_.film[j];
}

bool ThermalRun::restore(const std::map<std::string, double>& state,
                         const std::filesystem::path& file) {
  if (state.find("thermal.steps") == state.end()) return false;
  const auto get = [&](const std::string& name, double least, double most) {
    const auto found = state.find(name);
    if (found == state.end() || !(found->second >= least && found->second <= most))
      throw InputError(
          fmt::format("{}: the stored thermal analysis is incomplete or has an impossible value "
                      "({}{}); restore the file or start again with --overwrite",
                      file.string(), name,
                      found == state.end() ? std::string(" is missing")
                                           : fmt::format(" = {:g}", found->second)));
    return found->second;
  };
  constexpr double kColdest = 1.0, kMaxValue = 1e30;
  steps_ = static_cast<int>(get("thermal.steps", 0.0, 1e9));
  window_start_time_ = get("thermal.begun", 0.0, kMaxValue);
  settled_ = get("thermal.settled", 0.0, 1.0) > 0.5;
  std::array<double, 7> now{}, geometry{};
  for (std::size_t k = 0; k < now.size(); ++k) {
    now[k] = get(key("now", k), kColdest, thermal::kHottest);
    geometry[k] = get(key("geometry", k), kColdest, thermal::kHottest);
  }
  part_temperatures_ = thermal::BulkTemperatures::of(now);
  geometry_temperatures_ = thermal::BulkTemperatures::of(geometry);
  constexpr double kMaxNodes = 64.0;
  node_state_.resize(static_cast<std::size_t>(get("thermal.nodes", 0.0, kMaxNodes)));
  for (std::size_t k = 0; k < node_state_.size(); ++k)
    node_state_[k] = get(key("node", k), -kMaxValue, kMaxValue);
  relaxation_.factor = get("thermal.relaxation", 0.0, 1.0);
  relaxation_.begun = get("thermal.relaxed", 0.0, 1.0) > 0.5;
  relaxation_.turns = static_cast<int>(get("thermal.turns", 0.0, 1e9));
  for (std::size_t k = 0; k < mean_residual_.size(); ++k)
    mean_residual_[k] = get(key("drift", k), -kMaxValue, kMaxValue);
  for (std::size_t k = 0; k < now.size(); ++k)
    relaxation_.residual[k] = get(key("residual", k), -kMaxValue, kMaxValue);
  std::array<double, 8> heat{};
  for (std::size_t k = 0; k < heat.size(); ++k)
    heat[k] = get(key("heat", k), -kMaxValue, kMaxValue);
  window_start_heat_ = of_list(heat);
  const auto count = static_cast<std::size_t>(get("thermal.history", 0.0, double(kHistoryLength)));
  history_.assign(count, std::vector<double>(now.size()));
  for (std::size_t n = 0; n < count; ++n)
    for (std::size_t k = 0; k < now.size(); ++k)
      history_[n][k] = get(fmt::format("thermal.history.{}.{}", n, k), kColdest, thermal::kHottest);
  std::array<double, 14> shown{};
  for (std::size_t k = 0; k < shown.size(); ++k)
    shown[k] = get(key("shown", k), -kMaxValue, kMaxValue);
  // Films are not computed before the next thermal step where a network without them was stored.
  std::array<double, 2> film{};
  for (std::size_t j = 0; j < 2; ++j) {
    const auto found = state.find(key("film", j));
    film[j] = found == state.end() ? std::numeric_limits<double>::quiet_NaN()
                                   : get(key("film", j), 0.0, kMaxValue);
  }
  shown_ = {steps_,
            shown[5],
            shown[6],
            shown[7],
            shown[8],
            shown[9],
            shown[10],
            shown[11],
            {shown[12], shown[13]},
            {shown[0], shown[1]},
            film,
            shown[2],
            shown[3],
            shown[4]};
  return true;
}

thermal::RaceConductance race_conductance(const Prepared& p) {
  return p.roller_scene ? thermal::race_conductance(p.bearing, p.roller_scene->solution)
                        : thermal::race_conductance(p.bearing, p.start);
}

std::vector<Finding> move_to(Prepared& p, bearing::Bearing operating) {
  p.bearing = std::move(operating);
  std::vector<Finding> out;
  std::optional<statics::LubricantFilms> films;
  if (p.bearing.rollers()) {
    auto scene = std::make_shared<dynamics::RollerStaticResult>();
    scene->options = p.options.rollers;
    scene->solution = statics::solve_roller_statics(p.bearing, p.options.rollers);
    p.start = dynamics::static_start(*scene, p.bearing);
    out = scene->solution.friction.findings();
    if (p.bearing.lubrication) films = statics::contact_films(p.bearing, scene->solution);
    p.roller_scene = std::move(scene);
  } else {
    statics::BallStaticsOptions as_in_motion = ball_statics_options(p);
    as_in_motion.curvature =
        p.options.system.moving_angle ? statics::Curvature::Potential : statics::Curvature::Fixed;
    as_in_motion.fixed_angle = p.fixed_angle;
    p.start = statics::solve_ball_statics(p.bearing, as_in_motion);
    out = statics::solve_ball_friction_balance(p.bearing, as_in_motion, p.start).findings();
    if (p.bearing.lubrication) films = statics::contact_films(p.bearing, p.start);
  }
  if (!films) return out;
  for (Finding& doubt : statics::film_doubts(*films, statics::FilmUse::ThermalSteps))
    out.push_back(std::move(doubt));
  return out;
}

}  // namespace adore::runs
