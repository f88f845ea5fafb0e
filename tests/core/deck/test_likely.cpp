#include "deck/deck.hpp"
#include "deck/templates.hpp"
#include "deck/unit_change.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

using namespace adore;

namespace {

struct Slip {
  const char* deck;
  std::vector<std::pair<const char*, const char*>> sets;
  Severity severity;
  const char* variable;
  const char* said;
};

bool has(const std::vector<Issue>& issues, const Slip& slip) {
  for (const Issue& issue : issues)
    if (issue.severity == slip.severity && issue.variable == slip.variable &&
        issue.text().find(slip.said) != std::string::npos)
      return true;
  return false;
}

std::string all(const std::vector<Issue>& issues) {
  std::string out;
  for (const Issue& issue : issues) out += issue.text() + "\n";
  return out;
}

}  // namespace

TEST_CASE("check_likely_mistakes: probable slips → warning with the probable meaning", "[unit]") {
  const Severity warning = Severity::Warning;
  const std::vector<Slip> slips = {
      {"ball", {{"roomTemp", "20"}}, warning, "roomTemp", "for 20 deg C write 293.15 K"},
      {"ball", {{"raceTemp2", "80"}, {"shftTemp", "75"}}, warning, "shftTemp", "(also raceTemp2)"},
      {"ball", {{"raceTemp2", "80"}}, warning, "raceTemp2", "for 80 deg C write 353.15 K"},
      {"ball-english", {{"reTemp", "70"}}, warning, "reTemp", "for 70 deg F write 529.67 R"},
      {"ball", {{"gravityVecZ", "-9810"}}, warning, "gravityVecZ", "looks like gravity in mm/s^2"},
      {"ball", {{"gravityVecZ", "-1"}}, warning, "gravityVecZ", "units of g"},
      {"ball", {{"gravityVecX", "-32.2"}, {"gravityVecZ", "0"}}, warning, "gravityVecX", "ft/s^2"},
      {"ball", {{"gravityVecZ", "386"}}, warning, "gravityVecZ", "in/s^2"},
      {"ball", {{"gravityVecZ", "5000"}}, warning, "gravityVecZ", "times the gravity of Earth"},
      {"ball-english",
       {{"gravityVecZ", "-9.81"}},
       warning,
       "gravityVecZ",
       "the unit of this deck: 386"},
      {"ball", {{"freeConAng", "0.4363"}}, warning, "freeConAng", "for 0.4363 rad write 24.998"},
      {"tapered", {{"raceTaper2", "0.2"}}, warning, "raceTaper2", "for 0.2 rad write 11.4592"},
      {"ball", {{"appMis11", "0.5"}}, warning, "appMis11", "for 0.5 deg write 0.00872665"},
      {"ball", {{"kUnit", "2"}}, warning, "kUnit", "set kUnit to 1"},
      {"ball-english", {{"kUnit", "1"}}, warning, "kUnit", "set kUnit to 2"},
      {"ball", {{"appLoadX", "0"}, {"appLoadZ", "0"}}, warning, "appLoadX", "no load"},
      {"ball", {{"rpm2", "0"}}, warning, "rpm2", "no race rotates"},
      {"ball", {{"rpm1", "10000"}}, warning, "rpm2", "both races rotate at 10000 rpm"},
      {"deep-groove-6205", {{"rpm2", "0"}}, Severity::Note, "rpm2", "equilibrium at rest"},
  };
  for (const Slip& slip : slips) {
    deck::Deck deck = deck::new_deck(slip.deck);
    for (const auto& [name, value] : slip.sets) deck.set(name, value);
    const std::vector<Issue> issues = deck::check_deck(deck);
    INFO(slip.deck << " " << slip.sets.front().first << " = " << slip.sets.front().second << "\n"
                   << all(issues));
    CHECK(has(issues, slip));
  }
}

