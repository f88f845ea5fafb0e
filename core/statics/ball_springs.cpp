#include "statics/ball_springs.hpp"

#include "statics/ball_race.hpp"

#include <algorithm>
#include <cmath>

namespace adore::statics {

RaceScales race_scales(const BallSprings& springs) { return race_scales(springs.model); }

double reference_stiffness(const BallSprings& springs, double load) {
  return reference_stiffness(springs.model, load);
}

bool update_race(const BallSprings& springs, const Vec5& q, RaceState<BallSpring>& state,
                 double /*accuracy*/) {
  const BallModel& m = springs.model;
  const contact::GrooveGeometry& groove = m.groove;
  const double soft = std::pow(m.hertz[0].reference().K, -2.0 / 3.0) +
                      std::pow(m.hertz[1].reference().K, -2.0 / 3.0);
  const double K = std::pow(soft, -1.5);
  const double R = groove.centre_radius[1];
  const double along = groove.centre_x[1] - groove.centre_x[0];
  const double across = R - groove.centre_radius[0];
  state.q = q;
  state.load.setZero();
  state.stiffness.setZero();
  state.largest_contact = 0.0;
  // Halves of split races: the pair that thrust along +x loads, and the other one. A spring has no
  // axial part beyond the plane where its balls would leave their halves.
  const double other =
      m.half[1][1].shift - m.half[1][0].shift - m.half[0][1].shift + m.half[0][0].shift;
  const double first = m.half[1][0].shift - m.half[0][0].shift;
  for (const auto& [s, c] : state.elements)
    for (int pair = 0; pair < (m.split ? 2 : 1); ++pair) {
      const double outer_shift =
          groove.centre_radius[0] * (m.outer_tilt[0] * c + m.outer_tilt[1] * s);
      double x = along + q(0) + R * (q(3) * c + q(4) * s) - outer_shift;
      if (m.split) x = pair == 0 ? std::max(x + first, 0.0) : std::min(x + first + other, 0.0);
      const double r = across + q(2) * c - q(1) * s;
      const double length = std::sqrt(x * x + r * r);
      const double approach = length - m.offset_sum();
      if (!(approach > 0.0)) {
        continue;
      }
      const double ux = x / length, ur = r / length;
      const Vec5 along_normal = (Vec5() << ux, -ur * s, ur * c, ux * R * c, ux * R * s).finished();
      const Vec5 along_tangent =
          (Vec5() << -ur, -ux * s, ux * c, -ur * R * c, -ur * R * s).finished();
      const double root = std::sqrt(approach);
      const double load = K * approach * root;
      state.load += load * along_normal;
      state.stiffness += 1.5 * K * root * along_normal * along_normal.transpose() +
                         load / length * along_tangent * along_tangent.transpose();
      state.largest_contact = std::max(state.largest_contact, load);
    }
  return true;
}

Vec5 guess_by_springs(const BallModel& model, const RaceLoadCase& task, const Vec5& q) {
  RaceState<BallSpring> state;
  state.q = q;
  for (const double azimuth : model.azimuth)
    state.elements.push_back({std::sin(azimuth), std::cos(azimuth)});
  const RaceSolveResult solve = solve_race(BallSprings{model}, task, state, 0.01);
  return solve.converged ? state.q : q;
}

}  // namespace adore::statics
