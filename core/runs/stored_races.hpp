#pragma once

#include "dynamics/prescribed_races.hpp"
#include "results/quantities.hpp"
#include "scene/plan.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

/// State of the races in FINAL and MASTER (dynamics/prescribed_races.hpp).
namespace adore::runs {

void store_races(const dynamics::PrescribedRaces& races, std::map<std::string, double>& out);

/// Nothing when the file is older than such entries.
[[nodiscard]] std::optional<dynamics::PrescribedRaces> stored_races(
    const std::map<std::string, double>& from);

/// A sentence for each race that jumps to another position when its run continues: under another
/// load, or because laws of time (records 9.3 and 9.4) count from the start of the files,
/// so that another frequency is another phase. For a race along directions in which it moves
/// freely the state is kept, without a sentence.
/// @param moved the elements moved with the races (new_equilibrium.hpp): no impact
[[nodiscard]] std::vector<std::string> describe_race_jumps(const dynamics::PrescribedRaces& before,
                                                           const dynamics::PrescribedRaces& now,
                                                           const scene::ScenePlan& plan,
                                                           results::UnitSystem units, bool moved);

}  // namespace adore::runs
