#include "base/errors.hpp"
#include "base/find_report.hpp"
#include "base/find_values.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>

using namespace adore;

namespace {

FindSettings between(double first, double last, double target,
                     Relation relation = Relation::Equal) {
  FindSettings out;
  out.first = first;
  out.last = last;
  out.target = target;
  out.relation = relation;
  return out;
}

FindReport report_of(const FindSettings& settings, const std::function<double(double)>& f) {
  FindReport out;
  out.source = "test";
  out.unknown = {"x", "N", settings.first, settings.last};
  out.target = {"y", "m", settings.relation, settings.target};
  out.outcome = find_values(settings, f);
  return out;
}

}  // namespace

TEST_CASE("find_values(): monotonic function → one solution with its tolerance", "[unit][find]") {
  int calls = 0;
  const FindOutcome out = find_values(between(0.0, 10.0, 7.0), [&](double x) {
    ++calls;
    return std::pow(x, 1.5);
  });
  REQUIRE(out.answer == FindAnswer::One);
  CHECK(out.solutions[0].kind == FindSolutionKind::Crossing);
  CHECK(out.solutions[0].x == Approx(std::pow(7.0, 2.0 / 3.0)).epsilon(1e-9));
  CHECK(out.solutions[0].width < 2e-8);
  CHECK(out.monotonic);
  CHECK(calls < 60);  // 41 of the scan: faster than bisection, which needs 30 more
}

TEST_CASE("find_values(): oscillating function → every solution", "[unit][find]") {
  const FindOutcome out =
      find_values(between(0.5, 20.0, 0.0), [](double x) { return std::sin(x); });
  REQUIRE(out.answer == FindAnswer::Many);
  REQUIRE(out.solutions.size() == 6);
  for (std::size_t k = 0; k < 6; ++k)
    CHECK(out.solutions[k].x == Approx(M_PI * static_cast<double>(k + 1)).epsilon(1e-8));
  CHECK_FALSE(out.monotonic);
}

TEST_CASE("find_values(): two solutions between two scan points → both", "[unit][find]") {
  // Scan points are 0.25 apart; the solutions 0.02.
  const FindOutcome out =
      find_values(between(0.0, 10.0, 0.0), [](double x) { return (x - 5.1) * (x - 5.12); });
  REQUIRE(out.answer == FindAnswer::Many);
  REQUIRE(out.solutions.size() == 2);
  CHECK(out.solutions[0].x == Approx(5.1));
  CHECK(out.solutions[1].x == Approx(5.12));
}

TEST_CASE("find_values(): function that touches the target → one solution, not monotonic",
          "[unit][find]") {
  const FindOutcome out =
      find_values(between(0.0, 10.0, 1.0), [](double x) { return 1.0 + (x - 3.3) * (x - 3.3); });
  REQUIRE(out.answer == FindAnswer::NotMonotonic);
  CHECK(out.solutions[0].kind == FindSolutionKind::Touch);
  CHECK(out.solutions[0].x == Approx(3.3).epsilon(1e-4));
  REQUIRE(out.turns.size() == 1);
  CHECK(out.turns[0] == Approx(3.3).margin(0.01));
}

TEST_CASE("find_values(): target out of reach → none, with the best value and the bound",
          "[unit][find]") {
  const FindReport report = report_of(between(1.0, 10.0, 30.0), [](double x) { return 2.0 * x; });
  CHECK(report.outcome.answer == FindAnswer::None);
  CHECK(report.outcome.best.x == 10.0);
  CHECK(report.outcome.best.value == 20.0);
  const std::vector<std::string> lines = answer_lines(report);
  REQUIRE(lines.size() == 2);
  CHECK(lines[0] == "No solution for x from 1 to 10 N.");
  CHECK(lines[1] == "Best value: y = 20 m at x = 10 N, the upper bound.");
  const nlohmann::ordered_json json = find_report_json(report);
  CHECK(json.at("best").at("at_bound") == true);
  CHECK_FALSE(json.contains("solution"));
  CHECK_FALSE(json.contains("solutions"));
}

