#include "base/rotation.hpp"
#include "deck/templates.hpp"
#include "dynamics/friction_start.hpp"
#include "integrators/stepper.hpp"
#include "runs/changed_equilibrium.hpp"
#include "runs/start_state.hpp"
#include "runs/system_ode.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Rollers start where friction leaves them.
using namespace adore;

namespace {

using Sets = std::vector<std::pair<std::string, std::string>>;

runs::Prepared prepared(const char* type, const Sets& sets,
                        const std::map<std::string, std::string>& options = {}) {
  runs::LoadedDeck input;
  input.path = runs::kStandardInput;
  input.deck = deck::new_deck(type);
  input.deck.set_all(sets);
  input.option_values = options;
  return runs::prepare(std::move(input));
}

dynamics::Slice slice(const dynamics::System& system, const std::string& name) {
  for (const auto& group : system.layout().groups())
    if (group.name == name) return group.slice;
  FAIL("no " << name);
  return {};
}

/// Of every roller: its axis against the plane through the bearing axis, positive about e_r [rad].
std::vector<double> skews(const dynamics::System& system, const std::vector<double>& y) {
  std::vector<double> out;
  const dynamics::Slice theta = slice(system, "element.theta");
  for (int i = 0; i < theta.count; ++i) {
    const auto at =
        static_cast<std::size_t>(slice(system, fmt::format("element{}.quaternion", i + 1)).first);
    const Vec3 axis =
        rotation_matrix(normalize_quaternion({y[at], y[at + 1], y[at + 2], y[at + 3]})) *
        Vec3::UnitX();
    const double angle = y[static_cast<std::size_t>(theta.first + i)];
    const Vec3 e_theta(0.0, -std::cos(angle), -std::sin(angle));
    out.push_back(-std::asin(axis.dot(e_theta)));
  }
  return out;
}

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

std::vector<double> moved(dynamics::System& system, std::vector<double> y, double seconds) {
  runs::SystemOde ode(system);
  integrators::StepControl control;
  control.initial = control.maximum = 0.5 * system.scales().time;
  control.minimum = 1e-12;
  control.tolerance = 1e-6;
  const auto stepper = integrators::make_stepper("rkf5");
  system.set_start(0.0, y);
  (void)system.between_steps(0.0, y);
  stepper->start(ode, 0.0, y, control);
  while (stepper->time() < seconds) stepper->step(seconds);
  const auto state = stepper->state();
  return {state.begin(), state.end()};
}

}  // namespace

TEST_CASE("friction start: tapered rollers start in the skew of their rib's friction",
          "[physics][runs][rollers]") {
  const runs::Prepared ready = prepared("tapered", {});
  dynamics::System system = runs::make_system(ready);
  const runs::StartState start = runs::start_state(ready, system);
  CHECK(start.remark.find("skewed by up to 1.7") != std::string::npos);
  const double turn = 2.0 * std::numbers::pi / ready.bearing.speed[1];

  const double at_start = mean(skews(system, start.y));
  const double later = mean(skews(system, moved(system, start.y, 0.03 * turn)));
  const double unbalanced = mean(skews(system, moved(system, system.initial_state(), 0.03 * turn)));
  INFO("mean skew " << at_start << ", after 0.03 turns " << later << ", from none " << unbalanced);
  CHECK(later == Approx(at_start).epsilon(0.01));
  // On the way: there after 0.18 turns.
  CHECK(unbalanced > 0.3 * at_start);
  CHECK(unbalanced < 0.9 * at_start);
}

TEST_CASE("friction start: reversed speed → opposite skew; no friction → none",
          "[physics][runs][rollers]") {
  const auto skew_of = [](const char* type, const Sets& sets) {
    const runs::Prepared ready = prepared(type, sets);
    dynamics::System system = runs::make_system(ready);
    return skews(system, runs::start_state(ready, system).y);
  };
  const std::vector<double> forth = skew_of("tapered", {}),
                            back = skew_of("tapered", {{"rpm2", "-3000"}});
  for (std::size_t i = 0; i < forth.size(); ++i) {
    CHECK(forth[i] > 1e-3);
    // Under gravity and a load along z, the mirror image of roller i stands at -θ.
    CHECK(back[(forth.size() - i) % forth.size()] == Approx(-forth[i]).epsilon(1e-5));
  }
  for (const double skew : skew_of("cylindrical", {})) CHECK(std::abs(skew) < 1e-12);
}

