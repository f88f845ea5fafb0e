#include "bearing/rating_data.hpp"

#include "base/json_text.hpp"
#include "base/resources.hpp"

#include <nlohmann/json.hpp>

namespace adore::bearing {

const nlohmann::json& rating_data(std::string_view block) {
  static const nlohmann::json kData = parse_json(resources::get("ratings.json"), "ratings.json");
  return kData.at(std::string(block));
}

}  // namespace adore::bearing
