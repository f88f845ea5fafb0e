#include "base/errors.hpp"
#include "studies/cage_whirl.hpp"
#include "studies/charts.hpp"
#include "studies/engine.hpp"
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

/// A cage center that runs through a circle at `ratio` of the cage's speed, with a wobble.
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

TEST_CASE("cage whirl: circling cage → whirling at that ratio, resting cage → resting",
          "[unit][studies]") {
  const Whirl even = classify_whirl(circle(0.8, 0.7, 0.0));
  CHECK(even.ratio == Approx(0.7).epsilon(1e-12));
  CHECK(even.deviation == Approx(0.0).margin(1e-12));
  CHECK(even.orbit == Approx(0.8).epsilon(0.01));
  CHECK(even.of == WhirlClass::Whirling);
  CHECK(classify_whirl(circle(0.8, -0.7, 0.0)).ratio == Approx(-0.7).epsilon(1e-12));

  // Mean square of 3 w cos: 4.5 w².
  const Whirl uneven = classify_whirl(circle(0.8, 0.7, 0.2));
  CHECK(uneven.deviation == Approx(std::sqrt(4.5) * 0.2).epsilon(0.02));
  CHECK(uneven.of == WhirlClass::Irregular);

  std::vector<CageInstant> resting(100, CageInstant{0.0, -0.9, 0.0, 0.0, 400.0});
  CHECK(classify_whirl(resting).of == WhirlClass::Resting);
  CHECK(classify_whirl(resting).ratio == 0.0);
}

TEST_CASE("statistics: weighted by time, without missing values", "[unit][studies]") {
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
      summarize({3.0, kNone, 1.0, 2.0, std::numeric_limits<double>::infinity()}, {50.0});
  CHECK(summary.count == 3);
  CHECK(summary.infinite == 1);
  CHECK(summary.mean == Approx(2.0));
  CHECK(summary.deviation == Approx(1.0));
  CHECK(summary.percentiles[0].value == 2.0);
  CHECK(rank_correlation({1, 2, 3, 4}, {1, 8, 27, 64}) == Approx(1.0));
  CHECK(rank_correlation({1, 2, 3, 4}, {4, 3, kNone, 1}) == Approx(-1.0));
  CHECK(std::isnan(rank_correlation({1, 1, 1}, {1, 2, 3})));
}

TEST_CASE("parallel chart: axes of all runs keep room for quantities", "[unit][studies]") {
  const auto columns = [](const std::string& name, std::size_t count) {
    std::vector<TableColumn> out;
    for (std::size_t k = 0; k < count; ++k)
      out.push_back(
          {name + std::to_string(k), "", {0.0, std::nan(""), 1.0 + static_cast<double>(k)}});
    return out;
  };
  std::vector<TableColumn> variables = columns("v", 30), quantities = columns("q", 3);
  variables.front().values = {2.0, 2.0, std::nan("")};  // says nothing
  auto axes = parallel_chart_axes(variables, quantities);
  REQUIRE(axes.size() == 12);
  CHECK(axes.front()->name == "v1");
  CHECK(axes[9]->name == "q0");
  CHECK(axes.back()->name == "q2");
  quantities = columns("q", 20);
  axes = parallel_chart_axes(variables, quantities);
  CHECK(axes.size() == 12);
  CHECK(axes[5]->name == "v6");
  CHECK(axes.back()->name == "q5");
  CHECK(parallel_chart_axes(columns("v", 2), quantities).size() == 12);
}

