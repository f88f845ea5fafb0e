#pragma once

#include "deck/units.hpp"

/// Units of the results that no deck variable has; everything else comes from deck/units.hpp.
/// A file value is the SI value divided by the factor of its unit.
namespace adore::results {

using deck::UnitPair;
using deck::UnitSystem;

namespace unit {
using namespace deck::unit;  // NOLINT(google-build-using-namespace): one vocabulary of units
inline constexpr UnitPair kRevolution{"rev", "rev", 2.0 * kPi, 2.0 * kPi};
inline constexpr UnitPair kPressure{"Pa", "lbf/in^2", 1.0, kStress.en_factor};
inline constexpr UnitPair kPower{"W", "in.lbf/s", 1.0, kPoundForce* kInch};
inline constexpr UnitPair kConductance{"W/K", "in.lbf/s/R", 1.0, kPoundForce* kInch * 1.8};
inline constexpr UnitPair kEnergy{"J", "in.lbf", 1.0, kPoundForce* kInch};
inline constexpr UnitPair kLife{"hr", "hr", 1.0, 1.0};  ///< the models deliver hours
inline constexpr UnitPair kStiffness{"N/m", "lbf/in", 1.0, kPoundForce / kInch};
inline constexpr UnitPair kRotationalStiffness{"N.m/rad", "lbf.in/rad", 1.0, kPoundForce* kInch};
inline constexpr UnitPair kCoupledStiffness{"N/rad", "lbf/rad", 1.0, kPoundForce};
inline constexpr UnitPair kHertzConstant{"N/m^1.5", "lbf/in^1.5", 1.0,
                                         kPoundForce / 0.004048093872429343};  // 0.0254^1.5
}  // namespace unit

[[nodiscard]] inline std::string_view unit_name(const UnitPair& unit, UnitSystem system) {
  return system == UnitSystem::SI ? unit.si : unit.en;
}
[[nodiscard]] inline double from_si(double value, const UnitPair& unit, UnitSystem system) {
  return value / (system == UnitSystem::SI ? unit.si_factor : unit.en_factor);
}
[[nodiscard]] inline double to_si(double value, const UnitPair& unit, UnitSystem system) {
  return value * (system == UnitSystem::SI ? unit.si_factor : unit.en_factor);
}

}  // namespace adore::results
