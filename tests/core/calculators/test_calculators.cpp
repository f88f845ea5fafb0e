#include "base/errors.hpp"
#include "calculators/calculator_description.hpp"
#include "calculators/calculators.hpp"
#include "support/bytes.hpp"
#include "support/paths.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

using namespace adore;
using namespace adore::calculators;

namespace {

using Json = nlohmann::json;

void collect_numbers(Json& value, std::vector<Json*>& out) {
  if (value.is_number()) out.push_back(&value);
  if (value.is_structured())
    for (Json& item : value) collect_numbers(item, out);
}

/// Paths of the numbers in a result that have no unit: none under "units", no "unit" beside them,
/// none in their name.
void collect_bare(const Json& value, const std::string& path, const Json& units,
                  std::vector<std::string>& out) {
  if (value.is_object()) {
    for (const auto& [key, item] : value.items()) {
      const bool named = value.contains("unit") || key.ends_with("_K");
      if (!(named && (item.is_number() || item.is_array())))
        collect_bare(item, path.empty() ? key : path + "." + key, units, out);
    }
  } else if (value.is_array()) {
    for (const Json& item : value) collect_bare(item, path + "[]", units, out);
  } else if (value.is_number() && !units.contains(path)) {
    out.push_back(path);
  }
}
std::vector<std::string> without_unit(Json result) {
  std::vector<std::string> out;
  if (!result.is_object()) return out;
  const Json units = result.value("units", Json::object());
  result.erase("units");
  collect_bare(result, "", units, out);
  return out;
}

}  // namespace

TEST_CASE("calculators: any value of any number → results with units, or an error message",
          "[unit][calc]") {
  int refused = 0, computed = 0;
  for (const CalculatorInfo& info : calculator_list()) {
    const nlohmann::ordered_json described = describe_calculator(info);
    for (const auto& one : described.at("calculations")) {
      const Json example = Json::parse(one.at("example").dump());
      CAPTURE(info.name, example.dump());
      CHECK(without_unit(calculate(info.name, example)) == std::vector<std::string>());
      Json changed = example;
      std::vector<Json*> numbers;
      collect_numbers(changed, numbers);
      if (numbers.size() > 12) numbers.resize(12);  // the rest are more of the same lists
      for (Json* number : numbers) {
        const Json kept = *number;
        for (const Json& value : {Json(-1), Json(0), Json(3), Json(12), Json(1000000), Json(1e18),
                                  Json(-1e308), Json(nullptr)}) {
          *number = value;
          CAPTURE(changed.dump());
          try {
            const Json result = calculate(info.name, changed);
            ++computed;
            CHECK(without_unit(result) == std::vector<std::string>());
          } catch (const InputError& error) {
            CHECK(std::string(error.what()).find("bug") == std::string::npos);
            ++refused;
          } catch (const SolverError&) {
            ++refused;
          }
        }
        *number = kept;
      }
    }
  }
  CHECK(refused > 200);
  CHECK(computed > 200);
}

TEST_CASE("calculator adapters: every integer is read with its range", "[unit][calc]") {
  int seen = 0;
  for (const char* folder : {"core/calculators", "core/validation"})
    for (const auto& entry :
         std::filesystem::directory_iterator(adore::test::source_dir() / folder)) {
      if (entry.path().extension() != ".cpp") continue;
      ++seen;
      const std::string text = adore::test::bytes_of(entry.path());
      CAPTURE(entry.path().string());
      for (const char* way :
           {"get<int>", "get<long", "get<unsigned", "get<std::size_t>", "get<std::int"})
        CHECK(text.find(way) == std::string::npos);
    }
  CHECK(seen > 20);
}

TEST_CASE("calc iso281: output names the contact angle of the equivalent load", "[unit][calc]") {
  for (const double degrees : {0.0, 5.0, 10.0, 14.99, 15.0, 25.0}) {
    const Json out = Json::parse(calculate("iso281", {{"bearing", "radial_ball"},
                                                      {"Dw", 12.7},
                                                      {"Dpw", 60.0},
                                                      {"Z", 12},
                                                      {"alpha_deg", degrees},
                                                      {"Fr", 100.0},
                                                      {"Fa", 500.0}})
                                     .dump());
    CAPTURE(degrees, out.dump());
    REQUIRE(out.dump().find("\"P\"") != std::string::npos);
    CHECK(without_unit(out) == std::vector<std::string>());
    CHECK((out.dump().find("\"rated_at_deg\"") != std::string::npos) ==
          (degrees > 0.0 && degrees < 15.0));
  }
}
