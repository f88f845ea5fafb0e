#pragma once

#include <cmath>
#include <limits>
#include <random>
#include <vector>

/// A path back and forth with very many points.
namespace adore::test {

struct Way {
  std::vector<double> x, y;
  void add(double across, double up) {
    x.push_back(across);
    y.push_back(up);
  }
};

/// Turns that precess by a golden angle, with an excursion in the middle, a gap and strokes that
/// cross the picture from far outside.
inline Way many_turns(int turns, double noise) {
  std::mt19937 random(3);
  std::normal_distribution<double> some(0.0, 1.0);
  Way way;
  for (int i = 0; i < 400 * turns; ++i) {
    const double a = 2.0 * 3.14159265358979 * i / 400.0;
    const double r = 120.0 + 25.0 * std::sin(0.381966 * a) + noise * some(random);
    way.add(200.0 + r * std::cos(a), 200.0 + r * std::sin(a));
  }
  const std::size_t middle = way.x.size() / 2;
  way.x[middle] = 390.0, way.y[middle] = 12.0;
  way.x[middle + 7] = std::numeric_limits<double>::quiet_NaN();
  way.x[middle + 50] = -1e7, way.y[middle + 50] = 5e6;
  return way;
}

}  // namespace adore::test
