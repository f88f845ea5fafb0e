#pragma once

#include "dynamics/system.hpp"
#include "integrators/stepper.hpp"

namespace adore::runs {

/// Adapter from dynamics::System to the integrators, which do not depend on bearings.
class SystemOde final : public integrators::OdeSystem {
 public:
  /// @param elastic energy of the quasi-static solution [J]; below 0: steps are not judged by
  /// energy
  explicit SystemOde(dynamics::System& system, double elastic = -1.0)
      : system_(system), elastic_(elastic) {}
  [[nodiscard]] int size() const noexcept override { return system_.layout().size(); }
  [[nodiscard]] int controlled_size() const noexcept override {
    return system_.layout().controlled_size();
  }
  [[nodiscard]] std::span<const double> scales() const noexcept override {
    return system_.layout().scales().first(static_cast<std::size_t>(controlled_size()));
  }
  integrators::EvalStatus rhs(double t, const double* y, double* dydt) noexcept override {
    return status(system_.rhs(t, y, dydt));
  }
  [[nodiscard]] bool has_stiff_part() const noexcept override { return system_.has_stiff_part(); }
  integrators::EvalStatus rhs_stiff(double t, const double* y, double* dydt) noexcept override {
    return status(system_.rhs_stiff(t, y, dydt));
  }
  [[nodiscard]] std::span<const int> blocks() const noexcept override { return system_.coupling(); }
  [[nodiscard]] bool blocks_form_ring() const noexcept override {
    return system_.neighbours_meet();
  }
  integrators::EvalStatus rhs_with_contributions(integrators::RhsPart part, double t,
                                                 const double* y, double* dydt,
                                                 double* shares) noexcept override {
    // The stiff part holds no rate of the border, which is what the default says.
    if (part == integrators::RhsPart::Stiff) {
      return OdeSystem::rhs_with_contributions(part, t, y, dydt, shares);
    }
    return status(system_.rhs_with_contributions(t, y, dydt, shares));
  }
  [[nodiscard]] double step_guard(double t) const noexcept override {
    return system_.longest_step(t);
  }
  bool project(double t, double* y) noexcept override { return system_.project(t, y); }
  /// Energy: the ledger closes but for the error of the steps (decision 392). Its scale is the mean
  /// of the elastic energy at the start of the run and now.
  [[nodiscard]] Kept kept() noexcept override {
    if (elastic_ < 0.0) return {};
    const dynamics::System::EnergyBalance now = system_.energy_balance();
    return {now.balance, 0.5 * (elastic_ + now.elastic), kRounding * now.size};
  }
  [[nodiscard]] std::string component_name(int index) const override {
    return system_.layout().component_name(index);
  }

 private:
  static integrators::EvalStatus status(dynamics::RhsStatus status) noexcept {
    switch (status) {
      case dynamics::RhsStatus::Ok:
        return integrators::EvalStatus::Ok;
      case dynamics::RhsStatus::Retry:
        return integrators::EvalStatus::Retry;
      case dynamics::RhsStatus::Fail:
        break;
    }
    return integrators::EvalStatus::Fail;
  }

  /// Sums of some thousand products that nearly cancel.
  static constexpr double kRounding = 1e-13;
  dynamics::System& system_;
  double elastic_;
};

}  // namespace adore::runs
