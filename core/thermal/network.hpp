#pragma once

#include <array>

/// Steady temperatures of a bearing for given heat sources: shaft, races, elements, cage, housing
/// and coolant. SI, kelvin. Conduction is radial, R = ln(r_out/r_in)/(2π k w).
///
/// Heat sources are averages over a thermal step, shared out with e_re (of a race or flange contact
/// into the element), e_cage (of element/cage heat into the cage), e_land (of land heat into the
/// cage):
///   elements  Hb = e_re (Qo + Qi + Qf1 + Qf2) + (1 - e_cage) Qrc
///   cage      Hc = e_cage Qrc + e_land (Ql1 + Ql2)
///   outer     Ho = (1 - e_re)(Qo + Qf1) + (1 - e_land) Ql1,   inner likewise
///   coolant   Hb + Hc + Qchurn
namespace adore::thermal {

struct NetworkRing {
  double inner = 0.0, outer = 0.0, width = 0.0;  ///< radii, width [m]
  double conductivity = 0.0;                     ///< [W/(m K)]
  [[nodiscard]] double resistance() const;       ///< [K/W]
};

struct NetworkRings {
  NetworkRing outer, housing, inner, shaft;
};

struct HeatSources {
  std::array<double, 2> race{}, land{}, flange{};  ///< outer, inner [W]
  double element_cage = 0.0, churning = 0.0;
  [[nodiscard]] double total() const {
    return race[0] + race[1] + land[0] + land[1] + flange[0] + flange[1] + element_cage + churning;
  }
};

/// Shares [choice]: halves.
struct HeatSplit {
  double element = 0.5, cage = 0.5, land = 0.5;
};

struct HeatFlows {
  double element = 0.0, cage = 0.0, coolant = 0.0;  ///< Hb, Hc, into the coolant [W]
  std::array<double, 2> race{};                     ///< Ho, Hi
};
[[nodiscard]] HeatFlows share_out(const HeatSources& sources, const HeatSplit& split);

/// Which temperature is given (kBaseTemp).
enum class BaseNode : unsigned char {
  OuterInterface,  ///< outer race at the housing
  HousingOutside,
  CoolantOut,
  CoolantIn,
  InnerInterface,  ///< inner race at the shaft
  ShaftInside
};

struct NetworkTemperatures {
  double coolant_in = 0.0, coolant_mean = 0.0, coolant_out = 0.0;
  double element = 0.0, cage = 0.0;
  double outer_raceway = 0.0, outer_interface = 0.0, housing = 0.0;
  double inner_raceway = 0.0, inner_interface = 0.0, shaft = 0.0;
};

/// The ladder: with the flows fixed, one known temperature gives all (default; reproduces the
/// manual's single base) [choice].
///   T_out = T_in + H/(ṁ c_p), T_mean between; element and cage above it by Hb/(h A), Hc/(h A);
///   raceways follow the elements; rings fall by Ho R, Hi R towards housing and shaft.
/// Without coolant flow Hb + Hc + Qchurn goes to both races in halves, and all but the rings have
/// one temperature.
struct Ladder {
  NetworkRings rings;
  HeatFlows flows;
  double capacity_flow = 0.0;                  ///< ṁ c_p [W/K]
  double element_film = 0.0, cage_film = 0.0;  ///< h A [W/K]; > 0 with coolant
  BaseNode base = BaseNode::OuterInterface;
  double base_temperature = 0.0;  ///< [K]
  /// Of the inner race's heat, what cannot leave by the shaft: it goes by elements to the coolant,
  /// or, where none flows, by the outer race [W].
  double turned_back = 0.0;
};
struct LadderResult {
  NetworkTemperatures temperature;
  HeatFlows flows;  ///< as they then flow
};
[[nodiscard]] LadderResult solve_ladder(const Ladder& ladder);

/// The closed network: housing outside, shaft inside and coolant inlet given; elements and races
/// joined by contact conductances.
struct NodalNetwork {
  NetworkRings rings;
  HeatFlows flows;
  double churning = 0.0;                                ///< straight into the coolant [W]
  double capacity_flow = 0.0;                           ///< ṁ c_p [W/K]
  double element_film = 0.0, cage_film = 0.0;           ///< h A [W/K]
  std::array<double, 2> contact{};                      ///< element to outer, inner race [W/K]
  std::array<double, 2> race_film{};                    ///< h A of the raceways [W/K]
  double housing = 0.0, shaft = 0.0, coolant_in = 0.0;  ///< given [K]
};
struct NodalResult {
  NetworkTemperatures temperature;
  double to_coolant = 0.0, to_housing = 0.0, to_shaft = 0.0;  ///< [W]
};
/// @throws SolverError when a node hangs on nothing
[[nodiscard]] NodalResult solve_network(const NodalNetwork& network);

}  // namespace adore::thermal
