#pragma once

#include <string_view>

/// ISO 286: limits of a size by its tolerance class ("k6", "H7"), by the formulas of the standard.
///
///   tolerance of grade n (500 mm and less): factor_n i with i = 0.45 D^(1/3) + 0.001 D [um], above
///   500 mm factor_n (0.004 D + 2.1); D: geometric mean of the step of sizes [mm]; grades 1 to 4 in
///   geometric progression between 0.8 + 0.02 D and grade 5.
///   shafts d to h: upper limit -16 D^0.44, -11 D^0.41, -5.5 D^0.41, -2.5 D^0.34, 0;
///   k 0.6 D^(1/3) (grades 4 to 7), m IT7 - IT6, n 5 D^0.34, p IT7 + 0 to 5, s IT8 + 1 to 4 or
///   IT7 + 0.4 D, r the geometric mean of p and s; js in the middle.
///   holes D to H mirror the shafts; K, M, N and P: minus the shaft plus IT_n - IT_(n-1).
/// j and J have no formula. The tables of the standard are rounded with exceptions: limits of
/// grades 5 to 9 agree with printed tables to 1 um (M6 above 250 mm: 2 um), others to 4 %.
namespace adore::bearing {

/// Deviations from the nominal size [m].
struct SizeLimits {
  double lower = 0.0, upper = 0.0;
  [[nodiscard]] double width() const noexcept { return upper - lower; }
};

/// Tolerance of a grade [m]. @param nominal [m], above 3 mm and up to 800 mm
/// @throws InputError for sizes and grades outside the range (1 to 11)
[[nodiscard]] double grade_tolerance(int grade, double nominal);

/// @param tolerance_class a letter for a hole (upper case) or a shaft (lower case) and a grade
/// @throws InputError naming the classes that are available
[[nodiscard]] SizeLimits size_limits(std::string_view tolerance_class, double nominal);

}  // namespace adore::bearing
