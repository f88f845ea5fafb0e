#pragma once

#include "base/errors.hpp"

namespace adore::results {

/// A file could not be read for a reason that lies outside it: its reader's process was killed, did
/// not start, or its disk did not answer. It says nothing about the file; trying again is sound.
class ReaderKilled : public InputError {
 public:
  using InputError::InputError;
};

}  // namespace adore::results