TEST_CASE("find_values(): constant part on the target → its edge", "[unit][find]") {
  const auto clipped = [](double x) { return x > 3.7 ? std::pow(x - 3.7, 1.5) : 0.0; };
  const FindReport report = report_of(between(1.0, 10.0, 0.0), clipped);
  REQUIRE(report.outcome.answer == FindAnswer::One);
  const FindSolution& one = report.outcome.solutions[0];
  CHECK(one.kind == FindSolutionKind::Range);
  CHECK(one.x == Approx(3.7).epsilon(1e-8));
  CHECK(one.from_bound);
  CHECK_FALSE(one.to_bound);
  CHECK(answer_lines(report)[0].find("The target is met from 1 N (the lower bound) to 3.7") !=
        std::string::npos);
  // Inequality: from the edge of the condition to the bound.
  const FindOutcome least = find_values(between(1.0, 10.0, 1.0, Relation::AtLeast), clipped);
  REQUIRE(least.answer == FindAnswer::One);
  CHECK(least.solutions[0].x == Approx(4.7));
  CHECK(least.solutions[0].to_bound);
  const FindOutcome most = find_values(between(1.0, 10.0, 1.0, Relation::AtMost), clipped);
  REQUIRE(most.answer == FindAnswer::One);
  CHECK(most.solutions[0].x == Approx(4.7));
  CHECK(most.solutions[0].from_bound);
  CHECK(find_values(between(1.0, 3.0, 0.0), clipped).answer == FindAnswer::Everywhere);
  CHECK(find_values(between(1.0, 3.0, 0.0), clipped).constant);
}

TEST_CASE("find_values(): rounding of a constant result → constant, no turns", "[unit][find]") {
  const FindOutcome out = find_values(between(0.0, 1.0, 2.0),
                                      [](double x) { return 1500.0 + 1e-8 * std::sin(99.0 * x); });
  CHECK(out.constant);
  CHECK(out.monotonic);
  CHECK(out.answer == FindAnswer::None);
}

TEST_CASE("find_values(): exact hit at a scan point or a bound → one solution", "[unit][find]") {
  for (const double hit : {0.0, 2.5, 10.0}) {
    const FindOutcome out =
        find_values(between(0.0, 10.0, 0.0), [hit](double x) { return x - hit; });
    REQUIRE(out.answer == FindAnswer::One);
    CHECK(out.solutions[0].kind == FindSolutionKind::Crossing);
    CHECK(out.solutions[0].x == Approx(hit).margin(1e-7));
  }
}

TEST_CASE("find_values(): jump over the target → no solution, the jump is named", "[unit][find]") {
  const FindReport report =
      report_of(between(0.0, 1.0, 0.5), [](double x) { return x < 0.371 ? 0.1 * x : 1.0 + x; });
  CHECK(report.outcome.answer == FindAnswer::None);
  REQUIRE(report.outcome.jumps.size() == 1);
  CHECK(report.outcome.jumps[0].before == Approx(0.371));
  CHECK(answer_exit_code(report.outcome.answer) == 1);
  // A condition has an answer there.
  const FindOutcome least = find_values(between(0.0, 1.0, 0.5, Relation::AtLeast),
                                        [](double x) { return x < 0.371 ? 0.1 * x : 1.0 + x; });
  REQUIRE(least.answer == FindAnswer::One);
  CHECK(least.solutions[0].x == Approx(0.371));
}

TEST_CASE("find_values(): failed points are named and split the range", "[unit][find]") {
  const auto broken = [](double x) {
    if (x > 4.0 && x < 6.0) throw SolverError("no equilibrium");
    return x;
  };
  const FindOutcome beside = find_values(between(0.0, 10.0, 8.0), broken);
  REQUIRE(beside.answer == FindAnswer::One);
  REQUIRE(beside.failures.size() == 1);
  CHECK(beside.failures[0].from == Approx(4.0));
  CHECK(beside.failures[0].to == Approx(6.0));
  CHECK(beside.failures[0].reason == "no equilibrium");
  // The solution is where nothing was computed: not "none".
  const FindOutcome inside = find_values(between(0.0, 10.0, 5.0), broken);
  CHECK(inside.answer == FindAnswer::NotComputed);
  CHECK(answer_exit_code(inside.answer) == 3);
  CHECK_THROWS_AS(find_values(between(4.5, 5.5, 5.0), broken), SolverError);
  CHECK_THROWS_AS(find_values(between(0.0, 1.0, 5.0),
                              [](double) -> double { throw InputError("out of range"); }),
                  InputError);
}

