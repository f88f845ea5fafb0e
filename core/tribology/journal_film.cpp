#include "tribology/journal_film.hpp"

#include "base/gauss.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace adore::tribology {

JournalForce journal_force(const JournalFilm& film, const JournalMotion& motion) {
  const double pi = std::numbers::pi, e = motion.eccentricity;
  const double wedge = 0.5 * e * (motion.journal + motion.bearing - 2.0 * motion.attitude_rate);
  const double R = film.radius, L = film.length, c = film.clearance;
  const double scale = film.viscosity * R * L * L * L / (c * c), root2 = 1.0 - e * e;
  JournalForce out;
  if (motion.squeeze == 0.0) {
    out.radial = -scale * 2.0 * std::abs(wedge) * e / (root2 * root2);
    out.tangential = scale * wedge * 0.5 * pi / (root2 * std::sqrt(root2));
  } else {
    const double from = std::atan2(motion.squeeze, wedge);
    // Panels of 20 points: 12 see the peak of ε = 0.99 to 1e-12.
    const int panels = 2 + static_cast<int>(std::min(30.0, 1.0 / std::sqrt(root2)));
    for (int panel = 0; panel < panels; ++panel)
      for (const GaussPoint& point : kGauss20) {
        const double theta = from + pi * (2 * panel + 1 + point.node) / (2 * panels);
        const double gap = 1.0 + e * std::cos(theta);
        const double p = std::max(
            0.0, (wedge * std::sin(theta) - motion.squeeze * std::cos(theta)) / (gap * gap * gap));
        const double weight = scale * p * point.weight * pi / (2 * panels);
        out.radial += weight * std::cos(theta);
        out.tangential += weight * std::sin(theta);
      }
  }
  const double shear = 2.0 * pi * film.viscosity * R * R * R * L *
                       (motion.journal - motion.bearing) / (c * std::sqrt(root2));
  const double couple = 0.5 * c * e * out.tangential;
  out.torque_journal = -(shear + couple);
  out.torque_bearing = shear - couple;
  return out;
}

}  // namespace adore::tribology
