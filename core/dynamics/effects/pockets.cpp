#include "dynamics/effects/pockets.hpp"

#include "base/errors.hpp"
#include "dynamics/effect_makers.hpp"
#include "statics/kinematics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace adore::dynamics {

double nominal_cage_speed(const bearing::Bearing& bearing) noexcept {
  const double gamma = bearing.balls().diameter * std::cos(bearing.balls().contact_angle) /
                       bearing.balls().pitch_diameter;
  return statics::epicyclic_speed(bearing.speed[0], bearing.speed[1], gamma);
}

PocketSet::PocketSet(const bearing::Bearing& bearing, const std::vector<double>& azimuths) {
  const bearing::Cage& cage = *bearing.cage;
  const double D = bearing.balls().diameter;
  ball_radius_ = 0.5 * D;
  pitch_radius_ = 0.5 * bearing.balls().pitch_diameter;
  rotation_sign_ = nominal_cage_speed(bearing) < 0.0 ? -1.0 : 1.0;
  const std::size_t count = azimuths.size();
  segment_.assign(count, 0);  // a cage of one piece
  for (auto* values : {&qx_, &qy_, &qz_, &sin_, &cos_}) values->resize(count);
  std::vector<bearing::PocketDeviation> deviation;
  bool alike = cage.pocket == bearing::PocketShape::Cylindrical && cage.cone_angle == 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    deviation.push_back(cage.deviation_of(i));
    alike = alike && deviation.back().is_zero();
  }
  const auto height = [&](double thickness) {
    return contact::wall_height(cage.outer_diameter, cage.inner_diameter,
                                bearing.balls().pitch_diameter, thickness);
  };
  if (alike) {
    const auto [low, high] = height(0.0);
    wall_ = {0.5 * (D + cage.pocket_clearance_1), low, high};
    hole2_ = wall_.wall_radius * wall_.wall_radius;
    const double play = std::max(wall_.wall_radius - ball_radius_, 0.0);
    play2_ = play * play;
    law_ = contact::ball_pocket_law(bearing.element_material, cage.material, D,
                                    {-1.0 / wall_.wall_radius, 0.0})
               .law;
    for (std::size_t i = 0; i < count; ++i) {
      sin_[i] = std::sin(azimuths[i]);
      cos_[i] = std::cos(azimuths[i]);
    }
    return;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const bearing::PocketDeviation& own = deviation[i];
    const auto [low, high] = height(own.thickness);
    Shaped pocket;
    pocket.pocket = {cage.pocket,
                     D,
                     cage.pocket_clearance_1 + own.clearance[0],
                     cage.pocket_clearance_2 + own.clearance[1],
                     low,
                     high};
    pocket.frame = contact::pocket_frame(
        {azimuths[i] + own.angular, pitch_radius_, own.axial, cage.cone_angle, own.tilt});
    pocket.law = contact::ball_pocket_law(bearing.element_material, cage.material, D,
                                          contact::wall_curvatures(pocket.pocket))
                     .law;
    shaped_.push_back(std::move(pocket));
  }
}

inline void PocketSet::locate_round(const Evaluation& e, std::size_t i) noexcept {
  const BodyState& cage = body(e, i);
  const Mat3& R = cage.to_base;
  const Vec3& p = cage.position;
  const ElementViews& b = e.elements;
  const double dx = b.x[i] - p[0];
  const double dy = -b.r[i] * b.sin_theta[i] - p[1];
  const double dz = b.r[i] * b.cos_theta[i] - p[2];
  const double cy = R(0, 1) * dx + R(1, 1) * dy + R(2, 1) * dz;
  const double cz = R(0, 2) * dx + R(1, 2) * dy + R(2, 2) * dz;
  qx_[i] = R(0, 0) * dx + R(1, 0) * dy + R(2, 0) * dz;
  qy_[i] = cos_[i] * cy + sin_[i] * cz;
  qz_[i] = cos_[i] * cz - sin_[i] * cy - pitch_radius_;
}

void PocketSet::locate_shaped(const Evaluation& e, std::size_t i) noexcept {
  const contact::PocketFrame& frame = shaped_[i].frame;
  const BodyState& cage = body(e, i);
  const Vec3 in_cage = cage.to_base.transpose() * (e.element_centre(i) - cage.position);
  const Vec3 q = frame.cage_to_pocket * (in_cage - frame.centre);
  qx_[i] = q[0];
  qy_[i] = q[1];
  qz_[i] = q[2];
}

void PocketSet::locate(const Evaluation& e) noexcept {
  if (shaped())
    for (std::size_t i = 0; i < size(); ++i) locate_shaped(e, i);
  else
    for (std::size_t i = 0; i < size(); ++i) locate_round(e, i);
}

void PocketSet::locate(const Evaluation& e, std::size_t i) noexcept {
  shaped() ? locate_shaped(e, i) : locate_round(e, i);
}

std::vector<PocketContactSnapshot> PocketSet::report(std::size_t i) const {
  std::vector<PocketContactSnapshot> out;
  const contact::WallPoints all = walls(i);
  for (std::size_t k = 0; k < static_cast<std::size_t>(all.count); ++k) {
    const contact::WallPoint& wall = all.surface[k];
    out.push_back({contact::load(law(i), -wall.gap), wall.gap,
                   contact::pocket_theta(wall.m, rotation_sign_), contact::pocket_phi(wall.m)});
  }
  return out;
}

