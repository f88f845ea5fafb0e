#include "bearing/element_inertia.hpp"
#include "core/dynamics/allocation_counter.hpp"
#include "core/dynamics/system_fixture.hpp"
#include "core/dynamics/thrust_scene.hpp"
#include "dynamics/constrained.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

/// Balls on split races in motion: both halves are contacts.
using namespace adore;
using namespace adore::fixture;
using dynamics::InstructionSet;
using dynamics::System;
using scene::Effect;
using scene::Snapshot;
using scene::Vec3;

namespace {

constexpr double kShim = 1e-4;

/// The inner race split, or both; radial load.
bearing::Bearing split(double outer, double inner, double rpm = 6000.0, int balls = 9) {
  bearing::Bearing b = angular_contact(balls, 0.07);
  b.cage.reset();
  b.balls().shim = {outer, inner};
  b.constraints.load = {100.0, 0.0, 2500.0, 0.0, 0.0};
  b.speed = {0.0, rpm * std::numbers::pi / 30.0};
  return b;
}

/// Both halves of race j.
std::array<dynamics::RaceContactModel, 2> halves_of(const bearing::Bearing& b, std::size_t j,
                                                    bool follows) {
  std::array<dynamics::RaceContactModel, 2> out;
  const contact::GrooveGeometry groove = contact::groove_geometry(b.balls());
  const auto half = contact::split_race_halves(b.balls(), groove, static_cast<int>(j));
  for (std::size_t h = 0; h < 2; ++h) {
    dynamics::RaceContactModel& model = out[h];
    model.race = static_cast<bearing::Race>(j);
    model.groove = groove;
    model.effective_modulus = bearing::contact_modulus(b.element_material, b.race_material[j]);
    model.hertz = contact::hertz_constants(
        contact::race_curvature(b.balls(), static_cast<int>(j), b.balls().contact_angle),
        model.effective_modulus);
    if (follows) model.angle = angle_laws(b)[j];
    model.law = b.race_traction;
    model.rule = tribology::make_split_ellipse_rule(4, 4);
    model.half = half[h];
    dynamics::set_unequal_balls(model, b.balls(), {}, {}, b.balls().contact_angle,
                                static_cast<std::size_t>(b.element_count()));
  }
  return out;
}

/// Balls that sit on both halves of the inner race, some with an ellipse that the split cuts.
struct Balls {
  std::array<std::vector<double>, 10> value;
  Balls(const bearing::Bearing& b, const contact::GrooveGeometry& groove) {
    const int n = b.element_count();
    for (int i = 0; i < n; ++i) {
      const double psi = 2.0 * std::numbers::pi * i / n;
      const double aside = 3e-5 * std::cos(psi), deep = 2e-5 + 1e-5 * std::sin(psi);
      const double of[] = {groove.centre_x[1] - 0.5 * kShim + aside,
                           groove.centre_radius[1] - groove.offset[1] - deep,
                           std::sin(psi),
                           std::cos(psi),
                           2e-3,
                           -1e-3,
                           250.0,
                           -1400.0,
                           30.0,
                           5.0};
      for (std::size_t k = 0; k < value.size(); ++k) value[k].push_back(of[k]);
    }
  }
  [[nodiscard]] dynamics::ElementViews views() const {
    const auto at = [&](std::size_t k) { return value[k].data(); };
    return {value[0].size(), at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7), at(8), at(9)};
  }
};

dynamics::RaceMotion tilted_race(const contact::GrooveGeometry& groove) {
  dynamics::RaceMotion race{Vec3(groove.centre_x[1], 1e-6, -2e-6),
                            Vec3(1.0, 2e-4, -1e-4).normalized(), 600.0};
  race.velocity = Vec3(1e-3, -2e-3, 5e-4);
  race.tilt = Vec3(0.0, 0.3, 0.5);
  race.tilt -= race.tilt.dot(race.axis) * race.axis;
  return race;
}

const Snapshot at_start(System& system, const std::vector<double>& y) {
  system.set_start(0.0, y);
  return system.snapshot(0.0, y);
}

}  // namespace

