#pragma once

#include "life/load_damage.hpp"
#include "listing/print_life.hpp"

#include <array>
#include <map>
#include <optional>
#include <span>
#include <string>

/// Fatigue life along a dynamic run. Life of the run: from the contact loads of every integration
/// step (life/load_damage.hpp), independent of all output intervals. Life of an instant, which SOL7
/// stores: from the snapshots that kLifeFreq selects. Never called by the right-hand side.
namespace adore::runs {

class LifeObserver {
 public:
  /// @param film_parameter Λ by race of instants that say none
  LifeObserver(const bearing::Bearing& bearing, const life::LifeParameters& parameters,
               const std::array<std::optional<double>, 2>& film_parameter = {});

  /// The equilibrium whose contacts tabulate damage over load; before the first step.
  void set_reference(const life::BearingContacts& contacts);
  /// Normal loads at the end of an integration step [N]. @pre set_reference
  void follow_step(double time, std::span<const double> outer, std::span<const double> inner) {
    run_->step(time, outer, inner);
  }
  /// Must the full life model be evaluated now?
  [[nodiscard]] bool evaluation_due() const noexcept { return run_->due(); }
  /// Evaluates it at the start of the run, or after the step that was followed last.
  void evaluate(const scene::Snapshot& snapshot);

  /// The life at this instant's loads, for SOL7.
  void observe(const scene::Snapshot& snapshot);
  /// The bearing has another geometry now (thermal steps).
  void update_bearing();
  /// Of the last instant, as if its loads lasted for ever, by the model that SOL7 stores, at the
  /// deck's survival probability [hr]; infinity is a valid life, 0 before the first instant.
  [[nodiscard]] double hours() const noexcept { return life_hours_; }
  /// Number of that instant's step.
  [[nodiscard]] long step() const noexcept { return step_; }
  [[nodiscard]] listing::RunLife run_life() const;

  /// For MASTER, and back.
  void save(std::map<std::string, double>& state) const;
  void restore(const std::map<std::string, double>& state);

 private:
  [[nodiscard]] life::LifeState state_at(const scene::Snapshot& snapshot);

  const bearing::Bearing& bearing_;
  life::LifeCalculator calculator_;
  std::array<std::optional<double>, 2> film_parameter_;
  std::optional<life::StepDamageAccumulator> run_;
  double life_hours_ = 0.0;
  long step_ = 0;
};

}  // namespace adore::runs
