#pragma once

#include <functional>
#include <string>

/// Common to the command lines of the apps and of the drawing program.
namespace adore::desktop {

struct PictureSize {
  int width = 1280, height = 800;
};

/// "1280x800". @throws InputError unless both are between 160 and 8192.
PictureSize parse_size(const std::string& text);

/// Runs the body of a program and converts exceptions to a message on stderr and the exit codes of
/// the suite (2 input, 3 numerics, 1 bug).
int run_guarded(const std::string& program, const std::function<int()>& body);

}  // namespace adore::desktop
