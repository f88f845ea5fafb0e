#include "base/gauss.hpp"
#include "tribology/ellipse_split.hpp"
#include "validation/ball_scenario.hpp"

#include <array>
#include <cmath>

/// Traction rules of the cases: the converged integral of the library, and two surface models of
/// the table dyn3_convention_sensitivity that the library does not offer.
namespace adore::validation {
namespace {

/// Rows ξ = a s in equal panels, 20 Gauss points each, weight of the strip load ¾(1-s²).
template <class Row>
void over_rows(int panels, const Row& row) {
  for (int panel = 0; panel < panels; ++panel)
    for (const GaussPoint& point : kGauss20) {
      const double s = -1 + (2 * panel + 1 + point.node) / panels;
      row(s, 0.75 * (1 - s * s) * point.weight / panels);
    }
}

SurfaceTraction strip_traction(const tribology::TractionLaw& law,
                               const dynamics::RaceContactState& contact, double) {
  const tribology::EllipseGeometry& g = contact.ellipse;
  const tribology::EllipseKinematics& m = contact.motion;
  SurfaceTraction sum;
  tribology::EllipseTraction& t = sum.in_plane;
  over_rows(200, [&](double s, double weight) {
    const double xi = g.a * s, h = g.height(xi);
    const double u_c = m.u_c + m.W_t * h, u_t = m.u_t + m.W_n * xi - m.W_c * h,
                 u = std::hypot(u_c, u_t);
    if (!(u > 0.0)) return;
    const double kappa = law.coefficient(u), per_slip = g.Q * weight * kappa / u;
    const double f_c = per_slip * u_c, f_t = per_slip * u_t;
    t.F_c += f_c;
    t.F_t += f_t;
    t.M_c -= h * f_t;
    t.M_t += h * f_c;
    t.M_n += xi * f_t;
    t.heat += per_slip * u * u;
  });
  return sum;
}

/// At ξ the tangent c' = c cos φ - n sin φ, sin φ = ξ/ρ; slip and traction in the plane (c', t).
SurfaceTraction tilted_traction(const tribology::TractionLaw& law,
                                const dynamics::RaceContactState& contact, double u_n) {
  const tribology::EllipseGeometry& g = contact.ellipse;
  const tribology::EllipseKinematics& m = contact.motion;
  const double kink = law.kink();
  SurfaceTraction sum;
  tribology::EllipseTraction& t = sum.in_plane;
  over_rows(32, [&](double s, double weight) {
    const double xi = g.a * s, h = g.height(xi), half_width = g.b * std::sqrt(1 - s * s);
    const double sine = g.rho > 0.0 ? xi / g.rho : 0.0, cosine = std::sqrt(1 - sine * sine);
    const double u_t = m.u_t + m.W_n * xi - m.W_c * h;
    const double mean = (m.u_c + m.W_t * h) * cosine - (u_n - m.W_t * xi) * sine;
    const double swing = (m.W_n * cosine + m.W_c * sine) * half_width;
    std::array<double, 4> cuts = {-1, 1, 1, 1};
    std::size_t pieces = 1;
    if (const double room = kink * kink - u_t * u_t; room > 0.0 && swing != 0.0)
      for (const double side : {-1.0, 1.0})
        if (const double v = mean / swing + side * std::sqrt(room) / std::abs(swing);
            v > -1 && v < 1) {
          cuts[pieces++] = v;
          cuts[pieces] = 1;
        }
    for (std::size_t k = 0; k < pieces; ++k)
      for (const GaussPoint& point : kGauss20) {
        const double from = std::asin(cuts[k]), to = std::asin(cuts[k + 1]);
        const double psi = 0.5 * (from + to) + 0.5 * (to - from) * point.node, v = std::sin(psi),
                     c = std::cos(psi);
        const double share = weight * c * c * (to - from) * point.weight / kPi;  // (2/π) cos²ψ dψ
        const double slip_c = mean - swing * v, u = std::hypot(slip_c, u_t), eta = half_width * v;
        if (!(u > 0.0)) continue;
        const double kappa = law.coefficient(u), per_slip = g.Q * share * kappa / u;
        const double f_c = per_slip * slip_c * cosine, f_n = -per_slip * slip_c * sine,
                     f_t = per_slip * u_t;
        t.F_c += f_c;
        t.F_t += f_t;
        sum.F_n += f_n;
        t.M_c += eta * f_n - h * f_t;
        t.M_t += h * f_c - xi * f_n;
        t.M_n += xi * f_t - eta * f_c;
        t.heat += per_slip * u * u;
      }
  });
  return sum;
}

}  // namespace

TractionRule split_rule(int points) {
  return [points](const tribology::TractionLaw& law, const dynamics::RaceContactState& contact,
                  double) {
    return SurfaceTraction{
        tribology::ellipse_traction_split(law, contact.ellipse, contact.motion, points), 0.0};
  };
}

TractionRule minor_axis_ignored_rule() { return strip_traction; }
TractionRule tangent_plane_rule() { return tilted_traction; }

}  // namespace adore::validation
