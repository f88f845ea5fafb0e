#pragma once

#include <functional>

/// Common start and end of both programs of the command line.
namespace adore::cli {

/// Keeps the standard streams in order, and turns what `body` throws into a sentence on stderr and
/// an exit code: 2 wrong input, 3 the numerics gave up, 130 interrupted, 1 a bug.
[[nodiscard]] int whole_program(const std::function<int()>& body);

}  // namespace adore::cli
