#pragma once

#include "dynamics/prescribed_races.hpp"
#include "results/quantities.hpp"
#include "scene/plan.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

/// What FINAL and MASTER hold of the races beside the state (dynamics/prescribed_races.hpp).
namespace adore::facade {

void keep_races(const dynamics::PrescribedRaces& races, std::map<std::string, double>& out);

/// Nothing when the file is older than such entries.
[[nodiscard]] std::optional<dynamics::PrescribedRaces> kept_races(
    const std::map<std::string, double>& from);

/// A sentence for each race that is put elsewhere at once where a run goes on: under another load,
/// or because a law of the time (records 9.3 and 9.4) goes by the time since the start of the files
/// and another frequency is another phase there. Of a race along directions in which it moves
/// freely the state is kept, and nothing is said.
/// @param moved the elements moved with the races (new_equilibrium.hpp): a new place is no impact
[[nodiscard]] std::vector<std::string> jumps_of_races(const dynamics::PrescribedRaces& before,
                                                      const dynamics::PrescribedRaces& now,
                                                      const scene::ScenePlan& plan,
                                                      results::UnitSystem units, bool moved);

}  // namespace adore::facade
