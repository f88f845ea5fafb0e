#include "base/constants.hpp"
#include "base/counted.hpp"
#include "deck/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

/// Records 4 and 5: sizes that cannot go together. Lengths are compared in meters.
namespace adore::deck {
namespace {

constexpr double kTextRounding =
    1e-9;  // relative; the deck's own rounding must not turn equal into unequal

bool above(double a, double b) { return a > b * (1.0 + kTextRounding) + 1e-15; }

/// Chord between neighboring element centers on a circle.
double element_pitch(double circle_diameter, long long count) {
  return circle_diameter * std::sin(std::numbers::pi / static_cast<double>(count));
}

/// Do the elements fit side by side on the pitch circle?
void check_fit_on_circle(Checker& c, double pitch_diameter, double element_diameter) {
  const auto count = c.integer("nRe");
  if (!count || *count < 2) return;
  const double pitch = element_pitch(pitch_diameter, *count);
  if (!above(element_diameter, pitch)) return;
  const double fitting =
      std::numbers::pi / std::asin(std::min(1.0, element_diameter / pitch_diameter));
  c.error("nRe",
          fmt::format("{} elements do not fit on the pitch circle: their centers are {} apart, but "
                      "their diameter is {}",
                      *count, c.length(pitch), c.length(element_diameter)),
          "enter at most " +
              counted(static_cast<long long>(fitting * (1.0 + kTextRounding)), "element"));
}

void check_pitch_circle(Checker& c, double pitch_diameter, double element_diameter) {
  const auto bore = c.si("brgBore");
  const auto outside = c.si("brgOD");
  if (bore && outside && *bore < *outside) {
    if (pitch_diameter <= *bore || pitch_diameter >= *outside)
      c.error("pitchDia",
              fmt::format("the pitch circle must be between bore ({}) and outside diameter ({})",
                          c.length(*bore), c.length(*outside)),
              "check pitchDia, brgBore and brgOD");
    else if (pitch_diameter - element_diameter <= *bore ||
             pitch_diameter + element_diameter >= *outside)
      c.warning("bReDia",
                "the elements reach through a race: no ring material is left at the bore or at the "
                "outside diameter",
                "check bReDia, pitchDia, brgBore and brgOD");
  }
  check_fit_on_circle(c, pitch_diameter, element_diameter);
}

void check_plausible_lengths(Checker& c) {
  for (const std::string_view name : {"brgBore", "brgOD", "bReDia", "pitchDia", "cageDia1"}) {
    const auto length = c.si(name);
    if (length && *length > 5.0)
      c.warning(name, fmt::format("{} is very large for a bearing", c.length(*length)),
                "enter lengths in m (SI) or inches (English), not mm");
  }
  for (const std::string_view name : {"rmsAspHt1", "rmsAspHt2"}) {
    const auto height = c.si(name);
    if (height && *height > 1e-4)
      c.warning(name, fmt::format("a roughness of {} is very large", c.length(*height)),
                "enter lengths in m (SI) or inches (English), not µm");
  }
}

void check_angle_and_clearance(Checker& c, double diameter) {
  const auto angle = c.si("freeConAng");
  const auto clearance = c.si("freeIntCls");
  const auto f1 = c.value_in_deck_units("raceCurFac1");
  const auto f2 = c.value_in_deck_units("raceCurFac2");
  if (!angle || !clearance || !f1 || !f2 || *f1 <= 0.5 || *f2 <= 0.5) return;
  const double room =
      2.0 * diameter * (*f1 + *f2 - 1.0);  // clearance at a contact angle of 90 degrees
  if (*angle == 0.0) {
    if (*clearance == 0.0)
      c.warning("freeIntCls",
                "contact angle and clearance are both zero: the bearing has neither clearance nor "
                "preload",
                "enter freeConAng or freeIntCls, unless zero clearance is intended");
    if (*clearance > room)
      c.error("freeIntCls",
              fmt::format("with this clearance a ball cannot touch both races: the grooves allow a "
                          "clearance of at most {}",
                          c.length(room)),
              "enter a smaller clearance or larger groove radii (raceCurFac1, raceCurFac2)");
    return;
  }
  const double implied = room * (1.0 - std::cos(*angle));
  if (*clearance != 0.0 && std::abs(*clearance - implied) > 0.05 * implied)
    c.warning("freeIntCls",
              fmt::format("is not used: freeConAng is above 0 and determines a clearance of {}",
                          c.length(implied)),
              "set freeIntCls or freeConAng to 0");
}

/// Grooves as open as these are made for tests with balls smaller than the race was ground for.
void check_open_grooves(Checker& c) {
  constexpr double kOpen = 1.0;
  for (const char* name : {"raceCurFac1", "raceCurFac2"}) {
    const auto factor = c.value_in_deck_units(name);
    if (factor && *factor >= kOpen)
      c.warning(name,
                "the groove radius is not below the ball diameter, so that the contact is nearly "
                "circular",
                "the usual range is 0.515 to 0.53; keep the value if the race was ground for "
                "larger balls");
  }
}

void check_shims(Checker& c, double diameter) {
  for (const int race : {1, 2}) {
    const auto factor = c.value_in_deck_units(fmt::format("raceCurFac{}", race));
    const std::string name = fmt::format("shimThickness{}", race);
    const auto shim = c.si(name);
    if (!factor || !shim || *factor <= 0.5) continue;
    const double widest = (2.0 * *factor - 1.0) * diameter;
    if (*shim >= widest && *shim > 0.0)
      c.error(name,
              fmt::format("the shim is too thick for a split groove: it must be thinner than {}, "
                          "which is (2 f - 1) D with ball diameter D and groove radius f D",
                          c.length(widest)),
              "enter a thinner shim, or 0 for a race that is not split");
  }
}

/// Both race cones share their apex; the element at half length rolls between them (notes N38).
double cone_pitch_diameter(double diameter, double outer, double inner) {
  return diameter * std::sin(0.5 * (outer + inner)) / std::tan(0.5 * (outer - inner));
}

/// The inner cone angle in (0, outer) that gives this pitch diameter, which grows with it.
double inner_cone_for(double pitch_diameter, double diameter, double outer) {
  double low = 0.0, high = outer;
  for (int n = 0; n < 100; ++n) {
    const double middle = 0.5 * (low + high);
    (cone_pitch_diameter(diameter, outer, middle) < pitch_diameter ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// The pitch diameter is not an input: inconsistent angles make it infinite or smaller than
/// the shaft (N38).
void check_cone_pitch(Checker& c, double pitch, double diameter, double outer, double inner) {
  const auto bore = c.si("brgBore");
  const auto outside = c.si("brgOD");
  if (!bore || !outside || *bore >= *outside) return;
  const auto angle = [&](double rad) { return fmt::format("{:.5g} deg", rad / kDegree); };
  const std::string formula = fmt::format(
      "the resulting pitch diameter, bReDia sin(mean angle) / tan(half the "
      "angle difference), is {}",
      c.length(pitch));
  const bool wide = pitch >= *outside;
  if (wide || pitch <= *bore) {
    const double first = inner_cone_for(*bore + diameter, diameter, outer);
    const double last = inner_cone_for(*outside - diameter, diameter, outer);
    const std::string remedy = *bore + diameter < *outside - diameter
                                   ? fmt::format(
                                         "enter an inner cone angle of {} to {} for this outer "
                                         "cone, or change both angles",
                                         angle(first), angle(last))
                                   : "check bReDia, brgBore and brgOD";
    c.error("raceTaper2",
            fmt::format("the cone angles {} (outer, raceTaper1) and {} (inner) are too {}: {}, "
                        "{} the {} of {}",
                        angle(outer), angle(inner), wide ? "close" : "far apart", formula,
                        wide ? "not below" : "not above", wide ? "outside diameter" : "bore",
                        c.length(wide ? *outside : *bore)),
            remedy);
  } else if (pitch - diameter <= *bore || pitch + diameter >= *outside) {
    c.warning("raceTaper2",
              fmt::format("the rollers reach through a race, so that no ring material is left at "
                          "the bore or at the outside diameter: {}",
                          formula),
              "check raceTaper1, raceTaper2, bReDia, brgBore and brgOD");
  }
}

void check_cones(Checker& c, double diameter) {
  const auto outer = c.si("raceTaper1");
  const auto inner = c.si("raceTaper2");
  if (!outer || !inner) return;
  if (*outer <= *inner)
    return c.error("raceTaper1",
                   "the outer cone angle must be larger than the inner cone angle; otherwise the "
                   "roller has no taper",
                   "enter a value of raceTaper1 above raceTaper2");
  const double pitch = cone_pitch_diameter(diameter, *outer, *inner);
  check_cone_pitch(c, pitch, diameter, *outer, *inner);
  check_fit_on_circle(c, pitch, diameter);
}

/// A flange that is there has a face: it leans away from the roller, and it has a height.
void check_flanges(Checker& c) {
  const auto type = c.integer("kBrg");
  if (!type || *type == 1) return;  // balls touch none
  for (const std::string_view code : {"11", "21", "12", "22"}) {
    if (!c.is(fmt::format("kFlngInd{}", code), 1)) continue;
    const std::string off = fmt::format("or set kFlngInd{} to 0", code);
    const std::string height = fmt::format("flngHt{}", code);
    const std::string layback = fmt::format("flngAng{}", code);
    const auto h = c.si(height);
    const auto angle = c.value_in_deck_units(layback);
    constexpr double kMinFlangeHeight = 1e-6;  // [m]
    if (h && *h < kMinFlangeHeight)
      c.error(height, "the flange has no height and cannot touch a roller",
              "enter a height above 0, " + off);
    if (angle && (*angle < 0.0 || *angle > 89.0))
      c.error(layback, "the flange face must lean away from the roller end by 0 to 89 deg",
              "enter 0 to 89 deg, " + off);
  }
  if (*type == 4 && c.is("kFlngInd11", 0) && c.is("kFlngInd12", 0))
    c.error("kFlngInd12",
            "tapered rollers need a flange at their large end (negative x side); without this "
            "flange, any load pushes the rollers out",
            "set kFlngInd12 to 1 and give record 5F (rib of the inner race)");
}

void check_roller_profile(Checker& c, double diameter) {
  const auto length = c.si("bReLen");
  const auto land = c.si("bReCenLen");
  const auto corner1 = c.si("bReCorRad1");
  const auto corner2 = c.si("bReCorRad2");
  if (!length || *length <= 0.0) return;
  if (land && above(*land, *length))
    c.error(
        "bReCenLen",
        fmt::format("the central land is longer than the roller, bReLen = {}", c.length(*length)),
        "enter a length of at most bReLen");
  if (corner1 && corner2 && *corner1 + *corner2 >= *length)
    c.error("bReCorRad1",
            fmt::format("the two corner radii together are not below the roller length of {}",
                        c.length(*length)),
            "enter smaller corner radii");
  for (const std::string_view name : {"bReCorRad1", "bReCorRad2"}) {
    const auto corner = c.si(name);
    if (corner && *corner > 0.5 * diameter)
      c.error(name, "a corner radius cannot exceed the roller radius",
              "enter a smaller corner radius");
  }
}

}  // namespace

void check_envelope(Checker& c) {
  const auto bore = c.si("brgBore");
  const auto outside = c.si("brgOD");
  const auto shaft_bore = c.si("shftID");
  const auto housing = c.si("hsngOD");
  if (bore && outside && *bore >= *outside)
    c.error(
        "brgBore",
        fmt::format("the bore must be smaller than the outside diameter of {}", c.length(*outside)),
        "check brgBore and brgOD");
  if (bore && shaft_bore && *shaft_bore >= *bore && *bore > 0.0)
    c.error(
        "shftID",
        fmt::format("the shaft has no wall: the shaft bore must be below the bearing bore of {}",
                    c.length(*bore)),
        "enter a smaller shaft bore, or 0 for a solid shaft");
  if (outside && housing && *housing == 0.0)
    c.warning("hsngOD", "the housing has no wall that could hold the outer race with a fit",
              "enter the outside diameter of the housing");
  else if (outside && housing && above(*outside, *housing))
    c.error("hsngOD",
            fmt::format("the housing must be larger than the bearing, whose outside diameter is {}",
                        c.length(*outside)),
            "check hsngOD and brgOD");
  check_flanges(c);
  check_plausible_lengths(c);
}

void check_ball_geometry(Checker& c) {
  const auto diameter = c.si("bReDia");
  if (!c.is("kBrg", 1) || !diameter || *diameter <= 0.0) return;
  const auto pitch = c.si("pitchDia");
  if (pitch && *pitch > 0.0) {
    if (*pitch <= *diameter)
      c.error("pitchDia",
              fmt::format("the pitch diameter must be larger than the ball diameter of {}",
                          c.length(*diameter)),
              "check pitchDia and bReDia");
    else
      check_pitch_circle(c, *pitch, *diameter);
  }
  check_angle_and_clearance(c, *diameter);
  check_open_grooves(c);
  check_shims(c, *diameter);
  const auto outer_shoulder = c.si("shoulderDia1");
  const auto inner_shoulder = c.si("shoulderDia2");
  if (outer_shoulder && inner_shoulder && *outer_shoulder > 0.0 &&
      *outer_shoulder <= *inner_shoulder)
    c.warning("shoulderDia1",
              "the diameter of the outer shoulder is not larger than that of the inner shoulder",
              "check shoulderDia1 and shoulderDia2");
  else if (pitch && outer_shoulder && *outer_shoulder > 0.0 && *outer_shoulder < *pitch)
    c.warning("shoulderDia1", "the outer shoulder is inside the pitch circle",
              "enter a diameter above pitchDia");
  else if (pitch && inner_shoulder && *inner_shoulder > *pitch)
    c.warning("shoulderDia2", "the inner shoulder is outside the pitch circle",
              "enter a diameter below pitchDia");
}

void check_roller_geometry(Checker& c) {
  const auto type = c.integer("kBrg");
  const auto diameter = c.si("bReDia");
  if (!type || *type < 2 || !diameter || *diameter <= 0.0) return;
  check_roller_profile(c, *diameter);
  if (*type == 4 || *type == 5) return check_cones(c, *diameter);
  const auto pitch = c.si("pitchDia");
  if (!pitch || *pitch <= 0.0) return;
  if (*pitch <= *diameter)
    c.error("pitchDia",
            fmt::format("the pitch diameter must be larger than the roller diameter of {}",
                        c.length(*diameter)),
            "check pitchDia and bReDia");
  else
    check_pitch_circle(c, *pitch, *diameter);
}

}  // namespace adore::deck
