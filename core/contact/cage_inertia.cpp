#include "contact/cage_inertia.hpp"

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "base/gauss.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace adore::contact {
namespace {

using bearing::PocketShape;

/// Volume, first and second moments of a body of unit density.
struct Moments {
  double volume = 0.0;
  Vec3 first = Vec3::Zero();
  Mat3 second = Mat3::Zero();  ///< ∫ r r^T dV

  void add(const Moments& other, double sign = 1.0) {
    volume += sign * other.volume;
    first += sign * other.first;
    second += sign * other.second;
  }
  /// The same body turned about x by ψ.
  [[nodiscard]] Moments turned(double psi) const {
    const Mat3 R = passive_rotation_x(psi).transpose();
    return {volume, R * first, R * second * R.transpose()};
  }
};

/// Cross-section of a pocket: half chord along x over the pocket's y and z.
struct PocketSection {
  const CageSolid& solid;
  double half_y = 0.0;      ///< half width along y: faces of a rectangle, radius ρ (r1 for a cone)
  double flat = 0.0;        ///< half length of the straight part along y (elongated)
  double cone_slope = 0.0;  ///< dρ/dz
  double cone_z = 0.0;      ///< z where the radius is half_y
  double half_x = 0.0;      ///< rectangle only

  explicit PocketSection(const CageSolid& s) : solid(s) {
    half_y = 0.5 * (s.element_diameter + s.clearance_1);
    if (s.pocket == PocketShape::Elongated) flat = 0.5 * s.clearance_2;
    if (s.pocket == PocketShape::Rectangular || along_axis())
      half_x = s.roller_length > 0.0 ? 0.5 * s.roller_length
                                     : 0.5 * (s.element_diameter + s.clearance_2);
    if (s.pocket == PocketShape::Conical) {
      const double low = 0.5 * (s.inner_diameter - s.pitch_diameter);
      const double high = 0.5 * (s.outer_diameter - s.pitch_diameter);
      cone_z = low;
      cone_slope = 0.5 * (s.clearance_2 - s.clearance_1) / (high - low);
    }
  }
  /// A cylinder about the roller's own axis.
  [[nodiscard]] bool along_axis() const {
    return solid.pocket == PocketShape::Cylindrical && solid.roller_length > 0.0;
  }
  [[nodiscard]] double half_chord(double y, double z) const {
    if (along_axis()) return half_x;
    double squared = half_y * half_y - y * y;
    switch (solid.pocket) {
      case PocketShape::Rectangular:
        return half_x;
      case PocketShape::Elongated: {
        const double beyond = std::max(std::abs(y) - flat, 0.0);
        squared = half_y * half_y - beyond * beyond;
        break;
      }
      case PocketShape::Spherical:
        squared -= z * z;
        break;
      case PocketShape::Conical: {
        const double radius = half_y + cone_slope * (z - cone_z);
        squared = radius * radius - y * y;
        break;
      }
      case PocketShape::Cylindrical:
        break;
    }
    return std::sqrt(std::max(squared, 0.0));
  }
  /// Half angle of the void on the circle of radius r about the cage axis; 0 when that circle
  /// misses the pocket.
  [[nodiscard]] double half_angle(double r) const {
    const double r_p = 0.5 * solid.pitch_diameter;
    if (solid.pocket == PocketShape::Spherical || along_axis()) {  // the same circle about x
      const double c = (r * r + r_p * r_p - half_y * half_y) / (2 * r * r_p);
      return c >= 1.0 ? 0.0 : std::acos(std::max(c, -1.0));
    }
    if (solid.pocket == PocketShape::Conical) {
      const double k = cone_slope, b = half_y - k * (r_p + cone_z);  // r sin φ - k r cos φ = b
      return std::asin(std::clamp(b / (r * std::sqrt(1 + k * k)), -1.0, 1.0)) + std::atan(k);
    }
    return std::asin(std::min((half_y + flat) / r, 1.0));
  }
};

/// Half of a void, φ from `from` to its end on the side of `sign`, pocket at azimuth 0.
Moments half_void(const PocketSection& section, double from, double sign) {
  const CageSolid& s = section.solid;
  const double r_p = 0.5 * s.pitch_diameter;
  double r1 = 0.5 * s.outer_diameter, r2 = 0.5 * s.inner_diameter;
  // A cylinder about the roller may end inside the wall, where its width goes like a root: r =
  // middle + half sin makes that smooth.
  const bool along_axis = section.along_axis();
  if (along_axis) {
    r1 = std::min(r1, r_p + section.half_y);
    r2 = std::max(r2, r_p - section.half_y);
    if (!(r1 > r2)) return {};
  }
  Moments sum;
  for (const GaussPoint& radial : kGauss20) {
    const double turned = 0.5 * kPi * radial.node;
    const double share = along_axis ? std::sin(turned) : radial.node;
    const double slope = along_axis ? 0.5 * kPi * std::cos(turned) : 1.0;
    const double r = 0.5 * (r1 + r2) + 0.5 * (r1 - r2) * share;
    const double end = section.half_angle(r);
    const double kink = section.flat > 0.0 ? std::asin(std::min(section.flat / r, 1.0)) : 0.0;
    const std::array<double, 3> pieces = {from, std::clamp(kink, from, std::max(end, from)), end};
    for (std::size_t p = 0; p < 2; ++p) {
      const double length = pieces[p + 1] - pieces[p];
      if (!(length > 0.0)) continue;
      for (const GaussPoint& around : kGauss20) {
        const double t =
            0.25 * kPi * (1 + around.node);  // φ = start + length sin t: smooth at the end
        const double phi = sign * (pieces[p] + length * std::sin(t));
        const double y = -r * std::sin(phi), z = r * std::cos(phi);
        const double chord = section.half_chord(y, z - r_p);
        const double dV = radial.weight * slope * 0.5 * (r1 - r2) * r * around.weight * 0.25 * kPi *
                          length * std::cos(t) * 2 * chord;
        const Vec3 point(0.0, y, z);
        sum.volume += dV;
        sum.first += dV * point;
        sum.second += dV * point * point.transpose();
        sum.second(0, 0) += dV * chord * chord / 3;
      }
    }
  }
  return sum;
}

/// Shell sector of half angle β, its middle at azimuth 0.
Moments sector(const CageSolid& s, double beta) {
  const double r1 = 0.5 * s.outer_diameter, r2 = 0.5 * s.inner_diameter, w = s.width;
  const double third = (r1 * r1 * r1 - r2 * r2 * r2) / 3,
               fourth = (r1 * r1 * r1 * r1 - r2 * r2 * r2 * r2) / 4;
  Moments m;
  m.volume = beta * (r1 * r1 - r2 * r2) * w;
  m.first = Vec3(0.0, 0.0, 2 * std::sin(beta) * third * w);
  m.second.diagonal() = Vec3(m.volume * w * w / 12, fourth * w * (beta - 0.5 * std::sin(2 * beta)),
                             fourth * w * (beta + 0.5 * std::sin(2 * beta)));
  return m;
}

/// Sector of half angle β of a conical shell, radius R - x tan γ, its middle at azimuth 0: exact
/// polynomials in x.
Moments cone(const CageSolid& s, double beta) {
  const double r1 = 0.5 * s.outer_diameter, r2 = 0.5 * s.inner_diameter, t = std::tan(s.cone_angle);
  Moments m;
  for (const GaussPoint& axial : kGauss20) {
    const double x = 0.5 * s.width * axial.node, a = r1 - x * t, b = r2 - x * t;
    const double dx = 0.5 * s.width * axial.weight;
    const double area = dx * beta * (a * a - b * b);
    const double out = dx * 2.0 * std::sin(beta) * (a * a * a - b * b * b) / 3.0;
    const double fourth = dx * (a * a * a * a - b * b * b * b) / 4.0;
    m.volume += area;
    m.first += Vec3(area * x, 0.0, out);
    m.second(0, 0) += area * x * x;
    m.second(1, 1) += fourth * (beta - 0.5 * std::sin(2.0 * beta));
    m.second(2, 2) += fourth * (beta + 0.5 * std::sin(2.0 * beta));
    m.second(0, 2) += x * out;
    m.second(2, 0) += x * out;
  }
  return m;
}

/// Where along the pocket's z the void reaches at (x, y) of its frame; empty: high < low.
struct Reach {
  double low, high;
};
constexpr double kFar = 1e3;  // m

/// Where a line along the pocket's z through p lies in the void, and which surfaces bound it.
struct Span {
  Vec3 p;
  double low, high;
  int bounds;
};
Reach reach_of_void(const PocketSection& section, double x, double y) {
  const CageSolid& s = section.solid;
  if (section.along_axis() || s.pocket == PocketShape::Spherical) {
    const double from = section.along_axis() ? std::abs(y) : std::hypot(x, y);
    const double square = section.half_y * section.half_y - from * from;
    const double half = std::sqrt(std::max(square, 0.0));
    return {-half, half};
  }
  if (s.pocket == PocketShape::Conical && section.cone_slope != 0.0) {
    const double z = section.cone_z + (std::hypot(x, y) - section.half_y) / section.cone_slope;
    return section.cone_slope > 0.0 ? Reach{z, kFar} : Reach{-kFar, z};
  }
  return {-kFar, kFar};
}

/// Void of a pocket in a conical cage, along the pocket's own normal between the two cones. Of a
/// pocket that is cut by planes through the axis at ±cut/2 the part on the side of `sign` in y;
/// sign 0: all of it.
Moments cone_void(const PocketSection& section, int sign = 0, double cut = 0.0) {
  const CageSolid& s = section.solid;
  const double t = std::tan(s.cone_angle);
  const Mat3 to_cage = passive_rotation_y(s.cone_angle).transpose();
  const Vec3 normal = to_cage.col(2), middle(0.0, 0.0, 0.5 * s.pitch_diameter);
  const auto end = [&](const Vec3& p,
                       double radius) {  // where p + z·normal meets the cone of that mid radius
    const double R = radius - p[0] * t, slope = normal[0] * t;
    const double a = normal[1] * normal[1] + normal[2] * normal[2] - slope * slope;
    const double b = p[1] * normal[1] + p[2] * normal[2] + R * slope;
    const double c = p[1] * p[1] + p[2] * p[2] - R * R;
    return (-b + std::sqrt(std::max(b * b - a * c, 0.0))) / a;
  };
  // Of cones the widest section that the wall has.
  double widest = section.half_y;
  if (s.pocket == PocketShape::Conical)
    widest += std::abs(section.cone_slope) * (s.outer_diameter - s.inner_diameter);
  Moments sum;
  const double total = widest + section.flat;
  std::vector<double> edges{-total, -section.flat, section.flat, total};
  if (section.flat == 0.0) edges = {-total, 0.0, total};
  if (sign < 0)
    for (double& edge : edges) edge = std::min(edge, 0.0);
  if (sign > 0)
    for (double& edge : edges) edge = std::max(edge, 0.0);
  if (sign != 0 && cut > 0.0) {  // where the cut enters and leaves the wall
    for (const double diameter : {s.inner_diameter, s.outer_diameter}) {
      const double y = 0.5 * diameter * std::tan(0.5 * cut);
      if (y < total) edges.push_back(std::copysign(y, sign));
    }
    std::sort(edges.begin(), edges.end());
  }
  const bool round = s.pocket != PocketShape::Rectangular && !section.along_axis();
  const bool plain =
      round && s.pocket != PocketShape::Spherical && s.pocket != PocketShape::Conical;
  // Sections that change along the wall have kinks: more and shorter pieces.
  const int parts = plain && sign == 0 ? 1 : s.pocket == PocketShape::Conical ? 16 : 6;
  for (std::size_t piece = 0; piece + 1 < edges.size(); ++piece) {
    const double y0 = edges[piece], length = edges[piece + 1] - y0;
    if (!(length > 0.0)) continue;
    for (int part_y = 0; part_y < parts; ++part_y)
      for (const GaussPoint& gy : kGauss20) {
        // sin² map: the chord's square-root end becomes smooth.
        const double u = (part_y + 0.5 * (1 + gy.node)) / parts;
        const double part = std::pow(std::sin(0.5 * kPi * u), 2);
        const double slope = 0.5 * kPi * std::sin(kPi * u) / parts;
        const double y = y0 + length * part;
        double half = section.half_chord(y, 0.0);
        if (s.pocket == PocketShape::Conical)
          half = std::sqrt(std::max(widest * widest - y * y, 0.0));
        const auto span_at = [&](double x) {
          const Vec3 p = middle + to_cage * Vec3(x, y, 0.0);
          const Reach reach = reach_of_void(section, x, y);
          const double inner = end(p, 0.5 * s.inner_diameter);
          const double outer = end(p, 0.5 * s.outer_diameter);
          // |y| >= z tan(cut/2) of the cage frame
          const double plane = sign != 0 && cut > 0.0
                                   ? (std::abs(p[1]) / std::tan(0.5 * cut) - p[2]) / normal[2]
                                   : kFar;
          const double low = std::max(inner, reach.low);
          const double high = std::min({outer, reach.high, plane});
          const int bounds = (low == inner ? 0 : 1) +
                             (high == outer   ? 0
                              : high == plane ? 2
                                              : 4) +
                             (high > low ? 0 : 8);
          return Span{p, low, high, bounds};
        };
        const auto add_strip = [&](double x0, double x1) {
          for (const GaussPoint& gx : kGauss20) {
            // Smooth at roots at both ends, as where a sphere ends.
            const double turned = 0.5 * kPi * gx.node;
            const double x = 0.5 * (x0 + x1) + 0.5 * (x1 - x0) * std::sin(turned);
            const auto [p, low, high, bounds] = span_at(x);
            if (!(high > low)) continue;
            const double dx = 0.25 * kPi * std::cos(turned) * gx.weight * (x1 - x0);
            const double area = 0.5 * gy.weight * length * slope * dx;
            const double n1 = high - low, n2 = (high * high - low * low) / 2;
            const double n3 = (high * high * high - low * low * low) / 3;
            sum.volume += area * n1;
            sum.first += area * (n1 * p + n2 * normal);
            sum.second += area * (n1 * p * p.transpose() + n3 * normal * normal.transpose() +
                                  n2 * (p * normal.transpose() + normal * p.transpose()));
          }
        };
        if (plain && sign == 0) {
          add_strip(-half, half);
          continue;
        }
        // Strips of one kind: a surface that takes over from another makes a kink.
        constexpr int kSamples = 24;
        const double inside = half * (1.0 - 1e-9);
        double from = -half, last = -inside;
        int kind = span_at(last).bounds;
        for (int k = 1; k <= kSamples; ++k) {
          const double next = inside * (2.0 * k / kSamples - 1.0);
          const int kind_there = span_at(next).bounds;
          for (int change = 0; kind != kind_there && change < 4; ++change) {
            double lo = last, hi = next;
            for (int halving = 0; halving < 50; ++halving) {
              const double mid = 0.5 * (lo + hi);
              (span_at(mid).bounds == kind ? lo : hi) = mid;
            }
            add_strip(from, hi);
            from = last = hi;
            kind = span_at(hi).bounds;
          }
          last = next;
        }
        add_strip(from, half);
      }
  }
  return sum;
}

void check(const CageSolid& s, const PocketSection& section) {
  if (!(s.inner_diameter > 0.0) || !(s.outer_diameter > s.inner_diameter) || !(s.width > 0.0) ||
      !(s.density > 0.0) || s.pockets < 1 || !(s.element_diameter > 0.0) ||
      !(s.pitch_diameter > 0.0))
    throw InputError(
        fmt::format("cage inertia: the outer diameter, {} m, must exceed the inner diameter, {} m. "
                    "Width {} m, density {} kg/m^3, element diameter {} m, pitch diameter {} m and "
                    "the number of pockets, {}, must be positive",
                    s.outer_diameter, s.inner_diameter, s.width, s.density, s.element_diameter,
                    s.pitch_diameter, s.pockets));
  double widest = 0.0, chord = 0.0;
  for (const double d :
       {s.inner_diameter, std::clamp(s.pitch_diameter, s.inner_diameter, s.outer_diameter),
        s.outer_diameter}) {
    widest = std::max(widest, section.half_angle(0.5 * d));
    chord = std::max(chord, section.half_chord(0.0, 0.5 * (d - s.pitch_diameter)));
  }
  if (widest >= kPi / s.pockets)
    throw InputError(
        fmt::format("cage inertia: the {} pockets overlap: each spans {:.3f} degrees, but only "
                    "{:.3f} degrees are available. Enter less pocket clearance, fewer elements, or "
                    "the mass and inertia of the cage",
                    s.pockets, widest * 360 / kPi, 360.0 / s.pockets));
  if (2 * chord >= s.width)
    throw InputError(fmt::format(
        "cage inertia: the pocket is {} m long, but the cage is only {} m wide. Enter a wider cage",
        2 * chord, s.width));
  if (s.segments > 1 && s.pockets % s.segments != 0)
    throw InputError(fmt::format("cage inertia: {} pockets cannot be shared equally by {} segments",
                                 s.pockets, s.segments));
}

}  // namespace

