#include "statics/ball_balance.hpp"

#include "statics/ball_friction.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace adore::statics {
namespace {

using bearing::Bearing;

constexpr int kMaxSteps = 100, kMaxStepCuts = 4;
constexpr double kSphereInertia = 0.4;  ///< J/(m r_b²)

/// The contacts of a ball at other places.
StaticBall moved_to(const BallInGrooves& seat, const StaticBall& ball, const Places& s) {
  StaticBall out = ball;
  for (std::size_t j = 0; j < 2; ++j) {
    const auto k = static_cast<Eigen::Index>(j);
    out.Q[j] = s[k];
    out.alpha[j] = s[k + 2];
    const contact::HertzConstants hertz = seat.hertz[j].at(out.alpha[j]);
    const double root = std::cbrt(out.Q[j]);
    out.a[j] = hertz.a_hat * root;
    out.b[j] = hertz.b_hat * root;
    if (seat.table[j]) {  // the groove as it is at the ball
      const contact::HertzConstants before = seat.hertz[j].at(ball.alpha[j]);
      const double root_before = std::cbrt(ball.Q[j]);
      out.a[j] *= ball.a[j] / (before.a_hat * root_before);
      out.b[j] *= ball.b[j] / (before.b_hat * root_before);
    }
    out.p_max[j] = 1.5 * out.Q[j] / (std::numbers::pi * out.a[j] * out.b[j]);
  }
  out.r = s[4];
  return out;
}

}  // namespace

Places contact_variables_of(const StaticBall& ball) {
  Places s;
  s << ball.Q[0], ball.Q[1], ball.alpha[0], ball.alpha[1], ball.r;
  return s;
}

BallBalance::BallBalance(const Bearing& bearing, const ContactLaws& laws,
                         const tribology::BearingDrag* drag, double frame, const StaticBall& ball)
    : bearing_(bearing), laws_(laws), drag_(drag), frame_(frame) {
  radius_ = 0.5 * bearing.balls().diameter;
  load_ = std::max(ball.Q[0], ball.Q[1]);
  spin_ = std::abs(ball.spin_speed);
  set_position(ball);
}

bool BallBalance::find(BallMotion& motion, const tribology::EllipseRule& rule, double balanced) {
  quadrature_rule_ = &rule;
  motion.balanced = false;
  if (!(spin_ > 0.0)) return false;
  Vec4 v = speeds(motion);
  Vec4 G = residual(v, motion);
  const double first = std::max(G.norm(), balanced);
  Mat4 slopes;
  bool known = false;
  for (int n = 0; n < kMaxSteps && G.norm() > balanced; ++n) {
    const double size = G.norm();
    if (!std::isfinite(size)) return false;
    BallMotion ignored;
    for (int k = 0; k < 4 && !known; ++k) {
      Vec4 w = v;
      w[k] += kSpeedDifference;
      slopes.col(k) = (residual(w, ignored) - G) / kSpeedDifference;
    }
    Mat4 J = slopes;
    constexpr double kFirstDamping = 1e-2;
    J.diagonal().array() -=
        kFirstDamping * J.diagonal().cwiseAbs().maxCoeff() * std::min(1.0, size / first);
    Vec4 d = J.partialPivLu().solve(-G);
    const double longest = d.cwiseAbs().maxCoeff();
    if (!std::isfinite(longest)) return false;
    if (longest > kMaxSpeedStep) d *= kMaxSpeedStep / longest;
    // Traction that saturates: shorter where the residual grows, and on in any case.
    Vec4 next = residual(v + d, motion);
    for (int cut = 0; cut < kMaxStepCuts && !(next.norm() < size); ++cut) {
      d *= 0.5;
      next = residual(v + d, motion);
    }
    constexpr double kKeepSlopesRatio = 0.1;  // slopes stay while the residual falls so
    known = next.norm() < kKeepSlopesRatio * size;
    // Rounding, or a speed on which nearly nothing depends, since its tractions saturate.
    constexpr double kNearRounding = 1e-8, kStalledRatio = 0.9;
    const bool at_end = size <= kNearRounding && !(next.norm() < kStalledRatio * size);
    if (at_end && !(next.norm() < size)) {
      (void)residual(v, motion);
      break;
    }
    v += d;
    G = next;
    if (at_end) break;
  }
  set_speeds(v, motion);
  motion.balanced = G.norm() <= kAcceptedResidual;
  return motion.balanced;
}

BallLinearization BallBalance::linearize(const BallInGrooves& seat, const StaticBall& ball,
                                         const BallMotion& motion) {
  BallLinearization out;
  const Vec4 v = speeds(motion);
  Eigen::Vector3d t[2];
  Vec4 G[2];
  for (int k = 0; k < 4; ++k) {
    for (const int side : {0, 1})
      G[side] = at(v + (side == 1 ? kSpeedDifference : -kSpeedDifference) * Vec4::Unit(k), t[side]);
    out.G_v.col(k) = (G[1] - G[0]) / (2.0 * kSpeedDifference);
    out.t_v.col(k) = (t[1] - t[0]) / (2.0 * kSpeedDifference);
  }
  if (has_second_contact(ball) || ball.share[0] < 1.0 || ball.share[1] < 1.0) return out;
  const Places s = contact_variables_of(ball);
  constexpr double kLoadDifference = 1e-5, kAngleDifference = 1e-6, kRadiusDifference = 1e-5;
  const Places step{kLoadDifference * s[0], kLoadDifference * s[1], kAngleDifference,
                    kAngleDifference, kRadiusDifference * radius_};
  for (int k = 0; k < 5; ++k) {
    for (const int side : {0, 1}) {
      set_position(moved_to(seat, ball, s + (side == 1 ? step[k] : -step[k]) * Places::Unit(k)));
      G[side] = at(v, t[side]);
    }
    out.G_s.col(k) = (G[1] - G[0]) / (2.0 * step[k]);
    out.t_s.col(k) = (t[1] - t[0]) / (2.0 * step[k]);
  }
  set_position(ball);
  return out;
}

