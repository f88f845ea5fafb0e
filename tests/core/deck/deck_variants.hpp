#pragma once

#include "base/errors.hpp"
#include "deck/deck.hpp"
#include "deck/templates.hpp"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Decks that between them contain every record of the schema.
namespace deck_variants {

using adore::deck::Deck;

inline constexpr int kVariants = 6;
inline constexpr std::string_view kTypes[] = {"ball", "cylindrical", "spherical", "tapered",
                                              "spherical-tapered"};

/// Sets options one by one; records follow. An option that the type or an earlier option rules out
/// is left alone.
inline void set_all(Deck& deck,
                    const std::vector<std::pair<std::string_view, std::string>>& options) {
  for (const auto& [name, value] : options) {
    try {
      deck.set(name, value);
    } catch (const adore::InputError&) {
      continue;
    }
    deck.complete();
  }
}

/// The options do not make physical sense together; they are meant to bring records into the deck.
inline Deck make(std::string_view type, int variant) {
  Deck deck = adore::deck::new_deck(type);
  const auto code = [](int value) { return std::to_string(value); };
  const int half = variant % 2;
  const int curve = variant % 4 - 1;
  set_all(deck, {{"mode", variant == 5   ? "-1"
                          : variant == 4 ? "2"
                                         : "0"},
                 {"kDCR", code(half)},
                 {"kFnOpt", code(half)},
                 {"kTherm", code(half)},
                 {"kUnit", code(1 + half)},
                 {"kReGeoImp", code(1 + half)},
                 {"kRaceGeoImp1", code(1 + half)},
                 {"kRaceGeoImp2", code(2 - half)},
                 {"kFlngInd11", code(half)},
                 {"kFlngInd22", variant == 2 ? "1" : "0"},
                 {"kStif", code(3 * half)},
                 {"kChrn", variant == 1   ? "1"
                           : variant == 2 ? "2"
                           : variant == 3 ? "13"
                                          : "0"},
                 {"kReMat", code(half)},
                 {"kRaceMat1", code(half)},
                 {"kRaceMat2", code(1 - half)},
                 {"kHsngMat", code(half)},
                 {"kShftMat", variant == 3 ? "1" : "150"},
                 {"kLifeCons", code(1 - half)},
                 {"kVarLoad", code(1 + half)},
                 {"kVarSpeed", code(2 - half)},
                 {"kRotFrame", code(half)},
                 {"kReIP", code(variant % 4)},
                 {"kRaceIP1", "1"},
                 {"kRaceIP2", code(half)},
                 {"kNumPltElem", "2"},
                 {"kPltElemInd", "1,2"},
                 {"kCoolant", "2"},
                 {"nCseg", code(variant == 4   ? 0
                                : variant == 1 ? 3
                                               : 1)},
                 {"kPocType", variant == 5 ? "-1" : code(variant % 4)},
                 {"kCagePocImp", code(half + 1)},
                 {"kCageGsImp", code(half + 1)},
                 {"kRaceGsImp", code(2 - half)},
                 {"kPocHydro", code(half)},
                 {"kCageMat", code(half)},
                 {"kCageIP", code(half)},
                 {"nGL", variant == 3   ? "4"
                         : variant == 2 ? "0"
                                        : "1"},
                 {"iCageGuide[1]", "2"},
                 {"kTrac", variant == 2   ? "9"
                           : variant == 3 ? "-1"
                                          : code(half)},
                 {"kTracType", code(curve)},
                 {"kCPTracType", code(curve)},
                 {"kCRTracType", code(curve)},
                 {"kRFTracType", code(curve)},
                 {"kRRTracType", code(curve)}});
  return deck;
}

/// Combinations that the loop above cannot reach: each traction curve with its record, kTrac with
/// hydrodynamics.
inline std::vector<Deck> all() {
  std::vector<Deck> decks;
  for (const std::string_view type : kTypes)
    for (int variant = 0; variant < kVariants; ++variant) decks.push_back(make(type, variant));
  for (int curve = -1; curve <= 2; ++curve) {
    Deck deck = adore::deck::new_deck("cylindrical");
    const std::string code = std::to_string(curve);
    set_all(deck, {{"kTracType", code},
                   {"kCPTracType", code},
                   {"kCRTracType", code},
                   {"kRFTracType", code},
                   {"kRRTracType", code},
                   {"kGsHydro", "1"}});
    decks.push_back(deck);
    set_all(deck, {{"nCseg", "0"}});
    decks.push_back(deck);
  }
  return decks;
}

}  // namespace deck_variants
