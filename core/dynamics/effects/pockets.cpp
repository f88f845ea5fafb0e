#include "dynamics/effects/pockets.hpp"

#include "base/errors.hpp"
#include "bearing/element_inertia.hpp"
#include "dynamics/effect_makers.hpp"
#include "dynamics/effects/contact_damping.hpp"
#include "dynamics/effects/scene_pieces.hpp"
#include "statics/kinematics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace adore::dynamics {

double nominal_cage_speed(const bearing::Bearing& bearing) noexcept {
  const double angle =
      bearing.rollers() ? bearing.rollers()->axis_angle : bearing.balls().contact_angle;
  const double gamma = bearing.element_diameter() * std::cos(angle) / bearing.pitch_diameter();
  return statics::epicyclic_speed(bearing.speed[0], bearing.speed[1], gamma);
}

PocketSet::PocketSet(const bearing::Bearing& bearing,
                     const std::vector<contact::SegmentPocket>& pockets) {
  const bearing::Cage& cage = *bearing.cage;
  const double D = bearing.balls().diameter;
  ball_radius_ = 0.5 * D;
  pitch_radius_ = 0.5 * bearing.balls().pitch_diameter;
  rotation_sign_ = nominal_cage_speed(bearing) < 0.0 ? -1.0 : 1.0;
  const std::size_t count = pockets.size();
  for (auto* values : {&qx_, &qy_, &qz_, &sin_, &cos_}) values->resize(count);
  std::vector<bearing::PocketDeviation> deviation;
  bool alike = cage.pocket == bearing::PocketShape::Cylindrical && cage.cone_angle == 0.0 &&
               !bearing::has_unequal_balls(bearing);
  for (const contact::SegmentPocket& pocket : pockets) {
    segment_.push_back(pocket.piece);
    element_.push_back(pocket.element);
    deviation.push_back(cage.deviation_of(pocket.element));
    alike = alike && deviation.back().is_zero() && pocket.half == 0;
  }
  const auto height = [&](double thickness) {
    return contact::pocket_wall_limits(cage.outer_diameter, cage.inner_diameter,
                                       bearing.balls().pitch_diameter, thickness);
  };
  if (alike) {
    const auto [low, high] = height(0.0);
    wall_ = {0.5 * (D + cage.pocket_clearance_1), low, high};
    hole_radius_squared_ = wall_.wall_radius * wall_.wall_radius;
    const double play = std::max(wall_.wall_radius - ball_radius_, 0.0);
    clearance_squared_ = play * play;
    law_ = contact::ball_pocket_law(bearing.element_material, cage.material, D,
                                    {-1.0 / wall_.wall_radius, 0.0})
               .law;
    for (std::size_t i = 0; i < count; ++i) {
      sin_[i] = std::sin(pockets[i].azimuth);
      cos_[i] = std::cos(pockets[i].azimuth);
    }
    return;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const bearing::PocketDeviation& own = deviation[i];
    const auto [low, high] = height(own.thickness);
    ShapedPocket pocket;
    pocket.pocket = {cage.pocket,
                     D,
                     cage.pocket_clearance_1 + own.clearance[0],
                     cage.pocket_clearance_2 + own.clearance[1],
                     low,
                     high,
                     pockets[i].half,
                     contact::half_pocket_edge(cage, bearing.balls().pitch_diameter)};
    const double own_diameter = 2.0 * bearing::element_radius(bearing, pockets[i].element);
    pocket.pocket = contact::pocket_with_ball_growth(pocket.pocket, own_diameter - D);
    pocket.frame = contact::pocket_frame(
        {pockets[i].azimuth + own.angular, pitch_radius_, own.axial, cage.cone_angle, own.tilt});
    pocket.law = contact::ball_pocket_law(bearing.element_material, cage.material, own_diameter,
                                          contact::wall_curvatures(pocket.pocket))
                     .law;
    shaped_pockets_.push_back(std::move(pocket));
  }
}

