#pragma once

#include "tribology/ellipse_breaks.hpp"
#include "tribology/laws/contact_point.hpp"
#include "tribology/rounded_law.hpp"

#include <numbers>
#include <type_traits>
#include <utility>

/// The traction integral of one contact by the fixed rule of a run (ellipse_traction.hpp), for
/// numbers and for vectors of numbers, one contact a lane. At fixed ξ only the moments Σ (κ/s) v^k,
/// k = 0, 1, 2, are needed over η because u_t is constant there and u_c = mean - swing v. Seen by
/// the race kernels.
namespace adore::tribology {

/// Slip at the ball center without the W terms, and Ω_race - ω_ball on (c, t, n), as in
/// ellipse_traction.hpp.
template <class T>
struct EllipseMotion {
  T u_c{}, u_t{};         ///< [m/s]
  T W_c{}, W_t{}, W_n{};  ///< [rad/s]
  T entrainment{};        ///< laws/contact_point.hpp [m/s]
  T curvature{};          ///< likewise [1/m]
};

/// Height of the contact surface over the ball center: h(ξ) = offset, or offset + √(ρ² - ξ²) when
/// ρ > 0.
/// Radii are numbers, or of vectors one a lane: then S is T.
template <class T, class S = double>
struct EllipseSurface {
  T offset{};
  S rho = 0.0;
  [[gnu::always_inline]] T height(const T& xi) const {
    return is_curved(rho) ? offset + ScalarMath<T>::root(rho * rho - xi * xi) : offset;
  }
  /// The surfaces of all lanes are of the same type.
  [[gnu::always_inline]] static bool is_curved(const S& rho) {
    if constexpr (std::is_same_v<S, double>)
      return rho > 0.0;
    else
      return rho[0] > 0.0;
  }
};

/// Position of the arc or plane by a surface convention (tribology::ContactSurface).
enum class SurfacePosition : unsigned char {
  ThroughEdge,   ///< through the ends of the major axis on the undeformed ball
  HalfApproach,  ///< half the approach below the undeformed ball at the center
  Undeformed     ///< touching the undeformed ball at the center
};
template <class T, class S>
[[gnu::always_inline]] inline EllipseSurface<T, S> ellipse_surface(SurfacePosition place,
                                                                   const S& rho,
                                                                   const S& ball_radius, const T& a,
                                                                   const T& approach) {
  using M = ScalarMath<T>;
  T offset = ball_radius;
  if (place == SurfacePosition::ThroughEdge) {
    offset = M::root(ball_radius * ball_radius - a * a);
    if (EllipseSurface<T, S>::is_curved(rho)) offset -= M::root(rho * rho - a * a);
  } else {
    if (place == SurfacePosition::HalfApproach) offset -= 0.5 * approach;
    offset -= rho;
  }
  return {offset, rho};
}

/// Nodes and weights of an EllipseRule (ellipse_traction.hpp).
struct EllipseNodes {
  bool split = false;
  int major = 0, minor = 0;
  int of_piece[kEllipsePieces] = {};  ///< split: how many of `major` nodes each piece has
  double sweep = 0.0;                 ///< split: slip at the ends of the pieces over W_n b; 0: that
                                      ///< of the law
  const double *s = nullptr, *chord = nullptr, *weight_s = nullptr;
  const double *v = nullptr, *weight_v = nullptr, *weight_v1 = nullptr, *weight_v2 = nullptr;
  const double* chord_v = nullptr;  ///< √(1 - v²)
};

/// One contact, or one a lane.
template <class T, class S = double>
struct EllipseContact {
  T load{}, a{}, b{};
  EllipseSurface<T, S> surface;
  EllipseMotion<T> motion;
};

template <class T>
struct EllipseResultants {
  T F_c{}, F_t{}, M_c{}, M_t{}, M_n{}, heat{}, load_slip{};
};

template <class T, class Law, class S = double>
class EllipseQuadrature {
 public:
  /// @param floor ε² of the rounded slip; slip_scale of the law, for the pieces of a split rule
  [[gnu::always_inline]] EllipseQuadrature(const EllipseNodes& nodes,
                                           const EllipseContact<T, S>& contact, const Law& law,
                                           double floor, double slip_scale)
      : nodes_(nodes),
        e_(contact),
        peak_pressure_(Law::kDependsOnPressure ? peak_pressure(contact) : T(0.0)),
        law_{law.at(ContactConditions<T>{contact.load, peak_pressure(contact), contact.a, contact.b,
                                         contact.motion.entrainment, middle_slip(contact),
                                         contact.motion.curvature}),
             floor},
        slip_scale_(slip_scale) {}

