#include "dynamics/system_lands.hpp"

#include "contact/guide_land.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace adore::dynamics {
namespace {

struct SliceAt {
  Vec3 centre;        ///< slice centre, base frame [m]
  Vec3 eccentricity;  ///< across the race axis [m]
};

SliceAt locate(double x, const CageState& cage, const RaceMotion& race) noexcept {
  const Vec3 centre = cage.position + x * cage.to_base.col(0);
  const Vec3 from_race = centre - race.centre;
  return {centre, from_race - from_race.dot(race.axis) * race.axis};
}

}  // namespace

std::vector<LandModel> make_lands(const bearing::Bearing& bearing, int slices) {
  std::vector<LandModel> lands;
  const bearing::Cage& cage = *bearing.cage;
  for (const bearing::GuideLand& guide : cage.lands) {
    LandModel land;
    if (guide.guide != bearing::GuideLand::Guide::None) {
      const bool outer = guide.guide == bearing::GuideLand::Guide::Outer;
      land.race = outer ? bearing::kOuter : bearing::kInner;
      land.side = outer ? 1.0 : -1.0;
      land.cage_radius = 0.5 * guide.diameter;
      const auto race = static_cast<std::size_t>(land.race);
      land.law = {bearing::contact_modulus(cage.material, bearing.race_material[race]),
                  0.5 * guide.clearance};
      land.slice_length = guide.width / slices;
      const double centre = contact::land_centre(guide.edge, guide.width);
      for (int k = 0; k < slices; ++k)
        land.slice_x.push_back(centre + ((k + 0.5) / slices - 0.5) * guide.width);
    }
    lands.push_back(std::move(land));
  }
  return lands;
}

LandSnapshot report(const LandModel& land, const Evaluation& e) {
  LandSnapshot result;
  const RaceMotion& race = e.race[static_cast<std::size_t>(land.race)].motion;
  Vec3 force = Vec3::Zero();
  double largest = -1.0;
  for (const double x : land.slice_x) {
    const Vec3 eccentricity = locate(x, e.cage, race).eccentricity;
    const double size = eccentricity.norm();
    if (size > 0.0)
      force -=
          contact::land_load_per_length(land.law, size) * land.slice_length / size * eccentricity;
    if (size <= largest) continue;
    largest = size;
    result.gap = land.law.clearance - size;
    const double angle = azimuth(e.cage.to_base.transpose() * (land.side * eccentricity));
    result.angle = angle < 0.0 ? angle + 2.0 * std::numbers::pi : angle;
  }
  result.force = force.norm();
  return result;
}

template <bool Traction>
void LandBlock<Traction>::apply(Evaluation& e) noexcept {
  for (const LandModel& land : lands_) {
    RaceState& race = e.race[static_cast<std::size_t>(land.race)];
    const double c = land.law.clearance;
    for (const double x : land.slice_x) {
      const SliceAt slice = locate(x, e.cage, race.motion);
      const double e2 = slice.eccentricity.squaredNorm();
      if (c > 0.0 && e2 <= c * c) continue;
      const double size = std::sqrt(e2);
      const Vec3 direction =
          slice.eccentricity / std::max(size, std::numeric_limits<double>::min());
      const double N = contact::land_load_per_length(land.law, size) * land.slice_length;
      e.cage.add_force(-N * direction, slice.centre);
      race.add_force(N * direction, slice.centre);
      e.elastic += contact::land_energy_per_length(land.law, size) * land.slice_length;
      if constexpr (Traction) {
        const Vec3 point = slice.centre + (land.side * land.cage_radius) * direction;
        Vec3 slip = race.velocity_at(point) - e.cage.velocity_at(point);
        slip -= slip.dot(direction) * direction;
        const double u = slip.norm();
        const Vec3 friction = (N * friction_.per_slip(u)) * slip;
        e.cage.add_force(friction, point);
        race.add_force(-friction, point);
        e.heat_lands += friction.dot(slip);
        e.wear_cage += N * u;
      }
    }
  }
}

template class LandBlock<false>;
template class LandBlock<true>;

}  // namespace adore::dynamics
