#pragma once

#include <string>

/// Static safety s0 = C0/P0 of ISO 76 from the equivalent static load P0.
///
/// Radial bearings: P0 = X0 Fr + Y0 Fa, of one row not below Fr.
///   deep groove ball            X0 0.6  Y0 0.5 (one or two rows)
///   angular contact ball        X0 0.5  Y0 by the angle (0.46 at 15 deg ... 0.22 at 45 deg)
///   the same, two rows          X0 1    Y0 twice that of one row
///   self-aligning, tapered, spherical: one row X0 0.5, Y0 0.22 cot(angle); two rows 1 and 0.44 cot
///   cylindrical roller, needle  P0 = Fr; an axial load acts on the flanges
/// Thrust bearings: angle 90 deg P0 = Fa without radial load, else P0 = Fa + 2.3 Fr tan(angle).
/// Loads act in one direction of the bearing; signs do not matter. Loads [N], angles [rad].
namespace adore::life {

enum class StaticBearingType : unsigned char {
  DeepGroove,
  AngularContact,
  SelfAligning,  ///< ball; and tapered and spherical roller bearings
  Cylindrical,   ///< and needle
  Thrust
};

struct StaticLoadFactors {
  double X0 = 1.0, Y0 = 0.0;
  bool at_least_radial = true;  ///< P0 is not below Fr
  std::string provenance;       ///< "seen" or "recalled", with the source
};

/// @param angle contact angle; tapered: half the cup angle @param rows 1 or 2
/// @throws InputError for an angle that the type does not have
[[nodiscard]] StaticLoadFactors static_factors(StaticBearingType type, double angle, int rows);

/// @throws InputError for a radial load on a thrust bearing of 90 deg
[[nodiscard]] double equivalent_static_load(const StaticLoadFactors& factors, double radial,
                                            double axial);

}  // namespace adore::life
