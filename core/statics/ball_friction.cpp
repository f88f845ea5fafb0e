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

constexpr int kPasses = 30;
constexpr int kSearches = 2;  ///< without an equilibrium, of one ball; from then on the spin rule
/// Change of the traction forces in a pass over the largest contact load: below kSteady the search
/// ends. After kPasses passes, a change below kSteadyAccepted is accepted.
constexpr double kSteady = 1e-10, kSteadyAccepted = 1e-5;

/// Computes spin, pitch angle, gyroscopic moment, spin-to-roll and friction ratios from the motion
/// of the friction equilibrium. Before the call, the ball has those of the spin rule.
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

/// Passes of balances of all balls and the equilibrium of the bearing with their tractions.
class Search {
 public:
  Search(const Bearing& bearing, const StaticsOptions& options, StaticSolution& solution)
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
  bool settle() {
    for (int pass = 0; pass < kPasses; ++pass) {
      const bool first = pass == 0 && !cage_ && !lags_;
      change_ = first ? std::numeric_limits<double>::infinity() : 0.0;
      out.left.clear();
      if (!(lags_ ? balance_together() : balance_each(first))) return false;
      if (cage_) change_ = std::max(change_, cage_->follow(push_, solution_));
      // Once more where they stay: the stiffness has the slopes of this place.
      if (!race.solve(solution_)) {
        change_ = std::numeric_limits<double>::infinity();
        return false;
      }
      if (change_ <= kSteady) break;
    }
    return change_ <= kSteadyAccepted;
  }

  [[nodiscard]] std::string failure() const {
    return std::isfinite(change_)
               ? fmt::format("traction forces and loads did not converge in {} passes", kPasses)
               : "the bearing has no equilibrium with the traction forces";
  }

  /// Balls that their cage carries, where their pockets need it.
  void join_cage() {
    cage_ = cage_orbit(bearing_, out.balls, solution_);
    if (!cage_) return;
    const State alone = state();
    if (settle()) return;
    const std::string why = failure();
    give_back(alone);
    cage_.reset();
    out.without_cage = why;
  }