SolidInertia cage_solid_inertia(const CageSolid& s) {
  const PocketSection section(s);
  check(s, section);
  const double pitch = 2 * kPi / s.pockets;
  Moments body;
  if (s.segments <= 1) {
    Moments pocket;
    if (s.cone_angle != 0.0) {
      body = cone(s, kPi);
      pocket = cone_void(section);
    } else {
      body = sector(s, kPi);
      pocket = half_void(section, 0.0, 1.0);
      pocket.add(half_void(section, 0.0, -1.0));
    }
    for (int i = 0; i < s.pockets; ++i) body.add(pocket.turned(i * pitch), -1.0);
  } else {
    const double half = kPi / s.segments;
    const bool conical = s.cone_angle != 0.0;
    body = conical ? cone(s, half - 0.5 * s.cut_angle) : sector(s, half - 0.5 * s.cut_angle);
    const int per_segment = s.pockets / s.segments,
              whole = s.cut_at_pocket ? per_segment - 1 : per_segment;
    Moments pocket;
    if (conical) {
      pocket = cone_void(section);
    } else {
      pocket = half_void(section, 0.0, 1.0);
      pocket.add(half_void(section, 0.0, -1.0));
    }
    for (int i = 0; i < whole; ++i) body.add(pocket.turned((i - 0.5 * (whole - 1)) * pitch), -1.0);
    if (s.cut_at_pocket) {
      // In front of the middle lies the start of the pocket that the next segment shares: y > 0.
      const auto part = [&](double side) {
        return conical ? cone_void(section, side < 0.0 ? 1 : -1, s.cut_angle)
                       : half_void(section, 0.5 * s.cut_angle, side);
      };
      body.add(part(-1.0).turned(half), -1.0);
      body.add(part(1.0).turned(-half), -1.0);
    }
  }
  SolidInertia result;
  result.volume = body.volume;
  result.mass = s.density * body.volume;
  result.mass_centre = body.first / body.volume;
  const Mat3 second =
      body.second - body.volume * result.mass_centre * result.mass_centre.transpose();
  result.inertia = s.density * (second.trace() * Mat3::Identity() - second);
  return result;
}

