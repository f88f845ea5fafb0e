#include "statics/roller_flanges.hpp"

#include "base/errors.hpp"
#include "contact/roller_shape.hpp"

#include <fmt/format.h>

#include <cmath>

namespace adore::statics {
namespace {

/// Roller axis in the race frame for the relative coordinates t, f.
Vec3 axis_of(double t, double f) { return {std::sqrt(1.0 - t * t - f * f), f, t}; }

contact::FlangeContact contact_at(const FlangeEndPair& pair, const Vec4& p) {
  return contact::flange_contact_for_forces(pair.face, pair.end, Vec3(p(0), 0.0, p(1)),
                                            axis_of(p(2), p(3)));
}

/// ∂gap/∂p: the contact point moves with the roller, only its motion along the normal counts.
Vec4 gap_gradient(const contact::FlangeContact& c, const Vec4& p) {
  const Vec3 a = axis_of(p(2), p(3));
  const Vec3 arm = c.point - Vec3(p(0), 0.0, p(1));
  const Vec3 a_t(-a.z() / a.x(), 0.0, 1.0);
  const Vec3 a_f(-a.y() / a.x(), 1.0, 0.0);
  const Vec3 g = c.steepness * c.normal;
  return {g.x(), g.z(), g.dot(a.cross(a_t).cross(arm)), g.dot(a.cross(a_f).cross(arm))};
}

}  // namespace

std::vector<FlangeEndPair> flange_end_pairs(bearing::Type type,
                                            const bearing::RollerGeometry& rollers,
                                            const std::array<double, 2>& E_star,
                                            const contact::RollerProfile& profile) {
  std::vector<FlangeEndPair> out;
  const bearing::RollerGeometry g = rollers.unmounted_geometry();
  const RollerRaces races = bench_races(type, g);
  const auto growth = race_growths(type, rollers);
  const contact::RollerProfile ideal = contact::roller_profile(g);
  for (int race = 0; race < 2; ++race) {
    const auto j = static_cast<std::size_t>(race);
    const bool both = g.flange[j][0] && g.flange[j][1];
    for (int side = 0; side < 2; ++side) {
      const auto& given = g.flange[j][static_cast<std::size_t>(side)];
      if (!given) {
        continue;
      }
      const bool cylinder = g.axis_angle == 0.0;
      const double alpha = g.race_angle[j];
      contact::Flange flange;
      flange.side = race;
      flange.at = side == 0 ? -1 : 1;
      flange.layback = given->layback;
      flange.height = given->height;
      flange.race_half_angle = alpha;
      // The ideal roller seated on this race: cylinders take half the play, cones touch both races.
      const double sigma = race == 0 ? 1.0 : -1.0;
      const double seat = cylinder ? sigma * 0.25 * g.clearance : 0.0;
      const Vec3 centre(0.0, 0.0, 0.5 * g.pitch_diameter + seat);
      const Vec3 axis(std::cos(g.axis_angle), 0.0, -std::sin(g.axis_angle));
      const double travel =
          both ? 0.5 * g.flange_play[j] : (cylinder ? 0.5 * g.flange_play[1 - j] : 0.0);
      const std::array<double, 2> mid{races[j].mid_x, g.race_radius(race)};
      const contact::RollerEnd ideal_end = contact::roller_end(ideal, side);
      try {
        flange = contact::placed_flange(flange, ideal_end, centre, axis, mid, travel);
        FlangeEndPair pair;
        pair.race = race;
        pair.side = side;
        pair.end = contact::roller_end(profile, side);
        const Vec3 along(std::cos(alpha), 0.0, -std::sin(alpha));
        const Vec3 touching = centre + (flange.at * travel) * along;
        const contact::FlangeContact first =
            contact::flange_contact(contact::flange_face(flange), ideal_end, touching, axis);
        pair.K = contact::flange_load(ideal_end, axis, first, E_star[j]).hertz.K;
        pair.face = contact::flange_face(contact::grown(flange, growth[j]));
        pair.open_pose = Vec4(0.0, 0.5 * rollers.pitch_diameter, -std::sin(g.axis_angle), 0.0);
        pair.open_gap = contact_at(pair, pair.open_pose).gap;
        pair.reach = std::hypot(0.5 * profile.length, 0.5 * profile.diameter);
        out.push_back(pair);
      } catch (const InputError& error) {
        throw InputError(fmt::format("flange of the {} race at the {} side: {}",
                                     race == 0 ? "outer" : "inner", side == 0 ? "-x" : "+x",
                                     error.what()));
      }
    }
  }
  return out;
}

FlangeContactLoad flange_contact_load(const FlangeEndPair& pair, const Vec4& p) {
  FlangeContactLoad out;
  out.contact =
      contact::flange_contact(pair.face, pair.end, Vec3(p(0), 0.0, p(1)), axis_of(p(2), p(3)));
  out.load = out.contact.steepness * contact::hertz_load(pair.K, -out.contact.gap);
  return out;
}

void add_flange_force(const FlangeEndPair& pair, const Vec4& p, bool with_curvature,
                      PairPotential& sum) {
  if (pair.is_certainly_open(p)) {
    return;
  }
  const contact::FlangeContact c = contact_at(pair, p);
  if (!(c.gap < 0.0)) {
    return;
  }
  const double load = contact::hertz_load(pair.K, -c.gap);
  const double slope = 1.5 * load / -c.gap;
  const Vec4 g = gap_gradient(c, p);
  sum.gradient -= load * g;
  sum.hessian += slope * g * g.transpose();
  sum.total += c.steepness * load;
  if (!with_curvature) {
    return;
  }
  // Steps far above rounding and far below the sizes over which a gap curves.
  const double length_step = 1e-4 * std::max(pair.end.corner_radius, 0.1 * contact::kEdgeTube);
  const Vec4 step(length_step, length_step, 1e-6, 1e-6);
  Mat4 curvature;
  for (Eigen::Index k = 0; k < 4; ++k) {
    Vec4 up = p;
    Vec4 down = p;
    up(k) += step(k);
    down(k) -= step(k);
    curvature.col(k) =
        (gap_gradient(contact_at(pair, up), up) - gap_gradient(contact_at(pair, down), down)) /
        (2.0 * step(k));
  }
  sum.hessian -= load * 0.5 * (curvature + curvature.transpose());
}

}  // namespace adore::statics
