#pragma once

#include "dynamics/system.hpp"
#include "integrators/stepper.hpp"

namespace adore::facade {

/// Shows a dynamics::System to the integrators, which know no bearings.
class SystemOde final : public integrators::OdeSystem {
 public:
  explicit SystemOde(dynamics::System& system) : system_(system) {}
  [[nodiscard]] int size() const noexcept override { return system_.layout().size(); }
  [[nodiscard]] int controlled_size() const noexcept override {
    return system_.layout().controlled_size();
  }
  [[nodiscard]] std::span<const double> scales() const noexcept override {
    return system_.layout().scales().first(static_cast<std::size_t>(controlled_size()));
  }
  integrators::EvalStatus rhs(double t, const double* y, double* dydt) noexcept override {
    switch (system_.rhs(t, y, dydt)) {
      case dynamics::RhsStatus::Ok:
        return integrators::EvalStatus::Ok;
      case dynamics::RhsStatus::Retry:
        return integrators::EvalStatus::Retry;
      case dynamics::RhsStatus::Fail:
        break;
    }
    return integrators::EvalStatus::Fail;
  }
  bool project(double t, double* y) noexcept override { return system_.project(t, y); }
  [[nodiscard]] std::string component_name(int index) const override {
    return system_.layout().component_name(index);
  }

 private:
  dynamics::System& system_;
};

}  // namespace adore::facade
