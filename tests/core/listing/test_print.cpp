#include "base/errors.hpp"
#include "core/results/synthetic.hpp"
#include "deck/deck.hpp"
#include "listing/print_file.hpp"
#include "listing/static_summary.hpp"
#include "results/fortran_format.hpp"
#include "support/paths.hpp"

#include <catch2/catch.hpp>

#include <functional>
#include <limits>
#include <sstream>

using namespace adore;
using namespace adore::listing;
using namespace adore::testing;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;

namespace {

/// The page rules hold everywhere: width, length, heading of every page.
void check_pages(const std::string& text) {
  REQUIRE(text.substr(0, 1) == "\f");
  int on_page = 0;
  for (const std::string& line : lines_of(text)) {
    if (!line.empty() && line[0] == '\f') {
      CHECK_THAT(line, Contains("Adore 0.9.0") && Contains("synthetic run 7"));
      on_page = 0;
    }
    CAPTURE(line);
    REQUIRE(line.size() <= Report::kColumns + 1);  // a form feed takes no column
    REQUIRE(++on_page <= Report::kLines);
  }
}

/// The line that holds `text`; fails when there is none.
std::string line_with(const std::string& page, const std::string& text) {
  for (const std::string& line : lines_of(page))
    if (line.find(text) != std::string::npos) return line;
  FAIL("no line with '" << text << "'");
  return {};
}

statics::StaticSolution make_solution() {
  statics::StaticSolution solution;
  solution.displacement = {1e-5, 0.0, -2e-5, 0.001, 0.0};
  solution.load = {1000.0, 0.0, -500.0, 0.0, 2.5};
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j) solution.stiffness(i, j) = 1e7 * (i + 1) + 1e5 * j;
  for (int k = 0; k < 3; ++k) {
    statics::StaticBall ball;
    ball.azimuth = 2.0 * k;
    ball.Q = {100.0 + k, 90.0 + k};
    ball.alpha = {0.3, k == 2 ? std::numeric_limits<double>::quiet_NaN() : 0.4};
    ball.p_max = {1.5e9, 1.6e9};
    ball.a = {2e-4, 3e-4};
    ball.omega_x = -2000.0;
    ball.orbital_speed = 400.0;
    ball.centrifugal_force = 12.5;
    solution.balls.push_back(ball);
  }
  solution.max_load = 102.0;
  solution.notes = {
      adore::make_finding("statics.outer_only", "ball 3 touches the outer race only")};
  return solution;
}

std::string read_text(const std::filesystem::path& path) { return read_bytes(path); }

}  // namespace

TEST_CASE("PRINT: the front part has every record and every variable of the deck",
          "[unit][print]") {
  for (const char* example : {"ball.txt", "ball-english.txt"}) {
    const deck::ReadResult read =
        deck::read_deck(adore::test::source_dir().string() + "/resources/decks/" + example);
    REQUIRE(read.ok());
    const bearing::Bearing bearing = make_bearing();
    TemporaryFolder folder;
    {
      PrintFile print = PrintFile::create(folder / "PRINT.txt", bearing.run_id, read.deck.units());
      print.front(
          {read.deck, bearing, scene::Scales{0.00635, 1000.0, 2e-5}, {{"ellipse_major", "12"}}});
    }
    const std::string text = read_text(folder / "PRINT.txt");
    check_pages(text);
    for (const deck::RecordData& record : read.deck.records) {
      const deck::RecordSpec* spec = deck::find_record(record.id);
      CAPTURE(record.id);
      CHECK_THAT(text, Contains("Record " + record.id + (spec->repeat.empty() ? ":" : " (")));
      for (const deck::VariableSpec& variable : spec->variables)
        CHECK_THAT(text, Contains("    " + std::string(variable.name) + " "));
    }
    for (const char* part :
         {"BEARING GEOMETRY", "MATERIAL PROPERTIES", "Inertia", "Traction coefficient",
          "INITIAL OPERATING CONDITIONS", "Translation: outer x, y, z, inner x, y, z",
          "Scale factors", "Output control", "Named options"})
      CHECK_THAT(text, Contains(part));
    const bool si = read.deck.units() == UnitSystem::SI;
    const std::string time = line_with(text, "Time: sqrt(mass / stiffness)");
    CHECK_THAT(time, Contains("2e-05  s"));
    CHECK_THAT(line_with(text, "Length: radius"), Contains(si ? "0.00635  m" : "0.25  in"));
    CHECK_THAT(line_with(text, "Force: largest"), Contains(si ? "1000  N" : "224.8089  lbf"));
  }
}

