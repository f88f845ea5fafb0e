#include "dynamics/state_access.hpp"
#include "scene/user_laws.hpp"
#include "validation/ball_scenario.hpp"
#include "validation/scenarios.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

/// dynamics_pocket and dynamics_rigid_whirl: the solver's cage with its pockets and guide lands,
/// whose walls are linear springs here, as the cases say: the routines ADRX3 and ADRX4 of a user.
namespace adore::validation {
namespace {

using dynamics::Evaluation;

/// F = k δ.
class LinearWalls final : public scene::UserLaws, public scene::UserContactForce {
 public:
  explicit LinearWalls(double stiffness) : stiffness_(stiffness) { pocket = land = this; }
  bool forces(double, const Contacts& contacts) noexcept override {
    for (std::size_t i = 0; i < contacts.n; ++i)
      contacts.force[i] = stiffness_ * std::max(-contacts.gap[i], 0.0);
    return true;
  }
  [[nodiscard]] bool failed() const noexcept override { return false; }
  bool refused() noexcept override { return false; }

 private:
  double stiffness_;
};

/// Sample times with one a little later, so that an event at the very end is found.
std::vector<double> slightly_longer(std::vector<double> times) {
  times.push_back(times.back() * (1 + 1e-6));
  return times;
}

// ---- dynamics_pocket

/// A ball in a round pocket of a cage that nothing moves; mass and inertia of the ball as given.
SmallScene pocket_scene(const bearing::Inertia& ball, double clearance, double stiffness) {
  SmallScene scene;
  scene.bearing.element_inertia = ball;
  constexpr double kImmovable = 1e18;
  add_cage(scene, kImmovable, Vec3::Constant(kImmovable));
  scene.bearing.cage->pocket_clearance_1 = 2.0 * clearance;
  scene.have({scene::Effect::PocketContact});
  scene.options.user = std::make_shared<LinearWalls>(stiffness);
  return scene;
}

bearing::Inertia ball_inertia(double mass, double inertia) {
  bearing::Inertia out;
  out.mass = mass;
  out.moments.setConstant(inertia);
  return out;
}

void scale_pocket(Motion& ball, double clearance, double speed) {
  const double r = ball.start_of("element.r");
  for (const char* group : {"element.x", "element.r"}) ball.scale(group, clearance);
  for (const char* group : {"element.x_dot", "element.r_dot"}) ball.scale(group, speed);
  ball.scale("element.theta", clearance / r);
  ball.scale("element.theta_dot", speed / r);
}

/// @pre the state was evaluated
double penetration(const Motion& ball) { return -ball.view().pocket_gap(); }

/// The frictionless cases: s tangential in the sense of rotation, which at azimuth 0 is -y.
Json rectilinear(const Json& the_case, double clearance, const Vec3& at_x_s, const Vec3& rate_x_s,
                 double push) {
  const Json& in = the_case.at("inputs");
  const double m = get(in, "ball_mass"), k = get(in, "pocket_stiffness");
  SmallScene scene = pocket_scene(ball_inertia(m, m), clearance, k);
  const double pitch_radius = 0.5 * scene.bearing.balls().pitch_diameter;
  add(scene, {[=](Evaluation& e, const dynamics::RaceModels&) {
                e.add_force(0, e.to_cylindrical(0, Vec3(0.0, -push, 0.0)));
              },
              {},
              {}});
  Motion ball(std::move(scene));
  ball.place(0, Vec3(at_x_s[0], -at_x_s[1], pitch_radius), Vec3(rate_x_s[0], -rate_x_s[1], 0.0),
             Vec3::Zero());
  scale_pocket(ball, clearance,
               std::max(rate_x_s.norm(), std::sqrt(std::abs(push) * clearance / m)));
  Problem problem = ball.problem();
  problem.longest_step = 0.2 * std::sqrt(m / k);
  const auto evaluated = [&](double t, const double* y) -> const Evaluation& {
    return ball.evaluate(t, y);
  };
  problem.events = {
      [&](double t, const double* y) { return (void)evaluated(t, y), penetration(ball); },
      [&](double t, const double* y) { return -evaluated(t, y).element_velocity(0)[1]; }};
  const auto times = sample_times(the_case);
  const Solution solution = ball.solve(problem, slightly_longer(times));
  Json result = {{"contact_start_times", solution.times_of(0, true)},
                 {"contact_end_times", solution.times_of(0, false)},
                 {"peak_pocket_forces", Json::array()},
                 {"azimuth_of_contact_start", Json::array()},
                 {"t", times}};
  for (const Event& event : solution.events) {
    const Vec3 place = evaluated(event.t, event.y.data()).element_centre(0);
    const double depth = penetration(ball);
    if (event.index == 1 && depth > 0.0) result["peak_pocket_forces"].push_back(k * depth);
    if (event.index == 0 && event.rising)
      result["azimuth_of_contact_start"].push_back(std::atan2(-place[1], place[0]));
  }
  for (std::size_t i = 0; i < times.size(); ++i) {
    const Evaluation& e = evaluated(times[i], solution.samples[i].data());
    const Vec3 place = e.element_centre(0), velocity = e.element_velocity(0);
    result["x"].push_back(place[0]);
    result["s"].push_back(-place[1]);
    result["x_dot"].push_back(velocity[0]);
    result["s_dot"].push_back(-velocity[1]);
    result["angular_momentum_per_mass"] = place[1] * velocity[0] - place[0] * velocity[1];
  }
  ball.add_evaluation_record(result);
  return result;
}

/// Pocket of a cage that turns about X; the ball with or without a fixed outer race.
Json rotating_pocket(const Json& the_case) {
  const Json &in = the_case.at("inputs"), &start = in.at("initial_state");
  const double m = get(in, "ball_mass"), k = get(in, "pocket_stiffness"),
               D = get(in, "ball_diameter"), clearance = get(in, "pocket_radial_clearance"),
               speed = get(in, "cage_speed_rad_s");
  const Vec3 velocity = vec3(start.at("velocity")), omega = vec3(start.at("omega"));
  const bool on_race = in.contains("outer_race");
  SmallScene scene = pocket_scene(ball_inertia(m, get(in, "ball_inertia")), clearance, k);
  scene.bearing.balls().diameter = D;
  if (on_race) {
    const Json& race = in.at("outer_race");
    const double offset = get(race, "groove_minus_ball_radius"),
                 centre = get(race, "groove_centre_radius"), touch = centre + offset;
    constexpr double kInnerFactor = 0.6, kInnerGap = 5e-4;  // of a groove out of reach [-, m]
    set_grooves(scene, D, {0.5 + offset / D, kInnerFactor},
                {centre, touch - kInnerGap + (kInnerFactor - 0.5) * D}, 0.5 * D / touch);
    set_hertz_constant(scene, 0, get(race, "K"));
    scene.bearing.race_traction = traction_law(in.at("race_law"));
    scene.options.surface = contact_surface(race.at("contact_surface").get<std::string>());
    scene.have({scene::Effect::RaceContact, scene::Effect::RaceTraction});
    (void)install_converged_traction(scene, split_rule(16));
    add_heat_integrals(scene, 1);
  }
  scene.have({scene::Effect::PocketTraction});
  const bearing::TractionCurve curve = traction_law(in.at("pocket_law"));
  scene.bearing.pocket_traction = curve;
  // Effect of the pocket, for separate ledgers: those of ADRX3 book its changes as heat.
  const tribology::TractionLaw law(curve);
  Motion* motion = nullptr;
  const auto pocket = [&, law](const Evaluation& e) {
    return dynamics::wall_contact(e, 0, e.segments[0], motion->view().pocket_normal(), 0.5 * D,
                                  linear_spring(k), penetration(*motion), law);
  };
  double work = 0.0, heat = 0.0;
  add(scene, {{},
              [&](Evaluation& e, const dynamics::RaceModels&) {
                const dynamics::WallContact action = pocket(e);
                heat = action.heat;
                work = action.on_element.dot(e.segments[0].velocity_at(action.point));
              },
              {{"work", &work}, {"heat pocket", &heat}}});
  Motion ball(std::move(scene));
  motion = &ball;
  ball.place(0, vec3(start.at("position")), velocity, omega);
  set_cage_start(ball, get(in, "pocket_axial_position") * Vec3::UnitX(), Vec3::Zero(),
                 quaternion_about(Vec3::UnitX(), get(in, "pocket_azimuth_at_t0")),
                 speed * Vec3::UnitX());
  scale_pocket(ball, clearance, velocity.norm());
  for (const char* group : {"element.omega_x", "element.omega_r", "element.omega_theta"})
    ball.scale(group, std::max(omega.norm(), 2.0 * velocity.norm() / D));
  Problem problem = ball.problem();
  problem.tolerance = 1e-12;
  if (on_race) problem.stepper = "pece8";  // two evaluations of the contact ellipse per step
  problem.longest_step = 0.2 * std::sqrt(m / k);
  problem.events = {
      [&](double t, const double* y) { return (void)ball.evaluate(t, y), penetration(ball); },
      [&](double t, const double* y) { return pocket(ball.evaluate(t, y)).rate; }};
  const auto times = sample_times(the_case);
  const Solution solution = ball.solve(problem, times);
  double peak = 0.0;
  for (const Event& event : solution.events)
    if (event.index == 1) {
      (void)ball.evaluate(event.t, event.y.data());
      peak = std::max(peak, k * penetration(ball));
    }
  Json result = {{"t", times},
                 {"contact_start_times", solution.times_of(0, true)},
                 {"contact_end_times", solution.times_of(0, false)},
                 {"peak_pocket_force_on_fine_grid", peak},
                 {"work_by_moving_surfaces", solution.channel(ball.at("work"))},
                 {"heat_pocket", solution.channel(ball.at("heat pocket"))},
                 {"heat_race", on_race ? solution.channel(ball.at(heat_integral_name(0, 0)))
                                       : Json(std::vector<double>(times.size(), 0.0))}};
  for (std::size_t i = 0; i < times.size(); ++i) {
    const Evaluation& e = ball.evaluate(times[i], solution.samples[i].data());
    result["position"].push_back(json(e.element_centre(0)));
    result["velocity"].push_back(json(e.element_velocity(0)));
    result["omega"].push_back(json(e.element_omega(0)));
    result["pocket_penetration"].push_back(std::max(penetration(ball), 0.0));
    if (on_race) result["Q_outer"].push_back(e.load[0][0]);
  }
  ball.add_evaluation_record(result);
  return result;
}

// ---- dynamics_rigid_whirl

/// A cage of given moments that nothing touches.
Json rotation(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  const Vec3 I = vec3(in.at("inertia_principal_xyz")), w0 = vec3(in.at("omega_body0"));
  const Vec3 inertial = vec3(in.at("torque_inertial")), in_body = vec3(in.at("torque_body"));
  const Quat q0 = quaternion_from_angles(vec3(in.at("angles0_eta_xi_lambda")));
  SmallScene scene;
  add_cage(scene, 1.0, I);
  add(scene, {[=](Evaluation& e, const dynamics::RaceModels&) {
                e.segments[0].moment += inertial + e.segments[0].to_base * in_body;
              },
              {},
              {}});
  Motion cage(std::move(scene));
  set_cage_start(cage, Vec3::Zero(), Vec3::Zero(), q0, w0);
  Problem problem = cage.problem();
  problem.longest_step = 0.5 / w0.norm();
  const auto times = sample_times(the_case);
  const Solution solution = cage.solve(problem, times);
  Json result = {{"t", times}};
  for (std::size_t i = 0; i < times.size(); ++i) {
    const dynamics::BodyState& body =
        cage.evaluate(times[i], solution.samples[i].data()).segments[0];
    const Mat3& R = body.to_base;
    const Vec3 H = I.cwiseProduct(body.omega_body);
    result["omega_body"].push_back(json(body.omega_body));
    result["omega_inertial"].push_back(json(body.omega));
    result["body_x_axis_inertial"].push_back(json(Vec3(R.col(0))));
    result["body_y_axis_inertial"].push_back(json(Vec3(R.col(1))));
    result["angles_eta_xi_lambda"].push_back(json(angles_from_quaternion(body.attitude)));
    result["angular_momentum_inertial"].push_back(json(Vec3(R * H)));
    result["kinetic_energy"].push_back(0.5 * body.omega_body.dot(H));
  }
  // Steady precession of a free symmetric body, from its rates at the start.
  const dynamics::BodyState& body = cage.evaluate(0.0, cage.start.data()).segments[0];
  const Vec3 H = body.to_base * I.cwiseProduct(w0), axis = H.normalized(), x = body.to_base.col(0);
  const Vec3 x_rate = body.omega.cross(x),
             w_rate = dynamics::vector_at(cage.rates().data(), {cage.at("cage.omega"), 3});
  const double across = w0[1] * w0[1] + w0[2] * w0[2], sine2 = 1 - x.dot(axis) * x.dot(axis);
  if (across > 0.0 && sine2 > 0.0) {
    result["body_cone_rate"] = (w0[1] * w_rate[2] - w0[2] * w_rate[1]) / across;
    result["precession_rate"] = axis.dot(x.cross(x_rate)) / sine2;
    result["nutation_angle"] = std::atan2(x.cross(axis).norm(), x.dot(axis));
    result["precession_axis"] = json(axis);
  }
  cage.add_evaluation_record(result);
  return result;
}

/// Planar cage in a circular land. The cases take the surface of the land with one speed; that of
/// the solver turns, so that its speed at the contact changes with eccentricity. A cage and land of
/// kEnlarged times the radius that turn as much more slowly are the same motion (moment of inertia
/// times kEnlarged²), and the speed of that land is constant to 1e-8.
class Whirl {
 public:
  explicit Whirl(const Json& in)
      : clearance_(get(in, "radial_guide_clearance")),
        stiffness_(get(in, "contact_stiffness")),
        cage_radius_(kEnlarged * get(in, "cage_guide_radius")),
        land_speed_(get(in, "land_speed_rad_s") * get(in, "land_radius")),
        outer_(in.at("guidance") == "outer") {
    const auto guide = static_cast<std::size_t>(outer_ ? bearing::kOuter : bearing::kInner);
    SmallScene scene;
    add_cage(scene, get(in, "cage_mass"),
             Vec3::Constant(kEnlarged * kEnlarged * get(in, "cage_Ix")));
    using Guide = bearing::GuideLand::Guide;
    constexpr double kWidth = 0.01;
    scene.bearing.cage->lands = {{outer_ ? Guide::Outer : Guide::Inner,
                                  2.0 * cage_radius_,
                                  kWidth,
                                  0.5 * kWidth,
                                  2.0 * clearance_,
                                  {},
                                  {}}};
    scene.options.land_slices = 1;
    scene.bearing.land_traction = traction_law(in.at("friction_law"));
    scene.options.user = std::make_shared<LinearWalls>(stiffness_);
    scene.bearing.speed[guide] = land_speed_ / (cage_radius_ + side() * clearance_);
    scene.bearing.gravity =
        Vec3(0.0, in.at("gravity_yz")[0].get<double>(), in.at("gravity_yz")[1].get<double>());
    scene.plan.suppressed.element_all = true;
    scene.have({scene::Effect::LandContact, scene::Effect::LandTraction, scene::Effect::Gravity});
    add(scene, {{},
                [this, guide](Evaluation& e, const dynamics::RaceModels&) {
                  const dynamics::BodyState& cage = e.segments[0];
                  const Vec3 &at = cage.position, &v = cage.velocity;
                  const double e2 = at.squaredNorm();
                  whirl_ = e2 > 0.0 ? (at[1] * v[2] - at[2] * v[1]) / e2 : 0.0;
                  // The normal force passes through the axis of the race.
                  const double friction =
                      -e.race[guide].moment[0] / (cage_radius_ + side() * std::sqrt(e2));
                  work_ = friction * land_speed_;
                  heat_ = friction * slip(cage);
                },
                {{"whirl", &whirl_}, {"work", &work_}, {"heat", &heat_}}});
    motion_ = std::make_unique<Motion>(std::move(scene));
    const Json& start = in.at("initial_state");
    set_cage_start(*motion_, Vec3(0.0, get(start, "y"), get(start, "z")),
                   Vec3(0.0, get(start, "vy"), get(start, "vz")), {1, 0, 0, 0},
                   get(start, "omega") / kEnlarged * Vec3::UnitX());
    const double v = std::max(std::hypot(get(start, "vy"), get(start, "vz")), 1e-2);
    motion_->scale("cage.position", clearance_);
    motion_->scale("cage.velocity", v);
    whirl_start_ = std::atan2(get(start, "z"), get(start, "y"));
  }

