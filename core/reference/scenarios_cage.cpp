#include "contact/ball_pocket.hpp"
#include "dynamics/rigid_body.hpp"
#include "reference/adapter.hpp"
#include "reference/ball_scenario.hpp"
#include "reference/scenarios.hpp"
#include "reference/trajectory.hpp"
#include "tribology/traction_curve.hpp"

#include <nlohmann/json.hpp>

/// dynamics_pocket and dynamics_rigid_whirl. The pocket's walls and the land are linear springs
/// here, as the cases say.
namespace adore::reference {
namespace {

double sign(double u) { return (u > 0.0) - (u < 0.0); }

/// Sample times with one a little later, so that an event at the very end is found; drop_extra
/// undoes it.
std::vector<double> slightly_longer(std::vector<double> times) {
  times.push_back(times.back() * (1 + 1e-6));
  return times;
}

/// Largest spring force of each contact from the turning points of the penetration.
Json peak_forces(const Solution& solution, int turning_event,
                 const std::function<double(const Event&)>& force) {
  Json peaks = Json::array();
  for (const Event& event : solution.events)
    if (event.index == turning_event && force(event) > 0.0) peaks.push_back(force(event));
  return peaks;
}

// ---- dynamics_pocket

/// Ball between two walls at ±clearance, along s.
Json bounce(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  const double m = get(in, "ball_mass"), k = get(in, "pocket_stiffness"),
               c = get(in, "pocket_half_clearance");
  const double push = get(in, "constant_force");
  const auto penetration = [=](const double* y) { return std::abs(y[0]) - c; };
  Problem problem;
  problem.start = {get(in, "initial_position"), get(in, "initial_relative_velocity")};
  problem.scales = {c, std::max(std::abs(problem.start[1]), std::sqrt(std::abs(push) * c / m))};
  problem.longest_step = 0.2 * std::sqrt(m / k);
  problem.rates = [=](double, const double* y, double* d) {
    d[0] = y[1];
    d[1] = (push - k * std::max(penetration(y), 0.0) * sign(y[0])) / m;
  };
  problem.events = {[=](double, const double* y) { return penetration(y); },
                    [](double, const double* y) { return y[1]; }};
  const auto times = sample_times(the_case);
  Solution solution = solve(problem, slightly_longer(times));
  solution.samples.resize(times.size());
  const auto force = [=](const Event& event) { return k * penetration(event.y.data()); };
  return {{"contact_start_times", solution.times_of(0, true)},
          {"contact_end_times", solution.times_of(0, false)},
          {"peak_pocket_forces", peak_forces(solution, 1, force)},
          {"t", times},
          {"s", solution.channel(0)},
          {"s_dot", solution.channel(1)}};
}

/// Frictionless ball in a circular pocket at rest; x axial, s tangential (the pocket's -y).
Json oblique(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  const double m = get(in, "ball_mass"), k = get(in, "pocket_stiffness"), radius = 0.1;
  const contact::CylindricalPocket pocket{radius + get(in, "pocket_radial_clearance"), -1.0, 1.0};
  const auto wall = [=](const double* y) {
    return contact::nearest_wall(pocket, {y[0], -y[1], 0.0}, radius);
  };
  const auto position = in.at("position0_x_s").get<State>(),
             velocity = in.at("velocity0_x_s").get<State>();
  Problem problem;
  problem.start = {position[0], position[1], velocity[0], velocity[1]};
  const double speed = std::hypot(velocity[0], velocity[1]),
               size = get(in, "pocket_radial_clearance");
  problem.scales = {size, size, speed, speed};
  problem.longest_step = 0.2 * std::sqrt(m / k);
  problem.rates = [=](double, const double* y, double* d) {
    const contact::WallPoint w = wall(y);
    const double force = k * std::max(-w.gap, 0.0);
    d[0] = y[2];
    d[1] = y[3];
    d[2] = -force * w.m[0] / m;
    d[3] = force * w.m[1] / m;
  };
  problem.events = {[=](double, const double* y) { return -wall(y).gap; }};
  const auto times = sample_times(the_case);
  Solution solution = solve(problem, slightly_longer(times));
  solution.samples.resize(times.size());
  Json azimuths = Json::array();
  for (const Event& event : solution.events)
    if (event.rising) azimuths.push_back(std::atan2(event.y[1], event.y[0]));
  const State& end = solution.samples.back();
  return {{"contact_start_times", solution.times_of(0, true)},
          {"contact_end_times", solution.times_of(0, false)},
          {"azimuth_of_contact_start", azimuths},
          {"t", times},
          {"x", solution.channel(0)},
          {"s", solution.channel(1)},
          {"x_dot", solution.channel(2)},
          {"s_dot", solution.channel(3)},
          {"angular_momentum_per_mass", end[0] * end[3] - end[1] * end[2]}};
}

/// Pocket of a massive cage that turns about X; the ball in inertial axes, with or without a fixed
/// outer race.
class RotatingPocket {
 public:
  explicit RotatingPocket(const Json& in)
      : mass_(get(in, "ball_mass")),
        inertia_(get(in, "ball_inertia")),
        radius_(0.5 * get(in, "ball_diameter")),
        stiffness_(get(in, "pocket_stiffness")),
        speed_(get(in, "cage_speed_rad_s")),
        start_(get(in, "pocket_azimuth_at_t0")),
        x_(get(in, "pocket_axial_position")),
        pocket_{radius_ + get(in, "pocket_radial_clearance"), -1.0, 1.0},
        law_(traction_law(in.at("pocket_law"))) {
    if (in.contains("outer_race"))
      race_ = outer_race_model(in.at("outer_race"), traction_law(in.at("race_law")), radius_);
  }