TEST_CASE("worst case: maximum inside and in a corner → found", "[unit][studies]") {
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
    std::vector<Point> points = first_round_points(study);
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

TEST_CASE("sensitivity: fourth-order differences → derivative of a quintic's lower part",
          "[unit][studies]") {
  const auto f = [](double x) { return 2.0 + 3.0 * x + x * x - 4.0 * x * x * x + x * x * x * x; };
  const double h = 0.1;
  const Derivative d = difference({f(-2 * h), f(-h), f(h), f(2 * h)}, h);
  CHECK(d.value == Approx(3.0).epsilon(1e-12));
  CHECK(d.doubt == Approx(4.0 * h * h).epsilon(1e-10));  // (d1 - d2)/3 = 4 h² f'''/24
}

TEST_CASE("record: reads back to the last bit; damaged record → none", "[unit][studies]") {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / "adore-test-records";
  std::filesystem::remove_all(folder);
  Record record;
  record.key = "00112233445566778899aabbccddeeff";
  record.exit_code = 3;
  record.values = {1.0 / 3.0, kNone, std::numeric_limits<double>::infinity(), -2e-308};
  record.message = "no equilibrium: \"x\", \xff";
  record.codes = {"cage.whirling", "statics.shoulder"};
  write_record(folder, record);
  const auto back = read_record(folder, record.key);
  REQUIRE(back);
  CHECK(back->values[0] == record.values[0]);
  CHECK(std::isnan(back->values[1]));
  CHECK(back->values[2] == record.values[2]);
  CHECK(back->values[3] == record.values[3]);
  CHECK(back->exit_code == 3);
  CHECK(back->codes == record.codes);
  const auto file = run_record_path(folder, record.key);
  std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
  CHECK_FALSE(read_record(folder, record.key));
  std::filesystem::remove_all(folder);
}

namespace {

/// The local engine with a stand-in for the worker: a shell script that gets KEY of its task.
struct StandIn {
  std::filesystem::path folder;
  EngineRequest work;
  std::vector<Record> done;
  std::string note;

  StandIn(const std::string& name, const std::string& body)
      : folder(std::filesystem::temp_directory_path() / ("adore-test-" + name)) {
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    work.folder = folder;
    work.program = folder / "worker.sh";
    work.workers = 2;
    work.seconds_each = 0.01;
    work.megabytes_each = 1.0;
    for (const char c : {'a', 'b'}) {
      Task task;
      task.number = static_cast<long>(work.tasks.size()) + 1;
      task.key = std::string(32, c);
      work.tasks.push_back(task);
      std::filesystem::create_directories(run_record_path(folder, task.key).parent_path());
    }
    // $3 is the study's folder, as the worker is told.
    std::ofstream(work.program) << "#!/bin/sh\ncd \"$3\"\nwhile read -r line; do\n"
                                   "case $line in *aaaaaaaaaaaaaaaa*) key=" +
                                       work.tasks[0].key + ";; *) key=" + work.tasks[1].key +
                                       ";; esac\n" + body + "\ndone\n";
    std::filesystem::permissions(work.program, std::filesystem::perms::owner_all);
  }
  ~StandIn() { std::filesystem::remove_all(folder); }
  StandIn(const StandIn&) = delete;
  StandIn& operator=(const StandIn&) = delete;

  void run() {
    run_local(
        work, [&](const Record& record) { done.push_back(record); },
        [&](int, const std::string& said) {
          if (!said.empty()) note = said;
        },
        {});
  }
  [[nodiscard]] std::size_t starts(std::size_t task) const {
    std::error_code error;
    const auto size = std::filesystem::file_size(folder / work.tasks[task].key, error);
    return error ? 0 : static_cast<std::size_t>(size);
  }
};

/// One character a start of that run.
const std::string kCount = "printf x >>$key\n";
const std::string kAnswer =
    R"(printf '{"adore_run":1,"key":"%s","exit":0,"values":[1],"message":"","measured":{"processor":1,"wall":1,"memory_megabytes":1,"disk_megabytes":1,"host":"h"}}\n' $key >next_$key
mv next_$key runs/$(printf %.2s $key)/$key.json
echo done $key
)";

}  // namespace

TEST_CASE("study: run whose process is killed repeatedly → computed in the end",
          "[unit][studies]") {
  StandIn engine("kills", kCount + "[ $(wc -c <$key) -gt 12 ] || kill -KILL $$\n" + kAnswer);
  engine.run();
  REQUIRE(engine.done.size() == 2);
  for (std::size_t k = 0; k < 2; ++k) {
    CHECK(engine.done[k].exit_code == 0);
    CHECK(engine.done[k].values == std::vector<double>{1.0});
    CHECK(engine.starts(k) == 13);
  }
  CHECK(engine.note.find("24 killed runs repeated") != std::string::npos);
}

TEST_CASE("study: run whose process is always killed → unfinished, without a record of failure",
          "[unit][studies]") {
  for (const char* signal : {"KILL", "TERM"}) {
    StandIn engine("always-killed",
                   kCount + "case $key in a*) kill -" + signal + " $$;; esac\n" + kAnswer);
    CHECK_THROWS_WITH(engine.run(), Catch::Contains("1 run has no result") &&
                                        Catch::Contains("was killed 20 times"));
    REQUIRE(engine.done.size() == 1);
    CHECK(engine.done[0].key == engine.work.tasks[1].key);
    CHECK(engine.starts(0) == 20);
    CHECK_FALSE(read_record(engine.folder, engine.work.tasks[0].key));
  }
}
