#pragma once

#include "agore/animation.hpp"
#include "agore/warned_bodies.hpp"

#include <QPointF>

#include <optional>
#include <string>
#include <vector>

namespace adore::agore {

enum class View : unsigned char {
  Bearing,
  Cage,
  Pocket,
  Element,
  OuterRace,
  InnerRace,
  Flange,
  Section,  ///< the cut through one element and the bearing's axis
  Solid,    ///< in space
  Raceways  ///< both unrolled, with the contact ellipses
};

/// By what the elements of the bearing view are colored: the larger of both contacts.
enum class ColourBy : unsigned char { None, Load, Slip, Heat, Temperature, Pressure };

/// How the scale of colors is chosen.
enum class ColorScaleKind : unsigned char {
  Usual,   ///< limit for 95 % of the values of the run: a short peak does not hide differences
  Run,     ///< to the largest of the run
  Moment,  ///< to the largest of the frame
  Typed
};
struct ColorScaleChoice {
  ColorScaleKind kind = ColorScaleKind::Usual;
  double low = 0.0, high = 0.0;  ///< specified limits, in the unit of the channel
  bool operator==(const ColorScaleChoice&) const = default;
};

/// Parts of a picture that can be hidden, so that the bodies get their space.
struct ShownParts {
  bool heading = true, chart = true, key = true;
  bool operator==(const ShownParts&) const = default;
};

/// An additional view, with its own zoom.
struct AdditionalView {
  View view = View::Section;
  double zoom = 1.0;
  QPointF pan{0.0, 0.0};
  bool operator==(const AdditionalView&) const = default;
};

struct ViewOptions {
  View view = View::Bearing;
  int element = 1;            ///< element or pocket of the single views, from 1
  double exaggeration = 0.0;  ///< of clearances and the motions within them; 0 = chosen from the
                              ///< geometry, 1 = to scale
  bool dark = false;
  std::size_t flange_race = 1;  ///< of the flange view: 0 outer, 1 inner
  ColourBy colour = ColourBy::None;
  ColorScaleChoice scale;
  bool contacts = false;  ///< arrows of the race loads on all elements
  bool trails = false;    ///< paths of the elements so far
  double zoom = 1.0;
  QPointF pan{0.0, 0.0};                ///< of the picture, in parts of its size
  double yaw = 32.0, elevation = 18.0;  ///< of the 3D view's eye [degrees], from +X
  bool moving = false;                  ///< a quick picture of the 3D view is enough
  /// Repeated range, as shown in the time bar [s]; none: to that end of the run.
  std::optional<double> span_from, span_to;
  bool one_of_several = false;  ///< one of several: smaller pictures share a key below them
  std::vector<AdditionalView> beside = {};  ///< additional views of the same frame

  ShownParts shown = {};
  bool picked = false;       ///< the element has a ring in the views of all elements
  WarnedBodies warned = {};  ///< get a ring in the bearing view

  /// The options of one of the pictures: 0 is the first view, others are additional ones.
  [[nodiscard]] ViewOptions tile(std::size_t number) const;
};

/// "bearing", "cage", "pocket", "element", "section", "3d", "raceways", "flange", "race" (`race`
/// outer or inner).
/// @throws InputError with the list of names.
View parse_view(const std::string& name, const std::string& race = "inner");

/// "3d,section": several views, separated by commas; empty: none. @throws InputError as
/// parse_view()
std::vector<AdditionalView> parse_additional_views(const std::string& names,
                                                   const std::string& race = "inner");

/// "none", "load", "slip", "heat", "temperature", "pressure". @throws InputError with the list of
/// names.
ColourBy parse_color_quantity(const std::string& name);

/// "usual", "run", "moment", or two limits: "0:0.02". @throws InputError with the valid values.
ColorScaleChoice parse_color_scale(const std::string& name);
/// The way back.
std::string scale_name(const ColorScaleChoice& scale);

/// "bearing", "outer-race", "3d": a view's name in names of files.
std::string view_name(View view);

/// Title of a view for menus and pictures.
std::string view_title(View view);

/// Why a view cannot be shown for this file ("the bearing has no cage"), or empty.
std::string why_not(View view, const Animation& animation);

/// No race is selected: the flange view uses one with a flange.
void choose_flange_race(const Animation& animation, ViewOptions& options);

/// @throws InputError when the file cannot show this view or has no such element.
void check_view(const Animation& animation, const ViewOptions& options);

/// The magnification in use: that of the user, or the largest of 1, 2, 5, 10 ... for which pockets
/// do not overlap and the guide clearance is about 3 % of the pitch radius.
double used_exaggeration(const Animation& animation, const ViewOptions& options);

}  // namespace adore::agore
