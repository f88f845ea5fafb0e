#include "base/errors.hpp"
#include "base/version.hpp"
#include "results/averages.hpp"
#include "results/restart.hpp"
#include "synthetic.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>
#include <limits>
#include <locale>
#include <numbers>
#include <vector>

using namespace adore;
using namespace adore::results;
using namespace adore::testing;
using Catch::Matchers::Contains;

namespace {

FinalState make_state() {
  FinalState state;
  state.version = kProgramVersion;
  state.run_id = "synthetic run 7, with  blanks";
  state.step = 4711;
  state.time = 0.1 + 0.2;  // 0.30000000000000004: needs all digits
  state.step_size = 1.0 / 3.0 * 1e-7;
  state.shaft_rotation = -12.345678901234567;
  state.scales = {0.00635, 1234.5, 2.5e-5};
  state.extras = {{"stored energy at start", 1.0 / 7.0}, {"zero", 0.0}};
  state.components = {"element.x[1] [m]", "element.x[2] [m]", "cage.q[1] [-]"};
  state.state = {std::numeric_limits<double>::denorm_min(), -1.0 / 3.0,
                 std::numeric_limits<double>::max()};
  state.deck = "'Rec 1',0,0\n'Rec 3.1','synthetic'\n";
  return state;
}

void check_equal(const FinalState& a, const FinalState& b) {
  CHECK(a.version == b.version);
  CHECK(a.step == b.step);
  CHECK(a.time == b.time);
  CHECK(a.step_size == b.step_size);
  CHECK(a.shaft_rotation == b.shaft_rotation);
  CHECK(a.scales.length == b.scales.length);
  CHECK(a.scales.force == b.scales.force);
  CHECK(a.scales.time == b.scales.time);
  CHECK(a.extras == b.extras);
  CHECK(a.components == b.components);
  CHECK(a.state == b.state);
  CHECK(a.deck == b.deck);
}

}  // namespace

TEST_CASE("FINAL and MASTER: every bit is reproduced", "[unit][restart]") {
  TemporaryFolder folder;
  const FinalState state = make_state();
  write_final(state, folder / "FINAL");
  check_equal(read_final(folder / "FINAL"), state);
  CHECK(read_final(folder / "FINAL").run_id == "synthetic run 7, with  blanks");
  CHECK_THAT(read_bytes(folder / "FINAL"), Contains("Adore 0.9.0 FINAL") && Contains("SI units") &&
                                               Contains("0.30000000000000004"));

  MasterState master;
  master.last = state;
  master.averages = {{"average time", 0.125}, {"branch cage.theta[0]", -6.25}};
  master.files = {{"PRINT", "PRINT.txt", 123456789012ULL, {}},
                  {"SOL1", "my file with blanks", 42, {}}};
  write_master(master, folder / "MASTER");
  const MasterState back = read_master(folder / "MASTER");
  check_equal(back.last, state);
  CHECK(back.averages == master.averages);
  REQUIRE(back.files.size() == 2);
  CHECK(back.file("PRINT")->bytes == 123456789012ULL);
  CHECK(back.file("SOL1")->name == "my file with blanks");
  CHECK(back.file("SOL2") == nullptr);
}

TEST_CASE("FINAL and MASTER: damaged or foreign file → error with the line", "[unit][restart]") {
  TemporaryFolder folder;
  MasterState master;
  master.last = make_state();
  master.averages = {{"average time", 0.125}};
  master.files = {{"PRINT", "PRINT.txt", 10, {}}};
  write_master(master, folder / "MASTER");
  write_final(make_state(), folder / "FINAL");
  CHECK_THAT(message_of([&] { (void)read_final(folder / "MASTER"); }),
             Contains("not a FINAL file"));
  CHECK_THAT(message_of([&] { (void)read_master(folder / "FINAL"); }),
             Contains("not a MASTER file"));
  CHECK_THAT(message_of([&] { (void)read_final(folder / "nothing"); }), Contains("no such file"));
  CHECK_THAT(message_of([&] { (void)read_final(folder / "."); }), Contains("folder"));
  for (const std::string name : {"FINAL", "MASTER"}) {
    const std::string text = read_bytes(folder / name);
    const auto read = [&] {
      name == "FINAL" ? (void)read_final(folder / name) : (void)read_master(folder / name);
    };
    for (std::size_t size = 0; size + 1 < text.size();
         ++size) {  // without its last line end the file is whole
      write_bytes(folder / name, text.substr(0, size));
      CAPTURE(name, size);
      REQUIRE_THROWS_AS(read(), InputError);
    }
    std::string wrong = text;
    wrong.replace(wrong.find("\ntime 0.3"), 9, "\ntime x.3");
    write_bytes(folder / name, wrong);
    CHECK_THAT(message_of(read),
               Contains(name + ":7:") && Contains("not a number") && Contains("kIcOpt"));
    // One digit is another motion.
    for (std::size_t at = text.find('\n', text.find("\nrun ") + 1); at < text.rfind("end "); ++at) {
      if (text[at] < '0' || text[at] > '9') continue;
      wrong = text;
      wrong[at] = text[at] == '5' ? '6' : '5';
      write_bytes(folder / name, wrong);
      CAPTURE(name, at);
      REQUIRE_THROWS_AS(read(), InputError);
    }
    wrong = text;
    wrong.replace(wrong.find("\ntime 0.3"), 9, "\ntime 0.4");
    write_bytes(folder / name, wrong);
    CHECK_THAT(message_of(read), Contains("checksum") && Contains("the file is damaged"));
    wrong = text;
    wrong.replace(wrong.find("format 4"), 8, "format 9");
    write_bytes(folder / name, wrong);
    CHECK_THAT(message_of(read), Contains("format 9"));
  }
}

