#include "dynamics/system_motion.hpp"

#include "dynamics/rigid_body.hpp"
#include "tribology/traction_curve.hpp"

#include <algorithm>
#include <cmath>

namespace adore::dynamics {
namespace {

Vec3 vector_at(const double* y, const Slice& slice) noexcept {
  const double* p = y + slice.first;
  return {p[0], p[1], p[2]};
}

Quat quaternion_at(const double* y, const Slice& slice) noexcept {
  const double* p = y + slice.first;
  return {p[0], p[1], p[2], p[3]};
}

template <class Values>
void store(double* dydt, const Slice& slice, const Values& values) noexcept {
  for (int k = 0; k < slice.count; ++k) dydt[slice.first + k] = values[static_cast<std::size_t>(k)];
}
void store(double* dydt, const Slice& slice, const Vec3& v) noexcept {
  for (int k = 0; k < 3; ++k) dydt[slice.first + k] = v[k];
}

}  // namespace

SlipFriction::SlipFriction(const bearing::TractionCurve& curve) : curve_(curve) {
  constexpr double kSlip = tribology::kRegularisationSlip;
  if (tribology::traction_coefficient(curve, 0.0) != 0.0) smoothing_ = kSlip * kSlip;
}

double SlipFriction::per_slip(double u) const noexcept {
  return tribology::traction_coefficient(curve_, u) / std::sqrt(u * u + smoothing_);
}

Evaluation::Evaluation(std::size_t n)
    : sin_theta(n), cos_theta(n), F_x(n), F_r(n), F_theta(n), M_x(n), M_r(n), M_theta(n) {
  for (auto* arrays : {&load, &heat, &load_slip})
    for (auto& array : *arrays) array.assign(n, 0.0);
}

void Evaluation::begin(double time, const double* state, double* rates) noexcept {
  t = time;
  y = state;
  dydt = rates;
  for (auto* array : {&F_x, &F_r, &F_theta, &M_x, &M_r, &M_theta})
    std::fill(array->begin(), array->end(), 0.0);
  cage.force.setZero();
  cage.moment.setZero();
  for (RaceState& r : race) {
    r.force.setZero();
    r.moment.setZero();
  }
  elastic = heat_pockets = heat_lands = wear_cage = 0.0;
  valid = true;
}

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

void CageKinematics::apply(Evaluation& e) noexcept {
  CageState& c = e.cage;
  c.position = vector_at(e.y, s_.position);
  c.velocity = vector_at(e.y, s_.velocity);
  c.to_base = rotation_matrix(normalise(quaternion_at(e.y, s_.orientation)));
  c.omega_body = vector_at(e.y, s_.omega);
  c.omega = c.to_base * c.omega_body;
}

RaceBlock::RaceBlock(const RaceContactModel& model, bool load_slip)
    : model_(model),
      load_slip_(load_slip),
      load_limit_(contact::hertz_load(model.hertz.K, model.groove.ball_radius)) {}

void RaceBlock::apply(Evaluation& e) noexcept {
  const auto j = static_cast<std::size_t>(model_.race);
  RaceState& race = e.race[j];
  const BallForces out{
      e.F_x.data(),     e.F_r.data(),     e.F_theta.data(),
      e.M_x.data(),     e.M_r.data(),     e.M_theta.data(),
      e.load[j].data(), e.heat[j].data(), load_slip_ ? e.load_slip[j].data() : nullptr};
  const RaceSums sums = evaluate_race_contacts(model_, e.balls, race.motion, out);
  race.force += sums.force;
  race.moment += sums.moment;
  e.elastic += sums.elastic_energy;
  e.heat_race[j] = sums.heat;
  e.wear_race[j] = sums.load_slip;
  e.wear_element1[j] = e.load_slip[j][0];
  for (const double Q : e.load[j]) e.valid = e.valid && !(Q > load_limit_);
}

void BallGravity::apply(Evaluation& e) noexcept {
  for (std::size_t i = 0; i < e.balls.n; ++i) {
    const Vec3 f = e.to_cylindrical(i, weight_);
    e.F_x[i] += f[0];
    e.F_r[i] += f[1];
    e.F_theta[i] += f[2];
  }
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

void CageMotion::apply(Evaluation& e) noexcept {
  const CageState& c = e.cage;
  const Vec3 omega_dot =
      euler_rate(inertia_.moments, c.omega_body, c.to_base.transpose() * c.moment);
  const Vec3 acceleration = c.force / inertia_.mass;
  store(e.dydt, s_.position, c.velocity);
  store(e.dydt, s_.velocity, acceleration);
  store(e.dydt, s_.orientation, quaternion_rate(quaternion_at(e.y, s_.orientation), c.omega_body));
  store(e.dydt, s_.omega, omega_dot);
  e.dydt[s_.rotation.first] = c.omega_body[0];
  e.valid = e.valid && std::isfinite(acceleration.sum() + omega_dot.sum() + c.velocity.sum());
}

void OrientationMotion::apply(Evaluation& e) noexcept {
  for (const OrientedElement& element : elements_) {
    const Quat q = quaternion_at(e.y, element.orientation);
    const Vec3 omega = rotation_matrix(normalise(q)).transpose() * e.ball_omega(element.element);
    store(e.dydt, element.orientation, quaternion_rate(q, omega));
    e.dydt[element.rotation.first] = omega[0];
  }
}

void ExternalActions::apply(Evaluation& e) noexcept {
  e.external_force.setZero();
  e.external_moment.setZero();
  for (const RaceState& race : e.race) {
    e.external_force -= race.force;
    e.external_moment -= race.moment + race.motion.centre.cross(race.force);
  }
  if (!has_gravity_) return;
  const BallArrays& b = e.balls;
  double x = 0.0, y = 0.0, z = 0.0;
  for (std::size_t i = 0; i < b.n; ++i) {
    x += b.x[i];
    y -= b.r[i] * b.sin_theta[i];
    z += b.r[i] * b.cos_theta[i];
  }
  const Vec3 first_moment = ball_mass_ * Vec3(x, y, z) + cage_mass_ * e.cage.position;
  e.external_force += (ball_mass_ * static_cast<double>(b.n) + cage_mass_) * gravity_;
  e.external_moment += first_moment.cross(gravity_);
}

void Quadratures::apply(Evaluation& e) noexcept {
  for (std::size_t j = 0; j < 2; ++j) e.race_power[j] = e.race[j].power();
  for (const Entry& entry : entries_) e.dydt[entry.index] = *entry.rate;
}

}  // namespace adore::dynamics
