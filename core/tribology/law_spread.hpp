#pragma once

#include "tribology/laws/contact_point.hpp"

#include <string>
#include <vector>

/// Friction coefficients that the codes of one oil give in the same contact: MIL-L-23699 is
/// described by kTrac 4, 10, 11 and 12, and their laws differ several times at small slip.
namespace adore::tribology {

struct LawSpreadContact {
  ContactConditions<double> point;  ///< slip is not read; of a line per length
  bool line = false;
  double modulus = 0.0;      ///< E' [Pa]
  double temperature = 0.0;  ///< of oil and walls [K]
  double meniscus = 0.0;     ///< strParam
  bool stress_limit = true;  ///< films have their limiting shear stress
};

struct LawSpreadRow {
  int code = 0;
  std::string name;
  bool recommended = false;
  std::vector<double>
      kappa;  ///< one per slip: mean of the strip along rolling at the peak pressure
};

/// One row for each code of the oil of `code`. The film never breaks down here (no metal contact).
/// @param slips [m/s], > 0
[[nodiscard]] std::vector<LawSpreadRow> law_spread(int code, const LawSpreadContact& contact,
                                                   const std::vector<double>& slips);

}  // namespace adore::tribology
