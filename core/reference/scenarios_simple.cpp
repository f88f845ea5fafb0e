#include "contact/hertz.hpp"
#include "dynamics/rigid_body.hpp"
#include "reference/adapter.hpp"
#include "reference/scenarios.hpp"
#include "reference/trajectory.hpp"
#include "tribology/traction_curve.hpp"

#include <nlohmann/json.hpp>

/// F_dynamics, dynamics_impact and dynamics_plates: one or two degrees of freedom, integrated with
/// located events.
namespace adore::reference {
namespace {

using contact::hertz_load;

double sign(double u) { return (u > 0.0) - (u < 0.0); }

// ---- Hertz impact

struct Impact {
  double max_approach = 0.0, time_of_peak = 0.0, duration = 0.0, rebound = 0.0;
  Solution solution;
};

/// The acceleration starts like t^1.5, a rate that depends on time alone: the higher Fehlberg pairs
/// do not see its error.
constexpr const char* kSeesTimeErrors = "rkf4";

/// m d'' = -K d^1.5 from d = 0 with speed v (below 0: it leaves, and nothing touches); sampled at
/// `times` (may be empty).
Impact impact(double mass, double K, double speed, std::vector<double> times) {
  const double size = std::pow(mass * speed * speed / K, 0.4), time = size / std::abs(speed);
  const std::size_t samples = times.size();
  if (times.empty()) times.push_back(0.0);
  times.push_back(std::max(5 * time, 1.01 * times.back()));
  Problem problem;
  problem.start = {0.0, speed};
  problem.scales = {size, speed};
  problem.longest_step = 0.05 * time;
  problem.stepper = kSeesTimeErrors;
  problem.rates = [=](double, const double* y, double* d) {
    d[0] = y[1];
    d[1] = -hertz_load(K, y[0]) / mass;
  };
  problem.events = {[](double, const double* y) { return y[1]; },
                    [](double, const double* y) { return y[0]; }};
  Impact result;
  result.solution = solve(problem, times);
  result.solution.samples.resize(samples);
  for (const Event& event : result.solution.events) {
    if (event.index == 0) {
      result.max_approach = event.y[0];
      result.time_of_peak = event.t;
    } else if (!event.rising) {
      result.duration = event.t;
      result.rebound = event.y[1];
    }
  }
  return result;
}

// ---- F_dynamics

/// FV: ball between two fixed races.
Json between_races(const Json& in) {
  const double Ki = get(in, "Ki"), Ko = get(in, "Ko"), mass = get(in, "mass"),
               preload = get(in, "preload");
  const double x0 = get(in, "x0");
  const double di = std::pow(preload / Ki, 2.0 / 3.0), d_o = std::pow(preload / Ko, 2.0 / 3.0);
  const double stiffness = 1.5 * (Ki * std::sqrt(di) + Ko * std::sqrt(d_o)),
               omega = std::sqrt(stiffness / mass);
  Problem problem;
  problem.start = {x0, 0.0};
  problem.scales = {std::abs(x0), std::abs(x0) * omega};
  problem.longest_step = 0.1 / omega;
  problem.stepper = kSeesTimeErrors;
  problem.rates = [=](double, const double* y, double* d) {
    d[0] = y[1];
    d[1] = (hertz_load(Ki, di - y[0]) - hertz_load(Ko, d_o + y[0])) / mass;
  };
  problem.events = {[](double, const double* y) { return y[1]; },
                    [](double, const double* y) { return y[0]; },
                    [=](double, const double* y) { return di - y[0]; },  // contacts opening
                    [=](double, const double* y) { return d_o + y[0]; }};
  int turns = 0;
  problem.at_event = [&](int event, double, const State&) { return event == 0 && ++turns == 2; };
  const Solution solution = solve(problem, std::vector<double>{0.0, 100.0 / omega});
  Json result = {{"delta_i0", di},
                 {"delta_o0", d_o},
                 {"linear_stiffness", stiffness},
                 {"linear_angular_frequency", omega},
                 {"linear_frequency_Hz", omega / (2 * kPi)}};
  for (const Event& event : solution.events) {
    if (event.index == 1 && !result.contains("speed_at_x0_zero"))
      result["speed_at_x0_zero"] = std::abs(event.y[1]);
    if (event.index != 0) continue;
    if (!result.contains("opposite_turning_point"))
      result["opposite_turning_point"] = event.y[0];
    else
      result["period"] = event.t;
  }
  return result;
}

Json mass_impact(const Json& in) {
  const double mass = get(in, "mass"), K = get(in, "K"), speed = get(in, "speed");
  const Impact hit = impact(mass, K, speed, {});
  return {{"delta_max", hit.max_approach},
          {"F_max", hertz_load(K, hit.max_approach)},
          {"duration", hit.duration},
          {"coefficient", hit.duration * speed / hit.max_approach}};
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
  Problem problem;
  problem.start = {1.0, 0.0, 0.0, 0.0, w0[0], w0[1], w0[2]};
  const double speed = w0.norm();
  problem.scales = {1, 1, 1, 1, speed, speed, speed};
  problem.longest_step = 0.5 / speed;
  problem.rates = [&](double, const double* y, double* d) {
    const Vec3 w(y[4], y[5], y[6]);
    const Quat q = quaternion_rate({y[0], y[1], y[2], y[3]}, w);
    const Vec3 rate = dynamics::euler_rate(I, w, Vec3::Zero());
    for (int i = 0; i < 4; ++i) d[i] = q[static_cast<std::size_t>(i)];
    for (int i = 0; i < 3; ++i) d[4 + i] = rate[i];
  };
  if (!symmetric) problem.events = {[](double, const double* y) { return y[5]; }};
  const Solution solution = solve(problem, times);
  Json states = Json::array();
  for (std::size_t i = 0; i < times.size(); ++i) {
    const State& y = solution.samples[i];
    states.push_back(
        {{"t", times[i]},
         {"omega_body", {y[4], y[5], y[6]}},
         {"quaternion_wxyz", json(with_positive_w(normalise({y[0], y[1], y[2], y[3]})))}});
  }
  const Vec3 L = I.cwiseProduct(w0);
  Json result = {{"states", states},
                 {"kinetic_energy", 0.5 * w0.dot(L)},
                 {"angular_momentum_magnitude", L.norm()}};
  if (symmetric) {
    result["body_precession_rate"] = dynamics::euler_rate(I, w0, Vec3::Zero())[2] / w0[1];
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

/// FK: body pressed on a plane by N, sliding until it rolls.
Json slide_to_rolling(const Json& in) {
  const double m = get(in, "mass"), R = get(in, "radius"),
               I = get(in, "inertia_coefficient") * m * R * R;
  const double friction = get(in, "friction_coefficient") * get(in, "normal_force");
  Problem problem;
  problem.start = {get(in, "v0"), get(in, "omega0"), 0.0};
  const double slip = problem.start[0] - R * problem.start[1];
  problem.scales = {std::abs(slip), std::abs(slip) / R, m * slip * slip};
  problem.rates = [=](double, const double* y, double* d) {
    const double f = friction * sign(slip);
    d[0] = -f / m;
    d[1] = f * R / I;
    d[2] = f * (y[0] - R * y[1]);
  };
  problem.events = {[=](double, const double* y) { return y[0] - R * y[1]; }};
  problem.at_event = [](int, double, const State&) { return true; };
  const Solution solution =
      solve(problem, std::vector<double>{0.0, 2 * std::abs(slip) * m / friction});
  const Event& end = solution.events.at(0);
  return {{"time_to_rolling", end.t},
          {"rolling_speed", end.y[0]},
          {"rolling_spin", end.y[1]},
          {"friction_work", end.y[2]}};
}

/// FO: element dragged by the rotating inner race while it rolls on the fixed outer race.
Json orbit_spin_up(const Json& in) {
  const double m = get(in, "mass"), R = get(in, "radius"), r_m = get(in, "pitch_radius");
  const double I = get(in, "inertia_coefficient") * m * R * R, speed = get(in, "inner_speed");
  const double friction =
      sign(speed) * get(in, "friction_coefficient") * get(in, "inner_normal_force");
  // m r_m ω_m' = friction + T, I r_m ω_m'/R = R (friction - T), T along the motion.
  const double acceleration = 2 * friction / (r_m * (m + I / (R * R)));
  Problem problem;
  problem.start = {0.0, 0.0};
  problem.scales = {speed, friction * r_m};
  const auto slip = [=](double omega_m) { return speed * (r_m - R) - 2 * omega_m * r_m; };
  problem.rates = [=](double, const double* y, double* d) {
    d[0] = acceleration;
    d[1] = friction * slip(y[0]);
  };
  problem.events = {[=](double, const double* y) { return slip(y[0]); }};
  problem.at_event = [](int, double, const State&) { return true; };
  const Solution solution = solve(problem, std::vector<double>{0.0, speed / acceleration});
  const Event& end = solution.events.at(0);
  return {{"orbital_acceleration", acceleration},
          {"outer_tangential_force", m * r_m * acceleration - friction},
          {"final_orbital_speed", end.y[0]},
          {"final_spin_speed_absolute", end.y[0] * r_m / R},
          {"time_to_rolling", end.t},
          {"slip_work", end.y[1]}};
}

/// FP: element rolling in a circular race under gravity.
Json rolling_pendulum(const Json& in) {
  const double arm = get(in, "race_radius") - get(in, "element_radius");
  const double omega = std::sqrt(get(in, "g") / (arm * (1 + get(in, "inertia_coefficient"))));
  Problem problem;
  problem.start = {get(in, "theta0"), 0.0};
  problem.scales = {std::abs(problem.start[0]), std::abs(problem.start[0]) * omega};
  problem.rates = [=](double, const double* y, double* d) {
    d[0] = y[1];
    d[1] = -omega * omega * std::sin(y[0]);
  };
  problem.events = {[](double, const double* y) { return y[1]; },
                    [](double, const double* y) { return y[0]; }};
  int turns = 0;
  problem.at_event = [&](int event, double, const State&) { return event == 0 && ++turns == 2; };
  const Solution solution = solve(problem, std::vector<double>{0.0, 100 / omega});
  Json result = {{"small_amplitude_angular_frequency", omega}};
  for (const Event& event : solution.events) {
    if (event.index == 0)
      result["period"] = event.t;
    else if (!result.contains("max_orbital_rate"))
      result["max_orbital_rate"] = std::abs(event.y[1]);
  }
  return result;
}

// ---- plates

/// Coulomb friction on both plates: motion in pieces of constant acceleration; a contact whose slip
/// is zero sticks when the force that keeps it so is within μN.
class CoulombPlates {
 public:
  explicit CoulombPlates(const Json& in)
      : m_(get(in, "mass")),
        R_(get(in, "radius")),
        I_(get(in, "inertia")),
        limit_{get(in, "mu") * get(in, "N_top"), get(in, "mu") * get(in, "N_bottom")},
        plate_{get(in, "V_top"), get(in, "V_bottom")},
        v_(get(in, "v0")),
        omega_(get(in, "omega0")) {}

  Json run(const std::vector<double>& times) {
    Json result;
    std::vector<Piece> pieces;
    double t = 0.0;
    for (int i = 0; i < 20; ++i) {
      pieces.push_back(piece(t));
      const Piece& p = pieces.back();
      if (i == 0) {
        result["acceleration"] = p.a;
        result["angular_acceleration"] = p.alpha;
        result["bottom_sticking_force"] = p.force[1];
      }
      if (!std::isfinite(p.length)) break;
      t += p.length;
      heat_ += p.heat(p.length);
      v_ += p.a * p.length;
      omega_ += p.alpha * p.length;
    }
    result["time_to_rolling"] = t;
    result["total_heat"] = heat_;
    for (const double time : times) {
      std::size_t k = 0;
      while (k + 1 < pieces.size() && time >= pieces[k + 1].start) ++k;
      const Piece& p = pieces[k];
      const double v = p.v + p.a * (time - p.start), omega = p.omega + p.alpha * (time - p.start);
      result["t"].push_back(time);
      result["v"].push_back(v);
      result["omega"].push_back(omega);
      result["slip_top"].push_back(slip(0, v, omega));
      result["slip_bottom"].push_back(slip(1, v, omega));
    }
    return result;
  }

 private:
  struct Piece {
    double start, v, omega, a, alpha, length;
    std::array<double, 2> force, slip, slip_rate;
    [[nodiscard]] double heat(double dt) const {
      return force[0] * (slip[0] + 0.5 * slip_rate[0] * dt) * dt +
             force[1] * (slip[1] + 0.5 * slip_rate[1] * dt) * dt;
    }
  };

  [[nodiscard]] double slip(int plate, double v, double omega) const {
    return plate_[static_cast<std::size_t>(plate)] - v + (plate == 0 ? R_ : -R_) * omega;
  }

  [[nodiscard]] Piece piece(double t) const {
    const double same = 1 / m_ + R_ * R_ / I_,
                 cross = 1 / m_ - R_ * R_ / I_;  // slip rate of a unit force
    Piece p{t, v_, omega_, 0, 0, std::numeric_limits<double>::infinity(), {}, {}, {}};
    std::array<bool, 2> stick{};
    const double tiny =
        1e-12 * (std::abs(plate_[0]) + std::abs(plate_[1]) + std::abs(v_) + R_ * std::abs(omega_));
    for (std::size_t k = 0; k < 2; ++k) {
      p.slip[k] = slip(static_cast<int>(k), v_, omega_);
      if (std::abs(p.slip[k]) <= tiny) p.slip[k] = 0.0;
      stick[k] = p.slip[k] == 0.0;
      p.force[k] = limit_[k] * sign(p.slip[k]);
    }
    for (std::size_t k = 0; k < 2; ++k) {  // the other contact slides: this one alone holds
      if (!stick[k] || stick[1 - k]) continue;
      const double hold = -p.force[1 - k] * cross / same;
      p.force[k] = std::clamp(hold, -limit_[k], limit_[k]);
    }
    p.a = (p.force[0] + p.force[1]) / m_;
    p.alpha = R_ * (p.force[1] - p.force[0]) / I_;
    for (std::size_t k = 0; k < 2; ++k) {
      p.slip_rate[k] = -p.a + (k == 0 ? R_ : -R_) * p.alpha;
      if (p.slip[k] * p.slip_rate[k] < 0.0)
        p.length = std::min(p.length, -p.slip[k] / p.slip_rate[k]);
    }
    return p;
  }

  double m_, R_, I_;
  std::array<double, 2> limit_, plate_;
  double v_, omega_, heat_ = 0.0;
};

/// State: v, ω, heat of the top and bottom contact, work of the plates.
Json lubricated_plates(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  const double m = get(in, "mass"), R = get(in, "radius"), I = get(in, "inertia");
  const std::array<double, 2> N = {get(in, "N_top"), get(in, "N_bottom")};
  const std::array<double, 2> V = {get(in, "V_top"), get(in, "V_bottom")};
  const bearing::TractionCurve curve = traction_law(in.at("law"));
  const auto slips = [=](const double* y) {
    return std::array<double, 2>{V[0] - (y[0] - y[1] * R), V[1] - (y[0] + y[1] * R)};
  };
  Problem problem;
  problem.start = {get(in, "v0"), get(in, "omega0"), 0.0, 0.0, 0.0};
  const auto u0 = slips(problem.start.data());
  const double speed = std::max({std::abs(u0[0]), std::abs(u0[1]), 1e-3});
  problem.scales = {speed, speed / R, m * speed * speed, m * speed * speed, m * speed * speed};
  problem.rates = [=](double, const double* y, double* d) {
    const auto u = slips(y);
    std::array<double, 2> f{};
    for (std::size_t k = 0; k < 2; ++k) {
      f[k] = N[k] * tribology::traction_coefficient(curve, std::abs(u[k])) * sign(u[k]);
      d[2 + k] = f[k] * u[k];
    }
    d[0] = (f[0] + f[1]) / m;
    d[1] = R * (f[1] - f[0]) / I;
    d[4] = f[0] * V[0] + f[1] * V[1];
  };
  for (std::size_t k = 0; k < 2; ++k) {
    problem.events.push_back([=](double, const double* y) { return slips(y)[k]; });
    if (curve.form == bearing::TractionCurve::Form::TwoSlope)
      problem.events.push_back(
          [=](double, const double* y) { return std::abs(slips(y)[k]) - curve.u0; });
  }
  const Solution solution = solve(problem, sample_times(the_case));
  Json top = Json::array(), bottom = Json::array();
  for (const State& y : solution.samples) {
    top.push_back(slips(y.data())[0]);
    bottom.push_back(slips(y.data())[1]);
  }
  return {{"t", sample_times(the_case)},
          {"v", solution.channel(0)},
          {"omega", solution.channel(1)},
          {"slip_top", top},
          {"slip_bottom", bottom},
          {"heat_top", solution.channel(2)},
          {"heat_bottom", solution.channel(3)},
          {"work_by_plates", solution.channel(4)},
          {"closed_form_slip_top", top}};
}

}  // namespace

std::optional<Json> closed_form_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  if (in.contains("preload")) return between_races(in);
  if (in.contains("K") && in.contains("speed")) return mass_impact(in);
  if (in.contains("inertia") && in.contains("omega0")) return free_rotation(the_case);
  if (in.contains("v0") && in.contains("normal_force")) return slide_to_rolling(in);
  if (in.contains("inner_normal_force")) return orbit_spin_up(in);
  if (in.contains("theta0") && in.contains("race_radius")) return rolling_pendulum(in);
  return std::nullopt;
}

std::optional<Json> impact_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  const double mass = get(in, "mass"), K = get(in, "K"), speed = get(in, "impact_velocity");
  const std::vector<double> times = sample_times(the_case);
  const Impact hit = impact(mass, K, speed, times);
  Json force = Json::array();
  for (const State& y : hit.solution.samples) force.push_back(hertz_load(K, y[0]));
  return Json{{"max_approach", hit.max_approach},
              {"peak_force", hertz_load(K, hit.max_approach)},
              {"contact_duration", hit.duration},
              {"time_of_peak", hit.time_of_peak},
              {"rebound_velocity", hit.rebound},
              {"impulse", mass * (speed - hit.rebound)},
              {"duration_constant", hit.duration * speed / hit.max_approach},
              {"t", times},
              {"approach", hit.solution.channel(0)},
              {"velocity", hit.solution.channel(1)},
              {"force", force}};
}

std::optional<Json> plates_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  if (in.contains("mu")) return CoulombPlates(in).run(sample_times(the_case));
  if (in.contains("law")) return lubricated_plates(the_case);
  return std::nullopt;
}

}  // namespace adore::reference
