#include "../core/dynamics/roller_scene.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <vector>

/// Right-hand sides of one bearing, for `page`, which counts the instructions of counted_rhs():
///   rhs_cost ball BALLS TIMES
///   rhs_cost cylindrical ROLLERS SLICES TIMES
/// The pitch circle grows with the number of elements, so that their pockets stay apart.
namespace {

using namespace adore;

/// Evaluates the start state `times` times.
[[gnu::noinline]] void counted_rhs(dynamics::System& system, const std::vector<double>& y,
                                   std::vector<double>& dydt, int times) {
  for (int i = 0; i < times; ++i) system.rhs(0.0, y.data(), dydt.data());
}

void run(dynamics::System& system, int times) {
  const std::vector<double> y = system.initial_state();
  std::vector<double> dydt(y.size());
  counted_rhs(system, y, dydt, times);
}

/// Pitch diameter of `count` elements of diameter D [m].
double pitch_of(int count, double D) { return std::max(4.0 * D, 0.41 * D * count); }

}  // namespace

int main(int count, char** words) {
  const std::string_view kind = count > 1 ? words[1] : "";
  const auto number = [&](int i) { return std::atoi(words[i]); };
  if (kind == "ball" && count == 4) {
    dynamics::System system = fixture::make_system(
        fixture::angular_contact(number(2), pitch_of(number(2), 0.0127)), fixture::full_plan());
    run(system, number(3));
  } else if (kind == "cylindrical" && count == 5) {
    bearing::Bearing b = roller_bearings::cylindrical(6000.0);
    b.rollers()->count = number(2);
    b.rollers()->pitch_diameter = pitch_of(number(2), b.element_diameter());
    roller_scene::add_cage(b);
    roller_scene::add_friction(b);
    roller_scene::Scene scene = roller_scene::scene_of(b, roller_scene::with_friction(), number(3));
    run(scene.system, number(4));
  } else {
    std::puts("usage: rhs_cost ball BALLS TIMES | rhs_cost cylindrical ROLLERS SLICES TIMES");
    return 2;
  }
}
