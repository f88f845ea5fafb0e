#pragma once

#include "bearing/lubrication.hpp"
#include "calculators/adapter.hpp"

#include <optional>
#include <string>
#include <vector>

/// Behavior of a lubricant of kTrac in one contact, over slip, pressure and speed: the numbers
/// behind `adore calc traction`, `adore plot --lubricant` and AdrInput's charts of record 10. SI.
///
/// The contact is a point between two bodies of radius `radius` along rolling and `across` over it,
/// both of one modulus. Traction is that of a disc machine: the ellipse slips by one speed
/// everywhere, κ = F/Q with the film of that load, speed and slip; below the critical film the
/// curve of record 10.1. Temperatures of inlet and walls are equal, as in motion.
namespace adore::calculators {

struct LubricantContact {
  int code = 0;                                ///< kTrac 1 to 20
  std::optional<bearing::UserLubricant> user;  ///< with kTrac 9
  double temperature = 350.0;                  ///< of oil and walls [K]
  double radius = 0.006;                       ///< of both bodies along rolling [m]
  double across = 0.15;                        ///< of both across it [m]
  double modulus = 2.26e11;                    ///< E' [Pa], steel on steel
  double pressure = 1.2e9;                     ///< largest [Pa]
  double speed = 10.0;                         ///< mean of both surfaces [m/s]
  double roughness = 1.0e-7;                   ///< of both, root of the sum of squares [m]
  double critical_film = 1.0e-8;               ///< reRaceFilm [m]
  double meniscus = 10.0;                      ///< strParam
  bool stress_limit = true;                    ///< the film has its limiting shear stress
  bool recommended = false;                    ///< traction by the recommended law of the oil
  int metal_type = 1;                          ///< kTracType of the metal contact
  /// Its four values, of record 10.1C unless said else.
  std::vector<double> metal{0.0, 0.1, 0.08, 1.0};
};

struct LubricantContactResult {
  double load = 0.0, half_width = 0.0, ratio = 1.0;  ///< [N], b [m], a/b
  double viscosity = 0.0, alpha = 0.0;               ///< of the inlet [Pa s], [1/Pa]
  double central = 0.0, minimum = 0.0;               ///< film at slip 0 [m]
  double thermal = 1.0, starvation = 1.0;            ///< factors in it
  double lambda = 0.0;                               ///< minimum over roughness
  std::vector<double> traction;                      ///< one a slip
};
/// @param slips [m/s], either sign: traction has that of its slip
/// @throws InputError for a code, temperature or size that is none
[[nodiscard]] LubricantContactResult solve_lubricant_contact(const LubricantContact& contact,
                                                             const std::vector<double>& slips);

struct NamedCurve {
  std::string name;
  std::vector<double> x, y;
};
struct CurveChart {
  std::string title, x_title, x_unit, y_title, y_unit;
  bool log_x = false, log_y = false;
  std::vector<NamedCurve> curves;
};
/// To which the charts of traction and viscosity go [Pa].
inline constexpr double kLargestPressure = 2.0e9;
struct LubricantCurves {
  std::string name;        ///< of the lubricant
  std::string provenance;  ///< weakest word for its numbers; "given" of kTrac 9
  std::string conditions;  ///< of the contact, a sentence
  /// A film uses the lower limit of the inlet heating factor (thermal_reduction.hpp).
  bool beyond_heating = false;
  /// Of traction and viscosity beyond the measurements (lubricant_range.hpp); empty: within.
  std::string extrapolation_note;
  CurveChart traction, viscosity, film, lambda;
  /// Traction over slip by each code that describes the same oil, in the middle strip of the
  /// contact; without curves where there is one code.
  CurveChart laws;
  std::string recommended;  ///< "MIL-L-23699: kTrac 11 is recommended (...)"; empty: one code
};
[[nodiscard]] LubricantCurves lubricant_curves(const LubricantContact& contact);

/// Family "lubricant_traction".
std::vector<Adapter> lubricant_adapters();

}  // namespace adore::calculators
