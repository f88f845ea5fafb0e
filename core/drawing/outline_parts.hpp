#pragma once

#include "drawing/outline_model.hpp"

#include <numbers>

/// Pieces that several views are put together from.
namespace adore::drawing {

inline constexpr double kTurn = 2.0 * std::numbers::pi;

/// Points of a circle's arc between two angles from the x axis, both ends included.
[[nodiscard]] Path arc(Point centre, double radius, double from, double to, int parts = 32);
void append(Path& path, const Path& more);
[[nodiscard]] Path rectangle(double left, double bottom, double right, double top);
/// Position at azimuth θ in the side view: y = -r sin θ, z = r cos θ.
[[nodiscard]] Point point_at_azimuth(double radius, double azimuth);

/// One closed outline of a part; `shows` are the variables that it stands for.
[[nodiscard]] Shape shape_of(Part part, Shape::Style style, std::string name, Path path,
                             std::vector<std::string> shows = {});

/// Ring of one race in the meridian plane with groove or raceway and flanges.
[[nodiscard]] Shape ring_section(const OutlineModel& model, int race);
/// Ball or roller, in its place in the meridian plane.
[[nodiscard]] Shape element_section(const OutlineModel& model);
/// Outline of a roller along s (to the right), closed.
[[nodiscard]] Path roller_outline(const contact::RollerProfile& profile);
/// Bars of the cage to both sides of the element, cut through the middle of a pocket.
[[nodiscard]] std::vector<Shape> cage_section(const OutlineModel& model);
/// Half size of the pocket along the cage axis at height z over the pitch circle, and along its
/// circumference.
[[nodiscard]] double pocket_half_axial(const OutlineModel& model, double z);
[[nodiscard]] double pocket_half_circumferential(const OutlineModel& model, double z);

/// Collects the dimensions of a pane.
class DimensionCollector {
 public:
  DimensionCollector(const deck::Deck& deck, Pane& pane) : deck_(deck), pane_(pane) {}
  /// Between two values of x, drawn at height y; the edges are where the body is.
  void horizontal(std::string_view variable, double x1, double x2, double y, Point edge1,
                  Point edge2, int instance = 1, int index = 1);
  /// Between two values of y, drawn at x.
  void vertical(std::string_view variable, double y1, double y2, double x, Point edge1, Point edge2,
                int instance = 1, int index = 1);
  /// One side of a diameter, at x, from the axis to the radius of the body that ends at x = `body`.
  void half_diameter(std::string_view variable, double radius, double x, double body);
  /// Straight from point to point.
  void between(std::string_view variable, Point from, Point to, int instance = 1, int index = 1);
  void radius(std::string_view variable, Point centre, Point on_arc);
  void leader(std::string_view variable, Point from, Point to, int instance = 1, int index = 1);
  /// A leader that is shown only in focus: of what is too small to see, or mostly zero.
  void note(std::string_view variable, Point from, Point to, int instance = 1, int index = 1);
  void angle(std::string_view variable, Point centre, Point from, Point to, int instance = 1,
             int index = 1);

 private:
  void add(Dimension dimension, std::string_view variable, int instance, int index);
  const deck::Deck& deck_;
  Pane& pane_;
};

// The views. @throws InputError with the reason when there is nothing to draw.
[[nodiscard]] Drawing draw_cross_section(const deck::Deck& deck);
[[nodiscard]] Drawing draw_side_view(const deck::Deck& deck);
[[nodiscard]] Drawing draw_element(const deck::Deck& deck);
[[nodiscard]] Drawing draw_pocket(const deck::Deck& deck);
[[nodiscard]] Drawing draw_lands(const deck::Deck& deck);
[[nodiscard]] Drawing draw_flanges(const deck::Deck& deck);
[[nodiscard]] Drawing draw_traction(const deck::Deck& deck);
[[nodiscard]] Drawing draw_loads(const deck::Deck& deck);

}  // namespace adore::drawing