TEST_CASE("split race, kernels: forces are the gradient of the energy, reactions are opposite",
          "[physics][dynamics][split]") {
  const bearing::Bearing b = split(0.0, kShim);
  for (const bool follows : {false, true}) {
    auto half = halves_of(b, 1, follows);
    Balls balls(b, half[0].groove);
    const dynamics::RaceMotion race = tilted_race(half[0].groove);
    const std::size_t n = balls.value[0].size();
    for (const InstructionSet set :
         {InstructionSet::Baseline, InstructionSet::Avx2, InstructionSet::Avx512}) {
      if (!dynamics::is_instruction_set_available(set)) continue;
      for (auto& model : half) model.traction = false;
      const auto energy = [&] {
        double sum = 0.0;
        for (const auto& model : half) {
          test::Outputs out(n);
          sum += dynamics::evaluate_race_contacts(set, model, balls.views(), race, out.forces())
                     .elastic_energy;
        }
        return sum;
      };
      test::Outputs all(n);
      for (const auto& model : half)
        dynamics::evaluate_race_contacts(set, model, balls.views(), race, all.forces());
      int cut = 0;
      for (std::size_t i = 0; i < n; ++i) {
        for (const auto& model : half) {
          const auto state = dynamics::race_contact_state(model.of(i), balls.views(), i, race);
          cut += state.share > 0.0 && state.share < 1.0 ? 1 : 0;
        }
        for (const std::size_t axis : {0U, 1U}) {
          constexpr double kStep = 1e-9;
          double& place = balls.value[axis][i];
          const double was = place;
          place = was + kStep;
          const double above = energy();
          place = was - kStep;
          const double below = energy();
          place = was;
          CHECK(all.value[axis][i] ==
                Approx(-(above - below) / (2.0 * kStep)).epsilon(1e-5).margin(1e-3));
        }
      }
      CHECK(cut > 0);
      // With friction: forces and moments of both bodies cancel, and so does the power.
      for (auto& model : half) {
        model.traction = true;
        test::Outputs out(n);
        const auto sums =
            dynamics::evaluate_race_contacts(set, model, balls.views(), race, out.forces());
        Vec3 force = sums.force, moment = sums.moment + race.centre.cross(sums.force);
        double power = sums.force.dot(race.velocity) +
                       sums.moment.dot(race.speed * race.axis + race.tilt),
               size = 0.0, heat = 0.0;
        for (std::size_t i = 0; i < n; ++i) {
          const double s = balls.value[2][i], c = balls.value[3][i], r = balls.value[1][i];
          const auto to_base = [&](std::size_t k) {
            const double x = out.value[k][i], e = out.value[k + 1][i], t = out.value[k + 2][i];
            return Vec3(x, -s * e - c * t, c * e - s * t);
          };
          const Vec3 at(balls.value[0][i], -r * s, r * c), F = to_base(0), M = to_base(3);
          force += F;
          moment += at.cross(F) + M;
          power += out.value[0][i] * balls.value[4][i] + out.value[1][i] * balls.value[5][i] +
                   out.value[2][i] * r * balls.value[6][i];
          for (std::size_t k = 0; k < 3; ++k) power += out.value[3 + k][i] * balls.value[7 + k][i];
          size += F.norm();
          heat += out.value[7][i];
        }
        REQUIRE(size > 0.0);
        CHECK(force.norm() < 1e-10 * size);
        CHECK(moment.norm() < 1e-10 * size * 0.035);
        CHECK(sums.heat == Approx(heat).epsilon(1e-11));
        CHECK(heat > 0.0);
        // What is left of the power changes the elastic energy.
        constexpr double kTime = 1e-9;
        Balls before = balls;
        dynamics::RaceMotion early = race;
        const auto stored = [&](double t) {
          Balls moved = before;
          for (std::size_t i = 0; i < n; ++i) {
            const double psi =
                std::atan2(before.value[2][i], before.value[3][i]) + t * before.value[6][i];
            moved.value[0][i] += t * before.value[4][i];
            moved.value[1][i] += t * before.value[5][i];
            moved.value[2][i] = std::sin(psi);
            moved.value[3][i] = std::cos(psi);
          }
          early.centre = race.centre + t * race.velocity;
          early.axis = (race.axis + t * race.tilt.cross(race.axis)).normalized();
          test::Outputs scratch(n);
          return dynamics::evaluate_race_contacts(set, model, moved.views(), early,
                                                  scratch.forces())
              .elastic_energy;
        };
        const double rate = (stored(kTime) - stored(-kTime)) / (2.0 * kTime);
        CHECK(power + heat == Approx(-rate).epsilon(1e-4).margin(1e-4 * heat));
      }
    }
  }
}

