#include "reference/cases_motion.hpp"

#include "calculators/rigid_body.hpp"
#include "dynamics/excitations.hpp"
#include "dynamics/moving_frame.hpp"
#include "dynamics/rigid_body.hpp"
#include "reference/adapter.hpp"
#include "reference/cases_constrained.hpp"
#include "reference/trajectory.hpp"
#include "statics/kinematics.hpp"

#include <nlohmann/json.hpp>

namespace adore::reference {
namespace {

Json angles_case(const Json& in) {
  const Vec3 angles = vec3(in.at("angles_deg")) * kDegree;
  const Quat q = quaternion_from_angles(angles);
  return {{"matrix_parent_to_body", json(passive_matrix(angles))},
          {"quaternion_body_to_parent", json(with_positive_w(q))},
          {"angles_back_deg", json(Vec3(angles_from_quaternion(q) / kDegree))}};
}

Json angle_rates_case(const Json& in) {
  const Vec3 angles = vec3(in.at("angles_deg")) * kDegree;
  const Quat q = with_positive_w(quaternion_from_angles(angles));
  const Vec3 omega = omega_from_angle_rates(angles, vec3(in.at("angle_rates")));
  return {{"omega_body", json(omega)},
          {"omega_parent", json(Vec3(rotation_matrix(q) * omega))},
          {"quaternion_body_to_parent", json(q)},
          {"quaternion_rate", json(quaternion_rate(q, omega))}};
}

Json cylindrical_case(const Json& in) {
  const Vec3 place = vec3(in.at("position_x_r_theta"));
  const dynamics::PointMotion motion =
      dynamics::from_cylindrical(place, vec3(in.at("rates")), vec3(in.at("second_rates")));
  const Vec3 force = get(in, "mass") * motion.acceleration;
  const Vec3 components(force[0], force.dot(radial_direction(place[2])),
                        force.dot(circumferential_direction(place[2])));
  return {{"position", json(motion.position)},
          {"velocity", json(motion.velocity)},
          {"acceleration", json(motion.acceleration)},
          {"force_needed_x_r_theta", json(components)}};
}

Json azimuth_spin_case(const Json& in) {
  const double polar = get(in, "polar_inertia"), transverse = get(in, "transverse_inertia");
  const Vec3 axis = vec3(in.at("axis_azimuth")).normalized(), omega = vec3(in.at("omega_azimuth"));
  const dynamics::SpinRates rates = dynamics::axisymmetric_spin(
      polar, transverse, get(in, "theta_rate"), omega, axis, vec3(in.at("moment_azimuth")));
  const double spin = omega.dot(axis);
  return {{"omega_rate_azimuth", json(rates.omega_azimuth)},
          {"axis_rate_azimuth", json(rates.axis_azimuth)},
          {"omega_rate_inertial_components", json(rates.omega_inertial)},
          {"kinetic_energy",
           0.5 * polar * spin * spin + 0.5 * transverse * (omega.squaredNorm() - spin * spin)}};
}

/// State: quaternion, ω (geometric axes), mass centre, its velocity.
Json trajectory_case(const Json& in) {
  const dynamics::RigidBody body = rigid_body(in);
  const Quat q0 = quaternion(in.at("initial_quaternion"));
  const Vec3 omega0 = vec3(in.at("initial_omega_geometric"));
  const Mat3 R0 = rotation_matrix(q0);
  const Vec3 G0 = vec3(in.at("initial_geometric_centre")) - R0 * body.to_geometric_centre;
  const Vec3 v0 = vec3(in.at("initial_geometric_centre_velocity")) -
                  R0 * omega0.cross(body.to_geometric_centre);
  const Vec3 force = vec3(in.at("force_inertial_at_geometric_centre"));
  Problem problem;
  problem.start = {q0[0], q0[1], q0[2], q0[3], omega0[0], omega0[1], omega0[2],
                   G0[0], G0[1], G0[2], v0[0], v0[1],     v0[2]};
  const double speed = omega0.norm(), size = 1e-3;
  problem.scales = {
      1, 1, 1, 1, speed, speed, speed, size, size, size, size * speed, size * speed, size * speed};
  problem.rates = [&](double, const double* y, double* d) {
    const Quat q = {y[0], y[1], y[2], y[3]};
    const Vec3 omega(y[4], y[5], y[6]);
    const Vec3 moment = body.to_geometric_centre.cross(rotation_matrix(q).transpose() * force);
    const Quat q_rate = quaternion_rate(q, omega);
    const Vec3 omega_rate = dynamics::euler_rate(body.inertia, omega, moment);
    for (int i = 0; i < 4; ++i) d[i] = q_rate[static_cast<std::size_t>(i)];
    for (int i = 0; i < 3; ++i) {
      d[4 + i] = omega_rate[i];
      d[7 + i] = y[10 + i];
      d[10 + i] = force[i] / body.mass;
    }
  };
  const auto times = in.at("times").get<std::vector<double>>();
  const Solution solution = solve(problem, times);
  Json quaternions = Json::array(), centres = Json::array();
  for (const State& y : solution.samples) {
    const Quat q = normalise({y[0], y[1], y[2], y[3]});
    quaternions.push_back(json(with_positive_w(q)));
    centres.push_back(
        json(Vec3(Vec3(y[7], y[8], y[9]) + rotation_matrix(q) * body.to_geometric_centre)));
  }
  return {{"quaternion_geometric_to_inertial", quaternions},
          {"omega_geometric", solution.vectors(4)},
          {"geometric_centre", centres}};
}

std::array<bool, 3> flags(const Json& j) {
  return {j.at(0).get<double>() != 0.0, j.at(1).get<double>() != 0.0, j.at(2).get<double>() != 0.0};
}

Json race_flags_case(const Json& in) {
  const Mat3 T = passive_matrix(vec3(in.at("angles_deg")) * kDegree);
  const Mat3 inertia = T.transpose() * vec3(in.at("principal_moments")).asDiagonal() * T;
  dynamics::RaceConstraints constraints;
  constraints.translation = flags(in.at("kFD"));
  constraints.rotation = flags(in.at("kMD"));
  constraints.acceleration = vec3(in.at("prescribed_acceleration"));
  constraints.angular_acceleration = vec3(in.at("prescribed_angular_acceleration"));
  const dynamics::RaceAccelerations a =
      dynamics::race_accelerations(get(in, "mass"), inertia, vec3(in.at("omega_inertial")),
                                   vec3(in.at("force")), vec3(in.at("moment")), constraints);
  return {{"acceleration", json(a.acceleration)},
          {"angular_acceleration", json(a.angular_acceleration)},
          {"holding_force", json(a.holding_force)},
          {"holding_moment", json(a.holding_moment)}};
}

dynamics::MovingFrame moving_frame(const Json& in) {
  return {get(in, "frame_speed"), get(in, "orbit_radius"), get(in, "orbit_angle_deg") * kDegree};
}

Json moving_frame_case(const Json& in) {
  const dynamics::MovingFrame frame = moving_frame(in);
  const double mass = get(in, "mass");
  const Vec3 position = vec3(in.at("position")), velocity = vec3(in.at("velocity"));
  const Vec3 inertial = frame.inertial_force(mass, position, velocity);
  const dynamics::RelativeSpinRates spin = dynamics::relative_spin(
      frame, get(in, "polar_inertia"), get(in, "transverse_inertia"), vec3(in.at("omega")),
      vec3(in.at("axis")).normalized(), vec3(in.at("moment")));
  return {{"transport_force", json(frame.transport_force(mass, position))},
          {"coriolis_force", json(frame.coriolis_force(mass, velocity))},
          {"acceleration", json(Vec3((vec3(in.at("force")) + inertial) / mass))},
          {"omega_rate", json(spin.omega)},
          {"axis_rate", json(spin.axis)},
          {"race_extra_load", json(Vec3(get(in, "load_fraction") * inertial))}};
}

/// State: position and velocity relative to the frame.
Json free_particle_case(const Json& in) {
  const dynamics::MovingFrame frame = moving_frame(in);
  const Vec3 p = vec3(in.at("initial_position")), v = vec3(in.at("initial_velocity"));
  Problem problem;
  problem.start = {p[0], p[1], p[2], v[0], v[1], v[2]};
  const double size = frame.orbit_radius, speed = size * frame.speed;
  problem.scales = {size, size, size, speed, speed, speed};
  problem.rates = [&](double, const double* y, double* d) {
    const Vec3 a = frame.inertial_force(1.0, Vec3(y[0], y[1], y[2]), Vec3(y[3], y[4], y[5]));
    for (int k = 0; k < 3; ++k) {
      d[k] = y[3 + k];
      d[3 + k] = a[k];
    }
  };
  return {{"position", solve(problem, in.at("times").get<std::vector<double>>()).vectors(0)}};
}

std::optional<Json> frame_case(const Json& the_case) {
  const std::string kind = kind_of(the_case);
  const Json& in = the_case.at("inputs");
  if (kind == "angles") return angles_case(in);
  if (kind == "angle_rates") return angle_rates_case(in);
  if (kind == "cylindrical") return cylindrical_case(in);
  if (kind == "azimuth_spin") return azimuth_spin_case(in);
  if (kind == "rigid_body_trajectory") return trajectory_case(in);
  if (kind == "race_flags") return race_flags_case(in);
  if (kind == "moving_frame") return moving_frame_case(in);
  if (kind == "moving_frame_free_particle") return free_particle_case(in);
  return std::nullopt;
}

/// Values of both races at every time of the case: keys outer_*, inner_*.
template <class Law>
Json race_histories(const Json& in, const Law& law) {
  Json out = Json::object();
  for (const double t : in.at("times"))
    for (int race = 0; race < 2; ++race) {
      const Json values = law(race, t);
      for (const auto& [name, value] : values.items())
        out[(race == 0 ? "outer_" : "inner_") + name].push_back(value);
    }
  return out;
}

Json motion_json(const dynamics::PrescribedMotion& m) {
  return {{"position", json(m.position)},
          {"velocity", json(m.velocity)},
          {"acceleration", json(m.acceleration)}};
}

Json turn_json(const dynamics::PrescribedTurn& t) {
  return {{"angle", t.angle}, {"speed", t.speed}, {"acceleration", t.acceleration}};
}

/// Deck quantity of race 0 (outer) or 1.
const Json& of_race(const Json& in, const char* name, int race) {
  return in.at(name + std::to_string(race + 1));
}

Json rotating_load_case(const Json& in) {
  const dynamics::RotatingLoad load(
      {vec3(in.at("static_outer_centre")), vec3(in.at("static_inner_centre"))},
      {get(in, "rotLoadFrac1"), get(in, "rotLoadFrac2")},
      {get(in, "rotLoadRpm1") * kRpm, get(in, "rotLoadRpm2") * kRpm});
  return race_histories(in, [&](int race, double t) { return motion_json(load.at(race, t)); });
}

Json vibration_case(const Json& in) {
  return race_histories(in, [&](int race, double t) {
    return motion_json(dynamics::vibration(
        vec3(in.at(race == 0 ? "static_outer_centre" : "static_inner_centre")),
        vec3(of_race(in, "raceVibAmp", race)), of_race(in, "raceVibFreq", race).get<double>(), t));
  });
}

Json speed_ramp_case(const Json& in) {
  return race_histories(in, [&](int race, double t) {
    const auto value = [&](const char* name) { return of_race(in, name, race).get<double>(); };
    return turn_json(dynamics::ramped_turn(
        value("rpm") * kRpm, {value("raceAngAcc") * kRpm, value("startTime"), value("endTime")},
        t));
  });
}

Json speed_sine_case(const Json& in) {
  return race_histories(in, [&](int race, double t) {
    const auto value = [&](const char* name) { return of_race(in, name, race).get<double>(); };
    return turn_json(dynamics::varying_turn(value("rpm") * kRpm, value("raceSpeedAmp") * kRpm,
                                            value("raceSpeedFreq"), t));
  });
}

Json cage_start_case(const Json& in) {
  const double gamma = get(in, "element_diameter") *
                       std::cos(get(in, "contact_angle_deg") * kDegree) / get(in, "pitch_diameter");
  const double epicyclic =
      statics::epicyclic_speed(get(in, "rpm1") * kRpm, get(in, "rpm2") * kRpm, gamma);
  const Vec3 angles = vec3(in.at("cageAngPos_deg")) * kDegree;
  const dynamics::CageStart start =
      dynamics::cage_start(epicyclic, get(in, "avRatio"), get(in, "wvRatio"),
                           vec3(in.at("locus_centre")), vec3(in.at("cageGcPos")), angles);
  dynamics::RigidBody cage;
  cage.to_geometric_centre = vec3(in.at("mass_centre_to_geometric_centre"));
  const Mat3 R = rotation_matrix(start.orientation);
  return {
      {"epicyclic_speed", epicyclic},
      {"cage_speed", start.cage_speed},
      {"whirl_speed", start.whirl_speed},
      {"mass_centre", json(start.mass_centre)},
      {"mass_centre_velocity", json(start.mass_centre_velocity)},
      {"omega_inertial", json(Vec3(R * start.omega_body))},
      {"omega_cage_frame", json(start.omega_body)},
      {"matrix_inertial_to_cage", json(Mat3(R.transpose()))},
      {"geometric_centre", json(Vec3(start.mass_centre + R * cage.to_geometric_centre))},
      {"geometric_centre_velocity", json(dynamics::geometric_centre_velocity(
                                        cage, R, start.mass_centre_velocity, start.omega_body))}};
}

std::optional<Json> excitation_case(const Json& the_case) {
  const std::string kind = kind_of(the_case);
  const Json& in = the_case.at("inputs");
  if (kind == "rotating_load") return rotating_load_case(in);
  if (kind == "race_vibration") return vibration_case(in);
  if (kind == "speed_ramp") return speed_ramp_case(in);
  if (kind == "speed_sine") return speed_sine_case(in);
  if (kind == "cage_start") return cage_start_case(in);
  return std::nullopt;
}

}  // namespace

std::vector<Adapter> motion_adapters() {
  return {{"motion_frames", frame_case},
          {"motion_excitations", excitation_case},
          {"motion_constraints", constraint_case}};
}

}  // namespace adore::reference
