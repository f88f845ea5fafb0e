#pragma once

#include "bearing/bearing.hpp"
#include "bearing/given_surface.hpp"

#include <functional>
#include <vector>

/// Surfaces of races that vary across, or that have steps and spalls (user routine ADRX6), as
/// tables that an element rolls over. SI, rad.
///
/// Deviations of a groove: radius ΔR(ψ, x), curvature factor Δf(ψ, x), x = r_g sin φ. The surface
/// recedes from the ball along the direction φ by [derived]
///   w = ±ΔR cos φ + ∫ D Δf(t) sin(φ - t) dt,  from the nominal contact angle on,
/// + outer and - inner race: the arc whose local radius is (f + Δf) D.
/// An element touches what is nearest, not what is under its centre. A point of the surface that is
/// away by a along rolling and by γ on the arc is a²/2R_y + γ² r_g s/2R farther from it (R, R_y:
/// radius of the ball, and of both bodies along rolling; s = r_g - R), so that the approach is
///   δ = l - s - min over all (ψ', φ') of [w(ψ', φ') + a²/2R_y + γ² r_g s/2R]
/// This is the morphological dilation of the surface by the ball (Moreau envelope), the force is
/// its gradient. It has no jumps: from the edge of a step or spall on, the ball turns about the
/// edge; over a spall of length L it sinks by no more than L²/8R_y, or the depth of the spall. Of
/// smooth waves it is the wave itself, lowered by R_y (dw/da)²/2.
/// Rollers: each slice for itself, along rolling.
/// Limits: edges are found to half the distance of places, 2π/4096 and 1 degree of the arc;
/// stiffness is Hertz's of the groove, on an edge, too, where a quarter space is softer; pressures
/// and films on edges are not computed; Δf counts where the ball touches; slices of a roller keep
/// their place on the race across.
namespace adore::setup {

inline constexpr int kTableAround = 4096;
inline constexpr int kTableAcross = 161;     ///< of grooves
inline constexpr double kTableReach = 80.0;  ///< greatest |φ| [degrees]

/// Places across where a race is asked for: x of rows of a groove, middles of a roller's slices.
[[nodiscard]] std::vector<double> surface_table_axial_positions(const bearing::Bearing& bearing,
                                                                std::size_t race, int slices);

/// @param places as surface_table_axial_positions; radius ΔR and factor Δf row by row, kTableAround
/// values of the turn each; factor: empty, all 0
[[nodiscard]] bearing::SurfaceTable build_surface_table(const bearing::Bearing& bearing,
                                                        std::size_t race,
                                                        const std::vector<double>& places,
                                                        const std::vector<double>& radius,
                                                        const std::vector<double>& factor);

/// min over j of values[j] + cost (i - j)² for each i; values between places where they are smooth.
/// @param closed the last is followed by the first; from: place of the least, may be null
[[nodiscard]] std::vector<double> moreau_envelope(const std::vector<double>& values, double cost,
                                                  bool closed, std::vector<std::size_t>* from);

/// Coefficients of the cubic B-spline that goes near the values, to fourth order.
[[nodiscard]] std::vector<double> spline_coefficients(const std::vector<double>& values,
                                                      bool closed);
/// The same of a table, in place.
void convert_to_spline_coefficients(std::vector<double>& rows, std::size_t around, bool across);

}  // namespace adore::setup
