#pragma once

#include "base/finding.hpp"
#include "bearing/material.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

/// How a bearing is mounted, and what fits, temperatures and speeds make of its geometry. SI;
/// arrays of two are [0] = outer race in the housing, [1] = inner race on the shaft. Clearances and
/// fits are diametral, growths radial.
namespace adore::bearing {

/// Surroundings of the rings (records 3.3, 3.5, 9.0, 9.1.3); their radii are in the Envelope.
struct Mounting {
  std::array<double, 2> fit{};  ///< allowance at room temperature, > 0 interference, < 0 loose [m]
  Material housing, shaft;      ///< of the parts around the rings
  double housing_temperature = 293.15, shaft_temperature = 293.15;  ///< [K]
  bool material_laws = false;      ///< kMatPropMod = 1: properties follow temperature
  bool centrifugal_growth = true;  ///< named option centrifugalGrowth
};

/// One interference fit.
struct FitState {
  double allowance = 0.0;         ///< given, at room temperature and rest [m]
  double interference = 0.0;      ///< operating; < 0 is a running clearance [m]
  double mounted_pressure = 0.0;  ///< at room temperature and rest [Pa]
  double pressure = 0.0;          ///< operating [Pa]
  double race_hoop = 0.0;  ///< operating hoop stress of largest size in the race, > 0 tension [Pa]
  double mate_hoop = 0.0;  ///< the same in housing or shaft [Pa]
  double race_limit =
      0.0;  ///< elastic limit of the race: strain limit times modulus; 0 = not known [Pa]
  double mate_limit = 0.0;  ///< of housing or shaft; 0 = not known [Pa]
};

/// Radial displacement of a surface and what causes it [m], outward positive.
struct Growth {
  double thermal = 0.0, centrifugal = 0.0, pressure = 0.0;
  [[nodiscard]] double total() const { return thermal + centrifugal + pressure; }
};

/// Clearance and what follows from it in one state of the bearing.
struct ClearanceState {
  double clearance = 0.0;        ///< diametral, < 0 is preload [m]
  double contact_angle = 0.0;    ///< free contact angle of a ball bearing [rad]
  double end_play = 0.0;         ///< free axial clearance 2 A sin α of a ball bearing [m]
  double centre_distance = 0.0;  ///< A of the curvature centers of a ball bearing [m]
};

/// A clearance of the cage.
struct CageClearance {
  std::string name;
  double free = 0.0, operating = 0.0;  ///< diametral [m]
};

/// Results of thermal::operating_bearing; stored in the operating Bearing for the listings.
struct OperatingFits {
  bool changed =
      false;  ///< false: nothing grows or presses, the geometry is the input's bit by bit
  std::array<FitState, 2> fit;
  std::array<Growth, 2> raceway;            ///< at the groove bottom
  std::array<Growth, 2> race_at_fit;        ///< race at the interface, without pressure
  std::array<Growth, 2> mate_at_fit;        ///< housing bore, shaft outside, without pressure
  std::array<double, 2> raceway_radius{};   ///< groove bottom, free [m]
  double element_growth = 0.0;              ///< of the diameter [m]
  std::optional<double> axial_setting;      ///< cones: change of the axial setting, above 0 where
                                            ///< the radial clearance shrank [m]
  ClearanceState free, mounted, operating;  ///< unmounted cold; mounted cold at rest; in operation
  std::array<double, 2> locus_free{}, locus{};  ///< radius of the circle of curvature centers [m]
  double pitch_free = 0.0, pitch = 0.0;         ///< pitch diameter [m]
  double cage_speed = 0.0;     ///< epicyclic, for the cage's centrifugal growth [rad/s]
  std::array<Growth, 2> cage;  ///< outside, bore
  std::vector<CageClearance>
      plays;                      ///< guide lands, unguided surfaces, pockets; empty without cage
  std::vector<Finding> warnings;  ///< fit.clearance, fit.loose, fit.hoop_stress ...
};

}  // namespace adore::bearing
