#include "dynamics/effects/lands.hpp"

#include "base/errors.hpp"
#include "contact/guide_land.hpp"
#include "dynamics/effect_makers.hpp"
#include "dynamics/effects/contact_damping.hpp"
#include "dynamics/effects/scene_pieces.hpp"
#include "dynamics/effects/user_forces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

/// Guide lands of the cage on the cylindrical lands of the races.
///
/// A land is cut into slices, each taken at its mid plane as a circle of the cage about the cage
/// axis inside (outer guidance) or around (inner guidance) a circle of the race about the race
/// axis, whose radii differ by the radial clearance c. e = vector from the race axis to the slice
/// center, across the race axis; contact where |e| > c. Normal: F/L of contact/conformal.hpp on the
/// cage along -e through the slice center, the opposite on the race; it is minus the gradient of
/// the slice energy. Friction at the cage point P = slice center ± R_c e/|e| (+ outer, - inner
/// guidance): slip = race point - cage point velocity, its part along e removed; N κ(s)/s u on
/// the cage, s the rounded slip (tribology/rounded_law.hpp), the opposite on the race at the same
/// point. Heat = friction · u. Tilt enters through
/// the slice centers; second order in tilt. With damping (contact_damping.hpp) N is the total
/// force.
///
/// A segment has an arc of the circle only: s = e·d, d the unit vector of the arc (signed by its
/// side) with the largest s, takes the place of |e|; inside the arc d = e/|e| and s = |e|. At an
/// end of the arc d turns with the segment: the force -N d acts on it, and its opposite on the
/// race, at the point of the race axis next to the slice, which is minus the gradient of the energy
/// over all poses. Limit: the law is that of a full circle also near the ends of the arc.
///
/// Lands with shape errors of the cage or the race have a separate block (uneven_lands.cpp).
namespace adore::dynamics {
namespace {

constexpr LedgerTerm kHeat{LedgerKind::Heat,
                           "land_heat",
                           "heat at the guide lands",
                           {"guide lands"},
                           "dissipated since the start"};
constexpr const LedgerTerm* kTerms[] = {&kHeat, &kLandDamping};

/// Position where a slice is nearest to the race.
struct Nearest {
  double size = 0.0;              ///< s [m]
  Vec3 direction = Vec3::Zero();  ///< d, across the race axis
};

/// Within `half_angle` of the z axis of the segment.
Nearest nearest_on_arc(const Vec3& eccentricity, double side, double half_angle,
                       const BodyState& segment, const Vec3& race_axis) noexcept {
  const Vec3 out = segment.to_base.transpose() * (side * eccentricity);
  const double angle = std::atan2(-out[1], out[2]);  // of the nearest point of the whole circle
  if (std::abs(angle) <= half_angle) {
    const double size = eccentricity.norm();
    return {size, eccentricity / std::max(size, std::numeric_limits<double>::min())};
  }
  Vec3 d = side * (segment.to_base * radial_direction(std::copysign(half_angle, angle)));
  d -= d.dot(race_axis) * race_axis;
  return {eccentricity.dot(d), d};
}

contact::UnevenLand::Shape uneven_shape(const bearing::GuideLand& guide, const LandModel& land,
                                        double half_angle) {
  contact::UnevenLand::Shape shape;
  shape.side = land.side;
  shape.clearance = land.law.clearance;
  shape.cage = contact::land_profile(land.cage_radius, guide.of_cage);
  shape.race = contact::land_profile(land.cage_radius + land.side * shape.clearance, guide.of_race);
  shape.stiffness = 3.0 * std::numbers::pi / 16.0 * land.law.E_star * land.slice_length;
  shape.half_angle = half_angle;
  return shape;
}

/// One per land of the cage; lands without a guiding race have no slices.
std::vector<LandModel> make_lands(const bearing::Bearing& bearing, int slices, double half_angle) {
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
      const double centre = contact::land_center_position(guide.edge, guide.width);
      for (int k = 0; k < slices; ++k)
        land.slice_x.push_back(centre + ((k + 0.5) / slices - 0.5) * guide.width);
      if (!guide.ideal()) land.uneven.emplace(uneven_shape(guide, land, half_angle));
    }
    lands.push_back(std::move(land));
  }
  return lands;
}

/// dN/de of a slice [N/m].
double stiffness_of(const LandModel& land, double eccentricity) noexcept {
  return contact::land_stiffness_per_length(land.law, eccentricity) * land.slice_length;
}