TEST_CASE("friction start: same balance in modes 0 and 1; not where elements are held",
          "[physics][runs][rollers][constrained]") {
  const auto start_of = [](const Sets& sets) {
    // Elements in balance have no damping at the races, free ones do.
    const runs::Prepared ready = prepared("spherical-tapered", sets, {{"contactDamping", "0"}});
    dynamics::System system = runs::make_system(ready);
    runs::StartState start = runs::start_state(ready, system);
    return std::pair{skews(system, start.y), start.remark};
  };
  const auto [free, remark] = start_of({});
  const auto [held, held_remark] = start_of({{"mode", "1"}});
  CHECK(mean(free) > 1e-3);
  for (std::size_t i = 0; i < free.size(); ++i) CHECK(held[i] == Approx(free[i]).epsilon(1e-5));
  const auto [suppressed, none] = start_of({{"kDOF", "4"}});
  CHECK(none.empty());
  for (const double skew : suppressed) CHECK(std::abs(skew) < 1e-14);
}

TEST_CASE("start: an element pressed into its races → excess energy is judged", "[physics][runs]") {
  for (const char* type : {"ball", "cylindrical"}) {
    INFO(type);
    const runs::Prepared ready = prepared(type, {});
    dynamics::System system = runs::make_system(ready);
    std::vector<double> y = runs::start_state(ready, system).y;
    system.set_start(0.0, y);
    CHECK_FALSE(runs::judge_start_energy(ready, system, y));
    double& r = y[static_cast<std::size_t>(slice(system, "element.r").first)];
    const double rest = r;
    r = rest + (ready.roller_scene ? 4e-6 : 1e-5);
    const std::optional<Finding> warned = runs::judge_start_energy(ready, system, y);
    REQUIRE(warned);
    CHECK(warned->code == "run.start_excess");
    CHECK(warned->severity == Severity::Warning);
    CHECK(warned->message.starts_with("start: excess energy"));
    CHECK(warned->measured.value_or(0.0) > warned->limit.value_or(1e9));
    r = rest + 1e-4;
    CHECK_THROWS_WITH(runs::judge_start_energy(ready, system, y),
                      Catch::Contains("start: excess energy"));
  }
}

TEST_CASE("equilibrium_change_finding(): jumps that the deck specifies → run continues",
          "[unit][runs]") {
  dynamics::EquilibriumChange change;
  change.moved = true;
  change.elastic = 1.0;
  change.excess = 0.05;
  CHECK_FALSE(runs::equilibrium_change_finding(change, "thermal step 2", {}));
  change.excess = 2.0;
  CHECK_THROWS_WITH(runs::equilibrium_change_finding(change, "thermal step 2", {}),
                    Catch::Contains("thermal step 2: excess energy = 2 J, 200 %"));
  const std::optional<Finding> specified =
      runs::equilibrium_change_finding(change, "thermal step 2", "routine ADRX1 specifies loads");
  REQUIRE(specified);
  CHECK(specified->measured == 200.0);
  CHECK_THAT(specified->message, Catch::Contains("200 %") && Catch::Contains("ADRX1") &&
                                     Catch::Contains("the run continues"));
}

TEST_CASE("balance_race(): step that increases the residual → undone", "[physics][runs]") {
  const runs::Prepared ready = prepared("ball", {{"mode", "2"}});
  dynamics::System system = runs::make_system(ready);
  std::vector<double> start = system.initial_state();
  // The friction of the balls moves the race's balance.
  (void)dynamics::balance_friction(system, start);
  const Mat3 stiffness = ready.start.stiffness.topLeftCorner<3, 3>();
  const std::array<bool, 3> free{true, true, true};
  std::vector<double> right = start, wrong = start;
  const double better = dynamics::balance_race(system, right, stiffness, free);
  CHECK((right != start));
  // Away from the balance: the first step makes it worse.
  const double left = dynamics::balance_race(system, wrong, -stiffness, free);
  CHECK((wrong == start));
  CHECK(left > 10.0 * better);
}

TEST_CASE("friction start: rollers without a balance of friction → start unchanged, with a remark",
          "[physics][runs][rollers]") {
  const runs::Prepared ready = prepared("spherical", {});
  dynamics::System system = runs::make_system(ready);
  const runs::StartState start = runs::start_state(ready, system);
  CHECK((start.y == system.initial_state()));
  CHECK(start.remark.find("15 of 15 rollers start without skew") != std::string::npos);
}
