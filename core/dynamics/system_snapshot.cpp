#include "base/errors.hpp"
#include "dynamics/system_impl.hpp"

#include <algorithm>
#include <cmath>

namespace adore::dynamics {
namespace {

Quat quaternion_of(std::span<const double> y, const Slice& slice) {
  const auto first = static_cast<std::size_t>(slice.first);
  return {y[first], y[first + 1], y[first + 2], y[first + 3]};
}

double component(std::span<const double> y, const Slice& slice, std::size_t k = 0) {
  return y[static_cast<std::size_t>(slice.first) + k];
}

Vec3 vector_of(std::span<const double> y, const Slice& slice) {
  return {component(y, slice, 0), component(y, slice, 1), component(y, slice, 2)};
}

}  // namespace

Snapshot System::snapshot(double t, std::span<const double> y) {
  Impl& s = *impl_;
  s.evaluate_for_report(t, y);
  const Evaluation& e = s.e;
  const std::vector<double>& dydt = s.rates;
  const std::size_t n = e.balls.n;

  Snapshot result;
  result.time = t;
  result.shaft_rotation = (s.bearing.speed[1] - s.bearing.speed[0]) * t;
  result.elements.resize(n);
  double mean_x = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    ElementSnapshot& ball = result.elements[i];
    ball.x = e.balls.x[i];
    ball.r = e.balls.r[i];
    ball.theta = component(y, s.ball.theta, i);
    ball.vx = component(y, s.ball.x_dot, i);
    ball.vr = component(y, s.ball.r_dot, i);
    ball.held = s.held && s.held->is_held(i);
    ball.theta_dot = e.balls.theta_dot[i];
    ball.ax = component(dydt, s.ball.x_dot, i);
    ball.ar = component(dydt, s.ball.r_dot, i);
    ball.theta_ddot = component(dydt, s.ball.theta_dot, i);
    ball.omega = Vec3(e.balls.omega_x[i], -e.balls.omega_theta[i], e.balls.omega_r[i]);
    mean_x += ball.x / static_cast<double>(n);
    if (s.has_race_contact)
      for (std::size_t j = 0; j < 2; ++j) {
        RaceContactSnapshot& contact = ball.race[j];
        contact = race_contact_detail(s.contacts[j], e.balls, i, e.race[j].motion);
        contact.contact_temperature = s.bearing.race_temperature[j] + contact.temperature_rise;
      }
    if (s.pockets) {
      ball.pocket = {s.pockets->report(i)};
      ball.pocket_to_centre = s.pockets->centre(i);
    }
  }
  for (const OrientedElement& oriented : s.oriented) {
    ElementSnapshot& ball = result.elements[oriented.element];
    ball.oriented = true;
    ball.orientation = quaternion_of(y, oriented.orientation);
    ball.total_rotation = component(y, oriented.rotation);
    const Vec3 axis =
        e.to_cylindrical(oriented.element, rotation_matrix(normalise(ball.orientation)).col(0));
    ball.x_axis = Vec3(axis[0], -axis[2], axis[1]);
    result.max_quaternion_error =
        std::max(result.max_quaternion_error, std::abs(norm(ball.orientation) - 1.0));
  }

  if (s.has_cage()) {
    CageSnapshot cage;
    cage.position = e.cage.position - Vec3(mean_x, 0.0, 0.0);
    cage.velocity = e.cage.velocity;
    cage.acceleration = vector_of(dydt, s.cage.velocity);
    cage.orientation = quaternion_of(y, s.cage.orientation);
    cage.omega = e.cage.omega;
    cage.total_rotation = component(y, s.cage.rotation);
    for (const LandModel& land : s.lands) cage.lands.push_back(report(land, e));
    result.max_quaternion_error =
        std::max(result.max_quaternion_error, std::abs(norm(cage.orientation) - 1.0));
    result.cages.push_back(std::move(cage));
  }

  for (std::size_t j = 0; j < 2; ++j) {
    const RaceState& state = e.race[j];
    RaceSnapshot& race = result.races[j];
    race.position = state.motion.centre - s.free_centre[j];
    race.velocity = state.motion.velocity;
    race.total_rotation = state.motion.speed * t;
    race.orientation =
        multiply(s.race_attitude[j], quaternion_about(Vec3::UnitX(), race.total_rotation));
    race.omega = state.motion.speed * state.motion.axis;
    race.applied_force = -state.force;
    race.applied_moment = -state.moment;
  }

  const auto integral = [&y](int index) {
    return index < 0 ? 0.0 : y[static_cast<std::size_t>(index)];
  };
  const QuadratureIndices& q = s.integrals;
  result.energy = s.energy_ledger(y);
  if (q.impulse >= 0) result.momentum = s.momentum_ledger(y);
  PowerSnapshot& power = result.power;
  power.pockets = e.heat_pockets;
  power.lands = e.heat_lands;
  power.total_loss = e.heat_pockets + e.heat_lands;
  power.qv_cage = integral(q.wear_cage);
  for (std::size_t j = 0; j < 2; ++j) {
    power.race_contacts[j] = e.heat_race[j];
    power.total_loss += e.heat_race[j];
    power.qv_race[j] = integral(q.wear_race[j]);
    power.qv_element1[j] = integral(q.wear_element1[j]);
  }
  return result;
}

double System::quadrature_error(double t, std::span<const double> y) {
  Impl& s = *impl_;
  s.evaluate_for_report(t, y);
  double largest = 0.0;
  if (!s.has_race_contact) return largest;
  for (std::size_t j = 0; j < 2; ++j) {
    const RaceContactModel& model = s.contacts[j];
    if (!model.traction) continue;
    for (std::size_t i = 0; i < s.e.balls.n; ++i) {
      const RaceContactState contact = race_contact_state(model, s.e.balls, i, s.e.race[j].motion);
      if (!(contact.ellipse.Q > 0.0)) continue;
      const auto fixed =
          tribology::ellipse_traction(model.curve, contact.ellipse, contact.motion, model.rule);
      const auto exact =
          tribology::ellipse_traction_converged(model.curve, contact.ellipse, contact.motion);
      if (!(exact.heat > 0.0)) continue;
      const double friction = exact.heat * contact.ellipse.Q / exact.load_slip;
      largest =
          std::max(largest, std::hypot(fixed.F_c - exact.F_c, fixed.F_t - exact.F_t) / friction);
    }
  }
  return largest;
}

}  // namespace adore::dynamics