TEST_CASE("restart: state of another layout → error with the component name", "[unit][restart]") {
  const FinalState state = make_state();
  CHECK_NOTHROW(check_layout(state, state.components, "FINAL"));
  CHECK_THAT(message_of([&] {
               check_layout(state, {"element.x[1] [m]", "cage.q[1] [-]"}, "FINAL");
             }),
             Contains("3 components") && Contains("needs 2") && Contains("'element.x[2] [m]'") &&
                 Contains("'cage.q[1] [-]'"));
  auto more = state.components;
  more.push_back("cage.q[2] [-]");
  CHECK_THAT(message_of([&] { check_layout(state, more, "FINAL"); }),
             Contains("nothing more") && Contains("'cage.q[2] [-]'"));
}

TEST_CASE("restart: FINAL without checksum → read", "[unit][restart]") {
  TemporaryFolder folder;
  write_final(make_state(), folder / "FINAL");
  std::string text = read_bytes(folder / "FINAL");
  text.replace(text.find("format 4"), 8, "format 2");
  text.replace(text.rfind("end "), std::string::npos, "end\n");
  write_bytes(folder / "FINAL", text);
  check_equal(read_final(folder / "FINAL"), make_state());
  text.replace(text.find("format 2"), 8, "format 4");
  write_bytes(folder / "FINAL", text);
  CHECK_THAT(message_of([&] { (void)read_final(folder / "FINAL"); }), Contains("checksum"));
}

TEST_CASE("restart: FINAL without deck → read", "[unit][restart]") {
  TemporaryFolder folder;
  FinalState state = make_state();
  write_final(state, folder / "FINAL");
  std::string text = read_bytes(folder / "FINAL");
  text.replace(text.find("format 4"), 8, "format 1");
  text.replace(text.find("deck 2"), std::string::npos, "end\n");
  write_bytes(folder / "FINAL", text);
  state.deck.clear();
  check_equal(read_final(folder / "FINAL"), state);
}

TEST_CASE("restart: state of other bodies → error", "[unit][restart]") {
  FinalState state;
  state.components = {"element.x[1] [m]", "element.x[2] [m]", "element1.rotation [rad]"};
  CHECK_NOTHROW(check_bodies(state, {"element.x[1] [m]", "element.x[2] [m]"}, "FINAL"));
  CHECK_THAT(message_of([&] {
               check_bodies(state, {"element.x[1] [m]", "cage.position[1] [m]"}, "FINAL");
             }),
             Contains("2 rolling elements and no cage") &&
                 Contains("1 rolling elements and a cage") && Contains("kIcOpt = 0"));
}

TEST_CASE("restart: checkpoint in a folder without write permission → reported",
          "[unit][restart]") {
  CHECK_THAT(message_of([&] { write_final(make_state(), "/no/such/folder/FINAL"); }),
             Contains("/no/such/folder/FINAL"));
}

TEST_CASE("averages: equal to those of the motion, for any interval", "[unit][averages]") {
  const bearing::Bearing bearing = make_bearing(4);
  for (const long every : {1L, 10L, 100L}) {
    RunAverages averages;
    for (long step = 0; step <= 2000; step += every) averages.add(make_snapshot(bearing, step));
    const Averages result = averages.averages();
    CHECK(result.time == Approx(0.02));
    CHECK(result.orbital_ratio == Approx(0.4));  // 400 of 1000 rad/s
    CHECK(result.cage_ratio == Approx(0.43));
    CHECK(result.whirl_ratio == Approx(0.45));
    CHECK(result.power_loss == Approx(55.0));
  }
  RunAverages first;
  first.add(make_snapshot(bearing, 0));
  CHECK(first.averages().orbital_ratio == 0.0);
  CHECK(first.averages().power_loss == 55.0);
}

