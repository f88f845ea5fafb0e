#pragma once

#include "deck/rated_bearings.hpp"

#include <string>
#include <vector>

/// Ratings of catalogue bearings by ISO 281 and ISO 76 from the estimated inside: ESTIMATES, not a
/// maker's values.
namespace adore::design {

struct CatalogueRatings {
  double C = 0.0, C0 = 0.0;  ///< dynamic and static, radial or axial [N]
  bool axial = false;
};

[[nodiscard]] CatalogueRatings catalogue_ratings(const deck::RatedBearing& bearing);

/// Sentences: dimensions, estimated inside, ratings, and that no deck describes the type.
[[nodiscard]] std::vector<std::string> describe_ratings(const deck::RatedBearing& bearing);

}  // namespace adore::design
