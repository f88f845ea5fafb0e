#pragma once

#include "studies/points.hpp"

#include <string>
#include <vector>

/// Derivatives of every quantity over every variable.
///
/// By differences: five runs per variable, at -2, -1, 0, 1 and 2 steps, all with the same
/// integrator, tolerance and end, so that errors of the integration that both sides share drop out:
///   d1 = (f(1) - f(-1)) / 2h,  d2 = (f(2) - f(-2)) / 4h,  derivative = (4 d1 - d2) / 3
/// whose error is of fourth order in h; |d1 - d2| / 3 bounds the rest of second order and is
/// printed with it: for an irregular motion it is as large as the derivative. Of an equilibrium
/// exactly: static_sensitivity.hpp.
namespace adore::studies {

/// The base, then -2, -1, 1, 2 steps of each variable. @throws InputError for a variable whose base
/// value is 0 and that has no step
[[nodiscard]] std::vector<Point> sensitivity_points(const Study& study);

/// The value of each variable in the base deck with the study's sets, and the step.
struct BaseValue {
  double value = 0.0, step = 0.0;
};
[[nodiscard]] std::vector<BaseValue> base_values(const Study& study, std::size_t deck);

struct Derivative {
  double value = 0.0;  ///< quantity (SI) over variable (the deck's unit)
  double doubt = 0.0;  ///< |d1 - d2| / 3
};
/// @param f at -2, -1, 1, 2 steps
[[nodiscard]] Derivative difference(const std::vector<double>& f, double step);

}  // namespace adore::studies
