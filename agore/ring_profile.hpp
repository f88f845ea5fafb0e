#pragma once

#include "agore/animation.hpp"
#include "agore/roller_outline.hpp"

#include <QPointF>

#include <array>
#include <utility>
#include <vector>

/// Cuts through the bodies along the bearing's axis, in the file's length: (x, r). They need the
/// sizes of RESULTS.h5.
namespace adore::agore {

/// A dimension of RESULTS.h5 (SI), or `otherwise` if missing.
[[nodiscard]] double dimension_in_si(const Animation& animation, const char* name,
                                     double otherwise = 0.0);
/// A length of RESULTS.h5 in the unit of the file; `otherwise` if it is not above 0.
[[nodiscard]] double dimension_in_file_unit(const Animation& animation, const char* name,
                                            double otherwise = 0.0);
/// [m] per unit of length of the file.
[[nodiscard]] double length_unit(const Animation& animation);

/// A ring at one axial position: from the side of the elements to the far one.
struct RingRadii {
  double x = 0.0, near = 0.0, far = 0.0;
};
/// A guide land of the cage along x, with its radius on the cage and on the race that guides it.
struct LandSection {
  std::size_t race = 0;
  double low = 0.0, high = 0.0;
  double on_cage = 0.0, on_race = 0.0;
};
/// @param clearance magnification of the land clearance
[[nodiscard]] std::vector<LandSection> land_sections(const Animation& animation,
                                                     double clearance = 1.0);

/// Race 0 (outer) or 1 (inner) without displacement, from -x to +x. A race that guides the cage has
/// the height of its land up to its face [choice: files do not contain its shape beyond the land].
/// @param clearance magnification of the land clearance
[[nodiscard]] std::vector<RingRadii> ring_profile(const Animation& animation, std::size_t race,
                                                  double clearance = 1.0);

/// Its corners (x, r) in order. The far side is one straight line: at an overhanging end of a
/// tilted roller columns go back, and the far side would be drawn three times.
[[nodiscard]] std::vector<QPointF> ring_outline(const std::vector<RingRadii>& profile);

/// Lean of the rollers' axes outward [rad] as the run began; 0 for balls.
[[nodiscard]] double nominal_lean(const Animation& animation);
/// Of one roller at a frame: lean outward and skew (turned toward increasing azimuth) [rad].
struct AxisAngles {
  double lean = 0.0, skew = 0.0;
};
[[nodiscard]] AxisAngles axis_angles(const results::Sol8Element& element);

/// (u, v) of a body at (x, r) whose axis leans outward by `lean`.
[[nodiscard]] QPointF tilted_point(double x, double r, double lean, double u, double v);

/// The section of the cage, its corners about (0, pitch radius); a conical cage is tilted like its
/// rollers. Empty without a cage.
struct CageProfile {
  double lean = 0.0, half_width = 0.0;
  double low = 0.0, high = 0.0;  ///< from the pitch radius, across
  /// Half of a pocket along its axis: `hole` in the middle of the cage's height; a sphere of
  /// `round` or a cone of `flare` over the height is less or more elsewhere.
  double hole = 0.0, round = 0.0, flare = 0.0;
  std::array<double, 2> leaning{};  ///< addition of end_wall_offsets()
  /// @param end 0 at -u, 1 at +u
  [[nodiscard]] double pocket_half_length_at(double across, std::size_t end) const;
};
/// Additional distance of the end walls at -u and +u from the middle of the pocket for the nominal
/// tilted roller: it has half of clearance I at each end for any tilt (decision 213).
[[nodiscard]] std::array<double, 2> end_wall_offsets(const RollerProfile& roller, double lean);
[[nodiscard]] CageProfile cage_profile(const Animation& animation);
/// The part of a land along x on the bar next to a pocket, in the section plane; all of it if the
/// land is not on one side.
[[nodiscard]] std::pair<double, double> land_range_on_bar(const CageProfile& cage,
                                                          double pitch_radius,
                                                          const LandSection& land);

}  // namespace adore::agore
