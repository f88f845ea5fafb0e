#include "deck/unit_text.hpp"

#include <catch2/catch.hpp>

using namespace adore::deck;

TEST_CASE("a message speaks in the units of its deck", "[unit][deck]") {
  const auto english = [](std::string_view text) {
    return message_in_units(text, UnitSystem::English);
  };
  const char* text = "the shaft of 0.0254 m takes 44.482216152605 N, kFS1 = 1, at 3 N m or 300 K.";
  CHECK(message_in_units(text, UnitSystem::SI) == text);
  CHECK(english(text) == "the shaft of 1 in takes 10 lbf, kFS1 = 1, at 26.6 lbf.in or 540 R.");
  CHECK(english("a stress of 1.234 MPa (limit 4.2 GPa).") ==
        "a stress of 179 lbf/in^2 (limit 609158.5 lbf/in^2).");
  CHECK(english("-2.5e-05 m or 12.7 mm, 25.4 um; at 2 m/s") ==
        "-0.000984 in or 0.5 in, 0.001 in; at 78.7 in/s");
  // Neither names with digits, nor other units, nor words that begin like one.
  const char* same = "ball 3 moves by 5 rad at 10 rpm in 2 s; 4 more, x2 m of 7 Nodes, 1.5 degrees";
  CHECK(english(same) == same);
  CHECK(english("(-1.68e+05 N/m), 2 N m/rad") == "(-959 lbf/in), 17.7 lbf.in/rad");
  CHECK(english("") == "");
  CHECK(english("0 m") == "0 in");
}
