#pragma once

#include "base/scalar_math.hpp"

/// A split race (record 5A, shimThickness). Its groove is ground as one circle with a shim g
/// between both halves. Without the shim the halves are closer by g: two arcs of the same radius r
/// that meet in the plane of the split, with their centres g/2 beyond it (arched groove). A ball
/// can touch both: each half is a contact with its own angle. SI. For kernels too: plain numbers.
///
/// Half with side σ (covers the contacts whose normal has σ n_k > 0), δ and n of
/// contact/ball_groove.hpp about its own centre. The split is at the distance
///   y = r σ n_k - g/2
/// from the middle of the contact, along the axis, and cuts the ellipse at τ = y/a, a = A √δ:
///   τ >= 1 nothing is cut, τ <= -1 nothing is left.
/// The strain energy of a Hertz contact per length is proportional to (1 - τ²)², so that the half
/// keeps the part φ of the energy V of the whole contact:
///   φ = 1/2 + (15 τ - 10 τ³ + 3 τ⁵)/16,   V_half = φ V
/// and the force on the ball is the gradient -∂V_half/∂d = -w Q n + (φ L + M) c,
///   w = φ - 0.2 τ φ' = 1/2 + (3 τ - τ³)/4,   M = 0.4 Q √δ φ' r σ n_e/(l A),   φ' = (15/16)(1 -
///   τ²)²
/// w is the part of the load of the Hertz ellipse on this side of the split. M turns the load
/// towards the middle of what is left [derived]. For g -> 0 both halves together are the contact of
/// the undivided race: w(τ) + w(-τ) = 1, and M cancels. Traction, heat and damping of the half are
/// w times those of the whole ellipse. Limits: A is that of contact angle 0; both contacts deform
/// independently; the ellipse is cut along a plane across the axis (the split is at small angles);
/// the edges at the split are not worn.
namespace adore::contact {

struct SplitRaceHalf {
  double side = 0.0;           ///< σ: 1 or -1; 0: the race is not split
  double half_shim = 0.0;      ///< g/2 [m]
  double groove_radius = 0.0;  ///< r [m]
  double shift = 0.0;          ///< centre of the arc from P_j along the race axis [m]
  double major = 1.0;          ///< A [m^0.5]

  [[nodiscard]] bool is_split() const noexcept { return side != 0.0; }
};

template <class T>
struct SplitLoadFractions {
  T load;    ///< w
  T energy;  ///< φ
  T turned;  ///< M, along c, of the load Q of the whole contact [N]
};

/// @param load Q of the whole contact, elastic; root √δ, 0 when open; length l
template <class T>
[[nodiscard, gnu::always_inline]] inline SplitLoadFractions<T> split_load_fractions(
    const SplitRaceHalf& half, const T& load, const T& root, const T& n_k, const T& n_e,
    const T& length) {
  using M = ScalarMath<T>;
  const T y = (half.groove_radius * half.side) * n_k - half.half_shim;
  const T cut = y / (half.major * M::max(root, T(1e-15)));
  const T t = M::max(M::min(cut, T(1.0)), T(-1.0));
  const T square = t * t;
  const T rest = 1.0 - square;
  const T slope = 0.9375 * rest * rest;
  SplitLoadFractions<T> out;
  out.load = 0.5 + 0.25 * t * (3.0 - square);
  out.energy = 0.5 + 0.0625 * t * (15.0 + square * (3.0 * square - 10.0));
  out.turned =
      (0.4 / half.major * half.groove_radius * half.side) * load * root * slope * n_e / length;
  return out;
}

}  // namespace adore::contact
