#include "results/energy_judgement.hpp"
#include "results/run_json.hpp"

#include <catch2/catch.hpp>

#include <limits>

using namespace adore::results;

namespace {

/// Heat of 1 J, work larger by the residual.
adore::scene::EnergyLedger run_of(double residual) {
  using adore::scene::LedgerKind;
  static const adore::scene::LedgerTerm heat{LedgerKind::Heat, "heat", "", {"contacts", ""}, ""};
  static const adore::scene::LedgerTerm work{LedgerKind::Work, "work", "", {"races", ""}, ""};
  adore::scene::EnergyLedger energy;
  energy.add(heat, 1.0);
  energy.add(work, 1.0 + residual);
  return energy;
}

}  // namespace

TEST_CASE("Energy residual: judged against exchanged energy and elastic energy",
          "[unit][results]") {
  const double much = 1e6;  // elastic energy that judges nothing
  CHECK(judge_energy(run_of(0.9e-4), much).trust == Trust::Full);
  CHECK(judge_energy(run_of(0.9e-4), much).text.empty());
  CHECK(judge_energy(run_of(1.1e-4), much).trust == Trust::Warned);
  CHECK(judge_energy(run_of(-1.1e-4), much).trust == Trust::Warned);
  CHECK(judge_energy(run_of(0.9e-2), much).trust == Trust::Warned);
  CHECK(judge_energy(run_of(-1.1e-2), much).trust == Trust::None);
  const double residual = 1e-5;
  CHECK(judge_energy(run_of(residual), residual / 0.019).trust == Trust::Full);
  CHECK(judge_energy(run_of(residual), residual / 0.021).trust == Trust::Warned);
  CHECK(judge_energy(run_of(residual), residual / 0.49).trust == Trust::Warned);
  CHECK(judge_energy(run_of(residual), residual / 0.51).trust == Trust::None);
  CHECK(judge_energy(run_of(residual), 0.0).trust == Trust::Full);  // nothing to measure by
  CHECK(judge_energy(run_of(1.1e-4), 0.0).text.find("elastic") == std::string::npos);
  CHECK(judge_energy(run_of(1.1e-4), much).text.find("elastic") != std::string::npos);
}

TEST_CASE("Energy residual: no motion except step errors → no advice of shorter steps",
          "[unit][results]") {
  using adore::scene::LedgerKind;
  static const adore::scene::LedgerTerm work{LedgerKind::Work, "work", "", {"races", ""}, ""};
  adore::scene::EnergyLedger at_rest;
  at_rest.add(work, 1e-6);
  const EnergyJudgment stands = judge_energy(at_rest, 1e-2);
  CHECK(stands.trust == Trust::None);
  CHECK_THAT(stands.text, Catch::Contains("energy residual of") && Catch::Contains("mode = -1") &&
                              Catch::Contains("kTrac = 0") && !Catch::Contains("--tol"));
  // One that shakes, and one that moves.
  CHECK_THAT(judge_energy(at_rest, 1e-6).text, Catch::Contains("--tol"));
  CHECK_THAT(judge_energy(run_of(0.3), 1e6).text, Catch::Contains("--tol"));
}

TEST_CASE("Energy residual: creeping bearing → judged by its stored energy", "[unit][results]") {
  using adore::scene::LedgerKind;
  static const adore::scene::LedgerTerm start{LedgerKind::Start, "start", "", {"start", ""}, ""};
  static const adore::scene::LedgerTerm elastic{LedgerKind::Stored, "e", "", {"elastic", ""}, ""};
  static const adore::scene::LedgerTerm work{LedgerKind::Work, "work", "", {"races", ""}, ""};
  static const adore::scene::LedgerTerm heat{LedgerKind::Heat, "heat", "", {"contacts", ""}, ""};
  const auto creeps = [&](double residual) {
    adore::scene::EnergyLedger out;
    out.add(start, 0.0355);
    out.add(elastic, 0.0355);
    out.add(work, 5e-17 + residual);
    out.add(heat, 5e-17);
    return out;
  };
  CHECK(judge_energy(creeps(1e-17), 0.0355).trust == Trust::Full);  // rounding
  CHECK(judge_energy(creeps(4.0 * kEnergyFloor * kMovedWarning * 0.0355), 0.0355).trust ==
        Trust::Warned);
  CHECK(judge_energy(creeps(2.0 * kEnergyFloor * kMovedLimit * 0.0355), 0.0355).trust ==
        Trust::None);
  CHECK(energy_scale(creeps(0.0)) > 0.0);
}

TEST_CASE("Energy residual: warning above 5 % of the heat, for any exchanged energy",
          "[unit][results]") {
  using adore::scene::LedgerKind;
  static const adore::scene::LedgerTerm work{LedgerKind::Work, "work", "", {"races", ""}, ""};
  static const adore::scene::LedgerTerm now{LedgerKind::Stored, "k", "", {"kinetic", ""}, ""};
  static const adore::scene::LedgerTerm heat{LedgerKind::Heat, "heat", "", {"contacts", ""}, ""};
  const auto accelerated = [&](double residual) {
    adore::scene::EnergyLedger out;
    out.add(now, 1.0);
    out.add(heat, 1e-4);
    out.add(work, 1.0001 + residual);
    return out;
  };
  CHECK(judge_energy(accelerated(4e-6), 1e6).trust == Trust::Full);
  const EnergyJudgment judged = judge_energy(accelerated(6e-6), 1e6);
  CHECK(judged.trust == Trust::Warned);
  CHECK(judged.over_heat == Approx(0.06).epsilon(1e-6));
  CHECK_THAT(judged.text, Catch::Contains("6 % of the heat (0.0001 J)"));
}

TEST_CASE("Energy residual: temporary residual → warning", "[unit][results]") {
  const double much = 1e6;
  CHECK(judge_energy(run_of(1e-6), much, 1.1e-4).trust == Trust::Warned);
  CHECK(judge_energy(run_of(1e-6), much, 1.1e-4).text.find("(largest value of the run)") !=
        std::string::npos);
  CHECK(judge_energy(run_of(1e-6), much, 1.1e-2).trust == Trust::Warned);
  CHECK(judge_energy(run_of(1e-6), 1e-2 / 0.51, 1e-2).trust == Trust::Warned);
  CHECK(judge_energy(run_of(1.1e-2), much, 2e-2).trust == Trust::None);
  CHECK(judge_energy(run_of(1.1e-4), much, 1e-6).text.find("(largest value of the run)") ==
        std::string::npos);
}

TEST_CASE("Energy residual: above its limit and not returned → not trusted for any final value",
          "[unit][results]") {
  const double much = 1e6;
  // Over what moved, and over the elastic energy: the end lies within its limit, above a warning.
  CHECK(judge_energy(run_of(1.1e-4), much, 1.1e-2).trust == Trust::None);
  CHECK(judge_energy(run_of(-5e-5), 1e-3, 5.1e-4).trust == Trust::None);
  CHECK_THAT(judge_energy(run_of(-5e-5), 1e-3, 5.1e-4).text,
             Catch::Contains("(largest value of the run)") && Catch::Contains("(limit 0.5)"));
  // Below the warnings at the end: it came back.
  CHECK(judge_energy(run_of(1.9e-5), 1e-3, 5.1e-4).trust == Trust::Warned);
}

TEST_CASE("Energy residual: NaN → never trusted", "[unit][results]") {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e300}) {
    const EnergyJudgment judgement = judge_energy(run_of(bad), 1.0);
    CHECK(judgement.trust == Trust::None);
    CHECK_FALSE(judgement.text.empty());
  }
}
