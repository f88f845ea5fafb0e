#include "validation/motion.hpp"
#include "validation/scenarios.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>

/// dynamics_roller: one cylindrical roller between two races, with separate loads Q = k δ and
/// slip that is uniform along each line (tests/reference/dynamics_README.md, family 7). The roller
/// of a plane problem is a ball with the roller's moment of inertia; races are walls that press on
/// it.
namespace adore::validation {
namespace {

using dynamics::Evaluation;

constexpr std::array<double, 2> kSide{1.0, -1.0};  ///< outer, inner
const std::array<std::string, 2> kRace{"outer", "inner"};

/// One contact at the state evaluated last.
struct Line {
  double approach = 0.0, Q = 0.0;
  Vec3 arm = Vec3::Zero(), friction = Vec3::Zero();  ///< on the roller [m, N]
  Vec3 slip = Vec3::Zero();  ///< race minus roller, (x, r, θ) of the race [m/s]
  double heat = 0.0, work = 0.0;
};

/// Walls of both races.
struct Walls {
  std::array<dynamics::BodyState, 2> race;
  std::array<double, 2> radius{}, stiffness{};
  std::optional<std::array<double, 2>> load;  ///< given instead of a spring [N]
  double half = 0.0;                          ///< D/2 [m]
  tribology::TractionLaw law;
  std::array<Line, 2> line;

  void act(Evaluation& e) {
    for (std::size_t j = 0; j < 2; ++j) {
      Vec3 from_axis = e.element_centre(0) - race[j].position;
      from_axis[0] = 0.0;
      const double r = from_axis.norm();
      const Vec3 out = from_axis / r, m = kSide[j] * out;
      Line& one = line[j];
      one = {};
      one.approach = kSide[j] * (r - radius[j]) + half;
      one.arm = half * m;
      const Vec3 point = e.element_centre(0) + one.arm;
      const Vec3 slip =
          race[j].velocity_at(point) - e.element_velocity(0) - e.element_omega(0).cross(one.arm);
      one.slip = Vec3(slip[0], slip.dot(out), slip.dot(Vec3::UnitX().cross(out)));
      const double k = load ? (*load)[j] : stiffness[j];
      const double overlap = load ? 1.0 : one.approach;
      if (!(overlap > 0.0)) continue;
      const dynamics::WallContact action =
          press(e, 0, race[j], m, half, linear_spring(k), overlap, law);
      one.Q = action.N;
      one.friction = action.friction;
      one.heat = action.heat;
      one.work = action.on_element.dot(race[j].velocity_at(action.point));
    }
  }
};

/// The walls of a case in a scene with the roller; `after` acts behind them.
struct RollerMotion {
  std::unique_ptr<Walls> walls = std::make_unique<Walls>();
  std::unique_ptr<double> work = std::make_unique<double>(0.0);
  std::unique_ptr<Motion> motion;