TEST_CASE("averages: continue from MASTER", "[unit][averages]") {
  const bearing::Bearing bearing = make_bearing(4);
  RunAverages whole, part;
  std::map<std::string, double> state;
  for (long step = 0; step <= 3000; step += 100) {
    whole.add(make_snapshot(bearing, step));
    if (step <= 1500) part.add(make_snapshot(bearing, step));
  }
  part.save(state);
  RunAverages continued;
  continued.restore(state);
  for (long step = 1600; step <= 3000; step += 100) continued.add(make_snapshot(bearing, step));
  CHECK(continued.averages().whirl_ratio == whole.averages().whirl_ratio);
  CHECK(continued.averages().swept_whirl_ratio == whole.averages().swept_whirl_ratio);
  CHECK(continued.averages().orbital_ratio == whole.averages().orbital_ratio);
  CHECK(continued.averages().power_loss == whole.averages().power_loss);
  RunAverages fresh;
  fresh.restore({});
  fresh.add(make_snapshot(bearing, 100));
  CHECK(fresh.averages().time == 0.0);
}

TEST_CASE("whirl: followed between snapshots by positions only", "[unit][averages]") {
  const bearing::Bearing bearing = make_bearing(4);
  RunAverages averages;
  for (long step = 0; step <= 20000; step += 100) {
    const scene::Snapshot snapshot = make_snapshot(bearing, step);
    if (step % 10000 == 0)
      averages.add(snapshot);  // 45 rad apart: many turns of the whirl
    else
      averages.add_cage_position(snapshot.time, snapshot.cages[0].position);
  }
  CHECK(averages.averages().whirl_ratio == Approx(0.45));
}

namespace {

/// Both whirls of a center at `path(turns)` [m], followed for `turns` of the shaft (100 rad/s) by
/// `looks` looks.
template <class Path>
Averages whirl_along(const Path& path, double turns, int looks) {
  RunAverages averages;
  scene::Snapshot shaft = make_snapshot(make_bearing(4), 0);
  for (int k = 0; k <= looks; ++k) {
    const double turned = turns * k / looks;
    shaft.shaft_rotation = 2.0 * std::numbers::pi * turned;
    shaft.time = shaft.shaft_rotation / 100.0;
    shaft.cages[0].position = path(turned);
    averages.add(shaft);
  }
  return averages.averages();
}

}  // namespace

TEST_CASE("whirl by the area swept: that of a circle, continuous where a path passes the axis",
          "[unit][averages]") {
  const double pi = std::numbers::pi;
  const auto circle = [&](double ratio) {
    return [=](double turns) {
      const double angle = 2.0 * pi * ratio * turns;
      return scene::Vec3(3e-6, -2e-5 * std::sin(angle), 2e-5 * std::cos(angle));
    };
  };
  for (const double ratio : {0.43, -0.43, 2.0, 0.0}) {
    CAPTURE(ratio);
    const Averages of = whirl_along(circle(ratio), 5.0, 4000);
    CHECK(of.whirl_ratio == Approx(ratio).margin(1e-12));
    CHECK(of.swept_whirl_ratio == Approx(ratio).epsilon(1e-4).margin(1e-12));
    const double phi = 2.0 * pi * ratio * 5.0 / 50.0;  // what few looks take from it
    if (ratio != 0.0 && std::abs(ratio) < 1.0)
      CHECK(whirl_along(circle(ratio), 5.0, 50).swept_whirl_ratio ==
            Approx(ratio * std::sin(phi) / phi).epsilon(1e-12));
  }
  // A circle that touches the axis, three times around, passed by `off` (the axis is a look) inside
  // or outside: three windings or none. With its center c from the axis the swept area is R², the
  // square R² + c².
  const double radius = 2e-5;
  for (const int looks : {300, 3000, 30000}) {
    CAPTURE(looks);
    std::vector<Averages> sides;
    for (const double off : {3e-12, -3e-12})
      sides.push_back(whirl_along(
          [&](double turns) {
            const double angle = 2.0 * pi * 0.4 * turns;
            return scene::Vec3(0.0, -radius * std::sin(angle),
                               radius * std::cos(angle) - radius + off);
          },
          2.5 * 3.0, looks));
    CHECK(std::abs(sides[0].swept_whirl_ratio - sides[1].swept_whirl_ratio) < 1e-6);
    CHECK(std::abs(sides[0].whirl_ratio - sides[1].whirl_ratio) == Approx(0.4).epsilon(1e-3));
    const double phi = 2.0 * pi * 3.0 / looks;
    CHECK(sides[0].swept_whirl_ratio == Approx(0.2 * std::sin(phi) / phi).epsilon(1e-6));
  }
  // Straight through beside the axis: half a turn either way by windings, nothing by area.
  for (const double off : {1e-12, -1e-12}) {
    const Averages of = whirl_along(
        [&](double turns) { return scene::Vec3(0.0, 2e-5 * (turns - 0.5), off); }, 1.0, 1001);
    CHECK(std::abs(of.whirl_ratio) == Approx(0.5).epsilon(1e-4));
    CHECK(std::abs(of.swept_whirl_ratio) < 1e-6);
  }
  CHECK(
      whirl_along([](double) { return scene::Vec3(1e-6, 0.0, 0.0); }, 1.0, 10).swept_whirl_ratio ==
      0.0);
}

