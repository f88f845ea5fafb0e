#include "statics/ball_friction.hpp"

#include "base/errors.hpp"
#include "statics/ball_report.hpp"
#include "statics/race_text.hpp"
#include "tribology/bearing_drag.hpp"
#include "tribology/traction_curve.hpp"

#include <Eigen/LU>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace adore::statics {
namespace {

using bearing::Bearing;
using Vec4 = Eigen::Vector4d;
using Mat4 = Eigen::Matrix4d;

constexpr int kSteps = 100, kCuts = 4, kPasses = 20;
/// Residual over the larger contact load: where steps end, and what is taken when they are used up.
constexpr double kBalanced = 1e-11, kAccepted = 1e-5;
/// Change of the tractions over the largest contact load: likewise.
constexpr double kSteady = 1e-10, kSteadyAccepted = 1e-5;
constexpr double kLongestStep = 0.03;  ///< over the spin
constexpr double kDifference = 1e-7;   ///< likewise

bool is_loaded(const StaticBall& ball) { return ball.Q[0] > 0.0 && ball.Q[1] > 0.0; }

/// One ball at its place.
class Ball {
 public:
  Ball(const Bearing& bearing, const ContactLaws& laws, const tribology::EllipseRule& rule,
       const tribology::BearingDrag* drag, double frame, const StaticBall& ball)
      : bearing_(bearing), rule_(rule), drag_(drag), frame_(frame), r_(ball.r) {
    radius_ = 0.5 * bearing.balls().diameter;
    load_ = std::max(ball.Q[0], ball.Q[1]);
    spin_ = std::abs(ball.spin_speed);
    for (std::size_t j = 0; j < 2; ++j) {
      contact_[j] = ball_contact(bearing, laws, ball, j);
      rolling_[j] = laws.rolling_force(j, contact_[j].film);
    }
  }

  /// False: no balance was found; the motion is then of no use.
  bool find(BallMotion& motion) {
    motion.balanced = false;
    if (!(spin_ > 0.0)) return false;
    Vec4 v(motion.omega[0], motion.omega[1], motion.omega[2], motion.orbit);
    v /= spin_;
    Vec4 G = residual(v, motion);
    const double first = std::max(G.norm(), kBalanced);
    for (int n = 0; n < kSteps && G.norm() > kBalanced; ++n) {
      const double size = G.norm();
      if (!std::isfinite(size)) return false;
      Mat4 J;
      BallMotion ignored;
      for (int k = 0; k < 4; ++k) {
        Vec4 w = v;
        w[k] += kDifference;
        J.col(k) = (residual(w, ignored) - G) / kDifference;
      }
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
      constexpr double kRounding = 1e-8;
      if (size <= kRounding && !(next.norm() < size)) {
        (void)residual(v, motion);
        break;
      }
      v += d;
      G = next;
    }
    motion.omega = spin_ * v.head<3>();
    motion.orbit = spin_ * v[3];
    motion.balanced = G.norm() <= kAccepted;
    return motion.balanced;
  }

