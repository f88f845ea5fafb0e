#include "cli/driver.hpp"
#include "results/restart.hpp"
#include "results/sol_file.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <vector>

using namespace adore;
using namespace adore::test;
using nlohmann::json;

TEST_CASE("every ball example checks clean and runs", "[cli]") {
  const Folder folder;
  for (const std::string type : {"ball", "ball-english", "ball-thrust", "ball-18"}) {
    const std::string deck = (folder / (type + ".txt")).string();
    REQUIRE(run_adore("new " + type + " --out " + deck).code == 0);
    CHECK(run_adore("check " + deck).code == 0);
    const Result run =
        run_adore("run " + deck + " --until 0.02rev --quiet --out " + (folder / type).string());
    INFO(type << "\n" << run.out);
    CHECK(run.code == 0);
  }
  // The same bearing in two unit systems. The decks' own numbers are rounded to 1e-7 or better.
  const auto result = [&](const std::string& type, const char* name) {
    return json::parse(read(folder / type / "RUN.json")).at("summary").at(name).get<double>();
  };
  for (const char* name : {"largest_contact_load_N", "power_loss_W", "mean_orbital_ratio"})
    CHECK(result("ball-english", name) == Approx(result("ball", name)).epsilon(1e-6));
}

TEST_CASE("a short run writes every file, and each can be shown and exported", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const Result run =
      run_adore("run " + folder.path().string() + " --until 0.1rev --progress plain");
  INFO(run.out);
  REQUIRE(run.code == 0);
  for (const char* name : {"PRINT.txt", "FINAL", "MASTER", "SOL1", "SOL2", "SOL3", "SOL4", "SOL7",
                           "SOL8", "RUN.json", "RESULTS.h5"}) {
    INFO(name);
    REQUIRE(fs::exists(folder / name));
    CHECK(fs::file_size(folder / name) > 0);
    if (std::string(name) == "PRINT.txt") continue;
    CHECK(run_adore("show " + (folder / name).string()).code == 0);
    const Result csv = run_adore("convert " + (folder / name).string() + " --to csv");
    CHECK(csv.code == 0);
    const Result exported = run_adore("convert " + (folder / name).string() + " --to json");
    CHECK(json::accept(exported.out));
  }
  const json summary = json::parse(read(folder / "RUN.json"));
  CHECK(summary.at("status") == "done");
  CHECK(summary.at("revolutions").get<double>() == Approx(0.1).epsilon(1e-9));
  const std::string listing = read(folder / "PRINT.txt");
  for (const char* part : {"kBrg", "residual", "stepper", "7208"}) CHECK(contains(listing, part));
  std::size_t longest = 0;
  std::istringstream lines(listing);
  for (std::string line; std::getline(lines, line);) {
    std::size_t columns = 0;
    for (const char c : line) columns += (static_cast<unsigned char>(c) & 0xC0U) != 0x80U ? 1 : 0;
    longest = std::max(longest, columns);
  }
  CHECK(longest <= 132);
}

TEST_CASE("the same deck writes the same bytes, measured times apart", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const auto run_into = [&](const std::string& name, const std::string& environment = "") {
    const Result run = run_adore("run " + folder.path().string() +
                                     " --quiet --until 0.05rev --out " + (folder / name).string(),
                                 environment);
    INFO(run.out);
    REQUIRE(run.code == 0);
  };
  run_into("a");
  run_into("b", "LC_ALL=de_DE.UTF-8 LANG=de_DE.UTF-8");
  for (const char* name : {"SOL1", "SOL2", "SOL3", "SOL4", "SOL7", "SOL8", "FINAL", "RESULTS.h5"}) {
    INFO(name);
    CHECK(read(folder / "a" / name) == read(folder / "b" / name));
  }
  json a = json::parse(read(folder / "a" / "RUN.json")),
       b = json::parse(read(folder / "b" / "RUN.json"));
  a.erase("measured");
  b.erase("measured");
  CHECK(a == b);
}

