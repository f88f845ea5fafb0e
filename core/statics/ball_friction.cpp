#include "statics/ball_friction.hpp"

#include "base/errors.hpp"
#include "statics/balanced_race.hpp"
#include "statics/ball_balance.hpp"
#include "statics/cage_orbit.hpp"
#include "statics/race_text.hpp"
#include "statics/spin_lag.hpp"
#include "tribology/bearing_drag.hpp"
#include "tribology/traction_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace adore::statics {
namespace {

using bearing::Bearing;

constexpr int kMaxPasses = 30;
/// Failed searches for the equilibrium of one ball, after which it keeps the spin rule.
constexpr int kMaxFailedSearches = 2;
/// Change of the traction forces in a pass over the largest contact load: below kSteadyChange the
/// search ends. After kMaxPasses passes, a change below kAcceptedChange is accepted.
constexpr double kSteadyChange = 1e-10, kAcceptedChange = 1e-5;

/// Computes spin, pitch angle, gyroscopic moment, spin-to-roll and friction ratios from the motion
/// of the friction equilibrium. Before the call, the ball has those of the spin rule.
void set_contact_ratios(const Bearing& bearing, const ContactLaws& laws, const BallMotion& motion,
                        double frame, StaticBall& ball) {
  const double along_x = motion.orbit - motion.omega[0];
  const double sign = std::copysign(1.0, ball.spin_speed);
  ball.spin_speed = sign * std::hypot(along_x, motion.omega[1], motion.omega[2]);
  ball.pitch_angle = std::atan2(sign * motion.omega[1], sign * along_x);
  ball.gyroscopic_moment =
      bearing.element_inertia.moments.x() * (motion.orbit + frame) * motion.omega[1];
  for (std::size_t j = 0; j < 2; ++j) {
    const tribology::EllipseKinematics slip =
        contact_kinematics(bearing, ball_contact(bearing, laws, ball, j), motion, ball.r, j);
    ball.spin_roll[j] = (j == 0 ? 1.0 : -1.0) * slip.W_n / slip.W_c;
    ball.friction[j] = std::abs(motion.along[j]) / ball.Q[j];
  }
}

/// Passes of balances of all balls and the equilibrium of the bearing with their tractions.
class Search {
 public:
  Search(const Bearing& bearing, const BallStaticsOptions& options, StaticSolution& solution)
      : laws(bearing),
        frame(options.frame ? options.frame->speed : 0.0),
        race(bearing, options, solution),
        bearing_(bearing),
        solution_(solution),
        // Nodes that tractions do not see pass: of 30, slopes would be 4e-4 apart from differences
        // of whole equilibria, of 100 2e-6. The way from pure rolling takes few. Films are smooth
        // across.
        rule_(tribology::make_split_ellipse_rule(100, bearing.lubrication ? 6 : 12)),
        few_(tribology::make_split_ellipse_rule(20, 4)),
        failed_(solution.balls.size(), 0),
        push_(solution.balls.size(), 0.0) {
    if (bearing.churning) drag_.emplace(bearing);
    for (std::size_t k = 0; k < solution.balls.size(); ++k)
      out.balls.push_back(out.motion_of(k, solution.balls[k]));
  }

  /// Passes until the tractions stay; false: no equilibrium, or not steady.
  bool iterate() {
    for (int pass = 0; pass < kMaxPasses; ++pass) {
      const bool first = pass == 0 && !cage_ && !lags_;
      change_ = first ? std::numeric_limits<double>::infinity() : 0.0;
      out.left.clear();
      if (!(lags_ ? balance_coupled() : balance_separately(first))) return false;
      if (cage_) change_ = std::max(change_, cage_->follow(push_, solution_));
      // Once more where they stay: the stiffness has the slopes of this place.
      if (!race.solve(solution_)) {
        change_ = std::numeric_limits<double>::infinity();
        return false;
      }
      if (change_ <= kSteadyChange) break;
    }
    return change_ <= kAcceptedChange;
  }

