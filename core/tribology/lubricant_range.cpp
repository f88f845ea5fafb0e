#include "tribology/lubricant_range.hpp"

#include "base/errors.hpp"
#include "base/resources.hpp"
#include "tribology/lubricant.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <map>

namespace adore::tribology {
namespace {

using Json = nlohmann::json;

std::map<int, PressureRange> read() {
  std::map<int, PressureRange> out;
  const Json json = Json::parse(resources::get("lubricants.json"));
  for (const Json& entry : json.at("lubricants")) {
    if (!entry.contains("measuredTo")) continue;
    const Json& from = entry.at("measuredTo");
    PressureRange range;
    if (from.at("value").is_number()) range.measured_to = from.at("value").get<double>();
    range.provenance = from.at("provenance").get<std::string>();
    range.source =
        from.contains("note")
            ? from.at("note").get<std::string>()
            : json.at("sources").at(from.at("source").get<std::string>()).get<std::string>();
    out.emplace(static_cast<int>(entry.at("kTrac").get<double>()), std::move(range));
  }
  return out;
}

}  // namespace

const PressureRange& pressure_range(int code) {
  static const std::map<int, PressureRange> kRanges = read();
  const auto found = kRanges.find(lubricant(code).code);
  demand(found != kRanges.end(), "a lubricant of lubricants.json has no entry \"measuredTo\"");
  return found->second;
}

std::string extrapolation_note(const PressureRange& range, double pressure) {
  if (!range.measured_to) return "measured up to an unknown pressure";
  if (pressure <= *range.measured_to) return {};
  return fmt::format("extrapolated beyond {:g} GPa, the highest measured pressure{}",
                     1e-9 * *range.measured_to,
                     range.provenance == "seen" ? "" : " (not verified)");
}

}  // namespace adore::tribology
