#include "dynamics/state_access.hpp"
#include "validation/ball_scenario.hpp"
#include "validation/scenarios.hpp"

#include <nlohmann/json.hpp>

#include <array>

/// F_dynamics, dynamics_impact and dynamics_plates. Parts that are not bearings: races are grooves
/// of given Hertz constants on which the ball moves radially, a pendulum is an inner race with its
/// mass center off its axis, a rigid body is a cage, a plate is a wall that presses on the ball.
namespace adore::validation {
namespace {

using contact::hertz_load;
using dynamics::Evaluation;

double sign(double u) { return (u > 0.0) - (u < 0.0); }

// ---- a ball that moves radially between grooves

/// The acceleration starts like t^1.5, a rate that depends on time alone: the higher Fehlberg pairs
/// do not see its error.
constexpr const char* kSeesTimeErrors = "rkf4";
constexpr double kFactor = 0.52;     ///< of the grooves
constexpr double kWideFactor = 0.6;  ///< of an inner groove that the ball does not reach
constexpr double kInnerGap = 5e-4;   ///< to it [m], less than (kWideFactor - 0.5) D

/// Contact points of the ball with the outer and the inner race [m].
SmallScene radial_scene(double mass, double diameter, const std::array<double, 2>& touch,
                        double inner_factor) {
  SmallScene scene;
  set_grooves(scene, diameter, {kFactor, inner_factor},
              {touch[0] - (kFactor - 0.5) * diameter, touch[1] + (inner_factor - 0.5) * diameter},
              diameter / (touch[0] + touch[1]));
  scene.bearing.element_inertia.mass = mass;
  scene.bearing.element_inertia.moments.setConstant(0.1 * mass * diameter * diameter);
  scene.have({scene::Effect::RaceContact});
  return scene;
}

void scale_radial(Motion& ball, double length, double speed) {
  ball.scale("element.r", length);
  ball.scale("element.r_dot", speed);
}

struct Impact {
  double max_approach = 0.0, time_of_peak = 0.0, duration = 0.0, rebound = 0.0;
  std::vector<double> approach, velocity, force;  ///< at the sample times
};

/// Hits the outer race with `speed` (below 0: it leaves, and nothing touches); sampled at `times`
/// (may be empty). @param touch where the ball touches the outer race [m]
Impact impact(SmallScene scene, double K, double touch, double speed, std::vector<double> times,
              Json& evidence) {
  Motion ball(std::move(scene));
  const double mass = ball.mass();
  const double size = std::pow(mass * speed * speed / K, 0.4), time = size / std::abs(speed);
  const std::size_t samples = times.size();
  if (times.empty()) times.push_back(0.0);
  times.push_back(std::max(5 * time, 1.01 * times.back()));
  const auto r = static_cast<std::size_t>(ball.at("element.r")),
             r_dot = static_cast<std::size_t>(ball.at("element.r_dot"));
  ball.start[r] = touch;
  ball.start[r_dot] = speed;
  scale_radial(ball, size, speed);
  Problem problem = ball.problem();
  problem.longest_step = 0.05 * time;
  problem.stepper = kSeesTimeErrors;
  const auto approach = [&](double t, const double* y) {
    return ball_load(ball, ball.evaluate(t, y), 0).contact.approach;
  };
  problem.events = {[=](double, const double* y) { return y[r_dot]; }, approach};
  const Solution solution = ball.solve(problem, times);
  Impact result;
  for (std::size_t i = 0; i < samples; ++i) {
    const State& y = solution.samples[i];
    result.approach.push_back(approach(times[i], y.data()));
    result.velocity.push_back(y[r_dot]);
    result.force.push_back(ball.evaluate(times[i], y.data()).load[0][0]);
  }
  for (const Event& event : solution.events) {
    if (event.index == 0) {
      result.max_approach = approach(event.t, event.y.data());
      result.time_of_peak = event.t;
    } else if (!event.rising) {
      result.duration = event.t;
      result.rebound = event.y[r_dot];
    }
  }
  ball.add_evaluation_record(evidence);
  return result;
}

/// A ball of the case's mass on a groove with its Hertz constant: which ball and groove have it
/// does not matter.
Impact impact_of(double mass, double K, double speed, std::vector<double> times, Json& evidence) {
  constexpr double kTouch = 0.02;
  SmallScene scene = radial_scene(mass, 0.0127, {kTouch, kTouch - kInnerGap}, kWideFactor);
  set_hertz_constant(scene, 0, K);
  return impact(std::move(scene), K, kTouch, speed, std::move(times), evidence);
}

// ---- F_dynamics

/// FV: ball between two fixed races.
Json between_races(const Json& in) {
  const double Ki = get(in, "Ki"), Ko = get(in, "Ko"), mass = get(in, "mass"),
               preload = get(in, "preload"), x0 = get(in, "x0");
  const double di = std::pow(preload / Ki, 2.0 / 3.0), d_o = std::pow(preload / Ko, 2.0 / 3.0);
  const double stiffness = 1.5 * (Ki * std::sqrt(di) + Ko * std::sqrt(d_o)),
               omega = std::sqrt(stiffness / mass);
  constexpr double kRest = 3e-3;  // small, so that 1e-8 m of it has eleven digits
  SmallScene scene = radial_scene(mass, 2e-3, {kRest - d_o, kRest + di}, kFactor);
  set_hertz_constant(scene, 0, Ko);
  set_hertz_constant(scene, 1, Ki);
  Motion ball(std::move(scene));
  const auto r = static_cast<std::size_t>(ball.at("element.r")),
             r_dot = static_cast<std::size_t>(ball.at("element.r_dot"));
  ball.start[r] = kRest + x0;
  scale_radial(ball, x0, x0 * omega);
  Problem problem = ball.problem();
  problem.longest_step = 0.1 / omega;
  problem.stepper = kSeesTimeErrors;
  problem.events = {[=](double, const double* y) { return y[r_dot]; },
                    [=](double, const double* y) { return y[r] - kRest; }};
  for (const std::size_t j : {0UL, 1UL})  // contacts opening
    problem.events.emplace_back([&ball, j](double t, const double* y) {
      return ball_load(ball, ball.evaluate(t, y), j).contact.approach;
    });
  int turns = 0;
  problem.at_event = [&](int event, double, const State&) { return event == 0 && ++turns == 2; };
  const Solution solution = ball.solve(problem, std::vector<double>{0.0, 100.0 / omega});
  Json result = {{"delta_i0", di},
                 {"delta_o0", d_o},
                 {"linear_stiffness", stiffness},
                 {"linear_angular_frequency", omega},
                 {"linear_frequency_Hz", omega / (2 * kPi)}};
  for (const Event& event : solution.events) {
    if (event.index == 1 && !result.contains("speed_at_x0_zero"))
      result["speed_at_x0_zero"] = std::abs(event.y[r_dot]);
    if (event.index != 0) continue;
    if (!result.contains("opposite_turning_point"))
      result["opposite_turning_point"] = event.y[r] - kRest;
    else
      result["period"] = event.t;
  }
  ball.add_evaluation_record(result);
  return result;
}

Json mass_impact(const Json& in) {
  const double K = get(in, "K"), speed = get(in, "speed");
  Json result;
  const Impact hit = impact_of(get(in, "mass"), K, speed, {}, result);
  result["delta_max"] = hit.max_approach;
  result["F_max"] = hertz_load(K, hit.max_approach);
  result["duration"] = hit.duration;
  result["coefficient"] = hit.duration * speed / hit.max_approach;
  return result;
}

/// FE, FS: torque-free rotation on principal axes.
Json free_rotation(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  const Vec3 I = vec3(in.at("inertia")), w0 = vec3(in.at("omega0"));
  std::vector<double> times;
  const Json::json_pointer states_asked("/expected/states");
  if (the_case.contains(states_asked))
    for (const Json& state : the_case[states_asked]) times.push_back(get(state, "t"));
  else
    times = sample_times(the_case);
  const bool symmetric = I[1] == I[2];
  SmallScene scene;
  add_cage(scene, 1.0, I);
  Motion body(std::move(scene));
  set_cage_start(body, Vec3::Zero(), Vec3::Zero(), {1, 0, 0, 0}, w0);
  const int q = body.at("cage.quaternion"), w = body.at("cage.omega");
  Problem problem = body.problem();
  problem.longest_step = 0.5 / w0.norm();
  if (!symmetric) problem.events = {[=](double, const double* y) { return y[w + 1]; }};
  const Solution solution = body.solve(problem, times);
  Json states = Json::array();
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double* y = solution.samples[i].data();
    states.push_back(
        {{"t", times[i]},
         {"omega_body", json(dynamics::vector_at(y, {w, 3}))},
         {"quaternion_wxyz",
          json(with_positive_w(normalize_quaternion(dynamics::quaternion_at(y, {q, 4}))))}});
  }
  const Vec3 L = I.cwiseProduct(w0);
  Json result = {{"states", states},
                 {"kinetic_energy", 0.5 * w0.dot(L)},
                 {"angular_momentum_magnitude", L.norm()}};
  body.add_evaluation_record(result);
  if (symmetric) {
    (void)body.evaluate(0.0, body.start.data());
    result["body_precession_rate"] = body.rates()[static_cast<std::size_t>(w) + 2] / w0[1];
    result["inertial_precession_rate"] = L.norm() / I[1];
    return result;
  }
  const double low = (I[1] - I[0]) * I[0] * w0[0] * w0[0],
               high = (I[2] - I[1]) * I[2] * w0[2] * w0[2];
  const double span = I[2] - I[0];
  result["modulus_m"] = low < high ? low / high : high / low;
  result["polhode_rate"] = low < high ? w0[2] * std::sqrt((I[2] - I[1]) * span / (I[0] * I[1]))
                                      : w0[0] * std::sqrt((I[1] - I[0]) * span / (I[1] * I[2]));
  if (solution.events.size() > 1) result["polhode_period"] = solution.events[1].t;
  return result;
}

// ---- a ball between plates

/// The ball moves along x with v and turns about e_θ with ω; the top plate touches it at +e_r, the
/// bottom plate at -e_r. Slips V - (v ∓ R ω).
struct Plates {
  double radius;
  std::array<double, 2> load, speed;
  tribology::TractionLaw law;
  std::array<double, 2> heat{};
  double work = 0.0;

