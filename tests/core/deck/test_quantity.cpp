#include "deck/quantity.hpp"
#include "deck/units.hpp"

#include <catch2/catch.hpp>

using namespace adore;
using deck::UnitSystem;

namespace {

double taken(const char* text, const deck::UnitPair& unit, UnitSystem system = UnitSystem::SI) {
  double value = 0.0;
  const deck::NumberProblem problem = deck::parse_quantity(text, unit, system, value);
  INFO(text << ": " << problem.message);
  REQUIRE_FALSE(problem);
  return value;
}

bool refused(const char* text, const deck::UnitPair& unit) {
  double value = 0.0;
  const deck::NumberProblem problem = deck::parse_quantity(text, unit, UnitSystem::SI, value);
  if (problem) CHECK_FALSE(problem.remedy.empty());
  return static_cast<bool>(problem);
}

}  // namespace

TEST_CASE("parse quantity: usual notations → read", "[unit][deck]") {
  namespace unit = deck::unit;
  CHECK(taken("12.7 mm", unit::kLength) == 0.0127);
  CHECK(taken("12.7mm", unit::kLength) == 0.0127);
  CHECK(taken("1/2 in", unit::kLength) == 0.0127);
  CHECK(taken("1/2 \"", unit::kLength) == 0.0127);
  CHECK(taken("1 in + 2 mm", unit::kLength) == 0.0274);
  CHECK(taken("3*0.005", unit::kLength) == 0.015);
  CHECK(taken("(25 - 15)/2 mm", unit::kLength) == 0.005);
  CHECK(taken("-4 µm", unit::kLength) == -4e-6);
  CHECK(taken("12.7 mm", unit::kLength, UnitSystem::English) == 0.5);
  CHECK(taken("80 °C", unit::kTemperature) == 353.15);
  CHECK(taken("68 degF", unit::kTemperature, UnitSystem::English) == 527.67);
  CHECK(taken("-40 C", unit::kTemperature) == taken("-40 F", unit::kTemperature));
  CHECK(taken("206 GPa", unit::kStress) == 2.06e11);
  CHECK(taken("206000 N/mm²", unit::kStress) == 2.06e11);
  CHECK(taken("206e3 N/mm^2", unit::kStress) == 2.06e11);
  CHECK(taken("1000 rad/s", unit::kRotation) == Approx(9549.296585513721).epsilon(1e-15));
  CHECK(taken("100 rev/s", unit::kRotation) == Approx(6000.0).epsilon(1e-15));
  CHECK(taken("5 cP", unit::kViscosity) == 0.005);
  CHECK(taken("5 mPa s", unit::kViscosity) == Approx(0.005));
  CHECK(taken("45 W/(m K)", unit::kConductivity) == 45.0);
  CHECK(taken("45 W/m/K", unit::kConductivity) == 45.0);
  CHECK(taken("6 l/min", unit::kVolumeFlow) == Approx(1e-4).epsilon(1e-15));
  CHECK(taken("40 deg", unit::kAngle) == 40.0);
  CHECK(taken("40°", unit::kAngle) == 40.0);
  CHECK(taken("2 kN", unit::kForce) == 2000.0);
  CHECK(taken("3*2", unit::kPure) == 6.0);
}

TEST_CASE("parse quantity: meaningless text → error with remedy", "[unit][deck]") {
  namespace unit = deck::unit;
  for (const char* wrong : {"12.7 furlong", "3 N", "1 in + 2", "80 °C", "2 mm mm", "1/0", "(1",
                            "mm", "", "1 +", "2 mm 3", "1 m/s", "12.7 m m", "1e400 mm", "x"}) {
    INFO(wrong);
    CHECK(refused(wrong, unit::kLength));
  }
  CHECK(refused("80 °C + 1 K", unit::kTemperature));
  CHECK(refused("2*80 °C", unit::kTemperature) ==
        false);  // 160 °C: the product stands before the unit
  CHECK(refused("80 °C * 2", unit::kTemperature));
  CHECK(refused("3 mm", unit::kPure));
  CHECK(refused(std::string(500, '(').c_str(), unit::kLength));
}

TEST_CASE("parse quantity: value displayed in another unit → reproduced", "[unit][deck]") {
  namespace unit = deck::unit;
  const deck::UnitPair pairs[] = {unit::kLength,  unit::kAngle,      unit::kRotation,
                                  unit::kForce,   unit::kStress,     unit::kTemperature,
                                  unit::kMoment,  unit::kViscosity,  unit::kMass,
                                  unit::kDensity, unit::kVolumeFlow, unit::kInertia};
  for (const deck::UnitPair& pair : pairs)
    for (const std::string_view name : deck::usual_units(pair))
      for (const double value : {0.0127, 40.0, 293.15, 1.0 / 3.0, 123456.789, 6.4e-7})
        for (const UnitSystem system : {UnitSystem::SI, UnitSystem::English}) {
          const std::string text = deck::number_in_unit(value, pair, system, name);
          INFO(text << " " << name);
          CHECK(taken((text + " " + std::string(name)).c_str(), pair, system) ==
                Approx(value).epsilon(2e-15).margin(pair.si == "K" ? 1e-12 : 0.0));
        }
  CHECK(deck::number_in_unit(0.0127, unit::kLength, UnitSystem::SI, "mm") == "12.7");
  CHECK(deck::number_in_unit(353.15, unit::kTemperature, UnitSystem::SI, "°C") == "80");
  CHECK(deck::number_in_unit(0.5, unit::kLength, UnitSystem::English, "mm") == "12.7");
  CHECK(deck::usual_units(unit::kPure).empty());
}
