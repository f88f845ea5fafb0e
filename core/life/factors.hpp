#pragma once

#include <optional>
#include <string>

/// Life modification factors: STLE (recalled tables) and a Tallian-type form of this project.
namespace adore::life {

/// exp(0.1 (Rc - 60)), Rc Rockwell C hardness at operating temperature (recalled).
[[nodiscard]] double hardness_factor(double rockwell_c);

/// STLE film factor over Λ = h_min/σ_rms: log-log interpolation of a table digitized from memory,
/// take ±30 %; held outside 0.2..10.
/// @throws InputError for Λ <= 0
[[nodiscard]] double film_factor(double film_parameter);

/// 1.8 FR^-0.25, FR filter rating in µm at beta 200 (recalled); about 1 at 10 µm. @throws
/// InputError
[[nodiscard]] double filter_factor(double micrometres);

/// (τ_max/(τ_max - S/2))^9, S > 0 compressive residual stress [Pa] (recalled). Empty when S >= 2
/// τ_max, where the form has no meaning.
[[nodiscard]] std::optional<double> residual_stress_factor(double max_shear, double compressive,
                                                           double exponent = 9.0);

struct StleFactors {
  double material = 1.0, process = 1.0, hardness = 1.0;
  std::optional<double> film_parameter;  ///< Λ; empty: unknown, film factor 1
  double filter = 1.0, residual = 1.0;
};
struct StleResult {
  double factor = 1.0;
  double film = 1.0;
  bool thin_film = false;  ///< Λ < 1: no credit for material, process and hardness
};
/// LF = LF_mat LF_proc LF_hard LF_film (filter, residual). Below Λ = 1 min(LF_mat LF_proc LF_hard,
/// 1) stands for the first three: a jump at Λ = 1.
[[nodiscard]] StleResult stle_factor(const StleFactors& factors);

struct TallianFactors {
  double material = 1.0, process = 1.0, contamination = 1.0;  ///< hazard multipliers
  double asperity = 1.0;                                      ///< φ_asp
};
/// φ_asp = 1 + C_a (θ/0.02)² ((1 + μ/0.1)/2)² G(Λ), G(x) = erfc(x/√2)/2, C_a such that the life
/// factor is 0.40 at Λ = 1, θ = 0.02, μ = 0.1 and e = 10/9. Form of this project: Tallian's own was
/// not available. @param slope θ, composite rms [rad] @param traction μ
[[nodiscard]] double asperity_hazard(double film_parameter, double slope, double traction);

struct TallianResult {
  double hazard = 1.0;  ///< φ = product
  double factor = 1.0;  ///< φ^(-1/e)
};
[[nodiscard]] TallianResult tallian_factor(const TallianFactors& factors, double slope);

}  // namespace adore::life
