#pragma once

#include "base/find_values.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Question and answer of an inverse calculation, as text and JSON.
namespace adore {

struct FindUnknown {
  std::string name, unit;  ///< the unit is that of the bounds
  double first = 0.0, last = 0.0;
};

struct FindTarget {
  std::string name, unit;
  Relation relation = Relation::Equal;
  double value = 0.0;  ///< unused by Least and Largest
};

/// Reads "appLoadX=10:2000". @throws InputError
[[nodiscard]] FindUnknown parse_unknown(std::string_view text);
/// Reads "NAME=5", "NAME>=5", "NAME<=5", "NAME=least", "NAME=largest". @throws InputError
[[nodiscard]] FindTarget parse_target(std::string_view text);
/// Reads "10:2000". @throws InputError that begins with `what`
[[nodiscard]] std::pair<double, double> parse_bounds(std::string_view what, std::string_view text);

/// Message for an unknown name: "there is no result X; did you mean Y?", or all names.
[[nodiscard]] std::string unknown_name_message(std::string_view kind, std::string_view name,
                                               const std::vector<std::string>& known);

struct FindReport {
  std::string source;  ///< deck or calculator
  FindUnknown unknown;
  FindTarget target;
  FindOutcome outcome;
};

/// "one", "not_monotonic", "many", "everywhere", "none", "not_computed"
[[nodiscard]] std::string_view answer_keyword(FindAnswer answer);
/// 0 one solution, 1 none, 3 not computed, 4 many or everywhere, 5 not monotonic
[[nodiscard]] int answer_exit_code(FindAnswer answer);

/// The question: "appLoadX from 1 to 2000 N: least_element_load_N = 0 N".
[[nodiscard]] std::string question_text(const FindReport& report);
/// The answer in sentences, one a line.
[[nodiscard]] std::vector<std::string> answer_lines(const FindReport& report);
/// The key "solution" exists only with one solution, "solutions" only with more, "best" only with
/// none.
[[nodiscard]] nlohmann::ordered_json find_report_json(const FindReport& report);

}  // namespace adore
