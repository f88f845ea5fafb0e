#include "dynamics/effects/rigid_elements.hpp"

#include "base/errors.hpp"
#include "dynamics/effect_makers.hpp"
#include "dynamics/effects/balls.hpp"
#include "dynamics/roller_start.hpp"
#include "dynamics/state_access.hpp"
#include "scene/ledger_terms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace adore::dynamics {
namespace {

/// Component of a roller's axis along the bearing below which its contacts are undefined
/// (contact/roller_race.hpp): it is across the bearing.
constexpr double kLeastAlong = 0.1;

bool lies_across(const Mat3& attitude) noexcept { return !(attitude(0, 0) > kLeastAlong); }

}  // namespace

/// Attitudes as matrices. After ElementKinematics.
class RigidElements::Kinematics final : public EffectBlock {
 public:
  explicit Kinematics(const RigidElements& of) : of_(of) {}
  void apply(Evaluation& e) noexcept override {
    for (std::size_t i = 0; i < of_.attitude_.size(); ++i) {
      e.attitude[i] = rotation_matrix(normalize_quaternion(quaternion_at(e.y, of_.attitude_[i])));
      e.valid = e.valid && !(of_.rollers_ && lies_across(e.attitude[i]));
    }
  }

 private:
  const RigidElements& of_;
};

class RigidElements::Motion final : public EffectBlock {
 public:
  explicit Motion(const RigidElements& of) : of_(of) {}
  void apply(Evaluation& e) noexcept override;

 private:
  const RigidElements& of_;
};

void RigidElements::Motion::apply(Evaluation& e) noexcept {
  const ElementViews& b = e.elements;
  double check = 0.0;
  const auto& [F_x, F_r, F_theta, M_x, M_r, M_theta] = e.actions;
  const auto [x, r, theta, x_dot, r_dot, theta_dot, omega_x, omega_r, omega_theta] =
      rates_in(e.dydt, of_.s_);
  for (std::size_t i = 0; i < b.n; ++i) {
    const double td = b.theta_dot[i];
    const ElementMass& body = of_.masses_[i];
    const double per_mass = 1.0 / body.mass;
    Vec3 acceleration(F_x[i] * per_mass, F_r[i] * per_mass, F_theta[i] * per_mass);
    const Mat3& B = e.attitude[i];
    const Vec3 omega = B.transpose() * e.element_omega(i);
    Vec3 moment = B.transpose() * e.to_base(i, M_x[i], M_r[i], M_theta[i]);
    if (body.has_eccentric_mass)
      moment -= body.arm.cross(Vec3(B.transpose() * e.to_base(i, F_x[i], F_r[i], F_theta[i])));
    const Vec3 rate = body.inverse * (moment - omega.cross(Vec3(body.inertia * omega)));
    if (body.has_eccentric_mass)
      acceleration -=
          e.to_cylindrical(i, B * (rate.cross(body.arm) + omega.cross(omega.cross(body.arm))));
    const double ax = acceleration[0];
    const double ar = acceleration[1] + b.r[i] * td * td;
    const double at = (acceleration[2] - 2.0 * b.r_dot[i] * td) / b.r[i];
    const Vec3 w = e.to_cylindrical(i, B * rate);
    x[i] = b.x_dot[i];
    r[i] = b.r_dot[i];
    theta[i] = td;
    x_dot[i] = ax;
    r_dot[i] = ar;
    theta_dot[i] = at;
    omega_x[i] = w[0];
    omega_r[i] = w[1] + td * b.omega_theta[i];
    omega_theta[i] = w[2] - td * b.omega_r[i];
    store_at(e.dydt, of_.attitude_[i],
             quaternion_rate(quaternion_at(e.y, of_.attitude_[i]), omega));
    check += ax + ar + at + w.sum() + b.x_dot[i] + b.r_dot[i];
  }
  for (const Rotation& one : of_.rotation_)
    e.dydt[one.turn.first] = e.attitude[one.element].col(0).dot(e.element_omega(one.element));
  e.valid = e.valid && std::isfinite(check);
}

void RigidElements::declare(SceneBuilder& scene) {
  const bearing::Bearing& bearing = scene.bearing;
  const int count = bearing.element_count();
  rollers_ = scene.rollers != nullptr;
  if (rollers_)
    start_ = start_poses(*scene.rollers, bearing);
  else
    for (const statics::StaticBall& ball : scene.statics.balls)
      start_.push_back({ball.azimuth,
                        ball.x,
                        ball.r,
                        ball.orbital_speed,
                        {ball.omega_x, ball.omega_r, ball.omega_theta},
                        quaternion_about(Vec3::UnitX(), ball.azimuth)});
  demand(static_cast<int>(start_.size()) == count,
         "the number of elements at the start differs from that of the bearing");
  masses_ = ElementMasses(bearing);
  for (std::size_t q = 0; q < kQuantities.size(); ++q) {
    const ElementQuantity& line = kQuantities[q];
    s_[static_cast<Quantity>(q)] =
        scene.add_element_states("element." + std::string(line.name), line.unit, line.scale);
  }
  for (int i = 0; i < count; ++i)
    attitude_.push_back(scene.quaternion(fmt::format("element{}.quaternion", i + 1), i));
  for (const int i : scene.plan.oriented_elements)
    rotation_.push_back(
        {static_cast<std::size_t>(i),
         scene.state(fmt::format("element{}.rotation", i + 1), "rad", 1, ScaleKind::Angle, i)});
  scene.e.attitude.assign(static_cast<std::size_t>(count), Mat3::Identity());
  scene.block<ElementKinematics>(Phase::Kinematics, kMotionCost, {}, s_);
  scene.block<Kinematics>(Phase::Kinematics, kMotionCost, {}, *this);
  scene.block<Motion>(Phase::Motion, kMotionCost, {}, *this);
}

