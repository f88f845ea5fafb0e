#pragma once

#include "base/rotation.hpp"
#include "bearing/bearing.hpp"

/// Mass, mass centre and inertia of a cage from its ideal geometry: a shell between two diameters
/// over the width minus one pocket per element. Lands, fillets and pocket imperfections are
/// ignored. SI. Method: each void in polar coordinates ∫ r dr ∫ 2 h_x dφ (half chord h_x along the
/// axis), Gauss points, exact to ~1e-12; in conical cages exact for pockets of constant section, to
/// some 1e-6 of the void for others and for cut ones.
namespace adore::contact {

/// What the integrals need. The cage frame has x along the axis, origin on the axis at mid width.
struct CageSolid {
  bearing::PocketShape pocket = bearing::PocketShape::Cylindrical;
  double outer_diameter = 0.0, inner_diameter = 0.0, width = 0.0;  ///< [m]
  int pockets = 0;
  double element_diameter = 0.0, pitch_diameter = 0.0;  ///< [m]
  double clearance_1 = 0.0, clearance_2 = 0.0;          ///< C1, C2 of the pocket [m]
  /// > 0: roller pocket of this axial length [m]. Rectangular: a window of parallel faces;
  /// Cylindrical: a cylinder about the roller's axis (roller-guided cage).
  double roller_length = 0.0;
  double density = 0.0;     ///< [kg/m^3]
  double cone_angle = 0.0;  ///< > 0: radii fall with x [rad]
  // Segmented cage; segments <= 1: one piece.
  int segments = 1;
  double cut_angle = 0.0;  ///< angle removed between segments [rad]
  bool cut_at_pocket =
      false;  ///< the cuts go through pockets; otherwise through the middle of the bars
};

struct SolidInertia {
  double volume = 0.0, mass = 0.0;  ///< [m^3, kg]
  Vec3 mass_centre =
      Vec3::Zero();  ///< in the geometric frame of the piece (z through its angular middle) [m]
  Mat3 inertia = Mat3::Zero();  ///< about the mass centre, geometric axes [kg m^2]
};

/// @throws InputError when diameters or width are not positive, pockets overlap, or a pocket is
/// wider than the cage.
[[nodiscard]] SolidInertia cage_solid_inertia(const CageSolid& solid);

/// The cage of a bearing, or one of its pieces. A roller's window is as long as the roller and as
/// wide as its diameter at mid length and the pocket's play. @pre the bearing has a cage
[[nodiscard]] CageSolid cage_solid(const bearing::Bearing& bearing);

/// Mass and moments of that cage or piece about its mass centre, which in a conical cage lies off
/// the middle and of a piece far from the axis; a piece has its principal axes along those of its
/// frame (contact/cage_pieces.hpp), by its symmetry. Without material density or with a shape that
/// cannot be cut it throws as cage_solid_inertia does.
[[nodiscard]] bearing::Inertia cage_inertia(const bearing::Bearing& bearing);

/// One-piece ball cage with straight walls: the tensor is diagonal with equal transverse moments.
[[nodiscard]] bearing::Inertia cage_inertia(const bearing::Cage& geometry, int pockets,
                                            double ball_diameter, double pitch_diameter,
                                            double density);

}  // namespace adore::contact
