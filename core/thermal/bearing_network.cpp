#include "base/errors.hpp"
#include "thermal/heat_network.hpp"
#include "thermal/network.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace adore::thermal {
namespace {

using Node = HeatNetwork::Node;

/// Parts without a wall between them [W/K] [choice].
constexpr double kTouching = 1e5;

double conduction(const NetworkRing& ring) {
  return ring.outer > ring.inner ? std::min(1.0 / ring.resistance(), kTouching) : kTouching;
}

constexpr std::array<const char*, 2> kRace{"outer", "inner"};

/// The network of one bearing with its nodes by role.
struct Assembly {
  HeatNetwork net;
  std::array<Node, 2> raceway{}, ring_seat{}, mate_seat{}, far{};  ///< outer, inner side
  Node element = 0, cage = 0, medium = 0, inlet = 0, ambient = 0;

  explicit Assembly(const BearingNetwork& n) {
    const HeatSources& q = n.sources;
    const BearingNetwork::HeatCapacities& C = n.capacity;
    element = net.add("rolling elements", 0.0, C.element);
    raceway = {net.add("outer raceway", 0.0, 0.5 * C.race[0]),
               net.add("inner raceway", 0.0, 0.5 * C.race[1])};
    ring_seat = {net.add("outer race at the housing", 0.0, 0.5 * C.race[0]),
                 net.add("inner race at the shaft", 0.0, 0.5 * C.race[1])};
    mate_seat = {net.add("housing at the outer race", 0.0, 0.5 * C.mate[0]),
                 net.add("shaft at the inner race", 0.0, 0.5 * C.mate[1])};
    far = {net.add("housing outside", 0.0, 0.5 * C.mate[0]),
           net.add("shaft inside", 0.0, 0.5 * C.mate[1])};
    const bool flows = n.capacity_flow > 0.0;
    medium = net.add(flows ? "coolant mean" : "medium in the bearing", q.churning);
    cage = n.cage ? net.add("cage", 0.0, C.cage) : element;
    ambient = net.add("ambient");
    net.fix_temperature(ambient, n.ambient);
    const std::array<const NetworkRing*, 2> ring{&n.rings.outer, &n.rings.inner},
        mate{&n.rings.housing, &n.rings.shaft};
    for (std::size_t j = 0; j < 2; ++j) {
      net.link(raceway[j], ring_seat[j], conduction(*ring[j]));
      net.link(ring_seat[j], mate_seat[j], n.joint[j]);
      net.link(mate_seat[j], far[j], conduction(*mate[j]));
      net.link(raceway[j], medium, n.race_film[j]);
      // The outside of the housing; the shaft along its axis.
      net.link(j == 0 ? far[0] : mate_seat[1], ambient, n.to_ambient[j]);
      film(fmt::format("film of the {} race", kRace[j]), q.race[j], element, raceway[j], n.race[j]);
      film(fmt::format("film of the flanges, {} race", kRace[j]), q.flange[j], element, raceway[j],
           n.flange[j]);
      film(fmt::format("film of the lands, {} race", kRace[j]), q.land[j], cage, raceway[j],
           n.land[j]);
    }
    net.link(element, medium, n.element_film);
    if (n.cage) {
      net.link(cage, medium, n.cage_film);
      film("film of the pockets", q.element_cage, element, cage, n.pocket);
    } else {
      net.add_heat(element, q.element_cage);
    }
    if (flows) {
      inlet = net.add("coolant inlet");
      const double hA =
          n.element_film + (n.cage ? n.cage_film : 0.0) + n.race_film[0] + n.race_film[1];
      net.link(medium, inlet, coolant_link(n.capacity_flow, hA));
    }
    fix_base(n);
  }

  /// Temperatures by node of parts that have one temperature each.
  [[nodiscard]] std::vector<double> start(const NetworkTemperatures& T) const {
    std::vector<double> out(net.size(), T.coolant_mean);
    out[element] = T.element;
    if (cage != element) out[cage] = T.cage;
    out[raceway[0]] = T.outer_raceway;
    out[ring_seat[0]] = T.outer_interface;
    out[mate_seat[0]] = T.housing_seat;
    out[far[0]] = T.housing;
    out[raceway[1]] = T.inner_raceway;
    out[ring_seat[1]] = T.inner_interface;
    out[mate_seat[1]] = T.shaft_seat;
    out[far[1]] = T.shaft;
    return out;
  }

  /// A source that two bodies share; without conductance, in halves.
  void film(std::string name, double heat, Node first, Node second, const FilmConductance& G) {
    if (G.first > 0.0 && G.second > 0.0) {
      const Node between = net.add(std::move(name), heat);
      net.link(between, first, G.first);
      net.link(between, second, G.second);
    } else {
      net.add_heat(first, 0.5 * heat);
      net.add_heat(second, 0.5 * heat);
    }
  }