TEST_CASE("PRINT: quasi-static page → every number with its unit", "[unit][print]") {
  const bearing::Bearing bearing = make_bearing();
  for (const UnitSystem units : {UnitSystem::SI, UnitSystem::English}) {
    Report report(bearing.run_id, units);
    print_quasi_static(report, make_solution(), bearing);
    const std::string text = report.take();
    check_pages(text);
    const bool si = units == UnitSystem::SI;
    CHECK_THAT(line_with(text, "  x    "),
               Contains(si ? "1e-05             m" : "0.0003937008      in") &&
                   Contains(si ? "1000" : "224.8089"));
    CHECK_THAT(line_with(text, "  about y "), Contains("0.05729578        deg"));
    CHECK_THAT(line_with(text, "Largest contact load"), Contains(si ? "102  N" : "22.93051  lbf"));
    // K[Fx][z] = 1.02e7 N/m; K[My][rot z] = 4.04e7 N m/rad.
    CHECK_THAT(line_with(text, si ? "Fx [N]" : "Fx [lbf]"), Contains(si ? "1.02e+07" : "58244"));
    CHECK_THAT(line_with(text, si ? "My [N.m]" : "My [lbf.in]"),
               Contains(si ? "4.04e+07" : "3.5757e+08"));
    CHECK_THAT(text, Contains("ball 3 touches the outer race only"));
    CHECK_THAT(text, Contains(si ? "[N.m]" : "[lbf.in]") && Contains(si ? "[Pa]" : "[lbf/in^2]"));
    // The unloaded contact has no angle.
    const auto lines = lines_of(text);
    const auto third = std::find_if(lines.begin(), lines.end(), [](const std::string& line) {
      return line.substr(0, 6) == "  3   ";
    });
    REQUIRE(third != lines.end());
    CHECK_THAT(*third, Contains(" - "));
  }
}

TEST_CASE("PRINT: edges of the contacts for both races with their limits", "[unit][print]") {
  bearing::Bearing bearing = make_bearing();
  bearing.balls().shim = {0.0, 4e-4};
  statics::StaticSolution solution = make_solution();
  solution.balls[0].shoulder_depth = {1.1e-3, 1.2e-3};
  solution.balls[0].inner_chord = {2.1e-3, 2.2e-3};
  solution.balls[1].spin_roll = {7e-17, 0.25};
  Report report(bearing.run_id, UnitSystem::SI);
  print_quasi_static(report, solution, bearing);
  const std::string text = report.take();
  check_pages(text);
  CHECK_THAT(line_with(text, "s outer"), Contains("t outer     s inner     t inner"));
  CHECK_THAT(line_with(text, "0.0021"), Contains("0.0011      0.0021      0.0012      0.0022"));
  CHECK_THAT(text, Contains("(shoulder diameter 0.063 m); t above 0.0002 m"));
  // Rounding is no spin.
  CHECK_THAT(line_with(text, "0.25"), Contains("           0        0.25"));
}

TEST_CASE("PRINT: tilt of the inner race in the base frame and relative to the outer race",
          "[unit][print]") {
  bearing::Bearing bearing = make_bearing();
  bearing.constraints.outer_misalignment = {0.001, 0.002};
  statics::StaticSolution solution = make_solution();
  solution.displacement[3] = 0.001;
  solution.displacement[4] = 0.002;
  Report report(bearing.run_id, UnitSystem::SI);
  print_quasi_static(report, solution, bearing);
  const std::string text = report.take();
  CHECK_THAT(line_with(text, "Tilt of the outer race about z"), Contains("0.1145916  deg"));
  CHECK_THAT(line_with(text, "relative to the outer race about y"), Contains(" 0  deg"));
  CHECK_THAT(line_with(text, "relative to the outer race about z"), Contains(" 0  deg"));
  // Large tilts about one axis subtract.
  const auto tilt = relative_tilt({0.7, 0.0}, {0.2, 0.0});
  CHECK(tilt[0] == Approx(0.5).epsilon(1e-14));
  CHECK(tilt[1] == Approx(0.0).margin(1e-15));
}

