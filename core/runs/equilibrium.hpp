#pragma once

#include "results/key_results.hpp"
#include "results/static_tables.hpp"
#include "runs/deck_request.hpp"

#include <array>
#include <stop_token>
#include <string>
#include <vector>

/// The quasi-static equilibrium as values, for programs: nothing is written.
namespace adore::runs {

/// SI and radians throughout. Order of the five components: x, y, z, turn about y, turn about z.
struct Equilibrium {
  std::array<double, 5> displacement{};  ///< of the inner race, from where its geometry alone puts
                                         ///< it (decision 140) [m, rad]
  std::array<double, 5> load{};  ///< load of the shaft on the inner race, given or as reaction
                                 ///< [N, N m]
  std::array<std::array<double, 5>, 5> stiffness{};  ///< d load[row] / d displacement[column]
  results::KeyResults results;                       ///< displacements, extremes, fits, heat, lives
  results::StaticTables tables;    ///< those of RUN.json: "elements", "slices", "friction" ...
  std::vector<std::string> lines;  ///< a few sentences in the deck's units, as `adore run` ends
  std::vector<Finding> remarks;    ///< of the deck, and what the equilibrium says of itself
  double seconds = 0.0;            ///< computing time of the solution
};

/// Of any deck: a dynamic one starts from it.
/// @throws InputError, SolverError (no equilibrium), Interrupted.
[[nodiscard]] Equilibrium solve_equilibrium(const DeckRequest& request, std::stop_token stop = {});

struct Prepared;

/// The same of a deck that is prepared already; `remarks` stays empty.
[[nodiscard]] Equilibrium equilibrium_of(const Prepared& prepared);

}  // namespace adore::runs
