#include "statics/spin_lag.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace adore::statics {
namespace {

using Index = Eigen::Index;

constexpr int kMaxLagSteps = 100, kMaxLagStepCuts = 4;

/// Largest residual of a ball.
double largest(const Eigen::VectorXd& R) {
  double out = 0.0;
  for (Index k = 0; k < R.size() / 4; ++k) out = std::max(out, R.segment<4>(4 * k).norm());
  return out;
}

}  // namespace

SpinLag::SpinLag(std::vector<Ball> balls, double orbit) : balls_(std::move(balls)) {
  const auto n = static_cast<Index>(balls_.size());
  const Index back = orbit < 0.0 ? 1 : -1;
  const double turn = 2.0 * std::numbers::pi;
  for (const Ball& ball : balls_) unit_ = std::max(unit_, ball.at->spin());
  for (Index k = 0; k < n; ++k) {
    Stencil& at = stencils_.emplace_back();
    std::array<double, 2> h{};  // azimuth of this ball minus those before, by their direction
    double way = 0.0;
    at.ball[0] = k;
    for (std::size_t i = 0; i < 2; ++i) {
      const Index from = at.ball[i];
      at.ball[i + 1] = (from + back + n) % n;
      const double step = balls_[static_cast<std::size_t>(from)].azimuth -
                          balls_[static_cast<std::size_t>(at.ball[i + 1])].azimuth;
      way += back < 0 ? std::fmod(step + 2.0 * turn, turn) : -std::fmod(2.0 * turn - step, turn);
      h[i] = way;
    }
    at.weight = {1.0 / h[0] + 1.0 / h[1], -h[1] / (h[0] * (h[1] - h[0])),
                 h[0] / (h[1] * (h[1] - h[0]))};
  }
}

Vec4 SpinLag::speeds_of(const Ball& ball, const BallMotion& motion) const {
  return ball.at->speeds(motion) * (ball.at->spin() / unit_);
}

Vec4 SpinLag::derivative(Index k, const Eigen::VectorXd& U) const {
  const Stencil& at = stencils_[static_cast<std::size_t>(k)];
  Vec4 out = Vec4::Zero();
  for (std::size_t i = 0; i < 3; ++i) out += at.weight[i] * U.segment<4>(4 * at.ball[i]);
  if (balls_[static_cast<std::size_t>(k)].at->has_cage_orbital_speed()) out[3] = 0.0;
  return out;
}

double SpinLag::inertia(Index k) const {
  const BallBalance& at = *balls_[static_cast<std::size_t>(k)].at;
  const double of_spin = unit_ / at.spin();
  return at.inertia() * of_spin * of_spin;
}

Eigen::VectorXd SpinLag::residual(const Eigen::VectorXd& U, double share,
                                  std::vector<BallMotion>& motions) const {
  Eigen::VectorXd out(U.size());
  for (std::size_t i = 0; i < balls_.size(); ++i) {
    const auto k = static_cast<Index>(i);
    const Vec4 u = U.segment<4>(4 * k);
    const BallBalance& at = *balls_[i].at;
    out.segment<4>(4 * k) = at.residual(u * (unit_ / at.spin()), motions[balls_[i].number]) -
                            share * inertia(k) * u[3] * derivative(k, U);
  }
  return out;
}

void SpinLag::add_inertia(const Eigen::VectorXd& U, double share, Eigen::MatrixXd& J) const {
  for (std::size_t i = 0; i < balls_.size(); ++i) {
    const auto k = static_cast<Index>(i);
    const Index rows = balls_[i].at->has_cage_orbital_speed() ? 3 : 4;
    const double m = share * inertia(k), orbit = U[4 * k + 3];
    J.block(4 * k, 4 * k + 3, rows, 1) -= m * derivative(k, U).head(rows);
    for (std::size_t s = 0; s < 3; ++s)
      for (Index c = 0; c < rows; ++c)
        J(4 * k + c, 4 * stencils_[i].ball[s] + c) -= m * orbit * stencils_[i].weight[s];
  }
}

bool SpinLag::search(Eigen::VectorXd& U, double share, double balanced,
                     std::vector<BallMotion>& motions) const {
  const auto n = static_cast<Index>(balls_.size());
  Eigen::VectorXd R = residual(U, share, motions);
  const double first = std::max(largest(R), balanced);
  Eigen::MatrixXd slopes = Eigen::MatrixXd::Zero(4 * n, 4 * n);
  bool known = false;
  for (int step = 0; step < kMaxLagSteps && largest(R) > balanced; ++step) {
    const double size = R.norm();
    if (!std::isfinite(size)) return false;
    for (Index k = 0; k < n && !known; ++k) {
      const BallBalance& at = *balls_[static_cast<std::size_t>(k)].at;
      const double unit = unit_ / at.spin();
      const Vec4 v = U.segment<4>(4 * k) * unit;
      BallMotion ignored;
      const Vec4 G = at.residual(v, ignored);
      for (int c = 0; c < 4; ++c)
        slopes.block<4, 1>(4 * k, 4 * k + c) =
            (at.residual(v + kSpeedDifference * Vec4::Unit(c), ignored) - G) *
            (unit / kSpeedDifference);
    }
    Eigen::MatrixXd J = slopes;
    constexpr double kFirstDamping = 1e-2;
    for (Index k = 0; k < n; ++k) {
      const double scale = J.block<4, 4>(4 * k, 4 * k).diagonal().cwiseAbs().maxCoeff();
      J.diagonal().segment<4>(4 * k).array() -=
          kFirstDamping * scale * std::min(1.0, largest(R) / first);
    }
    add_inertia(U, share, J);
    Eigen::VectorXd d = J.partialPivLu().solve(-R);
    const double longest = d.cwiseAbs().maxCoeff();
    if (!std::isfinite(longest)) return false;
    if (longest > kMaxSpeedStep) d *= kMaxSpeedStep / longest;
    Eigen::VectorXd next = residual(U + d, share, motions);
    for (int cut = 0; cut < kMaxLagStepCuts && !(next.norm() < size); ++cut) {
      d *= 0.5;
      next = residual(U + d, share, motions);
    }
    constexpr double kKeepSlopesRatio = 0.1, kNearRounding = 1e-8, kStalledRatio = 0.9;
    known = next.norm() < kKeepSlopesRatio * size;
    const bool at_end = size <= kNearRounding && !(next.norm() < kStalledRatio * size);
    if (at_end && !(next.norm() < size)) {
      (void)residual(U, share, motions);
      break;
    }
    U += d;
    R = next;
    if (at_end) break;
  }
  return largest(R) <= std::max(balanced, kAcceptedResidual);
}

