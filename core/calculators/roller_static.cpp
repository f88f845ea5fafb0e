#include "calculators/roller_static.hpp"

#include "calculators/json_access.hpp"
#include "contact/tapered_geometry.hpp"
#include "statics/roller_statics.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>

namespace adore::calculators {
namespace {

/// Family D has no axial freedom: ux is held at 0.
bearing::Bearing cylindrical(const Json& in) {
  bearing::Bearing b;
  b.type = bearing::Type::Cylindrical;
  bearing::RollerGeometry g;
  g.count = whole(in, "Z", 1, kMostElements);
  g.diameter = get(in, "roller_diameter");
  g.length = get(in, "roller_length");
  g.pitch_diameter = get(in, "pitch_diameter");
  g.clearance = get(in, "diametral_clearance");
  const std::string profile = in.at("profile").get<std::string>();
  g.crown_radius = std::numeric_limits<double>::infinity();
  g.central_length = g.length;
  if (profile == "circular") {
    g.crown_radius = get(in, "crown_radius");
    g.central_length = 0.0;
  } else if (profile == "logarithmic") {
    g.shape = bearing::RollerShape::Logarithmic;
  }
  b.elements = g;
  for (bearing::Material* m : {&b.element_material, &b.race_material[0], &b.race_material[1]}) {
    m->elastic_modulus = 206e9;
    m->poisson_ratio = 0.3;
  }
  const double D = g.diameter;
  const double mass = get(in, "roller_density") * kPi * D * D * g.length / 4.0;
  b.element_inertia.mass = mass;
  const double across = mass * (D * D / 16.0 + g.length * g.length / 12.0);
  b.element_inertia.moments = {mass * D * D / 8.0, across, across};
  b.speed = {0.0, in.value("speed_rpm", 0.0) * kRpm};
  b.constraints.displacement_given[0] = true;
  const Json& prescribed = in.at("prescribed");
  for (std::size_t k = 1; k < 5; ++k) {
    if (prescribed.contains(kDisplacement[k])) {
      b.constraints.displacement_given[k] = true;
      b.constraints.displacement[k] = get(prescribed, kDisplacement[k]);
    } else {
      b.constraints.load[k] = get(in.at("applied_load"), kLoad[k]);
    }
  }
  return b;
}

Json block(const statics::RollerSolution& s, int size) {
  Json out;
  for (int i = 0; i < size; ++i)
    for (int j = 0; j < size; ++j) out[i][j] = s.stiffness(i + 1, j + 1);
  return out;
}

Json cylindrical_case(const Json& in) {
  statics::RollerOptions options;
  options.slices = whole(in, "n_slices", 1, kMostSlices);
  options.kinematics = statics::RollerKinematics::Linear;
  options.line_constant = get(in, "K_line");
  options.first_azimuth = in.value("psi0_deg", 0.0) * kDegree;
  const bearing::Bearing bearing = cylindrical(in);
  const statics::RollerSolution s = statics::solve_roller_statics(bearing, options);
  Json out;
  for (std::size_t k = 1; k < 5; ++k) {
    out["displacement"][kDisplacement[k]] = s.displacement[k];
    out["reaction"][kLoad[k]] = s.load[k];
  }
  int loaded = 0;
  double largest = 0.0;
  for (const statics::StaticRoller& roller : s.rollers) {
    out["azimuth_rad"].push_back(roller.azimuth);
    out["Qo"].push_back(roller.race[0].load);
    out["Qi"].push_back(roller.race[1].load);
    out["roller_moment_o"].push_back(roller.race[0].moment);
    out["roller_moment_i"].push_back(roller.race[1].moment);
    const bool both = roller.race[1].load > 0.0;
    out["roller_tilt"].push_back(both ? Json(roller.tilt) : Json(nullptr));
    loaded += both ? 1 : 0;
    largest = std::max(largest, roller.race[1].load);
  }
  out["loaded_rollers"] = loaded;
  out["Q_max"] = largest;
  out["Fc"] = s.centrifugal_force;
  out["roller_mass"] = s.roller_mass;
  out["orbital_speed"] = s.orbital_speed;
  out["roller_spin_speed"] = std::abs(s.spin_speed);
  out["stiffness_2x2_uy_uz"] = block(s, 2);
  out["stiffness_4x4"] = block(s, 4);
  out["stiffness_dof_order"] = {"uy", "uz", "thy", "thz"};
  return out;
}

Json tapered_case(const Json& in) {
  const std::array<double, 2> angle{get(in, "cup_half_angle_deg") * kDegree,
                                    get(in, "cone_half_angle_deg") * kDegree};
  const double count = whole(in, "Z", 1, kMostElements);
  const contact::RibLoads q =
      contact::rib_loads(get(in, "thrust") / count, angle, get(in, "flange_angle_deg") * kDegree,
                         get(in, "centrifugal_force"));
  const double thrust = count * (q.inner * std::sin(angle[1]) +
                                 q.rib * std::cos(get(in, "flange_angle_deg") * kDegree));
  return {{"Q_cup", q.outer},
          {"Q_cone", q.inner},
          {"Q_flange", q.rib},
          {"thrust_check_inner_ring", thrust}};
}

std::optional<Json> roller_case(const Json& the_case) {
  const std::string kind = kind_of(the_case);
  const Json& in = the_case.at("inputs");
  if (kind == "cylindrical_roller_bearing_z") return cylindrical_case(in);
  if (kind == "tapered_roller_bearing_under") return tapered_case(in);
  return std::nullopt;
}

}  // namespace

std::vector<Adapter> roller_static_adapters() { return {{"D_roller_bearing", roller_case}}; }

}  // namespace adore::calculators
