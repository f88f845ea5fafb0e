#pragma once

#include "deck/deck.hpp"

#include <string>
#include <string_view>
#include <vector>

/// Outlines and curves for drawings: content of a deck as plane figures that a painter only
/// has to scale. They correspond to the figures of a manual: each names the deck variables that
/// it shows. Plain values, SI meters; independent of colors and pixels.
///
/// Planes: the meridian plane has x along the bearing axis to the right and the distance from it
/// upwards (roller at azimuth 0); the side view is seen from +X, y to the right and z up.
namespace adore::drawing {

enum class View : unsigned char {
  CrossSection,    ///< meridian half section to scale
  AdditionalView,  ///< along the axis, elements at their azimuths, loads as arrows
  Element,         ///< ball, or roller with its exaggerated profile
  Pocket,          ///< cage pocket with the element in it
  Lands,           ///< guide lands of the cage, clearances exaggerated
  Flange,          ///< race flanges and the roller ends that they guide
  Traction,        ///< traction coefficient over slip of every pair that the deck describes
  Loads            ///< base frame with loads, moments, misalignments and speeds
};
[[nodiscard]] std::string_view title_of(View view);

/// Type of a shape, and subject of a variable.
enum class Part : unsigned char {
  Shaft,
  Housing,
  OuterRing,
  InnerRing,
  Element,
  Cage,
  OuterFlange,
  InnerFlange,
  Construction,  ///< center lines, pitch circle, contact line, tangents
  Curve
};

struct Point {
  double x = 0.0, y = 0.0;
};
struct Circle {
  Point centre;
  double radius = 0.0;
};
using Path = std::vector<Point>;

/// A body or a line. Areas are the closed paths and circles together, by the even-odd rule.
struct Shape {
  enum class Style : unsigned char {
    Cut,     ///< area, sectioned
    Body,    ///< area, seen as a surface
    Behind,  ///< area behind the plane of the drawing
    Line,    ///< open paths, circles as rings
    Dashed,  ///< the same, for what is not matter
    Strong   ///< thick open paths: a surface that matters
  };
  Part part = Part::Construction;
  Style style = Style::Line;
  std::string name;  ///< "outer groove", "ball", "pitch circle"
  std::vector<Path> paths;
  std::vector<Circle> circles;
  std::vector<std::string> shows;  ///< deck variables that it depicts
};

/// A deck variable shown by its measure in the figure.
struct Dimension {
  enum class Kind : unsigned char {
    Span,    ///< arrows at both ends of from - to
    Radius,  ///< arrow from the center `from` to the arc at `to`
    Leader,  ///< pointer from the label at `from` to the point `to`
    Angle    ///< arc about `centre` from the ray through `from` to the ray through `to`
  };
  Kind kind = Kind::Span;
  std::string variable;
  int instance = 1, index = 1;  ///< of a repeated record, of an array
  Point from, to, centre;
  Point from_edge, to_edge;  ///< on the body: thin lines lead from there to `from` and `to`
  bool minor = false;        ///< worth showing only while somebody works on it
  bool half = false;         ///< a diameter of which the figure has one side: `from` is on the axis
  std::string label;         ///< "pitchDia = 0.06 m": the deck's own number and unit
};

/// A load, moment, speed or displacement: the arrow runs along its path.
struct Arrow {
  enum class Kind : unsigned char { Load, Moment, Speed, Displacement, Gravity };
  Kind kind = Kind::Load;
  std::string variable;
  double value = 0.0;  ///< SI; where it is 0 the arrow shows the positive sense only
  Path path;
  std::string label;
};

/// A word in the figure: "X", the number of an element.
struct Caption {
  Point at;
  std::string text;
  double room = 0.0;  ///< width that is free for it; 0: any
};

/// Axis of a chart: shown number = SI value / factor.
struct ChartAxis {
  std::string title, unit;
  double factor = 1.0;
  double low = 0.0, high = 1.0;  ///< SI
};

/// One figure of a drawing. Without axes both directions have the same scale.
struct Pane {
  std::string title;
  double share = 1.0;  ///< of the height of the drawing, relative to the other panes
  std::vector<Shape> shapes;
  std::vector<Dimension> dimensions;
  std::vector<Arrow> arrows;
  std::vector<Caption> captions;
  std::vector<ChartAxis> axes;  ///< empty, or x and y of a chart
  std::vector<Point> window;    ///< empty, or two corners of what is to be seen
};

struct Drawing {
  View view = View::CrossSection;
  std::vector<Pane> panes;
  std::vector<std::string> remarks;  ///< exaggerations, assumptions and omissions; sentences
  std::string reason;                ///< why there is no figure; empty when there is one
};

/// Views that this deck calls for, in the order of View.
[[nodiscard]] std::vector<View> views_of(const deck::Deck& deck);

/// Draws as much as possible of any deck, also of a wrong one; otherwise `reason` has the cause.
/// Does not throw for errors of a deck. Fast: below a millisecond.
[[nodiscard]] Drawing draw(View view, const deck::Deck& deck);

/// The view that a variable belongs to; of a whole record when the variable is empty. It may be
/// none of views_of(): then the cross-section is meant.
[[nodiscard]] View view_of_variable(std::string_view record, std::string_view variable);
/// The bodies that a variable speaks of without a measure: materials, temperatures, masses.
[[nodiscard]] std::vector<Part> parts_of(std::string_view record, std::string_view variable);
/// "raceTemp1 = 293.15 K": the value in the deck; the name alone when it has none.
[[nodiscard]] std::string label_of(const deck::Deck& deck, std::string_view variable,
                                   int instance = 1, int index = 1);

}  // namespace adore::drawing
