#include "contact/roller_flange.hpp"

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "base/root.hpp"
#include "base/simd_math.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace adore::contact {
namespace {

using Mode = FlangeContact::Mode;
using Surface = FlangeContact::Surface;

/// A two-component vector of the meridian plane of X as a vector of three.
Vec3 in_meridian_of(const Vec3& X, double x, double r) {
  const double over = r / std::hypot(X[1], X[2]);
  return {x, X[1] * over, X[2] * over};
}

/// The end of the roller in place: o = outward axis, the ring and the dome on it.
struct PlacedEnd {
  const RollerEnd& end;
  Vec3 centre, out;

  PlacedEnd(const RollerEnd& e, const Vec3& C, const Vec3& a)
      : end(e), centre(C), out(e.sign * a) {}

  [[nodiscard]] double from_axis(const Vec3& X) const {
    const Vec3 d = X - centre;
    return (d - d.dot(out) * out).norm();
  }
  /// Signed distance of a point from the convex surface of the end, whose side goes on as a
  /// cylinder behind the corner, with the outward normal; `part` = where.
  double distance(const Vec3& X, Vec3& outward, Surface& part) const {
    const Vec3 d = X - centre;
    const double v = d.dot(out);
    const Vec3 across = d - v * out;
    const double rho = across.norm(), beside = rho - end.ring_radius - end.corner_radius;
    const double to_ring = end.ring - end.dome_centre;
    double before = 0.0;  // from disc or cap
    if (end.flat() && rho <= end.ring_radius) {
      outward = out;
      part = Surface::Disc;
      before = v - end.vertex;
    } else if (!end.flat() && rho * to_ring <= end.ring_radius * (v - end.dome_centre)) {
      outward = X - (centre + end.dome_centre * out);
      before = outward.norm();
      outward /= before;
      part = Surface::Cap;
      before -= end.end_radius;
    } else {
      const double dv = v - end.ring, dr = rho - end.ring_radius;
      part = Surface::Torus;
      outward = dv > 0.0 ? Vec3(dv * out + dr / rho * across).normalized() : Vec3(across / rho);
      return dv > 0.0 ? std::hypot(dv, dr) - end.corner_radius : beside;
    }
    // Within a sharp corner the side may be nearer.
    if (before >= 0.0 || beside < before || rho == 0.0) return before;
    outward = across / rho;
    part = Surface::Torus;
    return beside;
  }
};

/// σ of the ring point at χ with its first two derivatives, for the corner torus on the face.
struct Ring {
  const FlangeFace& face;
  Vec3 middle, e1, e2;  ///< e1, e2 already multiplied by the ring radius