  /// State: position, velocity, ω (base axes), work of the moving surfaces, heat of the race, heat
  /// of the pocket.
  static constexpr std::size_t kSize = 12;

  struct PocketContact {
    double penetration = 0.0, penetration_rate = 0.0;
    Vec3 outward, force = Vec3::Zero(), friction = Vec3::Zero(), arm, surface_velocity;
    double heat = 0.0;
  };

  [[nodiscard]] PocketContact contact(double t, const double* y) const {
    const double psi = start_ + speed_ * t;
    const Vec3 q(y[0], y[1], y[2]), v(y[3], y[4], y[5]), omega(y[6], y[7], y[8]);
    const Mat3 to_pocket = passive_x(psi);
    const Vec3 local = to_pocket * (q - x_ * Vec3::UnitX());
    const contact::WallPoint wall =
        contact::nearest_wall(pocket_, {local[0], local[1], 0.0}, radius_);
    PocketContact c;
    c.penetration = -wall.gap;
    c.outward = to_pocket.transpose() * wall.m;
    const Vec3 turning = speed_ * Vec3::UnitX();
    c.penetration_rate = c.outward.dot(v - turning.cross(q));
    c.arm = radius_ * c.outward;
    c.surface_velocity = turning.cross(q + c.arm);
    if (c.penetration <= 0.0) return c;
    const double N = stiffness_ * c.penetration;
    Vec3 slip = c.surface_velocity - (v + omega.cross(c.arm));
    slip -= slip.dot(c.outward) * c.outward;
    const double u = slip.norm();
    if (u > 0.0) c.friction = N * tribology::traction_coefficient(law_, u) / u * slip;
    c.heat = c.friction.dot(slip);
    c.force = c.friction - N * c.outward;
    return c;
  }

  void rates(double t, const double* y, double* d) const {
    const PocketContact c = contact(t, y);
    Vec3 force = c.force, moment = c.arm.cross(c.friction);
    d[9] = c.force.dot(c.surface_velocity);
    d[10] = 0.0;
    d[11] = c.heat;
    if (race_) {
      const BallLoad race = load_on_free_ball(*race_, 0.0, y);
      force += race.force;
      moment += race.moment;
      d[10] = race.heat;
    }
    for (int i = 0; i < 3; ++i) {
      d[i] = y[3 + i];
      d[3 + i] = force[i] / mass_;
      d[6 + i] = moment[i] / inertia_;
    }
  }

