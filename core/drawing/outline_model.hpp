#pragma once

#include "bearing/bearing.hpp"
#include "contact/groove.hpp"
#include "contact/race_surface.hpp"
#include "contact/roller_profile.hpp"
#include "drawing/outline.hpp"
#include "statics/roller_flanges.hpp"

#include <array>
#include <optional>

/// Common geometry of the views, read from a deck as far as possible. SI.
namespace adore::drawing {

struct OutlineCage : bearing::Cage {  ///< outer and inner diameter and width > 0
  double cut = 0.0;                   ///< angle between segments [rad]
  int face_pairs = 0, segments = 1;   ///< guide faces of a roller's pocket; nCseg
  /// Radius at x: cones narrow towards +x.
  [[nodiscard]] double outer_radius(double x) const {
    return 0.5 * outer_diameter - x * std::tan(cone_angle);
  }
  [[nodiscard]] double inner_radius(double x) const {
    return 0.5 * inner_diameter - x * std::tan(cone_angle);
  }
};

struct OutlineModel {
  bearing::Type type = bearing::Type::Ball;
  int count = 0;
  double diameter = 0.0, pitch = 0.0;  ///< of the elements and of their circle
  double length = 0.0;                 ///< of the rollers; the diameter of balls
  double angle = 0.0;                  ///< contact angle of balls, tilt of rollers
  std::optional<bearing::BallGeometry> balls;
  contact::GrooveGeometry groove;                  ///< balls
  std::optional<bearing::RollerGeometry> rollers;  ///< the rest is theirs
  contact::RollerProfile profile;
  std::array<contact::RaceSurface, 2> races;
  std::vector<statics::FlangeEndPair> flanges;
  std::array<double, 2> ring_radius{};  ///< outside of the outer, bore of the inner ring
  std::array<double, 2> ring_width{};
  double shaft_bore = 0.0, housing = 0.0;  ///< radii; 0: not given
  std::optional<OutlineCage> cage;
  std::vector<std::string> remarks;

  [[nodiscard]] double pitch_radius() const { return 0.5 * pitch; }
  /// Radius of a raceway under the middle of an element.
  [[nodiscard]] double raceway(int race) const;
};

/// A number of the deck in SI, or 0 when there is none.
[[nodiscard]] double value_or_zero(const deck::Deck& deck, std::string_view name, int instance = 1,
                                   int index = 1);

/// @throws InputError when the rolling elements cannot be drawn; the rest is left out or assumed,
/// with a remark.
[[nodiscard]] OutlineModel outline_model(const deck::Deck& deck);
/// Guide lands and pockets only; empty when the deck has no cage that can be drawn.
[[nodiscard]] std::optional<OutlineCage> outline_cage(const deck::Deck& deck);

}  // namespace adore::drawing
