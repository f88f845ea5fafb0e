#include "dynamics/effects/free_body.hpp"

#include "base/errors.hpp"
#include "dynamics/state_access.hpp"

#include <Eigen/LU>

#include <cmath>

namespace adore::dynamics {

void FreeBody::declare(SceneBuilder& scene, BodyId id, const std::string& name,
                       const bearing::Inertia& inertia) {
  demand(inertia.mass > 0.0 && inertia.moments.minCoeff() > 0.0,
         "a body that moves freely needs a positive mass and positive moments of inertia");
  id_ = id;
  const RigidBody rigid = rigid_body(inertia);
  mass_ = rigid.mass;
  principal_inertia_ = inertia.moments;
  inertia_ = rigid.inertia;
  inverse_inertia_ = inertia_.inverse();
  principal_axes_aligned_ = inertia.frame.isZero(0.0);
  has_eccentric_mass_ = !inertia.geometric_centre.isZero(0.0);
  mass_centre_ = has_eccentric_mass_ ? Vec3(-inertia.geometric_centre) : Vec3(Vec3::Zero());
  s_.position = scene.state(name + ".position", "m", 3, ScaleKind::Length, kBorder);
  s_.velocity = scene.state(name + ".velocity", "m/s", 3, ScaleKind::Velocity, kBorder);
  s_.orientation = scene.quaternion(name + ".quaternion", kBorder);
  s_.omega = scene.state(name + ".omega", "rad/s", 3, ScaleKind::Rate, kBorder);
  s_.rotation = scene.state(name + ".rotation", "rad", 1, ScaleKind::Angle, kBorder);
  scene.add_border_body(id, *this, {s_.position.first, s_.rotation.first + 1 - s_.position.first});
  BodyState& body = scene.e.body(id);
  body.moves = Moves::Integrated;
  body.mass = mass_;
  body.inertia = inertia_;
  body.mass_centre = mass_centre_;
}

void FreeBody::start(std::span<double> y, const Vec3& mass_centre, const Vec3& velocity,
                     const Quat& orientation, const Vec3& omega_body) const {
  store_at(y.data(), s_.position, mass_centre);
  store_at(y.data(), s_.velocity, velocity);
  store_at(y.data(), s_.orientation, orientation);
  store_at(y.data(), s_.omega, omega_body);
}

const BodyState& FreeBody::state(const Evaluation& e) const noexcept { return e.body(id_); }

void FreeBody::read(const double* y, BodyState& body) const noexcept {
  body.position = vector_at(y, s_.position);
  body.velocity = vector_at(y, s_.velocity);
  body.attitude = normalize_quaternion(quaternion_at(y, s_.orientation));
  body.to_base = rotation_matrix(body.attitude);
  body.omega_body = vector_at(y, s_.omega);
  body.omega = body.to_base * body.omega_body;
  if (!has_eccentric_mass_) return;
  const Vec3 to_centre = arm(body);
  body.position -= to_centre;
  body.velocity -= body.omega.cross(to_centre);
}

Vec3 FreeBody::free_angular_acceleration(const BodyState& body, const Vec3& omega,
                                         const Vec3& moment) const noexcept {
  const Vec3 in_body = body.to_base.transpose() * moment;
  if (principal_axes_aligned_) return euler_rate(principal_inertia_, omega, in_body);
  return inverse_inertia_ * (in_body - omega.cross(Vec3(inertia_ * omega)));
}

bool FreeBody::write_rates(const BodyState& body, const double* y, double* dydt) noexcept {
  Vec3 acceleration, omega_dot;
  if (!constraints_) {
    Vec3 moment = body.moment;
    if (has_eccentric_mass_) moment -= arm(body).cross(body.force);
    acceleration = body.force / mass_;
    omega_dot = free_angular_acceleration(body, body.omega_body, moment);
  } else {
    const ConstrainedBody self = held(body);
    const RaceAccelerations rates =
        constrained_accelerations(self, body.omega, body.force, body.moment, *constraints_);
    const Vec3& alpha = rates.angular_acceleration;
    acceleration =
        rates.acceleration + alpha.cross(self.arm) + body.omega.cross(body.omega.cross(self.arm));
    omega_dot = body.to_base.transpose() * alpha;  // ω × ω = 0: no more to it
    holding_force_ = rates.holding_force;
    holding_moment_ = rates.holding_moment;
  }
  const Vec3 velocity = vector_at(y, s_.velocity);
  store_at(dydt, s_.position, velocity);
  store_at(dydt, s_.velocity, acceleration);
  store_at(dydt, s_.orientation,
           quaternion_rate(quaternion_at(y, s_.orientation), body.omega_body));
  store_at(dydt, s_.omega, omega_dot);
  dydt[s_.rotation.first] = body.omega_body[0];
  return std::isfinite(acceleration.sum() + omega_dot.sum() + velocity.sum());
}

double FreeBody::kinetic_energy(const BodyState& body) const noexcept {
  const Vec3& w = body.omega_body;
  Vec3 velocity = body.velocity;
  if (has_eccentric_mass_) velocity += body.omega.cross(arm(body));
  return 0.5 * mass_ * velocity.squaredNorm() + 0.5 * w.dot(angular_momentum(w));
}

void FreeBody::carry(const BodyState& body, Momenta& momenta) const {
  Vec3 velocity = body.velocity, position = body.position;
  if (has_eccentric_mass_) {
    velocity += body.omega.cross(arm(body));
    position += arm(body);
  }
  const Vec3 p = mass_ * velocity;
  momenta.add(p, position.cross(p) + body.to_base * angular_momentum(body.omega_body));
}

void FreeBody::report(const Evaluation& e, BodySnapshot& snapshot) const {
  const BodyState& body = state(e);
  snapshot.position = body.position;
  snapshot.velocity = body.velocity;
  snapshot.acceleration = vector_at(e.dydt, s_.velocity);
  if (has_eccentric_mass_) {
    const Vec3 to_centre = arm(body), rate = body.to_base * vector_at(e.dydt, s_.omega);
    snapshot.acceleration -= rate.cross(to_centre) + body.omega.cross(body.omega.cross(to_centre));
  }
  snapshot.orientation = quaternion_at(e.y, s_.orientation);
  snapshot.omega = body.omega;
  snapshot.total_rotation = integrated_rotation(e.y);
}

void FreeBody::add_rate_contribution(const Evaluation& e, std::size_t i, const Vec3& force,
                                     const Vec3& moment, double* row) const noexcept {
  const BodyState& body = state(e);
  Vec3 from = e.element_centre(i) - body.position;
  Vec3 acceleration, rates;
  if (!constraints_) {
    if (has_eccentric_mass_) from -= arm(body);
    acceleration = -force / mass_;
    rates = free_angular_acceleration(body, Vec3::Zero(), -(from.cross(force) + moment));
  } else {
    RaceConstraints still = *constraints_;
    still.acceleration.setZero();
    still.angular_acceleration.setZero();
    const ConstrainedBody self = held(body);
    const RaceAccelerations all =
        constrained_accelerations(self, Vec3::Zero(), -force, -(from.cross(force) + moment), still);
    acceleration = all.acceleration + all.angular_acceleration.cross(self.arm);
    rates = body.to_base.transpose() * all.angular_acceleration;
  }
  for (int k = 0; k < 3; ++k) {
    row[s_.velocity.first - s_.position.first + k] += acceleration[k];
    row[s_.omega.first - s_.position.first + k] += rates[k];
  }
}

}  // namespace adore::dynamics
