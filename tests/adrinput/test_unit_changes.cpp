#include "adrinput/document.hpp"
#include "deck/lookup.hpp"
#include "deck/reader.hpp"
#include "deck/templates.hpp"
#include "deck/unit_change.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

/// kUnit changes while records come and go.
using namespace adore;
using namespace adore::adrinput;
using deck::UnitSystem;

namespace {

const char* code_of(UnitSystem units) { return units == UnitSystem::English ? "2" : "1"; }

Cell cell(const std::string& name, int instance = 1, std::size_t element = 0) {
  const auto refs = deck::find_variable(name);
  REQUIRE_FALSE(refs.empty());
  return {std::string(refs[0].record->id), instance, refs[0].position, element};
}

void set(Document& document, const Cell& cell, const std::string& text) {
  document.edit(cell, text);
  document.end_undo_step();
  REQUIRE_FALSE(document.has_unparsed_text(cell));
}

/// A document of an example in one of the systems of units.
void start(Document& document, const std::string& type, UnitSystem units) {
  document.start_new(type);
  if (document.deck().units() == units) return;
  set(document, cell("kUnit"), code_of(units));
  document.convert_values();
}

void change_units(Document& document, UnitSystem to, bool convert) {
  set(document, cell("kUnit"), code_of(to));
  if (convert) document.convert_values();
}

/// An integer that makes records or elements appear when it gets this value.
struct Switch {
  std::string type;
  Cell cell;
  std::string before, after;
};

/// Cells that have units in `now` and are not there in `before`.
std::vector<Cell> new_cells(const deck::Deck& before, const deck::Deck& now) {
  std::vector<Cell> out;
  for (const deck::RecordData& record : now.records) {
    const deck::RecordSpec& spec = *deck::find_record(record.id);
    for (std::size_t v = 0; v < record.values.size(); ++v)
      for (std::size_t k = 0; k < record.values[v].size(); ++k)
        if (const Cell cell{record.id, record.instance, v, k};
            deck::depends_on_units(now, spec.variables[v]) && value_at(before, cell) == nullptr)
          out.push_back(cell);
  }
  return out;
}

/// All of them in five examples, each once.
std::vector<Switch> switches() {
  std::vector<Switch> out;
  std::set<std::pair<std::string, std::string>> seen;
  for (const deck::TemplateInfo& info : deck::templates()) {
    const std::string type(info.name);
    const deck::Deck deck = deck::new_deck(type);
    for (const deck::RecordData& record : deck.records) {
      const deck::RecordSpec& spec = *deck::find_record(record.id);
      for (std::size_t v = 0; v < spec.variables.size(); ++v) {
        const deck::VariableSpec& variable = spec.variables[v];
        if (variable.type != deck::VarType::Integer || variable.name == "kUnit" ||
            record.instance > 1 || record.values[v].empty())
          continue;
        const auto* now = std::get_if<long long>(&record.values[v][0]);
        if (now == nullptr) continue;
        std::vector<long long> codes;
        for (long long code = -2; code <= 7; ++code) codes.push_back(code);
        codes.push_back(*now + 2);
        for (const long long code : codes) {
          const std::string text = std::to_string(code);
          if (code == *now || !deck::is_reliable_integer(variable, deck::Value(code)) ||
              !seen.emplace(variable.name, text).second)
            continue;
          deck::Deck changed = deck;
          changed.records[static_cast<std::size_t>(&record - deck.records.data())].values[v][0] =
              code;
          changed.complete();
          if (new_cells(deck, changed).empty())
            seen.erase({std::string(variable.name), text});  // of another type perhaps
          else
            out.push_back({type, {record.id, 1, v, 0}, std::to_string(*now), text});
        }
      }
    }
  }
  return out;
}

using TypedValues = std::vector<std::pair<Cell, double>>;

/// Types numbers into some cells that have come.
TypedValues fill(Document& document, const deck::Deck& before) {
  constexpr std::size_t kFilled = 3;
  std::vector<Cell> cells = new_cells(before, document.deck());
  if (cells.size() > kFilled) cells = {cells.front(), cells[cells.size() / 2], cells.back()};
  TypedValues out;
  for (const Cell& cell : cells) {
    out.emplace_back(cell, 0.125 + 0.25 * static_cast<double>(out.size()));
    set(document, cell, fmt::format("{}", out.back().second));
  }
  return out;
}

double real_at(const deck::Deck& deck, const Cell& cell) {
  const deck::Value* value = value_at(deck, cell);
  REQUIRE(value != nullptr);
  return std::get<double>(*value);
}

/// The deck with other numbers in some cells.
deck::Deck with(deck::Deck deck, const TypedValues& given, UnitSystem from, UnitSystem to) {
  for (const auto& [cell, number] : given)
    record_at(deck, cell.record, cell.instance)->values[cell.variable][cell.element] =
        deck::convert_value(number, variable_of(cell)->unit, from, to);
  return deck;
}

}  // namespace

