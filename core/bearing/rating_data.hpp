#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string_view>

namespace adore::bearing {

/// Block of resources/ratings.json: data of ratings that no formula gives, with sources.
[[nodiscard]] const nlohmann::json& rating_data(std::string_view block);

}  // namespace adore::bearing
