#pragma once

#include "statics/ball_race.hpp"

#include <Eigen/Core>

#include <vector>

/// Balls whose tractions depend on the contacts of other balls, too (spin_lag.hpp), as an element
/// set of race_equilibrium.hpp.
///
/// Tractions t_k = (f_o, f_i, ω_m) of ball k are known to first order over the contacts s_l of all
/// balls, t = t0 + T (s - s0). The blocks T_kk are the slopes of LinearizedTractions. The others
/// change its values until the places of all balls stay (they are small: contacts are much stiffer
/// than tractions). The stiffness has all blocks [derived]: with the forces F_k(y_k, q, t_k) on
/// ball k at y_k = (x, r) and its contacts s_k(y_k, q),
///   F_y dy_k + F_t Σ_l≠k T_kl (s_y dy_l + s_q dq) + F_q dq = 0
/// for all balls at once, and likewise for the load on the race.
namespace adore::statics {

struct CoupledBalls {
  const BallModel* model = nullptr;
  std::vector<LinearizedTractions>
      start;                  ///< by ball, at s0; values that the slopes T_kk belong to
  std::vector<bool> coupled;  ///< by ball: it has tractions that depend on others
  Eigen::MatrixXd T;          ///< 3 n × 5 n, SI
};

[[nodiscard]] inline RaceScales race_scales(const CoupledBalls& set) {
  return race_scales(*set.model);
}
[[nodiscard]] inline double reference_stiffness(const CoupledBalls& set, double load) {
  return reference_stiffness(*set.model, load);
}
[[nodiscard]] inline bool is_conservative(const CoupledBalls&) { return false; }
[[nodiscard]] inline double initial_accuracy(const CoupledBalls&) { return 0.0; }
/// False also where the values do not settle.
[[nodiscard]] bool update_race(const CoupledBalls& set, const Vec5& q, BallRace& state,
                               double accuracy = 0.0);

}  // namespace adore::statics
