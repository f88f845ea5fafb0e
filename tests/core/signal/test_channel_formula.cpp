#include "base/errors.hpp"
#include "signal/channel_formula.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using namespace adore::signal;
using Catch::Contains;

TEST_CASE("evaluate: formula over two channels → its value at each step", "[unit]") {
  const NamedSeries series{{"Fy", {3.0, 0.0, -5.0}}, {"Fz", {4.0, 2.0, 12.0}}};
  CHECK(evaluate("sqrt(Fy^2+Fz^2)", series) == std::vector<double>{5.0, 2.0, 13.0});
  CHECK(evaluate("2*pi*Fz", series)[1] == Approx(4.0 * 3.14159265358979));
  CHECK(variable_names_in("sqrt(Fy^2 + Fz^2) + abs(Fy)") == std::vector<std::string>{"Fy", "Fz"});
}

TEST_CASE("evaluate: missing values and results that are not numbers → missing", "[unit]") {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> out = evaluate("sqrt(a)", {{"a", {4.0, none, -1.0}}});
  CHECK(out[0] == 2.0);
  CHECK(std::isnan(out[1]));
  CHECK(std::isnan(out[2]));
}

TEST_CASE("evaluate: wrong formulas → message with the cause", "[unit]") {
  const NamedSeries series{{"a", {1.0}}, {"b", {1.0, 2.0}}};
  CHECK_THROWS_WITH(evaluate("a + c", series),
                    Contains("\"c\" is not a channel") && Contains("a, b"));
  CHECK_THROWS_WITH(evaluate("a + b", series), Contains("different numbers of values"));
  CHECK_THROWS_AS(evaluate("a +", series), adore::InputError);
  CHECK_THROWS_AS(evaluate("", series), adore::InputError);
  CHECK_THROWS_WITH(evaluate("3", series), Contains("no channel"));
}

TEST_CASE("is_formula_name: letters, digits, underscores; no function names", "[unit]") {
  for (const char* name : {"Fy", "a1", "_x", "load_outer"}) CHECK(is_formula_name(name));
  for (const char* name : {"", "1a", "a b", "sqrt", "pi", "_pi", "a-b", "µ"})
    CHECK_FALSE(is_formula_name(name));
}
