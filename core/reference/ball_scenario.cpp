#include "reference/ball_scenario.hpp"

#include "base/errors.hpp"
#include "bearing/material.hpp"
#include "contact/groove.hpp"
#include "dynamics/ball_motion.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <complex>

namespace adore::reference {
namespace {

constexpr std::size_t kX = 0, kR = 1, kTheta = 2, kXRate = 3, kRRate = 4, kThetaRate = 5,
                      kOmega = 6;

/// One element, its quantities in their order.
dynamics::ElementSlices ball_slices() {
  dynamics::ElementSlices slices;
  for (std::size_t q = 0; q < dynamics::kQuantities.size(); ++q)
    slices[static_cast<dynamics::Quantity>(q)] = {static_cast<int>(q), 1};
  return slices;
}

double density_mass(const Json& in) { return get(in.at("derived"), "ball_mass"); }

}  // namespace

tribology::ContactSurface contact_surface(const std::string& name) {
  using tribology::ContactSurface;
  if (name == "curved_edge") return ContactSurface::CurvedEdge;
  if (name == "curved_half") return ContactSurface::CurvedHalf;
  if (name == "curved_undeformed") return ContactSurface::CurvedUndeformed;
  if (name == "flat_undeformed") return ContactSurface::FlatUndeformed;
  if (name == "flat_half") return ContactSurface::FlatHalf;
  if (name == "flat_edge") return ContactSurface::FlatEdge;
  throw InputError(
      fmt::format("contact_surface \"{}\" is none of curved_edge, curved_half, curved_undeformed, "
                  "flat_undeformed, flat_half, flat_edge",
                  name));
}

BallLoad ball_load(const dynamics::RaceContactModel& model, const dynamics::ElementViews& balls,
                   std::size_t index, const dynamics::RaceMotion& race, const TractionRule& rule) {
  BallLoad load;
  load.contact = dynamics::race_contact_state(model, balls, index, race);
  const dynamics::RaceContactState& s = load.contact;
  if (!(s.approach > 0.0)) return load;
  load.Q = s.ellipse.Q;
  load.force = -load.Q * s.n;
  if (!model.traction) return load;
  const Vec3 e_r(0.0, -balls.sin_theta[index], balls.cos_theta[index]);
  const Vec3 velocity = balls.x_dot[index] * Vec3::UnitX() + balls.r_dot[index] * e_r +
                        balls.r[index] * balls.theta_dot[index] * Vec3::UnitX().cross(e_r);
  const Vec3 slip = race.velocity + race.speed * race.axis.cross(s.arm) - velocity;
  const SurfaceTraction surface = rule(model.law, s, slip.dot(s.n));
  load.traction = surface.in_plane;
  const tribology::EllipseTraction& f = load.traction;
  load.force += f.F_c * s.c + f.F_t * s.t + surface.F_n * s.n;
  load.moment = f.M_c * s.c + f.M_t * s.t + f.M_n * s.n;
  load.heat = f.heat;
  return load;
}

dynamics::RaceContactModel outer_race_model(const Json& race, const bearing::TractionCurve& curve,
                                            double ball_radius) {
  dynamics::RaceContactModel model;
  model.race = bearing::kOuter;
  model.groove.ball_radius = ball_radius;
  model.groove.offset[0] = get(race, "groove_minus_ball_radius");
  model.groove.groove_radius[0] = ball_radius + model.groove.offset[0];
  model.groove.centre_radius[0] = get(race, "groove_centre_radius");
  model.hertz.K = get(race, "K");
  model.hertz.a_hat = get(race, "a_over_Q13");
  model.hertz.b_hat = get(race, "b_over_Q13");
  model.law = curve;
  model.surface = contact_surface(race.at("contact_surface").get<std::string>());
  return model;
}

BallLoad load_on_free_ball(const dynamics::RaceContactModel& model, double race_speed,
                           const double* y) {
  const Vec3 position(y[0], y[1], y[2]), velocity(y[3], y[4], y[5]), omega(y[6], y[7], y[8]);
  const double theta = azimuth(position), s = std::sin(theta), c = std::cos(theta);
  const Vec3 e_r = radial_direction(theta), e_t = circumferential_direction(theta);
  const double x = position[0], r = position.dot(e_r), x_dot = velocity[0],
               r_dot = velocity.dot(e_r);
  const double theta_dot = velocity.dot(e_t) / r, wx = omega[0], wr = omega.dot(e_r),
               wt = omega.dot(e_t);
  const dynamics::ElementViews ball{1, &x, &r, &s, &c, &x_dot, &r_dot, &theta_dot, &wx, &wr, &wt};
  const dynamics::RaceMotion race{Vec3::Zero(), Vec3::UnitX(), race_speed, Vec3::Zero()};
  return ball_load(model, ball, 0, race, split_rule(16));
}

BallBetweenRaces::BallBetweenRaces(const Json& in, const Vec3& inner_centre, bool traction)
    : slices_(ball_slices()),
      mass_(density_mass(in)),
      ball_radius_(0.5 * get(in.at("bearing"), "D")),
      orbit_radius_(0.5 * get(in.at("bearing"), "dm")) {
  const Json& b = in.at("bearing");
  bearing::BallGeometry balls;
  balls.count = whole_or(in, "n_balls", whole_or(b, "Z", 1, 1, kMostElements), 1, kMostElements);
  balls.diameter = get(b, "D");
  balls.pitch_diameter = get(b, "dm");
  balls.contact_angle = get(b, "alpha0");
  balls.groove_factor = {get(b, "fo"), get(b, "fi")};
  bearing::Material steel;
  steel.elastic_modulus = get(b, "E");
  steel.poisson_ratio = get(b, "nu");
  const double E_star = bearing::contact_modulus(steel, steel);
  contact::GrooveGeometry groove = contact::groove_geometry(balls);
  // The family puts the whole clearance on the inner race.
  groove.centre_radius = {get(in.at("derived"), "Rc_outer"), get(in.at("derived"), "Rc_inner")};
  for (std::size_t j = 0; j < 2; ++j) {
    dynamics::RaceContactModel& model = models_[j];
    model.race = static_cast<bearing::Race>(j);
    model.groove = groove;
    model.hertz = contact::hertz_constants(
        contact::race_curvature(balls, static_cast<int>(j), balls.contact_angle), E_star);
    model.effective_modulus = E_star;
    model.traction = traction;
    if (traction) model.law = traction_law(in.at("traction_law"));
    if (in.contains("contact_surface"))
      model.surface = contact_surface(in["contact_surface"].get<std::string>());
    races_[j] = {Vec3::Zero(), Vec3::UnitX(), 0.0, Vec3::Zero()};
  }
  races_[0].speed = in.value("outer_speed_rad_s", 0.0);
  races_[1].speed = in.value("inner_speed_rad_s", 0.0);
  races_[1].centre = inner_centre;
}

State BallBetweenRaces::rolling_start(double x, double r) {
  Vec3 speeds = Vec3::Zero();  // θ', ω_x, ω_r
  const auto state = [&](double at_x, double at_r, const Vec3& at) {
    return State{at_x, at_r, 0, 0, 0, at[0], at[1], at[2], 0, 0, 0, 0};
  };
  const auto rolling = [&](const Vec3& unknown) {
    const auto [outer, inner] = loads(state(x, r, unknown).data());
    const auto slip = [](const BallLoad& load) {
      return load.contact.motion.u_t - load.contact.motion.W_c * load.contact.ellipse.h0;
    };
    return Vec3(slip(outer), slip(inner), outer.contact.motion.W_n);
  };
  const auto imbalance = [&](double at_x, double at_r) {
    Eigen::Vector2d sum(0.0, mass_ * at_r * speeds[0] * speeds[0]);
    for (const BallLoad& load : loads(state(at_x, at_r, speeds).data()))
      sum -= load.Q * Eigen::Vector2d(load.contact.n[0], load.contact.n[2]);  // θ = 0: e_r = e_z
    return sum;
  };
  for (int iteration = 0; iteration < 40; ++iteration) {
    const Vec3 offset = rolling(Vec3::Zero());  // linear in the three speeds
    Mat3 slopes;
    for (int k = 0; k < 3; ++k) slopes.col(k) = rolling(Vec3::Unit(k)) - offset;
    speeds = slopes.fullPivLu().solve(-offset);
    const double h = 1e-10;
    Eigen::Matrix2d stiffness;
    stiffness.col(0) = (imbalance(x + h, r) - imbalance(x - h, r)) / (2 * h);
    stiffness.col(1) = (imbalance(x, r + h) - imbalance(x, r - h)) / (2 * h);
    const Eigen::Vector2d step = stiffness.fullPivLu().solve(-imbalance(x, r));
    x += step[0];
    r += step[1];
    if (step.norm() < 1e-16) break;
  }
  return {x, r, 0, 0, 0, speeds[0], speeds[1], speeds[2], 0};
}

void BallBetweenRaces::set_surface(tribology::ContactSurface surface) {
  for (dynamics::RaceContactModel& model : models_) model.surface = surface;
}

dynamics::ElementViews BallBetweenRaces::view(const double* y) {
  dynamics::ElementViews ball;
  (void)dynamics::view_elements(y, slices_, &sin_theta_, &cos_theta_, ball);
  return ball;
}

std::array<BallLoad, 2> BallBetweenRaces::loads(const double* y) {
  const dynamics::ElementViews ball = view(y);
  std::array<BallLoad, 2> result;
  for (std::size_t j = 0; j < 2; ++j) result[j] = ball_load(models_[j], ball, 0, races_[j], rule_);
  return result;
}

void BallBetweenRaces::rates(const double* y, double* d) {
  const dynamics::ElementViews ball = view(y);
  const double theta = y[kTheta];
  const Vec3 e_r = radial_direction(theta), e_t = circumferential_direction(theta);
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
  for (std::size_t j = 0; j < 2; ++j) {
    const BallLoad load = ball_load(models_[j], ball, 0, races_[j], rule_);
    force += load.force;
    moment += load.moment;
    d[kMechanical + j] = load.heat;
    if (j == 1)
      d[kMechanical + 2] =
          races_[1].speed * (load.contact.arm.cross(load.force) + load.moment).dot(races_[1].axis);
  }
  const std::array acting{force[0],  force.dot(e_r),  force.dot(e_t),
                          moment[0], moment.dot(e_r), moment.dot(e_t)};
  for (std::size_t k = 0; k < acting.size(); ++k) actions_[k].assign(1, acting[k]);
  // Inertia of a solid sphere.
  (void)dynamics::ball_motion(ball, actions_, mass_, 0.4 * mass_ * ball_radius_ * ball_radius_,
                              dynamics::rates_in(d, slices_));
}

Problem BallBetweenRaces::problem(const State& mechanical) {
  Problem problem;
  problem.start = mechanical;
  problem.start.resize(kSize, 0.0);
  const double length = 1e-5, time = 1e-5;  // of contact deformation and of contact vibration
  const double spin = std::max(std::abs(mechanical[kOmega]), 1.0),
               orbit = std::max(std::abs(mechanical[kThetaRate]), 1.0);
  problem.scales = {length, length, 1e-3, length / time, length / time, orbit,
                    spin,   spin,   spin, 1e-3,          1e-3,          1e-3};
  problem.rates = [this](double, const double* y, double* d) { rates(y, d); };
  problem.longest_step = 2e-5;
  return problem;
}

Eigen::MatrixXd BallBetweenRaces::jacobian(const State& y, std::span<const std::size_t> columns,
                                           std::span<const std::size_t> rows) {
  const State scales = problem(y).scales;
  Eigen::MatrixXd J(rows.size(), columns.size());
  State plus(kSize), minus(kSize), half_plus(kSize), half_minus(kSize);
  const auto at = [&](std::size_t column, double step, State& d) {
    State moved = y;
    moved[column] += step;
    rates(moved.data(), d.data());
  };
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const double h = 1e-4 * scales[columns[c]];
    at(columns[c], h, plus);
    at(columns[c], -h, minus);
    at(columns[c], 0.5 * h, half_plus);
    at(columns[c], -0.5 * h, half_minus);
    for (std::size_t r = 0; r < rows.size(); ++r) {  // Richardson: fourth order
      const double coarse = (plus[rows[r]] - minus[rows[r]]) / (2 * h);
      const double fine = (half_plus[rows[r]] - half_minus[rows[r]]) / h;
      J(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c)) = (4 * fine - coarse) / 3;
    }
  }
  return J;
}