inline void PocketSet::locate_in_round_pocket(const Evaluation& e, std::size_t i) noexcept {
  const BodyState& cage = body(e, i);
  const Mat3& R = cage.to_base;
  const Vec3& p = cage.position;
  const ElementViews& b = e.elements;
  const std::size_t ball = element_[i];
  const double dx = b.x[ball] - p[0];
  const double dy = -b.r[ball] * b.sin_theta[ball] - p[1];
  const double dz = b.r[ball] * b.cos_theta[ball] - p[2];
  const double cy = R(0, 1) * dx + R(1, 1) * dy + R(2, 1) * dz;
  const double cz = R(0, 2) * dx + R(1, 2) * dy + R(2, 2) * dz;
  qx_[i] = R(0, 0) * dx + R(1, 0) * dy + R(2, 0) * dz;
  qy_[i] = cos_[i] * cy + sin_[i] * cz;
  qz_[i] = cos_[i] * cz - sin_[i] * cy - pitch_radius_;
}

void PocketSet::locate_in_shaped_pocket(const Evaluation& e, std::size_t i) noexcept {
  const contact::PocketFrame& frame = shaped_pockets_[i].frame;
  const BodyState& cage = body(e, i);
  const Vec3 in_cage = cage.to_base.transpose() * (e.element_centre(element_[i]) - cage.position);
  const Vec3 q = frame.cage_to_pocket * (in_cage - frame.centre);
  qx_[i] = q[0];
  qy_[i] = q[1];
  qz_[i] = q[2];
}

void PocketSet::locate(const Evaluation& e) noexcept {
  if (has_shaped_pockets())
    for (std::size_t i = 0; i < size(); ++i) locate_in_shaped_pocket(e, i);
  else
    for (std::size_t i = 0; i < size(); ++i) locate_in_round_pocket(e, i);
}

void PocketSet::locate(const Evaluation& e, std::size_t i) noexcept {
  has_shaped_pockets() ? locate_in_shaped_pocket(e, i) : locate_in_round_pocket(e, i);
}

void PocketSet::report(std::size_t i, std::vector<PocketContactSnapshot>& out) const {
  out.clear();
  const contact::WallPoints all = walls(i);
  for (std::size_t k = 0; k < static_cast<std::size_t>(all.count); ++k) {
    const contact::WallPoint& wall = all.surface[k];
    if (!std::isfinite(wall.gap)) {  // a face that the cut has taken away
      out.emplace_back();
      continue;
    }
    out.push_back({contact::load(law(i), -wall.gap), wall.gap,
                   contact::pocket_theta(wall.m, rotation_sign_), contact::pocket_phi(wall.m)});
  }
}

namespace {

constexpr const LedgerTerm* kTerms[] = {&kPocketHeat, &kPocketDamping};

template <bool Traction, bool ShapedPocket>
class PocketBlock final : public EffectBlock {
 public:
  PocketBlock(PocketSet& set, const tribology::TractionLaw& law,
              const contact::DampingLaw<>& damping, HeatByPart& heat, LastContactValues& kept)
      : pocket_set_(set), law_(law), damping_(damping), heat_(heat), kept_(kept) {
    if (law.is_user_law()) asked_.reserve(set.size() * kMostWalls);
  }
  void apply(Evaluation& e) noexcept override {
    kept_.none();
    if constexpr (Traction) {
      law_.visit_regularized([&](const auto& friction) {
        run_friction_passes(asked_, friction, [&](const auto& law) { apply_with(law, e); });
      });
    } else {
      apply_with(nullptr, e);
    }
  }

 private:
  template <class Friction>
  void apply_with(const Friction& friction, Evaluation& e) noexcept;
  template <class Friction>
  void touch(const Friction& friction, Evaluation& e, std::size_t i, std::size_t surface,
             const contact::CappedHertz& law, const Vec3& m, double overlap) noexcept;

