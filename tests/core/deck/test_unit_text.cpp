#include "deck/unit_text.hpp"
#include "support/bytes.hpp"
#include "support/paths.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>

using namespace adore::deck;

TEST_CASE("in_deck_units(): numbers of a message → units of its deck", "[unit][deck]") {
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

TEST_CASE("in_deck_units(): heat, viscosity and slopes of traction", "[unit][deck]") {
  const auto english = [](std::string_view text) {
    return message_in_units(text, UnitSystem::English);
  };
  CHECK(english("112.985 W") == "1000.002 in.lbf/s");
  CHECK(english("the 0.1129848 J that moved") == "the 0.9999997 in.lbf that moved");
  CHECK(english("0.0254 s/m, 6.895 Pa s. 1 kg m^2") ==
        "0.000645 s/in, 0.001 lbf.s/in^2. 3417.172 lbm.in^2");
  CHECK(english("3 W/m^2/K") == "0.00952 lbf.in/s/in^2/R");
  CHECK(english("3 N mean, 4 Pa seem") == "0.674 lbf mean, 0.00058 lbf/in^2 seem");
}

TEST_CASE("in_deck_units(): every SI unit in messages has an English unit", "[unit][deck]") {
  // What stands behind a placeholder and is made of SI units; s, rad and Hz are the same in both.
  const std::string base = "(?:m|mm|um|N|kN|K|Pa|kPa|MPa|GPa|W|kW|J|kg|s)(?:\\^[0-9])?";
  const std::regex written("\\{[^{}\"]*\\} ((?:N m|Pa s|kg m\\^2|1|" + base + ")(?:[/.]" + base +
                           ")*)(?![A-Za-z0-9_/^])");
  std::set<std::string> units;
  for (const char* folder : {"core", "cli", "adrinput"})
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(adore::test::source_dir() / folder)) {
      if (entry.path().extension() != ".cpp" && entry.path().extension() != ".hpp") continue;
      const std::string text = adore::test::bytes_of(entry.path());
      for (std::sregex_iterator at(text.begin(), text.end(), written), end; at != end; ++at)
        units.insert((*at)[1]);
    }
  CHECK(units.size() > 10);
  for (const std::string& unit : units) {
    if (unit == "s" || unit == "1") continue;
    INFO(unit);
    CHECK(message_in_units("2 " + unit, UnitSystem::English) != "2 " + unit);
  }
}