  Ring(const FlangeFace& f, const PlacedEnd& placed) : face(f) {
    middle = placed.centre + placed.end.ring * placed.out;
    const Vec3 radial(0.0, placed.centre[1], placed.centre[2]);
    e1 = (radial - radial.dot(placed.out) * placed.out).normalized() * placed.end.ring_radius;
    e2 = placed.out.cross(e1);
  }
  [[nodiscard]] Vec3 at(double chi) const {
    return middle + std::cos(chi) * e1 + std::sin(chi) * e2;
  }
  [[nodiscard]] double sigma(double chi) const {
    const Vec3 Y = at(chi);
    return face.sigma(Y[0], std::hypot(Y[1], Y[2]));
  }
  /// Numbers of the sign of dσ/dχ where cosines and sines of χ are given.
  template <class V>
  [[nodiscard]] V rising(const V& c, const V& s) const {
    const V y = middle[1] + c * e1[1] + s * e2[1], z = middle[2] + c * e1[2] + s * e2[2];
    const V r = sqrt(y * y + z * z);
    return face.m_x * (c * e2[0] - s * e1[0]) * r +
           face.m_r * (y * (c * e2[1] - s * e1[1]) + z * (c * e2[2] - s * e1[2]));
  }
  /// dσ/dχ and d²σ/dχ².
  [[nodiscard]] std::array<double, 2> slopes(double chi) const {
    const double c = std::cos(chi), s = std::sin(chi);
    const Vec3 Y = middle + c * e1 + s * e2, d1 = -s * e1 + c * e2, d2 = -c * e1 - s * e2;
    const double r = std::hypot(Y[1], Y[2]);
    const double dr = (Y[1] * d1[1] + Y[2] * d1[2]) / r;
    const double ddr = (d1[1] * d1[1] + d1[2] * d1[2] + Y[1] * d2[1] + Y[2] * d2[2] - dr * dr) / r;
    return {face.m_x * d1[0] + face.m_r * dr, face.m_x * d2[0] + face.m_r * ddr};
  }
  /// Local minimum bracketed by [low, high] (slope < 0 at low, > 0 at high): Newton, else
  /// bisection.
  [[nodiscard]] double minimum(double low, double high) const {
    double chi = 0.5 * (low + high);
    for (int n = 0; n < 60; ++n) {
      const auto [d1, d2] = slopes(chi);
      (d1 < 0.0 ? low : high) = chi;
      double next = d2 > 0.0 ? chi - d1 / d2 : low - 1.0;
      if (std::abs(next - chi) < 1e-12) return std::clamp(next, low, high);
      // Of an aligned roller the minimum is an end of the bracket, which Newton overshoots a
      // little.
      constexpr double kBeside = 1e-3;
      if (next > low - kBeside && next < high + kBeside) next = std::clamp(next, low, high);
      if (!(next >= low && next <= high)) next = 0.5 * (low + high);
      if (std::abs(next - chi) < 1e-12) return next;
      chi = next;
    }
    return chi;
  }
};

/// Corner torus on the face: the least local minimum that respects the height; `any` = some minimum
/// lies beyond it.
bool torus_on_face(const FlangeFace& face, const PlacedEnd& placed, FlangeContact& best,
                   double& beyond) {
  constexpr int kScan = 16;
  using V = stdx::native_simd<double>;
  static_assert(kScan % V::size() == 0);
  struct Turns {
    std::array<double, kScan> cosine{}, sine{};
  };
  static const auto kTurns = [] {
    Turns out;
    for (int k = 0; k < kScan; ++k) {
      const double chi = 2.0 * kPi * k / kScan;
      out.cosine[static_cast<std::size_t>(k)] = std::cos(chi);
      out.sine[static_cast<std::size_t>(k)] = std::sin(chi);
    }
    return out;
  }();
  const Ring ring(face, placed);
  std::array<double, kScan + 1> slope{};
  for (std::size_t k = 0; k < kScan; k += V::size())
    ring.rising(V(kTurns.cosine.data() + k, stdx::element_aligned),
                V(kTurns.sine.data() + k, stdx::element_aligned))
        .copy_to(slope.data() + k, stdx::element_aligned);
  slope[kScan] = slope[0];  // the same point, so no minimum falls between two roundings
  beyond = kInfinity;
  bool found = false;
  for (int k = 0; k < kScan; ++k) {
    const auto i = static_cast<std::size_t>(k);
    if (!(slope[i] < 0.0 && slope[i + 1] >= 0.0)) continue;
    const double chi = ring.minimum(2.0 * kPi * k / kScan, 2.0 * kPi * (k + 1) / kScan);
    const Vec3 Y = ring.at(chi);
    const double r = std::hypot(Y[1], Y[2]), tau = face.coordinate_along_flange(Y[0], r);
    const double gap = face.sigma(Y[0], r) - placed.end.corner_radius;
    if (tau > face.reach) {
      beyond = std::min(beyond, gap);
      continue;
    }
    if (found && gap >= best.gap) continue;
    found = true;
    best.gap = gap;
    best.height = tau;
    best.normal = in_meridian_of(Y, face.m_x, face.m_r);
    best.point = Y - placed.end.corner_radius * best.normal;
    best.surface = Surface::Torus;
  }
  return found;
}

/// Azimuths that an end covers as seen from the race axis, with a margin for tilt; none without a
/// lip.
struct LipArc {
  double x = 0.0, r = 0.0;  ///< of the lip [m]
  double from = 0.0, to = 0.0;