TEST_CASE("a continued run reaches the state of an unbroken one", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const std::string
      deck = folder.path().string(),
      fixed = " --set stpMin=0.2 --set stpMax=0.2 --set stpInit=0.2 --set intMet=4 --quiet";
  REQUIRE(
      run_adore("run " + deck + fixed + " --set maxStps=20 --out " + (folder / "whole").string())
          .code == 0);
  const std::string parts = (folder / "parts").string();
  REQUIRE(run_adore("run " + deck + fixed + " --set maxStps=10 --out " + parts).code == 0);
  REQUIRE(
      run_adore("run " + deck + fixed + " --set maxStps=10 --set kIcOpt=1 --out " + parts).code ==
      0);
  const auto whole = adore::results::read_final(folder / "whole" / "FINAL");
  const auto joined = adore::results::read_final(folder / "parts" / "FINAL");
  CHECK(joined.step == whole.step);
  REQUIRE(joined.state.size() == whole.state.size());
  double worst = 0.0;
  for (std::size_t i = 0; i < whole.state.size(); ++i)
    worst = std::max(worst, std::abs(joined.state[i] - whole.state[i]) /
                                std::max(1.0, std::abs(whole.state[i])));
  CHECK(worst < 1e-11);  // the same steps; only t = k h is summed in two parts
  CHECK(read(folder / "whole" / "SOL1").size() == read(folder / "parts" / "SOL1").size());

  const Result other =
      run_adore("run " + deck + fixed +
                " --set maxStps=10 --set kIcOpt=1 --set runID=another --out " + parts);
  INFO(other.out);
  CHECK(other.code == 2);
  CHECK(contains(other.out, "another"));
  CHECK(contains(other.out, "7208"));
}

TEST_CASE("continued run: changed loads and speeds → reported; other bearing → rejected", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const std::string deck = folder.path().string();
  const auto run = [&](const std::string& options) {
    return run_adore("run " + deck + " --quiet --set maxStps=20 " + options);
  };
  REQUIRE(run("").code == 0);
  const auto first = adore::results::read_final(folder / "FINAL");
  const std::string listing = read(folder / "PRINT.txt");

  for (const auto& [set, name] :
       {std::pair{"bReDia=0.0126", "bReDia"},
        {"nRe=11 --set kPltElemInd=1,5,12,14", "nRe"},
        {"kRaceMat1=101", "kRaceMat1"},
        {"cageGsCls[2]=2.5e-4", "cageGsCls[2]"},
        {"raceFit2=1e-6", "raceFit2"},
        {"runID=another", "another"},
        {"mode=1", "do not allow this change (mode: 0"},
        {"kDOF=2", "do not allow this change (kDOF: 0"},
        {"kPltElemInd[1]=2", "do not allow this change (kPltElemInd[1]: 1"}}) {
    const Result other = run(std::string("--set kIcOpt=1 --set ") + set);
    INFO(other.out);
    CHECK(other.code == 2);
    CHECK(contains(other.out, name));
    CHECK(contains(other.out, "kIcOpt = -1"));
  }
  CHECK(read(folder / "PRINT.txt") == listing);

  const Result more =
      run("--set kIcOpt=1 --set rpm2=9000 --set appLoadX=1200 --set cageGcPos[1]=1e-5");
  INFO(more.out);
  REQUIRE(more.code == 0);
  CHECK(contains(more.out, "with a changed deck: appLoadX: "));
  CHECK(contains(more.out, "; rpm2: 10000.0 rpm before, 9000.0 rpm now"));
  CHECK(contains(more.out,
                 "have no effect, because the run starts from the stored state: cageGcPos[1]"));
  CHECK(contains(read(folder / "PRINT.txt"), "with a changed deck"));
  CHECK(contains(read(folder / "RUN.json"), "9000.0 rpm now"));
  // The shaft continues from its angle.
  const auto second = adore::results::read_final(folder / "FINAL");
  CHECK(second.step == 40);
  CHECK(second.shaft_rotation - first.shaft_rotation ==
        Approx(9000.0 * std::acos(-1.0) / 30.0 * (second.time - first.time)).epsilon(1e-9));

  const Result same = run("--set kIcOpt=1 --set rpm2=9000 --set appLoadX=1200");
  CHECK(same.code == 0);
  CHECK_FALSE(contains(same.out, "changed deck"));

  const Result fewer = run("--set kIcOpt=-1 --set nRe=11 --set kPltElemInd=1,5,12,14");
  CHECK(fewer.code == 2);
  CHECK(contains(fewer.out, "12 rolling elements and a cage, but this deck has 11"));
  const Result smaller = run("--set kIcOpt=-1 --set cageGsCls[2]=2.5e-4 --set rpm2=9000");
  CHECK(smaller.code == 0);
  CHECK(contains(smaller.out, "starts with a changed deck"));

  // Record 2.3 of the stored deck names the file that holds it.
  for (const char* keeps_files : {"--set kFnOpt=1 --overwrite", "--set kIcOpt=-1 --overwrite"}) {
    const Result stored = run(keeps_files);
    INFO(stored.out);
    CHECK(stored.code == 0);
  }
}

