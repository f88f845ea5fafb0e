#pragma once

#include <functional>

/// Common start and end of both programs of the command line.
namespace adore::cli {

/// Manages the standard streams, and converts exceptions of `body` to a message on stderr and an
/// exit code: 2 wrong input, 3 numerical failure, 130 interrupted, 1 program error.
[[nodiscard]] int whole_program(const std::function<int()>& body);

}  // namespace adore::cli
