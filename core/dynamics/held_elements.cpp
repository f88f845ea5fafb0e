#include "dynamics/held_elements.hpp"

#include "dynamics/rigid_body.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <utility>

namespace adore::dynamics {
namespace {

/// Floor of B, in N/m and as a share of its largest stiffness: keeps B² far from rounding.
constexpr double kNoStiffness = 1e-6;

Vec3 e_theta_at(const Evaluation& e, std::size_t i) noexcept {
  return {0.0, -e.cos_theta[i], -e.sin_theta[i]};
}

/// Base axes -> (x, r, θ) of element i.
Mat3 azimuth_frame(const Evaluation& e, std::size_t i) noexcept {
  Mat3 frame;
  for (int axis = 0; axis < 3; ++axis) frame.col(axis) = e.to_cylindrical(i, Vec3::Unit(axis));
  return frame;
}

/// From the reference point to the mass center, on (x, r, θ).
Vec3 arm_of(const Evaluation& e, std::size_t i, const ElementMass& body) noexcept {
  return e.to_cylindrical(i, Vec3(e.attitude[i] * body.arm));
}

/// Square root of a symmetric positive definite 2x2 matrix.
Mat2 square_root(const Mat2& M) noexcept {
  const double s = std::sqrt(std::max(M.determinant(), 0.0));
  return (M + s * Mat2::Identity()) / std::sqrt(M.trace() + 2.0 * s);
}

}  // namespace

QuasiStaticElements::QuasiStaticElements(const Scene& scene, const ElementSlices& slices,
                                         std::unique_ptr<QuasiStaticContacts> contacts,
                                         ForcePass pass)
    : scene_(scene),
      slices_(slices),
      contacts_(std::move(contacts)),
      pass_(pass),
      quasi_static_flags_(slices.elements(), 0),
      x_dot_(slices.elements(), 0.0),
      r_dot_(slices.elements(), 0.0),
      residual_(slices.elements(), Vec2::Zero()),
      springs_(slices.elements()),
      forces_(slices.elements()),
      estimate_(slices.elements()) {
  quasi_static_indices_.reserve(slices.elements());
}

void QuasiStaticElements::set(std::size_t i, bool held) {
  quasi_static_flags_[i] = held ? 1 : 0;
  quasi_static_indices_.clear();
  for (std::size_t k = 0; k < quasi_static_flags_.size(); ++k)
    if (quasi_static_flags_[k] != 0) quasi_static_indices_.push_back(k);
}

/// Stiffness of what element i touches and what follows from it.
void QuasiStaticElements::estimate(const Evaluation& e, std::size_t k) noexcept {
  const std::size_t i = quasi_static_indices_[k];
  const ElementViews& b = e.elements;
  const double mass = scene_.masses[i].mass;
  const double td = b.theta_dot[i], r = b.r[i], centrifugal = mass * r * td * td;
  Estimate& est = estimate_[k];
  Mat2 B = springs_[k].stiffness.topLeftCorner<2, 2>();
  if (!scene_.axial) B(0, 1) = B(1, 0) = 0.0;
  B(1, 1) += 3.0 * centrifugal / r;  // of L²/(m r³)
  const double floor = kSoft * mass * td * td + kNoStiffness * (1.0 + std::abs(B.trace()));
  const Mat2 square = B * B + floor * floor * Mat2::Identity();
  est.damping = 2.0 * std::sqrt(mass) * square_root(square_root(square));
  const Mat2 first = B * square.inverse();  // off by (floor / B)²; one step of Newton squares that
  est.inverse = first * (2.0 * Mat2::Identity() - B * first);
  if (!scene_.axial) est.inverse.row(0).setZero();
  est.per_orbit = Vec2(0.0, 2.0 * td / r);
}

/// w: rates of the balance of race normals, L changing by those alone.
void QuasiStaticElements::predict_rates(const Evaluation& e, std::size_t k) noexcept {
  const std::size_t i = quasi_static_indices_[k];
  const Estimate& est = estimate_[k];
  const ContactLinearization& springs = springs_[k];
  const double td = e.elements.theta_dot[i], r = e.elements.r[i];
  const Vec3 orbit(scene_.axial ? 0.0 : e.elements.x_dot[i], 0.0, r * td);
  Vec3 drift = Vec3::Zero();  // change of the races' force at fixed x, r
  for (std::size_t j = 0; j < 2; ++j)
    drift +=
        springs.race[j] * (e.to_cylindrical(i, e.race[j].velocity) - orbit) + springs.turning[j];
  // e_r turns with the element: a fixed force changes its r component by F_θ θ̇.
  const Vec2 w = est.inverse * (drift.head<2>() + Vec2(0.0, springs.normal[2] * td) +
                                est.per_orbit * (r * springs.normal[2]));
  if (scene_.axial) x_dot_[i] = w[0];
  r_dot_[i] = w[1];
}

/// The force of element i on the inner race is Q n: it changes by S v of the element less S v of
/// the race, S the contact's stiffness, and the element follows the race by B⁻¹ S.
void QuasiStaticElements::move_race(Evaluation& e) noexcept {
  Mat3 stiffness = Mat3::Zero();
  Vec3 drift = Vec3::Zero();
  double mass = 0.0;
  for (std::size_t k = 0; k < quasi_static_indices_.size(); ++k) {
    const std::size_t i = quasi_static_indices_[k];
    mass += scene_.masses[i].mass;
    const Mat3& S = springs_[k].race[1];
    const Mat3 frame = azimuth_frame(e, i);
    Mat3 held = S;
    held -= S.leftCols<2>() * estimate_[k].inverse * S.topRows<2>();
    stiffness += frame.transpose() * held * frame;
    const Vec3 velocity(x_dot_[i], r_dot_[i], e.elements.r[i] * e.elements.theta_dot[i]);
    drift += frame.transpose() *
             (S * (velocity - e.to_cylindrical(i, e.race[1].velocity)) - springs_[k].turning[1]);
  }
  scene_.race->estimate_velocity(stiffness, drift, mass);
  follow_race(e, scene_.race->velocity());
  e.race[1].velocity += scene_.race->velocity();
}

void QuasiStaticElements::follow_race(const Evaluation& e, const Vec3& velocity) noexcept {
  for (std::size_t k = 0; k < quasi_static_indices_.size(); ++k) {
    const std::size_t i = quasi_static_indices_[k];
    const Vec2 more =
        estimate_[k].inverse * (springs_[k].race[1] * e.to_cylindrical(i, velocity)).head<2>();
    x_dot_[i] += more[0];
    r_dot_[i] += more[1];
  }
}

/// Adds (A + C)⁻¹ G(w) and the part of race friction in L̇. Impacts of the cage are left to the
/// former.
void QuasiStaticElements::pull(const Evaluation& e, std::size_t k) noexcept {
  const std::size_t i = quasi_static_indices_[k];
  const ElementViews& b = e.elements;
  const Estimate& est = estimate_[k];
  const Forces& forces = forces_[k];
  const double td = b.theta_dot[i];
  Mat2 damping = forces.friction;
  const ElementMass& body = scene_.masses[i];
  Vec2 G(forces.force[0], forces.force[1] + body.mass * b.r[i] * td * td);
  if (body.has_eccentric_mass) {
    const Vec3 omega(b.omega_x[i], b.omega_r[i], b.omega_theta[i]);
    G -= body.mass * omega.cross(omega.cross(arm_of(e, i, body))).head<2>();
  }
  if (!scene_.axial) {
    G[0] = 0.0;
    damping(0, 1) = damping(1, 0) = 0.0;
  }
  Vec2 p = (est.damping + damping).inverse() * G;
  const double size = G.norm();
  if (size > 0.0)
    p /= std::sqrt(1.0 +
                   body.mass * p.squaredNorm() / (2.0 * size * contacts_->max_free_displacement()));
  const double friction_theta = forces.race_theta - springs_[k].normal[2];
  p += est.inverse * est.per_orbit * (b.r[i] * friction_theta);
  x_dot_[i] += p[0];
  r_dot_[i] += p[1];
}

/// Friction over slip of a race contact of load Q: Q κ/u = heat (Q/load-slip)².
QuasiStaticElements::RaceForces QuasiStaticElements::form_forces(Evaluation& e) noexcept {
  RaceForces on_race;
  pass_.apply(e, ForcePass::Which::OnRaces);
  for (std::size_t k = 0; k < quasi_static_indices_.size(); ++k)
    forces_[k].race_theta = e.actions[2][quasi_static_indices_[k]];
  if (e.valid) pass_.apply(e, ForcePass::Which::Others);
  for (std::size_t k = 0; e.valid && k < quasi_static_indices_.size(); ++k) {
    const std::size_t i = quasi_static_indices_[k];
    Forces& of = forces_[k];
    of.force = {e.actions[0][i], e.actions[1][i], e.actions[2][i]};
    of.friction.setZero();
    for (std::size_t j = 0; j < 2; ++j) {
      const double load_slip = e.load_slip[j][i], heat = e.heat[j][i];
      if (!(load_slip > 0.0 && heat > 0.0)) continue;
      const double share = e.load[j][i] / load_slip, friction = heat * share * share;
      of.friction += friction * springs_[k].along[j];
      if (j == 1 && scene_.race != nullptr) {
        Mat3 across = Mat3::Identity();  // to the contact normal, which is in the (x, r) plane
        across.topLeftCorner<2, 2>() = springs_[k].along[j];
        const Mat3 frame = azimuth_frame(e, i);
        on_race.friction += friction * (frame.transpose() * across * frame);
      }
    }
    pass_.damp(e, i, of.friction);
  }
  on_race.force = e.race[1].force;
  e.clear_actions();
  return on_race;
}

void QuasiStaticElements::form_rates(Evaluation& e) noexcept {
  const std::size_t n = e.elements.n, held = quasi_static_indices_.size();
  std::copy(e.elements.x_dot, e.elements.x_dot + n, x_dot_.begin());
  std::copy(e.elements.r_dot, e.elements.r_dot + n, r_dot_.begin());
  e.elements.x_dot = x_dot_.data();
  e.elements.r_dot = r_dot_.data();
  if (held == 0) return;

  contacts_->springs(e, quasi_static_indices_, {springs_.data(), held});
  for (std::size_t k = 0; k < held; ++k) {
    pass_.resist(e, quasi_static_indices_[k], springs_[k].stiffness);
    estimate(e, k);
    predict_rates(e, k);
  }
  if (scene_.race != nullptr) move_race(e);
  const RaceForces on_race = form_forces(e);
  if (!e.valid) return;
  for (std::size_t k = 0; k < held; ++k) pull(e, k);
  if (scene_.race == nullptr) return;
  scene_.race->resist(on_race.friction);
  const Vec3 pull = scene_.race->pull(on_race.force);
  follow_race(e, pull);
  e.race[1].velocity += pull;
}

/// The inertia that is left out would take m(ẍ, r̈ - rθ̇²) = F: what the equations of motion found
/// for ẍ, r̈ is G/m. Momentum is that of r θ̇ (and of ẋ where it stays
/// dynamic), p = m r θ̇ e_θ: ṗ = F - G - m ṙ θ̇ e_θ.
void QuasiStaticElements::remove_inertia(Evaluation& e) noexcept {
  account_ = {};
  for (const std::size_t i : quasi_static_indices_) {
    if (scene_.masses[i].has_eccentric_mass) {
      constrain_eccentric_element(e, i);
      continue;
    }
    const double m = scene_.masses[i].mass;
    double& ax = e.dydt[slices_.at(Quantity::XDot, i)];
    double& ar = e.dydt[slices_.at(Quantity::RDot, i)];
    const double td = e.elements.theta_dot[i], r = e.elements.r[i];
    residual_[i] = Vec2(scene_.axial ? m * ax : 0.0, m * ar);
    account_.power += residual_[i].dot(rate(i));
    const Vec3 force = e.to_base(i, residual_[i][0], residual_[i][1], m * r_dot_[i] * td);
    // Of the mass center, what it carries left out.
    const Vec3 velocity = e.to_base(i, left_out(i)[0], left_out(i)[1], 0.0);
    Vec3 carried = m * r * td * e_theta_at(e, i);
    if (!scene_.axial) carried[0] += m * x_dot_[i];
    account_.force += force;
    account_.moment += e.element_centre(i).cross(force) - velocity.cross(carried);
    if (scene_.axial) ax = 0.0;
    ar = 0.0;
    if (aligns(i)) align(e, i);
  }
}

void QuasiStaticElements::align(Evaluation& e, std::size_t i) noexcept {
  using enum Quantity;
  const auto rate = [&](Quantity q) -> double& { return e.dydt[slices_.at(q, i)]; };
  const Vec3 axis = aligned_axis(), free(rate(OmegaX), rate(OmegaR), rate(OmegaTheta));
  const double orbit = rate(ThetaDot);
  const Vec3 held = orbit * Vec3::UnitX() + (axis.dot(free) - orbit * axis[0]) * axis;
  const Mat3& to_base = e.attitude[i];
  const Vec3 moment = to_base * (scene_.masses[i].inertia *
                                 (to_base.transpose() * e.to_base(i, Vec3(held - free))));
  rate(OmegaX) = held[0];
  rate(OmegaR) = held[1];
  rate(OmegaTheta) = held[2];
  account_.power -= moment.dot(e.element_omega(i));
  account_.moment -= moment;
}

/// The reaction on the reference point changes the other rates, too: all are recomputed.
void QuasiStaticElements::constrain_eccentric_element(Evaluation& e, std::size_t i) noexcept {
  using enum Quantity;
  const ElementMass& body = scene_.masses[i];
  const ElementViews& b = e.elements;
  ElementConstraints hold = scene_.suppressed;
  hold.r = true;
  hold.x = hold.x || scene_.axial;
  const bool aligned = aligns(i);
  hold.tilt = hold.tilt || aligned;
  const ElementRates found = constrained_element(e, i, body, hold);
  const auto rate_of = [&](Quantity q) -> double& { return e.dydt[slices_.at(q, i)]; };
  rate_of(XDot) = found.x_ddot;
  rate_of(RDot) = 0.0;
  rate_of(ThetaDot) = found.theta_ddot;
  rate_of(OmegaX) = found.omega[0];
  rate_of(OmegaR) = found.omega[1];
  rate_of(OmegaTheta) = found.omega[2];
  residual_[i] = Vec2(scene_.axial ? -found.force[0] : 0.0, -found.force[1]);

  const Vec2 u = left_out(i);
  const double m = body.mass, td = b.theta_dot[i], turning = m * u[1] * td;
  const Vec3 arm = arm_of(e, i, body);
  const Vec3 swing = Vec3(b.omega_x[i], b.omega_r[i], b.omega_theta[i]).cross(arm);
  const Vec3 velocity(scene_.axial ? 0.0 : x_dot_[i], 0.0, b.r[i] * td);
  account_.power +=
      e.actions[0][i] * u[0] + e.actions[1][i] * u[1] + turning * (velocity[2] + swing[2]);
  const Vec3 around(0.0, 0.0, turning);
  const Vec3 force = e.to_base(i, residual_[i][0], residual_[i][1], turning);
  account_.force += force;
  if (aligned) {
    account_.power -= found.moment.dot(Vec3(b.omega_x[i], b.omega_r[i], b.omega_theta[i]));
    account_.moment -= e.to_base(i, found.moment);
  }
  account_.moment +=
      e.element_centre(i).cross(force) +
      e.to_base(i, Vec3(arm.cross(around) - Vec3(u[0], u[1], 0.0).cross(m * (velocity + swing))));
}

}  // namespace adore::dynamics
