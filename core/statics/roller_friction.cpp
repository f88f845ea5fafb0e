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
using Mat56 = Eigen::Matrix<double, 5, 6>;

constexpr int kSteps = 80, kCuts = 4, kPasses = 8;
/// Residuals that the search for one roller may take in all.
constexpr int kResiduals = 4000;
/// Rates: where steps end, and what is taken where rounding ends them.
constexpr double kBalanced = 1e-11, kAccepted = 1e-8;
/// Differences and longest steps in units of u.
const Vec6 kDifference = (Vec6() << 1e-8, 1e-8, 1e-7, 1e-7, 2e-8, 2e-8).finished();
const Vec6 kLongestStep = (Vec6() << 1e-2, 1e-2, 3e-3, 1e-2, 1e-2, 1e-2).finished();
constexpr double kRaceDifference = 1e-8;  ///< of q, over the lever of the race [roller radii]
constexpr double kLightest = 1e-3;        ///< load of a roller in balance over the largest one

struct FrictionRoller {
  RollerState state;
  Vec6 u = Vec6::Zero();
  Mat6 J = Mat6::Zero();         ///< ∂rates/∂u over units
  Mat65 follow = Mat65::Zero();  ///< du/dq
  bool balanced = false;
  bool known = false;  ///< J
  bool axial = true;   ///< x is free
  int left = kResiduals;
};

/// An element set of race_equilibrium.hpp.
struct FrictionSet {
  const RollerModel& model;
  const RollerMotionForces& forces;
  std::vector<std::size_t>* lost = nullptr;  ///< rollers whose search ended nowhere
};
using FrictionRace = RaceState<FrictionRoller>;

RaceScales race_scales(const FrictionSet& set) { return race_scales(set.model); }
double reference_stiffness(const FrictionSet& set, double load) {
  return reference_stiffness(set.model, load);
}
bool is_conservative(const FrictionSet&) { return false; }
double first_accuracy(const FrictionSet&) { return 0.0; }

RollerMotionAction evaluate(const FrictionSet& set, FrictionRoller& roller, const Vec6& u,
                            const Races<double>& races) {
  --roller.left;
  RollerMotionAction out = set.forces.at(roller.state, u, races);
  if (!roller.axial)
    out.rates[kPlaceX] = (roller.state.e(0) - u[kPlaceX]) / set.forces.units()[kPlaceX];
  return out;
}

/// Differences over u, in its units. @param over_load the same of the load on the race; null: not
/// wanted
void differentiate(const FrictionSet& set, FrictionRoller& roller, const Races<double>& races,
                   const RollerMotionAction& here, Mat56* over_load) {
  for (int k = 0; k < 6; ++k) {
    Vec6 u = roller.u;
    u[k] += kDifference[k] * set.forces.units()[k];
    const RollerMotionAction there = evaluate(set, roller, u, races);
    roller.J.col(k) = (there.rates - here.rates) / kDifference[k];
    if (over_load != nullptr) over_load->col(k) = (there.load - here.load) / kDifference[k];
  }
  roller.known = true;
}

/// Moves a roller into balance between races held in place.
bool find_balance(const FrictionSet& set, FrictionRoller& roller, const Races<double>& races,
                  RollerMotionAction& here) {
  constexpr double kLeastFirst = 1e-2, kFast = 0.1, kSlow = 0.3, kRounding = 1e-8;
  here = evaluate(set, roller, roller.u, races);
  double size = here.rates.norm();
  const double first = std::max(size, kLeastFirst);
  for (int n = 0; n < kSteps && size > kBalanced; ++n) {
    if (!std::isfinite(size) || roller.left <= 0) return false;
    const bool fresh = !roller.known;
    if (fresh) differentiate(set, roller, races, here, nullptr);
    const auto d = flow_step<6>(roller.J, here.rates, size / first, kLongestStep);
    if (!d) return false;
    Vec6 step = d->cwiseProduct(set.forces.units());
    RollerMotionAction next = evaluate(set, roller, roller.u + step, races);
    // Traction that saturates: shorter where the rates grow, and on in any case.
    for (int cut = 0; cut < kCuts && fresh && !(next.rates.norm() < size); ++cut) {
      step *= 0.5;
      next = evaluate(set, roller, roller.u + step, races);
    }
    const double next_size = next.rates.norm();
    if (size <= kRounding && !(next_size < size)) break;
    if (!fresh && !(next_size < kSlow * size)) {  // derivatives of an earlier place
      roller.known = false;
      continue;
    }
    roller.known = next_size < kFast * size;
    roller.u += step;
    here = next;
    size = next_size;
  }
  return size <= kAccepted;
}

