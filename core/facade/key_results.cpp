#include "facade/key_results.hpp"

#include "life/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>

namespace adore::facade {

using scene::Snapshot;

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

double static_elastic(const Prepared& prepared) {
  double elastic = 0.0;
  for (const statics::StaticBall& ball : prepared.start.balls)
    for (std::size_t j = 0; j < 2; ++j)
      if (ball.Q[j] > 0.0) elastic += 0.4 * ball.Q[j] * ball.delta[j];
  return elastic;
}

}  // namespace adore::facade
