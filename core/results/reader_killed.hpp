#pragma once

#include "base/errors.hpp"

namespace adore::results {

/// A file could not be read for an external reason: its reader's process was killed, did
/// not start, or its disk did not respond. The file may be good; trying again is sensible.
class ReaderKilled : public InputError {
 public:
  using InputError::InputError;
};

}  // namespace adore::results
