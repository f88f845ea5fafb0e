#include "core/dynamics/system_fixture.hpp"
#include "dynamics/effects/free_body.hpp"
#include "integrators/arrow_jacobian.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace adore;
using namespace adore::dynamics;
using namespace adore::fixture;

namespace {

/// Springs and dampers between each element and one body, and a drag on their relative spin.
class Tethers final : public EffectBlock {
 public:
  Tethers(std::vector<BodyId> to, double stiffness) : to_(std::move(to)), k_(stiffness) {}
  void apply(Evaluation& e) noexcept override {
    for (std::size_t i = 0; i < e.elements.n; ++i) {
      BodyState& body = e.body(to_[i]);
      const Vec3 centre = e.element_centre(i);
      const Vec3 anchor = body.position + body.to_base * Vec3(0.001, 0.02, 0.03);
      const Vec3 stretch = centre - anchor;
      const Vec3 force = -k_ * (1.0 + 20.0 * stretch.squaredNorm()) * stretch -
                         2.0 * (e.element_velocity(i) - body.velocity_at(centre));
      const Vec3 moment = -1e-4 * (e.element_omega(i) - body.omega);
      e.add_force(i, e.to_cylindrical(i, force));
      e.add_moment(i, e.to_cylindrical(i, moment));
      body.add_force(-force, centre);
      body.moment -= moment;
    }
  }

 private:
  std::vector<BodyId> to_;
  double k_;
};

/// Two bodies of its own: the even elements are tied to the first, the odd ones to the second, and
/// all of them by weaker ties to the second.
class TwoBodies final : public SceneEffect {
 public:
  void declare(SceneBuilder& scene) override {
    scene.e.others.resize(2);
    std::vector<BodyId> each, second;
    for (int i = 0; i < scene.bearing.element_count(); ++i) {
      each.push_back({BodyId::Kind::Other, i % 2});
      second.push_back({BodyId::Kind::Other, 1});
    }
    bodies_[0].declare(scene, {BodyId::Kind::Other, 0}, "first", {0.3, {2e-4, 3e-4, 4e-4}});
    bodies_[1].declare(scene, {BodyId::Kind::Other, 1}, "second",
                       {0.5, {5e-4, 4e-4, 3e-4}, {-1e-3, -2e-3, 3e-3}, {0.2, -0.1, 0.3}});
    for (FreeBody& body : bodies_)
      scene.block<BodyKinematics>(Phase::Kinematics, "bodies", {}, body);
    scene.block<Tethers>(Phase::Force, "ties", CoupledBodies(each), each, 2e4);
    scene.block<Tethers>(Phase::Force, "ties", second.front(), second, 3e3);
    for (FreeBody& body : bodies_) scene.block<BodyMotion>(Phase::Motion, "bodies", {}, body);
  }
  void start(std::span<double> y) const override {
    for (std::size_t k = 0; k < 2; ++k)
      bodies_[k].start(y, Vec3(0.001, -0.002, 0.003), Vec3(0.1, 0.2, -0.1),
                       quaternion_about(Vec3(0.6, 0.0, 0.8), 0.4 + 0.1 * static_cast<double>(k)),
                       Vec3(300.0, 5.0, -7.0));
  }

 private:
  std::array<FreeBody, 2> bodies_;
};

/// Spheres of the ring that press and rub on the ones before and after them, as in a bearing
/// without cage: a linear law, wide enough that every pair touches.
class Neighbours final : public SceneEffect {
 public:
  void declare(SceneBuilder& scene) override {
    const double spacing = scene.bearing.balls().pitch_diameter *
                           std::sin(std::numbers::pi / scene.bearing.element_count());
    scene.block<Contact>(Phase::Force, "element to element", {}, 1.01 * spacing);
    scene.neighbours_meet();
  }

 private:
  class Contact final : public EffectBlock {
   public:
    explicit Contact(double reach) : reach_(reach) {}
    void apply(Evaluation& e) noexcept override {
      for (std::size_t i = 0; i < e.elements.n; ++i) {
        const std::size_t next = (i + 1) % e.elements.n;
        const Vec3 between = e.element_centre(next) - e.element_centre(i);
        const double distance = between.norm();
        if (distance >= reach_) continue;
        const Vec3 n = between / distance, arm = 0.5 * between;
        Vec3 slip = e.element_velocity(next) - e.element_omega(next).cross(arm) -
                    e.element_velocity(i) - e.element_omega(i).cross(arm);
        slip -= slip.dot(n) * n;
        const Vec3 friction = 0.3 * slip, on_first = -1e6 * (reach_ - distance) * n + friction;
        e.add_force(i, e.to_cylindrical(i, on_first));
        e.add_force(next, e.to_cylindrical(next, -on_first));
        e.add_moment(i, e.to_cylindrical(i, arm.cross(friction)));
        e.add_moment(next, e.to_cylindrical(next, arm.cross(friction)));
      }
    }

