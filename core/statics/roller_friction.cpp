#include "statics/roller_friction.hpp"

#include "base/errors.hpp"
#include "statics/friction_flow.hpp"
#include "statics/race_text.hpp"
#include "statics/roller_motion_forces.hpp"
#include "statics/roller_report.hpp"
#include "statics/stiffness_difference.hpp"
#include "tribology/traction_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace adore::statics {
namespace {

using bearing::Bearing;
using Mat65 = Eigen::Matrix<double, 6, 5>;
using Vec11 = Eigen::Matrix<double, 11, 1>;
using Mat11 = Eigen::Matrix<double, 11, 11>;

constexpr int kMaxRollerSteps = 80, kMaxRollerStepCuts = 4, kMaxPasses = 8;
/// Residuals that the search for one roller may take in all.
constexpr int kMaxEvaluations = 4000;
/// Rates: where steps end, what is taken where rounding ends them, and where they end at the place
/// of the race without friction.
constexpr double kBalanceTolerance = 1e-11, kAcceptedRates = 1e-8, kFirstTolerance = 1e-6;
/// Differences and longest steps in units of u.
const Vec6 kDifference = (Vec6() << 1e-8, 1e-8, 1e-7, 1e-7, 2e-8, 2e-8).finished();
const Vec6 kMaxStep = (Vec6() << 1e-2, 1e-2, 3e-3, 1e-2, 1e-2, 1e-2).finished();
constexpr double kRaceDifference = 1e-8;  ///< in units of q
constexpr double kMinLoadRatio = 1e-3;    ///< load of a roller in balance over the largest one

/// A roller, its action where it was evaluated last, and derivatives that follow all evaluations
/// (Broyden's update): 11 rows rates and load, 11 columns u and q in their units.
struct FrictionRoller {
  RollerState state;
  Vec6 u = Vec6::Zero();
  RollerMotionAction action;
  Vec11 place = Vec11::Zero();      ///< (u, q) of `action` in their units
  Mat11 D = Mat11::Zero();          ///< ∂(rates, load)/∂(u, q)
  Mat65 follow = Mat65::Zero();     ///< du/dq
  bool placed = false;              ///< `action` and `place` are of this roller
  bool by_u = false, by_q = false;  ///< columns of D that are known
  bool balanced = false;
  bool axial = true;  ///< x is free
  int left = kMaxEvaluations;
  [[nodiscard]] Mat6 J() const { return D.topLeftCorner<6, 6>(); }
};

/// An element set of race_equilibrium.hpp.
struct FrictionSet {
  const RollerModel& model;
  const RollerMotionForces& forces;
  std::vector<std::size_t>* lost = nullptr;  ///< rollers whose search ended nowhere
  bool central = false;                      ///< differences
  bool fresh = false;  ///< derivatives at each place of the race, where those kept mislead
};
using FrictionRace = RaceState<FrictionRoller>;

RaceScales race_scales(const FrictionSet& set) { return race_scales(set.model); }
double reference_stiffness(const FrictionSet& set, double load) {
  return reference_stiffness(set.model, load);
}
bool is_conservative(const FrictionSet&) { return false; }
double initial_accuracy(const FrictionSet& set) { return set.fresh ? 0.0 : 0.03; }

Races<double> races_of(const FrictionSet& set, const Vec5& q) {
  return races_at<double>(set.model, q);
}

/// Of q: the radius of a roller, tilts at the lever of the race.
Vec5 race_units(const FrictionSet& set) {
  const double radius = 0.5 * set.model.rollers.diameter, lever = race_scales(set).lever;
  return (Vec5() << radius, radius, radius, radius / lever, radius / lever).finished();
}

RollerMotionAction evaluate(const FrictionSet& set, FrictionRoller& roller, const Vec6& u,
                            const Races<double>& races,
                            const RollerMotionAction* same_outer = nullptr) {
  --roller.left;
  RollerMotionAction out = set.forces.at(roller.state, u, races, same_outer);
  if (!roller.axial)
    out.rates[kPlaceX] = (roller.state.e(0) - u[kPlaceX]) / set.forces.units()[kPlaceX];
  return out;
}

Vec11 values(const RollerMotionAction& action) {
  return (Vec11() << action.rates, action.load).finished();
}

/// Moves a roller to u and evaluates it there, with the race at q. The change since the last
/// evaluation corrects the derivatives.
void move_to(const FrictionSet& set, FrictionRoller& roller, const Vec6& u, const Vec5& q,
             const Races<double>& races) {
  constexpr double kMinUpdateStep = 1e-11;
  roller.u = u;
  const RollerMotionAction there = evaluate(set, roller, u, races);
  Vec11 place;
  place << u.cwiseQuotient(set.forces.units()), q.cwiseQuotient(race_units(set));
  const Vec11 step = place - roller.place;
  const double square = step.squaredNorm();
  if (roller.placed && roller.by_u && square > kMinUpdateStep * kMinUpdateStep) {
    const Vec11 missing = values(there) - values(roller.action) - roller.D * step;
    if (missing.allFinite()) roller.D += missing * (step.transpose() / square);
  }
  roller.action = there;
  roller.place = place;
  roller.placed = true;
}

/// Differences at the last evaluation over u, and over q if `with_race`.
/// @param central both ways, with longer steps: their error is of second order
void differentiate(const FrictionSet& set, FrictionRoller& roller, const Vec5& q,
                   const Races<double>& races, bool with_race, bool central) {
  constexpr double kCentralStepFactor = 10.0;
  const Vec11 here = values(roller.action);
  const auto slope = [&](double step, const auto& at) {
    if (!central) return Vec11((values(at(step)) - here) / step);
    step *= kCentralStepFactor;
    return Vec11((values(at(step)) - values(at(-step))) / (2.0 * step));
  };
  for (Eigen::Index k = 0; k < 6; ++k)
    roller.D.col(k) = slope(kDifference[k], [&](double step) {
      Vec6 moved = roller.u;
      moved[k] += step * set.forces.units()[k];
      return evaluate(set, roller, moved, races);
    });
  roller.by_u = true;
  if (!with_race) return;
  const Vec5 units = race_units(set);
  for (Eigen::Index k = 0; k < 5; ++k)
    roller.D.col(6 + k) = slope(kRaceDifference, [&](double step) {
      Vec5 moved = q;
      moved[k] += step * units[k];
      return evaluate(set, roller, roller.u, races_of(set, moved), &roller.action);
    });
  roller.by_q = true;
}

/// Moves a roller from its last evaluation into balance between races held in place, to rates of
/// `accuracy`.
bool find_balance(const FrictionSet& set, FrictionRoller& roller, const Vec5& q,
                  const Races<double>& races, double accuracy) {
  constexpr double kMinFirstRates = 1e-2, kSlowRatio = 0.3, kRounding = 1e-8;
  constexpr int kMaxSlowSteps = 2;
  const double target = std::max(accuracy, kBalanceTolerance);
  double size = roller.action.rates.norm();
  const double first = std::max(size, kMinFirstRates);
  int slow = 0;
  for (int n = 0; n < kMaxRollerSteps && size > target; ++n) {
    if (!std::isfinite(size) || roller.left <= 0) return false;
    const bool fresh = !roller.by_u;
    if (fresh) {
      differentiate(set, roller, q, races, false, false);
      slow = 0;
    }
    const auto d = pseudo_time_step<6>(roller.J(), roller.action.rates, size / first, kMaxStep);
    if (!d) return false;
    const FrictionRoller here = roller;
    Vec6 step = d->cwiseProduct(set.forces.units());
    move_to(set, roller, here.u + step, q, races);
    double next = roller.action.rates.norm();
    // Traction that saturates: shorter where the rates grow, and on in any case.
    for (int cut = 0; cut < kMaxRollerStepCuts && fresh && !(next < size); ++cut) {
      step *= 0.5;
      move_to(set, roller, here.u + step, q, races);
      next = roller.action.rates.norm();
    }
    const bool back = (size <= kRounding || !fresh) && !(next < size);
    if (back) {
      const int left = roller.left;
      roller = here;
      roller.left = left;
      if (size <= kRounding) break;
      roller.by_u = false;
      continue;
    }
    slow = next < kSlowRatio * size ? 0 : slow + 1;
    roller.by_u = slow < kMaxSlowSteps;
    size = next;
  }
  return size <= std::max(accuracy, kAcceptedRates);
}

/// du/dq, and what the roller adds to load and stiffness of the race. With `last_step` its step
/// below the accuracy is taken without being evaluated.
bool add_balanced(const FrictionSet& set, bool last_step, FrictionRoller& roller, RaceLoad& sum) {
  Mat6 right;
  right << (last_step ? roller.action.rates : Vec6::Zero()), roller.D.topRightCorner<6, 5>();
  const Mat6 moved = -roller.J().partialPivLu().solve(right);
  if (!moved.allFinite()) return false;
  const Vec5 units = race_units(set);
  const auto load_by_u = roller.D.bottomLeftCorner<5, 6>();
  const Mat65 scaled = moved.rightCols<5>();
  roller.u += moved.col(0).cwiseProduct(set.forces.units());
  roller.follow = set.forces.units().asDiagonal() * scaled * units.cwiseInverse().asDiagonal();
  sum.load += roller.action.load + load_by_u * moved.col(0);
  sum.stiffness +=
      (roller.D.bottomRightCorner<5, 5>() + load_by_u * scaled) * units.cwiseInverse().asDiagonal();
  sum.largest_contact =
      std::max({sum.largest_contact, roller.action.race[0], roller.action.race[1]});
  return true;
}

/// Moves a roller on with the race: to the better place of those with and without its speeds, which
/// do not follow where traction saturates.
void follow(const FrictionSet& set, FrictionRoller& roller, const Vec5& change, const Vec5& q,
            const Races<double>& races) {
  constexpr double kMaxFollowRates = 3e-3;
  Vec6 shift = roller.follow * change;
  const Vec6 over = shift.cwiseAbs().cwiseQuotient(set.forces.units().cwiseProduct(kMaxStep));
  if (!(over.head<4>().maxCoeff() <= 1.0)) shift.setZero();
  if (!(over.tail<2>().maxCoeff() <= 1.0)) shift.tail<2>().setZero();
  const Vec6 from = roller.u;
  move_to(set, roller, from + shift, q, races);
  if (!(roller.action.rates.norm() > kMaxFollowRates) || shift.tail<2>().isZero(0.0)) return;
  const FrictionRoller whole = roller;
  shift.tail<2>().setZero();
  move_to(set, roller, from + shift, q, races);
  if (whole.action.rates.norm() < roller.action.rates.norm()) roller = whole;
}

bool update_race(const FrictionSet& set, const Vec5& q, FrictionRace& race, double accuracy = 0.0) {
  const RacesAtDisplacement held = races_at_displacement(set.model, q);
  const Races<double> here = races_of(set, q);
  const Vec5 change = q - race.q;
  RaceLoad sum;
  for (FrictionRoller& roller : race.elements) {
    if (!roller.balanced) {
      if (!add_roller(set.model, held, change, 0.0, roller.state, sum)) return false;
      continue;
    }
    follow(set, roller, change, q, here);
    if (set.fresh) roller.by_u = roller.by_q = false;
    bool found = find_balance(set, roller, q, here, accuracy);
    if (found && !(roller.by_u && roller.by_q))
      differentiate(set, roller, q, here, !roller.by_q, set.central);
    found = found && add_balanced(set, accuracy > 0.0, roller, sum);
    if (!found) {
      if (set.lost != nullptr) set.lost->push_back(roller.state.number);
      return false;
    }
  }
  race.load = sum.load;
  race.stiffness = sum.stiffness;
  race.largest_contact = sum.largest_contact;
  race.q = q;
  return true;
}

/// Load and stiffness of the race with derivatives of its place.
bool differentiate_race(const FrictionSet& set, FrictionRace& race) {
  for (FrictionRoller& roller : race.elements) roller.by_u = roller.by_q = false;
  FrictionSet exact = set;
  exact.central = true;
  return update_race(exact, Vec5(race.q), race);
}

bool is_carrying(const StaticRoller& roller, double largest) {
  return std::min(roller.race[0].load, roller.race[1].load) > kMinLoadRatio * largest;
}

/// The rule of unloaded rollers, and those that friction does not keep.
bool is_balance(const FrictionRoller& roller) {
  if (!(roller.action.race[0] > 0.0) || !(roller.action.race[1] > 0.0)) return false;
  const double skew = std::abs(roller.u[kPlaceSkew]);
  constexpr double kNoSkew = 1e-9;
  return skew <= kLargestSkew &&
         (skew <= kNoSkew || !(condensed_slope<6>(roller.J(), kPlaceSkew) > 0.0));
}

Vec6 without_friction(const RollerModel& m, const RollerState& roller) {
  Vec6 u;
  u << roller.e(0), 0.5 * m.rollers.pitch_diameter + roller.e(1),
      roller.e(2) - m.rollers.axis_angle, 0.0, m.speeds.spin, m.speeds.orbital;
  return u;
}

/// Balances at the place of the race without friction, one roller after the other.
void find_first_balances(const FrictionSet& set, const RollerSolution& solution,
                         FrictionRace& race) {
  const Races<double> races = races_of(set, race.q);
  Vec6 ahead = Vec6::Zero();  // of the roller before
  const FrictionRoller* before = nullptr;
  for (std::size_t k = 0; k < race.elements.size(); ++k) {
    FrictionRoller& roller = race.elements[k];
    const StaticRoller& at = solution.rollers[k];
    if (!is_carrying(at, solution.max_load)) continue;
    const bool flanged = std::any_of(at.flange.begin(), at.flange.end(), [](const auto& of_race) {
      return of_race[0].load > 0.0 || of_race[1].load > 0.0;
    });
    roller.axial = !set.model.grips || flanged;
    const Vec6 plain = without_friction(set.model, roller.state);
    if (before != nullptr && before->axial == roller.axial) {
      move_to(set, roller, plain + ahead, race.q, races);
      roller.D = before->D;
      roller.by_u = true;
      roller.balanced = find_balance(set, roller, race.q, races, kFirstTolerance);
    }
    if (!roller.balanced) {
      move_to(set, roller, plain, race.q, races);
      roller.by_u = false;
      roller.balanced = find_balance(set, roller, race.q, races, kFirstTolerance);
    }
    if (!roller.balanced) continue;
    ahead = roller.u - plain;
    before = &roller;
  }
}

StaticRoller report(const FrictionSet& set, FrictionRoller& roller, const Vec5& q) {
  const RollerModel& m = set.model;
  if (!roller.balanced) return report_roller(m, q, roller.state);
  roller.state.e = {roller.u[kPlaceX], roller.u[kPlaceR] - 0.5 * m.rollers.pitch_diameter,
                    roller.u[kPlaceTilt] + m.rollers.axis_angle};
  roller.state.skew_sin = std::sin(roller.u[kPlaceSkew]);
  roller.state.skew_cos = std::cos(roller.u[kPlaceSkew]);
  roller.state.follow = roller.follow.topRows<3>();
  StaticRoller out = report_roller(m, q, roller.state);
  out.skew = roller.u[kPlaceSkew];
  out.spin_speed = roller.u[kPlaceSpin];
  out.orbital_speed = roller.u[kPlaceOrbit];
  out.balanced = true;
  out.heat = roller.action.heat;
  return out;
}

}  // namespace

