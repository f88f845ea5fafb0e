#include "validation/ball_scenario.hpp"

#include "base/errors.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace adore::validation {
namespace {

using dynamics::Evaluation;

/// The rates of these vanish in steady motion of one ball.
constexpr std::array kResidual{"element.x_dot",   "element.r_dot",   "element.theta_dot",
                               "element.omega_x", "element.omega_r", "element.omega_theta"};
constexpr std::array kUnknown{"element.x",       "element.r",       "element.theta_dot",
                              "element.omega_x", "element.omega_r", "element.omega_theta"};

template <class Names>
std::vector<std::size_t> places(const Motion& motion, const Names& names) {
  std::vector<std::size_t> out;
  for (const char* name : names) out.push_back(static_cast<std::size_t>(motion.at(name)));
  return out;
}

/// Rows of the rates by columns of the state; differences of fourth order (Richardson).
Eigen::MatrixXd jacobian(Motion& motion, const State& y, const std::vector<std::size_t>& columns,
                         const std::vector<std::size_t>& rows) {
  Eigen::MatrixXd J(rows.size(), columns.size());
  const auto at = [&](std::size_t column, double step) {
    State moved = y;
    moved[column] += step;
    (void)motion.evaluate(0.0, moved.data());
    return motion.rates();
  };
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const double h = 1e-4 * motion.scales()[columns[c]];
    const State plus = at(columns[c], h), minus = at(columns[c], -h),
                half_plus = at(columns[c], 0.5 * h), half_minus = at(columns[c], -0.5 * h);
    for (std::size_t r = 0; r < rows.size(); ++r) {
      const double coarse = (plus[rows[r]] - minus[rows[r]]) / (2 * h);
      const double fine = (half_plus[rows[r]] - half_minus[rows[r]]) / h;
      J(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c)) = (4 * fine - coarse) / 3;
    }
  }
  return J;
}

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
      fmt::format("contact_surface \"{}\" is unknown; give one of curved_edge, curved_half, "
                  "curved_undeformed, flat_undeformed, flat_half, flat_edge",
                  name));
}

void set_grooves(SmallScene& scene, double diameter, const std::array<double, 2>& factor,
                 const std::array<double, 2>& centre_radius, double gamma) {
  bearing::BallGeometry& balls = scene.bearing.balls();
  const double outer = (factor[0] - 0.5) * diameter, inner = (factor[1] - 0.5) * diameter;
  balls.diameter = diameter;
  balls.groove_factor = factor;
  balls.contact_angle = 0.0;
  balls.groove_plane = {0.0, 0.0};
  balls.pitch_diameter = centre_radius[0] + centre_radius[1] + outer - inner;
  balls.clearance = 4.0 * (centre_radius[0] + outer - 0.5 * balls.pitch_diameter);
  const double cosine = gamma * balls.pitch_diameter / diameter;
  require(cosine >= 0.0 && cosine <= 1.0 + 1e-12,
          "derived.Rc_outer and derived.Rc_inner (radii of the circles of groove centers) do not "
          "fit D (ball diameter) and dm (pitch diameter). Enter values of the same bearing.");
  scene.hertz_angle.fill(std::acos(std::min(cosine, 1.0)));
}

