#include "calculators/ratings.hpp"

#include "base/errors.hpp"
#include "bearing/rating_data.hpp"
#include "calculators/json_access.hpp"
#include "life/iso281.hpp"
#include "life/minimum_load.hpp"
#include "life/oscillation.hpp"
#include "life/reference_speed.hpp"
#include "life/static_safety.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace adore::calculators {
namespace {

// ---- rating_static

life::StaticBearingType static_type(const std::string& name) {
  if (name == "deep_groove") return life::StaticBearingType::DeepGroove;
  if (name == "angular_contact") return life::StaticBearingType::AngularContact;
  if (name == "cylindrical_roller") return life::StaticBearingType::Cylindrical;
  if (name == "thrust") return life::StaticBearingType::Thrust;
  return life::StaticBearingType::SelfAligning;
}

Json thrust_rating(const Json& in) {
  life::IsoGeometry g;
  g.type = in.contains("Lwe") ? life::IsoType::ThrustRoller : life::IsoType::ThrustBall;
  g.element_diameter = get(in, "Dw");
  g.length = in.value("Lwe", 0.0);
  g.pitch_diameter = get(in, "Dpw");
  g.count = whole(in, "Z", 1, kMostElements);
  require_elements_fit(g.count, g.element_diameter, g.pitch_diameter);
  g.contact_angle = in.value("alpha_deg", 90.0) * kDegree;
  constexpr double kGroove = 0.54;
  g.conformity_inner = g.conformity_outer = in.value("f", kGroove);
  return {{"C0", life::iso_thrust_static_rating(g)}, {"provenance", "recalled"}};
}

std::optional<Json> static_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  if (in.contains("Dw")) return thrust_rating(in);
  const std::string type = in.at("type");
  require(in.contains("alpha_deg") || type == "deep_groove" || type == "cylindrical_roller",
          "alpha_deg is missing: P0 of this bearing type depends on the contact angle. Enter "
          "alpha_deg.");
  life::StaticLoadFactors factors = life::static_factors(
      static_type(type), in.value("alpha_deg", 0.0) * kDegree, whole_or(in, "rows", 1, 1, 2));
  if (in.contains("X0") || in.contains("Y0")) factors.provenance = "given";
  factors.X0 = in.value("X0", factors.X0);
  factors.Y0 = in.value("Y0", factors.Y0);
  const double P0 = life::equivalent_static_load(factors, get(in, "Fr"), get(in, "Fa"));
  require(P0 > 0.0, "Fr and Fa are both 0. Enter a radial or an axial load.");
  return Json{{"P0", P0},
              {"s0", get(in, "C0") / P0},
              {"X0", factors.X0},
              {"Y0", factors.Y0},
              {"provenance", factors.provenance}};
}

// ---- rating_reference_speed

std::optional<Json> reference_speed_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  life::ReferenceBearing b;
  b.bore = 1e-3 * get(in, "d");
  b.outside = 1e-3 * get(in, "D");
  b.width = 1e-3 * in.value("B", 0.0);
  b.static_rating = get(in, "C0");
  b.thrust_roller = in.value("type", std::string("radial")) == "thrust_roller";
  require(
      b.thrust_roller || in.contains("B"),
      "B (bearing width) is missing: the seat area of a radial bearing depends on it. Enter B.");
  std::string origin = "given";
  if (in.contains("series")) {
    b.friction = life::reference_friction_factors(in.at("series").get<std::string>());
    origin = bearing::rating_data("friction_factors").at("source");
  } else {
    b.friction = {get(in, "f0r"), get(in, "f1r")};
  }
  const life::ReferenceSpeed r = life::reference_speed(b);
  return Json{{"n_ref", r.speed},    {"f0r", b.friction.f0r},    {"f1r", b.friction.f1r},
              {"P1", r.load},        {"A_r", 1e6 * r.seat_area}, {"q_r", 1e-6 * r.heat_flow},
              {"heat", r.heat},      {"M0", 1e3 * r.oil_torque}, {"M1", 1e3 * r.load_torque},
              {"provenance", origin}};
}