TEST_CASE("PRINT: kPrtOpt → sections of a printed step", "[unit][print]") {
  bearing::Bearing bearing = make_bearing(30);
  const scene::Snapshot snapshot = make_snapshot(bearing, 100);
  ChannelRecorder recorder(bearing, UnitSystem::SI, channel_table());
  const StepRecord& record = recorder.record(snapshot);
  RunAverages averages;
  averages.add(make_snapshot(bearing, 0));
  averages.add(snapshot);
  const auto print = [&](int kPrtOpt) {
    Report report(bearing.run_id, UnitSystem::SI);
    print_step(report, snapshot, record, bearing, averages.averages(), kPrtOpt, {},
               RaceFrictionModel::Film);
    const std::string text = report.take();
    check_pages(text);
    return text;
  };
  const auto sections = [](const std::string& text) {
    std::string found;
    for (const char* title :
         {"  1. Rolling element", "  2. Race and cage", "  3. Applied", "  4. Time step"}) {
      if (text.find(title) != std::string::npos) found += title[2];
    }
    return found;
  };
  CHECK(sections(print(-2)) == "4");
  CHECK(sections(print(-1)) == "34");
  CHECK(sections(print(0)) == "234");
  CHECK(sections(print(1)) == "1234");
  CHECK(sections(print(7)) == "1234");
  const auto rows = [](const std::string& text, const std::string& name) {
    long count = 0;
    for (const std::string& line : lines_of(text))
      count += line.substr(0, name.size()) == name ? 1 : 0;
    return count;
  };
  CHECK(rows(print(1), "  2   ") == 7);  // position, orientation, two races, films, heat, pocket
  CHECK(rows(print(1), "  29  ") == 7);
  CHECK(rows(print(7), "  2   ") == 0);
  CHECK(rows(print(7), "  29  ") == 7);  // 1, 8, 15, 22, 29

  const std::string text = print(1);
  CHECK_THAT(line_with(text, "Orbital velocity ratio"), Contains("0.4"));
  CHECK_THAT(line_with(text, "Cage angular velocity ratio"), Contains("0.43"));
  CHECK_THAT(line_with(text, "Power loss, average"), Contains("55  W"));
  CHECK_THAT(line_with(text, "Bearing rotation"), Contains("0.1591549  rev"));
  CHECK_THAT(line_with(text, "Displacement of the inner relative to the outer race along z"),
             Contains("-1e-05  m"));
  CHECK_THAT(line_with(text, "Energy residual"), Contains("J"));
  const bearing::Bearing cageless = make_bearing(3, false);
  ChannelRecorder plain(cageless, UnitSystem::SI, channel_table());
  Report report(cageless.run_id, UnitSystem::SI);
  const scene::Snapshot bare = make_snapshot(cageless, 1);
  print_step(report, bare, plain.record(bare), cageless, {}, 1);
  const std::string without = report.take();
  CHECK(without.find("whirl ratio") == std::string::npos);
  CHECK(without.find("pocket") != 0);
}

TEST_CASE("PRINT: time zero → no averages, and no wear without integrals", "[unit][print]") {
  const bearing::Bearing bearing = make_bearing();
  ChannelRecorder recorder(bearing, UnitSystem::SI, channel_table());
  RunAverages averages;
  const auto print = [&](long step, bool integrated) {
    scene::Snapshot snapshot = make_snapshot(bearing, step);
    snapshot.power.integrated = integrated;
    averages.add(snapshot);
    Report report(bearing.run_id, UnitSystem::SI);
    print_step(report, snapshot, recorder.record(snapshot), bearing, averages.averages(), 1, {},
               RaceFrictionModel::Film);
    return report.take();
  };
  const std::vector<std::string> ratios{"Orbital velocity ratio", "Cage angular velocity ratio",
                                        "Cage whirl ratio"},
      wear{"Average wear rate, rolling element 1", "Average wear rate, outer race",
           "Average wear rate, inner race", "Average wear rate, cage"};
  std::string text = print(0, true);
  for (const auto* lines : {&ratios, &wear})
    for (const std::string& line : *lines)
      CHECK_THAT(line_with(text, line), Contains("not computed at time zero"));
  text = print(100, true);
  for (const auto* lines : {&ratios, &wear})
    for (const std::string& line : *lines)
      CHECK_THAT(line_with(text, line), !Contains("not computed"));
  text = print(200, false);
  for (const std::string& line : ratios)
    CHECK_THAT(line_with(text, line), !Contains("not computed"));
  for (const std::string& line : wear)
    CHECK_THAT(line_with(text, line), Contains("not computed (wear integrals are off)"));
}