TEST_CASE("run: fatigue lives printed, selected one stored in SOL7", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const std::string deck = folder.path().string();
  const auto sol7_lives = [&](const std::string& name, const std::string& options) {
    const Result run = run_adore("run " + deck + " --quiet --until 0.1rev " + options + " --out " +
                                 (folder / name).string());
    INFO(run.out);
    REQUIRE(run.code == 0);
    std::istringstream csv(
        run_adore("convert " + (folder / name / "SOL7").string() + " --to csv").out);
    std::string line;
    std::getline(csv, line);
    std::size_t column = 0;
    std::istringstream titles(line);
    std::string title;
    while (std::getline(titles, title, ',') && !contains(title, "life")) ++column;
    std::vector<double> out;
    while (std::getline(csv, line)) {
      std::istringstream cells(line);
      std::string cell;
      for (std::size_t k = 0; k <= column; ++k) std::getline(cells, cell, ',');
      out.push_back(std::stod(cell));
    }
    REQUIRE(out.size() > 3);
    return out;
  };
  const std::vector<double> stored = sol7_lives("default", "");
  for (const double life : stored) {
    CHECK(life > 1.0);
    CHECK(life < 1e9);
  }
  const json run = json::parse(read(folder / "default" / "RUN.json"));
  const json& models = run.at("life").at("quasi-static").at("lives");
  // The run starts from the statics that the page shows, in balance of friction (decisions 817,
  // 860): its first life is 0.05 % below that of the statics (measured; 9 % by the spin rule).
  const auto page = [&](const char* model, const char* factors) {
    return models.at(model).at(factors).at("L10 [hr]").get<double>();
  };
  // Races only, of the original theory: no formula of spin in between.
  const double original = page("Original Lundberg-Palmgren", "basic");
  CHECK(stored.front() == Approx(original).epsilon(0.005));
  CHECK(run.at("life").at("run").at("life [hr]").get<double>() == Approx(original).epsilon(0.2));
  CHECK(run.at("summary").at("life_lp_hours").get<double>() == Approx(original).epsilon(1e-12));
  CHECK_FALSE(run.at("summary").contains("life_gz_stle_hours"));
  CHECK(run.at("life").at("run").at("window [rev]").get<double>() == Approx(0.1).epsilon(1e-6));
  const std::string listing = read(folder / "default" / "PRINT.txt");
  for (const char* part :
       {"FATIGUE LIFE", "CALIBRATED", "Fatigue life of the run", "no lubricant film is computed",
        "Fatigue life at the current loads", "Life model in SOL7, terminal and sweeps (sol7Life)"})
    CHECK(contains(listing, part));
  CHECK_FALSE(contains(listing, "no life model is active"));

  // Of the first and the last step only: held in between, whether plots store the last step anyway
  // or not.
  for (const char* stored_every : {"kPltFreq=1", "kPltFreq=7"}) {
    const std::vector<double> ends =
        sol7_lives(stored_every, std::string("--set kLifeFreq=0 --set ") + stored_every);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) CHECK(ends[i] == ends.front());
    CHECK(ends.front() == stored.front());
    CHECK(ends.back() == Approx(stored.back()).epsilon(1e-7));
    CHECK(ends.back() != Approx(ends.front()).epsilon(1e-7));
  }

  // A model of the program only when chosen; elements at their actual spin, not the formula's.
  const double chosen = page("Gupta-Zaretsky type", "STLE");
  CHECK(sol7_lives("gz", "--opt sol7Life=gz-stle").front() == Approx(chosen).epsilon(0.02));
  const json other = json::parse(read(folder / "gz" / "RUN.json"));
  CHECK(other.at("summary").at("life_lp_hours").get<double>() == Approx(original).epsilon(1e-12));
  CHECK(other.at("summary").at("life_gz_stle_hours").get<double>() ==
        Approx(chosen).epsilon(1e-12));
  // Every contact under the limit.
  for (const double life : sol7_lives(
           "light", "--opt sol7Life=ih --set appLoadX=60.0 --set appLoadZ=0.0 --set rpm2=500.0"))
    CHECK(life == Approx(9.9999999e30).epsilon(1e-6));
  CHECK(contains(read(folder / "light" / "PRINT.txt"), "INFINITE"));
  CHECK(contains(run_adore("run " + deck + " --opt sol7Life=no").out, "gz"));
}

