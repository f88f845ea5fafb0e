#include "cli/driver.hpp"
#include "deck/deck.hpp"
#include "deck/reader.hpp"
#include "results/key_results.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <locale>
#include <map>

using namespace adore;
using namespace adore::test;
using nlohmann::json;

TEST_CASE("a quasi-static deck writes one page and the equilibrium carries the load", "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const Result run = run_adore("run " + folder.path().string() + " --set mode=-1");
  INFO(run.out);
  REQUIRE(run.code == 0);
  const json summary = json::parse(read(folder / "RUN.json"));
  CHECK(summary.at("summary").at("load_x_N").get<double>() == Approx(1500.0).epsilon(1e-9));
  CHECK(summary.at("summary").at("load_z_N").get<double>() == Approx(500.0).epsilon(1e-9));
  CHECK_FALSE(fs::exists(folder / "SOL1"));
}

TEST_CASE("a quasi-static deck of each roller type writes one page and carries its load", "[cli]") {
  for (const std::string type : {"cylindrical", "spherical", "tapered", "spherical-tapered"}) {
    const Folder folder;
    const std::string deck = (folder / "DATA.txt").string();
    REQUIRE(run_adore("new " + type + " --out " + deck).code == 0);
    const Result run = run_adore("run " + folder.path().string() + " --quiet --set mode=-1");
    INFO(type << "\n" << run.out);
    REQUIRE(run.code == 0);
    const std::string print = read(folder / "PRINT.txt");
    for (const char* part : {"QUASI-STATIC EQUILIBRIUM", "Contacts with the outer race",
                             "Slices of the most loaded rollers", "Roller length"})
      CHECK(contains(print, part));
    CHECK_FALSE(contains(print, "nan"));
    const json summary = json::parse(read(folder / "RUN.json")).at("summary");
    CHECK(summary.at("load_z_N").get<double>() == Approx(5000.0).epsilon(1e-9));
    CHECK(summary.at("largest_pressure_Pa").get<double>() > 5e8);
  }
}

TEST_CASE("roller decks in SI and in English units give the same results", "[cli]") {
  using namespace adore::deck;
  for (const std::string type : {"cylindrical", "spherical", "tapered", "spherical-tapered",
                                 "angular-218", "tapered-30208", "spherical-22210"}) {
    const Folder folder;
    const fs::path path = folder / "SI.txt";
    REQUIRE(run_adore("new " + type + " --out " + path.string()).code == 0);
    Deck si = read_deck(path).deck;
    si.set("mode", "-1");
    si.complete();
    Deck english = si;
    english.set("kUnit", "2");
    for (const RecordSpec& record : schema())
      for (const VariableSpec& variable : record.variables) {
        if (variable.type != VarType::Real) continue;
        for (int i = 1; si.has_record(record.id, i); ++i) {
          const std::string name = record.repeat.empty() ? std::string(variable.name)
                                                         : fmt::format("{}[{}]", variable.name, i);
          const double value = si.si(variable.name, i) / variable.unit.en_factor;
          if (variable.length == "1") english.set(name, fmt::format("{}", value));
        }
      }
    write_deck(si, folder / "SI.txt");
    write_deck(english, folder / "EN.txt");
    // Friction equilibria of rollers have derivatives by differences, which amplify rounding.
    for (const auto& [options, accuracy] :
         {std::pair{std::string(" --opt rollerFriction=none"), 1e-10}, {std::string(), 1e-6}}) {
      std::array<json, 2> result;
      for (const std::size_t k : {0U, 1U}) {
        const fs::path out = folder / (k == 0 ? "si" : "en");
        const Result run = run_adore("run " + (folder / (k == 0 ? "SI.txt" : "EN.txt")).string() +
                                     " --quiet --overwrite --out " + out.string() + options);
        INFO(type << "\n" << run.out);
        REQUIRE(run.code == 0);
        result[k] = json::parse(read(out / "RUN.json")).at("summary");
      }
      // A result that is small compared with others of its unit (a load from rounding, a tilt) has
      // the accuracy of the largest of them.
      std::map<std::string, double> scale;
      const auto unit_of = [](const std::string& key) {
        return std::string(results::find_key_result(key).unit->si);
      };
      for (const auto& [key, value] : result[0].items())
        if (value.is_number()) {
          double& largest = scale[unit_of(key)];
          largest = std::max(largest, std::abs(value.get<double>()));
        }
      scale["N.m"] = std::max(scale["N.m"], 0.01 * scale["N"]);  // loads times a centimeter
      int compared = 0;
      for (const auto& [key, value] : result[0].items()) {
        if (!value.is_number() || result[1].at(key).is_null()) continue;
        CAPTURE(type, key, options);
        CHECK(result[1].at(key).get<double>() ==
              Approx(value.get<double>()).epsilon(accuracy).margin(accuracy * scale[unit_of(key)]));
        ++compared;
      }
      CHECK(compared > 15);
    }
  }
}

