#pragma once

#include "base/errors.hpp"

namespace adore {

/// A results file cannot be written (any further): not an error of the deck. The run that wrote it
/// reports how to continue.
class WriteError : public InputError {
 public:
  using InputError::InputError;
};

}  // namespace adore