bool SpinLag::find(std::vector<BallMotion>& motions, const tribology::EllipseRule& few,
                   const tribology::EllipseRule& rule) const {
  const auto n = static_cast<Index>(balls_.size());
  Eigen::VectorXd U(4 * n);
  for (Index k = 0; k < n; ++k) {
    const Ball& ball = balls_[static_cast<std::size_t>(k)];
    U.segment<4>(4 * k) = speeds_of(ball, motions[ball.number]);
  }
  std::vector<BallMotion> now = motions;
  const auto use = [&](const tribology::EllipseRule& which) {
    for (const Ball& ball : balls_) ball.at->use(which);
  };
  const auto finish = [&] {
    use(rule);
    if (!search(U, 1.0, kBalanceTolerance, now)) return false;
    for (Index k = 0; k < n; ++k) {
      const Ball& ball = balls_[static_cast<std::size_t>(k)];
      BallMotion& motion = now[ball.number];
      ball.at->set_speeds(U.segment<4>(4 * k) * (unit_ / ball.at->spin()), motion);
      motion.balanced = true;
    }
    motions = std::move(now);
    return true;
  };
  const Eigen::VectorXd start = U;
  use(few);
  if (search(U, 1.0, kFewNodesTolerance, now) && finish()) return true;
  U = start;
  use(few);
  // Steps of the share that shrink where they fail.
  constexpr double kFirstInertiaStep = 0.25, kMinInertiaStep = 1e-3;
  double share = 0.0, step = kFirstInertiaStep;
  while (share < 1.0) {
    Eigen::VectorXd trial = U;
    const double next = std::min(1.0, share + step);
    if (search(trial, next, kFewNodesTolerance, now)) {
      U = trial;
      share = next;
      step *= 2.0;
    } else if ((step *= 0.5) < kMinInertiaStep) {
      return false;
    }
  }
  return finish();
}

Eigen::MatrixXd SpinLag::slopes(const std::vector<BallLinearization>& of_balls,
                                const std::vector<BallMotion>& motions, std::size_t count) const {
  const auto n = static_cast<Index>(balls_.size()), all = static_cast<Index>(count);
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(4 * n, 4 * n),
                  R_s = Eigen::MatrixXd::Zero(4 * n, 5 * n);
  Eigen::VectorXd U(4 * n);
  for (Index k = 0; k < n; ++k) {
    const Ball& ball = balls_[static_cast<std::size_t>(k)];
    const BallLinearization& by = of_balls[ball.number];
    U.segment<4>(4 * k) = speeds_of(ball, motions[ball.number]);
    J.block<4, 4>(4 * k, 4 * k) = by.G_v * (unit_ / ball.at->spin());
    R_s.block<4, 5>(4 * k, 5 * k) = by.G_s;
  }
  add_inertia(U, 1.0, J);
  const Eigen::MatrixXd dU = -J.partialPivLu().solve(R_s);
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(3 * all, 5 * all);
  for (Index k = 0; k < n; ++k) {
    const Ball& ball = balls_[static_cast<std::size_t>(k)];
    const BallLinearization& by = of_balls[ball.number];
    const auto row = static_cast<Index>(ball.number);
    for (Index l = 0; l < n; ++l) {
      const auto column = static_cast<Index>(balls_[static_cast<std::size_t>(l)].number);
      out.block<3, 5>(3 * row, 5 * column) =
          by.t_v * (unit_ / ball.at->spin()) * dU.block<4, 5>(4 * k, 5 * l);
    }
    out.block<3, 5>(3 * row, 5 * row) += by.t_s;
  }
  if (!out.allFinite()) out.setZero();
  return out;
}

std::vector<double> SpinLag::spin_moment_ratio(const std::vector<BallMotion>& motions,
                                               double radius, std::size_t count) const {
  const auto n = static_cast<Index>(balls_.size());
  std::vector<double> out(count, 0.0);
  Eigen::VectorXd U(4 * n);
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (Index k = 0; k < n; ++k) {
    const Ball& ball = balls_[static_cast<std::size_t>(k)];
    U.segment<4>(4 * k) = speeds_of(ball, motions[ball.number]);
    mean += U.segment<3>(4 * k) / static_cast<double>(n);
  }
  double variation = 0.0;
  for (Index k = 0; k < n; ++k)
    variation = std::max(variation, (U.segment<3>(4 * k) - mean).norm());
  for (Index k = 0; k < n; ++k) {
    const Ball& ball = balls_[static_cast<std::size_t>(k)];
    const double moment = inertia(k) * std::abs(U[4 * k + 3]) * derivative(k, U).head<3>().norm();
    const double available = ball.at->friction_moment_at(variation * unit_ * radius);
    if (available > 0.0) out[ball.number] = moment / available;
  }
  return out;
}

}  // namespace adore::statics