void RigidElements::start(std::span<double> y) const {
  for (std::size_t i = 0; i < start_.size(); ++i) {
    const ElementStartState& pose = start_[i];
    component(y, s_[Quantity::X], i) = pose.x;
    component(y, s_[Quantity::R], i) = pose.r;
    component(y, s_[Quantity::Theta], i) = pose.azimuth;
    component(y, s_[Quantity::ThetaDot], i) = pose.theta_dot;
    component(y, s_[Quantity::OmegaX], i) = pose.omega[0];
    component(y, s_[Quantity::OmegaR], i) = pose.omega[1];
    component(y, s_[Quantity::OmegaTheta], i) = pose.omega[2];
    store_at(y.data(), attitude_[i], pose.attitude);
  }
}

std::string RigidElements::why_invalid(const Evaluation& e) const {
  for (std::size_t i = 0; i < attitude_.size(); ++i) {
    if (!(e.y[s_.at(Quantity::R, i)] > 0.0))
      return fmt::format(
          "element {} has reached the bearing axis; check speeds, loads and the largest step "
          "(stpMax)",
          i + 1);
    if (rollers_ && lies_across(e.attitude[i]))
      return fmt::format(
          "roller {} has rotated across the bearing: its axis is inclined by more than 84 degrees "
          "to the bearing axis; check its cage pocket and flanges, the loads and the largest step "
          "(stpMax)",
          i + 1);
  }
  return {};
}

Vec3 RigidElements::angular_momentum(const Evaluation& e, std::size_t i) const noexcept {
  const Mat3& B = e.attitude[i];
  return B * (masses_[i].inertia * (B.transpose() * e.element_omega(i)));
}

/// From the state, in which ẋ and ṙ of held elements are zero.
Vec3 RigidElements::velocity_from_state(const Evaluation& e, std::size_t i) const noexcept {
  return e.to_base(i, e.y[s_.at(Quantity::XDot, i)], e.y[s_.at(Quantity::RDot, i)],
                   e.elements.r[i] * e.elements.theta_dot[i]);
}

void RigidElements::store(const Evaluation& e, EnergyLedger& energy) const {
  double kinetic = 0.0;
  for (std::size_t i = 0; i < e.elements.n; ++i) {
    const Vec3 omega = e.element_omega(i);
    const Vec3 velocity = velocity_from_state(e, i) + omega.cross(arm(e, i));
    kinetic +=
        0.5 * masses_[i].mass * velocity.squaredNorm() + 0.5 * omega.dot(angular_momentum(e, i));
  }
  energy.accumulate(terms::kKinetic, kinetic);
}

void RigidElements::carry(const Evaluation& e, Momenta& momenta) const {
  for (std::size_t i = 0; i < e.elements.n; ++i) {
    const Vec3 to_mass = arm(e, i);
    const Vec3 p =
        masses_[i].mass * (velocity_from_state(e, i) + e.element_omega(i).cross(to_mass));
    momenta.add(p, (e.element_centre(i) + to_mass).cross(p) + angular_momentum(e, i));
  }
}

void RigidElements::report(const Evaluation& e, Snapshot& snapshot) const {
  const std::size_t n = e.elements.n;
  snapshot.elements.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    ElementSnapshot& element = snapshot.elements[i];
    element.x = e.elements.x[i];
    element.r = e.elements.r[i];
    element.theta = e.elements.theta[i];
    element.vx = e.y[s_.at(Quantity::XDot, i)];
    element.vr = e.y[s_.at(Quantity::RDot, i)];
    element.theta_dot = e.elements.theta_dot[i];
    element.ax = e.dydt[s_.at(Quantity::XDot, i)];
    element.ar = e.dydt[s_.at(Quantity::RDot, i)];
    element.theta_ddot = e.dydt[s_.at(Quantity::ThetaDot, i)];
    element.omega = Vec3(e.elements.omega_x[i], -e.elements.omega_theta[i], e.elements.omega_r[i]);
    element.oriented = true;
    element.orientation = quaternion_at(e.y, attitude_[i]);
    const Vec3 axis = e.to_cylindrical(i, e.attitude[i].col(0));
    element.x_axis = Vec3(axis[0], -axis[2], axis[1]);
  }
  for (const Rotation& one : rotation_)
    snapshot.elements[one.element].total_rotation = e.y[one.turn.first];
}

std::unique_ptr<SceneEffect> make_rigid_elements(const ScenePlan& plan) {
  return plan.rollers || plan.rigid_balls ? std::make_unique<RigidElements>() : nullptr;
}

}  // namespace adore::dynamics
