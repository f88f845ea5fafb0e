#include "base/errors.hpp"
#include "deck/schema.hpp"
#include "tribology/lubricant.hpp"
#include "tribology/lubricant_range.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <string>
#include <string_view>

using namespace adore::tribology;

TEST_CASE("lubricants: each says to which pressure it was measured, or why that is not known",
          "[unit][lubricants]") {
  int known = 0;
  for (const int code : lubricant_codes()) {
    CAPTURE(code);
    const PressureRange& range = pressure_range(code);
    CHECK(range.source.size() > 20);
    if (!range.measured_to) {
      CHECK(range.provenance == "estimated");
      CHECK_THAT(extrapolation_note(range, 1e6), Catch::Contains("unknown pressure"));
      continue;
    }
    ++known;
    CHECK((range.provenance == "seen" || range.provenance == "recalled"));
    CHECK(*range.measured_to >= 0.5e9);
    CHECK(*range.measured_to <= 4e9);
    CHECK(extrapolation_note(range, *range.measured_to).empty());
    CHECK_THAT(extrapolation_note(range, 1.01 * *range.measured_to),
               Catch::Contains(fmt::format("{:g} GPa", 1e-9 * *range.measured_to)));
    // No constant of a law: it does not lower the word for the lubricant's numbers.
    for (const LubricantSource& source : lubricant(code).sources)
      CHECK(source.quantity.find("measuredTo") == std::string::npos);
  }
  CHECK(known == 12);
  CHECK_THROWS_AS(pressure_range(9), adore::InputError);
}

TEST_CASE("lubricants: names that end at a pressure have it as their range", "[unit][lubricants]") {
  int named = 0;
  for (const int code : lubricant_codes()) {
    CAPTURE(code);
    const std::string& name = lubricant(code).name;
    std::string option;
    for (const adore::deck::OptionSpec& one : adore::deck::option_table("@lubricants"))
      if (std::string_view(one.code) == std::to_string(code)) option = one.meaning;
    REQUIRE_FALSE(option.empty());
    const std::string range =
        pressure_range(code).measured_to
            ? fmt::format("to {:g} GPa", 1e-9 * *pressure_range(code).measured_to)
            : "none";
    for (const std::string& text : {name, option}) {
      CAPTURE(text);
      if (text.find("GPa") == std::string::npos) continue;
      ++named;
      CHECK(text.find(range) != std::string::npos);
    }
  }
  CHECK(named == 6);  // 13, 15 and 17, in both lists
}