Races<double> races_of(const FrictionSet& set, const Vec5& q) {
  return races_at<double>(set.model, q);
}

bool update_race(const FrictionSet& set, const Vec5& q, FrictionRace& race,
                 double /*accuracy*/ = 0.0) {
  const HeldRaces held = held_races(set.model, q);
  const Races<double> here = races_of(set, q);
  const RaceScales scales = race_scales(set);
  const double radius = 0.5 * set.model.rollers.diameter;
  std::array<Races<double>, 5> moved;
  std::array<double, 5> step{};
  for (Eigen::Index k = 0; k < 5; ++k) {
    const auto i = static_cast<std::size_t>(k);
    step[i] = kRaceDifference * radius / (k < 3 ? 1.0 : 0.1 * scales.lever);
    Vec5 there = q;
    there(k) += step[i];
    moved[i] = races_of(set, there);
  }
  const Vec5 change = q - race.q;
  RaceLoad sum;
  for (FrictionRoller& roller : race.elements) {
    if (!roller.balanced) {
      if (!add_roller(set.model, held, change, 0.0, roller.state, sum)) return false;
      continue;
    }
    const Vec6 shift = roller.follow * change;
    if ((shift.array().abs() <= kLongestStep.array() * set.forces.units().array()).all())
      roller.u += shift;
    RollerMotionAction at;
    if (!find_balance(set, roller, here, at)) {
      if (set.lost != nullptr) set.lost->push_back(roller.state.number);
      return false;
    }
    Mat56 load_by_u;
    differentiate(set, roller, here, at, &load_by_u);
    Mat65 rates_by_q;
    Mat5 load_by_q;
    for (Eigen::Index k = 0; k < 5; ++k) {
      const auto i = static_cast<std::size_t>(k);
      const RollerMotionAction there = evaluate(set, roller, roller.u, moved[i]);
      rates_by_q.col(k) = (there.rates - at.rates) / step[i];
      load_by_q.col(k) = (there.load - at.load) / step[i];
    }
    const Mat65 scaled = -roller.J.partialPivLu().solve(rates_by_q);
    if (!scaled.allFinite()) return false;
    roller.follow = set.forces.units().asDiagonal() * scaled;
    sum.load += at.load;
    sum.stiffness += load_by_q + load_by_u * scaled;
    sum.largest_contact = std::max({sum.largest_contact, at.race[0], at.race[1]});
  }
  race.load = sum.load;
  race.stiffness = sum.stiffness;
  race.largest_contact = sum.largest_contact;
  race.q = q;
  return true;
}

bool carries(const StaticRoller& roller, double largest) {
  return std::min(roller.race[0].load, roller.race[1].load) > kLightest * largest;
}

/// The rule of unloaded rollers, and those that friction does not keep.
bool is_balance(const FrictionSet& set, FrictionRoller& roller, const Vec5& q) {
  const RollerMotionAction at = evaluate(set, roller, roller.u, races_of(set, q));
  if (!(at.race[0] > 0.0) || !(at.race[1] > 0.0)) return false;
  const double skew = std::abs(roller.u[kPlaceSkew]);
  constexpr double kStays = 1e-9;
  return skew <= kLargestSkew &&
         (skew <= kStays || !(slope_with_others<6>(roller.J, kPlaceSkew) > 0.0));
}

Vec6 without_friction(const RollerModel& m, const RollerState& roller) {
  Vec6 u;
  u << roller.e(0), 0.5 * m.rollers.pitch_diameter + roller.e(1),
      roller.e(2) - m.rollers.axis_angle, 0.0, m.speeds.spin, m.speeds.orbital;
  return u;
}

