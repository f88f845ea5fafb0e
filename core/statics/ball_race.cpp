#include "statics/ball_race.hpp"

#include <algorithm>
#include <cmath>

namespace adore::statics {

RaceScales race_scales(const BallModel& m) {
  return {m.groove.centre_radius[1], 0.25 * m.offset_sum(),
          0.5 * m.balls.diameter + 4.0 * m.offset_sum(), m.balls.pitch_diameter,
          m.base_centrifugal};
}

double reference_stiffness(const BallModel& m, double load) {
  const double K = std::max(m.hertz[0].reference().K, m.hertz[1].reference().K);
  return 1.5 * std::cbrt(K * K * load);
}

bool is_conservative(const BallModel& m) {
  return m.own_speed_share == 0.0 ||
         (!m.moving && (!m.hertz[0].varying() || m.hertz[0].law().follows));
}

bool update_race(const BallModel& model, const Vec5& q, BallRace& state, double accuracy) {
  std::array<double, 5> displacement{};
  std::array<RaceDual, 5> variable;
  for (std::size_t k = 0; k < 5; ++k) {
    displacement[k] = q(static_cast<Eigen::Index>(k));
    variable[k] = RaceDual::variable(displacement[k], static_cast<int>(k) + 2);
  }
  const auto pose = inner_race_pose<double>(model, displacement);
  const auto pose_with_derivatives = inner_race_pose<RaceDual>(model, variable);
  const Vec5 change = q - state.q;
  state.load.setZero();
  state.stiffness.setZero();
  state.largest_contact = 0.0;
  for (BallState& ball : state.elements) {
    if (ball.known) {
      const Eigen::Vector2d shift = ball.follow * change;
      if (shift.norm() < 0.25 * model.offset_sum()) {
        ball.x += shift(0);
        ball.rho += shift(1);
      }
    }
    if (!solve_ball(model, pose, ball, accuracy)) {
      return false;
    }
    const BallLoadContribution share =
        ball_share(model, pose_with_derivatives, ball, accuracy > 0.0);
    state.load += share.load;
    state.stiffness += share.stiffness;
    state.largest_contact = std::max(state.largest_contact, share.largest_load);
  }
  state.q = q;
  return true;
}

Vec5 first_guess(const BallModel& m, const RaceLoadCase& task, const Vec5& given) {
  Vec5 q = given;
  const double S = m.offset_sum();
  const double across =
      m.groove.centre_radius[1] - m.groove.centre_radius[0];  // of the groove centres, unloaded
  const auto of_half = [&](std::size_t h) {
    return m.groove.centre_x[1] + m.half[1][h].shift - m.groove.centre_x[0] - m.half[0][h].shift;
  };
  const bool backward = !task.given[0] && task.load(0) < 0.0;
  const bool centred = task.given[0] || task.load(0) == 0.0;
  const double along = centred ? 0.5 * (of_half(0) + of_half(1)) : of_half(backward ? 1 : 0);
  const double soft = std::pow(m.hertz[0].reference().K, -2.0 / 3.0) +
                      std::pow(m.hertz[1].reference().K, -2.0 / 3.0);
  const auto closure = [&](double load) { return soft * std::cbrt(load * load); };
  const auto count = static_cast<double>(m.azimuth.size());
  const auto is_free = [&](int k) {
    return !task.given[static_cast<std::size_t>(k)] && given(k) == 0.0;
  };

  const double radial_load =
      std::hypot(task.given[1] ? 0.0 : task.load(1), task.given[2] ? 0.0 : task.load(2));
  const bool radial = radial_load > 0.0 || given(1) != 0.0 || given(2) != 0.0;
  const double thrust = task.given[0] ? 0.0 : task.load(0);
  double depth = along + given(0);
  if (is_free(0)) {
    if (thrust != 0.0) {
      // |A| = S + δ with A_r unchanged, and Q sin α = thrust/Z.
      double sine = 0.3;
      for (int pass = 0; pass < 8; ++pass) {
        const double length = S + closure(std::abs(thrust) / (count * sine));
        sine = std::sqrt(std::max(1e-4, 1.0 - (across / length) * (across / length)));
        depth = std::copysign(length * sine, thrust);
      }
      q(0) = depth - along;
    } else if (radial) {
      depth = 0.0;
      q(0) = -along;
    }
  }
  if (radial_load > 0.0 && is_free(1) && is_free(2)) {
    const double length = S + closure(5.0 * radial_load / count);
    const double shift = std::sqrt(std::max(0.0, length * length - depth * depth)) - across;
    if (shift > 0.0) {
      q(1) = shift * task.load(1) / radial_load;
      q(2) = shift * task.load(2) / radial_load;
    }
  } else if (radial_load > 0.0) {
    for (int k = 1; k < 3; ++k) {
      if (is_free(k) && !task.given[static_cast<std::size_t>(k)]) {
        const double length = S + closure(5.0 * std::abs(task.load(k)) / count);
        const double shift = std::sqrt(std::max(0.0, length * length - depth * depth)) - across;
        if (shift > 0.0 && task.load(k) != 0.0) {
          q(k) = std::copysign(shift, task.load(k));
        }
      }
    }
  }
  return q;
}

}  // namespace adore::statics
