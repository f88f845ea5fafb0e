#include "calculators/deck_lubricant.hpp"

#include "base/errors.hpp"
#include "setup/user_lubricant.hpp"

#include <string>

namespace adore::calculators {
namespace {

constexpr int kUsers = 9;  // kTrac

/// A value of the deck in SI that is there and in use, else the fallback.
double value_or(const deck::Deck& deck, const char* name, double fallback) {
  try {
    return deck.has(name) ? deck.si(name) : fallback;
  } catch (const InputError&) {
    return fallback;  // not typed yet
  }
}

}  // namespace

std::optional<LubricantContact> lubricant_contact(const deck::Deck& deck) {
  const long long code = deck.integer("kTrac");
  if (code < 1) return std::nullopt;
  LubricantContact out;
  if (code == kUsers) out.user = setup::user_lubricant(deck);
  out.code = static_cast<int>(code);
  out.temperature = 0.5 * (value_or(deck, "raceTemp2", out.temperature) +
                           value_or(deck, "reTemp", out.temperature));
  out.roughness = value_or(deck, "rmsAspHt2", out.roughness);
  out.critical_film = value_or(deck, "reRaceFilm", out.critical_film);
  out.meniscus = value_or(deck, "strParam", out.meniscus);
  out.metal_type = static_cast<int>(deck.integer("kTracType"));
  for (std::size_t n = 0; n < out.metal.size(); ++n)
    out.metal[n] = value_or(deck, ("reRaceTC" + std::to_string(n + 1)).c_str(), out.metal[n]);
  return out;
}

}  // namespace adore::calculators