  LipArc(const FlangeFace& face, const PlacedEnd& placed)
      : x(face.root_x + face.reach * face.t_x), r(face.root_r + face.reach * face.t_r) {
    if (!(r > 0.0)) return;
    const Vec3 ring_middle = placed.centre + placed.end.ring * placed.out;
    const double wide = placed.end.ring_radius + placed.end.corner_radius;
    const double half =
        std::asin(std::min(1.05 * wide / std::min(r, ring_middle.tail<2>().norm()), 1.0));
    from = azimuth(ring_middle) - half;
    to = from + 2.0 * half;
  }
  [[nodiscard]] double at(int k, int cells) const { return from + (to - from) * k / cells; }
};

/// A point of the lip beside the end.
struct LipPoint {
  Vec3 X, outward;
  Surface part = Surface::Disc;
  double distance = 0.0, slope = 0.0;  ///< from the end's surface, and its slope over ψ

  LipPoint(const LipArc& arc, const PlacedEnd& placed, double psi) {
    const Vec3 e_r = radial_direction(psi);
    X = Vec3(arc.x, arc.r * e_r[1], arc.r * e_r[2]);
    distance = placed.distance(X, outward, part);
    slope = arc.r * outward.dot(circumferential_direction(psi));
  }
};

/// Where the lip crosses a sharp corner between end and side the least distance lies on a crease
/// between azimuths low and high: its gradient is the mean of both sides' normals that has no slope
/// along the lip.
LipPoint crossed_edge(const LipArc& arc, const PlacedEnd& placed, double low, double high) {
  for (int n = 0; n < 40; ++n) {
    const double middle = 0.5 * (low + high);
    (LipPoint(arc, placed, middle).slope < 0.0 ? low : high) = middle;
  }
  LipPoint lip(arc, placed, low);
  const LipPoint other(arc, placed, high);
  lip.outward = (other.slope * lip.outward - lip.slope * other.outward) / (other.slope - lip.slope);
  return lip;
}

/// The least distance between lip and end.
bool lip_beside_end(const FlangeFace& face, const PlacedEnd& placed, FlangeContact& best) {
  constexpr int kScan = 16;
  constexpr double kEndOfSearch = 1e-13;  // [rad]
  constexpr double kCrease = 1e-6;
  const LipArc arc(face, placed);
  if (!(arc.to > arc.from)) return false;
  best.gap = kInfinity;
  double before = LipPoint(arc, placed, arc.from).slope;
  for (int k = 0; k < kScan; ++k) {
    const double a = arc.at(k, kScan), b = arc.at(k + 1, kScan);
    const double after = LipPoint(arc, placed, b).slope;
    if (before < 0.0 && after >= 0.0) {
      const double psi = root_between(a, before, b, after, kEndOfSearch,
                                      [&](double at) { return LipPoint(arc, placed, at).slope; });
      LipPoint lip(arc, placed, psi);
      if (lip.distance < best.gap) {
        if (std::abs(lip.slope) > kCrease * arc.r) lip = crossed_edge(arc, placed, a, b);
        best.gap = lip.distance;
        best.steepness = lip.outward.norm();
        best.normal = -lip.outward / best.steepness;
        best.point = lip.X + lip.distance * best.normal;
        best.surface = lip.part;
      }
    }
    before = after;
  }
  best.height = face.reach;
  best.mode = Mode::Lip;
  return std::isfinite(best.gap);
}

/// Distance along m from the lip circle at race azimuth psi to the end surface; infinite when the
/// ray misses it. The distance to a convex body is convex along a line, so Newton from outside
/// rises to the first hit.
struct LipRay {
  const FlangeFace& face;
  const PlacedEnd& placed;
  LipArc arc{face, placed};
  Vec3 X = Vec3::Zero(), outward = Vec3::Zero();
  Surface part = Surface::Disc;

