#include "dynamics/held_rollers.hpp"
#include "roller_scene.hpp"
#include "statics/roller_model.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

/// qFac and modes 1 and 2 of rollers.
using namespace adore;
using namespace adore::dynamics;
using roller_scene::Scene;
using scene::Effect;
using scene::LedgerKind;
using scene::ScenePlan;
using scene::Snapshot;

namespace {

ScenePlan mode_plan(int mode, ScenePlan plan = roller_scene::with_friction()) {
  if (mode >= 1) plan.effects.push_back({Effect::ElementBalance, "", true, "test"});
  if (mode == 2) plan.effects.push_back({Effect::RaceBalance, "", true, "test"});
  return plan;
}

struct Run {
  Snapshot last;
  int most_held = 0;
  long switches = 0;
};

/// As a run does it: elements change between holding and free between steps only.
Run run(Scene& s, double end, double tolerance, const char* method = "rkf5") {
  dynamics::System& system = s.system;
  std::vector<double> y = system.initial_state();
  system.set_start(0.0, y);
  Run out;
  out.switches += system.between_steps(0.0, y);
  fixture::Adapter adapter(system);
  const auto stepper = integrators::make_stepper(method);
  integrators::StepControl control;
  control.maximum = end;
  control.minimum = 1e-13;
  control.tolerance = tolerance;
  stepper->start(adapter, 0.0, y, control);
  for (int step = 1; stepper->time() < end; ++step) {
    stepper->step(end);
    if (step % 10 != 0) continue;
    y.assign(stepper->state().begin(), stepper->state().end());
    if (system.between_steps(stepper->time(), y)) {
      ++out.switches;
      stepper->start(adapter, stepper->time(), y, control);
    }
    out.most_held =
        std::max(out.most_held, system.snapshot(stepper->time(), y).held_elements.value_or(0));
  }
  out.last = system.snapshot(end, stepper->state());
  return out;
}

bearing::Bearing with_cage(bearing::Bearing b) {
  roller_scene::add_cage(b);
  roller_scene::add_friction(b);
  return b;
}

}  // namespace

TEST_CASE("held rollers: springs are the derivatives of the normal forces, turning included",
          "[unit][rollers][held]") {
  for (bearing::Bearing b :
       {roller_bearings::cylindrical(3000.0), roller_bearings::tapered(3000.0),
        roller_bearings::spherical(3000.0), roller_bearings::spherical_tapered(3000.0)}) {
    INFO("type " << static_cast<int>(b.type));
    Scene s = roller_scene::scene_of(b, roller_scene::races_only(), 9);
    const std::size_t i = 1;
    const ElementStartState pose = start_poses(*s.rollers, s.bearing)[i];
    QuasiStaticRollers held(statics::make_roller_model(s.bearing, s.rollers->options),
                            s.bearing.imperfections, ElementMasses(s.bearing));
    // The start, moved a little so that nothing is symmetric.
    struct Place {
      Vec3 G;
      Mat3 attitude;
    };
    const Mat3 attitude = rotation_matrix(pose.attitude);
    const Vec3 axis_turn(0.0, 2e-4, -1e-4);
    const auto turned = [](const Vec3& by, const Mat3& m) {
      return Mat3(rotation_matrix(quaternion_about(by.normalized(), by.norm())) * m);
    };
    const Place at{
        Vec3(pose.x + 1e-6, -pose.r * std::sin(pose.azimuth), pose.r * std::cos(pose.azimuth)),
        turned(axis_turn, attitude)};
    Evaluation e(s.rollers->solution.rollers.size());
    const auto& shift = s.rollers->solution.displacement;
    e.race[1].position = Vec3(shift[0], shift[1], shift[2]);
    e.race[1].set_attitude(quaternion_from_angles({0.0, shift[3], shift[4]}));
    const std::size_t n = e.sin_theta.size();
    e.attitude.assign(n, Mat3::Identity());
    std::vector<double> zero(n, 0.0), x(n), r(n), omega[3];
    for (auto& part : omega) part.assign(n, 0.0);
    const Vec3 turning(3.0, 40.0, -25.0);  // base axes [rad/s]
    const double sine = std::sin(pose.azimuth), cosine = std::cos(pose.azimuth);
    const auto put = [&](const Place& where) {
      // At a fixed azimuth frame: a step along θ is one of the races the other way, so steps are
      // made in x and r here and along θ below.
      e.sin_theta[i] = sine;
      e.cos_theta[i] = cosine;
      x[i] = where.G[0];
      r[i] = -sine * where.G[1] + cosine * where.G[2];
      e.attitude[i] = where.attitude;
      e.elements.n = n;
      e.elements.x = x.data();
      e.elements.r = r.data();
      e.elements.sin_theta = e.sin_theta.data();
      e.elements.cos_theta = e.cos_theta.data();
      e.elements.x_dot = e.elements.r_dot = e.elements.theta_dot = zero.data();
      const Vec3 w = e.to_cylindrical(i, turning);
      for (int k = 0; k < 3; ++k) omega[k][i] = w[k];
      e.elements.omega_x = omega[0].data();
      e.elements.omega_r = omega[1].data();
      e.elements.omega_theta = omega[2].data();
    };
    put(at);
    const std::vector<std::size_t> list{i};
    std::vector<ContactLinearization> springs(1);
    held.springs(e, list, springs);
    REQUIRE(springs[0].normal.norm() > 1.0);
    CHECK((held.normal_force(e, i) - springs[0].normal.head<2>()).norm() <
          1e-12 * springs[0].normal.norm());
    const auto force_at = [&](const Place& where) {
      put(where);
      std::vector<ContactLinearization> out(1);
      held.springs(e, list, out);
      return out[0].normal;
    };
    const Mat3 whole = springs[0].race[0] + springs[0].race[1];
    const double h = 2e-9, scale = whole.norm();
    for (int k = 0; k < 2; ++k) {
      const Vec3 way = e.to_base(i, Vec3::Unit(k));
      const Vec3 slope =
          (force_at({at.G + h * way, at.attitude}) - force_at({at.G - h * way, at.attitude})) /
          (-2.0 * h);
      CAPTURE(k, whole.col(k).transpose(), slope.transpose());
      CHECK((whole.col(k) - slope).norm() < 1e-5 * scale);
    }
    const double dt = 1e-9;
    const Vec3 rate = (force_at({at.G, turned(dt * turning, at.attitude)}) -
                       force_at({at.G, turned(-dt * turning, at.attitude)})) /
                      (2.0 * dt);
    const Vec3 told = springs[0].turning[0] + springs[0].turning[1];
    CAPTURE(told.transpose(), rate.transpose());
    // 1.1e-4 where slices of a crowned roller close within the step of the difference.
    CHECK((told - rate).norm() < 3e-4 * rate.norm());
  }
}

