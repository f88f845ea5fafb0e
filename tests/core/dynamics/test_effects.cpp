#include "core/dynamics/system_fixture.hpp"
#include "dynamics/effect.hpp"
#include "dynamics/effect_catalogue.hpp"
#include "results/run_json.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <set>

using namespace adore;
using namespace adore::dynamics;
using namespace adore::fixture;

namespace {

/// Air drag of the balls as a plain quadratic law, F = -c |v| v on the velocity of the mass center:
/// what a new effect costs. All of it is this one piece of code.
class AirDrag final : public SceneEffect {
 public:
  explicit AirDrag(double coefficient) : c_(coefficient) {}
  void declare(SceneBuilder& scene) override {
    static constexpr LedgerTerm kHeat{LedgerKind::Heat,
                                      "air_heat",
                                      "heat in the air",
                                      {"air drag"},
                                      "dissipated since the start"};
    scene.block<Drag>(Phase::Force, "air drag", {}, c_, heat_);
    scene.energy("air.heat", kHeat, &heat_);
  }

 private:
  class Drag final : public EffectBlock {
   public:
    Drag(double coefficient, double& heat) : c_(coefficient), heat_(heat) {}
    void apply(Evaluation& e) noexcept override {
      heat_ = 0.0;
      for (std::size_t i = 0; i < e.elements.n; ++i) {
        const double vx = e.elements.x_dot[i], vr = e.elements.r_dot[i];
        const double vt = e.elements.r[i] * e.elements.theta_dot[i];
        const double g = c_ * std::sqrt(vx * vx + vr * vr + vt * vt);
        e.add_force(i, -g * Vec3(vx, vr, vt));
        heat_ += g * (vx * vx + vr * vr + vt * vt);
      }
    }

   private:
    double c_;
    double& heat_;
  };
  double c_, heat_ = 0.0;
};

System with_drag(const bearing::Bearing& b, const ScenePlan& plan, double coefficient) {
  const double angle = b.balls().contact_angle;
  return {b, plan, statics_of(b, angle), {angle, angle}, {}, {[coefficient](const ScenePlan&) {
            return std::make_unique<AirDrag>(coefficient);
          }}};
}

}  // namespace

TEST_CASE("effect catalogue: added effect → acts, closes the energy ledger, is shown by name",
          "[physics][dynamics][energy]") {
  const bearing::Bearing b = angular_contact();
  const ScenePlan plan = full_plan();
  const double c = 1e-4, end = 2e-4;  // [kg/m]
  System plain = make_system(b, plan), drag = with_drag(b, plan, c);
  CHECK(drag.layout().controlled_size() == plain.layout().controlled_size());
  CHECK(drag.layout().size() == plain.layout().size() + 1);

  double previous = 0.0;
  for (const double tolerance : {1e-6, 1e-9}) {
    const std::vector<double> y0 = drag.initial_state();
    const double at_start = drag.snapshot(0.0, y0).energy.rate("air_heat");
    const RunResult result = run(drag, y0, end, tolerance, "rkf4");
    const Snapshot snapshot = drag.snapshot(end, result.y);
    const double heat = snapshot.energy.value("air_heat"), now = snapshot.energy.rate("air_heat");
    double power = 0.0;
    for (const ElementSnapshot& ball : snapshot.elements)
      power += c * std::pow(std::hypot(ball.vx, ball.vr, ball.r * ball.theta_dot), 3);
    CHECK(now == Approx(power).epsilon(1e-12));
    // The balls only slow down: over 0.03 turns the power falls by a few percent.
    CHECK(heat > now * end);
    CHECK(heat < at_start * end);
    CHECK(now > 0.9 * at_start);
    const double residual =
        std::abs(snapshot.energy.residual()) / snapshot.energy.sum(LedgerKind::Start);
    if (previous > 0.0) {
      CHECK(residual < previous);
      // Drag that missed the ledger would show as a residual of its heat.
      CHECK(std::abs(snapshot.energy.residual()) < 0.01 * heat);
    }
    previous = residual;

    const auto items = results::energy_items(snapshot.energy);
    CHECK(std::any_of(items.begin(), items.end(), [&](const auto& item) {
      return item.first == "heat, air drag" && item.second == heat;
    }));
    CHECK(snapshot.power.total_loss > snapshot.energy.rate("air_heat"));
  }
  // Slower than without drag: the cage and the races pull the balls along.
  const RunResult free = run(plain, plain.initial_state(), end, 1e-7, "rkf4");
  const RunResult slowed = run(drag, drag.initial_state(), end, 1e-7, "rkf4");
  CHECK(drag.snapshot(end, slowed.y).elements[0].theta <
        plain.snapshot(end, free.y).elements[0].theta);
}

TEST_CASE("effect catalogue: each effect and each item of the ledger once", "[unit][dynamics]") {
  std::set<std::string_view> names, ids;
  for (const EffectCatalogEntry& line : effect_catalogue()) {
    CHECK(names.insert(line.name).second);
    CHECK_FALSE(line.help.empty());
    CHECK(line.make != nullptr);
  }
  for (const LedgerTerm* term : energy_terms()) {
    INFO(term->id);
    CHECK(ids.insert(term->id).second);
    CHECK_FALSE(term->label.empty());
    CHECK_FALSE(term->name[0].empty());
  }
  // A scene makes what its plan asks for and nothing else.
  const ScenePlan bare = plan_with({Effect::RaceContact});
  std::set<std::string_view> made;
  for (const EffectCatalogEntry& line : effect_catalogue())
    if (line.make(bare) != nullptr) made.insert(line.name);
  CHECK(made == std::set<std::string_view>{"balls", "races"});
}

TEST_CASE("ledger: residual is the signed sum of its items", "[unit][dynamics]") {
  using enum LedgerKind;
  constexpr LedgerTerm kIn{Work, "in", "", {"in"}, ""}, kOut{Heat, "out", "", {"out"}, ""},
      kStored{Stored, "stored", "", {"stored"}, ""}, kStart{Start, "start", "", {"start"}, ""},
      kJump{Switch, "jump", "", {"jump"}, ""}, kTaken{Taken, "taken", "", {"taken"}, ""},
      kNote{Note, "note", "", {"note"}, ""};
  EnergyLedger ledger;
  CHECK(ledger.residual() == 0.0);
  ledger.add(kStart, 100.0);
  ledger.add(kStored, 1.0);
  ledger.accumulate(kStored, 2.0);
  ledger.add(kIn, 1000.0);
  ledger.add(kOut, 10.0, 0, 5.0);
  ledger.add(kJump, 0.5);
  ledger.add(kTaken, 0.25);
  ledger.add(kNote, 1e9);
  CHECK(ledger.value("stored") == 3.0);
  CHECK(ledger.flow() == 1000.0 - 10.0 - 0.25 + 0.5);
  CHECK(ledger.residual() == ledger.flow() - (3.0 - 100.0));
  CHECK(ledger.heat_rate() == 5.0);
  CHECK(ledger.find("nothing") == nullptr);
  CHECK(ledger.value("nothing") == 0.0);
  CHECK(ledger.find("out")->name() == "heat, out");
}
