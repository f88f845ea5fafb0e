#include "dynamics/held_balls.hpp"

#include "dynamics/rigid_body.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace adore::dynamics {
namespace {

/// Floor of B, in N/m and as a share of its largest stiffness: keeps B² far from rounding.
constexpr double kNoStiffness = 1e-6;

/// Pose of a race in the azimuth frame of ball i.
RacePose seen_by(const Evaluation& e, std::size_t i, const RacePose& pose) noexcept {
  return {e.to_cylindrical(i, pose.centre), e.to_cylindrical(i, pose.axis),
          e.to_cylindrical(i, pose.zero)};
}
RacePose seen_by(const Evaluation& e, std::size_t i, const RaceBody& race) noexcept {
  return {e.to_cylindrical(i, race.position), e.to_cylindrical(i, race.axis())};
}

Vec3 e_theta_at(const Evaluation& e, std::size_t i) noexcept {
  return {0.0, -e.cos_theta[i], -e.sin_theta[i]};
}

/// Square root of a symmetric positive definite 2x2 matrix.
Mat2 square_root(const Mat2& M) noexcept {
  const double s = std::sqrt(std::max(M.determinant(), 0.0));
  return (M + s * Mat2::Identity()) / std::sqrt(M.trace() + 2.0 * s);
}

}  // namespace

HeldBalls::HeldBalls(const Scene& scene, const ElementSlices& slices, std::size_t balls)
    : scene_(scene),
      slices_(slices),
      ball_(scene.contacts[0].groove, {scene.contacts[0].hertz.K, scene.contacts[1].hertz.K},
            scene.mass, {scene.contacts[0].angle, scene.contacts[1].angle}),
      offset_(std::min(scene.contacts[0].groove.offset[0], scene.contacts[0].groove.offset[1])),
      flags_(balls, 0),
      x_dot_(balls, 0.0),
      r_dot_(balls, 0.0),
      residual_(balls, Vec2::Zero()),
      estimate_(balls) {
  std::array<const contact::WavyGroove*, 2> wavy{};
  for (std::size_t j = 0; j < 2; ++j)
    if (scene.contacts[j].wavy) wavy[j] = &*scene.contacts[j].wavy;
  ball_.set_wavy(wavy);
  list_.reserve(balls);
  for (auto& values : state_) values.assign(balls, 0.0);
  for (auto& values : action_) values.assign(balls, 0.0);
  for (auto* arrays : {&load_, &heat_, &load_slip_})
    for (auto& values : *arrays) values.assign(balls, 0.0);
}

void HeldBalls::set(std::size_t i, bool held) {
  flags_[i] = held ? 1 : 0;
  list_.clear();
  for (std::size_t k = 0; k < flags_.size(); ++k)
    if (flags_[k] != 0) list_.push_back(k);
}

RacePose HeldBalls::pose(const Evaluation& e, std::size_t j) const noexcept {
  const RaceBody& race = e.race[j];
  if (!scene_.contacts[j].wavy) return {race.position, race.axis()};
  return {race.position, race.axis(), race.motion().zero()};
}

std::array<RacePose, 2> HeldBalls::poses(const Evaluation& e) const noexcept {
  return {pose(e, 0), pose(e, 1)};
}

Vec2 HeldBalls::normal_force(const Evaluation& e, std::size_t i) const noexcept {
  Vec2 force = Vec2::Zero();
  for (std::size_t j = 0; j < 2; ++j) {
    const GrooveContact c = ball_.contact_with(static_cast<int>(j), seen_by(e, i, pose(e, j)),
                                               {e.elements.x[i], e.elements.r[i]});
    force += c.force.head<2>();
  }
  return force;
}

