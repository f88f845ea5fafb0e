#include "base/errors.hpp"
#include "calculators/roller_json.hpp"
#include "calculators/rollers.hpp"
#include "contact/roller_flange.hpp"
#include "contact/roller_inertia.hpp"
#include "contact/slice_traction.hpp"
#include "contact/tapered_geometry.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace adore::calculators {
namespace {

using namespace contact;

Json json(const Meridian& m) { return Json::array({m[0], m[1]}); }

double end_radius(const Json& j, const char* key) {
  return j.contains(key) && j[key].is_number() ? j[key].get<double>() : 0.0;
}

const char* mode_name(FlangeContact::Mode mode) {
  switch (mode) {
    case FlangeContact::Mode::Face:
      return "face";
    case FlangeContact::Mode::Lip:
      return "lip";
    case FlangeContact::Mode::Corner:
      return "corner";
    case FlangeContact::Mode::None:
      break;
  }
  return "none";
}

// ---- rollers_flange

/// The roller of a flange case: one end radius and one corner radius, given for the end in
/// question.
RollerProfile flange_roller(const Json& in) {
  RollerProfile p = roller_profile(in);
  p.corner_radius = {get(in, "corner_radius"), get(in, "corner_radius")};
  p.end_radius = {end_radius(in, "end_radius"), end_radius(in, "end_radius")};
  return p;
}

Flange flange_of(const Json& j) {
  Flange f;
  f.side = race_from_json(j);
  f.at = j.at("at") == "-x" ? -1 : 1;
  f.layback = get(j, "layback");
  f.height = get(j, "height");
  f.race_half_angle = get(j, "race_half_angle");
  f.root_x = j.at("root").at(0).get<double>();
  f.root_r = j.at("root").at(1).get<double>();
  require(
      f.root_r > 0.0,
      fmt::format("root = [x, r]: r = {} m must be above 0. Enter the radius of the flange root.",
                  f.root_r));
  return f;
}

double modulus(const Json& in) {
  bearing::Material both;
  both.elastic_modulus = get(in.at("material"), "E");
  both.poisson_ratio = get(in["material"], "nu");
  return bearing::contact_modulus(both, both);
}

struct EndAtFlange {
  FlangeFace face;
  RollerEnd end;
  RollerAxisPose place;
  FlangeContact contact;
};

EndAtFlange end_at_flange(const Json& in) {
  EndAtFlange e;
  e.face = flange_face(flange_of(in.at("flange")));
  e.end = roller_end(flange_roller(in), whole(in, "end", 1, 2) - 1);
  e.place = read_roller_axis_pose(in.at("pose"));
  e.contact = flange_contact(e.face, e.end, e.place.centre, e.place.axis);
  return e;
}

Json contact_json(const FlangeContact& c) {
  return {{"gap", std::isfinite(c.gap) ? Json(c.gap) : Json(nullptr)},
          {"mode", mode_name(c.mode)},
          {"contact_point", calculators::json(c.point)},
          {"normal", calculators::json(c.normal)},
          {"height_along_face", c.height},
          {"contact_radius_from_roller_axis", c.from_axis}};
}

Json end_case(const Json& in) {
  const EndAtFlange e = end_at_flange(in);
  Json out = contact_json(e.contact);
  if (in.contains("material")) {
    const FlangeLoad load = flange_load(e.end, e.place.axis, e.contact, modulus(in));
    out["curvature_circumferential"] = load.curvature.across;
    out["curvature_along_face"] = load.curvature.along;
    out["K_hertz"] = load.hertz.K;
    out["load"] = load.load;
  }
  if (e.end.flat()) return out;
  out["cap_radius"] = e.end.cap_radius;
  out["on_cap"] = e.contact.on_cap;
  out["extended_sphere_gap"] = e.contact.sphere_gap;
  return out;
}

Json corner_case(const Json& in) {
  const RollerEnd e = roller_end(flange_roller(in), whole(in, "end", 1, 2) - 1);
  return {{"tube_centre_s", e.sign * e.ring},
          {"ring_radius", e.ring_radius},
          {"cap_radius", e.cap_radius}};
}

Json play_case(const Json& in) {
  const RollerProfile p = flange_roller(in);
  const RollerAxisPose place = read_roller_axis_pose(in.at("pose"));
  const int side = race_from_json(in);
  const double R = get(in, "race_radius");
  const double seated = side == bearing::kInner ? R + 0.5 * p.diameter : R - 0.5 * p.diameter;
  Json out;
  for (int k = 0; k < 2; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const RollerEnd end = roller_end(p, k);
    Flange flange;
    flange.side = side;
    flange.at = end.sign;
    flange.layback = in.at("layback").at(i).get<double>();
    flange.height = in.at("height").at(i).get<double>();
    flange = placed_flange(flange, end, Vec3(0.0, 0.0, seated), Vec3::UnitX(),
                           {end.sign * end.vertex, R}, 0.5 * get(in, "play"));
    const FlangeContact c = flange_contact(flange_face(flange), end, place.centre, place.axis);
    out["root_x"].push_back(flange.root_x);
    out["gap"].push_back(c.gap);
    out["mode"].push_back(mode_name(c.mode));
  }
  return out;
}

Json flange_load_case(const Json& in) {
  const EndAtFlange e = end_at_flange(in);
  const FlangeLoad load = flange_load(e.end, e.place.axis, e.contact, modulus(in));
  const RigidMotion race = {Vec3::Zero(), Vec3::Zero(), get(in, "race_speed") * Vec3::UnitX()};
  const RigidMotion roller = {e.place.centre, vec3(in.at("roller_velocity")),
                              vec3(in.at("roller_omega"))};
  const Vec3 slip = contact_slip(race, roller, e.contact.point, e.contact.normal);
  const double kappa = get(in, "kappa");
  ContactWrench sum;
  add_contact(sum, load.load, e.contact.point, -e.contact.normal, slip, e.place.centre,
              [&](double u2) { return u2 > 0.0 ? kappa / std::sqrt(u2) : 0.0; });
  return {{"gap", e.contact.gap},
          {"K_hertz", load.hertz.K},
          {"load", load.load},
          {"slip", calculators::json(slip)},
          {"slip_speed", slip.norm()},
          {"force", calculators::json(sum.force)},
          {"moment", calculators::json(sum.moment)},
          {"driving_moment", roller_moments(sum.moment, e.place.axis).driving},
          {"heat", sum.heat}};
}

std::optional<Json> flange_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  const std::string kind = kind_of(the_case);
  if (kind == "sphere_end" || kind == "flat_end") return end_case(in);
  if (kind == "corner_geometry") return corner_case(in);
  if (kind == "end_play") return play_case(in);
  if (kind == "flange_load") return flange_load_case(in);
  return std::nullopt;
}

