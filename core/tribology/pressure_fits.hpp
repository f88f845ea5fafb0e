#pragma once

#include "tribology/laws/pressure_fit.hpp"

#include <functional>

/// Properties over pressure for laws of traction, at one temperature.
namespace adore::tribology {

struct PolynomialWithError {
  PressurePolynomial fit;
  double error = 0.0;  ///< largest distance on a grid between the points of the fit
};

/// @param value of the pressure [Pa], smooth from 0 to `end`
/// @param wanted error at which no more terms are taken; all of PressurePolynomial's if it is not
/// reached
[[nodiscard]] PolynomialWithError fit_over_pressure(const std::function<double(double)>& value,
                                                    double end, double wanted);

/// First pressure where ln μ reaches `limit`, at most `largest` [Pa]. ln μ rises with pressure.
[[nodiscard]] double pressure_at_viscosity(const std::function<double(double)>& log_viscosity,
                                           double limit, double largest);

}  // namespace adore::tribology
