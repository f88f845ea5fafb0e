#pragma once

#include "statics/race_equilibrium.hpp"
#include "statics/race_result.hpp"

#include <optional>

/// Stiffness of the inner race by displacing it a little, as the classic table does it: a check of
/// the exact linearisation that a user can see, and a secant where the contact law bends.
namespace adore::statics {

struct DifferenceStiffness {
  double step = 0.0;              ///< displacement either way; rotations: this over the lever [m]
  Mat5 stiffness = Mat5::Zero();  ///< d load / d displacement [N/m, N/rad, N, N m/rad]
};

/// Central differences at the solved state: direction k is moved by ±step, every element finds its
/// equilibrium again, the other directions stay. Error against the linearisation: second order in
/// the step, first order where an element touches or leaves within it. Nothing when an element has
/// no equilibrium there.
template <class Set, class State>
std::optional<DifferenceStiffness> difference_stiffness(const Set& set, const State& solved,
                                                        double step) {
  const RaceScales scales = race_scales(set);
  DifferenceStiffness out;
  out.step = step;
  State moved = solved;
  for (Eigen::Index k = 0; k < 5; ++k) {
    const double h = step / lever_of(scales, k);
    Vec5 load = Vec5::Zero();
    for (const double side : {1.0, -1.0}) {
      Vec5 q = solved.q;
      q(k) += side * h;
      moved = solved;
      if (!update_race(set, q, moved)) return std::nullopt;
      load += side * moved.load;
    }
    out.stiffness.col(k) = load / (2.0 * h);
  }
  return out;
}

/// The same with the step as a share of the largest contact deflection, into the result; nothing
/// happens when no contact is loaded.
template <class Set, class State>
void add_difference_stiffness(const Set& set, const State& solved, double share,
                              RaceResult& result) {
  if (!(share * result.max_deflection > 0.0)) return;
  if (const auto difference = difference_stiffness(set, solved, share * result.max_deflection)) {
    result.stiffness_by_difference = difference->stiffness;
    result.difference_step = difference->step;
  }
}

/// Largest difference between two stiffness matrices over the largest entry of its kind (force or
/// moment row, translation or rotation column), of 0 .. 1 and more.
[[nodiscard]] double stiffness_disagreement(const Mat5& a, const Mat5& b);

}  // namespace adore::statics
