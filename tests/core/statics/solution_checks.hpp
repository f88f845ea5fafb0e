#pragma once

#include "bearing/bearing.hpp"
#include "statics/race_result.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>

/// What holds for every quasi-static solution, of balls and rollers alike.
namespace solution_checks {

/// Given loads are carried, given displacements kept, nothing is NaN.
inline void check_race(const adore::bearing::Bearing& bearing,
                       const adore::statics::RaceResult& s) {
  double scale = s.max_load;
  for (double f : bearing.constraints.load) scale = std::max(scale, std::abs(f));
  for (std::size_t k = 0; k < 5; ++k) {
    REQUIRE(std::isfinite(s.displacement[k]));
    if (bearing.constraints.displacement_given[k]) {
      CHECK(s.displacement[k] == bearing.constraints.displacement[k]);
    } else {
      CHECK(s.load[k] == Approx(bearing.constraints.load[k]).margin(1e-8 * scale));
    }
  }
  REQUIRE(s.stiffness.allFinite());
}

inline bool noted(const adore::statics::RaceResult& s, const std::string& text) {
  return std::any_of(s.notes.begin(), s.notes.end(), [&](const adore::Finding& n) {
    return n.message.find(text) != std::string::npos;
  });
}

}  // namespace solution_checks