TEST_CASE("the quasi-static example decks run, with tables for plots, lives and stiffness",
          "[cli]") {
  const Folder folder;
  for (const std::string name : {"angular-218", "deep-groove-6205", "cylindrical-nu209",
                                 "tapered-30208", "spherical-22210"}) {
    INFO(name);
    const std::string deck = (folder / (name + ".txt")).string(), out = (folder / name).string();
    REQUIRE(run_adore("new " + name + " --out " + deck).code == 0);
    const Result run = run_adore("run " + deck + " --quiet --out " + out);
    INFO(run.out);
    REQUIRE(run.code == 0);
    const json report = json::parse(read(fs::path(out) / "RUN.json"));
    const json& tables = report.at("quasi_static").at("tables");
    const auto count = tables.at("elements").at("azimuth [deg]").size();
    CHECK(count >= 9);
    CHECK(tables.at("elements").at("inner load [N]").size() == count);
    const bool rollers = name != "angular-218" && name != "deep-groove-6205";
    CHECK(tables.contains("slices") == rollers);
    CHECK(tables.contains("stiffness over speed") == (name == "angular-218"));
    CHECK(report.at("summary").at("life_lp_hours").get<double>() > 0.0);
    const std::string listing = read(fs::path(out) / "PRINT.txt");
    for (const char* page : {"QUASI-STATIC EQUILIBRIUM", "OPERATING FITS AND CLEARANCES"})
      CHECK(contains(listing, page));
  }
}

namespace {

/// --set of fits and temperatures in the units of a deck: meters and kelvin, or inches and rankine.
std::string fits_and_temperatures(bool english) {
  const double length = english ? 1.0 / 0.0254 : 1.0, temperature = english ? 1.8 : 1.0;
  const auto set = [](const char* name, double value) {
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out.precision(17);
    out << " --set " << name << "=" << std::scientific << value;
    return out.str();
  };
  return set("raceFit1", 4e-6 * length) + set("raceFit2", 16e-6 * length) +
         set("hsngTemp", 318.0 * temperature) + set("shftTemp", 336.0 * temperature) +
         set("raceTemp1", 330.0 * temperature) + set("raceTemp2", 345.0 * temperature) +
         set("reTemp", 350.0 * temperature) + set("cageTemp", 335.0 * temperature);
}

}  // namespace

TEST_CASE("fits and temperatures change statics and dynamics alike, in either unit system",
          "[cli]") {
  const Folder folder;
  std::map<std::string, json> runs;
  for (const std::string type : {"ball", "ball-english"}) {
    const std::string deck = (folder / (type + ".txt")).string();
    REQUIRE(run_adore("new " + type + " --out " + deck).code == 0);
    const std::string sets = fits_and_temperatures(type == "ball-english");
    const std::string out = (folder / type).string();
    for (const auto& [name, arguments] :
         {std::pair<std::string, std::string>{"-static", " --set mode=-1"},
          std::pair<std::string, std::string>{"-dynamic", " --until 0.01rev"}}) {
      const Result run =
          run_adore("run " + deck + sets + arguments + " --quiet --out " + out + name);
      INFO(run.out);
      REQUIRE(run.code == 0);
      runs[type + name] = json::parse(read(fs::path(out + name) / "RUN.json"));
      CHECK(contains(read(fs::path(out + name) / "PRINT.txt"), "OPERATING FITS AND CLEARANCES"));
    }
  }
  const json& si = runs["ball-static"];
  const json& fits = si.at("operating fits");
  CHECK(fits.at("geometry changed").get<bool>());
  const double free = fits.at("unmounted").at("diametral clearance [m]").get<double>();
  const double warm = fits.at("operating").at("diametral clearance [m]").get<double>();
  CHECK(warm < free);
  // The dynamic run has the same bearing, and its cage too.
  CHECK(runs["ball-dynamic"].at("operating fits").at("operating") == fits.at("operating"));
  CHECK(runs["ball-dynamic"].at("operating fits").contains("cage play, diametral"));
  // Statics in two unit systems: only the conversion of the deck's 16 digits differs.
  for (const auto& [name, value] : si.at("summary").items()) {
    INFO(name);
    const double other = runs["ball-english-static"].at("summary").at(name).get<double>();
    // Zero by symmetry, up to 1e-10 of the largest load [N, N m] or displacement [m].
    const bool load = name.find("load_") == 0, displacement = name.find("displacement_") == 0;
    const double scale = load ? 1e-10 * 1500.0 : displacement ? 1e-10 * 2e-5 : 0.0;
    CHECK(other == Approx(value.get<double>()).epsilon(1e-10).margin(scale));
  }
}

