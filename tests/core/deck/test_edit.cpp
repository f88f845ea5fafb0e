#include "base/errors.hpp"
#include "deck/deck.hpp"
#include "deck/defaults.hpp"
#include "deck/number.hpp"
#include "deck/templates.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

using namespace adore::deck;

namespace {

std::string failure(Deck deck, std::string_view name, std::string_view value) {
  const Deck before = deck;
  try {
    deck.set(name, value);
  } catch (const adore::InputError& error) {
    CHECK(deck.records == before.records);  // nothing half done
    return error.what();
  }
  return "no error";
}

}  // namespace

TEST_CASE("set(): changes one value by name, element or instance", "[unit][deck]") {
  Deck deck = new_deck("ball");
  deck.set("pitchDia", "0.061");
  CHECK(deck.real("pitchDia") == 0.061);
  deck.set("pitchDia", " 6.2d-2 ");
  CHECK(deck.real("pitchDia") == 0.062);
  deck.set("cageGsCls[2]", "4e-4");
  CHECK(deck.real("cageGsCls", 2) == 4e-4);
  CHECK(deck.real("cageGsCls", 1) == 3e-4);
  deck.set("iCageGuide[1]", "2");
  CHECK(deck.integer("iCageGuide", 1) == 2);
  CHECK(deck.integer("iCageGuide", 2) == 1);
  deck.set("iCageGuide", "1,0");
  CHECK(deck.integer("iCageGuide", 2) == 0);
  deck.set("cageGcPos[3]", "1e-5");
  CHECK(deck.real("cageGcPos", 1, 3) == 1e-5);
  deck.set("runID", "it's new");
  CHECK(deck.text("runID") == "it's new");
  deck.set("runID", "'it''s quoted'");
  CHECK(deck.text("runID") == "it's quoted");
}

TEST_CASE("set() and complete(): add the records that a changed option needs", "[unit][deck]") {
  Deck deck = new_deck("ball");
  deck.set("kDCR", "1");
  CHECK_FALSE(deck.has_record("2.2"));
  deck.set("kFD12", "0");  // the record is due, so that its variables can be set
  CHECK(deck.integer("kFD12") == 0);
  CHECK(deck.integer("kMD32") == 1);
  CHECK(deck.records[2].id == "2.2");
  deck.set("kTrac", "9");
  deck.complete();
  CHECK(deck.has_record("10.4.1"));
  CHECK_FALSE(deck.has_record("10.6"));
  deck.set("mode", "-1");
  deck.complete();
  CHECK_FALSE(deck.has_record("2.1"));
  CHECK_FALSE(deck.has_record("11"));

  Deck segmented = new_deck("ball");
  segmented.set("nCseg", "3");
  segmented.complete();
  CHECK(segmented.has_record("9.6.k", 3));
  CHECK_FALSE(segmented.has_record("9.6"));
  segmented.set("cageGcPos[2][3]", "1.5e-5");
  CHECK(segmented.real("cageGcPos", 2, 3) == 1.5e-5);
  CHECK_THAT(failure(segmented, "cageGcPos[4][1]", "0"),
             Catch::Contains("instance 4 of this record"));
  CHECK_THAT(failure(segmented, "wvRatio", "0"), Catch::Contains("wvRatio[1]"));

  Deck monitored = new_deck("ball");
  monitored.set("kNumPltElem", "5");
  monitored.set("kPltElemInd[5]", "14");
  CHECK(monitored.integer("kPltElemInd", 5) == 14);
  monitored.set("kNumPltElem", "2");
  monitored.complete();
  CHECK(monitored.integer("kPltElemInd", 3) == 0);
  CHECK(monitored.integer("kPltElemInd", 2) == 5);
}

TEST_CASE("complete(): complete deck → unchanged", "[unit][deck]") {
  for (const TemplateInfo& info : templates()) {
    Deck deck = new_deck(info.name);
    deck.complete();
    CHECK(deck == new_deck(info.name));
  }
}

