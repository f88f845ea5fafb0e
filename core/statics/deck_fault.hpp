#pragma once

#include "base/errors.hpp"

#include <string>
#include <utility>

namespace adore::statics {

/// Value of the deck for which there is no solution: `runs` converts it to an InputError with
/// record and line.
class DeckFault : public SolverError {
 public:
  /// @param variable of the deck, that the fault is told of
  DeckFault(std::string variable, std::string why, std::string remedy)
      : SolverError(why + "; " + remedy),
        variable_(std::move(variable)),
        why_(std::move(why)),
        remedy_(std::move(remedy)) {}
  [[nodiscard]] const std::string& variable() const noexcept { return variable_; }
  [[nodiscard]] const std::string& why() const noexcept { return why_; }
  [[nodiscard]] const std::string& remedy() const noexcept { return remedy_; }

 private:
  std::string variable_, why_, remedy_;
};

}  // namespace adore::statics
