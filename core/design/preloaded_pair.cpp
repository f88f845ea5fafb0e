#include "design/preloaded_pair.hpp"

#include "base/errors.hpp"

#include <cmath>

namespace adore::design {

PairStiffness pair_stiffness(const statics::RaceResult& a, const statics::RaceResult& b) noexcept {
  return {a.stiffness(0, 0) + b.stiffness(0, 0), a.stiffness(2, 2) + b.stiffness(2, 2)};
}

double pair_offset(const RowUnderThrust& row, double from, double to) {
  return 2.0 * (row(to).displacement[0] - row(from).displacement[0]);
}

double unloading_force(const RowUnderThrust& row, double preload, double free) {
  const double aim = 2.0 * (row(preload).displacement[0] - free);
  double force = std::pow(2.0, 1.5) * preload;
  // Newton with the row's own stiffness; δ(F) is smooth and rises.
  for (int n = 0; n < 20; ++n) {
    const statics::RaceResult at = row(force);
    const double step = (aim - (at.displacement[0] - free)) * at.stiffness(0, 0);
    force += step;
    if (std::abs(step) < 1e-6 * force) return force;
  }
  throw SolverError("the search for the force that unloads one row of the pair did not converge");
}

}  // namespace adore::design