TEST_CASE("no default of a variable depends on the system of units", "[unit][adrinput]") {
  // Values that an option adds are 0 or pure numbers and need no conversion.
  for (const deck::RecordSpec& record : deck::schema())
    for (const deck::VariableSpec& variable : record.variables) {
      INFO(record.id << " " << variable.name);
      if (variable.type == deck::VarType::Real &&
          variable.unit.si_factor != variable.unit.en_factor)
        CHECK(std::get<double>(deck::default_value(variable)) == 0.0);
    }
}

TEST_CASE("records that come after or before a change of units have the same numbers",
          "[unit][adrinput][slow]") {
  const std::vector<Switch> all = switches();
  CHECK(all.size() > 40);
  for (const Switch& one : all)
    for (const UnitSystem from : {UnitSystem::SI, UnitSystem::English}) {
      const UnitSystem to = deck::other_system(from);
      INFO(one.type << ": " << variable_of(one.cell)->name << " " << one.before << " -> "
                    << one.after << ", to kUnit " << code_of(to));
      // Reference for the comparisons below: first the records, then the units.
      Document reference;
      start(reference, one.type, from);
      const deck::Deck begin = reference.deck();
      set(reference, one.cell, one.after);
      const deck::Deck with_records = reference.deck();
      const TypedValues given = fill(reference, begin);
      REQUIRE_FALSE(given.empty());
      change_units(reference, to, true);

      // They were given, went, and come back after the change.
      Document gone;
      start(gone, one.type, from);
      set(gone, one.cell, one.after);
      (void)fill(gone, begin);
      set(gone, one.cell, one.before);
      change_units(gone, to, true);
      set(gone, one.cell, one.after);
      CHECK(gone.deck() == reference.deck());

      // They come after the change and before its answer; with numbers in the new units, or none.
      Document asked;
      start(asked, one.type, from);
      const deck::Deck before = asked.deck();
      change_units(asked, to, false);
      set(asked, one.cell, one.after);
      const TypedValues typed = fill(asked, begin);
      Document parked;
      (void)parked.restore(asked.snapshot("1"));
      for (Document* document : {&asked, &parked}) {
        document->convert_values();
        CHECK(document->deck() == with(reference.deck(), typed, to, to));
      }
      const deck::Deck after = asked.deck();
      int steps = 0;
      for (; asked.can_undo() && !(asked.deck() == before); ++steps) (void)asked.undo();
      CHECK(asked.deck() == before);
      while (steps-- > 0) (void)asked.redo();
      CHECK(asked.deck() == after);

      // The units go back to what they were while the records are away.
      Document back;
      start(back, one.type, from);
      change_units(back, to, false);
      set(back, one.cell, one.after);
      (void)fill(back, begin);
      set(back, one.cell, one.before);
      change_units(back, from, false);
      CHECK_FALSE(back.previous_units());
      set(back, one.cell, one.after);
      CHECK(back.deck() == with(with_records, given, to, from));
    }
}

