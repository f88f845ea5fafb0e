#include "thermal/network.hpp"

#include "base/errors.hpp"

#include <Eigen/Dense>

#include <cmath>
#include <numbers>

namespace adore::thermal {

double NetworkRing::resistance() const {
  return std::log(outer / inner) / (2.0 * std::numbers::pi * conductivity * width);
}

HeatFlows share_out(const HeatSources& q, const HeatSplit& split) {
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
  HeatFlows& flow = out.flows = ladder.flows;
  NetworkTemperatures& T = out.temperature;  // over that of the coolant inlet, first
  flow.race[1] -= ladder.turned_back;
  if (ladder.capacity_flow > 0.0) {
    flow.element += ladder.turned_back;
    flow.coolant += ladder.turned_back;
    T.coolant_out = flow.coolant / ladder.capacity_flow;
    T.coolant_mean = 0.5 * T.coolant_out;
    T.element = T.coolant_mean + flow.element / ladder.element_film;
    T.cage = T.coolant_mean + flow.cage / ladder.cage_film;
  } else {
    for (double& race : flow.race) race += 0.5 * flow.coolant;
    flow.race[0] += ladder.turned_back;
    flow.element = flow.cage = flow.coolant = 0.0;
  }
  T.outer_raceway = T.inner_raceway = T.element;
  T.outer_interface = T.outer_raceway - flow.race[0] * ladder.rings.outer.resistance();
  T.housing = T.outer_interface - flow.race[0] * ladder.rings.housing.resistance();
  T.inner_interface = T.inner_raceway - flow.race[1] * ladder.rings.inner.resistance();
  T.shaft = T.inner_interface - flow.race[1] * ladder.rings.shaft.resistance();
  const double known[] = {T.outer_interface, T.housing,         T.coolant_out,
                          T.coolant_in,      T.inner_interface, T.shaft};
  const double shift = ladder.base_temperature - known[static_cast<std::size_t>(ladder.base)];
  for (double* node :
       {&T.coolant_in, &T.coolant_mean, &T.coolant_out, &T.element, &T.cage, &T.outer_raceway,
        &T.outer_interface, &T.housing, &T.inner_raceway, &T.inner_interface, &T.shaft})
    *node += shift;
  return out;
}

NodalResult solve_network(const NodalNetwork& n) {
  enum : int { kOuter, kOuterSeat, kElement, kCage, kInner, kInnerSeat, kCoolant, kNodes };
  Eigen::Matrix<double, kNodes, kNodes> G = Eigen::Matrix<double, kNodes, kNodes>::Zero();
  Eigen::Matrix<double, kNodes, 1> H;
  H << n.flows.race[0], 0.0, n.flows.element, n.flows.cage, n.flows.race[1], 0.0, n.churning;
  const auto link = [&](int a, int b, double conductance) {
    G(a, a) += conductance;
    G(b, b) += conductance;
    G(a, b) -= conductance;
    G(b, a) -= conductance;
  };
  const auto pin = [&](int a, double conductance, double temperature) {
    G(a, a) += conductance;
    H(a) += conductance * temperature;
  };
  const double to_housing = 1.0 / n.rings.housing.resistance(),
               to_shaft = 1.0 / n.rings.shaft.resistance();
  link(kOuter, kOuterSeat, 1.0 / n.rings.outer.resistance());
  link(kInner, kInnerSeat, 1.0 / n.rings.inner.resistance());
  pin(kOuterSeat, to_housing, n.housing);
  pin(kInnerSeat, to_shaft, n.shaft);
  link(kElement, kOuter, n.contact[0]);
  link(kElement, kInner, n.contact[1]);
  link(kElement, kCoolant, n.element_film);
  link(kCage, kCoolant, n.cage_film);
  link(kOuter, kCoolant, n.race_film[0]);
  link(kInner, kCoolant, n.race_film[1]);
  pin(kCoolant, 2.0 * n.capacity_flow, n.coolant_in);
  const Eigen::FullPivLU<Eigen::Matrix<double, kNodes, kNodes>> solver(G);
  if (!solver.isInvertible())
    throw SolverError(
        "thermal network: a node is joined to nothing that carries its heat away; give it a film "
        "or "
        "contact conductance above 0");
  const Eigen::Matrix<double, kNodes, 1> T = solver.solve(H);
  NodalResult out;
  out.temperature = {n.coolant_in,
                     T(kCoolant),
                     n.capacity_flow > 0.0 ? 2.0 * T(kCoolant) - n.coolant_in : T(kCoolant),
                     T(kElement),
                     T(kCage),
                     T(kOuter),
                     T(kOuterSeat),
                     n.housing,
                     T(kInner),
                     T(kInnerSeat),
                     n.shaft};
  out.to_coolant = 2.0 * n.capacity_flow * (T(kCoolant) - n.coolant_in);
  out.to_housing = to_housing * (T(kOuterSeat) - n.housing);
  out.to_shaft = to_shaft * (T(kInnerSeat) - n.shaft);
  return out;
}

}  // namespace adore::thermal