TEST_CASE("set(): impossible change → error with the possible ones", "[unit][deck]") {
  const Deck deck = new_deck("ball");
  CHECK_THAT(failure(deck, "pichDia", "0.06"), Catch::Contains("did you mean pitchDia"));
  CHECK_THAT(failure(deck, "xyzzyplugh", "1"), Catch::Contains("adore schema"));
  CHECK_THAT(failure(deck, "recID", "'x'"), Catch::Contains("the name recID alone is ambiguous"));
  CHECK_THAT(failure(deck, "nRe", "12.0"), Catch::Contains("write 12"));
  CHECK_THAT(failure(deck, "nRe", "twelve"), Catch::Contains("nRe takes an integer"));
  CHECK_THAT(failure(deck, "pitchDia", "0,06"), Catch::Contains("is not a number"));
  CHECK_THAT(failure(deck, "pitchDia", "nan"), Catch::Contains("finite"));
  CHECK_THAT(failure(deck, "pitchDia[1]", "0.06"), Catch::Contains("single value"));
  CHECK_THAT(failure(deck, "iCageGuide[3]", "1"), Catch::Contains("2 elements"));
  CHECK_THAT(failure(deck, "iCageGuide", "1"), Catch::Contains("give 2 values"));
  CHECK_THAT(failure(new_deck("spherical"), "iCageGuide", "1"),
             Catch::Contains("this variable has no elements in this deck; first increase nGL"));
  CHECK_THAT(failure(deck, "cageGsCls", "1"), Catch::Contains("cageGsCls[1]"));
  CHECK_THAT(failure(deck, "cageGsCls[3]", "1"), Catch::Contains("instance 3 of this record"));
  CHECK_THAT(failure(deck, "cageGsCls[0]", "1"), Catch::Contains("counting from 1"));
  CHECK_THAT(failure(deck, "cageGsCls[1", "1"), Catch::Contains("counting from 1"));
  CHECK_THAT(failure(deck, "kFD11", "1"),
             Catch::Contains("record 2.2") && Catch::Contains("kDCR == 1"));
  CHECK_THAT(failure(deck, "runID", "two\nlines"), Catch::Contains("one line"));
}

TEST_CASE("set(): rejected value → no new record", "[unit][deck]") {
  Deck deck = new_deck("ball");
  deck.set("kDCR", "1");
  CHECK_THAT(failure(deck, "kFD11", "x"), Catch::Contains("is not an integer"));
}

TEST_CASE("set(): values in deck units and in SI", "[unit][deck]") {
  const Deck si = new_deck("ball");
  const Deck english = new_deck("ball-english");
  CHECK(english.units() == UnitSystem::English);
  CHECK(english.real("bReDia") == 0.5);
  CHECK(english.si("bReDia") == 0.0127);
  CHECK(si.si("freeConAng") == Approx(0.4363323129985824).epsilon(1e-15));
  CHECK(si.si("rpm2") == Approx(1047.1975511965977).epsilon(1e-15));
  CHECK_THROWS_AS(si.real("bReCrn"), adore::InternalError);
  CHECK_THROWS_AS(si.real("nothing"), adore::InternalError);
  CHECK(si.integer("kFD11") == 0);
  CHECK(si.text("lubName").empty());
  // The twin is the same bearing: every real value agrees in SI to the rounding of the conversion.
  REQUIRE(si.records.size() == english.records.size());
  for (const RecordSpec& record : schema())
    for (const VariableSpec& variable : record.variables) {
      if (variable.type != VarType::Real || !si.has_record(record.id)) continue;
      CAPTURE(variable.name);
      const int length = variable.length == "3" ? 3 : 1;
      for (int instance = 1; si.has_record(record.id, instance); ++instance)
        for (int i = 1; i <= length; ++i)
          CHECK(english.si(variable.name, instance, i) ==
                Approx(si.si(variable.name, instance, i)).epsilon(1e-14).margin(1e-300));
    }
}

TEST_CASE("reader: a count in a length field → error", "[unit][deck]") {
  Deck deck = new_deck("ball-english");
  deck.set("kCageGsImp", "1");
  deck.complete();
  deck.set("cageGsRadVar2[1]", "2.0");
  CHECK(deck.si("cageGsRadVar2") == Approx(2.0 * 0.0254));
  deck.set("kCageGsImp", "2");  // now the value is a number of waves per turn
  CHECK(deck.si("cageGsRadVar2") == 2.0);
}