  PocketSet& pocket_set_;
  tribology::TractionLaw law_;
  contact::DampingLaw<> damping_;
  UserTractionBatch asked_;
  HeatByPart& heat_;
  LastContactValues& kept_;
};

template <bool Traction, bool ShapedPocket>
template <class Friction>
inline void PocketBlock<Traction, ShapedPocket>::touch(const Friction& friction, Evaluation& e,
                                                       std::size_t i, std::size_t surface,
                                                       const contact::CappedHertz& law,
                                                       const Vec3& m, double overlap) noexcept {
  BodyState& cage = pocket_set_.body(e, i);
  const std::size_t ball = pocket_set_.element(i);
  const PocketAction action =
      pocket_action(law, damping_, friction, e, ball, cage, pocket_set_.ball_radius(i), m, overlap);
  if constexpr (kOnlyNotes<Friction>) return;
  if constexpr (Traction) {
    e.add_moment(ball, e.to_cylindrical(ball, action.arm.cross(action.friction)));
    heat_.add(ball, action.heat);
    cage.load_slip += action.N * action.slip;
  }
  e.add_force(ball, e.to_cylindrical(ball, action.on_ball));
  cage.add_force(-action.on_ball, action.point);
  e.elastic += contact::energy(law, overlap);
  heat_.damping += action.damping;
  kept_.add(i, surface, action.N);
}

template <bool Traction, bool ShapedPocket>
template <class Friction>
void PocketBlock<Traction, ShapedPocket>::apply_with(const Friction& friction,
                                                     Evaluation& e) noexcept {
  pocket_set_.locate(e);
  for (std::size_t i = 0; i < pocket_set_.size(); ++i) {
    if constexpr (ShapedPocket) {
      if (!pocket_set_.is_inside(i)) {
        e.valid = false;
        return;
      }
      const contact::WallPoints walls = pocket_set_.walls(i);
      for (std::size_t k = 0; k < static_cast<std::size_t>(walls.count); ++k) {
        const contact::WallPoint& wall = walls.surface[k];
        if (wall.gap < 0.0)
          touch(friction, e, i, k, pocket_set_.law(i),
                pocket_set_.to_base(i, wall.m, pocket_set_.body(e, i).to_base), -wall.gap);
      }
    } else {
      if (pocket_set_.is_certainly_open(i) && pocket_set_.is_inside_round_pocket(i)) continue;
      if (!pocket_set_.is_inside_round_pocket(i)) {
        e.valid = false;
        return;
      }
      const contact::WallPoint wall = pocket_set_.wall_point(i);
      if (wall.gap < 0.0)
        touch(friction, e, i, 0, pocket_set_.law(),
              pocket_set_.round_pocket_to_base(i, wall.m, pocket_set_.body(e, i).to_base),
              -wall.gap);
    }
  }
}

/// ADRX3 (user_forces.hpp).
class UserPocketBlock final : public EffectBlock {
 public:
  UserPocketBlock(PocketSet& set, const std::optional<tribology::TractionLaw>& friction,
                  const contact::DampingLaw<>& damping, UserPocketForces& forces, HeatByPart& heat,
                  LastContactValues& kept)
      : pocket_set_(set),
        friction_(friction),
        damping_(damping),
        user_forces_(forces),
        heat_(heat),
        kept_(kept) {}
  void apply(Evaluation& e) noexcept override {
    run_traction_passes(asked_, friction_ ? &*friction_ : nullptr,
                        [&](const auto& law) { collect_all(law, e); });
    const bool valid =
        user_forces_.ask(e.t, [&](const UserPocketTouch& touch, const UserForceDifference& by) {
          const std::size_t ball = pocket_set_.element(touch.pocket);
          BodyState& cage = pocket_set_.body(e, touch.pocket);
          const Vec3 on_ball = by.ratio * touch.action.on_ball;
          e.add_force(ball, e.to_cylindrical(ball, on_ball));
          cage.add_force(-on_ball, touch.action.point);
          if (friction_) {
            const Vec3 friction = by.ratio * touch.action.friction;
            e.add_moment(ball, e.to_cylindrical(ball, touch.action.arm.cross(friction)));
            cage.load_slip += by.force * touch.action.slip;
          }
          heat_.add(ball, by.ratio * touch.action.heat + by.heat);
          heat_.damping += by.damping;
          kept_.add(touch.pocket, touch.surface, by.force);
        });
    if (!valid) e.valid = false;
  }

 private:
  template <class Friction>
  void collect_all(const Friction& friction, const Evaluation& e) noexcept {
    user_forces_.clear();
    for (std::size_t i = 0; i < pocket_set_.size(); ++i) {
      if (!pocket_set_.is_inside(i) ||
          (!pocket_set_.has_shaped_pockets() && pocket_set_.is_certainly_open(i)))
        continue;
      const contact::WallPoints walls = pocket_set_.walls(i);
      for (std::size_t k = 0; k < static_cast<std::size_t>(walls.count); ++k)
        if (walls.surface[k].gap < 0.0) collect(friction, e, i, k, walls.surface[k]);
    }
  }
  template <class Friction>
  void collect(const Friction& friction, const Evaluation& e, std::size_t i, std::size_t k,
               const contact::WallPoint& wall) noexcept {
    const BodyState& cage = pocket_set_.body(e, i);
    const Vec3 m = pocket_set_.to_base(i, wall.m, cage.to_base);
    const std::size_t ball = pocket_set_.element(i);
    const UserPocketTouch touch{i, k,
                                pocket_action(pocket_set_.law(i), {}, friction, e, ball, cage,
                                              pocket_set_.ball_radius(i), m, -wall.gap)};
    const double N = touch.action.N, rate = touch.action.rate;
    if (!(N > 0.0)) return;
    user_forces_.collect(touch, ball, k, wall.gap, -rate, N,
                         damped_contact(damping_, N, contact::slope(pocket_set_.law(i), -wall.gap),
                                        -wall.gap, rate));
  }

