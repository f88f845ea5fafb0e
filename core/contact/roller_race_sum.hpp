#pragma once

#include "base/scalar_math.hpp"
#include "contact/damping_law.hpp"
#include "contact/land_edge.hpp"
#include "contact/race_shape.hpp"
#include "contact/race_slope.hpp"
#include "contact/slice_circle.hpp"
#include "contact/slice_law.hpp"
#include "contact/triple.hpp"

#include <cstddef>
#include <type_traits>

/// The slices of one roller against one race, summed: what roller_race.hpp states, as plain numbers
/// in the meridian frame of the roller (slice_circle.hpp), for kernels too. SI.
namespace adore::contact {

/// One race against rollers of one shape; arrays padded to whole vectors with slices of width 0.
struct RaceSlicesView {
  RaceSurface race;
  PowerLaw law;
  double E_star = 0.0;   ///< for the pressure, which only some laws of traction ask for [Pa]
  bool limited = false;  ///< the land has an end
  std::size_t count = 0;
  const double *s = nullptr, *radius = nullptr, *width = nullptr;  ///< [m]
  // A cone about the roller that holds all slices: where it ends, and its radii there [m].
  double end[2] = {0.0, 0.0}, around[2] = {0.0, 0.0};
  DampingLaw<> damping;
  bool damped = false;
};

/// What a traction that knows a lubricant's film may know of a slice. SI.
template <class T>
struct SliceContactState {
  T load_per_length;  ///< Q/w [N/m]
  T peak_pressure;    ///< of the line [Pa]
  T half_width;       ///< b [m]
  T curvature;        ///< Σρ [1/m]
  T entrainment;      ///< mean speed of both surfaces along rolling, in the frame that orbits with
                      ///< the roller; signed [m/s]
  T slip;             ///< [m/s]
  // For what acts on the slice beside its traction.
  T width, radius;    ///< on the land; of the roller [m]
  Triple<T> along;    ///< unit vector of rolling
  Triple<T> of_axis;  ///< the point of the roller axis in the slice, from C [m]
};

/// Middle C of the roller along and from the race axis, its axis, and the motion of the race
/// relative to it about C.
struct RollerPose {
  double x = 0.0, r = 0.0;
  SliceAxes axes;
  Triple<double> velocity{}, omega{};
  Triple<double> spin{};  ///< ω of the roller less that of its orbit, read by films only [rad/s]
  bool open = false;      ///< is_certainly_open (roller_race.hpp): not computed
};

template <class T>
struct RollerRaceSums {
  Triple<T> force{T(0.0), T(0.0), T(0.0)};   ///< on the roller
  Triple<T> moment{T(0.0), T(0.0), T(0.0)};  ///< about C
  T load = 0.0, energy = 0.0, heat = 0.0, load_slip = 0.0;
  T fastest = 0.0;  ///< largest slip of slices that press, squared [m²/s²]; 0 without traction
  T turning = 0.0;  ///< ∂U/∂ψ of a race with errors, and what damping adds to it [J/rad]
  T damping = 0.0;  ///< power that damping takes [W]
};

/// A slice that presses, as it is kept until its traction is known.
template <class T>
struct LoadedSlice {
  T Q;
  Triple<T> n, arm, slip;
  T square;  ///< of the slip
};
/// Adds force, moment and heat of a kept slice. @param over_slip κ(s)/s
template <class T>
[[gnu::always_inline]] inline void add_loaded_slice(RollerRaceSums<T>& sum, const LoadedSlice<T>& c,
                                                    const T& over_slip) {
  const T per_slip = c.Q * over_slip;
  Triple<T> f{-c.Q * c.n.x, -c.Q * c.n.y, -c.Q * c.n.z};
  f = f + per_slip * c.slip;
  sum.heat += per_slip * c.square;
  sum.force = sum.force + f;
  sum.moment = sum.moment + cross(c.arm, f);
}

/// How vectors are read from memory and summed over lanes: for double, and in roller_race_simd.hpp
/// for vectors.
template <class T>
struct SliceLanes;
template <>
struct SliceLanes<double> {
  static constexpr std::size_t kSize = 1;
  static double read(const double* from) { return *from; }
  static double sum(double x) { return x; }
};

/// @param traction callable (u², pressure) -> κ(s)/s on T, or nullptr: none; or with
/// on(SliceContactState)
/// -> callable u² -> κ(s)/s; or with keep(LoadedSlice, SliceContactState): forces, moments and heat
/// come later, by add_loaded_slice
/// @param slope RaceAzimuthSlope of a race with errors at the azimuth of C, or nullptr
template <class T, class Traction, class Slope = std::nullptr_t>
[[nodiscard, gnu::always_inline]] inline RollerRaceSums<T> roller_race_sums(
    const RaceSlicesView& slices, const RollerPose& at, const Traction& traction,
    const Slope& slope = nullptr) noexcept {
  using M = ScalarMath<T>;
  using Lanes = SliceLanes<T>;
  constexpr bool kTraction = !std::is_null_pointer_v<Traction>;
  constexpr bool kWavy = !std::is_null_pointer_v<Slope>;
  constexpr bool kKeeps = requires(const LoadedSlice<T>& slice, const SliceContactState<T>& at) {
    traction.keep(slice, at);
  };
  constexpr double kOverPi = 0.31830988618379067154;
  const RaceSurface& surface = slices.race;
  RollerRaceSums<T> sum;
  LandEdgeForce<T> edge;
  for (std::size_t k = 0; k < slices.count; k += Lanes::kSize) {
    const T s = Lanes::read(slices.s + k);
    const T radius = Lanes::read(slices.radius + k);
    T width = Lanes::read(slices.width + k);
    // Slices are independent, so the processor overlaps their chains of roots and quotients.
    T tan_chi = first_order_tan_chi(surface, at.axes, at.x, at.r, s, radius);
    const DeepestSlicePoint<T> d =
        deepest_slice_point(surface, at.axes, at.x, at.r, s, radius, tan_chi);
    if (!M::any(d.at.depth > 0.0)) continue;
    [[maybe_unused]] T widens = 0.0;
    const T delta = M::max(d.at.depth, T(0.0));
    T secant = 0.0, elastic = 0.0;
    if (slices.limited) {
      const T x = land_coordinate(surface, slice_axial_position(surface, at.axes, at.x, s, radius));
      const T whole = width;
      width = overlap_width(x, whole, surface.land_offset, surface.land_width);
      secant = slice_secant_stiffness(slices.law, width, delta);
      elastic = secant * delta;
      if (M::any(width < whole)) {
        const T shift = width_slope_over_offset(x, whole, surface.land_offset, surface.land_width);
        if constexpr (kWavy) widens = shift * slope.land_offset;
        edge.add(elastic, delta, width, -shift, surface.cos_angle, s, radius);
      }
    } else {
      secant = slice_secant_stiffness(slices.law, width, delta);
      elastic = secant * delta;
    }
    const Triple<T>& n = d.at.n;
    Triple<T> arm = s * at.axes.a + radius * d.u;
    // To the middle of the overlap, where both surfaces slip; -Q n has the same moment from there.
    if constexpr (kTraction) arm = arm + (-0.5 * delta) * n;
    T Q = elastic;
    [[maybe_unused]] Triple<T> u{};
    [[maybe_unused]] T along_n = 0.0, rise = 0.0;
    if constexpr (kWavy) {
      rise = depth_slope_over_azimuth(surface, slope, d.X, d.at);
      if (slope.rise != nullptr) rise = rise + Lanes::read(slope.rise + k);
    }
    if (kTraction || slices.damped) {
      u = at.velocity + cross(at.omega, arm);
      along_n = dot(u, n);
    }
    if (slices.damped) {
      // The point X may be held, because δ is a maximum over its circle. The surface of a race with
      // errors changes with the azimuth ψ of C in the race, ψ̇ = v_y/r.
      T rate = -along_n;
      if constexpr (kWavy) rate += (at.velocity.y / at.r) * rise;
      Q = damped_load(slices.damping, elastic, T((10.0 / 9.0) * width * secant), delta, rate);
      sum.damping += (Q - elastic) * rate;
    }
    Triple<T> f{-Q * n.x, -Q * n.y, -Q * n.z};
    if constexpr (kTraction) {
      const Triple<T> slip = u - along_n * n;
      const T square = dot(slip, slip);
      // Pressures of slices without width are not read: Q is 0 there.
      const T per_length = Q / M::max(width, T(1e-30));
      const T pressure =
          M::root(per_length * ((1.0 / radius - d.at.A_hoop) * (slices.E_star * kOverPi)));
      const auto place = [&]() __attribute__((always_inline)) {
        // Half the race's surface and half the roller's, which both have the orbit's motion too.
        const T speed = 0.5 * dot(slip, d.w) + dot(cross(at.spin, arm), d.w);
        const T half_width = (2.0 * kOverPi) * per_length / M::max(pressure, T(1.0));
        return SliceContactState<T>{
            per_length, pressure,        half_width, 1.0 / radius - d.at.A_hoop,
            speed,      M::root(square), width,      radius,
            d.w,        s * at.axes.a};
      };
      if constexpr (kKeeps) {
        traction.keep(LoadedSlice<T>{Q, n, arm, slip, square}, place());
      } else {
        T per_slip;
        if constexpr (requires(const SliceContactState<T>& at) { traction.on(at); })
          per_slip = Q * traction.on(place())(square);
        else
          per_slip = Q * traction(square, pressure);
        f = f + per_slip * slip;
        sum.heat += per_slip * square;
      }
      sum.load_slip += Q * M::root(square);
      sum.fastest = M::max(sum.fastest, M::pick(Q > 0.0, square, T(0.0)));
    }
    if constexpr (!kKeeps) {
      sum.force = sum.force + f;
      sum.moment = sum.moment + cross(arm, f);
    }
    sum.load += Q;
    sum.energy += (9.0 / 19.0) * elastic * delta;
    if constexpr (kWavy)
      sum.turning += Q * rise + elastic * ((9.0 / 19.0) * delta * widens / M::max(width, T(1e-30)));
  }
  if (edge.reached) edge.add_to_roller(at.axes, surface.sigma(), at.r, sum.force, sum.moment);
  return sum;
}

}  // namespace adore::contact
