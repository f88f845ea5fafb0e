#include "roller_scene.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

using namespace adore;
using roller_scene::Scene;
using roller_scene::scene_of;
using scene::Snapshot;

namespace {

/// First component of a group of element states.
int first_of(const dynamics::System& system, const std::string& name) {
  for (const dynamics::StateLayout::Group& group : system.layout().groups())
    if (group.name == name) return group.slice.first;
  throw std::runtime_error(name);
}

/// What the equilibrium has balanced and the start leaves: largest force along x and r [N], largest
/// moment that tilts, over half the length [N]. The equilibrium is one of each roller's azimuth
/// plane: a race that is displaced across it pushes sideways.
double largest_unbalance(Scene& s) {
  const std::vector<double> y = s.system.initial_state();
  std::vector<double> rates(y.size());
  REQUIRE(s.system.rhs(0.0, y.data(), rates.data()) == dynamics::RhsStatus::Ok);
  const auto largest = [&](const std::string& name) {
    const auto first = static_cast<std::size_t>(first_of(s.system, "element." + name));
    double out = 0.0;
    for (std::size_t i = 0; i < s.rollers->solution.rollers.size(); ++i)
      out = std::max(out, std::abs(rates[first + i]));
    return out;
  };
  const bearing::Inertia& inertia = s.bearing.element_inertia;
  return std::max(
      {inertia.mass * largest("x_dot"), inertia.mass * largest("r_dot"),
       inertia.moments[1] * largest("omega_theta") / (0.5 * s.bearing.rollers()->length)});
}

bearing::Bearing tilted(double about_y, double about_z) {
  bearing::Bearing b = roller_bearings::cylindrical(3000.0);
  b.constraints.displacement[3] = about_y;
  b.constraints.displacement[4] = about_z;
  roller_scene::add_cage(b);
  roller_scene::add_friction(b);
  return b;
}

/// Skew of every roller [rad]: positive right-handed about the outward radial.
std::vector<double> skews(const Snapshot& at) {
  std::vector<double> out;
  for (const scene::ElementSnapshot& e : at.elements) out.push_back(std::asin(e.x_axis[1]));
  return out;
}

Snapshot after(Scene& s, double end, double tolerance = 1e-7, const char* method = "rkf5") {
  const auto run = fixture::run(s.system, s.system.initial_state(), end, tolerance, method);
  return s.system.snapshot(end, run.y);
}

}  // namespace

TEST_CASE("rollers: the loads of the equilibrium hold at the start, nothing drifts",
          "[physics][rollers]") {
  for (bearing::Bearing b :
       {roller_bearings::cylindrical(0.0), roller_bearings::tapered(0.0),
        roller_bearings::spherical(0.0), roller_bearings::spherical_tapered(0.0),
        roller_bearings::cylindrical(6000.0), roller_bearings::tapered(6000.0),
        roller_bearings::on_crowned_races(roller_bearings::cylindrical(0.0)),
        roller_bearings::on_crowned_races(roller_bearings::tapered(6000.0))}) {
    Scene s = scene_of(b, roller_scene::races_only());
    const double load = s.rollers->solution.max_load;
    REQUIRE(load > 500.0);
    INFO("type " << static_cast<int>(b.type) << " at " << b.speed[1] << " rad/s");
    // The equilibrium takes the centrifugal force at the nominal radius: 1e-4 of some 30 N.
    CHECK(largest_unbalance(s) < (b.speed[1] == 0.0 ? 1e-6 : 1e-5) * load);
    const std::vector<double> y = s.system.initial_state();
    const Snapshot at = s.system.snapshot(0.0, y);
    for (std::size_t i = 0; i < at.elements.size(); ++i)
      for (std::size_t j = 0; j < 2; ++j) {
        const std::vector<double>& solved = s.rollers->solution.rollers[i].race[j].slice_load;
        REQUIRE(at.elements[i].race[j].slice_load.size() == solved.size());
        for (std::size_t k = 0; k < solved.size(); ++k)
          CHECK(at.elements[i].race[j].slice_load[k] == Approx(solved[k]).margin(1e-9 * load));
      }
    CHECK(at.races[1].applied_force[2] ==
          Approx(b.constraints.load[2]).epsilon(1e-6).margin(1e-6 * load));
  }
}

