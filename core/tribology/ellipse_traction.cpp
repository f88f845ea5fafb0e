#include "tribology/ellipse_traction.hpp"

#include "base/errors.hpp"
#include "tribology/largest_slip.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace adore::tribology {
namespace {

constexpr int kLargestRule = 200;

/// Legendre P_{k-1}(x) and P_k(x) by the three-term recurrence, k >= 1.
struct LegendrePair {
  double previous, value;
};
LegendrePair legendre(int k, double x) {
  double previous = 1.0, value = x;
  for (int j = 2; j <= k; ++j) {
    const double next = ((2 * j - 1) * x * value - (j - 1) * previous) / j;
    previous = value;
    value = next;
  }
  return {previous, value};
}

void check_size(int major, int minor) {
  if (major < 1 || major > kLargestRule || minor < 1 || minor > kLargestRule) {
    throw InputError(
        fmt::format("integration over a contact ellipse with {} x {} points is not possible; each "
                    "number must be from 1 to {}",
                    major, minor, kLargestRule));
  }
}

void add_minor_node(EllipseRule& rule, double v, double weight, double chord) {
  ++rule.minor;
  rule.v.push_back(v);
  rule.weight_v.push_back(weight);
  rule.weight_v1.push_back(weight * v);
  rule.weight_v2.push_back(rule.weight_v1.back() * v);
  rule.chord_v.push_back(chord);
}

/// Gauss-Chebyshev of the second kind over v.
void add_minor_nodes(EllipseRule& rule, int minor) {
  for (int j = minor; j >= 1; --j) {
    const double angle = std::numbers::pi * j / (minor + 1.0);
    add_minor_node(rule, 2 * j == minor + 1 ? 0.0 : std::cos(angle),
                   2.0 * std::sin(angle) * std::sin(angle) / (minor + 1.0), std::sin(angle));
  }
}

/// Of one piece of a split rule, on 0..1.
struct PieceNodes {
  std::vector<double> s, weight;
};

PieceNodes legendre_nodes(int k) {
  PieceNodes out;
  for (int i = 0; i < k; ++i) {
    double x = -std::cos(std::numbers::pi * (i + 0.75) / (k + 0.5));
    double slope = 0.0;
    for (int iteration = 0; iteration < 50; ++iteration) {
      const auto [previous, value] = legendre(k, x);
      slope = k * (previous - x * value) / (1.0 - x * x);
      const double step = value / slope;
      x -= step;
      if (std::abs(step) < 1e-16) break;
    }
    out.s.push_back(0.5 * (1.0 + x));
    out.weight.push_back(1.0 / ((1.0 - x * x) * slope * slope));
  }
  return out;
}

/// Two nodes with weights that are exact for t and t²: a load that ends at t = 0.
PieceNodes edge_nodes(double a, double b) {
  return {{a, b}, {(1.0 / 3.0 - 0.5 * b) / (a * (a - b)), (1.0 / 3.0 - 0.5 * a) / (b * (b - a))}};
}

/// Four nodes that lie the same on both sides, exact for every cubic.
PieceNodes four_nodes(double outer, double inner) {
  const double outer2 = (0.5 - outer) * (0.5 - outer), inner2 = (0.5 - inner) * (0.5 - inner);
  const double of_outer = (1.0 / 24.0 - 0.5 * inner2) / (outer2 - inner2),
               of_inner = 0.5 - of_outer;
  return {{outer, inner, 1.0 - inner, 1.0 - outer}, {of_outer, of_inner, of_inner, of_outer}};
}

void add_piece(EllipseRule& rule, std::size_t piece, const PieceNodes& nodes) {
  rule.of_piece[piece] = static_cast<int>(nodes.s.size());
  rule.major += rule.of_piece[piece];
  rule.s.insert(rule.s.end(), nodes.s.begin(), nodes.s.end());
  rule.weight_s.insert(rule.weight_s.end(), nodes.weight.begin(), nodes.weight.end());
}

/// @param edge nodes from the edge of the ellipse inwards; mirrored at the other one
EllipseRule film_pieces(const PieceNodes& edge, const PieceNodes& band, const PieceNodes& middle) {
  PieceNodes mirrored;
  for (std::size_t i = edge.s.size(); i-- > 0;) {
    mirrored.s.push_back(1.0 - edge.s[i]);
    mirrored.weight.push_back(edge.weight[i]);
  }
  EllipseRule rule;
  rule.split = true;
  add_piece(rule, 0, edge);
  add_piece(rule, 1, band);
  add_piece(rule, 2, middle);
  add_piece(rule, 3, band);
  add_piece(rule, 4, mirrored);
  return rule;
}

}  // namespace

