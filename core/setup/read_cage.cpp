#include "setup/read_cage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace adore::setup {
namespace {

/// Records 7.5.i and 7.6.i.
bearing::LandErrors land_errors(const deck::Deck& deck, std::string_view body, int index,
                                const NumberReader& number) {
  using Roundness = bearing::RaceErrors::Roundness;
  bearing::LandErrors out;
  const long long code = deck.integer(body == "cage" ? "kCageGsImp" : "kRaceGsImp");
  if (code != 1 && code != 2) return out;
  out.roundness = code == 1 ? Roundness::Elliptical : Roundness::Sinusoidal;
  for (std::size_t k = 0; k < (code == 1 ? 2U : 3U); ++k)
    out.variation[k] = number(fmt::format("{}GsRadVar{}", body, k + 1), index);
  return out;
}

bearing::GuideLand guide_land(const deck::Deck& deck, int index, const NumberReader& number) {
  bearing::GuideLand land;
  const long long guide = deck.integer("iCageGuide", index);
  land.guide = guide == 1   ? bearing::GuideLand::Guide::Outer
               : guide == 2 ? bearing::GuideLand::Guide::Inner
                            : bearing::GuideLand::Guide::None;
  land.diameter = number("cageGsDia", index);
  {
    const deck::ReportOnly quiet(deck, deck.integer("mode") < 0);  // of plays no part
    land.width = number("cageGsWidth", index);
    land.edge = number("cageGsPos", index);
  }
  land.clearance = number("cageGsCls", index);
  const deck::ReportOnly quiet(
      deck, deck.integer("mode") < 0 || land.guide == bearing::GuideLand::Guide::None);
  land.of_cage = land_errors(deck, "cage", index, number);
  land.of_race = land_errors(deck, "race", index, number);
  return land;
}

}  // namespace

bearing::Cage read_cage(const deck::Deck& deck, const NumberReader& number) {
  bearing::Cage out;
  out.outer_diameter = number("cageDia1", 1);
  out.inner_diameter = number("cageDia2", 1);
  out.width = number("cageWidth", 1);
  out.clearance_outer = number("cageCls1", 1);
  out.clearance_inner = number("cageCls2", 1);
  out.cone_angle = deck.has("cageConeAng") ? number("cageConeAng", 1) : 0.0;
  const bool rollers = deck.integer("kBrg") != 1;
  const long long pocket = deck.integer("kPocType");
  out.pocket = bearing::pocket_shape(pocket, rollers);
  out.pocket_clearance_1 = number("bPocCls1", 1);
  if (!rollers && pocket >= 2) out.pocket_clearance_2 = number("bPocCls2", 1);
  if (const long long pieces = deck.integer("nCseg"); pieces > 1) {
    const long long first = deck.integer("lSeg", 1);
    out.segments = {static_cast<int>(pieces), first < 0, static_cast<int>(std::abs(first)) - 1,
                    number("cageAngCut", 1)};
    for (int i = 2; i <= pieces; ++i) (void)deck.integer("lSeg", i);  // alike: check_cage.cpp
  }
  const long long lands = std::clamp(deck.integer("nGL"), 0LL, 4LL);
  for (int i = 1; i <= lands; ++i) out.lands.push_back(guide_land(deck, i, number));
  return out;
}

}  // namespace adore::setup
