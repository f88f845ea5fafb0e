#pragma once

#include "tribology/ellipse_traction.hpp"

/// The traction of a contact ellipse by a rule that is split where a two-slope law bends: the
/// accuracy of the converged integral at a hundredth of its cost, for trajectories that are
/// compared with reference cases. A run uses the fixed rule.
namespace adore::tribology {

/// With s = sin φ, v = sin ψ the load element is Q ¾cos³φ dφ (2/π)cos²ψ dψ. Rows of constant φ are
/// cut where |u| = u0
/// (|u|² is a quadratic in v), the range of φ where those points appear or cross the edge of the
/// ellipse and where the rolling slip reverses. Gauss points in each piece, clustered in φ to its
/// ends and in ψ to the place of least slip.
/// @param points Gauss points per piece and direction, 4 to 40; 16 gives 1e-7 of the traction or
/// better.
[[nodiscard]] EllipseTraction ellipse_traction_split(const TractionLaw& law,
                                                     const EllipseGeometry& geometry,
                                                     const EllipseKinematics& motion,
                                                     int points = 12);

}  // namespace adore::tribology
