#include "runs/film_tolerance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace adore::runs {

double FilmTolerance::wanted(const dynamics::System& system, double now) const {
  const bool tight = now < tolerance_;
  const double near = (tight ? 2.0 : 1.0) * kNear * velocity_;
  const double speed = system.speed_to_resolve(near);
  if (!std::isfinite(speed) || tolerance_ * velocity_ <= kCoarse * speed) return tolerance_;
  const double wanted =
      std::clamp(kResolved * speed / velocity_, std::min(kTightest, tolerance_), tolerance_);
  // Each change restarts the method.
  constexpr double kWorthwhile = 3.0;
  return tight && wanted * kWorthwhile > now ? now : wanted;
}

std::string film_tolerance_text(double tolerance, double tightest, double share) {
  return fmt::format(
      "films broke down where contacts slid without rolling. For {:.3g} % of the time the run "
      "used a tolerance down to {:.2g}, because the specified tolerance of {:g} cannot resolve "
      "this",
      100.0 * share, tightest, tolerance);
}

}  // namespace adore::runs
