#include "runs/film_tolerance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace adore::runs {

double FilmTolerance::wanted(const dynamics::System& system, double now) const {
  const bool tight = now < deck_tolerance_;
  const double near = (tight ? 2.0 : 1.0) * kSlowRolling * velocity_scale_;
  const double speed = system.speed_to_resolve(near);
  if (!std::isfinite(speed) || deck_tolerance_ * velocity_scale_ <= kUnresolvedShare * speed)
    return deck_tolerance_;
  const double wanted = std::clamp(kResolvedShare * speed / velocity_scale_,
                                   std::min(kMinTolerance, deck_tolerance_), deck_tolerance_);
  // Each change restarts the method.
  constexpr double kMinRelaxation = 3.0;
  return tight && wanted * kMinRelaxation > now ? now : wanted;
}

std::string film_tolerance_text(double tolerance, double tightest, double share) {
  return fmt::format(
      "for {:.3g} % of the time, the run used a smaller tolerance (down to {:.2g}) than specified "
      "({:g}), because oil films collapsed in contacts that slid without rolling",
      100.0 * share, tightest, tolerance);
}

}  // namespace adore::runs
