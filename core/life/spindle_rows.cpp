#include "life/spindle_rows.hpp"

#include "base/resources.hpp"

#include <nlohmann/json.hpp>

namespace adore::life {

const SpindleRows& spindle_rows() {
  static const SpindleRows kRows = [] {
    const auto value = nlohmann::json::parse(resources::get("life_constants.json"))
                           .at("iso281")
                           .at("xye_15_degrees")
                           .at("value");
    return SpindleRows{value.at("X").get<double>(),
                       value.at("rows").get<std::vector<std::array<double, 3>>>()};
  }();
  return kRows;
}

}  // namespace adore::life
