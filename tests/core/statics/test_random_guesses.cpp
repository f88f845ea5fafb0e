#include "base/errors.hpp"
#include "core/statics/ball_bearings.hpp"
#include "core/statics/roller_bearings.hpp"
#include "core/statics/solution_checks.hpp"
#include "statics/ball_equilibrium.hpp"
#include "statics/ball_race.hpp"
#include "statics/ball_statics.hpp"
#include "statics/roller_statics.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <random>

/// A thousand first guesses of the race (and of the rollers) for each bearing lead to the
/// equilibrium of the cold start, or to those that its solution reports.
using namespace adore;
using namespace adore::statics;
using namespace solution_checks;
using ball_bearings::hold;
using ball_bearings::load;
using bearing::Bearing;

namespace {

constexpr int kGuesses = 1000;
constexpr double kLever = 0.03;   ///< rotations in meters [m/rad]
constexpr double kBeyond = 2e-2;  ///< out of the reach of every element [m]

/// The sequence of the engine is fixed by the standard; the mapping is ours.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  /// -1 to 1
  double uniform() { return static_cast<double>(engine_()) / 2147483648.0 - 1.0; }
  /// Any order of magnitude between a hundredth of a usual play and 0.3 mm (10 mrad), where all
  /// contacts are crushed or open.
  double size() { return std::pow(10.0, -5.25 + 1.75 * uniform()); }
  /// The same; each tenth beyond the reach of every element.
  double race_size() {
    const double usual = size();
    return ++drawn_ % 10 == 0 ? kBeyond : usual;
  }

 private:
  std::mt19937 engine_;
  int drawn_ = 0;
};

std::array<double, 5> random_displacement(const Bearing& bearing, Random& random) {
  std::array<double, 5> q = bearing.constraints.displacement;
  const double size = random.race_size();
  for (std::size_t k = 0; k < 5; ++k) {
    const double u = random.uniform();
    const double part = size == kBeyond ? std::copysign(1.0, u) : u;
    if (!bearing.constraints.displacement_given[k]) q[k] = part * size / (k < 3 ? 1.0 : kLever);
  }
  return q;
}

double distance(const std::array<double, 5>& a, const std::array<double, 5>& b) {
  double largest = 0.0;
  for (std::size_t k = 0; k < 5; ++k)
    largest = std::max(largest, std::abs(a[k] - b[k]) * (k < 3 ? 1.0 : kLever));
  return largest;
}

/// What the guesses led to.
struct Tally {
  explicit Tally(const RaceResult& cold) : known(cold.other_equilibria) {
    known.push_back(cold.displacement);
    met.assign(known.size(), 0);
  }
  /// Returns the number of the equilibrium.
  std::size_t add(const RaceResult& s) {
    std::size_t nearest = 0;
    for (std::size_t e = 1; e < known.size(); ++e)
      if (distance(s.displacement, known[e]) < distance(s.displacement, known[nearest]))
        nearest = e;
    ++met[nearest];
    worst = std::max(worst, distance(s.displacement, known[nearest]));
    if (noted(s, "no equilibrium was found from the first guess")) ++restarted;
    return nearest;
  }

  std::vector<std::array<double, 5>> known;
  std::vector<int> met;
  double worst = 0.0;
  int restarted = 0;
};

/// Of displacements of some 1e-5 m.
constexpr double kSame = 1e-11;

void check(const Tally& tally, const RaceResult& cold) {
  CAPTURE(tally.met, tally.restarted);
  CHECK(tally.worst < kSame);
  for (int times : tally.met) CHECK(times > 0);  // none is reported that nobody can find
  CHECK(noted(cold, "not stable") == (tally.known.size() > 1));
  // Nine of ten guesses are within reach and need no second start.
  CHECK(tally.restarted < kGuesses / 5);
}

/// Guesses of the race; where it is, solve_ball finds every ball (see the test of that below).
void thousand_ball_guesses(const Bearing& bearing, unsigned seed) {
  Random random(seed);
  const auto cold = solve_ball_statics(bearing);
  check_race(bearing, cold);
  Tally tally(cold);
  BallStaticsOptions warm;
  warm.warm_start = true;
  for (int n = 0; n < kGuesses; ++n) {
    Bearing guessed = bearing;
    guessed.constraints.displacement = random_displacement(bearing, random);
    tally.add(solve_ball_statics(guessed, warm));
  }
  check(tally, cold);
}