TEST_CASE("rollers: without friction energy and momentum are conserved, the better the tolerance",
          "[physics][rollers]") {
  for (bearing::Bearing b : {roller_bearings::cylindrical(3000.0), roller_bearings::tapered(3000.0),
                             roller_bearings::spherical_tapered(3000.0),
                             roller_bearings::on_crowned_races(roller_bearings::tapered(3000.0))}) {
    roller_scene::add_cage(b);
    INFO("type " << static_cast<int>(b.type));
    std::vector<double> residuals;
    for (const double tolerance : {1e-5, 1e-7, 1e-9}) {
      Scene s = scene_of(b, roller_scene::frictionless(), 9);
      std::vector<double> y = s.system.initial_state();
      // A push: the rollers vibrate against races, flanges and cage.
      for (std::size_t i = 0; i < y.size(); ++i)
        if (s.system.layout().component_name(static_cast<int>(i)).rfind("element.x_dot", 0) == 0)
          y[i] += 0.02;
      const auto run = fixture::run(s.system, y, 1e-3, tolerance, "rkf5");
      const Snapshot at = s.system.snapshot(1e-3, run.y);
      residuals.push_back(std::abs(at.energy.residual()));
      const auto momentum = at.momentum->linear.residual();
      CHECK(momentum.norm() < 2e2 * tolerance * at.momentum->linear_size);
      CHECK(at.momentum->angular.residual().norm() < 2e2 * tolerance * at.momentum->angular_size);
      CHECK(at.max_quaternion_error < 1e-12);
    }
    CAPTURE(residuals[0], residuals[1], residuals[2]);
    CHECK(residuals[1] < 0.1 * residuals[0]);
    // Of some 1 J that moves: below is rounding.
    CHECK(residuals[2] < std::max(0.1 * residuals[1], 1e-9));
  }
}

TEST_CASE("rollers: what friction takes is heat", "[physics][rollers]") {
  for (bearing::Bearing b : {roller_bearings::cylindrical(3000.0), roller_bearings::tapered(3000.0),
                             roller_bearings::spherical(3000.0)}) {
    roller_scene::add_cage(b);
    roller_scene::add_friction(b);
    INFO("type " << static_cast<int>(b.type));
    Scene s = scene_of(b, roller_scene::with_friction(), 9);
    const Snapshot at = after(s, 1e-3, 1e-8);
    CHECK(at.power.total_loss > 0.0);
    double heat = 0.0, elastic = 0.0;
    for (const auto& item : at.energy.items()) {
      if (item.term->kind == scene::LedgerKind::Heat) heat += item.value;
      if (item.term->id == "elastic") elastic = item.value;
    }
    CHECK(heat > 0.0);
    // Barrels, which friction skews at once, leave 2e-6 of the elastic energy.
    CHECK(std::abs(at.energy.residual()) < 1e-5 * elastic);
  }
}

TEST_CASE("rollers: a bearing turned by an azimuth gives turned results", "[physics][rollers]") {
  bearing::Bearing b = roller_bearings::cylindrical(3000.0);
  roller_scene::add_cage(b);
  roller_scene::add_friction(b);
  const double angle = 0.7;
  bearing::Bearing turned = b;
  turned.constraints.load[1] = -std::sin(angle) * b.constraints.load[2];
  turned.constraints.load[2] = std::cos(angle) * b.constraints.load[2];
  Scene one = scene_of(b, roller_scene::with_friction(), 9);
  Scene other = scene_of(turned, roller_scene::with_friction(), 9, angle);
  const Snapshot a = after(one, 5e-4, 1e-9), c = after(other, 5e-4, 1e-9);
  for (std::size_t i = 0; i < a.elements.size(); ++i) {
    CHECK(c.elements[i].theta - a.elements[i].theta == Approx(angle).margin(1e-8));
    CHECK(c.elements[i].r == Approx(a.elements[i].r).margin(1e-11));
    CHECK(c.elements[i].race[1].load == Approx(a.elements[i].race[1].load).margin(1e-3));
    CHECK((c.elements[i].x_axis - a.elements[i].x_axis).norm() < 1e-7);
  }
  CHECK(c.cages[0].omega.x() == Approx(a.cages[0].omega.x()).epsilon(1e-7));
}