  double operator()(double psi) {
    const Vec3 e_r = radial_direction(psi);
    const Vec3 m(face.m_x, face.m_r * e_r[1], face.m_r * e_r[2]);
    const Vec3 lip(arc.x, arc.r * e_r[1], arc.r * e_r[2]);
    const double closing = -m.dot(placed.out);
    if (!(closing > 0.0)) return kInfinity;
    // Start in front of the vertex plane.
    double lambda = ((lip - placed.centre).dot(placed.out) - placed.end.vertex) / closing;
    for (int n = 0; n < 60; ++n) {
      X = lip + lambda * m;
      const double distance = placed.distance(X, outward, part);
      const double slope = outward.dot(m);
      if (distance <= 1e-16) return lambda;
      if (!(slope < -1e-9)) return kInfinity;
      const double step = -distance / slope;
      if (step > 2.0 * placed.end.vertex) return kInfinity;
      lambda += step;
      if (step < 1e-15) return lambda;
    }
    return lambda;
  }
};

/// The least distance along m.
bool lip_across_gap(const FlangeFace& face, const PlacedEnd& placed, FlangeContact& best) {
  constexpr int kScan = 48;
  LipRay ray{face, placed};
  const double from = ray.arc.from, step = (ray.arc.to - from) / kScan;
  if (!(step > 0.0)) return false;
  std::array<double, kScan + 1> lambda{};
  for (int k = 0; k <= kScan; ++k) lambda[static_cast<std::size_t>(k)] = ray(from + step * k);
  const auto lowest = std::min_element(lambda.begin(), lambda.end());
  if (!std::isfinite(*lowest)) return false;
  const auto at = static_cast<double>(lowest - lambda.begin());
  double low = from + step * std::max(at - 1.0, 0.0);
  double high = from + step * std::min(at + 1.0, static_cast<double>(kScan));
  constexpr double kGolden = 0.61803398874989484820;
  double left = high - kGolden * (high - low), right = low + kGolden * (high - low);
  double f_left = ray(left), f_right = ray(right);
  for (int n = 0; n < 45; ++n) {
    if (f_left < f_right) {
      high = right;
      right = left;
      f_right = f_left;
      left = high - kGolden * (high - low);
      f_left = ray(left);
    } else {
      low = left;
      left = right;
      f_left = f_right;
      right = low + kGolden * (high - low);
      f_right = ray(right);
    }
  }
  const double gap = ray(f_left < f_right ? left : right);
  if (!std::isfinite(gap)) return false;
  best.gap = gap;
  best.point = ray.X;
  best.normal = -ray.outward;
  best.height = face.reach;
  best.surface = ray.part;
  best.mode = Mode::Lip;
  return true;
}

/// What the gap at a lip is while it is open.
enum class Open : unsigned char { AlongFaceNormal, Nearest };

/// The whole sphere of a domed end on face or lip.
FlangeContact sphere_contact(const FlangeFace& face, const PlacedEnd& placed, Open open) {
  const RollerEnd& end = placed.end;
  const Vec3 E = placed.centre + end.dome_centre * placed.out;
  const double r = std::hypot(E[1], E[2]);
  const double sigma = face.sigma(E[0], r), tau = face.coordinate_along_flange(E[0], r),
               beyond = tau - face.reach;
  FlangeContact c;
  c.surface = Surface::Cap;
  if (beyond <= 0.0) {
    c.mode = Mode::Face;
    c.gap = sigma - end.end_radius;
    c.normal = in_meridian_of(E, face.m_x, face.m_r);
    c.point = E - end.end_radius * c.normal;
    c.height = tau;
  } else if (beyond < end.end_radius) {
    c.mode = Mode::Lip;
    c.height = face.reach;
    const double length = std::hypot(sigma, beyond);
    c.gap = length - end.end_radius;
    if (c.gap > 0.0 && open == Open::AlongFaceNormal) {
      c.gap = sigma - std::sqrt((end.end_radius - beyond) * (end.end_radius + beyond));
      c.point = in_meridian_of(E, face.root_x + face.reach * face.t_x + c.gap * face.m_x,
                               face.root_r + face.reach * face.t_r + c.gap * face.m_r);
      c.normal = (E - c.point) / end.end_radius;
    } else {
      c.normal = in_meridian_of(E, sigma * face.m_x + beyond * face.t_x,
                                sigma * face.m_r + beyond * face.t_r) /
                 length;
      c.point = E - end.end_radius * c.normal;
    }
  } else {
    c.gap = kInfinity;
    c.sphere_gap = kInfinity;
    return c;
  }
  c.from_axis = placed.from_axis(c.point);
  c.on_cap = c.from_axis <= end.cap_radius && (c.point - E).dot(placed.out) > 0.0;
  if (c.on_cap && c.mode == Mode::Lip && c.gap < 0.0)  // and the lip is not nearer to the side
    c.on_cap =
        placed.from_axis(c.point - c.gap * c.normal) - end.ring_radius - end.corner_radius <= c.gap;
  c.sphere_gap = c.gap;
  return c;
}

FlangeContact contact_of(const FlangeFace& face, const PlacedEnd& placed, Open open) noexcept {
  const RollerEnd& end = placed.end;
  FlangeContact best;
  if (!end.flat()) {
    best = sphere_contact(face, placed, open);
    if (best.on_cap) return best;
  } else {
    best.gap = kInfinity;
  }
  FlangeContact corner = best;
  double beyond = kInfinity;
  const bool on_face = torus_on_face(face, placed, corner, beyond);
  if (on_face)
    corner.mode = end.flat() ? Mode::Face : Mode::Corner;
  else
    corner.gap = kInfinity;
  // A minimum beyond the height, should it be the lower one, is met at the lip.
  if (!on_face || beyond < corner.gap) {
    FlangeContact lip = best;
    bool found = lip_beside_end(face, placed, lip);
    if (open == Open::AlongFaceNormal && !(lip.gap <= 0.0))
      found = lip_across_gap(face, placed, lip);
    if (found && lip.gap < corner.gap) corner = lip;
  }
  if (!std::isfinite(corner.gap)) {
    corner.mode = Mode::None;
    return corner;
  }
  corner.from_axis = placed.from_axis(corner.point);
  return corner;
}

}  // namespace