/// Force, least gap over the slices and its azimuth in the frame of the cage or segment.
/// @param force of the evaluation made last [N]
LandSnapshot report_of(const LandModel& land, const Evaluation& e, const BodyState& cage,
                       double half_angle, const Vec3& force) {
  LandSnapshot result;
  const RaceBody& race = e.race[static_cast<std::size_t>(land.race)];
  double largest = -std::numeric_limits<double>::infinity();
  for (const double x : land.slice_x) {
    const Vec3 eccentricity = locate(x, cage, race).eccentricity;
    const Nearest at = nearest_on_arc(eccentricity, land.side, half_angle, cage, race.axis());
    const double size = at.size;
    if (size <= largest) continue;
    largest = size;
    result.gap = land.law.clearance - size;
    const double angle = azimuth(cage.to_base.transpose() * (land.side * at.direction));
    result.angle = angle < 0.0 ? angle + 2.0 * std::numbers::pi : angle;
  }
  result.force = force.norm();
  return result;
}

template <bool Traction, bool Arcs>
class LandBlock final : public EffectBlock {
 public:
  LandBlock(const std::vector<LandModel>& lands, double half_angle,
            const tribology::TractionLaw& law, HeatByPart& heat, LandForces& kept)
      : lands_(lands),
        half_angle_(half_angle),
        law_(law),
        heat_(heat),
        kept_(kept),
        race_(common_guide_race(lands)) {}
  [[nodiscard]] bool acts_on_elements() const noexcept override { return false; }
  void apply(Evaluation& e) noexcept override {
    kept_.none();
    heat_.none();
    law_.visit_regularized([&](const auto& friction_per_slip) {
      run_friction_passes(
          asked_, friction_per_slip,
          [&](const auto& law) {
            for (std::size_t k = 0; k < e.segments.size(); ++k) apply_with(law, e, k);
          },
          race_);
    });
  }

 private:
  template <class Friction>
  void apply_with(const Friction& friction_per_slip, Evaluation& e, std::size_t piece) noexcept;

  const std::vector<LandModel>& lands_;
  double half_angle_;  ///< of the arc of a segment [rad]
  tribology::TractionLaw law_;
  UserTractionBatch asked_;
  HeatByPart& heat_;
  LandForces& kept_;
  int race_;
};

template <bool Traction, bool Arcs>
template <class Friction>
void LandBlock<Traction, Arcs>::apply_with([[maybe_unused]] const Friction& friction_per_slip,
                                           Evaluation& e, std::size_t piece) noexcept {
  BodyState& cage = e.segments[piece];
  for (std::size_t which = 0; which < lands_.size(); ++which) {
    const LandModel& land = lands_[which];
    if (land.uneven) continue;
    RaceBody& race = e.race[static_cast<std::size_t>(land.race)];
    const double c = land.law.clearance;
    for (const double x : land.slice_x) {
      const LandSlicePosition slice = locate(x, cage, race);
      const double e2 = slice.eccentricity.squaredNorm();
      if (c > 0.0 && e2 <= c * c) continue;
      double size = 0.0;
      Vec3 direction, acts_at = slice.centre;
      if constexpr (Arcs) {
        const Nearest at =
            nearest_on_arc(slice.eccentricity, land.side, half_angle_, cage, race.axis());
        size = at.size;
        direction = at.direction;
        if (c > 0.0 ? size <= c : size <= 0.0) continue;
        acts_at -= slice.eccentricity;
      } else {
        size = std::sqrt(e2);
        direction = slice.eccentricity / std::max(size, std::numeric_limits<double>::min());
      }
      double N = contact::land_load_per_length(land.law, size) * land.slice_length;
      if (contact::is_damped(land.damping)) {
        const double elastic = N,
                     rate = (cage.velocity_at(acts_at) - race.velocity_at(acts_at)).dot(direction);
        N = contact::damped_load(land.damping, elastic, stiffness_of(land, size), size - c, rate);
        if constexpr (!kOnlyNotes<Friction>) heat_.damping += (N - elastic) * rate;
      }
      if constexpr (!kOnlyNotes<Friction>) {
        cage.add_force(-N * direction, acts_at);
        race.add_force(N * direction, acts_at);
        kept_.at[piece * lands_.size() + which] -= N * direction;
        e.elastic += contact::land_energy_per_length(land.law, size) * land.slice_length;
      }
      if constexpr (Traction) {
        const Vec3 point = slice.centre + (land.side * land.cage_radius) * direction;
        Vec3 slip = race.velocity_at(point) - cage.velocity_at(point);
        slip -= slip.dot(direction) * direction;
        const double square = slip.squaredNorm();
        const Vec3 friction = friction_over_slip(friction_per_slip, N, square) * slip;
        if constexpr (kOnlyNotes<Friction>) continue;
        cage.add_force(friction, point);
        race.add_force(-friction, point);
        heat_.add(piece * lands_.size() + which, friction.dot(slip));
        cage.load_slip += N * std::sqrt(square);
      }
    }
  }
}