   private:
    double reach_;
  };
};

/// Shows nothing of its structure: a dense Jacobian, one component after the other.
class Hidden final : public integrators::OdeSystem {
 public:
  explicit Hidden(System& system) : all_(system) {}
  [[nodiscard]] int size() const noexcept override { return all_.size(); }
  [[nodiscard]] int controlled_size() const noexcept override { return all_.controlled_size(); }
  [[nodiscard]] std::span<const double> scales() const noexcept override { return all_.scales(); }
  integrators::EvalStatus rhs(double t, const double* y, double* d) noexcept override {
    return all_.rhs(t, y, d);
  }

 private:
  Adapter all_;
};

/// Away from every symmetry.
std::vector<double> disturbed(const System& system, double size) {
  std::vector<double> y = system.initial_state();
  for (int k = 0; k < system.layout().controlled_size(); ++k)
    y[static_cast<std::size_t>(k)] +=
        size * system.layout().scales()[static_cast<std::size_t>(k)] * std::sin(1.0 + 3.7 * k);
  return y;
}

/// Largest difference between the arrow's and the dense Jacobian, against the largest entry of the
/// row, in scaled components; and that what the structure leaves out is 0.
void compare_jacobians(System& system, std::vector<double> y) {
  using namespace integrators;
  Adapter shown(system);
  Hidden hidden(system);
  ArrowJacobian by_structure(shown, RhsPart::Whole), one_by_one(hidden, RhsPart::Whole);
  ArrowMatrix arrow(by_structure.shape()), dense(one_by_one.shape());
  std::vector<double> f(y.size());
  REQUIRE(system.rhs(0.0, y.data(), f.data()) == RhsStatus::Ok);
  REQUIRE(by_structure(0.0, y.data(), f.data(), arrow) == Outcome::Ok);
  REQUIRE(one_by_one(0.0, y.data(), f.data(), dense) == Outcome::Ok);
  CHECK(by_structure.evaluations() < one_by_one.evaluations());
  const auto scales = shown.scales();
  int wrong = 0;
  for (int i = 0; i < shown.controlled_size(); ++i) {
    double largest = 0.0;
    for (int j = 0; j < shown.controlled_size(); ++j)
      largest = std::max(largest, std::abs(dense.at(i, j)) * scales[static_cast<std::size_t>(j)]);
    // Forward differences over 1.5e-8 of the scale round by some 1e-8 of the rate.
    largest += std::abs(f[static_cast<std::size_t>(i)]);
    for (int j = 0; j < shown.controlled_size(); ++j) {
      double value = 0.0;
      try {
        value = arrow.at(i, j);
      } catch (const std::out_of_range&) {  // the structure says that there is nothing
      }
      const double off =
          std::abs(value - dense.at(i, j)) * scales[static_cast<std::size_t>(j)] / largest;
      if (largest > 0.0 && !(off < 1e-6) && ++wrong < 5)
        FAIL_CHECK(system.layout().component_name(i) << " by " << system.layout().component_name(j)
                                                     << ": " << value << " and " << dense.at(i, j));
    }
  }
  CHECK(wrong == 0);
}

System with(const bearing::Bearing& b, const ScenePlan& plan,
            const std::vector<EffectMaker>& more) {
  const double angle = b.balls().contact_angle;
  return {b, plan, statics_of(b, angle), {angle, angle}, {}, more};
}
template <class E>
EffectMaker maker() {
  return [](const ScenePlan&) { return std::make_unique<E>(); };
}

}  // namespace

