#pragma once

#include "agore/depth_canvas.hpp"
#include "agore/ring_profile.hpp"
#include "agore/view_scene.hpp"

#include <optional>

/// The bearing in space: what cannot be seen along its axis (contact angle, skew, tilt of rollers
/// and cage). Parallel projection; the outer race is cut open towards the viewer. Races are to
/// scale; the clearances of elements and cage are magnified like those of the bearing view, and
/// skew and tilt of rollers by a factor of their own; both are stated. Pockets are as wide in the
/// middle of the cage's height as everywhere: what a sphere or a cone has more or less at its edges
/// is in the section view alone, as are the domes of rollers, whose ends are flat here and whose
/// corners are chamfers.
namespace adore::agore {

/// Where the viewer stands, far away: directions of the picture in the bearing's axes.
struct Eye {
  Eye(double yaw, double elevation);  ///< [degrees]; 0, 0: on the +X side, as in the flat views
  Vec3 right, up, toward;
};

/// Draws frames of one animation; keeps between them what does not move.
class SolidLayer {
 public:
  /// Draws the bodies into the area of the scene's sketch, `oversample` pixels for one of it each
  /// way.
  void draw(const Scene& scene, int oversample, double pixel_ratio);
  /// Magnification of skew and tilt of the rollers; 0 where there is none.
  double roller_factor(const Animation& animation);

 private:
  /// What the races' picture depends on.
  struct Key {
    QSize size;
    double scale = 0.0, yaw = 0.0, elevation = 0.0, x = 0.0, y = 0.0, factor = 0.0;
    std::array<int, 6> shift{};  ///< of both races, in half pixels
    bool dark = false;
    const Animation* animation = nullptr;
    bool operator==(const Key&) const = default;
  };
  Key key_;
  DepthCanvas races_, canvas_;
  std::optional<double> roller_factor_;
};

}  // namespace adore::agore