  [[gnu::always_inline]] EllipseResultants<T> run() {
    if constexpr (can_evaluate_several() && is_strip_law<Law>()) {
      if (nodes_.minor == 2) {
        FourPointRows waiting;
        for_each_row([&](const T& xi, const T& chord, const T& half_width, const T& load)
                         __attribute__((always_inline)) {
                           waiting.row[waiting.count] = row(xi, half_width, load);
                           waiting.chord[waiting.count] = chord;
                           if (++waiting.count == 2) add_strips(waiting);
                         });
        if (waiting.count > 0) add_strips(waiting);
        return sum_;
      }
    } else if constexpr (can_evaluate_several()) {
      if (nodes_.minor == 4) {
        FourPointRows waiting;
        for_each_row([&](const T& xi, const T& chord, const T& half_width, const T& load)
                         __attribute__((always_inline)) {
                           waiting.row[waiting.count] = row(xi, half_width, load);
                           waiting.chord[waiting.count] = chord;
                           if (++waiting.count == 2) add_four_point_rows(waiting);
                         });
        if (waiting.count > 0) add_four_point_rows(waiting);
        return sum_;
      }
      if (nodes_.minor % 2 == 0) {
        Pairs waiting;
        for_each_row([&](const T& xi, const T& chord, const T& half_width, const T& load)
                         __attribute__((always_inline)) {
                           const Row r = row(xi, half_width, load);
                           for (int j = 0; 2 * j < nodes_.minor; ++j) {
                             waiting.pair[waiting.count++] = {r, pressure(chord, j), j};
                             if (waiting.count == kPairs) add_point_pairs(waiting);
                           }
                         });
        if (waiting.count > 0) add_point_pairs(waiting);
        return sum_;
      }
    }
    for_each_row([this](const T& xi, const T& chord, const T& half_width, const T& load)
                     __attribute__((always_inline)) { add_row(xi, chord, half_width, load); });
    return sum_;
  }

  /// visit(ξ, chord, half width, load of the row) in the order in which rows are summed.
  template <class Visit>
  [[gnu::always_inline]] void for_each_row(const Visit& visit) const {
    if (nodes_.split) {
      visit_split_rows(visit);
    } else {
      visit_product_rows(visit);
    }
  }

  /// Values common to all points of a row.
  struct Row {
    T xi, half_width, load, h, u_t, mean, swing, fixed;
  };
  [[gnu::always_inline]] Row row(const T& xi, const T& half_width, const T& load) const {
    return row(xi, half_width, load, e_.surface.height(xi));
  }
  /// @param h height of the surface at ξ
  [[gnu::always_inline]] Row row(const T& xi, const T& half_width, const T& load,
                                 const T& h) const {
    const EllipseMotion<T>& m = e_.motion;
    const T u_t = m.u_t + m.W_n * xi - m.W_c * h;
    return {xi,
            half_width,
            load,
            h,
            u_t,
            m.u_c + m.W_t * h,
            m.W_n * half_width,
            u_t * u_t + law_.floor};
  }
  /// u_c at point j of a row.
  [[gnu::always_inline]] T transverse_slip(const Row& r, int j) const {
    return r.mean - r.swing * nodes_.v[j];
  }
  /// Pressure at point j of a row of that chord; of laws of pressure only.
  [[gnu::always_inline]] T pressure(const T& chord, int j) const {
    return peak_pressure_ * chord * nodes_.chord_v[j];
  }
  /// Adds a row from g_k = Σ (κ/s) v^k and Σ s, with weights.
  [[gnu::always_inline]] void add_moments(const Row& r, const T& g0, const T& g1, const T& g2,
                                          const T& speed) {
    const T f_t = r.load * (g0 * r.u_t);
    const T f_c = r.load * (r.mean * g0 - r.swing * g1);
    const T f_cv = r.load * (r.mean * g1 - r.swing * g2);
    sum_.F_c += f_c;
    sum_.F_t += f_t;
    sum_.M_c -= r.h * f_t;
    sum_.M_t += r.h * f_c;
    sum_.M_n += r.xi * f_t - r.half_width * f_cv;
    sum_.heat += r.u_t * f_t + r.mean * f_c - r.swing * f_cv;
    sum_.load_slip += r.load * speed;
  }
  /// κ/s at the two points of a row, sum and difference (second less first), and Σ s.
  struct TwoPointRow {
    T sum, difference, slips;
  };
  /// Adds a row of a rule with two minor nodes ±v of half the weight each: with q = swing v,
  /// u_c = mean ∓ q, F_c = ½ load (mean sum - q difference).
  [[gnu::always_inline]] void add_two_point_row(const Row& r, const TwoPointRow& at) {
    const T q = r.swing * nodes_.v[1], half = 0.5 * r.load;
    const T f_t = half * (at.sum * r.u_t);
    const T f_c = half * (r.mean * at.sum - q * at.difference);
    const T f_cv = half * (r.mean * at.difference - q * at.sum);
    sum_.F_c += f_c;
    sum_.F_t += f_t;
    sum_.M_c -= r.h * f_t;
    sum_.M_t += r.h * f_c;
    sum_.M_n += r.xi * f_t - (r.half_width * nodes_.v[1]) * f_cv;
    sum_.heat += r.u_t * f_t + r.mean * f_c - q * f_cv;
    sum_.load_slip += half * at.slips;
  }
  [[nodiscard]] const EllipseResultants<T>& sums() const { return sum_; }

