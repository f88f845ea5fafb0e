#include "contact/roller_inertia.hpp"

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "base/gauss.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace adore::contact {
namespace {

/// ∫ρ² ds, ∫sρ² ds, ∫s²ρ² ds, ∫ρ⁴ ds.
struct SectionMoments {
  double square = 0.0, first = 0.0, second = 0.0, fourth = 0.0;

  void add(double s, double rho, double ds) {
    const double area = rho * rho * ds;
    square += area;
    first += s * area;
    second += s * s * area;
    fourth += rho * rho * area;
  }
};

template <class Visit>
void over(double from, double to, const Visit& visit) {
  if (!(to > from)) return;
  for (const GaussPoint& g : kGauss20)
    visit(0.5 * (from + to) + 0.5 * (to - from) * g.node, 0.5 * (to - from) * g.weight);
}

void add_end(SectionMoments& sum, const RollerEnd& e) {
  double from_angle = 0.0;  // of the tube normal, where the end face passes into the corner
  if (!e.flat()) {
    const double reach = std::hypot(e.ring - e.dome_centre, e.ring_radius);
    from_angle = std::atan2(e.ring_radius, e.ring - e.dome_centre);
    const double cap = e.dome_centre + e.end_radius * (e.ring - e.dome_centre) / reach;
    over(cap, e.vertex, [&](double v, double dv) {
      const double from_centre = v - e.dome_centre;
      sum.add(e.sign * v, std::sqrt((e.end_radius - from_centre) * (e.end_radius + from_centre)),
              dv);
    });
  }
  over(from_angle, e.side_angle, [&](double angle, double d_angle) {
    const double sine = std::sin(angle);
    sum.add(e.sign * (e.ring + e.corner_radius * std::cos(angle)),
            e.ring_radius + e.corner_radius * sine, e.corner_radius * sine * d_angle);
  });
}

}  // namespace

RollerInertia roller_inertia(const RollerProfile& given, double density, bool with_corners) {
  if (!(std::isfinite(density) && density > 0.0))
    throw InputError(
        fmt::format("roller: the density is {} kg/m^3; it must be a positive number", density));
  RollerProfile profile = given;
  if (!with_corners) profile.corner_radius = {};
  check_roller_profile(profile);
  SectionMoments sum;
  std::array<double, 4> breaks{};
  for (int end = 0; end < 2; ++end) {
    const RollerEnd e = roller_end(profile, end);
    add_end(sum, e);
    breaks[end == 0 ? 0U : 3U] = e.sign * e.side_v;
  }
  const bool land = profile.kind == RollerProfile::Kind::Crowned;
  for (std::size_t k = 1; k < 3; ++k) {
    const double edge = profile.land_offset + (k == 1 ? -0.5 : 0.5) * profile.central_length;
    breaks[k] = land ? std::clamp(edge, breaks[0], breaks[3]) : 0.0;
  }
  for (std::size_t k = 0; k < 3; ++k)
    over(breaks[k], breaks[k + 1],
         [&](double s, double ds) { sum.add(s, roller_radius(profile, s), ds); });

  RollerInertia inertia;
  inertia.mass = kPi * density * sum.square;
  inertia.mass_centre = sum.first / sum.square;
  inertia.axial = 0.5 * kPi * density * sum.fourth;
  inertia.transverse =
      kPi * density * (0.25 * sum.fourth + sum.second - sum.first * inertia.mass_centre);
  return inertia;
}

}  // namespace adore::contact
