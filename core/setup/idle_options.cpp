#include "setup/idle_options.hpp"

#include <fmt/format.h>

namespace adore::setup {
namespace {

using deck::Deck;

struct Option {
  const char* variable;
  long long neutral;
  const char* asks_for;
};

constexpr Option kOptions[] = {
    {"kDCR", 0, "constraints of the races in dynamics"},
    {"kDOF", 0, "suppressed degrees of freedom"},
    {"kIcOpt", 0, "the start of a dynamic run"},
    {"kTherm", 0, "the thermal analysis"},
    {"kChrn", 0, "churning and drag"},
    {"kCageGsImp", 0, "imperfections of the cage's guide lands"},
    {"kRaceGsImp", 0, "imperfections of the races' guide lands"},
    {"kPocHydro", 0, "hydrodynamics in the pockets"},
    {"kGsHydro", 0, "hydrodynamics at the guide lands"},
    {"kTrac", 0, "element to race traction by a lubricant or routine"},
    {"kCPTrac", 0, "element to cage traction by a routine"},
    {"kCRTrac", 0, "cage to race traction by a routine"},
    {"kRFTrac", 0, "roller to flange traction by a routine"},
    {"kRRTrac", 0, "element to element traction by a routine"},
    {"iTherm", 0, "the thermal correction of a lubricant's traction"},
};

/// Of pocket imperfections the deviations of clearance change the play; these only move.
constexpr std::pair<const char*, const char*> kPocketErrors[] = {
    {"bPocThknsVar", "a deviation of the pocket's thickness"},
    {"bPocCenVar1", "an axial shift of the pocket"},
    {"bPocCenVar2", "an angular shift of the pocket"},
    {"bPocAngVar1", "a tilt of the pocket"},
    {"bPocAngVar2", "a tilt of the pocket"},
    {"bPocAngVar3", "a tilt of the pocket"},
};

}  // namespace

std::vector<IdleOption> idle_options(const Deck& deck) {
  std::vector<IdleOption> out;
  if (deck.integer("mode") >= 0) return out;
  const deck::ReportOnly quiet(deck);  // to ask is not to use
  for (const Option& option : kOptions)
    if (deck.has(option.variable) && deck.integer(option.variable) != option.neutral)
      out.push_back(
          {option.variable, std::to_string(deck.integer(option.variable)), option.asks_for});
  const long long segments = deck.integer("nCseg");
  if (segments > 1) out.push_back({"nCseg", std::to_string(segments), "a cage cut into segments"});
  if (segments != 0 && deck.integer("kCagePocImp") == 4)
    out.push_back({"kCagePocImp", "4", "pocket imperfections by a routine"});
  const auto number = [&](const char* variable, const char* what) {
    if (deck.has(variable) && deck.real(variable) != 0.0)
      out.push_back({variable, fmt::format("{:g}", deck.real(variable)), what});
  };
  for (const auto& [variable, what] : kPocketErrors) number(variable, what);
  // The play of round pockets is clearance I; between guide faces it follows from their places.
  const bool rollers = deck.integer("kBrg") != 1;
  const long long shape = segments != 0 ? deck.integer("kPocType") : 0;
  if (rollers || shape < 2)
    number("bPocClsVar2", "a deviation of clearance II, which these pockets do not have");
  if (rollers && shape > 0)
    number("bPocClsVar1", "a deviation of clearance I, which pockets of guide faces do not have");
  return out;
}

}  // namespace adore::setup
