#include "deck/quantity.hpp"

#include "base/errors.hpp"
#include "deck/number.hpp"
#include "deck/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>

namespace adore::deck {
namespace {

/// Exponents of meter, kilogram, second, kelvin and radian.
using Dimension = std::array<int, 5>;
constexpr Dimension kPureNumber{};

struct Unit {
  double factor = 1.0;  ///< to coherent SI with radians
  Dimension dimension{};
  double offset = 0.0;  ///< [K] of the zero of a temperature scale
};

struct Word {
  std::string_view name;
  Unit unit;
};

constexpr Dimension kMetre{1, 0, 0, 0, 0}, kKilogram{0, 1, 0, 0, 0}, kSecond{0, 0, 1, 0, 0},
    kKelvin{0, 0, 0, 1, 0}, kRad{0, 0, 0, 0, 1}, kNewton{1, 1, -2, 0, 0}, kPascal{-1, 1, -2, 0, 0},
    kJoule{2, 1, -2, 0, 0}, kWatt{2, 1, -3, 0, 0}, kHertz{0, 0, -1, 0, 0}, kTurning{0, 0, -1, 0, 1},
    kPoise{-1, 1, -1, 0, 0}, kStoke{2, 0, -1, 0, 0}, kVolume{3, 0, 0, 0, 0};
constexpr double kPsi = unit::kPoundForce / (unit::kInch * unit::kInch);
constexpr double kIceK = 273.15, kIceF = 459.67 * unit::kRankine;

constexpr std::array kWords = {
    Word{"m", {1.0, kMetre}},
    Word{"km", {1e3, kMetre}},
    Word{"cm", {1e-2, kMetre}},
    Word{"mm", {1e-3, kMetre}},
    Word{"\u00b5m", {1e-6, kMetre}},
    Word{"\u03bcm", {1e-6, kMetre}},
    Word{"um", {1e-6, kMetre}},
    Word{"micron", {1e-6, kMetre}},
    Word{"nm", {1e-9, kMetre}},
    Word{"in", {unit::kInch, kMetre}},
    Word{"inch", {unit::kInch, kMetre}},
    Word{"\"", {unit::kInch, kMetre}},
    Word{"mil", {unit::kInch * 1e-3, kMetre}},
    Word{"ft", {unit::kInch * 12.0, kMetre}},
    Word{"kg", {1.0, kKilogram}},
    Word{"g", {1e-3, kKilogram}},
    Word{"mg", {1e-6, kKilogram}},
    Word{"t", {1e3, kKilogram}},
    Word{"lbm", {unit::kPoundMass, kKilogram}},
    Word{"lb", {unit::kPoundMass, kKilogram}},
    Word{"s", {1.0, kSecond}},
    Word{"ms", {1e-3, kSecond}},
    Word{"\u00b5s", {1e-6, kSecond}},
    Word{"us", {1e-6, kSecond}},
    Word{"min", {60.0, kSecond}},
    Word{"h", {3600.0, kSecond}},
    Word{"K", {1.0, kKelvin}},
    Word{"R", {unit::kRankine, kKelvin}},
    Word{"\u00b0R", {unit::kRankine, kKelvin}},
    Word{"\u00b0C", {1.0, kKelvin, kIceK}},
    Word{"degC", {1.0, kKelvin, kIceK}},
    Word{"C", {1.0, kKelvin, kIceK}},
    Word{"\u00b0F", {unit::kRankine, kKelvin, kIceF}},
    Word{"degF", {unit::kRankine, kKelvin, kIceF}},
    Word{"F", {unit::kRankine, kKelvin, kIceF}},
    Word{"rad", {1.0, kRad}},
    Word{"mrad", {1e-3, kRad}},
    Word{"deg", {kDegree, kRad}},
    Word{"\u00b0", {kDegree, kRad}},
    Word{"arcmin", {kDegree / 60.0, kRad}},
    Word{"rev", {2.0 * kPi, kRad}},
    Word{"rpm", {unit::kRpm, kTurning}},
    Word{"Hz", {1.0, kHertz}},
    Word{"kHz", {1e3, kHertz}},
    Word{"N", {1.0, kNewton}},
    Word{"mN", {1e-3, kNewton}},
    Word{"kN", {1e3, kNewton}},
    Word{"MN", {1e6, kNewton}},
    Word{"lbf", {unit::kPoundForce, kNewton}},
    Word{"kgf", {9.80665, kNewton}},
    Word{"Pa", {1.0, kPascal}},
    Word{"mPa", {1e-3, kPascal}},
    Word{"kPa", {1e3, kPascal}},
    Word{"MPa", {1e6, kPascal}},
    Word{"GPa", {1e9, kPascal}},
    Word{"TPa", {1e12, kPascal}},
    Word{"bar", {1e5, kPascal}},
    Word{"psi", {kPsi, kPascal}},
    Word{"ksi", {kPsi * 1e3, kPascal}},
    Word{"J", {1.0, kJoule}},
    Word{"kJ", {1e3, kJoule}},
    Word{"W", {1.0, kWatt}},
    Word{"kW", {1e3, kWatt}},
    Word{"P", {0.1, kPoise}},
    Word{"cP", {1e-3, kPoise}},
    Word{"cSt", {1e-6, kStoke}},
    Word{"l", {1e-3, kVolume}},
    Word{"L", {1e-3, kVolume}},
    Word{"ml", {1e-6, kVolume}},
    Word{"%", {0.01, kPureNumber}},
};

const Unit* word(std::string_view name) {
  const auto found = std::find_if(kWords.begin(), kWords.end(),
                                  [&](const Word& candidate) { return candidate.name == name; });
  return found == kWords.end() ? nullptr : &found->unit;
}

Unit power(const Unit& unit, int exponent) {
  Unit out;
  out.factor = std::pow(unit.factor, exponent);
  for (std::size_t k = 0; k < out.dimension.size(); ++k)
    out.dimension[k] = unit.dimension[k] * exponent;
  return out;
}

Unit product(const Unit& a, const Unit& b, int sign) {
  Unit out = power(b, sign);
  out.factor *= a.factor;
  for (std::size_t k = 0; k < out.dimension.size(); ++k) out.dimension[k] += a.dimension[k];
  return out;
}

constexpr int kDigits = 15;  // that a double keeps of what a person typed

/// A number, or a number of something.
struct Amount {
  double value = 0.0;
  std::optional<Unit> unit;  ///< value is in coherent SI then
  bool point = false;        ///< of a scale with an offset zero
};

struct Failure {
  NumberProblem problem;
};

[[noreturn]] void fail(std::string message, std::string remedy) {
  throw Failure{{std::move(message), std::move(remedy)}};
}

/// Recursive descent: sum := product {+- product}, product := factor {*/ factor} [unit] ...
class QuantityParser {
 public:
  explicit QuantityParser(std::string_view text) : text_(text) {}

