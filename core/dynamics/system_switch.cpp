#include "dynamics/system_impl.hpp"

#include <algorithm>
#include <vector>

/// Light-load balance: which balls are held, changed between steps only.
namespace adore::dynamics {
namespace {

/// A ball that becomes held: where it was and where its balance is.
struct Candidate {
  std::size_t ball;
  double x, r, theta_dot;
  Vec2 residual;  ///< G at the old place [N]
};

}  // namespace

int System::held_count() const noexcept {
  return impl_->held ? static_cast<int>(impl_->held->list().size()) : 0;
}

bool System::update_held(double t, std::span<double> y) {
  Impl& s = *impl_;
  if (!s.held) return false;
  HeldBalls& held = *s.held;
  s.evaluate_for_report(t, y);
  const Evaluation& e = s.e;
  const double threshold = s.light_load_ratio * s.scales.force, mass = s.bearing.ball_inertia.mass;
  const auto at = [&y](const Slice& slice, std::size_t i) -> double& {
    return y[static_cast<std::size_t>(slice.first) + i];
  };
  const auto rate_of = [&s](const Slice& slice, std::size_t i) {
    return s.rates[static_cast<std::size_t>(slice.first) + i];
  };
  const auto load_of = [&e](std::size_t i) { return std::max(e.load[0][i], e.load[1][i]); };

  struct Release {
    std::size_t ball;
    Vec2 rate;
  };
  std::vector<Release> released;
  std::vector<Candidate> taken;
  std::vector<BallBalance> places;
  for (std::size_t i = 0; i < e.balls.n; ++i) {
    const bool was = held.is_held(i);
    if (held_next(was, load_of(i), threshold) == was) continue;
    if (was) {
      released.push_back({i, held.rate(i)});
      continue;
    }
    // All forces but the normal ones of the races stay as they are while the place is sought.
    const double centrifugal = mass * e.balls.r[i] * e.balls.theta_dot[i] * e.balls.theta_dot[i];
    const Vec2 residual = mass * Vec2(rate_of(s.ball.x_dot, i), rate_of(s.ball.r_dot, i));
    const Vec2 other = residual - Vec2(0.0, centrifugal) - held.normal_force(e, i);
    const BallBalance place = held.balanced(e, i, other);
    const double load = std::max(place.contact[0].load, place.contact[1].load);
    if (!place.solved || load > kReleaseRatio * threshold) continue;  // only passing through
    taken.push_back({i, e.balls.x[i], e.balls.r[i], e.balls.theta_dot[i], residual});
    places.push_back(place);
  }
  if (released.empty() && taken.empty()) return false;

  const double energy = s.stored_energy().total();
  const Momenta momenta = s.momenta();
  for (const Release& release : released) {
    held.set(release.ball, false);
    at(s.ball.x_dot, release.ball) = release.rate[0];
    at(s.ball.r_dot, release.ball) = release.rate[1];
  }
  for (std::size_t k = 0; k < taken.size(); ++k) {
    const std::size_t i = taken[k].ball;
    held.set(i, true);
    at(s.ball.x_dot, i) = at(s.ball.r_dot, i) = 0.0;
    at(s.ball.x, i) = places[k].x;
    at(s.ball.r, i) = places[k].r;
    at(s.ball.theta_dot, i) = places[k].speed;  // L is kept
  }
  // A pocket wall in the way can make the new place worse than the old one: then the ball stays and
  // its motion as a held ball brings it to balance.
  const bool valid = s.evaluate(t, y.data(), s.rates.data());
  for (const Candidate& c : taken) {
    if (valid && held.residual(c.ball).norm() <= c.residual.norm()) continue;
    at(s.ball.x, c.ball) = c.x;
    at(s.ball.r, c.ball) = c.r;
    at(s.ball.theta_dot, c.ball) = c.theta_dot;
  }
  s.evaluate_for_report(t, y);

  const QuadratureIndices& q = s.integrals;
  const auto integral = [&y](int index) -> double& { return y[static_cast<std::size_t>(index)]; };
  integral(q.held_switches) += s.stored_energy().total() - energy;
  const Momenta after = s.momenta();
  for (int k = 0; k < 3; ++k) {
    integral(q.held_impulse + k) -= after.linear[k] - momenta.linear[k];
    integral(q.held_angular_impulse + k) -= after.angular[k] - momenta.angular[k];
  }
  for (std::size_t i = 0; i < e.balls.n; ++i)
    integral(q.held_flags + static_cast<int>(i)) = held.is_held(i) ? 1.0 : 0.0;
  return true;
}

}  // namespace adore::dynamics
