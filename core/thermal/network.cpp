#include "thermal/network.hpp"

#include "base/errors.hpp"
#include "thermal/heat_network.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace adore::thermal {

double NetworkRing::resistance() const {
  return std::log(outer / inner) / (2.0 * std::numbers::pi * conductivity * width);
}

HeatFlows split_heat_sources(const HeatSources& q, const HeatSplit& split) {
  HeatFlows out;
  const double contacts = q.race[0] + q.race[1] + q.flange[0] + q.flange[1];
  out.element = split.element * contacts + (1.0 - split.cage) * q.element_cage;
  out.cage = split.cage * q.element_cage + split.land * (q.land[0] + q.land[1]);
  for (std::size_t j = 0; j < 2; ++j)
    out.race[j] =
        (1.0 - split.element) * (q.race[j] + q.flange[j]) + (1.0 - split.land) * q.land[j];
  out.coolant = out.element + out.cage + q.churning;
  return out;
}

LadderResult solve_ladder(const Ladder& ladder) {
  LadderResult out;
  out.turned_back = ladder.turned_back;
  HeatFlows& flow = out.flows = ladder.flows;
  NetworkTemperatures& T = out.temperature;  // over that of the coolant inlet, first
  const std::array<double, 2>& back = ladder.turned_back;
  for (std::size_t j = 0; j < 2; ++j) flow.race[j] -= back[j];
  if (ladder.capacity_flow > 0.0) {
    flow.element += back[0] + back[1];
    flow.coolant += back[0] + back[1];
    T.coolant_out = flow.coolant / ladder.capacity_flow;
    T.coolant_mean = 0.5 * T.coolant_out;
    T.element = T.coolant_mean + flow.element / ladder.element_film;
    T.cage = T.coolant_mean + flow.cage / ladder.cage_film;
  } else {
    for (std::size_t j = 0; j < 2; ++j) flow.race[j] += 0.5 * flow.coolant + back[1 - j];
    flow.element = flow.cage = flow.coolant = 0.0;
  }
  T.outer_raceway = T.inner_raceway = T.element;
  T.outer_interface = T.outer_raceway - flow.race[0] * ladder.rings.outer.resistance();
  T.housing = T.outer_interface - flow.race[0] * ladder.rings.housing.resistance();
  T.inner_interface = T.inner_raceway - flow.race[1] * ladder.rings.inner.resistance();
  T.shaft = T.inner_interface - flow.race[1] * ladder.rings.shaft.resistance();
  T.housing_seat = T.outer_interface;
  T.shaft_seat = T.inner_interface;
  const double known[] = {T.outer_interface, T.housing,         T.coolant_out,
                          T.coolant_in,      T.inner_interface, T.shaft};
  const double shift = ladder.base_temperature - known[static_cast<std::size_t>(ladder.base)];
  for (double* node : {&T.coolant_in, &T.coolant_mean, &T.coolant_out, &T.element, &T.cage,
                       &T.outer_raceway, &T.outer_interface, &T.housing, &T.inner_raceway,
                       &T.inner_interface, &T.shaft, &T.housing_seat, &T.shaft_seat})
    *node += shift;
  return out;
}

LadderResult solve_guarded_ladder(Ladder ladder, double room) {
  const auto coldest = [&](const NetworkTemperatures& T) {
    double out = ladder.base_temperature;
    if (room > 0.0) out = std::min(out, room);
    if (ladder.capacity_flow > 0.0) out = std::min(out, T.coolant_in);
    return out;
  };
  const auto too_cold = [&](std::size_t race, double back) {
    Ladder changed = ladder;
    changed.turned_back[race] = back;
    const NetworkTemperatures T = solve_ladder(changed).temperature;
    const double limit = coldest(T), node = race == 0 ? std::min(T.housing, T.outer_interface)
                                                      : std::min(T.shaft, T.inner_interface);
    return node < limit - 1e-9 * std::abs(limit);
  };
  const bool flows = ladder.capacity_flow > 0.0;
  for (const std::size_t race : {std::size_t{1}, std::size_t{0}}) {
    const bool holds_base = race == 0 ? ladder.base <= BaseNode::HousingOutside
                                      : ladder.base >= BaseNode::InnerInterface;
    if ((holds_base && !flows) || !too_cold(race, 0.0)) continue;
    double low = 0.0, high = solve_ladder(ladder).flows.race[race];
    constexpr int kHalvings = 60;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = 0.5 * (low + high);
      (too_cold(race, middle) ? low : high) = middle;
    }
    ladder.turned_back[race] = high;
  }
  LadderResult out = solve_ladder(ladder);
  NetworkTemperatures& T = out.temperature;
  const double limit = coldest(T);
  for (double* node : {&T.outer_interface, &T.housing, &T.inner_interface, &T.shaft,
                       &T.housing_seat, &T.shaft_seat})
    if (*node < limit - 1e-6) {
      *node = limit;
      out.clamped = true;
    }
  return out;
}

NodalResult solve_nodal_network(const NodalNetwork& n) {
  HeatNetwork net;
  const auto outer = net.add("outer raceway", n.flows.race[0]),
             outer_seat = net.add("outer race at the housing"),
             element = net.add("rolling elements", n.flows.element),
             cage = net.add("cage", n.flows.cage),
             inner = net.add("inner raceway", n.flows.race[1]),
             inner_seat = net.add("inner race at the shaft"),
             coolant = net.add("coolant", n.churning), housing = net.add("housing"),
             shaft = net.add("shaft"), inlet = net.add("coolant inlet");
  net.fix_temperature(housing, n.housing);
  net.fix_temperature(shaft, n.shaft);
  net.fix_temperature(inlet, n.coolant_in);
  net.link(outer, outer_seat, 1.0 / n.rings.outer.resistance());
  net.link(inner, inner_seat, 1.0 / n.rings.inner.resistance());
  net.link(outer_seat, housing, 1.0 / n.rings.housing.resistance());
  net.link(inner_seat, shaft, 1.0 / n.rings.shaft.resistance());
  net.link(element, outer, n.contact[0]);
  net.link(element, inner, n.contact[1]);
  net.link(element, coolant, n.element_film);
  net.link(cage, coolant, n.cage_film);
  net.link(outer, coolant, n.race_film[0]);
  net.link(inner, coolant, n.race_film[1]);
  net.link(coolant, inlet, 2.0 * n.capacity_flow);
  if (const std::string lost = net.find_unconnected_node(); !lost.empty())
    throw SolverError(
        fmt::format("thermal network: no link removes heat from {}. Enter a film or contact "
                    "conductance above 0.",
                    lost));
  const HeatNetwork::Solution at = net.solve();
  const std::vector<double>& T = at.temperature;
  NodalResult out;
  NetworkTemperatures& t = out.temperature;
  t.coolant_in = n.coolant_in;
  t.coolant_mean = T[coolant];
  t.coolant_out = n.capacity_flow > 0.0 ? 2.0 * T[coolant] - n.coolant_in : T[coolant];
  t.element = T[element];
  t.cage = T[cage];
  t.outer_raceway = T[outer];
  t.outer_interface = t.housing_seat = T[outer_seat];
  t.housing = n.housing;
  t.inner_raceway = T[inner];
  t.inner_interface = t.shaft_seat = T[inner_seat];
  t.shaft = n.shaft;
  out.heat_to_coolant = at.taken[inlet];
  out.to_housing = at.taken[housing];
  out.to_shaft = at.taken[shaft];
  return out;
}

}  // namespace adore::thermal