  /// The moment that turns spin axes along the orbit.
  void follow_orbit() {
    std::vector<std::optional<BallBalance>> balances = balances_of_all();
    const std::optional<SpinLag> lag = lag_of(balances);
    if (!lag) return;
    for (std::optional<BallBalance>& ball : balances)
      if (ball) ball->use(rule_);
    const std::vector<double> ratio =
        lag->moment_ratio(out.balls, 0.5 * bearing_.element_diameter(), out.balls.size());
    const auto worst = std::max_element(ratio.begin(), ratio.end());
    out.turning = *worst;
    out.turning_ball = static_cast<std::size_t>(worst - ratio.begin());
    constexpr double kNegligible = 1e-2;
    if (!(out.turning > kNegligible)) return;
    const State at_once = state();
    lags_ = true;
    if (settle()) return;
    const std::string why = failure();
    lags_ = false;
    give_back(at_once);
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
  void give_back(State from) {
    solution_ = std::move(from.solution);
    out = std::move(from.out);
    race = std::move(from.race);
  }

  [[nodiscard]] BallBalance balance_of(std::size_t k) const {
    BallBalance at(bearing_, laws, drag_ ? &*drag_ : nullptr, frame, solution_.balls[k]);
    if (cage_) at.carry(cage_->of(k));
    return at;
  }

  /// Ball k alone. @param first from pure rolling
  bool find(std::size_t k, BallBalance& at, bool first) {
    if (failed_[k] >= kSearches) return false;
    const StaticBall& ball = solution_.balls[k];
    BallMotion& now = out.balls[k];
    const bool from_rolling = first ? !at.find(now, few_, kNear) : !now.balanced;
    if (from_rolling) now = FrictionBalance{}.motion_of(k, ball);
    if (at.find(now, rule_, kBalanced)) return true;
    now = FrictionBalance{}.motion_of(k, ball);
    return !from_rolling && at.find(now, rule_, kBalanced);
  }

  void note_change(std::size_t k, const std::array<double, 2>& last) {
    for (std::size_t j = 0; j < 2; ++j)
      change_ = std::max(change_, std::abs(out.balls[k].along[j] - last[j]) / solution_.max_load);
  }

  /// The spin rule for a ball that is not in balance. @param asked it is loaded
  void leave(std::size_t k, bool asked) {
    out.balls[k] = FrictionBalance{}.motion_of(k, solution_.balls[k]);
    if (!asked) return;
    ++failed_[k];
    out.left.push_back(k);
  }

  bool balance_each(bool first) {
    for (std::size_t k = 0; k < solution_.balls.size(); ++k) {
      const StaticBall& ball = solution_.balls[k];
      const std::array<double, 2> last = race.along(k);
      race.release(k);
      push_[k] = 0.0;
      if (!is_loaded(ball)) {
        leave(k, false);
        continue;
      }
      BallBalance at = balance_of(k);
      if (!find(k, at, first)) {
        leave(k, true);
        continue;
      }
      push_[k] = at.push();
      race.hold(k, ball, out.balls[k], at.slopes(race.seat(k), ball, out.balls[k]));
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
  [[nodiscard]] std::optional<SpinLag> lag_of(
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
  bool balance_together() {
    const std::size_t n = solution_.balls.size();
    std::vector<std::optional<BallBalance>> balances = balances_of_all();
    std::vector<std::array<double, 2>> last;
    for (std::size_t k = 0; k < n; ++k) {
      last.push_back(race.along(k));
      push_[k] = 0.0;
      const bool loaded = is_loaded(solution_.balls[k]);
      if (!loaded || (!out.balls[k].balanced && !find(k, *balances[k], false))) leave(k, loaded);
    }
    const std::optional<SpinLag> lag = lag_of(balances);
    if (!lag || !lag->find(out.balls, few_, rule_)) {
      change_ = std::numeric_limits<double>::infinity();
      return false;
    }
    std::vector<BallSlopes> slopes(n);
    for (std::size_t k = 0; k < n; ++k) {
      race.release(k);
      if (!out.balls[k].balanced) continue;
      push_[k] = balances[k]->push();
      slopes[k] = balances[k]->linearize(race.seat(k), solution_.balls[k], out.balls[k]);
    }
    const Eigen::MatrixXd over_all = lag->slopes(slopes, out.balls, n);
    for (std::size_t k = 0; k < n; ++k) {
      if (!out.balls[k].balanced) continue;
      const auto i = static_cast<Eigen::Index>(k);
      race.hold(k, solution_.balls[k], out.balls[k], over_all.block<3, 5>(3 * i, 5 * i));
      note_change(k, last[k]);
    }
    race.couple(over_all);
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

std::vector<Finding> FrictionBalance::findings() const {
  std::vector<Finding> out;
  if (!failure.empty()) {
    out.push_back(make_finding(
        "statics.friction_balance",
        fmt::format("no friction equilibrium: {}. The ball speeds follow the spin rule (kAngVel)",
                    failure)));
    return out;
  }
  if (!left.empty()) {
    std::vector<std::size_t> numbers;
    for (const std::size_t k : left) numbers.push_back(k + 1);
    out.push_back(make_finding(
        "statics.friction_balance",
        fmt::format("{}: no friction equilibrium was found; heat and loads are those of the spin "
                    "rule (kAngVel)",
                    number_list(numbers, "ball"))));
  }
  if (!without_cage.empty())
    out.push_back(make_finding(
        "statics.cage_orbit",
        fmt::format("the cage carries balls along the orbit, but no friction equilibrium with the "
                    "cage was found: {}. Each ball orbits alone. Light balls orbit too fast, and "
                    "contact loads may be several percent too large",
                    without_cage)));
  if (plain_stiffness)
    out.push_back(make_finding(
        "statics.plain_stiffness",
        "the stiffness does not include changes of the traction forces: no equilibrium was found "
        "with them. Loads and displacements include the traction forces"));
  if (!without_turning.empty())
    out.push_back(
        make_finding(
            "statics.spin_lag",
            fmt::format(
                "ball {}: to turn its spin axis along the orbit takes {:.2g} times its "
                "friction moment, but no equilibrium with this moment was found: {}. {}",
                turning_ball + 1, turning, without_turning,
                turning > 1.0
                    ? "Spin axes lag behind in motion, so that the race heat is a lower bound"
                    : "Race heat and loads do not include this moment"))
            .of(fmt::format("ball {}", turning_ball + 1))
            .measure(turning, 1.0));
  return out;
}

std::vector<std::string> FrictionBalance::notes() const {
  std::vector<std::string> out;
  for (Finding& one : findings()) out.push_back(std::move(one.message));
  return out;
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
  if (!has_friction_balance(bearing, options)) return {};
  const StaticSolution before = solution;
  Search search(bearing, options, solution);
  if (!search.settle()) {
    solution = before;
    FrictionBalance out;
    out.failure = search.failure();
    return out;
  }
  search.join_cage();
  search.follow_orbit();
  FrictionBalance out = std::move(search.out);
  out.plain_stiffness = search.race.is_plain();
  search.race.add_difference(options.difference_share, solution);
  out.give_speeds(solution);
  for (std::size_t k = 0; k < solution.balls.size(); ++k)
    if (out.balls[k].balanced)
      give_ratios(bearing, search.laws, out.balls[k], search.frame, solution.balls[k]);
  // Notes of the balls at their new places; those of the spin rule only while a ball keeps it.
  const std::vector<std::string> old = search.race.notes(before);
  std::erase_if(solution.notes, [&](const std::string& note) {
    const bool of_rule =
        note.starts_with("race control: ") || note.starts_with("minimum-heat spin axis: ");
    return std::count(old.begin(), old.end(), note) > 0 || (of_rule && out.left.empty());
  });
  for (std::string& note : search.race.notes(solution)) solution.notes.push_back(std::move(note));
  return out;
}

}  // namespace adore::statics