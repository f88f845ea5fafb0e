#include "deck/schema_parts.hpp"

#include <fmt/format.h>

/// Records 6 (inertia of rolling elements and races) and 7 (cage).
namespace adore::deck {
namespace {

using range::between;
using range::kAny;
using range::kNotNegative;
using range::kPositive;
using range::kSize;
using range::kTilt;
using unit::kAngle;
using unit::kLength;

RecordSpec cage_options() {
  const auto land_errors = [](std::string_view name, std::string_view what) {
    return choice(
        name, {{"0", "ideal"}, {"1", "elliptical"}, {"2", "sinusoidal"}},
        intern_string(fmt::format("Geometry errors of the guide lands of the {}. The code is used "
                                  "only if nGL (number of guide lands) is above 0.",
                                  what)));
  };
  const auto hydrodynamics = [](std::string_view name, std::string_view where) {
    return choice(
        name, {{"0", "neglect"}, {"1", "include"}},
        intern_string(fmt::format(
            "Hydrodynamic forces of the oil film {}. They are not available with a segmented cage.",
            where)));
  };
  return record(
      "7.0", "Cage options", "nCseg > 0",
      {choice("kPocType",
              {{"-1", "cylindrical roller pockets of a roller-guided cage"},
               {"0", "cylindrical ball pockets or rectangular roller pockets"},
               {"1", "spherical ball pockets or one guide surface pair (rollers)"},
               {"2", "elongated ball pockets or two guide surface pairs (rollers)"},
               {"3", "rectangular ball pockets or three guide surface pairs (rollers)"},
               {"4", "conical ball pockets"}},
              "Shape of the pockets. The meaning of a code depends on the bearing type (kBrg). For "
              "rollers, a positive value is the number of guide surface pairs on records 7.3.i."),
       choice("kCagePocImp",
              {{"0", "ideal"},
               {"1", "pocket 1 only"},
               {"2", "same error in all pockets"},
               {"3", "random, normally distributed"},
               {"4", "user routine ADRX8"}},
              "Geometry errors of the pockets."),
       land_errors("kCageGsImp", "cage"), land_errors("kRaceGsImp", "race"),
       hydrodynamics("kPocHydro", "in the pockets"),
       hydrodynamics("kGsHydro", "at the guide lands"),
       with_option_table(
           choice("kCageMat",
                  {{"0", "mild steel"}, {"1", "record 8.5"}, {"2", "user routine ADRX0"}},
                  "Material of the cage. 0 is mild steel, and 1 takes the properties from "
                  "the deck. The material table lists the other codes.",
                  "0"),
           "@materials"),
       choice("kCageIP", {{"0", "from ideal geometry"}, {"1", "record 7.7"}},
              "Source of mass and inertia of the cage.", "0"),
       counted("nGL", between(0, 4),
               {{"0", "not guided by a race"}, {"n", "number of guide lands, at most 4"}},
               "Number of cage lands that are guided by a race, at most 4; 0 for none."),
       array(choice("iCageGuide", {{"0", "no guidance"}, {"1", "outer race"}, {"2", "inner race"}},
                    "Race that guides each land of the cage."),
             "nGL")});
}

RecordSpec cage_geometry() {
  return record(
      "7.1", "Cage geometry", "nCseg > 0",
      {real("cageDia1", kLength, kSize, "Outer diameter of the cage."),
       real("cageDia2", kLength, kSize, "Inner diameter of the cage."),
       real("cageWidth", kLength, kSize, "Width of the cage."),
       real("cageCls1", kLength, kAny,
            "Diametral clearance between cage and outer race outside the guide lands. The "
            "clearances of the lands are on records 7.2.i."),
       real("cageCls2", kLength, kAny,
            "Diametral clearance between cage and inner race outside the guide lands. The "
            "clearances of the lands are on records 7.2.i."),
       real("bPocCls1", kLength, kAny,
            "Pocket clearance I: circumferential pocket size minus element diameter. For elongated "
            "ball pockets, it is the axial clearance. For conical ball pockets, it is the inner "
            "opening minus the ball diameter. It is not used for roller pockets with guide surface "
            "pairs."),
       real("bPocCls2", kLength, kAny,
            "Pocket clearance II of ball pockets. Elongated pocket: center offset. Rectangular "
            "pocket: axial clearance. Conical pocket: outer opening minus ball diameter. Enter 0 "
            "for other ball pockets and for rollers."),
       real("cageAngCut", kAngle, between(0.0, 360.0),
            "Angular width of the cut between two cage segments; 0 for a one-piece cage."),
       real("cageConeAng", kAngle, kTilt,
            "Half cone angle of a conical cage; 0 for a cylindrical cage.")});
}

RecordSpec guide_lands() {
  return repeated_record(
      "7.2.i", "Cage guide land geometry", "nCseg > 0 && nGL > 0", "nGL",
      {real("cageGsDia", kLength, kSize, "Diameter of the guide land of the cage."),
       real("cageGsWidth", kLength, kSize, "Width of the guide land."),
       real("cageGsPos", kLength, kAny,
            "Axial distance from the cage center to the outer edge of the guide land. It is "
            "negative for a land on the negative x side."),
       real("cageGsCls", kLength, kAny,
            "Diametral clearance between the guide land of the cage and the race that guides the "
            "cage.")});
}

RecordSpec pocket_surfaces() {
  RecordSpec spec = repeated_record("7.3.i", "Roller pocket guide surfaces",
                                    "nCseg > 0 && kBrg > 1 && kPocType > 0", "kPocType", {});
  for (const char axis : {'x', 'y', 'z'})
    spec.variables.push_back(real(
        intern_string(fmt::format("bPocGsAng{}", axis - 'x' + 1)), kAngle, kAny,
        intern_string(fmt::format(
            "Rotation about {} from the pocket frame to the frame of the guide surface.", axis))));
  spec.variables.push_back(
      real("bPocGsCen1", kLength, kAny,
           "x coordinate of the center of the guide surface, measured from the pocket center."));
  spec.variables.push_back(real("bPocGsCen2", kLength, kAny,
                                "y coordinate of the center of the guide surface on the positive y "
                                "side, measured from the pocket center. The second surface of the "
                                "pair is its mirror image in the x-z plane of the pocket."));
  spec.variables.push_back(
      real("bPocGsCen3", kLength, kAny,
           "z coordinate of the center of the guide surface, measured from the pocket center."));
  spec.variables.push_back(
      real("bPocGsLen1", kLength, kSize, "Width of the guide surface (along z)."));
  spec.variables.push_back(
      real("bPocGsLen2", kLength, kSize, "Length of the guide surface (along x)."));
  return spec;
}

RecordSpec pocket_errors() {
  return record(
      "7.4", "Pocket imperfections", "nCseg > 0 && kCagePocImp in (1,2,3)",
      {real("bPocClsVar1", kLength, kAny,
            "Deviation of pocket clearance I from its nominal value (bPocCls1). If kCagePocImp is "
            "3 (random), enter the rms value of the deviation."),
       real("bPocClsVar2", kLength, kAny,
            "Deviation of pocket clearance II from its nominal value (bPocCls2). If kCagePocImp is "
            "3 (random), enter the rms value of the deviation."),
       real("bPocThknsVar", kLength, kAny,
            "Deviation of the pocket thickness from the cage thickness (outer minus inner cage "
            "radius)."),
       real("bPocCenVar1", kLength, kAny, "Axial shift of the pocket center."),
       real("bPocCenVar2", kAngle, kAny,
            "Angular shift of the pocket center along the pitch circle."),
       real("bPocAngVar1", kAngle, kAny, "Tilt of the pocket frame, first angle (about x)."),
       real("bPocAngVar2", kAngle, kAny,
            "Tilt of the pocket frame, second angle (about the y axis after the first rotation)."),
       real("bPocAngVar3", kAngle, kAny,
            "Tilt of the pocket frame, third angle (about the z axis after both rotations).")});
}

/// Records 7.5.i (cage) and 7.6.i (race). The second value is a length or a count, depending on the
/// code.
RecordSpec land_errors(std::string_view id, std::string_view title, std::string_view condition,
                       std::string_view prefix, std::string_view code, std::string_view where) {
  VariableSpec second = real(
      intern_string(fmt::format("{}GsRadVar2", prefix)), kLength, kAny,
      intern_string(fmt::format("{0} guide land: if {1} is 1, semi-axis along z minus nominal "
                                "radius; if {1} is 2, number of waves per revolution (no unit).",
                                where, code)));
  second.unitless_when = intern_string(fmt::format("{} == 2", code));
  return repeated_record(
      id, title, condition, "nGL",
      {real(intern_string(fmt::format("{}GsRadVar1", prefix)), kLength, kAny,
            intern_string(fmt::format("{0} guide land: if {1} is 1, semi-axis along y minus "
                                      "nominal radius; if {1} is 2, amplitude of the radius wave.",
                                      where, code))),
       second,
       real(intern_string(fmt::format("{}GsRadVar3", prefix)), kAngle, kAny,
            intern_string(fmt::format("{0} guide land: phase of the radius wave if {1} is 2. If "
                                      "{1} is 1, the value is not used; enter 0.",
                                      where, code)))});
}

}  // namespace

void add_inertia_records(std::vector<RecordSpec>& out) {
  out.push_back(record("6.1", "Rolling element inertia", "mode >= 0 && kReIP in (1,2)",
                       inertia_variables("bRe", "", "rolling element", "its geometric frame")));
  out.push_back(record("6.2.1", "Outer race inertia", "mode == 0 && kRaceIP1 == 1",
                       inertia_variables("race", "1", "outer race", "the race frame")));
  out.push_back(record("6.2.2", "Inner race inertia", "mode == 0 && kRaceIP2 == 1",
                       inertia_variables("race", "2", "inner race", "the race frame")));
}

void add_cage_records(std::vector<RecordSpec>& out) {
  out.push_back(cage_options());
  out.push_back(record(
      "7.0.1", "Cage segmentation", "nCseg > 1",
      {array(integer(
                 "lSeg", between(-10000, 10000),
                 "Number of the first rolling element of each cage segment, in increasing absolute "
                 "values. With a positive number, the cage is cut just before this element. With a "
                 "negative number, the cage is cut through the pocket of this element."),
             "nCseg")}));
  out.push_back(cage_geometry());
  out.push_back(guide_lands());
  out.push_back(pocket_surfaces());
  out.push_back(pocket_errors());
  out.push_back(land_errors("7.5.i", "Cage guide land imperfections",
                            "nCseg > 0 && nGL > 0 && kCageGsImp in (1,2)", "cage", "kCageGsImp",
                            "Cage"));
  out.push_back(land_errors("7.6.i", "Race guide land imperfections",
                            "nCseg > 0 && nGL > 0 && kRaceGsImp in (1,2)", "race", "kRaceGsImp",
                            "Race"));
  out.push_back(record("7.7", "Cage inertia", "nCseg > 0 && kCageIP > 0",
                       inertia_variables("cage", "", "cage", "the cage frame")));
}

}  // namespace adore::deck
