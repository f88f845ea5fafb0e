#include "thermal/too_cold.hpp"

#include <fmt/format.h>

#include <utility>

namespace adore::thermal {

std::string describe_too_cold_nodes(const BearingHeat& heat) {
  const NetworkTemperatures& T = heat.temperature;
  const auto told = [](const char* node, double at) {
    return fmt::format("{} would be at {:.4g} K, which is not above absolute zero", node, at);
  };
  if (heat.coolant && !(T.coolant_in > 0.0))
    return told("the coolant inlet", T.coolant_in) +
           fmt::format(": a heat of {:.4g} W increases the coolant temperature by {:.4g} K",
                       heat.flows.coolant, T.coolant_out - T.coolant_in);
  for (const auto& [node, at] : {std::pair{"the outer race at the housing", T.outer_interface},
                                 std::pair{"the outside of the housing", T.housing},
                                 std::pair{"the inner race at the shaft", T.inner_interface},
                                 std::pair{"the inside of the shaft", T.shaft},
                                 std::pair{"the coolant exit", T.coolant_out}})
    if (!(at > 0.0)) return told(node, at);
  return {};
}

}  // namespace adore::thermal
