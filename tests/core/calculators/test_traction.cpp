#include "calculators/traction.hpp"
#include "support/paths.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>

using adore::calculators::Adapter;
using adore::calculators::Json;

namespace {

Json read_family(const std::string& family) {
  std::ifstream file(adore::test::source_dir().string() + "/tests/reference/" + family + ".json");
  return Json::parse(file);
}

Adapter adapter_of(const std::string& family) {
  for (const Adapter& adapter : adore::calculators::traction_adapters()) {
    if (adapter.family == family) return adapter;
  }
  FAIL("no adapter for " << family);
  return {};
}

/// Allowed absolute error of the entries of one key, as tests/reference/tribology_README.md
/// explains: relative to the number itself, for arrays to the largest entry, or {"abs": value}.
double allowed(const Json& tolerance, const std::string& key, double largest) {
  const Json& rule = tolerance.is_number() ? tolerance : tolerance.at(key);
  return rule.is_number() ? rule.get<double>() * largest : rule.at("abs").get<double>();
}

void check_numbers(const Json& expected, const Json& value, const Json& tolerance,
                   const std::string& key) {
  if (expected.is_number()) {
    const double wanted = expected, got = value;
    INFO(key << " = " << got << " instead of " << wanted);
    CHECK(std::abs(got - wanted) <= allowed(tolerance, key, std::abs(wanted)));
    return;
  }
  REQUIRE(expected.is_array());
  REQUIRE(value.size() == expected.size());
  double largest = 0.0;
  for (const double wanted : expected) largest = std::max(largest, std::abs(wanted));
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const double wanted = expected[i], got = value[i];
    INFO(key << "[" << i << "] = " << got << " instead of " << wanted);
    CHECK(std::abs(got - wanted) <= allowed(tolerance, key, largest));
  }
}

void check_family(const std::string& family, std::size_t cases) {
  const Json file = read_family(family);
  REQUIRE(file.at("cases").size() == cases);
  const Adapter adapter = adapter_of(family);
  for (const Json& one : file.at("cases")) {
    INFO(one.at("id").get<std::string>());
    const auto result = adapter.run(one);
    REQUIRE(result.has_value());
    for (const auto& [key, expected] : one.at("expected").items()) {
      REQUIRE(result->contains(key));
      if (expected.is_string()) {
        CHECK(result->at(key) == expected);
      } else {
        check_numbers(expected, result->at(key), one.at("tolerance"), key);
      }
    }
  }
}

}  // namespace

TEST_CASE("reference: traction curves in their four prescriptions", "[validation]") {
  check_family("tribology_hypotheticalTraction", 13);
}

TEST_CASE("reference: invalid traction curves → error with reason", "[validation]") {
  const Adapter adapter = adapter_of("tribology_hypotheticalTraction");
  const Json result =
      adapter.run({{"inputs", {{"type", 1}, {"tc", {0.0, 0.04, 0.05, 0.1}}, {"slip", {0.1}}}}})
          .value();
  CHECK_THAT(result.at("message").get<std::string>(), Catch::Contains("must exceed"));
}

TEST_CASE("reference: traction over Hertz ellipses and strips", "[validation]") {
  check_family("tribology_hertzTraction", 23);
}

TEST_CASE("reference: unknown traction laws → not covered", "[validation]") {
  Json one = read_family("tribology_hertzTraction").at("cases").at(0);
  one["inputs"]["law"]["kind"] = "yasutomi";
  CHECK_FALSE(adapter_of("tribology_hertzTraction").run(one).has_value());
}

TEST_CASE("reference: traction at prescribed contact kinematics", "[validation]") {
  const Json file = read_family("dynamics_contact_traction");
  REQUIRE(file.at("cases").size() == 11);
  const Adapter adapter = adapter_of("dynamics_contact_traction");
  for (const Json& one : file.at("cases")) {
    INFO(one.at("id").get<std::string>());
    const Json result = adapter.run(one).value();
    const Json& tolerance = one.at("tolerance");
    const auto check = [&](const Json& expected, const Json& got) {
      for (const auto& [key, wanted] : expected.items()) {
        if (wanted.is_object()) continue;
        const double w = wanted, g = got.at(key);
        INFO(key << " = " << g << " instead of " << w);
        if (key == "heat") {
          CHECK(std::abs(g - w) <= tolerance.at("heat_relative").get<double>() * std::abs(w));
        } else {
          const char* group = key[0] == 'F'
                                  ? "force_absolute"
                                  : (key == "M_n" ? "moment_n_absolute" : "moment_c_t_absolute");
          CHECK(std::abs(g - w) <= tolerance.at(group).get<double>());
        }
      }
    };
    check(one.at("expected"), result);
    if (one.at("expected").contains("closed_form"))
      check(one.at("expected").at("closed_form"), result.at("closed_form"));
  }
}
