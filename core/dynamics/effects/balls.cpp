#include "dynamics/effects/balls.hpp"

#include "base/errors.hpp"
#include "dynamics/ball_motion.hpp"
#include "dynamics/effect_makers.hpp"
#include "dynamics/state_access.hpp"
#include "scene/ledger_terms.hpp"

#include <fmt/format.h>

#include <cmath>

namespace adore::dynamics {

void ElementKinematics::apply(Evaluation& e) noexcept {
  e.valid = view_elements(e.y, s_, e.sin_theta.data(), e.cos_theta.data(), e.elements) && e.valid;
}

void BallMotion::apply(Evaluation& e) noexcept {
  e.valid = ball_motion(e.elements, e.actions, mass_, inertia_, rates_in(e.dydt, s_)) && e.valid;
}

UnequalBallMotion::UnequalBallMotion(const ElementSlices& slices, const ElementMasses& masses)
    : s_(slices) {
  for (std::size_t i = 0; i < slices.elements(); ++i) {
    inverse_mass_.push_back(1.0 / masses[i].mass);
    inverse_inertia_.push_back(1.0 / masses[i].inertia(0, 0));
  }
}

void UnequalBallMotion::apply(Evaluation& e) noexcept {
  e.valid =
      ball_motion(e.elements, e.actions, inverse_mass_, inverse_inertia_, rates_in(e.dydt, s_)) &&
      e.valid;
}

void Balls::declare(SceneBuilder& scene) {
  const bearing::Bearing& bearing = scene.bearing;
  demand(bearing.element_count() >= 1, "a bearing needs at least one ball");
  demand(static_cast<int>(scene.statics.balls.size()) == bearing.element_count(),
         "the number of balls in the static solution differs from that of the bearing");
  const Vec3& moments = bearing.element_inertia.moments;
  demand(bearing.element_inertia.mass > 0.0 && moments.minCoeff() > 0.0 &&
             moments.maxCoeff() - moments.minCoeff() <= 1e-9 * moments.maxCoeff(),
         "a ball needs a positive mass and three equal, positive moments of inertia");
  masses_ = ElementMasses(bearing);
  start_ = scene.statics.balls;
  for (std::size_t q = 0; q < kQuantities.size(); ++q) {
    const ElementQuantity& line = kQuantities[q];
    s_[static_cast<Quantity>(q)] =
        scene.add_element_states("element." + std::string(line.name), line.unit, line.scale);
  }
  scene.block<ElementKinematics>(Phase::Kinematics, kMotionCost, {}, s_);
  if (masses_.all_equal())
    scene.block<BallMotion>(Phase::Motion, kMotionCost, {}, s_, masses_[0].mass, moments[0]);
  else
    scene.block<UnequalBallMotion>(Phase::Motion, kMotionCost, {}, s_, masses_);
}

void Balls::start(std::span<double> y) const {
  for (std::size_t i = 0; i < start_.size(); ++i) {
    const statics::StaticBall& ball = start_[i];
    component(y, s_[Quantity::X], i) = ball.x;
    component(y, s_[Quantity::R], i) = ball.r;
    component(y, s_[Quantity::Theta], i) = ball.azimuth;
    component(y, s_[Quantity::ThetaDot], i) = ball.orbital_speed;
    component(y, s_[Quantity::OmegaX], i) = ball.omega_x;
    component(y, s_[Quantity::OmegaR], i) = ball.omega_r;
    component(y, s_[Quantity::OmegaTheta], i) = ball.omega_theta;
  }
}

std::string Balls::why_invalid(const Evaluation& e) const {
  for (int i = 0; i < s_[Quantity::R].count; ++i)
    if (!(e.y[s_[Quantity::R].first + i] > 0.0))
      return fmt::format(
          "element {} has reached the bearing axis; check speeds, loads and the largest step "
          "(stpMax)",
          i + 1);
  return {};
}

/// The velocity comes from the state, in which ẋ and ṙ of held balls are zero.
void Balls::store(const Evaluation& e, EnergyLedger& energy) const {
  const ElementViews& b = e.elements;
  const double *x_dot = e.y + s_[Quantity::XDot].first, *r_dot = e.y + s_[Quantity::RDot].first;
  double kinetic = 0.0;
  for (std::size_t i = 0; i < b.n; ++i) {
    const Vec3 velocity = e.to_base(i, x_dot[i], r_dot[i], b.r[i] * b.theta_dot[i]);
    kinetic += 0.5 * masses_[i].mass * velocity.squaredNorm() +
               0.5 * masses_[i].inertia(0, 0) * e.element_omega(i).squaredNorm();
  }
  energy.accumulate(terms::kKinetic, kinetic);
}

void Balls::carry(const Evaluation& e, Momenta& momenta) const {
  const ElementViews& b = e.elements;
  const double *x_dot = e.y + s_[Quantity::XDot].first, *r_dot = e.y + s_[Quantity::RDot].first;
  for (std::size_t i = 0; i < b.n; ++i) {
    const Vec3 p = masses_[i].mass * e.to_base(i, x_dot[i], r_dot[i], b.r[i] * b.theta_dot[i]);
    momenta.add(p, e.element_centre(i).cross(p) + masses_[i].inertia(0, 0) * e.element_omega(i));
  }
}

void Balls::report(const Evaluation& e, Snapshot& snapshot) const {
  const std::size_t n = e.elements.n;
  snapshot.elements.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    ElementSnapshot& ball = snapshot.elements[i];
    const auto at = [i](const double* values, const Slice& slice) {
      return values[slice.first + static_cast<int>(i)];
    };
    ball.x = e.elements.x[i];
    ball.r = e.elements.r[i];
    ball.theta = at(e.y, s_[Quantity::Theta]);
    ball.vx = at(e.y, s_[Quantity::XDot]);
    ball.vr = at(e.y, s_[Quantity::RDot]);
    ball.theta_dot = e.elements.theta_dot[i];
    ball.ax = at(e.dydt, s_[Quantity::XDot]);
    ball.ar = at(e.dydt, s_[Quantity::RDot]);
    ball.theta_ddot = at(e.dydt, s_[Quantity::ThetaDot]);
    ball.omega = Vec3(e.elements.omega_x[i], -e.elements.omega_theta[i], e.elements.omega_r[i]);
  }
}

std::unique_ptr<SceneEffect> make_balls(const ScenePlan& plan) {
  return plan.rollers || plan.rigid_balls ? nullptr : std::make_unique<Balls>();
}

}  // namespace adore::dynamics
