#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

/// Geometric imperfections of rolling elements and races: what differs from the ideal bearing. SI,
/// rad. The deviations of rollers are RollerGeometry::deviation, which has more of them.
namespace adore::bearing {

/// a sin(nψ + p).
struct Harmonic {
  double amplitude = 0.0, waves = 0.0, phase = 0.0;
  [[nodiscard]] double at(double psi) const noexcept {
    return amplitude * std::sin(waves * psi + phase);
  }
  [[nodiscard]] double slope(double psi) const noexcept {
    return amplitude * waves * std::cos(waves * psi + phase);
  }
};

/// Σ c_n cos nψ + s_n sin nψ, n from 0, as pairs (c_n, s_n); empty: 0.
struct AzimuthSeries {
  std::vector<double> pairs;
  double least = 0.0, largest = 0.0;  ///< over the turn
};

/// Race surface given by user routine ADRX6.
struct SurfaceSeries {
  AzimuthSeries radius;            ///< [m]
  AzimuthSeries taper;             ///< as RaceErrors::taper [rad]
  AzimuthSeries curvature_factor;  ///< added to f [-]
};

/// Errors of one race over the azimuth ψ of its frame: from its z axis, positive about x (N79).
/// Their effect on the surface: contact/race_errors.hpp.
struct RaceErrors {
  enum class Roundness : unsigned char { None, Elliptical, Sinusoidal } roundness = Roundness::None;
  std::shared_ptr<const SurfaceSeries> given;  ///< in the place of all that follows
  std::array<double, 3> variation{};  ///< v1, v2, v3: [m, m, rad] elliptical; [m, waves per
                                      ///< revolution, rad] sinusoidal
  Harmonic land_offset;               ///< moves the land towards +x [m]
  Harmonic taper;                     ///< turns the profile, positive opens towards +x [rad]
  Harmonic curvature_factor;          ///< added to f [-]

  /// All amplitudes are zero.
  [[nodiscard]] bool ideal() const noexcept {
    if (given)
      return given->radius.pairs.empty() && given->taper.pairs.empty() &&
             given->curvature_factor.pairs.empty();
    const bool round =
        roundness == Roundness::None ||
        (variation[0] == 0.0 && (roundness == Roundness::Sinusoidal || variation[1] == 0.0));
    return round && land_offset.amplitude == 0.0 && taper.amplitude == 0.0 &&
           curvature_factor.amplitude == 0.0;
  }
  /// The least and the largest that is added to f over the turn.
  [[nodiscard]] std::array<double, 2> curvature_range() const noexcept {
    if (given) return {given->curvature_factor.least, given->curvature_factor.largest};
    const Harmonic& w = curvature_factor;
    if (w.waves == 0.0) return {w.at(0.0), w.at(0.0)};
    return {-std::abs(w.amplitude), std::abs(w.amplitude)};
  }
  /// No change of f is larger than this.
  [[nodiscard]] double curvature_amplitude() const noexcept {
    if (!given) return std::abs(curvature_factor.amplitude);
    return std::max(std::abs(given->curvature_factor.least),
                    std::abs(given->curvature_factor.largest));
  }
};

/// Errors of a guide land of the cage or of the race that guides it (records 7.5.i, 7.6.i) over the
/// azimuth ψ of that body, as RaceErrors::roundness, about the body's own axes.
struct LandErrors {
  RaceErrors::Roundness roundness = RaceErrors::Roundness::None;
  /// elliptical: half axes along y and z minus the nominal radius [m, m, -]; sinusoidal: amplitude,
  /// waves per revolution, phase [m, -, rad]
  std::array<double, 3> variation{};

  [[nodiscard]] bool ideal() const noexcept {
    using Roundness = RaceErrors::Roundness;
    return roundness == Roundness::None ||
           (variation[0] == 0.0 && (roundness == Roundness::Sinusoidal || variation[1] == 0.0));
  }
};

/// Source of the deviations of the rolling elements (kReGeoImp).
enum class ElementErrorSource : unsigned char { None = 0, Random = 1, Listed = 2 };

struct Imperfections {
  ElementErrorSource elements = ElementErrorSource::None;
  std::uint64_t seed = 0;             ///< of the random table (base/random_table.hpp), Random only
  std::vector<double> ball_diameter;  ///< D_k - D by ball [m]; empty: none
  std::array<RaceErrors, 2> race;     ///< [0] outer, [1] inner
  std::array<bool, 2> race_given{};   ///< the deck gives errors of this race (they may be zero)
};

}  // namespace adore::bearing
