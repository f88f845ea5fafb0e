#pragma once

#include "base/find_report.hpp"
#include "runs/deck_request.hpp"

#include <functional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

/// Inverse calculation on a deck: values of one input at which a result of the equilibrium meets a
/// target (base/find_values.hpp).
namespace adore::design {

struct FindRequest : runs::DeckRequest {
  /// A deck variable as --set writes it, in the deck's units, or a run option.
  FindUnknown unknown;
  /// A key result of the equilibrium (results/key_results.cpp), in the unit of its name.
  FindTarget target;
  int points = 41;  ///< of the scan
};

/// @param computed called after each equilibrium with their number; may be empty
/// @throws InputError for unknown names, an unknown that this deck does not use, or a result that
/// it does not have; SolverError; Interrupted
[[nodiscard]] FindReport find_in_deck(const FindRequest& request, std::stop_token stop = {},
                                      const std::function<void(int)>& computed = {});

/// Can be a target: id, unit, meaning.
struct FindResultInfo {
  std::string id, unit, meaning;
};
[[nodiscard]] std::vector<FindResultInfo> find_results();

/// Common question with its unknown and target.
struct FindQuestion {
  std::string_view name;
  std::string_view meaning;     ///< what is found
  std::string_view calculator;  ///< it asks a component calculator; empty: a deck
  std::string_view unknown;
  std::string_view target;
  std::string_view value;  ///< of the target; empty: the user gives it
  std::string_view sets;   ///< "freeConAng=0" where the deck has this variable; empty: none
  std::string_view example;
};
[[nodiscard]] const std::vector<FindQuestion>& find_questions();
/// Reads "NAME" or "NAME=value" into unknown (without bounds) and target. @throws InputError
struct ParsedFindQuestion {
  const FindQuestion* question = nullptr;
  FindUnknown unknown;
  FindTarget target;
};
[[nodiscard]] ParsedFindQuestion parse_question(std::string_view text);
/// Adds the sets of the question that the deck of the request has.
void add_sets(const FindQuestion& question, runs::DeckRequest& request);

}  // namespace adore::design