// ---- rollers_inertia: every kind has the same inputs

std::optional<Json> inertia_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  if (!in.contains("roller")) return std::nullopt;
  RollerProfile p = roller_profile(in["roller"]);
  p.end_radius = {end_radius(in, "end_radius_1"), end_radius(in, "end_radius_2")};
  const RollerInertia i = roller_inertia(p, get(in, "density"), in.value("corners", true));
  return Json{{"mass", i.mass},
              {"centre_of_mass_s", i.mass_centre},
              {"I_axial", i.axial},
              {"I_transverse", i.transverse}};
}

// ---- rollers_tapered

TaperedGeometry geometry_of(const Json& in) {
  return tapered_geometry(get(in, "dia"),
                          {get(in, "outer_half_angle"), get(in, "inner_half_angle")});
}

Json geometry_case(const Json& in) {
  const TaperedGeometry g = geometry_of(in);
  const EndDiameters ends = end_diameters(g, get(in, "dia"), get(in, "length"));
  const int most = max_roller_count(g);
  return {{"pitch_diameter", g.pitch_diameter},
          {"half_angle", g.half_angle},
          {"axis_angle", g.axis_angle},
          {"apex_distance", g.apex_distance},
          {"apex_x", g.apex_x},
          {"outer_contact", json(g.contact[0])},
          {"inner_contact", json(g.contact[1])},
          {"outer_cone_radius_at_x0", g.cone_radius_at_x0[0]},
          {"inner_cone_radius_at_x0", g.cone_radius_at_x0[1]},
          {"large_end_diameter", ends.large},
          {"small_end_diameter", ends.small},
          {"neighbours_clear", whole(in, "n_rollers", 0, kMostElements) <= most},
          {"max_rollers", most}};
}

/// Flat-ended uncrowned cone rolling at the given race speeds.
struct RollingCone {
  TaperedGeometry geometry;
  RollingSpeeds speeds;
  RollerInertia inertia;
  double centre_radius = 0.0;  ///< of the mass center
};

RollingCone rolling_cone(const Json& in) {
  RollingCone cone;
  cone.geometry = geometry_of(in);
  RollerProfile p;
  p.diameter = get(in, "dia");
  p.length = get(in, "length");
  p.half_angle = cone.geometry.half_angle;
  cone.inertia = roller_inertia(p, get(in, "density"));
  cone.speeds = rolling_speeds({cone.geometry.contact[0][1], cone.geometry.contact[1][1]},
                               p.diameter, cone.geometry.axis_angle,
                               {in.value("outer_speed", 0.0), get(in, "inner_speed")});
  cone.centre_radius = 0.5 * cone.geometry.pitch_diameter -
                       cone.inertia.mass_centre * std::sin(cone.geometry.axis_angle);
  return cone;
}

Json speeds_case(const Json& in) {
  const RollingCone cone = rolling_cone(in);
  return {{"orbital_speed", cone.speeds.orbital},
          {"spin_relative_to_orbit", cone.speeds.spin},
          {"omega", calculators::json(cone.speeds.omega)},
          {"gyroscopic_moment",
           calculators::json(gyroscopic_moment(cone.speeds, cone.geometry.axis_angle,
                                               cone.inertia.axial, cone.inertia.transverse))},
          {"mass", cone.inertia.mass},
          {"I_axial", cone.inertia.axial},
          {"I_transverse", cone.inertia.transverse}};
}

