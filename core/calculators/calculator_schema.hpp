#pragma once

#include <nlohmann/json.hpp>

#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

/// Schema of the calculators: resources/calculators.json, by family. `inputs` describes every input
/// once, `results` every result, `kinds` every kind of calculation. The gate, `--describe`, the
/// page of the documentation and the Python module read nothing else.
///
/// Paths: "body1.E", "lands[].race", "Qi[]" (each item of a list).
/// Keys of an input:
///   type     number | whole number | code | name (of a table that the calculator looks up) |
///            label (describes, does not act) | true or false
///   range    "[a, b]", "(a, b]": bounds of a number in its unit; a round bracket excludes the end
///   nonzero  true: 0 is not in the range
///   values   the only numbers allowed
///   codes    texts allowed, in any case; of a number, texts allowed instead of it
///   null     meaning of null; without it null is rejected
///   length   length of a list: a number, the path of a number, or the path of another list
///   default  value used when the input is not given
///   needs    inputs that must be given with this one
///   if       {path: [values]}: the input acts only when the other one has one of these values
/// Keys of a kind:
///   runs     kind that the adapter knows; aliases: older names that are still accepted
///   when     {path: [codes]}: codes that select this kind
///   required, optional, one_of (exactly one of each group), results, example
///   inputs   inputs that mean something else in this kind than in the family
namespace adore::calculators {

struct ValueRange {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false, high_open = false, nonzero = false;
  [[nodiscard]] bool contains(double value) const;  ///< false for NaN
  [[nodiscard]] std::string text() const;           ///< "above 0, up to 0.5"
};

/// Parses "[a, b)". @throws InternalError on other text: the schema is part of the program
[[nodiscard]] ValueRange parse_range(std::string_view text);

using Condition = std::map<std::string, std::vector<nlohmann::json>>;

struct SchemaInput {
  std::string name, type, unit, meaning;
  ValueRange range;
  std::vector<double> values;
  std::vector<std::string> codes;
  std::optional<std::string> null_meaning;
  nlohmann::json length;         ///< null, a number or a path
  nlohmann::json default_value;  ///< null when there is none
  std::vector<std::string> needs;
  Condition only_if;
  /// "number above 0 [m] or \"inf\"": what a value must be
  [[nodiscard]] std::string value_text() const;
};

struct SchemaResult {
  std::string name, unit, meaning;
  ValueRange range;
};

struct SchemaKind {
  std::string name, runs;
  std::vector<std::string> aliases;
  Condition when;
  std::vector<std::string> required, optional;
  std::vector<std::vector<std::string>> one_of;
  std::vector<std::string> results;
  nlohmann::ordered_json example;
  std::vector<SchemaInput> inputs;  ///< all that it takes, in the order of the family
  [[nodiscard]] const SchemaInput* find(std::string_view name) const;
};

struct SchemaFamily {
  std::vector<SchemaInput> inputs;
  std::vector<SchemaResult> results;
  std::vector<SchemaKind> kinds;
};

/// Null for a family of reference cases that is not described.
[[nodiscard]] const SchemaFamily* family_schema(std::string_view family);

/// Kinds of a calculator: all of its family, or those that its adapter kind runs.
[[nodiscard]] std::vector<const SchemaKind*> calculation_kinds(const SchemaFamily& family,
                                                               std::string_view adapter_kind);

/// "did you mean a, b?" for a misspelled name, or all names when none is near.
[[nodiscard]] std::string spelling_suggestion(std::string_view wrong,
                                              const std::set<std::string>& names,
                                              std::string_view plural);

}  // namespace adore::calculators