TEST_CASE("Jacobian: several bodies in the border → dense difference",
          "[physics][dynamics][implicit]") {
  bearing::Bearing b = angular_contact(9, 0.07);
  b.cage->pocket_clearance_1 = b.cage->pocket_clearance_2 = 2e-5;
  b.cage->start_offset = {0.0, 1.2e-4, -8e-5};
  System system = with(b, full_plan(), {maker<TwoBodies>()});
  const auto owner = system.coupling();
  CHECK(std::count(owner.begin(), owner.end(), -1) == 3 * 14);  // cage, first, second
  compare_jacobians(system, disturbed(system, 1e-5));

  // What all elements do to the three bodies is what the elements feel, seen from the bodies: the
  // rates of a body are its own without elements and the sum of the shares.
  const std::vector<double> y = disturbed(system, 1e-5);
  std::vector<double> f(y.size()), plain(y.size()), shares(9 * 42);
  REQUIRE(system.rhs(0.0, y.data(), plain.data()) == RhsStatus::Ok);
  REQUIRE(system.rhs_with_contributions(0.0, y.data(), f.data(), shares.data()) == RhsStatus::Ok);
  CHECK(f == plain);
  const auto slice = [&](std::string_view name) {
    for (const auto& group : system.layout().groups())
      if (group.name == name) return group.slice.first;
    FAIL("no " << name);
    return 0;
  };
  const int first_border =
      static_cast<int>(std::find(owner.begin(), owner.end(), -1) - owner.begin());
  for (const int body : {slice("first.velocity"), slice("second.velocity")})
    for (int k = body; k < body + 3; ++k) {
      double sum = 0.0;
      for (int i = 0; i < 9; ++i)
        sum += shares[static_cast<std::size_t>(i * 42 + k - first_border)];
      CHECK(sum == Approx(f[static_cast<std::size_t>(k)]).epsilon(1e-9));
    }
}

TEST_CASE("elements that touch their neighbors form a ring with the Jacobian of a dense difference",
          "[physics][dynamics][implicit]") {
  for (const int balls : {7, 12}) {
    bearing::Bearing b = angular_contact(balls, 0.07);
    b.cage.reset();
    System alone =
        with(b, plan_with({Effect::RaceContact, Effect::RaceTraction}), {maker<Neighbours>()});
    CHECK(alone.neighbours_meet());
    compare_jacobians(alone, disturbed(alone, 1e-5));
    // A ring and bodies in the border.
    System both = with(b, plan_with({Effect::RaceContact, Effect::RaceTraction}),
                       {maker<Neighbours>(), maker<TwoBodies>()});
    compare_jacobians(both, disturbed(both, 1e-5));
  }
}

TEST_CASE("free races: in the border with the cage", "[physics][dynamics][implicit]") {
  bearing::Bearing b = angular_contact(9, 0.07);
  b.gravity = {0.0, 0.0, -9.81};
  b.cage->pocket_clearance_1 = b.cage->pocket_clearance_2 = 2e-5;
  b.cage->start_offset = {0.0, 1.2e-4, -8e-5};
  b.race_inertia = {bearing::Inertia{0.9, {9e-4, 6e-4, 6e-4}},
                    bearing::Inertia{0.5, {3e-4, 2e-4, 2e-4}}};
  ScenePlan plan = full_plan();
  plan.race_motions.free[1].emplace().force = {1500.0, 0.0, 500.0};
  b.race_inertia[1].geometric_centre = {-1e-3, -2e-4, 0.0};
  b.race_inertia[1].frame = {0.1, 0.05, -0.2};
  plan.race_motions.free[1]->rotation_held = {true, false, false};
  System one = with(b, plan, {});
  compare_jacobians(one, disturbed(one, 1e-5));
  plan.race_motions.free[0].emplace().translation_held = {true, true, true};
  System both = with(b, plan, {});
  const auto owner = both.coupling();
  CHECK(std::count(owner.begin(), owner.end(), -1) == 3 * 14);
  compare_jacobians(both, disturbed(both, 1e-5));
}

TEST_CASE("implicit steps: ring of touching elements → end of explicit ones",
          "[physics][dynamics][implicit]") {
  bearing::Bearing b = angular_contact(8, 0.07);
  b.cage.reset();
  System system = with(b, plan_with({Effect::RaceContact, Effect::RaceTraction}),
                       {maker<Neighbours>(), maker<TwoBodies>()});
  const std::vector<double> y0 = system.initial_state();
  const double end = 5e-5;
  const RunResult reference = run(system, y0, end, 1e-11, "rkf7");
  const auto scales = system.layout().scales();
  double previous = 1e300;
  for (const double tolerance : {1e-5, 1e-8}) {
    const RunResult implicit = run(system, y0, end, tolerance, "cvode-bdf");
    double error = 0.0;
    for (int i = 0; i < system.layout().controlled_size(); ++i)
      error = std::max(error, std::abs(implicit.y[i] - reference.y[i]) / scales[i]);
    INFO("tolerance " << tolerance << ": error " << error << ", steps " << implicit.counters.steps
                      << ", iterations " << implicit.counters.nonlinear_iterations);
    CHECK(error < 0.1 * previous);
    previous = error;
    // A right Jacobian: a few iterations a step.
    CHECK(implicit.counters.nonlinear_iterations < 3 * implicit.counters.steps);
  }
  CHECK(previous < 1e-4);
}