/// A slice of a round land for ADRX4.
struct UserLandTouch {
  std::size_t segment = 0, land = 0;
  Vec3 direction, acts_at, point;
  Vec3 friction = Vec3::Zero();  ///< on the cage, of the built-in force [N]
  double slip = 0.0, heat = 0.0;
};
using UserLandForces = UserForces<UserLandTouch>;

/// ADRX4 (user_forces.hpp).
class UserLandBlock final : public EffectBlock {
 public:
  UserLandBlock(const std::vector<LandModel>& lands, double half_angle, bool traction,
                const tribology::TractionLaw& law, UserLandForces& forces, HeatByPart& heat,
                LandForces& kept)
      : lands_(lands),
        half_angle_(half_angle),
        traction_(traction),
        law_(law),
        forces_(forces),
        heat_(heat),
        kept_(kept),
        race_(common_guide_race(lands)) {}
  [[nodiscard]] bool acts_on_elements() const noexcept override { return false; }
  void apply(Evaluation& e) noexcept override {
    law_.visit_regularized([&](const auto& friction) {
      run_friction_passes(
          asked_, friction, [&](const auto& law) { collect_all(law, e); }, race_);
    });
    const bool valid =
        forces_.ask(e.t, [&](const UserLandTouch& touch, const UserForceDifference& by) {
          BodyState& cage = e.segments[touch.segment];
          RaceBody& race = e.race[static_cast<std::size_t>(lands_[touch.land].race)];
          const Vec3 normal = -by.force * touch.direction, friction = by.ratio * touch.friction;
          cage.add_force(normal, touch.acts_at);
          race.add_force(-normal, touch.acts_at);
          cage.add_force(friction, touch.point);
          race.add_force(-friction, touch.point);
          cage.load_slip += by.force * touch.slip;
          const std::size_t part = touch.segment * lands_.size() + touch.land;
          kept_.at[part] += normal;
          heat_.add(part, by.ratio * touch.heat + by.heat);
          heat_.damping += by.damping;
        });
    if (!valid) e.valid = false;
  }

 private:
  template <class Friction>
  void collect_all(const Friction& friction, const Evaluation& e) noexcept {
    forces_.clear();
    for (std::size_t i = 0; i < e.segments.size(); ++i)
      for (std::size_t k = 0; k < lands_.size(); ++k)
        if (!lands_[k].uneven)
          for (const double x : lands_[k].slice_x) collect(friction, e, i, k, x);
  }
  template <class Friction>
  void collect(const Friction& friction, const Evaluation& e, std::size_t i, std::size_t k,
               double x) noexcept {
    const LandModel& land = lands_[k];
    const BodyState& cage = e.segments[i];
    const RaceBody& race = e.race[static_cast<std::size_t>(land.race)];
    const LandSlicePosition slice = locate(x, cage, race);
    const Nearest at =
        nearest_on_arc(slice.eccentricity, land.side, half_angle_, cage, race.axis());
    const double c = land.law.clearance;
    if (c > 0.0 ? at.size <= c : at.size <= 0.0) return;
    const double N = contact::land_load_per_length(land.law, at.size) * land.slice_length;
    if (!(N > 0.0)) return;
    UserLandTouch touch;
    touch.segment = i;
    touch.land = k;
    touch.direction = at.direction;
    touch.acts_at = slice.centre;
    if (half_angle_ < std::numbers::pi) touch.acts_at -= slice.eccentricity;
    touch.point = slice.centre + (land.side * land.cage_radius) * at.direction;
    if (traction_) {
      Vec3 slip = race.velocity_at(touch.point) - cage.velocity_at(touch.point);
      slip -= slip.dot(at.direction) * at.direction;
      const double square = slip.squaredNorm();
      touch.friction = friction_over_slip(friction, N, square) * slip;
      touch.slip = std::sqrt(square);
      touch.heat = touch.friction.dot(slip);
    }
    const Vec3 apart = cage.velocity_at(touch.acts_at) - race.velocity_at(touch.acts_at);
    const double rate = apart.dot(at.direction);
    forces_.collect(
        touch, k, static_cast<std::size_t>(land.race), c - at.size, -rate, N,
        damped_contact(land.damping, N, stiffness_of(land, at.size), at.size - c, rate));
  }

  const std::vector<LandModel>& lands_;
  double half_angle_;
  bool traction_;
  tribology::TractionLaw law_;
  UserTractionBatch asked_;
  UserLandForces& forces_;
  HeatByPart& heat_;
  LandForces& kept_;
  int race_;
};

