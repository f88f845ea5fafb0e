#include "runs/film_precision.hpp"

#include "tribology/film_law.hpp"

#include <string_view>

namespace adore::runs {
namespace {

constexpr double kMinTolerance = 1e-6;  // that floats do not disturb (decision 460)

/// Does it evaluate the right-hand side for its steps alone?
bool is_explicit(std::string_view method) {
  return method.starts_with("rk") || method.starts_with("pece") || method == "arkode-erk";
}

}  // namespace

void choose_film_precision(Prepared& prepared) {
  const auto& oil = prepared.as_built.lubrication;
  if (!oil) return;
  const setup::RunControl& control = prepared.control;
  // Strips of balls are read by floats with two nodes across (ellipse_sum.hpp).
  const bool wide_strips =
      tribology::lubricant_of(*oil).model == tribology::LubricantModel::ViscoElastic &&
      prepared.as_built.rollers() == nullptr && prepared.options.system.ellipse_minor != 2;
  prepared.options.system.single_films =
      prepared.options.single_films && !prepared.options.direct_strips && control.dynamic &&
      prepared.input.deck.integer("mode") == 0 && !(control.light_load_ratio > 0.0) &&
      control.tolerance >= kMinTolerance && !wide_strips && is_explicit(control.integrator);
}

}  // namespace adore::runs
