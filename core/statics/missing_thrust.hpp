#pragma once

#include "base/errors.hpp"

#include <string>
#include <utility>

namespace adore::statics {

/// The row has less thrust than its rollers turn its radial load into: no numerics can find an
/// equilibrium, the loads are to be mended.
class MissingThrust : public SolverError {
 public:
  MissingThrust(std::string why, std::string remedy)
      : SolverError(why + "; " + remedy), why_(std::move(why)), remedy_(std::move(remedy)) {}
  [[nodiscard]] const std::string& why() const noexcept { return why_; }
  [[nodiscard]] const std::string& remedy() const noexcept { return remedy_; }

 private:
  std::string why_, remedy_;
};

}  // namespace adore::statics