RollerSolution random_start(const Bearing& bearing, const RollerSolution& cold, Random& random) {
  RollerSolution start;
  start.displacement = random_displacement(bearing, random);
  const double size = random.size();
  for (const StaticRoller& roller : cold.rollers) {
    StaticRoller guess;
    guess.azimuth = roller.azimuth;
    guess.x = size * random.uniform();
    guess.r = 0.5 * bearing.rollers()->pitch_diameter + size * random.uniform();
    guess.tilt = -bearing.rollers()->axis_angle + size / kLever * random.uniform();
    start.rollers.push_back(guess);
  }
  return start;
}

/// Guesses of the race and of every roller's place and tilt.
void thousand_roller_guesses(const Bearing& bearing, unsigned seed,
                             RollerContact contact = RollerContact::Sliced) {
  Random random(seed);
  RollerOptions options;
  options.slices = 11;
  options.contact = contact;
  const auto cold = solve_roller_statics(bearing, options);
  check_race(bearing, cold);
  Tally tally(cold);
  double misplaced = 0.0;
  double other_load = 0.0;
  for (int n = 0; n < kGuesses; ++n) {
    const RollerSolution start = random_start(bearing, cold, random);
    RollerOptions warm = options;
    warm.start = &start;
    const auto s = solve_roller_statics(bearing, warm);
    if (tally.add(s) + 1 != tally.known.size()) continue;
    for (std::size_t k = 0; k < s.rollers.size(); ++k) {
      const StaticRoller& a = s.rollers[k];
      const StaticRoller& b = cold.rollers[k];
      misplaced = std::max({misplaced, std::abs(a.x - b.x), std::abs(a.r - b.r),
                            std::abs(a.tilt - b.tilt) * 0.25 * bearing.rollers()->length});
      for (std::size_t j = 0; j < 2; ++j)
        other_load = std::max(other_load, std::abs(a.race[j].load - b.race[j].load));
    }
  }
  check(tally, cold);
  CHECK(other_load < 1e-6 * cold.max_load);
  // Unloaded rollers too: the rule gives them one place, flat directions to a nanometre.
  CHECK(misplaced < 1e-9);
}

}  // namespace

TEST_CASE("a thousand first guesses: deep groove balls with clearance, free to tilt",
          "[physics][statics][hard][guesses][slow]") {
  Bearing bearing = ball_bearings::deep_groove(1.5e-5);
  thousand_ball_guesses(load(bearing, 0, 100, 300), 1);
}

TEST_CASE("a thousand first guesses: one loaded ball under a held race",
          "[physics][statics][hard][guesses][slow]") {
  Bearing bearing = ball_bearings::deep_groove(1.5e-5);
  hold(hold(hold(load(bearing, 0, 0, 5), 0, 0.0), 3, 0.0), 4, 0.0);
  thousand_ball_guesses(bearing, 2);
}

TEST_CASE("a thousand first guesses: angular contact balls at speed",
          "[physics][statics][hard][guesses][slow]") {
  Bearing bearing = ball_bearings::angular_contact_218(12000.0);
  thousand_ball_guesses(load(bearing, 5000, 0, 4000), 3);
}

TEST_CASE("a thousand first guesses: a spindle bearing at three million n d_m",
          "[physics][statics][hard][guesses][slow]") {
  Bearing bearing = ball_bearings::spindle(3e6 / 54);
  thousand_ball_guesses(load(bearing, 400, 0, 300), 4);
}

TEST_CASE("a thousand first guesses: all five loads, balls of least heat",
          "[physics][statics][hard][guesses][slow]") {
  Bearing bearing = ball_bearings::angular_contact_218(6000.0);
  bearing.spin_rule = bearing::SpinRule::MinimumHeat;
  thousand_ball_guesses(load(bearing, 3000, 1000, 3000, 20, 30), 5);
}

