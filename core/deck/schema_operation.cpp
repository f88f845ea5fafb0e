#include "deck/schema_parts.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

/// Records 9: fits, loads, speeds, temperatures, variation in time, cage start, heat; records 11
/// and 12.
namespace adore::deck {
namespace {

/// Residual stresses that no material bears, in either unit; beyond, the life factor overflows.
constexpr Range kResidual = range::between(-1e10, 1e10);

using range::kAny;
using range::kNotNegative;
using range::kPositive;
using unit::kAngle;
using unit::kLength;
using unit::kPure;
using unit::kRotation;
using unit::kTemperature;

RecordSpec room_and_fits() {
  return record(
      "9.0", "Room temperature, fits, residual stress", "true",
      {real("roomTemp", kTemperature, range::kHeat,
            "Room temperature (absolute), at which all dimensions and fits are given."),
       real("raceFit1", kLength, range::kPlay,
            "Diametral fit of the outer race in the housing, mounted at room "
            "temperature; positive is interference."),
       real("raceFit2", kLength, range::kPlay,
            "Diametral fit of the inner race on the shaft, mounted at room temperature; "
            "positive is interference."),
       real("angVelOrient", kAngle, kAny,
            "Angle between the ball spin axis and the x axis, in the plane through ball center and "
            "bearing axis, relative to the orbiting ball frame. It is used only when kAngVel is 2. "
            "With a positive angle, the end of the spin axis towards -x is tilted outwards. If the "
            "angle equals the contact angle, the ball rolls without spin. If the inner race "
            "rotates in the positive direction, the spin vector points to -x. The file PRINT.txt "
            "contains theta, the angle of the total angular velocity, which includes the orbit. "
            "Theta is slightly below 180 degrees minus the angle of the spin axis."),
       real("res1", unit::kStress, kResidual,
            "Residual stress of the outer race in operation, positive in tension. It enters the "
            "STLE life factor."),
       real("res2", unit::kStress, kResidual,
            "Residual stress of the inner race in operation, positive in tension. It enters the "
            "STLE life factor."),
       real("facStrLimit", kPure, kNotNegative,
            "Multiplier on the fatigue limit stress. With 1, the limit is the octahedral shear "
            "stress at the von Mises limit stress of the race material. A multiplier of 1.28 "
            "reproduces ISO 281 for AISI 52100 steel.",
            "1.0")});
}

RecordSpec loads() {
  RecordSpec spec = record("9.1.1", "Applied loads or displacements", "true", {});
  constexpr std::array<std::pair<char, int>, 3> kAxes = {{{'X', 1}, {'Y', 2}, {'Z', 3}}};
  for (const auto& [axis, number] : kAxes)
    spec.variables.push_back(
        real(intern_string(fmt::format("appLoad{}", axis)), unit::kForce, range::kLoad,
             intern_string(
                 fmt::format("Force that the shaft applies to the inner race along {}, used when "
                             "kFS{} is 0.",
                             static_cast<char>(axis - 'A' + 'a'), number))));
  for (const auto& [axis, number] : kAxes)
    spec.variables.push_back(real(
        intern_string(fmt::format("appDisp{}", axis)), kLength, range::kShift,
        intern_string(fmt::format(
            "Displacement of the inner race relative to the outer race along {1} when kFS{0} is 1. "
            "When kFS{0} is 0, it is the first guess of the static solution. If this guess is 0, "
            "the program estimates the first guess. The displacement is measured from the "
            "unmounted bearing at rest and at room temperature. {2}. Fits, thermal growth and "
            "speed do not change this reference position.",
            number, static_cast<char>(axis - 'A' + 'a'),
            axis == 'X' ? "At displacement 0, balls just touch both races at the contact angle "
                          "freeConAng (towards +x), and tapered rollers just touch both races. In "
                          "other bearings, the mid planes of the races coincide at displacement 0"
                        : "At displacement 0, the races are coaxial"))));
  return spec;
}

RecordSpec moments_and_speeds() {
  return record(
      "9.1.2", "Applied moments, misalignments, speeds", "true",
      {real("appMomY", unit::kMoment, range::kLoad,
            "Moment that the shaft applies to the inner race about y, used when kFS4 is 0."),
       real("appMomZ", unit::kMoment, range::kLoad,
            "Moment that the shaft applies to the inner race about z, used when kFS5 is 0."),
       real("appMis11", unit::kRadian, range::kLean,
            "Misalignment of the reference (outer) race about y."),
       real("appMis21", unit::kRadian, range::kLean,
            "Misalignment of the reference (outer) race about z."),
       real("appMis12", unit::kRadian, range::kLean,
            "Misalignment of the moving (inner) race about y when kFS4 is 1. When kFS4 is 0, it is "
            "the first guess of the static solution."),
       real("appMis22", unit::kRadian, range::kLean,
            "Misalignment of the moving (inner) race about z when kFS5 is 1. When kFS5 is 0, it is "
            "the first guess of the static solution."),
       real("rpm1", kRotation, range::kSpeed, "Speed of the outer race, positive about x."),
       real("rpm2", kRotation, range::kSpeed, "Speed of the inner race, positive about x.")});
}

RecordSpec temperatures() {
  RecordSpec spec = record("9.1.3", "Initial temperatures", "true", {});
  constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kParts = {
      {{"hsngTemp", "housing"},
       {"shftTemp", "shaft"},
       {"raceTemp1", "outer race"},
       {"raceTemp2", "inner race"},
       {"reTemp", "rolling elements"},
       {"cageTemp", "cage"}}};
  for (const auto& [name, part] : kParts)
    spec.variables.push_back(
        real(name, kTemperature, range::kHeat,
             intern_string(fmt::format(
                 "Temperature (absolute) of the {} at the start. Thermal expansion is computed "
                 "from the difference between this temperature and room temperature.",
                 part))));
  return spec;
}

RecordSpec stiffness_table() {
  return record("9.2", "Stiffness table", "kStif > 0",
                {real("pctDisp", unit::kPercent, kPositive,
                      "Displacement increment for computing the stiffness, in percent of the "
                      "contact deflection."),
                 real("rpmRange11", kRotation, range::kSpeed,
                      "First speed of the outer race in the stiffness table."),
                 real("rpmRange21", kRotation, range::kSpeed,
                      "Last speed of the outer race in the stiffness table."),
                 real("rpmRange12", kRotation, range::kSpeed,
                      "First speed of the inner race in the stiffness table."),
                 real("rpmRange22", kRotation, range::kSpeed,
                      "Last speed of the inner race in the stiffness table.")});
}

RecordSpec race_vibration() {
  RecordSpec spec = record("9.3B", "Sinusoidal race motion", "mode >= 0 && kVarLoad == 2", {});
  constexpr std::array<std::pair<int, std::string_view>, 2> kRaces = {{{1, "Outer"}, {2, "Inner"}}};
  for (const auto& [race, name] : kRaces)
    for (const char axis : {'x', 'y', 'z'})
      spec.variables.push_back(
          real(intern_string(fmt::format("raceVibAmp{}{}", axis - 'x' + 1, race)), kLength, kAny,
               intern_string(fmt::format(
                   "{} race: amplitude A of the motion A sin(2 pi f t) along {}.", name, axis))));
  for (const auto& [race, name] : kRaces)
    spec.variables.push_back(
        real(intern_string(fmt::format("raceVibFreq{}", race)), unit::kFrequency, kNotNegative,
             intern_string(fmt::format("{} race: frequency f of the motion.", name))));
  return spec;
}

std::vector<VariableSpec> cage_start(std::string_view body) {
  return {real("pocLubFilm", kLength, kNotNegative,
               "Largest thickness of the lubricant film in the pockets. The film acts on elements "
               "that are closer to the pocket wall than this thickness."),
          real("wvRatio", kPure, range::kSpeedRatio,
               intern_string(
                   fmt::format("Whirl speed of the {} mass center at the start, divided by the "
                               "angular speed of the {}.",
                               body, body))),
          real("avRatio", kPure, range::kSpeedRatio,
               intern_string(
                   fmt::format("Angular speed of the {} at the start, divided by the epicyclic "
                               "speed of the rolling elements.",
                               body)),
               ""),
          array(real("cageGcPos", kLength, kAny,
                     intern_string(
                         fmt::format("Coordinates x, y, z of the {} at the start, relative to the "
                                     "center of the pitch circle.",
                                     body == "segment" ? "point of the segment on the cage axis"
                                                       : "cage mass center"))),
                "3"),
          array(real("cageAngPos", kAngle, kAny,
                     intern_string(
                         fmt::format("Three angles of the transformation from the inertial frame "
                                     "to the frame of the {} at the start.",
                                     body))),
                "3")};
}

RecordSpec thermal_inputs() {
  return record(
      "9.7", "Thermal inputs", "kTherm > 0",
      {real("baseTemp", kTemperature, range::kHeat,
            "Reference temperature (absolute) at the location selected by kBaseTemp."),
       real("cFlowRate", unit::kVolumeFlow, kNotNegative,
            "Volume flow of the coolant; not used when kCoolant is 0."),
       real("reHTC", unit::kConvection, kNotNegative,
            "Convection coefficient of the rolling elements. Enter 0 if the program computes it "
            "(kHTC = 0)."),
       real("cageHTC", unit::kConvection, kNotNegative,
            "Convection coefficient of the cage. Enter 0 if the program computes it (kHTC = 0)."),
       real("aveTime", unit::kTime, kPositive,
            "Duration over which the heat is averaged for one thermal step (in seconds, not "
            "dimensionless)."),
       real("skipTime", unit::kTime, kNotNegative,
            "Duration of the first part of the run, in which the geometry is not updated for "
            "thermal expansion (in seconds, not dimensionless).")});
}

}  // namespace

void add_operation_records(std::vector<RecordSpec>& out) {
  out.push_back(room_and_fits());
  out.push_back(loads());
  out.push_back(moments_and_speeds());
  out.push_back(temperatures());
  out.push_back(stiffness_table());
  out.push_back(record(
      "9.3A", "Rotating load", "mode >= 0 && kVarLoad == 1",
      {real("rotLoadFrac1", kPure, kAny,
            "Orbit radius of the outer race divided by the radial deflection between the races."),
       real("rotLoadFrac2", kPure, kAny,
            "Orbit radius of the inner race divided by the radial deflection between the races."),
       real("rotLoadRpm1", kRotation, kAny,
            "Rotational speed of the load due to the orbit of the outer race."),
       real("rotLoadRpm2", kRotation, kAny,
            "Rotational speed of the load due to the orbit of the inner race.")}));
  out.push_back(race_vibration());
  out.push_back(record(
      "9.4A", "Constant race acceleration", "mode >= 0 && kVarSpeed == 1",
      {real("raceAngAcc1", unit::kRotationRate, kAny, "Angular acceleration of the outer race."),
       real("raceAngAcc2", unit::kRotationRate, kAny, "Angular acceleration of the inner race."),
       real("startTime1", unit::kTime, kNotNegative,
            "Time at which the outer race starts to accelerate."),
       real("endTime1", unit::kTime, kNotNegative,
            "Time at which the outer race stops accelerating."),
       real("startTime2", unit::kTime, kNotNegative,
            "Time at which the inner race starts to accelerate."),
       real("endTime2", unit::kTime, kNotNegative,
            "Time at which the inner race stops accelerating.")}));
  out.push_back(record(
      "9.4B", "Sinusoidal race speed", "mode >= 0 && kVarSpeed == 2",
      {real("raceSpeedAmp1", kRotation, kAny,
            "Amplitude A of the sinusoidal part of the outer race speed, rpm1 + A sin(2 pi f t)."),
       real("raceSpeedAmp2", kRotation, kAny,
            "Amplitude A of the sinusoidal part of the inner race speed, rpm2 + A sin(2 pi f t)."),
       real("raceSpeedFreq1", unit::kFrequency, kNotNegative,
            "Frequency f of the sinusoidal part of the outer race speed."),
       real("raceSpeedFreq2", unit::kFrequency, kNotNegative,
            "Frequency f of the sinusoidal part of the inner race speed.")}));
  out.push_back(record(
      "9.5", "Rotating base frame", "mode >= 0 && kRotFrame == 1",
      {real("brgOrbitRad", kLength, kNotNegative, "Orbit radius of the bearing center."),
       real("brgAngPos", kAngle, kAny, "Angle of the bearing center on its orbit at the start."),
       real("brgAngVel", kRotation, kAny, "Orbit speed of the bearing center."),
       real("brgLoadFrac1", kPure, kAny,
            "Fraction of the inertia load of the outer race that the bearing carries."),
       real("brgLoadFrac2", kPure, kAny,
            "Fraction of the inertia load of the inner race that the bearing carries.")}));
  out.push_back(
      record("9.6", "Initial state of a one-piece cage", "nCseg == 1", cage_start("cage")));
  out.push_back(repeated_record("9.6.k", "Initial state of each cage segment", "nCseg > 1", "nCseg",
                                cage_start("segment")));
  out.push_back(thermal_inputs());
  out.push_back(record(
      "9.8", "Coolant properties", "kTherm > 0 && kCoolant == 2",
      {real("xRo", unit::kDensity, kPositive, "Density of the coolant at base temperature."),
       real("xMu", unit::kViscosity, kPositive, "Viscosity of the coolant at base temperature."),
       real("xCp", unit::kSpecificHeat, kPositive, "Specific heat of the coolant."),
       real("xK", unit::kConductivityAsForce, kPositive,
            "Thermal conductivity of the coolant (N/s/K is the same unit as W/m/K).")}));
}

void add_final_records(std::vector<RecordSpec>& out) {
  RecordSpec gravity = record("11", "Gravity", "mode >= 0", {});
  for (const char axis : {'x', 'y', 'z'})
    gravity.variables.push_back(
        real(intern_string(fmt::format("gravityVec{}", static_cast<char>(axis - 'a' + 'A'))),
             unit::kAcceleration, kAny,
             intern_string(fmt::format("Gravity acceleration along {}.{}", axis,
                                       axis == 'z' ? " With a negative value, gravity acts against "
                                                     "the usual direction of the radial load."
                                                   : ""))));
  out.push_back(std::move(gravity));
  RecordSpec user{"12", "User routine inputs", "user() > 0", "user()", {}};
  user.variables.push_back(text("userLine", 0,
                                "One line of text for each record 12.1 to 12.n, in the form that "
                                "the active user routine requires."));
  out.push_back(std::move(user));
}

}  // namespace adore::deck
