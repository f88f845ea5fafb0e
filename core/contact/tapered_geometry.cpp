#include "contact/tapered_geometry.hpp"

#include "base/constants.hpp"
#include "base/errors.hpp"

#include <fmt/format.h>

#include <cmath>

namespace adore::contact {
namespace {

double groove_radius(double factor, double crown_radius, int race) {
  if (!(factor > 0.5))
    throw InputError(
        fmt::format("the curvature factor of the {} race is {}; it must be above 0.5 (at 0.5 the "
                    "groove radius is equal to the crown radius)",
                    race == bearing::kOuter ? "outer" : "inner", factor));
  if (!(std::isfinite(crown_radius) && crown_radius > 0.0))
    throw InputError(
        fmt::format("the crown radius is {} m; it must be a positive number", crown_radius));
  return 2.0 * factor * crown_radius;
}

/// Groove whose bottom point is `contact`, with n in (x, r) from the roller into the race.
RaceSurface groove_through(int race, const Meridian& contact, const Meridian& n, double r_g) {
  RaceSurface surface = groove_race(race, r_g, contact[0] - r_g * n[0], contact[1] - r_g * n[1]);
  surface.mid_x = contact[0];
  surface.mid_r = contact[1];
  const double towards_x = std::copysign(1.0, n[1]);  // the tangent that points to +x
  surface.along_x = towards_x * n[1];
  surface.along_r = -towards_x * n[0];
  return surface;
}

}  // namespace

TaperedGeometry tapered_geometry(double D, const std::array<double, 2>& race_angle) {
  const auto [outer, inner] = race_angle;
  if (!(std::isfinite(D) && D > 0.0))
    throw InputError(fmt::format(
        "tapered bearing: the roller diameter is {} m; it must be a positive number", D));
  if (!(inner > 0.0 && outer < 0.5 * kPi && std::isfinite(inner)))
    throw InputError(
        fmt::format("tapered bearing: the half angles of the races are {} rad (outer) and {} rad "
                    "(inner); both must be between 0 and π/2",
                    outer, inner));
  if (!(outer > inner))
    throw InputError(fmt::format(
        "tapered bearing: the half angle of the outer race, {} rad, is not larger than that of the "
        "inner race, {} rad. If the angles are equal, the apex and the pitch diameter are at "
        "infinity. Enter a larger outer angle or use a cylindrical roller bearing",
        outer, inner));
  TaperedGeometry g;
  g.race_angle = race_angle;
  g.half_angle = 0.5 * (outer - inner);
  g.axis_angle = 0.5 * (outer + inner);
  const double tangent = std::tan(g.half_angle), sine = std::sin(g.axis_angle),
               cosine = std::cos(g.axis_angle);
  g.pitch_diameter = D * sine / tangent;
  if (g.pitch_diameter > kLargestPitchRatio * D)
    throw InputError(
        fmt::format("tapered bearing: the half angles {} rad (outer) and {} rad (inner) are nearly "
                    "equal: the common apex requires a pitch diameter of {} m ({:.0f} roller "
                    "diameters). Enter angles with a larger difference (for a pitch diameter dm, "
                    "inner/outer is about (dm - D)/(dm + D)), or use a cylindrical roller bearing",
                    outer, inner, g.pitch_diameter, g.pitch_diameter / D));
  g.apex_distance = 0.5 * D / tangent;
  g.apex_x = g.apex_distance * cosine;
  for (std::size_t race = 0; race < 2; ++race) {
    const double side = race == 0 ? 0.5 * D : -0.5 * D;
    g.contact[race] = {side * sine, 0.5 * g.pitch_diameter + side * cosine};
    g.cone_radius_at_x0[race] = g.apex_x * std::tan(race_angle[race]);
  }
  if (!(g.pitch_diameter > D))
    throw InputError(fmt::format(
        "tapered bearing: the half angles {} rad (outer) and {} rad (inner) give a pitch diameter "
        "of {} m, too small "
        "for rollers of diameter {} m; the inner angle must be larger or the outer one smaller",
        outer, inner, g.pitch_diameter, D));
  return g;
}

double pitch_diameter_sensitivity(const TaperedGeometry& g) {
  return 0.5 * g.pitch_diameter / g.half_angle;
}

EndDiameters end_diameters(const TaperedGeometry& g, double D, double length) {
  if (!(length > 0.0 && 0.5 * length < g.apex_distance))
    throw InputError(
        fmt::format("tapered bearing: rollers of length {} m reach the common apex, which is {} m "
                    "from their middle; the length must be positive and below twice this distance",
                    length, g.apex_distance));
  const double change = length * std::tan(g.half_angle);
  return {D + change, D - change};
}

int max_roller_count(const TaperedGeometry& g) {
  return static_cast<int>(
             std::ceil(kPi / std::asin(std::sin(g.half_angle) / std::sin(g.axis_angle)))) -
         1;
}

std::array<RaceSurface, 2> tapered_races(const TaperedGeometry& g) {
  std::array<RaceSurface, 2> races;
  for (std::size_t race = 0; race < 2; ++race) {
    races[race] = cone_race(static_cast<int>(race), g.cone_radius_at_x0[race], g.race_angle[race]);
    races[race].mid_x = g.contact[race][0];
    races[race].mid_r = g.contact[race][1];
  }
  return races;
}

std::array<RaceSurface, 2> grooved_tapered_races(const TaperedGeometry& g, double crown_radius,
                                                 const std::array<double, 2>& factor) {
  std::array<RaceSurface, 2> races;
  for (std::size_t race = 0; race < 2; ++race) {
    const double sigma = race == 0 ? 1.0 : -1.0, angle = g.race_angle[race];
    const double r_g = groove_radius(factor[race], crown_radius, static_cast<int>(race));
    races[race] = groove_through(static_cast<int>(race), g.contact[race],
                                 {sigma * std::sin(angle), sigma * std::cos(angle)}, r_g);
  }
  return races;
}

SphericalRow spherical_row(double D, double pitch_diameter, double contact_angle,
                           double crown_radius, const std::array<double, 2>& factor, double play) {
  SphericalRow row;
  const double sine = std::sin(contact_angle), cosine = std::cos(contact_angle);
  row.normal_gap = 0.25 * play * cosine;
  for (std::size_t race = 0; race < 2; ++race) {
    const double sigma = race == 0 ? 1.0 : -1.0;
    const double r_g = groove_radius(factor[race], crown_radius, static_cast<int>(race));
    const double reach = 0.5 * D + row.normal_gap;
    row.race[race] =
        groove_through(static_cast<int>(race),
                       {sigma * reach * sine, 0.5 * pitch_diameter + sigma * reach * cosine},
                       {sigma * sine, sigma * cosine}, r_g);
  }
  return row;
}

RollingSpeeds rolling_speeds(const std::array<double, 2>& r, double D, double axis_angle,
                             const std::array<double, 2>& race_speed) {
  RollingSpeeds s;
  s.orbital = (race_speed[0] * r[0] + race_speed[1] * r[1]) / (r[0] + r[1]);
  s.spin = (race_speed[0] - s.orbital) * r[0] / (0.5 * D);
  s.omega = Vec3(s.orbital + s.spin * std::cos(axis_angle), 0.0, -s.spin * std::sin(axis_angle));
  return s;
}

Vec3 gyroscopic_moment(const RollingSpeeds& speeds, double axis_angle, double axial_inertia,
                       double transverse_inertia) {
  const Vec3 a(std::cos(axis_angle), 0.0, -std::sin(axis_angle));
  const Vec3 along = speeds.omega.dot(a) * a;
  const Vec3 H = axial_inertia * along + transverse_inertia * (speeds.omega - along);
  return speeds.orbital * Vec3::UnitX().cross(H);
}

RibLoads rib_loads(double thrust_per_roller, const std::array<double, 2>& race_angle,
                   double rib_angle, double centrifugal_force) {
  const auto [outer, inner] = race_angle;
  const double across = std::cos(inner - rib_angle);
  if (!(outer > 0.0 && outer < 0.5 * kPi))
    throw InputError(fmt::format(
        "tapered bearing: the half angle of the outer race is {} rad; it must be between 0 and π/2",
        outer));
  if (!(across > 1e-6 && std::abs(inner) < 0.5 * kPi))
    throw InputError(
        fmt::format("tapered bearing: the rib normal is inclined by {} rad to the bearing axis; "
                    "such a rib cannot guide a roller on an inner race of half angle {} rad",
                    rib_angle, inner));
  RibLoads q;
  q.outer = thrust_per_roller / std::sin(outer);
  q.rib = (q.outer * std::sin(outer - inner) + centrifugal_force * std::sin(inner)) / across;
  q.inner = (q.outer * std::cos(outer) - centrifugal_force + q.rib * std::sin(rib_angle)) /
            std::cos(inner);
  return q;
}

}  // namespace adore::contact