State BallBetweenRaces::steady_state(State y) {
  constexpr std::array<std::size_t, 6> kUnknown = {kX,     kR,         kThetaRate,
                                                   kOmega, kOmega + 1, kOmega + 2};
  constexpr std::array<std::size_t, 6> kResidual = {kXRate, kRRate,     kThetaRate,
                                                    kOmega, kOmega + 1, kOmega + 2};
  y.resize(kSize, 0.0);
  y[kXRate] = y[kRRate] = 0.0;
  const State scales = problem(y).scales;
  State d(kSize);
  const auto residual = [&](const State& state) {
    rates(state.data(), d.data());
    Eigen::VectorXd r(6);
    for (std::size_t i = 0; i < 6; ++i) r[static_cast<Eigen::Index>(i)] = d[kResidual[i]];
    return r;
  };
  Eigen::VectorXd r = residual(y);
  for (int iteration = 0; iteration < 60; ++iteration) {
    const Eigen::VectorXd step = jacobian(y, kUnknown, kResidual).fullPivLu().solve(-r);
    double largest = 0.0;
    for (std::size_t i = 0; i < 6; ++i)
      largest =
          std::max(largest, std::abs(step[static_cast<Eigen::Index>(i)]) / scales[kUnknown[i]]);
    State next = y;
    double part = 1.0;
    for (int halving = 0; halving < 12; ++halving, part *= 0.5) {
      for (std::size_t i = 0; i < 6; ++i)
        next[kUnknown[i]] = y[kUnknown[i]] + part * step[static_cast<Eigen::Index>(i)];
      const Eigen::VectorXd trial = residual(next);
      if (trial.norm() < r.norm() || largest < 1e-6) {
        r = trial;
        break;
      }
    }
    y = next;
    if (largest < 1e-12) return y;
  }
  return y;
}

std::vector<std::complex<double>> BallBetweenRaces::eigenvalues(const State& steady) {
  constexpr std::array<std::size_t, 8> kStates = {kX,         kR,     kXRate,     kRRate,
                                                  kThetaRate, kOmega, kOmega + 1, kOmega + 2};
  const Eigen::MatrixXd J = jacobian(steady, kStates, kStates);
  const Eigen::VectorXcd values = Eigen::EigenSolver<Eigen::MatrixXd>(J, false).eigenvalues();
  return {values.data(), values.data() + values.size()};
}

}  // namespace adore::reference