TEST_CASE("PRINT: printed step → half chords of inner contacts, and results that were not computed",
          "[unit][print]") {
  const bearing::Bearing bearing = make_bearing(3, false);
  scene::Snapshot snapshot = make_snapshot(bearing, 20);
  for (scene::ElementSnapshot& element : snapshot.elements)
    for (scene::RaceContactSnapshot& contact : element.race) {
      contact.film = contact.temperature_rise = 0.0;
      contact.edge = 0.00111;
      contact.centre_chord = 0.00222;
    }
  snapshot.power.life_hours = 1234.0;
  RaceFrictionModel in_force = RaceFrictionModel::Curve;
  const auto print = [&](std::optional<long> life_step) {
    ChannelRecorder recorder(bearing, UnitSystem::SI, channel_table());
    Report report(bearing.run_id, UnitSystem::SI);
    print_step(report, snapshot, recorder.record(snapshot), bearing, {}, 1, life_step, in_force);
    return report.take();
  };
  const std::string text = print({});
  const auto row_after = [&](const std::string& heading) {
    const std::size_t row = text.find("\n  2   ", text.find(heading));
    return text.substr(row + 1, text.find('\n', row + 1) - row - 1);
  };
  CHECK_THAT(row_after("Contacts with the outer race"), EndsWith(" 0.00111"));
  CHECK_THAT(row_after("Contacts with the inner race"), EndsWith(" 0.00222"));
  CHECK_THAT(line_with(text, "Film thickness"), Contains("not computed"));
  CHECK_THAT(line_with(text, "Contact temperature"), Contains("not computed"));
  CHECK(text.find("rise outer") == std::string::npos);
  CHECK_THAT(line_with(text, "Fatigue life"), Contains("at the current loads"));
  CHECK_THAT(line_with(print(7), "Fatigue life"), Contains("at the loads of step 7"));

  // The law in force says whether there are films, not what they are: at rest all of them are 0.
  for (const auto& [friction, reason] :
       {std::pair{RaceFrictionModel::Curve, "hypothetical traction"},
        {RaceFrictionModel::OfUser, "user routine ADRX7"},
        {RaceFrictionModel::None, "no race friction"}}) {
    in_force = friction;
    CHECK_THAT(line_with(print({}), "Film thickness"), Contains(reason));
    CHECK_THAT(line_with(print({}), "Contact temperature"), Contains(reason));
  }
  in_force = RaceFrictionModel::Film;
  const std::string in_oil = print({});
  CHECK_THAT(in_oil, Contains("rise outer") && Contains(" film ") && Contains("least outer"));
  CHECK(in_oil.find("Film thickness (") == std::string::npos);
  CHECK(in_oil.find("hypothetical") == std::string::npos);
}

TEST_CASE("PRINT: tilted race → misalignment about y and z", "[unit][print]") {
  bearing::Bearing bearing = make_bearing(3, false);
  scene::Snapshot snapshot = make_snapshot(bearing, 0);
  const double tilt = 0.002;  // about y
  snapshot.races[1].orientation = {std::cos(tilt / 2), 0.0, std::sin(tilt / 2), 0.0};
  ChannelRecorder recorder(bearing, UnitSystem::SI, channel_table());
  Report report(bearing.run_id, UnitSystem::SI);
  print_step(report, snapshot, recorder.record(snapshot), bearing, {}, -1);
  const std::string text = report.take();
  CHECK_THAT(line_with(text, "Misalignment of the inner race about y"), Contains("0.1145916  deg"));
  CHECK_THAT(line_with(text, "Misalignment of the inner race about z"), Contains(" 0  deg"));
}

