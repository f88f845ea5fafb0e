#include "roller_scene.hpp"
#include "statics/roller_model.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

using namespace adore;
using roller_scene::Scene;
using roller_scene::scene_of;

namespace {

/// A race of inertia J that a moment M tilts by θ, on n cylinders of mass m, and inertia I across
/// their axes, whose loads are Q. They move along their axes by c_i X and skew by c_i Φ, c_i the
/// cosine of the azimuth from where the tilt lifts them, Σ c_i² = n/2:
///   m X'' = Q θ,   I Φ'' = -a θ,   J θ'' = M - K θ + (n/2) (Q X - a Φ).
struct TiltOnCylinders {
  double J, K, m, I, Q, a, n, M;
  using State = std::array<double, 6>;  ///< θ, X, Φ and their rates
  [[nodiscard]] State slope(const State& y) const {
    return {y[3],         y[4],         y[5], (M - K * y[0] + 0.5 * n * (Q * y[1] - a * y[2])) / J,
            Q * y[0] / m, -a * y[0] / I};
  }
  [[nodiscard]] double tilt(double t) const {
    constexpr int kSteps = 20'000;
    State y{};
    const double h = t / kSteps;
    const auto beyond = [&](const State& k, double share) {
      State out = y;
      for (std::size_t i = 0; i < y.size(); ++i) out[i] += share * h * k[i];
      return out;
    };
    for (int step = 0; step < kSteps; ++step) {
      const State k1 = slope(y), k2 = slope(beyond(k1, 0.5)), k3 = slope(beyond(k2, 0.5)),
                  k4 = slope(beyond(k3, 1.0));
      for (std::size_t i = 0; i < y.size(); ++i)
        y[i] += h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
    }
    return y[0];
  }
};

}  // namespace

/// A race that tilts pushes each cylinder out of the wedge along its axis, by its load times the
/// tilt, and nothing holds it there; the load goes with it and tilts the race further: of p in
/// e^(pt), (m p²)(J p² + K) = Q² n/2 has a positive root [derived]. Skew does the same, weakly: a
/// slice at s stands s φ beside the plane of the bearing axis, (s φ)²/2r further out, r its
/// distance from that axis, and presses so much deeper into the outer race and less into the inner
/// one. Their energies have the second derivatives +a and -a over the skew, a = Σ Q_k s_k²/r
/// [derived]. So without friction and flanges a race does not swing on cylinders.
TEST_CASE("rollers: a race that tilts on cylinders without friction or flanges drives them out",
          "[physics][rollers][races][limits]") {
  bearing::Bearing b = roller_bearings::cylindrical(0.0, -2e-5);
  b.rollers()->flange = {};
  b.constraints.displacement_given.fill(true);
  b.constraints.load = {};
  statics::RollerOptions options;
  options.slices = 9;
  const double transverse = 0.1, h = 3e-7, size = 2.0 * h;
  b.race_inertia[1] = {40.0, {0.05, transverse, transverse}};
  const auto load_at = [&](double tilt) {
    bearing::Bearing moved = b;
    moved.constraints.displacement[3] += tilt;
    return statics::solve_roller_statics(moved, options).load[3];
  };
  const double K = (load_at(h) - load_at(-h)) / (2.0 * h);

  const statics::RollerSolution rest = statics::solve_roller_statics(b, options);
  const statics::RollerModel model = statics::make_roller_model(b, options);
  const auto& slices = model.slices(1, model.body(0)).slices;
  const std::vector<double>& loads = rest.rollers.front().race[1].slice_load;
  REQUIRE(loads.size() == slices.size());
  double a = 0.0;
  for (std::size_t k = 0; k < loads.size(); ++k)
    a += loads[k] * slices[k].s * slices[k].s / (0.5 * model.rollers.pitch_diameter);
  const TiltOnCylinders linear{transverse,
                               K,
                               b.element_inertia.mass,
                               b.element_inertia.moments[1],
                               rest.rollers.front().race[1].load,
                               a,
                               static_cast<double>(b.element_count()),
                               K * size};

  scene::ScenePlan plan = roller_scene::races_only();
  bearing::FreeRace& free = plan.race_motions.free[1].emplace();
  plan.effects.push_back({scene::Effect::FreeRaces, "", true, "test"});
  free.translation_held.fill(true);
  free.rotation_held = {true, false, true};
  free.moment[1] = K * size;
  Scene s = scene_of(b, plan, 9);
  const double period = 2.0 * std::numbers::pi * std::sqrt(transverse / K);
  for (const double turns : {0.25, 0.5, 1.0}) {
    const double t = turns * period;
    const auto run = fixture::run(s.system, s.system.initial_state(), t, 1e-9, "rkf7");
    const Vec3 tip = rotation_matrix(adore::normalize_quaternion(
                                         s.system.snapshot(t, run.y).races[1].orientation))
                         .col(0);
    INFO(turns << " periods of " << period << " s");
    CHECK(-tip[2] / size == Approx(linear.tilt(t) / size).epsilon(0.04));
    // One that swings would be back.
    if (turns == 1.0) CHECK(std::abs(tip[2]) / size > 10.0);
  }
}