  static constexpr std::array<double, 2> kSide{1.0, -1.0};
  [[nodiscard]] double slip(std::size_t k, double v, double omega) const {
    return speed[k] - v + kSide[k] * radius * omega;
  }
  void act(Evaluation& e) {
    work = 0.0;
    for (std::size_t k = 0; k < 2; ++k) {
      heat[k] = 0.0;
      if (!(load[k] > 0.0)) continue;
      dynamics::BodyState plate;
      plate.velocity = speed[k] * Vec3::UnitX();
      const Vec3 m = kSide[k] * e.to_base(0, Vec3::UnitY());
      const auto action = press(e, 0, plate, m, radius, linear_spring(load[k]), 1.0, law);
      e.add_force(0, e.to_cylindrical(0, load[k] * m));  // load of the ball on the plate
      heat[k] = action.heat;
      work += action.friction.dot(plate.velocity);
    }
  }
};

struct PlateMotion {
  std::unique_ptr<Plates> plates;
  Motion motion;
  std::size_t v, omega;

  PlateMotion(double mass, double inertia, Plates given, double v0, double omega0)
      : plates(std::make_unique<Plates>(std::move(given))),
        motion([&] {
          SmallScene scene;
          scene.bearing.element_inertia.mass = mass;
          scene.bearing.element_inertia.moments.setConstant(inertia);
          add(scene, {[p = plates.get()](Evaluation& e, const dynamics::RaceModels&) { p->act(e); },
                      {},
                      {{"heat top", &plates->heat[0]},
                       {"heat bottom", &plates->heat[1]},
                       {"work", &plates->work}}});
          return scene;
        }()),
        v(static_cast<std::size_t>(motion.at("element.x_dot"))),
        omega(static_cast<std::size_t>(motion.at("element.omega_theta"))) {
    motion.start[v] = v0;
    motion.start[omega] = omega0;
    double speed = 1e-3;
    for (const std::size_t k : {0UL, 1UL})
      if (plates->load[k] > 0.0) speed = std::max(speed, std::abs(slip(k, motion.start.data())));
    motion.scale("element.x_dot", speed);
    for (const char* group : {"element.omega_x", "element.omega_r", "element.omega_theta"})
      motion.scale(group, speed / plates->radius);
  }
  [[nodiscard]] double slip(std::size_t k, const double* y) const {
    return plates->slip(k, y[v], y[omega]);
  }
};

/// FK: body pressed on a plane by N, sliding until it rolls. Friction is constant above 1e-12 of
/// the slip at the start.
Json slide_to_rolling(const Json& in) {
  const double m = get(in, "mass"), R = get(in, "radius"), mu = get(in, "friction_coefficient"),
               N = get(in, "normal_force"), v0 = get(in, "v0"), omega0 = get(in, "omega0");
  const double slip = v0 - R * omega0, least = 1e-12 * std::abs(slip);
  const bearing::TractionCurve coulomb{
      bearing::TractionCurve::Form::TwoSlope, 0.0, mu / least, 0.0, 0.0, least};
  PlateMotion body(m, get(in, "inertia_coefficient") * m * R * R, {R, {N, 0.0}, {}, coulomb}, v0,
                   omega0);
  Problem problem = body.motion.problem();
  problem.events = {[&](double, const double* y) { return std::abs(body.slip(0, y)) - least; }};
  problem.at_event = [](int, double, const State&) { return true; };
  const Solution solution =
      body.motion.solve(problem, std::vector<double>{0.0, 2 * std::abs(slip) * m / (mu * N)});
  const Event& end = solution.events.at(0);
  Json result = {{"time_to_rolling", end.t},
                 {"rolling_speed", end.y[body.v]},
                 {"rolling_spin", end.y[body.omega]},
                 {"friction_work", end.y[static_cast<std::size_t>(body.motion.at("heat top"))]}};
  body.motion.add_evaluation_record(result);
  return result;
}

/// FP: element rolling in a circular race under gravity: the same motion as that of an inner race
/// that turns about its axis, with its mass center as far off it as the element is.
Json rolling_pendulum(const Json& in) {
  const double arm = get(in, "race_radius") - get(in, "element_radius"), g = get(in, "g"),
               kc = get(in, "inertia_coefficient"), theta0 = get(in, "theta0");
  const double omega = std::sqrt(g / (arm * (1 + kc)));
  SmallScene scene;
  bearing::Inertia& inertia = scene.bearing.race_inertia[1];
  inertia.mass = 1.0;
  inertia.moments.setConstant(kc * arm * arm);
  inertia.geometric_centre = Vec3(0.0, 0.0, arm);
  scene.bearing.gravity = Vec3(0.0, 0.0, -g);
  bearing::FreeRace race;
  race.translation_held = {true, true, true};
  race.rotation_held = {false, true, true};
  scene.plan.race_motions.free[1] = race;
  scene.plan.suppressed.element_all = true;
  scene.have({scene::Effect::Gravity, scene::Effect::FreeRaces});
  Motion pendulum(std::move(scene));
  const Quat turned = quaternion_about(Vec3::UnitX(), theta0);
  const Vec3 centre = rotation_matrix(turned) * Vec3(0.0, 0.0, -arm);
  for (int k = 0; k < 3; ++k)
    pendulum.start_of("inner race.position", static_cast<std::size_t>(k)) = centre[k];
  for (std::size_t k = 0; k < 4; ++k) pendulum.start_of("inner race.quaternion", k) = turned[k];
  pendulum.scale("inner race.position", arm);
  pendulum.scale("inner race.velocity", arm * theta0 * omega);
  pendulum.scale("inner race.omega", theta0 * omega);
  pendulum.scale("inner race.rotation", theta0);
  const int turn = pendulum.at("inner race.rotation"), rate = pendulum.at("inner race.omega");
  Problem problem = pendulum.problem();
  problem.events = {[=](double, const double* y) { return y[rate]; },
                    [=](double, const double* y) { return theta0 + y[turn]; }};
  int turns = 0;
  problem.at_event = [&](int event, double, const State&) { return event == 0 && ++turns == 2; };
  const Solution solution = pendulum.solve(problem, std::vector<double>{0.0, 100 / omega});
  Json result = {{"small_amplitude_angular_frequency", omega}};
  for (const Event& event : solution.events) {
    if (event.index == 0)
      result["period"] = event.t;
    else if (!result.contains("max_orbital_rate"))
      result["max_orbital_rate"] = std::abs(event.y[static_cast<std::size_t>(rate)]);
  }
  pendulum.add_evaluation_record(result);
  return result;
}

/// Heat and work by the plates are integrals.
Json lubricated_plates(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  const bearing::TractionCurve curve = traction_law(in.at("law"));
  PlateMotion body(get(in, "mass"), get(in, "inertia"),
                   {get(in, "radius"),
                    {get(in, "N_top"), get(in, "N_bottom")},
                    {get(in, "V_top"), get(in, "V_bottom")},
                    curve},
                   get(in, "v0"), get(in, "omega0"));
  Problem problem = body.motion.problem();
  for (const std::size_t k : {0UL, 1UL}) {
    problem.events.emplace_back([&, k](double, const double* y) { return body.slip(k, y); });
    if (curve.form == bearing::TractionCurve::Form::TwoSlope)
      problem.events.emplace_back(
          [&, k](double, const double* y) { return std::abs(body.slip(k, y)) - curve.u0; });
  }
  const Solution solution = body.motion.solve(problem, sample_times(the_case));
  Json top = Json::array(), bottom = Json::array();
  for (const State& y : solution.samples) {
    top.push_back(body.slip(0, y.data()));
    bottom.push_back(body.slip(1, y.data()));
  }
  const auto channel = [&](const char* name) { return solution.channel(body.motion.at(name)); };
  Json result = {{"t", sample_times(the_case)},
                 {"v", channel("element.x_dot")},
                 {"omega", channel("element.omega_theta")},
                 {"slip_top", top},
                 {"slip_bottom", bottom},
                 {"heat_top", channel("heat top")},
                 {"heat_bottom", channel("heat bottom")},
                 {"work_by_plates", channel("work")},
                 {"closed_form_slip_top", top}};
  body.motion.add_evaluation_record(result);
  return result;
}

// ---- unit tests of the integrators: contacts that stick or roll without any slip, which the
// solver's friction laws have only as limits. FO01, FO03, dyn2_coulomb_roller_symmetric and
// dyn2_coulomb_ball_bottom_fixed.

void add_evaluation_record(Json& result, const Problem& problem) {
  result["evaluation"] = {{"entry", "adore::integrators::Stepper::step"},
                          {"stepper", problem.stepper}};
}

/// FO: element dragged by the rotating inner race while it rolls on the fixed outer race.
Json orbit_spin_up(const Json& in) {
  const double m = get(in, "mass"), R = get(in, "radius"), r_m = get(in, "pitch_radius");
  const double I = get(in, "inertia_coefficient") * m * R * R, speed = get(in, "inner_speed");
  const double friction =
      sign(speed) * get(in, "friction_coefficient") * get(in, "inner_normal_force");
  // m r_m ω_m' = friction + T, I r_m ω_m'/R = R (friction - T), T along the motion.
  const double acceleration = 2 * friction / (r_m * (m + I / (R * R)));
  const auto slip = [=](const double* y) { return speed * (r_m - R) - 2 * y[0] * r_m; };
  Rates rates({std::abs(speed), std::abs(friction * r_m)}, [=](const double* y, double* d) {
    d[0] = acceleration;
    d[1] = friction * slip(y);
  });
  Problem problem{rates, {0.0, 0.0}};
  problem.events = {[=](double, const double* y) { return slip(y); }};
  problem.at_event = [](int, double, const State&) { return true; };
  const Solution solution = solve(problem, std::vector<double>{0.0, speed / acceleration});
  const Event& end = solution.events.at(0);
  Json result = {{"orbital_acceleration", acceleration},
                 {"outer_tangential_force", m * r_m * acceleration - friction},
                 {"final_orbital_speed", end.y[0]},
                 {"final_spin_speed_absolute", end.y[0] * r_m / R},
                 {"time_to_rolling", end.t},
                 {"slip_work", end.y[1]}};
  add_evaluation_record(result, problem);
  return result;
}

/// Coulomb friction on both plates: a contact whose slip is zero sticks when the force that keeps
/// it so is within μN. State v, ω, heat.
Json coulomb_plates(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  const double m = get(in, "mass"), R = get(in, "radius"), I = get(in, "inertia");
  const std::array<double, 2> limit{get(in, "mu") * get(in, "N_top"),
                                    get(in, "mu") * get(in, "N_bottom")};
  const Plates plates{R, limit, {get(in, "V_top"), get(in, "V_bottom")}, {}};
  const double speed = std::max(std::abs(plates.speed[0]), std::abs(plates.speed[1]));
  std::array<double, 2> force{};
  std::array<bool, 2> sticks{};
  const auto slip = [&](std::size_t k, const double* y) { return plates.slip(k, y[0], y[1]); };
  const auto set_forces = [&](const double* y) {
    for (const std::size_t k : {0UL, 1UL}) {
      sticks[k] = sticks[k] || std::abs(slip(k, y)) <= 1e-12 * speed;
      force[k] = sticks[k] ? 0.0 : limit[k] * sign(slip(k, y));
    }
    const double same = 1 / m + R * R / I, cross = 1 / m - R * R / I;  // slip rate of a unit force
    for (const std::size_t k : {0UL, 1UL})
      if (sticks[k] && !sticks[1 - k])
        force[k] = std::clamp(-force[1 - k] * cross / same, -limit[k], limit[k]);
  };
  const auto acceleration = [&] { return (force[0] + force[1]) / m; };
  const auto spin_up = [&] { return R * (force[1] - force[0]) / I; };
  Rates rates({speed, speed / R, m * speed * speed}, [&](const double* y, double* d) {
    d[0] = acceleration();
    d[1] = spin_up();
    d[2] = (sticks[0] ? 0.0 : force[0] * slip(0, y)) + (sticks[1] ? 0.0 : force[1] * slip(1, y));
  });
  Problem problem{rates, {get(in, "v0"), get(in, "omega0"), 0.0}};
  set_forces(problem.start.data());
  const std::vector<double> times = sample_times(the_case);
  Json result = {{"acceleration", acceleration()},
                 {"angular_acceleration", spin_up()},
                 {"bottom_sticking_force", force[1]}};
  for (const std::size_t k : {0UL, 1UL})
    problem.events.emplace_back(
        [&, k](double, const double* y) { return sticks[k] ? 1.0 : slip(k, y); });
  problem.at_event = [&](int event, double t, const State& y) {
    sticks[static_cast<std::size_t>(event)] = true;
    set_forces(y.data());
    result["time_to_rolling"] = t;
    result["total_heat"] = y[2];
    return false;
  };
  const Solution solution = solve(problem, times);
  result["t"] = times;
  result["v"] = solution.channel(0);
  result["omega"] = solution.channel(1);
  for (const State& y : solution.samples)
    for (const std::size_t k : {0UL, 1UL})
      result[k == 0 ? "slip_top" : "slip_bottom"].push_back(slip(k, y.data()));
  add_evaluation_record(result, problem);
  return result;
}

}  // namespace