TEST_CASE("split race: all instruction sets and the report agree", "[unit][dynamics][split]") {
  const bearing::Bearing b = split(0.0, kShim);
  const auto half = halves_of(b, 1, true);
  const Balls balls(b, half[0].groove);
  const dynamics::RaceMotion race = tilted_race(half[0].groove);
  const std::size_t n = balls.value[0].size();
  for (const auto& model : half) {
    test::Outputs base(n);
    dynamics::evaluate_race_contacts(InstructionSet::Baseline, model, balls.views(), race,
                                     base.forces());
    for (const InstructionSet set : {InstructionSet::Avx2, InstructionSet::Avx512}) {
      if (!dynamics::is_instruction_set_available(set)) continue;
      test::Outputs out(n);
      dynamics::evaluate_race_contacts(set, model, balls.views(), race, out.forces());
      for (std::size_t k = 0; k < 9; ++k)
        for (std::size_t i = 0; i < n; ++i)
          CHECK(out.value[k][i] == Approx(base.value[k][i]).epsilon(1e-10).margin(1e-9));
    }
    for (std::size_t i = 0; i < n; ++i) {
      const auto detail = dynamics::race_contact_detail(model.of(i), balls.views(), i, race);
      CHECK(detail.load == Approx(base.value[6][i]).epsilon(1e-10).margin(1e-12));
      CHECK(detail.heat == Approx(base.value[7][i]).epsilon(1e-9).margin(1e-12));
    }
  }
}

TEST_CASE("split race: a ball in balance has the forces of the kernel and exact stiffness",
          "[unit][dynamics][split]") {
  const bearing::Bearing b = split(0.0, kShim);
  auto half = halves_of(b, 1, true);
  const Balls balls(b, half[0].groove);
  dynamics::RaceMotion race = tilted_race(half[0].groove);
  race.axis = Vec3::UnitX();
  race.centre = Vec3(half[0].groove.centre_x[1], 0.0, 0.0);
  const auto law = angle_laws(b);
  dynamics::ConstrainedBall ball(half[0].groove, {half[0].hertz.K, half[0].hertz.K}, 0.01, law);
  ball.set_split_halves({std::array<contact::SplitRaceHalf, 2>{}, {half[0].half, half[1].half}});
  test::Outputs out(balls.value[0].size());
  for (auto& model : half) {
    model.traction = false;
    dynamics::evaluate_race_contacts(InstructionSet::Baseline, model, balls.views(), race,
                                     out.forces());
  }
  const dynamics::RacePose pose{race.centre, race.axis};
  for (std::size_t i = 0; i < balls.value[0].size(); ++i) {
    const dynamics::Vec2 at(balls.value[0][i], balls.value[1][i]);
    const auto c = ball.contact_with(1, pose, at);
    CHECK(c.force[0] == Approx(out.value[0][i]).epsilon(1e-10).margin(1e-8));
    CHECK(c.force[1] == Approx(out.value[1][i]).epsilon(1e-10).margin(1e-8));
    for (int k = 0; k < 2; ++k) {
      constexpr double kStep = 1e-10;
      dynamics::Vec2 above = at, below = at;
      above[k] += kStep;
      below[k] -= kStep;
      const Vec3 slope =
          (ball.contact_with(1, pose, above).force - ball.contact_with(1, pose, below).force) /
          (2.0 * kStep);
      for (int row = 0; row < 2; ++row)
        CHECK(c.stiffness(row, k) == Approx(-slope[row]).epsilon(1e-4).margin(1e3));
    }
  }
}

