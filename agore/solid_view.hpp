#pragma once

#include "agore/depth_canvas.hpp"
#include "agore/ring_profile.hpp"
#include "agore/view_scene.hpp"

#include <optional>
#include <vector>

/// The bearing in space, with contact angle, skew, and tilt of rollers and cage. Parallel
/// projection; the outer race is cut open toward the viewer. Races are to scale; clearances of
/// elements and cage are magnified as in the bearing view, skew and tilt of rollers by a separate
/// factor; both are stated. Pockets have the width at mid height of the cage: spherical and conical
/// walls and roller domes are drawn only in the section; here roller ends are flat and corners
/// chamfered.
namespace adore::agore {

/// Viewing direction, from infinity: axes of the picture in bearing coordinates.
struct Eye {
  Eye(double yaw, double elevation);  ///< [degrees]; 0, 0: on the +X side, as in the flat views
  Vec3 right, up, toward;
};

/// Half angle of the cut of the outer race, about the direction of the viewer [rad].
inline constexpr double kOpen = 70.0 * kPi / 180.0;
[[nodiscard]] double viewers_azimuth(const Eye& eye);
/// Is the spot of the outer race on metal that is drawn?
[[nodiscard]] bool is_outer_mark_visible(const Scene& scene, const Eye& eye);

/// Center as drawn: the clearances magnified across the axis, to scale along it.
[[nodiscard]] Vec3 drawn_element_center(const Scene& scene, std::size_t k);

/// A spot on a face of a race, which shows its turning.
struct RaceRotationMark {
  std::size_t race;
  Vec3 centre;
};
/// Those on metal that is drawn.
[[nodiscard]] std::vector<RaceRotationMark> race_rotation_marks(const Scene& scene, const Eye& eye);
[[nodiscard]] double race_rotation_mark_radius(const Scene& scene);

/// Color of the marks that turn with elements in space. Green on steel, because a flat dark mark
/// looks like a hole there; on colored elements the dark gray of no color of the scale.
[[nodiscard]] QColor solid_rotation_mark_color(const desktop::Theme& theme, bool coloured = false);

/// Draws frames of one animation; caches constant parts.
class SolidLayer {
 public:
  /// Draws the bodies into the area of the scene's sketch, with `oversample` pixels per pixel in
  /// each direction.
  void draw(const Scene& scene, int oversample, double pixel_ratio);
  /// Do the bodies drawn last lie before a place of the picture, that far toward the viewer
  /// [pixels]?
  [[nodiscard]] bool hides(QPointF place, double depth) const;
  /// Magnification of skew and tilt of the rollers; 0 without them.
  double roller_factor(const Animation& animation);

 private:
  /// Dependencies of the picture of the races.
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
  QPointF canvas_corner_;           ///< of the canvas in the picture
  double canvas_pixel_size_ = 1.0;  ///< of the canvas, in pixels of the picture
  std::optional<double> roller_factor_;
};

/// Drawn parts of lines of one kind: in front of bodies, and behind them.
struct LineVisibility {
  bool seen = false, hidden = false;
};
/// Paths of the elements; arrows of the loads of both races. Dashed behind bodies, with hollow
/// heads.
LineVisibility draw_paths(const Scene& scene, const SolidLayer& layer, const Eye& eye);
std::array<LineVisibility, 2> draw_loads(const Scene& scene, const SolidLayer& layer,
                                         const Eye& eye);

}  // namespace adore::agore
