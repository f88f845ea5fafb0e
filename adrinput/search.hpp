#pragma once

#include "adrinput/cell.hpp"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Search for variables by name, help, record title and meaning of codes: "Where is race
/// curvature?" No Qt.
namespace adore::adrinput {

struct VariableMatch {
  Cell cell;
  int score = 0;
};

/// Best first, at most `most`. Every meaningful word of the query must occur; words like "where"
/// and "is" are ignored. Among equally good ones those of the deck (`is_here`) come first: pitchDia
/// is in three records, of which a deck has one.
[[nodiscard]] std::vector<VariableMatch> search_variables(
    std::string_view query, const std::function<bool(const Cell&)>& is_here = {},
    std::size_t most = 60);

/// An option that adds a record to a deck with another code.
struct EnablingOption {
  Cell option;
  std::string code;
  bool enough = true;  ///< false: only the first of several options that must change
};

/// The option for a record that the deck does not have; no value for an unknown record, or if no
/// code of a present option leads to it.
[[nodiscard]] std::optional<EnablingOption> find_enabling_option(const deck::Deck& deck,
                                                                 std::string_view record);

}  // namespace adore::adrinput