  explicit RollerMotion(const Json& in, std::function<void(Evaluation&)> after = {}) {
    Walls& w = *walls;
    w.half = 0.5 * get(in, "D");
    w.law = traction_law(in.at("law"));
    SmallScene scene;
    bearing::Inertia& inertia = scene.bearing.element_inertia;
    if (in.contains("mass")) {
      inertia.mass = get(in, "mass");
      inertia.moments.setConstant(get(in, "inertia"));
    }
    for (std::size_t j = 0; j < 2; ++j) {
      if (!in.contains(kRace[j])) {
        w.race[j].omega[0] = get(in, (kRace[j] + "_speed_rad_s").c_str());
        continue;
      }
      const Json& race = in.at(kRace[j]);
      w.race[j].position = Vec3(0.0, race.at("centre_yz").at(0).get<double>(),
                                race.at("centre_yz").at(1).get<double>());
      w.race[j].omega[0] = get(race, "speed_rad_s");
      w.radius[j] = get(race, "raceway_radius");
      w.stiffness[j] = get(race, "stiffness");
    }
    if (in.contains("Q_outer")) w.load = {get(in, "Q_outer"), get(in, "Q_inner")};
    add(scene,
        {[&w, total = work.get(), after](Evaluation& e, const dynamics::RaceModels&) {
           w.act(e);
           *total = w.line[0].work + w.line[1].work;
           if (after) after(e);
         },
         {},
         {{"work", work.get()}, {"heat outer", &w.line[0].heat}, {"heat inner", &w.line[1].heat}}});
    motion = std::make_unique<Motion>(std::move(scene));
  }
  /// @throws InputError where the start presses the roller into a race as no elastic body can be
  void check_start() const {
    (void)motion->evaluate(0.0, motion->start.data());
    constexpr double kDeepest = 0.02;  // of D/2
    for (std::size_t j = 0; j < 2; ++j)
      require(walls->line[j].approach <= kDeepest * walls->half,
              fmt::format(
                  "{}.raceway_radius = {:.6g} m: the roller of diameter D = {:.6g} m overlaps this "
                  "race by {:.4g} m in its \"initial_state\". Enter a radius without overlap.",
                  kRace[j], walls->radius[j], 2.0 * walls->half, walls->line[j].approach));
  }
  /// With events where a contact opens or passes the kink of the law.
  [[nodiscard]] Solution solve(const std::vector<double>& times, bool with_events) {
    check_start();
    const double time = std::sqrt(motion->mass() / walls->stiffness[0]);
    const double r = motion->start_of("element.r"),
                 speed = std::hypot(r * motion->start_of("element.theta_dot"),
                                    motion->start_of("element.r_dot")) +
                         1.0;
    motion->scale("element.x", 1e-3);
    motion->scale("element.r", r);
    motion->scale("element.x_dot", 0.1);
    motion->scale("element.r_dot", 0.1 * speed);
    motion->scale("element.theta_dot", speed / r);
    for (const char* group : {"element.omega_x", "element.omega_r", "element.omega_theta"})
      motion->scale(group, speed / walls->half);
    Problem problem = motion->problem();
    problem.longest_step = 0.3 * time;
    const auto evaluated = [this](double t, const double* y) -> const Walls& {
      (void)motion->evaluate(t, y);
      return *walls;
    };
    for (std::size_t j = 0; with_events && j < 2; ++j) {
      problem.events.emplace_back(
          [=](double t, const double* y) { return evaluated(t, y).line[j].approach; });
      problem.events.emplace_back([=](double t, const double* y) {
        const Walls& w = evaluated(t, y);
        return std::abs(w.line[j].slip[2]) - w.law.kink();
      });
    }
    return motion->solve(problem, times);
  }
  void add_integrals(const Solution& solution, Json& out) const {
    out["work_by_races"] = solution.channel(motion->at("work"));
    for (const std::string& race : kRace)
      out["heat_" + race] = solution.channel(motion->at("heat " + race));
  }
};

// ---- planar motion

Json planar_case(const Json& the_case) {
  const Json &in = the_case.at("inputs"), &at = in.at("initial_state");
  RollerMotion roller(in);
  Motion& motion = *roller.motion;
  motion.place(0, Vec3(0.0, get(at, "y"), get(at, "z")), Vec3(0.0, get(at, "vy"), get(at, "vz")),
               get(at, "omega") * Vec3::UnitX());
  const double orbit = motion.start_of("element.theta_dot");
  const std::vector<double> times = sample_times(the_case);
  const Solution solution = roller.solve(times, true);
  Json out = {{"t", times},
              {"theta", solution.channel(motion.at("element.theta"))},
              {"r", solution.channel(motion.at("element.r"))},
              {"orbital_speed", solution.channel(motion.at("element.theta_dot"))},
              {"omega", solution.channel(motion.at("element.omega_x"))},
              // At constant angular momentum the orbit adds 3 θ̇².
              {"angular_frequency_linear",
               std::sqrt((roller.walls->stiffness[0] + roller.walls->stiffness[1]) / motion.mass() +
                         3.0 * orbit * orbit)}};
  roller.add_integrals(solution, out);
  for (std::size_t i = 0; i < times.size(); ++i) {
    const Evaluation& e = motion.evaluate(times[i], solution.samples[i].data());
    const Vec3 place = e.element_centre(0), velocity = e.element_velocity(0);
    out["y"].push_back(place[1]);
    out["z"].push_back(place[2]);
    out["vy"].push_back(velocity[1]);
    out["vz"].push_back(velocity[2]);
    for (std::size_t j = 0; j < 2; ++j) {
      out["Q_" + kRace[j]].push_back(roller.walls->line[j].Q);
      out["slip_" + kRace[j]].push_back(roller.walls->line[j].slip[2]);
    }
  }
  motion.add_evaluation_record(out);
  return out;
}

// ---- a roller whose axis is skewed by s: (cos s, 0, -sin s) on (e_x, e_r, e_θ)

void set_spin(Motion& motion, double spin, double skew) {
  motion.start_of("element.omega_x") = spin * std::cos(skew);
  motion.start_of("element.omega_theta") = -spin * std::sin(skew);
}

/// Traction of an instant: one evaluation for each row, no motion.
Json skew_table(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  RollerMotion roller(in);
  Motion& motion = *roller.motion;
  motion.start_of("element.r") = get(in, "orbit_radius");
  motion.start_of("element.theta_dot") = get(in, "orbital_speed");
  Json rows = Json::array();
  for (const Json& asked : the_case.at("expected").at("rows")) {
    const double degrees = get(asked, "skew_deg");
    set_spin(motion, get(in, "roller_spin"), degrees * kDegree);
    const Evaluation& e = motion.evaluate(0.0, motion.start.data());
    Json row = {{"skew_deg", degrees}};
    double axial = 0.0, moment = 0.0;
    for (std::size_t j = 0; j < 2; ++j) {
      const Line& line = roller.walls->line[j];
      const Vec3 f = e.to_cylindrical(0, line.friction),
                 M = e.to_cylindrical(0, line.arm.cross(line.friction));
      row[kRace[j]] = {{"slip_axial", line.slip[0]},
                       {"slip_rolling", line.slip[2]},
                       {"F_axial", f[0]},
                       {"F_rolling", f[2]},
                       {"M_x", M[0]},
                       {"M_theta", M[2]},
                       {"heat", line.heat}};
      axial += f[0];
      moment += M[2];
    }
    row["net_axial"] = axial;
    row["net_M_theta"] = moment;
    rows.push_back(row);
  }
  Json out = {{"rows", rows}};
  motion.add_evaluation_record(out);
  return out;
}

/// Held at a skew: moments across the roller's axis are reacted, so that its attitude follows the
/// orbit.
Json held_case(const Json& the_case) {
  const Json &in = the_case.at("inputs"), &at = in.at("initial_state");
  const double skew = get(in, "skew_deg") * kDegree, inertia = get(in, "inertia");
  const Vec3 axis(std::cos(skew), 0.0, -std::sin(skew));
  RollerMotion roller(in, [=](Evaluation& e) {
    const Vec3 M(e.actions[3][0], e.actions[4][0], e.actions[5][0]);
    const double orbit = e.elements.theta_dot[0];
    const Vec3 turning =
        inertia * orbit * Vec3(0.0, -e.elements.omega_theta[0], e.elements.omega_r[0]);
    e.add_moment(0, M.dot(axis) * axis + turning - M);
  });
  Motion& motion = *roller.motion;
  for (const char* key : {"x", "r", "theta", "x_dot", "r_dot", "theta_dot"})
    motion.start_of("element." + std::string(key)) = get(at, key);
  set_spin(motion, get(at, "spin"), skew);
  const std::vector<double> times = sample_times(the_case);
  const Solution solution = roller.solve(times, false);
  Json out = {{"t", times},
              {"spin", solution.channel(motion.at("element.omega_x"), 1.0 / std::cos(skew))}};
  for (const char* key : {"x", "r", "theta", "x_dot", "r_dot", "theta_dot"})
    out[key] = solution.channel(motion.at("element." + std::string(key)));
  roller.add_integrals(solution, out);
  for (std::size_t i = 0; i < times.size(); ++i) {
    (void)motion.evaluate(times[i], solution.samples[i].data());
    double holding = 0.0;
    for (std::size_t j = 0; j < 2; ++j) {
      const Line& line = roller.walls->line[j];
      const double axial = line.friction[0];
      out["Q_" + kRace[j]].push_back(line.Q);
      out["axial_force_" + kRace[j]].push_back(axial);
      holding += kSide[j] * roller.walls->half * axial;
    }
    out["holding_moment_theta"].push_back(holding);
  }
  motion.add_evaluation_record(out);
  return out;
}

}  // namespace

std::optional<Json> evaluate_roller_case(const Json& the_case) {
  const std::string kind = kind_of(the_case);
  if (kind == "preloaded_concentric_races_roller") return planar_case(the_case);
  if (kind == "instantaneous_traction_skewed_cylindrical") return skew_table(the_case);
  if (kind == "roller_held_constant_skew") return held_case(the_case);
  return std::nullopt;
}

}  // namespace adore::validation
