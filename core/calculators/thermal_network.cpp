#include "base/errors.hpp"
#include "calculators/json_access.hpp"
#include "calculators/thermal.hpp"
#include "thermal/convection.hpp"
#include "thermal/network.hpp"
#include "thermal/steps.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace adore::calculators {
namespace {

using namespace thermal;

NetworkRing ring(const Json& in) {
  const NetworkRing out{get(in, "r_in"), get(in, "r_out"), get(in, "w"), get(in, "k")};
  require(out.outer > out.inner,
          fmt::format("r_out = {} m must be larger than r_in = {} m. Enter a larger outer radius.",
                      out.outer, out.inner));
  return out;
}

NetworkRings rings(const Json& in) {
  return {ring(in.at("outer")), ring(in.at("housing")), ring(in.at("inner")), ring(in.at("shaft"))};
}

HeatSources sources(const Json& in) {
  HeatSources out;
  out.race = {in.value("outer", 0.0), in.value("inner", 0.0)};
  out.land = {in.value("land1", 0.0), in.value("land2", 0.0)};
  out.flange = {in.value("flange1", 0.0), in.value("flange2", 0.0)};
  out.element_cage = in.value("re_cage", 0.0);
  out.churning = in.value("churn", 0.0);
  return out;
}

HeatSplit split(const Json& in) {
  return {get(in, "eta_re"), get(in, "eta_cage"), get(in, "eta_land")};
}

Json temperatures(const NetworkTemperatures& T) {
  return {{"coolant_in", T.coolant_in},
          {"coolant_mean", T.coolant_mean},
          {"coolant_out", T.coolant_out},
          {"re", T.element},
          {"cage", T.cage},
          {"outer_raceway", T.outer_raceway},
          {"inner_raceway", T.inner_raceway},
          {"outer_housing_interface", T.outer_interface},
          {"housing_od", T.housing},
          {"inner_shaft_interface", T.inner_interface},
          {"shaft_id", T.shaft}};
}

Json ladder_case(const Json& in) {
  Ladder ladder;
  ladder.rings = rings(in.at("rings"));
  const HeatSources heat = sources(in.at("heat"));
  ladder.flows = split_heat_sources(heat, split(in.at("split")));
  const Json& coolant = in.at("coolant");
  ladder.capacity_flow = get(coolant, "rho") * get(coolant, "cp") * get(coolant, "flow");
  ladder.element_film = get(in, "h_re") * get(in, "area_re");
  ladder.cage_film = get(in, "h_cage") * get(in, "area_cage");
  constexpr int kLastBase = 5;
  ladder.base = static_cast<BaseNode>(whole(in, "kBaseTemp", 0, kLastBase));
  ladder.base_temperature = get(in, "base_temp");
  const LadderResult result = solve_ladder(ladder);
  return {{"resistances",
           {{"outer", ladder.rings.outer.resistance()},
            {"housing", ladder.rings.housing.resistance()},
            {"inner", ladder.rings.inner.resistance()},
            {"shaft", ladder.rings.shaft.resistance()}}},
          {"temperatures", temperatures(result.temperature)},
          {"heat",
           {{"total", heat.total()},
            {"coolant", result.flows.coolant},
            {"outer_race", result.flows.race[0]},
            {"inner_race", result.flows.race[1]},
            {"re", result.flows.element},
            {"cage", result.flows.cage}}}};
}

Json nodal_case(const Json& in) {
  NodalNetwork network;
  network.rings = rings(in.at("rings"));
  const HeatSources heat = sources(in.at("heat"));
  network.flows = split_heat_sources(heat, split(in.at("split")));
  network.churning = heat.churning;
  network.capacity_flow = get(in, "mdot_cp");
  network.element_film = get(in, "hA_re");
  network.cage_film = get(in, "hA_cage");
  network.contact = {get(in, "G_re_outer"), get(in, "G_re_inner")};
  network.race_film = {get(in, "hA_outer"), get(in, "hA_inner")};
  const Json& fixed = in.at("fixed");
  network.housing = get(fixed, "housing_od");
  network.shaft = get(fixed, "shaft_id");
  network.coolant_in = get(fixed, "coolant_in");
  const NodalResult result = solve_nodal_network(network);
  return {{"temperatures", temperatures(result.temperature)},
          {"heat",
           {{"coolant", result.heat_to_coolant},
            {"housing", result.to_housing},
            {"shaft", result.to_shaft},
            {"total", heat.total()}}}};
}

std::optional<Json> convection_case(const Json& in) {
  const Json& f = in.at("fluid");
  const ConvectionFluid fluid{get(f, "rho"), get(f, "mu"), get(f, "cp"), get(f, "k")};
  const double diameter = get(in, "diameter"), speed = get(in, "speed");
  const std::string shape = in.at("shape");
  if (shape == "sphere") return Json{{"h", sphere_convection(fluid, diameter, speed)}};
  if (shape == "cylinder") return Json{{"h", cylinder_convection(fluid, diameter, speed)}};
  if (shape == "rotating_ring") return Json{{"h", ring_convection(fluid, diameter, speed)}};
  return std::nullopt;
}

std::optional<Json> network_case(const Json& the_case) {
  const std::string what = kind(the_case);
  const Json& in = the_case.at("inputs");
  if (what == "ladder_network") return ladder_case(in);
  if (what == "nodal_network") return nodal_case(in);
  if (what == "convection") return convection_case(in);
  return std::nullopt;
}

Json windows_case(const Json& in) {
  constexpr int kMostSteps = 1'000'000;
  HeatWindow window(get(in, "aveTime"), get(in, "skipTime"), whole(in, "kGeoMod", 0, kMostSteps));
  const Json &times = in.at("end_times"), &steps = in.at("step_sizes"), &heat = in.at("heat");
  Json closed = Json::array();
  for (std::size_t i = 0; i < times.size(); ++i)
    if (const auto one =
            window.add(times[i].get<double>(), steps[i].get<double>(), heat[i].get<double>()))
      closed.push_back({{"step", one->step},
                        {"time", one->time},
                        {"average_heat", one->average_heat},
                        {"geometry_update", one->geometry_update}});
  return {{"steps", std::move(closed)}};
}

Json sequence_case(const Json& in) {
  constexpr int kMostSteps = 1'000'000;
  ThermalStepCriteria rules;
  rules.tolerance = get(in, "tol");
  rules.converged = whole(in, "n_converged", 1, kMostSteps);
  rules.divergent = whole(in, "n_divergent", 1, kMostSteps);
  if (in.contains("limit") && !in.at("limit").is_null()) rules.limit = get(in, "limit");
  std::vector<std::vector<double>> temperatures;
  for (const Json& step : in.at("temperatures")) {
    std::vector<double>& nodes = temperatures.emplace_back();
    for (const Json& node : step) nodes.push_back(node.get<double>());
    if (nodes.size() != temperatures.front().size())
      throw InputError(
          "\"temperatures\" must contain one list for each step, and all lists must have the same "
          "length");
  }
  const ThermalStepAssessment result = assess_thermal_steps(temperatures, rules);
  constexpr const char* kNames[] = {"undecided", "stable", "divergent"};
  const auto maybe = [](const std::optional<double>& value) {
    return value ? Json(*value) : Json(nullptr);
  };
  return {{"classification", kNames[static_cast<std::size_t>(result.verdict)]},
          {"step", result.step},
          {"reason", result.reason},
          {"gain", maybe(result.gain)},
          {"aitken_limit_first_node", maybe(result.first_node_limit)}};
}

std::optional<Json> steps_case(const Json& the_case) {
  const std::string what = kind(the_case);
  const Json& in = the_case.at("inputs");
  if (what == "thermal_steps") return windows_case(in);
  if (what == "step_sequence") return sequence_case(in);
  return std::nullopt;
}

}  // namespace

std::vector<Adapter> network_adapters() {
  return {{"thermal_network", network_case}, {"thermal_steps", steps_case}};
}

}  // namespace adore::calculators
