#pragma once

#include "statics/ball_balance.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

/// Balls whose spin axes turn along the orbit. SI.
///
/// The balance of one ball (ball_friction.hpp) is steady in the frame of its azimuth θ, so that its
/// motion follows its contacts at once. In a bearing under radial load the contacts of a ball
/// change along its orbit, and turning its spin axis takes a moment [derived: d/dt = ω_m d/dθ of a
/// motion that all balls repeat]:
///   Σ M = J ω_m dω/dθ + gyroscopic moments,   Σ F_θ = m r ω_m dω_m/dθ (balls without a cage).
/// Light balls have less friction than that: their spin axes lag behind their contacts, and they
/// slide. dω/dθ is the upwind difference of second order over the two balls before in the direction
/// of the orbit, with the period of the bearing. All balls are solved at once by Newton steps of
/// the flow (ball_balance.hpp), with a share λ of the inertia that grows to 1 where the direct way
/// does not converge.
///
/// Places s_l of all balls act on the tractions of ball k. With R the residuals of all balls,
///   dt/ds = t_s - t_v R_v⁻¹ R_s,
/// full matrices, which the race equilibrium has with all blocks (coupled_balls.hpp).
///
/// Limits: balls without two loaded contacts, or without a balance, are passed over: they keep the
/// motion of the ball before. Places of balls are evenly spaced. Radial motion of a ball along its
/// orbit (Coriolis force) is left out.
namespace adore::statics {

class SpinLag {
 public:
  struct Ball {
    std::size_t number = 0;  ///< in the bearing, from 0
    double azimuth = 0.0;    ///< [rad]
    BallBalance* at = nullptr;
  };
  /// @param balls in the order of their azimuths, at least three; they must outlive this
  /// @param orbit mean orbit [rad/s]: its sign is the direction in which balls come
  SpinLag(std::vector<Ball> balls, double orbit);

  /// Balance of all balls from the given motions, by ball of the bearing. False: none was found,
  /// and nothing changes.
  [[nodiscard]] bool find(std::vector<BallMotion>& motions, const tribology::EllipseRule& few,
                          const tribology::EllipseRule& rule) const;
  /// dt/ds of all `count` balls of the bearing, 3 count × 5 count, at their balance.
  [[nodiscard]] Eigen::MatrixXd slopes(const std::vector<BallLinearization>& of_balls,
                                       const std::vector<BallMotion>& motions,
                                       std::size_t count) const;
  /// Moment that turns the spin axis of each ball at these motions, over its friction moment if it
  /// slid by the whole variation of the spin axes: above 1, the spin axis cannot follow its
  /// contacts. By ball of the bearing, 0 of those passed over.
  [[nodiscard]] std::vector<double> spin_moment_ratio(const std::vector<BallMotion>& motions,
                                                      double radius, std::size_t count) const;

 private:
  /// dU/dθ of ball k = Σ weight U over itself and the two before it.
  struct Stencil {
    std::array<Eigen::Index, 3> ball{};
    std::array<double, 3> weight{};
  };
  [[nodiscard]] Vec4 speeds_of(const Ball& ball, const BallMotion& motion) const;
  [[nodiscard]] Vec4 derivative(Eigen::Index k, const Eigen::VectorXd& U) const;
  [[nodiscard]] double inertia(Eigen::Index k) const;
  [[nodiscard]] Eigen::VectorXd residual(const Eigen::VectorXd& U, double share,
                                         std::vector<BallMotion>& motions) const;
  void add_inertia(const Eigen::VectorXd& U, double share, Eigen::MatrixXd& J) const;
  [[nodiscard]] bool search(Eigen::VectorXd& U, double share, double balanced,
                            std::vector<BallMotion>& motions) const;

  std::vector<Ball> balls_;
  std::vector<Stencil> stencils_;
  double unit_ = 0.0;  ///< of all speeds: the fastest spin [rad/s]
};

}  // namespace adore::statics