TEST_CASE("example decks: no errors, complete, with names", "[unit][deck]") {
  CHECK(templates().size() == 15);
  for (const TemplateInfo& info : templates()) {
    INFO(info.name);
    const Deck deck = new_deck(info.name);
    CHECK(check_deck(deck).empty());
    CHECK(deck.user_lines.empty());
    CHECK_FALSE(info.description.empty());
    CHECK(template_text(info.name).size() > 500);
  }
  CHECK(new_deck("tapered").integer("kBrg") == 4);
  CHECK(new_deck("ball-18").integer("nRe") == 18);
  CHECK(new_deck("ball-thrust").integer("nGL") == 0);
  CHECK_THROWS_WITH(new_deck("needle"),
                    Catch::Contains("cylindrical") && Catch::Contains("'needle'"));
}

TEST_CASE("issue: has record and variable", "[unit][deck]") {
  Deck deck = read_deck_text(template_text("ball"), "DATA.txt").deck;
  const adore::Issue issue =
      deck.issue(adore::Severity::Error, "cageGsCls", "is wrong", "mend it", 2);
  CHECK(issue.text() == "DATA.txt:12: record 7.2.i, cageGsCls[2] = 3.0e-04: is wrong; mend it");
  CHECK(deck.issue(adore::Severity::Warning, "bReCrn", "is absent").record.empty());
}

TEST_CASE("numbers: read as Fortran reads them", "[unit][deck]") {
  const auto real = [](std::string_view text) {
    double value = -1.0;
    const NumberProblem problem = parse_real(text, value);
    INFO(text << ": " << problem.message);
    CHECK_FALSE(problem);
    return value;
  };
  CHECK(real("1") == 1.0);
  CHECK(real("+1.") == 1.0);
  CHECK(real("-.5") == -0.5);
  CHECK(real("1.5e3") == 1500.0);
  CHECK(real("1.5D3") == 1500.0);
  CHECK(real("1.5d-3") == 0.0015);
  CHECK(real("1.5+3") == 1500.0);
  CHECK(real("1.2345678-100") == 1.2345678e-100);
  CHECK(real("1e-999") == 0.0);
  CHECK(real("0.0e999") == 0.0);
  CHECK(real("-1e-99999999999999999999") == 0.0);
  CHECK(real("4.9406564584124654e-324") > 0.0);
  double value = 0.0;
  for (const char* bad : {"",
                          "+",
                          ".",
                          "e5",
                          "1e",
                          "1e+",
                          "1.2.3",
                          "1,5",
                          "0x10",
                          "1_000",
                          "1.5f",
                          "--1",
                          "nan",
                          "inf",
                          "-Infinity",
                          "1e999",
                          "1e99999999999999999999",
                          "9d400",
                          "1 2",
                          "1e5.0"}) {
    INFO(bad);
    CHECK(parse_real(bad, value));
    CHECK_FALSE(parse_real(bad, value).remedy.empty());
  }
  long long integer = 0;
  CHECK_FALSE(parse_integer("-12", integer));
  CHECK(integer == -12);
  CHECK_FALSE(parse_integer("+7", integer));
  CHECK(integer == 7);
  for (const char* bad :
       {"", "+", "-", "+-5", "--5", "1.0", "1e3", "0x1", "12a", "99999999999999999999"}) {
    INFO(bad);
    CHECK(parse_integer(bad, integer));
  }
}

TEST_CASE("reals: written short, exact and with a decimal point", "[unit][deck]") {
  CHECK(format_real(0.1) == "0.1");
  CHECK(format_real(1.0) == "1.0");
  CHECK(format_real(-0.0) == "-0.0");
  CHECK(format_real(1e-6) == "1.0e-06");
  CHECK(format_real(1e300) == "1.0e+300");
  CHECK(format_real(123456.0) == "123456.0");
  for (const double value :
       {1.0 / 3.0, 2.2250738585072014e-308, 5e-324, 1.7976931348623157e308, 0.1 + 0.2}) {
    double back = 0.0;
    CHECK_FALSE(parse_real(format_real(value), back));
    CHECK(back == value);
    CHECK(format_real(value).find('.') != std::string::npos);
  }
}