  Amount whole() {
    Amount out = sum(0);
    blanks();
    if (at_ < text_.size())
      fail(fmt::format("contains '{}', which is not part of a quantity", text_.substr(at_)),
           kExample);
    return out;
  }
  Unit unit_alone() {
    Unit out = units();
    if (at_ < text_.size()) fail("is not a unit", kExample);
    return out;
  }

 private:
  static constexpr const char* kExample = "write a number, 12.7 mm, 1/2 in, 80 °C or 3*0.005";
  static constexpr int kDeepest = 50;  // brackets

  void blanks() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
  }
  [[nodiscard]] char here() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  [[nodiscard]] bool starts_unit() const {
    const auto c = static_cast<unsigned char>(here());
    return std::isalpha(c) != 0 || c == '"' || c == '%' || c >= 0x80;
  }

  Amount sum(int depth) {
    Amount out = term(depth);
    for (blanks(); here() == '+' || here() == '-'; blanks()) {
      const double sign = text_[at_++] == '+' ? 1.0 : -1.0;
      const Amount next = term(depth);
      if (out.unit.has_value() != next.unit.has_value())
        fail("has a unit in only some of its terms", "give a unit to every term or to no term");
      if (out.unit && out.unit->dimension != next.unit->dimension)
        fail("adds different kinds of quantities", kExample);
      if (out.point || next.point)
        fail("adds temperatures in °C or °F, whose zero is not absolute zero",
             "give one temperature");
      out.value += sign * next.value;
    }
    return out;
  }