TEST_CASE("split races: at rest the forces are those of the static solution",
          "[physics][dynamics][split]") {
  for (const double outer : {0.0, 8e-5})
    for (const double thrust : {0.0, 100.0, -100.0, -1500.0}) {
      CAPTURE(outer, thrust);
      bearing::Bearing b = split(outer, kShim, 0.0);
      b.constraints.load[0] = thrust;
      if (thrust == -1500.0) b.constraints.load[2] = 200.0;
      const auto solution = statics_of(b, b.balls().contact_angle);
      System system = make_system(b, plan_with({Effect::RaceContact}), solution);
      const std::vector<double> y = system.initial_state();
      const Snapshot s = at_start(system, y);
      for (std::size_t i = 0; i < s.elements.size(); ++i) {
        const statics::StaticBall& ball = solution.balls[i];
        const double m = bearing::inertia_of(b, i).mass, size = solution.max_load;
        for (std::size_t j = 0; j < 2; ++j) {
          CHECK(s.elements[i].race[j].load == Approx(ball.Q[j]).margin(1e-7 * size));
          CHECK(s.elements[i].second[j].load == Approx(ball.second[j].Q).margin(1e-7 * size));
          if (ball.second[j].Q > 1e-3 * size)
            CHECK(std::abs(s.elements[i].second[j].angle) ==
                  Approx(std::abs(ball.second[j].alpha)).margin(1e-6));
        }
        CHECK(m * std::abs(s.elements[i].ax) < 1e-7 * size);
        CHECK(m * std::abs(s.elements[i].ar) < 1e-7 * size);
      }
      const Vec3 load(b.constraints.load[0], 0.0, b.constraints.load[2]);
      CHECK((s.races[1].applied_force - load).norm() < 1e-7 * load.norm());
    }
}

TEST_CASE("split races: without friction energy stays, with it the ledger balances",
          "[physics][dynamics][split][energy]") {
  using enum Effect;
  for (const bool friction : {false, true}) {
    const bearing::Bearing b = split(8e-5, kShim);
    const scene::ScenePlan plan =
        friction ? plan_with({RaceContact, RaceTraction, Gravity, WearIntegrals, MomentumLedger})
                 : plan_with({RaceContact, Gravity, MomentumLedger});
    System system = make_system(b, plan);
    const double end = 1e-3;
    const RunResult result = fixture::run(system, system.initial_state(), end, 1e-9);
    const Snapshot at = system.snapshot(end, result.y);
    const double residual =
        std::abs(at.energy.residual()) / at.energy.sum(scene::LedgerKind::Start);
    INFO("friction " << friction << ": " << residual);
    CHECK(residual < (friction ? 3e-7 : 1e-7));
    CHECK(at.momentum->linear.residual().norm() < 1e-7 * at.momentum->linear_size);
    CHECK(at.momentum->angular.residual().norm() < 1e-7 * at.momentum->angular_size);
    double second = 0.0;
    for (const auto& element : at.elements) second = std::max(second, element.second[1].load);
    CHECK(second > 10.0);
  }
}

TEST_CASE("split races: the right-hand side allocates nothing", "[unit][dynamics][split][alloc]") {
  System system =
      make_system(split(8e-5, kShim),
                  plan_with({Effect::RaceContact, Effect::RaceTraction, Effect::WearIntegrals}));
  const std::vector<double> y = system.initial_state();
  std::vector<double> dydt(y.size());
  system.set_start(0.0, y);
  system.rhs(0.0, y.data(), dydt.data());
  const auto before = test::allocation_count();
  system.rhs(1e-7, y.data(), dydt.data());
  CHECK(test::allocation_count() == before);
}
