#include "base/errors.hpp"
#include "contact/conformal.hpp"
#include "contact/guide_land.hpp"
#include "dynamics/effect_makers.hpp"
#include "tribology/traction_law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

/// Guide lands of the cage on the cylindrical lands of the races.
///
/// A land is cut into slices, each taken at its mid plane as a circle of the cage about the cage
/// axis inside (outer guidance) or around (inner guidance) a circle of the race about the race
/// axis, whose radii differ by the radial clearance c. e = vector from the race axis to the slice
/// centre, across the race axis; contact where |e| > c. Normal: F/L of contact/conformal.hpp on the
/// cage along -e through the slice centre, the opposite on the race; it is minus the gradient of
/// the slice energy. Friction at the cage point P = slice centre ± R_c e/|e| (+ outer, - inner
/// guidance): slip = race point - cage point velocity, its part along e removed; N κ(s)/s u on
/// the cage, s the rounded slip (tribology/rounded_law.hpp), the opposite on the race at the same
/// point. Heat = friction · u. Tilt enters through
/// the slice centres; second order in tilt.
namespace adore::dynamics {
namespace {

constexpr LedgerTerm kHeat{LedgerKind::Heat,
                           "land_heat",
                           "heat at the guide lands",
                           {"guide lands"},
                           "dissipated since the start"};
constexpr const LedgerTerm* kTerms[] = {&kHeat};

struct LandModel {
  int race = 0;              ///< guiding race
  double side = 1.0;         ///< +1 outer guidance, -1 inner guidance
  double cage_radius = 0.0;  ///< R_c [m]
  contact::LandLaw law;
  double slice_length = 0.0;    ///< [m]
  std::vector<double> slice_x;  ///< mid planes in the cage frame [m]
};

struct SliceAt {
  Vec3 centre;        ///< slice centre, base frame [m]
  Vec3 eccentricity;  ///< across the race axis [m]
};

SliceAt locate(double x, const BodyState& cage, const RaceBody& race) noexcept {
  const Vec3 centre = cage.position + x * cage.to_base.col(0);
  const Vec3 from_race = centre - race.position, axis = race.axis();
  return {centre, from_race - from_race.dot(axis) * axis};
}

/// One per land of the cage; lands without a guiding race have no slices.
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

/// Force, least gap over the slices and its azimuth in the cage frame.
LandSnapshot report_of(const LandModel& land, const Evaluation& e) {
  LandSnapshot result;
  const RaceBody& race = e.race[static_cast<std::size_t>(land.race)];
  const BodyState& cage = e.segments.front();
  Vec3 force = Vec3::Zero();
  double largest = -1.0;
  for (const double x : land.slice_x) {
    const Vec3 eccentricity = locate(x, cage, race).eccentricity;
    const double size = eccentricity.norm();
    if (size > 0.0)
      force -=
          contact::land_load_per_length(land.law, size) * land.slice_length / size * eccentricity;
    if (size <= largest) continue;
    largest = size;
    result.gap = land.law.clearance - size;
    const double angle = azimuth(cage.to_base.transpose() * (land.side * eccentricity));
    result.angle = angle < 0.0 ? angle + 2.0 * std::numbers::pi : angle;
  }
  result.force = force.norm();
  return result;
}

template <bool Traction>
class LandBlock final : public EffectBlock {
 public:
  LandBlock(const std::vector<LandModel>& lands, const tribology::TractionLaw& law, double& heat)
      : lands_(lands), law_(law), heat_(heat) {}
  void apply(Evaluation& e) noexcept override {
    law_.visit_rounded([&](const auto& friction_per_slip) { apply_with(friction_per_slip, e); });
  }

 private:
  template <class Friction>
  void apply_with(const Friction& friction_per_slip, Evaluation& e) noexcept;

  const std::vector<LandModel>& lands_;
  tribology::TractionLaw law_;
  double& heat_;
};

template <bool Traction>
template <class Friction>
void LandBlock<Traction>::apply_with([[maybe_unused]] const Friction& friction_per_slip,
                                     Evaluation& e) noexcept {
  if constexpr (Traction) heat_ = 0.0;
  BodyState& cage = e.segments.front();
  for (const LandModel& land : lands_) {
    RaceBody& race = e.race[static_cast<std::size_t>(land.race)];
    const double c = land.law.clearance;
    for (const double x : land.slice_x) {
      const SliceAt slice = locate(x, cage, race);
      const double e2 = slice.eccentricity.squaredNorm();
      if (c > 0.0 && e2 <= c * c) continue;
      const double size = std::sqrt(e2);
      const Vec3 direction =
          slice.eccentricity / std::max(size, std::numeric_limits<double>::min());
      const double N = contact::land_load_per_length(land.law, size) * land.slice_length;
      cage.add_force(-N * direction, slice.centre);
      race.add_force(N * direction, slice.centre);
      e.elastic += contact::land_energy_per_length(land.law, size) * land.slice_length;
      if constexpr (Traction) {
        const Vec3 point = slice.centre + (land.side * land.cage_radius) * direction;
        Vec3 slip = race.velocity_at(point) - cage.velocity_at(point);
        slip -= slip.dot(direction) * direction;
        const double square = slip.squaredNorm();
        const Vec3 friction = (N * friction_per_slip(square)) * slip;
        cage.add_force(friction, point);
        race.add_force(-friction, point);
        heat_ += friction.dot(slip);
        cage.load_slip += N * std::sqrt(square);
      }
    }
  }
}

class LandContact final : public SceneEffect {
 public:
  void declare(SceneBuilder& scene) override {
    demand(scene.plan.has(Effect::CageMotion), "the plan has cage contacts but no cage motion");
    demand(scene.options.land_slices >= 1, "a guide land needs at least one slice");
    lands_ = make_lands(scene.bearing, scene.options.land_slices);
    if (lands_.empty()) return;
    constexpr std::string_view kCost = "land contacts";
    if (!scene.plan.has(Effect::LandTraction)) {
      scene.block<LandBlock<false>>(Phase::Force, kCost, {}, lands_, tribology::TractionLaw(),
                                    heat_);
      return;
    }
    demand(scene.bearing.land_traction.has_value(), "land traction is on without a traction curve");
    scene.block<LandBlock<true>>(Phase::Force, kCost, {}, lands_,
                                 tribology::TractionLaw(*scene.bearing.land_traction), heat_);
    scene.energy("lands.heat", kHeat, &heat_);
  }

  void report(const Evaluation& e, Snapshot& snapshot) const override {
    if (snapshot.cages.empty()) snapshot.cages.emplace_back();
    for (const LandModel& land : lands_) snapshot.cages.front().lands.push_back(report_of(land, e));
  }

 private:
  std::vector<LandModel> lands_;
  double heat_ = 0.0;  ///< now [W]
};

}  // namespace

std::unique_ptr<SceneEffect> make_land_contact(const ScenePlan& plan) {
  if (!plan.has(Effect::LandContact)) return nullptr;
  return std::make_unique<LandContact>();
}
std::span<const LedgerTerm* const> land_terms() { return kTerms; }

}  // namespace adore::dynamics
