#include "base/errors.hpp"
#include "calculators/lubricant_curves.hpp"
#include "setup/run_control.hpp"
#include "tribology/film_law.hpp"
#include "tribology/lubricant.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

// The limiting shear stress of oil films (laws/limited.hpp), as a disc machine reads it.

using namespace adore;
using calculators::LubricantContact;

namespace {

constexpr std::array kSlipRatio{0.001, 0.003, 0.01, 0.03, 0.1, 0.3};

/// Coefficients over the slip ratios of one contact without metal contact.
std::vector<double> coefficients(LubricantContact contact, double celsius, double pressure) {
  contact.temperature = celsius + 273.15;
  contact.pressure = pressure;
  contact.critical_film = 0.0;
  std::vector<double> slips;
  for (const double ratio : kSlipRatio) slips.push_back(ratio * contact.speed);
  return calculators::solve_lubricant_contact(contact, slips).traction;
}
double largest(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}
LubricantContact of(int code) {
  LubricantContact out;
  out.code = code;
  return out;
}

/// Published ranges of the largest coefficient between discs (issue 43; sources in
/// lubricants.json).
std::array<double, 2> published(int code) {
  switch (code) {
    case 4:
    case 10:
    case 11:
    case 12:
      return {0.03, 0.08};  // MIL-L-23699
    case 1:
    case 18:
    case 19:
      return {0.04, 0.09};  // mineral
    case 2:
    case 6:
    case 7:
      return {0.04, 0.12};  // traction fluids
    case 3:
    case 8:
      return {0.03, 0.08};  // MIL-L-7808
    default:
      return {0.03, 0.08};  // PAO, other esters, PFPE
  }
}

}  // namespace

TEST_CASE("stress limit: every lubricant has one with a source, not one value for all",
          "[unit][lubricants]") {
  std::map<double, int> codes_of;
  for (const int code : tribology::lubricant_codes()) {
    CAPTURE(code);
    const tribology::Lubricant& oil = tribology::lubricant(code);
    CHECK(oil.limiting_ratio(313.15) > 0.0);
    CHECK(oil.limiting_ratio(373.15) < oil.limiting_ratio(313.15));
    ++codes_of[oil.limiting_ratio(313.15)];
    const bool own = oil.model == tribology::LubricantModel::ViscoElastic;
    const char* const name = own ? "traction.tau0p" : "limitingStress.ratio";
    CHECK(std::any_of(oil.sources.begin(), oil.sources.end(), [&](const auto& one) {
      return one.quantity == name && !one.source.empty() && !one.provenance.empty();
    }));
  }
  CHECK(codes_of.size() >= 8);
}

TEST_CASE(
    "stress limit: 0.5-3 GPa, 0-200 °C, slip to 30 % → largest coefficient in the published "
    "range, falling with temperature",
    "[physics][lubricants][slow]") {
  for (const int code : tribology::lubricant_codes()) {
    const auto [low, high] = published(code);
    double last = HUGE_VAL;
    for (const double celsius : {0.0, 40.0, 80.0, 120.0, 160.0, 200.0}) {
      LubricantContact free = of(code);
      free.stress_limit = false;
      double most = 0.0, without = 0.0;
      for (const double pressure : {0.5e9, 0.75e9, 1.0e9, 1.5e9, 2.0e9, 2.5e9, 3.0e9}) {
        most = std::max(most, largest(coefficients(of(code), celsius, pressure)));
        without = std::max(without, largest(coefficients(free, celsius, pressure)));
      }
      CAPTURE(code, celsius, most, without);
      // The laws of kTrac 11 and 20 do not reach the range in hot oil, with no limit either
      // (0.029 at 160 °C and 0.019 at 200 °C; 0.025 at 200 °C): nor may the limit take from them.
      if ((code == 11 && celsius > 120.0) || (code == 20 && celsius > 160.0)) {
        CHECK(without < low);
        CHECK(most >= 0.97 * without);
      } else {
        CHECK(most >= low);
      }
      CHECK(most <= high);
      CHECK(most < last);
      last = most;
    }
  }
}