  PocketSet& pocket_set_;
  const std::optional<tribology::TractionLaw>& friction_;
  contact::DampingLaw<> damping_;
  UserTractionBatch asked_;
  UserPocketForces& user_forces_;
  HeatByPart& heat_;
  LastContactValues& kept_;
};

}  // namespace

void PocketContact::add_block(SceneBuilder& scene, PocketSet& set, LastContactValues& kept,
                              std::vector<BodyId> partners) {
  const auto add = [&]<bool Traction, bool ShapedPocket>() {
    scene.block<PocketBlock<Traction, ShapedPocket>>(
        Phase::Force, "pocket contacts", CoupledBodies(std::move(partners)), set,
        Traction ? *friction_ : tribology::TractionLaw(), damping_, heat_, kept);
  };
  if (!friction_)
    set.has_shaped_pockets() ? add.operator()<false, true>() : add.operator()<false, false>();
  else
    set.has_shaped_pockets() ? add.operator()<true, true>() : add.operator()<true, false>();
}

void PocketContact::declare(SceneBuilder& scene) {
  demand(scene.plan.has(Effect::CageMotion),
         "contacts of the cage are to be computed, but its motion is not");
  heat_.part.assign(static_cast<std::size_t>(scene.bearing.element_count()), 0.0);
  if (scene.plan.has(Effect::PocketTraction)) {
    demand(scene.bearing.pocket_traction.has_value(),
           "the pocket traction is switched on, but has no traction curve");
    friction_.emplace(
        traction_of(scene, tribology::TractionKind::ElementCage, *scene.bearing.pocket_traction));
  }
  const bearing::Cage& cage = *scene.bearing.cage;
  damping_ = damping_law(scene, scene.bearing.element_material, cage.material,
                         reduced_mass(scene.bearing.element_inertia.mass, cage.inertia.mass));
  scene::UserContactForce* const user = scene.options.user ? scene.options.user->pocket : nullptr;
  const bool damped = contact::is_damped(damping_);
  if (friction_ || user != nullptr || damped)
    scene.block<ResetHeatByPart>(Phase::Force, "pocket contacts", {}, heat_);
  const contact::CagePieces pieces = pieces_of(scene);
  const auto add = [&](std::optional<PocketSet>& set,
                       const std::vector<contact::SegmentPocket>& pockets,
                       std::optional<UserPocketForces>& forces, LastContactValues& kept) {
    set.emplace(scene.bearing, pockets);
    kept.size(pockets.size(),
              static_cast<std::size_t>(bearing::pocket_surfaces(*scene.bearing.cage, false)));
    std::vector<BodyId> partners(pieces.pockets.size(), BodyId{BodyId::Kind::Segment, -1});
    for (const contact::SegmentPocket& pocket : pockets)
      partners[pocket.element].index = pocket.piece;
    if (user == nullptr) return add_block(scene, *set, kept, std::move(partners));
    CoupledBodies same{std::vector<BodyId>(partners)};
    add_block(scene, *set, kept, std::move(partners));
    forces.emplace(*user, set->size() * kMostWalls);
    scene.block<UserPocketBlock>(Phase::Force, "user routine ADRX3", std::move(same), *set,
                                 friction_, damping_, *forces, heat_, kept);
  };
  add(pocket_set_, pieces.pockets, user_forces_[0], kept_[0]);
  if (!pieces.last_halves.empty())
    add(end_half_pockets_, pieces.last_halves, user_forces_[1], kept_[1]);
  if (friction_ || user != nullptr) scene.energy("pockets.heat", kPocketHeat, &heat_.sum);
  if (damped) scene.energy("pockets.damping", kPocketDamping, &heat_.damping);
  scene.supports(*this);
}

