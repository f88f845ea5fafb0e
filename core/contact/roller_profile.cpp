#include "contact/roller_profile.hpp"

#include "base/errors.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace adore::contact {
namespace {

constexpr double kHalfPi = 1.57079632679489661923;

void require_positive(double value, const char* name) {
  if (!(std::isfinite(value) && value > 0.0))
    throw InputError(
        fmt::format("roller: the {} is {} m; it must be a positive number", name, value));
}

/// The tube centre that touches the side at s, as (v, ρ).
std::array<double, 2> tube_centre(const RollerProfile& p, int sign, double corner, double v) {
  const double slope = sign * roller_slope(p, sign * v);  // dρ/dv
  const double root = std::sqrt(1.0 + slope * slope);
  return {v + corner * slope / root, roller_radius(p, sign * v) - corner / root};
}

}  // namespace

void check_roller_profile(const RollerProfile& p) {
  require_positive(p.diameter, "diameter");
  require_positive(p.length, "length");
  if (!(p.crown_radius > 0.0))
    throw InputError(
        fmt::format("roller: the crown radius is {} m; it must be positive (a large number for a "
                    "straight roller)",
                    p.crown_radius));
  if (!(p.half_angle >= 0.0 && p.half_angle < kHalfPi))
    throw InputError(fmt::format("roller: the half angle is {} rad; it must be between 0 and π/2",
                                 p.half_angle));
  if (!(p.corner_radius[0] >= 0.0 && p.corner_radius[1] >= 0.0))
    throw InputError(
        fmt::format("roller: the corner radii are {} and {} m; they must not be negative",
                    p.corner_radius[0], p.corner_radius[1]));
  if (!(effective_length(p) > 0.0))
    throw InputError(
        fmt::format("roller: the corner radii {} and {} m use up the whole length {} m; enter "
                    "smaller corner radii",
                    p.corner_radius[0], p.corner_radius[1], p.length));
  const bool crowned = p.kind == RollerProfile::Kind::Crowned;
  for (const double s : {-0.5 * p.length, 0.5 * p.length}) {
    const double reach = crowned
                             ? std::max(std::abs(s - p.land_offset) - 0.5 * p.central_length, 0.0)
                             : std::abs(s + p.crown_radius * std::sin(p.half_angle));
    if (std::isfinite(reach) && !(reach < p.crown_radius))
      throw InputError(
          fmt::format("roller: the crown radius {} m does not reach the end at s = {} m; it must "
                      "be larger than {} m",
                      p.crown_radius, s, reach));
    if (!(roller_radius(p, s) > 0.0))
      throw InputError(
          fmt::format("roller: the radius at the end s = {} m is {} m; reduce crown or half angle "
                      "so that this radius is positive",
                      s, roller_radius(p, s)));
  }
  for (int end = 0; end < 2; ++end) (void)roller_end(p, end);
}

RollerEnd roller_end(const RollerProfile& p, int end) {
  const auto index = static_cast<std::size_t>(end);
  RollerEnd e;
  e.sign = end == 0 ? -1 : 1;
  e.vertex = 0.5 * p.length;
  e.corner_radius = p.corner_radius[index];
  const bool flat = is_flat_end(p, end);
  e.end_radius = flat ? std::numeric_limits<double>::infinity() : p.end_radius[index];
  e.dome_centre = flat ? 0.0 : e.vertex - e.end_radius;
  const double r = e.corner_radius;
  if (!flat && !(e.end_radius > r && e.end_radius > 0.0))
    throw InputError(
        fmt::format("roller: the radius of end {} is {} m; it must be larger than the corner "
                    "radius {} m, or 0 for a "
                    "flat end",
                    end + 1, e.end_radius, r));
  // How far the tube centre lies beyond the place where it touches the end; rises with v.
  const auto beyond = [&](double v) {
    const auto [vc, rho] = tube_centre(p, e.sign, r, v);
    return flat ? vc - (e.vertex - r) : std::hypot(vc - e.dome_centre, rho) - (e.end_radius - r);
  };
  double low = 0.0, high = e.vertex;
  if (beyond(high) <= 0.0) low = high;  // a sharp flat edge: the side ends on the end face
  if (low < high && beyond(low) >= 0.0)
    throw InputError(
        fmt::format("roller: end {} with radius {} m and corner radius {} m does not fit a roller "
                    "of diameter {} m and "
                    "length {} m; give a larger end radius or a smaller corner",
                    end + 1, e.end_radius, r, p.diameter, p.length));
  for (int n = 0; n < 100 && low < high; ++n) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) break;
    (beyond(middle) < 0.0 ? low : high) = middle;
  }
  e.side_v = high;
  const auto [vc, rho] = tube_centre(p, e.sign, r, high);
  if (!(rho > 0.0))
    throw InputError(
        fmt::format("roller: the corner radius {} m of end {} is too large for this roller; it "
                    "must be below {} m",
                    r, end + 1, rho + r));
  e.ring = vc;
  e.ring_radius = rho;
  e.cap_radius = flat ? rho : rho * e.end_radius / (e.end_radius - r);
  e.side_angle = kHalfPi + std::atan(e.sign * roller_slope(p, e.sign * high));
  return e;
}

Slicing slicing(const RollerProfile& profile, int count) {
  if (count < 1)
    throw InputError(
        fmt::format("the number of roller slices is {}; it must be at least 1", count));
  Slicing s;
  s.count = count;
  s.effective_length = effective_length(profile);
  if (!(s.effective_length > 0.0))
    throw InputError(fmt::format(
        "roller: the length {} m minus the corner radii {} and {} m leaves no length to slice",
        profile.length, profile.corner_radius[0], profile.corner_radius[1]));
  s.width = s.effective_length / count;
  s.start = -0.5 * profile.length + profile.corner_radius[0];
  return s;
}

std::vector<RollerSlice> roller_slices(const RollerProfile& profile, const Slicing& slicing) {
  std::vector<RollerSlice> slices(static_cast<std::size_t>(slicing.count));
  for (int k = 0; k < slicing.count; ++k) {
    const double s = slicing.centre(k);
    slices[static_cast<std::size_t>(k)] = {s, roller_radius(profile, s)};
  }
  return slices;
}

int suggested_slice_count(const RollerProfile& profile, double penetration) {
  const double whole = effective_length(profile);
  const double contact =
      std::min(std::sqrt(8.0 * profile.crown_radius * std::max(penetration, 0.0)), whole);
  if (!(contact > 0.0)) return 31;
  return static_cast<int>(std::clamp(std::ceil(20.0 * whole / contact), 20.0, 1000.0));
}

}  // namespace adore::contact
