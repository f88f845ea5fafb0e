#pragma once

#include "agore/picture_key.hpp"
#include "agore/sketch.hpp"
#include "agore/view_options.hpp"
#include "base/constants.hpp"

#include <cmath>
#include <optional>
#include <vector>

/// Shared by the sources of the views: one frame of an animation, and the drawn positions of its
/// bodies.
namespace adore::agore {

/// Everything that the views of one frame share.
struct Scene {
  const Sketch& sketch;
  const Animation& animation;
  std::size_t index;
  const results::Sol8Frame& frame;
  double factor;  ///< exaggeration
  const ViewOptions& options;
  CageOutlines& cages;
  PictureLegend& key;

  [[nodiscard]] const results::Sol8Geometry& geometry() const { return animation.file.geometry; }
  [[nodiscard]] double pitch_radius() const { return 0.5 * geometry().pitch_diameter; }
  /// Exaggerated position (y, z) of a body.
  [[nodiscard]] QPointF place(const results::Sol8Body& body) const {
    return QPointF(body.position[1], body.position[2]) * factor;
  }
  [[nodiscard]] double pocket_radius() const {
    return geometry().element_radius + 0.5 * factor * geometry().pocket_clearance_1;
  }
  /// Of the cage: the segment with the pocket of the selected element.
  [[nodiscard]] int segment() const {
    return animation.pocket_part.at(static_cast<std::size_t>(options.element - 1));
  }
  [[nodiscard]] const results::Sol8Body& cage() const { return animation.part(index, segment()); }
  [[nodiscard]] double cage_angle() const { return animation.cage_part_angle(index, segment()); }
  /// Azimuth of the center of an element's pocket.
  [[nodiscard]] double pocket_azimuth(std::size_t k) const {
    return animation.cage_part_angle(index, animation.pocket_part[k]) + animation.pocket_angle[k];
  }
};

void draw_legend(const Scene& scene, const std::vector<PictureLegendEntry>& entries,
                 const QString& remark);

/// Direction of an element's orientation mark seen from outside along the pocket axis at azimuth
/// `angle`: right is increasing azimuth, up is X.
[[nodiscard]] std::array<double, 3> mark_from_outside(const results::Sol8Element& element,
                                                      double angle);

/// Length of the arrow of the largest race load of the file: `wanted`, or the distance between the
/// elements and the circle of radius `edge`, where the texts of a picture begin.
[[nodiscard]] double longest_load_arrow(const Scene& scene, double wanted, double edge);

/// Element center (y, z) as drawn: its pocket's center plus the exaggerated way out of it, or its
/// own place when there is no cage.
[[nodiscard]] QPointF element_centre(const Scene& scene, std::size_t k);
/// @param factor magnification of the clearances
[[nodiscard]] QPointF element_centre(const Animation& animation, std::size_t frame, double factor,
                                     std::size_t k);
/// The way of an element's center as drawn, from now back over nearly a pitch; x along the axis.
struct TrailPoint {
  QPointF centre;
  double x = 0.0;
  bool joined = false;  ///< is the path to the previous point, a later frame, known?
};
[[nodiscard]] std::vector<TrailPoint> element_trail(const Scene& scene, std::size_t k);
/// Name of the lands that guide the cage, in all views.
inline constexpr const char* kGuideLands = "guide lands";
/// Names the z arm of frames without names.
void add_frame_arms_entry(const Scene& scene, bool named, std::vector<PictureLegendEntry>& key);
/// An entry for something that not all frames have: text `there` with its mark, or `none` without,
/// in the same place, so that the key does not jump.
[[nodiscard]] PictureLegendEntry optional_entry(const QColor& colour, bool now,
                                                const QString& there, const QString& none,
                                                LegendMark mark = LegendMark::Line);
/// Adds the rotation mark of an element, or of all, to the key if it is drawn, that is if the run
/// stored the rotation.
void add_rotation_mark_entry(const Scene& scene, std::optional<std::size_t> element,
                             std::vector<PictureLegendEntry>& key);
/// Of the rest of an orbit.
[[nodiscard]] PictureLegendEntry remaining_orbit_entry(const Scene& scene);

/// Key entry of a path; `what`: "path" or similar, `places`: name of its marks if the path is
/// unknown.
[[nodiscard]] PictureLegendEntry trajectory_entry(const QColor& colour, Known known,
                                                  const QString& what, const QString& places);
/// Addition to the key in this case.
inline constexpr const char* kTooSmall = ", arrow too small";
/// Key entry of the paths of element_trail(), if there are any.
[[nodiscard]] PictureLegendEntry trail_entry(const Scene& scene, bool any);
/// Told apart from loads, frames and marks with every color vision.
[[nodiscard]] QColor trail_colour(const Scene& scene);

/// ", up to 390 N" in the run, for a key: all arrows of loads are on one scale, and that one may
/// not be in the frame that is drawn.
[[nodiscard]] QString largest_load_text(const Scene& scene, double load);

/// Draws the arrow of a load from `tail` to `tip` in the picture. @return false: too short to be
/// visible, as stated in the key
bool draw_load_arrow(const Scene& scene, QPointF tail, QPointF tip, const QColor& colour,
                     double width);

/// Of the largest load of the run: smaller ones of many elements have no arrow.
inline constexpr double kLeastLoad = 0.01;
/// A load whose arrow would be too short: length from its scale, at least 3 pixels, so that a
/// loaded element does not look unloaded.
void draw_load_stub(QPainter& painter, QPointF tail, QPointF tip, const QColor& colour,
                    const QColor& casing);

/// Seen along the bearing axis; `tint` invalid: steel.
void draw_element(const Scene& scene, std::size_t k, const QColor& tint = {}, bool marked = true);
/// All elements, colored according to the options, with the scale. Without their rotation marks if
/// paths are drawn over them.
void draw_elements(const Scene& scene);
/// Those marks.
void draw_rotation_marks(const Scene& scene);
/// Marks the contacts of the cage with the elements, and their numbers.
void draw_contact_marks(const Scene& scene);
struct DrawnOrbit {
  double enlargement = 0.0;  ///< 0: the body stands still
  QPointF now{0.0, 0.0};     ///< where its center is in the picture
};
/// Orbit of a body's center, enlarged to `radius` of the picture's lengths. Without a reference
/// length it is drawn about its middle, which is not magnified: only motion is. A body that moves
/// less than an atom's size stands still.
DrawnOrbit draw_orbit(const Scene& scene, double radius, double reference,
                      std::vector<QPointF> orbit);
/// Current position of the center, over its frame.
void draw_orbit_center(const Scene& scene, const DrawnOrbit& orbit);

class SolidLayer;

/// Constant parts of a view while the races do not move, below the rest.
void draw_bearing_rings(const Scene& scene);
void draw_element_rings(const Scene& scene);
void draw_race_ring(const Scene& scene);

void draw_bearing_view(const Scene& scene);
void draw_cage_view(const Scene& scene);
void draw_element_view(const Scene& scene);
void draw_race_view(const Scene& scene);
void solid_view(const Scene& scene, SolidLayer& layer);
void draw_pocket_view(const Scene& scene);
void draw_section_view(const Scene& scene);
void draw_flange_view(const Scene& scene);
void draw_raceway_view(const Scene& scene);
/// Half the height that they need, in the file's length.
[[nodiscard]] double pocket_picture_radius(const Animation& animation);
[[nodiscard]] double section_picture_radius(const Animation& animation);
[[nodiscard]] double flange_picture_radius(const Animation& animation);
[[nodiscard]] double solid_picture_radius(const Animation& animation);

/// A quantity of an element as a color: where the value is between the ends of the scale.
struct ElementColors {
  std::string title, unit;
  double low = 0.0, high = 0.0;  ///< ends of the scale
  bool above = false;            ///< the run has values beyond its upper end
  bool below = false;            ///< beyond its lower end
  std::string scale;             ///< type of the scale, and largest value of the run
  std::vector<double> value;     ///< of each element at the frame; empty: nothing to color by
  std::vector<bool>
      touches;  ///< has contact with a race: elements without contact have a special color
  std::string why_none;
  [[nodiscard]] bool any() const { return !value.empty() && high > low; }
  /// Color of an element; invalid: steel.
  [[nodiscard]] QColor of(std::size_t element) const;
  /// Names of the ends of the scale, with a sign for values outside.
  [[nodiscard]] std::string low_end_label() const;
  [[nodiscard]] std::string high_end_label() const;
};
[[nodiscard]] ElementColors element_colors(const Animation& animation, std::size_t frame,
                                           ColourBy by, const ColorScaleChoice& scale = {});
/// Of an element that touches no race: a gray, which no scale has.
[[nodiscard]] QColor no_contact_colour();
/// Blue over green to yellow, even in lightness; `part` 0 to 1. No color is as dark as the rotation
/// marks, which keep one color on all of them.
[[nodiscard]] QColor scale_colour(double part);
/// Bar with its ends and values outside, in the upper right corner of the picture. Small pictures
/// have no space for it: the common key names its ends.
void draw_color_scale(const Scene& scene, const ElementColors& element_colors);
/// Color of flange forces, in all views.
[[nodiscard]] QColor flange_force_colour(const desktop::Theme& theme);
/// Color of the frame of a race and of its marks, in all views.
[[nodiscard]] QColor race_colour(const desktop::Theme& theme, std::size_t race);
/// Of the race loads on all elements, if there are any arrows of them.
[[nodiscard]] PictureLegendEntry loads_entry(const Scene& scene, std::size_t race, bool any);
/// Those names, and that of elements without contact, for the key.
[[nodiscard]] std::vector<PictureLegendEntry> scale_entries(const Scene& scene);

}  // namespace adore::agore
