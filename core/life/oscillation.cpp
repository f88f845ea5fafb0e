#include "life/oscillation.hpp"

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "life/constants.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace adore::life {

Oscillation oscillation(const OscillationInput& in) {
  if (in.count < 2 || !(in.gamma >= 0.0 && in.gamma < 1.0))
    throw InputError(fmt::format(
        "oscillation: Z = {} (number of rolling elements), gamma = {:.4g} (D cos(alpha)/d_m): Z "
        "must be 2 or more, and gamma must be 0 or more and below 1.",
        in.count, in.gamma));
  if (!(in.swing > 0.0))
    throw InputError("swing: it must be above 0. Enter the angle between both end positions.");
  const double slope = in.ball ? constants().point_slope.value : constants().line_slope.value;
  Oscillation out;
  out.cycles_per_revolution = std::numeric_limits<double>::infinity();
  for (const bool inner : {false, true}) {
    const double passes = in.count * (inner ? 1.0 + in.gamma : 1.0 - in.gamma);
    const double critical = 4.0 * kPi / passes;
    (inner ? out.critical_inner : out.critical_outer) = critical;
    const bool below = in.swing < critical;
    out.below_critical = out.below_critical || below;
    const double cycles =
        below ? 0.25 * passes * std::pow(critical / in.swing, 1.0 / slope) : kPi / in.swing;
    out.cycles_per_revolution = std::min(out.cycles_per_revolution, cycles);
  }
  out.false_brinelling = in.swing < 0.5 * std::min(out.critical_inner, out.critical_outer);
  return out;
}

}  // namespace adore::life
