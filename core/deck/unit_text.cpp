#include "deck/unit_text.hpp"

#include "deck/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace adore::deck {
namespace {

struct WrittenUnit {
  std::string_view name;
  const UnitPair* unit;
  double prefix;  ///< of the SI unit
};

// Quantities that no variable of the deck has.
constexpr UnitPair kPower{"W", "in.lbf/s", 1.0, unit::kPoundForce* unit::kInch};
constexpr UnitPair kEnergy{"J", "in.lbf", 1.0, unit::kPoundForce* unit::kInch};
constexpr UnitPair kPowerPerKelvin{"W/K", "in.lbf/s/R", 1.0,
                                   unit::kPoundForce* unit::kInch / unit::kRankine};
constexpr UnitPair kPerLength{"1/m", "1/in", 1.0, 1.0 / unit::kInch};
constexpr UnitPair kStiffness{"N/m", "lbf/in", 1.0, unit::kPoundForce / unit::kInch};
constexpr UnitPair kRotationalStiffness{"N m/rad", "lbf.in/rad", 1.0,
                                        unit::kPoundForce* unit::kInch};

constexpr WrittenUnit kUnits[] = {{"m", &unit::kLength, 1.0},
                                  {"mm", &unit::kLength, 1e-3},
                                  {"um", &unit::kLength, 1e-6},
                                  {"µm", &unit::kLength, 1e-6},
                                  {"Pa", &unit::kStress, 1.0},
                                  {"kPa", &unit::kStress, 1e3},
                                  {"MPa", &unit::kStress, 1e6},
                                  {"GPa", &unit::kStress, 1e9},
                                  {"N/m^2", &unit::kStress, 1.0},
                                  {"N/mm^2", &unit::kStress, 1e6},
                                  {"N", &unit::kForce, 1.0},
                                  {"kN", &unit::kForce, 1e3},
                                  {"N m", &unit::kMoment, 1.0},
                                  {"N.m", &unit::kMoment, 1.0},
                                  {"K", &unit::kTemperature, 1.0},
                                  {"kg", &unit::kMass, 1.0},
                                  {"kg/m^3", &unit::kDensity, 1.0},
                                  {"m/s", &unit::kSpeed, 1.0},
                                  {"m/s^2", &unit::kAcceleration, 1.0},
                                  {"N/m", &kStiffness, 1.0},
                                  {"N m/rad", &kRotationalStiffness, 1.0},
                                  {"N.m/rad", &kRotationalStiffness, 1.0},
                                  {"W", &kPower, 1.0},
                                  {"kW", &kPower, 1e3},
                                  {"J", &kEnergy, 1.0},
                                  {"W/K", &kPowerPerKelvin, 1.0},
                                  {"W/m/K", &unit::kConductivity, 1.0},
                                  {"W/m^2/K", &unit::kConvection, 1.0},
                                  {"J/kg/K", &unit::kSpecificHeat, 1.0},
                                  {"1/m", &kPerLength, 1.0},
                                  {"1/K", &unit::kPerTemperature, 1.0},
                                  {"m^3/s", &unit::kVolumeFlow, 1.0},
                                  {"s/m", &unit::kPerSpeed, 1.0},
                                  {"Pa s", &unit::kViscosity, 1.0},
                                  {"N.s/m^2", &unit::kViscosity, 1.0},
                                  {"m^2/N", &unit::kPerStress, 1.0},
                                  {"1/Pa", &unit::kPerStress, 1.0},
                                  {"kg m^2", &unit::kInertia, 1.0},
                                  {"kg.m^2", &unit::kInertia, 1.0}};

/// Units of two words.
constexpr std::string_view kPairs[] = {"N m/rad", "N m", "Pa s", "kg m^2"};

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' ||
         (static_cast<unsigned char>(c) & 0x80U) != 0;
}

/// Length of the number that the text starts with; 0 when it starts with none.
std::size_t number_length(std::string_view text, double& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || !std::isfinite(value)) return 0;
  auto length = static_cast<std::size_t>(end - text.data());
  if (text[length - 1] == '.') --length;  // of the sentence
  return length;
}

int significant_digits(std::string_view number) {
  int count = 0;
  for (const char c : number.substr(0, number.find_first_of("eE")))
    if (std::isdigit(static_cast<unsigned char>(c)) != 0 && (count > 0 || c != '0')) ++count;
  return std::clamp(count, 3, 15);
}

/// The unit that the text starts with, up to the end of its word; nullptr when it starts with none.
const WrittenUnit* unit_at(std::string_view text) {
  std::size_t length = 0;
  while (length < text.size() &&
         (is_word(text[length]) || text[length] == '/' || text[length] == '^'))
    ++length;
  for (const std::string_view pair : kPairs)
    if (pair.substr(0, pair.find(' ')) == text.substr(0, length) && text.starts_with(pair) &&
        (text.size() == pair.size() || text[pair.size()] == '.' || !is_word(text[pair.size()]))) {
      length = pair.size();
      break;
    }
  while (length > 0 && text[length - 1] == '.') --length;
  const auto found = std::find_if(std::begin(kUnits), std::end(kUnits), [&](const WrittenUnit& u) {
    return u.name == text.substr(0, length);
  });
  return found == std::end(kUnits) ? nullptr : found;
}

}  // namespace

std::string message_in_units(std::string_view text, UnitSystem units) {
  if (units == UnitSystem::SI) return std::string(text);
  std::string out;
  std::size_t at = 0;
  while (at < text.size()) {
    double value = 0.0;
    const bool starts_word = at == 0 || !is_word(text[at - 1]);
    const std::size_t length = starts_word ? number_length(text.substr(at), value) : 0;
    const WrittenUnit* written = length > 0 && text.substr(at + length, 1) == " "
                                     ? unit_at(text.substr(at + length + 1))
                                     : nullptr;
    if (written == nullptr) {
      const std::size_t step = std::max<std::size_t>(length, 1);
      out += text.substr(at, step);
      at += step;
      continue;
    }
    const double converted = value * written->prefix / written->unit->en_factor;
    const bool whole = std::abs(converted) >= 1e3 && std::abs(converted) < 1e7;
    const int digits = significant_digits(text.substr(at, length));
    out += fmt::format("{:.{}g} {}", converted, whole ? std::max(digits, 7) : digits,
                       written->unit->en);
    at += length + 1 + written->name.size();
  }
  return out;
}

}  // namespace adore::deck
