#pragma once

#include <QPainterPath>
#include <QPointF>

#include <array>
#include <vector>

namespace adore::agore {

struct Animation;

/// A roller along its axis u from mid length, in the length unit of the file, from RESULTS.h5. A
/// barrel or a crowned end is an arc, without the second-order difference between a drop normal to
/// the axis and one normal to the cone (see contact/roller_profile.hpp). Ends 0 and 1 are at -u and
/// +u.
struct RollerProfile {
  double half = 0.0, radius = 0.0;         ///< of the length over all; at mid length
  double slope = 0.0;                      ///< of the cone
  double crown = 0.0, central = 0.0;       ///< radius, 0: straight; length of the straight part
  std::array<double, 2> corner{}, dome{};  ///< radii by end; 0: sharp, flat
  double mass_centre = 0.0;                ///< along u
  [[nodiscard]] bool is_barrel() const { return crown > 0.0 && !(central > 0.0); }
  [[nodiscard]] double line(double u) const;  ///< its radius there, as if it had no corners
  [[nodiscard]] double side(double u) const;  ///< its radius there
  /// The half meridian from the middle of the end at -u to that of the end at +u: (u, radius).
  [[nodiscard]] std::vector<QPointF> meridian() const;
  /// Its silhouette with u to the right.
  [[nodiscard]] QPainterPath outline() const;
  /// The same of a roller whose axis leans by an angle toward the viewer: the hull of its discs.
  [[nodiscard]] QPainterPath outline(double lean) const;
  /// Visible part of the rim of the end of such a roller; empty for a small tilt.
  [[nodiscard]] QPainterPath visible_end_rim(double lean) const;
};
[[nodiscard]] RollerProfile roller_profile(const Animation& animation);

}  // namespace adore::agore
