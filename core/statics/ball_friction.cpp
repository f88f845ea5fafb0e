#include "statics/ball_friction.hpp"

#include "base/errors.hpp"
#include "statics/ball_race.hpp"
#include "statics/ball_report.hpp"
#include "statics/race_text.hpp"
#include "statics/stiffness_difference.hpp"
#include "tribology/bearing_drag.hpp"
#include "tribology/traction_curve.hpp"

#include <Eigen/LU>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

namespace adore::statics {
namespace {

using bearing::Bearing;
using Vec4 = Eigen::Vector4d;
using Mat4 = Eigen::Matrix4d;

constexpr int kSteps = 100, kCuts = 4, kPasses = 30;
constexpr int kSearches = 2;  ///< without an equilibrium, of one ball; from then on the spin rule
/// Residual over the larger contact load: where steps end (with few nodes kNear), and what is taken
/// when they are used up.
constexpr double kBalanced = 1e-11, kNear = 1e-5, kAccepted = 1e-5;
/// Tractions minus those of the equilibrium over the largest contact load: likewise.
constexpr double kSteady = 1e-10, kSteadyAccepted = 1e-5;
constexpr double kLongestStep = 0.03;  ///< over the spin
constexpr double kDifference = 1e-7;   ///< likewise

bool is_loaded(const StaticBall& ball) { return ball.Q[0] > 0.0 && ball.Q[1] > 0.0; }

/// Places of a ball's contacts on which its tractions depend: those of GivenTractions.
using Places = Eigen::Matrix<double, static_cast<int>(GivenTractions::kPlaces), 1>;

Places places_of(const StaticBall& ball) {
  Places s;
  s << ball.Q[0], ball.Q[1], ball.alpha[0], ball.alpha[1], ball.r;
  return s;
}

/// The contacts of a ball at other places.
StaticBall moved_to(const BallSeat& seat, const StaticBall& ball, const Places& s) {
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

/// Tractions along both ellipses [N] and the orbit over the spin.
using Result = Eigen::Vector3d;

/// One ball at its place.
class Ball {
 public:
  Ball(const Bearing& bearing, const ContactLaws& laws, const tribology::BearingDrag* drag,
       double frame, const StaticBall& ball)
      : bearing_(bearing), laws_(laws), drag_(drag), frame_(frame) {
    radius_ = 0.5 * bearing.balls().diameter;
    load_ = std::max(ball.Q[0], ball.Q[1]);
    spin_ = std::abs(ball.spin_speed);
    stand(ball);
  }

  /// The cage has it orbit at this speed [rad/s].
  void carry(double orbit) { carried_ = orbit; }
  /// Of the cage along the orbit, at the last evaluation [N].
  [[nodiscard]] double push() const { return push_; }

  /// From the given motion; false: no balance was found, and the motion is of no use.
  /// @param rule kept for slopes(), as a reference
  bool find(BallMotion& motion, const tribology::EllipseRule& rule, double balanced) {
    rule_ = &rule;
    motion.balanced = false;
    if (!(spin_ > 0.0)) return false;
    Vec4 v = speeds(motion);
    Vec4 G = residual(v, motion);
    const double first = std::max(G.norm(), balanced);
    Mat4 slopes;
    bool known = false;
    for (int n = 0; n < kSteps && G.norm() > balanced; ++n) {
      const double size = G.norm();
      if (!std::isfinite(size)) return false;
      BallMotion ignored;
      for (int k = 0; k < 4 && !known; ++k) {
        Vec4 w = v;
        w[k] += kDifference;
        slopes.col(k) = (residual(w, ignored) - G) / kDifference;
      }
      Mat4 J = slopes;
      constexpr double kFirstDamping = 1e-2;
      J.diagonal().array() -=
          kFirstDamping * J.diagonal().cwiseAbs().maxCoeff() * std::min(1.0, size / first);
      Vec4 d = J.partialPivLu().solve(-G);
      const double longest = d.cwiseAbs().maxCoeff();
      if (!std::isfinite(longest)) return false;
      if (longest > kLongestStep) d *= kLongestStep / longest;
      // Traction that saturates: shorter where the residual grows, and on in any case.
      Vec4 next = residual(v + d, motion);
      for (int cut = 0; cut < kCuts && !(next.norm() < size); ++cut) {
        d *= 0.5;
        next = residual(v + d, motion);
      }
      constexpr double kFast = 0.1;  // slopes stay while the residual falls so
      known = next.norm() < kFast * size;
      // Rounding, or a speed on which nearly nothing depends, since its tractions saturate.
      constexpr double kSmall = 1e-8, kSlow = 0.9;
      const bool at_end = size <= kSmall && !(next.norm() < kSlow * size);
      if (at_end && !(next.norm() < size)) {
        (void)residual(v, motion);
        break;
      }
      v += d;
      G = next;
      if (at_end) break;
    }
    motion.omega = spin_ * v.head<3>();
    motion.orbit = spin_ * v[3];
    motion.balanced = G.norm() <= kAccepted;
    return motion.balanced;
  }

  /// Of a balance G(v, s) = 0 that stays balanced while the contacts move: dv/ds = -G_v⁻¹ G_s.
  /// 0 of a ball with two contacts at a race.
  [[nodiscard]] Eigen::Matrix<double, 3, 5> slopes(const BallSeat& seat, const StaticBall& ball,
                                                   const BallMotion& motion) {
    if (has_second(ball) || ball.share[0] < 1.0 || ball.share[1] < 1.0)
      return Eigen::Matrix<double, 3, 5>::Zero();
    const Vec4 v = speeds(motion);
    Mat4 G_v;
    Eigen::Matrix<double, 3, 4> t_v;
    Result t[2];
    for (int k = 0; k < 4; ++k) {
      Vec4 G[2];
      for (const int side : {0, 1})
        G[side] = at(v + (side == 1 ? kDifference : -kDifference) * Vec4::Unit(k), t[side]);
      G_v.col(k) = (G[1] - G[0]) / (2.0 * kDifference);
      t_v.col(k) = (t[1] - t[0]) / (2.0 * kDifference);
    }
    const Eigen::PartialPivLU<Mat4> lu(G_v);
    const Places s = places_of(ball);
    constexpr double kOfLoad = 1e-5, kOfAngle = 1e-6, kOfRadius = 1e-5;
    const Places step{kOfLoad * s[0], kOfLoad * s[1], kOfAngle, kOfAngle, kOfRadius * radius_};
    Eigen::Matrix<double, 3, 5> out;
    for (int k = 0; k < 5; ++k) {
      Vec4 G[2];
      for (const int side : {0, 1}) {
        stand(moved_to(seat, ball, s + (side == 1 ? step[k] : -step[k]) * Places::Unit(k)));
        G[side] = at(v, t[side]);
      }
      out.col(k) = (t[1] - t[0] - t_v * lu.solve(G[1] - G[0])) / (2.0 * step[k]);
    }
    stand(ball);
    out.row(2) *= spin_;
    if (!out.allFinite()) out.setZero();
    return out;
  }

 private:
  void stand(const StaticBall& ball) {
    r_ = ball.r;
    for (std::size_t j = 0; j < 2; ++j) {
      contact_[j] = ball_contact(bearing_, laws_, ball, j);
      second_[j].reset();
      normal_[j] = Eigen::Vector2d(contact_[j].n_x, contact_[j].n_r);
      if (!(ball.second[j].Q > 0.0)) continue;
      second_[j] = ball_contact(bearing_, laws_, on_other_halves(ball), j);
      normal_[j] = ball.Q[j] * normal_[j] +
                   ball.second[j].Q * Eigen::Vector2d(second_[j]->n_x, second_[j]->n_r);
      normal_[j].normalize();
    }
  }
  [[nodiscard]] Vec4 speeds(const BallMotion& motion) const {
    return Vec4(motion.omega[0], motion.omega[1], motion.omega[2], motion.orbit) / spin_;
  }
  Vec4 at(const Vec4& v, Result& result) const {
    BallMotion motion;
    const Vec4 G = residual(v, motion);
    result << motion.along[0], motion.along[1], v[3];
    return G;
  }

  /// M_x, M_r, M_θ over load and radius; F_θ over the load, as what it does to the orbit.
  Vec4 residual(const Vec4& v, BallMotion& motion) const {
    BallMotion at;
    at.omega = spin_ * v.head<3>();
    at.orbit = spin_ * v[3];
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();
    double force = 0.0;
    const auto add = [&](std::size_t j, const BallContact& c) {
      const tribology::EllipseKinematics slip = contact_motion(bearing_, c, at, r_, j);
      const tribology::EllipseTraction on_ball =
          tribology::ellipse_traction(c.law, c.ellipse, slip, *rule_);
      tribology::FilmContact film = c.film;
      film.speed = slip.entrainment;
      const double rolling = laws_.rolling_force(j, film);
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
      force -= drag_->element_force(std::abs(V)) * V;
      const Eigen::Vector3d turn = at.omega - bearing_.speed[0] * Eigen::Vector3d::UnitX();
      moment -= drag_->element_spin(turn.norm()) * turn;
    }
    const double gyroscopic = bearing_.element_inertia.moments.x() * (at.orbit + frame_);
    moment[1] += gyroscopic * at.omega[2];
    moment[2] -= gyroscopic * at.omega[1];
    constexpr double kSphere = 0.4;  // J/(m r_b²)
    push_ = carried_ ? -force : 0.0;
    Vec4 out;
    out << moment / (load_ * radius_),
        carried_ ? v[3] - *carried_ / spin_ : kSphere * force / load_ * radius_ / r_;
    return out;
  }

  const Bearing& bearing_;
  const ContactLaws& laws_;
  const tribology::EllipseRule* rule_ = nullptr;
  const tribology::BearingDrag* drag_;
  double frame_, r_ = 0.0, radius_ = 0.0, load_ = 0.0, spin_ = 0.0;
  std::optional<double> carried_;
  mutable double push_ = 0.0;
  std::array<BallContact, 2> contact_;
  std::array<std::optional<BallContact>, 2> second_;  ///< with the other half of a split race
  std::array<Eigen::Vector2d, 2> normal_;             ///< of their resultant on (e_x, e_r)
};

/// Balls of a solution with their tractions, and the race on them.
class Balls {
 public:
  Balls(const Bearing& bearing, const StaticsOptions& options, const StaticSolution& solution)
      : task_(race_task(bearing.constraints)), model_(make_ball_model(bearing, options)) {
    state_.q = Eigen::Map<const Vec5>(solution.displacement.data());
    for (std::size_t k = 0; k < solution.balls.size(); ++k) {
      const StaticBall& from = solution.balls[k];
      BallState ball;
      ball.site.sin = std::sin(from.azimuth);
      ball.site.cos = std::cos(from.azimuth);
      ball.site.own = model_.own_number.empty() ? 0 : model_.own_number[k];
      ball.site.law = first_spin_law(bearing, options);
      ball.site.axis_shift = from.axis_shift;
      if (from.inner_race_control)
        ball.site.law = {SpinLaw::Axis::InnerControl, SpinLaw::Share::Equal};
      ball.x = from.x;
      ball.rho = from.r - 0.5 * model_.balls.pitch_diameter;
      ball.known = true;
      state_.elements.push_back(ball);
    }
  }
  [[nodiscard]] const BallSeat& seat(std::size_t k) const {
    return model_.seat(state_.elements[k].site.own);
  }
  /// Traction along the major axis that ball k has at its present place.
  [[nodiscard]] std::array<double, 2> along(std::size_t k) const {
    const BallState& ball = state_.elements[k];
    if (!ball.site.tractions) return {};
    const auto f = ball_forces<double>(model_, ball.site, ball.x, ball.rho,
                                       inner_pose<double>(model_, displacement()));
    return {f.contact[0].friction, f.contact[1].friction};
  }
  void hold(std::size_t k, const StaticBall& ball, const BallMotion& motion,
            const Eigen::Matrix<double, 3, 5>& slopes) {
    GivenTractions now;
    const auto value = [&](double of, Eigen::Index row) {
      GivenTractions::Value out{of, {}};
      for (std::size_t p = 0; p < GivenTractions::kPlaces; ++p)
        out.slope[p] = slopes(row, static_cast<Eigen::Index>(p));
      return out;
    };
    now.along = {value(motion.along[0], 0), value(motion.along[1], 1)};
    now.into = motion.into;
    now.orbital = value(motion.orbit, 2);
    now.at.load = ball.Q;
    now.at.rho = ball.r - 0.5 * model_.balls.pitch_diameter;
    for (std::size_t j = 0; j < 2; ++j) {
      now.at.sin[j] = std::sin(ball.alpha[j]);
      now.at.cos[j] = std::cos(ball.alpha[j]);
    }
    state_.elements[k].site.tractions = now;
  }
  void release(std::size_t k) { state_.elements[k].site.tractions.reset(); }

  /// The equilibrium with these tractions; false: none was found, and nothing changes.
  bool solve(StaticSolution& solution) {
    BallRace trial = state_;
    RaceSolve solve = solve_race(model_, task_, trial);
    if (!solve.converged) {
      // Slopes of tractions that saturate mislead long steps: without them.
      trial = state_;
      for (BallState& ball : trial.elements)
        if (ball.site.tractions) {
          for (GivenTractions::Value& value : ball.site.tractions->along) value.slope = {};
          ball.site.tractions->orbital.slope = {};
        }
      solve = solve_race(model_, task_, trial);
      if (!solve.converged) return false;
    }
    state_ = std::move(trial);
    solution.displacement = displacement();
    for (std::size_t k = 0; k < 5; ++k)
      solution.load[k] = state_.load(static_cast<Eigen::Index>(k));
    solution.stiffness = state_.stiffness;
    solution.residual = solve.residual;
    solution.iterations += solve.iterations;
    for (std::size_t k = 0; k < state_.elements.size(); ++k) {
      StaticBall now = report_ball(model_, solution.displacement, state_.elements[k]);
      now.azimuth = solution.balls[k].azimuth;
      solution.balls[k] = now;
    }
    fill_summary(model_, solution);
    return true;
  }
  [[nodiscard]] std::vector<Finding> notes(const StaticSolution& solution) const {
    return report_notes(model_, solution.balls);
  }
  void add_difference(double share, StaticSolution& solution) const {
    if (share > 0.0) add_difference_stiffness(model_, state_, share, solution);
  }

 private:
  [[nodiscard]] std::array<double, 5> displacement() const {
    return {state_.q(0), state_.q(1), state_.q(2), state_.q(3), state_.q(4)};
  }

  RaceTask task_;
  BallModel model_;
  BallRace state_;
};

/// Balls that their cage carries along. Its pockets let the angle of a ball vary by their clearance
/// only, so that its speed departs from that of the cage by a share of what it does alone. The
/// cage orbits where it pushes the balls with no moment in sum.
class CageOrbit {
 public:
  CageOrbit(double orbit, std::vector<double> departure)
      : orbit_(orbit), departure_(std::move(departure)) {}
  [[nodiscard]] double of(std::size_t k) const { return orbit_ + departure_[k]; }

  /// Secant step of the cage. @return its moment over the largest load and the orbit's radius
  double follow(const std::vector<double>& push, const StaticSolution& solution) {
    double moment = 0.0, radius = 0.0;
    for (std::size_t k = 0; k < push.size(); ++k) {
      radius = std::max(radius, solution.balls[k].r);
      moment += push[k] * solution.balls[k].r;
    }
    const double size = moment / (solution.max_load * radius);
    constexpr double kFirst = 1e-5, kLongest = 1e-2;  // over the orbit
    double step = kFirst * orbit_;
    if (last_step_ != 0.0 && size != last_) step = -size * last_step_ / (size - last_);
    step = std::clamp(step, -kLongest * std::abs(orbit_), kLongest * std::abs(orbit_));
    last_ = size;
    last_step_ = step;
    orbit_ += step;
    return std::abs(size);
  }

 private:
  double orbit_, last_ = 0.0, last_step_ = 0.0;
  std::vector<double> departure_;
};

/// Of balls in balance; empty: no cage, or its pockets let each of them orbit alone.
std::optional<CageOrbit> cage_orbit(const Bearing& bearing, const std::vector<BallMotion>& balls,
                                    const StaticSolution& solution) {
  if (!bearing.cage) return std::nullopt;
  const double clearance = bearing.cage->pocket_clearance_1;
  double load = 0.0, heaviest = 0.0, mean = 0.0, radius = 0.0;
  int count = 0;
  for (std::size_t k = 0; k < balls.size(); ++k) {
    radius += solution.balls[k].r / static_cast<double>(balls.size());
    if (!balls[k].balanced) continue;
    if (solution.balls[k].Q[1] > load) {
      load = solution.balls[k].Q[1];
      heaviest = balls[k].orbit;
    }
    mean += balls[k].orbit;
    ++count;
  }
  if (count < 2 || heaviest == 0.0) return std::nullopt;
  mean /= count;
  // With one radius the departures add up to nothing around the bearing, so that the variation does
  // not depend on the ball that is counted first.
  std::vector<double> departure(balls.size(), 0.0);
  double place = 0.0, least = 0.0, most = 0.0;  // ahead of the cage [m]
  for (std::size_t k = 0; k < balls.size(); ++k) {
    if (balls[k].balanced) departure[k] = balls[k].orbit - mean;
    place += departure[k] / heaviest * 2.0 * std::numbers::pi / static_cast<double>(balls.size()) *
             radius;
    least = std::min(least, place);
    most = std::max(most, place);
  }
  if (!(most - least > clearance)) return std::nullopt;
  const double share = std::max(0.0, clearance / (most - least));
  for (double& of_ball : departure) of_ball *= share;
  return CageOrbit(heaviest - share * (heaviest - mean), std::move(departure));
}

/// What follows from the speeds of a ball in balance, in the place of the values of the spin rule.
void give_ratios(const Bearing& bearing, const ContactLaws& laws, const BallMotion& motion,
                 double frame, StaticBall& ball) {
  const double along_x = motion.orbit - motion.omega[0];
  const double sign = std::copysign(1.0, ball.spin_speed);
  ball.spin_speed = sign * std::hypot(along_x, motion.omega[1], motion.omega[2]);
  ball.pitch_angle = std::atan2(sign * motion.omega[1], sign * along_x);
  ball.gyroscopic_moment =
      bearing.element_inertia.moments.x() * (motion.orbit + frame) * motion.omega[1];
  for (std::size_t j = 0; j < 2; ++j) {
    const tribology::EllipseKinematics slip =
        contact_motion(bearing, ball_contact(bearing, laws, ball, j), motion, ball.r, j);
    ball.spin_roll[j] = (j == 0 ? 1.0 : -1.0) * slip.W_n / slip.W_c;
    ball.friction[j] = std::abs(motion.along[j]) / ball.Q[j];
  }
}

}  // namespace

tribology::EllipseKinematics contact_motion(const Bearing& bearing, const BallContact& contact,
                                            const BallMotion& motion, double r, std::size_t race) {
  const double W_x = bearing.speed[race] - motion.omega[0], W_r = -motion.omega[1];
  tribology::EllipseKinematics m{};
  m.u_t = (bearing.speed[race] - motion.orbit) * r;
  m.W_n = W_x * contact.n_x + W_r * contact.n_r;
  m.W_c = -W_x * contact.n_r + W_r * contact.n_x;
  m.W_t = -motion.omega[2];
  // Mean of both surfaces in the frame that orbits with the ball (dynamics/ball_race_motion.hpp).
  const double R = 0.5 * bearing.element_diameter();
  const double turn_c =
      contact.n_x * motion.omega[1] - contact.n_r * (motion.omega[0] - motion.orbit);
  m.entrainment = 0.5 * (m.u_t - m.W_c * R) - R * turn_c;
  return m;
}

void FrictionBalance::give_speeds(StaticSolution& solution) const {
  for (std::size_t k = 0; k < balls.size(); ++k) {
    if (!balls[k].balanced) continue;
    StaticBall& ball = solution.balls[k];
    ball.orbital_speed = balls[k].orbit;
    ball.omega_x = balls[k].omega[0];
    ball.omega_r = balls[k].omega[1];
    ball.omega_theta = balls[k].omega[2];
  }
}

BallMotion FrictionBalance::motion_of(std::size_t k, const StaticBall& ball) const {
  if (k < balls.size() && balls[k].balanced) return balls[k];
  BallMotion out;
  out.omega = {ball.omega_x, ball.omega_r, ball.omega_theta};
  out.orbit = ball.orbital_speed;
  return out;
}

std::string FrictionBalance::note() const {
  if (!failure.empty())
    return fmt::format(
        "no friction equilibrium: {}. The ball speeds follow the spin rule (kAngVel)", failure);
  if (left.empty()) return {};
  std::vector<std::size_t> numbers;
  for (const std::size_t k : left) numbers.push_back(k + 1);
  return fmt::format(
      "{}: no friction equilibrium was found; heat and loads are those of the spin "
      "rule (kAngVel)",
      number_list(numbers, "ball"));
}

bool has_friction_balance(const Bearing& bearing, const StaticsOptions& options) {
  const bool resists =
      bearing.lubrication || tribology::largest_traction(bearing.race_traction) > 0.0;
  return !bearing.rollers() && options.friction_balance && resists &&
         bearing.speed[0] != bearing.speed[1] &&
         bearing.spin_rule != bearing::SpinRule::Prescribed && options.orbit == Orbit::PerBall;
}

FrictionBalance balance_balls(const Bearing& bearing, const StaticsOptions& options,
                              StaticSolution& solution) {
  FrictionBalance out;
  if (!has_friction_balance(bearing, options)) return out;
  const StaticSolution before = solution;
  const ContactLaws laws(bearing);
  // Nodes that tractions do not see pass: of 30, slopes would be 4e-4 apart from differences of
  // whole equilibria, of 100 2e-6. The way from pure rolling takes few. Films are smooth across.
  const int across = bearing.lubrication ? 6 : 12;
  const tribology::EllipseRule rule = tribology::make_split_ellipse_rule(100, across),
                               few = tribology::make_split_ellipse_rule(20, 4);
  std::optional<tribology::BearingDrag> drag;
  if (bearing.churning) drag.emplace(bearing);
  const double frame = options.frame ? options.frame->speed : 0.0;
  for (std::size_t k = 0; k < solution.balls.size(); ++k)
    out.balls.push_back(out.motion_of(k, solution.balls[k]));
  Balls balls(bearing, options, solution);
  std::vector<int> failed(solution.balls.size(), 0);
  std::optional<CageOrbit> cage;
  std::vector<double> push(solution.balls.size(), 0.0);  // of the cage
  // Passes until the tractions stay; false: no equilibrium (change is not finite), or not steady.
  double change = 0.0;
  const auto settle = [&] {
    for (int pass = 0; pass < kPasses; ++pass) {
      change = pass == 0 && !cage ? std::numeric_limits<double>::infinity() : 0.0;
      out.left.clear();
      for (std::size_t k = 0; k < solution.balls.size(); ++k) {
        const StaticBall& ball = solution.balls[k];
        const std::array<double, 2> last = balls.along(k);
        BallMotion& now = out.balls[k];
        balls.release(k);
        push[k] = 0.0;
        if (!is_loaded(ball)) {
          now = FrictionBalance{}.motion_of(k, ball);
        } else {
          Ball at(bearing, laws, drag ? &*drag : nullptr, frame, ball);
          if (cage) at.carry(cage->of(k));
          const bool first = pass == 0 && !cage;
          const auto find = [&] {
            if (failed[k] >= kSearches) return false;
            const bool from_rolling = first ? !at.find(now, few, kNear) : !now.balanced;
            if (from_rolling) now = FrictionBalance{}.motion_of(k, ball);
            if (at.find(now, rule, kBalanced)) return true;
            now = FrictionBalance{}.motion_of(k, ball);
            return !from_rolling && at.find(now, rule, kBalanced);
          };
          if (!find()) {
            now = FrictionBalance{}.motion_of(k, ball);
            ++failed[k];
            out.left.push_back(k);
          }
          push[k] = now.balanced ? at.push() : 0.0;
          if (now.balanced) balls.hold(k, ball, now, at.slopes(balls.seat(k), ball, now));
        }
        if (now.balanced)
          for (std::size_t j = 0; j < 2; ++j)
            change = std::max(change, std::abs(now.along[j] - last[j]) / solution.max_load);
      }
      if (cage) change = std::max(change, cage->follow(push, solution));
      // Once more where they stay: the stiffness has the slopes of this place.
      if (!balls.solve(solution)) {
        change = std::numeric_limits<double>::infinity();
        return false;
      }
      if (change <= kSteady) break;
    }
    return change <= kSteadyAccepted;
  };
  if (!settle()) {
    solution = before;
    out = {};
    out.failure =
        std::isfinite(change)
            ? fmt::format("traction forces and loads did not converge in {} passes", kPasses)
            : "the bearing has no equilibrium with the traction forces";
    return out;
  }
  cage = cage_orbit(bearing, out.balls, solution);
  if (cage) {
    const StaticSolution free = solution;
    const FrictionBalance free_balance = out;
    const Balls free_balls = balls;
    if (!settle()) {
      solution = free;
      out = free_balance;
      balls = free_balls;
    }
  }
  balls.add_difference(options.difference_share, solution);
  out.give_speeds(solution);
  for (std::size_t k = 0; k < solution.balls.size(); ++k)
    if (out.balls[k].balanced) give_ratios(bearing, laws, out.balls[k], frame, solution.balls[k]);
  // Notes of the balls at their new places; those of the spin rule only while a ball keeps it.
  const std::vector<Finding> old = balls.notes(before);
  std::erase_if(solution.notes, [&](const Finding& note) {
    const bool of_rule = note.code == "statics.race_control" || note.code == "statics.least_heat";
    return (of_rule && out.left.empty()) ||
           std::any_of(old.begin(), old.end(), [&](const Finding& one) {
             return one.code == note.code && one.message == note.message;
           });
  });
  for (Finding& note : balls.notes(solution)) solution.notes.push_back(std::move(note));
  return out;
}

}  // namespace adore::statics
