#include "adrinput/document.hpp"
#include "adrinput/driver.hpp"
#include "adrinput/search.hpp"
#include "adrinput/typed.hpp"
#include "deck/deck_text_with_comments.hpp"
#include "deck/element_names.hpp"
#include "deck/lookup.hpp"
#include "deck/templates.hpp"

#include <QTemporaryDir>
#include <catch2/catch.hpp>

#include <algorithm>

/// The deck in the form: typing, options that bring records, undo, problems, units.
using namespace adore;
using namespace adore::adrinput;
namespace fs = std::filesystem;

TEST_CASE("typed numbers: comma, minus sign and blanks accepted, other text rejected with a reason",
          "[unit][adrinput]") {
  const deck::VariableSpec& real = *variable_of(cell("pitchDia"));
  const deck::VariableSpec& whole = *variable_of(cell("nRe"));
  const deck::VariableSpec& code = *variable_of(cell("kBrg"));
  const auto number = [&](std::string_view text) {
    const TypedValue typed = parse_typed_text(real, text);
    INFO(text);
    REQUIRE_FALSE(typed.problem);
    return std::get<double>(typed.value);
  };
  CHECK(number("0,0605") == 0.0605);
  CHECK(number(" 0.0605 ") == 0.0605);
  CHECK(number("1,5e-3") == 1.5e-3);
  CHECK(number("\u22120,5") == -0.5);
  CHECK(number("1.5d-3") == 1.5e-3);
  CHECK(number("7") == 7.0);
  for (const char* wrong : {"", "abc", "1.234,5", "1,2,3", "nan", "1e999", "0x10"}) {
    INFO(wrong);
    const TypedValue typed = parse_typed_text(real, wrong);
    CHECK(typed.problem);
    CHECK_FALSE(typed.problem.remedy.empty());
  }
  // Ten or ten thousand? A comma before three digits may be either, unless nobody groups so.
  const deck::Deck deck = deck::new_deck("ball");
  for (const char* either : {"10,000", "1,500", " -12,700", "12,700 mm", "2*1,250"}) {
    INFO(either);
    for (const TypedValue& typed :
         {parse_typed_text(real, either), parse_typed_text(deck, real, either)}) {
      CHECK(typed.problem.message ==
            "is ambiguous: the comma could be a decimal comma or a thousands separator");
      CHECK(typed.problem.remedy.find(" or ") != std::string::npos);
    }
  }
  CHECK(parse_typed_text(real, "10,000").problem.remedy == "write 10000 or 10.000");
  CHECK(number("0,125") == 0.125);
  CHECK(number("1234,567") == 1234.567);
  CHECK(number("1,5000") == 1.5);
  CHECK(number("1,500e3") == 1500.0);
  CHECK(number("12,12") == 12.12);
  CHECK(std::get<long long>(parse_typed_text(whole, "12").value) == 12);
  CHECK(parse_typed_text(whole, "12.0").problem);
  CHECK(parse_typed_text(whole, "-3").problem);
  CHECK(parse_typed_text(whole, "20000").problem);
  CHECK(parse_typed_text(code, "9").problem);
  CHECK_FALSE(parse_typed_text(code, "2").problem);
}

TEST_CASE("typed numbers: three times a number in a vector of three values → rejected as ambiguous",
          "[unit][adrinput]") {
  Document document;
  const auto problem_of = [&](const char* name, std::size_t element, const char* typed) {
    Cell at = cell(name);
    at.element = element;
    return document.parse(at, typed).problem;
  };
  const auto asked = problem_of("cageGcPos", 0, "3*4e-4");
  CHECK(asked.message == "is ambiguous: it could be a product or, as in a deck, 3 values");
  CHECK(asked.remedy == "write 4e-4*3 for the product, or 4e-4 in each of the 3 fields");
  CHECK(problem_of("cageGcPos", 0, " 2*0,0004 "));
  // A list that is invalid here is a product, also one in a form that decks do not use.
  Cell last = cell("cageGcPos");
  while (value_at(document.deck(), {last.record, 1, last.variable, last.element + 1}) != nullptr)
    ++last.element;
  REQUIRE(last.element > 0);
  CHECK_FALSE(problem_of("cageGcPos", last.element, "3*4e-4"));
  for (const char* product : {"4e-4*2", "99*4e-4", "1*4e-4", "2 * 4e-4", "2*0.4 mm", "0.5*4e-4"}) {
    INFO(product);
    CHECK_FALSE(problem_of("cageGcPos", 0, product));
  }
  CHECK_FALSE(problem_of("pitchDia", 0, "2*0.03"));  // alone
  document.edit(cell("cageGcPos"), "3*4e-4");
  CHECK_FALSE(document.errors().empty());  // nothing is taken before it is clear
}

