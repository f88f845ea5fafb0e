#include "studies/cage_whirl.hpp"
#include "studies/job.hpp"
#include "studies/quantities.hpp"
#include "studies/sensitivity.hpp"
#include "studies/statistics.hpp"
#include "studies/worst_case.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numbers>

using namespace adore::studies;

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// A cage centre that runs through a circle at `ratio` of the cage's speed, with a wobble.
std::vector<CageInstant> circle(double radius, double ratio, double wobble) {
  std::vector<CageInstant> out;
  for (int i = 0; i < 2000; ++i) {
    const double t = 0.01 * i, omega = 400.0;
    const double theta = ratio * omega * t + wobble * std::sin(3.0 * omega * t);
    const double speed = ratio * omega + 3.0 * omega * wobble * std::cos(3.0 * omega * t);
    out.push_back({-radius * std::sin(theta), radius * std::cos(theta),
                   -radius * speed * std::cos(theta), -radius * speed * std::sin(theta), omega});
  }
  return out;
}

}  // namespace

TEST_CASE("a cage that circles whirls at that ratio, one that stays rests", "[unit][studies]") {
  const Whirl even = judge_whirl(circle(0.8, 0.7, 0.0));
  CHECK(even.ratio == Approx(0.7).epsilon(1e-12));
  CHECK(even.deviation == Approx(0.0).margin(1e-12));
  CHECK(even.orbit == Approx(0.8).epsilon(0.01));
  CHECK(even.of == WhirlClass::Whirling);
  CHECK(judge_whirl(circle(0.8, -0.7, 0.0)).ratio == Approx(-0.7).epsilon(1e-12));

  // Mean square of 3 w cos: 4.5 w².
  const Whirl uneven = judge_whirl(circle(0.8, 0.7, 0.2));
  CHECK(uneven.deviation == Approx(std::sqrt(4.5) * 0.2).epsilon(0.02));
  CHECK(uneven.of == WhirlClass::Irregular);

  std::vector<CageInstant> resting(100, CageInstant{0.0, -0.9, 0.0, 0.0, 400.0});
  CHECK(judge_whirl(resting).of == WhirlClass::Resting);
  CHECK(judge_whirl(resting).ratio == 0.0);
}

TEST_CASE("statistics weigh time, and leave missing values out", "[unit][studies]") {
  // A ramp 0 to 1, sampled unevenly: the mean over time is 1/2.
  const std::vector<double> times{0.0, 0.1, 0.2, 1.0}, values{0.0, 0.1, 0.2, 1.0};
  CHECK(statistic(Statistic::Mean, 0, times, values, 1) == Approx(0.5));
  CHECK(statistic(Statistic::Largest, 0, times, values, 1) == 1.0);
  CHECK(statistic(Statistic::Span, 0, times, values, 1) == 1.0);
  CHECK(statistic(Statistic::Last, 0, times, values, 1) == 1.0);
  CHECK(statistic(Statistic::Percentile, 50, times, values, 1) == Approx(0.15));
  const std::vector<double> two{1.0, 3.0, 1.0, 3.0};
  CHECK(statistic(Statistic::Mean, 0, {0.0, 1.0}, two, 2) == Approx(2.0));
  CHECK(statistic(Statistic::Deviation, 0, {0.0, 1.0}, two, 2) == Approx(1.0));
  CHECK(statistic(Statistic::Rms, 0, {0.0, 1.0}, two, 2) == Approx(std::sqrt(5.0)));
  CHECK(statistic(Statistic::LargestSize, 0, {0.0}, {-4.0, kNone, 2.0}, 3) == 4.0);
  CHECK(std::isnan(statistic(Statistic::Mean, 0, {0.0}, {kNone}, 1)));

  const Summary summary =
      summarise({3.0, kNone, 1.0, 2.0, std::numeric_limits<double>::infinity()}, {50.0});
  CHECK(summary.count == 3);
  CHECK(summary.infinite == 1);
  CHECK(summary.mean == Approx(2.0));
  CHECK(summary.deviation == Approx(1.0));
  CHECK(summary.percentiles[0].value == 2.0);
  CHECK(rank_correlation({1, 2, 3, 4}, {1, 8, 27, 64}) == Approx(1.0));
  CHECK(rank_correlation({1, 2, 3, 4}, {4, 3, kNone, 1}) == Approx(-1.0));
  CHECK(std::isnan(rank_correlation({1, 1, 1}, {1, 2, 3})));
}

