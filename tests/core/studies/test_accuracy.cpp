#include "core/runs/deck_runs.hpp"
#include "deck/templates.hpp"
#include "results/energy_judgement.hpp"
#include "scene/cost_ledger.hpp"
#include "studies/accuracy_judgement.hpp"
#include "studies/verify.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

using namespace adore;
using namespace adore::runs;
using namespace adore::studies;
using results::AccuracyErrors;
using results::kAccuracyQuantities;

namespace {

results::KeyResults made_up(double orbit, double cage, double whirl, double load, double heat,
                            double life) {
  using results::key_result;
  return {key_result("mean_orbital_ratio", orbit),
          key_result("mean_cage_ratio", cage),
          key_result("mean_swept_whirl_ratio", whirl),
          key_result("mean_largest_load_N", load),
          key_result("mean_load_x_N", 300.0),
          key_result("mean_load_y_N", 0.0),
          key_result("mean_load_z_N", 400.0),
          key_result("mean_power_loss_W", heat),
          key_result("mean_heat_outer_race_W", 0.5 * heat),
          key_result("mean_heat_inner_race_W", 0.25 * heat),
          key_result("mean_heat_elsewhere_W", 0.25 * heat),
          key_result("run_life_hours", life)};
}

AccuracyRequest short_study() {
  AccuracyRequest request;
  request.text = std::string(deck::template_text("ball"));
  request.methods = {"rkf5", "pece4"};
  request.tolerances = {1e-5, 1e-6};
  request.turns = 0.05;
  request.budget = 10.0;
  request.target = 0.1;
  return request;
}

}  // namespace

TEST_CASE("accuracy errors: speeds, loads, heat and life", "[unit][accuracy]") {
  const auto reference = made_up(0.4, 0.4, 0.1, 100.0, 8.0, 1e4);
  const AccuracyErrors none = compare_results(reference, reference);
  CHECK(none.largest() == 0.0);
  const auto of = [&](const results::KeyResults& run) { return compare_results(run, reference); };
  CHECK(of(made_up(0.404, 0.4, 0.1, 100.0, 8.0, 1e4)).speed == Approx(0.01));
  CHECK(of(made_up(0.4, 0.408, 0.1, 100.0, 8.0, 1e4)).speed == Approx(0.02));
  // A whirl that is small against the cage's own speed is measured by that.
  CHECK(of(made_up(0.4, 0.4, 0.104, 100.0, 8.0, 1e4)).whirl == Approx(0.01));
  CHECK(of(made_up(0.4, 0.4, 0.104, 100.0, 8.0, 1e4)).speed == 0.0);
  CHECK(of(made_up(0.4, 0.4, 0.1, 103.0, 8.0, 1e4)).load == Approx(0.03));
  CHECK(of(made_up(0.4, 0.4, 0.1, 100.0, 8.8, 1e4)).heat == Approx(0.05));
  CHECK(of(made_up(0.4, 0.4, 0.1, 100.0, 8.0, 0.9e4)).life == Approx(0.1));
  CHECK(of(made_up(0.4, 0.4, 0.1, 100.0, 8.0, 0.9e4)).largest() == Approx(0.1));
}

TEST_CASE("accuracy errors: values that a run has not computed → no error", "[unit][accuracy]") {
  const double infinite = std::numeric_limits<double>::infinity();
  const auto reference = made_up(0.4, 0.4, 0.1, 100.0, 0.0, infinite);
  const AccuracyErrors errors = compare_results(made_up(0.4, 0.4, 0.1, 100.0, 0.0, 1e4), reference);
  CHECK(errors.life < 0.0);
  CHECK(errors.heat == 0.0);
  CHECK(errors.largest() == 0.0);
  CHECK(errors_text({0.0, 0.01, -1.0, -1.0, 0.2, -1.0}) == "speeds 0 %, whirl 20 %, loads 1 %");
}

