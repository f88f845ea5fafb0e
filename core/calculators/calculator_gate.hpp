#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>

/// The one check between a user's inputs and the adapter of a calculator.
namespace adore::calculators {

/// Picks the kind of calculation and checks every input against the schema: known to this kind,
/// used by it, of its type, in its range, a code of its list, of its length, and given when
/// required. Codes are read in any case and passed on as the schema writes them.
/// @param adapter_kind kind that the calculator fixes; empty when the inputs select it
/// @param the_case {"inputs": {...}} and perhaps "kind"
/// @return the case for the adapter; unchanged when the family is not described
/// @throws InputError with one issue per input that is wrong
[[nodiscard]] nlohmann::json check_inputs(std::string_view family, std::string_view adapter_kind,
                                          nlohmann::json the_case);

/// A result that is not finite or outside its physical range comes from inputs that have no
/// meaning together. @throws InputError naming it
void check_results(std::string_view family, std::string_view calculator,
                   const nlohmann::json& results);

}  // namespace adore::calculators
