#pragma once

#include "dynamics/system.hpp"
#include "dynamics/system_effects.hpp"
#include "dynamics/system_held.hpp"
#include "dynamics/system_lands.hpp"
#include "dynamics/system_motion.hpp"
#include "dynamics/system_pockets.hpp"
#include "dynamics/system_stiff.hpp"

#include <memory>
#include <optional>
#include <vector>

/// Private parts of System, shared by its source files.
namespace adore::dynamics {

/// Indices of the time integrals in the state; -1 when the plan does not ask for them.
struct QuadratureIndices {
  std::array<int, 2> work_race{-1, -1}, heat_race{-1, -1}, wear_race{-1, -1}, wear_element1{-1, -1};
  int heat_pockets = -1, heat_lands = -1, wear_cage = -1;
  int impulse = -1, angular_impulse = -1;            ///< first of three
  int held_balance = -1, held_switches = -1;         ///< energy
  int held_impulse = -1, held_angular_impulse = -1;  ///< first of three
  int held_flags = -1;                               ///< first of one per ball: 1 held, 0 free
};

/// Kind of error scale of a group of components (N7, N11).
enum class ScaleKind : unsigned char { Length, Velocity, Angle, Rate };

struct StoredEnergy {
  double kinetic = 0.0, elastic = 0.0, gravity = 0.0;  ///< [J]
  [[nodiscard]] double total() const noexcept { return kinetic + elastic + gravity; }
};

struct Momenta {
  Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();  ///< about the base origin [N s, N m s]
  double linear_size = 0.0, angular_size = 0.0;        ///< Σ over bodies of the sizes
};

struct System::Impl {
  Impl(const bearing::Bearing& bearing_, const ScenePlan& plan,
       const statics::StaticSolution& statics, const std::array<double, 2>& fixed_angle,
       const SystemOptions& options);
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  const bearing::Bearing bearing;
  const statics::StaticSolution statics;
  bool gravity = false, has_race_contact = false;
  std::array<RaceContactModel, 2> contacts;
  std::array<Vec3, 2> free_centre;      ///< free positions of the race centres [m]
  std::array<Quat, 2> race_attitude{};  ///< race frame without its spin -> base
  std::optional<PocketSet> pockets;     ///< with pocket contact
  std::vector<LandModel> lands;         ///< one per land of the cage, with land contact
  std::optional<HeldBalls> held;        ///< with light-load balance
  double light_load_ratio = 0.0;

  StateLayout layout;
  Scales scales;
  BallSlices ball;
  CageSlices cage;
  std::vector<OrientedElement> oriented;
  QuadratureIndices integrals;

  struct Block {
    std::unique_ptr<EffectBlock> block;
    int entry;  ///< of the cost ledger
  };
  std::vector<Block> blocks;
  int pocket_block = -1;               ///< in blocks; -1 without pocket contact
  std::optional<NormalContacts> fast;  ///< with race contact
  std::vector<int> element_of;         ///< System::coupling
  PocketShares pocket_shares;
  Evaluation e;
  CostLedger ledger;
  std::vector<double> rates;     ///< dydt of evaluations for reports
  double stored_at_start = 0.0;  ///< [J]
  Momenta momenta_at_start;      ///< less the integrals of the start state

  [[nodiscard]] bool has_cage() const noexcept { return cage.position.count > 0; }
  /// All blocks in order; false when the state is outside the model's validity.
  bool evaluate(double t, const double* y, double* dydt) noexcept;
  bool evaluate_measured(double t, const double* y, double* dydt) noexcept;
  /// For reports: evaluates into `rates`. @throws SolverError when the state is not valid.
  void evaluate_for_report(double t, std::span<const double> y);
  [[noreturn]] void throw_invalid(double t, const double* y) const;
  /// Clause that says why the state evaluated last is not valid.
  [[nodiscard]] std::string what_is_invalid(const double* y) const;
  /// Of the state evaluated last.
  [[nodiscard]] StoredEnergy stored_energy() const;
  [[nodiscard]] Momenta momenta() const;
  [[nodiscard]] EnergySnapshot energy_ledger(std::span<const double> y) const;
  [[nodiscard]] MomentumSnapshot momentum_ledger(std::span<const double> y) const;
  void apply_scales();

 private:
  Slice add(std::string name, std::string_view unit, int count, ScaleKind kind);
  void set_up_races(const std::array<double, 2>& fixed_angle, const SystemOptions& options,
                    bool traction);
  void set_up_state(const ScenePlan& plan);
  void set_up_quadratures(const ScenePlan& plan);
  void set_up_blocks(const ScenePlan& plan);
  void set_up_coupling();
  void set_up_ledger_integrals(const ScenePlan& plan);
  template <class Block, class... Arguments>
  void add_block(int entry, Arguments&&... arguments);

  std::vector<std::pair<Slice, ScaleKind>> kinds_;
  std::vector<Quadratures::Entry> rates_of_integrals_;
};

}  // namespace adore::dynamics