TEST_CASE("rollers: mirrored about X, a misaligned bearing skews its rollers to the other side",
          "[physics][rollers]") {
  Scene one = scene_of(tilted(1e-3, 0.0), roller_scene::with_friction(), 9);
  Scene other = scene_of(tilted(-1e-3, 0.0), roller_scene::with_friction(), 9);
  const Snapshot a = after(one, 2e-3, 1e-8), b = after(other, 2e-3, 1e-8);
  const std::vector<double> skew = skews(a), mirrored = skews(b);
  double largest = 0.0;
  for (std::size_t i = 0; i < skew.size(); ++i) {
    CHECK(mirrored[i] == Approx(-skew[i]).margin(1e-8));
    CHECK(b.elements[i].x == Approx(-a.elements[i].x).margin(1e-10));
    largest = std::max(largest, std::abs(skew[i]));
  }
  CHECK(largest > 1e-6);
}

TEST_CASE("rollers: an aligned bearing does not skew its rollers", "[physics][rollers]") {
  Scene s = scene_of(tilted(0.0, 0.0), roller_scene::with_friction(), 9);
  const Snapshot at = after(s, 2e-3, 1e-8);
  for (const double skew : skews(at)) CHECK(std::abs(skew) < 1e-9);
}

TEST_CASE("rollers: with a light load the cage turns at the epicyclic speed",
          "[physics][rollers]") {
  bearing::Bearing b = roller_bearings::cylindrical(3000.0, -2e-6);
  b.constraints.load.fill(0.0);
  roller_scene::add_cage(b);
  roller_scene::add_friction(b);
  const double epicyclic = 0.5 * b.speed[1] * (1.0 - b.element_diameter() / b.pitch_diameter());
  Scene s = scene_of(b, roller_scene::with_friction(), 9);
  const Snapshot at = after(s, 5e-3, 1e-7);
  for (const scene::ElementSnapshot& e : at.elements)
    CHECK(e.theta_dot == Approx(epicyclic).epsilon(2e-3));
  CHECK(at.cages[0].omega.x() == Approx(epicyclic).epsilon(2e-3));
}

TEST_CASE("rollers: what each does to the cage is its share of the rates", "[unit][rollers]") {
  bearing::Bearing b = roller_bearings::tapered(3000.0);
  roller_scene::add_cage(b);
  roller_scene::add_friction(b);
  Scene s = scene_of(b, roller_scene::with_friction(), 9);
  std::vector<double> y = s.system.initial_state();
  for (int i = 0; i < s.system.layout().size(); ++i)  // against the pocket walls
    if (s.system.layout().component_name(i).rfind("element.theta[", 0) == 0)
      y[static_cast<std::size_t>(i)] += 5e-3;
  const auto owner = s.system.coupling();
  const auto border = std::count(owner.begin(), owner.end(), -1);
  std::vector<double> rates(y.size()), same(y.size()),
      shares(static_cast<std::size_t>(border) * 17, 0.0);
  REQUIRE(s.system.rhs(0.0, y.data(), rates.data()) == dynamics::RhsStatus::Ok);
  REQUIRE(s.system.rhs_with_contributions(0.0, y.data(), same.data(), shares.data()) ==
          dynamics::RhsStatus::Ok);
  CHECK(rates == same);
  // The shares of all rollers make the cage's rates: no land touches.
  std::size_t row = 0;
  double largest = 0.0;
  for (std::size_t i = 0; i < owner.size(); ++i) {
    if (owner[i] != -1) continue;
    const std::string name = s.system.layout().component_name(static_cast<int>(i));
    if (name.rfind("cage.velocity", 0) == 0) {
      double sum = 0.0;
      for (std::size_t k = 0; k < 17; ++k)
        sum += shares[k * static_cast<std::size_t>(border) + row];
      CHECK(sum == Approx(rates[i]).margin(1e-6));
      for (std::size_t k = 0; k < 17; ++k)
        largest = std::max(largest, std::abs(shares[k * static_cast<std::size_t>(border) + row]));
    }
    ++row;
  }
  CHECK(largest > 1.0);
}

