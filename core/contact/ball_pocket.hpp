#pragma once

#include "base/rotation.hpp"
#include "bearing/bearing.hpp"

#include <algorithm>
#include <array>
#include <cmath>

/// Geometry of a ball in a cage pocket.
///
/// Pocket frame: x along the cage axis, z radially outward, y = z × x (against +θ), origin at the
/// pocket centre. One rule for every shape: the gap is the distance from the ball centre q to the
/// nearest point w of the wall, minus the ball radius; m = (w - q)/|w - q| points from the ball
/// into the wall, the wall pushes the ball along -m. SI. Exact, covers rims, C1 in q off the medial
/// axis. Limit: the ball centre lies inside the pocket. On the medial axis (nearer than 1e-6 D to
/// it) m is shortened continuously to zero: no direction is preferred there.
namespace adore::contact {

/// Pocket of constant radius ρ = (D + C1)/2 about the pocket z axis, wall from z_low to z_high. The
/// shape of the hot path.
struct CylindricalPocket {
  double wall_radius = 0.0;          ///< ρ [m]
  double z_low = 0.0, z_high = 0.0;  ///< ends of the wall [m]
};

struct WallPoint {
  Vec3 w = Vec3::Zero();  ///< nearest point of the wall [m]
  Vec3 m = Vec3::Zero();  ///< unit vector from the ball centre to w
  double gap = 0.0;       ///< |w - q| - r_b [m], negative in contact
};

/// Distance from the medial axis, as a multiple of the ball radius, below which the direction is
/// softened (1e-6 D).
inline constexpr double kMedialAxisRadius = 2e-6;

/// Nearest wall point of a wall of revolution about z that meets the half plane of q at (radius,
/// height).
[[nodiscard]] inline WallPoint nearest_revolved_wall_point(const Vec3& q, double radius,
                                                           double height,
                                                           double ball_radius) noexcept {
  const double d = std::sqrt(q[0] * q[0] + q[1] * q[1]);
  const double guarded = std::max(d, kMedialAxisRadius * ball_radius);
  const double ux = q[0] / guarded, uy = q[1] / guarded;
  const double across = radius - d, along = height - q[2];
  const double distance = std::sqrt(across * across + along * along);
  const double inverse = distance > 0.0 ? 1.0 / distance : 0.0;
  return {{radius * ux, radius * uy, height},
          {across * ux * inverse, across * uy * inverse, along * inverse},
          distance - ball_radius};
}

/// Cylindrical pocket: w = (ρ (x, y)/d, clamp(z)); inside the wall height the gap is ρ - r_b - d.
[[nodiscard]] inline WallPoint nearest_wall(const CylindricalPocket& pocket, const Vec3& q,
                                            double ball_radius) noexcept {
  return nearest_revolved_wall_point(q, pocket.wall_radius,
                                     std::clamp(q[2], pocket.z_low, pocket.z_high), ball_radius);
}

/// Angle of a contact in the pocket: θ = atan2(m_x, σ m_y) in [0, 2π). σ = sign of the cage's
/// nominal speed (+1 if none). θ = 0: the cage drives the ball, π: the ball drives the cage, π/2:
/// the +x side.
[[nodiscard]] inline double pocket_theta(const Vec3& m, double rotation_sign) noexcept {
  constexpr double kTurn = 6.283185307179586476925;
  const double angle = std::atan2(m[0], rotation_sign * m[1]);
  return angle < 0.0 ? angle + kTurn : angle;
}

/// φ = asin m_z in [-π/2, π/2]: 0 on cylinders and faces.
[[nodiscard]] inline double pocket_phi(const Vec3& m) noexcept {
  return std::asin(std::clamp(m[2], -1.0, 1.0));
}

/// Any pocket shape, for reports and for calculators; the run's hot path uses CylindricalPocket.
struct BallPocket {
  bearing::PocketShape shape = bearing::PocketShape::Cylindrical;
  double ball_diameter = 0.0;
  double clearance_1 = 0.0,
         clearance_2 = 0.0;  ///< C1, C2 with variations [m]; meaning by shape, see nearest_walls
  double z_low = 0.0, z_high = 0.0;  ///< ends of the wall [m]
  /// A pocket that the cut between two segments goes through keeps its wall where half * y >= cut:
  /// half -1 at the start of a segment, +1 at the end of one, 0: a whole pocket.
  int half = 0;
  double cut = 0.0;  ///< [m]
};

struct WallPoints {
  std::array<WallPoint, 4>
      surface;  ///< rectangular: faces at θ = 0, 90, 180, 270 degrees; otherwise one
  int count = 0;
};

/// Nearest wall points of every surface. Of a half pocket: where the nearest point of the whole one
/// is cut away, the nearest point of the edge on the ball's side of y (the gap is C1 while the
/// edges are further apart than the ball is wide); a face that is cut away is infinitely far, m =
/// 0. cylindrical: ρ = (D+C1)/2 · spherical: ρ = (D+C1)/2 about the centre, cut at z_low, z_high ·
/// elongated: ρ = (D+C1)/2, arc centres at y = ±C2/2 · rectangular: faces y = ±(D+C1)/2, x =
/// ±(D+C2)/2 · conical: radius (D+C1)/2 at z_low, (D+C2)/2 at z_high.
[[nodiscard]] WallPoints nearest_walls(const BallPocket& pocket, const Vec3& q,
                                       double rotation_sign) noexcept;

/// Is the ball's centre inside the hole, at most a radius above or below the wall? Only there is
/// the direction of nearest_walls into the wall.
[[nodiscard]] bool is_inside(const BallPocket& pocket, const Vec3& q) noexcept;

/// Half the width along x of the opening that the cut makes of a half pocket, at the height where a
/// ball in its middle is nearest to the edges [m].
[[nodiscard]] double cut_opening_half_width(const BallPocket& pocket) noexcept;

/// Wall curvatures [around, along] [1/m], concave negative, of the part nearest to q. Elongated:
/// flat between the arc centres.
[[nodiscard]] std::array<double, 2> wall_curvatures(const BallPocket& pocket, const Vec3& q);
/// The same at mid wall, of the arc: what a contact law is set up with.
[[nodiscard]] std::array<double, 2> wall_curvatures(const BallPocket& pocket);

/// Cylindrical pocket cut by the plane through the cage axis that segments the cage: the half keeps
/// the wall with half_side * y >= y_cut (half_side -1: leading half, +1: trailing half). Where the
/// nearest point of the full circle is cut away, the nearest point is the end of the arc.
[[nodiscard]] WallPoint nearest_half_pocket_wall(const CylindricalPocket& pocket, const Vec3& q,
                                                 double ball_radius, int half_side,
                                                 double y_cut) noexcept;

/// The same pocket with a ball that is `growth` larger [m]: walls stay, so that clearances that are
/// counted from the ball are smaller.
[[nodiscard]] BallPocket pocket_with_ball_growth(BallPocket pocket, double growth) noexcept;

/// Where the pocket is in the cage.
struct PocketPlacement {
  double azimuth = 0.0;          ///< ψ_i, circumferential variation included [rad]
  double pitch_radius = 0.0;     ///< d_m/2 [m]
  double axial_variation = 0.0;  ///< bPocCenVar1 [m]
  double cone_angle = 0.0;       ///< cageConeAng [rad], > 0: apex on the +x side
  Vec3 tilt = Vec3::Zero();      ///< bPocAngVar [rad]
};

struct PocketFrame {
  Vec3 centre;          ///< P_i in the cage frame [m]
  Mat3 cage_to_pocket;  ///< T_pocket = T(tilt) Ry(cone) Rx(ψ)
};
[[nodiscard]] PocketFrame pocket_frame(const PocketPlacement& placement) noexcept;

/// Wall ends in the pocket frame from the cage diameters: middle (d1+d2)/4 - d_m/2, thickness
/// (d1-d2)/2 + variation.
[[nodiscard]] std::array<double, 2> pocket_wall_limits(double outer_diameter, double inner_diameter,
                                                       double pitch_diameter,
                                                       double thickness_variation = 0.0) noexcept;

}  // namespace adore::contact
