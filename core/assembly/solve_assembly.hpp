#pragma once

#include "assembly/assembly.hpp"
#include "assembly/preload.hpp"
#include "base/finding.hpp"
#include "deck/deck.hpp"
#include "results/key_results.hpp"
#include "runs/deck_request.hpp"

#include <array>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

/// Quasi-static results of an assembly, as values: nothing is written. SI, frame of the set.
namespace adore::assembly {

struct AssemblyRequest {
  std::filesystem::path folder = ".";  ///< of ASSEMBLY.json, or that file
  /// Deck variables of all rows, in the units of each deck.
  std::vector<std::pair<std::string, std::string>> sets, options;
};

struct RowResult {
  std::string deck;        ///< path from the folder of the assembly
  int orientation = 1;     ///< +1, -1
  double position = 0.0;   ///< X of the middle of the row [m]
  double offset = 0.0;     ///< of its inner ring [m]
  RowState state;          ///< frame of its deck
  Vec5 load;               ///< of the shaft on the row, frame of the set [N, N m]
  results::KeyResults of;  ///< lives, pressures ... of its deck at this displacement
  /// Sets that make its deck that of this row: all displacements given.
  std::vector<std::pair<std::string, std::string>> changes;
};

struct AssemblyResult {
  Assembly assembly;
  std::vector<RowResult> rows;
  BearingSetSolution loaded;    ///< under the load of the assembly
  BearingSetSolution unloaded;  ///< without it, in operation
  bool opposed = false;         ///< rows of both orientations: preload and offset exist
  double offset = 0.0;          ///< of the set [m]
  double preload_unmounted = 0.0, preload_operation = 0.0;  ///< [N]
  std::vector<Unloading> unloading;                         ///< mounted
  std::vector<AxialCurvePoint> curve;                       ///< mounted
  std::vector<PreloadPoint> preload;                        ///< unmounted
  results::KeyResults set;        ///< of the set: same names as of a single bearing
  std::vector<Finding> findings;  ///< of all rows ("row 1: ...") and of the set
  double seconds = 0.0;           ///< computing time
};

/// Points of the curves.
inline constexpr int kCurvePoints = 41, kPreloadPoints = 16;

/// @throws InputError for a wrong file or deck, SolverError without an equilibrium, Interrupted
[[nodiscard]] AssemblyResult solve_assembly(const AssemblyRequest& request,
                                            std::stop_token stop = {});

/// The request for the deck of row k (from 0) as the user wrote it.
[[nodiscard]] runs::DeckRequest row_request(const AssemblyRequest& request,
                                            const Assembly& assembly, std::size_t k);
/// Values of a deck that hold the inner ring at `own` [m, rad], as `system` has them.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> prescribed_displacement_sets(
    const Vec5& own, deck::UnitSystem system);
/// Errors of a row's deck that only an assembly has. @throws InputError
void check_row_deck(const deck::Deck& deck, std::size_t k);

}  // namespace adore::assembly
