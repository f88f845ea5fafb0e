#pragma once

#include "statics/ball_race.hpp"
#include "statics/ball_statics.hpp"
#include "statics/coupled_balls.hpp"
#include "statics/friction_balance.hpp"

#include <Eigen/Core>

#include <array>
#include <string>
#include <vector>

/// Balls of a solution with their tractions, and the race on them (ball_friction.hpp). SI.
namespace adore::statics {

class BalancedRace {
 public:
  BalancedRace(const bearing::Bearing& bearing, const StaticsOptions& options,
               const StaticSolution& solution);

  [[nodiscard]] const BallSeat& seat(std::size_t k) const {
    return model_.seat(state_.elements[k].site.own);
  }
  /// Traction along the major axis that ball k has at its present place.
  [[nodiscard]] std::array<double, 2> along(std::size_t k) const;
  void hold(std::size_t k, const StaticBall& ball, const BallMotion& motion,
            const Eigen::Matrix<double, 3, 5>& slopes);
  void release(std::size_t k) { state_.elements[k].site.tractions.reset(); }
  /// Slopes of all tractions held over the places of all balls (coupled_balls.hpp), 3 n × 5 n.
  /// Until this is called, the traction of a ball depends on its own contacts only.
  void couple(Eigen::MatrixXd slopes);

  /// The equilibrium with these tractions; false: none was found, and nothing changes.
  [[nodiscard]] bool solve(StaticSolution& solution);
  /// The last solve() found no equilibrium with the slopes of the tractions.
  [[nodiscard]] bool is_plain() const { return plain_; }
  [[nodiscard]] std::vector<std::string> notes(const StaticSolution& solution) const;
  void add_difference(double share, StaticSolution& solution) const;

 private:
  [[nodiscard]] std::array<double, 5> displacement() const {
    return {state_.q(0), state_.q(1), state_.q(2), state_.q(3), state_.q(4)};
  }
  [[nodiscard]] bool is_coupled() const { return coupled_.T.size() > 0; }
  [[nodiscard]] CoupledBalls coupled_set() const;

  RaceTask task_;
  BallModel model_;
  BallRace state_;
  bool plain_ = false;
  CoupledBalls coupled_;  ///< without its model
};

}  // namespace adore::statics
