#include "base/symmetric_eigen.hpp"
#include "reference/ball_scenario.hpp"
#include "reference/scenarios.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

/// dynamics_ball_vibration, dynamics_ball_thrust and dynamics_ball_radial.
namespace adore::reference {
namespace {

/// Channels of one ball at one state, as families 3 and 4 name them.
Json ball_channels(BallBetweenRaces& ball, const State& y) {
  const auto [o, i] = ball.loads(y.data());
  const auto spin_to_roll = [](const BallLoad& load) {
    return load.contact.motion.W_n / load.contact.motion.W_c;
  };
  return {{"Q_o", o.Q},
          {"Q_i", i.Q},
          {"alpha_o", o.contact.angle},
          {"alpha_i", i.contact.angle},
          {"orbital_speed", y[5]},
          {"x", y[0]},
          {"r", y[1]},
          {"omega_x", y[6]},
          {"omega_r", y[7]},
          {"omega_theta", y[8]},
          {"spin_to_roll_o", spin_to_roll(o)},
          {"spin_to_roll_i", spin_to_roll(i)},
          {"heat_o", o.heat},
          {"heat_i", i.heat}};
}

/// Slip at the middle of the ellipse.
std::array<double, 2> slip_centre(const BallLoad& load) {
  const tribology::EllipseKinematics& k = load.contact.motion;
  const double h = load.contact.ellipse.h0;
  return {k.u_c + k.W_t * h, k.u_t - k.W_c * h};
}

Json steady_channels(BallBetweenRaces& ball, const State& y) {
  Json result = ball_channels(ball, y);
  const auto loads = ball.loads(y.data());
  for (std::size_t j = 0; j < 2; ++j) {
    const std::string side = j == 0 ? "_o" : "_i";
    const BallLoad& load = loads[j];
    result["traction_rolling" + side] = load.traction.F_t;
    result["traction_transverse" + side] = load.traction.F_c;
    result["moment_normal" + side] = load.traction.M_n;
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

State mechanical_state(const Json& s) {
  return {get(s, "x"),       get(s, "r"),       get(s, "theta"),
          get(s, "x_dot"),   get(s, "r_dot"),   get(s, "theta_dot"),
          get(s, "omega_x"), get(s, "omega_r"), get(s, "omega_theta")};
}

/// Enough for 2e-7 of the traction: an exponential law is steeper at slip reversal than a two-slope
/// law without A.
int rule_points(const Json& in) {
  return in.at("traction_law").at("type") == "exponential" ? 24 : 16;
}

Json thrust_run(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  BallBetweenRaces ball(in, Vec3(get(in.at("static"), "inner_groove_centre_x"), 0, 0), true);
  ball.set_rule(split_rule(rule_points(in)));
  const State start = mechanical_state(in.at("initial_state"));
  Problem problem = ball.problem(start);
  problem.tolerance = 1e-10;
  problem.stepper = "pece8";  // two evaluations of the contact ellipses per step
  const auto times = sample_times(the_case);
  const Solution solution = solve(problem, times);
  Json result = {{"t", times},
                 {"theta", solution.channel(2)},
                 {"heat_energy_total_o", solution.channel(9)},
                 {"heat_energy_total_i", solution.channel(10)},
                 {"work_by_inner_race", solution.channel(11)}};
  for (const State& y : solution.samples) {
    const Json now = ball_channels(ball, y);
    for (const auto& [key, value] : now.items()) result[key].push_back(value);
  }
  ball.set_rule(split_rule(32));
  const State steady = ball.steady_state(solution.samples.back());
  result["steady_state"] = steady_channels(ball, steady);
  const Json* expected = the_case.contains("expected") ? &the_case["expected"] : nullptr;
  if (expected && expected->contains("steady_state"))
    add_eigenvalues(ball.eigenvalues(steady), (*expected)["steady_state"], result["steady_state"]);
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
  conventions.push_back({"curved_edge_tilted", "curved_edge", tangent_plane()});
  conventions.push_back(
      {"flat_undeformed_minor_axis_ignored", "flat_undeformed", minor_axis_ignored()});
  conventions.push_back({"curved_edge_minor_axis_ignored", "curved_edge", minor_axis_ignored()});
  BallBetweenRaces ball(base, Vec3(get(base.at("static"), "inner_groove_centre_x"), 0, 0), true);
  Json result;
  for (const Convention& convention : conventions) {
    ball.set_surface(contact_surface(convention.surface));
    ball.set_rule(convention.rule);
    const State start =
        ball.rolling_start(get(base.at("initial_state"), "x"), get(base.at("initial_state"), "r"));
    Problem problem = ball.problem(start);
    problem.tolerance = 1e-10;
    problem.stepper = "pece8";
    const Solution solution = solve(problem, std::vector<double>{0.0, 1e-3});
    result[convention.name] = {
        {"initial_theta_dot", start[5]},
        {"initial_omega_x", start[6]},
        {"initial_omega_r", start[7]},
        {"at_1ms", ball_channels(ball, solution.samples.back())},
        {"steady", ball_channels(ball, ball.steady_state(solution.samples.back()))}};
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
  BallBetweenRaces ball(in, Vec3(get(in, "inner_groove_centre_x"), 0, 0), false);
  const double td = get(in, "orbital_speed_at_equilibrium"), m = ball.mass();
  State start = {
      get(in.at("equilibrium"), "x"), get(in.at("equilibrium"), "r"), 0, 0, 0, td, 0, 0, 0};
  const auto loads = ball.loads(start.data());
  Eigen::Matrix2d K = Eigen::Matrix2d::Zero();
  for (std::size_t j = 0; j < 2; ++j) {
    const dynamics::RaceContactState& c = loads[j].contact;
    const Eigen::Vector2d n(c.n[0], c.n[2]);  // at θ = 0 the radial direction is z
    const double l = c.approach + ball.model(j).groove.offset[j];
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
  start[0] += get(in.at("initial_offset"), "x");
  start[1] += get(in.at("initial_offset"), "r");
  start[5] = td * std::pow(get(in.at("equilibrium"), "r") / start[1], 2);
  const double bin =
      the_case.value("expected", Json::object()).value("fft_bin_Hz", frequency[0] / 128);
  const double dt = 0.05 / frequency[1];
  std::vector<double> times;
  for (std::size_t n = 0; static_cast<double>(n) * dt < 1 / bin; ++n)
    times.push_back(static_cast<double>(n) * dt);
  Problem problem = ball.problem(start);
  problem.scales[0] = problem.scales[1] = 1e-9;
  problem.scales[3] = problem.scales[4] = 1e-4;
  problem.tolerance = 1e-9;
  const Solution solution = solve(problem, times);
  Json peaks = Json::array(), fitted = Json::array();
  for (int k = 0; k < 2; ++k) {
    // Modal coordinate of mode k: a nearly pure sine, its frequency from the zero crossings.
    std::vector<double> modal;
    for (const State& y : solution.samples)
      modal.push_back(shapes(0, k) * (y[0] - get(in.at("equilibrium"), "x")) +
                      shapes(1, k) * (y[1] - get(in.at("equilibrium"), "r")));
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
  const Json& shift = in.at("inner_race_displacement");
  const auto times = sample_times(the_case);
  BallBetweenRaces ball(in, Vec3(get(shift, "x"), get(shift, "y"), get(shift, "z")), true);
  Json result = {{"t", times}};
  std::vector<Vec3> force(times.size(), Vec3::Zero());
  std::vector<double> torque(times.size(), 0.0);
  for (const Json& initial : in.at("initial_states")) {
    const Vec3 p = vec3(initial.at("position")), v = vec3(initial.at("velocity")),
               w = vec3(initial.at("omega"));
    const double theta = azimuth(p);
    const Vec3 e_r = radial_direction(theta), e_t = circumferential_direction(theta);
    const double r = p.dot(e_r);
    Problem problem = ball.problem(
        {p[0], r, theta, v[0], v.dot(e_r), v.dot(e_t) / r, w[0], w.dot(e_r), w.dot(e_t)});
    problem.tolerance = 3e-10;
    problem.stepper = "pece8";
    const Solution solution = solve(problem, times);
    Json rows;
    for (std::size_t k = 0; k < times.size(); ++k) {
      const State& y = solution.samples[k];
      const auto [o, i] = ball.loads(y.data());
      rows["Q_outer"].push_back(o.Q);
      rows["Q_inner"].push_back(i.Q);
      rows["alpha_outer"].push_back(o.contact.angle);
      force[k] -= i.force;
      torque[k] -= (i.contact.arm.cross(i.force) + i.moment)[0];
    }
    rows["x"] = solution.channel(0);
    rows["r"] = solution.channel(1);
    rows["theta"] = solution.channel(2);
    rows["orbital_speed"] = solution.channel(5);
    rows["omega_x"] = solution.channel(6);
    rows["omega_r"] = solution.channel(7);
    rows["omega_theta"] = solution.channel(8);
    rows["heat_energy_outer"] = solution.channel(9);
    rows["heat_energy_inner"] = solution.channel(10);
    for (const auto& [key, value] : rows.items()) result[key].push_back(value);
  }
  for (const Vec3& f : force) result["force_on_inner_race_xyz"].push_back(json(f));
  result["torque_x_on_inner_race"] = torque;
  return result;
}

}  // namespace

std::optional<Json> vibration_case(const Json& the_case) {
  if (!the_case.at("inputs").contains("initial_offset")) return std::nullopt;
  return vibration(the_case);
}

std::optional<Json> thrust_case(const Json& the_case) {
  if (the_case.contains("base_case")) return convention_table(the_case);
  if (!the_case.at("inputs").contains("initial_state")) return std::nullopt;
  return thrust_run(the_case);
}

std::optional<Json> radial_case(const Json& the_case) {
  if (!the_case.at("inputs").contains("initial_states")) return std::nullopt;
  return radial_run(the_case);
}

}  // namespace adore::reference