TEST_CASE("accuracy study: includes the deck's own run and recommends the fastest row",
          "[unit][accuracy]") {
  const AccuracyRequest request = short_study();
  const double begin = scene::processor_seconds();
  const AccuracyStudy study = study_accuracy(request);
  const double processor = scene::processor_seconds() - begin;
  REQUIRE(study.complete);
  REQUIRE(study.screening.size() >= 3);
  CHECK(study.screening.front().setting.own);
  CHECK(study.finals.front().setting.own);
  CHECK(study.models.size() >= 5);
  REQUIRE(study.recommended >= 0);
  // The example moves regularly: a millionth of the loads changes its means by about as little.
  CHECK(study.irregular.largest() < 1e-4);
  CHECK((accuracy_table(study).find("A relative load change of 1e-6 changes the means by") !=
         std::string::npos) == (study.irregular.largest() > 0.0));
  const AccuracyRow& best = study.finals[static_cast<std::size_t>(study.recommended)];
  for (const AccuracyRow& row : study.finals) {
    if (row.setting.own) CHECK(row.runs == 3);
    if (!row.failure.empty() || !study.keeps(row.errors)) continue;
    if (!(row.energy_share > results::kMovedWarning))
      CHECK(best.seconds <= row.seconds);  // others are warned of
  }
  // The same settings once more: the front holds no row that another one beats.
  const auto over = [&](const AccuracyRow& row) {
    return error_to_limit_ratio(row.errors, study.short_reference.noise, study.target);
  };
  for (const AccuracyRow& row : study.screening)
    for (const AccuracyRow& other : study.screening)
      if (row.front && other.failure.empty())
        CHECK_FALSE((other.seconds < row.seconds && over(other) <= over(row)));

  SECTION("a finished study comes back from its file, and nothing is run again") {
    const AccuracyStudy read = read_accuracy(accuracy_json(study), "ACCURACY.json");
    CHECK(accuracy_csv(read) == accuracy_csv(study));
    CHECK(recommendation(read) == recommendation(study));
    CHECK(recommended_sets(read) == recommended_sets(study));
    int rows_made = 0;
    const AccuracySink count = [&](const AccuracyRow&, const AccuracyStudy&) { ++rows_made; };
    const AccuracyStudy again = study_accuracy(request, count, {}, read);
    CHECK(rows_made == 0);
    CHECK(accuracy_json(again) == accuracy_json(study));
    CHECK(again.untried == study.untried);
    // All that was spent is in the account: rows, references, runs without a row.
    CHECK(study.unlisted_seconds > 0.0);
    double listed = study.short_reference.seconds + study.unlisted_seconds;
    if (study.long_turns > study.short_turns) listed += study.long_reference.seconds;
    double of_medians = 0.0;  // three runs take two times their median or more
    for (const auto* rows : {&study.screening, &study.finals, &study.models})
      for (const AccuracyRow& row : *rows) {
        listed += row.runs * row.seconds;
        if (row.runs > 1) of_medians += row.runs * row.seconds;
      }
    CHECK(study.seconds >= listed - of_medians / 3.0 - 1e-9);
    CHECK(study.seconds <= processor);
    // As one that was broken off at its very end.
    AccuracyStudy cut = read;
    cut.complete = false;
    const AccuracyStudy rest = study_accuracy(request, {}, {}, cut);
    CHECK(rest.complete);
    CHECK(rest.untried <= study.untried);
    CHECK(rest.twins == study.twins);
    REQUIRE(rest.screening.size() >= study.screening.size());
    REQUIRE(rest.finals.size() >= study.finals.size());
    for (std::size_t k = 0; k < study.finals.size(); ++k) {
      CHECK(rest.finals[k].setting.name == study.finals[k].setting.name);
      CHECK(rest.finals[k].errors.heat == study.finals[k].errors.heat);
    }
    CHECK(rest.irregular.speed == study.irregular.speed);
    CHECK(rest.seconds >= listed - of_medians);
    // Stopped again before it came to its rows: not one is lost.
    std::stop_source stop;
    stop.request_stop();
    const AccuracyStudy stopped = study_accuracy(request, {}, stop.get_token(), cut);
    CHECK_FALSE(stopped.complete);
    CHECK(accuracy_csv(stopped) == accuracy_csv(study));
    CHECK(stopped.unlisted_seconds >= study.unlisted_seconds);
    CHECK(stopped.irregular.speed == study.irregular.speed);
    const AccuracyStudy whole = study_accuracy(request, {}, {}, stopped);
    CHECK(whole.screening.size() == rest.screening.size());

    AccuracyStudy spent = cut;  // a study that spent its budget so has none when it goes on
    spent.unlisted_seconds = 2.0 * request.budget;
    spent.irregular = AccuracyErrors::none();
    spent.models.clear();
    const AccuracyStudy poor = study_accuracy(request, {}, {}, spent);
    CHECK(poor.seconds > 2.0 * request.budget);
    CHECK(poor.models.empty());
    CHECK(poor.irregular.speed < 0.0);
  }
  SECTION("rows of another deck are not taken over") {
    AccuracyRequest other = request;
    other.sets = {{"appLoadX", "777"}};
    AccuracyStudy known = study;
    for (AccuracyRow& row : known.finals) row.seconds = 1e6;
    for (const AccuracyRow& row : study_accuracy(other, {}, {}, known).finals)
      CHECK(row.seconds < 1e6);
  }
}

