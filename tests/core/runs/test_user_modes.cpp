#include "core/runs/user_runs.hpp"

#include <cmath>
#include <numbers>
#include <sstream>

/// Routines ADRX1, ADRX2, ADRX5 and ADRX9 in all modes of motion.
using namespace adore;
using namespace adore::user_runs;

namespace {

runs::RunRequest with_formulas(const std::string& name, const std::string& deck,
                               const std::string& until, const std::string& json) {
  auto out = request_of(name, deck, until);
  out.user = json_file(name, json);
  return out;
}

/// Lines of numbers of a text file.
std::vector<std::vector<double>> rows_of(const fs::path& file) {
  std::vector<std::vector<double>> out;
  std::istringstream text(text_of(file));
  for (std::string line; std::getline(text, line);) {
    std::istringstream words(line);
    std::vector<double> row;
    for (double one = 0.0; words >> one;) row.push_back(one);
    if (words.eof() && row.size() > 1) out.push_back(std::move(row));
  }
  return out;
}

const Sets kMode2{{"mode", "2"}, {"kDCR", "0"}};

}  // namespace

TEST_CASE("ADRX1, mode 2: a load of the routine acts on the balance as the deck's load does",
          "[user][physics]") {
  const std::string until = "4e-4s";
  auto more = kMode2;
  more.emplace_back("appLoadZ", "1500");
  const Ran of_deck = ran_with(request_of("balance-deck", deck_with(more, ""), until));
  auto less = kMode2;
  less.emplace_back("appLoadZ", "1000");
  const Ran without = ran_with(request_of("balance-without", deck_with(less, ""), until));
  const Ran of_user =
      ran_with(with_formulas("balance-user", deck_with(less, ""), until,
                             R"~({"adrx1": {"inner_race": {"force": ["0", "0", "500"]}}})~"));
  REQUIRE(of_user.outcome.status == runs::RunStatus::Done);
  const char* const z = "inner race.centre[3] [m]";
  const double acts = of_deck.last.at(z) - without.last.at(z);
  CHECK(std::abs(acts) > 1e-7);
  // Balls at rest in another equilibrium have other speeds for a while.
  CHECK(std::abs(of_user.last.at(z) - of_deck.last.at(z)) < 0.03 * std::abs(acts));
}

TEST_CASE("ADRX1, mode 2: the race follows a load that varies", "[user][physics]") {
  const double end = 6e-4;
  auto request = with_formulas("balance-varies", deck_with(kMode2, ""), fmt::format("{}s", end),
                               R"~({"adrx1": {"inner_race": {"force":
                               ["0", "0", "100*sin(2*pi*2000*t)"]}, "longest_step": "1e-5"},
                               "adrx9": {"channels": ["contact.load[1]", "race.applied_force_z[2]"]}
                               })~");
  const Ran ran = ran_with(request);
  REQUIRE(ran.outcome.status == runs::RunStatus::Done);
  const double load = runs::prepare(request).bearing.constraints.load[2];
  double worst = 0.0;
  for (const auto& row : rows_of(ran.folder / "SOL9"))
    if (row[0] > 2e-4)
      worst = std::max(worst, std::abs(row[2] - load -
                                       100.0 * std::sin(2.0 * std::numbers::pi * 2000.0 * row[0])));
  CHECK(worst < 5.0);  // 2.7 N measured, of 100 N
}