FlangeFace flange_face(const Flange& f) {
  if (!(std::isfinite(f.height) && f.height > 0.0))
    throw InputError(
        fmt::format("flange: the height is {} m; it must be a positive number", f.height));
  if (!(f.layback >= 0.0 && f.layback < 0.5 * kPi))
    throw InputError(fmt::format(
        "flange: the layback angle is {} rad; it must be between 0 and π/2", f.layback));
  const double towards = f.at < 0 ? 1.0 : -1.0, out = f.side == bearing::kInner ? 1.0 : -1.0;
  const double ca = std::cos(f.race_half_angle), sa = std::sin(f.race_half_angle);
  const double cg = std::cos(f.layback), sg = std::sin(f.layback);
  FlangeFace face;
  face.root_x = f.root_x;
  face.root_r = f.root_r;
  face.g_x = towards * ca;
  face.g_r = -towards * sa;
  const double n_x = out * sa, n_r = out * ca;
  face.t_x = cg * n_x - sg * face.g_x;
  face.t_r = cg * n_r - sg * face.g_r;
  face.m_x = cg * face.g_x + sg * n_x;
  face.m_r = cg * face.g_r + sg * n_r;
  face.reach = f.height / cg;
  return face;
}

FlangeContact flange_contact(const FlangeFace& face, const RollerEnd& end, const Vec3& centre,
                             const Vec3& axis) noexcept {
  return contact_of(face, PlacedEnd(end, centre, axis), Open::AlongFaceNormal);
}

FlangeContact flange_contact_for_forces(const FlangeFace& face, const RollerEnd& end,
                                        const Vec3& centre, const Vec3& axis) noexcept {
  return contact_of(face, PlacedEnd(end, centre, axis), Open::Nearest);
}

double dome_center_axis_distance(const RollerEnd& end, const Vec3& centre,
                                 const Vec3& axis) noexcept {
  const Vec3 E = centre + end.sign * end.dome_centre * axis;
  return std::hypot(E[1], E[2]);
}