TEST_CASE("options: record hidden and shown again → its values are kept", "[unit][adrinput]") {
  Document document;
  const auto has = [&](const std::string& id) { return document.instances(id) > 0; };
  REQUIRE(has("7.1"));
  document.edit(cell("cageDia1"), "0,0662");
  document.edit(cell("cageGsCls", 2), "4e-4");
  document.edit(cell("nCseg"), "0");
  CHECK_FALSE(has("7.0"));
  CHECK_FALSE(has("7.2.i"));
  CHECK(has("10.5.3D"));
  document.edit(cell("nCseg"), "1");
  REQUIRE(has("7.2.i"));
  CHECK(document.text(cell("cageDia1")) == "0.0662");
  CHECK(document.text(cell("cageGsCls", 2)) == "4.0e-04");

  document.edit(cell("nGL"), "1");
  CHECK(document.instances("7.2.i") == 1);
  document.edit(cell("nGL"), "2");
  CHECK(document.instances("7.2.i") == 2);
  CHECK(document.text(cell("cageGsCls", 2)) == "4.0e-04");
  CHECK(document.text(cell("iCageGuide", 1, 1)) == "1");
  CHECK_FALSE(document.has_errors());
}

TEST_CASE("counts: typed digit by digit → no values lost; huge count → no records added",
          "[unit][adrinput]") {
  Document document;
  const std::string before = deck::write_deck(document.deck());
  for (const char* text : {"1", "", "1", "12", "1200000", "12"})
    document.edit(cell("kNumPltElem"), text);
  document.edit(cell("kNumPltElem"), "4");
  CHECK(deck::write_deck(document.deck()) == before);
  document.edit(cell("nGL"), "4000");
  CHECK(document.instances("7.2.i") == 2);
  CHECK(document.text(cell("nGL")) == "4000");
  CHECK(document.has_errors());
}

TEST_CASE("undo and redo: every step; typing in one field is one step", "[unit][adrinput]") {
  Document document;
  const deck::Deck first = document.deck();
  CHECK_FALSE(document.can_undo());
  for (const char* text : {"0.06", "0.061", "0.0612"}) document.edit(cell("pitchDia"), text);
  const deck::Deck second = document.deck();
  document.end_undo_step();
  document.edit(cell("kBrg"), "2");
  const deck::Deck third = document.deck();
  CHECK(document.undo() == "3.2");
  CHECK(document.deck() == second);
  CHECK(document.undo() == "5A");
  CHECK(document.deck() == first);
  CHECK_FALSE(document.modified());
  CHECK_FALSE(document.can_undo());
  document.redo();
  document.redo();
  CHECK(document.deck() == third);
  CHECK_FALSE(document.can_redo());
}

TEST_CASE("problems: wrong value named, also if only the model check finds it",
          "[unit][adrinput]") {
  Document document;
  document.check_model();
  CHECK(document.problems().empty());
  document.edit(cell("pitchDia"), "0.001");
  REQUIRE(document.has_errors());
  const auto at = [&](const Cell& where) {
    return std::any_of(document.problems().begin(), document.problems().end(),
                       [&](const Problem& problem) { return problem.cell == where; });
  };
  CHECK(at(cell("pitchDia")));
  CHECK(document.state_of("5A") == RecordState::Wrong);
  CHECK(document.state_of("4") == RecordState::Complete);
  document.edit(cell("cageGsDia", 2), "-1");
  CHECK(at(cell("cageGsDia", 2)));
  CHECK_FALSE(at(cell("cageGsDia", 1)));
  document.edit(cell("pitchDia"), "0,06x");
  CHECK(document.text(cell("pitchDia")) == "0,06x");
  CHECK(at(cell("pitchDia")));
}

TEST_CASE("start check: error in another record → a rejected record stays marked",
          "[unit][adrinput]") {
  Document document;
  document.edit(cell("kDOF"), "6");  // needs a routine of the user
  document.check_model();
  REQUIRE_FALSE(document.has_errors());
  REQUIRE(document.deck_state() == DeckState::Refused);
  const std::string record = cell("kDOF").record;
  CHECK(document.state_of(record) == RecordState::Doubtful);
  document.edit(cell("pitchDia"), "0.001");
  document.check_model();
  REQUIRE(document.has_errors());
  CHECK(document.state_of(record) == RecordState::Doubtful);
  document.undo();
  CHECK(document.state_of(record) == RecordState::Doubtful);
  document.edit(cell("kDOF"), "1");
  document.check_model();
  CHECK(document.deck_state() == DeckState::Unchecked);
  CHECK(document.state_of(record) == RecordState::Complete);
}

