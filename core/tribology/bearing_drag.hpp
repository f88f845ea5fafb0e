#pragma once

#include "bearing/bearing.hpp"
#include "tribology/churning.hpp"

#include <array>
#include <string>
#include <vector>

/// Effect of the medium in the cavity of a bearing (kChrn) on its elements and its cage. SI.
///
/// The medium turns with the outer race [choice]: speeds are relative to it, and it passes the
/// reactions of elements and cage to the outer race, so that its power is all heat.
/// Element: F = ½ C_D ρ A V² against the velocity of its center, of a sphere or a cylinder across
/// the flow; of its projected area what the wall of the cage hides is left out. Spin: of a ball
/// that of a sphere in the cavity; of a roller a cylinder in a wide annulus, gap R/2, which gives
/// the exact 4π μ ω R² l of a cylinder in an endless medium, and both end faces as discs. The
/// narrow gaps of the pockets are those of pocket hydrodynamics (kPocHydro).
/// Cage: both cylindrical surfaces as annuli against the races, with the clearance of guide lands
/// where they are, and both side faces as discs less the opening. Decision 300.
namespace adore::tribology {

/// Medium of a bearing at its temperature: that of the coolant where it is known, else the mean of
/// both races and the elements.
struct ChurningMedium {
  Medium medium;  ///< effective: ratios are in it
  std::string name, provenance;
  double temperature = 0.0;         ///< [K]
  double T_min = 0.0, T_max = 0.0;  ///< of its correlations; 0: no limits known
  [[nodiscard]] bool is_temperature_clamped() const noexcept {
    return T_max > 0.0 && (temperature < T_min || temperature > T_max);
  }
};
/// Needs bearing.churning. @throws InputError where the temperature or a ratio gives no medium
[[nodiscard]] ChurningMedium churning_medium(const bearing::Bearing& bearing);

/// A cylindrical surface of the cage and the race that it turns in or around.
struct CageSurface {
  int race = 0;
  double radius = 0.0;             ///< of the inner one of both surfaces [m]
  double gap = 0.0, length = 0.0;  ///< [m]
};

class BearingDrag {
 public:
  explicit BearingDrag(const bearing::Bearing& bearing);

  /// Force against the velocity, over its size V [N s/m].
  [[nodiscard]] double element_force_per_speed(double V) const noexcept;
  /// Moment against the spin about the element's axis (balls: any), over its size [N m s].
  [[nodiscard]] double element_spin(double omega) const noexcept;
  /// Of one surface against the turn of the cage relative to its race, over its size [N m s].
  [[nodiscard]] double surface_moment_per_speed(const CageSurface& surface,
                                                double omega) const noexcept;
  /// Of both side faces, relative to the medium.
  [[nodiscard]] double face_moment_per_speed(double omega) const noexcept;

  [[nodiscard]] const std::vector<CageSurface>& surfaces() const noexcept { return surfaces_; }
  [[nodiscard]] const ChurningMedium& medium() const noexcept { return medium_; }
  /// Mean radius of the side faces of the cage [m].
  [[nodiscard]] double mean_face_radius() const noexcept {
    return 0.5 * (cage_face_radii_[0] + cage_face_radii_[1]);
  }
  /// Part of an element's projected area that the cage does not hide.
  [[nodiscard]] double exposed_area_fraction() const noexcept { return exposed_area_fraction_; }

 private:
  void add_cage(const bearing::Cage& cage, const bearing::Bearing& bearing);

  ChurningMedium medium_;
  double diameter_ = 0.0, length_ = 0.0;  ///< length 0: balls
  double exposed_area_fraction_ = 1.0;
  std::vector<CageSurface> surfaces_;
  std::array<double, 2>
      cage_face_radii_{};  ///< outer and inner radius of the cage's sides; 0: no cage
};

/// Power that the medium takes at steady speeds [W].
struct DragPower {
  double elements = 0.0, cage = 0.0;
  [[nodiscard]] double total() const noexcept { return elements + cage; }
};
/// @param orbit of the elements, spin about their axes relative to the base frame, cage: speeds
/// [rad/s]
[[nodiscard]] DragPower drag_power(const BearingDrag& drag, const bearing::Bearing& bearing,
                                   double orbit, double spin, double cage);

}  // namespace adore::tribology
