#include "validation/cases_motion.hpp"

#include "calculators/rigid_body.hpp"
#include "dynamics/excitations.hpp"
#include "dynamics/moving_frame.hpp"
#include "dynamics/rigid_body.hpp"
#include "statics/kinematics.hpp"
#include "validation/adapter.hpp"
#include "validation/cases_constrained.hpp"
#include "validation/motion.hpp"

#include <nlohmann/json.hpp>

namespace adore::validation {
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

/// A cage off its mass center, with tilted principal axes, under a force.
Json trajectory_case(const Json& in) {
  const dynamics::RigidBody body = rigid_body(in);
  const Quat q0 = quaternion(in.at("initial_quaternion"));
  const Vec3 omega0 = vec3(in.at("initial_omega_geometric"));
  const Mat3 R0 = rotation_matrix(q0);
  const Vec3 force = vec3(in.at("force_inertial_at_geometric_centre"));
  SmallScene scene;
  add_cage(scene, body.mass, vec3(in.at("principal_moments")));
  scene.bearing.cage->inertia.geometric_centre = body.to_geometric_centre;
  scene.bearing.cage->inertia.frame = vec3(in.at("frame_angles_deg")) * kDegree;
  add(scene, {[=](dynamics::Evaluation& e, const dynamics::RaceModels&) {
                e.segments[0].add_force(force, e.segments[0].position);
              },
              {},
              {}});
  Motion motion(std::move(scene));
  set_cage_start(motion, vec3(in.at("initial_geometric_centre")) - R0 * body.to_geometric_centre,
                 vec3(in.at("initial_geometric_centre_velocity")) -
                     R0 * omega0.cross(body.to_geometric_centre),
                 q0, omega0);
  constexpr double kSize = 1e-3;
  motion.scale("cage.position", kSize);
  motion.scale("cage.velocity", kSize * omega0.norm());
  const auto times = in.at("times").get<std::vector<double>>();
  const Solution solution = motion.solve(motion.problem(), times);
  Json out;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const dynamics::BodyState& at =
        motion.evaluate(times[i], solution.samples[i].data()).segments[0];
    out["quaternion_geometric_to_inertial"].push_back(json(with_positive_w(at.attitude)));
    out["omega_geometric"].push_back(json(at.omega_body));
    out["geometric_centre"].push_back(json(at.position));
  }
  motion.add_evaluation_record(out);
  return out;
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

/// A ball that nothing touches in a base frame that turns.
Json free_particle_case(const Json& in) {
  SmallScene scene;
  scene.plan.race_motions.frame = bearing::FrameMotion{
      get(in, "frame_speed"), get(in, "orbit_radius"), get(in, "orbit_angle_deg") * kDegree};
  scene.have({scene::Effect::TurningFrame});
  Motion ball(std::move(scene));
  ball.place(0, vec3(in.at("initial_position")), vec3(in.at("initial_velocity")), Vec3::Zero());
  const double size = get(in, "orbit_radius"), speed = get(in, "frame_speed");
  for (const char* group : {"element.x", "element.r"}) ball.scale(group, size);
  for (const char* group : {"element.x_dot", "element.r_dot"}) ball.scale(group, size * speed);
  for (const char* group : {"element.theta_dot", "element.omega_x"}) ball.scale(group, speed);
  const auto times = in.at("times").get<std::vector<double>>();
  const Solution solution = ball.solve(ball.problem(), times);
  Json out;
  for (std::size_t i = 0; i < times.size(); ++i)
    out["position"].push_back(
        json(ball.evaluate(times[i], solution.samples[i].data()).element_centre(0)));
  ball.add_evaluation_record(out);
  return out;
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

Json turn_json(const dynamics::PrescribedRotation& t) {
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

Json motion_vibration_case(const Json& in) {
  return race_histories(in, [&](int race, double t) {
    return motion_json(dynamics::vibration(
        vec3(in.at(race == 0 ? "static_outer_centre" : "static_inner_centre")),
        vec3(of_race(in, "raceVibAmp", race)), of_race(in, "raceVibFreq", race).get<double>(), t));
  });
}

Json speed_ramp_case(const Json& in) {
  return race_histories(in, [&](int race, double t) {
    const auto value = [&](const char* name) { return of_race(in, name, race).get<double>(); };
    return turn_json(dynamics::ramped_rotation(
        value("rpm") * kRpm, {value("raceAngAcc") * kRpm, value("startTime"), value("endTime")},
        t));
  });
}

Json speed_sine_case(const Json& in) {
  return race_histories(in, [&](int race, double t) {
    const auto value = [&](const char* name) { return of_race(in, name, race).get<double>(); };
    return turn_json(dynamics::varying_rotation(value("rpm") * kRpm, value("raceSpeedAmp") * kRpm,
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
  if (kind == "race_vibration") return motion_vibration_case(in);
  if (kind == "speed_ramp") return speed_ramp_case(in);
  if (kind == "speed_sine") return speed_sine_case(in);
  if (kind == "cage_start") return cage_start_case(in);
  return std::nullopt;
}

}  // namespace

std::vector<Adapter> motion_adapters() {
  return {{"motion_frames", frame_case},
          {"motion_excitations", excitation_case},
          {"motion_constraints", evaluate_constraint_case}};
}

}  // namespace adore::validation