  static double coolant_link(double capacity_flow, double hA) {
    const double N = hA / capacity_flow, share = N > 0.0 ? -std::expm1(-N) / N : 1.0;
    constexpr double kSeries = 1e-4;  // 1 - (1 - e^-N)/N = N/2 - N²/6
    const double rest = N > kSeries ? 1.0 - share : 0.5 * N - N * N / 6.0;
    return N > 0.0 ? capacity_flow * N * share / rest : 2.0 * capacity_flow;
  }

  void fix_base(const BearingNetwork& n) {
    switch (n.base) {
      case BaseNode::OuterInterface:
        return net.fix_temperature(ring_seat[0], n.base_temperature);
      case BaseNode::HousingOutside:
        return net.fix_temperature(far[0], n.base_temperature);
      case BaseNode::InnerInterface:
        return net.fix_temperature(ring_seat[1], n.base_temperature);
      case BaseNode::ShaftInside:
        return net.fix_temperature(far[1], n.base_temperature);
      case BaseNode::None:
      case BaseNode::CoolantIn:
      case BaseNode::CoolantOut:
        return;
    }
  }
};

/// Heat from `from` to `to` over the links between them.
double heat_between(const HeatNetwork::Solution& at, Node from, Node to) {
  double out = 0.0;
  for (const HeatNetwork::Flow& flow : at.flows) {
    if (flow.from == from && flow.to == to) out += flow.heat;
    if (flow.from == to && flow.to == from) out -= flow.heat;
  }
  return out;
}

}  // namespace

BearingNetworkResult solve_bearing_network(const BearingNetwork& n, const TransientStep* step) {
  Assembly a(n);
  std::vector<double> before;
  if (step != nullptr) before = step->before.empty() ? a.start(step->start) : step->before;
  const auto solve = [&] {
    return step == nullptr ? a.net.solve() : a.net.step(before, step->duration);
  };
  const bool flows = n.capacity_flow > 0.0;
  if (flows) a.net.fix_temperature(a.inlet, n.coolant_in);
  if (const std::string lost = a.net.find_unconnected_node(); !lost.empty())
    throw InputError(fmt::format(
        "thermal network: heat of {} has no path out of the bearing. Enter a coolant (kCoolant, "
        "cFlowRate), a base temperature at housing or shaft (kBaseTemp 0, 1, 4, 5), or a "
        "conductance to ambient above 0 (run options housingCooling, shaftCooling).",
        lost));
  double inlet = n.coolant_in;
  HeatNetwork::Solution at = solve();
  const auto exit_of = [&] { return inlet + at.taken[a.inlet] / n.capacity_flow; };
  if (flows && n.base == BaseNode::CoolantOut) {
    constexpr double kApart = 100.0;  // [K]
    const auto exit_with = [&](double given) {
      inlet = given;
      a.net.fix_temperature(a.inlet, inlet);
      at = solve();
      return exit_of();
    };
    const double low = exit_with(n.base_temperature - kApart), high = exit_with(n.base_temperature),
                 slope = (high - low) / kApart;
    exit_with(n.base_temperature - (high - n.base_temperature) / slope);
  }
  const std::vector<double>& T = at.temperature;
  BearingNetworkResult out;
  NetworkTemperatures& t = out.temperature;
  t.coolant_mean = T[a.medium];
  t.coolant_in = flows ? inlet : T[a.medium];
  t.coolant_out = flows ? exit_of() : T[a.medium];
  t.element = T[a.element];
  t.cage = T[a.cage];
  t.outer_raceway = T[a.raceway[0]];
  t.outer_interface = T[a.ring_seat[0]];
  t.housing_seat = T[a.mate_seat[0]];
  t.housing = T[a.far[0]];
  t.inner_raceway = T[a.raceway[1]];
  t.inner_interface = T[a.ring_seat[1]];
  t.shaft_seat = T[a.mate_seat[1]];
  t.shaft = T[a.far[1]];
  for (std::size_t j = 0; j < 2; ++j)
    out.flows.race[j] = heat_between(at, a.raceway[j], a.ring_seat[j]);
  if (flows) {
    out.flows.coolant = at.taken[a.inlet];
    out.flows.element = heat_between(at, a.element, a.medium);
    out.flows.cage = n.cage ? heat_between(at, a.cage, a.medium) : 0.0;
  }
  for (Node i = 0; i < a.net.size(); ++i) {
    out.nodes.push_back({a.net.name(i), T[i]});
    if (flows && i == a.inlet) out.nodes.push_back({"coolant exit", t.coolant_out});
    if (a.net.is_boundary(i))
      out.leaving.push_back(
          {"bearing", i == a.inlet && flows ? "coolant" : a.net.name(i), at.taken[i]});
  }
  out.stored = at.stored;
  out.state = std::move(at.temperature);
  for (const HeatNetwork::Flow& flow : at.flows)
    out.links.push_back({a.net.name(flow.from), a.net.name(flow.to), flow.heat});
  return out;
}

}  // namespace adore::thermal
