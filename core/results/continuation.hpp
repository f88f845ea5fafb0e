#pragma once

#include "results/growing_file.hpp"

#include <filesystem>
#include <string>
#include <utility>

/// Continuing the classic files of an earlier run (N3).
namespace adore::results {

/// Opens a SOL file for appending after its last step with number <= `last_step`. The file's header
/// must equal `expected_header` but for the program version: another run code, element, layout or
/// unit system stops the run.
/// @throws InputError saying which, with both values.
[[nodiscard]] GrowingFile continue_sol_file(const WritePath& place,
                                            const std::string& expected_header, long last_step);

/// Step and time [s] of the last whole record of a SOL file; zeros when it has none.
/// @throws InputError when there is no such file
[[nodiscard]] std::pair<long, double> last_stored_step(const std::filesystem::path& path);

/// The checks of continue_sol_file() alone; nothing is touched. @throws InputError
void check_sol_file(const std::filesystem::path& path, const std::string& expected_header);

/// Throws unless the run code found in a file is that of the deck. @throws InputError naming both,
/// remedy kIcOpt = -1.
void check_run_id(const std::filesystem::path& path, const std::string& found,
                  const std::string& of_deck);

}  // namespace adore::results
