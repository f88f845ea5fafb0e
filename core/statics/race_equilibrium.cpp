#include "statics/race_equilibrium.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace adore::statics {
namespace {

/// Rotations count as the displacement of the groove-centre circle, moments as forces on it.
double lever(const BallModel& m, Eigen::Index k) { return k < 3 ? 1.0 : m.groove.centre_radius[1]; }

bool is_given(const RaceTask& task, Eigen::Index k) {
  return task.given[static_cast<std::size_t>(k)];
}

/// Zero where the displacement is given.
Vec5 scaled_residual(const BallModel& m, const RaceTask& task, const RaceState& s) {
  Vec5 r = Vec5::Zero();
  for (Eigen::Index k = 0; k < 5; ++k) {
    if (!is_given(task, k)) {
      r(k) = (task.load(k) - s.load(k)) / lever(m, k);
    }
  }
  return r;
}

/// Given directions become decoupled springs of the reference stiffness, which their zero residual
/// never moves.
Mat5 scaled_stiffness(const BallModel& m, const RaceTask& task, const RaceState& s, double k_ref) {
  Mat5 K = Mat5::Zero();
  for (Eigen::Index i = 0; i < 5; ++i) {
    for (Eigen::Index j = 0; j < 5; ++j) {
      if (is_given(task, i) || is_given(task, j)) {
        K(i, j) = i == j ? k_ref : 0.0;
      } else {
        K(i, j) = s.stiffness(i, j) / (lever(m, i) * lever(m, j));
      }
    }
  }
  return K;
}

/// Stiffness of one contact under the load scale: the measure of "no stiffness".
double reference_stiffness(const BallModel& m, double load) {
  const double K = std::max(m.hertz[0].reference().K, m.hertz[1].reference().K);
  return 1.5 * std::cbrt(K * K * load);
}

struct Step {
  Vec5 direction = Vec5::Zero();
  std::vector<int> held;  ///< directions that dominate unloaded modes without stiffness
};

/// Newton step, or its replacement where the stiffness is singular.
Step newton_step(const Mat5& K, const Vec5& r, double k_ref, double force, double longest) {
  Step step;
  const Eigen::PartialPivLU<Mat5> lu(K);
  if (lu.matrixLU().diagonal().cwiseAbs().minCoeff() > 1e-7 * k_ref) {
    step.direction = lu.solve(r);
    return step;
  }
  const Eigen::SelfAdjointEigenSolver<Mat5> eigen(0.5 * (K + K.transpose()));
  Vec5 unresisted = Vec5::Zero();
  for (Eigen::Index k = 0; k < 5; ++k) {
    const double stiffness = std::abs(eigen.eigenvalues()(k));
    const Vec5 mode = eigen.eigenvectors().col(k);
    const double load = mode.dot(r);
    if (stiffness > 1e-9 * k_ref) {
      step.direction += mode * (load / stiffness);
    } else if (std::abs(load) > 1e-9 * force) {
      unresisted += mode * load;
    } else {
      Eigen::Index largest = 0;
      mode.cwiseAbs().maxCoeff(&largest);
      step.held.push_back(static_cast<int>(largest));
    }
  }
  if (unresisted.squaredNorm() > 0.0) {
    step.direction += unresisted * (longest / unresisted.norm());
  }
  return step;
}

Vec5 moved(const BallModel& m, const Vec5& q, const Vec5& direction, double t) {
  Vec5 next = q;
  for (Eigen::Index k = 0; k < 5; ++k) {
    next(k) += t * direction(k) / lever(m, k);
  }
  return next;
}

bool out_of_reach(const BallModel& m, const Vec5& q) {
  double largest = 0.0;
  for (Eigen::Index k = 0; k < 5; ++k) {
    largest = std::max(largest, std::abs(q(k)) * lever(m, k));
  }
  return !(largest < 0.5 * m.balls.diameter + 4.0 * m.offset_sum());
}

}  // namespace

bool update_race(const BallModel& model, const Vec5& q, RaceState& state) {
  std::array<double, 5> displacement{};
  std::array<RaceDual, 5> variable;
  for (std::size_t k = 0; k < 5; ++k) {
    displacement[k] = q(static_cast<Eigen::Index>(k));
    variable[k] = RaceDual::variable(displacement[k], static_cast<int>(k) + 2);
  }
  const auto pose = inner_pose<double>(model, displacement);
  const auto pose_with_derivatives = inner_pose<RaceDual>(model, variable);
  const Vec5 change = q - state.q;
  state.load.setZero();
  state.stiffness.setZero();
  state.largest_contact = 0.0;
  for (BallState& ball : state.balls) {
    if (ball.known) {
      const Eigen::Vector2d shift = ball.follow * change;
      if (shift.norm() < 0.25 * model.offset_sum()) {
        ball.x += shift(0);
        ball.rho += shift(1);
      }
    }
    if (!solve_ball(model, pose, ball)) {
      return false;
    }
    const BallShare share = ball_share(model, pose_with_derivatives, ball);
    state.load += share.load;
    state.stiffness += share.stiffness;
    state.largest_contact = std::max(state.largest_contact, share.largest_load);
  }
  state.q = q;
  return true;
}

