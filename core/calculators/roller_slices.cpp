#include "base/constants.hpp"
#include "calculators/roller_json.hpp"
#include "calculators/rollers.hpp"
#include "contact/line_contact.hpp"
#include "contact/race_errors.hpp"
#include "contact/slice_contact.hpp"
#include "contact/slice_traction.hpp"
#include "contact/sliced_line.hpp"
#include "tribology/traction_law.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace adore::calculators {
namespace {

using namespace contact;

bearing::Material elastic(double E, double nu) {
  bearing::Material m;
  m.elastic_modulus = E;
  m.poisson_ratio = nu;
  return m;
}

double radius_or_infinity(const Json& j) { return j.is_number() ? j.get<double>() : kInfinity; }

// ---- B_line_contact

Json line_case(const Json& in) {
  const Json &first = in.at("body1"), &second = in.at("body2");
  const bearing::Material one = elastic(get(first, "E"), get(first, "nu"));
  const bearing::Material two = elastic(get(second, "E"), get(second, "nu"));
  const double Q = get(in, "load"), L = get(in, "length"), q = Q / L;
  const double R1 = radius_or_infinity(first.at("R")), R2 = radius_or_infinity(second.at("R"));
  const double curvature = 1.0 / R1 + 1.0 / R2, E_star = bearing::contact_modulus(one, two);
  const LinePressure line = line_pressure(q, curvature, E_star);
  const SubsurfaceStress s = line_subsurface_stress(line, get(in, "stress_poisson"));
  Json out = {
      {"E_star", E_star},
      {"R", 1.0 / curvature},
      {"load_per_length", q},
      {"half_width", line.half_width},
      {"p_max", line.peak},
      {"p_mean", 0.25 * kPi * line.peak},
      {"tau_max_axis", s.max_shear},
      {"tau_max_axis_depth", s.max_shear_depth},
      {"tau_orthogonal_max", s.orthogonal_shear},
      {"tau_orthogonal_depth", s.orthogonal_depth},
      {"tau_orthogonal_offset", s.orthogonal_offset},
      {"tau_oct_max_axis", s.octahedral},
      {"tau_oct_max_axis_depth", s.octahedral_depth},
      {"delta_palmgren_steel", approach_palmgren_steel(Q, L)},
      {"delta_palmgren_general", approach_palmgren(Q, L, one, two)},
      {"delta_johnson_half_cylinder_body1", approach_half_cylinder(q, one, R1, line.half_width)}};
  const bool alike =
      one.elastic_modulus == two.elastic_modulus && one.poisson_ratio == two.poisson_ratio;
  if (std::isfinite(R2) && alike) {  // a flat race has no d_m, unlike bodies no common modulus
    const double D = 2.0 * R1, gamma = D / (2.0 * std::abs(R2) + std::copysign(D, R2));
    out["gamma_used"] = gamma;
    out["delta_lundberg_log"] =
        approach_lundberg(Q, L, one, gamma, R2 > 0.0 ? bearing::kInner : bearing::kOuter);
  }
  return out;
}

Json sliced_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  const double D = get(in, "roller_diameter"), L = get(in, "roller_length");
  const double tilt = get(in, "tilt");
  const bool logarithmic = in.at("profile") == "logarithmic";
  RollerProfile p;
  p.kind = RollerProfile::Kind::Arc;
  p.diameter = D;
  p.length = L;
  if (!logarithmic) p.crown_radius = radius_or_infinity(in.at("crown_radius"));
  const auto drop = [&](double x) {
    return logarithmic ? logarithmic_drop(x, L, 0.00035 * D) : profile_drop(p, x);
  };
  SlicedLine line = sliced_line(p, whole(in, "n_slices", 1, kMostSlices), get(in, "K_line"));
  for (std::size_t k = 0; k < line.x.size(); ++k) line.drop[k] = drop(line.x[k]);
  const bearing::Material both = elastic(get(in, "E"), get(in, "nu"));
  const double E_star = bearing::contact_modulus(both, both);
  const double curvature = 2.0 / D + 1.0 / get(in, "race_radius");
  Json out = {{"table", Json::array()}, {"inverse", Json::array()}};
  for (const Json& approach : in.at("approach_list")) {
    const double delta0 = approach.get<double>();
    const LineResultant sum = line_resultant(line, delta0, tilt);
    const ContinuumResultant limit = continuum_resultant(
        line.law, -0.5 * L, 0.5 * L, [&](double x) { return delta0 + tilt * x - drop(x); });
    const double q = sum.largest_load / line.width.front();
    out["table"].push_back({{"delta0", delta0},
                            {"Q", sum.load},
                            {"M", sum.moment},
                            {"loaded_slices", sum.loaded},
                            {"max_slice_load", sum.largest_load},
                            {"p_max_worst_slice", line_pressure(q, curvature, E_star).peak},
                            {"Q_continuum", limit.load},
                            {"M_continuum", limit.moment}});
  }
  // The loads whose approach is asked: a list of the inputs, or what the case expects answers for.
  std::vector<double> loads = in.value("load_list", std::vector<double>());
  if (the_case.contains("expected"))
    for (const Json& asked : the_case["expected"].value("inverse", Json::array()))
      loads.push_back(get(asked, "Q"));
  for (const double Q : loads) {
    const double delta0 = approach_for_load(line, tilt, Q);
    out["inverse"].push_back(
        {{"Q", Q}, {"delta0", delta0}, {"M", line_resultant(line, delta0, tilt).moment}});
  }
  return out;
}

