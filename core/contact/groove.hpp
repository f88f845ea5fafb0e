#pragma once

#include "bearing/bearing.hpp"
#include "contact/hertz.hpp"
#include "contact/split_race.hpp"

#include <array>

/// Groove geometry of a ball bearing in the free state, shared by statics and dynamics.
///
/// Race frame j: origin P_j on the race axis in the plane of its groove-centre circle, x along the
/// axis. The groove cross-section is a circle of radius f_j D whose centre runs on a circle of
/// radius centre_radius[j] about that axis. Base frame: at zero displacement P_j lies at x =
/// centre_x[j], its free position, which the deck's geometry alone fixes
/// (BallGeometry::groove_plane, decision 140): the ball plane of the unloaded, just touching (or
/// centred) bearing is x = 0. A reported displacement of race j is P_j minus that free position.
namespace adore::contact {

struct GrooveGeometry {
  double ball_radius = 0.0;               ///< D/2 [m]
  std::array<double, 2> groove_radius{};  ///< r_j = f_j D [m]
  std::array<double, 2>
      offset{};  ///< s_j = (f_j - 1/2) D, groove centre to ball centre at touch [m]
  std::array<double, 2> centre_radius{};  ///< Rc_j [m]: outer d_m/2 - s_o cos α0 (+ Pd/4 radial),
                                          ///< inner d_m/2 + s_i cos α0 (- Pd/4)
  std::array<double, 2> centre_x{};  ///< free axial position of P_j [m]: groove_plane, else outer
                                     ///< -s_o sin α0, inner +s_i sin α0
};

/// With α0 > 0 the bearing just touches at α0; with α0 = 0 the clearance Pd places the centres
/// (README C of the reference cases: Pd/4 on each race).
[[nodiscard]] GrooveGeometry groove_geometry(const bearing::BallGeometry& balls);

/// The same bearing as one ball sees it that is `growth` larger than the others [m]: grooves stay,
/// their factors are those over its own diameter. Contact angle, clearance and groove_plane are not
/// touched: they say where the grooves are, which is what groove_with_ball_growth keeps.
[[nodiscard]] bearing::BallGeometry geometry_with_ball_growth(const bearing::BallGeometry& balls,
                                                              double growth);
/// Grooves of the nominal ball around that ball: radius and offsets are its own.
[[nodiscard]] GrooveGeometry groove_with_ball_growth(const GrooveGeometry& nominal,
                                                     double growth) noexcept;

/// Relative curvatures at race j for contact angle α: 2/D ± 2 cos α/(d_m ∓ D cos α) rolling (upper
/// sign inner), 2/D - 1/(f_j D) transverse. For every practical groove the major axis is
/// transverse.
[[nodiscard]] RelativeCurvature race_curvature(const bearing::BallGeometry& balls, int race,
                                               double contact_angle);

/// Where a contact ends on the groove (outputs §16, N94), f D = groove radius:
struct ContactEdges {
  double shoulder_depth = 0.0;  ///< s = fD cos(|α| + a/(fD)) ± (Rc - r_shoulder), + outer [m]
  double centre_chord = 0.0;    ///< t = fD sin(|α| - a/(fD)), inner end of the contact from the
                                ///< groove's centre plane [m]
};
/// @param half_major a [m]; shoulder_radius [m], 0: not given, and shoulder_depth stays 0
[[nodiscard]] ContactEdges contact_edges(const GrooveGeometry& groove, int race, double angle,
                                         double half_major, double shoulder_radius) noexcept;

/// Free contact angle and clearance of a ball bearing from what the deck gives (N39): cos α0 = 1 -
/// Pd/(2D(f1+f2-1)); a shim g on a race of factor f gives arch angle asin(g/((2f-1)D)) and Pd =
/// freeIntCls + (2f-1)D(1 - cos αs). contact_angle > 0 rules.
struct FreeAngleAndClearance {
  double contact_angle = 0.0;  ///< [rad]
  double clearance = 0.0;      ///< Pd of the circular grooves [m]
};
/// @throws InputError when the clearance is larger than the grooves allow.
[[nodiscard]] FreeAngleAndClearance free_angle_and_clearance(
    double diameter, const std::array<double, 2>& groove_factor, const std::array<double, 2>& shim,
    double contact_angle, double measured_clearance);

/// Both halves of a race: {} twice where it is not split. P_j is the centre of the half that thrust
/// along +x loads, halfway between both centres in bearings given by their clearance (centre_x 0).
[[nodiscard]] std::array<SplitRaceHalf, 2> split_race_halves(const bearing::BallGeometry& balls,
                                                             const GrooveGeometry& groove,
                                                             int race);

/// Axial play of a ball between unloaded races whose curvature centres are A cos α apart radially
/// [m]: 2 A sin α - Σ g. Where a ball would reach the split of a race before (s sin α < g/2), both
/// halves of that race touch it and it turns there no further; 0: no play is left.
/// @param offset s = groove radius - ball radius [m]; shim g [m]
[[nodiscard]] double split_race_end_play(const std::array<double, 2>& offset,
                                         const std::array<double, 2>& shim, double contact_angle);

}  // namespace adore::contact
