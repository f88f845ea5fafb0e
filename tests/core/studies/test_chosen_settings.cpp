#include "core/runs/deck_runs.hpp"
#include "deck/templates.hpp"
#include "studies/chosen_settings.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>

/// Settings chosen for an error: steps, and nodes or slices of the contacts.
using namespace adore;
using namespace adore::runs;
using namespace adore::studies;

namespace {

DeckRequest example(const char* name) {
  DeckRequest request;
  request.text = std::string(deck::template_text(name));
  // The example of balls is irregular with damped contacts: errors of 15 % are below its scatter.
  request.options = {{"contactDamping", "0"}};
  return request;
}

/// What choose_settings() promises of its rows.
void check_rows(const ChosenSettings& chosen, double target) {
  REQUIRE_FALSE(chosen.rows.empty());
  CHECK(chosen.rows.size() <= 7);
  REQUIRE(chosen.resolution >= 0);
  const auto row = static_cast<std::size_t>(chosen.resolution);
  const double limit = target - std::min(chosen.steps.largest(), 0.75 * target);
  for (std::size_t k = row; k < chosen.rows.size(); ++k) {
    CHECK(chosen.rows[k].failure.empty());
    CHECK(chosen.rows[k].significant.largest() <= limit);
  }
  if (row > 0) CHECK_FALSE(chosen.rows[row - 1].significant.largest() <= limit);
  CHECK(chosen.options == chosen.rows[row].options);
  // With little processor time, the study may find no steps within the target.
  if (chosen.text.find("no settings have errors within the target") == std::string::npos)
    CHECK(chosen.steps.largest() <= 0.75 * target);
  CHECK(chosen.text.find(chosen.rows[row].name) != std::string::npos);
}

}  // namespace

TEST_CASE("chosen settings: nodes of the contact ellipses chosen with the steps",
          "[accuracy][slow]") {
  const DeckRequest request = example("ball-18");
  const ChosenSettings rough = choose_settings(request, 0.2, {});
  check_rows(rough, 0.2);
  const ChosenSettings fine = choose_settings(request, 0.004, {});
  if (fine.resolution >= 0) check_rows(fine, 0.004);
  const auto nodes = [](const ChosenSettings& chosen) {
    int out = 1;
    for (const auto& [name, value] : chosen.options) out *= std::stoi(value);
    return out;
  };
  INFO(rough.text << "\n" << fine.text);
  CHECK(nodes(rough) < nodes(fine));

  std::string again = fmt::format("To repeat this run: `adore run DECK --integrator {} --tol {:g}",
                                  rough.integrator, rough.tolerance);
  for (const auto& [name, value] : rough.sets) again += fmt::format(" --set {}={}", name, value);
  for (const auto& [name, value] : rough.options) again += fmt::format(" --opt {}={}", name, value);
  CHECK(rough.text.ends_with(again + "`"));

  SECTION("chosen settings → listed in the files of the run") {
    const testing::TemporaryFolder folder;
    RunRequest run;
    static_cast<DeckRequest&>(run) = request;
    run.until = "0.05rev";
    run.out = folder / "out";
    const RunOutcome outcome = run_with_chosen_settings(run, rough);
    REQUIRE(outcome.status == RunStatus::Done);
    const auto report = nlohmann::json::parse(testing::read_bytes(folder / "out/RUN.json"));
    CHECK(report.at("integrator") == rough.integrator);
    CHECK(report.at("options").dump().find(rough.options.front().first) != std::string::npos);
    CHECK(report.at("notes").dump().find(rough.text) != std::string::npos);
    CHECK(testing::read_bytes(folder / "out/PRINT.txt").find("settings for an error of 20 %") !=
          std::string::npos);
  }
}

TEST_CASE("chosen settings: slices of rollers chosen with the steps", "[accuracy][slow]") {
  const ChosenSettings chosen = choose_settings(example("cylindrical"), 0.05, {});
  INFO(chosen.text);
  check_rows(chosen, 0.05);
  CHECK(chosen.options.front().first == "rollerSlices");
}

TEST_CASE("chosen settings: resolution given in the request → kept", "[accuracy][slow]") {
  DeckRequest request = example("ball-18");
  request.options = {{"ellipseMajor", "20"}};
  const ChosenSettings chosen = choose_settings(request, 0.2, {});
  CHECK(chosen.options.empty());
  CHECK(chosen.rows.empty());
  CHECK(chosen.text.find("because run options set them") != std::string::npos);
}
