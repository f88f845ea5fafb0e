#pragma once

#include "assembly/row_model.hpp"

#include <array>
#include <string>
#include <vector>

/// Equilibrium of a set of rows on one rigid shaft in one rigid housing. SI, frame of the set.
///
/// The shaft has the displacement q = (u_x, u_y, u_z, θ_y, θ_z) at X = 0, R = R_y R_z as in
/// statics/race_result.hpp. With a = R e_x and D = diag(s, 1, 1, s, s), s = ±1 the orientation of
/// the row (a mirror image where it is -1, assembly.hpp), its inner race is displaced by
///   d = D (u + L (a - e_x) + e e_x, θ) + g e_x                                        [derived]
/// L = X_row + s x_P, x_P the reference point of the row's inner race; g its axial offset, e the
/// shift of its ring by elastic spacers. The row answers with its load F(d) (existing statics of
/// its deck: contact laws, speed effects, friction as its options say), and the shaft needs
///   Σ D F = F_set,   Σ (D M + L a × D F) = M_set.
/// Spacers of compliance c_k = 1/k_inner + 1/k_outer between rows k and k + 1, rings clamped
/// against row 1 by a constant force:
///   e_1 = 0,   e_(k+1) - e_k = -c_k Σ_(j>k) (D F)_(x,j).
/// Newton's method (statics/race_equilibrium.hpp) with the stiffness matrix of each row. With
/// friction, that matrix includes the changes of the traction forces.
/// Limits: shaft, housing and rings are rigid; radially, rings do not move by spacers.
namespace adore::assembly {

struct BearingSetRow {
  RowModel model;
  int orientation = 1;
  double position = 0.0;  ///< X of the middle of the row [m]
  double offset = 0.0;    ///< g [m]
};

struct BearingSet {
  std::vector<BearingSetRow> rows;
  std::vector<double> compliance;  ///< c_k [m/N], one less than rows, or empty: rigid
};

using BearingSetState = statics::RaceState<RowState>;

// Functions of an element set for race_equilibrium.hpp.
[[nodiscard]] statics::RaceScales race_scales(const BearingSet& set);
[[nodiscard]] double reference_stiffness(const BearingSet& set, double load);
[[nodiscard]] inline bool is_conservative(const BearingSet&) { return false; }
[[nodiscard]] inline double initial_accuracy(const BearingSet&) { return 0.0; }
[[nodiscard]] bool update_race(const BearingSet& set, const Vec5& q, BearingSetState& state,
                               double accuracy = 0.0);

struct BearingSetSolution {
  BearingSetState state;       ///< elements are the rows; load and stiffness at X = 0
  std::vector<Finding> notes;  ///< directions without support, instability
  int iterations = 0;
  double residual = 0.0;  ///< of the forces over the load
};

/// Displacement or load of each direction given. @param start first guess of q
/// @throws SolverError naming the load and the cause
[[nodiscard]] BearingSetSolution solve_bearing_set(const BearingSet& set,
                                                   const statics::RaceLoadCase& task,
                                                   const Vec5& start = Vec5::Zero());
/// Under this load at X = 0.
[[nodiscard]] BearingSetSolution solve_bearing_set(const BearingSet& set,
                                                   const std::array<double, 5>& load,
                                                   const Vec5& start = Vec5::Zero());

/// Load of the shaft on row k, frame of the set, about the reference point of its inner race.
[[nodiscard]] Vec5 row_load_in_set_frame(const BearingSetRow& row, const RowState& state);
/// Axial load that presses the row: along its own +x [N].
[[nodiscard]] inline double axial_load(const RowState& state) { return state.load(0); }

}  // namespace adore::assembly
