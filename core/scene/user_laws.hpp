#pragma once

#include "bearing/imperfections.hpp"
#include "tribology/laws/user_law.hpp"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

/// What routines of the user put in the place of physics: plain interfaces, behind which the solver
/// knows neither plug-ins nor formulas. SI, base axes. A member that is null is not the user's.
namespace adore::scene {

/// ADRX1: loads and accelerations of races, motion of the base frame.
class UserMotion {
 public:
  struct Race {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< from its free place [m]
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
    Eigen::Vector3d omega = Eigen::Vector3d::Zero();
    double angle = 0.0;  ///< about its axis since the start [rad]
  };
  struct Actions {
    std::array<Eigen::Vector3d, 2> force, moment;  ///< on both races [N, N m]
    std::array<Eigen::Vector3d, 2> acceleration,
        angular_acceleration;                 ///< of driven races, held directions
    Eigen::Vector3d frame;                    ///< acceleration of the base frame's origin [m/s²]
    Eigen::Vector3d frame_omega, frame_turn;  ///< Ω of the base frame and dΩ/dt [rad/s, rad/s²]
  };
  /// Said once, before the start.
  struct MotionDeclaration {
    std::array<bool, 2> drives{};  ///< races whose accelerations it gives
    bool moves_frame = false;
    std::array<Eigen::Vector3d, 2> start_velocity{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
    std::array<double, 2> start_spin{};  ///< beyond the deck's [rad/s]
    double longest_step = 0.0;           ///< [s]; 0: no limit
    std::vector<double> kinks;           ///< steps end there [s]
  };

  virtual ~UserMotion() = default;
  [[nodiscard]] virtual const MotionDeclaration& motion_declaration() const noexcept = 0;
  /// False: no valid state. No allocation, no throw.
  virtual bool evaluate(double t, const std::array<Race, 2>& races, Actions& out) noexcept = 0;
};

/// ADRX2 to ADRX4: normal force over the gap.
class UserContactForce {
 public:
  struct Contacts {
    std::size_t n = 0;
    const int *element = nullptr, *surface = nullptr;
    const double *gap = nullptr, *gap_rate = nullptr, *built_in = nullptr;
    double* force = nullptr;  ///< built_in when asked
  };
  virtual ~UserContactForce() = default;
  virtual bool forces(double t, const Contacts& contacts) noexcept = 0;
};

struct UserLaws {
  virtual ~UserLaws() = default;
  UserLaws() = default;
  UserLaws(const UserLaws&) = delete;
  UserLaws& operator=(const UserLaws&) = delete;

  std::array<const tribology::UserTractionRoutine*, 5> traction{};  ///< by TractionKind
  UserMotion* motion = nullptr;
  UserContactForce *flange = nullptr, *pocket = nullptr, *land = nullptr;

  /// ADRX5: what the radius of each roller has more over the azimuth ψ of its own frame (from its z
  /// axis about +x), radius + s tan(taper) at s from its middle; empty: all round.
  std::vector<std::shared_ptr<const bearing::SurfaceSeries>> out_of_round;

  double time = 0.0;  ///< of the evaluation under way [s]

  /// A routine has failed for good: every evaluation from now on is none.
  [[nodiscard]] virtual bool failed() const noexcept = 0;
  /// Of the evaluation since the last call: did a routine refuse the state?
  virtual bool refused() noexcept = 0;

  [[nodiscard]] const tribology::UserTractionRoutine* traction_of(
      tribology::TractionKind kind) const noexcept {
    return traction[static_cast<std::size_t>(kind)];
  }
};

}  // namespace adore::scene
