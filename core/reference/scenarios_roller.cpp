#include "reference/scenarios.hpp"
#include "reference/trajectory.hpp"
#include "tribology/traction_curve.hpp"

#include <array>
#include <cmath>

/// dynamics_roller: one cylindrical roller between two races, with loads Q = k δ of its own and
/// slip that is uniform along each line (tests/reference/dynamics_README.md, family 7).
namespace adore::reference {
namespace {

constexpr std::array<double, 2> kSide{1.0, -1.0};  ///< outer, inner

struct RollerRace {
  double centre_y = 0.0, centre_z = 0.0, radius = 0.0, stiffness = 0.0, speed = 0.0;
};

/// Contact of one race. Azimuth axes: axial, e_r, e_θ.
struct RollerContact {
  double Q = 0.0;
  double slip_x = 0.0, slip_t = 0.0;  ///< race minus roller
  double f_x = 0.0, f_t = 0.0;        ///< traction on the roller
  double heat = 0.0, work = 0.0;      ///< [W]
};

class RollerCase {
 public:
  explicit RollerCase(const Json& in)
      : half_(0.5 * get(in, "D")), law_(traction_law(in.at("law"))) {
    if (!in.contains("mass")) return;
    mass_ = get(in, "mass");
    inertia_ = get(in, "inertia");
    for (std::size_t j = 0; j < 2; ++j) {
      const Json& race = in.at(j == 0 ? "outer" : "inner");
      race_[j] = {race.at("centre_yz").at(0).get<double>(),
                  race.at("centre_yz").at(1).get<double>(), get(race, "raceway_radius"),
                  get(race, "stiffness"), get(race, "speed_rad_s")};
    }
  }

  [[nodiscard]] double half() const { return half_; }
  [[nodiscard]] double kink() const { return law_.u0; }
  [[nodiscard]] double mass() const { return mass_; }
  [[nodiscard]] double inertia() const { return inertia_; }
  [[nodiscard]] const RollerRace& race(std::size_t j) const { return race_[j]; }
  /// δ at r from the race's own centre.
  [[nodiscard]] double approach(std::size_t j, double r) const {
    return kSide[j] * (r - race_[j].radius) + half_;
  }
  /// @param v_x, v_t velocity of the roller's centre; spin about the axis that is skewed by s
  [[nodiscard]] RollerContact contact(std::size_t j, double Q, double speed, double r, double v_x,
                                      double v_t, double spin, double s) const {
    const double side = kSide[j], rim = side * half_;
    RollerContact c;
    c.Q = Q;
    c.slip_x = -v_x - rim * spin * std::sin(s);
    c.slip_t = speed * (r + rim) - v_t - rim * spin * std::cos(s);
    const double u = std::hypot(c.slip_x, c.slip_t);
    if (u > 0.0 && Q > 0.0) {
      const double per_slip = tribology::traction_coefficient(law_, u) * Q / u;
      c.f_x = per_slip * c.slip_x;
      c.f_t = per_slip * c.slip_t;
    }
    c.heat = c.f_x * c.slip_x + c.f_t * c.slip_t;
    c.work = speed * (r + rim) * c.f_t;
    return c;
  }

