#include "runs/operating_point.hpp"

#include "base/errors.hpp"
#include "deck/deck.hpp"
#include "deck/deck_text_with_comments.hpp"
#include "tribology/lubricant.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace adore::runs {
namespace {

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// kTrac of a number or of the beginning of a name.
int oil_code(const std::string& oil) {
  std::string known;
  int found = 0;
  for (const int code : tribology::lubricant_codes()) {
    const std::string name(tribology::lubricant(code).name);
    if (oil == fmt::format("{}", code)) return code;
    if (found == 0 && lower(name).starts_with(lower(oil))) found = code;
    known += fmt::format("{}{} {}", known.empty() ? "" : ", ", code, name);
  }
  if (found != 0) return found;
  throw InputError(fmt::format(
      "unknown oil \"{:.60}\"; give the number of an oil or the beginning of its name: {}", oil,
      known));
}

}  // namespace

bool OperatingPoint::empty() const {
  return !radial && !axial && !speed && !temperature && oil.empty();
}

std::vector<std::pair<std::string, std::string>> deck_assignments(const OperatingPoint& point) {
  constexpr double kZeroCelsius = 273.15;
  std::vector<std::pair<std::string, std::string>> out;
  const auto set = [&](const char* name, double value) {
    out.emplace_back(name, fmt::format("{}", value));
  };
  if (point.radial) set("appLoadZ", *point.radial);
  if (point.axial) set("appLoadX", *point.axial);
  if (point.speed) set("rpm2", *point.speed);
  if (point.temperature)
    for (const char* name : {"hsngTemp", "shftTemp", "raceTemp1", "raceTemp2", "reTemp"})
      set(name, *point.temperature + kZeroCelsius);
  if (!point.oil.empty()) out.emplace_back("kTrac", fmt::format("{}", oil_code(point.oil)));
  return out;
}

std::string with_operating_point(const std::string& text, const OperatingPoint& point) {
  if (point.empty()) return text;
  deck::Deck deck = deck::read_deck_text(text, "new deck").deck;
  deck.set_all(deck_assignments(point));
  deck.complete();
  return deck::with_deck(text, deck).text;
}

}  // namespace adore::runs