TEST_CASE("lost clearance and loose fits → reported on the terminal, in PRINT and in RUN.json",
          "[cli]") {
  const Folder folder;
  new_ball_deck(folder);
  const Result run = run_adore("run " + folder.path().string() +
                               " --set mode=-1 --set raceFit2=2e-6 --set rpm2=30000.0 --set "
                               "reTemp=420.0 --set raceTemp2=400.0");
  INFO(run.out);
  REQUIRE(run.code == 0);
  for (const char* text : {"clearance becomes negative", "inner race comes loose from the shaft"}) {
    CHECK(contains(run.out, text));
    CHECK(contains(read(folder / "PRINT.txt"), text));
    CHECK(contains(read(folder / "RUN.json"), text));
  }
  const Result check = run_adore("check " + folder.path().string());
  CHECK(check.code == 0);
}

TEST_CASE("set: hidden record of the deck is used again, added defaults are listed", "[cli]") {
  const Folder folder;
  const std::string path = (folder / "DATA.txt").string();
  REQUIRE(run_adore("new angular-218 --out " + path).code == 0);
  const std::string plain = read(folder / "DATA.txt");
  const auto pressure = [&](const std::string& more, const char* said) {
    const Result run = run_adore("run " + path + " --quiet " + more);
    INFO(run.out);
    REQUIRE(run.code == 0);
    CHECK(contains(run.out, "was added with default values") == (said != nullptr));
    if (said != nullptr) CHECK(contains(run.out, said));
    return json::parse(read(folder / "RUN.json"))
        .at("summary")
        .at("largest_pressure_Pa")
        .get<double>();
  };
  const double ideal = pressure("", nullptr);
  CHECK(pressure("--set kReGeoImp=1", "record 5G.1A: was added with default values") == ideal);
  CHECK(pressure("--set kRaceGeoImp2=2", "rndVar12 = 0.0 m") == ideal);
  const double given = pressure("--set kReGeoImp=1 --set reDiaVar=2e-6", nullptr);
  CHECK(given != ideal);

  std::string with_record = plain;
  with_record.insert(with_record.find("'Rec 9.0'"), "'Rec 5G.1A', 2.0e-6\n");
  write(path, with_record);
  CHECK(pressure("", nullptr) == ideal);  // ignored, and said so
  CHECK(pressure("--set kReGeoImp=1", nullptr) == given);
}

TEST_CASE("check and run reject the same values, by record and variable", "[cli]") {
  struct Case {
    const char* deck;
    const char* set;
    const char* said;
  };
  const Case cases[] = {
      {"tapered-30208", "flngHt12=0.", "record 5F, flngHt12 = 0.0: the flange has no height"},
      {"tapered-30208", "flngAng12=-1.", "record 5F, flngAng12 = -1.0: the flange face"},
      {"tapered-30208", "bReEndRad1=0.001", "record 5D.1, bReEndRad1 = 0.001: a roller"},
      {"tapered-30208", "raceTaper2=14.0", "(outer, raceTaper1) and 14 deg (inner) are too close"},
      {"tapered-30208", "raceTaper1=10.2", "too close: the resulting pitch diameter"},
      {"cylindrical-nu209", "bReCrn=0.001", "record 5B.1, bReCrn = 0.001: a roller"},
      {"angular-218", "raceCurFac1=10.1", "enter a value above 0.5 and below 10"},
      {"ball", "cageWidth=0.007", "record 7.1, cageWidth = 0.007: the pockets"},
      {"cylindrical-nu209", "brgOD=0.07", "brgOD"},
      {"tapered", "kRFTrac=-1", "needs user routine ADRX7"},
  };
  for (const Case& c : cases) {
    const Folder folder;
    const std::string path = (folder / "DATA.txt").string();
    REQUIRE(run_adore(std::string("new ") + c.deck + " --out " + path).code == 0);
    const Result run = run_adore("run " + path + " --quiet --set " + c.set);
    INFO(run.out);
    CHECK(run.code == 2);
    CHECK(contains(run.out, c.said));
    deck::Deck changed = deck::read_deck(path).deck;
    const std::string set = c.set;
    changed.set(set.substr(0, set.find('=')), set.substr(set.find('=') + 1));
    deck::write_deck(changed, path);
    const Result check = run_adore("check " + path);
    INFO(check.out);
    CHECK(check.code == 2);
    CHECK(contains(check.out, c.said));
  }
}

TEST_CASE("messages about stiffness and spin: units of the deck", "[cli]") {
  const Folder folder;
  const std::string path = (folder / "DATA.txt").string();
  REQUIRE(run_adore("new angular-218 --out " + path).code == 0);
  const Result spin = run_adore("run " + path + " --set kAngVel=2 --set angVelOrient=-60.");
  INFO(spin.out);
  CHECK(spin.code == 3);
  CHECK(contains(spin.out, "at -60 degrees"));
  CHECK(contains(spin.out, "angVelOrient"));

  const Folder rollers;
  const std::string nu = (rollers / "DATA.txt").string();
  REQUIRE(run_adore("new cylindrical-nu209 --out " + nu).code == 0);
  const Result one = run_adore("run " + nu + " --quiet --opt rollerSlices=1");
  INFO(one.out);
  REQUIRE(one.code == 0);
  const std::string print = read(rollers / "PRINT.txt");
  if (contains(print, "mainly about")) CHECK(contains(print, "N.m/rad"));
}
