#include "core/runs/deck_runs.hpp"
#include "deck/templates.hpp"
#include "results/file_sums.hpp"
#include "studies/accuracy_statement.hpp"
#include "studies/chosen_settings.hpp"

#include <catch2/catch.hpp>

using namespace adore;
using namespace adore::runs;
using namespace adore::studies;

TEST_CASE("accuracy statement: part of a target, revolutions by the measured fall of the scatter",
          "[unit][accuracy]") {
  AccuracyStatement statement;
  statement.target = 0.01;
  statement.turns = 2.0;
  CHECK_FALSE(statement.keeps());  // nothing was stated
  StatedQuantity heat, peak;
  heat.label = "heat";
  heat.numerical = 0.004;
  heat.statistical = 0.005;
  peak.label = "peak";
  peak.mean = false;
  statement.quantities = {heat, peak};
  CHECK(statement.keeps());
  CHECK(statement.required_revolutions(0.01) == 0.0);
  statement.quantities[0].statistical = statement.quantities[0].diverged_statistical = 0.03;
  CHECK_FALSE(statement.keeps());
  CHECK(statement.required_revolutions(0.01) == Approx(27.0));  // 1.5 · 2 (0.03 / 0.01)²
  statement.quantities[0].diverged_statistical = 0.06;
  CHECK(statement.required_revolutions(0.01) == Approx(110.0));  // 1.5 · 2 (0.06 / 0.01)² = 108
  statement.quantities[0].diverged_statistical = 0.03;
  statement.quantities[0].fall = 0.25;
  CHECK(statement.required_revolutions(0.01) == Approx(250.0));  // 1.5 · 2 · 3⁴ = 243
  statement.quantities[0].fall = 0.5;
  CHECK(statement.numerical() == 0.004);
  CHECK(statement_text(statement).find(
            "need about 27 revolutions for an accuracy of 1 % (heat 27; this run: 2).") !=
        std::string::npos);
  statement.quantities[0].parting = true;
  CHECK(statement_text(statement).find("need on the order of") != std::string::npos);
  CHECK(statement_json(statement, {}).at("needs_revolutions_rough") == true);
  // A largest load is no mean: no span makes it certain.
  statement.quantities[0].statistical = 0.0;
  statement.quantities[1].statistical = 0.5;
  CHECK(statement.required_revolutions(0.01) == 0.0);
  CHECK_FALSE(statement.keeps());
}

TEST_CASE("accuracy statement: covers the span of the run, is stored in its files", "[accuracy]") {
  const testing::TemporaryFolder folder;
  RunRequest request;
  request.text = std::string(deck::template_text("ball"));
  request.until = "0.3rev";
  request.out = folder / "out";
  const RunOutcome outcome = run(request);
  REQUIRE(outcome.status == RunStatus::Done);
  const AccuracyStatement statement = make_accuracy_statement(request, outcome, 0.05, {});
  CHECK(statement.turns == Approx(0.3).epsilon(1e-3));
  REQUIRE(statement.quantities.size() >= 10);
  CHECK(statement.twin_failure.empty());
  CHECK(statement.twin_seconds < 1.5 * statement.run_seconds);  // 1.1 on a quiet machine
  for (const StatedQuantity& q : statement.quantities) {
    CAPTURE(q.id, q.numerical, q.statistical);
    CHECK(q.half_width() >= 0.0);
    // The tighter run is within every interval.
    if (q.id == "mean_load") continue;
    CHECK(std::abs(value_of(statement.tighter.results, q.id) - q.value) <=
          q.half_width() * q.scale * (1.0 + 1e-9));
  }
  store_statement(statement, outcome);
  const auto report = nlohmann::json::parse(testing::read_bytes(folder / "out/RUN.json"));
  CHECK(report.at("accuracy").at("quantities").size() == statement.quantities.size());
  CHECK(report.at("accuracy").at("revolutions") == statement.turns);
  CHECK(report.at("verify").at("results").contains("mean_power_loss_W"));
  CHECK(testing::read_bytes(folder / "out/PRINT.txt").find("ACCURACY OF THE RESULTS") !=
        std::string::npos);
  for (const results::FileCheck& file : results::verify_run(folder / "out"))
    CHECK(file.state != results::FileCheck::State::Damaged);
  // Once more in the place of the first.
  store_statement(statement, outcome);
  const auto again = nlohmann::json::parse(testing::read_bytes(folder / "out/RUN.json"));
  CHECK(again.at("accuracy") == report.at("accuracy"));
  // The run goes on as if nothing had been added.
  request.until = "0.4rev";
  request.go_on = true;
  CHECK(run(request).status == RunStatus::Done);
}

TEST_CASE("chosen settings: no run of their study is longer than the run itself", "[accuracy]") {
  RunRequest request;
  request.text = std::string(deck::template_text("ball"));
  request.until = "0.25rev";
  CHECK(requested_revolutions(request) == Approx(0.25).epsilon(1e-6));
  ChosenSettings chosen;
  chosen.tolerance = 1e-5;
  chosen.integrator = "rkf5";
  chosen.options = {{"ellipseMajor", "10"}, {"ellipseMinor", "1"}};
  RunOutcome outcome;
  outcome.longest_step = 2e-6;
  tighten_settings(chosen, request, outcome);
  CHECK(chosen.tolerance == Approx(1e-6));
  CHECK(chosen.options == std::vector<std::pair<std::string, std::string>>{{"ellipseMajor", "20"},
                                                                           {"ellipseMinor", "2"}});
  REQUIRE_FALSE(chosen.sets.empty());
  CHECK(chosen.sets.front().first == "stpMax");
}