  [[nodiscard]] std::string failure() const {
    return std::isfinite(change_)
               ? fmt::format("traction forces and loads did not converge in {} passes", kMaxPasses)
               : "the bearing has no equilibrium with the traction forces";
  }

  /// Balls that their cage carries, where their pockets need it.
  void add_cage() {
    cage_ = cage_orbit(bearing_, out.balls, solution_);
    if (!cage_) return;
    const State alone = state();
    if (iterate()) return;
    const std::string why = failure();
    restore(alone);
    cage_.reset();
    out.without_cage = why;
  }

  /// The moment that turns spin axes along the orbit.
  void add_gyroscopic_turning() {
    std::vector<std::optional<BallBalance>> balances = balances_of_all();
    const std::optional<SpinLag> lag = spin_lag_of(balances);
    if (!lag) return;
    for (std::optional<BallBalance>& ball : balances)
      if (ball) ball->use(rule_);
    const std::vector<double> ratio =
        lag->spin_moment_ratio(out.balls, 0.5 * bearing_.element_diameter(), out.balls.size());
    const auto worst = std::max_element(ratio.begin(), ratio.end());
    out.turning = *worst;
    out.turning_ball = static_cast<std::size_t>(worst - ratio.begin());
    constexpr double kMinMomentRatio = 1e-2;
    if (!(out.turning > kMinMomentRatio)) return;
    const State at_once = state();
    lags_ = true;
    if (iterate()) return;
    const std::string why = failure();
    lags_ = false;
    restore(at_once);
    out.without_turning = why;
  }

  FrictionBalance out;
  const ContactLaws laws;
  const double frame;
  BalancedRace race;

 private:
  struct State {
    StaticSolution solution;
    FrictionBalance out;
    BalancedRace race;
  };
  [[nodiscard]] State state() const { return {solution_, out, race}; }
  void restore(State from) {
    solution_ = std::move(from.solution);
    out = std::move(from.out);
    race = std::move(from.race);
  }

  [[nodiscard]] BallBalance balance_of(std::size_t k) const {
    BallBalance at(bearing_, laws, drag_ ? &*drag_ : nullptr, frame, solution_.balls[k]);
    if (cage_) at.set_cage_orbital_speed(cage_->of(k));
    return at;
  }

  /// Ball k alone. @param first from pure rolling
  bool find(std::size_t k, BallBalance& at, bool first) {
    if (failed_[k] >= kMaxFailedSearches) return false;
    const StaticBall& ball = solution_.balls[k];
    BallMotion& now = out.balls[k];
    const bool from_rolling = first ? !at.find(now, few_, kFewNodesTolerance) : !now.balanced;
    if (from_rolling) now = FrictionBalance{}.motion_of(k, ball);
    if (at.find(now, rule_, kBalanceTolerance)) return true;
    now = FrictionBalance{}.motion_of(k, ball);
    return !from_rolling && at.find(now, rule_, kBalanceTolerance);
  }

  void note_change(std::size_t k, const std::array<double, 2>& last) {
    for (std::size_t j = 0; j < 2; ++j)
      change_ = std::max(change_, std::abs(out.balls[k].along[j] - last[j]) / solution_.max_load);
  }

  /// The spin rule for a ball that is not in balance. @param asked it is loaded
  void use_spin_rule(std::size_t k, bool asked) {
    out.balls[k] = FrictionBalance{}.motion_of(k, solution_.balls[k]);
    if (!asked) return;
    ++failed_[k];
    out.left.push_back(k);
  }