TEST_CASE("accuracy study: recommendation mentions warnings of its run and irregular results",
          "[unit][accuracy]") {
  AccuracyStudy study;
  study.long_turns = 50.0;
  study.target = 0.01;
  AccuracyRow own, best;
  own.setting.name = "rkf5, tol 1e-06, stpMax 0.5";
  own.setting.own = true;
  own.seconds = 4.0;
  best.setting.name = "rk4, tol 0.0001, stpMax as long as stable";
  best.seconds = 1.0;
  best.errors = {0.002, 0.001, 0.003, 0.004};
  study.finals = {own, best};
  study.recommended = 1;
  for (const double share : {9e-5, 1.6e-4}) {
    study.finals[1].energy_share = share;
    const std::string says = recommendation(study);
    CAPTURE(says);
    CHECK((says.find("of the exchanged energy, which causes a warning") != std::string::npos) ==
          (share > results::kMovedWarning));
    CHECK((says.find("1.6e-04 of the exchanged energy") != std::string::npos) ==
          (share > results::kMovedWarning));
    CHECK(says.find("rk4, tol 0.0001, stpMax as long as stable: the fastest settings that keep "
                    "all errors within 1 % over 50 revolutions") == 0);
    CHECK(says.find("the deck's own settings need 4 s") != std::string::npos);
    CHECK(says.find("irregular") == std::string::npos);
  }
  AccuracyRow warned = study.finals[1];
  study.finals[1].energy_share = 1e-6;
  warned.setting.name = "pece2, tol 1e-7";
  warned.seconds = 0.5;
  warned.energy_share = 3e-4;
  study.finals.push_back(warned);
  CHECK(recommendation(study).find("pece2, tol 1e-7 needs only 0.5 s, but its "
                                   "energy residual is 3.0e-04") != std::string::npos);
  study.long_reference.noise.heat = 0.04;
  CHECK(recommendation(study).find("Two accurate runs differ by 4 %") != std::string::npos);
  CHECK(recommendation(study).find("within 1 % (heat within 6 %) over 50 revolutions") !=
        std::string::npos);
  // What the resolution of the contacts changes is no matter of integrators.
  CHECK(recommendation(study).find("only the integrator and the step sizes") == std::string::npos);
  AccuracyRow nodes;
  nodes.setting.name = "ellipse nodes 30 x 8";
  nodes.errors = {0.056, 0.001, 0.002, 0.0};
  study.models = {nodes};
  CHECK(recommendation(study).find(
            "this study covers only the integrator and the step sizes: ellipse "
            "nodes 30 x 8 changes the results by more than the target error (speeds 5.6 %") !=
        std::string::npos);
  study.short_reference.noise.speed = 0.05;  // no more than accurate runs differ by
  CHECK(recommendation(study).find("only the integrator and the step sizes") == std::string::npos);
  study.recommended = -1;
  CHECK(recommendation(study).find("No settings keep all errors within 1 %") == 0);
}

TEST_CASE("accuracy study: runs under nearby loads → noise, which hides errors of a method",
          "[unit][accuracy]") {
  const auto run = [](double whirl, double heat) {
    return made_up(0.4, 0.4, whirl, 100.0, heat, 1e4);
  };
  CHECK(estimate_noise({}).whirl < 0.0);
  // Regular: what each method has by itself plays no part, however far the two lie apart.
  const NearbyRuns one{run(0.1, 8.0), run(0.1, 8.000008), run(0.1, 7.999992)},
      other{run(0.2, 9.0), run(0.2, 9.000009), run(0.2, 8.999991)};
  CHECK(estimate_noise({one, other}).whirl == 0.0);
  CHECK(estimate_noise({one, other}).heat < 2e-6);
  CHECK(estimate_noise({one, other}).heat > 1e-7);
  // A life that two runs have not makes no noise and is none.
  const NearbyRuns endless(
      3, made_up(0.4, 0.4, 0.1, 100.0, 8.0, std::numeric_limits<double>::infinity()));
  CHECK(estimate_noise({endless}).life < 0.0);
  // Irregular: of two methods whose means scatter alike, a third run stands out once in twenty
  // times, whatever the scatter; and with one method only, too.
  for (const std::size_t methods : {1U, 2U}) {
    std::mt19937 random(700);
    std::normal_distribution<double> scatter(0.2, 0.012);
    int out = 0;
    constexpr int kDraws = 4000;
    for (int k = 0; k < kDraws; ++k) {
      std::vector<NearbyRuns> all(methods);
      for (NearbyRuns& runs : all)
        for (int n = 0; n < 3; ++n) runs.push_back(run(scatter(random), 8.0));
      const AccuracyErrors noise = estimate_noise(all);
      const AccuracyErrors errors =
          compare_results(run(scatter(random), 8.0), run(scatter(random), 8.0));
      if (significant_errors(errors, noise).whirl > 0.0) ++out;
      if (k == 0) CHECK(noise.heat == 0.0);
    }
    CHECK(out > 0.03 * kDraws);
    CHECK(out < 0.07 * kDraws);
  }
}

