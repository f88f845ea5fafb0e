#pragma once

#include "bearing/bearing.hpp"
#include "thermal/network.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

/// The thermal network of a bearing with its coolant (kTherm, records 3.5, 9.7, 9.8): from heat
/// sources to temperatures. SI, kelvin. Equations: network.hpp (ladder), convection.hpp, ring.hpp.
///
/// Coolant: its properties at its mean temperature, ṁ = ρ(T_in) cFlowRate. Elements meet it with
///   V = √((ω_c - ω_1)² d_m²/4 + U²),  U = flow over the annulus between cage and raceways
///   [choice],
/// all around: N π D² of balls, N (π D L + π D²/2) of rollers; the cage with both its cylinders.
/// Shaft and housing are as wide as their races [choice]. A solid shaft gets a bore of 1 % (N76).
/// Nothing cools the axis of a solid shaft: it takes no more heat than leaves it as warm as the
/// coldest that is known, of base temperature, room and coolant inlet; the rest goes by the
/// coolant, or without one by the outer race. Properties that depend on temperature are iterated to
/// 1e-6 K.
namespace adore::thermal {

struct Coolant {
  std::string name, provenance;
  double density = 0.0, viscosity = 0.0, specific_heat = 0.0,
         conductivity = 0.0;        ///< at its mean temperature
  double mass_flow = 0.0;           ///< [kg/s]
  double T_min = 0.0, T_max = 0.0;  ///< of its correlations; T_max 0: no limits known
  [[nodiscard]] bool outside(double T) const noexcept {
    return T_max > 0.0 && (T < T_min || T > T_max);
  }
};

/// What geometry and lubricant work with: one temperature for each part.
struct BulkTemperatures {
  std::array<double, 2> race{};
  double element = 0.0, cage = 0.0, housing = 0.0, shaft = 0.0, medium = 0.0;  ///< [K]

  [[nodiscard]] std::array<double, 7> list() const noexcept {
    return {race[0], race[1], element, cage, housing, shaft, medium};
  }
  [[nodiscard]] static BulkTemperatures of(const std::array<double, 7>& list) noexcept {
    return {{list[0], list[1]}, list[2], list[3], list[4], list[5], list[6]};
  }
  /// Those that the bearing has.
  [[nodiscard]] static BulkTemperatures in(const bearing::Bearing& bearing) noexcept;
  /// A bearing with these.
  void set(bearing::Bearing& bearing) const noexcept;
};
inline constexpr std::array<const char*, 7> kBulkNames{
    "outer race", "inner race", "elements", "cage", "housing", "shaft", "coolant"};

struct BearingHeat {
  HeatSources sources;
  NetworkTemperatures temperature;
  HeatFlows flows;
  NetworkRings rings;
  BulkTemperatures bulk;
  std::optional<Coolant> coolant;                          ///< empty: none, or it does not flow
  double element_convection = 0.0, cage_convection = 0.0;  ///< h [W/(m² K)]
  double element_area = 0.0, cage_area = 0.0;              ///< [m²]
  std::vector<std::string> notes;                          ///< extrapolations, whole sentences

  [[nodiscard]] double to_coolant() const noexcept { return coolant ? flows.coolant : 0.0; }
  /// Sources less what coolant, housing and shaft take [W]; rounding only.
  [[nodiscard]] double imbalance() const noexcept {
    return sources.total() - to_coolant() - flows.race[0] - flows.race[1];
  }
};

/// @param bearing with thermal inputs, as built or in operation; cage_speed its own or the
/// epicyclic
/// @throws InputError where flow or convection leave a part without any way for its heat
[[nodiscard]] BearingHeat solve_bearing_heat(const bearing::Bearing& bearing,
                                             const HeatSources& sources, double cage_speed);

/// What of a temperature field no bearing survives, in words; empty: none.
[[nodiscard]] std::string runaway(const BulkTemperatures& bulk);
/// Above it a field counts as running away [choice] [K].
inline constexpr double kHottest = 1000.0;

}  // namespace adore::thermal
