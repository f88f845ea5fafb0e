#include "contact/elliptic.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace adore::contact {

CompleteElliptic complete_elliptic(double mc) noexcept {
  const double m = 1.0 - mc;
  // c_n of the mean is m times d_n for n >= 1, so sums of c_n² keep their relative accuracy as m ->
  // 0.
  double a = 1.0;
  double b = std::sqrt(mc);
  double a_next = 0.5 * (a + b);
  double d = 0.25 / a_next;
  double weight = 1.0;  // 2^(n-1)
  double sum = d * d;
  for (int n = 0; n < 40; ++n) {
    b = std::sqrt(a * b);
    a = a_next;
    if (std::abs(a - b) <= 1e-16 * a) {
      break;
    }
    a_next = 0.5 * (a + b);
    d = m * d * d / (4.0 * a_next);
    weight *= 2.0;
    sum += weight * d * d;
  }
  CompleteElliptic result{};
  result.K = std::numbers::pi / (2.0 * a);
  result.C = 2.0 * result.K * sum;
  result.D = 0.5 * (result.K + m * result.C);
  result.B = 0.5 * (result.K - m * result.C);
  result.E = result.B + mc * result.D;
  return result;
}

double carlson_rd(double x, double y, double z) noexcept {
  double sum = 0.0;
  double factor = 1.0;
  double mean = 0.2 * (x + y + 3.0 * z);
  const double spread = std::max({std::abs(mean - x), std::abs(mean - y), std::abs(mean - z)}) /
                        std::pow(0.25e-16, 1.0 / 6.0);
  const double dx0 = mean - x;
  const double dy0 = mean - y;
  for (int n = 0; n < 60 && factor * spread > std::abs(mean); ++n) {
    const double root_x = std::sqrt(x);
    const double root_y = std::sqrt(y);
    const double root_z = std::sqrt(z);
    const double lambda = root_x * root_y + root_x * root_z + root_y * root_z;
    sum += factor / (root_z * (z + lambda));
    factor *= 0.25;
    x = 0.25 * (x + lambda);
    y = 0.25 * (y + lambda);
    z = 0.25 * (z + lambda);
    mean = 0.25 * (mean + lambda);
  }
  const double dx = factor * dx0 / mean;
  const double dy = factor * dy0 / mean;
  const double dz = -(dx + dy) / 3.0;
  const double e2 = dx * dy - 6.0 * dz * dz;
  const double e3 = (3.0 * dx * dy - 8.0 * dz * dz) * dz;
  const double e4 = 3.0 * (dx * dy - dz * dz) * dz * dz;
  const double e5 = dx * dy * dz * dz * dz;
  const double series = 1.0 - 3.0 * e2 / 14.0 + e3 / 6.0 + 9.0 * e2 * e2 / 88.0 - 3.0 * e4 / 22.0 -
                        9.0 * e2 * e3 / 52.0 + 3.0 * e5 / 26.0;
  return 3.0 * sum + factor * series / (mean * std::sqrt(mean));
}

}  // namespace adore::contact
