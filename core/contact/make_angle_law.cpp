#include "contact/make_angle_law.hpp"

#include "base/chebyshev.hpp"
#include "contact/groove.hpp"
#include "contact/hertz.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace adore::contact {
namespace {

/// Enough that what is cut off, not what is folded over, decides the error.
constexpr std::size_t kPoints = 32;

void fit(const std::vector<double>& values, double (&out)[HertzAngleLaw::kTerms]) {
  double largest = 0.0;
  for (const double v : values) largest = std::max(largest, std::abs(v));
  std::vector<double> relative(values);
  for (double& v : relative) v /= largest;
  std::vector<double> series = chebyshev_coefficients(relative);
  series.resize(HertzAngleLaw::kTerms, 0.0);
  const std::vector<double> powers = chebyshev_to_monomial(series);
  for (std::size_t k = 0; k < powers.size(); ++k) out[k] = largest * powers[k];
}

}  // namespace

HertzAngleLaw make_angle_law(const bearing::BallGeometry& balls, int race, double E_star) {
  const std::vector<double> points = chebyshev_points(kPoints);
  std::vector<double> K, major, minor;
  double kappa = 0.0;
  for (const double u : points) {
    const double cosine = race == 0 ? u : -u;
    const HertzConstants h =
        hertz_sensitivity(race_curvature(balls, race, std::acos(cosine)), E_star, kappa).constants;
    kappa = h.kappa;
    const double root_of_K = std::cbrt(h.K);  // Q^(1/3) = K^(1/3) sqrt(δ)
    K.push_back(h.K);
    major.push_back(h.a_hat * root_of_K);
    minor.push_back(h.b_hat * root_of_K);
  }
  HertzAngleLaw law;
  law.follows = true;
  fit(K, law.K);
  fit(major, law.major);
  fit(minor, law.minor);
  return law;
}

}  // namespace adore::contact