TEST_CASE("lightly loaded elements are held, booked and continued as in an unbroken run", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const std::string deck = folder.path().string(),
                    light = " --set appLoadX=200 --set appLoadZ=2000 --set qFac=0.1",
                    fixed = light +
                            " --set stpMin=0.2 --set stpMax=0.2 --set stpInit=0.2 --set intMet=4 "
                            "--set nStps=5 --quiet";
  const Result plan = run_adore("plan " + deck + light + " --json");
  REQUIRE(plan.code == 0);
  CHECK(contains(plan.out, "light-load balance"));
  CHECK(contains(plan.out, "qFac = 0.1"));

  const std::string whole = (folder / "whole").string(), parts = (folder / "parts").string();
  REQUIRE(run_adore("run " + deck + fixed + " --set maxStps=400 --out " + whole).code == 0);
  const json run = json::parse(read(folder / "whole" / "RUN.json"));
  CHECK(run.at("counters").at("changes of held elements").get<int>() >= 3);
  const json& energy = run.at("conservation").at("energy");
  CHECK(energy.contains("switches of held elements [J]"));
  CHECK(std::abs(energy.at("residual over energy moved").get<double>()) < 1e-5);
  const json& momentum = run.at("conservation").at("momentum");
  CHECK(std::abs(momentum.at("linear residual over momentum carried").get<double>()) < 1e-9);
  CHECK(std::abs(momentum.at("angular residual over momentum carried").get<double>()) < 1e-9);
  const std::string print = read(folder / "whole" / "PRINT.txt");
  CHECK(contains(print, "Quasi-static elements"));
  CHECK(contains(print, "residual of angular momentum, z"));

  // Broken in the middle, while balls are held and between two changes.
  REQUIRE(run_adore("run " + deck + fixed + " --set maxStps=230 --out " + parts).code == 0);
  REQUIRE(
      run_adore("run " + deck + fixed + " --set maxStps=170 --set kIcOpt=1 --out " + parts).code ==
      0);
  const auto one = adore::results::read_final(folder / "whole" / "FINAL");
  const auto two = adore::results::read_final(folder / "parts" / "FINAL");
  REQUIRE(one.components == two.components);
  CHECK(one.step == two.step);
  double held = 0.0, worst = 0.0;
  for (std::size_t i = 0; i < one.state.size(); ++i) {
    worst = std::max(worst,
                     std::abs(one.state[i] - two.state[i]) / std::max(1.0, std::abs(one.state[i])));
    if (one.components[i].rfind("held.element", 0) == 0) held += one.state[i];
  }
  CHECK(held >= 3.0);
  CHECK(worst < 1e-9);  // the same steps; only t = k h is summed in two parts

  // qFac = 0 is another state: rejected by name in a continuation.
  const Result other = run_adore("run " + deck + fixed +
                                 " --set qFac=0 --set maxStps=5 --set kIcOpt=1 --out " + parts);
  CHECK(other.code == 2);
  CHECK(contains(other.out, "qFac"));
}

TEST_CASE("integrator: steps too long for contact vibrations → reported, limited or rejected",
          "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const std::string deck = folder.path().string();
  const auto run = [&](const std::string& method) {
    return run_adore("run " + deck + " --until 0.02rev --quiet --integrator " + method + " --out " +
                     (folder / method).string());
  };
  const Result refused = run("rkf1");
  INFO(refused.out);
  CHECK(refused.code == 2);
  CHECK(contains(refused.out,
                 "rkf1 cannot be used for this deck. Integrators that allow these steps"));
  CHECK_FALSE(fs::exists(folder / "rkf1" / "SOL1"));

  const Result held = run("pece4");
  INFO(held.out);
  CHECK(held.code == 0);
  CHECK(contains(held.out, "pece4 with steps of up to"));
  CHECK(contains(held.out, "The run uses steps of up to"));
  const json summary = json::parse(read(folder / "pece4" / "RUN.json"));
  CHECK(contains(summary.at("plan").at("stability").get<std::string>(), "pece4"));
  CHECK(contains(read(folder / "pece4" / "PRINT.txt"), "The run uses steps of up to"));

  CHECK(run("rkf5").code == 0);
  const json kept = json::parse(read(folder / "rkf5" / "RUN.json"));
  CHECK(contains(kept.at("plan").at("stability").get<std::string>(), "keeps contact vibrations"));
  const Result plan = run_adore("plan " + deck + " --set intMet=4");
  CHECK(contains(plan.out, "The run uses steps of up to"));
}