std::vector<Finding> RollerFrictionBalance::findings() const {
  if (!failure.empty())
    return {make_finding(
        "statics.friction_balance",
        fmt::format(
            "no friction equilibrium was found: {}. The rollers are assumed to have no skew and to "
            "roll without slip at their nominal geometry",
            failure))};
  if (left.empty()) return {};
  std::vector<std::size_t> numbers;
  for (const std::size_t k : left) numbers.push_back(k + 1);
  return {make_finding(
              "statics.friction_balance",
              fmt::format("{}: no stable friction equilibrium was found; position, loads and heat "
                          "are those without skew",
                          number_list(numbers, "roller")))
              .of(fmt::format("roller {}", numbers.front()))};
}

bool has_friction_balance(const Bearing& bearing, const RollerOptions& options) {
  if (!bearing.rollers() || !options.friction_balance) return false;
  const auto& rollers = *bearing.rollers();
  const bool resists =
      bearing.lubrication || tribology::max_traction_coefficient(bearing.race_traction) > 0.0;
  const bool held =
      bearing.type != bearing::Type::Spherical || rollers.has_flange(0) || rollers.has_flange(1);
  return resists && held && bearing.speed[0] != bearing.speed[1] &&
         options.contact == RollerContact::Sliced && options.kinematics == RollerKinematics::Exact;
}

