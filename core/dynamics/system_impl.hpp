#pragma once

#include "dynamics/effect.hpp"
#include "dynamics/system.hpp"

#include <array>
#include <vector>

/// Private parts of System, shared by its source files: layout, blocks and loop.
namespace adore::dynamics {

struct System::Impl final : BetweenStepsAccess {
  Impl(const bearing::Bearing& bearing_, const ScenePlan& plan,
       const statics::StaticSolution& statics, const std::array<double, 2>& fixed_angle,
       const SystemOptions& options, const std::vector<EffectMaker>& more_effects,
       std::shared_ptr<const RollerStaticResult> rollers);
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  struct Integral {
    int index;
    const double* rate;
  };
  struct EnergyItem {
    const LedgerTerm* term;
    int race, index;
    const double* rate;  ///< null: changes between steps only
  };
  struct MomentumItem {
    const LedgerTerm* term;
    bool angular;
    int first;  ///< of three
  };

  const bearing::Bearing bearing;
  const std::shared_ptr<scene::UserLaws> user;             ///< null: none
  std::shared_ptr<const RollerStaticResult> roller_scene;  ///< of roller bearings
  Assembly parts;
  Scales scales;
  std::vector<Integral> integrals;
  std::vector<EnergyItem> energy_items;
  std::vector<MomentumItem> momentum_items;
  std::size_t race_blocks = 0;               ///< the first of parts.blocks, Phase::Races
  SceneEffect* stiff = nullptr;              ///< the effect with the fast part; null: there is none
  int border_count = 0;                      ///< components of the border
  std::vector<std::size_t> border_rank;      ///< of the first component of each border body
  std::vector<std::vector<int>> partner_of;  ///< of each block and element: which border body, -1
                                             ///< none; empty: none at all
  /// Forces and moments on the elements before a block that meets the border.
  ElementActions before;
  Evaluation e;
  std::vector<double> rates;  ///< dydt of evaluations for reports
  /// State that was evaluated and nothing since, as check_state() and energy_balance() leave it: a
  /// check or report of it need not again.
  std::vector<double> checked;
  double checked_time = 0.0;
  bool is_checked = false;
  double stored_at_start = 0.0;  ///< [J], less the flow until then
  Momenta momenta_at_start;      ///< less the flow until then
  EnergyLedger account;          ///< memory of energy_balance()

  /// Keeps the state evaluated last, which is valid, and its rates. A stepper that knows the rates
  /// of the end of its step has them of the state before quaternions were set to unit length
  /// (1e-10, System::project()).
  void remember() noexcept;
  [[nodiscard]] bool knows(double t, std::span<const double> y) const noexcept;
  /// All blocks in order; false when the state is outside the model's validity.
  bool evaluate_blocks(double t, const double* y, double* dydt) noexcept;
  bool evaluate_timed(double t, const double* y, double* dydt) noexcept;
  bool evaluate_with_contributions(double t, const double* y, double* dydt,
                                   double* shares) noexcept;
  [[noreturn]] void throw_invalid(double t, const double* y) const;
  /// Clause with the reason why the last evaluated state is not valid.
  [[nodiscard]] std::string invalid_state_reason(const double* y) const;
  /// Of the state evaluated last.
  [[nodiscard]] EnergyLedger energy_ledger() const;
  void form_energy_ledger(EnergyLedger& out) const;
  [[nodiscard]] MomentumLedger momentum_ledger() const;
  void apply_scales();

  // For reports and between steps, into `rates`.
  const Evaluation& evaluate(double t, std::span<const double> y) override;
  /// Did a user routine reject a state since the last call, or fail entirely?
  [[nodiscard]] bool user_refuses() const noexcept;
  [[nodiscard]] RhsStatus status(bool valid) const noexcept;
  void begin(double t, const double* y, double* dydt) noexcept;
  [[nodiscard]] bool is_valid(double t, std::span<const double> y) noexcept override;
  [[nodiscard]] double stored_energy() const override;
  [[nodiscard]] Momenta momenta() const override;
  [[nodiscard]] const Scales& run_scales() const noexcept override { return scales; }

 private:
  void set_up_integrals();
  void set_up_border();
};

}  // namespace adore::dynamics