TEST_CASE("start check: rejection without a record marks the deck, with a record also the record",
          "[unit][adrinput]") {
  Document document;
  document.check_model();
  REQUIRE(document.needs_start_check());
  CHECK(document.deck_state() == DeckState::Unchecked);
  document.set_start_check_result(document.candidate(), {});
  CHECK(document.deck_state() == DeckState::Ready);
  CHECK_FALSE(document.needs_start_check());
  document.edit(cell("appLoadX"), "1501");
  CHECK(document.deck_state() == DeckState::Unchecked);
  Issue nowhere, start;
  nowhere.message = "the equilibrium is not found";
  start.message = "moves the cage away from its elements";
  start.record = "9.6";
  document.set_start_check_result(document.candidate(), {nowhere, start});
  CHECK(document.deck_state() == DeckState::Refused);
  CHECK(document.state_of("9.6") == RecordState::Doubtful);
  REQUIRE(document.problems().size() >= 2);
  for (std::size_t i : {0U, 1U}) {
    CHECK(document.problems()[i].refused);
    CHECK(document.problems()[i].issue.severity == Severity::Note);  // it can be saved
  }
  CHECK_FALSE(document.has_errors());
  document.edit(cell("appLoadX"), "1502");
  CHECK(document.deck_state() == DeckState::Unchecked);
  CHECK(document.state_of("9.6") == RecordState::Doubtful);  // until somebody knows better
  document.set_start_check_result(document.candidate(), {});
  CHECK(document.state_of("9.6") == RecordState::Complete);
  Document other;
  other.edit(cell("appLoadX"), "1503");
  document.set_start_check_result(other.candidate(), {nowhere, start});  // of another deck
  CHECK(document.state_of("9.6") == RecordState::Complete);
  CHECK(document.deck_state() == DeckState::Ready);
  document.edit(cell("pitchDia"), "0.001");
  document.check_model();
  CHECK(document.deck_state() == DeckState::Wrong);
  CHECK_FALSE(document.needs_start_check());
}

TEST_CASE("new records: marked until they are opened", "[unit][adrinput]") {
  Document document;
  document.edit(cell("kChrn"), "1");
  REQUIRE(document.instances("10.7B") == 1);
  CHECK(document.state_of("10.7B") == RecordState::Untouched);
  document.accept_defaults("10.7B");
  CHECK(document.state_of("10.7B") == RecordState::Complete);
}

TEST_CASE("search: everyday words find variables", "[unit][adrinput]") {
  const auto names = [](std::string_view query) {
    std::vector<std::string> out;
    for (const VariableMatch& found : search_variables(query))
      out.emplace_back(variable_of(found.cell)->name);
    return out;
  };
  const auto among_first = [&](std::string_view query, const std::string& name) {
    const auto all = names(query);
    const auto found = std::find(all.begin(), all.end(), name);
    return found != all.end() && found - all.begin() < 6;
  };
  CHECK(among_first("where is race curvature?", "raceCurFac1"));
  CHECK(names("pitchDia").front() == "pitchDia");
  CHECK(among_first("pitch diameter", "pitchDia"));
  CHECK(among_first("integration method", "intMet"));
  CHECK(among_first("gravity", "gravityVecX"));
  CHECK(names("cotton phenolic").size() >= 1);
  CHECK(names("the of where").empty());
  CHECK(names("zebra").empty());
}