  bool balance_separately(bool first) {
    for (std::size_t k = 0; k < solution_.balls.size(); ++k) {
      const StaticBall& ball = solution_.balls[k];
      const std::array<double, 2> last = race.along(k);
      race.clear_traction(k);
      push_[k] = 0.0;
      if (!is_loaded(ball)) {
        use_spin_rule(k, false);
        continue;
      }
      BallBalance at = balance_of(k);
      if (!find(k, at, first)) {
        use_spin_rule(k, true);
        continue;
      }
      push_[k] = at.cage_force();
      race.set_traction(k, ball, out.balls[k], at.slopes(race.seat(k), ball, out.balls[k]));
      note_change(k, last);
    }
    return true;
  }

  /// By ball; loaded ones.
  [[nodiscard]] std::vector<std::optional<BallBalance>> balances_of_all() const {
    std::vector<std::optional<BallBalance>> balances(solution_.balls.size());
    for (std::size_t k = 0; k < balances.size(); ++k)
      if (is_loaded(solution_.balls[k])) balances[k].emplace(balance_of(k));
    return balances;
  }
  /// Of the balls in balance; empty: too few.
  [[nodiscard]] std::optional<SpinLag> spin_lag_of(
      std::vector<std::optional<BallBalance>>& balances) const {
    std::vector<SpinLag::Ball> balls;
    double orbit = 0.0;
    for (std::size_t k = 0; k < solution_.balls.size(); ++k) {
      if (!is_loaded(solution_.balls[k]) || !out.balls[k].balanced) continue;
      balls.push_back({k, solution_.balls[k].azimuth, &*balances[k]});
      orbit += out.balls[k].orbit;
    }
    if (balls.size() < 3) return std::nullopt;
    return SpinLag(std::move(balls), orbit);
  }

  /// All balls at once; false: no balance.
  bool balance_coupled() {
    const std::size_t n = solution_.balls.size();
    std::vector<std::optional<BallBalance>> balances = balances_of_all();
    std::vector<std::array<double, 2>> last;
    for (std::size_t k = 0; k < n; ++k) {
      last.push_back(race.along(k));
      push_[k] = 0.0;
      const bool loaded = is_loaded(solution_.balls[k]);
      if (!loaded || (!out.balls[k].balanced && !find(k, *balances[k], false)))
        use_spin_rule(k, loaded);
    }
    const std::optional<SpinLag> lag = spin_lag_of(balances);
    if (!lag || !lag->find(out.balls, few_, rule_)) {
      change_ = std::numeric_limits<double>::infinity();
      return false;
    }
    std::vector<BallLinearization> slopes(n);
    for (std::size_t k = 0; k < n; ++k) {
      race.clear_traction(k);
      if (!out.balls[k].balanced) continue;
      push_[k] = balances[k]->cage_force();
      slopes[k] = balances[k]->linearize(race.seat(k), solution_.balls[k], out.balls[k]);
    }
    const Eigen::MatrixXd over_all = lag->slopes(slopes, out.balls, n);
    for (std::size_t k = 0; k < n; ++k) {
      if (!out.balls[k].balanced) continue;
      const auto i = static_cast<Eigen::Index>(k);
      race.set_traction(k, solution_.balls[k], out.balls[k], over_all.block<3, 5>(3 * i, 5 * i));
      note_change(k, last[k]);
    }
    race.set_coupling(over_all);
    return true;
  }

  const Bearing& bearing_;
  StaticSolution& solution_;
  const tribology::EllipseRule rule_, few_;
  std::optional<tribology::BearingDrag> drag_;
  std::optional<CageOrbit> cage_;
  bool lags_ = false;
  std::vector<int> failed_;
  std::vector<double> push_;  ///< of the cage [N]
  double change_ = 0.0;
};
}  // namespace

