#include "core/runs/deck_runs.hpp"
#include "deck/templates.hpp"
#include "integrators/stepper.hpp"
#include "runs/measured_run.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

/// No method may be wrong and say nothing: on decks that are hard to integrate each one gives the
/// means of a far more accurate run, or refuses, or ends with a failure, or warns of its energy.
using namespace adore;
using runs::RunStatus;

namespace {

using Sets = std::vector<std::pair<std::string, std::string>>;

struct Hard {
  const char* name;
  const char* until;
  Sets sets;
  /// Of a mean, for runs with free steps at 1e-4. Near-conformal: the largest load of such runs
  /// whose radial load differs in the sixth digit lies between 360 and 399 N (rkf5) or 338 and 343
  /// N (arkode-erk, which damps the contact vibration), where precise ones have 362 to 368 N.
  double loose = 0.03;
};

const std::array<Hard, 6> kHard{{
    {"as it is", "1rev", {}},
    {"radial", "1rev", {{"appLoadX", "300"}, {"appLoadZ", "3000"}}},
    // Newton's error of implicit methods had the heat of the cage 3 % off (decision 415).
    {"vanishing load", "2rev", {{"appLoadX", "0.001"}}},
    {"near-conformal",
     "0.2rev",
     {{"raceCurFac1", "0.503"}, {"raceCurFac2", "0.503"}, {"appLoadX", "300"}},
     0.1},
    {"stiff traction",
     "0.01rev",
     {{"rpm2", "500"},
      {"appLoadX", "10000"},
      {"reRaceTC2", "0.18"},
      {"reRaceTC3", "0.12"},
      {"reRaceTC4", "0.016"}}},
    {"one ball",
     "0.3rev",
     {{"nRe", "1"}, {"nCseg", "0"}, {"kNumPltElem", "2"}, {"kPltElemInd", "1,3"}}},
}};

constexpr std::array<const char*, 3> kMeans{"mean_largest_load_N", "mean_power_loss_W",
                                            "mean_orbital_ratio"};
using Means = std::array<double, 3>;

struct Told {
  std::optional<Means> means;  ///< of a run that says nothing against itself
  std::string against;
};

Told run(const Hard& hard, std::string_view method, double tolerance, const Sets& more) {
  runs::RunRequest request;
  request.text = deck::write_deck(deck::new_deck("ball"));
  request.sets = more;
  // Few steps are stored: of the fourteen that arkode-dirk needs of one ball at 1e-4 three, whose
  // mean load is 10 % high. The means are those of all steps (0.4 %).
  for (const auto& set : hard.sets)
    if (std::none_of(more.begin(), more.end(),
                     [&](const auto& other) { return other.first == set.first; }))
      request.sets.push_back(set);
  request.until = hard.until;
  request.integrator = method;
  request.tolerance = tolerance;
  try {
    const runs::MeasuredRun ran = runs::measured_run(request, 120.0, {});
    if (ran.outcome.status != RunStatus::Done) return {{}, ran.outcome.message};
    for (const Issue& issue : ran.outcome.warnings)
      if (issue.severity == Severity::Warning &&
          (issue.message.find("energy residual of") != std::string::npos ||
           issue.message.find("missed the tolerance") != std::string::npos))
        return {{}, issue.message};
    Means means{};
    for (std::size_t k = 0; k < means.size(); ++k)
      means[k] = results::value_of(ran.outcome.summary, kMeans[k]);
    return {means, ""};
  } catch (const InputError& error) {
    return {{}, error.what()};
  } catch (const SolverError& error) {
    return {{}, error.what()};
  }
}

/// The radial load, a little larger or smaller.
Sets beside(const Hard& hard, double share) {
  const bool given = std::any_of(hard.sets.begin(), hard.sets.end(),
                                 [](const auto& set) { return set.first == "appLoadZ"; });
  return {{"appLoadZ", fmt::format("{:.12g}", (1.0 + share) * (given ? 3000.0 : 500.0))}};
}

/// Every method is right about this deck, or says that it is not.
void check_methods(const Hard& hard) {
  // Runs whose loads hardly differ: how far right runs may differ. One of them alone may lie close
  // by chance (361.34 and 361.49 N where others have 362.6 and 367.4).
  const Told reference = run(hard, "rkf7", 1e-8, {});
  INFO(hard.name << ": " << reference.against);
  REQUIRE(reference.means);
  Means spreads{};
  for (const double share : {1e-6, -1e-5, 2e-8}) {
    const Told other = run(hard, "rkf7", 1e-8, beside(hard, share));
    REQUIRE(other.means);
    for (std::size_t k = 0; k < kMeans.size(); ++k)
      spreads[k] = std::max(spreads[k], std::abs((*other.means)[k] - (*reference.means)[k]));
  }
  int told = 0;
  for (const std::string_view method : integrators::stepper_names())
    for (const bool free : {false, true}) {
      const Told one =
          free ? run(hard, method, 1e-4, {{"stpMax", "1000"}}) : run(hard, method, 1e-6, {});
      if (!one.means) {
        CHECK_FALSE(one.against.empty());
        continue;
      }
      ++told;
      for (std::size_t k = 0; k < kMeans.size(); ++k) {
        const double is = (*reference.means)[k], size = std::abs(is);
        INFO(hard.name << ", " << method << (free ? ", free steps at 1e-4" : "") << ": "
                       << kMeans[k] << " is " << (*one.means)[k] << " for " << is << ", spread "
                       << spreads[k]);
        CHECK(std::abs((*one.means)[k] - is) <=
              std::max((free ? hard.loose : 0.03) * size, 5.0 * spreads[k]));
      }
    }
  INFO(hard.name << ": " << told << " runs said nothing against themselves");
  CHECK(told >= 3);  // stiff traction at 1e-4 is nothing for explicit methods
}

}  // namespace

TEST_CASE("integrators: wrong result → always reported", "[physics][runs][slow]") {
  check_methods(kHard[GENERATE(3UL, 4UL, 5UL)]);
}

TEST_CASE("integrators: wrong result of a whole revolution → always reported",
          "[physics][runs][slow][nightly]") {
  check_methods(kHard[GENERATE(0UL, 1UL, 2UL)]);
}