TEST_CASE("accuracy study: irregular quantity → does not excuse errors of another",
          "[unit][accuracy]") {
  AccuracyStudy study;
  study.target = 0.01;
  std::array<double AccuracyErrors::*, 6> all{};
  for (std::size_t q = 0; q < all.size(); ++q) all[q] = kAccuracyQuantities[q].member;
  for (const auto noisy : all)
    for (const bool by_loads : {false, true})
      for (const auto wrong : all) {
        study.long_reference.noise = {0.001, 0.001, 0.001, 0.001, 0.001, 0.001};
        study.irregular = AccuracyErrors::none();
        AccuracyErrors& by = by_loads ? study.irregular : study.long_reference.noise;
        by.*noisy = 0.04;
        AccuracyErrors errors{0.009, 0.009, 0.009, 0.009, 0.009, 0.009};
        CHECK(study.keeps(errors));
        errors.*wrong = 0.05;
        CHECK(study.keeps(errors) == (wrong == noisy));
        errors.*wrong = 0.07;
        CHECK_FALSE(study.keeps(errors));
        const AccuracyErrors most = study.limits();
        for (const auto quantity : all)  // the limits that are told are those by which it keeps
          for (const double share : {0.999, 1.001}) {
            AccuracyErrors edge{0.0, 0.0, 0.0, 0.0};
            edge.*quantity = share * (most.*quantity);
            CHECK(study.keeps(edge) == (share < 1.0));
          }
      }
  study.irregular.speed = 0.04;
  const AccuracyStudy read = read_accuracy(accuracy_json(study), "ACCURACY.json");
  CHECK(read.irregular.speed == 0.04);
  CHECK(read.irregular.heat == study.irregular.heat);
}

TEST_CASE("accuracy study: one irregular quantity → no candidate leaves the second round",
          "[unit][accuracy]") {
  std::array<double AccuracyErrors::*, 6> all{};
  for (std::size_t q = 0; q < all.size(); ++q) all[q] = kAccuracyQuantities[q].member;
  for (const auto noisy : all)
    for (const auto other : all) {
      if (other == noisy) continue;
      AccuracyErrors noise{0.001, 0.001, 0.001, 0.001, 0.001, 0.001};
      noise.*noisy = 0.3;
      // By the largest error the right one (0.4 of its noise 0.3) is the worst of all by far, and
      // the wrong ones (0.2 of what is known to 0.001) are within it and cheaper.
      std::vector<AccuracyRow> rows;
      const auto add = [&](const char* name, double seconds, double irregular, double regular) {
        AccuracyRow row;
        row.setting.name = name;
        row.seconds = seconds;
        row.errors = {0.0005, 0.0005, 0.0005, 0.0005, 0.0005, 0.0005};
        row.errors.*noisy = irregular;
        row.errors.*other = regular;
        rows.push_back(row);
      };
      for (int k = 0; k < 9; ++k) add("wrong", 0.5 + 0.01 * k, 0.001, 0.2 - 0.01 * k);
      add("right", 1.0, 0.4, 0.005);
      add("dear", 9.0, 0.01, 0.004);
      judge_rows(rows, noise, 0.01);
      CHECK(rows[9].front);
      const auto first = candidates(rows, noise, 0.01, 3);
      REQUIRE(first.size() == 3);
      CHECK(rows[first[0]].setting.name == "right");
      CHECK(candidates(rows, noise, 0.01, 20).size() == rows.size());
      // The same rows where that quantity is known: then it is off.
      const AccuracyErrors known{0.001, 0.001, 0.001, 0.001, 0.001, 0.001};
      judge_rows(rows, known, 0.01);
      CHECK_FALSE(rows[9].front);
      CHECK(candidates(rows, known, 0.01, 20).back() == 9U);
    }
}