BallBalance HeldBalls::balanced(const Evaluation& e, std::size_t i, const Vec2& force) const {
  const ElementViews& b = e.elements;
  const Orbit orbit{Orbit::Kept::Momentum, scene_.mass * b.r[i] * b.r[i] * b.theta_dot[i]};
  return ball_.solve(poses(e), b.theta[i], orbit, force, {b.x[i], b.r[i]});
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

/// Stiffness of what ball i touches and what follows from it. Vectors in the right-handed basis
/// (e_x, e_r, e_θ) of the ball.
void HeldBalls::estimate(const Evaluation& e, std::size_t k) noexcept {
  const std::size_t i = list_[k];
  const ElementViews& b = e.elements;
  const double td = b.theta_dot[i], r = b.r[i], centrifugal = scene_.mass * r * td * td;
  Estimate& est = estimate_[k];
  est.normal_theta = 0.0;
  Mat3 stiffness = Mat3::Zero();  // of the contacts
  for (std::size_t j = 0; j < 2; ++j) {
    const auto race = static_cast<int>(j);
    const GrooveContact c =
        scene_.contacts[j].wavy
            ? ball_.wavy_contact(race, seen_by(e, i, pose(e, j)), {b.x[i], r}, est.race_turning[j])
            : ball_.contact_with(race, seen_by(e, i, e.race[j]), {b.x[i], r});
    const Vec2 n = c.normal.head<2>();
    est.race_along[j] = Mat2::Identity() - n * n.transpose();
    est.race_stiffness[j] = c.stiffness;
    if (scene_.contacts[j].wavy) est.race_turning[j] *= e.race[j].speed;
    est.normal_theta += c.force[2];
    stiffness += c.stiffness;
  }
  const contact::WallPoints walls = pocket_walls(i);
  for (int w = 0; w < walls.count; ++w) {
    const contact::WallPoint& wall = walls.surface[static_cast<std::size_t>(w)];
    const PocketSet& set = *scene_.pockets;
    // N' m mᵀ, and N over the distance from the pocket axis across it (an estimate where the wall
    // does not go round that axis).
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
  Mat2 B = stiffness.topLeftCorner<2, 2>();
  if (scene_.axial_suppressed) B(0, 1) = B(1, 0) = 0.0;
  B(1, 1) += 3.0 * centrifugal / r;  // of L²/(m r³)
  const double floor = kSoft * scene_.mass * td * td + kNoStiffness * (1.0 + std::abs(B.trace()));
  const Mat2 square = B * B + floor * floor * Mat2::Identity();
  est.damping = 2.0 * std::sqrt(scene_.mass) * square_root(square_root(square));
  est.inverse = B * square.inverse();
  if (scene_.axial_suppressed) est.inverse.row(0).setZero();
  est.per_orbit = Vec2(0.0, 2.0 * td / r);
}

/// w: rates of the balance of race normals, L changing by those alone.
void HeldBalls::first_rates(const Evaluation& e, std::size_t k) noexcept {
  const std::size_t i = list_[k];
  const Estimate& est = estimate_[k];
  const double td = e.elements.theta_dot[i], r = e.elements.r[i];
  const Vec3 orbit(0.0, 0.0, r * td);
  Vec3 drift = Vec3::Zero();  // change of the races' force at fixed x, r
  for (std::size_t j = 0; j < 2; ++j) {
    drift += est.race_stiffness[j] * (e.to_cylindrical(i, e.race[j].velocity) - orbit);
    if (scene_.contacts[j].wavy) drift += est.race_turning[j];
  }
  // e_r turns with the ball: a fixed force changes its r component by F_θ θ̇.
  const Vec2 w = est.inverse * (drift.head<2>() + Vec2(0.0, est.normal_theta * td) +
                                est.per_orbit * (r * est.normal_theta));
  x_dot_[i] = w[0];
  r_dot_[i] = w[1];
}

/// The force of ball i on the inner race is Q n: it changes by S v of the ball less S v of the
/// race, S the contact's stiffness, and the ball follows the race by B⁻¹ S.
void HeldBalls::move_race(Evaluation& e) noexcept {
  Mat3 stiffness = Mat3::Zero();
  Vec3 drift = Vec3::Zero();
  for (std::size_t k = 0; k < list_.size(); ++k) {
    const std::size_t i = list_[k];
    const Mat3& S = estimate_[k].race_stiffness[1];
    Mat3 frame;  // base axes -> (x, r, θ)
    for (int axis = 0; axis < 3; ++axis) frame.col(axis) = e.to_cylindrical(i, Vec3::Unit(axis));
    Mat3 held = S;
    held -= S.leftCols<2>() * estimate_[k].inverse * S.topRows<2>();
    stiffness += frame.transpose() * held * frame;
    const Vec3 velocity(x_dot_[i], r_dot_[i], e.elements.r[i] * e.elements.theta_dot[i]);
    drift += frame.transpose() * (S * velocity);
    if (scene_.contacts[1].wavy) drift -= frame.transpose() * estimate_[k].race_turning[1];
  }
  scene_.race->estimate(stiffness, drift, scene_.mass * static_cast<double>(list_.size()));
  follow_race(e, scene_.race->velocity());
  e.race[1].velocity = scene_.race->velocity();
}

void HeldBalls::follow_race(const Evaluation& e, const Vec3& velocity) noexcept {
  for (std::size_t k = 0; k < list_.size(); ++k) {
    const std::size_t i = list_[k];
    const Vec2 more = estimate_[k].inverse *
                      (estimate_[k].race_stiffness[1] * e.to_cylindrical(i, velocity)).head<2>();
    x_dot_[i] += more[0];
    r_dot_[i] += more[1];
  }
}

/// Adds (A + C)⁻¹ G(w) and what race friction adds to L̇. Blows of the cage are left to the former.
template <class Friction>
void HeldBalls::pull(const Friction& friction, Evaluation& e, std::size_t k) noexcept {
  const std::size_t i = list_[k];
  const ElementViews& b = e.elements;
  const Estimate& est = estimate_[k];
  const double td = b.theta_dot[i];
  Vec3 force = {action_[0][k], action_[1][k], action_[2][k]};  // x, r, θ
  Mat2 damping = Mat2::Zero();
  for (std::size_t j = 0; j < 2; ++j) {
    const double Q = load_[j][k], u = load_slip_[j][k];  // mean slip speed u/Q, mean κ heat/u
    if (u > 0.0 && heat_[j][k] > 0.0)
      damping += heat_[j][k] * (Q / u) * (Q / u) * est.race_along[j];
  }
  const double friction_theta = force[2] - est.normal_theta;
  force += e.to_cylindrical(i, scene_.mass * scene_.gravity);
  if (scene_.frame)
    force += e.to_cylindrical(
        i, scene_.frame->inertial_force(scene_.mass, e.element_centre(i), e.element_velocity(i)));
  const contact::WallPoints walls = pocket_walls(i);
  for (int w = 0; w < walls.count; ++w) {
    const contact::WallPoint& wall = walls.surface[static_cast<std::size_t>(w)];
    const PocketSet& set = *scene_.pockets;
    const PocketAction a =
        pocket_action(set.law(i), friction, e, i, set.body(e, i), set.ball_radius(),
                      set.to_base(i, wall.m, set.body(e, i).to_base), -wall.gap);
    force += e.to_cylindrical(i, a.on_ball);
    const Vec2 m = e.to_cylindrical(i, a.m).head<2>();
    damping += a.friction_per_slip * (Mat2::Identity() - m * m.transpose());
  }
  Vec2 G(force[0], force[1] + scene_.mass * b.r[i] * td * td);
  if (scene_.axial_suppressed) {
    G[0] = 0.0;
    damping(0, 1) = damping(1, 0) = 0.0;
  }
  Vec2 p = (est.damping + damping).inverse() * G;
  const double size = G.norm();
  if (size > 0.0)
    p /= std::sqrt(1.0 + scene_.mass * p.squaredNorm() / (2.0 * size * kFreePath * offset_));
  p += est.inverse * est.per_orbit * (b.r[i] * friction_theta);
  x_dot_[i] += p[0];
  r_dot_[i] += p[1];
}

void HeldBalls::form_rates(Evaluation& e) noexcept {
  const std::size_t n = e.elements.n, held = list_.size();
  std::copy(e.elements.x_dot, e.elements.x_dot + n, x_dot_.begin());
  std::copy(e.elements.r_dot, e.elements.r_dot + n, r_dot_.begin());
  e.elements.x_dot = x_dot_.data();
  e.elements.r_dot = r_dot_.data();
  if (held == 0) return;

  for (std::size_t k = 0; k < held; ++k) {
    if (scene_.pockets != nullptr) scene_.pockets->locate(e, list_[k]);
    estimate(e, k);
    first_rates(e, k);
  }
  if (scene_.race != nullptr) move_race(e);
  for (std::size_t k = 0; k < held; ++k) gather(e.elements, list_[k], state_, k);
  for (auto& values : action_) std::fill_n(values.begin(), held, 0.0);
  const ElementViews balls = view_of(state_, held);
  Vec3 on_race = Vec3::Zero();
  for (std::size_t j = 0; j < 2; ++j)
    on_race = evaluate_race_contacts(
                  scene_.contacts[j], balls, e.race[j].motion(),
                  forces_in(action_, load_[j].data(), heat_[j].data(), load_slip_[j].data()))
                  .force;  // of the inner race last
  const auto pull_all = [&](const auto& friction) {
    for (std::size_t k = 0; k < held; ++k) pull(friction, e, k);
  };
  if (scene_.pocket_traction) {
    scene_.pocket_law.visit_rounded(pull_all);
  } else {
    pull_all(nullptr);
  }
  if (scene_.race == nullptr) return;
  const Vec3 pull = scene_.race->pull(on_race);
  follow_race(e, pull);
  e.race[1].velocity += pull;
}

/// The inertia that is left out would take m(ẍ, r̈ - rθ̇²) = F: what the equations of motion found
/// for ẍ, r̈ is G/m. Momentum is that of r θ̇ alone, p = m r θ̇ e_θ: ṗ = F - G - m ṙ θ̇ e_θ.
void HeldBalls::take_inertia_out(Evaluation& e) noexcept {
  account_ = {};
  const double m = scene_.mass;
  for (const std::size_t i : list_) {
    double& ax = e.dydt[slices_.at(Quantity::XDot, i)];
    double& ar = e.dydt[slices_.at(Quantity::RDot, i)];
    const double td = e.elements.theta_dot[i], r = e.elements.r[i];
    residual_[i] = Vec2(m * ax, m * ar);
    account_.power += residual_[i].dot(rate(i));
    const Vec3 force = e.to_base(i, m * ax, m * ar, m * r_dot_[i] * td);
    const Vec3 velocity = e.to_base(i, x_dot_[i], r_dot_[i], 0.0);
    account_.force += force;
    account_.moment +=
        e.element_centre(i).cross(force) - velocity.cross(m * r * td * e_theta_at(e, i));
    ax = ar = 0.0;
  }
}

}  // namespace adore::dynamics
