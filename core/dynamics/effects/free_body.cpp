#include "dynamics/effects/free_body.hpp"

#include "base/errors.hpp"
#include "dynamics/state_access.hpp"

#include <Eigen/LU>

#include <cmath>

namespace adore::dynamics {

void FreeBody::declare(SceneBuilder& scene, BodyId id, const std::string& name,
                       const bearing::Inertia& inertia, const Vec3& mass_centre) {
  demand(inertia.mass > 0.0 && inertia.moments.minCoeff() > 0.0,
         "a body that moves freely needs a positive mass and positive moments of inertia");
  id_ = id;
  inertia_ = inertia;
  mass_centre_ = mass_centre;
  off_centre_ = !mass_centre.isZero(0.0);
  s_.position = scene.state(name + ".position", "m", 3, ScaleKind::Length, kBorder);
  s_.velocity = scene.state(name + ".velocity", "m/s", 3, ScaleKind::Velocity, kBorder);
  s_.orientation = scene.quaternion(name + ".quaternion", kBorder);
  s_.omega = scene.state(name + ".omega", "rad/s", 3, ScaleKind::Rate, kBorder);
  s_.rotation = scene.state(name + ".rotation", "rad", 1, ScaleKind::Angle, kBorder);
  scene.border_body(id, *this, {s_.position.first, s_.rotation.first + 1 - s_.position.first});
  BodyState& body = scene.e.body(id);
  body.moves = Moves::Integrated;
  body.inertia = inertia;
  body.mass_centre = mass_centre;
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
  body.attitude = normalise(quaternion_at(y, s_.orientation));
  body.to_base = rotation_matrix(body.attitude);
  body.omega_body = vector_at(y, s_.omega);
  body.omega = body.to_base * body.omega_body;
  if (!off_centre_) return;
  const Vec3 to_centre = arm(body);
  body.position -= to_centre;
  body.velocity -= body.omega.cross(to_centre);
}

bool FreeBody::write_rates(const BodyState& body, const double* y, double* dydt) noexcept {
  Vec3 moment = body.moment;
  if (off_centre_) moment -= arm(body).cross(body.force);
  Vec3 acceleration, omega_dot;
  if (!constraints_) {
    acceleration = body.force / inertia_.mass;
    omega_dot = euler_rate(inertia_.moments, body.omega_body, body.to_base.transpose() * moment);
  } else {
    const Mat3& R = body.to_base;
    const RaceAccelerations rates =
        race_accelerations(inertia_.mass, R * inertia_.moments.asDiagonal() * R.transpose(),
                           body.omega, body.force, moment, *constraints_);
    acceleration = rates.acceleration;
    omega_dot = R.transpose() * rates.angular_acceleration;  // ω × ω = 0: no more to it
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
  if (off_centre_) velocity += body.omega.cross(arm(body));
  return 0.5 * inertia_.mass * velocity.squaredNorm() +
         0.5 * w.dot(inertia_.moments.cwiseProduct(w));
}

void FreeBody::carry(const BodyState& body, Momenta& momenta) const {
  Vec3 velocity = body.velocity, position = body.position;
  if (off_centre_) {
    velocity += body.omega.cross(arm(body));
    position += arm(body);
  }
  const Vec3 p = inertia_.mass * velocity;
  momenta.add(p, position.cross(p) + body.to_base * inertia_.moments.cwiseProduct(body.omega_body));
}

void FreeBody::report(const Evaluation& e, BodySnapshot& snapshot) const {
  const BodyState& body = state(e);
  snapshot.position = body.position;
  snapshot.velocity = body.velocity;
  snapshot.acceleration = vector_at(e.dydt, s_.velocity);
  if (off_centre_) {
    const Vec3 to_centre = arm(body), rate = body.to_base * vector_at(e.dydt, s_.omega);
    snapshot.acceleration -= rate.cross(to_centre) + body.omega.cross(body.omega.cross(to_centre));
  }
  snapshot.orientation = quaternion_at(e.y, s_.orientation);
  snapshot.omega = body.omega;
  snapshot.total_rotation = total_turn(e.y);
}

void FreeBody::add_share(const Evaluation& e, std::size_t i, const Vec3& force, const Vec3& moment,
                         double* row) const noexcept {
  const BodyState& body = state(e);
  Vec3 from = e.element_centre(i) - body.position;
  if (off_centre_) from -= arm(body);
  const Vec3 on_body = -(from.cross(force) + moment);
  Vec3 rates;
  std::array<bool, 3> held{};
  if (!constraints_) {
    rates = (body.to_base.transpose() * on_body).cwiseQuotient(inertia_.moments);
  } else {
    const Mat3& R = body.to_base;
    RaceConstraints still = *constraints_;
    still.angular_acceleration.setZero();
    held = still.translation;
    rates = R.transpose() * race_accelerations(inertia_.mass,
                                               R * inertia_.moments.asDiagonal() * R.transpose(),
                                               Vec3::Zero(), Vec3::Zero(), on_body, still)
                                .angular_acceleration;
  }
  for (int k = 0; k < 3; ++k) {
    if (!held[static_cast<std::size_t>(k)])
      row[s_.velocity.first - s_.position.first + k] -= force[k] / inertia_.mass;
    row[s_.omega.first - s_.position.first + k] += rates[k];
  }
}

}  // namespace adore::dynamics