  /// u_t at ξ.
  [[gnu::always_inline]] T longitudinal_slip(const T& xi) const {
    return e_.motion.u_t + e_.motion.W_n * xi - e_.motion.W_c * e_.surface.height(xi);
  }
  /// Slip at the ends of the pieces over W_n b, unless the rule sets it. Films bend over a wider
  /// range than the kink of a rounded law: from 0.2 to 12 the value with the smallest errors in
  /// heat of equal pieces (decision 326).
  static constexpr double kSweep = kHasFilm<Law> ? 1.5 : 0.5;
  /// Ends of the pieces of the split rule, s = ξ/a.
  [[gnu::always_inline]] EllipseBreaks<T> breaks() const {
    using M = ScalarMath<T>;
    const EllipseMotion<T>& m = e_.motion;
    const double own = nodes_.sweep > 0.0 ? nodes_.sweep : kSweep;
    const T law2 = slip_scale_ * slip_scale_, sweep = own * m.W_n * e_.b;
    const T sweep2 = sweep * sweep;
    const T width = M::sqrt(M::sqrt(law2 * law2 + sweep2 * sweep2));
    const T at_end = m.u_t - m.W_c * e_.surface.height(e_.a);
    const T centre = m.u_t - m.W_c * e_.surface.height(T(0.0));
    const T swing = m.W_n * e_.a;
    return ellipse_breaks(at_end - swing, centre, at_end + swing, width);
  }

 private:
  [[gnu::always_inline]] static T middle_slip(const EllipseContact<T, S>& e) {
    const T h = e.surface.height(T(0.0));
    const T along = e.motion.u_t - e.motion.W_c * h, across = e.motion.u_c + e.motion.W_t * h;
    return ScalarMath<T>::root(along * along + across * across);
  }
  [[gnu::always_inline]] static T peak_pressure(const EllipseContact<T, S>& e) {
    // Open contacts next to closed ones have no ellipse.
    return 1.5 * e.load / (std::numbers::pi * ScalarMath<T>::max(e.a * e.b, T(1e-30)));
  }

  /// κ is a function of the slip only, and no other result of the law is needed.
  static constexpr bool depends_only_on_slip() {
    if constexpr (requires { Law::kDependsOnlyOnSlip; })
      return Law::kDependsOnlyOnSlip;
    else
      return false;
  }

  template <class Visit>
  [[gnu::always_inline]] void visit_product_rows(const Visit& visit) const {
    for (int i = 0; i < nodes_.major; ++i) {
      visit(nodes_.s[i] * e_.a, T(nodes_.chord[i]), nodes_.chord[i] * e_.b,
            nodes_.weight_s[i] * e_.load);
    }
  }