TEST_CASE("rollers: pockets of every shape conserve energy and momentum", "[physics][rollers]") {
  for (const int shape : {-2, -1, 1, 2}) {
    // Round pockets follow the taper of their rollers.
    bearing::Bearing b =
        shape == -2 ? roller_bearings::tapered(3000.0) : roller_bearings::cylindrical(3000.0);
    roller_scene::add_cage(b);
    const double reach = 0.5 * (b.element_diameter() + b.cage->pocket_clearance_1);
    if (shape < 0) {
      b.cage->pocket = bearing::PocketShape::Cylindrical;
    } else {
      for (int i = 0; i < shape; ++i) {
        const double at = shape == 1 ? 0.0 : (i == 0 ? 0.003 : -0.003);
        b.cage->pocket_faces.push_back({Vec3::Zero(), {at, reach, 0.0}, 0.004, 0.003});
      }
      if (shape == 2)  // the first pocket is wider, elsewhere and askew
        b.cage->pocket_deviation = {{{5e-5, 0.0}, 0.0, 2e-5, 1e-4, {0.0, 1e-3, 2e-3}}};
    }
    INFO("pockets " << shape);
    Scene s = scene_of(b, roller_scene::frictionless(), 9);
    std::vector<double> y = s.system.initial_state();
    const auto first = static_cast<std::size_t>(first_of(s.system, "cage.velocity"));
    y[first + 1] += 0.3;  // the cage strikes its rollers
    const auto run = fixture::run(s.system, y, 1e-3, 1e-9);
    const Snapshot at = s.system.snapshot(1e-3, run.y);
    const double struck = 0.5 * b.cage->inertia.mass * 0.3 * 0.3;
    CHECK(std::abs(at.energy.residual()) < 1e-4 * struck);
    CHECK(at.momentum->linear.residual().norm() < 1e-7 * at.momentum->linear_size);
    double largest = 0.0;
    for (const scene::ElementSnapshot& e : at.elements) {
      CHECK(e.pocket.size() == (shape < 0 ? 1U : 2U * static_cast<std::size_t>(shape)));
      for (const scene::PocketContactSnapshot& wall : e.pocket)
        largest = std::max(largest, -wall.gap);
    }
    CAPTURE(largest);
    // It struck: its speed across has changed by much.
    CHECK(std::abs(run.y[first + 1] - y[first + 1]) > 0.01);
  }
}

namespace {

/// A constant moment on element 1, base axes.
class Moment final : public dynamics::SceneEffect {
 public:
  explicit Moment(const Vec3& moment) : moment_(moment) {}
  void declare(dynamics::SceneBuilder& scene) override {
    scene.block<Block>(dynamics::Phase::Force, "moment of a test", {}, moment_);
  }

 private:
  class Block final : public dynamics::EffectBlock {
   public:
    explicit Block(const Vec3& moment) : moment_(moment) {}
    void apply(dynamics::Evaluation& e) noexcept override {
      e.add_moment(0, e.to_cylindrical(0, moment_));
    }

   private:
    Vec3 moment_;
  };
  Vec3 moment_;
};

}  // namespace

