#include "contact/ball_pocket.hpp"

#include <limits>

namespace adore::contact {
namespace {

using bearing::PocketShape;

/// From the ball centre to a point that is never on the medial axis.
WallPoint to_point(const Vec3& q, const Vec3& w, double ball_radius) noexcept {
  const Vec3 d = w - q;
  const double distance = d.norm();
  return {w, distance > 0.0 ? Vec3(d / distance) : Vec3::Zero(), distance - ball_radius};
}

WallPoint spherical(const BallPocket& pocket, const Vec3& q) noexcept {
  const double r_b = 0.5 * pocket.ball_diameter;
  const double rho = r_b + 0.5 * pocket.clearance_1;
  const double d = std::hypot(q[0], q[1]), s = std::hypot(d, q[2]);
  double radius = rho, height = 0.0;
  if (s > kMedialAxisRadius * r_b) {
    radius = rho * d / s;
    height = rho * q[2] / s;
  }
  const double inside = std::clamp(height, pocket.z_low, pocket.z_high);
  if (inside != height) {  // beyond the cut: the rim circle
    height = inside;
    radius = std::sqrt(std::max(rho * rho - height * height, 0.0));
  }
  return nearest_revolved_wall_point(q, radius, height, r_b);
}

WallPoint elongated(const BallPocket& pocket, const Vec3& q) noexcept {
  const double r_b = 0.5 * pocket.ball_diameter;
  const double half = 0.5 * std::max(pocket.clearance_2, 0.0);
  const double y_arc = std::clamp(q[1], -half, half);
  const Vec3 from_arc(q[0], q[1] - y_arc, q[2]);
  const CylindricalPocket arc{r_b + 0.5 * pocket.clearance_1, pocket.z_low, pocket.z_high};
  WallPoint point = nearest_wall(arc, from_arc, r_b);
  point.w[1] += y_arc;
  return point;
}

WallPoint conical(const BallPocket& pocket, const Vec3& q) noexcept {
  const double r_b = 0.5 * pocket.ball_diameter;
  const double r1 = r_b + 0.5 * pocket.clearance_1, r2 = r_b + 0.5 * pocket.clearance_2;
  const double dr = r2 - r1, dz = pocket.z_high - pocket.z_low;
  const double d = std::hypot(q[0], q[1]);
  const double along = ((d - r1) * dr + (q[2] - pocket.z_low) * dz) / (dr * dr + dz * dz);
  const double t = std::clamp(along, 0.0, 1.0);
  return nearest_revolved_wall_point(q, r1 + t * dr, pocket.z_low + t * dz, r_b);
}

WallPoints rectangular(const BallPocket& pocket, const Vec3& q, double rotation_sign) noexcept {
  const double r_b = 0.5 * pocket.ball_diameter;
  const double y = std::copysign(r_b + 0.5 * pocket.clearance_1, rotation_sign);
  const double x = r_b + 0.5 * pocket.clearance_2;
  const double z = std::clamp(q[2], pocket.z_low, pocket.z_high);
  return {{to_point(q, {q[0], y, z}, r_b), to_point(q, {x, q[1], z}, r_b),
           to_point(q, {q[0], -y, z}, r_b), to_point(q, {-x, q[1], z}, r_b)},
          4};
}

/// Half width along x of the hole at y and z.
double half_width(const BallPocket& pocket, double y, double z) noexcept {
  const double r_b = 0.5 * pocket.ball_diameter;
  double radius = r_b + 0.5 * pocket.clearance_1, beyond = std::abs(y);
  switch (pocket.shape) {
    case PocketShape::Rectangular:
      return r_b + 0.5 * pocket.clearance_2;
    case PocketShape::Elongated:
      beyond = std::max(beyond - 0.5 * std::max(pocket.clearance_2, 0.0), 0.0);
      break;
    case PocketShape::Spherical:
      beyond = std::hypot(beyond, z);
      break;
    case PocketShape::Conical:
      radius += 0.5 * (pocket.clearance_2 - pocket.clearance_1) * (z - pocket.z_low) /
                (pocket.z_high - pocket.z_low);
      break;
    case PocketShape::Cylindrical:
      break;
  }
  return std::sqrt(std::max(radius * radius - beyond * beyond, 0.0));
}

/// Nearest point to q of the edge at y that bounds the wall, on the side of q: (x(z), y, z), z from
/// the condition that the way there is across the edge.
WallPoint edge_point(const BallPocket& pocket, const Vec3& q, double y, double z) noexcept {
  const double r_b = 0.5 * pocket.ball_diameter;
  const auto inside = [&](double height) {
    return std::clamp(height, pocket.z_low, pocket.z_high);
  };
  double x = std::abs(q[0]);
  z = inside(q[2]);
  if (pocket.shape == PocketShape::Spherical) {  // a circle about the origin
    const double radius = half_width(pocket, y, 0.0), from = std::hypot(x, q[2]);
    if (from > kMedialAxisRadius * r_b) z = inside(radius * q[2] / from);
  } else if (pocket.shape == PocketShape::Conical) {
    // x² = r² - y², r' = k: stationary where (x - |q_x|) x' + z - q_z = 0, x' = k r/x.
    const double k =
        0.5 * (pocket.clearance_2 - pocket.clearance_1) / (pocket.z_high - pocket.z_low);
    for (int n = 0; n < 20; ++n) {
      const double wide = std::max(half_width(pocket, y, z), kMedialAxisRadius * r_b);
      const double slope = k * std::sqrt(wide * wide + y * y) / wide;
      const double bend = (k * k - slope * slope) / wide;
      const double error = (wide - x) * slope + z - q[2];
      const double next =
          inside(z - error / std::max(1.0 + slope * slope + (wide - x) * bend, 0.5));
      const bool done = std::abs(next - z) < 1e-15 * r_b;
      z = next;
      if (done) break;
    }
  }
  return to_point(q, {std::copysign(half_width(pocket, y, z), q[0]), y, z}, r_b);
}

/// What the cut leaves of the nearest points of the whole pocket.
WallPoints of_half(const BallPocket& pocket, const Vec3& q, WallPoints whole) noexcept {
  const double side = pocket.half < 0 ? -1.0 : 1.0;
  const double r_b = 0.5 * pocket.ball_diameter, edge = side * pocket.cut;
  for (std::size_t k = 0; k < static_cast<std::size_t>(whole.count); ++k) {
    WallPoint& point = whole.surface[k];
    if (side * point.w[1] >= pocket.cut) continue;
    if (pocket.shape != PocketShape::Rectangular)
      point = edge_point(pocket, q, edge, point.w[2]);
    else if (k % 2 == 0)  // fore and aft
      point = {Vec3::Zero(), Vec3::Zero(), std::numeric_limits<double>::infinity()};
    else
      point = to_point(q, {point.w[0], edge, point.w[2]}, r_b);
  }
  return whole;
}

WallPoints of_whole(const BallPocket& pocket, const Vec3& q, double rotation_sign) noexcept {
  const double r_b = 0.5 * pocket.ball_diameter;
  switch (pocket.shape) {
    case PocketShape::Spherical:
      return {{spherical(pocket, q)}, 1};
    case PocketShape::Elongated:
      return {{elongated(pocket, q)}, 1};
    case PocketShape::Conical:
      return {{conical(pocket, q)}, 1};
    case PocketShape::Rectangular:
      return rectangular(pocket, q, rotation_sign);
    case PocketShape::Cylindrical:
      break;
  }
  const CylindricalPocket wall{r_b + 0.5 * pocket.clearance_1, pocket.z_low, pocket.z_high};
  return {{nearest_wall(wall, q, r_b)}, 1};
}

}  // namespace

WallPoints nearest_walls(const BallPocket& pocket, const Vec3& q, double rotation_sign) noexcept {
  const WallPoints whole = of_whole(pocket, q, rotation_sign);
  return pocket.half == 0 ? whole : of_half(pocket, q, whole);
}

double cut_opening_half_width(const BallPocket& pocket) noexcept {
  const bool cone = pocket.shape == PocketShape::Conical;
  return std::min(half_width(pocket, pocket.cut, cone ? pocket.z_low : 0.0),
                  half_width(pocket, pocket.cut, cone ? pocket.z_high : 0.0));
}

bool is_inside(const BallPocket& pocket, const Vec3& q) noexcept {
  const double r_b = 0.5 * pocket.ball_diameter;
  if (q[2] <= pocket.z_low - r_b || q[2] >= pocket.z_high + r_b) return false;
  const double z = std::clamp(q[2], pocket.z_low, pocket.z_high);
  const double open = -pocket.half * q[1];  // out of the open side of a half
  if (open > 0.0)
    return open < pocket.ball_diameter && std::abs(q[0]) < half_width(pocket, pocket.cut, z);
  const double r1 = r_b + 0.5 * pocket.clearance_1, r2 = r_b + 0.5 * pocket.clearance_2;
  const double d2 = q[0] * q[0] + q[1] * q[1];
  switch (pocket.shape) {
    case PocketShape::Spherical:
      return d2 < r1 * r1 - z * z;
    case PocketShape::Elongated: {
      const double half = 0.5 * std::max(pocket.clearance_2, 0.0);
      const double y = q[1] - std::clamp(q[1], -half, half);
      return q[0] * q[0] + y * y < r1 * r1;
    }
    case PocketShape::Conical: {
      const double r = r1 + (r2 - r1) * (z - pocket.z_low) / (pocket.z_high - pocket.z_low);
      return d2 < r * r;
    }
    case PocketShape::Rectangular:
      return std::abs(q[0]) < r2 && std::abs(q[1]) < r1;
    case PocketShape::Cylindrical:
      break;
  }
  return d2 < r1 * r1;
}

std::array<double, 2> wall_curvatures(const BallPocket& pocket, const Vec3& q) {
  const double r_b = 0.5 * pocket.ball_diameter;
  const double rho = r_b + 0.5 * pocket.clearance_1;
  switch (pocket.shape) {
    case PocketShape::Cylindrical:
      return {-1.0 / rho, 0.0};
    case PocketShape::Spherical:
      return {-1.0 / rho, -1.0 / rho};
    case PocketShape::Elongated:
      if (std::abs(q[1]) < 0.5 * pocket.clearance_2) return {0.0, 0.0};
      return {-1.0 / rho, 0.0};
    case PocketShape::Conical: {
      const double r2 = r_b + 0.5 * pocket.clearance_2;
      const double cos_alpha = std::cos(std::atan2(r2 - rho, pocket.z_high - pocket.z_low));
      const Vec3 w = conical(pocket, q).w;
      return {-cos_alpha / std::hypot(w[0], w[1]), 0.0};
    }
    case PocketShape::Rectangular:
      break;
  }
  return {0.0, 0.0};
}

std::array<double, 2> wall_curvatures(const BallPocket& pocket) {
  const double r_b = 0.5 * pocket.ball_diameter;
  const double r1 = r_b + 0.5 * pocket.clearance_1, r2 = r_b + 0.5 * pocket.clearance_2;
  switch (pocket.shape) {
    case PocketShape::Spherical:
      return {-1.0 / r1, -1.0 / r1};
    case PocketShape::Conical:
      return {-std::cos(std::atan2(r2 - r1, pocket.z_high - pocket.z_low)) / (0.5 * (r1 + r2)),
              0.0};
    case PocketShape::Rectangular:
      return {0.0, 0.0};
    case PocketShape::Cylindrical:
    case PocketShape::Elongated:
      break;
  }
  return {-1.0 / r1, 0.0};
}

BallPocket pocket_with_ball_growth(BallPocket pocket, double growth) noexcept {
  pocket.ball_diameter += growth;
  pocket.clearance_1 -= growth;
  // Of an elongated pocket the distance of the arc centres.
  if (pocket.shape != PocketShape::Elongated) pocket.clearance_2 -= growth;
  return pocket;
}

WallPoint nearest_half_pocket_wall(const CylindricalPocket& pocket, const Vec3& q,
                                   double ball_radius, int half_side, double y_cut) noexcept {
  const WallPoint full = nearest_wall(pocket, q, ball_radius);
  const double side = half_side < 0 ? -1.0 : 1.0;
  if (side * full.w[1] >= y_cut) return full;
  const double rho = pocket.wall_radius;
  const double x_end = std::copysign(std::sqrt(std::max(rho * rho - y_cut * y_cut, 0.0)), q[0]);
  return to_point(q, {x_end, side * y_cut, full.w[2]}, ball_radius);
}

PocketFrame pocket_frame(const PocketPlacement& placement) noexcept {
  PocketFrame frame;
  frame.centre = placement.pitch_radius * radial_direction(placement.azimuth) +
                 placement.axial_variation * Vec3::UnitX();
  frame.cage_to_pocket = passive_matrix(placement.tilt) * passive_rotation_y(placement.cone_angle) *
                         passive_rotation_x(placement.azimuth);
  return frame;
}

std::array<double, 2> pocket_wall_limits(double outer_diameter, double inner_diameter,
                                         double pitch_diameter,
                                         double thickness_variation) noexcept {
  const double middle = 0.25 * (outer_diameter + inner_diameter) - 0.5 * pitch_diameter;
  const double half = 0.5 * (0.5 * (outer_diameter - inner_diameter) + thickness_variation);
  return {middle - half, middle + half};
}

}  // namespace adore::contact
