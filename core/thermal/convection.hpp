#pragma once

/// Convection from the parts of a bearing into the medium (kHTC = 0). SI. Re = ρ V D/μ, Pr = μ
/// c_p/k, h = Nu k/D; recalled correlations.
namespace adore::thermal {

struct ConvectionFluid {
  double density = 0.0, viscosity = 0.0, specific_heat = 0.0, conductivity = 0.0;
};

/// Ball (Ranz & Marshall): Nu = 2 + 0.6 Re^½ Pr^⅓. @return h [W/(m² K)]
[[nodiscard]] double sphere_convection(const ConvectionFluid& fluid, double diameter, double speed);

/// Roller across the flow (Churchill & Bernstein): Nu = 0.3 + 0.62 Re^½ Pr^⅓ [1 + (0.4/Pr)^⅔]^-¼ [1
/// + (Re/282000)^⅝]^⅘.
[[nodiscard]] double cylinder_convection(const ConvectionFluid& fluid, double diameter,
                                         double speed);

/// Cage turning with ω in the fluid: Nu = max(0.36, 0.133 Re^⅔ Pr^⅓), Re = ρ |ω| D²/(2μ); from
/// tests up to Re of some 1e5, extrapolated in cryogenic turbopumps.
[[nodiscard]] double ring_convection(const ConvectionFluid& fluid, double diameter, double omega);

}  // namespace adore::thermal