  template <class Visit>
  [[gnu::always_inline]] void visit_split_rows(const Visit& visit) const {
    using M = ScalarMath<T>;
    const EllipseBreaks<T> at = breaks();
    const T ends[kEllipsePieces + 1] = {T(-1.0), at.s1, at.s2, at.s3, at.s4, T(1.0)};
    int first = 0, end = 0;
    for (int piece = 0; piece < kEllipsePieces; ++piece, first = end) {
      end = first + nodes_.of_piece[piece];
      const T length = ends[piece + 1] - ends[piece];
      if (!M::any(length > 0.0)) continue;
      const T load = 0.75 * length * e_.load;
      for (int i = first; i < end; ++i) {
        const T s = ends[piece] + length * nodes_.s[i];
        const T outside = M::max(1.0 - s * s, T(0.0));
        const T chord = M::root(outside);
        visit(s * e_.a, chord, chord * e_.b, nodes_.weight_s[i] * outside * load);
      }
    }
  }

  [[gnu::always_inline]] void add_row(const T& xi, const T& chord, const T& half_width,
                                      const T& load) {
    const Row r = row(xi, half_width, load);
    if constexpr (depends_only_on_slip()) {
      if (nodes_.minor == 2) {
        add_two_point_row(r, two_point_row(r));
        return;
      }
    }
    T g0 = 0.0, g1 = 0.0, g2 = 0.0, speed = 0.0;
    const auto along_row = [&](const auto& law) {
      for (int j = 0; j < nodes_.minor; ++j) {
        const T u_c = transverse_slip(r, j);
        const T square = u_c * u_c + r.fixed;
        T p = 0.0, slip;
        if constexpr (Law::kDependsOnPressure) p = pressure(chord, j);
        const T g = law.coefficient_over_slip(square, p, slip);
        g0 += g * nodes_.weight_v[j];
        g1 += g * nodes_.weight_v1[j];
        g2 += g * nodes_.weight_v2[j];
        speed += slip * nodes_.weight_v[j];
      }
    };
    if constexpr (is_strip_law<Law>()) {
      const auto strip = law_.law.strip(peak_pressure_ * chord);
      along_row(RegularizedLaw<decltype(strip)>{strip, law_.floor});
    } else {
      along_row(law_);
    }
    add_moments(r, g0, g1, g2, speed);
  }

  [[gnu::always_inline]] TwoPointRow two_point_row(const Row& r) const {
    const T behind = transverse_slip(r, 0), ahead = transverse_slip(r, 1);
    T slip_behind, slip_ahead;
    const T g_behind = law_.coefficient_over_slip(behind * behind + r.fixed, T(0.0), slip_behind);
    const T g_ahead = law_.coefficient_over_slip(ahead * ahead + r.fixed, T(0.0), slip_ahead);
    return {g_ahead + g_behind, g_ahead - g_behind, slip_ahead + slip_behind};
  }

  using Here = decltype(std::declval<const Law&>().at(std::declval<const ContactConditions<T>&>()));
  /// Does the law take several points at once?
  static constexpr bool can_evaluate_several() {
    return requires(const Here& here, T* at) {
      here.template several<2 * kPairs, kPairs>(at, at, at);
    };
  }

  /// Two rows of four points, which is what runs have: points 0 and 3, 1 and 2 of a row have one
  /// pressure.
  struct FourPointRows {
    Row row[2];
    T chord[2];
    int count = 0;
  };
  [[gnu::noinline]] void add_four_point_rows(FourPointRows& rows) {
    if (rows.count == 1) {
      rows.row[1] = rows.row[0];
      rows.chord[1] = rows.chord[0];
    }
    constexpr int kNodes[4] = {0, 1, 3, 2};  // of both rows at one, then at the next
    T slip[8], inverse[8], kappa[8], p[4];
#pragma GCC unroll 8
    for (int i = 0; i < 8; ++i) {
      const int j = kNodes[i / 2], r = i % 2;
      const T u_c = transverse_slip(rows.row[r], j);
      slip[i] = ScalarMath<T>::sqrt_and_inverse(u_c * u_c + rows.row[r].fixed, inverse[i]);
      if (i < 4) p[i] = pressure(rows.chord[r], j);
    }
    law_.law.template several<8, 4>(slip, p, kappa);
    for (int r = 0; r < rows.count; ++r) {
      T g0 = 0.0, g1 = 0.0, g2 = 0.0, speed = 0.0;
#pragma GCC unroll 4
      for (int i = r; i < 8; i += 2) {
        const int j = kNodes[i / 2];
        const T g = ScalarMath<T>::over(kappa[i], slip[i], inverse[i]);
        g0 += g * nodes_.weight_v[j];
        g1 += g * nodes_.weight_v1[j];
        g2 += g * nodes_.weight_v2[j];
        speed += slip[i] * nodes_.weight_v[j];
      }
      add_moments(rows.row[r], g0, g1, g2, speed);
    }
    rows.count = 0;
  }