namespace {

/// visit(wall) of what the ball of a located pocket touches.
template <class Visit>
void for_touched(const PocketSet& set, std::size_t pocket, const Visit& visit) noexcept {
  if (!set.is_inside(pocket) || (!set.has_shaped_pockets() && set.is_certainly_open(pocket)))
    return;
  const contact::WallPoints walls = set.walls(pocket);
  for (std::size_t k = 0; k < static_cast<std::size_t>(walls.count); ++k)
    if (walls.surface[k].gap < 0.0) visit(walls.surface[k]);
}

}  // namespace

void PocketContact::resist(const Evaluation& e, std::size_t i, Mat3& stiffness) noexcept {
  for_pockets(i, [&](PocketSet& set, std::size_t pocket) {
    set.locate(e, pocket);
    for_touched(set, pocket, [&](const contact::WallPoint& wall) {
      const contact::CappedHertz& law = set.law(pocket);
      const Vec3 q = set.centre(pocket);
      const double d = std::max(std::hypot(q[0], q[1]), 1e-9);
      const auto in_frame = [&](const Vec3& v) {
        return e.to_cylindrical(i, set.to_base(pocket, v, set.body(e, pocket).to_base));
      };
      const Vec3 m = in_frame(wall.m), t = in_frame({-q[1] / d, q[0] / d, 0.0});
      stiffness += contact::slope(law, -wall.gap) * m * m.transpose() +
                   contact::load(law, -wall.gap) / d * t * t.transpose();
    });
  });
}

void PocketContact::damp(const Evaluation& e, std::size_t i, Eigen::Matrix2d& damping) noexcept {
  if (!friction_) return;
  for_pockets(i, [&](PocketSet& set, std::size_t pocket) {
    for_touched(set, pocket, [&](const contact::WallPoint& wall) {
      const BodyState& cage = set.body(e, pocket);
      friction_->visit_regularized([&](const auto& friction) {
        const PocketAction a =
            pocket_action(set.law(pocket), {}, friction, e, i, cage, set.ball_radius(pocket),
                          set.to_base(pocket, wall.m, cage.to_base), -wall.gap);
        const Eigen::Vector2d m = e.to_cylindrical(i, a.m).head<2>();
        damping += a.friction_per_slip * (Eigen::Matrix2d::Identity() - m * m.transpose());
      });
    });
  });
}

std::string PocketContact::why_invalid(const Evaluation&) const {
  for (const auto* set : {&pocket_set_, &end_half_pockets_}) {
    if (!set->has_value()) continue;
    for (std::size_t i = 0; i < (*set)->size(); ++i) {
      if ((*set)->is_inside(i)) continue;
      const Vec3 q = (*set)->centre(i);
      return fmt::format(
          "the center of element {} is outside its cage pocket (axial {:.4g} m, circumferential "
          "{:.4g} m, radial {:.4g} m from the pocket center); check the start position of the "
          "cage, its pocket clearance and the largest step (stpMax)",
          (*set)->element(i) + 1, q[0], q[1], q[2]);
    }
  }
  return {};
}

void PocketContact::report(const Evaluation& e, Snapshot& snapshot) const {
  for (std::size_t i = 0; i < e.elements.n; ++i) {
    pocket_set_->report(i, snapshot.elements[i].pocket);
    kept_[0].give(i, snapshot.elements[i].pocket);
    snapshot.elements[i].pocket_to_centre = pocket_set_->centre(i);
    snapshot.elements[i].pocket_heat = heat_.part[i];
  }
  if (!end_half_pockets_) return;
  snapshot.cages.resize(end_half_pockets_->size());
  for (std::size_t i = 0; i < end_half_pockets_->size(); ++i) {
    auto& half = snapshot.cages[static_cast<std::size_t>(end_half_pockets_->segment(i))].last_half;
    end_half_pockets_->report(i, half);
    kept_[1].give(i, half);
  }
}

void PocketContact::look(const Evaluation&, Look& out) const {
  sample_pocket_forces(kept_[0], end_half_pockets_, kept_[1], out);
}

std::unique_ptr<SceneEffect> make_pocket_contact(const ScenePlan& plan) {
  if (!plan.has(Effect::PocketContact) || plan.rollers) return nullptr;
  return std::make_unique<PocketContact>();
}
std::span<const LedgerTerm* const> pocket_terms() { return kTerms; }

}  // namespace adore::dynamics
