#include "deck/templates.hpp"
#include "runs/measured_run.hpp"
#include "runs/prepare.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

/// Record 6.2: what is said to play no part changes nothing, and the rest acts.
using namespace adore;

namespace {

using Sets = std::vector<std::pair<std::string, std::string>>;

struct Freedom {
  const char* name;
  Sets flags;
  std::set<std::string> acting;  ///< those whose change must be seen
};

const Freedom kFreedoms[] = {
    {"held", {}, {}},
    {"held, kDCR 1", {{"kDCR", "1"}}, {}},
    {"moves", {{"kDCR", "1"}, {"kFD12", "0"}, {"kFD22", "0"}, {"kFD32", "0"}}, {"raceMass2"}},
    {"turns", {{"kDCR", "1"}, {"kMD12", "0"}}, {"raceMIx2"}},
    {"tilts", {{"kDCR", "1"}, {"kMD22", "0"}, {"kMD32", "0"}}, {"raceMIy2", "raceMIz2"}},
};
const Sets kInertia{{"kRaceIP2", "1"},        {"raceMass2", "0.3"},     {"raceMIx2", "2e-4"},
                    {"raceMIy2", "1.4e-4"},   {"raceMIz2", "1.5e-4"},   {"raceGeoCenX2", "1e-5"},
                    {"raceGeoCenY2", "1e-5"}, {"raceGeoCenZ2", "1e-5"}, {"raceFrameX2", "3"},
                    {"raceFrameY2", "2"},     {"raceFrameZ2", "1"}};

runs::RunRequest request_of(const Freedom& freedom, const std::string& changed = {},
                            const std::string& value = {}) {
  runs::RunRequest request;
  request.text = deck::write_deck(deck::new_deck("ball"));
  request.sets = freedom.flags;
  for (const auto& set : kInertia)
    request.sets.emplace_back(set.first, set.first == changed ? value : set.second);
  request.until = "6e-5s";
  return request;
}

std::vector<double> results_of(const runs::RunRequest& request) {
  const runs::MeasuredRun run = runs::measured_run(request, 60.0, {});
  REQUIRE(run.outcome.status == runs::RunStatus::Done);
  std::vector<double> out;
  // The residual rounds with the energy of the race, which turns whether it is held or not.
  for (const results::KeyResult& key : run.outcome.summary)
    if (key.of.id != "energy_residual_J") out.push_back(key.value);
  return out;
}

std::set<std::string> named(const runs::RunRequest& request) {
  std::set<std::string> out;
  for (const deck::NoPart& value : runs::prepare(request).no_part) out.insert(value.variable);
  return out;
}

}  // namespace

TEST_CASE("race inertia: acts, or is listed as unused, in every free direction", "[runs]") {
  for (const Freedom& freedom : kFreedoms) {
    CAPTURE(freedom.name);
    const std::vector<double> usual = results_of(request_of(freedom));
    const std::set<std::string> without_part = named(request_of(freedom));
    for (const auto& [variable, value] : kInertia) {
      if (variable == "kRaceIP2") continue;
      CAPTURE(variable);
      const bool acts = freedom.acting.contains(variable);
      const bool said = without_part.contains(variable);
      CHECK_FALSE((acts && said));
      if (!acts && !said) continue;
      const std::vector<double> other =
          results_of(request_of(freedom, variable, fmt::format("{:g}", 1.2 * std::stod(value))));
      CHECK((other != usual) == acts);
    }
    if (freedom.acting.empty()) CHECK(without_part.contains("raceMass2"));
  }
}
