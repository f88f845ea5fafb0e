#include "base/counted.hpp"
#include "deck/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

/// Records 7 and 9.6: the cage and its neighbors. Lengths are compared in meters.
namespace adore::deck {
namespace {

constexpr double kRounding = 1e-9;
constexpr double kHardlyMetres = 5.0;  // larger lengths are remarked elsewhere: mm given as m

void check_pocket_code(Checker& c) {
  const auto type = c.integer("kBrg");
  if (!type) return;
  if (*type == 1 && c.is("kPocType", -1))
    c.error("kPocType", "code -1 is a pocket for rollers, but kBrg = 1 is a ball bearing",
            "valid codes for balls are 0 (cylindrical), 1 (spherical), 2 (elongated), 3 "
            "(rectangular), 4 (conical)");
  if (*type != 1 && c.is("kPocType", 4))
    c.error("kPocType", "code 4 is a conical pocket for balls, but kBrg is a roller bearing",
            "valid codes for rollers are -1 (cylindrical), 0 (rectangular), 1 to 3 (number of "
            "guide surface pairs)");
}

/// Pockets: the element must fit in, and neighbors must leave a web.
void check_pockets(Checker& c) {
  const auto type = c.integer("kBrg");
  const auto pocket = c.integer("kPocType");
  const auto diameter = c.si("bReDia");
  const auto clearance = c.si("bPocCls1");
  const auto inner = c.si("cageDia2");
  const auto outer = c.si("cageDia1");
  const auto count = c.integer("nRe");
  if (!type || !pocket || !diameter || !clearance) return;
  if (*type != 1 && *pocket > 0) return;  // guide surfaces: the clearance has no meaning
  const char* element = *type == 1 ? "ball" : "roller";
  if (*clearance < 0.0)
    c.warning("bPocCls1", fmt::format("the pocket is smaller than the {0} and clamps it", element),
              "enter a clearance above 0");
  else if (*clearance > *diameter)
    c.warning("bPocCls1", fmt::format("the pocket is more than twice as large as the {}", element),
              "enter clearances in m (SI) or inches (English)");
  const auto length = c.si("bReLen");
  const auto width = c.si("cageWidth");
  if (*type != 1 && length && width && *length >= *width)
    c.warning("cageWidth",
              fmt::format("pockets for rollers of length {} leave no rim at the sides of the cage",
                          c.length(*length)),
              "enter a width above bReLen");
  if (*type == 1 && *pocket == 0 && width && *clearance >= 0.0 && *clearance <= *diameter &&
      *diameter + *clearance >= *width)
    c.error(
        "cageWidth",
        fmt::format("the pockets, of size bReDia + bPocCls1 = {}, do not fit into the cage width",
                    c.length(*diameter + *clearance)),
        "enter a larger width");
  if (!inner || !outer || !count || c.is("kPocType", 2) || *outer <= *inner) return;
  const double web = std::numbers::pi * 0.5 * (*inner + *outer) / static_cast<double>(*count) -
                     (*diameter + *clearance);
  if (*count > 1 && web <= 0.0)
    c.warning(
        "nRe",
        "adjacent pockets overlap at the mean cage diameter, so that there is no web between them",
        "use fewer or smaller elements, or a smaller pocket clearance");
}

/// The cage runs in the gap between the rings: below the outer shoulder, above the inner one; where
/// no shoulder is given, between the raceways; in any case inside the bearing.
void check_cage_between_races(Checker& c) {
  const auto outer = c.si("cageDia1");
  const auto inner = c.si("cageDia2");
  const auto bore = c.si("brgBore");
  const auto outside = c.si("brgOD");
  if (!outer || !inner) return;
  if (outside && *outside > 0.0 && *outer >= *outside)
    return c.error(
        "cageDia1",
        fmt::format("the cage is larger than the bearing, whose outside diameter brgOD is {}",
                    c.length(*outside)),
        "enter a diameter below the shoulder diameter of the outer race");
  if (bore && *inner <= *bore)
    return c.error(
        "cageDia2",
        fmt::format("the inner diameter of the cage is not above the bearing bore, brgBore = {}",
                    c.length(*bore)),
        "enter a diameter above the shoulder diameter of the inner race");
  const auto pitch = c.si("pitchDia");
  const auto diameter = c.si("bReDia");
  if (!pitch || !diameter || *outer > kHardlyMetres) return;
  const double outer_shoulder = c.si("shoulderDia1").value_or(0.0);
  const double inner_shoulder = c.si("shoulderDia2").value_or(0.0);
  const double roof = outer_shoulder > 0.0 ? outer_shoulder : *pitch + *diameter;
  const double floor = inner_shoulder > 0.0 ? inner_shoulder : *pitch - *diameter;
  if (*outer > roof * (1.0 + kRounding))
    c.warning(
        "cageDia1",
        fmt::format("the cage overlaps the outer race, whose {} has a diameter of {}",
                    outer_shoulder > 0.0 ? "shoulder" : "raceway", c.length(roof)),
        "enter a smaller diameter, unless the cage is narrower than the race and runs next to it");
  if (*inner < floor * (1.0 - kRounding))
    c.warning(
        "cageDia2",
        fmt::format("the cage overlaps the inner race, whose {} has a diameter of {}",
                    inner_shoulder > 0.0 ? "shoulder" : "raceway", c.length(floor)),
        "enter a larger diameter, unless the cage is narrower than the race and runs next to it");
}

void check_cage_body(Checker& c) {
  const auto outer = c.si("cageDia1");
  const auto inner = c.si("cageDia2");
  const auto diameter = c.si("bReDia");
  const auto pitch = c.si("pitchDia");
  if (outer && inner && *inner >= *outer)
    c.error("cageDia2",
            fmt::format("the inner diameter must be smaller than the outer diameter, cageDia1 = {}",
                        c.length(*outer)),
            "check cageDia1 and cageDia2");
  else if (outer && inner && diameter && pitch &&
           (*inner >= *pitch + *diameter || *outer <= *pitch - *diameter))
    c.error("cageDia1",
            "the cage does not reach the elements, so that its pockets cannot touch them",
            "choose both cage diameters near the pitch diameter");
  else
    check_cage_between_races(c);
  const auto cut = c.value_in_deck_units("cageAngCut");
  if (c.is("nCseg", 1) && cut && *cut != 0.0)
    c.no_effect("cageAngCut", "a one-piece cage has no cut; the value has no effect",
                "set it to 0");
}

void check_lands(Checker& c) {
  const auto count = c.integer("nGL");
  const auto outer = c.si("cageDia1");
  const auto inner = c.si("cageDia2");
  const auto width = c.si("cageWidth");
  const auto outside = c.si("brgOD");
  const auto bore = c.si("brgBore");
  if (!count) return;
  bool guided = false;
  for (int land = 1; land <= *count; ++land) {
    const auto guide = c.integer("iCageGuide", land);
    guided = guided || (guide && *guide > 0);
    const auto diameter = c.si("cageGsDia", land);
    const auto clearance = c.si("cageGsCls", land);
    const auto land_width = c.si("cageGsWidth", land);
    const auto position = c.si("cageGsPos", land);
    if (guide && *guide == 1 && diameter && outer && *diameter > *outer * (1.0 + kRounding))
      c.warning("cageGsDia",
                "the land is guided by the outer race, but its diameter is above the outer "
                "diameter of the cage",
                "check cageGsDia and cageDia1", land);
    if (guide && *guide == 2 && diameter && inner && *diameter < *inner * (1.0 - kRounding))
      c.warning("cageGsDia",
                "the land is guided by the inner race, but its diameter is below the inner "
                "diameter of the cage",
                "check cageGsDia and cageDia2", land);
    const bool guides = guide && *guide > 0;
    if (guides && diameter && outside && *outside > 0.0 && *diameter >= *outside)
      c.error("cageGsDia", "the land is outside the bearing",
              fmt::format("enter a diameter below brgOD = {}", c.length(*outside)), land);
    else if (guides && diameter && bore && *diameter <= *bore)
      c.error("cageGsDia", "the land is inside the bore of the bearing",
              fmt::format("enter a diameter above brgBore = {}", c.length(*bore)), land);
    if (clearance && *clearance < 0.0)
      c.warning("cageGsCls", "a negative clearance clamps the cage on the guiding race",
                "enter a clearance above 0", land);
    if (width && land_width && *land_width > *width * (1.0 + kRounding))
      c.error("cageGsWidth",
              fmt::format("the land is wider than the cage, cageWidth = {}", c.length(*width)),
              "enter a width of at most cageWidth", land);
    else if (width && position && land_width && std::abs(*position) - *land_width >= 0.5 * *width)
      c.error("cageGsPos", "puts the whole land outside the cage",
              fmt::format("enter an absolute value of at most {}, which is half of cageWidth",
                          c.length(0.5 * *width)),
              land);
    else if (width && position && std::abs(*position) > 0.5 * *width * (1.0 + kRounding))
      c.warning("cageGsPos", "the outer edge of the land is outside the cage",
                "enter a distance of at most half the cage width", land);
  }
  if (!guided && c.is("kGsHydro", 1))
    c.no_effect("kGsHydro", "no land is guided by a race; the switch has no effect", "set it to 0");
}

/// Segments are identical: the same number of elements each, all cut the same way.
void check_segments(Checker& c) {
  const auto segments = c.integer("nCseg");
  const auto elements = c.integer("nRe");
  if (!segments || *segments < 2) return;
  for (const std::string_view name : {"kPocHydro", "kGsHydro"})
    if (c.is(name, 1))
      c.no_effect(
          name,
          "hydrodynamic forces are not available for a segmented cage; the switch has no effect",
          "set it to 0");
  if (!elements) return;
  if (*elements % *segments != 0) {
    c.error("nCseg",
            fmt::format("{} cannot be divided into {} equal segments",
                        counted(*elements, "element"), *segments),
            "choose nCseg so that nRe is a multiple of nCseg");
    return;
  }
  const long long share = *elements / *segments;
  long long last = 0;
  for (int i = 1; i <= *segments; ++i) {
    const auto start = c.integer("lSeg", i);
    if (!start) return;
    const long long element = std::abs(*start);
    if (element < 1 || element > *elements) {
      c.error("lSeg", fmt::format("there is no rolling element {}", *start),
              fmt::format("enter numbers from 1 to {}", *elements));
      return;
    }
    const auto first = c.integer("lSeg", 1);
    if (i > 1 && (element != last + share || (*start > 0) != (*first > 0))) {
      c.error(
          "lSeg",
          fmt::format(
              "the segments must be identical, with {} each and the same kind of cut (sign of "
              "lSeg), but segment {} has lSeg = {}",
              counted(share, "element"), i, *start),
          fmt::format("enter {} for this segment", *first > 0 ? last + share : -(last + share)));
      return;
    }
    last = element;
  }
}

/// A cage that starts at rest among elements that orbit, or far from their speed.
void check_cage_start(Checker& c, long long segments) {
  constexpr double kFastestStart = 1.5;  // of the epicyclic speed
  const auto mode = c.integer("mode");
  const auto outer = c.value_in_deck_units("rpm1"), inner = c.value_in_deck_units("rpm2");
  if (!mode || *mode < 0 || !outer || !inner || (*outer == 0.0 && *inner == 0.0)) return;
  for (int k = 1; k <= segments; ++k) {
    const auto ratio = c.value_in_deck_units("avRatio", k);
    if (!ratio || (*ratio > 0.0 && *ratio <= kFastestStart)) continue;
    const std::string_view how = *ratio == 0.0 ? "starts at rest among orbiting elements"
                                 : *ratio < 0.0
                                     ? "starts to rotate against the orbital motion of the elements"
                                     : "starts to rotate much faster than the elements orbit";
    return c.warning(
        "avRatio",
        fmt::format("the {} {}, which causes hard impacts", segments > 1 ? "segment" : "cage", how),
        "enter 1 to start the cage at the orbital speed of the elements", k);
  }
}

}  // namespace

void check_cage(Checker& c) {
  const auto segments = c.integer("nCseg");
  if (!segments || *segments < 1) return;
  check_cage_start(c, *segments);
  check_pocket_code(c);
  check_pockets(c);
  check_cage_body(c);
  check_lands(c);
  check_segments(c);
}

}  // namespace adore::deck
