#pragma once

#include "thermal/contact_conductance.hpp"

#include <array>
#include <string>
#include <vector>

/// Steady temperatures of a bearing for given heat sources: shaft, races, elements, cage, housing
/// and coolant. SI, kelvin. Conduction is radial, R = ln(r_out/r_in)/(2π k w).
///
/// Heat sources are averages over a thermal step. The ladder shares them out with e_re (of a race
/// or flange contact into the element), e_cage (of element/cage heat into the cage), e_land (of
/// land heat into the cage):
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

/// Shares of the ladder and of the reference cases [choice]: halves.
struct HeatSplit {
  double element = 0.5, cage = 0.5, land = 0.5;
};

struct HeatFlows {
  double element = 0.0, cage = 0.0, coolant = 0.0;  ///< Hb, Hc, into the coolant [W]
  std::array<double, 2> race{};                     ///< Ho, Hi
};
[[nodiscard]] HeatFlows split_heat_sources(const HeatSources& sources, const HeatSplit& split);

/// Which temperature is given (kBaseTemp).
enum class BaseNode : signed char {
  None = -1,           ///< run option thermalBase=none
  OuterInterface = 0,  ///< outer race at the housing
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
  double housing_seat = 0.0, shaft_seat = 0.0;  ///< of housing and shaft at their races
};

/// The ladder (run option thermalModel=ladder; the manual's single base): with the flows fixed, one
/// known temperature gives all [choice].
///   T_out = T_in + H/(ṁ c_p), T_mean between; element and cage above it by Hb/(h A), Hc/(h A);
///   raceways follow the elements; rings fall by Ho R, Hi R towards housing and shaft.
/// Without coolant flow Hb + Hc + Qchurn goes to both races in halves, and all but the rings have
/// one temperature.
/// It has no sinks and no balance: both raceways share one temperature, and a flow that its ring
/// cannot pass on makes nodes colder than everything around them. solve_guarded_ladder prevents the
/// latter.
struct Ladder {
  NetworkRings rings;
  HeatFlows flows;
  double capacity_flow = 0.0;                  ///< ṁ c_p [W/K]
  double element_film = 0.0, cage_film = 0.0;  ///< h A [W/K]; > 0 with coolant
  BaseNode base = BaseNode::OuterInterface;
  double base_temperature = 0.0;  ///< [K]
  /// Heat of each race that cannot leave through its ring: it goes by the elements to the coolant,
  /// or, where none flows, by the other race [W].
  std::array<double, 2> turned_back{};
};
struct LadderResult {
  NetworkTemperatures temperature;
  HeatFlows flows;  ///< as they then flow
  std::array<double, 2> turned_back{};
  bool clamped = false;  ///< nodes of a ring are held at the coldest given temperature
};
[[nodiscard]] LadderResult solve_ladder(const Ladder& ladder);
/// The same, with no ring, housing or shaft colder than the coldest of base temperature, room and
/// coolant inlet: the heat that would make them so is turned back; where nothing else can take it
/// (no coolant, base on that side), they are held at that temperature.
/// @param room [K]; 0: not known
[[nodiscard]] LadderResult solve_guarded_ladder(Ladder ladder, double room);

/// The network of a bearing (theory/thermal.md 6.5). Nodes: shaft inside and at the ring, inner
/// ring at the shaft, inner raceway, elements, cage, outer raceway, outer ring at the housing,
/// housing at the ring and outside, the oil or air in the bearing, and one film for all contacts
/// with each race, flanges of each race, pockets, and lands at each race.
/// Links: radial conduction, fits, contacts (contact_conductance.hpp), convection to the medium.
/// Boundaries: ambient, coolant inlet, and the place whose temperature the deck gives (kBaseTemp).
/// Sources: contact heat in its film; churning in the medium. The network decides which body takes
/// it.
/// Coolant: the flow passes bodies of mean temperature T* with ṁ c_p dT = h A (T* - T), so that
///   Q = ṁ c_p (1 - e^-N) (T* - T_in), N = Σ h A/(ṁ c_p);
///   with the mean along the flow as node, Q = G_in (T_mean - T_in),
///   G_in = ṁ c_p (1 - e^-N)/(1 - (1 - e^-N)/N), from 2 ṁ c_p (N -> 0) to ṁ c_p (N -> ∞), and
///   T_out = T_in + Q/(ṁ c_p) is between T_mean and T* [derived].
/// Where the exit is given (kBaseTemp 2) the inlet follows: T_out is linear in T_in.
struct BearingNetwork {
  NetworkRings rings;
  HeatSources sources;
  std::array<double, 2> joint{};               ///< ring to housing, to shaft [W/K]
  std::array<double, 2> to_ambient{};          ///< housing outside, shaft at the ring [W/K]
  double ambient = 0.0;                        ///< [K]
  std::array<FilmConductance, 2> race{};       ///< element, race
  std::array<FilmConductance, 2> flange{};     ///< element, race
  std::array<FilmConductance, 2> land{};       ///< cage, race
  FilmConductance pocket;                      ///< element, cage
  double element_film = 0.0, cage_film = 0.0;  ///< h A to the medium [W/K]
  std::array<double, 2> race_film{};           ///< of the raceways [W/K]
  double capacity_flow = 0.0;                  ///< ṁ c_p; 0: nothing flows [W/K]
  double coolant_in = 0.0;                     ///< [K]; not for BaseNode::CoolantOut
  BaseNode base = BaseNode::OuterInterface;
  double base_temperature = 0.0;  ///< [K]
  bool cage = false;
  /// Heat capacities [J/K], for steps in time: each race, housing and shaft in halves at both of
  /// their surfaces.
  struct HeatCapacities {
    std::array<double, 2> race{}, mate{};
    double element = 0.0, cage = 0.0;
  };
  HeatCapacities capacity;
};
/// A step in time of a network with heat capacities.
struct TransientStep {
  std::vector<double> before;  ///< by node; empty: from `start`
  NetworkTemperatures start;   ///< of the parts before the first step [K]
  double duration = 0.0;       ///< [s]
};
struct NodeTemperature {
  std::string name;
  double temperature = 0.0;  ///< [K]
};
struct NodeFlow {
  std::string from, to;
  double heat = 0.0;  ///< [W], either sign
};
struct BearingNetworkResult {
  NetworkTemperatures temperature;
  HeatFlows flows;  ///< through both rings; of elements, cage and all into the coolant
  std::vector<NodeTemperature> nodes;
  std::vector<NodeFlow> links;
  std::vector<NodeFlow> leaving;  ///< to: what takes the heat, coolant, ambient or the base
  std::vector<double> state;      ///< temperature by node, for TransientStep::before [K]
  double stored = 0.0;            ///< heat that stays in the parts; 0: steady [W]
};
/// @throws InputError when heat of a node has no path out
/// @param step null: steady
[[nodiscard]] BearingNetworkResult solve_bearing_network(const BearingNetwork& network,
                                                         const TransientStep* step = nullptr);

/// The network of the reference cases (`adore calc thermal_network`): housing outside, shaft inside
/// and coolant inlet given; elements and races joined by contact conductances.
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
  double heat_to_coolant = 0.0, to_housing = 0.0, to_shaft = 0.0;  ///< [W]
};
/// @throws SolverError when a node is not connected
[[nodiscard]] NodalResult solve_nodal_network(const NodalNetwork& network);

}  // namespace adore::thermal