TEST_CASE("mode 2 of rollers without friction stands at the static loads and keeps the asked one",
          "[physics][rollers][constrained]") {
  for (bearing::Bearing b : {roller_bearings::cylindrical(10.0), roller_bearings::tapered(10.0),
                             roller_bearings::spherical_tapered(10.0)}) {
    INFO("type " << static_cast<int>(b.type));
    Scene s = roller_scene::scene_of(b, mode_plan(2, roller_scene::races_only()), 9);
    const Snapshot now = run(s, 1e-6, 1e-10).last;  // the rollers pass 1e-6 rad
    const double load = s.rollers->solution.max_load;
    const Vec3 asked(b.constraints.load[0], b.constraints.load[1], b.constraints.load[2]);
    const Vec3 missing = now.races[1].applied_force - asked;
    for (int k = 0; k < 3; ++k)
      if (!b.constraints.displacement_given[static_cast<std::size_t>(k)])
        CHECK(std::abs(missing[k]) < 1e-9 * asked.norm());
    for (std::size_t i = 0; i < now.elements.size(); ++i)
      for (std::size_t j = 0; j < 2; ++j) {
        const std::vector<double>& solved = s.rollers->solution.rollers[i].race[j].slice_load;
        for (std::size_t k = 0; k < solved.size(); ++k)
          CHECK(now.elements[i].race[j].slice_load.at(k) == Approx(solved[k]).margin(1e-6 * load));
      }
  }
}

TEST_CASE("mode 2 of rollers at speed keeps the asked load to 1e-9",
          "[physics][rollers][constrained]") {
  bearing::Bearing b = roller_bearings::cylindrical(3000.0);
  Scene s = roller_scene::scene_of(b, mode_plan(2, roller_scene::races_only()), 9);
  const double pitch = 2.0 * std::numbers::pi / 14.0 / s.rollers->solution.orbital_speed;
  const Snapshot now = run(s, pitch, 1e-11).last;
  CHECK(std::abs(now.races[1].applied_force[2] - 5000.0) < 1e-9 * 5000.0);
  CHECK(std::abs(now.races[1].applied_force[1]) < 1e-9 * 5000.0);
  CHECK(std::abs(now.energy.residual()) < 1e-8 * now.energy.value("elastic"));
}

