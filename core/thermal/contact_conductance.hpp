#pragma once

#include "bearing/bearing.hpp"

#include <array>

/// Conductance between the film of a contact and both bodies [W/K]. SI, kelvin.
///
/// Heat arises in the film and enters both bodies through small patches that move over them. The
/// patch is hotter than the surface around it, in the mean over the patch, by R times the heat:
///   at rest:  G_s = 2π k a/K(m), m = 1 - (b/a)², a the larger half axis (isothermal ellipse on a
///     half space; circle: 4 k a; Holm, Yovanovich) [exact];
///   moving at U along b:  G_m = 0.819 π a b √(π k ρ c U/(2 b)): the mean over an ellipse of
///     θ(s) = 2 q √(s/(π k ρ c U)), s the distance from the leading edge (Blok 1937, Jaeger 1942:
///     fast moving band) [derived];
///   G = √(G_s² + G_m²), the blend of Tian & Kennedy (1994) for circles [recalled, high].
/// The bodies' surfaces move under the patch with U = |Ω_j - ω_m| r. Limits: uniform heat over the
/// ellipse, no return of heat from the turn before (that is the bulk temperature of the network),
/// one patch size for a contact of a roller (its slice with the largest pressure along the whole
/// length).
/// Oil: half of the film to either side, G_f = 1.25 × 2 k_oil π a b/h in series: a quarter more
/// than the ellipse conducts, for inlet and outlet, ∫ dx/(h + gap) over Hertz gaps at h = 0.3 b²/(2
/// R) with oil that is not under pressure [derived, one case]. Conductivity of oil under pressure
/// k_oil = k (1 + 1.72 p/(1 + 0.76 p)), p in GPa, 2/3 of the peak (Larsson & Andersson 2000)
/// [recalled, medium]. The flash temperature of tribology/contact_flash.hpp is the peak of the same
/// rise over the bulk; it is added to the temperatures of the network and never enters them.
namespace adore::statics {
struct StaticSolution;
struct RollerSolution;
}  // namespace adore::statics

namespace adore::thermal {

/// Of the film to each of two bodies [W/K].
struct FilmConductance {
  double first = 0.0, second = 0.0;
};

/// @param across, along half axes of the patch [m]; speed of the surface along `along` [m/s]
[[nodiscard]] double patch_conductance(const bearing::Material& body, double across, double along,
                                       double speed);

/// All contacts of elements with each race: first the element, second the race.
using RaceConductance = std::array<FilmConductance, 2>;
[[nodiscard]] RaceConductance race_conductance(const bearing::Bearing& bearing,
                                               const statics::StaticSolution& solution);
[[nodiscard]] RaceConductance race_conductance(const bearing::Bearing& bearing,
                                               const statics::RollerSolution& solution);

}  // namespace adore::thermal