TEST_CASE("ADRX1, held race: the load enters reaction and ledger and moves nothing",
          "[user][physics]") {
  const double F = 250.0, M = 0.3, end = 2e-4;
  for (const char* mode : {"0", "1"}) {
    CAPTURE(mode);
    const Sets sets{{"mode", mode}, {"kDCR", "0"}};
    const std::string out = R"~("adrx9": {"channels": ["race.applied_force_z[2]",
        "race.applied_moment_x[2]"]})~";
    const Ran plain = ran_with(with_formulas(std::string("held-plain-") + mode, deck_with(sets, ""),
                                             fmt::format("{}s", end), "{" + out + "}"));
    auto request = with_formulas(
        std::string("held-load-") + mode, deck_with(sets, ""), fmt::format("{}s", end),
        fmt::format(R"~({{"adrx1": {{"inner_race": {{"force": ["0", "0", "{}"], "moment": "{}"}}}},
                    {}}})~",
                    F, M, out));
    const Ran ran = ran_with(request);
    REQUIRE(ran.outcome.status == runs::RunStatus::Done);
    for (const auto& [name, value] : plain.last)
      if (name.find("[J]") == std::string::npos && name.find("impulse") == std::string::npos) {
        CAPTURE(name);
        CHECK(value == ran.last.at(name));
      }
    const auto a = rows_of(plain.folder / "SOL9"), b = rows_of(ran.folder / "SOL9");
    REQUIRE(a.size() == b.size());
    REQUIRE(a.size() > 3);
    for (std::size_t k = 0; k < a.size(); ++k) {
      CHECK(b[k][1] - a[k][1] == Approx(-F).epsilon(1e-9));
      CHECK(b[k][2] - a[k][2] == Approx(-M).epsilon(1e-9));
    }
    double work = 0.0;
    const auto ledger = ran.last.find("user loads.work [J]");
    REQUIRE(ledger != ran.last.end());
    work = ledger->second;
    CHECK(work == Approx(M * runs::prepare(request).bearing.speed[1] * end).epsilon(1e-9));
    CHECK(std::abs(ran.outcome.energy_residual) <=
          1.001 * std::abs(plain.outcome.energy_residual) + 1e-9);
    std::string warned;
    for (const Issue& issue : runs::prepare(request).input.warnings) warned += issue.text();
    CHECK_THAT(warned, Catch::Contains("does not move the race") && Catch::Contains("mode to 2"));
  }
}

TEST_CASE("ADRX1 drives races in modes 0, 1 and 2: speed and turn of the closed form",
          "[user][physics]") {
  const double a = 1e6, end = 2e-4;
  for (const char* mode : {"0", "1", "2"}) {
    CAPTURE(mode);
    const Sets sets{{"mode", mode}, {"kDCR", "0"}};
    auto request =
        with_formulas(std::string("drive-") + mode, deck_with(sets, ""), fmt::format("{}s", end),
                      fmt::format(R"~({{"adrx1": {{"inner_race": {{"angular_acceleration": "{}"}},
            "outer_race": {{"acceleration": ["0", "0", "-2e-6*w^2*sin(w*t)"],
                            "start_velocity": ["0", "0", "2e-6*w"]}},
            "constants": {{"w": "2*pi*2000"}}, "longest_step": "1e-5"}},
            "adrx9": {{"channels": ["race.angular_velocity[2]", "race.rotation[2]", "race.z[1]"]}}
            }})~",
                                  a));
    const Ran ran = ran_with(request);
    REQUIRE(ran.outcome.status == runs::RunStatus::Done);
    const double first = runs::prepare(request).bearing.speed[1];
    const auto rows = rows_of(ran.folder / "SOL9");
    REQUIRE(rows.size() > 3);
    for (const auto& row : rows) {
      const double t = row[0];
      CHECK(row[1] == Approx(first + a * t).epsilon(1e-9));
      CHECK(row[2] == Approx(first * t + 0.5 * a * t * t).epsilon(1e-6).margin(1e-9));
      CHECK(row[3] == Approx(2e-6 * std::sin(2.0 * std::numbers::pi * 2000.0 * t)).margin(2e-11));
    }
    CHECK(std::abs(ran.outcome.energy_residual) < 2e-3 * ran.outcome.energy_scale);
  }
  const auto problem = [&](const std::string& race) {
    auto request = with_formulas("drive-wrong", deck_with(kMode2, ""), "1e-5s",
                                 R"~({"adrx1": {"inner_race": )~" + race + "}}");
    try {
      return runs::run(request).message;
    } catch (const std::exception& error) {
      return std::string(error.what());
    }
  };
  CHECK_THAT(problem(R"({"acceleration": ["0", "0", "5"]})"), Catch::Contains("along z"));
  CHECK_THAT(problem(R"({"angular_acceleration": ["0", "5", "0"]})"), Catch::Contains("tilts"));
}