TEST_CASE("the search finds a summit inside and a corner", "[unit][studies]") {
  Study study;
  study.kind = Kind::WorstCase;
  study.samples = 8;
  study.rounds = 40;
  for (const char* name : {"a", "b", "c"}) {
    Variable variable;
    variable.name = name;
    variable.targets = {name};
    variable.law = Law::Uniform;
    variable.a = -1.0;
    variable.b = 3.0;
    study.variables.push_back(variable);
  }
  const auto find = [&](auto&& f) {
    WorstCaseSearch search(study);
    std::vector<Point> points = first_round(study);
    while (!points.empty()) {
      std::vector<double> values;
      for (const Point& point : points) values.push_back(f(point.values));
      points = search.next(points, values);
    }
    return search;
  };
  const WorstCaseSearch inside = find([](const std::vector<double>& v) {
    return 5.0 - (v[0] - 0.3) * (v[0] - 0.3) - 2.0 * (v[1] + 0.4) * (v[1] + 0.4) -
           (v[2] - v[0]) * (v[2] - v[0]);
  });
  CHECK(inside.value() == Approx(5.0).margin(0.01));
  CHECK(inside.best()[1] == Approx(-0.4).margin(0.1));
  study.seek_largest = false;
  const WorstCaseSearch corner =
      find([](const std::vector<double>& v) { return v[0] - 2.0 * v[1] + v[2]; });
  CHECK(corner.best() == std::vector<double>{-1.0, 3.0, -1.0});
  // Failed runs are passed by.
  const WorstCaseSearch holes = find(
      [](const std::vector<double>& v) { return v[1] > 2.9 ? kNone : v[0] - 2.0 * v[1] + v[2]; });
  CHECK(holes.best()[1] > 2.5);
}

TEST_CASE("differences of fourth order have the derivative of a quintic's lower part",
          "[unit][studies]") {
  const auto f = [](double x) { return 2.0 + 3.0 * x + x * x - 4.0 * x * x * x + x * x * x * x; };
  const double h = 0.1;
  const Derivative d = difference({f(-2 * h), f(-h), f(h), f(2 * h)}, h);
  CHECK(d.value == Approx(3.0).epsilon(1e-12));
  CHECK(d.doubt == Approx(4.0 * h * h).epsilon(1e-10));  // (d1 - d2)/3 = 4 h² f'''/24
}

TEST_CASE("a record comes back to the last bit, and a damaged one is none", "[unit][studies]") {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / "adore-test-records";
  std::filesystem::remove_all(folder);
  Record record;
  record.key = "00112233445566778899aabbccddeeff";
  record.exit_code = 3;
  record.values = {1.0 / 3.0, kNone, std::numeric_limits<double>::infinity(), -2e-308};
  record.message = "no equilibrium: \"x\", \xff";
  write_record(folder, record);
  const auto back = read_record(folder, record.key);
  REQUIRE(back);
  CHECK(back->values[0] == record.values[0]);
  CHECK(std::isnan(back->values[1]));
  CHECK(back->values[2] == record.values[2]);
  CHECK(back->values[3] == record.values[3]);
  CHECK(back->exit_code == 3);
  const auto file = record_file(folder, record.key);
  std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
  CHECK_FALSE(read_record(folder, record.key));
  std::filesystem::remove_all(folder);
}