std::optional<Json> line_contact_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  const std::string kind = kind_of(the_case);
  if (kind.starts_with("sliced_roller")) return sliced_case(the_case);
  if (kind.starts_with("line_contact")) return line_case(in);
  return std::nullopt;
}

// ---- rollers_slices

struct PlacedRace {
  RaceSurface surface;
  RacePose pose;
};

PlacedRace placed_race(const Json& j) {
  PlacedRace race;
  const int side = race_from_json(j);
  const std::string shape = j.at("shape").get<std::string>();
  if (shape == "cylinder")
    race.surface = cylinder_race(side, get(j, "radius"));
  else if (shape == "cone")
    race.surface = cone_race(side, get(j, "radius"), get(j, "half_angle"));
  else
    race.surface = groove_race(side, get(j, "groove_radius"), get(j, "groove_x"),
                               get(j, "groove_centre_radius"));
  race.pose.centre = vec3_or_zero(j, "centre");
  race.pose.axes = passive_rotation_y(j.value("rot_y", 0.0)).transpose() *
                   passive_rotation_z(j.value("rot_z", 0.0)).transpose();
  return race;
}

/// Contacts of the case, exact to rounding.
std::vector<SliceContact> contacts_of(const Json& in, const RollerProfile& p, const Slicing& cut) {
  const PlacedRace race = placed_race(in.at("race"));
  const RollerAxisPose place = read_roller_axis_pose(in.at("pose"));
  const auto slices = roller_slices(p, cut);
  std::vector<SliceContact> contacts(slices.size());
  roller_race_contacts(race.surface, race.pose, place.centre, place.axis, slices, contacts);
  return contacts;
}

Json penetration_case(const Json& in) {
  const RollerProfile p = roller_profile(in.at("roller"));
  const Slicing cut = slicing(p, whole(in, "n_slices", 1, kMostSlices));
  Json out;
  int k = 0;
  for (const SliceContact& c : contacts_of(in, p, cut)) {
    out["slice_centres"].push_back(cut.centre(k++));
    out["delta"].push_back(c.delta);
    out["contact_points"].push_back(json(c.point));
    out["normals"].push_back(json(c.normal));
  }
  return out;
}

Json load_case(const Json& in) {
  const RollerProfile p = roller_profile(in.at("roller"));
  const Json& law = in.at("law");
  const bool power = law.at("type") == "power";
  const double width = in.contains("land") ? get(in["land"], "width") : kInfinity;
  const double offset = in.contains("land") ? get(in["land"], "offset") : 0.0;
  const SlicedLine line =
      sliced_line(p, whole(in, "n_slices", 1, kMostSlices),
                  power ? get(law, "K_line") : kLineConstantSteel, width, offset);
  HalfSpaceLaw half_space;
  if (!power)
    half_space = half_space_law(elastic(get(law, "E1"), get(law, "nu1")),
                                elastic(get(law, "E2"), get(law, "nu2")), get(law, "race_depth"));
  Json out = {{"effective_length", effective_length(p)}};
  LineResultant sum;
  for (std::size_t k = 0; k < line.x.size(); ++k) {
    const double x = line.x[k], delta = get(in, "delta0") + get(in, "slope") * x - line.drop[k];
    const SliceLoad load = power ? slice_load(line.law, line.width[k], delta)
                                 : slice_load(half_space, line.width[k], delta, roller_radius(p, x),
                                              get(law, "race_curvature"));
    sum.add(x, delta, load);
    out["delta"].push_back(delta);
    out["widths"].push_back(line.width[k]);
    out["Q_slices"].push_back(load.load);
  }
  out["Q"] = sum.load;
  out["M"] = sum.moment;
  return out;
}