  Json run(const Json& the_case) {
    Problem problem = motion_->problem();
    problem.longest_step = 0.2 * std::sqrt(get(the_case.at("inputs"), "cage_mass") / stiffness_);
    const auto cage = [this](double t, const double* y) -> const dynamics::BodyState& {
      return motion_->evaluate(t, y).segments[0];
    };
    problem.events = {
        [&](double t, const double* y) { return cage(t, y).position.norm() - clearance_; },
        [&](double t, const double* y) { return slip(cage(t, y)); }};
    const auto times = sample_times(the_case);
    std::vector<double> all = times;  // the last tenth starts at a separate time
    const double last_tenth = times.front() + 0.9 * (times.back() - times.front());
    const auto where = std::lower_bound(all.begin(), all.end(), last_tenth);
    const auto extra = static_cast<std::size_t>(where - all.begin());
    all.insert(where, last_tenth);
    Solution solution = motion_->solve(problem, all);
    const auto whirl = static_cast<std::size_t>(motion_->at("whirl"));
    const double whirl_then = solution.samples[extra][whirl];
    solution.samples.erase(solution.samples.begin() + static_cast<std::ptrdiff_t>(extra));
    Json result = {{"t", times},
                   {"work_by_land", solution.channel(motion_->at("work"))},
                   {"heat", solution.channel(motion_->at("heat"))}};
    for (std::size_t i = 0; i < times.size(); ++i) {
      const dynamics::BodyState& body = cage(times[i], solution.samples[i].data());
      const double e = body.position.norm();
      result["y"].push_back(body.position[1]);
      result["z"].push_back(body.position[2]);
      result["vy"].push_back(body.velocity[1]);
      result["vz"].push_back(body.velocity[2]);
      result["omega"].push_back(kEnlarged * body.omega[0]);
      result["whirl_angle_unwrapped"].push_back(whirl_start_ + solution.samples[i][whirl]);
      result["eccentricity_over_clearance"].push_back(e / clearance_);
      result["guide_force"].push_back(stiffness_ * std::max(e - clearance_, 0.0));
      result["slip"].push_back(slip(body));
    }
    const double turned = solution.samples.back()[whirl], span = times.back() - times.front();
    result["whirl_turns"] = turned / (2 * kPi);
    result["mean_whirl_speed_last_tenth"] = (turned - whirl_then) / (times.back() - last_tenth);
    const double last = result["eccentricity_over_clearance"].back().get<double>() * clearance_;
    result["closed_form"] = {{"eccentricity", last},
                             {"guide_force", result["guide_force"].back()},
                             {"whirl_speed", turned / span}};
    motion_->add_evaluation_record(result);
    return result;
  }

