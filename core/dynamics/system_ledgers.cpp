#include "dynamics/system_impl.hpp"

/// Conservation ledgers of a System: energy and momentum stored now, and their balance since the
/// start.
namespace adore::dynamics {
namespace {

double integral(std::span<const double> y, int index) {
  return index < 0 ? 0.0 : y[static_cast<std::size_t>(index)];
}

Vec3 integral3(std::span<const double> y, int first) {
  if (first < 0) return Vec3::Zero();
  return {integral(y, first), integral(y, first + 1), integral(y, first + 2)};
}

}  // namespace

/// The velocity comes from the state: ẋ and ṙ of held balls stand there as zero.
StoredEnergy System::Impl::stored_energy() const {
  StoredEnergy energy;
  const double m = bearing.ball_inertia.mass, I = bearing.ball_inertia.moments[0];
  const BallArrays& b = e.balls;
  const double *x_dot = e.y + ball.x_dot.first, *r_dot = e.y + ball.r_dot.first;
  for (std::size_t i = 0; i < b.n; ++i) {
    const Vec3 velocity = e.to_base(i, x_dot[i], r_dot[i], b.r[i] * b.theta_dot[i]);
    energy.kinetic += 0.5 * m * velocity.squaredNorm() + 0.5 * I * e.ball_omega(i).squaredNorm();
    energy.gravity -= m * bearing.gravity.dot(e.ball_centre(i));
  }
  if (has_cage()) {
    const bearing::Inertia& cage_inertia = bearing.cage->inertia;
    const Vec3& w = e.cage.omega_body;
    energy.kinetic += 0.5 * cage_inertia.mass * e.cage.velocity.squaredNorm() +
                      0.5 * w.dot(cage_inertia.moments.cwiseProduct(w));
    energy.gravity -= cage_inertia.mass * bearing.gravity.dot(e.cage.position);
  }
  if (!gravity) energy.gravity = 0.0;
  energy.elastic = e.elastic;
  return energy;
}

Momenta System::Impl::momenta() const {
  Momenta out;
  const auto add = [&out](const Vec3& linear, const Vec3& angular) {
    out.linear += linear;
    out.angular += angular;
    out.linear_size += linear.norm();
    out.angular_size += angular.norm();
  };
  const double m = bearing.ball_inertia.mass, I = bearing.ball_inertia.moments[0];
  const BallArrays& b = e.balls;
  const double *x_dot = e.y + ball.x_dot.first, *r_dot = e.y + ball.r_dot.first;
  for (std::size_t i = 0; i < b.n; ++i) {
    const Vec3 p = m * e.to_base(i, x_dot[i], r_dot[i], b.r[i] * b.theta_dot[i]);
    add(p, e.ball_centre(i).cross(p) + I * e.ball_omega(i));
  }
  if (has_cage()) {
    const bearing::Inertia& inertia = bearing.cage->inertia;
    const Vec3 p = inertia.mass * e.cage.velocity;
    add(p, e.cage.position.cross(p) +
               e.cage.to_base * inertia.moments.cwiseProduct(e.cage.omega_body));
  }
  return out;
}

void System::set_start(double t, std::span<const double> y) {
  Impl& s = *impl_;
  const QuadratureIndices& q = s.integrals;
  if (s.held)
    for (std::size_t i = 0; i < s.e.sin_theta.size(); ++i)
      s.held->set(i, integral(y, q.held_flags + static_cast<int>(i)) > 0.5);
  s.evaluate_for_report(t, y);
  s.stored_at_start = s.stored_energy().total() + integral(y, q.heat_pockets) +
                      integral(y, q.heat_lands) + integral(y, q.held_balance) -
                      integral(y, q.held_switches);
  for (std::size_t j = 0; j < 2; ++j)
    s.stored_at_start += integral(y, q.heat_race[j]) - integral(y, q.work_race[j]);
  s.momenta_at_start = s.momenta();
  s.momenta_at_start.linear += integral3(y, q.held_impulse) - integral3(y, q.impulse);
  s.momenta_at_start.angular +=
      integral3(y, q.held_angular_impulse) - integral3(y, q.angular_impulse);
}

EnergySnapshot System::Impl::energy_ledger(std::span<const double> y) const {
  const QuadratureIndices& q = integrals;
  const StoredEnergy stored = stored_energy();
  EnergySnapshot energy;
  energy.kinetic = stored.kinetic;
  energy.elastic = stored.elastic;
  energy.gravity = stored.gravity;
  energy.stored_at_start = stored_at_start;
  energy.heat_pockets = integral(y, q.heat_pockets);
  energy.heat_lands = integral(y, q.heat_lands);
  for (std::size_t j = 0; j < 2; ++j) {
    energy.work_race[j] = integral(y, q.work_race[j]);
    energy.heat_race[j] = integral(y, q.heat_race[j]);
  }
  if (!held) return energy;
  energy.light_load_balance = true;
  energy.switches = integral(y, q.held_switches);
  energy.balance = integral(y, q.held_balance);
  for (const std::size_t i : held->list())
    energy.left_out += 0.5 * bearing.ball_inertia.mass * held->rate(i).squaredNorm();
  return energy;
}

MomentumSnapshot System::Impl::momentum_ledger(std::span<const double> y) const {
  const QuadratureIndices& q = integrals;
  const Momenta now = momenta();
  MomentumSnapshot out;
  out.linear = now.linear;
  out.angular = now.angular;
  out.linear_size = now.linear_size;
  out.angular_size = now.angular_size;
  out.linear_start = momenta_at_start.linear;
  out.angular_start = momenta_at_start.angular;
  out.impulse = integral3(y, q.impulse);
  out.angular_impulse = integral3(y, q.angular_impulse);
  out.held = integral3(y, q.held_impulse);
  out.angular_held = integral3(y, q.held_angular_impulse);
  return out;
}

}  // namespace adore::dynamics