  Amount term(int depth) {
    Amount out = factor(depth);
    for (blanks(); here() == '*' || here() == '/' || starts_unit(); blanks()) {
      if (starts_unit()) {
        if (out.unit) fail("has two units", kExample);
        out.unit = units();
        out.point = out.unit->offset != 0.0;
        out.value = out.value * out.unit->factor + out.unit->offset;
        continue;
      }
      const int sign = text_[at_++] == '*' ? 1 : -1;
      const Amount next = factor(depth);
      if (out.point || next.point)
        fail("multiplies a temperature in °C or °F, whose zero is not absolute zero",
             "give one temperature");
      if (sign < 0 && next.value == 0.0) fail("divides by zero", "give a divisor other than 0");
      out.value = sign > 0 ? out.value * next.value : out.value / next.value;
      if (next.unit) out.unit = product(out.unit.value_or(Unit{}), *next.unit, sign);
    }
    return out;
  }

  Amount factor(int depth) {
    blanks();
    if (depth > kDeepest) fail("has too many brackets", kExample);
    if (here() == '+' || here() == '-') {
      const bool negative = text_[at_++] == '-';
      Amount out = factor(depth + 1);
      if (negative) out.value = -out.value;
      return out;
    }
    if (here() == '(') {
      ++at_;
      Amount out = sum(depth + 1);
      blanks();
      if (here() != ')') fail("has no closing bracket", kExample);
      ++at_;
      return out;
    }
    return {number(), {}, false};
  }

  double number() {
    std::size_t end = at_;
    const auto digit = [&] {
      return end < text_.size() && std::isdigit(static_cast<unsigned char>(text_[end])) != 0;
    };
    while (digit() || (end < text_.size() && text_[end] == '.')) ++end;
    if (end == at_) {
      if (at_ == text_.size()) fail("ends where a number is expected", kExample);
      fail(fmt::format("has '{}' where a number is expected", text_.substr(at_)), kExample);
    }
    // An exponent needs digits after its letter: "3 d" is not an exponent, and neither is "2 deg".
    if (end < text_.size() && std::string_view("eEdD").find(text_[end]) != std::string_view::npos) {
      const std::size_t letter = end++;
      if (end < text_.size() && (text_[end] == '+' || text_[end] == '-')) ++end;
      const std::size_t first = end;
      while (digit()) ++end;
      if (end == first) end = letter;
    }
    double value = 0.0;
    if (NumberProblem problem = parse_real(text_.substr(at_, end - at_), value))
      throw Failure{std::move(problem)};
    at_ = end;
    return value;
  }

  Unit units() {
    Unit out = unit_power();
    for (;;) {
      const std::size_t before = at_;
      blanks();
      int sign = 1;
      if (here() == '/') sign = -1;
      const bool middle_dot = text_.substr(at_).starts_with("\u00b7");
      if (here() == '/' || here() == '.' || here() == '*')
        ++at_;
      else if (middle_dot)
        at_ += 2;
      blanks();
      if (here() == '(' && sign < 0) {  // W/(m K)
        ++at_;
        blanks();
        if (starts_unit()) {
          out = product(out, units(), sign);
          blanks();
          if (here() != ')') fail("has no closing bracket", kExample);
          ++at_;
          continue;
        }
      } else if (starts_unit()) {
        out = product(out, unit_power(), sign);
        continue;
      }
      at_ = before;
      return out;
    }
  }