  Json run(const Json& the_case) {
    const Json& start = the_case.at("inputs").at("initial_state");
    Problem problem;
    for (const char* part : {"position", "velocity", "omega"})
      for (const Json& value : start.at(part)) problem.start.push_back(value.get<double>());
    problem.start.resize(kSize, 0.0);
    const double v = vec3(start.at("velocity")).norm(), play = pocket_.wall_radius - radius_;
    const double w = std::max(vec3(start.at("omega")).norm(), v / radius_),
                 energy = mass_ * play * play * speed_ * speed_;
    problem.scales = {play, play, play, v, v, v, w, w, w, energy, energy, energy};
    problem.tolerance = 1e-12;
    if (race_) problem.stepper = "pece8";  // two evaluations of the contact ellipse per step
    problem.longest_step = 0.2 * std::sqrt(mass_ / stiffness_);
    problem.rates = [this](double t, const double* y, double* d) { rates(t, y, d); };
    problem.events = {[this](double t, const double* y) { return contact(t, y).penetration; },
                      [this](double t, const double* y) { return contact(t, y).penetration_rate; }};
    const auto times = sample_times(the_case);
    const Solution solution = solve(problem, times);
    Json penetration = Json::array(), Q = Json::array();
    for (std::size_t i = 0; i < times.size(); ++i) {
      penetration.push_back(
          std::max(contact(times[i], solution.samples[i].data()).penetration, 0.0));
      if (race_) Q.push_back(load_on_free_ball(*race_, 0.0, solution.samples[i].data()).Q);
    }
    double peak = 0.0;
    for (const Event& event : solution.events)
      if (event.index == 1)
        peak = std::max(peak, stiffness_ * contact(event.t, event.y.data()).penetration);
    Json result = {{"t", times},
                   {"position", solution.vectors(0)},
                   {"velocity", solution.vectors(3)},
                   {"omega", solution.vectors(6)},
                   {"pocket_penetration", penetration},
                   {"contact_start_times", solution.times_of(0, true)},
                   {"contact_end_times", solution.times_of(0, false)},
                   {"peak_pocket_force_on_fine_grid", peak},
                   {"work_by_moving_surfaces", solution.channel(9)},
                   {"heat_race", solution.channel(10)},
                   {"heat_pocket", solution.channel(11)}};
    if (race_) result["Q_outer"] = Q;
    return result;
  }

