#include "deck/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

/// Records 4 and 5: sizes that cannot go together. Lengths are compared in metres.
namespace adore::deck {
namespace {

constexpr double kRounding =
    1e-9;  // relative; the deck's own rounding must not turn equal into unequal

bool above(double a, double b) { return a > b * (1.0 + kRounding) + 1e-15; }

/// Chord between neighbouring element centres on a circle.
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
  c.error(
      "nRe",
      fmt::format("{} elements do not fit on the pitch circle: their centres are {} apart, "
                  "less than the diameter of "
                  "{}",
                  *count, c.length(pitch), c.length(element_diameter)),
      fmt::format("give at most {} elements", static_cast<long long>(fitting * (1.0 + kRounding))));
}

void check_pitch_circle(Checker& c, double pitch_diameter, double element_diameter) {
  const auto bore = c.si("brgBore");
  const auto outside = c.si("brgOD");
  if (bore && outside && *bore < *outside) {
    if (pitch_diameter <= *bore || pitch_diameter >= *outside)
      c.error("pitchDia",
              fmt::format("the pitch circle must lie between bore ({}) and outside diameter ({})",
                          c.length(*bore), c.length(*outside)),
              "check pitchDia, brgBore and brgOD");
    else if (pitch_diameter - element_diameter <= *bore ||
             pitch_diameter + element_diameter >= *outside)
      c.warning(
          "bReDia",
          "the elements reach through a race: no ring material is left at the bore or the outside",
          "check bReDia, pitchDia, brgBore and brgOD");
  }
  check_fit_on_circle(c, pitch_diameter, element_diameter);
}

void check_plausible_lengths(Checker& c) {
  for (const std::string_view name : {"brgBore", "brgOD", "bReDia", "pitchDia", "cageDia1"}) {
    const auto length = c.si(name);
    if (length && *length > 5.0)
      c.warning(name, fmt::format("{} is very large for a bearing", c.length(*length)),
                "lengths are in m (SI) or in (English), not mm");
  }
  for (const std::string_view name : {"rmsAspHt1", "rmsAspHt2"}) {
    const auto height = c.si(name);
    if (height && *height > 1e-4)
      c.warning(name, fmt::format("a roughness of {} is very large", c.length(*height)),
                "lengths are in m (SI) or in (English), not micrometres");
  }
}

void check_angle_and_clearance(Checker& c, double diameter) {
  const auto angle = c.si("freeConAng");
  const auto clearance = c.si("freeIntCls");
  const auto f1 = c.raw("raceCurFac1");
  const auto f2 = c.raw("raceCurFac2");
  if (!angle || !clearance || !f1 || !f2 || *f1 <= 0.5 || *f2 <= 0.5) return;
  const double room =
      2.0 * diameter * (*f1 + *f2 - 1.0);  // clearance at a contact angle of 90 degrees
  if (*angle == 0.0) {
    if (*clearance == 0.0)
      c.warning("freeIntCls",
                "both contact angle and clearance are zero: a line-to-line radial bearing",
                "give freeConAng or freeIntCls when that is not meant");
    if (*clearance > room)
      c.error(
          "freeIntCls",
          fmt::format("with this clearance a ball cannot touch both races: the grooves allow {}",
                      c.length(room)),
          "give a smaller clearance or larger groove factors");
    return;
  }
  const double implied = room * (1.0 - std::cos(*angle));
  if (*clearance != 0.0 && std::abs(*clearance - implied) > 0.05 * implied)
    c.warning("freeIntCls",
              fmt::format(
                  "is not used, because freeConAng is above 0; the angle implies a clearance of {}",
                  c.length(implied)),
              "set it to 0, or freeConAng to 0");
}

void check_shims(Checker& c, double diameter) {
  for (const int race : {1, 2}) {
    const auto factor = c.raw(fmt::format("raceCurFac{}", race));
    const std::string name = fmt::format("shimThickness{}", race);
    const auto shim = c.si(name);
    if (!factor || !shim || *factor <= 0.5) continue;
    const double widest = (2.0 * *factor - 1.0) * diameter;
    if (*shim >= widest && *shim > 0.0)
      c.error(name,
              fmt::format("a shim this thick leaves no arch: it must be below (2f - 1) D = {}",
                          c.length(widest)),
              "give a thinner shim, 0 for a race that is not split");
  }
}

struct Cone {
  double pitch_diameter = 0.0;
};

/// Both race cones share their apex; the element at half length rolls between them (notes N38).
bool find_cone(Checker& c, double diameter, Cone& cone) {
  const auto outer = c.si("raceTaper1");
  const auto inner = c.si("raceTaper2");
  if (!outer || !inner) return false;
  if (*outer <= *inner) {
    c.error("raceTaper1",
            "the outer cone must be wider than the inner one, or the roller has no taper",
            "give raceTaper1 above raceTaper2");
    return false;
  }
  const double mean = 0.5 * (*outer + *inner);
  const double half = 0.5 * (*outer - *inner);
  cone.pitch_diameter = diameter * std::sin(mean) / std::tan(half);
  return true;
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
        "give a length at most bReLen");
  if (corner1 && corner2 && *corner1 + *corner2 >= *length)
    c.error(
        "bReCorRad1",
        fmt::format("both corners together take the whole roller length of {}", c.length(*length)),
        "give smaller corner radii");
  for (const std::string_view name : {"bReCorRad1", "bReCorRad2"}) {
    const auto corner = c.si(name);
    if (corner && *corner > 0.5 * diameter)
      c.error(name, "a corner radius cannot exceed the roller radius",
              "give a smaller corner radius");
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
    c.error("shftID",
            fmt::format("the shaft would have no wall: its bore must be below {}", c.length(*bore)),
            "give a smaller shaft bore, 0 for a solid shaft");
  if (outside && housing && *housing == 0.0)
    c.warning("hsngOD",
              "the housing has no wall, so that an outer race fit has nothing to press against",
              "give the outside diameter of the housing");
  else if (outside && housing && above(*outside, *housing))
    c.error("hsngOD",
            fmt::format("the housing must be larger than the bearing, which measures {}",
                        c.length(*outside)),
            "check hsngOD and brgOD");
  for (const std::string_view code : {"11", "21", "12", "22"}) {
    const std::string height = fmt::format("flngHt{}", code);
    const auto value = c.si(height);
    if (c.is(fmt::format("kFlngInd{}", code), 1) && value && *value == 0.0)
      c.warning(height, "the flange has no height and cannot touch a roller",
                "give its height, or set the flange flag to 0");
  }
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
  check_shims(c, *diameter);
  const auto outer_shoulder = c.si("shoulderDia1");
  const auto inner_shoulder = c.si("shoulderDia2");
  if (outer_shoulder && inner_shoulder && *outer_shoulder > 0.0 &&
      *outer_shoulder <= *inner_shoulder)
    c.warning("shoulderDia1", "the outer shoulder is not larger than the inner one",
              "check shoulderDia1 and shoulderDia2");
  else if (pitch && outer_shoulder && *outer_shoulder > 0.0 && *outer_shoulder < *pitch)
    c.warning("shoulderDia1", "the outer shoulder stands higher than the centres of the balls",
              "give more than pitchDia");
  else if (pitch && inner_shoulder && *inner_shoulder > *pitch)
    c.warning("shoulderDia2", "the inner shoulder stands higher than the centres of the balls",
              "give less than pitchDia");
}

void check_roller_geometry(Checker& c) {
  const auto type = c.integer("kBrg");
  const auto diameter = c.si("bReDia");
  if (!type || *type < 2 || !diameter || *diameter <= 0.0) return;
  check_roller_profile(c, *diameter);
  Cone cone;
  if (*type == 4 || *type == 5) {
    if (find_cone(c, *diameter, cone)) check_fit_on_circle(c, cone.pitch_diameter, *diameter);
    return;
  }
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
