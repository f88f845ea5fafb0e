#include "statics/roller_equilibrium.hpp"

#include "statics/roller_forces.hpp"
#include "statics/roller_step.hpp"
#include "statics/slope_search.hpp"

#include <algorithm>
#include <cmath>

namespace adore::statics {
namespace {

/// A roller in equilibrium.
struct Balance {
  Contacts contacts;
  Eigen::Vector3d rest = Eigen::Vector3d::Zero();  ///< last step, which is left to be taken
};

/// `accuracy`: residual force over the sum of loads from which one more step, not evaluated, is
/// enough; 0: down to rounding.
bool newton(const RollerModel& m, const Races<PlaceDual>& races, double accuracy,
            RollerState& state, Balance& found) {
  constexpr int kMaxIterations = 120;
  const double nothing = m.load_floor;
  Contacts& contacts = found.contacts;
  found.rest.setZero();
  const auto evaluate = [&](const RollerState& at) {
    const auto pose = pose_of(m, at, races);
    contacts = contacts_at(m, at, pose);
    return scaled(m, forces_of(m, at, pose, contacts), contacts);
  };
  ScaledForces now = evaluate(state);
  for (int n = 0; n < kMaxIterations; ++n) {
    const double size = now.force.norm();
    if (!std::isfinite(size)) {
      return false;
    }
    const double k_ref = reference_stiffness(m, std::max(contacts.total, nothing));
    // Rounding of positions of the size of the pitch radius, through the stiffness.
    const double noise = 2e-16 * m.rollers.pitch_diameter * now.stiffness.diagonal().maxCoeff();
    const double rounding = std::max({nothing, noise, 1e-15 * contacts.total});
    if (size <= rounding) {
      return true;
    }
    auto [step, balanced] = roller_step(m, now, k_ref, rounding);
    const double length = step.norm();
    if (balanced) {
      return true;
    }
    if (!std::isfinite(length) || length == 0.0) {
      return false;
    }
    if (size <= accuracy * contacts.total && length <= 1e-2 * m.longest_step) {
      found.rest = unscaled_step(m, step);
      return true;
    }
    if (length > m.longest_step) {
      step *= m.longest_step / length;
    }
    SlopeSearch search(step.dot(now.force), 1e-13);
    RollerState trial = state;
    double t = 1.0;
    bool accepted = false;
    for (int attempt = 0; attempt < 50 && !accepted; ++attempt) {
      t = search.length();
      trial.e = state.e + t * unscaled_step(m, step);
      if (trial.e.head<2>().norm() > 0.5 * m.rollers.diameter || std::abs(trial.e(2)) > 0.5) {
        return false;
      }
      now = evaluate(trial);
      accepted = search.accepts(step.dot(now.force));
    }
    if (!accepted) {
      return size <= 1e-9 * std::max(contacts.total, nothing);
    }
    const bool at_rounding = t * length <= 1e-16 * m.rollers.pitch_diameter;
    state.e = trial.e;
    if (at_rounding) {
      return true;
    }
  }
  return now.force.norm() <= 1e-9 * std::max(contacts.total, nothing);
}

/// Finds the roller's equilibrium. Newton on a convex potential with a line search on the
/// directional derivative; directions that nothing holds or loads stay where they are, loaded ones
/// are walked until something touches. False when there is no equilibrium.
bool solve_roller(const RollerModel& m, const Vec5& q, const Races<PlaceDual>& races,
                  double accuracy, RollerState& state, Balance& found) {
  if (!m.moving) {
    RollerState middle = state;
    middle.e = middle_roller_position(m, state, q);
    found = {contacts_at(m, middle, pose_of(m, middle, races))};
    if (found.contacts.total == 0.0) {
      state.e = middle.e;
      state.idle = true;
      state.known = false;
      return true;
    }
  }
  state.idle = false;
  if (state.known && newton(m, races, accuracy, state, found)) {
    return true;
  }
  const Eigen::Vector3d first = initial_roller_position(m, state, q);
  const Eigen::Vector3d middle = middle_roller_position(m, state, q);
  state.e = first;
  state.known = newton(m, races, accuracy, state, found);
  if (!state.known && first != middle) {
    state.e = middle;
    state.known = newton(m, races, accuracy, state, found);
  }
  return state.known;
}

}  // namespace

void follow_race(const RollerModel& m, const Vec5& change, RollerState& state) {
  const Eigen::Vector3d shift = state.follow * change;
  if (shift.head<2>().norm() + m.lever * std::abs(shift(2)) < m.longest_step) {
    state.e += shift;
  }
}

RaceScales race_scales(const RollerModel& m) {
  return {0.5 * m.rollers.pitch_diameter, m.longest_step, 0.5 * m.rollers.diameter,
          m.rollers.pitch_diameter, m.centrifugal};
}

double reference_stiffness(const RollerModel& m, double load) {
  const double delta = line_approach(m, std::max(load, 1e-300));
  return load > 0.0 ? 10.0 / 9.0 * load / delta : 0.0;
}

RacesAtDisplacement races_at_displacement(const RollerModel& m, const Vec5& q) {
  return {q, races_at<PlaceDual>(m, q), races_at<RollerDual>(m, q)};
}

bool add_roller(const RollerModel& m, const RacesAtDisplacement& races, const Vec5& change,
                double accuracy, RollerState& roller, RaceLoad& sum) {
  if (roller.known) {
    follow_race(m, change, roller);
  }
  Balance found;
  if (!solve_roller(m, races.q, races.held, accuracy, roller, found)) {
    return false;
  }
  Contacts& contacts = found.contacts;
  const auto pose = pose_of(m, roller, races.moved);
  for (std::size_t j = 0; j < 2; ++j) {
    if (contacts.flanges[j].total > 0.0) {
      contacts.flanges[j] =
          flange_potential(m.body(roller.number), j, pose.seen_from[j].values(), true);
    }
  }
  const Forces<RollerDual> forces = forces_of(m, roller, pose, contacts);
  roller.follow = race_following_matrix(m, forces, contacts);
  roller.e += found.rest;
  if (contacts.total == 0.0) {
    return true;
  }
  Eigen::Matrix<double, 5, 3> by_roller;
  for (Eigen::Index i = 0; i < 5; ++i) {
    const RollerDual& load = forces.load[static_cast<std::size_t>(i)];
    sum.load(i) += load.v;
    for (Eigen::Index k = 0; k < 3; ++k) {
      by_roller(i, k) = load.d[static_cast<std::size_t>(k)];
    }
    for (Eigen::Index k = 0; k < 5; ++k) {
      sum.stiffness(i, k) += load.d[static_cast<std::size_t>(k) + 3];
    }
  }
  sum.load += by_roller * found.rest;
  sum.stiffness += by_roller * roller.follow;
  sum.largest_contact = std::max(sum.largest_contact, contacts.largest);
  return true;
}

bool update_race(const RollerModel& m, const Vec5& q, RollerRace& state, double accuracy) {
  const RacesAtDisplacement races = races_at_displacement(m, q);
  const Vec5 change = q - state.q;
  RaceLoad sum;
  for (RollerState& roller : state.elements) {
    if (!add_roller(m, races, change, accuracy, roller, sum)) {
      return false;
    }
  }
  state.load = sum.load;
  state.stiffness = sum.stiffness;
  state.largest_contact = sum.largest_contact;
  state.q = q;
  return true;
}

}  // namespace adore::statics
