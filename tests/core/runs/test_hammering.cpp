#include "core/runs/deck_runs.hpp"
#include "deck/templates.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

/// Rollers with play between a free race and one that is held away from them: line contacts that
/// close at speed, and a race so heavy that a velocity error within the tolerance costs more energy
/// than moves in many steps (decision 392).
using namespace adore;

namespace {

deck::Deck hammering() {
  deck::Deck deck = deck::new_deck("cylindrical");
  const std::vector<std::pair<std::string, std::string>> sets{
      {"kDCR", "1"},          {"kFD11", "0"},       {"kFD21", "0"},         {"kFD31", "0"},
      {"kRaceIP2", "1"},      {"raceMass2", "0.3"}, {"raceMIx2", "2e-4"},   {"raceMIy2", "1.4e-4"},
      {"raceMIz2", "1.4e-4"}, {"kRotFrame", "1"},   {"brgOrbitRad", "0.1"}, {"brgAngVel", "500"},
      {"brgLoadFrac2", "1"},  {"nCseg", "0"},       {"kFS3", "1"},          {"appDispZ", "1e-5"},
      {"fTime", "110"},       {"kPltFreq", "1000"}, {"kNumPltElem", "1"},   {"kPltElemInd", "1"},
      {"nStps", "1"},         {"kLifeFreq", "0"}};
  deck.set_all(sets);
  return deck;
}

}  // namespace

TEST_CASE("rollers that hammer a free race: energy ledger closes", "[validation][integrators]") {
  const testing::TemporaryFolder folder;
  const testing::Ran run = testing::run_deck(hammering(), folder / "run");
  const double share = std::abs(run.outcome.energy_residual) / run.outcome.energy_scale;
  INFO("residual " << run.outcome.energy_residual << " J of " << run.outcome.energy_scale << " J, "
                   << run.outcome.taken << " steps, t = " << run.outcome.time << " s");
  CHECK(run.outcome.status == runs::RunStatus::Done);
  CHECK(share < 1e-4);
  // There were blows, and they made steps shorter.
  const auto& counters = run.report.at("counters");
  CHECK(counters.at("rejected").get<long>() > 20);
  const long for_energy = counters.at("repeated_for_energy").get<long>();
  CHECK(for_energy > 5);
  CHECK(for_energy <= counters.at("rejected").get<long>());
  const std::string print = testing::read_bytes(folder / "run" / "PRINT.txt");
  CHECK(print.find("Counter: repeated_for_energy") != std::string::npos);
  CHECK(run.outcome.energy_scale > 1e-5);
}
