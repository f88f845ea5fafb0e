#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

/// SI model of the rolling elements and raceways of a roller bearing (records 5B to 5F). Lengths
/// [m], angles [rad]; arrays of two by race are [0] outer, [1] inner, by side or end [0] -x, [1]
/// +x.
namespace adore::bearing {

/// Codes of kBrg.
enum class Type : unsigned char {
  Ball = 1,
  Cylindrical = 2,
  Spherical = 3,
  Tapered = 4,
  SphericalTapered = 5
};

/// Half meridian of a roller over the length s from its middle, nominal radius D/2 - s tan ν.
enum class RollerShape : unsigned char {
  Crowned,     ///< straight central land, then a circle of the crown radius, tangent at the land's
               ///< ends
  Arc,         ///< one circle of the crown radius (barrel)
  Logarithmic  ///< straight less 0.00035 D ln(1/(1 - (2s/L)²)): reference cases only
};

/// Flange of a race.
struct Flange {
  double layback =
      0.0;  ///< angle of its face from the perpendicular to the raceway, away from the roller
  double height = 0.0;  ///< along the perpendicular to the raceway
};

/// Additional radius of a roller along its axis (routine ADRX5): at most 0, cubics between
/// places whose slopes are those of the parabola through each place and its neighbors; constant
/// beyond the ends.
struct RollerProfileDeviation {
  std::vector<double> place, more;  ///< s from mid length, growing; [m]
  struct At {
    double more = 0.0, slope = 0.0;
  };
  [[nodiscard]] At at(double s) const noexcept {
    const std::size_t n = place.size();
    if (s <= place.front()) return {more.front(), 0.0};
    if (s >= place.back()) return {more.back(), 0.0};
    std::size_t k = 0;
    for (std::size_t high = n - 1; high - k > 1;) {
      const std::size_t middle = (k + high) / 2;
      (place[middle] <= s ? k : high) = middle;
    }
    const double h = place[k + 1] - place[k], u = (s - place[k]) / h;
    const double rise = more[k + 1] - more[k], m0 = h * slope_at(k), m1 = h * slope_at(k + 1);
    // Hermite: m0 u(1-u)² + rise u²(3-2u) - m1 u²(1-u)
    return {more[k] + u * (m0 * (1 - u) * (1 - u) + u * (rise * (3 - 2 * u) - m1 * (1 - u))),
            (m0 * (1 - u) * (1 - 3 * u) + u * (6 * rise * (1 - u) - m1 * (2 - 3 * u))) / h};
  }

