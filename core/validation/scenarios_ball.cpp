#include "base/errors.hpp"
#include "base/symmetric_eigen.hpp"
#include "validation/ball_scenario.hpp"
#include "validation/scenarios.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

/// dynamics_ball_vibration, dynamics_ball_thrust and dynamics_ball_radial.
namespace adore::validation {
namespace {

/// Channels of one ball at one state, as families 3 and 4 name them.
Json ball_channels(Motion& ball, const State& y) {
  const dynamics::Evaluation& e = ball.evaluate(0.0, y.data());
  const auto value = [&](const char* name) { return y[static_cast<std::size_t>(ball.at(name))]; };
  Json result = {{"orbital_speed", value("element.theta_dot")}};
  for (const char* key : {"x", "r", "omega_x", "omega_r", "omega_theta"})
    result[key] = value(("element." + std::string(key)).c_str());
  for (const std::size_t j : {0UL, 1UL}) {
    const std::string side = j == 0 ? "_o" : "_i";
    const BallLoad load = ball_load(ball, e, j);
    result["Q" + side] = load.Q;
    result["alpha" + side] = load.contact.angle;
    result["heat" + side] = load.heat;
    result["spin_to_roll" + side] = load.contact.motion.W_n / load.contact.motion.W_c;
  }
  return result;
}

/// Slip at the middle of the ellipse.
std::array<double, 2> slip_centre(const BallLoad& load) {
  const tribology::EllipseKinematics& k = load.contact.motion;
  const double h = load.contact.ellipse.h0;
  return {k.u_c + k.W_t * h, k.u_t - k.W_c * h};
}

Json steady_channels(Motion& ball, const State& y, const TractionRule& rule) {
  Json result = ball_channels(ball, y);
  const dynamics::Evaluation& e = ball.evaluate(0.0, y.data());
  for (const std::size_t j : {0UL, 1UL}) {
    const std::string side = j == 0 ? "_o" : "_i";
    const BallLoad load = ball_load(ball, e, j);
    const tribology::EllipseTraction traction = rule(ball.race(j).law, load.contact, 0.0).in_plane;
    result["traction_rolling" + side] = traction.F_t;
    result["traction_transverse" + side] = traction.F_c;
    result["moment_normal" + side] = traction.M_n;
    result["slip_centre_transverse" + side] = slip_centre(load)[0];
    result["slip_centre_rolling" + side] = slip_centre(load)[1];
  }
  return result;
}

/// Puts the computed eigenvalues into the order of a given list: each takes the nearest one left.
void add_eigenvalues(std::vector<std::complex<double>> values, const Json& expected, Json& steady) {
  double largest = -std::numeric_limits<double>::infinity();
  for (const auto& value : values) largest = std::max(largest, value.real());
  steady["max_real_part"] = largest;
  Json real = Json::array(), imag = Json::array();
  for (std::size_t k = 0; k < expected.at("eigenvalues_real").size() && !values.empty(); ++k) {
    const std::complex<double> wanted(expected["eigenvalues_real"][k].get<double>(),
                                      expected["eigenvalues_imag"][k].get<double>());
    const auto nearest = std::min_element(
        values.begin(), values.end(),
        [&](const auto& a, const auto& b) { return std::abs(a - wanted) < std::abs(b - wanted); });
    real.push_back(nearest->real());
    imag.push_back(nearest->imag());
    values.erase(nearest);
  }
  steady["eigenvalues_real"] = real;
  steady["eigenvalues_imag"] = imag;
}

/// Enough for 2e-7 of the traction: an exponential law is steeper at slip reversal than a two-slope
/// law without A.
int rule_points(const Json& in) {
  return in.at("traction_law").at("type") == "exponential" ? 24 : 16;
}

/// @throws InputError where a ball starts deeper in a race than any elastic contact
void check_start(Motion& balls, const std::string& input, double diameter) {
  try {
    (void)balls.evaluate(0.0, balls.start.data());
  } catch (const SolverError& error) {
    throw InputError(
        fmt::format("{}: the start state is impossible in this bearing ({}). Correct {} or the "
                    "input \"derived\".",
                    input, error.what(), input));
  }
  const dynamics::Evaluation& e = balls.evaluate(0.0, balls.start.data());
  for (const std::size_t j : {0UL, 1UL})
    for (std::size_t i = 0; i < e.elements.n; ++i) {
      const double depth = ball_load(balls, e, j, i).contact.approach;
      require(depth <= 0.01 * diameter,
              fmt::format("{}: ball {} overlaps the {} race by {:.4g} m, more than 1 % of D = "
                          "{:.4g} m. Enter a position between the races.",
                          input, i, j == 0 ? "outer" : "inner", depth, diameter));
    }
}

Json thrust_run(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  SmallScene scene =
      ball_scene(in, Vec3(get(in.at("static"), "inner_groove_centre_x"), 0, 0), true, 1);
  const auto rule = install_converged_traction(scene, split_rule(rule_points(in)));
  add_heat_integrals(scene, 1);
  Motion ball(std::move(scene));
  for (const char* key :
       {"x", "r", "theta", "x_dot", "r_dot", "theta_dot", "omega_x", "omega_r", "omega_theta"})
    ball.start_of("element." + std::string(key)) = get(in.at("initial_state"), key);
  check_start(ball, "initial_state", get(in.at("bearing"), "D"));
  set_ball_error_scales(ball);
  Problem problem = ball.problem();
  problem.tolerance = 1e-10;
  problem.stepper = "pece8";  // two evaluations of the contact ellipses per step
  problem.longest_step = 2e-5;
  const auto times = sample_times(the_case);
  const Solution solution = ball.solve(problem, times);
  Json result = {{"t", times},
                 {"theta", solution.channel(ball.at("element.theta"))},
                 {"heat_energy_total_o", solution.channel(ball.at(heat_integral_name(0, 0)))},
                 {"heat_energy_total_i", solution.channel(ball.at(heat_integral_name(1, 0)))},
                 {"work_by_inner_race", solution.channel(ball.at("inner race.work"))}};
  for (const State& y : solution.samples) {
    const Json now = ball_channels(ball, y);
    for (const auto& [key, value] : now.items()) result[key].push_back(value);
  }
  *rule = split_rule(32);
  const State steady = steady_state(ball, solution.samples.back());
  result["steady_state"] = steady_channels(ball, steady, *rule);
  const Json* expected = the_case.contains("expected") ? &the_case["expected"] : nullptr;
  if (expected && expected->contains("steady_state"))
    add_eigenvalues(eigenvalues(ball, steady), (*expected)["steady_state"], result["steady_state"]);
  ball.add_evaluation_record(result);
  return result;
}

/// The same bearing under other conventions of the contact surface; `base_case` is the case that
/// the inputs name.
Json convention_table(const Json& the_case) {
  const Json& base = the_case.at("base_case").at("inputs");
  struct Convention {
    const char* name;
    const char* surface;
    TractionRule rule;
  };
  std::vector<Convention> conventions;
  for (const char* surface : {"flat_undeformed", "curved_edge", "flat_half", "curved_half",
                              "curved_undeformed", "flat_edge"})
    conventions.push_back({surface, surface, split_rule(16)});
  conventions.push_back({"curved_edge_tilted", "curved_edge", tangent_plane_rule()});
  conventions.push_back(
      {"flat_undeformed_minor_axis_ignored", "flat_undeformed", minor_axis_ignored_rule()});
  conventions.push_back(
      {"curved_edge_minor_axis_ignored", "curved_edge", minor_axis_ignored_rule()});
  Json result;
  for (const Convention& convention : conventions) {
    SmallScene scene =
        ball_scene(base, Vec3(get(base.at("static"), "inner_groove_centre_x"), 0, 0), true, 1);
    scene.options.surface = contact_surface(convention.surface);
    (void)install_converged_traction(scene, convention.rule);
    Motion ball(std::move(scene));
    ball.start =
        rolling_start(ball, get(base.at("initial_state"), "x"), get(base.at("initial_state"), "r"));
    set_ball_error_scales(ball);
    const auto started = [&](const char* group) {
      return ball.start[static_cast<std::size_t>(ball.at(group))];
    };
    Problem problem = ball.problem();
    problem.tolerance = 1e-10;
    problem.stepper = "pece8";
    problem.longest_step = 2e-5;
    const Solution solution = ball.solve(problem, std::vector<double>{0.0, 1e-3});
    result[convention.name] = {
        {"initial_theta_dot", started("element.theta_dot")},
        {"initial_omega_x", started("element.omega_x")},
        {"initial_omega_r", started("element.omega_r")},
        {"at_1ms", ball_channels(ball, solution.samples.back())},
        {"steady", ball_channels(ball, steady_state(ball, solution.samples.back()))}};
    ball.add_evaluation_record(result);
  }
  return result;
}

// ---- free vibration

/// Largest line of the discrete Fourier transform near `frequency`, at multiples of `bin`.
double peak_line(const std::vector<double>& signal, double dt, double bin, double frequency) {
  double best = 0.0, where = 0.0;
  const long middle = std::lround(frequency / bin);
  for (long k = std::max(middle - 5, 1L); k <= middle + 5; ++k) {
    double re = 0.0, im = 0.0;
    for (std::size_t n = 0; n < signal.size(); ++n) {
      const double phase = 2 * kPi * static_cast<double>(k) * bin * dt * static_cast<double>(n);
      re += signal[n] * std::cos(phase);
      im += signal[n] * std::sin(phase);
    }
    if (re * re + im * im <= best) continue;
    best = re * re + im * im;
    where = static_cast<double>(k) * bin;
  }
  return where;
}

Json vibration(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  Motion ball(ball_scene(in, Vec3(get(in, "inner_groove_centre_x"), 0, 0), false, 1));
  const double td = get(in, "orbital_speed_at_equilibrium"), m = ball.mass();
  const auto x = static_cast<std::size_t>(ball.at("element.x")),
             r = static_cast<std::size_t>(ball.at("element.r")),
             theta_dot = static_cast<std::size_t>(ball.at("element.theta_dot"));
  State& start = ball.start;
  start[x] = get(in.at("equilibrium"), "x");
  start[r] = get(in.at("equilibrium"), "r");
  start[theta_dot] = td;
  const dynamics::Evaluation& e = ball.evaluate(0.0, start.data());
  const std::array loads{ball_load(ball, e, 0), ball_load(ball, e, 1)};
  require(loads[0].Q > 0.0 && loads[1].Q > 0.0,
          "\"equilibrium\": a ball at this x and r does not touch both races, so it cannot vibrate "
          "about this position. Enter \"bearing\", \"derived\" and \"inner_groove_centre_x\" of "
          "the same bearing.");
  Eigen::Matrix2d K = Eigen::Matrix2d::Zero();
  for (std::size_t j = 0; j < 2; ++j) {
    const dynamics::RaceContactState& c = loads[j].contact;
    const Eigen::Vector2d n(c.n[0], c.n[2]);  // at θ = 0 the radial direction is z
    const double l = c.approach + ball.race(j).groove.offset[j];
    K += 1.5 * loads[j].Q / c.approach * n * n.transpose() +
         loads[j].Q / l * (Eigen::Matrix2d::Identity() - n * n.transpose());
  }
  K(1, 1) += 3 * m * td * td;
  const SymmetricEigen<2> modes = symmetric_eigen<2>(K);
  Json result = {{"Q_o", loads[0].Q},
                 {"Q_i", loads[1].Q},
                 {"alpha_o", loads[0].contact.angle},
                 {"alpha_i", loads[1].contact.angle},
                 {"stiffness_matrix_x_r", {{K(0, 0), K(0, 1)}, {K(1, 0), K(1, 1)}}}};
  std::array<double, 2> frequency{};
  Eigen::Matrix2d shapes = modes.vectors;
  for (int k = 0; k < 2; ++k) {
    frequency[static_cast<std::size_t>(k)] = std::sqrt(modes.values[k] / m) / (2 * kPi);
    if (shapes(1, k) < 0.0) shapes.col(k) *= -1.0;
  }
  result["natural_frequencies_Hz"] = frequency;
  result["mode_shapes_columns"] = {{shapes(0, 0), shapes(0, 1)}, {shapes(1, 0), shapes(1, 1)}};

  // The free motion: r² θ' is conserved from the equilibrium.
  start[x] += get(in.at("initial_offset"), "x");
  start[r] += get(in.at("initial_offset"), "r");
  start[theta_dot] = td * std::pow(get(in.at("equilibrium"), "r") / start[r], 2);
  const double bin =
      the_case.value("expected", Json::object()).value("fft_bin_Hz", frequency[0] / 128);
  const double dt = 0.05 / frequency[1];
  std::vector<double> times;
  for (std::size_t n = 0; static_cast<double>(n) * dt < 1 / bin; ++n)
    times.push_back(static_cast<double>(n) * dt);
  set_ball_error_scales(ball);
  for (const char* group : {"element.x", "element.r"}) ball.scale(group, 1e-9);
  for (const char* group : {"element.x_dot", "element.r_dot"}) ball.scale(group, 1e-4);
  Problem problem = ball.problem();
  problem.tolerance = 1e-9;
  problem.longest_step = 2e-5;
  const Solution solution = ball.solve(problem, times);
  ball.add_evaluation_record(result);
  Json peaks = Json::array(), fitted = Json::array();
  for (int k = 0; k < 2; ++k) {
    // Modal coordinate of mode k: a nearly pure sine, its frequency from the zero crossings.
    std::vector<double> modal;
    for (const State& y : solution.samples)
      modal.push_back(shapes(0, k) * (y[x] - get(in.at("equilibrium"), "x")) +
                      shapes(1, k) * (y[r] - get(in.at("equilibrium"), "r")));
    const double f = frequency[static_cast<std::size_t>(k)];
    peaks.push_back(peak_line(modal, dt, bin, f));
    // Phase advance over the run at the linear frequency, Hann window on two halves.
    const auto phase = [&](std::size_t from, std::size_t to) {
      std::complex<double> sum = 0.0;
      for (std::size_t n = from; n < to; ++n) {
        const double w =
            1 - std::cos(2 * kPi * static_cast<double>(n - from) / static_cast<double>(to - from));
        sum += w * modal[n] * std::polar(1.0, -2 * kPi * f * dt * static_cast<double>(n));
      }
      return std::arg(sum);
    };
    const std::size_t half = modal.size() / 2;
    const double advance = std::remainder(phase(half, 2 * half) - phase(0, half), 2 * kPi);
    fitted.push_back(f + advance / (2 * kPi * dt * static_cast<double>(half)));
  }
  result["fft_peak_Hz"] = peaks;
  result["fitted_frequencies_Hz"] = fitted;
  return result;
}

// ---- displaced inner race, several balls

Json radial_run(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  const Json &shift = in.at("inner_race_displacement"), &initial = in.at("initial_states");
  const auto times = sample_times(the_case);
  const std::size_t n = initial.size();
  SmallScene scene = ball_scene(in, Vec3(get(shift, "x"), get(shift, "y"), get(shift, "z")), true,
                                static_cast<int>(n));
  // This family asks for 1e-5: the run's rule with more nodes has it.
  scene.options.ellipse_major = 200;
  scene.options.ellipse_minor = 64;
  add_heat_integrals(scene, static_cast<int>(n));
  Motion balls(std::move(scene));
  for (std::size_t i = 0; i < n; ++i)
    balls.place(i, vec3(initial[i].at("position")), vec3(initial[i].at("velocity")),
                vec3(initial[i].at("omega")));
  check_start(balls, "initial_states", get(in.at("bearing"), "D"));
  set_ball_error_scales(balls);
  Problem problem = balls.problem();
  problem.tolerance = 3e-10;
  problem.stepper = "pece8";
  problem.longest_step = 2e-5;
  const Solution solution = balls.solve(problem, times);
  Json result = {{"t", times}};
  for (const State& y : solution.samples) {
    const auto component = [&](const std::string& group, std::size_t i = 0) {
      return y[static_cast<std::size_t>(balls.at(group)) + i];
    };
    const dynamics::Evaluation& e = balls.evaluate(0.0, y.data());
    result["force_on_inner_race_xyz"].push_back(json(e.race[1].force));
    result["torque_x_on_inner_race"].push_back(e.race[1].moment[0]);
    const auto keep = [&](const char* key, std::size_t i, double value) {
      if (!result.contains(key)) result[key] = Json(n, Json::array());
      result[key][i].push_back(value);
    };
    for (std::size_t i = 0; i < n; ++i) {
      const BallLoad outer = ball_load(balls, e, 0, i);
      keep("Q_outer", i, outer.Q);
      keep("Q_inner", i, e.load[1][i]);
      keep("alpha_outer", i, outer.contact.angle);
      for (const char* key : {"x", "r", "theta", "omega_x", "omega_r", "omega_theta"})
        keep(key, i, component("element." + std::string(key), i));
      keep("orbital_speed", i, component("element.theta_dot", i));
      keep("heat_energy_outer", i, component(heat_integral_name(0, i)));
      keep("heat_energy_inner", i, component(heat_integral_name(1, i)));
    }
  }
  balls.add_evaluation_record(result);
  return result;
}

}  // namespace

std::optional<Json> evaluate_vibration_case(const Json& the_case) {
  if (!the_case.at("inputs").contains("initial_offset")) return std::nullopt;
  return vibration(the_case);
}

std::optional<Json> evaluate_thrust_case(const Json& the_case) {
  if (the_case.contains("base_case")) return convention_table(the_case);
  if (!the_case.at("inputs").contains("initial_state")) return std::nullopt;
  return thrust_run(the_case);
}

std::optional<Json> evaluate_radial_case(const Json& the_case) {
  if (!the_case.at("inputs").contains("initial_states")) return std::nullopt;
  return radial_run(the_case);
}

}  // namespace adore::validation