Json traction_case(const Json& in) {
  const RollerProfile p = roller_profile(in.at("roller"));
  const Slicing cut = slicing(p, whole(in, "n_slices", 1, kMostSlices));
  const RollerAxisPose place = read_roller_axis_pose(in.at("pose"));
  const PlacedRace placed = placed_race(in.at("race"));
  const Json& moving = in.at("kinematics");
  const RigidMotion race = {placed.pose.centre, vec3(moving.at("race_velocity")),
                            get(moving, "race_speed") * placed.pose.axes.col(0)};
  const RigidMotion roller = {place.centre, vec3(moving.at("roller_velocity")),
                              vec3(moving.at("roller_omega"))};
  Json curve_inputs = in.at("traction");
  curve_inputs["type"] = "two_slope";
  const tribology::TractionLaw traction = traction_law(curve_inputs);
  const PowerLaw law = power_law(get(in, "K_line"), cut.effective_length);
  Json out;
  ContactWrench sum;
  for (const SliceContact& c : contacts_of(in, p, cut)) {
    const double Q = slice_load(law, cut.width, c.delta).load;
    const Vec3 slip = contact_slip(race, roller, c.point, c.normal);
    traction.visit_regularized([&](const auto& per_slip) {
      add_contact(sum, Q, c.point, c.normal, slip, place.centre, per_slip);
    });
    out["delta"].push_back(c.delta);
    out["Q_slices"].push_back(Q);
    out["slip"].push_back(json(slip));
  }
  out["force"] = json(sum.force);
  out["moment"] = json(sum.moment);
  out["driving_moment"] = roller_moments(sum.moment, place.axis).driving;
  out["heat"] = sum.heat;
  return out;
}

/// The continuum as a sliced model sees it, with the number of slices that the case suggests.
Json continuum_case(const Json& in) {
  const SlicedLine line =
      sliced_line(roller_profile(in.at("roller")), whole(in, "n_slices_suggested", 1, kMostSlices),
                  get(in, "K_line"));
  const LineResultant sum = line_resultant(line, get(in, "delta0"), get(in, "slope"));
  return {{"Q", sum.load},
          {"M", sum.moment},
          {"load_per_length_max", sum.largest_load / line.width.front()}};
}

Json race_errors_case(const Json& in) {
  const Json& j = in.at("error");
  const auto harmonic = [&](const std::string& name) {
    return Harmonic{j.value(name + "1", 0.0), j.value(name + "2", 0.0), j.value(name + "3", 0.0)};
  };
  RaceErrors errors;
  errors.roundness = j.at("code") == "elliptical" ? RaceErrors::Roundness::Elliptical
                                                  : RaceErrors::Roundness::Sinusoidal;
  errors.variation = {get(j, "rnd1"), get(j, "rnd2"), get(j, "rnd3")};
  require(errors.roundness == RaceErrors::Roundness::Elliptical || errors.variation[1] >= 0.0,
          "error.rnd2 (waves per revolution) is below 0. Enter 0 or more.");
  errors.land_offset = harmonic("offset");
  errors.taper = harmonic("taper");
  errors.curvature_factor = harmonic("cfac");
  const double R = get(j, "radius");
  Json out;
  for (const Json& azimuth : in.at("race_azimuth")) {
    const LocalRaceError local = race_error_at(errors, R, azimuth.get<double>());
    out["local_radius"].push_back(R + local.radius);
    out["land_offset"].push_back(local.land_offset);
    out["taper"].push_back(local.taper);
    if (j.contains("curvature_factor"))
      out["groove_radius"].push_back(2.0 * get(in, "crown_radius") *
                                     (get(j, "curvature_factor") + local.curvature_factor));
    if (!in.contains("roller")) continue;
    const RollerProfile p = roller_profile(in["roller"]);
    const Slicing cut = slicing(p, whole(in, "n_slices", 1, kMostSlices));
    RaceSurface race = race_with_error(cylinder_race(race_from_json(in), R), local);
    race.land_width = get(in, "land_width");
    const Vec3 centre(get(in, "x"), 0.0, get(in, "r")), axis = Vec3::UnitX();
    Json delta, widths;
    for (const RollerSlice& slice : roller_slices(p, cut)) {
      delta.push_back(slice_contact(race, centre, axis, slice).delta);
      const double middle = centre[0] + slice.s * axis[0] - race.mid_x;  // as the cases place it
      widths.push_back(overlap_width(middle, cut.width, race.land_offset, race.land_width));
    }
    out["delta"].push_back(delta);
    out["widths"].push_back(widths);
  }
  return out;
}

std::optional<Json> slices_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  const std::string kind = kind_of(the_case);
  if (kind == "slice_penetration") return penetration_case(in);
  if (kind == "slice_load") return load_case(in);
  if (kind == "slice_traction") return traction_case(in);
  if (kind == "slice_continuum") return continuum_case(in);
  if (kind == "race_errors") return race_errors_case(in);
  return std::nullopt;
}

}  // namespace

std::vector<Adapter> roller_slice_adapters() {
  return {{"B_line_contact", line_contact_case}, {"rollers_slices", slices_case}};
}

}  // namespace adore::calculators
