#include "contact/guide_land.hpp"

#include "base/constants.hpp"
#include "base/gauss.hpp"
#include "contact/race_wave.hpp"

#include <vector>

namespace adore::contact {
namespace {

/// One slice of a land at a pose: point and gap over the cage azimuth.
struct Slice {
  const LandPair& land;
  double x;
  const Vec3& g;
  Mat3 cage_to_race;

  [[nodiscard]] Vec3 point(double psi) const {
    const double R = land.cage.at(psi)[0];
    return g + cage_to_race * Vec3(x, -R * std::sin(psi), R * std::cos(psi));
  }
  [[nodiscard]] double gap(double psi) const {
    const Vec3 P = point(psi);
    const double h = land.race.at(azimuth(P))[0] - std::hypot(P[1], P[2]);
    return land.outer ? h : -h;
  }
  /// ∇h with respect to P, race axes.
  [[nodiscard]] Vec3 gradient(const Vec3& P) const {
    const double psi = azimuth(P), r = std::hypot(P[1], P[2]);
    const Vec3 v =
        -radial_direction(psi) + land.race.at(psi)[1] / r * circumferential_direction(psi);
    return land.outer ? v : Vec3(-v);
  }
};

int grid_size(const LandPair& land) {
  double waves = 2.0;
  for (const LandProfile* profile : {&land.cage, &land.race})
    if (profile->kind == LandProfile::Kind::Wave)
      waves = std::max(waves, std::abs(profile->variation_2) + 1.0);
  return 32 * static_cast<int>(std::ceil(waves));
}

/// Local minimum of the gap in [a, b] by golden section, then parabolic polish of the argument.
double local_minimum(const Slice& slice, double a, double b) {
  constexpr double kGolden = 0.61803398874989484820;
  double c = b - kGolden * (b - a), d = a + kGolden * (b - a);
  double fc = slice.gap(c), fd = slice.gap(d);
  while (b - a > 1e-4) {
    if (fc < fd) {
      b = d, d = c, fd = fc;
      c = b - kGolden * (b - a);
      fc = slice.gap(c);
    } else {
      a = c, c = d, fc = fd;
      d = a + kGolden * (b - a);
      fd = slice.gap(d);
    }
  }
  double psi = 0.5 * (a + b);
  for (int i = 0; i < 4; ++i) {  // parabola through three points: the gap is smooth
    const double s = 1e-3, left = slice.gap(psi - s), middle = slice.gap(psi),
                 right = slice.gap(psi + s);
    const double bend = left - 2 * middle + right;
    if (!(bend > 0.0)) break;
    psi += std::clamp(0.5 * s * (left - right) / bend, -s, s);
  }
  return psi;
}

/// Azimuths of all local minima of the gap.
std::vector<double> local_minima(const Slice& slice, int n) {
  std::vector<double> gap(static_cast<std::size_t>(n)), minima;
  const double step = 2 * kPi / n;
  for (int i = 0; i < n; ++i) gap[static_cast<std::size_t>(i)] = slice.gap(i * step);
  for (int i = 0; i < n; ++i) {
    const double here = gap[static_cast<std::size_t>(i)];
    const double before = gap[static_cast<std::size_t>((i + n - 1) % n)];
    const double after = gap[static_cast<std::size_t>((i + 1) % n)];
    if (here <= before && here < after)
      minima.push_back(local_minimum(slice, (i - 1) * step, (i + 1) * step));
  }
  if (minima.empty()) minima.push_back(0.0);  // the same gap all around
  return minima;
}

double root(const Slice& slice, double open, double closed) {
  for (int i = 0; i < 60 && std::abs(open - closed) > 1e-15; ++i) {
    const double middle = 0.5 * (open + closed);
    (slice.gap(middle) > 0.0 ? open : closed) = middle;
  }
  return 0.5 * (open + closed);
}

/// Adds the contact over [a, b], where the gap is negative throughout.
void add_interval(const Slice& slice, double a, double b, double k_w_share, LandLoad& sum) {
  const double half = 0.5 * (b - a), middle = 0.5 * (a + b);
  for (const GaussPoint& point : kGauss20) {
    const double weight = point.weight * half;
    const double psi = middle + half * point.node;
    const double h = std::min(slice.gap(psi), 0.0);
    const Vec3 P = slice.point(psi);
    const double pressure = k_w_share * weight * slice.land.cage.radius * (-h);
    const Vec3 force = pressure * slice.gradient(P);
    sum.force += force;
    sum.moment += (P - slice.g).cross(force);
    sum.energy += 0.5 * pressure * (-h);
  }
}

}  // namespace

std::array<double, 2> LandProfile::at(double psi) const noexcept {
  switch (kind) {
    case Kind::Circle:
      break;
    case Kind::Wave: {
      const double N = variation_2, s = std::sin(N * psi + phase), c = std::cos(N * psi + phase);
      return {radius + variation_1 * s, variation_1 * N * c};
    }
    case Kind::Ellipse: {
      const double p = 1 / ((radius + variation_1) * (radius + variation_1));
      const double q = 1 / ((radius + variation_2) * (radius + variation_2));
      const auto [R, slope] = oval_radius(q, p, std::cos(psi), std::sin(psi));
      return {R, slope};
    }
  }
  return {radius, 0.0};
}

LandGap min_land_gap(const LandPair& land, double x, const Vec3& g, const Mat3& race_to_cage) {
  const Slice slice{land, x, g, race_to_cage.transpose()};
  LandGap best;
  bool first = true;
  for (const double psi : local_minima(slice, grid_size(land))) {
    const double h = slice.gap(psi);
    if (!first && h >= best.gap) continue;
    first = false;
    best = {h, std::fmod(psi + 4 * kPi, 2 * kPi), slice.point(psi)};
  }
  return best;
}

LandLoad land_load(const LandPair& land, double E_star, const Vec3& g, const Mat3& race_to_cage) {
  const double k_w = 3 * kPi * E_star / (16 * land.cage.radius);
  LandLoad sum;
  for (int k = 0; k < land.slices; ++k) {
    const Slice slice{land, slice_position(land, k), g, race_to_cage.transpose()};
    const double share = k_w * land.width / land.slices;
    const int n = grid_size(land);
    // Break points: the grid and every local minimum, so that no spot falls between two grid
    // points.
    std::vector<double> psi = local_minima(slice, n);
    for (double& value : psi) value = std::fmod(value + 4 * kPi, 2 * kPi);
    for (int i = 0; i < n; ++i) psi.push_back(2 * kPi * i / n);
    std::sort(psi.begin(), psi.end());
    for (std::size_t i = 0; i < psi.size(); ++i) {
      const double a = psi[i], b = i + 1 < psi.size() ? psi[i + 1] : psi[0] + 2 * kPi;
      const bool in_a = slice.gap(a) < 0.0, in_b = slice.gap(b) < 0.0;
      if (in_a && in_b)
        add_interval(slice, a, b, share, sum);
      else if (in_a)
        add_interval(slice, a, root(slice, b, a), share, sum);
      else if (in_b)
        add_interval(slice, root(slice, a, b), b, share, sum);
    }
  }
  return sum;
}

}  // namespace adore::contact
