#pragma once

#include "bearing/rollers.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

/// Shape of a roller: radius over its axis, ends, and its slices.
///
/// s runs along the roller axis from mid length, -L/2 <= s <= L/2; end 1 is at -L/2 (the large end
/// of a tapered roller, towards -x), end 2 at +L/2. SI, rad.
///   ρ(s) = D/2 - s tan ν - d(s)
/// Crowned: d = k e²/(1 + √(1 - k²e²)), k = 1/R_c, e = max(|s - o| - L_c/2, 0): crown tangent to
///   the central land at its ends, drop across the axis, o = land offset [choice]. The other
///   reading, one arc about mid length that meets the land at a kink, is not taken (pressure spike
///   there).
/// Arc: one circle of radius R_c whose normal at s = 0 makes the angle ν with the radius [choice]:
///   ρ = D/2 - R_c cos ν + √(R_c² - (s + R_c sin ν)²); written as the drop from the cone, [derived]
///   d = k s² (1 + tan ν (k s + 2 sin ν)/w)/w, w = cos ν + √(1 - (k s + sin ν)²).
/// Either may have a form of the user's more (bearing::RollerProfileDeviation), which is taken off
/// d. Both forms are free of cancellation for any R_c, infinity included (R_c - √(R_c² - e²) loses
/// 2 µm at 1e10 m).
namespace adore::contact {

inline constexpr double kFlatEndRadius =
    1e9;  ///< an end radius of 0 or above this means a flat end [m]

struct RollerProfile {
  enum class Kind : unsigned char { Crowned, Arc } kind = Kind::Crowned;
  double diameter = 0.0;    ///< D at s = 0 (where a crowned roller has its land) [m]
  double length = 0.0;      ///< L from end to end, domes included [choice] [m]
  double half_angle = 0.0;  ///< ν >= 0, radius falls with s [rad]
  double crown_radius = std::numeric_limits<double>::infinity();  ///< R_c [m]; infinity: straight
  double central_length = 0.0;                                    ///< L_c, crowned only [m]
  double land_offset = 0.0;               ///< o, crowned only, towards +s [m]
  std::array<double, 2> corner_radius{};  ///< ends 1, 2 [m]
  std::array<double, 2> end_radius{};     ///< R_e of ends 1, 2 [m]; 0 or > kFlatEndRadius: flat
  std::shared_ptr<const bearing::RollerProfileDeviation> form;  ///< null: none
};

/// d(s) of crown or arc alone [m].
[[nodiscard]] inline double crown_drop(const RollerProfile& p, double s) noexcept {
  const double k = 1.0 / p.crown_radius;
  if (p.kind == RollerProfile::Kind::Crowned) {
    const double e = std::abs(s - p.land_offset) - 0.5 * p.central_length;
    if (e <= 0.0) return 0.0;
    return k * e * e / (1.0 + std::sqrt(1.0 - k * k * e * e));
  }
  const double sine = std::sin(p.half_angle), cosine = std::cos(p.half_angle);
  const double turned = k * s + sine;
  const double w = cosine + std::sqrt(1.0 - turned * turned);
  return k * s * s * (1.0 + sine / cosine * (turned + sine) / w) / w;
}

/// Drop d(s) below the straight cone [m].
[[nodiscard]] inline double profile_drop(const RollerProfile& p, double s) noexcept {
  const double drop = crown_drop(p, s);
  return p.form ? drop - p.form->at(s).more : drop;
}

/// ρ(s) [m].
[[nodiscard]] inline double roller_radius(const RollerProfile& p, double s) noexcept {
  return 0.5 * p.diameter - s * std::tan(p.half_angle) - profile_drop(p, s);
}

/// dρ/ds of crown or arc alone [-]. Crowned: -tan ν - sign(s - o) k e/√(1 - k²e²); arc: -t/√(1 -
/// t²), t = k s + sin ν.
[[nodiscard]] inline double crown_slope(const RollerProfile& p, double s) noexcept {
  const double k = 1.0 / p.crown_radius;
  if (p.kind == RollerProfile::Kind::Crowned) {
    const double from_land = s - p.land_offset;
    const double e = std::abs(from_land) - 0.5 * p.central_length;
    const double cone = -std::tan(p.half_angle);
    if (e <= 0.0) return cone;
    return cone - std::copysign(k * e / std::sqrt(1.0 - k * k * e * e), from_land);
  }
  const double turned = k * s + std::sin(p.half_angle);
  return -turned / std::sqrt(1.0 - turned * turned);
}

/// dρ/ds [-].
[[nodiscard]] inline double roller_slope(const RollerProfile& p, double s) noexcept {
  const double slope = crown_slope(p, s);
  return p.form ? slope + p.form->at(s).slope : slope;
}

[[nodiscard]] inline bool is_flat_end(const RollerProfile& p, int end) noexcept {
  const double radius = p.end_radius[static_cast<std::size_t>(end)];
  return radius == 0.0 || radius > kFlatEndRadius;
}

/// L_e = L - r_1 - r_2: the length that can touch a race [choice] [m].
[[nodiscard]] inline double effective_length(const RollerProfile& p) noexcept {
  return p.length - p.corner_radius[0] - p.corner_radius[1];
}

/// Checks that the shape exists: sizes positive, arcs defined over the length, radius positive,
/// domes wide enough.
/// @throws InputError naming what is wrong.
void check_roller_profile(const RollerProfile& profile);

/// One end: dome or flat, corner torus, and where they meet. v = ±s is measured outwards.
/// The corner is a tube of radius r_c about a ring of radius ρ_c at v_c, tangent to the side ρ(s)
/// and to the end [derived]: flat v_c = L/2 - r_c; dome (v_c - v_E)² + ρ_c² = (R_e - r_c)², v_E =
/// L/2 - R_e. On a straight cone this is ρ_c cos ν + s_c sin ν = (D/2) cos ν - r_c; crowned and arc
/// sides are met where they are, with their own slope.
struct RollerEnd {
  int sign = 1;                ///< -1 end 1, +1 end 2: s = sign·v
  double vertex = 0.0;         ///< v of the end face or of the top of the dome, L/2 [m]
  double end_radius = 0.0;     ///< R_e; infinity: flat [m]
  double dome_centre = 0.0;    ///< v_E; unused when flat [m]
  double corner_radius = 0.0;  ///< r_c; 0: sharp edge [m]
  double ring_radius = 0.0;    ///< ρ_c [m]
  double ring = 0.0;           ///< v_c [m]
  double cap_radius =
      0.0;  ///< distance from the axis at which the end face passes into the corner [m]
  double side_v = 0.0, side_angle = 0.0;  ///< where the corner passes into the side; angle of its
                                          ///< normal from the axis [m, rad]

