#pragma once

#include <array>
#include <map>
#include <string>

/// Palmgren-Miner accumulation of fatigue over a run, per component.
namespace adore::life {

inline constexpr std::size_t kDamageParts = 3;  ///< outer race, inner race, elements
using DamageParts = std::array<double, kDamageParts>;

/// Fatigue damage per second: dD_i/dt = n/(L_i 1e6), n relative revolutions of the races per
/// second. An infinite life or standstill gives none.
struct DamageRate {
  DamageParts damage{};  ///< [1/s]
  double turns = 0.0;    ///< [1/s]
};
/// @param speed Ω_inner - Ω_outer [rad/s], its sign is ignored @param lives [1e6 rev]
[[nodiscard]] DamageRate damage_rate(double speed, const DamageParts& lives);

class DamageSum {
 public:
  /// Conditions that last for a time.
  void add(double seconds, const DamageRate& rate) { add_trapezoidal(seconds, rate, rate); }
  /// Conditions whose damage rate changes linearly between two instants.
  void add_trapezoidal(double seconds, const DamageRate& before, const DamageRate& after);

  void add(const DamageParts& damage, double seconds, double revolutions);

  [[nodiscard]] double seconds() const noexcept { return seconds_; }
  [[nodiscard]] double revolutions() const noexcept { return revolutions_; }
  [[nodiscard]] const DamageParts& damage() const noexcept { return damage_; }
  /// How often the window could be repeated before 10 % of the bearings fail: Σ (n D_i)^e_i = 1;
  /// infinite without damage.
  [[nodiscard]] double repetitions_to_failure(const DamageParts& slopes) const;
  [[nodiscard]] double life_hours(const DamageParts& slopes) const;
  [[nodiscard]] double life_mega_revolutions(const DamageParts& slopes) const;

  /// For MASTER, and back (keys "life.…").
  void save(std::map<std::string, double>& state) const;
  void restore(const std::map<std::string, double>& state);  ///< @throws InputError: values lack

 private:
  DamageParts damage_{};
  double seconds_ = 0.0, revolutions_ = 0.0;
};

/// One of the values that save() wrote. @throws InputError naming it when MASTER lacks it
[[nodiscard]] double stored(const std::map<std::string, double>& state, const std::string& name);

}  // namespace adore::life
