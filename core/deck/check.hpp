#pragma once

#include "deck/deck.hpp"

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

/// The checks behind check_deck(). Errors that the reader has already reported are passed
/// along, so that nothing is reported twice.
namespace adore::deck {

struct ReportedErrors {
  std::set<std::pair<std::string, int>> missing_records;       ///< id, instance
  std::set<std::tuple<std::string, int, std::string>> values;  ///< id, instance, variable
  std::set<std::string> doubtful;  ///< integer variables whose value cannot be relied on
};

std::vector<Issue> check_deck(const Deck& deck, const ReportedErrors& reported);

/// Collects issues and hides absent values: a check that misses an input is skipped, since that
/// input has its own issue.
class Checker {
 public:
  Checker(const Deck& deck, const ReportedErrors& reported, std::vector<Issue>& issues)
      : deck_(deck), reported_errors_(reported), issues_(issues) {}

  [[nodiscard]] const Deck& deck() const { return deck_; }
  [[nodiscard]] bool is_reported(const RecordData& record, std::string_view variable) const;

  /// Value in coherent SI, when there is a finite one.
  [[nodiscard]] std::optional<double> si(std::string_view name, int instance = 1,
                                         int index = 1) const;
  /// The value as the deck gives it.
  [[nodiscard]] std::optional<double> value_in_deck_units(std::string_view name, int instance = 1,
                                                          int index = 1) const;
  /// A valid code or count; an absent variable has no value here.
  [[nodiscard]] std::optional<long long> integer(std::string_view name, int index = 1) const;
  [[nodiscard]] bool is(std::string_view name, long long value) const {
    return integer(name) == value;
  }

  /// Lengths and temperatures in messages, in the deck's own unit: "0.0127 m", "0.5 in".
  [[nodiscard]] std::string length(double metres) const;
  [[nodiscard]] std::string temperature(double kelvin) const;

  void error(std::string_view name, std::string message, std::string remedy = {}, int instance = 1);
  void warning(std::string_view name, std::string message, std::string remedy = {},
               int instance = 1);
  /// A warning of a value without effect: finding deck.no_effect.
  void no_effect(std::string_view name, std::string message, std::string remedy);
  void add(Issue issue) { issues_.push_back(std::move(issue)); }

 private:
  const Deck& deck_;
  const ReportedErrors& reported_errors_;
  std::vector<Issue>& issues_;
};

void check_record_layout(Checker& checker,
                         const ReportedErrors& reported);  // which records, in which order
void check_values(Checker& checker);                       // types, codes, ranges, lengths
void check_control(Checker& checker);                      // records 1 to 3
void check_ball_geometry(Checker& checker);                // 5A
void check_roller_geometry(Checker& checker);              // 5B to 5E
void check_envelope(Checker& checker);                     // 4, 5F, 5G, plausible sizes
void check_cage(Checker& checker);                         // 7, 9.6
void check_operation(Checker& checker);                    // 6, 8, 9, 10
void check_extension(Checker& checker);                    // X
void check_likely_mistakes(Checker& checker);              // legal, but most likely a slip

}  // namespace adore::deck
