#include "deck/schema_parts.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

/// Records 4 to 5F: envelope, rolling elements, raceways, flanges.
namespace adore::deck {
namespace {

using range::kAny;
using range::kConeAngle;
using range::kConformity;
using range::kContactAngle;
using range::kGroove;
using range::kNotNegative;
using range::kSize;
using range::kTilt;
using unit::kAngle;
using unit::kLength;
using unit::kPure;

VariableSpec roughness(int race, std::string_view name) {
  return real(
      intern_string(fmt::format("rmsAspHt{}", race)), kLength, kNotNegative,
      intern_string(fmt::format("Composite rms roughness of rolling element and {} race: square "
                                "root of the sum of their squared rms roughness values. The film "
                                "parameter is the film thickness divided by this value.",
                                name)));
}

RecordSpec envelope() {
  return record("4", "Bearing envelope", "true",
                {real("brgBore", kLength, kSize, "Bore diameter of the bearing."),
                 real("brgOD", kLength, kSize, "Outside diameter of the bearing."),
                 real("shftID", kLength, kNotNegative,
                      "Inside diameter of a hollow shaft; 0 for a solid shaft. Thermal analysis "
                      "replaces 0 by a small bore and reports it."),
                 real("hsngOD", kLength, kNotNegative,
                      "Outside diameter of the housing. It determines how much an interference fit "
                      "shrinks the outer race."),
                 real("raceWidth1", kLength, kSize, "Width of the outer race."),
                 real("raceWidth2", kLength, kSize, "Width of the inner race.")});
}

RecordSpec ball_geometry() {
  return record(
      "5A", "Ball bearing geometry", "kBrg == 1",
      {real("bReDia", kLength, kSize, "Nominal ball diameter."),
       real("pitchDia", kLength, kSize, "Pitch diameter: diameter of the circle of ball centers."),
       real("freeConAng", kAngle, range::kBallAngle,
            "Free contact angle (without load, before mounting). A value above 0 determines the "
            "clearance. With 0, the angle is "
            "computed from freeIntCls. Enter 90 degrees for a thrust bearing."),
       real("freeIntCls", kLength, range::kPlay,
            "Internal diametral clearance before mounting, used when freeConAng is 0. Negative "
            "means "
            "interference."),
       real("raceCurFac1", kPure, kGroove,
            "Groove radius of the outer race divided by ball diameter; above 0.5 and below 10, "
            "usually 0.515 to 0.53."),
       real("raceCurFac2", kPure, kGroove,
            "Groove radius of the inner race divided by ball diameter; above 0.5 and below 10, "
            "usually 0.515 to 0.53."),
       real("shoulderDia1", kLength, kNotNegative,
            "Shoulder diameter of the outer race. It is used only for the distance of the contact "
            "from the shoulder edge."),
       real("shoulderDia2", kLength, kNotNegative,
            "Shoulder diameter of the inner race. It is used only for the distance of the contact "
            "from the shoulder edge."),
       real("shimThickness1", kLength, kNotNegative,
            "Thickness of the grinding shim of a split outer race (gothic arch); 0 if the race is "
            "not split."),
       real("shimThickness2", kLength, kNotNegative,
            "Thickness of the grinding shim of a split inner race (gothic arch); 0 if the race is "
            "not split."),
       roughness(1, "outer"), roughness(2, "inner")});
}

VariableSpec corner_radius(int end, std::string_view where) {
  return real(
      intern_string(fmt::format("bReCorRad{}", end)), kLength, kNotNegative,
      intern_string(fmt::format(
          "Corner radius of the roller at the {}. It shortens the contact length.", where)));
}

/// Records 5B.2 and 5D.2 are identical.
std::vector<VariableSpec> straight_raceways() {
  std::vector<VariableSpec> variables;
  for (const auto& [race, name] : {std::pair{1, "outer"}, std::pair{2, "inner"}}) {
    variables.push_back(
        real(intern_string(fmt::format("raceLandLmt{}", race)), kLength, kSize,
             intern_string(fmt::format(
                 "Usable width of the {} raceway along the roller, without undercuts.", name))));
    variables.push_back(
        real(intern_string(fmt::format("raceCenLen{}", race)), kLength, kNotNegative,
             intern_string(fmt::format("Width of the flat land in the middle of a crowned "
                                       "{} raceway. It is used only with a crown.",
                                       name)),
             "0"));
    variables.push_back(real(intern_string(fmt::format("raceCrn{}", race)), kLength, kNotNegative,
                             intern_string(fmt::format(
                                 "Crown radius of the {} raceway on both sides of the flat land; 0 "
                                 "means no crown. The crown curves away from the rollers.",
                                 name)),
                             "0"));
  }
  variables.push_back(roughness(1, "outer"));
  variables.push_back(roughness(2, "inner"));
  return variables;
}

VariableSpec crown_radius() {
  return real("bReCrn", kLength, kNotNegative,
              "Crown radius of the roller profile. 0 means a straight roller without crown; "
              "bReCenLen is then not used.");
}

VariableSpec spherical_crown_radius() {
  return real("bReCrn", kLength, kSize,
              "Crown radius: the radius of the barrel-shaped roller profile.");
}

VariableSpec roller_length() {
  return real("bReLen", kLength, kSize, "Roller length from end to end.");
}

VariableSpec central_land() {
  return real("bReCenLen", kLength, kNotNegative,
              "Length of the uncrowned central part of the roller; at most the roller length.");
}

VariableSpec roller_groove(int race, std::string_view name) {
  return real(
      intern_string(fmt::format("raceCurFac{}", race)), kPure, kConformity,
      intern_string(fmt::format("Groove radius of the {} race divided by twice the crown radius of "
                                "the roller; above 0.5.",
                                name)));
}

VariableSpec cone_angle(int race, std::string_view name) {
  return real(
      intern_string(fmt::format("raceTaper{}", race)), kAngle, kConeAngle,
      intern_string(fmt::format("Half cone angle of the {} race. The cones of both races have a "
                                "common apex. The pitch diameter follows from the two cone angles.",
                                name)));
}

VariableSpec end_radius(int end, std::string_view where) {
  return real(intern_string(fmt::format("bReEndRad{}", end)), kLength, kNotNegative,
              intern_string(fmt::format(
                  "Sphere radius of the {} of the roller. This end can touch a flange.", where)));
}

RecordSpec cylindrical_roller() {
  return record(
      "5B.1", "Cylindrical roller geometry", "kBrg == 2",
      {real("bReDia", kLength, kSize, "Nominal roller diameter."), crown_radius(), roller_length(),
       central_land(), corner_radius(1, "negative x end"), corner_radius(2, "positive x end"),
       real("pitchDia", kLength, kSize,
            "Pitch diameter: diameter of the circle of roller centers."),
       real("freeIntCls", kLength, range::kPlay,
            "Diametral clearance before mounting; negative means preload.")});
}

RecordSpec spherical_roller() {
  return record("5C", "Spherical roller bearing geometry", "kBrg == 3",
                {real("bReDia", kLength, kSize, "Nominal roller diameter at the largest section."),
                 spherical_crown_radius(), roller_length(), corner_radius(1, "negative x end"),
                 corner_radius(2, "positive x end"),
                 real("pitchDia", kLength, kSize,
                      "Pitch diameter: diameter of the circle of roller centers."),
                 real("freeIntCls", kLength, range::kPlay,
                      "Diametral clearance before mounting; negative means preload."),
                 roller_groove(1, "outer"), roller_groove(2, "inner"),
                 real("freeConAng", kAngle, kContactAngle,
                      "Nominal contact angle of the row, measured from the radial plane. It is the "
                      "tilt of the inner raceway from the shaft axis."),
                 roughness(1, "outer"), roughness(2, "inner")});
}

RecordSpec tapered_roller() {
  return record("5D.1", "Tapered roller geometry", "kBrg == 4",
                {real("bReDia", kLength, kSize, "Roller diameter at mid length."), crown_radius(),
                 roller_length(), central_land(), end_radius(1, "large end"),
                 end_radius(2, "small end"), corner_radius(1, "negative x end (large end)"),
                 corner_radius(2, "positive x end (small end)"), cone_angle(1, "outer"),
                 cone_angle(2, "inner")});
}

RecordSpec spherical_tapered_roller() {
  return record(
      "5E", "Spherical tapered roller bearing geometry", "kBrg == 5",
      {real("bReDia", kLength, kSize, "Roller diameter at mid length."), spherical_crown_radius(),
       roller_length(), end_radius(1, "large end"), end_radius(2, "small end"),
       cone_angle(1, "outer"), cone_angle(2, "inner"), roller_groove(1, "outer"),
       roller_groove(2, "inner"), roughness(1, "outer"), roughness(2, "inner")});
}

RecordSpec flanges() {
  RecordSpec spec = record("5F", "Race flange geometry", kAnyFlange, {});
  struct Place {
    std::string_view code, where;
  };
  constexpr std::array<Place, 4> kPlaces = {{{"11", "outer race, negative x side"},
                                             {"21", "outer race, positive x side"},
                                             {"12", "inner race, negative x side"},
                                             {"22", "inner race, positive x side"}}};
  for (const Place& place : kPlaces)
    spec.variables.push_back(
        real(intern_string(fmt::format("flngAng{}", place.code)), kAngle, kTilt,
             intern_string(
                 fmt::format("Layback angle of the flange on the {}; used when kFlngInd{} is 1.",
                             place.where, place.code))));
  for (const Place& place : kPlaces)
    spec.variables.push_back(
        real(intern_string(fmt::format("flngHt{}", place.code)), kLength, kNotNegative,
             intern_string(fmt::format("Height of the flange on the {}; used when kFlngInd{} is 1.",
                                       place.where, place.code))));
  for (const auto& [race, name] : {std::pair{1, "outer"}, std::pair{2, "inner"}})
    spec.variables.push_back(
        real(intern_string(fmt::format("flngCls{}", race)), kLength, kAny,
             intern_string(
                 fmt::format("Total free axial travel of a roller between the two flanges of the "
                             "{0} race; used if kFlngInd1{1} and kFlngInd2{1} are both 1.",
                             name, race))));
  return spec;
}

}  // namespace

void add_geometry_records(std::vector<RecordSpec>& out) {
  out.push_back(envelope());
  out.push_back(ball_geometry());
  out.push_back(cylindrical_roller());
  out.push_back(
      record("5B.2", "Cylindrical roller bearing raceways", "kBrg == 2", straight_raceways()));
  out.push_back(spherical_roller());
  out.push_back(tapered_roller());
  out.push_back(
      record("5D.2", "Tapered roller bearing raceways", "kBrg == 4", straight_raceways()));
  out.push_back(spherical_tapered_roller());
  out.push_back(flanges());
}

}  // namespace adore::deck
