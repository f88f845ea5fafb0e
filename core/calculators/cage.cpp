#include "calculators/cage.hpp"

#include "base/symmetric_eigen.hpp"
#include "calculators/json_access.hpp"
#include "contact/ball_pocket.hpp"
#include "contact/cage_inertia.hpp"
#include "contact/conformal.hpp"
#include "contact/guide_land.hpp"
#include "contact/roller_pocket.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace adore::calculators {
namespace {

using bearing::PocketShape;

std::optional<PocketShape> pocket_shape(const Json& inputs) {
  return bearing::parse_pocket_shape(inputs.at("shape").get<std::string>());
}

// ---- cage_pockets

Json pocket_frame_case(const Json& in) {
  const int n = whole(in, "nRe", 1, kMostElements);
  const double dm = get(in, "pitch_diameter");
  contact::PocketPlacement placement;
  placement.azimuth = get(in, "azimuth_pocket_1_deg") * kDegree +
                      2 * kPi * (whole(in, "pocket", 1, kMostElements) - 1) / n +
                      in.value("bPocCenVar2_deg", 0.0) * kDegree;
  placement.pitch_radius = 0.5 * dm;
  placement.axial_variation = in.value("bPocCenVar1", 0.0);
  placement.cone_angle = in.value("cageConeAng_deg", 0.0) * kDegree;
  placement.tilt = vec3_or_zero(in, "bPocAngVar_deg") * kDegree;
  const contact::PocketFrame frame = contact::pocket_frame(placement);
  const auto height = contact::pocket_wall_limits(get(in, "cageDia1"), get(in, "cageDia2"), dm,
                                                  in.value("bPocThknsVar", 0.0));
  const Vec3 q = frame.cage_to_pocket * (vec3(in.at("element_centre_cage")) - frame.centre);
  return {{"pocket_centre_cage", json(frame.centre)},
          {"cage_to_pocket_matrix", json(frame.cage_to_pocket)},
          {"element_centre_pocket", json(q)},
          {"wall_z_low", height[0]},
          {"wall_z_high", height[1]}};
}

/// A pocket wall has a height, and only a cone turns over with the sign of its clearance.
void check_pocket(const Json& in, bool conical) {
  require(
      get(in, "wall_z_low") < get(in, "wall_z_high"),
      fmt::format("wall_z_low = {} m must be below wall_z_high = {} m. Exchange the two values.",
                  get(in, "wall_z_low"), get(in, "wall_z_high")));
  require(conical || get(in, "bPocCls1") >= 0.0,
          fmt::format("bPocCls1 (pocket clearance) = {} m: only a conical pocket may have a "
                      "negative clearance. Enter 0 or more.",
                      get(in, "bPocCls1")));
}

std::optional<Json> ball_pocket_case(const Json& in) {
  const auto shape = pocket_shape(in);
  if (!shape) return std::nullopt;
  check_pocket(in, *shape == PocketShape::Conical);
  const double sigma = get(in, "rotation_sign");
  const contact::BallPocket pocket{*shape,
                                   get(in, "ball_diameter"),
                                   get(in, "bPocCls1") + in.value("bPocClsVar1", 0.0),
                                   get(in, "bPocCls2") + in.value("bPocClsVar2", 0.0),
                                   get(in, "wall_z_low"),
                                   get(in, "wall_z_high")};
  const Vec3 q = vec3(in.at("element_centre_pocket"));
  const contact::WallPoints walls = contact::nearest_walls(pocket, q, sigma);
  Json result;
  for (int i = 0; i < walls.count; ++i) {
    const contact::WallPoint& wall = walls.surface[static_cast<std::size_t>(i)];
    result["gap"].push_back(wall.gap);
    result["contact_point"].push_back(json(wall.w));
    result["inward_normal"].push_back(json(Vec3(-wall.m)));
    result["theta_deg"].push_back(contact::pocket_theta(wall.m, sigma) / kDegree);
    result["phi_deg"].push_back(contact::pocket_phi(wall.m) / kDegree);
  }
  result["wall_curvatures"] = contact::wall_curvatures(pocket, q);
  return result;
}

Json half_pocket_case(const Json& in) {
  check_pocket(in, false);
  const double r_b = 0.5 * get(in, "ball_diameter");
  const contact::CylindricalPocket pocket{r_b + 0.5 * get(in, "bPocCls1"), get(in, "wall_z_low"),
                                          get(in, "wall_z_high")};
  const double y_cut =
      get(in, "pocket_centre_radius") * std::tan(0.5 * get(in, "cageAngCut_deg") * kDegree);
  const contact::WallPoint wall = contact::nearest_half_pocket_wall(
      pocket, vec3(in.at("element_centre_pocket")), r_b, whole(in, "half_side", -1, 1), y_cut);
  return {
      {"gap", wall.gap}, {"contact_point", json(wall.w)}, {"inward_normal", json(Vec3(-wall.m))}};
}

Json pocket_law_case(const Json& in) {
  bearing::Material ball, cage;
  ball.elastic_modulus = get(in, "E_element");
  ball.poisson_ratio = get(in, "nu_element");
  cage.elastic_modulus = get(in, "E_cage");
  cage.poisson_ratio = get(in, "nu_cage");
  const auto curvature = in.at("wall_curvatures").get<std::array<double, 2>>();
  const contact::PocketLaw pocket = contact::ball_pocket_law(ball, cage, get(in, "ball_diameter"),
                                                             curvature, get(in, "cap_ratio"));
  Json force = Json::array(), slope = Json::array();
  for (const Json& gap : in.at("gaps")) {
    force.push_back(contact::load(pocket.law, -gap.get<double>()));
    slope.push_back(contact::slope(pocket.law, -gap.get<double>()));
  }
  return {{"effective_modulus", pocket.E_star},
          {"ellipticity", pocket.hertz.kappa},
          {"hertz_constant", pocket.law.K},
          {"cap_penetration", pocket.law.delta_cap},
          {"force", force},
          {"stiffness", slope}};
}

/// A roller of the reference cases: slices of its whole length, outside the flat the arc that cuts
/// it.
struct PocketRoller {
  Vec3 q, u;
  std::vector<contact::RollerSlice> slices;
  double half_slice = 0.0;
};
PocketRoller pocket_roller(const Json& in) {
  PocketRoller out;
  out.q = vec3(in.at("element_centre_pocket"));
  out.u = passive_matrix(vec3(in.at("roller_angles_deg")) * kDegree).row(0);
  const int count = whole(in, "slices", 1, 1000);
  const double length = get(in, "roller_length"), radius = 0.5 * get(in, "roller_diameter");
  const double crown = in.value("crown_radius", 0.0), flat = in.value("flat_length", 0.0);
  out.half_slice = 0.5 * length / count;
  for (int k = 0; k < count; ++k) {
    const double s = ((k + 0.5) / count - 0.5) * length;
    const bool beyond = crown > 0.0 && std::abs(s) > 0.5 * flat;
    const double drop =
        beyond ? std::sqrt(crown * crown - 0.25 * flat * flat) - std::sqrt(crown * crown - s * s)
               : 0.0;
    out.slices.push_back({s, radius - drop});
  }
  return out;
}

std::vector<contact::PocketFace> pocket_faces(const Json& in) {
  if (in.at("pocket").get<std::string>() == "rectangular") {
    check_pocket(in, false);
    return contact::window_faces(get(in, "roller_diameter") + get(in, "bPocCls1"),
                                 get(in, "wall_z_low"), get(in, "wall_z_high"),
                                 get(in, "rotation_sign"));
  }
  std::vector<bearing::RollerPocketFace> given;
  for (const Json& pair : in.at("surface_pairs"))
    given.push_back({vec3(pair.at("bPocGsAng_deg")) * kDegree, vec3(pair.at("bPocGsCen")),
                     get(pair, "bPocGsLen1"), get(pair, "bPocGsLen2")});
  return contact::paired_faces(given, get(in, "rotation_sign"));
}

Json roller_pocket_case(const Json& in) {
  const PocketRoller roller = pocket_roller(in);
  const double stiffness = get(in, "slice_stiffness"), exponent = get(in, "exponent");
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
  Json result;
  for (const contact::PocketFace& face : pocket_faces(in)) {
    Json gaps = Json::array(), fractions = Json::array();
    double load = 0.0, at = 0.0, least = std::numeric_limits<double>::infinity(), nearest = 0.0;
    for (const contact::RollerSlice& slice : roller.slices) {
      const contact::PocketSlice c = contact::slice_at_face(
          face, roller.q + slice.s * roller.u, roller.u, slice.radius, roller.half_slice);
      gaps.push_back(c.gap);
      fractions.push_back(c.fraction);
      if (c.fraction > 0.0 && c.gap < least) {
        least = c.gap;
        nearest = c.position;
      }
      const double Q = c.fraction * stiffness * std::pow(std::max(-c.gap, 0.0), exponent);
      load += Q;
      at += Q * c.position;
      force -= Q * c.m;
      moment -= (c.point - roller.q).cross(Vec3(Q * c.m));
    }
    result["slice_gap"].push_back(gaps);
    result["slice_fraction"].push_back(fractions);
    result["surface_min_gap"].push_back(least);
    result["surface_force"].push_back(load);
    result["axial_position"].push_back(load > 0.0 ? at / load : nearest);
  }
  result["force_on_roller_pocket_frame"] = json(force);
  result["moment_on_roller_pocket_frame"] = json(moment);
  return result;
}

Json round_roller_pocket_case(const Json& in) {
  check_pocket(in, false);
  const PocketRoller roller = pocket_roller(in);
  const contact::RoundPocket pocket{0.5 * (get(in, "roller_diameter") + get(in, "bPocCls1")),
                                    get(in, "wall_z_low"), get(in, "wall_z_high")};
  Json gaps = Json::array();
  double least = std::numeric_limits<double>::infinity(), angle = 0.0;
  for (const contact::RollerSlice& slice : roller.slices) {
    const contact::PocketSlice c = contact::slice_in_round_pocket(
        pocket, roller.q + slice.s * roller.u, roller.u, slice.radius);
    gaps.push_back(c.gap);
    if (c.gap >= least) continue;
    least = c.gap;
    angle = contact::round_pocket_angle(c.m, get(in, "rotation_sign"));
  }
  return {{"slice_gap", gaps}, {"min_gap", least}, {"contact_angle_deg", angle / kDegree}};
}

std::optional<Json> pocket_case(const Json& the_case) {
  const std::string kind = kind_of(the_case);
  const Json& in = the_case.at("inputs");
  if (kind == "pocket_frame") return pocket_frame_case(in);
  if (kind == "ball_pocket") return ball_pocket_case(in);
  if (kind == "roller_pocket") return roller_pocket_case(in);
  if (kind == "cylindrical_roller_pocket") return round_roller_pocket_case(in);
  if (kind == "half_ball_pocket") return half_pocket_case(in);
  if (kind == "pocket_contact_law") return pocket_law_case(in);
  return std::nullopt;
}

// ---- cage_lands

contact::LandProfile land_profile(double radius, int code, const Json& in, const char* variation) {
  contact::LandProfile profile;
  profile.radius = radius;
  if (code == 0) return profile;
  const Vec3 value = vec3(in.at(variation));
  profile.kind = code == 1 ? contact::LandProfile::Kind::Ellipse : contact::LandProfile::Kind::Wave;
  profile.variation_1 = value[0];
  profile.variation_2 = value[1];
  profile.phase = value[2] * kDegree;
  return profile;
}

contact::LandPair land_pair(const Json& in) {
  contact::LandPair land;
  land.outer = whole(in, "iCageGuide", 0, 2) == 1;
  land.width = get(in, "cageGsWidth");
  land.centre_x = contact::land_center_position(get(in, "cageGsPos"), land.width);
  land.slices = whole(in, "slices", 1, kMostSlices);
  const double cage_radius = 0.5 * get(in, "cageGsDia"), play = 0.5 * get(in, "cageGsCls");
  land.cage = land_profile(cage_radius, whole_or(in, "kCageGsImp", 0, 0, 2), in, "cageGsRadVar");
  land.race = land_profile(cage_radius + (land.outer ? play : -play),
                           whole_or(in, "kRaceGsImp", 0, 0, 2), in, "raceGsRadVar");
  return land;
}

Json land_gap_case(const Json& in) {
  const contact::LandPair land = land_pair(in);
  const Vec3 g = vec3(in.at("cage_centre"));
  const Mat3 T = passive_matrix(vec3(in.at("cage_angles_deg")) * kDegree);
  Json gaps = Json::array(), azimuths = Json::array();
  contact::LandGap least;
  for (int k = 0; k < land.slices; ++k) {
    const contact::LandGap slice =
        contact::min_land_gap(land, contact::slice_position(land, k), g, T);
    gaps.push_back(slice.gap);
    azimuths.push_back(slice.azimuth / kDegree);
    if (k == 0 || slice.gap < least.gap) least = slice;
  }
  return {{"land_centre_x", land.centre_x},
          {"cage_radius", land.cage.radius},
          {"race_radius", land.race.radius},
          {"slice_min_gap", gaps},
          {"slice_azimuth_deg", azimuths},
          {"min_gap", least.gap},
          {"contact_angle_deg", least.azimuth / kDegree},
          {"contact_point_race_frame", json(least.point)}};
}

Json land_profile_case(const Json& in) {
  const contact::LandProfile profile =
      land_profile(get(in, "nominal_radius"), whole(in, "code", 0, 2), in, "radVar");
  Json radius = Json::array(), slope = Json::array();
  for (const Json& azimuth : in.at("azimuths_deg")) {
    const auto [R, dR] = profile.at(azimuth.get<double>() * kDegree);
    radius.push_back(R - profile.radius);
    slope.push_back(dR);
  }
  return {{"radius_minus_nominal", radius}, {"slope", slope}};
}

Json land_law_case(const Json& in) {
  const contact::LandLaw law{get(in, "effective_modulus"), 0.5 * get(in, "cageGsCls")};
  const double width = get(in, "cageGsWidth");
  Json force = Json::array(), slope = Json::array(), energy = Json::array();
  for (const Json& value : in.at("eccentricities")) {
    const double e = value.get<double>();
    force.push_back(width * contact::land_load_per_length(law, e));
    slope.push_back(width * contact::land_stiffness_per_length(law, e));
    energy.push_back(width * contact::land_energy_per_length(law, e));
  }
  return {{"force", force}, {"stiffness", slope}, {"energy", energy}};
}

Json land_load_case(const Json& in) {
  const Mat3 T = passive_matrix(vec3(in.at("cage_angles_deg")) * kDegree);
  const contact::LandLoad load = contact::land_load(land_pair(in), get(in, "effective_modulus"),
                                                    vec3(in.at("cage_centre")), T);
  return {{"force_on_cage", json(load.force)},
          {"moment_on_cage", json(load.moment)},
          {"potential_energy", load.energy}};
}

Json land_friction_case(const Json& in) {
  const contact::LandPair land = land_pair(in);
  const Vec3 cage = vec3(in.at("cage_centre")), race = vec3(in.at("race_centre"));
  const contact::LandGap least =
      contact::min_land_gap(land, land.centre_x, cage - race, Mat3::Identity());
  const Vec3 point = race + least.point;
  const double side =
      land.outer ? -1.0 : 1.0;  // the land pushes the cage inward, or outward off an inner race
  const Vec3 normal = side * radial_direction(azimuth(least.point));
  Vec3 slip = vec3(in.at("race_velocity")) + vec3(in.at("race_omega")).cross(point - race) -
              vec3(in.at("cage_velocity")) - vec3(in.at("cage_omega")).cross(point - cage);
  slip -= slip.dot(normal) * normal;
  const double N = get(in, "normal_force");
  const Vec3 friction = get(in, "kappa") * N * slip.normalized(), force = N * normal + friction;
  return {{"min_gap", least.gap},
          {"contact_point", json(point)},
          {"slip", json(slip)},
          {"normal_on_cage", json(normal)},
          {"friction_on_cage", json(friction)},
          {"force_on_cage", json(force)},
          {"moment_on_cage", json(Vec3((point - cage).cross(force)))},
          {"moment_on_race", json(Vec3((point - race).cross(-force)))},
          {"heat", friction.dot(slip)}};
}

std::optional<Json> land_case(const Json& the_case) {
  const std::string kind = kind_of(the_case);
  const Json& in = the_case.at("inputs");
  if (kind == "land_gap") return land_gap_case(in);
  if (kind == "land_profile") return land_profile_case(in);
  if (kind == "land_law_circular") return land_law_case(in);
  if (kind == "land_load") return land_load_case(in);
  if (kind == "land_friction") return land_friction_case(in);
  return std::nullopt;
}

// ---- cage_inertia

std::optional<Json> inertia_case(const Json& the_case) {
  const std::string kind = kind_of(the_case);
  const Json& in = the_case.at("inputs");
  const auto shape = pocket_shape(in);
  if (!shape || (kind != "cage_inertia" && kind != "segment_inertia")) return std::nullopt;
  contact::CageSolid solid;
  solid.pocket = *shape;
  solid.outer_diameter = get(in, "cageDia1");
  solid.inner_diameter = get(in, "cageDia2");
  solid.width = get(in, "cageWidth");
  solid.pockets = whole(in, "nRe", 1, kMostElements);
  solid.element_diameter = get(in, "element_diameter");
  solid.pitch_diameter = get(in, "pitch_diameter");
  require(*shape == PocketShape::Conical || get(in, "bPocCls1") >= 0.0,
          "bPocCls1 (pocket clearance) is below 0: only a conical pocket may have a negative "
          "clearance. Enter 0 or more.");
  solid.clearance_1 = get(in, "bPocCls1");
  solid.clearance_2 = get(in, "bPocCls2");
  solid.roller_length = in.value("roller_length", 0.0);
  solid.density = get(in, "density");
  solid.cone_angle = in.value("cageConeAng_deg", 0.0) * kDegree;
  solid.segments = whole_or(in, "nCseg", 1, 0, 1000);
  solid.cut_angle = in.value("cageAngCut_deg", 0.0) * kDegree;
  solid.cut_at_pocket = in.value("cut", "") == "pocket";
  const contact::SolidInertia result = contact::cage_solid_inertia(solid);
  const Vec3 principal = symmetric_eigen<3>(result.inertia).values;
  return Json{{"volume", result.volume},
              {"mass", result.mass},
              {"mass_centre", json(result.mass_centre)},
              {"inertia_about_mass_centre", json(result.inertia)},
              {"principal_moments_sorted", json(principal)}};
}

}  // namespace

std::vector<Adapter> cage_adapters() {
  return {{"cage_pockets", pocket_case}, {"cage_lands", land_case}, {"cage_inertia", inertia_case}};
}

}  // namespace adore::calculators