TEST_CASE("restart: MASTER with impossible time or scales → error with the name",
          "[unit][restart]") {
  TemporaryFolder folder;
  MasterState master;
  master.last = make_state();
  master.averages = {{"average time", 0.125}};
  write_master(master, folder / "MASTER");
  const std::string good = read_bytes(folder / "MASTER");
  for (const auto& [key, value] :
       std::vector<std::pair<std::string, std::string>>{{"step", "-5"},
                                                        {"step", "9999999999999999999"},
                                                        {"time", "1e300"},
                                                        {"time", "-1"},
                                                        {"time", "nan"},
                                                        {"step_size", "-1e-9"},
                                                        {"step_size", "inf"},
                                                        {"shaft_rotation", "nan"},
                                                        {"scale_length", "0"},
                                                        {"scale_force", "-1"},
                                                        {"scale_time", "inf"},
                                                        {"scale_time", "0"}}) {
    CAPTURE(key, value);
    const std::size_t at = good.find("\n" + key + " ") + 1;
    std::string bad = good;
    bad.replace(at, good.find('\n', at) - at, key + " " + value);
    write_bytes(folder / "MASTER", bad);
    CHECK_THAT(message_of([&] { (void)read_master(folder / "MASTER"); }),
               Contains("MASTER:") && Contains(key) && Contains("the file is damaged"));
  }
  for (const std::string name : {"element.x[1] [m]", "average time"}) {
    std::string bad = good;
    const std::size_t end = good.find(" " + name), begin = good.rfind('\n', end) + 1;
    bad.replace(begin, end - begin, "inf");
    write_bytes(folder / "MASTER", bad);
    CHECK_THAT(message_of([&] { (void)read_master(folder / "MASTER"); }), Contains("not finite"));
  }
}

TEST_CASE("restart: NaN, infinity or a word in MASTER or FINAL → error", "[unit][restart]") {
  TemporaryFolder folder;
  MasterState master;
  master.last = make_state();
  master.averages = {{"average time", 0.125}, {"stepper memory next step", 1e-6}};
  master.files = {{"PRINT", "PRINT.txt", 10, {}}};
  write_master(master, folder / "MASTER");
  write_final(make_state(), folder / "FINAL");
  for (const std::string name : {"FINAL", "MASTER"}) {
    const auto read = [&] {
      name == "FINAL" ? (void)read_final(folder / name) : (void)read_master(folder / name);
    };
    const std::string good = read_bytes(folder / name);
    const std::size_t numbers = good.find("\nstep ") + 1;  // behind the run's own name
    const std::size_t deck = good.find("\ndeck ") + 1;
    const std::size_t behind_deck = good.find("'synthetic'\n") + 12;
    int changed = 0;
    for (std::size_t line = numbers; line < good.size(); line = good.find('\n', line) + 1) {
      if (line > deck && line < behind_deck) continue;
      const std::size_t end = good.find('\n', line);
      // "keyword number" or "number name"
      const std::size_t blank = good.find(' ', line);
      if (blank == std::string::npos || blank > end) continue;  // the last line
      const bool first = good.find_first_of("0123456789", line) == line || good[line] == '-';
      const std::size_t at = first ? line : blank + 1, length = (first ? blank : end) - at;
      for (const std::string value : {"nan", "-nan", "inf", "-inf", "1e999", "x", ""}) {
        std::string bad = good;
        bad.replace(at, length, value);
        CAPTURE(name, good.substr(line, end - line), value);
        write_bytes(folder / name, bad);
        CHECK_THAT(message_of(read), Contains(name + ":") && Contains("the file is damaged"));
        ++changed;
      }
    }
    CHECK(changed >= 7 * 13);
  }
}
