#include "dynamics/held_balls.hpp"

#include "dynamics/rigid_body.hpp"

#include <algorithm>
#include <cmath>

namespace adore::dynamics {
namespace {

/// Pose of a race in the azimuth frame of ball i.
RacePose seen_by(const Evaluation& e, std::size_t i, const RacePose& pose) noexcept {
  return {e.to_cylindrical(i, pose.centre), e.to_cylindrical(i, pose.axis),
          e.to_cylindrical(i, pose.zero)};
}
RacePose seen_by(const Evaluation& e, std::size_t i, const RaceBody& race) noexcept {
  return {e.to_cylindrical(i, race.position), e.to_cylindrical(i, race.axis())};
}

}  // namespace

HeldBalls::HeldBalls(const Scene& scene, std::size_t balls)
    : scene_(scene),
      offset_(std::min(scene.contacts[0].groove.offset[0], scene.contacts[0].groove.offset[1])) {
  const auto& contacts = scene.contacts;
  const std::size_t own = scene.masses.alike() && !contacts[0].own ? 1 : balls;
  for (std::size_t i = 0; i < own; ++i) {
    const RaceContactModel &outer = contacts[0].of(i), &inner = contacts[1].of(i);
    ConstrainedBall ball(outer.groove, {outer.hertz.K, inner.hertz.K}, scene.masses[i].mass,
                         {outer.angle, inner.angle});
    ball.set_wavy({outer.wavy.get(), inner.wavy.get()});
    offset_ = std::min({offset_, outer.groove.offset[0], outer.groove.offset[1]});
    balls_.push_back(ball);
  }
  for (auto& values : state_) values.assign(balls, 0.0);
  for (auto& values : action_) values.assign(balls, 0.0);
  for (auto* arrays : {&load_, &heat_, &load_slip_})
    for (auto& values : *arrays) values.assign(balls, 0.0);
}

RacePose HeldBalls::pose(const Evaluation& e, std::size_t j) const noexcept {
  const RaceBody& race = e.race[j];
  if (!scene_.contacts[j].wavy) return {race.position, race.axis()};
  return {race.position, race.axis(), race.motion().zero()};
}

Vec2 HeldBalls::normal_force(const Evaluation& e, std::size_t i) const noexcept {
  Vec2 force = Vec2::Zero();
  for (std::size_t j = 0; j < 2; ++j) {
    const GrooveContact c = ball(i).contact_with(static_cast<int>(j), seen_by(e, i, pose(e, j)),
                                                 {e.elements.x[i], e.elements.r[i]});
    force += c.force.head<2>();
  }
  return force;
}

HeldPlace HeldBalls::balanced(const Evaluation& e, std::size_t i, const Vec2& force) const {
  const ElementViews& b = e.elements;
  const Orbit orbit{Orbit::Kept::Momentum,
                    scene_.masses[i].mass * b.r[i] * b.r[i] * b.theta_dot[i]};
  const std::array<RacePose, 2> poses{pose(e, 0), pose(e, 1)};
  const BallBalance at = ball(i).solve(poses, b.theta[i], orbit, force, {b.x[i], b.r[i]});
  return {at.x, at.r, at.speed, std::max(at.contact[0].load, at.contact[1].load), at.solved};
}

contact::WallPoints HeldBalls::pocket_walls(std::size_t i) const noexcept {
  const PocketSet* pockets = scene_.pockets;
  if (pockets == nullptr || !pockets->is_inside(i)) return {};
  if (!pockets->shaped() && pockets->surely_open(i)) return {};
  contact::WallPoints out = pockets->walls(i);
  int touching = 0;
  for (int k = 0; k < out.count; ++k)
    if (out.surface[static_cast<std::size_t>(k)].gap < 0.0)
      out.surface[static_cast<std::size_t>(touching++)] = out.surface[static_cast<std::size_t>(k)];
  out.count = touching;
  return out;
}

/// N' m mᵀ, and N over the distance from the pocket axis across it (an estimate where the wall does
/// not go round that axis).
void HeldBalls::add_walls(const Evaluation& e, std::size_t i, Mat3& stiffness) noexcept {
  const contact::WallPoints walls = pocket_walls(i);
  for (int w = 0; w < walls.count; ++w) {
    const contact::WallPoint& wall = walls.surface[static_cast<std::size_t>(w)];
    const PocketSet& set = *scene_.pockets;
    const double N = contact::load(set.law(i), -wall.gap);
    const Vec3 q = set.centre(i);
    const double d = std::max(std::hypot(q[0], q[1]), 1e-9);
    const auto in_frame = [&](const Vec3& v) {
      return e.to_cylindrical(i, set.to_base(i, v, set.body(e, i).to_base));
    };
    const Vec3 m = in_frame(wall.m), t = in_frame({-q[1] / d, q[0] / d, 0.0});
    stiffness +=
        contact::slope(set.law(i), -wall.gap) * m * m.transpose() + N / d * t * t.transpose();
  }
}

void HeldBalls::springs(const Evaluation& e, std::span<const std::size_t> held,
                        std::span<HeldSprings> out) noexcept {
  for (std::size_t k = 0; k < held.size(); ++k) {
    const std::size_t i = held[k];
    if (scene_.pockets != nullptr) scene_.pockets->locate(e, i);
    HeldSprings& of = out[k];
    of.normal.setZero();
    of.stiffness.setZero();
    for (std::size_t j = 0; j < 2; ++j) {
      const auto race = static_cast<int>(j);
      const Vec2 place(e.elements.x[i], e.elements.r[i]);
      const GrooveContact c =
          scene_.contacts[j].wavy
              ? ball(i).wavy_contact(race, seen_by(e, i, pose(e, j)), place, of.turning[j])
              : ball(i).contact_with(race, seen_by(e, i, e.race[j]), place);
      const Vec2 n = c.normal.head<2>();
      of.along[j] = Mat2::Identity() - n * n.transpose();
      of.race[j] = c.stiffness;
      if (scene_.contacts[j].wavy)
        of.turning[j] *= e.race[j].speed;
      else
        of.turning[j].setZero();
      of.normal += c.force;
      of.stiffness += c.stiffness;
    }
    add_walls(e, i, of.stiffness);
  }
}

template <class Friction>
void HeldBalls::add_forces(const Friction& friction, const Evaluation& e, std::size_t i,
                           std::size_t k, const HeldSprings& springs, HeldForces& out) noexcept {
  Vec3 force = {action_[0][k], action_[1][k], action_[2][k]};  // x, r, θ
  Mat2 damping = Mat2::Zero();
  for (std::size_t j = 0; j < 2; ++j)
    add_friction_damping(load_[j][k], heat_[j][k], load_slip_[j][k], springs.along[j], damping);
  out.race_theta = force[2];
  const double mass = scene_.masses[i].mass;
  force += e.to_cylindrical(i, mass * scene_.gravity);
  if (scene_.frame)
    force += e.to_cylindrical(
        i, scene_.frame->inertial_force(mass, e.element_centre(i), e.element_velocity(i)));
  const contact::WallPoints walls = pocket_walls(i);
  for (int w = 0; w < walls.count; ++w) {
    const contact::WallPoint& wall = walls.surface[static_cast<std::size_t>(w)];
    const PocketSet& set = *scene_.pockets;
    const PocketAction a =
        pocket_action(set.law(i), friction, e, i, set.body(e, i), set.ball_radius(i),
                      set.to_base(i, wall.m, set.body(e, i).to_base), -wall.gap);
    force += e.to_cylindrical(i, a.on_ball);
    const Vec2 m = e.to_cylindrical(i, a.m).head<2>();
    damping += a.friction_per_slip * (Mat2::Identity() - m * m.transpose());
  }
  out.force = force;
  out.damping = damping;
}

Vec3 HeldBalls::race_forces(const Evaluation& e, std::span<const std::size_t> held) noexcept {
  const ElementViews balls = view_of(state_, held.size());
  Vec3 on_race = Vec3::Zero();
  for (std::size_t j = 0; j < 2; ++j)
    on_race = evaluate_race_contacts(
                  scene_.contacts[j], balls, e.race[j].motion(),
                  forces_in(action_, load_[j].data(), heat_[j].data(), load_slip_[j].data()))
                  .force;  // of the inner race last
  return on_race;
}

/// Balls that differ, of which some are held.
Vec3 HeldBalls::race_forces_one_by_one(const Evaluation& e,
                                       std::span<const std::size_t> held) noexcept {
  Vec3 on_race = Vec3::Zero();
  for (std::size_t k = 0; k < held.size(); ++k) {
    ElementViews one = view_of(state_, 1);
    for (const auto view : kElementViews) one.*view += k;
    for (std::size_t j = 0; j < 2; ++j) {
      ElementForces out =
          forces_in(action_, load_[j].data() + k, heat_[j].data() + k, load_slip_[j].data() + k);
      for (const auto action : kElementActions) out.*action += k;
      const Vec3 force =
          evaluate_race_contacts(scene_.contacts[j].of(held[k]), one, e.race[j].motion(), out)
              .force;
      if (j == 1) on_race += force;
    }
  }
  return on_race;
}

Vec3 HeldBalls::forces(Evaluation& e, std::span<const std::size_t> held,
                       std::span<const HeldSprings> springs, std::span<HeldForces> out) noexcept {
  for (std::size_t k = 0; k < held.size(); ++k) gather(e.elements, held[k], state_, k);
  for (auto& values : action_) std::fill_n(values.begin(), held.size(), 0.0);
  const Vec3 on_race =
      scene_.contacts[0].own ? race_forces_one_by_one(e, held) : race_forces(e, held);
  const auto add_all = [&](const auto& friction) {
    for (std::size_t k = 0; k < held.size(); ++k)
      add_forces(friction, e, held[k], k, springs[k], out[k]);
  };
  if (scene_.pocket_traction) {
    scene_.pocket_law.visit_rounded(add_all);
  } else {
    add_all(nullptr);
  }
  return on_race;
}

}  // namespace adore::dynamics