TEST_CASE("rigid elements: a ball under a small moment turns its axis at M/(I omega), right-handed",
          "[physics][rollers]") {
  bearing::Bearing b = roller_bearings::cylindrical(3000.0);
  const double I = b.element_inertia.moments[0];
  b.element_inertia.moments.setConstant(I);  // of a ball
  dynamics::RollerStaticResult rollers;
  rollers.options.slices = 3;
  rollers.solution = statics::solve_roller_statics(b, rollers.options);
  const auto start = std::make_shared<const dynamics::RollerStaticResult>(rollers);
  const double omega = rollers.solution.orbital_speed + rollers.solution.spin_speed;
  const double end = 2e-3, M = 1e-3 * I * std::abs(omega) / end;  // turns by a milliradian
  const dynamics::EffectMaker moment = [&](const scene::ScenePlan&) {
    return std::make_unique<Moment>(Vec3(0.0, M, 0.0));
  };
  dynamics::System system(b, roller_scene::plan_of({}), dynamics::static_start(rollers, b), {}, {},
                          {moment}, start);
  const auto run = fixture::run(system, system.initial_state(), end, 1e-12, "rkf7");
  const scene::ElementSnapshot e = system.snapshot(end, run.y).elements[0];
  // Azimuth frame -> base: x, y turned about x by the azimuth.
  const double c = std::cos(e.theta), s = std::sin(e.theta);
  const Vec3 w(e.omega[0], c * e.omega[1] - s * e.omega[2], s * e.omega[1] + c * e.omega[2]);
  CHECK(w[0] == Approx(omega).epsilon(1e-9));
  CHECK(w[1] / w[0] == Approx(M * end / (I * omega)).epsilon(1e-6));
  CHECK(std::abs(w[2] / w[0]) < 1e-9);
}

TEST_CASE("rigid elements: a roller free of forces precesses as Euler says", "[physics][rollers]") {
  bearing::Bearing b = roller_bearings::cylindrical(0.0);
  dynamics::RollerStaticResult rollers;
  rollers.options.slices = 3;
  rollers.solution = statics::solve_roller_statics(b, rollers.options);
  const auto start = std::make_shared<const dynamics::RollerStaticResult>(rollers);
  dynamics::System system(b, roller_scene::plan_of({}), dynamics::static_start(rollers, b), {}, {},
                          {}, start);
  std::vector<double> y = system.initial_state();
  const auto at = [&](const char* name) {
    return static_cast<std::size_t>(first_of(system, name));
  };
  const double spin = 900.0, across = 40.0, end = 3e-3;
  y[at("element.omega_x")] = spin;
  y[at("element.omega_r")] = across;
  const auto run = fixture::run(system, y, end, 1e-12, "rkf7");
  // Its axis turns about L at |L|/I_t.
  const Vec3& I = b.element_inertia.moments;
  const Vec3 L(I[0] * spin, 0.0, I[1] * across);  // azimuth frame of the start: x, y, z = r
  const Vec3 l = L.normalized(), axis = Vec3::UnitX();
  const double angle = L.norm() / I[1] * end;
  const Vec3 expected = l * l.dot(axis) + std::cos(angle) * (axis - l * l.dot(axis)) +
                        std::sin(angle) * l.cross(axis);
  const Vec3 found = system.snapshot(end, run.y).elements[0].x_axis;
  CHECK((found - expected).norm() < 1e-9);
}

