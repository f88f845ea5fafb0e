#include "studies/sensitivity.hpp"

#include "base/errors.hpp"
#include "deck/deck.hpp"
#include "runs/prepare.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <map>

namespace adore::studies {
namespace {

constexpr double kDefaultStepShare = 1e-3;  ///< of the value: the step unless the study gives one

/// "appLoadX", "cageGsCls[2]", "cageGcPos[3]" as --set takes them: of repeated records the first
/// index is the instance, of arrays the element; which of both it is the deck knows.
double value_in(const deck::Deck& deck, const std::string& name) {
  const std::size_t bracket = name.find('[');
  const std::string bare = name.substr(0, bracket);
  std::vector<int> indices;
  for (std::size_t at = bracket; at != std::string::npos; at = name.find('[', at + 1))
    indices.push_back(std::atoi(name.c_str() + at + 1));
  const auto found = deck::find_variable(bare);
  for (const deck::VariableRef& ref : found) {
    if (!deck.has(bare)) break;
    int instance = 1, element = 1;
    std::size_t used = 0;
    if (!ref.record->repeat.empty() && used < indices.size()) instance = indices[used++];
    if (ref.spec().length != "1" && used < indices.size()) element = indices[used];
    if (!deck.has_record(ref.record->id, instance)) continue;
    return deck.real(bare, instance, element);
  }
  throw InputError(
      fmt::format("variable {}: the deck does not contain the record of this variable; in \"set\", "
                  "choose deck options that need this record",
                  name));
}

}  // namespace

std::vector<BaseValue> base_values(const Study& study, std::size_t deck) {
  runs::DeckRequest request;
  request.deck = study.decks.at(deck);
  request.sets = study.sets;
  const runs::LoadedDeck loaded = runs::load_deck(request);
  std::vector<BaseValue> out;
  for (const Variable& variable : study.variables) {
    if (variable.option)
      throw InputError(
          fmt::format("option {}: a sensitivity study varies deck variables only; to compare "
                      "options, use a study with \"kind\": \"sweep\"",
                      variable.name));
    BaseValue base;
    base.value = value_in(loaded.deck, variable.name);
    base.step = variable.step > 0.0 ? variable.step : kDefaultStepShare * std::abs(base.value);
    if (base.step == 0.0)
      throw InputError(fmt::format(
          "variable {}: its value is 0, so the program cannot choose a step; give \"step\"",
          variable.name));
    out.push_back(base);
  }
  return out;
}

std::vector<Point> sensitivity_points(const Study& study) {
  std::vector<Point> out;
  for (std::size_t deck = 0; deck < study.decks.size(); ++deck) {
    const std::vector<BaseValue> bases = base_values(study, deck);
    std::vector<double> values;
    for (const BaseValue& base : bases) values.push_back(base.value);
    Point base;
    base.deck = deck;
    base.values = values;
    out.push_back(base);
    for (std::size_t v = 0; v < bases.size(); ++v)
      for (const int side : kSensitivitySides) {
        Point next = base;
        next.values[v] += side * bases[v].step;
        next.sets = {{study.variables[v].name, setting_text(next.values[v])}};
        for (const std::string& name : study.variables[v].also)
          next.sets.emplace_back(name, setting_text(next.values[v]));
        out.push_back(std::move(next));
      }
  }
  return out;
}

Derivative difference(const std::vector<double>& f, double step) {
  const double d1 = (f.at(2) - f.at(1)) / (2.0 * step), d2 = (f.at(3) - f.at(0)) / (4.0 * step);
  return {(4.0 * d1 - d2) / 3.0, std::abs(d1 - d2) / 3.0};
}

}  // namespace adore::studies