TEST_CASE("PRINT: the last page has plan, ledgers and cost", "[unit][print]") {
  RunSummary run;
  run.status = "done";
  run.integrator = "rkf5";
  run.tolerance = 1e-6;
  run.steps = 500;
  run.counters = {{"rejected", 3}};
  run.energy = make_snapshot(make_bearing(), 100).energy;
  run.max_quaternion_error = 2e-16;
  run.quadrature_error = {1e-4, 10.1, 10.0};
  run.cost = {{"race contacts", 1000, 0.6}, {"stepper", 500, 0.39}};
  run.seconds = 1.0;
  run.findings = {
      make_finding("run.start_friction",
                   "a note that is long " + std::string(200, 'x') + " and goes on after it")};
  scene::ScenePlan plan;
  plan.effects = {{scene::Effect::RaceContact, "race contact", true, "kBrg = 1"},
                  {scene::Effect::Gravity, "gravity", false, "gravityVec = 0"}};
  plan.bodies = {{"balls (12)", "x, r, theta", 72}};
  Report report("synthetic run 7", UnitSystem::SI);
  print_ledgers(report, run, plan);
  const std::string text = report.take();
  check_pages(text);
  CHECK_THAT(line_with(text, "gravityVec"), Contains("off"));
  CHECK_THAT(line_with(text, "  race contacts"), Contains("60.0 %") && Contains("1000"));
  CHECK_THAT(line_with(text, "sum of these parts"), Contains("99.0 %"));
  CHECK_THAT(line_with(text, "  residual  "), Contains("J"));
  CHECK_THAT(line_with(text, "error of the contact integrals"), Contains("0.0001"));
  CHECK_THAT(text, Contains("and goes on after it"));
}

TEST_CASE("PRINT: titles of a table are separated", "[unit][print]") {
  Report report("run", UnitSystem::SI);
  CHECK_NOTHROW(report.table("", {{"eleven long", nullptr}}, {{"1", {2.0}}}));
  CHECK_THROWS_AS(report.table("", {{"twelve  long", nullptr}}, {{"1", {2.0}}}), InternalError);
}

TEST_CASE("PRINT: continued after the length stored in MASTER", "[unit][print]") {
  const bearing::Bearing bearing = make_bearing();
  TemporaryFolder folder;
  ChannelRecorder recorder(bearing, UnitSystem::SI, channel_table());
  const auto step = [&](PrintFile& print, long number) {
    const scene::Snapshot snapshot = make_snapshot(bearing, number);
    print.step(snapshot, recorder.record(snapshot), bearing, {}, -2);
  };
  std::uintmax_t bytes = 0;
  {
    PrintFile print = PrintFile::create(folder / "PRINT.txt", bearing.run_id, UnitSystem::SI);
    step(print, 1);
    bytes = print.file().bytes();
    CHECK(bytes == std::filesystem::file_size(folder / "PRINT.txt"));  // on disk at once
    step(print, 2);
  }
  {
    PrintFile print =
        PrintFile::continue_after(folder / "PRINT.txt", bearing.run_id, UnitSystem::SI, bytes);
    step(print, 3);
  }
  const std::string text = read_text(folder / "PRINT.txt");
  check_pages(text);
  CHECK_THAT(text, Contains("STEP 1") && Contains("STEP 3"));
  CHECK(text.find("STEP 2") == std::string::npos);
  CHECK_THAT(message_of([&] {
               PrintFile::continue_after(folder / "PRINT.txt", "another run", UnitSystem::SI,
                                         bytes);
             }),
             Contains("synthetic run 7") && Contains("another run"));
  CHECK_THAT(message_of([&] {
               PrintFile::continue_after(folder / "none", bearing.run_id, UnitSystem::SI, bytes);
             }),
             Contains("cannot open the file"));
  CHECK_THAT(message_of([&] {
               PrintFile print = PrintFile::create("/dev/full", bearing.run_id, UnitSystem::SI);
             }),
             Contains("not a regular file"));
}
