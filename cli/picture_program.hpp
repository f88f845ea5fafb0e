#pragma once

#include "cli/picture_commands.hpp"

#include <string>
#include <vector>

/// The drawing program in the same folder: `adore-pictures`.
namespace adore::cli {

/// Whether this build draws pictures.
[[nodiscard]] bool has_pictures() noexcept;

/// Actions that replace the process with that program, with the same command line. Without Qt they
/// throw an InputError. @param argv of main, null-terminated
[[nodiscard]] PictureActions forwarding_actions(char** argv);

/// Starts it with these arguments and waits. @return true if its exit code is 0; false without Qt.
/// @throws InputError if it is not installed.
bool run_picture_program(const std::vector<std::string>& words);

}  // namespace adore::cli
