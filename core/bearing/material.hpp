#pragma once

#include <string>
#include <vector>

/// Material properties in SI, from the embedded table or from the deck.
namespace adore::bearing {

struct Material {
  int code = 0;  ///< the manual's code; 0 default, 1 given in the deck
  std::string name;
  double density = 0.0;               ///< [kg/m^3]
  double elastic_modulus = 0.0;       ///< E [Pa]
  double poisson_ratio = 0.0;         ///< [-]
  double thermal_expansion = 0.0;     ///< mean coefficient 20-100 °C [1/K]
  double conductivity = 0.0;          ///< [W/(m K)]
  double specific_heat = 0.0;         ///< [J/(kg K)]
  double elastic_strain_limit = 0.0;  ///< [-]
  double hardness = 0.0;              ///< indentation pressure [Pa]
  double wear_coefficient = 0.0;      ///< Archard K, volume rate = K/H Q V [-]
  double fatigue_limit_stress =
      0.0;  ///< von Mises fatigue limit [Pa]; yield where no limit is known
  std::string
      provenance;  ///< weakest provenance word of the values above: seen, recalled, estimated, deck
  std::string table_key;  ///< key in the material table, "100" or "mild_steel"; empty when the deck
                          ///< gives the values
};

/// Which part asks: code 0 means 52100 for races and elements, mild steel for the rest.
enum class Part : unsigned char { RollingElement, OuterRace, InnerRace, Housing, Shaft, Cage };

/// Looks a code up in resources/materials.json (room-temperature values).
/// @throws InputError naming the valid codes.
Material material_from_table(int code, Part part);

/// All codes of the table, ascending.
std::vector<int> material_codes();

/// Indentation pressure [Pa] for a Rockwell C number: table of ASTM E140 as recalled
/// (materials.json), linear between its points, extrapolated by the end slopes outside 20-64; H
/// = 9.80665e6 HV.
double hardness_from_hrc(double hrc);

/// 1/E* = (1-ν1²)/E1 + (1-ν2²)/E2; returns E* [Pa] (not the 2E* of film-thickness papers).
double contact_modulus(const Material& a, const Material& b);

}  // namespace adore::bearing