namespace {

constexpr LedgerTerm kHeat{LedgerKind::Heat,
                           "pocket_heat",
                           "heat in the pockets",
                           {"cage pockets"},
                           "dissipated since the start"};
constexpr const LedgerTerm* kTerms[] = {&kHeat};

template <bool Traction, bool Shaped>
class PocketBlock final : public EffectBlock {
 public:
  PocketBlock(PocketSet& set, const tribology::TractionLaw& law, double& heat)
      : set_(set), law_(law), heat_(heat) {}
  void apply(Evaluation& e) noexcept override {
    if constexpr (Traction) {
      law_.visit_rounded([&](const auto& friction) { apply_with(friction, e); });
    } else {
      apply_with(nullptr, e);
    }
  }

 private:
  template <class Friction>
  void apply_with(const Friction& friction, Evaluation& e) noexcept;
  template <class Friction>
  void touch(const Friction& friction, Evaluation& e, std::size_t i,
             const contact::CappedHertz& law, const Vec3& m, double overlap) noexcept;

  PocketSet& set_;
  tribology::TractionLaw law_;
  double& heat_;
};

template <bool Traction, bool Shaped>
template <class Friction>
inline void PocketBlock<Traction, Shaped>::touch(const Friction& friction, Evaluation& e,
                                                 std::size_t i, const contact::CappedHertz& law,
                                                 const Vec3& m, double overlap) noexcept {
  BodyState& cage = set_.body(e, i);
  const PocketAction action =
      pocket_action(law, friction, e, i, cage, set_.ball_radius(), m, overlap);
  if constexpr (Traction) {
    e.add_moment(i, e.to_cylindrical(i, action.arm.cross(action.friction)));
    heat_ += action.heat;
    cage.load_slip += action.N * action.slip;
  }
  e.add_force(i, e.to_cylindrical(i, action.on_ball));
  cage.add_force(-action.on_ball, action.point);
  e.elastic += contact::energy(law, overlap);
}

template <bool Traction, bool Shaped>
template <class Friction>
void PocketBlock<Traction, Shaped>::apply_with(const Friction& friction, Evaluation& e) noexcept {
  set_.locate(e);
  if constexpr (Traction) heat_ = 0.0;
  for (std::size_t i = 0; i < set_.size(); ++i) {
    if constexpr (Shaped) {
      if (!set_.is_inside(i)) {
        e.valid = false;
        return;
      }
      const contact::WallPoints walls = set_.walls(i);
      for (std::size_t k = 0; k < static_cast<std::size_t>(walls.count); ++k) {
        const contact::WallPoint& wall = walls.surface[k];
        if (wall.gap < 0.0)
          touch(friction, e, i, set_.law(i), set_.to_base(i, wall.m, set_.body(e, i).to_base),
                -wall.gap);
      }
    } else {
      if (set_.surely_open(i) && set_.inside(i)) continue;
      if (!set_.inside(i)) {
        e.valid = false;
        return;
      }
      const contact::WallPoint wall = set_.wall_point(i);
      if (wall.gap < 0.0)
        touch(friction, e, i, set_.law(), set_.round_to_base(i, wall.m, set_.body(e, i).to_base),
              -wall.gap);
    }
  }
}

}  // namespace

void PocketContact::declare(SceneBuilder& scene) {
  demand(scene.plan.has(Effect::CageMotion), "the plan has cage contacts but no cage motion");
  std::vector<double> azimuths;
  for (const statics::StaticBall& b : scene.statics.balls) azimuths.push_back(b.azimuth);
  set_.emplace(scene.bearing, azimuths);
  std::vector<BodyId> partners;
  for (std::size_t i = 0; i < set_->size(); ++i)
    partners.push_back({BodyId::Kind::Segment, set_->segment(i)});
  constexpr std::string_view kCost = "pocket contacts";
  if (!scene.plan.has(Effect::PocketTraction)) {
    if (set_->shaped())
      scene.block<PocketBlock<false, true>>(Phase::Force, kCost, Partners(partners), *set_,
                                            tribology::TractionLaw(), heat_);
    else
      scene.block<PocketBlock<false, false>>(Phase::Force, kCost, Partners(partners), *set_,
                                             tribology::TractionLaw(), heat_);
    return;
  }
  demand(scene.bearing.pocket_traction.has_value(),
         "pocket traction is on without a traction curve");
  friction_.emplace(*scene.bearing.pocket_traction);
  if (set_->shaped())
    scene.block<PocketBlock<true, true>>(Phase::Force, kCost, Partners(partners), *set_, *friction_,
                                         heat_);
  else
    scene.block<PocketBlock<true, false>>(Phase::Force, kCost, Partners(partners), *set_,
                                          *friction_, heat_);
  scene.energy("pockets.heat", kHeat, &heat_);
}

std::string PocketContact::why_invalid(const Evaluation&) const {
  for (std::size_t i = 0; i < set_->size(); ++i)
    if (!set_->is_inside(i)) {
      const Vec3 q = set_->centre(i);
      return fmt::format(
          "the centre of element {} is outside its cage pocket (axial {:.4g} m, against the "
          "rotation {:.4g} m, radial {:.4g} m from the pocket centre); check the cage's start "
          "position, its pocket clearance and the largest step",
          i + 1, q[0], q[1], q[2]);
    }
  return {};
}

void PocketContact::report(const Evaluation& e, Snapshot& snapshot) const {
  for (std::size_t i = 0; i < e.elements.n; ++i) {
    snapshot.elements[i].pocket = set_->report(i);
    snapshot.elements[i].pocket_to_centre = set_->centre(i);
  }
}

std::unique_ptr<SceneEffect> make_pocket_contact(const ScenePlan& plan) {
  if (!plan.has(Effect::PocketContact)) return nullptr;
  return std::make_unique<PocketContact>();
}
std::span<const LedgerTerm* const> pocket_terms() { return kTerms; }

}  // namespace adore::dynamics