TEST_CASE("rollers: a race vibrates on them at the eigenfrequencies of the static stiffness",
          "[physics][rollers][races][limits][slow]") {
  struct Case {
    bearing::Bearing bearing;
    double thrust;           ///< [N]
    std::vector<int> along;  ///< directions that have stiffness: x, y, z, about y, about z
  };
  // Radially preloaded, or under thrust: all rollers carry alike, and nothing pushes them around.
  const std::vector<Case> cases{{roller_bearings::cylindrical(0.0, -2e-5), 0.0, {1, 2}},
                                {roller_bearings::spherical(0.0, -2e-5), 0.0, {2}},
                                {roller_bearings::tapered(0.0), 3000.0, {0, 2, 3, 4}},
                                {roller_bearings::spherical_tapered(0.0), 3000.0, {0, 2}}};
  for (const Case& one : cases) {
    bearing::Bearing b = one.bearing;
    b.constraints.load = {one.thrust, 0.0, 0.0, 0.0, 0.0};
    b.constraints.displacement_given = {one.thrust == 0.0, true, true, true, true};
    statics::RollerOptions options;
    options.slices = 9;
    const statics::RollerSolution rest = statics::solve_roller_statics(b, options);
    b.constraints.displacement_given.fill(true);
    b.constraints.displacement = rest.displacement;
    // The rollers have 0.17 kg or less together, at 32 mm or less from the axis.
    const double mass = 40.0, transverse = 0.1;
    b.race_inertia[1] = {mass, {0.05, transverse, transverse}};
    for (const int k : one.along) {
      const auto axis = static_cast<std::size_t>(k);
      const auto load_at = [&](double shift) {
        bearing::Bearing moved = b;
        moved.constraints.displacement[axis] += shift;
        return statics::solve_roller_statics(moved, options).load[axis];
      };
      const bool tilts = k > 2;
      const double h = tilts ? 3e-7 : 1e-8, size = 2.0 * h;
      const double stiffness = (load_at(h) - load_at(-h)) / (2.0 * h);
      const double period =
          2.0 * std::numbers::pi * std::sqrt((tilts ? transverse : mass) / stiffness);
      scene::ScenePlan plan = roller_scene::races_only();
      bearing::FreeRace& free = plan.race_motions.free[1].emplace();
      plan.effects.push_back({scene::Effect::FreeRaces, "", true, "test"});
      free.translation_held = {k != 0, k != 1, k != 2};
      free.rotation_held = {true, k != 3, k != 4};
      (tilts ? free.moment[k - 2] : free.force[k]) = load_at(0.0) + stiffness * size;
      Scene s = scene_of(b, plan, 9);
      // Released at the old place it swings about the new one, `size` away.
      const auto place = [&](double t) {
        const scene::RaceSnapshot race = after(s, t, 1e-8, "rkf7").races[1];
        if (!tilts) return (race.position[k] - rest.displacement[axis]) / size;
        // A small turn about y moves the tip of the axis against z, one about z along y.
        const Vec3 tip = rotation_matrix(adore::normalize_quaternion(race.orientation)).col(0);
        return ((k == 3 ? -tip[2] : tip[1]) - rest.displacement[axis]) / size;
      };
      const double late = place(4.5 * period), quarter = place(4.25 * period);
      INFO("type " << static_cast<int>(b.type) << " along " << k << " at " << 1.0 / period
                   << " Hz: " << late << ", " << quarter);
      // A race that tilts skews its rollers, whose skew the equilibrium holds: 2.09.
      CHECK(late == Approx(2.0).epsilon(tilts ? 0.05 : 0.02));
      // 1 - cos of the phase: slope 1 per radian, 27 rad of phase.
      CHECK(std::abs(quarter - 1.0) < 0.005 * 4.25 * 2.0 * std::numbers::pi);
    }
  }
}

TEST_CASE("a race drifts freely in directions in which nothing holds it",
          "[physics][rollers][races][limits]") {
  // Cylinders between races without flanges hold nothing along x, and no bearing a turn about x.
  bearing::Bearing b = roller_bearings::cylindrical(0.0, -2e-5);
  b.rollers()->flange = {};
  b.constraints.displacement_given.fill(true);
  b.constraints.load = {};
  const double mass = 2.0, polar = 2e-3, force = 30.0, moment = 0.4, end = 2e-3;
  b.race_inertia[1] = {mass, {polar, 1.5e-3, 1.5e-3}};
  scene::ScenePlan plan = roller_scene::races_only();
  bearing::FreeRace& free = plan.race_motions.free[1].emplace();
  plan.effects.push_back({scene::Effect::FreeRaces, "", true, "test"});
  free.rotation_held = {false, false, false};
  free.force[0] = force;
  free.moment[0] = moment;
  Scene s = scene_of(b, plan, 9);
  const scene::RaceSnapshot race = after(s, end, 1e-9).races[1];
  CHECK(race.position[0] == Approx(0.5 * force / mass * end * end).epsilon(1e-6));
  CHECK(race.velocity[0] == Approx(force / mass * end).epsilon(1e-6));
  CHECK(race.omega[0] == Approx(moment / polar * end).epsilon(1e-6));
  // The other directions keep their place: the race shrinks the gaps that it had.
  CHECK(race.position.tail<2>().norm() < 1e-9);
}