 private:
  static constexpr double kEnlarged = 1e4;

  [[nodiscard]] double side() const { return outer_ ? 1.0 : -1.0; }
  /// Land minus cage, along X × (outward of the land's axis at the contact).
  [[nodiscard]] double slip(const dynamics::BodyState& cage) const {
    const double e = cage.position.norm();
    const Vec3 out = e > 0.0 ? Vec3(side() / e * cage.position) : Vec3(Vec3::Zero());
    return land_speed_ -
           (cage.velocity.dot(Vec3::UnitX().cross(out)) + cage.omega[0] * cage_radius_);
  }

  double clearance_, stiffness_, cage_radius_, land_speed_;
  bool outer_;
  double whirl_ = 0.0, work_ = 0.0, heat_ = 0.0;  ///< now [rad/s, W, W]
  double whirl_start_ = 0.0;
  std::unique_ptr<Motion> motion_;
};

}  // namespace

std::optional<Json> evaluate_pocket_motion_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  if (in.contains("pocket_half_clearance"))
    return rectilinear(
        the_case, get(in, "pocket_half_clearance"), Vec3(0.0, get(in, "initial_position"), 0.0),
        Vec3(0.0, get(in, "initial_relative_velocity"), 0.0), get(in, "constant_force"));
  if (in.contains("position0_x_s")) {
    const auto pair = [&](const char* key) {
      return Vec3(in.at(key).at(0).get<double>(), in.at(key).at(1).get<double>(), 0.0);
    };
    return rectilinear(the_case, get(in, "pocket_radial_clearance"), pair("position0_x_s"),
                       pair("velocity0_x_s"), 0.0);
  }
  if (in.contains("cage_speed_rad_s")) return rotating_pocket(the_case);
  return std::nullopt;
}

std::optional<Json> evaluate_rigid_whirl_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  if (in.contains("inertia_principal_xyz")) return rotation(the_case);
  if (in.contains("radial_guide_clearance")) return Whirl(in).run(the_case);
  return std::nullopt;
}

}  // namespace adore::validation
