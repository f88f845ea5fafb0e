#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>
#include <vector>

/// Friction torque of bearings over speed, load and oil, from the equilibrium, next to a published
/// catalogue formula. Bearings, constants, limits and oils are data:
/// resources/experiments/skf-torque.json. `adore validate --torque`.
///
/// Catalogue (SKF, Rolling bearings, 2013; forms seen, constants of the series recalled), ν
/// [mm²/s], n [rpm], loads [N], d, D, dm = (d + D)/2 [mm], torque [N mm], without seals and drag:
///   M = φish φrs Grr (ν n)^0.6 + Gsl μsl
///   φish = 1/(1 + 1.84e-9 (n dm)^1.28 ν^0.64)
///   φrs = exp{-Krs ν n (d + D) √[Kz/(2 (D - d))]},  Krs = 3e-8 (oil bath)
///   μsl = φbl 0.15 + (1 - φbl) μEHL,  φbl = exp{-2.6e-8 (n ν)^1.4 dm}
///   deep groove, radial load   Grr = R1 dm^1.96 Fr^0.54         Gsl = S1 dm^-0.26 Fr^(5/3)
///   angular contact            Grr = R1 dm^1.97 (Fr + R3 dm^4 n² + R2 Fa)^0.54
///                              Gsl = S1 dm^0.26 [(Fr + S3 dm^4 n²)^(4/3) + S2 Fa^(4/3)]
///   cylindrical roller         Grr = R1 dm^2.41 Fr^0.31         Gsl = S2 dm Fr
///   tapered roller             Grr = R1 dm^2.38 (Fr + R2 Y Fa)^0.31
///                              Gsl = S1 dm^0.82 (Fr + S2 Y Fa)
///   spherical roller           Grr = min{R1 dm^1.85 (Fr + R2 Fa)^0.54, R3 dm^2.3 (Fr + R4
///   Fa)^0.31}
///                              Gsl = min{S1 dm^0.25 (Fr⁴ + S2 Fa⁴)^(1/3),
///                                        S3 dm^0.94 (Fr³ + S4 Fa³)^(1/3)}
/// Oil: Walther's law lg lg(ν + 0.7) = A - B lg T through ν at 40 and 100 °C [recalled high], so
/// that ν at the temperature of the table and d ln ν/d(1/T) follow from the grade.
/// Left out and counted: points above the limiting speed, and below the minimum load [kN]
///   deep groove      Fr = kr (ν n/1000)^(2/3) (dm/100)²
///   angular contact  Fa = ka C0 (n dm/1e5)²
///   cylindrical      Fr = kr (6 + 4 n/nr) (dm/100)²
///   tapered          share of C;   spherical   share of C0   [recalled medium]
/// Spherical bearings have two rows; the deck is one of them under half the load.
namespace adore::validation {

struct TorqueLine {
  double rpm = 0.0, radial = 0.0, axial = 0.0;                 ///< [rpm, N]
  double load_ratio = 0.0;                                     ///< C/P
  double rolling = 0.0, sliding = 0.0, spin = 0.0, rib = 0.0;  ///< ours [N m]
  double drag = 0.0;  ///< ours, of the medium: 0 where kChrn = 0 [N m]
  double catalogue_rolling = 0.0, catalogue_sliding = 0.0;  ///< [N m]
  std::string failed;                                       ///< why there is no figure of ours
  [[nodiscard]] double total() const noexcept { return rolling + sliding + spin + rib + drag; }
  [[nodiscard]] double catalogue() const noexcept { return catalogue_rolling + catalogue_sliding; }
};

struct TorqueTable {
  std::string deck, bearing, oil;
  double viscosity = 0.0;  ///< ν of both [m²/s]
  std::vector<TorqueLine> lines;
  int above_speed = 0, below_load = 0;  ///< points that are left out
  std::string certainty;                ///< of the formula's constants
};

/// @param data of resources/experiments/skf-torque.json; empty: the embedded file
/// @throws InputError naming bearing and member of a schema error; InputError, SolverError of a
/// deck
[[nodiscard]] std::vector<TorqueTable> compute_torque_tables(std::string_view data = {});

[[nodiscard]] std::string torque_text(const std::vector<TorqueTable>& tables);
/// The tables of resources/docs/friction-torque.md.
[[nodiscard]] std::string torque_markdown(const std::vector<TorqueTable>& tables);
[[nodiscard]] nlohmann::ordered_json torque_json(const std::vector<TorqueTable>& tables);

}  // namespace adore::validation
