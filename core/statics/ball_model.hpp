#pragma once

#include "bearing/bearing.hpp"
#include "contact/angle_law.hpp"
#include "contact/groove.hpp"
#include "contact/hertz.hpp"
#include "contact/wavy_groove.hpp"
#include "statics/ball_statics.hpp"

#include <Eigen/Core>

#include <array>
#include <memory>
#include <vector>

/// Constants of one quasi-static ball bearing problem: what all balls share.
namespace adore::statics {

/// ln(K/K_ref) and ln(a_hat/a_ref) of one race contact as Chebyshev series over c = cos α, -1 <= c
/// <= 1. Both are analytic there (the nearest singularity is c = ±d_m/D), so a short series holds
/// them to about 1e-15.
class HertzSeries {
 public:
  HertzSeries() = default;
  /// Curvature::Actual and Potential: at the contact's own angle; otherwise everything is taken at
  /// `reference_angle`.
  HertzSeries(const bearing::BallGeometry& balls, int race, double E_star, double reference_angle,
              Curvature curvature);

  struct Value {
    double value = 0.0, slope = 0.0;  ///< of the logarithm, and its derivative over cos α
  };
  [[nodiscard]] Value log_K(double cos_alpha) const noexcept { return evaluate(log_K_, cos_alpha); }
  [[nodiscard]] Value log_a(double cos_alpha) const noexcept { return evaluate(log_a_, cos_alpha); }
  [[nodiscard]] const contact::HertzConstants& reference() const noexcept { return reference_; }
  [[nodiscard]] bool varying() const noexcept { return varies_with_angle_; }
  /// K as the dynamics have it, whose slope leans the force; `follows` with Curvature::Potential.
  [[nodiscard]] const contact::HertzAngleLaw& law() const noexcept { return law_; }
  /// Exact constants at one angle (no series).
  [[nodiscard]] contact::HertzConstants at(double alpha) const;

 private:
  /// Coefficients of a series and of its derivative, side by side: one sum of two lanes.
  using Series = std::vector<Eigen::Array2d>;
  static Value evaluate(const Series& series, double c) noexcept;
  static Series series_with_derivative(const std::vector<double>& coefficients);

  Series log_K_, log_a_;  ///< empty when nothing varies
  contact::HertzAngleLaw law_;
  contact::HertzConstants reference_;
  bearing::BallGeometry balls_;
  int race_ = 0;
  double E_star_ = 0.0;
  bool varies_with_angle_ = false;
};

/// Where the spin axis comes from, and how the races share the gyroscopic moment.
struct SpinLaw {
  enum class Axis : unsigned char { OuterControl, InnerControl, LeastHeat, Prescribed };
  enum class Share : unsigned char {
    Outer,   ///< all at the outer race: λ = (0, 2) for (inner, outer)
    Equal,   ///< (1, 1)
    ByLoad,  ///< in proportion to the contact loads, 2Q_j/(Q_o + Q_i): equal demand on the friction
             ///< coefficient
    None     ///< reported, not applied
  };
  Axis axis = Axis::OuterControl;
  Share share = Share::Outer;
};

/// One ball and the two grooves where it runs.
struct BallInGrooves {
  contact::GrooveGeometry groove;
  std::array<HertzSeries, 2> hertz;
  std::array<double, 2> surface_radius{};  ///< 2fD/(2f+1), deformed contact surface [m]
  double diameter = 0.0;                   ///< D [m]
  double gamma = 0.0;                      ///< D/d_m
  double mass = 0.0, inertia = 0.0;        ///< of the ball [kg, kg m^2]
  double base_centrifugal = 0.0;           ///< m d_m/2 ω² of the base orbital speed [N]
  double window =
      0.0;  ///< inner load below which the ball is only partly driven (see ball_forces.hpp) [N]
  double inner_slope = 0.0;  ///< dR/dψ of the inner race here [m/rad]
  /// Races whose surface is a table (contact/wavy_groove.hpp); null: the groove here is a circle.
  std::array<std::shared_ptr<const contact::WavyGroove>, 2> table;
  double azimuth_in_race = 0.0;  ///< ψ at the start, read of tables only [rad]

  [[nodiscard]] double offset_sum() const noexcept { return groove.offset[0] + groove.offset[1]; }
};

/// What all balls share. The base is the seat of a nominal ball in ideal grooves.
struct BallModel : BallInGrooves {
  bearing::BallGeometry balls;
  std::array<double, 2> race_speed{};  ///< [rad/s]
  bool moving = false;                 ///< any race turns
  bool per_ball_speeds = false;        ///< Orbit::PerBall and moving
  bool exact = true;                   ///< RingKinematics::Exact
  std::array<double, 2> outer_tilt{};  ///< about y, z [rad]
  bool outer_tilted = false;
  /// Turning base frame: its speed adds to every orbital speed in inertial forces, and the
  /// transport acceleration of the base origin acts on every ball (field, base axes).
  double frame_speed = 0.0;                         ///< [rad/s]
  Eigen::Vector3d field = Eigen::Vector3d::Zero();  ///< [m/s²]
  double base_orbital =
      0.0;  ///< ω_m of a ball that does not follow its own angles (nominal, or unloaded) [rad/s]
  double spin_angle = 0.0;  ///< prescribed pitch angle [rad]
  double own_speed_share =
      1.0;  ///< 0: conservative problem (constant K and base speed); 1: the full one
  std::array<std::array<contact::SplitRaceHalf, 2>, 2> half{};  ///< by race; of a nominal ball
  bool split = false;                                           ///< a race is
  std::vector<double> azimuth;                                  ///< [rad]
  std::vector<BallInGrooves> own;       ///< seats of balls that differ from the nominal one
  std::vector<std::size_t> own_number;  ///< by ball: 1 + index into own, 0: nominal; empty: all 0

  /// Seat of the ball with this BallSite::own.
  [[nodiscard]] const BallInGrooves& seat(std::size_t own_number_of_ball) const {
    return own_number_of_ball == 0 ? *this : own[own_number_of_ball - 1];
  }
};

/// @throws InputError naming the value that makes no bearing.
[[nodiscard]] BallModel make_ball_model(const bearing::Bearing& bearing,
                                        const BallStaticsOptions& options);

/// Fills own and own_number for the imperfections of the bearing (bearing.imperfections): balls of
/// other diameter, grooves whose bottom or radius is another at the ball's azimuth.
/// Ball k: D_k, mass and inertia of bearing/element_inertia.hpp. Groove j at azimuth ψ:
/// contact/race_errors.hpp, the groove radius changes by Δf D. The inner race also has the slope
/// dR/dψ of its bottom, so that a wave pushes it sideways; that of the outer race pushes the ball
/// against its cage and has no effect here.
/// @throws InputError naming the ball that does not fit its groove.
void add_imperfect_balls(BallModel& model, const bearing::Bearing& bearing,
                         const BallStaticsOptions& options);

/// The spin law that the options ask for (race control starts as outer control).
[[nodiscard]] SpinLaw first_spin_law(const bearing::Bearing& bearing,
                                     const BallStaticsOptions& options);

}  // namespace adore::statics
