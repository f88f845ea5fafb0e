#pragma once

#include "dynamics/elements.hpp"
#include "dynamics/race_contacts.hpp"
#include "reference/adapter.hpp"
#include "reference/trajectory.hpp"

#include <array>
#include <complex>
#include <functional>
#include <span>
#include <vector>

/// Balls between races that are held or turn at constant speed, without cage and gravity: the
/// solver's contact geometry and equations of motion with the split traction integral.
namespace adore::reference {

/// What one race does to one ball, base axes.
struct BallLoad {
  Vec3 force = Vec3::Zero(),
       moment = Vec3::Zero();  ///< on the ball, moment about its centre [N, N m]
  double Q = 0.0, heat = 0.0;  ///< [N, W]
  dynamics::RaceContactState contact;
  tribology::EllipseTraction traction;
};

/// Traction on the ball, with its part along n for surfaces whose tangent plane is followed.
struct SurfaceTraction {
  tribology::EllipseTraction in_plane;
  double F_n = 0.0;  ///< [N]
};
/// Traction of one contact; replaceable where a case asks for another surface model than the
/// library's.
/// @param u_n race minus ball velocity along n at the ball centre [m/s]
using TractionRule = std::function<SurfaceTraction(const tribology::TractionLaw&,
                                                   const dynamics::RaceContactState&, double u_n)>;

/// The library's split rule with `points` per piece.
[[nodiscard]] TractionRule split_rule(int points);
/// Slip and arms at the middle of every strip across the ellipse: the variation along the minor
/// axis is ignored.
[[nodiscard]] TractionRule minor_axis_ignored();
/// Slip and traction in the local tangent plane of the curved surface.
[[nodiscard]] TractionRule tangent_plane();

[[nodiscard]] BallLoad ball_load(const dynamics::RaceContactModel& model,
                                 const dynamics::ElementViews& balls, std::size_t index,
                                 const dynamics::RaceMotion& race, const TractionRule& rule);

/// Outer race of the pocket family: {"groove_centre_radius", "groove_minus_ball_radius", "K", ...}.
[[nodiscard]] dynamics::RaceContactModel outer_race_model(const Json& race,
                                                          const bearing::TractionCurve& curve,
                                                          double ball_radius);
[[nodiscard]] tribology::ContactSurface contact_surface(const std::string& name);

/// Load on a ball given by position, velocity and ω in base axes (nine numbers), race at rest about
/// the base X axis.
[[nodiscard]] BallLoad load_on_free_ball(const dynamics::RaceContactModel& model, double race_speed,
                                         const double* state);

/// One ball between two races.
class BallBetweenRaces {
 public:
  /// State: x, r, θ, their rates, ω_x, ω_r, ω_θ, then heat outer, heat inner, work of the inner
  /// race.
  static constexpr std::size_t kMechanical = 9, kSize = 12;

  /// `inputs` of families dynamics_ball_thrust, _vibration and _radial.
  /// @param inner_centre position of the inner groove-centre circle's middle
  BallBetweenRaces(const Json& inputs, const Vec3& inner_centre, bool traction);

  void set_surface(tribology::ContactSurface surface);
  void set_rule(TractionRule rule) { rule_ = std::move(rule); }
  [[nodiscard]] const dynamics::RaceContactModel& model(std::size_t race) const {
    return models_[race];
  }
  [[nodiscard]] const dynamics::RaceMotion& race(std::size_t race) const { return races_[race]; }
  [[nodiscard]] double mass() const { return mass_; }

  void rates(const double* y, double* d);
  [[nodiscard]] std::array<BallLoad, 2> loads(const double* y);
  [[nodiscard]] Problem problem(const State& mechanical);

  /// Mechanical state near (x, r) with normal and centrifugal forces in balance, no slip at the
  /// middle of either contact, no spin at the outer race and ω_θ = 0.
  [[nodiscard]] State rolling_start(double x, double r);
  /// Newton for x'' = r'' = θ'' = ω' = 0, x' = r' = 0, from a mechanical state.
  [[nodiscard]] State steady_state(State start);
  /// Eigenvalues of the linearisation in (x, r, x', r', θ', ω).
  [[nodiscard]] std::vector<std::complex<double>> eigenvalues(const State& steady);

 private:
  [[nodiscard]] Eigen::MatrixXd jacobian(const State& y, std::span<const std::size_t> columns,
                                         std::span<const std::size_t> rows);
  /// The ball in the state y.
  [[nodiscard]] dynamics::ElementViews view(const double* y);

  dynamics::ElementSlices slices_;
  dynamics::ElementActions actions_;          ///< on the ball
  double sin_theta_ = 0.0, cos_theta_ = 1.0;  ///< of the state viewed last
  std::array<dynamics::RaceContactModel, 2> models_;
  std::array<dynamics::RaceMotion, 2> races_;
  double mass_, ball_radius_, orbit_radius_;
  TractionRule rule_ = split_rule(16);
};

}  // namespace adore::reference
