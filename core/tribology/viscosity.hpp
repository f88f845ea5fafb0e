#pragma once

#include "tribology/viscosity/double_exponential.hpp"
#include "tribology/viscosity/hybrid.hpp"
#include "tribology/viscosity/quadratic_exponential.hpp"
#include "tribology/viscosity/roelands.hpp"
#include "tribology/viscosity/type_one.hpp"
#include "tribology/viscosity/type_two.hpp"
#include "tribology/viscosity/vogel_scaling.hpp"
#include "tribology/viscosity/walther.hpp"
#include "tribology/viscosity/yasutomi.hpp"

#include <functional>
#include <string_view>
#include <variant>

/// Viscosity over pressure and temperature as a value: one of the laws of viscosity/, each in a
/// separate file. SI, kelvin, never above 1e12 Pa s (the glass).
namespace adore::tribology {

class Viscosity {
 public:
  using Law =
      std::variant<TypeTwoViscosity, TypeOneViscosity, RoelandsViscosity,
                   DoubleExponentialViscosity, QuadraticExponentialViscosity, WaltherViscosity,
                   YasutomiViscosity, HybridViscosity, VogelScalingViscosity>;

  Viscosity() = default;
  Viscosity(Law law) : law_(law) {}  // NOLINT: a law is a viscosity

  [[nodiscard]] double log_at(double pressure, double temperature) const;
  /// μ [Pa s].
  [[nodiscard]] double at(double pressure, double temperature) const;
  /// α = ∂ln μ/∂p at p = 0 [1/Pa], by formula.
  [[nodiscard]] double pressure_coefficient(double temperature) const;
  /// β = -∂ln μ/∂T [1/K], by a central difference over ±0.01 K (relative error some 1e-9); 0 in the
  /// glass.
  [[nodiscard]] double temperature_coefficient(double pressure, double temperature) const;

 private:
  Law law_;
};

/// The law called `name` in resources/lubricants.json ("typeI", "typeII", "roelands",
/// "doubleExponential", "expQuadratic", "waltherDensity", "yasutomiImproved", "hybrid",
/// "vogelScaling").
/// @param value its constants by their names there
/// @throws InputError naming the laws
[[nodiscard]] Viscosity viscosity_law(std::string_view name,
                                      const std::function<double(const char*)>& value);

}  // namespace adore::tribology