TEST_CASE("the plan promises the steps that a run with a step cap takes", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const std::string deck = folder.path().string();
  for (const std::string code : {"5", "21", "31"}) {  // rkf5, cvode-adams, arkode-erk
    const std::string set = " --set intMet=" + code + " --set tol=1e-4";
    const json plan =
        json::parse(run_adore("plan " + deck + set + " --json 2> /dev/null | cat").out);
    const double promised = plan.at("estimates").at("steps_per_revolution").get<double>();
    REQUIRE(
        run_adore("run " + deck + set + " --until 0.1rev --quiet --out " + (folder / code).string())
            .code == 0);
    const json run = json::parse(read(folder / code / "RUN.json"));
    INFO("intMet " << code);
    CHECK(run.at("counters").at("steps").get<double>() == Approx(0.1 * promised).epsilon(0.15));
  }
}

TEST_CASE("run without an energy balance → exit code not 0", "[cli][slow]") {
  const Folder folder;
  new_ball_deck(folder);
  // One ball between fixed races is squeezed out of its groove.
  const Result run =
      run_adore("run " + folder.path().string() +
                " --set nRe=1 --set kPltElemInd=1,2,3,4 --until 0.797rev --quiet --out " +
                (folder / "one").string());
  INFO(run.out);
  CHECK(run.code == 3);
  // The contact grows beyond what Hertz allows before the energy is judged at the end.
  CHECK(json::parse(read(folder / "one" / "RUN.json")).at("status") == "failed");
}

TEST_CASE("cage overlapping elements or lands at the start → rejected with the overlap", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const std::string deck = folder.path().string();
  for (const std::string place : {"--set cageAngPos[1]=5", "--set cageGcPos[3]=-0.001"}) {
    const Result run = run_adore("run " + deck + " " + place + " --until 0.01rev --quiet --out " +
                                 (folder / "out").string());
    INFO(run.out);
    CHECK(run.code == 2);
    CHECK(contains(run.out, "the cage overlaps other bodies"));
    CHECK(contains(run.out, "record 9.6"));
    CHECK_FALSE(fs::exists(folder / "out" / "PRINT.txt"));
  }
}

TEST_CASE("actual mean load → reported next to the specified load", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const Result run = run_adore("run " + folder.path().string() + " --until 0.1rev --quiet");
  INFO(run.out);
  REQUIRE(run.code == 0);
  const json load = json::parse(read(folder / "RUN.json")).at("load carried by the elements");
  CHECK(load.at("asked x [N]") == 1500.0);
  // Friction equilibrium at the start (decision 860); with the spin rule 1450 N (measured).
  CHECK(load.at("mean x [N]").get<double>() == Approx(1500.0).epsilon(0.005));
  CHECK(contains(read(folder / "PRINT.txt"), "difference from the specified load"));
  // A light load at high speed: carried by the bodies' inertia rather than by the contacts'
  // closing (13 %).
  const Result light = run_adore("run " + folder.path().string() +
                                 " --set appLoadX=30 --set appLoadZ=3 --set rpm2=20000"
                                 " --until 0.1rev --quiet --out " +
                                 (folder / "light").string());
  INFO(light.out);
  CHECK(contains(light.out, "% difference"));
}

TEST_CASE("run ended by maxStps before fTime → reported; plan names the limit", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const std::string deck = folder.path().string();
  const auto out = [&](const std::string& name) { return " --out " + (folder / name).string(); };
  const Result cut = run_adore("run " + deck + " --set maxStps=20" + out("cut"));
  INFO(cut.out);
  CHECK(cut.code == 0);
  CHECK(contains(cut.out, "the run stopped after maxStps steps, before its end time t = "));
  const Result whole = run_adore("run " + deck + " --set fTime=20.0" + out("whole"));
  CHECK(whole.code == 0);
  CHECK_FALSE(contains(whole.out, "stopped after maxStps"));
  const Result asked = run_adore("run " + deck + " --until 0.02rev" + out("asked"));
  CHECK_FALSE(contains(asked.out, "stopped after maxStps"));
  CHECK(contains(run_adore("plan " + deck).out, "revolutions, limited by fTime"));
  CHECK(contains(run_adore("plan " + deck + " --set maxStps=20").out,
                 "revolutions, limited by maxStps"));
}
