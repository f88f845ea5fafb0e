#include "base/errors.hpp"
#include "facade/catalogue_torque.hpp"
#include "facade/experiments.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <map>
#include <set>
#include <string>

using namespace adore;
using facade::Experiment;
using facade::ExperimentRow;

TEST_CASE("every experiment has a figure in every row, its kind and its certainty",
          "[validation][experiments]") {
  const std::vector<Experiment> all = facade::run_experiments();
  CHECK(all.size() == 9);
  const std::set<std::string> kinds{"calibration", "prediction", "part", "bound"};
  for (const Experiment& one : all) {
    CAPTURE(one.id);
    CHECK((!one.rows.empty() || !one.open.empty()));  // a figure, or why there is none
    for (const ExperimentRow& row : one.rows) {
      CAPTURE(row.condition, row.what, row.failed);
      REQUIRE(row.ours);
      CHECK(std::isfinite(*row.ours));
      CHECK(kinds.count(row.kind) == 1);
      CHECK_FALSE(row.certainty.empty());
    }
    for (const facade::ExperimentParameter& p : one.parameters) {
      CAPTURE(p.name);
      CHECK(p.value >= p.low);
      CHECK(p.value <= p.high);
    }
  }
}

TEST_CASE("the large bearing is predicted with the parameters of the small one, untouched",
          "[validation][experiments]") {
  const Experiment small = facade::run_experiments("NASA-35").front();
  const Experiment large = facade::run_experiments("NASA-120").front();
  REQUIRE(small.parameters.size() == large.parameters.size());
  for (std::size_t n = 0; n < small.parameters.size(); ++n) {
    CHECK(large.parameters[n].name == small.parameters[n].name);
    CHECK(large.parameters[n].value == small.parameters[n].value);
  }
  for (const ExperimentRow& row : small.rows) CHECK(row.kind == "calibration");
  for (const ExperimentRow& row : large.rows) {
    CHECK(row.kind == "prediction");
    CHECK_FALSE(row.theirs);
    CHECK_FALSE(row.deviation());
  }
  CHECK_THROWS_AS(facade::run_experiments("NASA-1"), InputError);
}

TEST_CASE("the disc of SPIN-DOWN runs down in time, its larger balls with a skid at speed",
          "[validation][experiments]") {
  const Experiment one = facade::run_experiments("SPIN-DOWN").front();
  std::vector<double> still, in_time;
  for (const ExperimentRow& row : one.rows) {
    CAPTURE(row.condition, row.what, row.failed);
    REQUIRE(row.ours);
    if (row.what == "exponent n of T = K w^n") still.push_back(*row.ours);
    if (row.what == "exponent n of -dw/dt = K w^n") in_time.push_back(*row.ours);
    // The error of the implicit steps at tol = 1e-8, 4e-8 (1.3e-6 at 1e-7; explicit steps, 500
    // times as many, leave 2e-14).
    if (row.what == "energy without account") CHECK(*row.ours < 2e-7);
    // Torque where the film carries; slower, where asperities do, ours falls short by up to 42 %.
    if (row.what == "friction torque" && row.condition.ends_with("210 rpm"))
      CHECK(std::abs(*row.deviation()) < 0.15);
  }
  REQUIRE(still.size() == 2);
  REQUIRE(in_time.size() == 2);
  // Balls of 6.35 mm under 0.125 N skid at speed, with 0.07 of the heat, and resist less than the
  // equilibrium says, which rolls freely: the fit goes across the skid and what follows it.
  CHECK(in_time[0] < still[0] - 0.05);
  // Small balls roll, with 0.998 of the heat.
  CHECK(std::abs(in_time[1] - still[1]) < 0.01);
}

TEST_CASE("the tapered bearing has the measured torque, with rib and cage named apart",
          "[validation][experiments][slow]") {
  const Experiment one = facade::run_experiments("TRB-32216").front();
  int still = 0, in_motion = 0, cages = 0;
  double whole = 0.0, parts = 0.0;
  std::map<std::string, double> ribs;
  for (const ExperimentRow& row : one.rows) {
    CAPTURE(row.condition, row.what, row.failed);
    REQUIRE(row.ours);
    // +5 to +25 %, with nothing fitted.
    if (row.what == "friction torque" && row.theirs) {
      ++still;
      CHECK(std::abs(*row.deviation()) < 0.26);
    }
    // The rib slides in an equilibrium as in motion, but for the skew of its rollers.
    if (row.what == "of it the rib" && !row.condition.ends_with("in motion"))
      ribs[row.condition + ", in motion"] = *row.ours;
    else if (row.what == "of it the rib")
      CHECK(*row.ours == Approx(ribs.at(row.condition)).epsilon(0.15));
    if (row.what == "friction torque in motion") {
      ++in_motion;
      CHECK(std::abs(*row.deviation()) < 0.3);
      CHECK(parts == Approx(whole).epsilon(1e-9));  // of the run before
      whole = *row.ours;
      parts = 0.0;
    }
    if (row.condition.ends_with("in motion") && row.what.starts_with("of it ")) parts += *row.ours;
    if (row.what == "of it the cage") {
      ++cages;
      CHECK(*row.ours > 0.0);
      CHECK(*row.ours < 0.01 * whole);  // 3 N mm: it "contributes only slightly", says the source
    }
    if (row.what == "energy without account") CHECK(*row.ours < 1e-6);
  }
  CHECK(still == 7);
  CHECK(in_motion == 3);
  CHECK(cages == 3);
  CHECK(parts == Approx(whole).epsilon(1e-9));
}

TEST_CASE("a deviation counts from the nearer end of a range", "[unit][experiments]") {
  ExperimentRow row;
  row.ours = 0.7;
  CHECK_FALSE(row.deviation());
  row.theirs = 0.5;
  CHECK(*row.deviation() == Approx(0.4));
  row.theirs_to = 0.8;
  CHECK(*row.deviation() == 0.0);
  row.ours = 1.0;
  CHECK(*row.deviation() == Approx(0.25));
  row.kind = "bound";
  CHECK_FALSE(row.deviation());
}

TEST_CASE("friction torques grow with speed and load and lie in the range of the catalogue",
          "[validation][experiments]") {
  for (const facade::TorqueTable& table : facade::catalogue_torques()) {
    CAPTURE(table.bearing);
    CHECK(table.lines.size() == 12);
    for (std::size_t n = 0; n < table.lines.size(); ++n) {
      const facade::TorqueLine& line = table.lines[n];
      CAPTURE(line.rpm, line.radial);
      CHECK(line.rolling > 0.45 * line.catalogue_rolling);  // 0.50 to 1.61, the page says why
      CHECK(line.rolling < 1.7 * line.catalogue_rolling);
      if (n % 4 > 0) CHECK(line.rolling > table.lines[n - 1].rolling);
      if (n >= 4) CHECK(line.total() > table.lines[n - 4].total());
    }
  }
}