CageSolid cage_solid(const bearing::Bearing& bearing) {
  demand(bearing.cage.has_value(), "the inertia of a cage needs a bearing with a cage");
  const bearing::Cage& cage = *bearing.cage;
  CageSolid solid;
  solid.pocket = cage.pocket;
  solid.outer_diameter = cage.outer_diameter;
  solid.inner_diameter = cage.inner_diameter;
  solid.width = cage.width;
  solid.pockets = bearing.element_count();
  solid.clearance_1 = cage.pocket_clearance_1;
  solid.clearance_2 = cage.pocket_clearance_2;
  solid.density = cage.material.density;
  solid.cone_angle = cage.cone_angle;
  solid.segments = cage.segments.count;
  solid.cut_angle = cage.segments.cut_angle;
  solid.cut_at_pocket = cage.segments.through_pockets;
  if (bearing.rollers()) {
    solid.element_diameter = bearing.rollers()->diameter;
    solid.pitch_diameter = bearing.rollers()->pitch_diameter;
    solid.roller_length = bearing.rollers()->length;
  } else {
    solid.element_diameter = bearing.balls().diameter;
    solid.pitch_diameter = bearing.balls().pitch_diameter;
  }
  return solid;
}

bearing::Inertia cage_inertia(const bearing::Bearing& bearing) {
  const SolidInertia result = cage_solid_inertia(cage_solid(bearing));
  bearing::Inertia inertia;
  inertia.mass = result.mass;
  inertia.moments = result.inertia.diagonal();
  inertia.geometric_centre = {-result.mass_centre.x(), 0.0, 0.0};
  if (bearing.cage->cone_angle == 0.0) inertia.geometric_centre.setZero();
  if (bearing.cage->segments.several()) {
    inertia.geometric_centre = {-result.mass_centre.x(), 0.0, -result.mass_centre.z()};
    if (bearing.cage->cone_angle != 0.0) {  // principal axes lean in the plane of x and z
      const Mat3& I = result.inertia;
      const double lean = 0.5 * std::atan2(2.0 * I(0, 2), I(0, 0) - I(2, 2));
      const Mat3 A = passive_rotation_y(lean);
      inertia.frame = {0.0, lean, 0.0};
      inertia.moments = (A.transpose() * I * A).diagonal();
    }
  }
  return inertia;
}

bearing::Inertia cage_inertia(const bearing::Cage& cage, int pockets, double ball_diameter,
                              double pitch_diameter, double density) {
  if (cage.cone_angle != 0.0)
    throw InputError(
        "cage inertia: the mass center of a conical cage is not its geometric center. Enter the "
        "mass, inertia and offset of the cage");
  CageSolid solid;
  solid.pocket = cage.pocket;
  solid.outer_diameter = cage.outer_diameter;
  solid.inner_diameter = cage.inner_diameter;
  solid.width = cage.width;
  solid.pockets = pockets;
  solid.element_diameter = ball_diameter;
  solid.pitch_diameter = pitch_diameter;
  solid.clearance_1 = cage.pocket_clearance_1;
  solid.clearance_2 = cage.pocket_clearance_2;
  solid.density = density;
  const SolidInertia inertia = cage_solid_inertia(solid);
  return {inertia.mass, inertia.inertia.diagonal()};
}

}  // namespace adore::contact