TEST_CASE("recommended law: kTrac 4, 10, 11, 12 → within a factor of 2 above 1 % slip",
          "[physics][lubricants]") {
  const tribology::Oil oil = tribology::oil_of(4);
  CHECK(oil.codes == std::vector<int>{4, 10, 11, 12});
  CHECK(std::find(oil.codes.begin(), oil.codes.end(), oil.recommended) != oil.codes.end());
  double widest = 1.0, widest_by_code = 1.0;
  for (const double celsius : {0.0, 40.0, 80.0, 120.0, 200.0})
    for (const double pressure : {0.5e9, 1.0e9, 2.0e9, 3.0e9})
      for (const bool recommended : {true, false}) {
        std::map<double, std::array<double, 2>> ends;
        for (const int code : oil.codes) {
          LubricantContact contact = of(code);
          contact.recommended = recommended;
          const std::vector<double> kappa = coefficients(contact, celsius, pressure);
          for (std::size_t i = 0; i < kappa.size(); ++i) {
            if (kSlipRatio[i] < 0.01) continue;
            auto [at, first] = ends.try_emplace(kSlipRatio[i], std::array{kappa[i], kappa[i]});
            at->second[0] = std::min(at->second[0], kappa[i]);
            at->second[1] = std::max(at->second[1], kappa[i]);
          }
        }
        double& most = recommended ? widest : widest_by_code;
        for (const auto& [slip, end] : ends) most = std::max(most, end[1] / end[0]);
      }
  CAPTURE(widest, widest_by_code);
  CHECK(widest < 2.0);
  CHECK(widest_by_code > 5.0);  // what the recommended law is for
}

TEST_CASE(
    "stress limit: below 1 GPa → at most 2 % less where the classic law is below a third of it",
    "[physics][lubricants]") {
  int compared = 0, of_tested_oils = 0;
  for (const int code : tribology::lubricant_codes()) {
    const tribology::Lubricant& oil = tribology::lubricant(code);
    for (const double celsius : {0.0, 40.0, 80.0, 120.0, 200.0})
      for (const double pressure : {0.5e9, 0.75e9, 0.9e9}) {
        LubricantContact free = of(code);
        free.stress_limit = false;
        const std::vector<double> limited = coefficients(of(code), celsius, pressure),
                                  classic = coefficients(free, celsius, pressure);
        // Coefficients are means over the contact. Where that is 0.44 of the limit the middle can
        // reach it (kTrac 6: 7 % less, which takes 0.98 of the limit somewhere); hence a third.
        // kTrac 1, 3, 4 and 5: constants of disc tests; any slip at bearing temperatures.
        const bool tested = (code == 1 || code == 3 || code == 4 || code == 5) && celsius >= 40.0 &&
                            celsius <= 120.0;
        for (std::size_t i = 0; i < limited.size(); ++i) {
          CAPTURE(code, celsius, pressure, kSlipRatio[i], limited[i], classic[i]);
          CHECK(limited[i] <= classic[i] * (1.0 + 1e-12));
          if (!tested && 3.0 * classic[i] > oil.limiting_ratio(celsius + 273.15)) continue;
          CHECK(limited[i] >= 0.98 * classic[i]);
          ++compared;
          of_tested_oils += tested ? 1 : 0;
        }
      }
  }
  CHECK(compared > 1000);
  CHECK(of_tested_oils == 4 * 3 * 3 * static_cast<int>(kSlipRatio.size()));
}

TEST_CASE("stress limit: user lubricant → own value, 0.07 assumed without one, none when off",
          "[unit][lubricants]") {
  bearing::Lubrication lubrication;
  lubrication.code = 9;
  lubrication.user = {"mine", 313.0, 0.03, 1.5e-8, 4000.0, 0.14, 900.0,
                      2000.0, 0.2,   6e-9, 0.03,   {},     0.003};
  const auto limit = [&](double T) {
    return tribology::lubricant_of(lubrication).limiting_ratio(T);
  };
  CHECK(limit(313.15) == Approx(tribology::kUserLimit));
  lubrication.user->limit_ratio = 0.05;
  lubrication.user->limit_softening = 0.01;
  CHECK(limit(313.15) == Approx(0.05));
  CHECK(limit(413.15) == Approx(0.05 * std::exp(-1.0)));
  LubricantContact contact;
  contact.code = 9;
  contact.user = lubrication.user;
  const double most = largest(coefficients(contact, 40.0, 3e9));
  CHECK(most <= 0.05);
  CHECK(most > 0.045);
  lubrication.stress_limit = false;
  CHECK(limit(313.15) == 0.0);
  contact.stress_limit = false;
  CHECK(largest(coefficients(contact, 40.0, 3e9)) > 0.2);
}

TEST_CASE("run options: filmStressLimit, lubStressLimit → read, or rejected with their meaning",
          "[unit][options]") {
  const setup::RunOptions plain = setup::build_run_options({});
  CHECK(plain.stress_limit);
  CHECK_FALSE(plain.user_limit.has_value());
  const setup::RunOptions set = setup::build_run_options(
      {{"filmStressLimit", "off"}, {"lubStressLimit", "0.06"}, {"lubStressSoftening", "0.004"}});
  CHECK_FALSE(set.stress_limit);
  CHECK(set.user_limit == 0.06);
  CHECK(set.user_softening == 0.004);
  CHECK_THROWS_AS(setup::build_run_options({{"filmStressLimit", "no"}}), InputError);
  CHECK_THROWS_AS(setup::build_run_options({{"lubStressLimit", "-1"}}), InputError);
}
