#pragma once

#include "validation/motion.hpp"

#include <fmt/format.h>

#include <array>
#include <complex>
#include <vector>

/// Balls between races that are held or turn at constant speed, without cage and gravity.
namespace adore::validation {

/// Effect of one race on one ball at the last evaluated state.
struct BallLoad {
  double Q = 0.0, heat = 0.0;  ///< [N, W]
  dynamics::RaceContactState contact;
};

/// Grooves of a ball bearing by their center circles, with a matching pitch
/// diameter and clearance of the deck. Hertz constants stay those of the nominal γ = D cos α0/d_m.
void set_grooves(SmallScene& scene, double diameter, const std::array<double, 2>& groove_factor,
                 const std::array<double, 2>& centre_radius, double gamma);
[[nodiscard]] tribology::ContactSurface contact_surface(const std::string& name);

/// `inputs` of families dynamics_ball_thrust, _vibration and _radial, balls at rest.
[[nodiscard]] SmallScene ball_scene(const Json& inputs, const Vec3& inner_centre, bool traction,
                                    int count);
/// Error scales of contact vibration and of the speeds of the start.
void set_ball_error_scales(Motion& motion);
[[nodiscard]] BallLoad ball_load(const Motion& motion, const dynamics::Evaluation& e,
                                 std::size_t race, std::size_t ball = 0);

/// Motion with x'' = r'' = θ'' = ω' = 0, x' = r' = 0 of one ball, by Newton's method from y.
[[nodiscard]] State steady_state(Motion& motion, State y);
/// Eigenvalues of the linearisation in (x, r, x', r', θ', ω) of one ball.
[[nodiscard]] std::vector<std::complex<double>> eigenvalues(Motion& motion, const State& steady);
/// Motion near (x, r) with normal and centrifugal forces in balance, no slip at the middle of
/// either contact, no spin at the outer race and ω_θ = 0.
[[nodiscard]] State rolling_start(Motion& motion, double x, double r);

/// Traction on the ball, with its part along n for surfaces whose tangent plane is followed.
struct SurfaceTraction {
  tribology::EllipseTraction in_plane;
  double F_n = 0.0;  ///< [N]
};
/// @param u_n race minus ball velocity along n at the ball center [m/s]
using TractionRule = std::function<SurfaceTraction(const tribology::TractionLaw&,
                                                   const dynamics::RaceContactState&, double u_n)>;
/// The integral split at kinks and reversals of slip, `points` nodes per piece.
[[nodiscard]] TractionRule split_rule(int points);
/// Slip and arms at the middle of every strip across the ellipse: the variation along the minor
/// axis is ignored. A rule of one case alone.
[[nodiscard]] TractionRule minor_axis_ignored_rule();
/// Slip and traction in the local tangent plane of the curved surface. A rule of one case alone.
[[nodiscard]] TractionRule tangent_plane_rule();

/// The traction of the cases is converged to 1e-7, the fixed quadrature rule of a run to 1e-3: to
/// what the run's traction does, this adds the difference of `rule` and that fixed rule. The rule
/// may be replaced later.
[[nodiscard]] std::shared_ptr<TractionRule> install_converged_traction(SmallScene& scene,
                                                                       TractionRule rule);
/// Integrals "heat j i" of the contact of race j and ball i [J].
void add_heat_integrals(SmallScene& scene, int balls);
[[nodiscard]] inline std::string heat_integral_name(std::size_t race, std::size_t ball) {
  return fmt::format("heat {} {}", race, ball);
}

}  // namespace adore::validation
