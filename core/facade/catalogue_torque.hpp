#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

/// Friction torque of three example bearings over speed and load, from the equilibrium, beside a
/// published catalogue formula. `adore validate --torque`.
///
/// Catalogue (SKF, Rolling bearings, 2013; forms seen, constants of the series recalled), ν
/// [mm²/s], n [rpm], loads [N], d, D, dm = (d + D)/2 [mm], torque [N mm], without seals and drag:
///   M = φish φrs Grr (ν n)^0.6 + Gsl μsl
///   φish = 1/(1 + 1.84e-9 (n dm)^1.28 ν^0.64)
///   φrs = exp{-Krs ν n (d + D) √[Kz/(2 (D - d))]},  Krs = 3e-8 (oil bath)
///   μsl = φbl 0.15 + (1 - φbl) μEHL,  φbl = exp{-2.6e-8 (n ν)^1.4 dm}
///   deep groove, radial load   Grr = R1 dm^1.96 Fr^0.54         Gsl = S1 dm^-0.26 Fr^(5/3)
///   cylindrical roller         Grr = R1 dm^2.41 Fr^0.31         Gsl = S2 dm Fr
///   tapered roller             Grr = R1 dm^2.38 (Fr + R2 Y Fa)^0.31
///                              Gsl = S1 dm^0.82 (Fr + S2 Y Fa)
namespace adore::facade {

struct TorqueLine {
  double rpm = 0.0, radial = 0.0, axial = 0.0;                 ///< [rpm, N]
  double rolling = 0.0, sliding = 0.0, spin = 0.0, rib = 0.0;  ///< ours [N m]
  double drag = 0.0;  ///< ours, of the medium: no part where kChrn = 0 [N m]
  double catalogue_rolling = 0.0, catalogue_sliding = 0.0;  ///< [N m]
  [[nodiscard]] double total() const noexcept { return rolling + sliding + spin + rib + drag; }
  [[nodiscard]] double catalogue() const noexcept { return catalogue_rolling + catalogue_sliding; }
};

struct TorqueTable {
  std::string deck, bearing;
  double viscosity = 0.0;  ///< ν of both [m²/s]
  std::vector<TorqueLine> lines;
};

/// @throws InputError, SolverError of a deck
[[nodiscard]] std::vector<TorqueTable> catalogue_torques();

[[nodiscard]] std::string torque_text(const std::vector<TorqueTable>& tables);
/// The tables of resources/docs/friction-torque.md.
[[nodiscard]] std::string torque_markdown(const std::vector<TorqueTable>& tables);
[[nodiscard]] nlohmann::ordered_json torque_json(const std::vector<TorqueTable>& tables);

}  // namespace adore::facade
