#pragma once

#include "base/errors.hpp"
#include "results/sol_file.hpp"

#include <functional>

/// Reading that can be watched and stopped: a gigabyte takes a minute.
namespace adore::results {

/// Told now and then which part of a file is read, 0 to 1; false stops the reading.
using ReadWatch = std::function<bool(double part)>;

/// A watch said stop.
struct ReadStopped : InputError {
  using InputError::InputError;
};

/// As without a watch. @throws ReadStopped
SolFile read_sol(const std::filesystem::path& path, const SolRange& range, const ReadWatch& watch);

}  // namespace adore::results
