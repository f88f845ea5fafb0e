#pragma once

#include <nlohmann/json.hpp>

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace adore::calculators {

using Json = nlohmann::json;

/// Runs one reference case: inputs -> results with at least the keys of `expected`. std::nullopt =
/// inputs not understood (not covered).
struct Adapter {
  std::string_view family;  ///< "A_hertz_point"
  std::function<std::optional<Json>(const Json& the_case)>
      run;  ///< gets the whole case object (kind, inputs, expected keys ...)
};

}  // namespace adore::calculators
