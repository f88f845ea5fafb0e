#include "deck/difference.hpp"
#include "deck/lookup.hpp"
#include "deck/number.hpp"
#include "deck/templates.hpp"
#include "deck/unit_change.hpp"
#include "deck/units.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <random>

using namespace adore::deck;

namespace {

const Difference* find(const std::vector<Difference>& list, const std::string& variable) {
  const auto found = std::find_if(list.begin(), list.end(),
                                  [&](const Difference& d) { return d.variable == variable; });
  return found == list.end() ? nullptr : &*found;
}

}  // namespace

TEST_CASE("difference: equal decks with different file names → none", "[unit][deck]") {
  for (const TemplateInfo& info : templates()) {
    Deck other = new_deck(info.name);
    other.file = "elsewhere.txt";
    CHECK(differences(new_deck(info.name), other).empty());
  }
}

TEST_CASE("difference: numbers, codes, texts, array elements → sentences", "[unit][deck]") {
  const Deck left = new_deck("ball");
  Deck right = left;
  right.set("pitchDia", "0.0606");
  right.set("kPltFreq", "7");
  right.set("intMet", "21");
  right.set("runID", "another name");
  right.set("cageGsCls[2]", "6e-4");
  right.set("iCageGuide[2]", "2");
  right.user_lines = {"1.0 2.0"};
  const auto list = differences(left, right);
  CHECK(list.size() == 7);
  const auto sentence = [&](const std::string& variable) {
    const Difference* d = find(list, variable);
    REQUIRE(d != nullptr);
    return d->sentence;
  };
  CHECK(sentence("pitchDia") == "pitchDia: 0.06 m here, 0.0606 m there (1 % more)");
  CHECK(sentence("intMet") ==
        "intMet: 5 (explicit, order 5) here, 21 (CVODE Adams (extension)) there");
  CHECK(sentence("kPltFreq").find("7 (every n-th step) there") != std::string::npos);
  CHECK(sentence("runID").find("'another name' there") != std::string::npos);
  CHECK(sentence("cageGsCls") == "cageGsCls[2]: 3.0e-04 m here, 6.0e-04 m there (100 % more)");
  CHECK(find(list, "cageGsCls")->instance == 2);
  CHECK(find(list, "iCageGuide")->index == 2);
  CHECK(list.back().sentence == "input line 1 of user routines: none here, \"1.0 2.0\" there");
  CHECK(differences(right, left).size() == list.size());
}

TEST_CASE("difference: record in only one deck → one difference", "[unit][deck]") {
  const Deck left = new_deck("ball");
  Deck right = left;
  right.set("nCseg", "0");
  right.complete();
  const auto list = differences(left, right);
  std::vector<std::string> only_here, only_there;
  for (const Difference& d : list)
    if (d.variable.empty()) (d.in_left ? only_here : only_there).push_back(d.record);
  CHECK(only_here ==
        std::vector<std::string>{"7.0", "7.1", "7.2.i", "7.2.i", "9.6", "10.5.1D", "10.5.2D"});
  CHECK(only_there == std::vector<std::string>{"10.5.3D"});
  REQUIRE(find(list, "nCseg") != nullptr);
  CHECK(find(list, "nCseg")->sentence == "nCseg: 1 (one-piece cage) here, 0 (no cage) there");
}

TEST_CASE("difference: decks in different units → compared as quantities", "[unit][deck]") {
  const Deck left = new_deck("ball");
  Deck right = in_units(left, UnitSystem::English);
  CHECK(right.real("pitchDia") != left.real("pitchDia"));
  auto list = differences(left, right);
  REQUIRE(list.size() == 1);
  CHECK(list[0].variable == "kUnit");
  right.set("pitchDia", "2.4");
  list = differences(left, right);
  REQUIRE(list.size() == 2);
  CHECK(find(list, "pitchDia")->sentence ==
        "pitchDia: 0.06 m here, 2.4 in there, which is 0.06096 m (1.6 % more)");
}

TEST_CASE("unit change: quantities are kept, and changing back gives an equal deck",
          "[unit][deck]") {
  for (const TemplateInfo& info : templates()) {
    INFO(info.name);
    // The English example holds all digits of converted numbers, which nobody types.
    const Deck deck = in_units(new_deck(info.name), UnitSystem::SI);
    const Deck other = in_units(deck, UnitSystem::English);
    CHECK(other.units() != deck.units());
    CHECK(in_units(other, deck.units()) == deck);
    CHECK(in_units(deck, deck.units()) == deck);
    for (const RecordData& record : deck.records) {
      const RecordSpec& spec = *find_record(record.id);
      for (std::size_t v = 0; v < spec.variables.size(); ++v) {
        if (spec.variables[v].type != VarType::Real) continue;
        for (int k = 1; k <= static_cast<int>(record.values[v].size()); ++k) {
          const std::string name(spec.variables[v].name);
          INFO(name);
          // Twelve digits: 5e-12 relative, and the rounding of two products.
          CHECK(other.si(name, record.instance, k) ==
                Approx(deck.si(name, record.instance, k)).epsilon(6e-12));
        }
      }
    }
    CHECK(read_deck_text(write_deck(other), "DATA.txt").deck == other);
  }
}

TEST_CASE("unit change: numbers of up to fifteen digits → reproduced after changing back",
          "[unit][deck]") {
  std::mt19937_64 random(7);
  const UnitPair pairs[] = {unit::kLength, unit::kInertia,     unit::kStress,     unit::kDensity,
                            unit::kForce,  unit::kTemperature, unit::kConvection, unit::kViscosity};
  const auto SI = UnitSystem::SI, english = UnitSystem::English;
  int failed = 0, long_numbers = 0;
  for (int i = 0; i < 40000; ++i) {
    const UnitPair& pair = pairs[random() % 8];
    const int digits = 1 + static_cast<int>(random() % 15);
    std::string text = std::to_string(1 + random() % 9);
    for (int d = 1; d < digits; ++d) text += std::to_string(random() % 10);
    text += "e" + std::to_string(static_cast<int>(random() % 24) - 12 - digits);
    double value = 0.0;
    REQUIRE_FALSE(parse_real(text, value));
    const double there = convert_value(value, pair, SI, english);
    INFO(text << " " << pair.si << " is " << format_real(there));
    if (convert_value(there, pair, english, SI) != value) ++failed;
    if (digits <= 9 && format_real(there).size() > 18) ++long_numbers;
  }
  CHECK(failed == 0);
  CHECK(long_numbers == 0);
  CHECK(convert_value(1.0, unit::kLength, english, SI) == 0.0254);
  CHECK(convert_value(0.0254, unit::kLength, SI, english) == 1.0);
  CHECK(convert_value(0.06, unit::kLength, SI, english) == 2.36220472441);
  CHECK(convert_value(293.15, unit::kTemperature, SI, english) == 527.67);
  CHECK(convert_value(0.0, unit::kLength, SI, english) == 0.0);
  CHECK(convert_value(12.5, unit::kAngle, SI, english) == 12.5);
}
