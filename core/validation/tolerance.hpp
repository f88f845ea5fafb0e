#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string_view>

namespace adore::validation {

/// How one expected quantity is compared.
struct ToleranceRule {
  double relative = 0.0, absolute = 0.0;
  /// Size that `relative` refers to.
  enum class Scale : unsigned char {
    Entry,     ///< each number separately
    Channel,   ///< the largest magnitude of the whole array
    Diagonal,  ///< matrix: √(K_ii K_jj)
    Norm       ///< array of vectors: the length of each innermost vector
  } scale = Scale::Entry;
  double period = 0.0;  ///< > 0: values are equal modulo this
  bool ignore = false;  ///< never compared: notes, residuals
  bool strings = true;  ///< strings must match; otherwise they are comments
};

/// The rule for the key (last part of `path`, e.g. "steady_state.Q_o") of one case, by the README
/// of its family.
[[nodiscard]] ToleranceRule tolerance_rule(std::string_view family, std::string_view path,
                                           const nlohmann::json& the_case);

}  // namespace adore::validation