Json rib_case(const Json& in) {
  const RollingCone cone = rolling_cone(in);
  const TaperedGeometry& g = cone.geometry;
  RollerProfile p;
  p.diameter = get(in, "dia");
  p.length = get(in, "length");
  p.half_angle = g.half_angle;
  p.end_radius[0] = get(in, "end_radius");
  const RollerEnd end = roller_end(p, 0);
  const Vec3 C(0.0, 0.0, 0.5 * g.pitch_diameter);
  const Vec3 a(std::cos(g.axis_angle), 0.0, -std::sin(g.axis_angle));
  Flange rib;
  rib.layback = get(in, "layback");
  rib.height = get(in, "flange_height");
  rib.race_half_angle = g.race_angle[1];
  rib = placed_flange(rib, end, C, a, g.contact[1], 0.0);
  const FlangeContact c = flange_contact(flange_face(rib), end, C, a);
  const double orbit = cone.speeds.orbital;
  const double F_c = cone.inertia.mass * cone.centre_radius * orbit * orbit;
  const RibLoads q = rib_loads(get(in, "thrust") / get(in, "n_rollers"), g.race_angle,
                               g.race_angle[1] - rib.layback, F_c);
  // Moment about y of the resultant of each race, were it to act at mid length.
  const auto race_moment = [&](std::size_t race, double Q) {
    const double sigma = race == 0 ? 1.0 : -1.0, angle = g.race_angle[race];
    const Vec3 at(g.contact[race][0], 0.0, g.contact[race][1]);
    const Vec3 force = -Q * sigma * Vec3(std::sin(angle), 0.0, std::cos(angle));
    return (at - C).cross(force)[1];
  };
  return {{"Q_outer", q.outer},
          {"Q_inner", q.inner},
          {"Q_rib", q.rib},
          {"centrifugal_force", F_c},
          {"rib_root", {rib.root_x, rib.root_r}},
          {"rib_contact", {c.point[0], std::hypot(c.point[1], c.point[2])}},
          {"rib_contact_height", c.height},
          {"on_face", c.mode == FlangeContact::Mode::Face},
          {"rib_moment_y", (c.point - C).cross(q.rib * c.normal)[1]},
          {"race_moment_y_mid", {race_moment(0, q.outer), race_moment(1, q.inner)}}};
}

Json groove_json(const RaceSurface& race) {
  return Json::array({race.groove_x, race.groove_centre_radius, race.groove_radius});
}

std::optional<Json> tapered_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  const std::string kind = kind_of(the_case);
  if (kind == "tapered_geometry" || kind == "tapered_limit") return geometry_case(in);
  if (kind == "tapered_speeds") return speeds_case(in);
  if (kind == "rib_static") return rib_case(in);
  const auto factors = [&] {
    return std::array<double, 2>{get(in, "curvature_factor_outer"),
                                 get(in, "curvature_factor_inner")};
  };
  if (kind == "grooved_tapered") {
    const TaperedGeometry g = geometry_of(in);
    const auto races = grooved_tapered_races(g, get(in, "crown_radius"), factors());
    return Json{{"pitch_diameter", g.pitch_diameter},
                {"outer_groove", groove_json(races[0])},
                {"inner_groove", groove_json(races[1])}};
  }
  if (kind == "grooved_spherical") {
    const SphericalRow row =
        spherical_row(get(in, "dia"), get(in, "pitch_diameter"), get(in, "contact_angle"),
                      get(in, "crown_radius"), factors(), get(in, "play"));
    return Json{{"normal_gap_each", row.normal_gap},
                {"outer_groove", groove_json(row.race[0])},
                {"inner_groove", groove_json(row.race[1])}};
  }
  return std::nullopt;
}

// ---- D_roller_bearing, the frictionless tapered roller

std::optional<Json> tapered_thrust_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  if (!in.contains("cup_half_angle_deg")) return std::nullopt;
  const double Z = get(in, "Z");
  const double cup = get(in, "cup_half_angle_deg") * kDegree;
  const double cone = get(in, "cone_half_angle_deg") * kDegree;
  const double rib = get(in, "flange_angle_deg") * kDegree;
  const RibLoads q =
      rib_loads(get(in, "thrust") / Z, {cup, cone}, rib, get(in, "centrifugal_force"));
  return Json{{"Q_cup", q.outer},
              {"Q_cone", q.inner},
              {"Q_flange", q.rib},
              {"thrust_check_inner_ring", Z * (q.inner * std::sin(cone) + q.rib * std::cos(rib))}};
}

}  // namespace

std::vector<Adapter> roller_part_adapters() {
  return {{"rollers_flange", flange_case},
          {"rollers_inertia", inertia_case},
          {"rollers_tapered", tapered_case},
          {"D_roller_bearing", tapered_thrust_case}};
}

}  // namespace adore::calculators