 private:
  /// M_x, M_r, M_θ over load and radius; F_θ over the load, as what it does to the orbit.
  Vec4 residual(const Vec4& v, BallMotion& motion) const {
    BallMotion at;
    at.omega = spin_ * v.head<3>();
    at.orbit = spin_ * v[3];
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();
    double force = 0.0;
    for (std::size_t j = 0; j < 2; ++j) {
      const BallContact& c = contact_[j];
      const tribology::EllipseTraction on_ball = tribology::ellipse_traction(
          c.law, c.ellipse, contact_motion(bearing_, c, at, r_, j), rule_);
      const double about_c = on_ball.M_c + radius_ * rolling_[j];
      moment += Eigen::Vector3d(-about_c * c.n_r + on_ball.M_n * c.n_x,
                                about_c * c.n_x + on_ball.M_n * c.n_r, on_ball.M_t);
      force += on_ball.F_t + (2.0 * c.film.radius / radius_ - 1.0) * rolling_[j];
      motion.along[j] = on_ball.F_c;
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
    Vec4 out;
    out << moment / (load_ * radius_), kSphere * force / load_ * radius_ / r_;
    return out;
  }

  const Bearing& bearing_;
  const tribology::EllipseRule& rule_;
  const tribology::BearingDrag* drag_;
  double frame_, r_, radius_ = 0.0, load_ = 0.0, spin_ = 0.0;
  std::array<BallContact, 2> contact_;
  std::array<double, 2> rolling_{};
};

/// The equilibrium with the tractions of the motion; false: none was found.
bool solve_with(const Bearing& bearing, const StaticsOptions& options, const FrictionBalance& found,
                StaticSolution& solution) {
  const BallModel model = make_ball_model(bearing, options);
  BallRace state;
  state.q = Eigen::Map<const Vec5>(solution.displacement.data());
  for (std::size_t k = 0; k < solution.balls.size(); ++k) {
    const StaticBall& from = solution.balls[k];
    BallState ball;
    ball.site.sin = std::sin(from.azimuth);
    ball.site.cos = std::cos(from.azimuth);
    ball.site.own = model.own_number.empty() ? 0 : model.own_number[k];
    ball.site.law = first_spin_law(bearing, options);
    ball.site.axis_shift = from.axis_shift;
    if (from.inner_race_control)
      ball.site.law = {SpinLaw::Axis::InnerControl, SpinLaw::Share::Equal};
    if (found.balls[k].balanced) ball.site.tractions = {found.balls[k].along, found.balls[k].orbit};
    ball.x = from.x;
    ball.rho = from.r - 0.5 * model.balls.pitch_diameter;
    ball.known = true;
    state.elements.push_back(ball);
  }
  const RaceSolve solve = solve_race(model, race_task(bearing.constraints), state);
  if (!solve.converged) return false;
  for (std::size_t k = 0; k < 5; ++k) {
    solution.displacement[k] = state.q(static_cast<Eigen::Index>(k));
    solution.load[k] = state.load(static_cast<Eigen::Index>(k));
  }
  solution.stiffness = state.stiffness;
  solution.residual = solve.residual;
  solution.iterations += solve.iterations;
  for (std::size_t k = 0; k < state.elements.size(); ++k) {
    StaticBall now = report_ball(model, solution.displacement, state.elements[k]);
    now.azimuth = solution.balls[k].azimuth;
    now.friction = solution.balls[k].friction;  // that the spin rule needs
    solution.balls[k] = now;
  }
  fill_summary(model, solution);
  return true;
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
  m.entrainment = contact.film.speed;
  return m;
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
    return fmt::format("friction is not in balance: {}; balls roll by the spin rule (kAngVel)",
                       failure);
  if (left.empty()) return {};
  std::vector<std::size_t> numbers;
  for (const std::size_t k : left) numbers.push_back(k + 1);
  return fmt::format(
      "{}: no balance of friction was found; heat and loads are those of the spin "
      "rule (kAngVel)",
      number_list(numbers, "ball"));
}

FrictionBalance balance_balls(const Bearing& bearing, const StaticsOptions& options,
                              StaticSolution& solution) {
  FrictionBalance out;
  const bool resists =
      bearing.lubrication || tribology::largest_traction(bearing.race_traction) > 0.0;
  if (!options.friction_balance || !resists || bearing.speed[0] == bearing.speed[1] ||
      bearing.spin_rule == bearing::SpinRule::Prescribed || options.orbit != Orbit::PerBall)
    return out;
  const StaticSolution before = solution;
  const ContactLaws laws(bearing);
  const tribology::EllipseRule rule = tribology::make_split_ellipse_rule(30, 8);
  std::optional<tribology::BearingDrag> drag;
  if (bearing.churning) drag.emplace(bearing);
  const double frame = options.frame ? options.frame->speed : 0.0;
  for (std::size_t k = 0; k < solution.balls.size(); ++k)
    out.balls.push_back(out.motion_of(k, solution.balls[k]));
  double change = 0.0;
  for (int pass = 0; pass < kPasses; ++pass) {
    change = pass == 0 ? std::numeric_limits<double>::infinity() : 0.0;
    out.left.clear();
    for (std::size_t k = 0; k < solution.balls.size(); ++k) {
      const StaticBall& ball = solution.balls[k];
      const BallMotion last = out.balls[k];
      BallMotion& now = out.balls[k];
      if (!is_loaded(ball)) {
        now = FrictionBalance{}.motion_of(k, ball);
      } else {
        Ball at(bearing, laws, rule, drag ? &*drag : nullptr, frame, ball);
        if (!at.find(now)) {
          now = FrictionBalance{}.motion_of(k, ball);  // once more from pure rolling
          if (!at.find(now)) {
            now = FrictionBalance{}.motion_of(k, ball);
            out.left.push_back(k);
          }
        }
      }
      for (std::size_t j = 0; j < 2; ++j)
        change = std::max(change, std::abs(now.along[j] - last.along[j]) / solution.max_load);
    }
    if (change <= kSteady) return out;
    if (!solve_with(bearing, options, out, solution)) {
      solution = before;
      out = {};
      out.failure = "no equilibrium of the bearing was found with its tractions";
      return out;
    }
  }
  if (change <= kSteadyAccepted) return out;
  solution = before;
  out = {};
  out.failure = fmt::format("tractions and loads do not settle in {} passes", kPasses);
  return out;
}

}  // namespace adore::statics