EllipseRule make_ellipse_rule(int major, int minor) {
  check_size(major, minor);
  EllipseRule rule;
  rule.major = major;
  // Gauss rule for the weight 1 - s²: its nodes are the zeros of P'_{n+1}, the inner nodes of the
  // Lobatto rule with n + 2 points, and its weights those Lobatto weights times 1 - s².
  // [abramowitz1964 25.4.32]
  const int k = major + 1;
  for (int i = 0; i < major; ++i) {
    double x = -std::cos(std::numbers::pi * (i + 1.0) / k);
    for (int iteration = 0; iteration < 50; ++iteration) {
      const auto [previous, value] = legendre(k, x);
      // (1-x²) P_k' = k (P_{k-1} - x P_k), whose derivative is -k (k+1) P_k.
      const double step = (previous - x * value) / ((k + 1.0) * value);
      x += step;
      if (std::abs(step) < 1e-16) break;
    }
    if (2 * i + 1 == major) x = 0.0;
    const double value = legendre(k, x).value;
    rule.s.push_back(x);
    rule.weight_s.push_back(0.75 * (1.0 - x * x) * 2.0 / (k * (k + 1.0) * value * value));
    rule.chord.push_back(std::sqrt(1.0 - x * x));
  }
  add_minor_nodes(rule, minor);
  return rule;
}

EllipseRule make_split_ellipse_rule(int major, int minor) {
  check_size(major, minor);
  EllipseRule rule;
  rule.split = true;
  // Two nodes integrate the parabola 1 - s² exactly, so the pieces always carry the whole load.
  const int k = std::max(2, (major + kEllipsePieces - 1) / kEllipsePieces);
  const PieceNodes nodes = legendre_nodes(k);
  for (std::size_t piece = 0; piece < kEllipsePieces; ++piece) add_piece(rule, piece, nodes);
  add_minor_nodes(rule, minor);
  return rule;
}

EllipseRule make_film_rule() {
  // Points where the load ends with the ellipse, where u_t reverses, and in between.
  EllipseRule rule =
      film_pieces(edge_nodes(0.3437, 0.807), legendre_nodes(2), four_nodes(0.084, 0.346));
  rule.sweep = 0.955;
  add_minor_nodes(rule, 4);
  return rule;
}

EllipseRule make_strip_rule() {
  EllipseRule rule = film_pieces(legendre_nodes(4), legendre_nodes(2), legendre_nodes(4));
  rule.sweep = 2.0 / 3.0;
  add_minor_nodes(rule, 2);
  return rule;
}

EllipseRule make_run_rule(EllipseNodeCounts size) {
  if (size == kFilmNodes) return make_film_rule();
  if (size == kStripNodes) return make_strip_rule();
  return make_split_ellipse_rule(size.major, size.minor);
}

EllipseNodes EllipseRule::nodes() const noexcept {
  EllipseNodes out;
  out.split = split;
  out.major = static_cast<int>(s.size());
  out.minor = static_cast<int>(v.size());
  std::copy(of_piece.begin(), of_piece.end(), out.of_piece);
  out.sweep = sweep;
  out.s = s.data();
  out.chord = chord.data();
  out.weight_s = weight_s.data();
  out.v = v.data();
  out.weight_v = weight_v.data();
  out.weight_v1 = weight_v1.data();
  out.weight_v2 = weight_v2.data();
  out.chord_v = chord_v.data();
  return out;
}

void set_contact_surface(EllipseGeometry& geometry, ContactSurface surface, double ball_radius,
                         double groove_radius, double approach) noexcept {
  const double rho = is_curved(surface) ? surface_radius(ball_radius, groove_radius) : 0.0;
  geometry.rho = rho;
  geometry.h0 =
      ellipse_surface(place_of(surface), rho, ball_radius, geometry.a, approach).offset + rho;
}

namespace {

EllipseContact<double> contact_of(const EllipseGeometry& geometry,
                                  const EllipseKinematics& motion) {
  return {geometry.Q, geometry.a, geometry.b, {geometry.h0 - geometry.rho, geometry.rho}, motion};
}

}  // namespace

EllipseTraction ellipse_traction(const TractionLaw& law, const EllipseGeometry& geometry,
                                 const EllipseKinematics& motion,
                                 const EllipseRule& rule) noexcept {
  const EllipseContact<double> contact = contact_of(geometry, motion);
  const EllipseNodes nodes = rule.nodes();
  return law.visit([&](const auto& own) {
    EllipseQuadrature sum(nodes, contact, own, law.regularization_slip_squared(), law.slip_scale());
    const EllipseResultants<double> s = sum.run();
    return EllipseTraction{s.F_c, s.F_t,  s.M_c,       s.M_t,
                           s.M_n, s.heat, s.load_slip, largest_slip(geometry, motion)};
  });
}

double largest_slip(const EllipseGeometry& geometry, const EllipseKinematics& motion) noexcept {
  return std::sqrt(largest_slip_square(contact_of(geometry, motion)));
}

}  // namespace adore::tribology