TEST_CASE("find_values(): failure in the refinement → not computed", "[unit][find]") {
  const FindOutcome out = find_values(between(0.0, 10.0, 5.1), [](double x) {
    if (x > 5.01 && x < 5.24) throw SolverError("lost");
    return x;
  });
  CHECK(out.answer == FindAnswer::NotComputed);
  REQUIRE(out.failures.size() == 1);
  CHECK(out.failures[0].from == Approx(5.0));
  CHECK(out.failures[0].to == Approx(5.25));
}

TEST_CASE("find_values(): whole numbers are not interpolated", "[unit][find]") {
  FindSettings settings = between(4.2, 20.0, 100.0);
  settings.whole = true;
  const auto square = [](double n) { return n * n; };
  const FindOutcome exact = find_values(settings, square);
  REQUIRE(exact.answer == FindAnswer::One);
  CHECK(exact.solutions[0].x == 10.0);
  CHECK(exact.samples.size() == 16);
  settings.target = 101.0;
  CHECK(find_values(settings, square).answer == FindAnswer::None);
  settings.relation = Relation::AtLeast;
  CHECK(find_values(settings, square).solutions.at(0).x == 11.0);
}

TEST_CASE("find_values(): least and largest value, also at a bound", "[unit][find]") {
  const auto f = [](double x) { return (x - 3.3) * (x - 3.3); };
  const FindOutcome least = find_values(between(0.0, 10.0, 0.0, Relation::Least), f);
  CHECK(least.solutions.at(0).x == Approx(3.3).epsilon(1e-4));
  CHECK_FALSE(least.solutions[0].from_bound);
  const FindOutcome largest = find_values(between(0.0, 10.0, 0.0, Relation::Largest), f);
  CHECK(largest.solutions.at(0).x == 10.0);
  CHECK(largest.solutions[0].to_bound);
}

TEST_CASE("find_values(): infinite results are on their side of the target", "[unit][find]") {
  const auto life = [](double x) {
    return x < 4.0 ? std::numeric_limits<double>::infinity() : 20.0 / x;
  };
  const FindOutcome jump = find_values(between(1.0, 10.0, 6.0), life);
  CHECK(jump.answer == FindAnswer::None);
  REQUIRE(jump.jumps.size() == 1);
  CHECK(jump.jumps[0].after == Approx(4.0));
  CHECK(find_values(between(1.0, 10.0, 2.5), life).solutions.at(0).x == Approx(8.0));
}

TEST_CASE("find_values(): bounds far apart → scan in equal ratios", "[unit][find]") {
  const FindOutcome out =
      find_values(between(1e-3, 1e6, 1.0), [](double x) { return std::log10(x) + 1.0; });
  CHECK(out.equal_ratios);
  CHECK(out.solutions.at(0).x == Approx(1.0));
  CHECK_THROWS_AS(find_values(between(2.0, 1.0, 0.0), [](double x) { return x; }), InputError);
}

TEST_CASE("parse_unknown() and parse_target(): forms and errors", "[unit][find]") {
  const FindUnknown x = parse_unknown("cageGsCls[2]=-1e-5:2e-4");
  CHECK(x.name == "cageGsCls[2]");
  CHECK(x.first == -1e-5);
  CHECK(x.last == 2e-4);
  CHECK(parse_target("life_lp_hours>=2e4").relation == Relation::AtLeast);
  CHECK(parse_target("life_lp_hours>=2e4").name == "life_lp_hours");
  CHECK(parse_target("a<=3").relation == Relation::AtMost);
  CHECK(parse_target("a=largest").relation == Relation::Largest);
  CHECK(parse_target("a=-2").value == -2.0);
  for (const char* wrong : {"rpm2", "=1:2", "rpm2=1", "rpm2=2:1", "rpm2=1:x", "rpm2=1:inf"}) {
    CAPTURE(wrong);
    CHECK_THROWS_AS(parse_unknown(wrong), InputError);
  }
  for (const char* wrong : {"a", "=3", "a=b", "a=nan", ">=3"}) {
    CAPTURE(wrong);
    CHECK_THROWS_AS(parse_target(wrong), InputError);
  }
}
