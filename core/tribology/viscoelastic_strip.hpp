#pragma once

/// Visco-elastic film along one strip of a contact that rolls with speed u:
///   (u/G) dτ/dx + (τ0/μ) F(τ/τ0) = slip/h,  τ(-b) = 0,
/// F = sinh (Johnson & Tevaarwerk 1977, Eyring) or atanh (Bair & Winer 1979, τ0 is then a limit).
/// The manual prints asinh for the first: taken literally the film would thicken with shear, so the
/// suite has sinh (decision 271). p = p0 √(1 - x²/b²), G = G0 + Gp p, τ0 = τ00 + τ0p p, ln(μ/μ0) =
/// min(α p, cap). SI.
///
/// Method: nodes x_i = -b cos(π i/N), implicit Euler, F multiplied by k/μ (k = G δ/u) on the left,
/// which rises in the unknown: a safeguarded Newton always ends. Error of the force 0.01 to 0.1 %
/// at N = 160, first order in N.
namespace adore::tribology {

struct ViscoElasticStrip {
  bool sinh_law = false;       ///< else atanh
  double half_length = 0.0;    ///< b [m]
  double peak_pressure = 0.0;  ///< p0 [Pa]
  double thickness = 0.0;      ///< h [m]
  double speed = 0.0;          ///< u [m/s], > 0
  double viscosity = 0.0;      ///< μ0 [Pa s]
  double alpha = 0.0, log_cap = 27.6;
  double modulus = 0.0, modulus_p = 0.0;  ///< G0 [Pa], Gp
  double stress = 0.0, stress_p = 0.0;    ///< τ00 [Pa], τ0p
};

/// ∫τ dx/∫p dx for slip >= 0 [m/s], on N cells; with `extrapolate` the value of Richardson from N/2
/// and N.
[[nodiscard]] double strip_coefficient(const ViscoElasticStrip& strip, double slip, int cells,
                                       bool extrapolate = false);

}  // namespace adore::tribology
