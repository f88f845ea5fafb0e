#include "dynamics/system.hpp"

#include "base/errors.hpp"
#include "dynamics/rigid_body.hpp"
#include "dynamics/system_impl.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace adore::dynamics {

bool System::Impl::evaluate(double t, const double* y, double* dydt) noexcept {
  e.begin(t, y, dydt);
  for (const Block& b : blocks) {
    b.block->apply(e);
    if (!e.valid) return false;
  }
  return true;
}

bool System::Impl::evaluate_measured(double t, const double* y, double* dydt) noexcept {
  e.begin(t, y, dydt);
  for (const Block& b : blocks) {
    const auto start = CostLedger::Clock::now();
    b.block->apply(e);
    ledger.add_sampled(b.entry, CostLedger::Clock::now() - start);
    if (!e.valid) return false;
  }
  return true;
}

void System::Impl::evaluate_for_report(double t, std::span<const double> y) {
  demand(static_cast<int>(y.size()) == layout.size(), "a state of another system was given");
  if (!evaluate(t, y.data(), rates.data())) throw_invalid(t, y.data());
}

std::string System::Impl::what_is_invalid(const double* y) const {
  for (int i = 0; i < layout.controlled_size(); ++i)
    if (!std::isfinite(y[i]))
      return fmt::format(
          "the state is not finite ({} = {}); use a smaller tolerance or largest step",
          layout.component_name(i), y[i]);
  for (std::size_t i = 0; i < e.balls.n; ++i)
    if (!(y[ball.r.first + static_cast<int>(i)] > 0.0))
      return fmt::format(
          "element {} has reached the bearing axis; check speeds, loads and the largest step",
          i + 1);
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < e.balls.n; ++i)
      if (e.load[j][i] > contact::hertz_load(contacts[j].hertz.K, contacts[j].groove.ball_radius))
        return fmt::format(
            "element {} is pressed into the {} race by more than its own radius; use a "
            "smaller largest step",
            i + 1, j == 0 ? "outer" : "inner");
  if (pockets)
    for (std::size_t i = 0; i < pockets->size(); ++i)
      if (!pockets->inside(i)) {
        const Vec3 q = pockets->centre(i);
        return fmt::format(
            "the centre of element {} is outside its cage pocket (axial {:.4g} m, against the "
            "rotation {:.4g} m, radial {:.4g} m from the pocket centre); check the cage's start "
            "position, its pocket clearance and the largest step",
            i + 1, q[0], q[1], q[2]);
      }
  return "an acceleration is not finite; use a smaller tolerance or largest step";
}

void System::Impl::throw_invalid(double t, const double* y) const {
  throw SolverError(fmt::format("at t = {:.9g} s {}", t, what_is_invalid(y)));
}

System::System(const bearing::Bearing& bearing, const ScenePlan& plan,
               const statics::StaticSolution& statics, const std::array<double, 2>& fixed_angle,
               const SystemOptions& options)
    : impl_(std::make_unique<Impl>(bearing, plan, statics, fixed_angle, options)) {}
System::~System() = default;
System::System(System&&) noexcept = default;

const StateLayout& System::layout() const noexcept { return impl_->layout; }
const Scales& System::scales() const noexcept { return impl_->scales; }
CostLedger& System::cost() noexcept { return impl_->ledger; }
const bearing::Bearing& System::bearing() const noexcept { return impl_->bearing; }

void System::set_scales(const Scales& scales) {
  demand(scales.length > 0.0 && scales.force > 0.0 && scales.time > 0.0, "scales must be positive");
  impl_->scales = scales;
  impl_->apply_scales();
}

std::vector<double> System::initial_state() const {
  const Impl& s = *impl_;
  std::vector<double> y(static_cast<std::size_t>(s.layout.size()), 0.0);
  const auto at = [&y](const Slice& slice, std::size_t i) -> double& {
    return y[static_cast<std::size_t>(slice.first) + i];
  };
  double mean_x = 0.0;
  for (std::size_t i = 0; i < s.statics.balls.size(); ++i) {
    const statics::StaticBall& ball = s.statics.balls[i];
    at(s.ball.x, i) = ball.x;
    at(s.ball.r, i) = ball.r;
    at(s.ball.theta, i) = ball.azimuth;
    at(s.ball.theta_dot, i) = ball.orbital_speed;
    at(s.ball.omega_x, i) = ball.omega_x;
    at(s.ball.omega_r, i) = ball.omega_r;
    at(s.ball.omega_theta, i) = ball.omega_theta;
    mean_x += ball.x / static_cast<double>(s.statics.balls.size());
  }
  for (const OrientedElement& oriented : s.oriented) {  // body axes start along the azimuth frame
    const Quat q = quaternion_about(Vec3::UnitX(), s.statics.balls[oriented.element].azimuth);
    for (std::size_t k = 0; k < 4; ++k) at(oriented.orientation, k) = q[k];
  }
  if (!s.has_cage()) return y;

  const bearing::Cage& cage = *s.bearing.cage;
  const CageStart start =
      cage_start(nominal_cage_speed(s.bearing), cage.speed_ratio, cage.whirl_ratio,
                 {mean_x, 0.0, 0.0}, cage.start_offset, cage.start_angles);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    at(s.cage.position, k) = start.mass_centre[axis];
    at(s.cage.velocity, k) = start.mass_centre_velocity[axis];
    at(s.cage.omega, k) = start.omega_body[axis];
  }
  for (std::size_t k = 0; k < 4; ++k) at(s.cage.orientation, k) = start.orientation[k];
  return y;
}

RhsStatus System::rhs(double t, const double* y, double* dydt) noexcept {
  Impl& s = *impl_;
  const bool valid = s.ledger.sample() ? s.evaluate_measured(t, y, dydt) : s.evaluate(t, y, dydt);
  return valid ? RhsStatus::Ok : RhsStatus::Retry;
}

bool System::project(double, double* y) const noexcept {
  bool changed = false;
  const auto renormalise = [&](const Slice& slice) {
    double* q = y + slice.first;
    const Quat unit = normalise({q[0], q[1], q[2], q[3]});
    for (std::size_t k = 0; k < 4; ++k) {
      changed = changed || q[k] != unit[k];
      q[k] = unit[k];
    }
  };
  if (impl_->has_cage()) renormalise(impl_->cage.orientation);
  for (const OrientedElement& element : impl_->oriented) renormalise(element.orientation);
  return changed;
}

void System::check_state(double t, const double* y) const {
  Impl& s = *impl_;
  if (!s.evaluate(t, y, s.rates.data())) s.throw_invalid(t, y);
}

}  // namespace adore::dynamics
