#pragma once

#include "base/rotation.hpp"
#include "bearing/bearing.hpp"
#include "contact/roller_profile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

/// Geometry of a roller in a cage pocket, slice by slice. Pocket frame: x along the roller, z
/// outward, y = z × x (against +θ), origin at the pocket centre. SI.
///
/// Slice k: a thin disc of radius r_k across the unit axis u, its middle p_k = q + s_k u, s_k =
/// ((k - ½)/n - ½) L over the whole length, r_k without corners [choice]. w_k = nearest point of
/// the surface to p_k; m_k = (w_k - p_k)/|w_k - p_k|,
///   gap_k = |w_k - p_k| - r_k √(1 - (m_k·u)²),  contact X_k = p_k + r_k (m_k - (m_k·u) u)/√(1 -
///   (m_k·u)²)
/// exact on a plane face, second order in the tilt at its edges and in a round pocket [derived].
/// Minus the gradient of ∫Q dδ is the force -Q m at X_k, and where m turns as the roller moves
/// (around the wall of a round pocket or an edge, ∂m/∂p = c t tᵀ with t across m and the wall's
/// line) besides it Q h at p_k, h = r_k (m·u)/√(1 - (m·u)²) c (t·u) t [derived]: a leaning disc
/// touches beside the direction from the pocket's axis. Without h a roller that leans by λ in a
/// play e takes Q λ² r/e of force from nowhere.
/// A slice that reaches over the end of a guide face lies on it with the fraction φ of its width,
/// and its energy 9/19 Q δ with it: besides -Q m there is -9/19 Q δ φ_x/φ along the face (`edge`)
/// [derived, of the line law]; what φ gets from the lean of the slice is left out (λ²/2 of it).
/// Damped loads scale -Q m and Q h alone: Q edge does not vanish with φ.
/// Limit: the middle of the roller stays within the pocket.
namespace adore::contact {

/// A plane guide face: unlimited or limited along the roller.
struct PocketFace {
  Vec3 centre = Vec3::Zero();
  Vec3 normal = Vec3::UnitY();  ///< away from the roller
  Vec3 along = Vec3::UnitX(), across = Vec3::UnitZ();
  double half_width = 0.0;                                       ///< across [m]
  double half_length = std::numeric_limits<double>::infinity();  ///< along [m]
};

/// Fore and aft faces of a window of width D + clearance at its middle, between the wall's ends;
/// they follow the taper of the roller, y = ±(width/2 - x tan ν) [choice: a window with parallel
/// faces would clamp its large end]. First the one that drives: at +y where the cage turns forward
/// (rotation_sign +1).
[[nodiscard]] std::vector<PocketFace> window_faces(double width, double z_low, double z_high,
                                                   double rotation_sign, double half_angle = 0.0);
/// Record 7.3: each given face and its mirror image in the x-z plane (N36), first the one that
/// drives: the given one where the cage turns forward.
[[nodiscard]] std::vector<PocketFace> paired_faces(std::span<const bearing::RollerPocketFace> given,
                                                   double rotation_sign);

/// A round pocket about the pocket's x axis, fore and aft walls between z_low and z_high. It
/// follows the taper of the roller, as windows do: radius ρ - x tan ν [choice: a cylinder would
/// clamp the large end].
struct RoundPocket {
  double radius = 0.0;  ///< ρ = (D + C1)/2, at x = 0 [m]
  double z_low = 0.0, z_high = 0.0;
  /// Of a pocket that is cut between two segments the wall with half * y >= cut (ball_pocket.hpp).
  int half = 0;
  double cut = 0.0;     ///< [m]
  double taper = 0.0;   ///< tan ν
  double cosine = 1.0;  ///< cos ν
  [[nodiscard]] double radius_at(double x) const noexcept { return radius - x * taper; }
};

struct PocketSlice {
  double gap = 0.0;            ///< negative in contact [m]
  double fraction = 1.0;       ///< of the slice that lies beside the face
  double position = 0.0;       ///< of the slice along the surface, from its centre [m]
  Vec3 m = Vec3::Zero();       ///< unit, from the roller into the surface
  Vec3 point = Vec3::Zero();   ///< X
  Vec3 middle = Vec3::Zero();  ///< p
  Vec3 aside = Vec3::Zero();   ///< h
  Vec3 edge = Vec3::Zero();    ///< of a slice over the end of a face, per elastic load
};

namespace detail {
/// From the middle of a slice to the surface: m, its part along the roller, and the gap.
struct SliceToSurface {
  Vec3 m;
  double lean, across, gap;
};
[[nodiscard, gnu::always_inline]] inline SliceToSurface reach(const Vec3& away, const Vec3& u,
                                                              double radius) noexcept {
  SliceToSurface out;
  const double distance = away.norm();
  out.m = distance > 0.0 ? Vec3(away / distance) : Vec3::Zero();
  out.lean = out.m.dot(u);
  out.across = std::sqrt(std::max(1.0 - out.lean * out.lean, 1e-12));
  out.gap = distance - radius * out.across;
  return out;
}
/// Point of a plane face that is nearest to p.
struct FacePoint {
  double along, beside, across;
  Vec3 at;
};
[[nodiscard, gnu::always_inline]] inline FacePoint nearest_point_on_face(const PocketFace& face,
                                                                         const Vec3& p) noexcept {
  FacePoint out;
  const Vec3 d = p - face.centre;
  out.along = d.dot(face.along);
  out.beside = d.dot(face.across);
  out.across = std::clamp(out.beside, -face.half_width, face.half_width);
  out.at = face.centre + out.along * face.along + out.across * face.across;
  return out;
}
/// @param line along the wall; turning: c, how m turns around it [1/m]
inline void touch(PocketSlice& out, const Vec3& w, const Vec3& p, const Vec3& u, double radius,
                  const Vec3& line, double turning) noexcept {
  const SliceToSurface to = reach(w - p, u, radius);
  out.m = to.m;
  out.gap = to.gap;
  out.point = p + (radius / to.across) * (out.m - to.lean * u);
  out.middle = p;
  const Vec3 t = line.cross(out.m);
  out.aside = (radius * to.lean / to.across * turning * t.dot(u)) * t;
}
}  // namespace detail

/// @param half_slice half its length [m]
[[nodiscard]] inline PocketSlice slice_at_face(const PocketFace& face, const Vec3& p, const Vec3& u,
                                               double radius, double half_slice) noexcept {
  const detail::FacePoint w = detail::nearest_point_on_face(face, p);
  PocketSlice out;
  const double turning = w.across == w.beside ? 0.0 : -1.0 / std::max((w.at - p).norm(), 1e-12);
  detail::touch(out, w.at, p, u, radius, face.along, turning);
  out.position = (out.point - face.centre).dot(face.along);
  if (std::isfinite(face.half_length)) {
    const double half = half_slice * std::abs(u.dot(face.along));
    const double high = std::min(w.along + half, face.half_length);
    const double low = std::max(w.along - half, -face.half_length);
    out.fraction = std::clamp((high - low) / (2.0 * half), 0.0, 1.0);
    if (out.gap < 0.0 && out.fraction > 0.0 && out.fraction < 1.0) {
      const double way =
          (high < face.half_length ? 1.0 : 0.0) - (low > -face.half_length ? 1.0 : 0.0);
      out.edge = (9.0 / 19.0 * out.gap * way / (2.0 * half * out.fraction)) * face.along;
    }
  }
  return out;
}

/// Its gap alone.
[[nodiscard, gnu::always_inline]] inline double gap_at_face(const PocketFace& face, const Vec3& p,
                                                            const Vec3& u, double radius) noexcept {
  return detail::reach(detail::nearest_point_on_face(face, p).at - p, u, radius).gap;
}

[[nodiscard]] inline PocketSlice slice_in_round_pocket(const RoundPocket& pocket, const Vec3& p,
                                                       const Vec3& u, double radius) noexcept {
  const double from_axis = std::max(std::hypot(p[1], p[2]), 1e-12 * pocket.radius);
  // Foot of the normal from the middle of the slice.
  double x =
      p[0] + (pocket.radius_at(p[0]) - from_axis) * pocket.cosine * pocket.cosine * pocket.taper;
  double reach = pocket.radius_at(x);
  double z = reach * p[2] / from_axis;
  bool edge = !(z >= pocket.z_low && z <= pocket.z_high);
  z = std::clamp(z, pocket.z_low, pocket.z_high);
  double y = std::copysign(std::sqrt(std::max(reach * reach - z * z, 0.0)), p[1]);
  if (pocket.half != 0 && pocket.half * y < pocket.cut) {  // the nearer edge of the cut
    const double high = std::sqrt(std::max(reach * reach - pocket.cut * pocket.cut, 0.0));
    z = std::clamp(std::copysign(high, p[2]), pocket.z_low, pocket.z_high);
    y = pocket.half * std::sqrt(std::max(reach * reach - z * z, 0.0));
    edge = true;
  }
  PocketSlice out;
  if (!edge) {
    // m = cos ν e_r + sin ν x.
    detail::touch(out, {x, y, z}, p, u, radius, Vec3::UnitX(), 1.0 / (from_axis * pocket.cosine));
  } else {
    // The edge at this z is a hyperbola, all but straight: Newton for its point nearest to p.
    Vec3 line = Vec3::UnitX();
    for (int pass = 0; pass < 2 && pocket.taper != 0.0 && y != 0.0; ++pass) {
      line[1] = -reach * pocket.taper / y;
      x += (p - Vec3(x, y, z)).dot(line) / line.squaredNorm();
      reach = pocket.radius_at(x);
      y = std::copysign(std::sqrt(std::max(reach * reach - z * z, 0.0)), y);
    }
    const Vec3 w(x, y, z);
    const double turning = -1.0 / std::max((w - p).norm(), 1e-12);
    detail::touch(out, w, p, u, radius, line.normalized(), turning);
  }
  out.position = out.point[0];
  return out;
}

/// Angle of a contact in a round pocket, atan2(m_z, σ m_y) in [0, 2π), σ the sign of the cage's
/// nominal speed: 0 where the cage drives the roller, π where the roller drives the cage.
[[nodiscard]] inline double round_pocket_angle(const Vec3& m, double rotation_sign) noexcept {
  constexpr double kTurn = 6.283185307179586476925;
  const double angle = std::atan2(m[2], rotation_sign * m[1]);
  return angle < 0.0 ? angle + kTurn : angle;
}

/// Slices of the whole length for pockets.
[[nodiscard]] std::vector<RollerSlice> pocket_slices(const RollerProfile& profile, int count);

/// Where the end of a roller comes nearest to the end of its pocket, the plane across x at
/// sign·wall: a dome with its sphere, else the corner torus. h(u) = furthest reach along sign·x;
/// the force along it at `point` is minus the gradient of ∫Q dδ over every displacement and turn.
/// Flat ends meet the plane all at once when aligned: there their rim is rounded over
/// kAlignedEnd (sin -> √(sin² + ε²) - ε) [choice].
inline constexpr double kAlignedEnd = 1e-3;  ///< ε [rad]
struct RollerEndContact {
  double gap = 0.0;  ///< negative in contact [m]
  Vec3 out = Vec3::UnitX(), point = Vec3::Zero();
};
[[nodiscard]] inline RollerEndContact end_contact_at_wall(const RollerEnd& end, double wall,
                                                          const Vec3& q, const Vec3& u) noexcept {
  RollerEndContact touch;
  touch.out = end.sign * Vec3::UnitX();
  const Vec3 outward = end.sign * u;
  const double cosine = u[0];
  const Vec3 across = touch.out - cosine * outward;
  const double sine = across.norm();
  double reach = 0.0;
  if (!end.flat() && end.end_radius * sine <= end.cap_radius) {
    reach = end.dome_centre * cosine + end.end_radius;
    touch.point = q + end.dome_centre * outward + end.end_radius * touch.out;
  } else {
    const double soft = end.flat() ? std::hypot(sine, kAlignedEnd) : sine;
    reach = end.ring * cosine + end.ring_radius * (soft - (end.flat() ? kAlignedEnd : 0.0)) +
            end.corner_radius;
    touch.point =
        q + end.ring * outward + (end.ring_radius / soft) * across + end.corner_radius * touch.out;
  }
  touch.gap = wall - touch.out.dot(q) - reach;
  return touch;
}

/// Never more than its gap: no point of the end lies beyond the vertex or farther from the axis
/// than its corner.
[[nodiscard]] inline double end_gap_bound(const RollerEnd& end, double wall, const Vec3& q,
                                          const Vec3& u) noexcept {
  constexpr double kRounding = 1e-15;  // [m]
  const double sine = std::sqrt(u[1] * u[1] + u[2] * u[2]);
  return wall - end.sign * q[0] - end.vertex - (end.ring_radius + end.corner_radius) * sine -
         kRounding;
}

/// Least gap that any slice can have, from the pose alone: never more than the true one. The roller
/// lies within the cone through the radii at its ends, low at -half_length (roller_profile.hpp:
/// drops only widen the gap), so a plane is nearest at one of them.
struct RollerBounds {
  double half_length = 0.0, low = 0.0, high = 0.0;  ///< [m]
};
[[nodiscard]] inline double gap_bound(const PocketFace& face, const Vec3& q, const Vec3& u,
                                      const RollerBounds& roller) noexcept {
  const double middle = face.normal.dot(face.centre - q);
  const double lean = roller.half_length * face.normal.dot(u);
  return std::min(middle + lean - roller.low, middle - lean - roller.high);
}
[[nodiscard]] inline double gap_bound(const RoundPocket& pocket, const Vec3& q, const Vec3& u,
                                      const RollerBounds& roller) noexcept {
  const double aside = std::hypot(q[1], q[2]) + roller.half_length * std::hypot(u[1], u[2]);
  const double low = pocket.radius_at(q[0] - roller.half_length * u[0]) - roller.low;
  const double high = pocket.radius_at(q[0] + roller.half_length * u[0]) - roller.high;
  return (std::min(low, high) - aside) * pocket.cosine;
}

}  // namespace adore::contact