 private:
  [[nodiscard]] double slope_at(std::size_t k) const noexcept {
    const auto chord = [this](std::size_t i) {
      return (more[i + 1] - more[i]) / (place[i + 1] - place[i]);
    };
    if (k == 0) return chord(0);
    if (k + 1 == place.size()) return chord(k - 1);
    const double before = place[k] - place[k - 1], after = place[k + 1] - place[k];
    return (after * chord(k - 1) + before * chord(k)) / (before + after);
  }
};

/// Deviations of one roller from the nominal one.
struct RollerDeviation {
  double diameter = 0.0, crown_radius = 0.0, length = 0.0, central_length = 0.0, land_offset = 0.0;
  std::shared_ptr<const RollerProfileDeviation> form;  ///< null: none
};

/// Change of one raceway by fits, temperatures and speeds.
struct RacewayGrowth {
  double radial = 0.0;  ///< outward displacement of the raceway under the middle of the rollers
  double strain = 0.0;  ///< thermal strain of the race
};

/// A roller bearing in operation remembers the raceways of the deck and how they grew: sizes that
/// the races follow from, on the bench, unmounted, cold and at rest.
struct UnmountedRollerGeometry {
  double diameter = 0.0, length = 0.0, crown_radius = 0.0, pitch_diameter = 0.0, clearance = 0.0;
  std::array<double, 2> groove_factor{};
  std::array<RacewayGrowth, 2> growth;
};

struct RollerGeometry {
  int count = 0;          ///< nRe
  double diameter = 0.0;  ///< D, at mid length
  double length = 0.0;    ///< L, over the ends
  RollerShape shape = RollerShape::Crowned;
  double crown_radius = 0.0;              ///< Rc; 1e10 is straight
  double central_length = 0.0;            ///< of the straight land (Crowned)
  std::array<double, 2> corner_radius{};  ///< by end
  std::array<double, 2> end_radius{};     ///< of domed ends, by end; 0: flat
  double half_angle = 0.0;                ///< ν of the roller's own taper
  double axis_angle = 0.0;  ///< of the roller axis to the bearing axis: nominal tilt is -axis_angle
  double pitch_diameter = 0.0;  ///< d_m, of the roller middles
  double clearance = 0.0;       ///< diametral; cones have none (theirs is the axial position)
  std::array<double, 2>
      race_angle{};  ///< contact angle at mid length by race: half cone angle, or of the row
  std::array<double, 2>
      groove_factor{};  ///< groove radius / (2 Rc) by race (Arc); 0: straight raceway
  std::array<double, 2> land_width{};           ///< usable raceway by race; 0: no limit
  std::array<double, 2> race_crown_radius{};    ///< of straight raceways that recede; 0: no crown
  std::array<double, 2> race_central_length{};  ///< straight part of a crowned raceway
  std::array<double, 2> roughness{};            ///< composite rms by race
  std::array<std::array<std::optional<Flange>, 2>, 2> flange;  ///< [race][side]
  std::array<double, 2> flange_play{};     ///< total axial travel between the two flanges of a race
  std::vector<RollerDeviation> deviation;  ///< by roller; empty: all nominal
  /// Set in operation: then the sizes above are those of the rollers in operation, and the races
  /// are the bench's, grown (contact/race_growth.hpp).
  std::optional<UnmountedRollerGeometry> bench;

  /// Length over which a roller can touch a raceway: without its corners.
  [[nodiscard]] double contact_length() const noexcept {
    return length - corner_radius[0] - corner_radius[1];
  }
  /// Across the rolling direction, of a raceway in the middle of its contact: positive hollow,
  /// negative crowned, infinite straight.
  [[nodiscard]] double race_profile_radius(std::size_t race) const noexcept {
    if (groove_factor[race] > 0.0) return 2.0 * groove_factor[race] * crown_radius;
    if (race_crown_radius[race] > 0.0) return -race_crown_radius[race];
    return std::numeric_limits<double>::infinity();
  }
  /// Radius about the bearing axis of the raceway under the middle of a nominal roller, half the
  /// play taken at this race.
  [[nodiscard]] double race_radius(int race) const noexcept {
    const double cosine = std::cos(axis_angle);
    const double out = 0.5 * diameter * cosine + 0.25 * clearance * cosine * cosine;
    return 0.5 * pitch_diameter + (race == 0 ? out : -out);
  }
  /// Itself, or what it was before it was mounted and put to work.
  [[nodiscard]] RollerGeometry unmounted_geometry() const {
    RollerGeometry out = *this;
    if (!bench) return out;
    out.diameter = bench->diameter;
    out.length = bench->length;
    out.crown_radius = bench->crown_radius;
    out.pitch_diameter = bench->pitch_diameter;
    out.clearance = bench->clearance;
    out.groove_factor = bench->groove_factor;
    out.bench.reset();
    return out;
  }
  [[nodiscard]] bool has_flange(int race) const noexcept {
    const auto& f = flange[static_cast<std::size_t>(race)];
    return f[0].has_value() || f[1].has_value();
  }
  [[nodiscard]] RollerDeviation deviation_of(std::size_t roller) const {
    return roller < deviation.size() ? deviation[roller] : RollerDeviation{};
  }
};

}  // namespace adore::bearing
