#include "dynamics/held_balls.hpp"

#include "contact/wavy_groove.hpp"

#include <algorithm>
#include <cmath>

namespace adore::dynamics {
namespace {

BallSpringsKernel kernel_of(InstructionSet set) noexcept {
#if defined(__x86_64__)
  if (set == InstructionSet::Avx512) return ball_springs_avx512;
  if (set == InstructionSet::Avx2) return ball_springs_avx2;
#endif
  (void)set;
  return ball_springs_baseline;
}

/// Pose of a race in the azimuth frame of ball i.
RacePose seen_by(const Evaluation& e, std::size_t i, const RacePose& pose) noexcept {
  return {e.to_cylindrical(i, pose.centre), e.to_cylindrical(i, pose.axis),
          e.to_cylindrical(i, pose.zero), azimuth_frame(e.elements.theta[i]).transpose()};
}
RacePose seen_by(const Evaluation& e, std::size_t i, const RaceBody& race) noexcept {
  return {e.to_cylindrical(i, race.position), e.to_cylindrical(i, race.axis())};
}

}  // namespace

QuasiStaticBalls::QuasiStaticBalls(const std::array<RaceContactModel, 2>& contacts,
                                   const std::array<std::array<contact::SplitRaceHalf, 2>, 2>& half,
                                   const ElementMasses& masses, std::size_t balls)
    : contacts_(contacts),
      offset_(std::min(contacts[0].groove.offset[0], contacts[0].groove.offset[1])),
      kernel_(kernel_of(chosen_instruction_set())),
      found_(balls) {
  const bool round = !contacts[0].wavy || contacts[0].wavy->forms == nullptr;
  const std::size_t own =
      masses.all_equal() && !contacts[0].own && !contacts[1].own && round ? 1 : balls;
  for (std::size_t i = 0; i < own; ++i) {
    const RaceContactModel &outer = contacts[0].of(i), &inner = contacts[1].of(i);
    ConstrainedBall ball(outer.groove, {outer.hertz.K, inner.hertz.K}, masses[i].mass,
                         {outer.angle, inner.angle});
    ball.set_split_halves(half);
    ball.set_wavy_grooves({outer.wavy.get(), inner.wavy.get()}, i);
    offset_ = std::min({offset_, outer.groove.offset[0], outer.groove.offset[1]});
    balls_.push_back(ball);
  }
}

RacePose QuasiStaticBalls::pose(const Evaluation& e, std::size_t j) const noexcept {
  const RaceBody& race = e.race[j];
  if (!contacts_[j].wavy) return {race.position, race.axis()};
  return {race.position, race.axis(), race.motion().zero()};
}

Vec2 QuasiStaticBalls::normal_force(const Evaluation& e, std::size_t i) const noexcept {
  Vec2 force = Vec2::Zero();
  for (std::size_t j = 0; j < 2; ++j) {
    const GrooveContact c = ball(i).contact_with(static_cast<int>(j), seen_by(e, i, pose(e, j)),
                                                 {e.elements.x[i], e.elements.r[i]});
    force += c.force.head<2>();
  }
  return force;
}

QuasiStaticPosition QuasiStaticBalls::balanced(const Evaluation& e, std::size_t i,
                                               const Vec2& force) const {
  const ElementViews& b = e.elements;
  const Orbit orbit{Orbit::Kept::Momentum, ball(i).mass() * b.r[i] * b.r[i] * b.theta_dot[i]};
  const std::array<RacePose, 2> poses{pose(e, 0), pose(e, 1)};
  const BallBalance at = ball(i).solve(poses, b.theta[i], orbit, force, {b.x[i], b.r[i]});
  return {at.x, at.r, at.speed, std::max(at.contact[0].load, at.contact[1].load), at.solved};
}

void QuasiStaticBalls::identical_ball_springs(const Evaluation& e, std::size_t j,
                                              std::span<const std::size_t> held,
                                              std::span<ContactLinearization> out) noexcept {
  const RaceBody& race = e.race[j];
  const RaceContactModel& model = contacts_[j];
  const Vec3 axis = race.axis();
  BallSpringsInput in{};
  for (int i = 0; i < 3; ++i) {
    in.centre[i] = race.position[i];
    in.axis[i] = axis[i];
  }
  in.centre_radius = model.groove.centre_radius[j];
  in.offset = model.groove.offset[j];
  in.K = model.hertz.K;
  in.follow = model.angle.follows ? &model.angle : nullptr;
  in.n = held.size();
  in.ball = held.data();
  in.x = e.elements.x, in.r = e.elements.r;
  in.sin_theta = e.sin_theta.data(), in.cos_theta = e.cos_theta.data();
  kernel_(in, found_.data());
  for (std::size_t k = 0; k < held.size(); ++k) {
    const BallSpring& s = found_[k];
    ContactLinearization& of = out[k];
    const Vec2 n(s.normal[0], s.normal[1]);
    of.along[j] = Mat2::Identity() - n * n.transpose();
    of.race[j] << s.xx, s.xy, s.xz, s.xy, s.yy, s.yz, s.xz, s.yz, s.zz;
    of.turning[j].setZero();
    of.normal += Vec3(s.force[0], s.force[1], s.force[2]);
    of.stiffness += of.race[j];
  }
}

void QuasiStaticBalls::general_ball_springs(const Evaluation& e, std::size_t j,
                                            std::span<const std::size_t> held,
                                            std::span<ContactLinearization> out) const noexcept {
  const auto race = static_cast<int>(j);
  for (std::size_t k = 0; k < held.size(); ++k) {
    const std::size_t i = held[k];
    ContactLinearization& of = out[k];
    const Vec2 place(e.elements.x[i], e.elements.r[i]);
    of.turning[j].setZero();
    const GrooveContact c =
        contacts_[j].wavy
            ? ball(i).wavy_contact(race, seen_by(e, i, pose(e, j)), place, of.turning[j])
            : ball(i).contact_with(race, seen_by(e, i, e.race[j]), place);
    const Vec2 n = c.normal.head<2>();
    of.along[j] = Mat2::Identity() - n * n.transpose();
    of.race[j] = c.stiffness;
    of.turning[j] *= e.race[j].speed;
    of.normal += c.force;
    of.stiffness += c.stiffness;
  }
}

void QuasiStaticBalls::springs(const Evaluation& e, std::span<const std::size_t> held,
                               std::span<ContactLinearization> out) noexcept {
  for (std::size_t k = 0; k < held.size(); ++k) {
    out[k].normal.setZero();
    out[k].stiffness.setZero();
  }
  for (std::size_t j = 0; j < 2; ++j) {
    if (!contacts_[j].own && !contacts_[j].wavy)
      identical_ball_springs(e, j, held, out);
    else
      general_ball_springs(e, j, held, out);
  }
}

}  // namespace adore::dynamics