 private:
  double mass_, inertia_, radius_, stiffness_, speed_, start_, x_;
  contact::CylindricalPocket pocket_;
  bearing::TractionCurve law_;
  std::optional<dynamics::RaceContactModel> race_;
};

// ---- dynamics_rigid_whirl

/// State: quaternion, ω on principal axes.
Json rotation(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  const Vec3 I = vec3(in.at("inertia_principal_xyz")), w0 = vec3(in.at("omega_body0"));
  const Vec3 inertial = vec3(in.at("torque_inertial")), body = vec3(in.at("torque_body"));
  const Quat q0 = quaternion_from_angles(vec3(in.at("angles0_eta_xi_lambda")));
  Problem problem;
  problem.start = {q0[0], q0[1], q0[2], q0[3], w0[0], w0[1], w0[2]};
  const double speed = w0.norm();
  problem.scales = {1, 1, 1, 1, speed, speed, speed};
  problem.longest_step = 0.5 / speed;
  problem.rates = [&](double, const double* y, double* d) {
    const Quat q = {y[0], y[1], y[2], y[3]};
    const Vec3 w(y[4], y[5], y[6]);
    const Quat q_rate = quaternion_rate(q, w);
    const Vec3 rate =
        dynamics::euler_rate(I, w, Vec3(body + rotation_matrix(q).transpose() * inertial));
    for (int i = 0; i < 4; ++i) d[i] = q_rate[static_cast<std::size_t>(i)];
    for (int i = 0; i < 3; ++i) d[4 + i] = rate[i];
  };
  const Solution solution = solve(problem, sample_times(the_case));
  Json result = {{"t", sample_times(the_case)}, {"omega_body", solution.vectors(4)}};
  for (const State& y : solution.samples) {
    const Quat q = normalise({y[0], y[1], y[2], y[3]});
    const Mat3 R = rotation_matrix(q);
    const Vec3 w(y[4], y[5], y[6]), H = I.cwiseProduct(w);
    result["omega_inertial"].push_back(json(Vec3(R * w)));
    result["body_x_axis_inertial"].push_back(json(Vec3(R.col(0))));
    result["body_y_axis_inertial"].push_back(json(Vec3(R.col(1))));
    result["angles_eta_xi_lambda"].push_back(json(angles_from_quaternion(q)));
    result["angular_momentum_inertial"].push_back(json(Vec3(R * H)));
    result["kinetic_energy"].push_back(0.5 * w.dot(H));
  }
  // Steady precession of a free symmetric body, from its rates at the start.
  const Mat3 R0 = rotation_matrix(q0);
  const Vec3 H = R0 * I.cwiseProduct(w0), axis = H.normalized(), x = R0.col(0);
  const Vec3 x_rate = (R0 * w0).cross(x), w_rate = dynamics::euler_rate(I, w0, Vec3::Zero());
  const double across = w0[1] * w0[1] + w0[2] * w0[2], sine2 = 1 - x.dot(axis) * x.dot(axis);
  if (across > 0.0 && sine2 > 0.0) {
    result["body_cone_rate"] = (w0[1] * w_rate[2] - w0[2] * w_rate[1]) / across;
    result["precession_rate"] = axis.dot(x.cross(x_rate)) / sine2;
    result["nutation_angle"] = std::atan2(x.cross(axis).norm(), x.dot(axis));
    result["precession_axis"] = json(axis);
  }
  return result;
}

/// Planar cage in a circular land. State: y, z, vy, vz, ω, whirl angle, work of the land, heat.
class Whirl {
 public:
  explicit Whirl(const Json& in)
      : mass_(get(in, "cage_mass")),
        inertia_(get(in, "cage_Ix")),
        clearance_(get(in, "radial_guide_clearance")),
        stiffness_(get(in, "contact_stiffness")),
        cage_radius_(get(in, "cage_guide_radius")),
        land_speed_(get(in, "land_speed_rad_s") * get(in, "land_radius")),
        outer_(in.at("guidance") == "outer"),
        law_(traction_law(in.at("friction_law"))) {
    gravity_ =
        Vec3(0.0, in.at("gravity_yz")[0].get<double>(), in.at("gravity_yz")[1].get<double>());
  }

  struct Contact {
    double eccentricity, load, slip, friction;
    Vec3 direction, tangent;
  };
  [[nodiscard]] Contact contact(const double* y) const {
    const Vec3 e(0.0, y[0], y[1]), v(0.0, y[2], y[3]);
    Contact c{e.norm(), 0.0, 0.0, 0.0, Vec3::Zero(), Vec3::Zero()};
    if (c.eccentricity > 0.0) c.direction = e / c.eccentricity;
    c.tangent = Vec3::UnitX().cross(outer_ ? c.direction : Vec3(-c.direction));
    c.load = stiffness_ * std::max(c.eccentricity - clearance_, 0.0);
    c.slip = land_speed_ - (v.dot(c.tangent) + y[4] * cage_radius_);
    c.friction = c.load * tribology::traction_coefficient(law_, std::abs(c.slip)) * sign(c.slip);
    return c;
  }

