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

/// Runs a program's body and turns exceptions into a sentence on stderr and the suite's exit codes
/// (2 input, 3 numerics, 1 bug).
int guarded(const std::string& program, const std::function<int()>& body);

}  // namespace adore::desktop