TEST_CASE("defaults_used(): missing values of the deck → listed", "[unit][deck]") {
  const std::string whole = write_deck(new_deck("ball"));
  const Deck given = read_deck_text(whole, "DATA.txt").deck;
  // Steel and the built-in constants are chosen by a 0; nothing is left out.
  for (const DefaultUsed& used : defaults_used(given)) CHECK(used.value.starts_with("0 ("));

  // Leave out each value with a default by `,,`, and the rest of the record by `/`.
  int tried = 0;
  for (const RecordData& record : given.records) {
    const RecordSpec& spec = *find_record(record.id);
    for (std::size_t v = 1; v < spec.variables.size(); ++v) {
      const VariableSpec& variable = spec.variables[v];
      if (variable.default_value.empty() || variable.length != "1") continue;
      INFO(record.id << ' ' << variable.name);
      const std::size_t line = whole.find("'Rec " + record.id + "'");
      if (line == std::string::npos) continue;  // of a repeated record
      std::size_t from = line;
      for (std::size_t comma = 0; comma < v; ++comma) from = whole.find(',', from) + 1;
      const std::size_t to = whole.find_first_of(",\n", from);
      std::string text = whole;
      text.replace(from, to - from, "");
      if (v + 1 == spec.variables.size()) text.insert(from, " /");
      const ReadResult read = read_deck_text(text, "DATA.txt");
      std::vector<DefaultUsed> added;
      const auto before = defaults_used(given);
      for (const DefaultUsed& used : defaults_used(read.deck))
        if (std::find(before.begin(), before.end(), used) == before.end()) added.push_back(used);
      if (read.deck.records.size() != given.records.size()) continue;  // it asks for other records
      const std::string unit = variable.unit.si == "-" ? "" : std::string(variable.unit.si);
      const bool listed_before =
          std::any_of(before.begin(), before.end(), [&](const DefaultUsed& used) {
            return used.record == record.id && used.variable == variable.name;
          });
      if (listed_before) continue;
      REQUIRE(added.size() == 1);
      CHECK(added[0].record == record.id);
      CHECK(added[0].variable == variable.name);
      CHECK(added[0].unit == unit);
      ++tried;
      // Where it came from changes neither equality nor what is written.
      const Deck back = read_deck_text(write_deck(read.deck), "DATA.txt").deck;
      CHECK(back == read.deck);
      for (const DefaultUsed& used : defaults_used(back)) CHECK(used.value.starts_with("0 ("));
    }
  }
  CHECK(tried > 5);
}

TEST_CASE("defaults: value set by set() → not a default; value added by complete() → default",
          "[unit][deck]") {
  Deck deck = read_deck_text(write_deck(new_deck("ball")), "DATA.txt").deck;
  const auto lists = [&](std::string_view variable) {
    const auto list = defaults_used(deck);
    return std::any_of(list.begin(), list.end(),
                       [&](const DefaultUsed& used) { return used.variable == variable; });
  };
  deck.set("nGL", "3");
  deck.complete();
  const auto list = defaults_used(deck);
  const auto added = std::find_if(list.begin(), list.end(), [](const DefaultUsed& used) {
    return used.record == "7.2.i (3)" && used.variable == "cageGsCls";
  });
  REQUIRE(added != list.end());
  CHECK(added->unit == "m");
  CHECK(lists("iCageGuide[3]"));
  CHECK_FALSE(lists("iCageGuide[2]"));
  deck.set("cageGsCls[3]", "0.0004");
  deck.set("iCageGuide[3]", "1");
  CHECK_FALSE(lists("iCageGuide[3]"));
  for (const DefaultUsed& used : defaults_used(deck))
    CHECK_FALSE((used.record == "7.2.i (3)" && used.variable == "cageGsCls"));
}