bool solve_roller_friction_balance(const Bearing& bearing, const RollerOptions& options,
                                   const RollerModel& model, const RaceLoadCase& task,
                                   const RollerRace& without, RollerSolution& out) {
  if (!(out.max_load > 0.0)) return false;
  out.friction.computed = true;
  const RollerMotionForces forces(bearing, model, out.max_load);
  std::vector<std::size_t> lost;
  FrictionSet set{model, forces, &lost};
  FrictionRace race;
  race.q = without.q;
  for (const RollerState& roller : without.elements) race.elements.emplace_back().state = roller;
  find_first_balances(set, out, race);
  std::vector<bool> asked;
  for (const StaticRoller& roller : out.rollers) asked.push_back(is_carrying(roller, out.max_load));
  int iterations = 0;
  bool settled = false;
  RaceSolveResult solve;
  for (int pass = 0; pass < kMaxPasses && !settled; ++pass) {
    FrictionRace trial = race;
    lost.clear();
    solve = solve_race(set, task, trial, 1e-11);
    iterations += solve.iterations;
    if (solve.converged) {
      lost.clear();  // on the way
      if (!differentiate_race(set, trial) && lost.empty()) break;
      for (std::size_t k = 0; k < trial.elements.size(); ++k)
        if (lost.empty() && trial.elements[k].balanced && !is_balance(trial.elements[k]))
          lost.push_back(k);
      settled = lost.empty();
    } else if (lost.empty()) {
      if (set.fresh) break;
      set.fresh = true;
      continue;
    }
    for (const std::size_t k : lost) race.elements[k].balanced = false;
    if (settled) race = std::move(trial);
  }
  if (!settled) {
    out.friction.failure = "the bearing has no equilibrium with the friction forces";
    return false;
  }
  for (std::size_t k = 0; k < race.elements.size(); ++k) {
    if (asked[k] && !race.elements[k].balanced) out.friction.left.push_back(k);
    out.rollers[k] = report(set, race.elements[k], race.q);
  }
  for (std::size_t k = 0; k < 5; ++k) {
    out.displacement[k] = race.q(static_cast<Eigen::Index>(k));
    out.load[k] = race.load(static_cast<Eigen::Index>(k));
  }
  out.stiffness = race.stiffness;
  out.iterations += iterations;
  out.residual = solve.residual;
  out.max_load = out.max_stiffness = out.max_deflection = 0.0;
  fill_summary(out);
  if (options.difference_share > 0.0)
    add_difference_stiffness(set, race, options.difference_share, out);
  return true;
}

}  // namespace adore::statics