TEST_CASE("ADRX1: a frame that turns at w is races that turn faster by w", "[user][physics]") {
  // Of revolution about x: in a frame at w with races at (0, n) all is as at rest with (w, n + w),
  // but for the growth of the rings with their speed (3.7 % of the change measured).
  const double w = 400.0, rpm = w * 30.0 / std::numbers::pi;
  const auto load = [&](const char* outer, const std::string& speeds, const std::string& routine) {
    Sets sets{{"mode", "1"},        {"kFS1", "1"},        {"kFS2", "1"},
              {"kFS3", "1"},        {"appDispX", "2e-5"}, {"gravityVecX", "0"},
              {"gravityVecY", "0"}, {"gravityVecZ", "0"}, {"rpm1", outer},
              {"rpm2", speeds}};
    const Ran ran =
        ran_with(with_formulas("frame", deck_with(sets, ""), "2e-4s",
                               "{" + routine + R"~("adrx9": {"channels": ["contact.load[1]"]}})~"));
    REQUIRE(ran.outcome.status == runs::RunStatus::Done);
    CHECK(std::abs(ran.outcome.energy_residual) < 1e-3 * ran.outcome.energy_scale);
    return rows_of(ran.folder / "SOL9").back()[1];
  };
  const double in_frame =
      load("0", "10000", fmt::format(R"~("adrx1": {{"frame_omega": "{:.17g}"}}, )~", w));
  const double faster =
      load(fmt::format("{:.17g}", rpm).c_str(), fmt::format("{:.17g}", 10000.0 + rpm), "");
  const double still = load("0", "10000", "");
  CHECK(std::abs(faster - still) > 1e-2 * still);
  CHECK(std::abs(in_frame - faster) < 0.05 * std::abs(faster - still));
}

TEST_CASE("ADRX2 acts on rollers in balance: twice the force needs 2^(-2/3) of the overlap",
          "[user][physics]") {
  const Sets kCases[] = {{{"mode", "1"}}, {{"mode", "2"}}, {{"mode", "0"}, {"qFac", "10"}}};
  for (const Sets& sets : kCases) {
    CAPTURE(sets.front().second);
    const auto flange = [&](const char* law) {
      auto request = request_of("flange", deck_of("tapered", sets, ""), "3e-4s");
      request.user =
          json_file("flange", fmt::format(R"~({{"adrx2": {{"force": "{}"}}, "adrx9": {{"channels":
                    ["flange.force[3]", "flange.gap[3]"]}}}})~",
                                          law));
      const Ran ran = ran_with(request);
      REQUIRE(ran.outcome.status == runs::RunStatus::Done);
      return rows_of(ran.folder / "SOL9").back();
    };
    const auto built_in = flange("built_in"), twice = flange("2*built_in");
    REQUIRE(built_in[1] > 1.0);
    CHECK(twice[1] == Approx(built_in[1]).epsilon(0.02));
    CHECK(twice[2] / built_in[2] == Approx(std::pow(2.0, -2.0 / 3.0)).epsilon(0.02));
  }
}

