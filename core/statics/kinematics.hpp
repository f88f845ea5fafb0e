#pragma once

/// Speeds of a bearing from its geometry alone: pure rolling at both races at one common contact
/// angle.
namespace adore::statics {

/// Speed of the element set for rolling without slip: ½ [Ω_i (1 - γ) + Ω_o (1 + γ)], γ = (D/d_m)
/// cos α [rad/s].
[[nodiscard]] inline double epicyclic_speed(double outer_speed, double inner_speed,
                                            double gamma) noexcept {
  return 0.5 * (inner_speed * (1.0 - gamma) + outer_speed * (1.0 + gamma));
}

/// Speeds [rad/s] and passing frequencies [Hz]. γ = (D/d_m) cos α; race speeds about +x.
struct EpicyclicSpeeds {
  double gamma = 0.0;         ///< (D/d_m) cos α
  double cage_speed = 0.0;    ///< ω_m = ½[ω_i(1-γ) + ω_o(1+γ)], signed [rad/s]
  double element_spin = 0.0;  ///< relative to the cage, |ω_i-ω_o| d_m(1-γ²)/(2D) [rad/s]
  double outer_pass = 0.0;    ///< BPFO = Z|ω_m-ω_o|/2π [Hz]
  double inner_pass = 0.0;    ///< BPFI = Z|ω_i-ω_m|/2π [Hz]
  double spin_frequency =
      0.0;  ///< BSF = element_spin/2π [Hz]; a flaw of the element strikes a race at twice this
  double cage_frequency = 0.0;  ///< FTF = ω_m/2π, signed [Hz]
};

/// @throws InputError when Z < 1, D <= 0, d_m <= D cos α or a value is not finite.
[[nodiscard]] EpicyclicSpeeds epicyclic_speeds(int count, double diameter, double pitch_diameter,
                                               double contact_angle, double outer_speed,
                                               double inner_speed);

}  // namespace adore::statics
