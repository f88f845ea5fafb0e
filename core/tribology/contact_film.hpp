#pragma once

#include "tribology/lubricant.hpp"

/// The film of one lubricated contact: isothermal, times inlet heating, times starvation. SI.
///   h = φT φS h_isothermal, with film_thickness.hpp, thermal_reduction.hpp, starvation.hpp;
/// central for traction, minimum for metal contact and Λ [choice]. Points with k < 1, and entrained
/// across the long axis, go by Chittenden et al., others by Hamrock & Dowson; lines by Dowson &
/// Toyoda and Dowson.
namespace adore::tribology {

/// The oil in the inlet, at one temperature.
struct InletOil {
  double viscosity = 0.0;     ///< μ0 [Pa s]
  double alpha = 0.0;         ///< [1/Pa]
  double beta = 0.0;          ///< -∂ln μ0/∂T [1/K]
  double conductivity = 0.0;  ///< [W/(m K)]
  double meniscus = 0.0;      ///< its distance over the half width (strParam)
};
[[nodiscard]] InletOil inlet_oil(const Lubricant& lubricant, double temperature, double meniscus);

struct LubricatedContact {
  bool line = false;
  double load = 0.0;           ///< [N]; line: per length [N/m]
  double radius = 0.0;         ///< of both bodies along rolling [m]
  double k = 1.0;              ///< point: half axis across over half axis along rolling
  double half_width = 0.0;     ///< b along rolling [m]
  double peak_pressure = 0.0;  ///< [Pa]
  double speed = 0.0;          ///< mean of both surfaces [m/s]; either sign
  double slip = 0.0;           ///< [m/s], >= 0
  double modulus = 0.0;        ///< E' = 2/[(1-ν1²)/E1 + (1-ν2²)/E2] [Pa]
};

struct ContactFilm {
  double isothermal = 0.0;              ///< central, before both factors [m]
  double thermal = 1.0;                 ///< φT
  double starvation = 1.0;              ///< φS
  double central = 0.0, minimum = 0.0;  ///< [m]
};

/// No film without load or without rolling.
[[nodiscard]] ContactFilm contact_film(const InletOil& oil, const LubricatedContact& contact);

}  // namespace adore::tribology