TEST_CASE("a thousand first guesses: a ball bearing with split races",
          "[physics][statics][hard][guesses][slow]") {
  Bearing bearing = ball_bearings::make(16, 0.0127, 0.07, 0.52, 0.52, 25.0, 0.0, 6000.0);
  bearing.balls().shim = {0.0, 1e-4};
  thousand_ball_guesses(load(bearing, 2000, 500, 1000), 6);
}

TEST_CASE("a ball comes back to its place from a thousand others",
          "[physics][statics][hard][guesses]") {
  Bearing bearing = ball_bearings::angular_contact_218(12000.0);
  load(bearing, 5000, 0, 4000);
  const auto cold = solve_ball_statics(bearing);
  const BallModel model = make_ball_model(bearing, {});
  const auto pose = inner_race_pose<double>(model, cold.displacement);
  Random random(7);
  double worst = 0.0;
  int failed = 0;
  for (int n = 0; n < kGuesses; ++n) {
    const std::size_t k = static_cast<std::size_t>(n) % cold.balls.size();
    BallState ball;
    ball.site.sin = std::sin(model.azimuth[k]);
    ball.site.cos = std::cos(model.azimuth[k]);
    ball.site.law = first_spin_law(bearing, {});
    ball.known = true;
    // Within the grooves; a millimeter beyond, the model's orbital speed runs away.
    const double size = random.size();
    ball.x = cold.balls[k].x + size * random.uniform();
    ball.rho = cold.balls[k].r - 0.5 * bearing.balls().pitch_diameter + size * random.uniform();
    failed += solve_ball(model, pose, ball) ? 0 : 1;
    worst = std::max({worst, std::abs(ball.x - cold.balls[k].x),
                      std::abs(ball.rho + 0.5 * bearing.balls().pitch_diameter - cold.balls[k].r)});
  }
  CHECK(failed == 0);
  CHECK(worst < kSame);
}

TEST_CASE("a thousand first guesses: cylindrical rollers with clearance, free to tilt",
          "[physics][statics][rollers][hard][guesses][slow]") {
  Bearing bearing = roller_bearings::unloaded(roller_bearings::cylindrical(3000.0));
  thousand_roller_guesses(load(bearing, 0, 300, 4000), 11);
}

TEST_CASE("a thousand first guesses: one loaded cylindrical roller at rest",
          "[physics][statics][rollers][hard][guesses][slow]") {
  Bearing bearing = roller_bearings::unloaded(roller_bearings::cylindrical(0.0));
  hold(hold(load(bearing, 0, 0, 20), 3, 0.0), 4, 0.0);
  thousand_roller_guesses(bearing, 12);
}

TEST_CASE("a thousand first guesses: tapered rollers",
          "[physics][statics][rollers][hard][guesses][slow]") {
  Bearing bearing = roller_bearings::unloaded(roller_bearings::tapered(2000.0));
  thousand_roller_guesses(load(bearing, 4000, 0, 3000), 13);
}

TEST_CASE("a thousand first guesses: barrels in slices",
          "[physics][statics][rollers][hard][guesses][slow]") {
  Bearing bearing = roller_bearings::unloaded(roller_bearings::spherical(2000.0));
  hold(hold(load(bearing, 2000, 0, 6000), 3, 0.0), 4, 0.0);
  thousand_roller_guesses(bearing, 14);
}

TEST_CASE("a thousand first guesses: barrels as points in grooves of factor 0.5005",
          "[physics][statics][rollers][hard][guesses][slow]") {
  Bearing bearing = roller_bearings::unloaded(roller_bearings::spherical(0.0));
  bearing.rollers()->groove_factor = {0.5005, 0.5005};
  hold(hold(load(bearing, 2000, 0, 6000), 3, 0.0), 4, 0.0);
  thousand_roller_guesses(bearing, 15, RollerContact::Point);
}

TEST_CASE("a thousand first guesses: spherical tapered rollers",
          "[physics][statics][rollers][hard][guesses][slow]") {
  Bearing bearing = roller_bearings::unloaded(roller_bearings::spherical_tapered(2000.0));
  // Tilts held: barrels let the race swivel.
  hold(hold(load(bearing, 4000, 0, 3000), 3, 0.0), 4, 0.0);
  thousand_roller_guesses(bearing, 16);
}
