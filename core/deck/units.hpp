#pragma once

#include "base/constants.hpp"
#include "deck/schema.hpp"

/// The unit pairs of the deck. Factors follow from the exact definitions: 1 in = 0.0254 m, 1 lbm =
/// 0.45359237 kg, 1 lbf = 4.4482216152605 N, 1 R = 5/9 K, 1 deg = pi/180 rad, 1 rpm = 2 pi/60
/// rad/s. English mass is lbm, force lbf; since everything is computed in SI, the constant 386.09
/// lbm.in/(lbf.s^2) never appears.
namespace adore::deck::unit {

inline constexpr double kInch = 0.0254;
inline constexpr double kPoundMass = 0.45359237;
inline constexpr double kPoundForce = 4.4482216152605;
inline constexpr double kRankine = 5.0 / 9.0;
inline constexpr double kRpm = 2.0 * kPi / 60.0;

inline constexpr UnitPair kNone{"", "", 1.0, 1.0};    ///< codes and strings
inline constexpr UnitPair kPure{"-", "-", 1.0, 1.0};  ///< dimensionless numbers

inline constexpr UnitPair kLength{"m", "in", 1.0, kInch};
inline constexpr UnitPair kAngle{"deg", "deg", kDegree, kDegree};
inline constexpr UnitPair kRadian{"rad", "rad", 1.0, 1.0};
inline constexpr UnitPair kWaves{"cycle/rev", "cycle/rev", 1.0, 1.0};  ///< a count, not an angle
inline constexpr UnitPair kPercent{"%", "%", 0.01, 0.01};
inline constexpr UnitPair kTime{"s", "s", 1.0, 1.0};
inline constexpr UnitPair kFrequency{"Hz", "Hz", 1.0,
                                     1.0};  ///< stays 1/s; omega = 2 pi f is the reader's business
inline constexpr UnitPair kSpeed{"m/s", "in/s", 1.0, kInch};
inline constexpr UnitPair kPerSpeed{"s/m", "s/in", 1.0, 1.0 / kInch};
inline constexpr UnitPair kAcceleration{"m/s^2", "in/s^2", 1.0, kInch};
inline constexpr UnitPair kRotation{"rpm", "rpm", kRpm, kRpm};
inline constexpr UnitPair kRotationRate{"rpm/s", "rpm/s", kRpm, kRpm};
inline constexpr UnitPair kMass{"kg", "lbm", 1.0, kPoundMass};
inline constexpr UnitPair kInertia{"kg.m^2", "lbm.in^2", 1.0, kPoundMass* kInch* kInch};
inline constexpr UnitPair kForce{"N", "lbf", 1.0, kPoundForce};
inline constexpr UnitPair kMoment{"N.m", "lbf.in", 1.0, kPoundForce* kInch};
inline constexpr UnitPair kStress{"N/m^2", "lbf/in^2", 1.0, kPoundForce / (kInch * kInch)};
inline constexpr UnitPair kDensity{"kg/m^3", "lbm/in^3", 1.0, kPoundMass / (kInch * kInch * kInch)};
inline constexpr UnitPair kTemperature{"K", "R", 1.0, kRankine};
inline constexpr UnitPair kPerTemperature{"1/K", "1/R", 1.0, 1.0 / kRankine};
inline constexpr UnitPair kConductivity{"W/m/K", "lbf.in/in/R/s", 1.0, kPoundForce / kRankine};
inline constexpr UnitPair kConductivityAsForce{"N/s/K", "lbf/s/R", 1.0,
                                               kPoundForce / kRankine};  ///< the same quantity
inline constexpr UnitPair kSpecificHeat{"J/kg/K", "lbf.in/lbm/R", 1.0,
                                        kPoundForce* kInch / (kPoundMass * kRankine)};
inline constexpr UnitPair kConvection{"W/m^2/K", "lbf.in/s/in^2/R", 1.0,
                                      kPoundForce / (kInch * kRankine)};
inline constexpr UnitPair kVolumeFlow{"m^3/s", "in^3/s", 1.0, kInch* kInch* kInch};
inline constexpr UnitPair kViscosity{"N.s/m^2", "lbf.s/in^2", 1.0, kPoundForce / (kInch * kInch)};
inline constexpr UnitPair kPerStress{"m^2/N", "in^2/lbf", 1.0, kInch* kInch / kPoundForce};
inline constexpr UnitPair kRockwell{
    "HRC", "HRC", 1.0, 1.0};  ///< a scale, turned into a pressure by the material model

}  // namespace adore::deck::unit