TEST_CASE("check_likely_mistakes: example decks in both unit systems → no warning", "[unit]") {
  for (const deck::TemplateInfo& info : deck::templates()) {
    deck::Deck deck = deck::new_deck(info.name);
    INFO(info.name << "\n" << all(deck::check_deck(deck)));
    CHECK(deck::check_deck(deck).empty());
    deck = deck::in_units(deck, deck::other_system(deck.units()));
    INFO("in the other units\n" << all(deck::check_deck(deck)));
    CHECK(deck::check_deck(deck).empty());
  }
}

TEST_CASE("check_likely_mistakes: bearing loaded by displacement → no warning", "[unit]") {
  const std::vector<std::vector<std::pair<const char*, const char*>>> loaded = {
      {{"kFS1", "1"}, {"appDispX", "1e-5"}},
      {{"kFS4", "0"}, {"appMomY", "2"}},
      {{"raceFit2", "1e-5"}},
      {{"raceTemp2", "320"}},
      {{"appMis11", "0.001"}},
      {{"freeConAng", "0"}, {"freeIntCls", "-1e-5"}}};
  for (const auto& sets : loaded) {
    deck::Deck deck = deck::new_deck("ball");
    deck.set("appLoadX", "0");
    deck.set("appLoadZ", "0");
    for (const auto& [name, value] : sets) deck.set(name, value);
    const std::vector<Issue> issues = deck::check_deck(deck);
    INFO(sets.front().first << "\n" << all(issues));
    CHECK(all(issues).find("no load") == std::string::npos);
  }
}

TEST_CASE("reader: number at the start of a comment → warning", "[unit]") {
  const std::string text(deck::template_text("ball"));
  const std::string line = "0.040, 0.080, 0.0, 0.110, 0.018, 0.018 ";
  REQUIRE(text.find(line) != std::string::npos);
  const auto with = [&](const std::string& other) {
    std::string changed = text;
    changed.replace(changed.find(line), line.size(), other);
    return deck::read_deck_text(changed, "DATA.txt");
  };
  // One width is missing, and the comment begins with a number.
  const deck::ReadResult slip = with("0.040, 0.080, 0.0, 0.110, 0.018   2 races, widths in m ");
  INFO(all(slip.issues));
  CHECK(has(slip.issues, {"", {}, Severity::Warning, "raceWidth2", "start of a comment"}));
  // A comma, blanks throughout, or no prose after it: meant.
  for (const char* meant :
       {"0.040, 0.080, 0.0, 0.110, 0.018,   0.018 ", "0.040 0.080  0.0 0.110   0.018  0.018 ",
        "0.040, 0.080, 0.0, 0.110, 0.018, 0.018   2 races "}) {
    const deck::ReadResult good = with(meant);
    INFO(meant << "\n" << all(good.issues));
    CHECK(good.issues.empty());
  }
}

TEST_CASE("reader: other files of the suite → error with their type", "[unit]") {
  const auto refusal = [](const std::string& text) {
    const auto path = std::filesystem::temp_directory_path() / "adore-no-deck";
    std::ofstream(path, std::ios::binary) << text;
    std::string said;
    try {
      (void)deck::read_deck(path);
    } catch (const InputError& error) {
      said = error.what();
    }
    std::filesystem::remove(path);
    return said;
  };
  CHECK(refusal("\fAdore 0.9.0         run\n").find("is a listing") != std::string::npos);
  CHECK(refusal("  Adore0.9.0       run\n  Rolling Element 1$\n").find("SOL1-SOL7") !=
        std::string::npos);
  CHECK(refusal("  Adore0.9.0       run\n   12  1  1  1  1  1  1  1  1  1  1  1  1  1\n")
            .find("SOL8") != std::string::npos);
  CHECK(refusal("Adore 0.9.0 FINAL: last\n").find("(file FINAL)") != std::string::npos);
  CHECK(refusal("{\n  \"program\": \"Adore 0.9.0\"").find("RUN.json") != std::string::npos);
  CHECK(refusal("{\"checkpointSeconds\": 2}").find("JSON") != std::string::npos);
  CHECK(refusal("rpm2 [rpm],exit,life,message\n1,0,2,\"\"\n").find("SWEEP.csv") !=
        std::string::npos);
  CHECK(refusal("\x89HDF\r\n\x1a\n").find("HDF5") != std::string::npos);
}
