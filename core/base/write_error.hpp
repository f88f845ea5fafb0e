#pragma once

#include "base/errors.hpp"

namespace adore {

/// A file of results cannot be written (any further): no fault of the deck. The run that wrote it
/// says how to go on.
class WriteError : public InputError {
 public:
  using InputError::InputError;
};

}  // namespace adore
