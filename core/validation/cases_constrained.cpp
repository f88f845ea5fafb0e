#include "validation/cases_constrained.hpp"

#include "base/errors.hpp"
#include "dynamics/constrained.hpp"
#include "dynamics/held_rollers.hpp"
#include "dynamics/mode2.hpp"
#include "statics/roller_model.hpp"
#include "validation/adapter.hpp"
#include "validation/trajectory.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace adore::validation {
namespace {

using dynamics::BallBalance;
using dynamics::ConstrainedBall;
using dynamics::Orbit;
using dynamics::RacePose;
using dynamics::Vec2;

ConstrainedBall ball_of(const Json& in) {
  contact::GrooveGeometry groove;
  const double D = get(in, "ball_diameter");
  groove.ball_radius = 0.5 * D;
  std::array<double, 2> K{};
  for (std::size_t j = 0; j < 2; ++j) {
    const double f = in.at("f").at(j);
    require(f > 0.5, fmt::format("f = {:.6g}: the groove factor (groove radius divided by ball "
                                 "diameter) must be above 0.5. Enter a larger factor.",
                                 f));
    groove.groove_radius[j] = f * D;
    groove.offset[j] = (f - 0.5) * D;
    groove.centre_radius[j] = in.at("groove_circle_radius").at(j);
    K[j] = in.at("K").at(j);
  }
  return {groove, K, get(in, "mass")};
}

std::array<RacePose, 2> races_of(const Json& in) {
  return {RacePose{vec3(in.at("race_centre").at(0))}, RacePose{vec3(in.at("race_centre").at(1))}};
}

Vec2 first_guess(const ConstrainedBall& ball, const std::array<RacePose, 2>& races) {
  return {0.5 * (races[0].centre[0] + races[1].centre[0]), ball.mid_radius()};
}

Json angle_json(const dynamics::GrooveContact& contact) { return contact.angle / kDegree; }

Json ball_case(const Json& in) {
  const ConstrainedBall ball = ball_of(in);
  const auto races = races_of(in);
  const double theta = get(in, "theta");
  const Orbit orbit{Orbit::Kept::Speed, get(in, "theta_rate")};
  const Json& force = in.at("external_force_x_r");
  const BallBalance b =
      ball.solve(races, theta, orbit, Vec2(force.at(0).get<double>(), force.at(1).get<double>()),
                 first_guess(ball, races));
  const dynamics::BallSensitivity s = sensitivity(b, theta);
  return {{"x", b.x},
          {"r", b.r},
          {"Q_outer", b.contact[0].load},
          {"Q_inner", b.contact[1].load},
          {"alpha_outer_deg", angle_json(b.contact[0])},
          {"alpha_inner_deg", angle_json(b.contact[1])},
          {"force_theta", b.force_theta},
          {"x_per_inner_centre", json(Vec3(s.per_inner_centre.row(0)))},
          {"r_per_inner_centre", json(Vec3(s.per_inner_centre.row(1)))},
          {"x_per_theta", s.per_theta[0]},
          {"r_per_theta", s.per_theta[1]},
          {"x_per_theta_rate", s.per_orbit[0]},
          {"r_per_theta_rate", s.per_orbit[1]}};
}

Json idle_case(const Json& in) {
  const ConstrainedBall ball = ball_of(in);
  const auto races = races_of(in);
  const BallBalance b =
      ball.solve(races, get(in, "theta"), {}, Vec2::Zero(), first_guess(ball, races));
  return {{"x", b.x},
          {"r", b.r},
          {"Q_outer", b.contact[0].load},
          {"Q_inner", b.contact[1].load},
          {"inner_gap", -b.contact[1].approach}};
}

/// State: θ and L = m r² θ̇; x and r follow.
Json orbit_case(const Json& in) {
  const ConstrainedBall ball = ball_of(in);
  const auto races = races_of(in);
  const double theta0 = get(in, "theta0"), outside = get(in, "external_force_theta");
  const BallBalance start = ball.solve(races, theta0, {Orbit::Kept::Speed, get(in, "theta_rate0")},
                                       Vec2::Zero(), first_guess(ball, races));
  const double L0 = ball.mass() * start.r * start.r * start.speed;
  Vec2 last = start.place();
  const auto balance = [&](double theta, double L) {
    const BallBalance b = ball.solve(races, theta, {Orbit::Kept::Momentum, L}, Vec2::Zero(), last);
    last = b.place();
    return b;
  };
  const auto momentum_rate = [&](const BallBalance& b) { return b.r * (b.force_theta + outside); };

  Rates rates({1.0, std::abs(L0)}, [&](const double* y, double* d) {
    const BallBalance b = balance(y[0], y[1]);
    d[0] = b.speed;
    d[1] = momentum_rate(b);
  });
  const Solution solution =
      solve(Problem{rates, {theta0, L0}}, in.at("times").get<std::vector<double>>());
  Json out = Json::object();
  for (const State& y : solution.samples) {
    const BallBalance b = balance(y[0], y[1]);
    const Vec2 rate = implicit_rates(sensitivity(b, y[0]), b.speed, momentum_rate(b));
    out["theta"].push_back(y[0]);
    out["theta_rate"].push_back(b.speed);
    out["x"].push_back(b.x);
    out["r"].push_back(b.r);
    out["x_rate"].push_back(rate[0]);
    out["r_rate"].push_back(rate[1]);
    out["Q_outer"].push_back(b.contact[0].load);
    out["Q_inner"].push_back(b.contact[1].load);
    out["energy"].push_back(b.potential);
    out["eliminated_kinetic_energy"].push_back(0.5 * ball.mass() * rate.squaredNorm());
  }
  return out;
}

struct RollerOfCase {
  statics::RollerModel model;
  dynamics::ElementMasses masses;
};

/// Straight and without crown between cylinders, every slice with its share of K.
RollerOfCase roller_of(const Json& in) {
  bearing::Bearing b;
  b.type = bearing::Type::Cylindrical;
  for (auto* m : {&b.element_material, &b.race_material[0], &b.race_material[1]})
    m->elastic_modulus = 1.0;  // K is given
  const double D = get(in, "roller_diameter");
  const double outer = in.at("raceway_radius").at(0), inner = in.at("raceway_radius").at(1);
  bearing::RollerGeometry g;
  g.count = 1;
  g.diameter = g.length = g.central_length = D;
  g.crown_radius = std::numeric_limits<double>::infinity();
  g.land_width = {3.0 * D, 3.0 * D};  // the ends of a roller at the ends of a land push it along
  g.pitch_diameter = outer + inner;
  g.clearance = 2.0 * (outer - inner - D);
  b.elements = g;
  b.element_inertia.mass = get(in, "mass");
  b.element_inertia.moments.setConstant(1.0);  // of no account
  statics::RollerModel model = statics::make_roller_model(b, {});
  for (std::size_t j = 0; j < 2; ++j)
    model.law[j].constant = in.at("K").at(j).get<double>() / model.slicing.effective_length;
  return {model, dynamics::ElementMasses(b)};
}

/// As a held roller finds its place in a run; that keeps m r² θ̇, here θ̇ is given.
Json constrained_roller_case(const Json& in) {
  const auto [model, masses] = roller_of(in);
  const double theta = get(in, "theta"), speed = get(in, "theta_rate");
  dynamics::QuasiStaticRollers held(model, {}, masses);
  dynamics::Evaluation e(1);
  const auto races = races_of(in);
  for (std::size_t j = 0; j < 2; ++j) e.race[j].position = races[j].centre;
  e.attitude.assign(1, Mat3::Identity());
  e.sin_theta[0] = std::sin(theta);
  e.cos_theta[0] = std::cos(theta);
  const double zero = 0.0;
  // A loose roller is on the outer race: a step of the balance is short against its clearance.
  double r = std::max(0.5 * model.rollers.pitch_diameter,
                      in.at("raceway_radius").at(0).get<double>() - 0.5 * model.rollers.diameter +
                          races[0].centre.dot(radial_direction(theta)));
  e.elements = {.n = 1,
                .x = &zero,
                .r = &r,
                .sin_theta = e.sin_theta.data(),
                .cos_theta = e.cos_theta.data(),
                .x_dot = &zero,
                .r_dot = &zero,
                .theta_dot = &speed,
                .omega_x = &zero,
                .omega_r = &zero,
                .omega_theta = &zero,
                .theta = &theta};
  for (int k = 0; k < 20; ++k) {
    const dynamics::QuasiStaticPosition at = held.balanced(e, 0, Vec2::Zero());
    demand(at.solved, "no force balance of the roller was found");
    r = at.r;
  }
  const std::vector<std::size_t> list{0};
  std::vector<dynamics::ContactLinearization> springs(1);
  held.springs(e, list, springs);
  std::array<double, 2> Q{};
  for (std::size_t j = 0; j < 2; ++j) {
    const Vec3 d = e.element_centre(0) - races[j].centre;
    statics::PairPotential potential;
    statics::add_race(model, model.body(0), j, {0.0, std::hypot(d[1], d[2]), 0.0, 0.0}, potential);
    Q[j] = potential.total;
  }
  return {{"r", r}, {"Q_outer", Q[0]}, {"Q_inner", Q[1]}, {"force_theta", springs[0].normal[2]}};
}

Json mode2_case(const Json& in) {
  const ConstrainedBall ball = ball_of(in);
  const int n = in.at("nRe");
  std::vector<double> theta;
  for (int k = 0; k < n; ++k) theta.push_back(get(in, "theta0") + 2.0 * kPi * k / n);
  const std::vector<Orbit> orbit(theta.size(), {Orbit::Kept::Speed, get(in, "theta_rate")});
  const dynamics::Mode2Solution solution = dynamics::solve_mode2(
      ball, {RacePose{vec3(in.at("outer_centre"))}, RacePose{vec3(in.at("guess_inner_centre"))}},
      theta, orbit, vec3(in.at("load_on_inner")));
  Json out = {{"inner_centre", json(solution.inner_centre)},
              {"inner_centre_velocity", json(solution.inner_velocity)}};
  for (const BallBalance& b : solution.balls) {
    out["x"].push_back(b.x);
    out["r"].push_back(b.r);
    out["Q_outer"].push_back(b.contact[0].load);
    out["Q_inner"].push_back(b.contact[1].load);
  }
  return out;
}

Json switch_case(const Json& in) {
  const ConstrainedBall ball = ball_of(in);
  const auto races = races_of(in);
  const double theta = get(in, "theta"), r = get(in, "r");
  const Orbit orbit{Orbit::Kept::Momentum, ball.mass() * r * r * get(in, "theta_rate")};
  const Vec2 place(get(in, "x"), r), rates(get(in, "x_rate"), get(in, "r_rate"));
  const dynamics::QuasiStaticTransition change =
      dynamics::hold(ball, races, theta, orbit, Vec2::Zero(), place, rates);
  return {{"x", change.after.x},
          {"r", change.after.r},
          {"theta_rate", change.after.speed},
          {"energy_before", change.energy_before},
          {"energy_after", change.after.potential},
          {"booked_jump", change.jump}};
}

Json sequence_case(const Json& in) {
  bool held = in.at("initially_held");
  const double threshold = get(in, "qFac") * get(in, "force_scale");
  Json states = Json::array();
  for (std::size_t i = 0; i < in.at("Q_outer").size(); ++i) {
    const double outer = in.at("Q_outer").at(i), inner = in.at("Q_inner").at(i);
    held = dynamics::is_quasi_static_next(held, std::max(outer, inner), threshold,
                                          get(in, "release_ratio"));
    states.push_back(held ? 1 : 0);
  }
  return {{"held", states}};
}

Json kdof_case(const Json& in) {
  auto element = in.at("element_accelerations").get<std::array<double, 6>>();
  auto cage = in.at("cage_accelerations").get<std::array<double, 6>>();
  dynamics::suppress_accelerations(in.at("kDOF"), element, cage);
  return {{"element_accelerations", element}, {"cage_accelerations", cage}};
}

}  // namespace

std::optional<Json> evaluate_constraint_case(const Json& the_case) {
  const std::string kind = kind_of(the_case);
  const Json& in = the_case.at("inputs");
  if (kind == "mode1_ball") return ball_case(in);
  if (kind == "mode1_idle") return idle_case(in);
  if (kind == "mode1_orbit") return orbit_case(in);
  if (kind == "mode1_roller") return constrained_roller_case(in);
  if (kind == "mode2_ball_bearing") return mode2_case(in);
  if (kind == "qfac_switch_energy") return switch_case(in);
  if (kind == "qfac_sequence") return sequence_case(in);
  if (kind == "kdof") return kdof_case(in);
  return std::nullopt;
}

}  // namespace adore::validation
