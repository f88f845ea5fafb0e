#include "dynamics/effects/balls.hpp"

#include "base/errors.hpp"
#include "dynamics/effect_makers.hpp"
#include "dynamics/state_access.hpp"
#include "scene/ledger_terms.hpp"

#include <fmt/format.h>

#include <cmath>

namespace adore::dynamics {

void BallKinematics::apply(Evaluation& e) noexcept {
  const double* y = e.y;
  const auto n = static_cast<std::size_t>(s_.x.count);
  const double* theta = y + s_.theta.first;
  const double* r = y + s_.r.first;
  for (std::size_t i = 0; i < n; ++i) {
    e.sin_theta[i] = std::sin(theta[i]);
    e.cos_theta[i] = std::cos(theta[i]);
    e.valid = e.valid && r[i] > 0.0;
  }
  e.balls = {n,
             y + s_.x.first,
             r,
             e.sin_theta.data(),
             e.cos_theta.data(),
             y + s_.x_dot.first,
             y + s_.r_dot.first,
             y + s_.theta_dot.first,
             y + s_.omega_x.first,
             y + s_.omega_r.first,
             y + s_.omega_theta.first};
}

void BallMotion::apply(Evaluation& e) noexcept {
  const BallArrays& b = e.balls;
  double* d = e.dydt;
  const double per_mass = 1.0 / mass_, per_inertia = 1.0 / inertia_;
  double check = 0.0;
  for (std::size_t i = 0; i < b.n; ++i) {
    const double td = b.theta_dot[i];
    const double ax = e.F_x[i] * per_mass;
    const double ar = e.F_r[i] * per_mass + b.r[i] * td * td;
    const double at = (e.F_theta[i] * per_mass - 2.0 * b.r_dot[i] * td) / b.r[i];
    const double wx = e.M_x[i] * per_inertia;
    const double wr = e.M_r[i] * per_inertia + td * b.omega_theta[i];
    const double wt = e.M_theta[i] * per_inertia - td * b.omega_r[i];
    const auto k = static_cast<int>(i);
    d[s_.x.first + k] = b.x_dot[i];
    d[s_.r.first + k] = b.r_dot[i];
    d[s_.theta.first + k] = td;
    d[s_.x_dot.first + k] = ax;
    d[s_.r_dot.first + k] = ar;
    d[s_.theta_dot.first + k] = at;
    d[s_.omega_x.first + k] = wx;
    d[s_.omega_r.first + k] = wr;
    d[s_.omega_theta.first + k] = wt;
    check += ax + ar + at + wx + wr + wt + b.x_dot[i] + b.r_dot[i];
  }
  e.valid = e.valid && std::isfinite(check);
}

void Balls::declare(SceneBuilder& scene) {
  const bearing::Bearing& bearing = scene.bearing;
  demand(bearing.balls.count >= 1, "a bearing needs at least one ball");
  demand(static_cast<int>(scene.statics.balls.size()) == bearing.balls.count,
         "the static solution has another number of balls than the bearing");
  const Vec3& moments = bearing.ball_inertia.moments;
  mass_ = bearing.ball_inertia.mass;
  inertia_ = moments[0];
  demand(mass_ > 0.0 && moments.minCoeff() > 0.0 &&
             moments.maxCoeff() - moments.minCoeff() <= 1e-9 * moments.maxCoeff(),
         "a ball needs a positive mass and three equal, positive moments of inertia");
  start_ = scene.statics.balls;
  s_.x = scene.states_of_elements("element.x", "m", ScaleKind::Length);
  s_.r = scene.states_of_elements("element.r", "m", ScaleKind::Length);
  s_.theta = scene.states_of_elements("element.theta", "rad", ScaleKind::Angle);
  s_.x_dot = scene.states_of_elements("element.x_dot", "m/s", ScaleKind::Velocity);
  s_.r_dot = scene.states_of_elements("element.r_dot", "m/s", ScaleKind::Velocity);
  s_.theta_dot = scene.states_of_elements("element.theta_dot", "rad/s", ScaleKind::Rate);
  s_.omega_x = scene.states_of_elements("element.omega_x", "rad/s", ScaleKind::Rate);
  s_.omega_r = scene.states_of_elements("element.omega_r", "rad/s", ScaleKind::Rate);
  s_.omega_theta = scene.states_of_elements("element.omega_theta", "rad/s", ScaleKind::Rate);
  scene.block<BallKinematics>(Phase::Kinematics, kMotionCost, false, s_);
  scene.block<BallMotion>(Phase::Motion, kMotionCost, false, s_, mass_, inertia_);
}

void Balls::start(std::span<double> y) const {
  for (std::size_t i = 0; i < start_.size(); ++i) {
    const statics::StaticBall& ball = start_[i];
    component(y, s_.x, i) = ball.x;
    component(y, s_.r, i) = ball.r;
    component(y, s_.theta, i) = ball.azimuth;
    component(y, s_.theta_dot, i) = ball.orbital_speed;
    component(y, s_.omega_x, i) = ball.omega_x;
    component(y, s_.omega_r, i) = ball.omega_r;
    component(y, s_.omega_theta, i) = ball.omega_theta;
  }
}

std::string Balls::why_invalid(const Evaluation& e) const {
  for (int i = 0; i < s_.r.count; ++i)
    if (!(e.y[s_.r.first + i] > 0.0))
      return fmt::format(
          "element {} has reached the bearing axis; check speeds, loads and the largest step",
          i + 1);
  return {};
}

/// The velocity comes from the state: ẋ and ṙ of held balls stand there as zero.
void Balls::store(const Evaluation& e, EnergyLedger& energy) const {
  const BallArrays& b = e.balls;
  const double *x_dot = e.y + s_.x_dot.first, *r_dot = e.y + s_.r_dot.first;
  double kinetic = 0.0;
  for (std::size_t i = 0; i < b.n; ++i) {
    const Vec3 velocity = e.to_base(i, x_dot[i], r_dot[i], b.r[i] * b.theta_dot[i]);
    kinetic +=
        0.5 * mass_ * velocity.squaredNorm() + 0.5 * inertia_ * e.ball_omega(i).squaredNorm();
  }
  energy.accumulate(terms::kKinetic, kinetic);
}

void Balls::carry(const Evaluation& e, Momenta& momenta) const {
  const BallArrays& b = e.balls;
  const double *x_dot = e.y + s_.x_dot.first, *r_dot = e.y + s_.r_dot.first;
  for (std::size_t i = 0; i < b.n; ++i) {
    const Vec3 p = mass_ * e.to_base(i, x_dot[i], r_dot[i], b.r[i] * b.theta_dot[i]);
    momenta.add(p, e.ball_centre(i).cross(p) + inertia_ * e.ball_omega(i));
  }
}

void Balls::report(const Evaluation& e, Snapshot& snapshot) const {
  const std::size_t n = e.balls.n;
  snapshot.elements.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    ElementSnapshot& ball = snapshot.elements[i];
    const auto at = [i](const double* values, const Slice& slice) {
      return values[slice.first + static_cast<int>(i)];
    };
    ball.x = e.balls.x[i];
    ball.r = e.balls.r[i];
    ball.theta = at(e.y, s_.theta);
    ball.vx = at(e.y, s_.x_dot);
    ball.vr = at(e.y, s_.r_dot);
    ball.theta_dot = e.balls.theta_dot[i];
    ball.ax = at(e.dydt, s_.x_dot);
    ball.ar = at(e.dydt, s_.r_dot);
    ball.theta_ddot = at(e.dydt, s_.theta_dot);
    ball.omega = Vec3(e.balls.omega_x[i], -e.balls.omega_theta[i], e.balls.omega_r[i]);
  }
}

std::unique_ptr<SceneEffect> make_balls(const ScenePlan&) { return std::make_unique<Balls>(); }

}  // namespace adore::dynamics
