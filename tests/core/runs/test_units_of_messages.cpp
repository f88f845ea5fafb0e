#include "deck/lookup.hpp"
#include "deck/templates.hpp"
#include "deck/unit_change.hpp"
#include "runs/check.hpp"
#include "runs/prepare.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <regex>
#include <set>

/// Whatever is said of an English deck is said in English units: every number of every type's deck
/// is driven out of its usual range, and all that warnings, notes and refusals say is read.
using namespace adore;
using deck::Deck;

namespace {

/// What the run and `adore check` say of the deck.
std::vector<std::string> all_texts(const Deck& deck) {
  std::vector<std::string> out;
  for (const Issue& issue : deck::check_deck(deck)) out.push_back(issue.text());
  for (const Issue& issue : runs::check_model(deck)) out.push_back(issue.text());
  try {
    runs::LoadedDeck input;
    input.path = "DATA.txt";
    input.deck = deck;
    const runs::Prepared p = runs::prepare(std::move(input));
    for (const Issue& issue : p.input.warnings) out.push_back(issue.text());
    for (const Issue& issue : runs::solution_notes(p)) out.push_back(issue.text());
    for (const Finding& one : p.life.notes) out.push_back(one.message);
    if (p.life.iso)
      for (const Finding& one : p.life.iso->notes) out.push_back(one.message);
    if (p.bearing.operating)
      for (const Finding& one : p.bearing.operating->warnings) out.push_back(one.message);
  } catch (const InputError& refused) {
    out.emplace_back(refused.what());
  } catch (const SolverError& failed) {
    out.emplace_back(failed.what());
  }
  return out;
}

/// The texts of a deck whose every number is multiplied, one after the other.
void read_messages(const std::string& type, std::set<std::string>& faults, std::size_t& read) {
  static const std::regex si(
      R"((^|[^\w.])[-+]?[0-9.]+(e[-+]?[0-9]+)? (mm|um|µm|m|kN|N|K|[kMG]?Pa|kg|N m|N\.m|m/s|N/m)(?![\w/^]))");
  static const std::regex list(
      R"([0-9] (and|to|or) [-+]?[0-9.]+(e[-+]?[0-9]+)? (in|lbf|lbf/in\^2|R|lbm)(?![\w/^]))");
  // Of the schema, whole in the units of the deck.
  static const std::regex range(R"(a value from [-+0-9.e]+ to )");
  Deck first = deck::new_deck(type);
  if (first.units() == deck::UnitSystem::SI)
    first = deck::in_units(first, deck::UnitSystem::English);
  first.set("mode", "-1");
  first.complete();
  for (const deck::RecordData& record : first.records)
    for (std::size_t v = 1; v < record.values.size(); ++v)
      for (std::size_t k = 0; k < record.values[v].size(); ++k) {
        const auto* real = std::get_if<double>(&record.values[v][k]);
        if (real == nullptr) continue;
        const deck::VariableSpec& spec = deck::find_record(record.id)->variables[v];
        for (const double factor : {0.0, -1.0, 1e-3, 0.5, 2.0, 30.0, 1e4}) {
          Deck changed = first;
          for (deck::RecordData& other : changed.records)
            if (other == record) other.values[v][k] = *real == 0.0 ? 0.01 * factor : factor * *real;
          for (const std::string& text : all_texts(changed)) {
            ++read;
            std::smatch match;
            const std::string lists = std::regex_replace(text, range, "");
            if (std::regex_search(text, match, si) || std::regex_search(lists, match, list))
              faults.insert(
                  fmt::format("{} x {}: '{}' in: {}", spec.name, factor, match.str(), text));
          }
        }
      }
}

}  // namespace

TEST_CASE("messages on an English deck: no SI units", "[validation][slow]") {
  for (const std::string type :
       {"ball-english", "cylindrical", "spherical", "tapered", "spherical-tapered"}) {
    std::set<std::string> faults;
    std::size_t read = 0;
    read_messages(type, faults, read);
    std::string all;
    for (const std::string& fault : faults) all += fault + "\n";
    INFO(type << ": " << read << " texts\n" << all);
    CHECK(faults.empty());
    CHECK(read > 500);
  }
}
