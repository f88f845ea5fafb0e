#pragma once

#include "bearing/bearing.hpp"
#include "dynamics/prescribed_races.hpp"
#include "dynamics/scene.hpp"
#include "dynamics/state_layout.hpp"
#include "scene/quadrature_error.hpp"
#include "statics/ball_statics.hpp"

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

/// The equations of motion of one bearing, assembled from the effects of its scene plan.
namespace adore::dynamics {

class SceneEffect;          // effect.hpp
struct RaceLoad;            // race_load.hpp
struct RollerStaticResult;  // roller_start.hpp
/// Makes an effect that the catalogue does not have; null: not in this scene.
using EffectMaker = std::function<std::unique_ptr<SceneEffect>(const ScenePlan&)>;

enum class RhsStatus : unsigned char { Ok, Retry, Fail };

class System {
 public:
  /// Allocates everything. `statics` must be a solution with Curvature::Potential, or with frozen
  /// constants (SystemOptions::moving_angle) Curvature::Fixed at `fixed_angle`: so forces agree.
  System(const bearing::Bearing& bearing, const ScenePlan& plan,
         const statics::StaticSolution& statics, const std::array<double, 2>& fixed_angle,
         const SystemOptions& options, const std::vector<EffectMaker>& more_effects = {},
         std::shared_ptr<const RollerStaticResult> rollers = nullptr);
  ~System();
  System(System&&) noexcept;

  [[nodiscard]] const StateLayout& layout() const noexcept;
  [[nodiscard]] const Scales& scales() const noexcept;
  void set_scales(const Scales& scales);  ///< continuation keeps the first run's scales (N7)
  /// Start from statics and record 9.6.
  [[nodiscard]] std::vector<double> initial_state() const;
  /// Fixes the reference of the ledgers and takes the effects' memory in addition to the state
  /// (call once with the start state).
  void set_start(double t, std::span<const double> y);
  /// Prescribed motion of the races at t, with their rotation so far.
  [[nodiscard]] PrescribedRaces prescribed_races(double t, std::span<const double> y) noexcept;
  /// Continues at t from the state of a run with the prescribed motion `before` of its races
  /// (prescribed_races.hpp); before set_start().
  void go_on(const PrescribedRaces& before, double t, std::span<double> y);
  /// Continues with the state of a system of the same layout whose bearing had other temperatures:
  /// scales and ledgers continue, and the jumps of stored energy and momentum are booked in y
  /// (effect "thermal steps").
  /// @throws SolverError when the state is not valid in this geometry
  void continue_from(System& before, double t, std::span<double> y);

  /// y' = f(t, y). No allocation, no throw. Retry: a ball left its pocket radially or the like in a
  /// trial step.
  RhsStatus rhs(double t, const double* y, double* dydt) noexcept;
  /// The fast part of the motion alone, for implicit-explicit methods (normal_contacts.hpp):
  /// false without race contacts.
  [[nodiscard]] bool has_stiff_part() const noexcept;
  /// Writes its rates, all of dydt. No allocation, no throw.
  RhsStatus rhs_stiff(double t, const double* y, double* dydt) noexcept;
  /// Longest step from time t that resolves prescribed motion, and ends at its next kink [s];
  /// infinity when nothing is prescribed.
  [[nodiscard]] double longest_step(double t) const noexcept;
  /// Coupling: number of the element (0, 1, ...) that each controlled component
  /// belongs to, -1 for components that meet every element (cage, free races). Elements are coupled
  /// only through these, and with their neighbors in the ring if neighbours_meet().
  [[nodiscard]] std::span<const int> coupling() const noexcept;
  [[nodiscard]] bool neighbours_meet() const noexcept;
  /// rhs, and what each element adds to each rate of the border (coupling -1): shares[element *
  /// border components + component], in the order of the components.
  RhsStatus rhs_with_contributions(double t, const double* y, double* dydt,
                                   double* shares) noexcept;
  /// Changes of the model (which elements stand in force balance, qFac) happen here and nowhere
  /// else, so that between two calls rhs stays a pure function of (t, y). Call after a finished
  /// step, and once at the start of a new run; true when y changed: the stepper must restart. Jumps
  /// of energy and momentum are booked in y.
  /// @throws SolverError when the state is not valid
  bool between_steps(double t, std::span<double> y);
  /// Renormalises quaternions; true when rates change.
  bool project(double t, double* y) const noexcept;
  /// Throws SolverError with a message when an accepted state is physically meaningless (ball
  /// outside its pocket ...).
  void check_state(double t, const double* y) const;

  /// Energy by which a single step can be judged, of the evaluation that was made last.
  struct EnergyBalance {
    double balance = 0.0;  ///< stored less what came in: exact motion keeps it [J]
    double elastic = 0.0;  ///< of all contacts [J]
    double size = 0.0;     ///< Σ of the sizes of all items: what rounding goes by [J]
  };
  [[nodiscard]] EnergyBalance energy_balance() noexcept;
  [[nodiscard]] Snapshot snapshot(double t, std::span<const double> y);
  /// The same into a snapshot of this system from before, whose memory is used again.
  void snapshot(double t, std::span<const double> y, Snapshot& out);
  /// Turn of the inner race less that of the outer one, about their axes [rad].
  [[nodiscard]] double shaft_rotation(double t, std::span<const double> y) noexcept;
  [[nodiscard]] scene::QuadratureError quadrature_error(double t, std::span<const double> y);
  /// Replacement of integrals that are too expensive, with its error; empty: none.
  [[nodiscard]] std::string approximation_note() const;
  /// Normal loads of all elements at a race, of the evaluation that was made last [N].
  [[nodiscard]] std::span<const double> contact_loads(std::size_t race) const noexcept;
  /// The same with the other half of a split race; empty: not split.
  [[nodiscard]] std::span<const double> other_half_loads(std::size_t race) const noexcept;
  /// Forces and heats of the evaluation that was made last (scene/look.hpp).
  void look(scene::Look& out) const;
  /// Rolling speed at which the film breaks down in contacts that slide and are about to stop
  /// rolling (effects/races.hpp), smallest; of the evaluation that was made last. Infinite: no such
  /// contact. @param near rolling speed below which a contact counts [m/s]
  [[nodiscard]] double speed_to_resolve(double near) const;
  /// Of an inner race in force balance, at the evaluation that was made last; zero: there is none.
  [[nodiscard]] const RaceLoad& balanced_race() const noexcept;
  [[nodiscard]] CostLedger& cost() noexcept;
  [[nodiscard]] const bearing::Bearing& bearing() const noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace adore::dynamics
