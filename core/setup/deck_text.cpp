#include "setup/deck_text.hpp"

#include <fmt/format.h>

#include <vector>

namespace adore::setup {
namespace {

constexpr double kInch = 0.0254, kRankine = 5.0 / 9.0;

}  // namespace

std::string length_text(const deck::Deck& deck, double metres) {
  return deck.units() == deck::UnitSystem::English ? fmt::format("{:.6g} in", metres / kInch)
                                                   : fmt::format("{:.6g} m", metres);
}

std::string temperature_text(const deck::Deck& deck, double kelvin) {
  return deck.units() == deck::UnitSystem::English ? fmt::format("{:.6g} R", kelvin / kRankine)
                                                   : fmt::format("{:.6g} K", kelvin);
}

InputError with_location(const deck::Deck& deck, std::string_view variable,
                         const InputError& error) {
  std::vector<Issue> out;
  for (const Issue& issue : error.issues()) {
    if (!issue.record.empty()) {
      out.push_back(issue);
      continue;
    }
    out.push_back(deck.issue(issue.severity, variable, issue.message, issue.remedy));
  }
  return InputError(std::move(out));
}

}  // namespace adore::setup