double flat_end_root_distance(double length, double r_c, double layback, double play) noexcept {
  return 0.5 * length - r_c + r_c / std::cos(layback) - r_c * std::tan(layback) + 0.5 * play;
}

Flange placed_flange(Flange flange, const RollerEnd& end, const Vec3& centre, const Vec3& axis,
                     const std::array<double, 2>& on_raceway, double travel) {
  flange.root_x = on_raceway[0];
  flange.root_r = on_raceway[1];
  for (int n = 0; n < 30; ++n) {
    const FlangeFace face = flange_face(flange);
    const FlangeContact contact = flange_contact(face, end, centre, axis);
    if (contact.mode == Mode::None) break;
    // Moving the root along g by s takes s cos γ off the gap, exactly on the face.
    const double along = contact.gap / (face.m_x * face.g_x + face.m_r * face.g_r);
    flange.root_x += along * face.g_x;
    flange.root_r += along * face.g_r;
    if (std::abs(along) < 1e-16 + 1e-15 * end.vertex) {
      flange.root_x -= travel * face.g_x;
      flange.root_r -= travel * face.g_r;
      return flange;
    }
  }
  throw InputError(
      fmt::format("flange: no flange position along the raceway through ({}, {}) m lets the roller "
                  "end touch the flange of height {} m",
                  on_raceway[0], on_raceway[1], flange.height));
}

FlangeCurvature flange_curvature(const RollerEnd& end, const Vec3& axis,
                                 const FlangeContact& c) noexcept {
  FlangeCurvature out;
  const double r = std::hypot(c.point[1], c.point[2]);
  const double n_r = (c.normal[1] * c.point[1] + c.normal[2] * c.point[2]) / r;
  const Vec3 around(0.0, -c.point[2] / r, c.point[1] / r);
  // Flange: along t (a tube at the lip) and around the race axis.
  const double flange_along = c.mode == Mode::Lip ? 1.0 / kEdgeTube : 0.0, flange_around = n_r / r;
  const Vec3 up = c.normal.cross(around);
  double first = 0.0, second = 0.0;  // roller: tube direction and across it
  Vec3 tube = up;
  if (c.surface == Surface::Cap) {
    first = second = 1.0 / end.end_radius;
  } else if (c.surface == Surface::Torus) {
    const Vec3 outward = -c.normal;
    const Vec3 across = outward - outward.dot(axis) * axis;
    const double radial = across.norm();
    first = 1.0 / (end.corner_radius > 0.0 ? end.corner_radius : kEdgeTube);
    second =
        std::max(radial / std::max(c.from_axis, end.ring_radius), 1.0 / (50.0 * end.ring_radius));
    if (radial > 0.0) tube = c.normal.cross(axis.cross(across / radial));
  }
  const double cosine = std::clamp(tube.dot(up), -1.0, 1.0),
               cos_twice = 2.0 * cosine * cosine - 1.0;
  const double d1 = first - second, d2 = flange_along - flange_around;
  const double sum = first + second + flange_along + flange_around;
  const double spread = std::sqrt(std::max(d1 * d1 + d2 * d2 + 2.0 * d1 * d2 * cos_twice, 0.0));
  double low = 0.5 * (sum - spread);
  const double high = 0.5 * (sum + spread);
  if (c.surface != Surface::Cap) low = std::max(low, 1.0 / (50.0 * end.ring_radius));
  out.relative = {low, std::max(high, low)};
  out.along = first + flange_along;
  out.across = second + flange_around;
  return out;
}

FlangeLoad flange_load(const RollerEnd& end, const Vec3& axis, const FlangeContact& contact,
                       double E_star) {
  FlangeLoad out;
  if (contact.mode == Mode::None) return out;
  out.curvature = flange_curvature(end, axis, contact);
  out.hertz = hertz_constants(out.curvature.relative, E_star);
  out.load = contact.steepness * hertz_load(out.hertz.K, -contact.gap);
  return out;
}

}  // namespace adore::contact
