#include "statics/coupled_balls.hpp"

#include "statics/ball_forces.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace adore::statics {
namespace {

using Index = Eigen::Index;

/// Contacts of a ball minus those at which its tractions are given.
template <class S>
std::array<S, 5> moved_places(const LinearizedTractions& given, const BallForces<S>& f,
                              const S& rho) {
  std::array<S, 5> out;
  for (std::size_t j = 0; j < 2; ++j) {
    const auto& alpha = f.contact[j].alpha;
    out[j] = f.contact[j].load - given.at.load[j];
    out[2 + j] = given.at.cos[j] * alpha.sin - given.at.sin[j] * alpha.cos;
  }
  out[4] = rho - given.at.rho;
  return out;
}

/// Values of the tractions of ball k by the contacts of the others. @return change of tractions [N]
double follow_others(const CoupledBalls& set, BallRace& state) {
  const std::size_t n = state.elements.size();
  Eigen::VectorXd ds = Eigen::VectorXd::Zero(5 * static_cast<Index>(n));
  const std::array<double, 5> q{state.q(0), state.q(1), state.q(2), state.q(3), state.q(4)};
  for (std::size_t k = 0; k < n; ++k) {
    const BallState& ball = state.elements[k];
    if (!set.coupled[k] || ball.idle) continue;
    const auto races =
        races_in_azimuth_frame(*set.model, ball.site, inner_race_pose<double>(*set.model, q));
    const auto f = ball_forces<double>(*set.model, ball.site, ball.x, ball.rho, races);
    const auto moved = moved_places(set.start[k], f, ball.rho);
    for (std::size_t p = 0; p < 5; ++p) ds[static_cast<Index>(5 * k + p)] = moved[p];
  }
  double change = 0.0;
  for (std::size_t k = 0; k < n; ++k) {
    if (!set.coupled[k]) continue;
    const auto i = static_cast<Index>(k);
    const Eigen::Vector3d by_others =
        set.T.middleRows<3>(3 * i) * ds - set.T.block<3, 5>(3 * i, 5 * i) * ds.segment<5>(5 * i);
    LinearizedTractions& now = *state.elements[k].site.tractions;
    for (std::size_t j = 0; j < 2; ++j) {
      const double value = set.start[k].along[j].value + by_others[static_cast<Index>(j)];
      change = std::max(change, std::abs(value - now.along[j].value));
      now.along[j].value = value;
    }
    now.orbital.value = set.start[k].orbital.value + by_others[2];
  }
  return change;
}

/// Stiffness with all blocks of T.
Mat5 coupled_stiffness(const CoupledBalls& set, const BallRace& state) {
  const BallModel& m = *set.model;
  const auto n = static_cast<Index>(state.elements.size());
  std::array<RaceDual, 5> variable;
  for (std::size_t k = 0; k < 5; ++k)
    variable[k] = RaceDual::variable(state.q(static_cast<Index>(k)), static_cast<int>(k) + 2);
  const auto pose = inner_race_pose<RaceDual>(m, variable);
  Eigen::MatrixXd on_ball = Eigen::MatrixXd::Identity(2 * n, 2 * n), by_q(2 * n, 5);
  Eigen::MatrixXd load_y = Eigen::MatrixXd::Zero(5, 2 * n),
                  load_t = Eigen::MatrixXd::Zero(5, 3 * n),
                  force_t = Eigen::MatrixXd::Zero(2 * n, 3 * n),
                  places_y = Eigen::MatrixXd::Zero(5 * n, 2 * n),
                  places_q = Eigen::MatrixXd::Zero(5 * n, 5);
  by_q.setZero();
  Eigen::MatrixXd T = Eigen::MatrixXd::Zero(3 * n, 5 * n);
  Mat5 direct = Mat5::Zero();
  for (Index i = 0; i < n; ++i) {
    const BallState& ball = state.elements[static_cast<std::size_t>(i)];
    if (ball.idle) continue;
    const RaceDual x = RaceDual::variable(ball.x, 0), rho = RaceDual::variable(ball.rho, 1);
    const auto races = races_in_azimuth_frame(m, ball.site, pose);
    const auto f = ball_forces<RaceDual>(m, ball.site, x, rho, races);
    const auto row = [&](const RaceDual& of, auto&& y, auto&& by) {
      for (Index c = 0; c < 2; ++c) y(c) = of.d[static_cast<std::size_t>(c)];
      for (Index c = 0; c < 5; ++c) by(c) = of.d[static_cast<std::size_t>(c) + 2];
    };
    row(f.axial, on_ball.block<1, 2>(2 * i, 2 * i), by_q.row(2 * i));
    row(f.radial, on_ball.block<1, 2>(2 * i + 1, 2 * i), by_q.row(2 * i + 1));
    for (Index k = 0; k < 5; ++k) {
      Eigen::Matrix<double, 1, 5> by;
      row(f.race[static_cast<std::size_t>(k)], load_y.block<1, 2>(k, 2 * i), by);
      direct.row(k) += by;
    }
    if (!set.coupled[static_cast<std::size_t>(i)]) continue;
    const auto moved = moved_places(set.start[static_cast<std::size_t>(i)], f, rho);
    for (Index p = 0; p < 5; ++p)
      row(moved[static_cast<std::size_t>(p)], places_y.block<1, 2>(5 * i + p, 2 * i),
          places_q.row(5 * i + p));
    T.middleRows<3>(3 * i) = set.T.middleRows<3>(3 * i);
    T.block<3, 5>(3 * i, 5 * i).setZero();  // in f
    // Forces over given values: linear in tractions, of second order in the orbit.
    const std::array<double, 5> q{state.q(0), state.q(1), state.q(2), state.q(3), state.q(4)};
    const auto here = races_in_azimuth_frame(m, ball.site, inner_race_pose<double>(m, q));
    for (Index t = 0; t < 3; ++t) {
      std::array<BallForces<double>, 2> at;
      const double step = t < 2 ? 1e-3 * std::max(value_of(f.contact[0].load), 1e-9)
                                : 1e-3 * std::max(std::abs(value_of(f.orbital)), 1e-9);
      for (const std::size_t side : {0UL, 1UL}) {
        BallSite site = ball.site;
        LinearizedTractions::Value& value =
            t < 2 ? site.tractions->along[static_cast<std::size_t>(t)] : site.tractions->orbital;
        value.value += side == 1 ? step : -step;
        at[side] = ball_forces<double>(m, site, ball.x, ball.rho, here);
      }
      force_t(2 * i, 3 * i + t) = (at[1].axial - at[0].axial) / (2.0 * step);
      force_t(2 * i + 1, 3 * i + t) = (at[1].radial - at[0].radial) / (2.0 * step);
      for (Index k = 0; k < 5; ++k)
        load_t(k, 3 * i + t) =
            (at[1].race[static_cast<std::size_t>(k)] - at[0].race[static_cast<std::size_t>(k)]) /
            (2.0 * step);
    }
  }
  const Eigen::MatrixXd t_y = T * places_y, t_q = T * places_q;
  const Eigen::MatrixXd dy = -(on_ball + force_t * t_y).partialPivLu().solve(by_q + force_t * t_q);
  return direct + load_y * dy + load_t * (t_y * dy + t_q);
}

}  // namespace

bool update_race(const CoupledBalls& set, const Vec5& q, BallRace& state, double accuracy) {
  constexpr int kMaxPasses = 60;
  constexpr double kSteadyChange = 1e-12, kRoundingChange = 1e-8;  // over the largest load
  double last = std::numeric_limits<double>::infinity();
  for (int pass = 0; pass < kMaxPasses; ++pass) {
    if (!update_race(*set.model, q, state, accuracy)) return false;
    const double change = follow_others(set, state) / state.largest_contact;
    if (!std::isfinite(change)) return false;
    if (change <= kSteadyChange || (change <= kRoundingChange && change >= 0.5 * last)) {
      state.stiffness = coupled_stiffness(set, state);
      return state.stiffness.allFinite();
    }
    last = change;
  }
  return false;
}

}  // namespace adore::statics
