#pragma once

#include "base/scalar_math.hpp"

#include <cmath>

/// Geometric imperfections of a race at one azimuth ψ of its own frame: the one statement of what
/// contact/race_errors.hpp says, as plain numbers, for numbers, vectors of numbers (one element a
/// lane) and dual numbers, for kernels too. SI, rad.
namespace adore::contact {

/// a sin(nψ + p).
struct RaceWave {
  double amplitude = 0.0, waves = 0.0, phase = 0.0;
  double cos_phase = 1.0, sin_phase = 0.0;
};

/// Ellipse with one half axis at ψ = phase and the other a quarter turn on.
struct RaceOval {
  double along = 0.0, across = 0.0;  ///< 1/(half axis)² [1/m²]
  double phase = 0.0, cos_phase = 1.0, sin_phase = 0.0;
};

template <class T>
struct ValueAndSlope {
  T value, slope;  ///< and its derivative over ψ
};

/// Σ c_n cos nψ + s_n sin nψ, n from 0: pairs (c_n, s_n) of a bearing::AzimuthSeries that lives
/// longer.
struct RaceFourierSeries {
  const double* pairs = nullptr;
  int count = 0;
};
/// From the cosine and sine of ψ, by turning on; n rounding errors.
template <class T>
[[gnu::always_inline]] inline ValueAndSlope<T> sum_at(const RaceFourierSeries& sum, const T& cosine,
                                                      const T& sine) {
  T c = 1.0, s = 0.0, value = sum.pairs[0], slope = 0.0;
  for (int n = 1; n < sum.count; ++n) {
    const double along = sum.pairs[2 * n], across = sum.pairs[2 * n + 1];
    const T next = c * cosine - s * sine;
    s = c * sine + s * cosine;
    c = next;
    value = value + along * c + across * s;
    slope = slope + static_cast<double>(n) * (across * c - along * s);
  }
  return {value, slope};
}

/// (sin²t/b² + cos²t/a²)^(-1/2) from the cosine and sine of t.
template <class T>
[[gnu::always_inline]] inline ValueAndSlope<T> oval_radius(double along, double across,
                                                           const T& cosine, const T& sine) {
  const T u = across * sine * sine + along * cosine * cosine;
  T R;
  ScalarMath<T>::sqrt_and_inverse(u, R);
  return {R, -R * (across - along) * sine * cosine / u};
}

/// An azimuth by its angle: waves of any number.
struct AzimuthAngle {
  using Number = double;
  double psi = 0.0;
  [[nodiscard]] ValueAndSlope<double> wave(const RaceWave& w) const {
    const double angle = w.waves * psi + w.phase;
    return {w.amplitude * std::sin(angle), w.amplitude * w.waves * std::cos(angle)};
  }
  [[nodiscard]] ValueAndSlope<double> oval(const RaceOval& o) const {
    const double t = psi - o.phase;
    return oval_radius(o.along, o.across, std::cos(t), std::sin(t));
  }
  [[nodiscard]] ValueAndSlope<double> sum(const RaceFourierSeries& s) const {
    return sum_at(s, std::cos(psi), std::sin(psi));
  }
};

/// An azimuth by its cosine and sine: whole numbers of waves, cos nψ + i sin nψ = (cos ψ + i sin
/// ψ)^n by repeated squares; n rounding errors.
template <class T>
struct AzimuthDirection {
  using Number = T;
  T cosine, sine;
  [[nodiscard, gnu::always_inline]] ValueAndSlope<T> wave(const RaceWave& w) const {
    T c = w.cos_phase, s = w.sin_phase, power_c = cosine, power_s = sine;
    if (w.waves < 0.0) power_s = -power_s;
    for (auto n = static_cast<unsigned>(w.waves < 0.0 ? -w.waves : w.waves); n != 0; n >>= 1) {
      if ((n & 1U) != 0U) {
        const T next = c * power_c - s * power_s;
        s = c * power_s + s * power_c;
        c = next;
      }
      const T square = power_c * power_c - power_s * power_s;
      power_s = 2.0 * power_c * power_s;
      power_c = square;
    }
    return {w.amplitude * s, (w.amplitude * w.waves) * c};
  }
  [[nodiscard, gnu::always_inline]] ValueAndSlope<T> oval(const RaceOval& o) const {
    return oval_radius(o.along, o.across, cosine * o.cos_phase + sine * o.sin_phase,
                       sine * o.cos_phase - cosine * o.sin_phase);
  }
  [[nodiscard, gnu::always_inline]] ValueAndSlope<T> sum(const RaceFourierSeries& s) const {
    return sum_at(s, cosine, sine);
  }
};

/// Errors of one race, ready for evaluation. Its radius follows the oval, or the wave; of a race
/// that is summed, radius, taper and curvature factor follow their sums.
struct RaceErrorModel {
  double nominal_radius = 0.0;  ///< R [m]
  bool is_oval = false;
  RaceOval oval;
  RaceWave radius, land_offset, taper, curvature_factor;
  bool is_summed = false;
  RaceFourierSeries radius_sum, taper_sum, curvature_sum;
};

/// Values at one azimuth, with their derivatives over it.
template <class T>
struct LocalRaceErrorOf {
  T radius = 0.0;            ///< R(ψ) - R [m]
  T radius_slope = 0.0;      ///< [m/rad]
  T land_offset = 0.0;       ///< [m]
  T taper = 0.0;             ///< [rad]
  T curvature_factor = 0.0;  ///< change of f [-]
  T land_offset_slope = 0.0, taper_slope = 0.0, curvature_factor_slope = 0.0;
};
using LocalRaceError = LocalRaceErrorOf<double>;

template <class Azimuth>
[[nodiscard, gnu::always_inline]] inline LocalRaceErrorOf<typename Azimuth::Number> race_error_at(
    const RaceErrorModel& form, const Azimuth& azimuth) {
  using T = typename Azimuth::Number;
  LocalRaceErrorOf<T> e;
  const auto take = [&](const RaceWave& wave, T& value, T& slope) {
    if (wave.amplitude == 0.0) return;
    const ValueAndSlope<T> at = azimuth.wave(wave);
    value = at.value;
    slope = at.slope;
  };
  if (form.is_summed) {
    const auto add_up = [&](const RaceFourierSeries& sum, T& value, T& slope) {
      if (sum.count == 0) return;
      const ValueAndSlope<T> at = azimuth.sum(sum);
      value = at.value;
      slope = at.slope;
    };
    add_up(form.radius_sum, e.radius, e.radius_slope);
    add_up(form.taper_sum, e.taper, e.taper_slope);
    add_up(form.curvature_sum, e.curvature_factor, e.curvature_factor_slope);
    return e;
  }
  if (form.is_oval) {
    const ValueAndSlope<T> outline = azimuth.oval(form.oval);
    e.radius = outline.value - form.nominal_radius;
    e.radius_slope = outline.slope;
  } else {
    take(form.radius, e.radius, e.radius_slope);
  }
  take(form.land_offset, e.land_offset, e.land_offset_slope);
  take(form.taper, e.taper, e.taper_slope);
  take(form.curvature_factor, e.curvature_factor, e.curvature_factor_slope);
  return e;
}

/// What an error does to a groove (race_errors.hpp, race_with_error): its radius and the circle of
/// its centres. Linear, so that slopes change as values do.
template <class T>
struct GrooveChange {
  T radius, x, centre_radius;  ///< [m], or [m/rad] from slopes
};
/// @param radius R(ψ) - R; curvature_diameter 2 R_c, or the ball's D [m]; normal_x, normal_r n of
/// the nominal contact
template <class T>
[[nodiscard, gnu::always_inline]] inline GrooveChange<T> groove_change(const T& radius,
                                                                       const T& curvature_factor,
                                                                       double curvature_diameter,
                                                                       double normal_x,
                                                                       double normal_r) {
  const T growth = curvature_factor * curvature_diameter;
  return {growth, -growth * normal_x, radius - growth * normal_r};
}

}  // namespace adore::contact