  Json run(const Json& the_case) {
    const Json& start = the_case.at("inputs").at("initial_state");
    Problem problem;
    for (const char* part : {"y", "z", "vy", "vz", "omega"})
      problem.start.push_back(get(start, part));
    const double whirl0 = std::atan2(problem.start[1], problem.start[0]);
    problem.start.insert(problem.start.end(), {whirl0, 0.0, 0.0});
    const double v = std::max(std::hypot(problem.start[2], problem.start[3]), 1e-2);
    const double energy = mass_ * v * v;
    problem.scales = {clearance_, clearance_, v,     v, std::abs(problem.start[4]),
                      1.0,        energy,     energy};
    problem.longest_step = 0.2 * std::sqrt(mass_ / stiffness_);
    problem.rates = [this](double, const double* y, double* d) {
      const Contact c = contact(y);
      const Vec3 force = -c.load * c.direction + c.friction * c.tangent;
      d[0] = y[2];
      d[1] = y[3];
      d[2] = force[1] / mass_ + gravity_[1];
      d[3] = force[2] / mass_ + gravity_[2];
      d[4] = cage_radius_ * c.friction / inertia_;
      d[5] = c.eccentricity > 0.0 ? (y[0] * y[3] - y[1] * y[2]) / (c.eccentricity * c.eccentricity)
                                  : 0.0;
      d[6] = c.friction * land_speed_;
      d[7] = c.friction * c.slip;
    };
    problem.events = {
        [this](double, const double* y) { return contact(y).eccentricity - clearance_; },
        [this](double, const double* y) { return contact(y).slip; }};
    const auto times = sample_times(the_case);
    std::vector<double> all = times;  // the last tenth starts at a time of its own
    const double last_tenth = times.front() + 0.9 * (times.back() - times.front());
    const auto where = std::lower_bound(all.begin(), all.end(), last_tenth);
    const auto extra = static_cast<std::size_t>(where - all.begin());
    all.insert(where, last_tenth);
    Solution solution = solve(problem, all);
    const double whirl_then = solution.samples[extra][5];
    solution.samples.erase(solution.samples.begin() + static_cast<std::ptrdiff_t>(extra));
    Json result = {{"t", times},
                   {"y", solution.channel(0)},
                   {"z", solution.channel(1)},
                   {"vy", solution.channel(2)},
                   {"vz", solution.channel(3)},
                   {"omega", solution.channel(4)},
                   {"whirl_angle_unwrapped", solution.channel(5)},
                   {"work_by_land", solution.channel(6)},
                   {"heat", solution.channel(7)}};
    for (const State& y : solution.samples) {
      const Contact c = contact(y.data());
      result["eccentricity_over_clearance"].push_back(c.eccentricity / clearance_);
      result["guide_force"].push_back(c.load);
      result["slip"].push_back(c.slip);
    }
    const State& end = solution.samples.back();
    const double span = times.back() - times.front();
    result["whirl_turns"] = (end[5] - whirl0) / (2 * kPi);
    result["mean_whirl_speed_last_tenth"] = (end[5] - whirl_then) / (times.back() - last_tenth);
    const Contact last = contact(end.data());
    result["closed_form"] = {{"eccentricity", last.eccentricity},
                             {"guide_force", last.load},
                             {"whirl_speed", (end[5] - whirl0) / span}};
    return result;
  }

 private:
  double mass_, inertia_, clearance_, stiffness_, cage_radius_, land_speed_;
  bool outer_;
  bearing::TractionCurve law_;
  Vec3 gravity_;
};

}  // namespace

std::optional<Json> pocket_motion_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  if (in.contains("pocket_half_clearance")) return bounce(the_case);
  if (in.contains("position0_x_s")) return oblique(the_case);
  if (in.contains("cage_speed_rad_s")) return RotatingPocket(in).run(the_case);
  return std::nullopt;
}

std::optional<Json> rigid_whirl_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  if (in.contains("inertia_principal_xyz")) return rotation(the_case);
  if (in.contains("radial_guide_clearance")) return Whirl(in).run(the_case);
  return std::nullopt;
}

}  // namespace adore::reference
