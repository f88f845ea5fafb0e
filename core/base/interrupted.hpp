#pragma once

#include <stdexcept>

namespace adore {

/// The user asked for an end before there was anything to keep.
class Interrupted : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace adore