 private:
  double half_, mass_ = 0.0, inertia_ = 0.0;
  bearing::TractionCurve law_;
  std::array<RollerRace, 2> race_;
};

const std::array<std::string, 2> kRace{"outer", "inner"};

// ---- planar motion: y, z, vy, vz, ω, work, heat of both races, azimuth

struct PlanarContact : RollerContact {
  double e_y = 0.0, e_z = 0.0;  ///< e_r about the race's own centre
  double approach = 0.0;
};
PlanarContact planar(const RollerCase& roller, std::size_t j, const double* y) {
  const RollerRace& race = roller.race(j);
  const double dy = y[0] - race.centre_y, dz = y[1] - race.centre_z, r = std::hypot(dy, dz);
  PlanarContact out;
  out.e_y = dy / r;
  out.e_z = dz / r;
  out.approach = roller.approach(j, r);
  const double v_t = -y[2] * out.e_z + y[3] * out.e_y;  // e_θ = (-cos θ, -sin θ)
  static_cast<RollerContact&>(out) = roller.contact(j, race.stiffness * std::max(out.approach, 0.0),
                                                    race.speed, r, 0.0, v_t, y[4], 0.0);
  return out;
}

Json planar_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  const RollerCase roller(in);
  const Json& at = in.at("initial_state");
  Problem problem;
  problem.start = {get(at, "y"),     get(at, "z"), get(at, "vy"), get(at, "vz"),
                   get(at, "omega"), 0.0,          0.0,           0.0};
  const double radius = roller.race(0).radius, stiffness = roller.race(0).stiffness;
  const double time = std::sqrt(roller.mass() / stiffness);
  const double speed = std::hypot(problem.start[2], problem.start[3]) + 1.0;
  const double heat = roller.mass() * speed * speed;
  problem.scales = {radius, radius, speed, speed, speed / roller.half(), heat, heat, heat};
  problem.longest_step = 0.3 * time;
  problem.rates = [&](double, const double* y, double* d) {
    double fy = 0.0, fz = 0.0, moment = 0.0;
    d[5] = 0.0;
    for (std::size_t j = 0; j < 2; ++j) {
      const PlanarContact c = planar(roller, j, y);
      fy += -kSide[j] * c.Q * c.e_y - c.f_t * c.e_z;
      fz += -kSide[j] * c.Q * c.e_z + c.f_t * c.e_y;
      moment += kSide[j] * roller.half() * c.f_t;
      d[5] += c.work;
      d[6 + j] = c.heat;
    }
    d[0] = y[2];
    d[1] = y[3];
    d[2] = fy / roller.mass();
    d[3] = fz / roller.mass();
    d[4] = moment / roller.inertia();
  };
  for (std::size_t j = 0; j < 2; ++j) {
    problem.events.push_back(
        [&roller, j](double, const double* y) { return planar(roller, j, y).approach; });
    problem.events.push_back([&roller, j](double, const double* y) {
      return std::abs(planar(roller, j, y).slip_t) - roller.kink();
    });
  }
  const std::vector<double> times = sample_times(the_case);
  const Solution solution = solve(problem, times);
  // At constant angular momentum the orbit adds 3 θ̇².
  const State& y0 = problem.start;
  const double orbit = (y0[0] * y0[3] - y0[1] * y0[2]) / (y0[0] * y0[0] + y0[1] * y0[1]);
  Json out = {
      {"t", times},
      {"y", solution.channel(0)},
      {"z", solution.channel(1)},
      {"vy", solution.channel(2)},
      {"vz", solution.channel(3)},
      {"omega", solution.channel(4)},
      {"work_by_races", solution.channel(5)},
      {"heat_outer", solution.channel(6)},
      {"heat_inner", solution.channel(7)},
      {"angular_frequency_linear",
       std::sqrt((stiffness + roller.race(1).stiffness) / roller.mass() + 3.0 * orbit * orbit)}};
  double theta = 0.0;
  for (const State& y : solution.samples) {
    const double r = std::hypot(y[0], y[1]), now = std::atan2(-y[0], y[1]);
    theta = out.contains("theta") ? theta + std::remainder(now - theta, 2.0 * kPi) : now;
    out["theta"].push_back(theta);
    out["r"].push_back(r);
    out["orbital_speed"].push_back((y[0] * y[3] - y[1] * y[2]) / (r * r));
    for (std::size_t j = 0; j < 2; ++j) {
      const PlanarContact c = planar(roller, j, y.data());
      out["Q_" + kRace[j]].push_back(c.Q);
      out["slip_" + kRace[j]].push_back(c.slip_t);
    }
  }
  return out;
}

// ---- skewed roller: traction of an instant

Json skew_table(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  const RollerCase roller(in);
  const double r = get(in, "orbit_radius"), v_t = r * get(in, "orbital_speed");
  Json rows = Json::array();
  for (const Json& asked : the_case.at("expected").at("rows")) {
    const double degrees = get(asked, "skew_deg");
    Json row = {{"skew_deg", degrees}};
    double axial = 0.0, moment = 0.0;
    for (std::size_t j = 0; j < 2; ++j) {
      const RollerContact c = roller.contact(j, get(in, ("Q_" + kRace[j]).c_str()),
                                             get(in, (kRace[j] + "_speed_rad_s").c_str()), r, 0.0,
                                             v_t, get(in, "roller_spin"), degrees * kDegree);
      const double rim = kSide[j] * roller.half();
      row[kRace[j]] = {{"slip_axial", c.slip_x}, {"slip_rolling", c.slip_t},
                       {"F_axial", c.f_x},       {"F_rolling", c.f_t},
                       {"M_x", rim * c.f_t},     {"M_theta", -rim * c.f_x},
                       {"heat", c.heat}};
      axial += c.f_x;
      moment -= rim * c.f_x;
    }
    row["net_axial"] = axial;
    row["net_M_theta"] = moment;
    rows.push_back(row);
  }
  return {{"rows", rows}};
}

// ---- held at a skew: x, r, θ and rates, spin, work, heat of both races

Json held_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  const RollerCase roller(in);
  const Json& at = in.at("initial_state");
  const double skew = get(in, "skew_deg") * kDegree;
  Problem problem;
  problem.start = {get(at, "x"),
                   get(at, "r"),
                   get(at, "theta"),
                   get(at, "x_dot"),
                   get(at, "r_dot"),
                   get(at, "theta_dot"),
                   get(at, "spin"),
                   0.0,
                   0.0,
                   0.0};
  const double time = std::sqrt(roller.mass() / roller.race(0).stiffness);
  const double radius = problem.start[1], speed = radius * std::abs(problem.start[5]) + 1.0;
  const double heat = roller.mass() * speed * speed;
  problem.scales = {1e-3, radius, 1.0, 0.1, 0.1 * speed, speed / radius, speed / roller.half(),
                    heat, heat,   heat};
  problem.longest_step = 0.3 * time;
  const auto contact = [&](std::size_t j, const double* y) {
    return roller.contact(j, roller.race(j).stiffness * std::max(roller.approach(j, y[1]), 0.0),
                          roller.race(j).speed, y[1], y[3], y[1] * y[5], y[6], skew);
  };
  problem.rates = [&](double, const double* y, double* d) {
    double fx = 0.0, fr = 0.0, ft = 0.0, about = 0.0;
    d[7] = 0.0;
    for (std::size_t j = 0; j < 2; ++j) {
      const RollerContact c = contact(j, y);
      fx += c.f_x;
      ft += c.f_t;
      fr -= kSide[j] * c.Q;
      about += kSide[j] * roller.half() * (c.f_t * std::cos(skew) + c.f_x * std::sin(skew));
      d[7] += c.work;
      d[8 + j] = c.heat;
    }
    d[0] = y[3];
    d[1] = y[4];
    d[2] = y[5];
    d[3] = fx / roller.mass();
    d[4] = fr / roller.mass() + y[1] * y[5] * y[5];
    d[5] = (ft / roller.mass() - 2.0 * y[4] * y[5]) / y[1];
    d[6] = about / roller.inertia();
  };
  const std::vector<double> times = sample_times(the_case);
  const Solution solution = solve(problem, times);
  Json out = {{"t", times},
              {"x", solution.channel(0)},
              {"r", solution.channel(1)},
              {"theta", solution.channel(2)},
              {"x_dot", solution.channel(3)},
              {"r_dot", solution.channel(4)},
              {"theta_dot", solution.channel(5)},
              {"spin", solution.channel(6)},
              {"work_by_races", solution.channel(7)},
              {"heat_outer", solution.channel(8)},
              {"heat_inner", solution.channel(9)}};
  for (const State& y : solution.samples) {
    double holding = 0.0;
    for (std::size_t j = 0; j < 2; ++j) {
      const RollerContact c = contact(j, y.data());
      out["Q_" + kRace[j]].push_back(c.Q);
      out["axial_force_" + kRace[j]].push_back(c.f_x);
      holding += kSide[j] * roller.half() * c.f_x;
    }
    out["holding_moment_theta"].push_back(holding);
  }
  return out;
}

}  // namespace

std::optional<Json> roller_case(const Json& the_case) {
  const std::string kind = kind_of(the_case);
  if (kind == "preloaded_concentric_races_roller") return planar_case(the_case);
  if (kind == "instantaneous_traction_skewed_cylindrical") return skew_table(the_case);
  if (kind == "roller_held_constant_skew") return held_case(the_case);
  return std::nullopt;
}

}  // namespace adore::reference
