#pragma once

#include "assembly/solve_assembly.hpp"
#include "results/static_tables.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

/// Results of an assembly as lines for the terminal, pages of PRINT.txt and members of RUN.json.
namespace adore::assembly {

/// A table of the rows and one line each for displacement, stiffness, preload, unloading and lives.
[[nodiscard]] std::vector<std::string> result_lines(const AssemblyResult& result);
/// PRINT.txt of the set.
[[nodiscard]] std::string assembly_listing(const AssemblyResult& result);
/// "assembly" of RUN.json: arrangement, rows, stiffness matrices, preload, unloading.
[[nodiscard]] nlohmann::ordered_json result_json(const AssemblyResult& result);
/// "quasi_static" of RUN.json: tables "rows", "axial force", "preload".
[[nodiscard]] results::StaticTables result_tables(const AssemblyResult& result);

}  // namespace adore::assembly
