#include "life/accumulation.hpp"

#include "base/errors.hpp"
#include "life/statistics.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace adore::life {

DamageRate damage_rate(double speed, const DamageParts& lives) {
  DamageRate out;
  out.turns = std::abs(speed) / (2.0 * std::numbers::pi);
  for (std::size_t i = 0; i < kDamageParts; ++i) {
    check_life(lives[i]);
    out.damage[i] = out.turns / lives[i] * 1e-6;
  }
  return out;
}

double stored(const std::map<std::string, double>& state, const std::string& name) {
  const auto found = state.find(name);
  if (found == state.end())
    throw InputError(
        fmt::format("file MASTER is damaged: the entry '{}' is missing. Use the file MASTER of an "
                    "earlier run, or start new files with kIcOpt = -1",
                    name));
  return found->second;
}

void DamageSum::add_trapezoidal(double seconds, const DamageRate& before, const DamageRate& after) {
  for (std::size_t i = 0; i < kDamageParts; ++i)
    damage_[i] += 0.5 * seconds * (before.damage[i] + after.damage[i]);
  seconds_ += seconds;
  revolutions_ += 0.5 * seconds * (before.turns + after.turns);
}

void DamageSum::add(const DamageParts& damage, double seconds, double revolutions) {
  for (std::size_t i = 0; i < kDamageParts; ++i) damage_[i] += damage[i];
  seconds_ += seconds;
  revolutions_ += revolutions;
}

double DamageSum::repetitions_to_failure(const DamageParts& slopes) const {
  DamageParts lives{};
  for (std::size_t i = 0; i < kDamageParts; ++i)
    lives[i] = damage_[i] > 0.0 ? 1.0 / damage_[i] : std::numeric_limits<double>::infinity();
  return combined_life(lives, slopes);
}

double DamageSum::life_hours(const DamageParts& slopes) const {
  const double windows = repetitions_to_failure(slopes);
  return std::isfinite(windows) ? windows * seconds_ / 3600.0 : windows;
}

double DamageSum::life_mega_revolutions(const DamageParts& slopes) const {
  const double windows = repetitions_to_failure(slopes);
  return std::isfinite(windows) ? windows * revolutions_ * 1e-6 : windows;
}

void DamageSum::save(std::map<std::string, double>& state) const {
  for (std::size_t i = 0; i < kDamageParts; ++i)
    state[fmt::format("life.damage.{}", i)] = damage_[i];
  state["life.seconds"] = seconds_;
  state["life.revolutions"] = revolutions_;
}

void DamageSum::restore(const std::map<std::string, double>& state) {
  if (state.count("life.seconds") == 0) return;
  for (std::size_t i = 0; i < kDamageParts; ++i)
    damage_[i] = stored(state, fmt::format("life.damage.{}", i));
  seconds_ = stored(state, "life.seconds");
  revolutions_ = stored(state, "life.revolutions");
}

}  // namespace adore::life
