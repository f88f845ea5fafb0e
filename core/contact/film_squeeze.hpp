#pragma once

#include <algorithm>
#include <cmath>

/// Damping by the squeeze of the oil film of a loaded contact. SI.
///
/// Under load the Hertz flat moves as a whole and its film, whose oil is too viscous to leave,
/// keeps its thickness. What closes is the gap outside: the approach δ̇ turns the surfaces there as
/// a flat punch on the present contact area does. With s the distance from the rim, both have the
/// edge field of plane strain [Johnson 1985, derived]:
///   Hertz pressure  p0 √(2 s/b) inside       ->  gap      h = h_c + C s^1.5,  C = 4 p0 √(2/b)/(3
///   E*) punch pressure  S/√s inside              ->  closing  V = 4 S/E* √s, S = k √(b/2)/(2π a b)
///   δ̇ of an ellipse,  k √(b/2)/(π b L) δ̇ of a line,  k = dQ/dδ
/// No oil crosses the rim, so that the flow is q = ∫ V ds outward, and Reynolds' dp/ds = -12 η0
/// q/h³ leaves at the rim
///   p_e = 12 η0 (2/3)(4 S/E*) I h_c^(-4/3) C^(-5/3),
///   I = ∫ t^1.5/(1 + t^1.5)³ dt = (1/3) Γ(5/3) Γ(4/3)
/// [derived; test: the whole equation integrated outside circle and line]. The inlet alone is
/// filled with oil: half the rim. Its pressure falls through the flat to the outlet, so that the
/// force is p_e times half the area. At the rim of an ellipse the value is that of the end of the
/// minor axis, where the oil enters [choice: the least one around].
/// Limits: η0 of the inlet at ambient pressure (piezoviscosity adds); h_c much less than the
/// approach; vibrations slower than the passage through the inlet. Taken at one load and applied
/// as a material loss (contact/damping_law.hpp) at all others.
namespace adore::contact {

struct SqueezedFilm {
  bool line = false;
  double stiffness = 0.0;      ///< k [N/m]
  double E_star = 0.0;         ///< [Pa]
  double peak_pressure = 0.0;  ///< p0 [Pa]
  double half_width = 0.0;     ///< b, along rolling [m]
  double film = 0.0;           ///< h_c [m]
  double viscosity = 0.0;      ///< η0 [Pa s]
};

/// Least film that is taken: thinner ones are broken by roughness [m] [choice].
inline constexpr double kLeastSqueezedFilm = 2e-8;

/// I of the file comment.
[[nodiscard]] inline double squeeze_integral() noexcept {
  return std::tgamma(5.0 / 3.0) * std::tgamma(4.0 / 3.0) / 3.0;
}

/// c [N s/m].
[[nodiscard]] inline double squeeze_damping(const SqueezedFilm& f) noexcept {
  const double h = std::max(f.film, kLeastSqueezedFilm);
  const double C = 4.0 / 3.0 * f.peak_pressure * std::sqrt(2.0 / f.half_width) / f.E_star;
  const double shape = f.line ? 32.0 / 3.14159265358979323846 : 8.0;
  return shape * squeeze_integral() * f.viscosity * f.stiffness * std::sqrt(0.5 * f.half_width) /
         f.E_star * std::pow(h, -4.0 / 3.0) * std::pow(C, -5.0 / 3.0);
}

}  // namespace adore::contact