  Unit unit_power() {
    std::size_t end = at_;
    const auto part = [&](unsigned char c) {
      return std::isalpha(c) != 0 || c >= 0x80 || c == '"' || c == '%';
    };
    const auto superscript = [&](std::size_t i) {
      return text_.substr(i).starts_with("\u00b2") || text_.substr(i).starts_with("\u00b3") ||
             text_.substr(i).starts_with("\u00b7");
    };
    while (end < text_.size() && part(static_cast<unsigned char>(text_[end])) && !superscript(end))
      ++end;
    const std::string_view name = text_.substr(at_, end - at_);
    const Unit* unit = word(name);
    if (unit == nullptr) fail(fmt::format("has the unknown unit '{}'", name), kExample);
    at_ = end;
    int exponent = 1;
    if (text_.substr(at_).starts_with("\u00b2") || text_.substr(at_).starts_with("\u00b3")) {
      exponent = text_.substr(at_).starts_with("\u00b2") ? 2 : 3;
      at_ += 2;
    } else {
      if (text_.substr(at_).starts_with("**")) at_ += 2;
      if (here() == '^') ++at_;
      const bool minus = here() == '-' && at_ > 0 && text_[at_ - 1] == '^';
      if (minus) ++at_;
      if (std::isdigit(static_cast<unsigned char>(here())) != 0) exponent = text_[at_++] - '0';
      if (minus) exponent = -exponent;
    }
    return exponent == 1 ? *unit : power(*unit, exponent);
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

/// Nothing for pure numbers and for counts and scales that have no other units.
std::optional<Unit> unit_of(const UnitPair& pair) {
  for (const std::string_view none : {"", "-", "cycle/rev", "HRC"})
    if (pair.si == none) return std::nullopt;
  return pair.si == "1/K" ? power(*word("K"), -1) : QuantityParser(pair.si).unit_alone();
}

double factor_of(const UnitPair& pair, UnitSystem system) {
  return system == UnitSystem::English ? pair.en_factor : pair.si_factor;
}

struct Usual {
  std::string_view si;
  std::array<std::string_view, 5> units;
  std::size_t count;
};
constexpr std::array kUsual = {
    Usual{"m", {"m", "mm", "\u00b5m", "in"}, 4},
    Usual{"deg", {"deg", "mrad", "arcmin", "rad"}, 4},
    Usual{"rad", {"rad", "mrad", "deg", "arcmin"}, 4},
    Usual{"m/s", {"m/s", "mm/s", "in/s"}, 3},
    Usual{"rpm", {"rpm", "rad/s", "rev/s"}, 3},
    Usual{"kg", {"kg", "g", "lbm"}, 3},
    Usual{"kg.m^2", {"kg.m^2", "kg.mm^2", "lbm.in^2"}, 3},
    Usual{"N", {"N", "kN", "lbf"}, 3},
    Usual{"N.m", {"N.m", "N.mm", "lbf.in"}, 3},
    Usual{"N/m^2", {"N/m^2", "MPa", "GPa", "psi"}, 4},
    Usual{"kg/m^3", {"kg/m^3", "g/cm^3", "lbm/in^3"}, 3},
    Usual{"K", {"K", "\u00b0C", "\u00b0F", "R"}, 4},
    Usual{"m^3/s", {"m^3/s", "l/min", "in^3/s"}, 3},
    Usual{"N.s/m^2", {"N.s/m^2", "cP", "lbf.s/in^2"}, 3},
    Usual{"s", {"s", "ms"}, 2},
    Usual{"Hz", {"Hz", "kHz"}, 2},
};

}  // namespace

NumberProblem parse_quantity(std::string_view text, const UnitPair& unit, UnitSystem system,
                             double& value) {
  try {
    const Amount amount = QuantityParser(text).whole();
    const std::optional<Unit> wanted = unit_of(unit);
    if (amount.unit) {
      const Dimension dimension = wanted ? wanted->dimension : kPureNumber;
      if (amount.unit->dimension != dimension)
        return {"has a unit of a different quantity",
                wanted
                    ? fmt::format(
                          "give the value in {}, or in a unit that can be converted to this unit",
                          system == UnitSystem::English ? unit.en : unit.si)
                    : std::string("give a pure number")};
      value = amount.value / factor_of(unit, system);
    } else {
      value = amount.value;
    }
    if (!std::isfinite(value)) return {"is too large for a number", "give a value below 1.0e+308"};
    value = rounded_to_digits(value, kDigits);
    return {};
  } catch (Failure& failure) {
    return std::move(failure.problem);
  }
}

std::span<const std::string_view> usual_units(const UnitPair& unit) {
  for (const Usual& usual : kUsual)
    if (usual.si == unit.si) return {usual.units.data(), usual.count};
  return {};
}

std::string number_in_unit(double value, const UnitPair& unit, UnitSystem system,
                           std::string_view wanted) {
  const Unit to = QuantityParser(wanted).unit_alone();
  demand(unit_of(unit) && unit_of(unit)->dimension == to.dimension,
         fmt::format("{} is not a unit of {}", wanted, unit.si));
  const double si = value * factor_of(unit, system);
  const double exact = (si - to.offset) / to.factor;
  for (int digits = 1; digits <= kDigits; ++digits) {
    const double candidate = rounded_to_digits(exact, digits);
    const double back =
        rounded_to_digits((candidate * to.factor + to.offset) / factor_of(unit, system), kDigits);
    if (back == value) return fmt::format("{}", candidate);
  }
  return fmt::format("{}", exact);
}

}  // namespace adore::deck