/// Balances at the place of the race without friction, one roller after the other.
void find_first(const FrictionSet& set, const RollerSolution& solution, FrictionRace& race) {
  const Races<double> races = races_of(set, race.q);
  Vec6 ahead = Vec6::Zero();  // of the roller before
  const FrictionRoller* before = nullptr;
  for (std::size_t k = 0; k < race.elements.size(); ++k) {
    FrictionRoller& roller = race.elements[k];
    const StaticRoller& at = solution.rollers[k];
    if (!carries(at, solution.max_load)) continue;
    const bool flanged = std::any_of(at.flange.begin(), at.flange.end(), [](const auto& of_race) {
      return of_race[0].load > 0.0 || of_race[1].load > 0.0;
    });
    roller.axial = !set.model.grips || flanged;
    const Vec6 plain = without_friction(set.model, roller.state);
    RollerMotionAction action;
    if (before != nullptr && before->axial == roller.axial) {
      roller.u = plain + ahead;
      roller.J = before->J;
      roller.known = true;
      roller.balanced = find_balance(set, roller, races, action);
    }
    if (!roller.balanced) {
      roller.u = plain;
      roller.known = false;
      roller.balanced = find_balance(set, roller, races, action);
    }
    if (!roller.balanced) continue;
    ahead = roller.u - plain;
    before = &roller;
  }
}

StaticRoller report(const FrictionSet& set, FrictionRoller& roller, const Vec5& q) {
  const RollerModel& m = set.model;
  if (!roller.balanced) return report_roller(m, q, roller.state);
  const RollerMotionAction at = evaluate(set, roller, roller.u, races_of(set, q));
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
  out.heat = at.heat;
  return out;
}

}  // namespace

std::string RollerFriction::note() const {
  if (!failure.empty())
    return fmt::format(
        "friction is not in balance: {}; rollers have no skew and roll by their "
        "nominal geometry",
        failure);
  if (left.empty()) return {};
  std::vector<std::size_t> numbers;
  for (const std::size_t k : left) numbers.push_back(k + 1);
  return fmt::format(
      "{}: no stable friction equilibrium was found; place, loads and heat are those without skew",
      number_list(numbers, "roller"));
}

bool has_friction_balance(const Bearing& bearing, const RollerOptions& options) {
  if (!bearing.rollers() || !options.friction_balance) return false;
  const auto& rollers = *bearing.rollers();
  const bool resists =
      bearing.lubrication || tribology::largest_traction(bearing.race_traction) > 0.0;
  const bool held =
      bearing.type != bearing::Type::Spherical || rollers.has_flange(0) || rollers.has_flange(1);
  return resists && held && bearing.speed[0] != bearing.speed[1] &&
         options.contact == RollerContact::Sliced && options.kinematics == RollerKinematics::Exact;
}

bool balance_rollers(const Bearing& bearing, const RollerOptions& options, const RollerModel& model,
                     const RaceTask& task, const RollerRace& without, RollerSolution& out) {
  if (!(out.max_load > 0.0)) return false;
  out.friction.computed = true;
  const RollerMotionForces forces(bearing, model, out.max_load);
  std::vector<std::size_t> lost;
  const FrictionSet set{model, forces, &lost};
  FrictionRace race;
  race.q = without.q;
  for (const RollerState& roller : without.elements) race.elements.push_back({roller});
  find_first(set, out, race);
  std::vector<bool> asked;
  for (const StaticRoller& roller : out.rollers) asked.push_back(carries(roller, out.max_load));
  int iterations = 0;
  bool settled = false;
  RaceSolve solve;
  for (int pass = 0; pass < kPasses && !settled; ++pass) {
    FrictionRace trial = race;
    lost.clear();
    solve = solve_race(set, task, trial, 1e-11);
    iterations += solve.iterations;
    if (solve.converged) {
      lost.clear();  // on the way
      for (std::size_t k = 0; k < trial.elements.size(); ++k)
        if (trial.elements[k].balanced && !is_balance(set, trial.elements[k], trial.q))
          lost.push_back(k);
      settled = lost.empty();
    } else if (lost.empty()) {
      break;
    }
    for (const std::size_t k : lost) race.elements[k].balanced = false;
    if (settled) race = std::move(trial);
  }
  if (!settled) {
    out.friction.failure = "no equilibrium of the bearing was found with its friction";
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
