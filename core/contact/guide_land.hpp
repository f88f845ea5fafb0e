#pragma once

#include "base/rotation.hpp"
#include "bearing/imperfections.hpp"
#include "contact/conformal.hpp"

#include <algorithm>
#include <array>
#include <cmath>

/// Contact of a cage guide land with the land of a race.
///
/// Race frame: x along the race axis, origin at the race centre. The cage pose is its geometric
/// centre g in that frame and T (race -> cage components). Cage land of radius R_c, race land of
/// radius R_r = R_c + c (outer guidance) or R_c - c (inner), c radial clearance. Gap h = ±(R_r -
/// r_P) of a cage point P, + outer; open when positive. Foundation law of conformal.hpp: pressure
/// k_w(-h), k_w = 3πE*/(16 R_c). SI, rad.
namespace adore::contact {

/// Signed land centre from the deck's outer edge position (N91): pos - sign(pos) width/2.
[[nodiscard]] inline double land_center_position(double edge, double width) noexcept {
  return edge - std::copysign(0.5 * width, edge);
}

/// Radius of a land over azimuth ψ (from the body's own z about +x).
struct LandProfile {
  enum class Kind : unsigned char { Circle, Ellipse, Wave } kind = Kind::Circle;
  double radius = 0.0;       ///< nominal [m]
  double variation_1 = 0.0;  ///< ellipse: half axis along y minus nominal; wave: amplitude [m]
  double variation_2 = 0.0;  ///< ellipse: half axis along z minus nominal [m]; wave: waves per turn
  double phase = 0.0;        ///< wave [rad]

  /// R(ψ), dR/dψ. Ellipse: (sin²ψ/a_y² + cos²ψ/a_z²)^(-1/2); wave: R + A sin(Nψ + phase).
  [[nodiscard]] std::array<double, 2> at(double psi) const noexcept;
};

/// @param radius nominal [m]
[[nodiscard]] inline LandProfile land_profile(double radius,
                                              const bearing::LandErrors& errors) noexcept {
  if (errors.ideal()) return {LandProfile::Kind::Circle, radius, 0.0, 0.0, 0.0};
  const bool wave = errors.roundness == bearing::RaceErrors::Roundness::Sinusoidal;
  return {wave ? LandProfile::Kind::Wave : LandProfile::Kind::Ellipse, radius, errors.variation[0],
          errors.variation[1], wave ? errors.variation[2] : 0.0};
}
/// Least and largest R(ψ) minus nominal [m].
[[nodiscard]] inline std::array<double, 2> land_deviation_range(const LandProfile& land) noexcept {
  if (land.kind == LandProfile::Kind::Circle) return {0.0, 0.0};
  if (land.kind == LandProfile::Kind::Wave)
    return {-std::abs(land.variation_1), std::abs(land.variation_1)};
  return {std::min(land.variation_1, land.variation_2),
          std::max(land.variation_1, land.variation_2)};
}

/// One land of the cage and of the race that guides it.
struct LandPair {
  bool outer = true;
  LandProfile cage, race;
  double centre_x = 0.0, width = 0.0;  ///< [m]
  int slices = 1;
};

struct LandGap {
  double gap = 0.0;      ///< least gap of a slice [m]
  double azimuth = 0.0;  ///< where, in the cage frame, [0, 2π)
  Vec3 point;            ///< on the cage, race frame [m]
};

/// Least gap of the slice at axial position x of the cage: grid finer than a quarter wave, then
/// refined to ~1e-15 m.
[[nodiscard]] LandGap min_land_gap(const LandPair& land, double x, const Vec3& g,
                                   const Mat3& race_to_cage);

struct LandLoad {
  Vec3 force = Vec3::Zero();   ///< on the cage, race axes [N]
  Vec3 moment = Vec3::Zero();  ///< on the cage about its centre, race axes [N m]
  double energy = 0.0;         ///< ½ k_w ∫∫ min(h,0)² R_c dψ dx [J]
};

/// Foundation law summed over the slices; force = -∂energy/∂pose. Integrated between the exact ends
/// of each contact spot.
[[nodiscard]] LandLoad land_load(const LandPair& land, double E_star, const Vec3& g,
                                 const Mat3& race_to_cage);

/// Axial position of the middle of slice k.
[[nodiscard]] inline double slice_position(const LandPair& land, int k) noexcept {
  return land.centre_x + ((k + 0.5) / land.slices - 0.5) * land.width;
}

}  // namespace adore::contact