TEST_CASE("shelf: records that options do not need → kept, and restored with the option",
          "[unit][deck]") {
  std::string text = write_deck(new_deck("ball"));
  text.insert(text.find("'Rec 7.0'"), "'Rec 5G.1A', 2.0e-6\n");
  const ReadResult read = read_deck_text(text, "DATA.txt");
  REQUIRE(read.ok());
  Deck deck = read.deck;
  CHECK_FALSE(deck.has("reDiaVar"));
  REQUIRE(deck.shelf.size() == 1);
  CHECK(write_deck(deck).find("5G.1A") == std::string::npos);

  deck.set("kReGeoImp", "1");
  deck.complete();
  CHECK(deck.real("reDiaVar") == 2e-6);
  CHECK(deck.shelf.empty());
  CHECK(added_defaults(read.deck, deck).empty());
  deck.set("kReGeoImp", "0");
  deck.complete();
  CHECK_FALSE(deck.has("reDiaVar"));
  deck.set("kReGeoImp", "1");
  deck.set("reDiaVar", "3e-6");  // taken back before it is set
  CHECK(deck.real("reDiaVar") == 3e-6);

  // Repeated records come back by their number: one land of two is dropped and asked for again.
  Deck lands = read.deck;
  lands.set("cageGsWidth[2]", "0.0031");
  lands.set("nGL", "1");
  lands.complete();
  CHECK_FALSE(lands.has_record("7.2.i", 2));
  lands.set("nGL", "2");
  lands.complete();
  CHECK(lands.real("cageGsWidth", 2) == 0.0031);
}

TEST_CASE("completed values: options changed → added values are listed", "[unit][deck]") {
  const Deck before = new_deck("cylindrical");
  Deck deck = before;
  deck.set("kReGeoImp", "1");
  deck.set("reCrnVar", "0.001");
  deck.complete();
  auto issues = added_defaults(before, deck);
  REQUIRE(issues.size() == 1);
  CHECK(issues[0].severity == adore::Severity::Warning);
  CHECK(issues[0].record == "5G.1B");
  CHECK(issues[0].message.find("reDiaVar = 0.0 m") != std::string::npos);
  CHECK(issues[0].message.find("reCrnVar") == std::string::npos);
  for (const char* name : {"reDiaVar", "reLenVar", "reCLVar", "reCLOffset"}) deck.set(name, "0.0");
  CHECK(added_defaults(before, deck).empty());

  deck = new_deck("ball");
  const Deck ball = deck;
  deck.set("kRaceGeoImp2", "2");
  deck.set("nGL", "3");
  deck.complete();
  issues = added_defaults(ball, deck);
  const std::string all = adore::to_text(issues);
  INFO(all);
  CHECK(all.find("record 5G.2.2B: was added with default values") != std::string::npos);
  CHECK(all.find("record 7.2.i (3): was added") != std::string::npos);
  CHECK(all.find("iCageGuide[3] = ") != std::string::npos);
}

namespace {

using Sets = std::vector<std::pair<std::string, std::string>>;

std::string refusal(Deck deck, const Sets& sets) {
  const Deck before = deck;
  try {
    deck.set_all(sets);
  } catch (const adore::InputError& error) {
    CHECK(deck.records == before.records);
    return error.what();
  }
  return "no error";
}

/// The codes of an option as text; one larger and one smaller number where any is taken.
std::vector<std::string> codes_of(const VariableSpec& option) {
  std::vector<std::string> out;
  for (const OptionSpec& code : option.options)
    out.push_back(code.code == "n" ? "3" : code.code == "-n" ? "-2" : std::string(code.code));
  return out;
}

/// A value for every variable of the records that `changed` has and `deck` has not.
Sets values_of_new_records(const Deck& deck, const Deck& changed) {
  Sets out;
  for (const RecordData& record : changed.records) {
    if (deck.has_record(record.id, record.instance)) continue;
    const RecordSpec& spec = *find_record(record.id);
    for (std::size_t v = 1; v < spec.variables.size(); ++v)
      for (std::size_t k = 0; k < record.values[v].size(); ++k) {
        std::string name(spec.variables[v].name);
        if (!spec.repeat.empty()) name += "[" + std::to_string(record.instance) + "]";
        if (spec.variables[v].length != "1") name += "[" + std::to_string(k + 1) + "]";
        const Value& value = record.values[v][k];
        if (spec.variables[v].type == VarType::Real)
          out.emplace_back(name, "0.37");
        else if (const auto* integer = std::get_if<long long>(&value))
          out.emplace_back(name, std::to_string(*integer));
      }
  }
  return out;
}

std::ptrdiff_t count_of(const Deck& deck, double number) {
  std::ptrdiff_t count = 0;
  for (const RecordData& record : deck.records)
    for (const std::vector<Value>& elements : record.values)
      count += std::count(elements.begin(), elements.end(), Value(number));
  return count;
}

}  // namespace

