#include "deck/check.hpp"

#include "deck/lookup.hpp"
#include "deck/units.hpp"

#include <fmt/format.h>

#include <cmath>

namespace adore::deck {

bool Checker::is_reported(const RecordData& record, std::string_view variable) const {
  return reported_errors_.values.count({record.id, record.instance, std::string(variable)}) > 0;
}

std::optional<double> Checker::value_in_deck_units(std::string_view name, int instance,
                                                   int index) const {
  const Value* value = find_value(deck_, name, instance, index);
  const double* real = value == nullptr ? nullptr : std::get_if<double>(value);
  return real != nullptr && std::isfinite(*real) ? std::optional(*real) : std::nullopt;
}

std::optional<double> Checker::si(std::string_view name, int instance, int index) const {
  return value_in_deck_units(name, instance, index) ? std::optional(deck_.si(name, instance, index))
                                                    : std::nullopt;
}

std::optional<long long> Checker::integer(std::string_view name, int index) const {
  const Value* value = find_value(deck_, name, 1, index);
  if (value == nullptr || !is_reliable_integer(find_present_variable(deck_, name).spec(), *value))
    return std::nullopt;
  return std::get<long long>(*value);
}

std::string Checker::length(double metres) const {
  return deck_.units() == UnitSystem::English ? fmt::format("{:.6g} in", metres / unit::kInch)
                                              : fmt::format("{:.6g} m", metres);
}

std::string Checker::temperature(double kelvin) const {
  return deck_.units() == UnitSystem::English ? fmt::format("{:.6g} R", kelvin / unit::kRankine)
                                              : fmt::format("{:.6g} K", kelvin);
}

void Checker::error(std::string_view name, std::string message, std::string remedy, int instance) {
  add(deck_.issue(Severity::Error, name, std::move(message), std::move(remedy), instance));
}

void Checker::warning(std::string_view name, std::string message, std::string remedy,
                      int instance) {
  add(deck_.issue(Severity::Warning, name, std::move(message), std::move(remedy), instance));
}

void Checker::no_effect(std::string_view name, std::string message, std::string remedy) {
  warning(name, std::move(message), std::move(remedy));
  issues_.back().code = "deck.no_effect";
}

std::vector<Issue> check_deck(const Deck& deck, const ReportedErrors& reported) {
  std::vector<Issue> issues;
  Checker checker(deck, reported, issues);
  check_record_layout(checker, reported);
  check_values(checker);
  check_control(checker);
  check_envelope(checker);
  check_ball_geometry(checker);
  check_roller_geometry(checker);
  check_cage(checker);
  check_operation(checker);
  check_extension(checker);
  check_likely_mistakes(checker);
  return issues;
}

std::vector<Issue> check_deck(const Deck& deck) { return check_deck(deck, ReportedErrors{}); }

}  // namespace adore::deck
