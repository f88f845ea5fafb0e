#pragma once

/// Stresses under a frictionless Hertz ellipse in an elastic half-space. Depth z > 0 points into
/// the body, compression is negative, "minor" and "major" are the axes of the contact ellipse.
namespace adore::contact {

/// The three principal stresses on the axis of the contact [Pa].
struct AxisStress {
  double major = 0.0;  ///< along the major axis
  double minor = 0.0;  ///< along the minor axis
  double depth = 0.0;  ///< along the depth

  [[nodiscard]] double max_shear()
      const noexcept;  ///< half the largest principal stress difference
  [[nodiscard]] double octahedral()
      const noexcept;  ///< (1/3) sqrt(Σ(σi-σj)²); von Mises = 3/√2 times this
};

/// Exact stresses at depth z >= 0 below the centre of an ellipse a >= b > 0 under the peak pressure
/// p_max. σ_depth = -p_max ab/sqrt((a²+z²)(b²+z²)); the lateral ones from the Boussinesq potentials
/// of the ellipsoidal pressure, written with Carlson's R_D so that circle (a = b) and long ellipse
/// need no special case. Sources: [love1929], [johnson1985 ch.3-4]. Surface limit of the circle:
/// lateral -(1+2ν)/2 p_max, depth -p_max.
[[nodiscard]] AxisStress axis_stress(double a, double b, double p_max, double poisson,
                                     double z) noexcept;

/// Largest stresses below one contact and where they act.
struct SubsurfaceStress {
  double orthogonal_shear = 0.0;   ///< max |τ_{y'z}| in the plane of minor axis and depth [Pa]
  double orthogonal_depth = 0.0;   ///< its depth [m]
  double orthogonal_offset = 0.0;  ///< its distance from the centre along the minor axis [m]
  double max_shear = 0.0;          ///< largest max_shear() on the axis [Pa]
  double max_shear_depth = 0.0;    ///< [m]; 0 when the surface is worst (small ν, long ellipse)
  double octahedral = 0.0;         ///< largest octahedral() on the axis [Pa]
  double octahedral_depth = 0.0;   ///< [m]
  double von_mises = 0.0;          ///< 3/√2 times octahedral [Pa]
};

/// Orthogonal shear in closed form [lundberg1947]: with b/a = sqrt((t²-1)(2t-1)),
/// τ/p_max = sqrt(2t-1)/(2t(t+1)), z/b = 1/((t+1) sqrt(2t-1)), y'/b = t/(t+1) sqrt((2t+1)/(2t-1)).
/// Axis maxima by bracketed minimisation: values to rounding, depths to about 1e-7 relative.
/// @throws InputError when a >= b > 0, p_max >= 0 or 0 <= ν <= 1/2 is violated.
[[nodiscard]] SubsurfaceStress subsurface_stress(double a, double b, double p_max, double poisson);

}  // namespace adore::contact