TEST_CASE("set_all(): several sets → one change, in any order", "[unit][deck]") {
  // The hypothetical traction of record 8.1.1 has another record for each form of the curve.
  Sets sets{{"kTracType", "-1"},
            {"reRaceTC1", "-0.04"},
            {"kNumPltElem", "2"},
            {"kPltElemInd", "3,4"},
            {"kPltElemInd[2]", "7"}};
  std::sort(sets.begin(), sets.end());
  do {
    Deck deck = new_deck("ball");
    deck.set_all(sets);
    CHECK(deck.integer("kTracType") == -1);
    CHECK(deck.real("reRaceTC1") == -0.04);
    CHECK(deck.integer("kPltElemInd", 1) == 3);
    CHECK(deck.integer("kPltElemInd", 2) == 7);
  } while (std::next_permutation(sets.begin(), sets.end()));

  // One set alone takes the record that the option asks for, too.
  Deck deck = new_deck("ball");
  deck.set("kTracType", "-1");
  deck.set("reRaceTC1", "-0.04");
  deck.complete();
  CHECK(deck.real("reRaceTC1") == -0.04);
}

TEST_CASE("set_all(): every option with its records → any order gives the same deck",
          "[unit][deck]") {
  std::ptrdiff_t checked = 0;
  for (const char* type : {"ball", "cylindrical"}) {
    const Deck deck = new_deck(type);
    for (const RecordData& record : deck.records)
      for (const VariableSpec& option : find_record(record.id)->variables)
        for (const std::string& code : codes_of(option)) {
          if (option.length != "1" || record.instance > 1) continue;
          Deck changed = deck;
          changed.set(option.name, code);
          changed.complete();
          Sets sets = values_of_new_records(deck, changed);
          if (sets.empty()) continue;
          CAPTURE(type, option.name, code);
          sets.emplace_back(option.name, code);
          Deck forwards = deck, backwards = deck;
          forwards.set_all(sets);
          std::reverse(sets.begin(), sets.end());
          backwards.set_all(sets);
          CHECK(forwards == backwards);
          const auto given = std::count_if(sets.begin(), sets.end(),
                                           [](const auto& set) { return set.second == "0.37"; });
          CHECK(count_of(forwards, 0.37) == given);
          checked += given;
        }
  }
  CHECK(checked > 300);
}

TEST_CASE("set_all(): unknown or contradicting sets → rejected together", "[unit][deck]") {
  const Deck deck = new_deck("ball");
  const std::string all = refusal(deck, {{"pichDia", "0.06"}, {"rpm1", "1"}, {"rpm1", "2"}});
  CHECK_THAT(all, Catch::Contains("did you mean pitchDia"));
  CHECK_THAT(all, Catch::Contains("set twice, to 1 and to 2"));
  CHECK_THAT(refusal(deck, {{"kFD11", "1"}, {"nRe", "x"}}),
             Catch::Contains("record 2.2") && Catch::Contains("takes an integer"));
  // The option takes its record away: the value would go nowhere.
  CHECK_THAT(refusal(deck, {{"cageGsCls[2]", "3e-4"}, {"nCseg", "0"}}),
             Catch::Contains("needed when") && Catch::Contains("cageGsCls"));
  CHECK_THAT(refusal(deck, {{"mode", "-1"}, {"stpMax", "0.5"}}), Catch::Contains("stpMax"));
  CHECK(refusal(deck, {{"rpm1", "1"}, {"rpm1", " 1"}}) == "no error");
}