TEST_CASE("mode 1 of rollers has the orbits and the heat of mode 0",
          "[physics][rollers][constrained][slow]") {
  const bearing::Bearing b = with_cage(roller_bearings::tapered(3000.0));
  std::array<Snapshot, 2> of;
  for (int mode = 0; mode <= 1; ++mode) {
    Scene s = roller_scene::scene_of(b, mode_plan(mode), 9);
    of[static_cast<std::size_t>(mode)] = run(s, 4e-3, 1e-6).last;  // a fifth of a turn
  }
  for (const char* item : {"heat", "flange_heat"})
    for (const int race : {0, 1}) {
      if (of[0].energy.find(item, race) == nullptr) continue;
      INFO(item << " " << race);
      CHECK(of[1].energy.value(item, race) == Approx(of[0].energy.value(item, race)).epsilon(0.01));
    }
  CHECK(of[1].cages[0].total_rotation == Approx(of[0].cages[0].total_rotation).epsilon(1e-3));
  CHECK(of[1].elements[3].vr == 0.0);
}

TEST_CASE("modes 1 and 2 and qFac of rollers close the energy ledger",
          "[physics][rollers][constrained][energy]") {
  const auto residual = [](const bearing::Bearing& b, const ScenePlan& plan, double tolerance) {
    Scene s = roller_scene::scene_of(b, plan, 9);
    const Run done = run(s, 4e-4, tolerance, "rkf4");
    CHECK(done.most_held > 0);
    CHECK(done.last.energy.value("left_out") >= 0.0);
    CHECK(done.last.momentum->linear.residual().norm() < 1e-5 * done.last.momentum->linear_size);
    CHECK(done.last.momentum->angular.residual().norm() < 1e-5 * done.last.momentum->angular_size);
    return std::abs(done.last.energy.residual()) / done.last.energy.value("elastic");
  };
  for (bearing::Bearing b : {roller_bearings::cylindrical(3000.0), roller_bearings::tapered(3000.0),
                             roller_bearings::spherical_tapered(3000.0)}) {
    b = with_cage(b);
    ScenePlan light = roller_scene::with_friction();
    light.effects.push_back({Effect::LightLoadBalance, "", true, "test"});
    light.light_load_ratio = 0.1;
    int k = 1;
    for (const ScenePlan& plan : {mode_plan(1), mode_plan(2), light}) {
      const double coarse = residual(b, plan, 1e-5), fine = residual(b, plan, 1e-8);
      INFO("type " << static_cast<int>(b.type) << ", case " << k++ << ": " << coarse << " -> "
                   << fine);
      // qFac turns rollers into line; of spherical tapered ones the residual at tolerances of 1e-5,
      // 1e-8, 1e-9, 1e-10 is 4.4e-5, 1.2e-6, 7.3e-8, 1.8e-8.
      CHECK(fine < (plan.has(Effect::LightLoadBalance) ? 2e-6 : 1e-6));
      // qFac of the cylindrical one, whose rollers change sides often: 2.3e-6 -> 2.4e-7.
      CHECK(fine < std::max(0.2 * coarse, 1e-8));
    }
  }
}

TEST_CASE("held rollers: every kind of stepper follows the same motion",
          "[physics][rollers][held][constrained][slow]") {
  const bearing::Bearing b = with_cage(roller_bearings::tapered(3000.0));
  for (const int mode : {1, 2}) {
    Scene first = roller_scene::scene_of(b, mode_plan(mode), 9);
    const Snapshot exact = run(first, 1e-4, 1e-10, "rkf7").last;
    for (const char* method : {"rkf4", "pece4", "cvode-bdf", "arkode-dirk"}) {
      Scene s = roller_scene::scene_of(b, mode_plan(mode), 9);
      const Snapshot now = run(s, 1e-4, 1e-8, method).last;
      INFO("mode " << mode << ", " << method);
      for (std::size_t i = 0; i < now.elements.size(); ++i) {
        CHECK(now.elements[i].r == Approx(exact.elements[i].r).margin(1e-9));
        CHECK(
            now.elements[i].race[1].load ==
            Approx(exact.elements[i].race[1].load).margin(1e-4 * first.rollers->solution.max_load));
      }
      CHECK((now.races[1].position - exact.races[1].position).norm() < 1e-9);
    }
  }
}
