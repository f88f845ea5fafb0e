#include "design/design_inputs.hpp"

#include "base/errors.hpp"
#include "deck/catalogue.hpp"
#include "deck/lookup.hpp"
#include "deck/number.hpp"
#include "deck/quantity.hpp"
#include "deck/unit_change.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace adore::design {
namespace {

constexpr std::array<const char*, 6> kTemperatures = {"hsngTemp",  "shftTemp", "raceTemp1",
                                                      "raceTemp2", "reTemp",   "cageTemp"};
constexpr std::array<const char*, 5> kOperation = {"appLoadX", "appLoadY", "appLoadZ", "rpm1",
                                                   "rpm2"};
/// Records 10.3 and 10.4 of an oil.
constexpr std::array<const char*, 13> kOilValues = {
    "reRaceFilm", "strParam",      "lubName",      "refTemp", "refVis",
    "prVisCoeff", "tempVisCoeff",  "lubTherCond",  "lubDen",  "lubSpHeat",
    "refTracVis", "tracVisCoeff1", "tracVisCoeff2"};
/// Values of record X2 that describe an oil: all except the temperature of the bearing.
constexpr std::array<const char*, 11> kGradeValues = {
    "oilGrade", "oilName",  "kOilBase", "kGrease", "oilVisc1",  "oilTemp1",
    "oilVisc2", "oilTemp2", "oilIndex", "oilDen",  "oilPrCoeff"};
constexpr std::array kGrades = {32, 46, 68, 100, 150, 220, 320, 460};  // ISO 3448
constexpr long long kByGrade = 21;  // kTrac of an oil of record X2

const deck::VariableSpec& spec_of(std::string_view name) {
  return deck::find_variable(name).front().spec();
}

/// The value as a deck has it, without quotes.
std::string plain_value(const deck::Deck& deck, const char* name) {
  const deck::Value* value = deck::find_value(deck, name);
  if (value == nullptr) return {};
  if (const auto* text = std::get_if<std::string>(value)) return *text;
  return deck::value_text(*value);
}

std::string fixed_load(const deck::Deck& deck, const char* flag, const char* displacement) {
  if (deck.integer(flag) != 1) return {};
  return fmt::format("the displacement {} is given instead ({} = 1)", displacement, flag);
}

}  // namespace

std::vector<DesignInput> design_inputs(const deck::Deck& deck) {
  const bool ball = deck.integer("kBrg") == 1;
  const std::string element = ball ? "ball" : "roller";
  std::vector<DesignInput> all = {
      {"Operation", "Radial load", {"appLoadZ"}, "N", fixed_load(deck, "kFS3", "appDispZ")},
      {"Operation", "Axial load", {"appLoadX"}, "N", fixed_load(deck, "kFS1", "appDispX")},
      {"Operation", "Inner race speed", {"rpm2"}, "rpm", ""},
      {"Operation", "Outer race speed", {"rpm1"}, "rpm", ""},
      {"Operation", "Temperature", {kTemperatures.begin(), kTemperatures.end()}, "°C", ""},
      {"Geometry", "Bore", {"brgBore"}, "mm", ""},
      {"Geometry", "Outside diameter", {"brgOD"}, "mm", ""},
      {"Geometry", fmt::format("Number of {}s", element), {"nRe"}, "", ""},
      {"Geometry", ball ? "Ball diameter" : "Roller diameter", {"bReDia"}, "mm", ""},
      {"Geometry", "Roller length", {"bReLen"}, "mm", ""},
      {"Geometry", "Pitch diameter", {"pitchDia"}, "mm", ""},
      {"Geometry", "Free contact angle", {"freeConAng"}, "°", ""},
      {"Geometry", "Cup half angle", {"raceTaper1"}, "°", ""},
      {"Geometry", "Diametral clearance", {"freeIntCls"}, "mm", ""}};
  if (ball && deck.has("freeConAng") && deck.real("freeConAng") != 0.0)
    all.back().why_fixed =
        "the diametral clearance follows from the contact angle without load (freeConAng)";
  std::erase_if(all, [&](const DesignInput& one) { return !deck.has(one.variables.front()); });
  return all;
}

