#pragma once

#include "user/plug_in.hpp"

#include <filesystem>

/// User routines without a compiler: a JSON file of formulas (muParser) and tables.
///
///   {"version": "my laws 1",
///    "adrx7": {"element_race": {"formula": "0.06*tanh(u/0.2)", "slip_scale": "0.2"},
///              "element_cage": {"table": "kappa.csv"}},
///    "adrx1": {"read": ["A", "f"], "constants": {"w": "2*pi*f"},
///              "outer_race": {"acceleration": ["0", "0", "-A*w^2*sin(w*t)"],
///                             "start_velocity": ["0", "0", "A*w"]}}}
///
/// "read" names numbers that come from records 12.x, "constants" what is formed of them once. All
/// is SI, as in adore_user.h. The page user-routines.md lists what each routine knows.
namespace adore::user {

/// @throws InputError naming file, routine and key
[[nodiscard]] PlugIn load_formulas(const std::filesystem::path& file);

}  // namespace adore::user