std::shared_ptr<TractionRule> install_converged_traction(SmallScene& scene, TractionRule wanted) {
  auto rule = std::make_shared<TractionRule>(std::move(wanted));
  dynamics::CustomSceneAction correction;
  correction.act = [rule](Evaluation& e, const dynamics::RaceModels& races) {
    for (std::size_t j = 0; j < 2; ++j) {
      const dynamics::RaceContactModel& model = races[j];
      dynamics::RaceBody& race = e.race[j];
      for (std::size_t i = 0; i < e.elements.n; ++i) {
        const auto s = dynamics::race_contact_state(model, e.elements, i, race.motion());
        if (!(s.approach > 0.0)) continue;
        const Vec3 place = e.element_centre(i);
        const Vec3 slip = race.velocity_at(place) - e.element_velocity(i);
        const SurfaceTraction exact = (*rule)(model.law, s, slip.dot(s.n));
        const tribology::EllipseTraction &f = exact.in_plane,
                                         fixed = tribology::ellipse_traction(model.law, s.ellipse,
                                                                             s.motion, model.rule);
        const Vec3 force = (f.F_c - fixed.F_c) * s.c + (f.F_t - fixed.F_t) * s.t + exact.F_n * s.n;
        const Vec3 moment =
            (f.M_c - fixed.M_c) * s.c + (f.M_t - fixed.M_t) * s.t + (f.M_n - fixed.M_n) * s.n;
        e.add_force(i, e.to_cylindrical(i, force));
        e.add_moment(i, e.to_cylindrical(i, moment));
        race.add_force(-force, place);
        race.moment -= moment;
        e.heat[j][i] += f.heat - fixed.heat;
      }
    }
  };
  add(scene, std::move(correction));
  return rule;
}

void add_heat_integrals(SmallScene& scene, int balls) {
  const auto n = static_cast<std::size_t>(balls);
  auto heat = std::make_shared<std::array<std::vector<double>, 2>>();
  heat->fill(std::vector<double>(n));
  dynamics::CustomSceneAction books;
  books.account = [heat](Evaluation& e, const dynamics::RaceModels&) { *heat = e.heat; };
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < n; ++i)
      books.books.push_back({heat_integral_name(j, i), &(*heat)[j][i]});
  add(scene, std::move(books));
}

SmallScene ball_scene(const Json& in, const Vec3& inner_centre, bool traction, int count) {
  const Json &b = in.at("bearing"), &derived = in.at("derived");
  SmallScene scene;
  bearing::Bearing& bearing = scene.bearing;
  set_grooves(scene, get(b, "D"), {get(b, "fo"), get(b, "fi")},
              {get(derived, "Rc_outer"), get(derived, "Rc_inner")},
              get(b, "D") * std::cos(get(b, "alpha0")) / get(b, "dm"));
  bearing.balls().count = count;
  const double mass = get(derived, "ball_mass");
  bearing.element_inertia.mass = mass;
  bearing.element_inertia.moments.setConstant(0.1 * mass * get(b, "D") * get(b, "D"));
  for (bearing::Material* material :
       {&bearing.element_material, &bearing.race_material[0], &bearing.race_material[1]}) {
    material->elastic_modulus = get(b, "E");
    material->poisson_ratio = get(b, "nu");
  }
  bearing.speed = {in.value("outer_speed_rad_s", 0.0), in.value("inner_speed_rad_s", 0.0)};
  scene.have({scene::Effect::RaceContact});
  if (traction) {
    bearing.race_traction = traction_law(in.at("traction_law"));
    scene.have({scene::Effect::RaceTraction});
  }
  if (in.contains("contact_surface"))
    scene.options.surface = contact_surface(in["contact_surface"].get<std::string>());
  for (int k = 0; k < 3; ++k)
    scene.start.displacement[static_cast<std::size_t>(k)] = inner_centre[k];
  scene.start.balls.resize(static_cast<std::size_t>(count));
  return scene;
}

void set_ball_error_scales(Motion& motion) {
  const double length = 1e-5, time = 1e-5;  // of contact deformation and of contact vibration
  const auto first = [&](const char* group) {
    return std::max(std::abs(motion.start_of(group)), 1.0);
  };
  for (const char* group : {"element.x", "element.r"}) motion.scale(group, length);
  for (const char* group : {"element.x_dot", "element.r_dot"}) motion.scale(group, length / time);
  motion.scale("element.theta", 1e-3);
  motion.scale("element.theta_dot", first("element.theta_dot"));
  for (const char* group : {"element.omega_x", "element.omega_r", "element.omega_theta"})
    motion.scale(group, first("element.omega_x"));
}