Eigen::Matrix<double, 3, 5> BallBalance::slopes(const BallInGrooves& seat, const StaticBall& ball,
                                                const BallMotion& motion) {
  const BallLinearization by = linearize(seat, ball, motion);
  Eigen::Matrix<double, 3, 5> out = by.t_s - by.t_v * by.G_v.partialPivLu().solve(by.G_s);
  if (!out.allFinite()) out.setZero();
  return out;
}

double BallBalance::inertia() const {
  return bearing_.element_inertia.moments.x() * spin_ * spin_ / (load_ * radius_);
}

double BallBalance::friction_moment_at(double slip) const {
  double out = 0.0;
  for (std::size_t j = 0; j < 2; ++j) {
    tribology::EllipseKinematics sliding{};
    sliding.u_c = slip;
    sliding.entrainment = contact_[j].film.speed;
    out += contact_[j].share *
           std::abs(tribology::ellipse_traction(contact_[j].law, contact_[j].ellipse, sliding,
                                                *quadrature_rule_)
                        .F_c);
  }
  return out / load_;
}

void BallBalance::set_position(const StaticBall& ball) {
  r_ = ball.r;
  for (std::size_t j = 0; j < 2; ++j) {
    contact_[j] = ball_contact(bearing_, laws_, ball, j);
    second_[j].reset();
    normal_[j] = Eigen::Vector2d(contact_[j].n_x, contact_[j].n_r);
    if (!(ball.second[j].Q > 0.0)) continue;
    second_[j] = ball_contact(bearing_, laws_, ball_at_second_contacts(ball), j);
    normal_[j] = ball.Q[j] * normal_[j] +
                 ball.second[j].Q * Eigen::Vector2d(second_[j]->n_x, second_[j]->n_r);
    normal_[j].normalize();
  }
}

Vec4 BallBalance::speeds(const BallMotion& motion) const {
  return Vec4(motion.omega[0], motion.omega[1], motion.omega[2], motion.orbit) / spin_;
}

void BallBalance::set_speeds(const Vec4& v, BallMotion& motion) const {
  motion.omega = spin_ * v.head<3>();
  motion.orbit = spin_ * v[3];
}

Vec4 BallBalance::at(const Vec4& v, Eigen::Vector3d& result) const {
  BallMotion motion;
  const Vec4 G = residual(v, motion);
  result << motion.along[0], motion.along[1], spin_ * v[3];
  return G;
}

Vec4 BallBalance::residual(const Vec4& v, BallMotion& motion) const {
  BallMotion at;
  set_speeds(v, at);
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  double force = 0.0;
  const auto add = [&](std::size_t j, const BallContact& c) {
    const tribology::EllipseKinematics slip = contact_kinematics(bearing_, c, at, r_, j);
    const tribology::EllipseTraction on_ball =
        tribology::ellipse_traction(c.law, c.ellipse, slip, *quadrature_rule_);
    tribology::LubricatedContact film = c.film;
    film.speed = slip.entrainment;
    const double rolling = laws_.rolling_resistance_force(j, film);
    const double about_c = on_ball.M_c + radius_ * rolling;
    moment += c.share * Eigen::Vector3d(-about_c * c.n_r + on_ball.M_n * c.n_x,
                                        about_c * c.n_x + on_ball.M_n * c.n_r, on_ball.M_t);
    force += c.share * (on_ball.F_t + (2.0 * c.film.radius / radius_ - 1.0) * rolling);
    if (!second_[j]) {
      motion.along[j] = c.share * on_ball.F_c;
      return;
    }
    const Eigen::Vector2d along = c.share * on_ball.F_c * Eigen::Vector2d(-c.n_r, c.n_x);
    motion.along[j] += along.dot(Eigen::Vector2d(-normal_[j][1], normal_[j][0]));
    motion.into[j] += along.dot(normal_[j]);
  };
  motion.along = motion.into = {};
  for (std::size_t j = 0; j < 2; ++j) {
    add(j, contact_[j]);
    if (second_[j]) add(j, *second_[j]);
  }
  if (drag_ != nullptr) {
    const double V = (at.orbit - bearing_.speed[0]) * r_;
    force -= drag_->element_force_per_speed(std::abs(V)) * V;
    const Eigen::Vector3d turn = at.omega - bearing_.speed[0] * Eigen::Vector3d::UnitX();
    moment -= drag_->element_spin(turn.norm()) * turn;
  }
  const double gyroscopic = bearing_.element_inertia.moments.x() * (at.orbit + frame_);
  moment[1] += gyroscopic * at.omega[2];
  moment[2] -= gyroscopic * at.omega[1];
  cage_force_ = cage_orbital_speed_ ? -force : 0.0;
  Vec4 out;
  out << moment / (load_ * radius_), cage_orbital_speed_
                                         ? v[3] - *cage_orbital_speed_ / spin_
                                         : kSphereInertia * force / load_ * radius_ / r_;
  return out;
}

}  // namespace adore::statics
