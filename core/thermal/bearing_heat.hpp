#pragma once

#include "base/finding.hpp"
#include "bearing/bearing.hpp"
#include "thermal/network.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

/// The thermal network of a bearing with its surroundings (kTherm, records 3.5, 9.7, 9.8): from
/// heat sources to temperatures. SI, kelvin. Equations: network.hpp, contact_conductance.hpp,
/// convection.hpp, ring.hpp. Properties that depend on temperature are iterated to 1e-6 K.
///
/// Medium. A coolant that flows: its properties at its mean temperature, ṁ = ρ(T_in) cFlowRate.
/// Otherwise the lubricant, or air without one: it joins the parts and takes nothing away [choice].
/// Elements meet it with
///   V = √((ω_c - ω_1)² d_m²/4 + U²),  U = flow over the annulus between cage and raceways
///   [choice],
/// all around: N π D² of balls, N (π D L + π D²/2) of rollers; the cage with both its cylinders;
/// raceways with 2π r w, by the law of the cage at their speed against it [choice]. Given
/// coefficients (kHTC = 1): reHTC holds for the raceways, too [choice].
/// Fits: h = k_air/(3 σ + gap) + 1.25 k_s (m/σ) (p/H)^0.95, σ = 1.5 µm, m = 0.15, H = 2.5 GPa
/// [estimated], k_s the harmonic mean (Cooper, Mikic & Yovanovich 1969) [recalled, high]; gap and p
/// of the fit as it is (operating.hpp).
/// Ambient: temperature of the room. Housing (from its outside) and shaft (from the ring, along its
/// axis) give away together 320 W/(m² K) times the area of both seats A = π B (D + d): the
/// reference heat flow density of ISO 15312 for radial bearings, 16 kW/m² at 50 K, above 0.05 m²
/// times (A/0.05 m²)^-0.34 [recalled, high]; a seat of the shaft half as much as one of the housing
/// [choice: with equal shares inner rings would be 2 to 3 K hotter than outer ones, catalogues say
/// 5 to 15 K]. None for liquefied gases (kCoolant 3 to 7), whose machine is as cold as they are,
/// and none of the housing where kBaseTemp is a place on the shaft side (4, 5), which cools instead
/// [choice]. Run options ambientTemperature, housingCooling, shaftCooling.
/// Base: the place of kBaseTemp has the base temperature (run option thermalBase=none: no place
/// has; coolant and ambient are the only boundaries). Coolant inlet: base temperature where
/// kBaseTemp is 3, and where it is a place on the rings (run option coolantInlet) [choice].
/// Flanges, pockets and lands: patches of 1 % of the element's, of lands the land's diameter
/// [estimated]; one for each element, one for each land. An unloaded row touches its races with
/// such patches. The element slides under the pocket, the race under the land; pocket and cage
/// rest. Shaft and housing are as wide as their races [choice]. A solid shaft gets a bore of 1 %
/// (N76).
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

/// Temperatures of geometry and lubricant: one for each part.
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
  std::vector<NodeTemperature> nodes;                      ///< of the network or ladder
  std::vector<NodeFlow> links, leaving;    ///< between nodes; what leaves, and to what
  std::array<FilmConductance, 2> contact;  ///< of the race contacts; ladder: 0 [W/K]
  std::array<double, 2> to_ambient{};      ///< housing, shaft; ladder: 0 [W/K]
  std::vector<double> state;               ///< by node, for a further step in time
  double stored = 0.0;                     ///< heat that stays in the parts; 0: steady [W]
  std::array<double, 2> turned_back{};     ///< by the guard of the ladder [W]
  bool clamped = false;                    ///< likewise: nodes held at the coldest temperature
  std::vector<Finding> notes;              ///< thermal.ladder, thermal.coolant_range ...

  [[nodiscard]] double heat_to_coolant() const noexcept { return coolant ? flows.coolant : 0.0; }
  /// Sources less what leaves and what stays in the parts [W]; rounding only.
  [[nodiscard]] double imbalance() const noexcept {
    double out = sources.total() - stored;
    for (const NodeFlow& one : leaving) out -= one.heat;
    return out;
  }
};

/// A step in time; heat capacities ρ c times the volume of ring, shaft and housing walls as wide as
/// the rings, of elements and cage. Parts whose material has no specific heat get 460 J/(kg K)
/// [choice].
struct HeatStep {
  std::vector<double> before;  ///< BearingHeat::state; empty: the bearing's temperatures
  double duration = 0.0;       ///< [s]
};

/// @param bearing with thermal inputs, as built or in operation; cage_speed its own or the
/// epicyclic; contact conductances of the race contacts (race_conductance)
/// @param step in time, with heat capacities, from the bearing's temperatures or from `before`;
/// null: steady. Ladders have no capacities and stay steady.
/// @throws InputError where flow or convection leave a part without any way for its heat
[[nodiscard]] BearingHeat solve_bearing_heat(const bearing::Bearing& bearing,
                                             const HeatSources& sources, double cage_speed,
                                             const RaceConductance& contact = {},
                                             const HeatStep* step = nullptr);

/// Parts of a temperature field that no bearing survives, in words; empty: none.
[[nodiscard]] std::string describe_thermal_runaway(const BulkTemperatures& bulk);
/// The hottest node above kHottest, films included, in words; empty: none.
[[nodiscard]] std::string describe_overheated_node(const BearingHeat& heat);
/// Above it a field counts as running away [choice] [K].
inline constexpr double kHottest = 1000.0;

}  // namespace adore::thermal
