#include "adrinput/study_example.hpp"

#include "base/errors.hpp"
#include "deck/lookup.hpp"
#include "deck/number.hpp"
#include "deck/unit_change.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace adore::adrinput {
namespace {

constexpr int kDigits = 4;  // of numbers that are an example
constexpr const char* kExampleLaws[] = {"grid", "list", "uniform", "normal"};
constexpr const char* kLoads[] = {"appLoadX", "appLoadY", "appLoadZ"};

/// "reDiaVar#" and "cageGsCls[1]" without the part that selects an element.
std::string variable_of_row(const StudyJson& row) {
  const auto name = row.find("name");
  if (name == row.end() || !name->is_string()) return {};
  const auto text = name->get<std::string>();
  return text.substr(0, text.find_first_of("#["));
}

/// The deck as all runs of the study have it.
deck::Deck with_sets(deck::Deck deck, const StudyJson& study) {
  std::vector<std::pair<std::string, std::string>> sets;
  if (const auto set = study.find("set"); set != study.end() && set->is_object())
    for (const auto& [name, value] : set->items()) sets.emplace_back(name, shown_value(value));
  try {
    deck.set_all(sets);
  } catch (const InputError&) {
    // Reported by the check of the study.
  }
  return deck;
}

bool is_there(const deck::Deck& deck, const StudyJson& row) {
  const std::string name = variable_of_row(row);
  if (name.empty()) return true;  // a run option
  if (deck::find_present_variable(deck, name).record != nullptr) return true;
  // A lot: reDiaVar1 and on.
  return row.at("name").get<std::string>().ends_with('#') &&
         deck::find_present_variable(deck, name + "1").record != nullptr;
}

double load(const deck::Deck& deck, const std::string& name) {
  return deck.has(name) ? deck.real(name) : 0.0;
}

/// Quantities that the deck does not have are adapted to it.
void about_own(StudyJson& row, const deck::Deck& deck) {
  const std::string name = variable_of_row(row);
  const double own = name.empty() || !deck.has(name) ? 0.0 : deck.real(name);
  for (const char* law : kExampleLaws) {
    if (own == 0.0 || !row.contains(law) || row[law].size() < 2) continue;
    StudyJson& numbers = row[law];
    const std::size_t count = law == std::string_view("grid") ? 2 : numbers.size();
    const bool normal = law == std::string_view("normal");
    double low = numbers[0].get<double>(), high = low;
    for (std::size_t k = 1; k < count && !normal; ++k) {
      low = std::min(low, numbers[k].get<double>());
      high = std::max(high, numbers[k].get<double>());
    }
    if (normal && row.contains("within")) {
      low = row["within"].at(0).get<double>();
      high = row["within"].at(1).get<double>();
    }
    const double middle = 0.5 * (low + high);
    if ((low <= own && own <= high) || middle == 0.0) continue;
    const auto scale = [&](StudyJson& number) {
      number = deck::rounded_to_digits(number.get<double>() * own / middle, kDigits);
    };
    for (std::size_t k = 0; k < count; ++k) scale(numbers[k]);
    if (row.contains("within"))
      for (StudyJson& number : row["within"]) scale(number);
  }
}

/// A load of zero varies nothing that this bearing carries: the row becomes one of its load.
void along_the_load(StudyJson& rows, const deck::Deck& deck) {
  std::string loaded;
  for (const char* name : kLoads)
    if (std::abs(load(deck, name)) > std::abs(loaded.empty() ? 0.0 : load(deck, loaded)))
      loaded = name;
  if (loaded.empty()) return;
  const auto varies = [&](const std::string& name) {
    return std::any_of(rows.begin(), rows.end(),
                       [&](const StudyJson& row) { return variable_of_row(row) == name; });
  };
  StudyJson out = StudyJson::array();
  for (StudyJson row : rows) {
    const std::string name = variable_of_row(row);
    const bool of_load = std::find(std::begin(kLoads), std::end(kLoads), name) != std::end(kLoads);
    if (of_load && load(deck, name) == 0.0) {
      if (varies(loaded)) continue;
      row["name"] = loaded;
    }
    out.push_back(std::move(row));
  }
  rows = std::move(out);
}

/// Numbers of an example are in SI.
void in_units_of(StudyJson& row, const deck::Deck& deck) {
  std::string name = variable_of_row(row);
  if (deck::find_present_variable(deck, name).record == nullptr) name += "1";
  const deck::VariableRef ref = deck::find_present_variable(deck, name);
  if (ref.record == nullptr || !deck::depends_on_units(deck, ref.spec())) return;
  const auto convert = [&](StudyJson& number) {
    if (number.is_number())
      number = deck::rounded_to_digits(deck::convert_value(number.get<double>(), ref.spec().unit,
                                                           deck::UnitSystem::SI, deck.units()),
                                       kDigits);
  };
  for (const char* law : kExampleLaws)
    if (row.contains(law))
      for (std::size_t k = 0; k < row[law].size(); ++k)
        if (law != std::string_view("grid") || k < 2) convert(row[law][k]);
  if (row.contains("within"))
    for (StudyJson& number : row["within"]) convert(number);
  if (row.contains("step")) convert(row["step"]);
}

/// For a cage without guide lands the pocket clearance is used.
void add_pocket_play(StudyJson& rows, const deck::Deck& deck) {
  constexpr const char* kPlay = "bPocCls1";
  const double own = deck.has(kPlay) ? deck.real(kPlay) : 0.0;
  if (own == 0.0) return;
  StudyJson list = StudyJson::array();
  for (const double share : {0.5, 0.75, 1.0, 1.25, 1.5})
    list.push_back(deck::rounded_to_digits(share * own, kDigits));
  rows.push_back({{"name", kPlay}, {"list", std::move(list)}});
}

}  // namespace

StudyJson adapt_example_to_deck(StudyJson example, const deck::Deck& base) {
  const deck::Deck deck = with_sets(base, example);
  if (example.contains("variables") && example["variables"].is_array()) {
    StudyJson rows = StudyJson::array();
    for (StudyJson& row : example["variables"])
      if (is_there(deck, row)) {
        if (deck.units() != deck::UnitSystem::SI) in_units_of(row, deck);
        rows.push_back(std::move(row));
      }
    along_the_load(rows, deck);
    for (StudyJson& row : rows) about_own(row, deck);
    if (example.value("kind", "") == "cage-map" && rows.size() == 1) add_pocket_play(rows, deck);
    example["variables"] = std::move(rows);
  }
  const auto varied = [&](const StudyJson& name) {
    const StudyJson& rows = example["variables"];
    return std::any_of(rows.begin(), rows.end(), [&](const StudyJson& row) {
      return row.contains("name") && row["name"] == name;
    });
  };
  if (example.contains("correlation") && example["correlation"].is_array()) {
    StudyJson rows = StudyJson::array();
    for (const StudyJson& row : example["correlation"])
      if (row.is_array() && row.size() == 3 && varied(row[0]) && varied(row[1]))
        rows.push_back(row);
    if (rows.empty())
      example.erase("correlation");
    else
      example["correlation"] = std::move(rows);
  }
  if (example.contains("cases") && deck.integer("kBrg") != 1)
    for (StudyJson& one : example["cases"])
      if (one.value("name", "") == "balls in force balance")
        one["name"] = "rollers in force balance";
  return example;
}

}  // namespace adore::adrinput
