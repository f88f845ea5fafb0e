#pragma once

#include "base/errors.hpp"

namespace adore::testing {

/// Calls a reader that may reject its input with an InputError. Any other exception is a find.
template <class Read>
void refused_or(Read read) {
  try {
    read();
  } catch (const InputError&) {
  }
}

}  // namespace adore::testing
