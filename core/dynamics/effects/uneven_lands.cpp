#include "dynamics/effects/lands.hpp"

#include <cmath>
#include <limits>
#include <numbers>

/// Guide lands with shape errors: U(e, φ, β) of contact/uneven_land.hpp for every slice.
///
/// e and φ are taken in the axes of the race that do not spin, β is its turn about its own axis. φ
/// is the azimuth of the z axis of the cage or segment, c, there; a turn dω of the segment against
/// the race changes it by
///   dφ = g·dω,   g = a - c_a (c - c_a a)/(1 - c_a²),   a the race axis, c_a = c·a,   [derived]
/// so that the moment T g on the segment and -T g on the race are minus the gradient of U, at any
/// tilt. F acts at the slice center, -F at the same point of the race: e × F is the moment of the
/// race for a rotation of e in its axes. Friction: as of circular lands, for each stretch of
/// a spot separately, at the cage's radius in the direction of its force. Damping
/// (contact_damping.hpp) multiplies all forces of a slice by one ratio, of the load L, the sum over
/// its stretches: dU/dt = L δ̇, δ = 2U/L the mean overlap, k = L/δ [derived].
namespace adore::dynamics {
namespace {

/// Position of a slice of a segment in the axes of its race.
struct PlacedSlice {
  LandSlicePosition at;
  contact::UnevenLand::Place place;
};

PlacedSlice place_slice(double x, const BodyState& segment, const RaceBody& race,
                        double middle) noexcept {
  PlacedSlice out;
  out.at = locate(x, segment, race);
  const Vec3 e = race.to_base.transpose() * out.at.eccentricity;
  const Vec3 c = race.to_base.transpose() * segment.to_base.col(2);
  out.place = {{e[1], e[2]}, azimuth(c), race.turn_beyond, middle};
  return out;
}

/// g of the file comment.
Vec3 rotation_gradient(const BodyState& segment, const RaceBody& race) noexcept {
  const Vec3 a = race.axis(), c = segment.to_base.col(2);
  const double along = c.dot(a);
  return a - along / (1.0 - along * along) * (c - along * a);
}

}  // namespace

template <bool Traction>
template <class Friction>
void UnevenLandBlock<Traction>::apply_to([[maybe_unused]] const Friction& friction_per_slip,
                                         Evaluation& e, std::size_t piece,
                                         std::size_t which) noexcept {
  const LandModel& land = lands_[which];
  BodyState& segment = e.segments[piece];
  const double middle = middle_[piece];
  RaceBody& race = e.race[static_cast<std::size_t>(land.race)];
  const Vec3 g = rotation_gradient(segment, race);
  for (const double x : land.slice_x) {
    if (land.uneven->is_out_of_reach(locate(x, segment, race).eccentricity.squaredNorm())) continue;
    const PlacedSlice slice = place_slice(x, segment, race, middle);
    double ratio = 1.0;
    if (contact::is_damped(land.damping)) {
      double power = 0.0, load = 0.0, energy = 0.0;
      const Vec3 apart = segment.velocity_at(slice.at.centre) - race.velocity_at(slice.at.centre);
      const double turns = g.dot(segment.omega - race.omega);
      land.uneven->visit(slice.place, [&](const contact::ContactSpotSection& part) {
        power -= (race.to_base * Vec3(0.0, part.force[0], part.force[1])).dot(apart) +
                 part.turning * turns;
        load += part.load;
        energy += part.energy;
      });
      if (!(load > 0.0)) continue;
      const double overlap = 2.0 * energy / load, rate = power / load;
      const double total = contact::damped_load(land.damping, load, load / overlap, overlap, rate);
      ratio = total / load;
      if constexpr (!kOnlyNotes<Friction>) heat_.damping += (total - load) * rate;
    }
    Vec3 force = Vec3::Zero();
    double turning = 0.0;
    land.uneven->visit(slice.place, [&](const contact::ContactSpotSection& part) {
      const Vec3 elastic = race.to_base * Vec3(0.0, part.force[0], part.force[1]);
      const double N = ratio * part.load;
      if constexpr (!kOnlyNotes<Friction>) {
        force += ratio * elastic;
        turning += ratio * part.turning;
        e.elastic += part.energy;
      }
      if constexpr (Traction) {
        // The race pushes the cage inwards where it guides outside, outwards where inside.
        const Vec3 normal = elastic / part.load;
        const Vec3 point = slice.at.centre - (land.side * land.cage_radius) * normal;
        Vec3 slip = race.velocity_at(point) - segment.velocity_at(point);
        slip -= slip.dot(normal) * normal;
        const double square = slip.squaredNorm();
        const Vec3 friction = friction_over_slip(friction_per_slip, N, square) * slip;
        if constexpr (kOnlyNotes<Friction>) return;
        segment.add_force(friction, point);
        race.add_force(-friction, point);
        heat_.add(piece * lands_.size() + which, friction.dot(slip));
        segment.load_slip += N * std::sqrt(square);
      }
    });
    if constexpr (kOnlyNotes<Friction>) continue;
    kept_.at[piece * lands_.size() + which] += force;
    segment.add_force(force, slice.at.centre);
    race.add_force(-force, slice.at.centre);
    segment.moment += turning * g;
    race.moment -= turning * g;
  }
}

template <bool Traction>
void UnevenLandBlock<Traction>::apply(Evaluation& e) noexcept {
  law_.visit_regularized([&](const auto& friction_per_slip) {
    run_friction_passes(
        asked_, friction_per_slip,
        [&](const auto& law) {
          for (std::size_t k = 0; k < e.segments.size(); ++k)
            for (std::size_t i = 0; i < lands_.size(); ++i)
              if (lands_[i].uneven) apply_to(law, e, k, i);
        },
        race_);
  });
}

template class UnevenLandBlock<false>;
template class UnevenLandBlock<true>;

scene::LandSnapshot report_uneven_land(const LandModel& land, const Evaluation& e,
                                       const BodyState& segment, double middle, const Vec3& force) {
  scene::LandSnapshot result;
  const RaceBody& race = e.race[static_cast<std::size_t>(land.race)];
  result.force = force.norm();
  result.gap = std::numeric_limits<double>::infinity();
  for (const double x : land.slice_x) {
    const PlacedSlice slice = place_slice(x, segment, race, middle);
    const auto least = land.uneven->minimum_gap(slice.place);
    if (least.gap >= result.gap) continue;
    result.gap = least.gap;
    result.angle = least.s < 0.0 ? least.s + 2.0 * std::numbers::pi : least.s;
  }
  return result;
}

}  // namespace adore::dynamics
