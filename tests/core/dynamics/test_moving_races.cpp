#include "core/dynamics/system_fixture.hpp"
#include "dynamics/effect.hpp"
#include "dynamics/rigid_body.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>

using namespace adore;
using namespace adore::dynamics;
using namespace adore::fixture;

namespace {

/// Both races swing about base y and shake along z, each at its own frequency, beside their spin:
/// a full rigid motion, written at every evaluation.
class Shaking final : public SceneEffect {
 public:
  void declare(SceneBuilder& scene) override { scene.block<Motion>(Phase::Races, "shaking", {}); }
  [[nodiscard]] bool moves_races() const noexcept override { return true; }

 private:
  class Motion final : public EffectBlock {
   public:
    void apply(Evaluation& e) noexcept override {
      for (std::size_t j = 0; j < 2; ++j) {
        RaceBody& race = e.race[j];
        const double w = j == 0 ? 2.0e3 : 3.0e3, swing = 2e-4, shake = 3e-6;
        const double s = std::sin(w * e.t), c = std::cos(w * e.t);
        race.position.z() += shake * s;
        race.velocity.z() += shake * w * c;
        race.acceleration.z() -= shake * w * w * s;
        race.set_attitude(multiply(quaternion_about(Vec3::UnitY(), swing * s), race.attitude));
        const Vec3 turning = swing * w * c * Vec3::UnitY();
        race.tilt += turning - turning.dot(race.axis()) * race.axis();
        race.settle();
      }
    }
  };
};

System shaken(const bearing::Bearing& b, const ScenePlan& plan) {
  const double angle = b.balls().contact_angle;
  return {b, plan, statics_of(b, angle), {angle, angle}, {}, {[](const ScenePlan&) {
            return std::make_unique<Shaking>();
          }}};
}

}  // namespace

TEST_CASE("races that shake and tilt by a law keep the energy ledger",
          "[physics][dynamics][energy]") {
  bearing::Bearing b = angular_contact();
  b.cage->start_offset = {0.0, 0.0,
                          -2.0e-4};  // at the outer race's land: its motion works there too
  const double end = 1e-3;
  for (const bool friction : {true, false}) {
    ScenePlan plan = full_plan();
    if (!friction)
      plan = plan_with({Effect::RaceContact, Effect::PocketContact, Effect::LandContact,
                        Effect::CageMotion, Effect::Gravity});
    System system = shaken(b, plan);
    double first = 0.0, residual = 0.0;
    for (const double tolerance : {1e-4, 1e-6, 1e-8}) {
      const RunResult result = run(system, system.initial_state(), end, tolerance, "rkf4");
      const Snapshot snapshot = system.snapshot(end, result.y);
      const EnergyLedger& energy = snapshot.energy;
      // Each race has done work, also where there is no friction.
      CHECK(std::abs(energy.value("work", 0)) > 1e-4);
      CHECK(std::abs(energy.value("work", 1)) > 1e-4);
      residual = std::abs(energy.residual());
      INFO("friction " << friction << ", tolerance " << tolerance << ", residual " << residual);
      if (first == 0.0) first = residual;
      CHECK(residual <= first);

      const RaceSnapshot& race = snapshot.races[1];
      CHECK(race.omega.y() == Approx(2e-4 * 3e3 * std::cos(3e3 * end)).epsilon(1e-6));
      CHECK(race.velocity.z() == Approx(3e-6 * 3e3 * std::cos(3e3 * end)));
      CHECK(race.total_rotation == b.speed[1] * end);
    }
    CHECK(residual < 1e-2 * first);
  }
}

TEST_CASE("the fast part of the motion sees the races where they are at its own time",
          "[unit][dynamics]") {
  const bearing::Bearing b = angular_contact();
  System system = shaken(b, plan_with({Effect::RaceContact}));
  const std::vector<double> y = system.initial_state();
  std::vector<double> early(y.size()), late(y.size()), whole(y.size());
  const double t = 4e-4;
  REQUIRE(system.rhs(t, y.data(), whole.data()) == RhsStatus::Ok);
  REQUIRE(system.rhs_stiff(0.0, y.data(), early.data()) == RhsStatus::Ok);
  REQUIRE(system.rhs_stiff(t, y.data(), late.data()) == RhsStatus::Ok);
  // Without traction, cage and gravity ẍ is all of the normal forces.
  const int x_dot = 3 * b.balls().count;
  double largest = 0.0, moved = 0.0;
  for (int i = x_dot; i < x_dot + b.balls().count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    largest = std::max(largest, std::abs(whole[k]));
    moved = std::max(moved, std::abs(late[k] - early[k]));
    CHECK(late[k] == Approx(whole[k]).margin(1e-9 * std::abs(whole[k])));
  }
  CHECK(moved > 0.01 * largest);
}