  [[nodiscard]] bool flat() const noexcept { return std::isinf(end_radius); }
};

/// @param end 0 (at -L/2) or 1 (at +L/2)
/// @throws InputError when corner and dome do not fit the roller.
[[nodiscard]] RollerEnd roller_end(const RollerProfile& profile, int end);

/// n equal slices between -L/2 + r_1 and L/2 - r_2.
struct Slicing {
  int count = 0;
  double width = 0.0;  ///< w = L_e/n along the axis; the 1/cos ν of a cone's generator is left out
                       ///< [choice] [m]
  double effective_length = 0.0;  ///< L_e [m]
  double start = 0.0;             ///< s of the first edge [m]
  [[nodiscard]] double centre(int k) const noexcept { return start + (k + 0.5) * width; }
};
/// @throws InputError when n < 1 or the corners leave no length.
[[nodiscard]] Slicing slicing(const RollerProfile& profile, int count);

struct RollerSlice {
  double s = 0.0, radius = 0.0;  ///< place along the axis and ρ(s) [m]
};
[[nodiscard]] std::vector<RollerSlice> roller_slices(const RollerProfile& profile,
                                                     const Slicing& slicing);

/// Number of slices that keeps the load within about 0.1 % [derived, by comparison with the
/// continuum]: n = 20 L_e/ℓ, ℓ = √(8 R_c δ) <= L_e, but not below 20. Use 31 where nothing is known
/// [choice].
[[nodiscard]] int suggested_slice_count(const RollerProfile& profile, double penetration);

/// Drop of the logarithmic profile, A ln(1/(1 - (2x/L)²)) [m]; infinite at the ends. A = 0.00035 D
/// is the usual choice [recalled]. Not a shape of the deck; for comparisons.
[[nodiscard]] inline double logarithmic_drop(double x, double length, double amplitude) noexcept {
  const double ratio = 2.0 * x / length;
  return -amplitude * std::log1p(-ratio * ratio);
}

}  // namespace adore::contact