  /// Two strips of two points, which is what runs have of laws of strips.
  [[gnu::noinline]] void add_strips(FourPointRows& rows) {
    if (rows.count == 1) {
      rows.row[1] = rows.row[0];
      rows.chord[1] = rows.chord[0];
    }
    T slip[4], inverse[4], kappa[4];
    const T peak[2] = {peak_pressure_ * rows.chord[0], peak_pressure_ * rows.chord[1]};
#pragma GCC unroll 4
    for (int i = 0; i < 4; ++i) {
      const Row& r = rows.row[i % 2];
      const T u_c = transverse_slip(r, i / 2);
      slip[i] = ScalarMath<T>::sqrt_and_inverse(u_c * u_c + r.fixed, inverse[i]);
    }
    law_.law.template several<4, 2>(slip, peak, kappa);
    for (int r = 0; r < rows.count; ++r) {
      const int j = r + 2;  // the second point
      const T g = ScalarMath<T>::over(kappa[r], slip[r], inverse[r]),
              h = ScalarMath<T>::over(kappa[j], slip[j], inverse[j]);
      add_moments(rows.row[r], g * nodes_.weight_v[0] + h * nodes_.weight_v[1],
                  g * nodes_.weight_v1[0] + h * nodes_.weight_v1[1],
                  g * nodes_.weight_v2[0] + h * nodes_.weight_v2[1],
                  slip[r] * nodes_.weight_v[0] + slip[j] * nodes_.weight_v[1]);
    }
    rows.count = 0;
  }

  /// Points j and minor - 1 - j of a row: those of one pressure.
  struct Pair {
    Row row;
    T pressure;
    int j = 0;
  };
  static constexpr int kPairs = 4;  ///< that laws take at once, of a row and the next
  struct Pairs {
    Pair pair[kPairs];
    int count = 0;
  };
  [[gnu::noinline]] void add_point_pairs(Pairs& pairs) {
    for (int k = pairs.count; k < kPairs; ++k) pairs.pair[k] = pairs.pair[0];
    T slip[2 * kPairs], inverse[2 * kPairs], kappa[2 * kPairs], p[kPairs];
    for (int k = 0; k < kPairs; ++k) {
      const Pair& at = pairs.pair[k];
      p[k] = at.pressure;
      for (int side = 0; side < 2; ++side) {
        const T u_c = transverse_slip(at.row, side == 0 ? at.j : nodes_.minor - 1 - at.j);
        const int i = k + side * kPairs;
        slip[i] = ScalarMath<T>::sqrt_and_inverse(u_c * u_c + at.row.fixed, inverse[i]);
      }
    }
    law_.law.template several<2 * kPairs, kPairs>(slip, p, kappa);
    for (int k = 0; k < pairs.count; ++k) {
      const Pair& at = pairs.pair[k];
      const int j = at.j, i = nodes_.minor - 1 - j, l = k + kPairs;
      const T g = ScalarMath<T>::over(kappa[k], slip[k], inverse[k]),
              h = ScalarMath<T>::over(kappa[l], slip[l], inverse[l]);
      add_moments(at.row, g * nodes_.weight_v[j] + h * nodes_.weight_v[i],
                  g * nodes_.weight_v1[j] + h * nodes_.weight_v1[i],
                  g * nodes_.weight_v2[j] + h * nodes_.weight_v2[i],
                  slip[k] * nodes_.weight_v[j] + slip[l] * nodes_.weight_v[i]);
    }
    pairs.count = 0;
  }

  const EllipseNodes& nodes_;
  const EllipseContact<T, S>& e_;
  T peak_pressure_;
  RegularizedLaw<Here> law_;
  double slip_scale_;
  EllipseResultants<T> sum_;
};

}  // namespace adore::tribology
