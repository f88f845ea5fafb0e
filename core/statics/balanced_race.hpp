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
  BalancedRace(const bearing::Bearing& bearing, const BallStaticsOptions& options,
               const StaticSolution& solution);

  [[nodiscard]] const BallInGrooves& seat(std::size_t k) const {
    return model_.seat(state_.elements[k].site.own);
  }
  /// Traction along the major axis that ball k has at its present place.
  [[nodiscard]] std::array<double, 2> along(std::size_t k) const;
  void set_traction(std::size_t k, const StaticBall& ball, const BallMotion& motion,
                    const Eigen::Matrix<double, 3, 5>& slopes);
  void clear_traction(std::size_t k) { state_.elements[k].site.tractions.reset(); }
  /// Slopes of all tractions held over the places of all balls (coupled_balls.hpp), 3 n × 5 n.
  /// Until this is called, the traction of a ball depends on its own contacts only.
  void set_coupling(Eigen::MatrixXd slopes);

  /// The equilibrium with these tractions; false: none was found, and nothing changes.
  [[nodiscard]] bool solve(StaticSolution& solution);
  /// The last solve() found no equilibrium with the slopes of the tractions.
  [[nodiscard]] bool ignores_traction_slopes() const { return ignores_traction_slopes_; }
  [[nodiscard]] std::vector<Finding> notes(const StaticSolution& solution) const;
  void add_stiffness_by_difference(double share, StaticSolution& solution) const;

 private:
  [[nodiscard]] std::array<double, 5> displacement() const {
    return {state_.q(0), state_.q(1), state_.q(2), state_.q(3), state_.q(4)};
  }
  [[nodiscard]] bool is_coupled() const { return coupled_balls_.T.size() > 0; }
  [[nodiscard]] CoupledBalls make_coupled_balls() const;

  RaceLoadCase load_case_;
  BallModel model_;
  BallRace state_;
  bool ignores_traction_slopes_ = false;
  CoupledBalls coupled_balls_;  ///< without its model
};

}  // namespace adore::statics
