#pragma once

/// Drag and churning of bodies in the medium of a bearing's cavity (kChrn): an oil-air mixture of
/// effective density ρ and viscosity μ, or a cryogenic liquid. SI. Every torque times its speed, or
/// force times speed, is the power that the medium takes.
namespace adore::tribology {

struct Medium {
  double density = 0.0, viscosity = 0.0;  ///< [kg/m³], [Pa s], > 0
};

struct Drag {
  double reynolds = 0.0, coefficient = 0.0, force = 0.0;  ///< [N], against V
};

/// F = ½ C_D ρ A V², Re = ρ V D/μ; smooth sphere, C_D log-log from a table (after Schlichting, seen
/// in a secondary source), ∝ 1/Re below 0.1, held above 1e6. @param area A = π D²/4 less what the
/// cage hides
[[nodiscard]] Drag sphere_drag(const Medium& medium, double speed, double diameter, double area);

/// The same for a cylinder across the flow, A = D l (table recalled).
[[nodiscard]] Drag cylinder_drag(const Medium& medium, double speed, double diameter,
                                 double length);

struct RotationDrag {
  double reynolds = 0.0, taylor = 0.0, coefficient = 0.0;
  double torque = 0.0;  ///< [N m], against ω
};

/// Cylinder of radius r turning in a concentric annulus of gap c: τ = ½ f ρ (ω r)², f = (2/Re) ×
/// ratio, Re = ρ ω r c/μ (exact for laminar flow). `coefficient` is the ratio (Rumbarger, Filetti &
/// Gubernick 1973, recalled): Taylor vortices 1.3 (Ta/41)^0.539474, Ta = Re √(c/r), blended in over
/// Ta 35 to 45; turbulence 3.0 (Re/2500)^0.85596, blended in over Re 2250 to 2750; the larger of
/// both. Torque 2π r² L τ.
[[nodiscard]] RotationDrag annulus_drag(const Medium& medium, double speed, double radius,
                                        double gap, double length);

/// Disc of radius r wetted on both sides: T = ½ ρ ω² r⁵ C, C = 3.87/√Re (Re = ρ ω r²/μ) and
/// 0.146/Re^0.2 beyond, blended over Re 2.7e5 to 3.3e5 (Schlichting, recalled).
[[nodiscard]] RotationDrag disc_drag(const Medium& medium, double speed, double radius);

/// Spin of a ball of radius R: T = ½ ρ ω² R⁵ C, C = 6.45/√Re + 32.1/Re or 16π/Re (creeping,
/// 8π μ R³ ω), the larger: they meet at Re 8.0; held above 4e4 (recalled; beyond is a choice).
[[nodiscard]] RotationDrag spin_drag(const Medium& medium, double speed, double radius);

/// Friction coefficient of a flat plate: 1.328/√Re; 0.455/(log10 Re)^2.58 - 1700/Re from where it
/// is the larger (Schlichting, recalled).
[[nodiscard]] double plate_friction(double reynolds);

}  // namespace adore::tribology