BallLoad ball_load(const Motion& motion, const Evaluation& e, std::size_t race, std::size_t ball) {
  return {e.load[race][ball], e.heat[race][ball],
          dynamics::race_contact_state(motion.race(race), e.elements, ball, e.race[race].motion())};
}

State steady_state(Motion& motion, State y) {
  const auto unknown = places(motion, kUnknown), residual = places(motion, kResidual);
  for (const char* name : {"element.x_dot", "element.r_dot"})
    y[static_cast<std::size_t>(motion.at(name))] = 0.0;
  const auto rates = [&](const State& state) {
    (void)motion.evaluate(0.0, state.data());
    Eigen::VectorXd r(residual.size());
    for (std::size_t i = 0; i < residual.size(); ++i)
      r[static_cast<Eigen::Index>(i)] = motion.rates()[residual[i]];
    return r;
  };
  Eigen::VectorXd r = rates(y);
  for (int iteration = 0; iteration < 60; ++iteration) {
    const Eigen::VectorXd step = jacobian(motion, y, unknown, residual).fullPivLu().solve(-r);
    double largest = 0.0;
    for (std::size_t i = 0; i < unknown.size(); ++i)
      largest = std::max(
          largest, std::abs(step[static_cast<Eigen::Index>(i)]) / motion.scales()[unknown[i]]);
    State next = y;
    double part = 1.0;
    for (int halving = 0; halving < 12; ++halving, part *= 0.5) {
      for (std::size_t i = 0; i < unknown.size(); ++i)
        next[unknown[i]] = y[unknown[i]] + part * step[static_cast<Eigen::Index>(i)];
      const Eigen::VectorXd trial = rates(next);
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

std::vector<std::complex<double>> eigenvalues(Motion& motion, const State& steady) {
  constexpr std::array kStates{"element.x",       "element.r",          "element.x_dot",
                               "element.r_dot",   "element.theta_dot",  "element.omega_x",
                               "element.omega_r", "element.omega_theta"};
  const auto states = places(motion, kStates);
  const Eigen::MatrixXd J = jacobian(motion, steady, states, states);
  const Eigen::VectorXcd values = Eigen::EigenSolver<Eigen::MatrixXd>(J, false).eigenvalues();
  return {values.data(), values.data() + values.size()};
}

State rolling_start(Motion& motion, double x, double r) {
  const auto at = [&](const char* name) { return static_cast<std::size_t>(motion.at(name)); };
  Vec3 speeds = Vec3::Zero();  // θ', ω_x, ω_r
  const auto evaluated = [&](double at_x, double at_r, const Vec3& with, State& y) -> const auto& {
    y.assign(motion.start.size(), 0.0);
    y[at("element.x")] = at_x;
    y[at("element.r")] = at_r;
    y[at("element.theta_dot")] = with[0];
    y[at("element.omega_x")] = with[1];
    y[at("element.omega_r")] = with[2];
    return motion.evaluate(0.0, y.data());
  };
  State y;
  const auto rolling = [&](const Vec3& unknown) {
    const Evaluation& e = evaluated(x, r, unknown, y);
    const BallLoad outer = ball_load(motion, e, 0), inner = ball_load(motion, e, 1);
    const auto slip = [](const BallLoad& load) {
      return load.contact.motion.u_t - load.contact.motion.W_c * load.contact.ellipse.h0;
    };
    return Vec3(slip(outer), slip(inner), outer.contact.motion.W_n);
  };
  const auto imbalance = [&](double at_x, double at_r) {
    const Evaluation& e = evaluated(at_x, at_r, speeds, y);
    Eigen::Vector2d sum(0.0, motion.mass() * at_r * speeds[0] * speeds[0]);
    for (const std::size_t j : {0UL, 1UL}) {
      const BallLoad load = ball_load(motion, e, j);
      sum -= load.Q * Eigen::Vector2d(load.contact.n[0], load.contact.n[2]);  // θ = 0: e_r = e_z
    }
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
  (void)evaluated(x, r, speeds, y);
  return y;
}

}  // namespace adore::validation