std::string input_text(const deck::Deck& deck, const DesignInput& input) {
  const std::string& first = input.variables.front();
  const deck::VariableSpec& spec = spec_of(first);
  if (spec.type == deck::VarType::Integer) return fmt::format("{}", deck.integer(first));
  const double value = deck.real(first);
  for (const std::string& other : input.variables)
    if (deck.has(other) && deck.real(other) != value) return {};
  const std::string unit = input.unit == "°" ? "deg" : input.unit;
  const auto units = deck::usual_units(spec.unit);
  const bool usual = std::find(units.begin(), units.end(), unit) != units.end();
  if (!usual) return fmt::format("{}", value);
  // Of a deck in other units, whose values have twelve digits, a person wants fewer.
  constexpr std::size_t kMostDigits = 10;
  const std::string exact = deck::number_in_unit(value, spec.unit, deck.units(), unit);
  if (exact.size() <= kMostDigits + 1) return exact;
  double number = value;
  const bool read = !deck::parse_real(exact, number);
  demand(read, "a printed number can be read");
  return fmt::format("{:.9g}", number);
}

namespace {

DesignOil oil_of(const deck::Deck& deck, std::string name, long long code, int grade = 0) {
  DesignOil oil{std::move(name), {{"kTrac", fmt::format("{}", code)}}};
  if (grade > 0) oil.sets.emplace_back(kGradeValues.front(), fmt::format("{}", grade));
  for (const char* value : kGradeValues)
    if (deck.has(value) && (grade == 0 || value != kGradeValues.front()))
      oil.sets.emplace_back(value, "");
  if (code == 0 || deck.integer("kTrac") > 0) return oil;
  // Metal contact below 0.01 µm, flooded inlet [choice].
  const bool english = deck.units() == deck::UnitSystem::English;
  const deck::UnitPair& length = spec_of("reRaceFilm").unit;
  oil.sets.emplace_back(
      "reRaceFilm", fmt::format("{:.6g}", 1e-8 / (english ? length.en_factor : length.si_factor)));
  oil.sets.emplace_back("strParam", "10");
  return oil;
}

}  // namespace

std::vector<DesignOil> design_oils(const deck::Deck& deck) {
  std::vector<DesignOil> out{oil_of(deck, "none (dry friction)", 0)};
  for (const int grade : kGrades)
    out.push_back(oil_of(deck, fmt::format("ISO VG {} mineral oil", grade), kByGrade, grade));
  for (const deck::OptionSpec& one : deck::option_table("@lubricants")) {
    long long code = 0;
    // Routine and own coefficients are in the records.
    if (!deck::parse_integer(one.code, code) && code > 0 && code != 9 && code != kByGrade)
      out.push_back(oil_of(deck, std::string(one.meaning), code));
  }
  return out;
}

std::optional<std::size_t> design_oil_index(const deck::Deck& deck) {
  const std::vector<DesignOil> oils = design_oils(deck);
  const bool by_grade = deck.integer("kTrac") == kByGrade;
  // Record X2 acts on films only with this code.
  const auto has = [&](const std::pair<std::string, std::string>& set) {
    return plain_value(deck, set.first.c_str()) == set.second;
  };
  const auto found = std::find_if(oils.begin(), oils.end(), [&](const DesignOil& oil) {
    return by_grade ? std::all_of(oil.sets.begin(), oil.sets.end(), has) : has(oil.sets.front());
  });
  if (found == oils.end()) return std::nullopt;
  return static_cast<std::size_t>(found - oils.begin());
}

deck::Deck replace_bearing(const deck::Deck& deck, std::string_view designation, bool keep) {
  const deck::CatalogueBearing bearing = deck::find_bearing(designation);
  deck::Deck out = deck::read_deck_text(deck::catalogue_deck(bearing), "catalog").deck;
  out.file.clear();
  if (deck.units() == deck::UnitSystem::English) out = deck::in_units(out, deck.units());
  if (!keep) return out;
  // Loads and speeds that the catalogue proposed for the present bearing are not the user's.
  std::optional<deck::Deck> proposed;
  try {
    proposed = replace_bearing(deck, deck.text("runID"), false);
  } catch (const InputError&) {
  }
  std::vector<std::pair<std::string, std::string>> sets;
  for (const char* name : kOperation) {
    if (proposed && proposed->real(name) == deck.real(name)) continue;
    const bool loads = std::string_view(name) == "appLoadX";
    if (loads && out.integer("kFS1") == 1) continue;
    sets.emplace_back(name, plain_value(deck, name));
  }
  for (const char* name : kTemperatures) sets.emplace_back(name, plain_value(deck, name));
  if (deck.integer("kTrac") > 0) {
    sets.emplace_back("kTrac", plain_value(deck, "kTrac"));
    for (const char* name : kOilValues)
      if (deck.has(name)) sets.emplace_back(name, plain_value(deck, name));
  }
  for (const char* name : kGradeValues)
    if (deck.has(name)) sets.emplace_back(name, plain_value(deck, name));
  out.set_all(sets);
  return out;
}

}  // namespace adore::design
