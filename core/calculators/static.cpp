#include "calculators/static.hpp"

#include "calculators/json_access.hpp"
#include "contact/groove.hpp"
#include "contact/hertz.hpp"
#include "contact/subsurface.hpp"
#include "statics/ball_statics.hpp"
#include "statics/kinematics.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace adore::calculators {
namespace {

using statics::Control;
using statics::Curvature;
using statics::Orbit;

constexpr double kUndefined = std::numeric_limits<double>::quiet_NaN();

/// Undefined quantities are NaN in the library and null in the cases.
Json number_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

/// Number, or the text "inf" (the gate allows no other).
double radius(const Json& j) {
  return j.is_string() ? std::numeric_limits<double>::infinity() : j.get<double>();
}

bearing::Material material(const Json& j) {
  bearing::Material m;
  m.elastic_modulus = get(j, "E");
  m.poisson_ratio = get(j, "nu");
  m.density = j.value("rho", 0.0);
  return m;
}

// ---- A_hertz_point

/// The load, or the load that gives one of its results: Q = K δ^(3/2), p0 = 3 Q/(2 π a b) with
/// a b = â b̂ Q^(2/3), a = â Q^(1/3).
double hertz_load(const Json& in, const contact::HertzConstants& h) {
  if (in.contains("approach")) return h.K * std::pow(get(in, "approach"), 1.5);
  if (in.contains("pressure"))
    return std::pow(get(in, "pressure") * kPi * h.a_hat * h.b_hat / 1.5, 3.0);
  if (in.contains("half_axis")) return std::pow(get(in, "half_axis") / h.a_hat, 3.0);
  return get(in, "load");
}

std::optional<Json> hertz_case(const Json& the_case) {
  if (kind_of(the_case) != "hertz_point") return std::nullopt;
  const Json& in = the_case.at("inputs");
  const Json& one = in.at("body1");
  const Json& two = in.at("body2");
  const double along_x = 1.0 / radius(one.at("Rx")) + 1.0 / radius(two.at("Rx"));
  const double along_y = 1.0 / radius(one.at("Ry")) + 1.0 / radius(two.at("Ry"));
  const auto [low, high] = std::minmax(along_x, along_y);
  const double E_star = bearing::contact_modulus(material(one), material(two));
  const contact::HertzConstants h = contact::hertz_constants({low, high}, E_star);
  const double Q = hertz_load(in, h);
  require(Q > 0.0, fmt::format("load = {:.4g} N: must be above 0. Enter a load.", Q));
  const double nu = get(in, "stress_poisson");
  const double a = h.a_hat * std::cbrt(Q);
  const double b = h.b_hat * std::cbrt(Q);
  const double p_max = 1.5 * Q / (kPi * a * b);
  const double delta = std::cbrt((Q / h.K) * (Q / h.K));
  const contact::SubsurfaceStress s = contact::subsurface_stress(a, b, p_max, nu);
  const contact::AxisStress axis = contact::axis_stress(a, b, p_max, nu, 0.5 * b);
  return Json{{"load", Q},
              {"E_star", E_star},
              {"curvature_sum", low + high},
              {"curvature_difference", (high - low) / (low + high)},
              {"ellipticity_k", h.kappa},
              {"elliptic_parameter_m", (1.0 - 1.0 / h.kappa) * (1.0 + 1.0 / h.kappa)},
              {"K", h.K_integral},
              {"E", h.E_integral},
              {"a", a},
              {"b", b},
              {"major_along", along_y <= along_x ? "y" : "x"},
              {"delta", delta},
              {"p_max", p_max},
              {"load_deflection_constant", h.K},
              {"stiffness", 1.5 * Q / delta},
              {"tau_orthogonal_max", s.orthogonal_shear},
              {"tau_orthogonal_depth", s.orthogonal_depth},
              {"tau_orthogonal_offset", s.orthogonal_offset},
              {"tau_max_axis", s.max_shear},
              {"tau_max_axis_depth", s.max_shear_depth},
              {"tau_oct_max_axis", s.octahedral},
              {"tau_oct_max_axis_depth", s.octahedral_depth},
              {"von_mises_max_axis", s.von_mises},
              {"axis_stress_at_half_b",
               {{"depth", 0.5 * b},
                {"sigma_major_dir", axis.major},
                {"sigma_minor_dir", axis.minor},
                {"sigma_depth_dir", axis.depth}}}};
}

// ---- C_ball_bearing

bearing::BallGeometry geometry(const Json& g) {
  bearing::BallGeometry balls;
  balls.count = whole(g, "Z", 1, kMostElements);
  balls.diameter = get(g, "D");
  balls.pitch_diameter = get(g, "dm");
  require_elements_fit(balls.count, balls.diameter, balls.pitch_diameter);
  balls.groove_factor = {get(g, "fo"), get(g, "fi")};
  balls.contact_angle = g.value("alpha0_deg", 0.0) * kDegree;
  balls.clearance = g.value("Pd", 0.0);
  return balls;
}

bearing::Bearing ball_bearing(const Json& in) {
  bearing::Bearing b;
  b.elements = geometry(in.at("geometry"));
  b.element_material = material(in.at("material").at("ball"));
  b.race_material = {material(in["material"].at("race")), material(in["material"]["race"])};
  const double D = b.balls().diameter;
  const double volume = kPi * D * D * D / 6.0;
  b.element_inertia.mass = in.value("ball_mass", b.element_material.density * volume);
  require(
      b.element_inertia.mass > 0.0 || in.contains("ball_mass") || in.value("speed_rpm", 0.0) == 0.0,
      "the ball mass is missing, but is needed because the race rotates. Give ball_mass or "
      "material.ball.rho");
  b.element_inertia.moments = bearing::Vec3::Constant(0.1 * b.element_inertia.mass * D * D);
  b.speed = {0.0, in.value("speed_rpm", 0.0) * kRpm};
  const Json prescribed = in.value("prescribed_displacement", Json::object());
  for (std::size_t k = 0; k < 5; ++k) {
    if (prescribed.contains(kDisplacement[k])) {
      b.constraints.displacement_given[k] = true;
      b.constraints.displacement[k] = get(prescribed, kDisplacement[k]);
    } else {
      b.constraints.load[k] = get(in.at("applied_load"), kLoad[k]);
    }
  }
  return b;
}

std::optional<statics::BallStaticsOptions> case_options(const Json& in) {
  statics::BallStaticsOptions o;
  o.kinematics = statics::RingKinematics::Linear;
  o.first_azimuth = in.at("geometry").value("psi0_deg", 0.0) * kDegree;
  const Json given = in.value("options", Json::object());
  const std::string curvature = given.value("curvature", "free");
  const std::string control = given.value("control", "outer");
  const std::string orbit = given.value("orbit", "per_ball");
  if (curvature == "free")
    o.curvature = Curvature::Free;
  else if (curvature == "actual")
    o.curvature = Curvature::Actual;
  else
    return std::nullopt;
  if (control == "outer")
    o.control = Control::Outer;
  else if (control == "inner")
    o.control = Control::Inner;
  else if (control == "equal")
    o.control = Control::Equal;
  else if (control == "none")
    o.control = Control::None;
  else
    return std::nullopt;
  if (orbit == "per_ball")
    o.orbit = Orbit::PerBall;
  else if (orbit == "nominal")
    o.orbit = Orbit::Nominal;
  else
    return std::nullopt;
  return o;
}

Json solution_json(const statics::StaticSolution& s) {
  Json out;
  for (std::size_t k = 0; k < 5; ++k) {
    out["displacement"][kDisplacement[k]] = s.displacement[k];
    out["reaction"][kLoad[k]] = s.load[k];
    for (std::size_t l = 0; l < 5; ++l) {
      out["stiffness_5x5"][k][l] =
          s.stiffness(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(l));
    }
  }
  out["stiffness_dof_order"] = kDisplacement;
  constexpr std::array<const char*, 2> kSide{"_o", "_i"};
  constexpr std::array<const char*, 2> kSuffix{"o", "i"};
  for (const statics::StaticBall& ball : s.balls) {
    const auto add = [&](const std::string& key, double value) {
      out[key].push_back(number_or_null(value));
    };
    add("azimuth_rad", ball.azimuth);
    add("orbital_speed", ball.orbital_speed);
    add("Fc", ball.centrifugal_force);
    add("gyro_moment", ball.gyroscopic_moment);
    add("spin_speed", ball.spin_speed);
    add("pitch_angle", ball.pitch_angle);
    add("race_control_ratio", ball.race_control_ratio);
    for (std::size_t j = 0; j < 2; ++j) {
      const std::string side = kSide[j];
      add(std::string("Q") + kSuffix[j], ball.Q[j]);
      add(std::string("K") + kSuffix[j] + "_per_ball", ball.K[j]);
      add("alpha" + side, ball.alpha[j]);
      add("delta" + side, ball.Q[j] > 0.0 ? ball.delta[j] : kUndefined);
      add("spin_roll" + side, ball.spin_roll[j]);
      add("a" + side, ball.a[j]);
      add("b" + side, ball.b[j]);
      add("pmax" + side, ball.p_max[j]);
    }
  }
  return out;
}

std::optional<Json> ball_case(const Json& the_case) {
  if (kind_of(the_case) != "ball_equilibrium") return std::nullopt;
  const Json& in = the_case.at("inputs");
  const auto options = case_options(in);
  if (!options) return std::nullopt;
  Json out = solution_json(statics::solve_ball_statics(ball_bearing(in), *options));
  // One constant per race where it does not follow the angles.
  const bool follows = options->curvature == Curvature::Actual;
  out["Ko"] = follows ? Json(nullptr) : Json(out["Ko_per_ball"][0]);
  out["Ki"] = follows ? Json(nullptr) : Json(out["Ki_per_ball"][0]);
  return out;
}

// ---- E_kinematics

Json frequencies(const statics::EpicyclicSpeeds& s, double scale) {
  return {{"BPFO", s.outer_pass * scale},
          {"BPFI", s.inner_pass * scale},
          {"BSF", s.spin_frequency * scale},
          {"ball_defect_2xBSF", 2.0 * s.spin_frequency * scale},
          {"FTF", s.cage_frequency * scale}};
}

std::optional<Json> kinematics_case(const Json& the_case) {
  if (kind_of(the_case) != "kinematics") return std::nullopt;
  const Json& in = the_case.at("inputs");
  require_elements_fit(whole(in, "Z", 1, kMostElements), get(in, "D"), get(in, "dm"));
  const double inner = get(in, "inner_speed_rpm") * kRpm;
  const double outer = get(in, "outer_speed_rpm") * kRpm;
  const auto s =
      statics::epicyclic_speeds(whole(in, "Z", 1, kMostElements), get(in, "D"), get(in, "dm"),
                                get(in, "contact_angle_deg") * kDegree, outer, inner);
  Json out = frequencies(s, 1.0);
  out["gamma"] = s.gamma;
  out["cage_speed"] = s.cage_speed;
  out["ball_spin_speed"] = s.element_spin;
  // Multiples of the speed of the race that turns (the inner one when both do).
  const double shaft = std::abs(inner != 0.0 ? inner : outer) / (2.0 * kPi);
  if (shaft > 0.0) out["multiples_of_shaft_speed"] = frequencies(s, 1.0 / shaft);
  return out;
}

// ---- P_published

/// P01-P07 use dm/2 as the lever of tilt and moment: M/lever and tilt times lever are what counts.
Json published_ball_bearing(const Json& in) {
  bearing::Bearing bearing = ball_bearing(in);
  const contact::GrooveGeometry groove = contact::groove_geometry(bearing.balls());
  const double lever_ratio =
      in.at("tilt_lever") == "dm/2"
          ? groove.centre_radius[bearing::kInner] / (0.5 * bearing.balls().pitch_diameter)
          : 1.0;
  bearing.constraints.load[3] *= lever_ratio;
  bearing.constraints.load[4] *= lever_ratio;
  statics::BallStaticsOptions options = *case_options(in);
  const auto s = statics::solve_ball_statics(bearing, options);
  return {{"u_radial_um", 1e6 * std::hypot(s.displacement[1], s.displacement[2])},
          {"ux_um", 1e6 * s.displacement[0]},
          {"tilt_mrad", 1e3 * lever_ratio * std::hypot(s.displacement[3], s.displacement[4])}};
}

Json multiples_of_shaft_speed(int Z, double gamma) {
  return frequencies(statics::epicyclic_speeds(Z, gamma, 1.0, 0.0, 0.0, 2.0 * kPi), 1.0);
}

Json thrust_bearing(const Json& in) {
  Json full = in;
  full["material"] = {{"ball", {{"E", 206e9}, {"nu", 0.3}}}, {"race", {{"E", 206e9}, {"nu", 0.3}}}};
  full["applied_load"] = {{"Fx", in.at("thrust")}, {"Fy", 0}, {"Fz", 0}, {"My", 0}, {"Mz", 0}};
  const auto s = statics::solve_ball_statics(ball_bearing(full), *case_options(full));
  return {{"contact_angle_deg", s.balls.front().alpha[bearing::kInner] / kDegree},
          {"axial_deflection", s.displacement[0]}};
}

Json curvature_of_both_races(const Json& in) {
  const bearing::BallGeometry balls = geometry(in.at("geometry"));
  Json out;
  for (int race = 0; race < 2; ++race) {
    const auto rho = contact::race_curvature(balls, race, balls.contact_angle);
    const double sum = rho.along_minor + rho.along_major;
    out[race == bearing::kOuter ? "outer" : "inner"] = {
        {"curvature_sum_per_mm", 1e-3 * sum},
        {"curvature_difference", (rho.along_minor - rho.along_major) / sum}};
  }
  return out;
}

std::optional<Json> published_case(const Json& the_case) {
  const std::string kind = kind_of(the_case);
  const Json& in = the_case.at("inputs");
  if (kind == "ball_bearing_static_radial") return published_ball_bearing(in);
  if (kind == "cwru_drive_end_bearing") {
    const double gamma =
        get(in, "D") / get(in, "dm") * std::cos(get(in, "contact_angle_deg") * kDegree);
    return multiples_of_shaft_speed(whole(in, "Z", 1, kMostElements), gamma);
  }
  if (kind == "timken_wide_inner_ring") {
    // The catalogue's BSF is per revolution of the shaft, d_m(1-γ²)/(2D) with γ = D/d_m.
    return multiples_of_shaft_speed(whole(in, "Z", 1, kMostElements), get(in, "gamma"));
  }
  if (kind == "harris_rolling_bearing_analysis" && in.contains("thrust")) return thrust_bearing(in);
  if (kind == "harris_angular_contact_curvature") return curvature_of_both_races(in);
  return std::nullopt;
}

}  // namespace

std::vector<Adapter> static_adapters() {
  return {{"A_hertz_point", hertz_case},
          {"C_ball_bearing", ball_case},
          {"E_kinematics", kinematics_case},
          {"P_published", published_case}};
}

}  // namespace adore::calculators