TEST_CASE("monitored bodies: number of elements changed → same bodies monitored",
          "[unit][adrinput]") {
  const auto monitored = [](const Document& document) {
    std::vector<std::string> names;
    const deck::Deck& deck = document.deck();
    for (int i = 1; i <= deck.integer("kNumPltElem"); ++i)
      names.push_back(deck::body_name(deck, deck.integer("kPltElemInd", i)));
    return names;
  };
  int changes = 0;
  for (const char* type : {"ball", "cylindrical", "spherical", "tapered", "spherical-tapered"})
    for (const char* variable : {"nRe", "nCseg"})
      for (const int change : {-2, -1, 1, 2, 5}) {
        Document document;
        document.start_new(type);
        const deck::Deck& deck = document.deck();
        const long long elements = deck.integer("nRe"), segments = deck.integer("nCseg");
        const long long now = deck.integer(variable) + change;
        if (now < 0) continue;
        // The first and the last element, the first segment, both races.
        std::vector<long long> bodies{1, elements};
        if (segments > 0) bodies.push_back(elements + 1);
        bodies.push_back(elements + segments + 1);
        bodies.push_back(elements + segments + 2);
        document.edit(cell("kNumPltElem"), std::to_string(bodies.size()));
        for (std::size_t k = 0; k < bodies.size(); ++k)
          document.edit(cell("kPltElemInd", 1, k), std::to_string(bodies[k]));
        document.end_undo_step();
        const deck::Deck before = deck;
        const std::vector<std::string> was = monitored(document);
        REQUIRE(was.size() == bodies.size());
        document.edit(cell(variable), std::to_string(now));
        document.end_undo_step();
        INFO(type << ": " << variable << " = " << now);
        REQUIRE(deck.integer(variable) == now);
        ++changes;
        const std::vector<std::string> is = monitored(document);
        const bool cage_gone = variable == std::string("nCseg") && now == 0 && segments > 0;
        std::vector<std::string> expected{"rolling element 1"};
        expected.push_back("rolling element " +
                           std::to_string(std::min(elements, deck.integer("nRe"))));
        if (segments > 0 && !cage_gone)
          expected.push_back(deck.integer("nCseg") == 1 ? "cage" : "cage segment 1");
        expected.insert(expected.end(), {"outer race", "inner race"});
        CHECK(is == expected);
        const auto told = std::count_if(
            document.problems().begin(), document.problems().end(), [](const Problem& problem) {
              return problem.issue.message ==
                     "the cage no longer exists and is no longer monitored";
            });
        CHECK(told == (cage_gone ? 1 : 0));
        (void)document.undo();
        CHECK(deck == before);
        (void)document.redo();
        CHECK(monitored(document) == is);
        document.edit(cell(variable), variable == std::string("nRe") ? std::to_string(elements)
                                                                     : std::to_string(segments));
        document.end_undo_step();
        CHECK(deck == before);  // the count comes back, and with it the bodies
        (void)document.undo();
        // The same as one change of several values.
        (void)document.undo();
        document.change({{variable, std::to_string(now)}});
        CHECK(monitored(document) == is);
      }
  CHECK(changes > 30);
}

TEST_CASE("unit change: numbers entered after kUnit was changed are not converted",
          "[unit][adrinput]") {
  Document document;
  document.start_new("ball");
  const double bore = document.deck().real("brgBore"), load = document.deck().real("appLoadZ");
  document.edit(cell("kUnit"), "2");
  document.end_undo_step();
  document.edit(cell("nCseg"), "0");
  document.end_undo_step();
  document.type(cell("pitchDia"), "2.5");
  CHECK(document.previous_units() == deck::UnitSystem::SI);
  document.end_undo_step();
  document.change({{"appLoadX", "12.5"}, {"tol", "1e-6"}});
  CHECK(document.previous_units() == deck::UnitSystem::SI);
  (void)document.undo();
  CHECK(document.previous_units() == deck::UnitSystem::SI);
  (void)document.redo();
  document.convert_values();
  CHECK_FALSE(document.previous_units());
  CHECK(document.deck().real("pitchDia") == 2.5);
  CHECK(document.deck().real("appLoadX") == 12.5);
  CHECK(document.deck().real("brgBore") == Approx(bore / 0.0254));
  CHECK(document.deck().real("appLoadZ") == Approx(load / 4.4482216152605));
  // Back to where it was asked, to where it was changed, and before.
  (void)document.undo();
  CHECK(document.previous_units() == deck::UnitSystem::SI);
  while (document.can_undo()) (void)document.undo();
  CHECK_FALSE(document.previous_units());
  CHECK(document.deck().real("brgBore") == bore);
}

TEST_CASE("unit change: undone → numbers return to their units, also in a draft",
          "[unit][adrinput]") {
  Document document;
  document.start_new("ball");
  const double bore = document.deck().real("brgBore");
  document.edit(cell("kUnit"), "2");
  document.type(cell("pitchDia"), "2.5");
  document.end_undo_step();
  Document parked;
  (void)parked.restore(document.snapshot("1"));
  CHECK(parked.previous_units() == deck::UnitSystem::SI);
  for (Document* one : {&document, &parked}) {
    one->edit(cell("kUnit"), "1");
    CHECK_FALSE(one->previous_units());
    CHECK(one->deck().real("pitchDia") == Approx(2.5 * 0.0254));
    CHECK(one->deck().real("brgBore") == bore);
  }
  // The draft has the question, too.
  Document asked;
  document.edit(cell("kUnit"), "2");
  document.type(cell("pitchDia"), "2.5");
  (void)asked.restore(document.snapshot("1"));
  asked.convert_values();
  CHECK(asked.deck().real("pitchDia") == 2.5);
  CHECK(asked.deck().real("brgBore") == Approx(bore / 0.0254));
}
