#pragma once

#include "deck/catalogue.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Catalogue bearings that no deck describes: their ratings only. Boundary dimensions are facts of
/// ISO 15 and ISO 104 as catalogs print them; the inside is an ESTIMATE (resources/catalogue.json).
namespace adore::deck {

enum class RatedBearingType : unsigned char {
  FourPoint,      ///< QJ2, QJ3; rated as two rows
  DoubleAngular,  ///< 32, 33
  SelfAligning,   ///< 12, 13, 22, 23: ball
  Needle,         ///< NA49
  ThrustBall,     ///< 511, 512
  ThrustRoller    ///< 811, 812: cylindrical
};

struct RatedBearing {
  std::string designation;
  RatedBearingType type = RatedBearingType::FourPoint;
  Envelope envelope;                                 ///< width: height of thrust bearings
  double angle = 0.0;                                ///< contact angle [deg]
  int rows = 1;                                      ///< in the rating
  std::string source;                                ///< of the boundary dimensions
  long long count = 0;                               ///< per row
  double diameter = 0.0, length = 0.0, pitch = 0.0;  ///< ESTIMATES; length 0: balls [m]
};

/// "51205", "QJ 205", "NA 4905", "3205"; suffixes are ignored. Empty: not one of them.
[[nodiscard]] std::optional<RatedBearing> find_rated_bearing(std::string_view designation);
[[nodiscard]] std::vector<RatedBearing> rated_bearings();
/// "thrust ball bearing"
[[nodiscard]] std::string_view rated_bearing_type_name(RatedBearingType type);

}  // namespace adore::deck