TEST_CASE("a change that brings records and their numbers together gives them in the new units",
          "[unit][adrinput]") {
  Document document;
  document.start_new("ball");
  const double pitch = document.deck().real("pitchDia");
  change_units(document, UnitSystem::English, false);
  document.change({{"kReGeoImp", "2"}, {"reDiaVar7", "0.125"}});
  document.convert_values();
  CHECK(document.deck().real("reDiaVar7") == 0.125);
  CHECK(document.deck().real("reDiaVar8") == 0.0);
  CHECK(document.deck().real("pitchDia") == Approx(pitch / 0.0254));
}

TEST_CASE("a cage that is cut keeps the numbers of its start through a change of units",
          "[unit][adrinput]") {
  Document document;
  document.start_new("ball");
  REQUIRE(document.deck().integer("nCseg") == 1);
  const deck::RecordData* whole = deck::find_record_data(document.deck(), "9.6");
  REQUIRE(whole != nullptr);
  // The first value with a unit is given in the new ones, the last in the old ones.
  std::vector<Cell> cells;
  for (std::size_t v = 0; v < whole->values.size(); ++v)
    if (const Cell at{"9.6", 1, v, 0};
        !whole->values[v].empty() && deck::depends_on_units(document.deck(), *variable_of(at)))
      cells.push_back(at);
  REQUIRE(cells.size() > 1);
  set(document, cells.back(), "0.25");
  change_units(document, UnitSystem::English, false);
  set(document, cells.front(), "0.5");
  set(document, cell("nCseg"), "3");
  document.convert_values();
  for (const int segment : {1, 2, 3}) {
    Cell given = cells.front(), left = cells.back();
    given.record = left.record = "9.6.k";
    given.instance = left.instance = segment;
    CHECK(real_at(document.deck(), given) == 0.5);
    CHECK(real_at(document.deck(), left) ==
          deck::convert_value(0.25, variable_of(left)->unit, UnitSystem::SI, UnitSystem::English));
  }
}

TEST_CASE("adrinput: stored values of inactive options → converted with the others",
          "[unit][adrinput]") {
  // A deck whose record is left over: written with its option, which is then turned off.
  deck::Deck full = deck::new_deck("ball");
  full.set_all(std::vector<std::pair<std::string, std::string>>{{"kReGeoImp", "2"},
                                                                {"reDiaVar7", "0.0254"}});
  std::string text = deck::write_deck(full);
  deck::Deck off = full;
  off.set("kReGeoImp", "0");
  off.complete();
  // The line of the option alone changes.
  const std::string with_it = deck::write_deck(full), without = deck::write_deck(off);
  std::size_t line = 0;
  while (with_it[line] == without[line]) ++line;
  const std::size_t begin = with_it.rfind('\n', line) + 1;
  text.replace(begin, with_it.find('\n', begin) - begin,
               without.substr(begin, without.find('\n', begin) - begin));
  const deck::ReadResult read = deck::read_deck_text(text, "left-over");
  REQUIRE(read.ok());
  REQUIRE(read.deck.integer("kReGeoImp") == 0);
  REQUIRE_FALSE(read.deck.shelf.empty());
  Document document;
  document.start_from_text(text);
  change_units(document, UnitSystem::English, true);
  Document parked;
  (void)parked.restore(document.snapshot("1"));
  for (Document* one : {&document, &parked}) {
    set(*one, cell("kReGeoImp"), "2");
    CHECK(one->deck().real("reDiaVar7") == Approx(1.0));
  }
  // And so it is by the library's own change of units.
  deck::Deck other = deck::in_units(read.deck, UnitSystem::English);
  other.set("kReGeoImp", "2");
  other.complete();
  CHECK(other.real("reDiaVar7") == Approx(1.0));
}
