#include "life/depth_integral.hpp"

#include "base/errors.hpp"
#include "base/gauss.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

namespace adore::life {
namespace {

struct Node {
  double depth, weight, amplitude;
};

/// Depths 0..12: beyond, τ ~ 1/z makes the integrand fall as z^-(c+h). ζ = s² softens the root at
/// the surface.
const std::vector<Node>& nodes() {
  static const std::vector<Node> table = [] {
    std::vector<Node> out;
    constexpr double kBreaks[] = {0.0, 0.15, 0.3, 0.45, 0.6, 0.75, 0.9, 1.1, 1.4, 2.0, 3.5};
    for (std::size_t i = 0; i + 1 < std::size(kBreaks); ++i) {
      const double half = 0.5 * (kBreaks[i + 1] - kBreaks[i]);
      const double mid = 0.5 * (kBreaks[i + 1] + kBreaks[i]);
      for (const GaussPoint& g : kGauss20) {
        const double s = mid + half * g.node;
        out.push_back({s * s, half * g.weight * 2.0 * s, line_shear_amplitude(s * s)});
      }
    }
    return out;
  }();
  return table;
}

}  // namespace

double line_shear(double x, double z) noexcept {
  const double difference = 1.0 - x * x + z * z;
  const double root = std::hypot(difference, 2.0 * x * z);
  const double m2 = 0.5 * (root + difference);
  const double n2 = 0.5 * (root - difference);
  if (!(m2 + n2 > 0.0)) return 0.0;
  return std::sqrt(std::max(n2, 0.0)) * std::abs(m2 - z * z) / (m2 + n2);
}

double line_shear_amplitude(double z) noexcept {
  // One maximum over x > 0; golden section around the best of a scan.
  constexpr int kSteps = 40;
  const double reach = 1.5 + 2.0 * z;
  int best = 1;
  for (int k = 2; k < kSteps; ++k)
    if (line_shear(reach * k / kSteps, z) > line_shear(reach * best / kSteps, z)) best = k;
  double low = reach * (best - 1) / kSteps, high = reach * (best + 1) / kSteps;
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  while (high - low > 1e-8) {
    const double left = high - golden * (high - low), right = low + golden * (high - low);
    (line_shear(left, z) >= line_shear(right, z) ? high : low) =
        line_shear(left, z) >= line_shear(right, z) ? right : left;
  }
  return line_shear(0.5 * (low + high), z);
}

double depth_integral(double limit_ratio, double c, double h) {
  if (!(limit_ratio >= 0.0) || !(0.5 * c > h - 1.0))
    throw InputError(
        fmt::format("Ioannides-Harris model: the stress exponent {} and the depth exponent {} give "
                    "an infinite depth integral at the surface; the stress exponent must be larger "
                    "than 2 x (depth exponent - 1)",
                    c, h));
  double sum = 0.0;
  for (const Node& node : nodes())
    if (node.amplitude > limit_ratio)
      sum += node.weight * std::pow(node.amplitude - limit_ratio, c) * std::pow(node.depth, -h);
  return sum;
}

}  // namespace adore::life