class LandContact final : public SceneEffect {
 public:
  void declare(SceneBuilder& scene) override {
    demand(scene.plan.has(Effect::CageMotion),
           "contacts of the cage are to be computed, but its motion is not");
    demand(scene.options.land_slices >= 1, "a guide land needs at least one slice");
    const bearing::Segmentation& cut = scene.bearing.cage->segments;
    if (cut.several()) half_angle_ = std::numbers::pi / cut.count - 0.5 * cut.cut_angle;
    lands_ = make_lands(scene.bearing, scene.options.land_slices, half_angle_);
    if (lands_.empty()) return;
    heat_.part.assign(lands_.size() * static_cast<std::size_t>(cut.count), 0.0);
    kept_.at.assign(heat_.part.size(), Vec3::Zero());
    middle_ = pieces_of(scene).middle;
    const bool traction = scene.plan.has(Effect::LandTraction);
    demand(!traction || scene.bearing.land_traction.has_value(),
           "the traction of guide lands is switched on, but has no traction curve");
    const tribology::TractionLaw law =
        traction
            ? traction_of(scene, tribology::TractionKind::CageRace, *scene.bearing.land_traction)
            : tribology::TractionLaw();
    scene::UserContactForce* const user = scene.options.user ? scene.options.user->land : nullptr;
    std::size_t slices = 0;  // of one segment, which share its mass
    for (const LandModel& land : lands_) slices += land.slice_x.size();
    for (LandModel& land : lands_)
      if (slices > 0)
        land.damping =
            damping_law(scene, scene.bearing.cage->material,
                        scene.bearing.race_material[static_cast<std::size_t>(land.race)],
                        scene.bearing.cage->inertia.mass, 1.0 / static_cast<double>(slices));
    const bool damped = scene.plan.has(Effect::ContactDamping);
    const bool any_uneven = std::any_of(lands_.begin(), lands_.end(), [](const LandModel& land) {
      return land.uneven.has_value();
    });
    const auto add = [&]<bool Traction, bool Arcs>() {
      scene.block<LandBlock<Traction, Arcs>>(Phase::Force, "land contacts", {}, lands_, half_angle_,
                                             law, heat_, kept_);
    };
    if (cut.several())
      traction ? add.operator()<true, true>() : add.operator()<false, true>();
    else
      traction ? add.operator()<true, false>() : add.operator()<false, false>();
    if (any_uneven) {
      if (traction)
        scene.block<UnevenLandBlock<true>>(Phase::Force, "land contacts", {}, lands_, middle_, law,
                                           heat_, kept_);
      else
        scene.block<UnevenLandBlock<false>>(Phase::Force, "land contacts", {}, lands_, middle_, law,
                                            heat_, kept_);
    }
    if (user != nullptr) {
      demand(!any_uneven, "user routine ADRX4 does not support guide lands with shape errors");
      forces_.emplace(*user, slices * static_cast<std::size_t>(cut.count));
      scene.block<UserLandBlock>(Phase::Force, "user routine ADRX4", {}, lands_, half_angle_,
                                 traction, law, *forces_, heat_, kept_);
    }
    if (traction || user != nullptr) scene.energy("lands.heat", kHeat, &heat_.sum);
    if (damped) scene.energy("lands.damping", kLandDamping, &heat_.damping);
  }

  void report(const Evaluation& e, Snapshot& snapshot) const override {
    snapshot.cages.resize(e.segments.size());
    for (std::size_t k = 0; k < e.segments.size(); ++k)
      for (std::size_t i = 0; i < lands_.size(); ++i) {
        const LandModel& land = lands_[i];
        const Vec3& force = kept_.at[k * lands_.size() + i];
        snapshot.cages[k].lands.push_back(
            land.uneven ? report_uneven_land(land, e, e.segments[k], middle_[k], force)
                        : report_of(land, e, e.segments[k], half_angle_, force));
        snapshot.cages[k].lands.back().heat = heat_.part[k * lands_.size() + i];
      }
  }

  void look(const Evaluation&, Look& out) const override {
    std::vector<double>& force = out[ExtremeQuantity::LandForce];
    force.resize(kept_.at.size());
    for (std::size_t i = 0; i < force.size(); ++i) force[i] = kept_.at[i].norm();
  }

 private:
  double half_angle_ = std::numbers::pi;  ///< of a segment [rad]
  std::vector<LandModel> lands_;
  std::vector<double> middle_;            ///< azimuth of each segment in the cage [rad]
  std::optional<UserLandForces> forces_;  ///< ADRX4
  HeatByPart heat_;                       ///< now, of the lands of each segment
  LandForces kept_;
};

}  // namespace

std::unique_ptr<SceneEffect> make_land_contact(const ScenePlan& plan) {
  if (!plan.has(Effect::LandContact)) return nullptr;
  return std::make_unique<LandContact>();
}
std::span<const LedgerTerm* const> land_terms() { return kTerms; }

}  // namespace adore::dynamics
