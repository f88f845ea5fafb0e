#pragma once

#include <array>
#include <optional>

namespace adore::bearing {

/// Source of temperatures: the closed network, or the manual's ladder from one base
/// temperature (run option thermalModel).
enum class ThermalModel : unsigned char { Network, Ladder };

/// Surroundings that only run options describe. Empty: the default of
/// thermal/bearing_heat.hpp.
struct Surroundings {
  std::optional<double> ambient;                     ///< [K]
  std::array<std::optional<double>, 2> conductance;  ///< housing, shaft to ambient [W/K]
  std::optional<double> coolant_inlet;               ///< [K]
};

/// Data of a deck with kTherm = 1 on its thermal analysis (records 3.5, 9.7, 9.8). SI, kelvin.
struct ThermalInputs {
  int coolant = 0;                ///< kCoolant: 0 none, 1 the lubricant, 2 given, 3 to 14 a fluid
  int base = 0;                   ///< kBaseTemp: whose temperature is `base_temperature`
  bool convection_given = false;  ///< kHTC
  int geometry_every = 0;         ///< kGeoMod: thermal steps from one change to the next; 0: never
  double base_temperature = 0.0;
  double flow = 0.0;                                       ///< of the coolant [m³/s]
  double element_convection = 0.0, cage_convection = 0.0;  ///< given [W/(m² K)]
  double average_time = 0.0, skip_time = 0.0;              ///< of thermal steps [s]
  double density = 0.0, viscosity = 0.0, specific_heat = 0.0,
         conductivity = 0.0;  ///< of a given coolant [kg/m³, Pa s, J/(kg K), W/(m K)]
  ThermalModel model = ThermalModel::Network;
  Surroundings surroundings;
};

}  // namespace adore::bearing
