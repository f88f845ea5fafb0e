#include "runs/key_results.hpp"

#include "life/statistics.hpp"
#include "runs/fault_frequencies.hpp"
#include "runs/static_quantities.hpp"

#include <algorithm>
#include <numbers>
#include <string_view>

namespace adore::runs {

using results::key_result;
using scene::Snapshot;

void add_lives(KeyResults& out, const life::BearingLife& life) {
  using bearing::LifeModel;
  using bearing::LifeModification;
  const auto add = [&](LifeModel model, LifeModification modification) {
    out.push_back(results::life_result(
        model, modification,
        life::life_hours(life.state.of(model, modification).L_S, life.state.relative_speed)));
  };
  add(LifeModel::Original, LifeModification::None);
  const bearing::LifeChoices& choices = life.parameters.choices;
  if (choices.stored_model != LifeModel::Original ||
      choices.stored_modification != LifeModification::None)
    add(choices.stored_model, choices.stored_modification);
}

void add_iso_lives(KeyResults& out, const life::BearingLife& life) {
  if (life.iso) {
    const auto hours = [&](const char* id, const std::optional<double>& L) {
      if (L) out.push_back(key_result(id, life::life_hours(*L, life.state.relative_speed)));
    };
    hours("life_iso281_hours", life.iso->L10);
    if (life.iso->reference) hours("life_iso16281_hours", life.iso->reference->L10r);
    hours("life_iso281_modified_hours", life.iso->L_nm);
    if (life.iso->kappa && life.iso->kappa_origin == "oil")
      out.push_back(key_result("viscosity_ratio", *life.iso->kappa));
  }
}

void add_fits(KeyResults& out, const bearing::OperatingFits& fits) {
  out.push_back(key_result("operating_clearance_m", fits.operating.clearance));
  out.push_back(key_result("operating_contact_angle_rad", fits.operating.contact_angle));
  out.push_back(key_result("outer_fit_pressure_Pa", fits.fit[0].pressure));
  out.push_back(key_result("inner_fit_pressure_Pa", fits.fit[1].pressure));
}

void add_heat(KeyResults& out, const Prepared& prepared) {
  if (!prepared.friction) return;
  if (prepared.friction->why_none().empty()) {
    out.push_back(key_result("friction_torque_Nm", prepared.friction->torque()));
    out.push_back(key_result("friction_power_W", prepared.friction->power()));
  }
  if (!prepared.thermal) return;
  const thermal::BearingHeat& heat = prepared.thermal->heat;
  out.push_back(key_result("outer_race_temperature_K", heat.bulk.race[0]));
  out.push_back(key_result("inner_race_temperature_K", heat.bulk.race[1]));
  out.push_back(key_result("element_temperature_K", heat.bulk.element));
  if (heat.coolant)
    out.push_back(key_result("coolant_exit_temperature_K", heat.temperature.coolant_out));
}

namespace {

double largest_pressure(const Prepared& prepared) {
  double pressure = 0.0;
  for (const statics::StaticBall& ball : prepared.statics.balls)
    for (const double p : ball.p_max) pressure = std::max(pressure, p);
  if (prepared.rollers)
    for (const statics::StaticRoller& roller : prepared.rollers->rollers)
      for (const auto& contact : roller.race) pressure = std::max(pressure, contact.peak_pressure);
  return pressure;
}

}  // namespace

KeyResults static_results(const Prepared& prepared) {
  const statics::RaceResult& solution = prepared.race_result();
  const auto stiffness = [&](Eigen::Index k) { return solution.stiffness(k, k); };
  return {key_result("displacement_x_m", solution.displacement[0]),
          key_result("displacement_y_m", solution.displacement[1]),
          key_result("displacement_z_m", solution.displacement[2]),
          key_result("displacement_about_y_rad", solution.displacement[3]),
          key_result("displacement_about_z_rad", solution.displacement[4]),
          key_result("load_x_N", solution.load[0]),
          key_result("load_y_N", solution.load[1]),
          key_result("load_z_N", solution.load[2]),
          key_result("load_about_y_Nm", solution.load[3]),
          key_result("load_about_z_Nm", solution.load[4]),
          key_result("largest_contact_load_N", solution.max_load),
          key_result("largest_pressure_Pa", largest_pressure(prepared)),
          key_result("stiffness_x_N_per_m", stiffness(0)),
          key_result("stiffness_y_N_per_m", stiffness(1)),
          key_result("stiffness_z_N_per_m", stiffness(2)),
          key_result("stiffness_about_y_Nm_per_rad", stiffness(3)),
          key_result("stiffness_about_z_Nm_per_rad", stiffness(4))};
}

KeyResults equilibrium_results(const Prepared& prepared) {
  KeyResults out = static_results(prepared);
  add_heat(out, prepared);
  if (prepared.bearing.operating) add_fits(out, *prepared.bearing.operating);
  add_lives(out, prepared.life);
  // Later ones at the end: scripts may count the columns of tables.
  add_iso_lives(out, prepared.life);
  add_extremes(out, prepared);
  add_fault_frequencies(out, prepared, equilibrium_fault_frequencies(prepared));
  return out;
}

std::array<double, 2> mean_race_heat(const Snapshot& last, const results::Averages& averages) {
  // The ledger counts from where the averages do, the start of the run.
  std::array<double, 2> heat{};
  for (int j = 0; j < 2; ++j) {
    const auto* item = last.energy.find("heat", j);
    if (item == nullptr) continue;
    heat[static_cast<std::size_t>(j)] =
        averages.time > 0.0 ? item->value / averages.time : item->rate;
  }
  return heat;
}

namespace {

bool asks_for_load(const results::MeanLoad& carried) {
  for (std::size_t k = 0; k < carried.given.size(); ++k)
    if (carried.given[k] && carried.asked[static_cast<Eigen::Index>(k)] != 0.0) return true;
  return false;
}

}  // namespace

KeyResults dynamic_results(const Snapshot& last, const results::Averages& averages,
                           const results::MeanLoad& carried) {
  double load = 0.0, slip = 0.0;
  for (const scene::ElementSnapshot& element : last.elements)
    for (const scene::RaceContactSnapshot& contact : element.race) {
      load = std::max(load, contact.load);
      slip = std::max(slip, contact.max_slip);
    }
  KeyResults out;
  const auto add = [&out](std::string_view id, double value) {
    out.push_back(key_result(id, value));
  };
  // Results that do not exist, or were not averaged, have no value: 0 would count as a result.
  const bool moved = averages.time > 0.0;
  const auto& terms = last.energy.items();
  const bool rubs = std::any_of(terms.begin(), terms.end(), [](const auto& item) {
    return item.term->kind == scene::LedgerKind::Heat;
  });
  add("time_s", last.time);
  add("revolutions", last.shaft_rotation / (2.0 * std::numbers::pi));
  add("largest_contact_load_N", load);
  add("largest_slip_m_per_s", slip);
  if (rubs) add("power_loss_W", last.power.total_loss);
  if (rubs && moved) {
    const std::array<double, 2> heat = mean_race_heat(last, averages);
    add("mean_power_loss_W", averages.power_loss);
    if (last.energy.find("heat", 0) != nullptr) add("mean_heat_outer_race_W", heat[0]);
    if (last.energy.find("heat", 1) != nullptr) add("mean_heat_inner_race_W", heat[1]);
    add("mean_heat_elsewhere_W", averages.power_loss - heat[0] - heat[1]);
  }
  if (moved && last.shaft_rotation != 0.0) {  // ratios are to the turns of the races
    add("mean_orbital_ratio", averages.orbital_ratio);
    if (!last.cages.empty()) {
      add("mean_cage_ratio", averages.cage_ratio);
      add("mean_whirl_ratio", averages.whirl_ratio);
      add("mean_swept_whirl_ratio", averages.swept_whirl_ratio);
    }
  }
  if (moved) {
    add("mean_load_x_N", carried.mean[0]);
    add("mean_load_y_N", carried.mean[1]);
    add("mean_load_z_N", carried.mean[2]);
    add("mean_largest_load_N", averages.largest_load);
  }
  add("peak_load_N", averages.peak_load);
  if (moved && asks_for_load(carried)) add("load_departure", carried.departure());
  if (moved) add("energy_residual_J", last.energy.residual());
  return out;
}

double static_elastic_energy(const Prepared& prepared) {
  const double share = prepared.rollers ? 9.0 / 19.0 : 0.4;  // of load times approach
  double elastic = 0.0;
  for (const statics::StaticBall& ball : prepared.start.balls)
    for (std::size_t j = 0; j < 2; ++j)
      if (ball.Q[j] > 0.0) elastic += share * ball.Q[j] * ball.delta[j];
  return elastic;
}

}  // namespace adore::runs