tribology::EllipseKinematics contact_kinematics(const Bearing& bearing, const BallContact& contact,
                                                const BallMotion& motion, double r,
                                                std::size_t race) {
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

void FrictionBalance::copy_speeds_to(StaticSolution& solution) const {
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

std::vector<Finding> FrictionBalance::findings() const {
  std::vector<Finding> out;
  if (!failure.empty()) {
    out.push_back(make_finding(
        "statics.friction_balance",
        fmt::format(
            "no friction equilibrium was found: {}. The ball speeds follow the spin rule (kAngVel)",
            failure)));
    return out;
  }
  if (!left.empty()) {
    std::vector<std::size_t> numbers;
    for (const std::size_t k : left) numbers.push_back(k + 1);
    out.push_back(
        make_finding(
            "statics.friction_balance",
            fmt::format("{}: no friction equilibrium was found; heat and loads are those of the "
                        "spin rule (kAngVel)",
                        number_list(numbers, "ball")))
            .of(fmt::format("ball {}", numbers.front())));
  }
  if (!without_cage.empty())
    out.push_back(make_finding(
        "statics.cage_orbit",
        fmt::format("the cage pushes balls along their orbit, but no friction equilibrium with the "
                    "cage was found: {}. The result does not include the cage: lightly loaded "
                    "balls orbit too fast, and contact loads may be several percent too large",
                    without_cage)));
  if (plain_stiffness)
    out.push_back(make_finding(
        "statics.plain_stiffness",
        "the stiffness does not include changes of the traction forces, because no equilibrium was "
        "found with these changes. Loads and displacements include the traction forces"));
  if (!without_turning.empty())
    out.push_back(
        make_finding(
            "statics.spin_lag",
            fmt::format(
                "ball {}: no equilibrium was found with the moment that turns the spin axis along "
                "the "
                "orbit ({:.2g} times the friction moment): {}. {}",
                turning_ball + 1, turning, without_turning,
                turning > 1.0
                    ? "In the real motion, the spin axes lag behind the orbiting contacts, so the "
                      "computed race heat is a lower bound"
                    : "Race heat and loads do not include the moment that turns the spin axis"))
            .of(fmt::format("ball {}", turning_ball + 1))
            .measure(turning, 1.0));
  return out;
}

bool has_friction_balance(const Bearing& bearing, const BallStaticsOptions& options) {
  const bool resists =
      bearing.lubrication || tribology::max_traction_coefficient(bearing.race_traction) > 0.0;
  return !bearing.rollers() && options.friction_balance && resists &&
         bearing.speed[0] != bearing.speed[1] &&
         bearing.spin_rule != bearing::SpinRule::Prescribed && options.orbit == Orbit::PerBall;
}

FrictionBalance solve_ball_friction_balance(const Bearing& bearing,
                                            const BallStaticsOptions& options,
                                            StaticSolution& solution) {
  if (!has_friction_balance(bearing, options)) return {};
  const StaticSolution before = solution;
  Search search(bearing, options, solution);
  if (!search.iterate()) {
    solution = before;
    FrictionBalance out;
    out.failure = search.failure();
    return out;
  }
  search.add_cage();
  search.add_gyroscopic_turning();
  FrictionBalance out = std::move(search.out);
  out.plain_stiffness = search.race.ignores_traction_slopes();
  search.race.add_stiffness_by_difference(options.difference_share, solution);
  out.copy_speeds_to(solution);
  for (std::size_t k = 0; k < solution.balls.size(); ++k)
    if (out.balls[k].balanced)
      set_contact_ratios(bearing, search.laws, out.balls[k], search.frame, solution.balls[k]);
  // Notes of the balls at their new places; those of the spin rule only while a ball keeps it.
  const std::vector<Finding> old = search.race.notes(before);
  std::erase_if(solution.notes, [&](const Finding& note) {
    const bool of_rule = note.code == "statics.race_control" || note.code == "statics.least_heat";
    return (of_rule && out.left.empty()) ||
           std::any_of(old.begin(), old.end(), [&](const Finding& one) {
             return one.code == note.code && one.message == note.message;
           });
  });
  for (Finding& note : search.race.notes(solution)) solution.notes.push_back(std::move(note));
  return out;
}

}  // namespace adore::statics