TEST_CASE("ADRX9: heat of pockets, lands and flanges is at its place and adds up to the loss",
          "[user][physics]") {
  for (const char* type : {"ball", "cylindrical", "tapered"}) {
    CAPTURE(type);
    auto request =
        with_formulas(std::string("heat-") + type, deck_of(type, {{"gravityVecZ", "-3000"}}, ""),
                      "0.05rev", R"~({"adrx9": {"heat_map": true}})~");
    const Ran ran = ran_with(request);
    REQUIRE(ran.outcome.status == runs::RunStatus::Done);
    const bearing::Bearing bearing = runs::prepare(request).bearing;
    const double R = 0.5 * bearing.element_diameter(), pitch = 0.5 * bearing.pitch_diameter();
    int pockets = 0, lands = 0, flanges = 0;
    for (const auto& row : rows_of(ran.folder / "SOL9")) {
      const int kind = static_cast<int>(row[1]);
      const double radius = std::hypot(row[5], row[6]);
      if (kind == -1) CHECK(radius == 0.0);
      if (kind == 1) {
        ++pockets;
        CHECK(radius == Approx(pitch).margin(1.1 * R));
      }
      if (kind == 2) {
        ++lands;
        CHECK(radius == Approx(0.5 * bearing.cage->lands.front().diameter).epsilon(0.02));
      }
      if (kind == 3) {
        ++flanges;
        CHECK(radius == Approx(pitch).margin(1.2 * R));
        CHECK(std::abs(row[4]) > 0.3 * bearing.rollers()->length);
      }
    }
    CHECK(pockets > 0);
    if (std::string(type) == "tapered") CHECK(flanges > 0);
  }
}

TEST_CASE("ADRX5: out-of-round elements: equilibrium and motion at t = 0 have equal loads",
          "[user][physics]") {
  const auto loads = [](const char* type, const std::string& radius, bool motion) {
    auto request =
        with_formulas("round-start", deck_of(type, {{"mode", motion ? "0" : "-1"}}, ""), "1e-6s",
                      R"~({"adrx5": {"radius": "i == 0 ? )~" + radius + R"~( : 0"}})~");
    request.options.emplace_back("rollerFriction", "none");  // or the cage turns them a little
    request.options.emplace_back("contactDamping", "0");     // surfaces move past the contacts
    const runs::Prepared ready = runs::prepare(request);
    std::vector<double> out;
    if (!motion) {
      if (ready.rollers)
        for (const auto& one : ready.rollers->rollers) out.push_back(one.race[1].load);
      else
        for (const auto& one : ready.statics.balls) out.push_back(one.Q[1]);
      return out;
    }
    dynamics::System system = runs::make_system(ready);
    const std::vector<double> y = system.initial_state();
    system.set_start(0.0, y);
    for (const auto& one : system.snapshot(0.0, y).elements) out.push_back(one.race[1].load);
    return out;
  };
  struct Shape {
    const char *type, *law, *as;  ///< the same load as round elements of this radius
  };
  // On balls lobes that vanish at the poles.
  for (const Shape& one : {Shape{"cylindrical", "1e-6*cos(2*psi)", "1e-6"},
                           {"cylindrical", "1e-6*cos(psi)", "0"},
                           {"cylindrical", "1e-6*cos(2*psi+0.7)", ""},
                           {"tapered", "1e-6*cos(2*psi)", "1e-6"},
                           {"tapered", "1e-6*cos(4*psi+0.7)", ""},
                           {"ball", "1e-6*(1-(x/0.00635)^2)*cos(2*psi)", ""},
                           {"ball", "1e-6*(1-(x/0.00635)^2)*cos(psi)", "0"}}) {
    CAPTURE(one.type, one.law);
    const std::vector<double> still = loads(one.type, one.law, false),
                              start = loads(one.type, one.law, true),
                              round = loads(one.type, *one.as == '\0' ? "0" : one.as, false),
                              ideal = loads(one.type, "0", false);
    const double largest = *std::max_element(ideal.begin(), ideal.end());
    const bool ball = std::string(one.type) == "ball";
    double acts = 0.0;
    for (std::size_t k = 0; k < ideal.size(); ++k) {
      CHECK(start[k] == Approx(still[k]).margin((ball ? 3e-3 : 2e-4) * largest));
      if (*one.as != '\0')
        CHECK(still[k] == Approx(round[k]).margin((ball ? 0.01 : 1e-3) * largest));
      acts = std::max(acts, std::abs(still[k] - ideal[k]));
    }
    if (std::string(one.as) != "0") CHECK(acts > 0.01 * largest);
  }
}

