#include "agore/view_options.hpp"

#include "agore/view_layout.hpp"
#include "base/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <locale>
#include <numbers>
#include <sstream>

namespace adore::agore {

View parse_view(const std::string& name, const std::string& race) {
  if (name == "bearing") return View::Bearing;
  if (name == "cage") return View::Cage;
  if (name == "pocket") return View::Pocket;
  if (name == "element") return View::Element;
  if (name == "race") {
    if (race != "outer" && race != "inner")
      throw InputError("there is no race '" + race + "'; give outer or inner");
    return race == "outer" ? View::OuterRace : View::InnerRace;
  }
  if (name == "flange") return View::Flange;
  if (name == "section") return View::Section;
  if (name == "3d") return View::Solid;
  if (name == "raceways") return View::Raceways;
  throw InputError("there is no view '" + name +
                   "'; use bearing, cage, pocket, element, race, flange, section, 3d or raceways");
}

std::vector<AdditionalView> parse_additional_views(const std::string& names,
                                                   const std::string& race) {
  std::vector<AdditionalView> out;
  std::istringstream list(names);
  for (std::string name; std::getline(list, name, ',');) out.push_back({parse_view(name, race)});
  return out;
}

ViewOptions ViewOptions::tile(std::size_t number) const {
  ViewOptions out = *this;
  out.one_of_several = !beside.empty();
  out.beside.clear();
  if (number == 0) return out;
  const AdditionalView& side = beside.at(number - 1);
  out.view = side.view;
  out.zoom = side.zoom;
  out.pan = side.pan;
  return out;
}

ColourBy parse_color_quantity(const std::string& name) {
  if (name == "none") return ColourBy::None;
  if (name == "load") return ColourBy::Load;
  if (name == "slip") return ColourBy::Slip;
  if (name == "heat") return ColourBy::Heat;
  if (name == "temperature") return ColourBy::Temperature;
  if (name == "pressure") return ColourBy::Pressure;
  throw InputError("elements cannot be colored by '" + name +
                   "'; use none, load, slip, heat, temperature or pressure");
}

ColorScaleChoice parse_color_scale(const std::string& name) {
  if (name == "usual") return {};
  if (name == "run") return {ColorScaleKind::Run, 0.0, 0.0};
  if (name == "moment") return {ColorScaleKind::Moment, 0.0, 0.0};
  const InputError refusal(
      "a color scale cannot be '" + name +
      "'; use \"usual\", \"run\", \"moment\" or two increasing limits such as 0:0.02");
  std::istringstream text(name);
  text.imbue(std::locale::classic());
  ColorScaleChoice out{ColorScaleKind::Typed, 0.0, 0.0};
  char between = 0;
  if (!(text >> out.low >> between >> out.high) || between != ':') throw refusal;
  if (text >> std::ws, !text.eof()) throw refusal;
  if (!(out.high > out.low) || !std::isfinite(out.high - out.low)) throw refusal;
  return out;
}

std::string scale_name(const ColorScaleChoice& scale) {
  switch (scale.kind) {
    case ColorScaleKind::Usual:
      return "usual";
    case ColorScaleKind::Run:
      return "run";
    case ColorScaleKind::Moment:
      return "moment";
    case ColorScaleKind::Typed:
      break;
  }
  return fmt::format("{}:{}", scale.low, scale.high);
}

std::string view_name(View view) {
  switch (view) {
    case View::Bearing:
      return "bearing";
    case View::Cage:
      return "cage";
    case View::Pocket:
      return "pocket";
    case View::Element:
      return "element";
    case View::OuterRace:
      return "outer-race";
    case View::InnerRace:
      return "inner-race";
    case View::Flange:
      return "flange";
    case View::Section:
      return "section";
    case View::Solid:
      return "3d";
    case View::Raceways:
      return "raceways";
  }
  return {};
}

std::string view_title(View view) {
  switch (view) {
    case View::Bearing:
      return "Bearing motion";
    case View::Cage:
      return "Cage motion";
    case View::Pocket:
      return "Pocket interaction";
    case View::Element:
      return "Rolling element motion";
    case View::OuterRace:
      return "Outer race motion";
    case View::InnerRace:
      return "Inner race motion";
    case View::Flange:
      return "Flange interaction";
    case View::Section:
      return "Axial section";
    case View::Solid:
      return "3D view";
    case View::Raceways:
      return "Raceway contacts";
  }
  return {};
}

std::string why_not(View view, const Animation& animation) {
  if (!animation.has_cage && (view == View::Cage || view == View::Pocket))
    return "This bearing has no cage.";
  if (view == View::Flange) {
    if (animation.file.bearing_type == 1) return "Ball bearings have no flanges.";
    if (!animation.motion)
      return "The flange view needs RESULTS.h5 in the same folder: " + animation.no_contacts + ".";
    bool any = false;
    for (std::size_t race = 0; race < 2; ++race)
      for (std::size_t side = 0; side < 2; ++side) any = any || has_flange(animation, race, side);
    if (!any) return "This bearing has no flange.";
  }
  if (view == View::Raceways) {
    if (!animation.motion)
      return "The raceway contacts need RESULTS.h5 in the same folder: " + animation.no_contacts +
             ".";
    for (const char* name : {"contact.half_major", "contact.half_minor", "contact.pressure"})
      if (!animation.motion->has(name))
        return "RESULTS.h5 of an earlier program version lacks the contact ellipses. Run the deck "
               "again.";
  }
  if ((view == View::Section || view == View::Solid) && !animation.motion)
    return fmt::format("The {} needs the dimensions from RESULTS.h5 in the same folder: {}.",
                       view == View::Section ? "axial section" : "3D view", animation.no_contacts);
  return {};
}

void choose_flange_race(const Animation& animation, ViewOptions& options) {
  if (!has_flange(animation, options.flange_race, 0) &&
      !has_flange(animation, options.flange_race, 1))
    options.flange_race = 1 - options.flange_race;
}

void check_view(const Animation& animation, const ViewOptions& options) {
  const std::string reason = why_not(options.view, animation);
  if (!reason.empty()) throw InputError(reason);
  if (options.view == View::Flange && !has_flange(animation, options.flange_race, 0) &&
      !has_flange(animation, options.flange_race, 1))
    throw InputError(fmt::format("The {} race has no flange. Select the other race.",
                                 options.flange_race == 0 ? "outer" : "inner"));
  if (options.element < 1 || options.element > animation.file.elements)
    throw InputError(fmt::format(
        "there is no rolling element or pocket {}; in this bearing, their numbers are 1 to {}",
        options.element, animation.file.elements));
}

namespace {

/// Largest distance of the cage, or a part of it, from the axis, from at most a thousand samples.
double way_of_cage(const Animation& animation) {
  constexpr std::size_t kLooks = 1000;
  const std::size_t every = std::max<std::size_t>(1, animation.frames() / kLooks);
  double out = 0.0;
  for (std::size_t i = 0; i < animation.frames(); i += every)
    for (int part = 0; part < animation.segments; ++part) {
      const auto& place = animation.part(i, part).position;
      const double way = std::hypot(place[1], place[2]);
      if (std::isfinite(way)) out = std::max(out, way);
    }
  return out;
}

/// The largest possible factor of a picture: elements do not overlap and stay within the rings of
/// the races, and the cage overlaps neither ring. Rounded down to a simple number.
double most_exaggeration(const Animation& animation) {
  const auto& g = animation.file.geometry;
  const double pitch_radius = 0.5 * g.pitch_diameter, pocket = 0.5 * g.pocket_clearance_1;
  double most = std::numeric_limits<double>::infinity();
  const auto keep = [&most](double room, double way) {
    if (room > 0.0 && way > 0.0) most = std::min(most, room / way);
  };
  const double half_pitch = std::numbers::pi * pitch_radius / animation.file.elements;
  keep(0.94 * half_pitch - g.element_radius, pocket);
  const double cage =
      animation.guide_clearance > 0.0 ? animation.guide_clearance : way_of_cage(animation);
  keep(g.outer_race_inner_radius - g.cage_outer_radius, cage);
  keep(g.cage_inner_radius - g.inner_race_outer_radius, cage);
  keep(outer_rim(g) - pitch_radius - g.element_radius, cage + pocket);
  keep(pitch_radius - g.element_radius - g.inner_race_inner_radius, cage + pocket);
  return most < 10.0 ? std::max(1.0, std::floor(10.0 * most) / 10.0) : std::floor(most);
}

double automatic_exaggeration(const Animation& animation);

}  // namespace

double used_exaggeration(const Animation& animation, const ViewOptions& options) {
  if (!(options.exaggeration > 0.0)) return automatic_exaggeration(animation);
  if (!animation.has_cage || options.exaggeration <= 1.0) return options.exaggeration;
  // Values chosen from the geometry are always allowed.
  return std::min(options.exaggeration,
                  std::max(most_exaggeration(animation), automatic_exaggeration(animation)));
}

namespace {

double automatic_exaggeration(const Animation& animation) {
  if (!animation.has_cage) return 1.0;
  const auto& g = animation.file.geometry;
  const double pitch_radius = 0.5 * g.pitch_diameter;
  double limit = 100.0;
  if (animation.guide_clearance > 0.0)
    limit = std::min(limit, 0.03 * pitch_radius / animation.guide_clearance);
  // A cage that no race guides is drawn clear of those that it does not touch.
  if (const double way = way_of_cage(animation); animation.guide == Guide::None && way > 0.0)
    for (const double room : {g.outer_race_inner_radius - g.cage_outer_radius,
                              g.cage_inner_radius - g.inner_race_outer_radius})
      if (room > 0.0) limit = std::min(limit, room / way);
  if (g.pocket_clearance_1 > 0.0) {
    const double half_pitch = std::numbers::pi * pitch_radius / animation.file.elements;
    limit = std::min(limit, (0.94 * half_pitch - g.element_radius) / (0.5 * g.pocket_clearance_1));
  }
  double factor = 1.0;
  for (const double candidate : {2.0, 5.0, 10.0, 20.0, 50.0, 100.0})
    if (candidate <= limit * 1.05) factor = candidate;
  return factor;
}

}  // namespace

}  // namespace adore::agore