std::optional<Json> evaluate_closed_form_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  if (in.contains("preload")) return between_races(in);
  if (in.contains("K") && in.contains("speed")) return mass_impact(in);
  if (in.contains("inertia") && in.contains("omega0")) return free_rotation(the_case);
  if (in.contains("v0") && in.contains("normal_force")) return slide_to_rolling(in);
  if (in.contains("inner_normal_force")) return orbit_spin_up(in);
  if (in.contains("theta0") && in.contains("race_radius")) return rolling_pendulum(in);
  return std::nullopt;
}

std::optional<Json> evaluate_impact_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  const double mass = get(in, "mass"), K = get(in, "K"), speed = get(in, "impact_velocity");
  const std::vector<double> times = sample_times(the_case);
  Json result;
  Impact hit;
  if (in.contains("groove_factor")) {
    // The race that the case describes has the Hertz constant that it states.
    const double D = get(in, "D"), f = get(in, "groove_factor"), dm = get(in, "pitch_diameter");
    SmallScene scene;
    set_grooves(scene, D, {f, kWideFactor},
                {0.5 * dm - (f - 0.5) * D, 0.5 * dm - kInnerGap + (kWideFactor - 0.5) * D},
                D * std::cos(get(in, "contact_angle")) / dm);
    scene.bearing.element_inertia.mass = mass;
    for (bearing::Material* steel :
         {&scene.bearing.element_material, &scene.bearing.race_material[0]}) {
      steel->elastic_modulus = get(in, "E");
      steel->poisson_ratio = get(in, "nu");
    }
    scene.have({scene::Effect::RaceContact});
    hit = impact(std::move(scene), K, 0.5 * dm, speed, times, result);
  } else {
    hit = impact_of(mass, K, speed, times, result);
  }
  result.update(Json{{"max_approach", hit.max_approach},
                     {"peak_force", hertz_load(K, hit.max_approach)},
                     {"contact_duration", hit.duration},
                     {"time_of_peak", hit.time_of_peak},
                     {"rebound_velocity", hit.rebound},
                     {"impulse", mass * (speed - hit.rebound)},
                     {"duration_constant", hit.duration * speed / hit.max_approach},
                     {"t", times},
                     {"approach", hit.approach},
                     {"velocity", hit.velocity},
                     {"force", hit.force}});
  return result;
}

std::optional<Json> evaluate_plates_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  if (in.contains("mu")) return coulomb_plates(the_case);
  if (in.contains("law")) return lubricated_plates(the_case);
  return std::nullopt;
}

}  // namespace adore::validation
