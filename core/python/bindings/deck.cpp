#include "deck/deck.hpp"

#include "base/input_file.hpp"
#include "base/json_text.hpp"
#include "bindings.hpp"
#include "deck/catalogue.hpp"
#include "deck/deck_text_with_comments.hpp"
#include "deck/defaults.hpp"
#include "deck/difference.hpp"
#include "deck/lookup.hpp"
#include "deck/monitored_bodies.hpp"
#include "deck/templates.hpp"
#include "deck/unit_change.hpp"
#include "design/bearing_candidates.hpp"
#include "runs/deck_request.hpp"
#include "runs/deck_story.hpp"
#include "runs/option_file.hpp"

#include <nlohmann/json.hpp>

#include <optional>

namespace adore::python {
namespace {

using Sets = std::vector<std::pair<std::string, std::string>>;

/// A deck with the text that it came from.
struct DeckObject {
  deck::Deck deck, original;
  std::string text;             ///< of `original`
  std::vector<Issue> warnings;  ///< of the reader
};

DeckObject from_text(std::string text, const std::string& name) {
  deck::ReadResult read = deck::read_deck_text(text, name);
  if (!read.ok()) throw InputError(std::move(read.issues));
  return {read.deck, read.deck, std::move(text), std::move(read.issues)};
}

/// The values in which `now` differs from `before`, as sets; records that only one of them has are
/// left to whoever compares the outcome.
Sets changes(const deck::Deck& before, const deck::Deck& now) {
  Sets out;
  for (const deck::RecordData& record : now.records) {
    const deck::RecordData* was = deck::find_record_data(before, record.id, record.instance);
    const deck::RecordSpec* spec = deck::find_record(record.id);
    if (was == nullptr || spec == nullptr || was->values.size() != record.values.size()) continue;
    for (std::size_t v = 1; v < record.values.size(); ++v)
      for (std::size_t k = 0; k < record.values[v].size(); ++k) {
        if (k < was->values[v].size() && was->values[v][k] == record.values[v][k]) continue;
        std::string name(spec->variables[v].name);
        if (!spec->repeat.empty()) name += "[" + std::to_string(record.instance) + "]";
        if (spec->variables[v].length != "1") name += "[" + std::to_string(k + 1) + "]";
        out.emplace_back(std::move(name), deck::value_text(record.values[v][k]));
      }
  }
  return out;
}

/// The deck's text with the values of now: remarks and blanks stay where that is possible.
std::string text_of(const DeckObject& self) {
  if (self.deck == self.original) return self.text;
  try {
    const Sets sets = changes(self.original, self.deck);
    deck::DeckTextWithComments kept = deck::with_values(self.text, sets);
    const deck::ReadResult again = deck::read_deck_text(kept.text, self.deck.file);
    if (kept.kept && again.deck == self.deck) return std::move(kept.text);
  } catch (const InputError&) {  // a value that no set can give: the writer can
  }
  return deck::write_deck(self.deck);
}

/// The text of DATA.txt: without records X, which ADORE.json has.
std::string saved_text(const DeckObject& self) {
  const deck::Deck plain = runs::without_extension(self.deck);
  return plain == self.deck ? text_of(self) : deck::with_deck(self.text, plain).text;
}

/// The text of the ADORE.json next to a deck file that has the deck's records X; empty optional:
/// the file stays as it is.
std::optional<std::string> extension_text(const DeckObject& self, const std::string& deck_file) {
  const runs::OptionFile file = runs::OptionFile::of_deck(std::filesystem::path(deck_file));
  if (!file.problem().empty())
    throw InputError(runs::OptionFile::path_for_deck(deck_file).string() + " " + file.problem());
  std::string text = file.with_variables(self.deck);
  if (text == file.text()) return std::nullopt;
  return text;
}

py::object to_python(const deck::Value& value) {
  if (const auto* integer = std::get_if<long long>(&value)) return py::int_(*integer);
  if (const auto* real = std::get_if<double>(&value)) return py::float_(*real);
  if (const auto* text = std::get_if<std::string>(&value)) return py::str(*text);
  return py::none();
}

py::list values_of(const deck::RecordData& record) {
  py::list out;
  for (const std::vector<deck::Value>& elements : record.values) {
    py::list list;
    for (const deck::Value& value : elements) list.append(to_python(value));
    out.append(list);
  }
  return out;
}

const deck::VariableRef present(const DeckObject& self, const std::string& name) {
  return deck::find_present_variable(self.deck, name);
}

}  // namespace

void bind_deck(py::module_& module) {
  module.def("schema_json", &deck::schema_json, "The record schema as JSON text.");
  module.def(
      "similar_variables",
      [](const std::string& name) {
        std::vector<std::string> out;
        for (const std::string_view similar : deck::similar_variables(name))
          out.emplace_back(similar);
        return out;
      },
      py::arg("name"), "Known variables that resemble a mistyped name, best first.");
  module.def(
      "examples",
      [] {
        py::list out;
        for (const deck::TemplateInfo& info : deck::templates())
          out.append(py::make_tuple(std::string(info.name), std::string(info.description)));
        return out;
      },
      "Name and description of every example deck.");

  module.def(
      "candidates",
      [](const std::string& facts) {
        return dump_json(
            design::candidates_json(design::find_candidates(design::read_facts(facts, "facts"))));
      },
      py::arg("facts"), "Internal geometries that agree with facts, JSON to JSON.");
  module.def(
      "candidates_text",
      [](const std::string& facts) {
        return design::candidates_text(design::find_candidates(design::read_facts(facts, "facts")));
      },
      py::arg("facts"), "The same as a table.");

  py::class_<DeckObject>(module, "Deck", "A deck as data, with its original text.")
      .def_static(
          "read",
          [](const std::string& path) {
            const std::filesystem::path file = runs::deck_path(std::filesystem::path(path));
            deck::ReadResult read = deck::read_deck(file);
            if (!read.ok()) throw InputError(std::move(read.issues));
            std::string text = read_text_file(file);
            const runs::OptionFile options = runs::usable_options_of_deck(file);
            if (options.variables().empty())
              return DeckObject{read.deck, read.deck, std::move(text), std::move(read.issues)};
            std::vector<Issue> issues = runs::set_extension(read.deck, options, file);
            if (!issues.empty()) throw InputError(std::move(issues));
            text = deck::with_deck(text, read.deck).text;
            return DeckObject{read.deck, read.deck, std::move(text), std::move(read.issues)};
          },
          py::arg("path"), "Reads a deck file, or DATA.txt of a folder.")
      .def_static("from_text", &from_text, py::arg("text"), py::arg("name"),
                  "A deck from its text; `name` is the name of the deck in messages.")
      .def_static(
          "example",
          [](const std::string& name) {
            return from_text(std::string(deck::template_text(name)), name);
          },
          py::arg("name"), "One of the example decks.")
      .def_static(
          "catalogue",
          [](const std::string& designation) {
            const deck::CatalogueBearing bearing = deck::find_bearing(designation);
            return from_text(deck::catalogue_deck(bearing), bearing.designation);
          },
          py::arg("designation"),
          "A deck from a designation; the internal geometry is an estimate.")
      .def_static(
          "from_facts",
          [](const std::string& facts, int choose) {
            const design::CandidateReport report =
                design::find_candidates(design::read_facts(facts, "facts"));
            const deck::CatalogueBearing bearing = design::candidate_bearing(report, choose);
            return from_text(deck::catalogue_deck(bearing), bearing.designation);
          },
          py::arg("facts"), py::arg("choose"), "The deck of a candidate of facts (JSON).")
      .def(
          "copy", [](const DeckObject& self) { return self; }, "A copy of the deck.")
      .def_property(
          "name", [](const DeckObject& self) { return self.deck.file; },
          [](DeckObject& self, const std::string& name) { self.deck.file = name; },
          "Name of the deck in messages.")
      .def_readonly("warnings", &DeckObject::warnings, "Remarks of the reader.")
      .def(
          "records",
          [](const DeckObject& self) {
            py::list out;
            for (const deck::RecordData& record : self.deck.records)
              out.append(py::make_tuple(record.id, record.instance));
            return out;
          },
          "Id and instance of every record, in deck order.")
      .def(
          "values",
          [](const DeckObject& self, const std::string& id, int instance) -> py::object {
            const deck::RecordData* record = deck::find_record_data(self.deck, id, instance);
            return record == nullptr ? py::object(py::none()) : py::object(values_of(*record));
          },
          py::arg("record"), py::arg("instance"),
          "The values of a record as a list for each variable, the label first; None if the deck "
          "does not have the record.")
      .def(
          "record_of",
          [](const DeckObject& self, const std::string& name) -> py::object {
            const deck::VariableRef ref = present(self, name);
            if (ref.record == nullptr) return py::none();
            return py::make_tuple(std::string(ref.record->id), ref.position);
          },
          py::arg("name"),
          "Record that contains a variable, and the position of the variable; None if this deck "
          "does not have the variable.")
      .def(
          "unit",
          [](const DeckObject& self, const std::string& name) {
            const deck::VariableRef ref = present(self, name);
            return ref.record == nullptr ? std::string()
                                         : std::string(deck::unit_name(self.deck, ref.spec()));
          },
          py::arg("name"),
          "Unit of a variable in this deck; empty for dimensionless numbers and texts.")
      .def(
          "si_factor",
          [](const DeckObject& self, const std::string& name) {
            const deck::VariableRef ref = present(self, name);
            if (ref.record == nullptr || deck::unit_name(self.deck, ref.spec()).empty()) return 1.0;
            const deck::UnitPair& unit = ref.spec().unit;
            return self.deck.units() == deck::UnitSystem::SI ? unit.si_factor : unit.en_factor;
          },
          py::arg("name"), "Factor from the unit of the deck to SI (with radians).")
      .def(
          "set_all",
          [](DeckObject& self, const Sets& sets) {
            const deck::Deck before = self.deck;
            std::vector<Issue> notes = deck::set_all_and_renumber(self.deck, sets);
            for (Issue& issue : deck::added_defaults(before, self.deck))
              notes.push_back(std::move(issue));
            return notes;
          },
          py::arg("sets"),
          "Sets variables as one change; names and values are texts. Returns notes on records that "
          "were added with default values, and on monitored bodies that were renumbered.")
      .def("text", &text_of, "The text of the deck; comments and blanks of the original are kept.")
      .def("saved_text", &saved_text,
           "The text of DATA.txt: without records X, which belong to ADORE.json.")
      .def("extension_text", &extension_text, py::arg("deck_file"),
           "The text of the ADORE.json next to a deck file, with the records X of the deck; None: "
           "the file needs no change.")
      .def(
          "in_units",
          [](const DeckObject& self, const std::string& system) {
            if (system != "SI" && system != "English")
              throw InputError("there is no system of units \"" + system +
                               "\"; give \"SI\" or \"English\"");
            return from_text(
                deck::write_deck(deck::in_units(
                    self.deck, system == "SI" ? deck::UnitSystem::SI : deck::UnitSystem::English)),
                self.deck.file);
          },
          py::arg("system"), "The same bearing in the other system of units.")
      .def(
          "differences",
          [](const DeckObject& self, const DeckObject& other) {
            std::vector<std::string> out;
            for (const deck::Difference& difference : deck::differences(self.deck, other.deck))
              if (!difference.label) out.push_back(difference.sentence);
            return out;
          },
          py::arg("other"), "Differences between two decks, one line each.")
      .def(
          "story", [](const DeckObject& self) { return runs::deck_story(self.deck); },
          "Description of the deck and of its run, in a few lines.")
      .def("__eq__",
           [](const DeckObject& self, const DeckObject& other) { return self.deck == other.deck; });
}

}  // namespace adore::python