TEST_CASE("accuracy study: budget ends early → growth between its spans is reported",
          "[unit][accuracy][slow]") {
  AccuracyRequest request = short_study();
  request.methods = {"rkf5", "rk4"};
  request.tolerances = {1e-5};
  request.models = false;
  request.turns = 1000.0;
  request.budget = 3.0;
  const AccuracyStudy study = study_accuracy(request);
  CHECK(study.complete);
  REQUIRE(study.long_turns < request.turns);
  REQUIRE_FALSE(study.finals.empty());
  for (const AccuracyRow& row : study.finals)
    for (const AccuracyRow& before : study.screening) {
      if (before.setting.name != row.setting.name || !row.failure.empty()) continue;
      if (row.turns - before.turns < 1.0) {  // on a slow machine
        CHECK(row.growth == 0.0);
        continue;
      }
      CHECK(before.energy_share * std::pow(row.growth, row.turns - before.turns) ==
            Approx(row.energy_share).epsilon(1e-6).margin(1e-12));
    }
  CHECK(accuracy_table(study).find(
            "Specified length: 1000 revolutions; the time budget allows only") !=
        std::string::npos);
  const AccuracyStudy read = read_accuracy(accuracy_json(study), "ACCURACY.json");
  CHECK(accuracy_table(read) == accuracy_table(study));
}

TEST_CASE("accuracy study: growth → of a row that completed both rounds", "[unit][accuracy]") {
  AccuracyStudy study;
  study.asked = 50.0;
  study.short_turns = 1.0;
  study.long_turns = 3.0;
  AccuracyRow own;
  own.setting.own = true;
  own.setting.name = "deck's own";
  own.turns = 1.0;
  own.energy_share = 1e-6;
  own.errors = {0.001, 0.001, 0.001, 0.001};
  study.screening = {own};
  own.turns = 3.0;
  own.energy_share = 4e-6;
  own.growth = 2.0;
  study.finals = {own};
  const auto told = [&] { return accuracy_table(study); };
  CHECK(told().find(
            "between 1 and 3 revolutions, the error changed from 0.1 % to 0.1 %, and the energy "
            "residual from 1.0e-06 to 4.0e-06 of the exchanged energy, a factor of 2 per "
            "revolution.") != std::string::npos);
  SECTION("a row that was cut has none") {
    study.finals[0].failure = "cut";
    study.finals[0].energy_share = study.finals[0].growth = 0.0;
    CHECK(told().find("growth (") == std::string::npos);
  }
  SECTION("of one span none can be") {
    study.long_turns = study.finals[0].turns = 1.0;
    CHECK(told().find(
              "Error growth: not measured, because both rounds have the same simulated length.") !=
          std::string::npos);
  }
}

TEST_CASE("accuracy study: stopped → results so far", "[unit][accuracy]") {
  std::stop_source stop;
  int rows = 0;
  const AccuracyStudy study = study_accuracy(
      short_study(),
      [&](const AccuracyRow&, const AccuracyStudy&) {
        if (++rows == 2) stop.request_stop();
      },
      stop.get_token());
  CHECK_FALSE(study.complete);
  CHECK(study.screening.size() == 2);
  CHECK(study.finals.empty());
  CHECK(recommended_sets(study).empty());
  CHECK(read_accuracy(accuracy_json(study), "ACCURACY.json").screening.size() == 2);
}

TEST_CASE("accuracy study: quasi-static deck or broken file → error", "[unit][accuracy]") {
  AccuracyRequest request = short_study();
  request.sets = {{"mode", "-1"}};
  CHECK_THROWS_AS(study_accuracy(request), InputError);
  request = short_study();
  request.methods = {"euler"};
  CHECK_THROWS_AS(study_accuracy(request), InputError);
  CHECK_THROWS_AS(read_accuracy("{}", "ACCURACY.json"), InputError);
  CHECK_THROWS_AS(read_accuracy("no json", "ACCURACY.json"), InputError);
}

TEST_CASE("verify: repeats a run with tighter settings to the same end", "[unit][accuracy]") {
  RunRequest request;
  request.text = std::string(deck::template_text("ball"));
  request.until = "0.05rev";
  const testing::TemporaryFolder folder;
  request.out = folder / "run";
  const RunOutcome outcome = run(request);
  REQUIRE(outcome.status == RunStatus::Done);
  const Verification verified = verify(request, outcome, {});
  REQUIRE(verified.failure.empty());
  CHECK(value_of(verified.results, "time_s") == Approx(outcome.time).epsilon(1e-12));
  CHECK(verified.errors.speed < 1e-3);
  CHECK(verified.errors.load < 1e-2);
  // It did take other steps: not one figure to the last digit.
  CHECK(value_of(verified.results, "power_loss_W") != value_of(outcome.summary, "power_loss_W"));
}