TEST_CASE("ADRX6: table on the race of rollers: equilibrium and motion at t = 0 have equal loads",
          "[user][physics]") {
  // Off the load's direction the inner race is displaced along its surface: with 25 waves loads of
  // light rollers change by up to 5 % there.
  for (const char* across : {"1+0.001*abs(x)", "1+20*abs(x)"}) {
    CAPTURE(across);
    auto request =
        with_formulas("table-start", deck_of("cylindrical", {{"kRaceGeoImp2", "3"}}, ""), "1e-6s",
                      R"~({"adrx6": {"inner_race": {"radius": "4e-6*sin(25*psi)*()~" +
                          std::string(across) + R"~()"}}})~");
    request.options.emplace_back("contactDamping", "0");  // surfaces move past the contacts
    runs::Prepared ready = runs::prepare(request);
    REQUIRE(ready.rollers.has_value());
    dynamics::System system = runs::make_system(ready);
    const std::vector<double> y = system.initial_state();
    system.set_start(0.0, y);
    const scene::Snapshot s = system.snapshot(0.0, y);
    double largest = 0.0;
    int loaded = 0;
    for (std::size_t i = 0; i < s.elements.size(); ++i) {
      const double load = ready.rollers->rollers[i].race[1].load;
      largest = std::max(largest, load);
      if (!(load > 50.0)) continue;
      ++loaded;
      CHECK(s.elements[i].race[1].load == Approx(load).epsilon(1e-3));
    }
    CHECK(loaded >= 5);
    CHECK(largest > 1500.0);
  }
}

TEST_CASE("ADRX5: two lobes of a roller: loads follow its turn, energy is conserved",
          "[user][physics]") {
  // Race held: the load is that of a roller whose radius is 1e-6 m cos 2(turn - orbit) larger.
  for (const char* mode : {"0", "1"}) {
    CAPTURE(mode);
    const auto ran = [&](const std::string& radius) {
      auto request = with_formulas(
          "lobes",
          deck_of("cylindrical",
                  {{"mode", mode}, {"kFS2", "1"}, {"kFS3", "1"}, {"appDispZ", "1.5e-5"}}, ""),
          "1.2e-3s",
          R"~({"adrx5": {"radius": ")~" + radius + R"~("}, "adrx9": {"channels": ["contact.load[1]",
              "element.rotation[1]", "element.orbital_position[1]"]}})~");
      request.options.emplace_back("contactDamping", "0");
      return ran_with(request);
    };
    const Ran lobes = ran("1e-6*cos(2*psi)");
    REQUIRE(lobes.outcome.status == runs::RunStatus::Done);
    CHECK(std::abs(lobes.outcome.energy_residual) < 1e-5 * lobes.outcome.energy_scale);
    if (mode[0] == '0') continue;
    const auto with = rows_of(lobes.folder / "SOL9"), more = rows_of(ran("1e-6").folder / "SOL9"),
               less = rows_of(ran("-1e-6").folder / "SOL9");
    for (std::size_t k = 5; k < with.size(); ++k) {
      const auto at = [&](const std::vector<std::vector<double>>& rows) {
        double best = 1e9, load = 0.0;
        for (const auto& row : rows)
          if (std::abs(row[0] - with[k][0]) < best) {
            best = std::abs(row[0] - with[k][0]);
            load = row[1];
          }
        return load;
      };
      const double mean = 0.5 * (at(more) + at(less)), half = 0.5 * (at(more) - at(less));
      CHECK((with[k][1] - mean) / half ==
            Approx(std::cos(2.0 * (with[k][2] - with[k][3]))).margin(0.1));
    }
  }
}