// ---- rating_oscillation

std::optional<Json> oscillation_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  life::OscillationInput input;
  input.ball = in.at("elements") == "ball";
  input.count = whole(in, "Z", 2, kMostElements);
  input.gamma = get(in, "gamma");
  input.swing = get(in, "swing_deg") * kDegree;
  const life::Oscillation o = life::oscillation(input);
  Json out{{"critical_outer_deg", o.critical_outer / kDegree},
           {"critical_inner_deg", o.critical_inner / kDegree},
           {"oscillations_per_revolution", o.cycles_per_revolution},
           {"below_critical", o.below_critical},
           {"false_brinelling", o.false_brinelling},
           {"provenance", o.below_critical ? "derived from Lundberg-Palmgren" : "seen"}};
  double L10 = 0.0;
  if (in.contains("L10")) {
    L10 = get(in, "L10");
  } else {
    const double p = input.ball ? 3.0 : 10.0 / 3.0;
    L10 = std::pow(get(in, "C") / get(in, "P"), p);
  }
  out["L_oscillations"] = L10 * o.cycles_per_revolution;
  if (in.contains("frequency")) {
    out["L_hours"] = 1e6 * L10 * o.cycles_per_revolution / (60.0 * get(in, "frequency"));
    out["n_equivalent"] = get(in, "frequency") / o.cycles_per_revolution;
  }
  return out;
}

// ---- rating_minimum_load

double mean_diameter(const Json& in) {
  require(get(in, "D") > get(in, "d"),
          "D (outside diameter) must be larger than d (bore). Enter the outside diameter of the "
          "bearing.");
  return 0.5 * (get(in, "d") + get(in, "D"));
}

double speed_ratio(const Json& in) {
  const double ratio = get(in, "n") / get(in, "n_ref");
  constexpr double kLargest = 2.0;
  require(ratio <= kLargest,
          fmt::format("n (speed) is {:.3g} times the reference speed. The formulas for the minimum "
                      "load are valid up to 2 times the reference speed.",
                      ratio));
  return ratio;
}

std::optional<Json> minimum_load_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  const std::string rule = in.at("rule");
  double least = 0.0;
  if (rule == "ball_share") {
    least = 0.01 * get(in, "C");
  } else if (rule == "roller_share") {
    least = 0.02 * get(in, "C");
  } else if (rule == "deep_groove" || rule == "self_aligning") {
    least =
        life::minimum_load_of_balls(get(in, "kr"), get(in, "nu"), get(in, "n"), mean_diameter(in));
  } else if (rule == "cylindrical_roller") {
    least = life::minimum_load_of_rollers(get(in, "kr"), speed_ratio(in), mean_diameter(in));
  } else if (rule == "spherical_roller") {
    least = in.contains("n")
                ? life::minimum_load_of_spherical_rollers(get(in, "C0"), speed_ratio(in))
                : 0.01 * get(in, "C0");
  } else if (rule == "thrust_ball") {
    least = life::minimum_thrust(get(in, "A"), get(in, "n"), 0.0);
  } else {
    least = life::minimum_thrust(get(in, "A"), get(in, "n"), get(in, "C0"));
  }
  Json out{{"F_min", least}, {"provenance", bearing::rating_data("minimum_load").at("source")}};
  if (in.contains("F")) {
    out["sufficient"] = get(in, "F") >= least;
    out["F_over_F_min"] = get(in, "F") / least;
  }
  return out;
}

}  // namespace

std::vector<Adapter> rating_adapters() {
  return {{"rating_static", static_case},
          {"rating_reference_speed", reference_speed_case},
          {"rating_oscillation", oscillation_case},
          {"rating_minimum_load", minimum_load_case}};
}

}  // namespace adore::calculators
