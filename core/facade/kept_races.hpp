#pragma once

#include "dynamics/prescribed_races.hpp"

#include <map>
#include <optional>
#include <string>

/// What FINAL and MASTER hold of the races beside the state (dynamics/prescribed_races.hpp).
namespace adore::facade {

void keep_races(const dynamics::PrescribedRaces& races, std::map<std::string, double>& out);

/// Nothing when the file is older than such entries.
[[nodiscard]] std::optional<dynamics::PrescribedRaces> kept_races(
    const std::map<std::string, double>& from);

}  // namespace adore::facade
