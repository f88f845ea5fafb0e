#include "dynamics/held_balls.hpp"

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

HeldBalls::HeldBalls(const std::array<RaceContactModel, 2>& contacts, const ElementMasses& masses,
                     std::size_t balls)
    : contacts_(contacts),
      offset_(std::min(contacts[0].groove.offset[0], contacts[0].groove.offset[1])) {
  const std::size_t own = masses.alike() && !contacts[0].own ? 1 : balls;
  for (std::size_t i = 0; i < own; ++i) {
    const RaceContactModel &outer = contacts[0].of(i), &inner = contacts[1].of(i);
    ConstrainedBall ball(outer.groove, {outer.hertz.K, inner.hertz.K}, masses[i].mass,
                         {outer.angle, inner.angle});
    ball.set_wavy({outer.wavy.get(), inner.wavy.get()});
    offset_ = std::min({offset_, outer.groove.offset[0], outer.groove.offset[1]});
    balls_.push_back(ball);
  }
}

RacePose HeldBalls::pose(const Evaluation& e, std::size_t j) const noexcept {
  const RaceBody& race = e.race[j];
  if (!contacts_[j].wavy) return {race.position, race.axis()};
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
  const Orbit orbit{Orbit::Kept::Momentum, ball(i).mass() * b.r[i] * b.r[i] * b.theta_dot[i]};
  const std::array<RacePose, 2> poses{pose(e, 0), pose(e, 1)};
  const BallBalance at = ball(i).solve(poses, b.theta[i], orbit, force, {b.x[i], b.r[i]});
  return {at.x, at.r, at.speed, std::max(at.contact[0].load, at.contact[1].load), at.solved};
}

void HeldBalls::springs(const Evaluation& e, std::span<const std::size_t> held,
                        std::span<HeldSprings> out) noexcept {
  for (std::size_t k = 0; k < held.size(); ++k) {
    const std::size_t i = held[k];
    HeldSprings& of = out[k];
    of.normal.setZero();
    of.stiffness.setZero();
    for (std::size_t j = 0; j < 2; ++j) {
      const auto race = static_cast<int>(j);
      const Vec2 place(e.elements.x[i], e.elements.r[i]);
      const GrooveContact c =
          contacts_[j].wavy
              ? ball(i).wavy_contact(race, seen_by(e, i, pose(e, j)), place, of.turning[j])
              : ball(i).contact_with(race, seen_by(e, i, e.race[j]), place);
      const Vec2 n = c.normal.head<2>();
      of.along[j] = Mat2::Identity() - n * n.transpose();
      of.race[j] = c.stiffness;
      if (contacts_[j].wavy)
        of.turning[j] *= e.race[j].speed;
      else
        of.turning[j].setZero();
      of.normal += c.force;
      of.stiffness += c.stiffness;
    }
  }
}

}  // namespace adore::dynamics
