#pragma once

#include "life/bearing_life.hpp"
#include "listing/print_life.hpp"

#include <array>
#include <map>
#include <optional>
#include <string>

/// Fatigue life along a dynamic run: looks at snapshots at output times, never at the right-hand
/// side.
namespace adore::facade {

class LifeObserver {
 public:
  /// @param film_parameter Λ by race of instants that say none
  LifeObserver(const bearing::Bearing& bearing, const life::LifeParameters& parameters,
               const std::array<std::optional<double>, 2>& film_parameter = {});

  /// The life at this instant's loads, and its damage since the instant before (linear between
  /// them).
  void observe(const scene::Snapshot& snapshot);
  /// The bearing has another geometry now (thermal steps).
  void follow_bearing();
  /// Of the last instant, as if its loads lasted for ever, by the model that SOL7 stores, at the
  /// deck's survival probability [hr]; infinity is a valid life, 0 before the first instant.
  [[nodiscard]] double hours() const noexcept { return hours_; }
  /// Number of that instant's step.
  [[nodiscard]] long step() const noexcept { return step_; }
  [[nodiscard]] listing::RunLife run_life() const;

  /// For MASTER, and back.
  void save(std::map<std::string, double>& state) const;
  void restore(const std::map<std::string, double>& state);

 private:
  const bearing::Bearing& bearing_;
  life::LifeCalculator calculator_;
  std::array<std::optional<double>, 2> film_parameter_;
  life::DamageSum damage_;
  life::DamageRate rate_;  ///< at the last instant
  double time_ = 0.0;      ///< of it [s]
  bool started_ = false;   ///< there was one inside the window
  double hours_ = 0.0;
  long step_ = 0;
};

}  // namespace adore::facade