double force_scale(const BallModel& model, const RaceTask& task, const RaceState& state) {
  double scale = 0.0;
  for (Eigen::Index k = 0; k < 5; ++k) {
    if (!task.given[static_cast<std::size_t>(k)]) {
      scale = std::max(scale, std::abs(task.load(k)) / lever(model, k));
    }
  }
  return scale > 0.0 ? scale : std::max(state.largest_contact, model.base_centrifugal);
}

namespace {

enum class Search : unsigned char { Accepted, NoProgress, BallFailed, RanAway };

/// Line search for a convex potential: the load along the step must fall to between 90 % and -50 %
/// of its first value. Overshoot brackets the minimum from above, undershoot after an overshoot
/// from below.
Search descend(const BallModel& m, const RaceTask& task, const RaceState& state, const Vec5& r,
               const Vec5& direction, RaceState& trial) {
  const double first = direction.dot(r);
  double low = 0.0;
  double high = 0.0;  // 0: no overshoot yet
  double t = 1.0;
  Search outcome = Search::NoProgress;
  for (int attempt = 0; attempt < 60; ++attempt) {
    const Vec5 q = moved(m, state.q, direction, t);
    if (out_of_reach(m, q)) {
      return Search::RanAway;
    }
    trial = state;
    if (!update_race(m, q, trial)) {
      outcome = Search::BallFailed;
      high = t;
      t = 0.5 * (low + high);
      continue;
    }
    const double slope = direction.dot(scaled_residual(m, task, trial));
    const bool bracket_closed = high > 0.0 && high - low <= 1e-15 * high;
    if (slope < -0.5 * first && first > 0.0 && !bracket_closed) {
      high = t;
      t = low + (high - low) * std::clamp(first / (first - slope), 0.05, 0.5);
    } else if (slope > 0.9 * first && high > 0.0 && !bracket_closed) {
      low = t;
      t = 0.5 * (low + high);
    } else {
      return Search::Accepted;
    }
  }
  return outcome;
}

/// Line search without a potential: halve the step until the residual is smaller.
Search reduce(const BallModel& m, const RaceTask& task, const RaceState& state, const Vec5& r,
              const Vec5& direction, RaceState& trial) {
  Search outcome = Search::NoProgress;
  double t = 1.0;
  for (int attempt = 0; attempt < 14; ++attempt, t *= 0.5) {
    const Vec5 q = moved(m, state.q, direction, t);
    if (out_of_reach(m, q)) {
      outcome = Search::RanAway;
      continue;
    }
    trial = state;
    if (!update_race(m, q, trial)) {
      outcome = Search::BallFailed;
      continue;
    }
    if (scaled_residual(m, task, trial).norm() <= (1.0 - 1e-4 * t) * r.norm()) {
      return Search::Accepted;
    }
    outcome = Search::NoProgress;
  }
  return outcome;
}

}  // namespace

RaceSolve solve_race(const BallModel& model, const RaceTask& task, RaceState& state,
                     double target) {
  RaceSolve result;
  if (!update_race(model, state.q, state)) {
    result.ball_failed = true;
    return result;
  }
  if (std::all_of(task.given.begin(), task.given.end(), [](bool given) { return given; })) {
    result.converged = true;
    return result;
  }
  const bool conservative =
      model.own_speed_share == 0.0 || (!model.moving && !model.hertz[0].varying());
  const double longest = 0.25 * model.offset_sum();
  constexpr int kIterations = 80;
  double previous_size = -1.0;
  for (int n = 0; n <= kIterations; ++n) {
    const Vec5 r = scaled_residual(model, task, state);
    const double force = std::max(force_scale(model, task, state), 1e-300);
    const double floor = std::max(force, state.largest_contact);
    result.iterations = n;
    result.residual = r.cwiseAbs().maxCoeff() / floor;
    const double k_ref = reference_stiffness(model, floor);
    const Mat5 K = scaled_stiffness(model, task, state, k_ref);
    Step step = newton_step(K, r, k_ref, force, longest);
    // What the rounding of positions of the size of the bearing does to the forces.
    const double noise =
        2e-16 * model.balls.pitch_diameter * K.diagonal().cwiseAbs().maxCoeff() / floor;
    const bool small = result.residual <= std::max(target, noise);
    const bool stalled =
        result.residual <= 1e-10 && previous_size >= 0.0 && r.norm() >= 0.25 * previous_size;
    if (small || stalled) {
      result.converged = true;
      result.held = step.held;
      return result;
    }
    if (n == kIterations || !step.direction.allFinite()) {
      return result;
    }
    previous_size = r.norm();
    const double size = step.direction.cwiseAbs().maxCoeff();
    if (size > longest) {
      step.direction *= longest / size;
    }

    RaceState trial;
    const Search search = conservative ? descend(model, task, state, r, step.direction, trial)
                                       : reduce(model, task, state, r, step.direction, trial);
    if (search != Search::Accepted) {
      result.ran_away = search == Search::RanAway;
      result.ball_failed = search == Search::BallFailed;
      result.converged = result.residual <= 1e-9;
      return result;
    }
    state = std::move(trial);
  }
  return result;
}

Vec5 first_guess(const BallModel& m, const RaceTask& task, const Vec5& given) {
  Vec5 q = given;
  const double S = m.offset_sum();
  const double across =
      m.groove.centre_radius[1] - m.groove.centre_radius[0];  // of the groove centres, unloaded
  const double along = m.groove.centre_x[1] - m.groove.centre_x[0];
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
