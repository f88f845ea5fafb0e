#include "base/errors.hpp"
#include "core/runs/deck_runs.hpp"
#include "deck/catalogue.hpp"
#include "deck/deck_text_with_comments.hpp"
#include "deck/lookup.hpp"
#include "deck/templates.hpp"
#include "design/calculator_inputs.hpp"
#include "runs/check.hpp"
#include "runs/equilibrium.hpp"
#include "runs/fault_frequencies.hpp"
#include "runs/option_file.hpp"
#include "runs/prepare.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>

/// ADORE.json next to a deck: variables of records X, and what they do to lives and films.

using namespace adore;
namespace fs = std::filesystem;

namespace {

using Sets = std::vector<std::pair<std::string, std::string>>;

struct Folder {
  fs::path path;
  explicit Folder(const char* name) : path(fs::temp_directory_path() / name) {
    fs::remove_all(path);
    fs::create_directories(path);
  }
  ~Folder() { fs::remove_all(path); }
  void deck(const deck::Deck& deck) const { deck::write_deck(deck, path / "DATA.txt"); }
  void json(const std::string& text) const { std::ofstream(path / "ADORE.json") << text; }
  [[nodiscard]] runs::LoadedDeck load() const {
    runs::DeckRequest request;
    request.deck = path;
    return runs::load_deck(request);
  }
  [[nodiscard]] std::string refusal() const {
    try {
      (void)load();
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  }
};

/// A deep-groove bearing at rest in its equilibrium.
deck::Deck bearing_6309() {
  deck::Deck deck =
      deck::read_deck_text(deck::catalogue_deck(deck::find_bearing("6309")), "6309").deck;
  deck.set_all(Sets{{"mode", "-1"}, {"rpm1", "0"}, {"rpm2", "1800"}});
  for (const char* axis : {"X", "Z"}) REQUIRE(deck.has(std::string("appLoad") + axis));
  deck.set("appLoadX", "500");
  deck.set("appLoadZ", "-4000");
  return deck;
}

runs::Prepared prepared(const deck::Deck& deck) {
  runs::DeckRequest request;
  request.deck = "deck";
  request.text = deck::write_deck(deck);
  request.in_memory = true;
  return runs::prepare(request);
}

const Sets kMakers{{"ratingC", "55.3 kN"}, {"ratingC0", "31.5 kN"}, {"ratingCu", "1.34 kN"}};
const Sets kOil{{"oilVisc1", "120"}, {"oilVisc2", "12"}, {"oilTemp", "80 °C"}};

deck::Deck with(deck::Deck deck, const Sets& sets) {
  deck.set_all(sets);
  return deck;
}

}  // namespace

TEST_CASE("ADORE.json: variables with units become values of the deck", "[unit][extension]") {
  const Folder folder("adore_extension");
  folder.deck(deck::new_deck("ball"));
  folder.json(R"({"version": 1, "ratingC": "55.3 kN", "ratingC0": 31500, "matEM": ["206 GPa",
                  "206 GPa", 3.1e11], "ellipseMajor": 20, "oilName": "VG, 68"})");
  const runs::LoadedDeck loaded = folder.load();
  CHECK(loaded.deck.real("ratingC") == Approx(55300.0).epsilon(1e-15));
  CHECK(loaded.deck.real("ratingC0") == 31500.0);
  CHECK(loaded.deck.si("matEM", 1, 3) == 3.1e11);
  CHECK(loaded.deck.text("oilName") == "VG, 68");
  CHECK(loaded.option_values.at("ellipseMajor") == "20");
  CHECK(loaded.option_values.size() == 1);
  // A set of the command overrides the file.
  runs::DeckRequest request;
  request.deck = folder.path;
  request.sets = {{"ratingC", "60000"}};
  CHECK(runs::load_deck(request).deck.real("ratingC") == 60000.0);
  // A deck given as text has none.
  request = {};
  request.deck = folder.path / "DATA.txt";
  request.text = deck::write_deck(deck::new_deck("ball"));
  request.in_memory = true;
  CHECK_FALSE(runs::load_deck(request).deck.has("ratingC"));
}

TEST_CASE("ADORE.json: faults → errors that name file, key and remedy", "[unit][extension]") {
  const Folder folder("adore_extension_faults");
  folder.deck(deck::new_deck("ball"));
  const auto refused = [&](const char* text, const char* phrase) {
    folder.json(text);
    const std::string why = folder.refusal();
    INFO(text << "\n" << why);
    CHECK(why.find(phrase) != std::string::npos);
    CHECK(why.find("ADORE.json") != std::string::npos);
    runs::DeckRequest request;
    request.deck = folder.path;
    try {
      CHECK_FALSE(runs::check(request).ok());
    } catch (const InputError&) {
    }
  };
  refused(R"({"version": 1, "ratingc": 5})", "did you mean ratingC");
  refused(R"({"elipseMajor": 5})", "did you mean ellipseMajor");
  refused(R"({"ratingC": 5e4})", "\"version\": 1");
  refused(R"({"version": 2, "ratingC": 5e4})", "version 1");
  refused(R"({"version": 1, "pitchDia": 0.05})", "no variable with this name in records X");
  refused(R"({"version": 1, "ratingC": "5 mm"})", "ratingC");
  refused(R"({"version": 1, "ratingC": {"N": 5}})", "ratingC");
  refused(R"({"version": 1, "ratingC": -5})", "out of range");
  refused(R"({"version": 1, "ratingC": 5e4, "ratingCu": 6e4})", "not below");
  // One value in two places.
  deck::Deck deck = deck::new_deck("ball");
  deck.set("ratingC", "1e4");
  folder.deck(deck);
  refused(R"({"version": 1, "ratingC": 5e4})", "a different value in the deck file");
  folder.json(R"({"version": 1, "ratingC": 1e4})");
  CHECK(folder.refusal() == "accepted");
}

TEST_CASE("ADORE.json: written from a deck → only what changed", "[unit][extension]") {
  const auto file = runs::OptionFile::from_text(
      "{\n  \"version\": 1,\n  \"ratingC\": \"55.3 kN\",\n  \"seed\": 7\n}\n");
  deck::Deck deck = deck::new_deck("ball");
  CHECK(runs::set_extension(deck, file, "DATA.txt").empty());
  CHECK(file.with_variables(deck) == file.text());
  deck.set("ratingCu", "1340");
  const auto more = runs::OptionFile::from_text(file.with_variables(deck));
  CHECK(more.variables() == Sets{{"ratingC", "55.3 kN"}, {"ratingCu", "1340.0"}});
  CHECK(more.values() == file.values());
  const auto none = runs::OptionFile::from_text(more.with_variables(runs::without_extension(deck)));
  CHECK(none.variables().empty());
  CHECK(none.values() == file.values());
  CHECK(runs::OptionFile().with_variables(deck::new_deck("ball")).empty());
}

TEST_CASE("maker's ratings and an oil by two viscosities: lives of a 6309 as published",
          "[physics][extension][life]") {
  const runs::Prepared made = prepared(with(with(bearing_6309(), kMakers), kOil));
  const life::IsoReport& iso = made.life.iso.value();
  CHECK(iso.C == Approx(55300.0));
  CHECK(iso.equivalent->P == Approx(4000.0));  // Fa/Fr is below e
  const double hours = *iso.L10 * 1e6 / (60.0 * 1800.0);
  CHECK(hours == Approx(24466.0).epsilon(0.005));
  CHECK(1e6 * iso.viscosity.value() == Approx(21.55).epsilon(0.005));
  CHECK(iso.kappa.value() == Approx(1.730).epsilon(0.005));
  CHECK(iso.kappa_origin == "oil");
  CHECK(iso.C_estimate > 0.5 * iso.C);
  CHECK(iso.C_estimate != iso.C);
  const runs::Equilibrium result = runs::equilibrium_of(made);
  std::string lines;
  for (const std::string& line : result.lines) lines += line + "\n";
  INFO(lines);
  CHECK(lines.find("life L10h by ISO 281") != std::string::npos);
  CHECK(lines.find("life L10r by ISO/TS 16281") != std::string::npos);
  CHECK(lines.find("maker's") != std::string::npos);
  CHECK(lines.find("kappa 1.73") != std::string::npos);
  const auto value = [&](std::string_view id) {
    for (const results::KeyResult& one : result.results)
      if (one.of.id == id) return one.value;
    return 0.0;
  };
  CHECK(value("life_iso281_hours") == Approx(hours));
  CHECK(value("viscosity_ratio") == Approx(*iso.kappa));
  // L10r goes with the cube of C.
  const runs::Prepared estimated = prepared(bearing_6309());
  const life::IsoReport& other = estimated.life.iso.value();
  CHECK(other.C == other.C_estimate);
  CHECK(iso.reference->L10r / other.reference->L10r ==
        Approx(std::pow(iso.C / other.C, 3)).epsilon(1e-9));
  CHECK_FALSE(other.kappa.has_value());
}

TEST_CASE("maker's e, X and Y: axial load above e → P = X Fr + Y Fa",
          "[physics][extension][life]") {
  const Sets factors{{"ratingE", "0.1"}, {"ratingX", "0.5"}, {"ratingY", "2.5"}};
  const runs::Prepared made = prepared(with(bearing_6309(), factors));
  CHECK(made.life.iso->equivalent->P == Approx(0.5 * 4000.0 + 2.5 * 500.0));
  const runs::Prepared below = prepared(with(bearing_6309(), {{"ratingE", "0.2"}}));
  CHECK(below.life.iso->equivalent->P == Approx(4000.0));
}

TEST_CASE("one property of the material: E acts on pressure, stiffness and mass stays",
          "[physics][extension]") {
  const runs::Prepared base = prepared(bearing_6309());
  const double given = base.bearing.race_material[0].elastic_modulus;
  const auto value = [](const runs::Prepared& p) { return p.statics.displacement[2]; };
  const runs::Prepared same = prepared(with(bearing_6309(), {{"matEM", std::to_string(given)}}));
  CHECK(value(same) == value(base));
  const runs::Prepared soft = prepared(with(bearing_6309(), {{"matEM", "103 GPa"}}));
  CHECK(soft.bearing.race_material[1].elastic_modulus == Approx(103e9));
  CHECK(soft.bearing.element_material.elastic_modulus == Approx(103e9));
  CHECK(soft.bearing.element_material.density == base.bearing.element_material.density);
  CHECK(std::abs(value(soft)) > std::abs(value(base)));
  CHECK(soft.bearing.element_material.name.find("given elastic modulus") != std::string::npos);
}

TEST_CASE("oil by grade: films, traction and churning of statics", "[physics][extension]") {
  deck::Deck deck = with(bearing_6309(), kOil);
  deck.set_all(Sets{{"kTrac", "21"},
                    {"strParam", "10"},
                    {"reRaceFilm", "1e-9"},
                    {"raceTemp1", "353.15"},
                    {"raceTemp2", "353.15"},
                    {"reTemp", "353.15"}});
  const runs::Prepared made = prepared(deck);
  REQUIRE(made.bearing.lubrication);
  REQUIRE(made.bearing.lubrication->user);
  const bearing::UserLubricant& oil = *made.bearing.lubrication->user;
  CHECK(oil.T0 == Approx(353.15));
  CHECK(oil.viscosity == Approx(21.55e-6 * 838.0).epsilon(0.01));
  CHECK(made.life.state.factors.film_parameter[0].value_or(0.0) > 0.0);
  CHECK(made.life.iso->kappa.value() == Approx(1.730).epsilon(0.005));  // not from the film
  deck.set("oilVisc1", "");
  deck.set("oilVisc2", "");
  deck.set("oilTemp", "");
  CHECK(testing::refusal_of(deck).find("record X2") != std::string::npos);
}

TEST_CASE("start angle: azimuth of element 1; a whole pitch changes nothing",
          "[physics][extension]") {
  const runs::Prepared base = prepared(bearing_6309());
  const int count = base.bearing.element_count();
  const auto at = [&](double pitches) {
    return prepared(
        with(bearing_6309(), {{"startAngle", std::to_string(pitches * 360.0 / count)}}));
  };
  const runs::Prepared whole = at(1.0), half = at(0.5);
  CHECK(half.statics.balls[0].azimuth == Approx(std::acos(-1.0) / count));
  CHECK(whole.statics.displacement[2] == Approx(base.statics.displacement[2]).epsilon(1e-5));
  CHECK(half.statics.displacement[2] != Approx(base.statics.displacement[2]).epsilon(1e-5));
  deck::Deck ball = deck::new_deck("ball");
  ball.set("startAngle", "17");
  const runs::Prepared motion = prepared(ball);
  CHECK(motion.start.balls[0].azimuth == Approx(17.0 * std::acos(-1.0) / 180.0));
  // The pockets of the cage are where the elements are.
  const Folder folder("adore_start_angle");
  ball.set("maxStps", "1");
  CHECK(testing::run_deck(ball, folder.path).outcome.status == runs::RunStatus::Done);
}

TEST_CASE("passing frequencies: nominal from the geometry, computed from the orbital speed",
          "[physics][extension]") {
  const runs::Prepared made = prepared(bearing_6309());
  const runs::FaultFrequencies nominal = runs::nominal_fault_frequencies(made),
                               computed = runs::equilibrium_fault_frequencies(made);
  const bearing::BallGeometry& balls = made.as_built.balls();
  const double turns = 1800.0 / 60.0;
  const double gamma = balls.diameter / balls.pitch_diameter * std::cos(balls.contact_angle);
  CHECK(nominal.outer == Approx(0.5 * balls.count * turns * (1.0 - gamma)));
  CHECK(nominal.inner == Approx(0.5 * balls.count * turns * (1.0 + gamma)));
  CHECK(nominal.cage == Approx(0.5 * turns * (1.0 - gamma)));
  CHECK(nominal.spin.value() ==
        Approx(0.5 * turns * balls.pitch_diameter / balls.diameter * (1.0 - gamma * gamma)));
  // Every element passes either the flaw of one race or, a turn later, that of the other.
  CHECK(computed.outer + computed.inner == Approx(balls.count * turns));
  CHECK(computed.outer == Approx(nominal.outer).epsilon(0.02));
  CHECK(computed.spin.value() == Approx(nominal.spin.value()).epsilon(0.02));
  for (const char* type : {"cylindrical", "tapered", "spherical"}) {
    deck::Deck deck = deck::new_deck(type);
    deck.set_all(Sets{{"mode", "-1"}});
    const runs::Prepared rollers = prepared(deck);
    INFO(type);
    CHECK(runs::equilibrium_fault_frequencies(rollers).outer ==
          Approx(runs::nominal_fault_frequencies(rollers).outer).epsilon(0.05));
    CHECK(runs::equilibrium_fault_frequencies(rollers).spin.value() ==
          Approx(runs::nominal_fault_frequencies(rollers).spin.value()).epsilon(0.05));
  }
}

TEST_CASE("crown radius 0: a straight roller", "[physics][extension]") {
  deck::Deck straight = deck::new_deck("cylindrical");
  straight.set_all(Sets{{"mode", "-1"}});
  deck::Deck written = straight;
  straight.set("bReCrn", "0");
  written.set("bReCrn", "1e10");
  written.set("bReCenLen", deck::value_text(*deck::find_value(written, "bReLen")));
  const runs::Prepared a = prepared(straight), b = prepared(written);
  CHECK(a.rollers->displacement == b.rollers->displacement);
}

TEST_CASE("inputs of calculators from a deck: whole bearing → results of the deck",
          "[unit][extension]") {
  const runs::Prepared ready = prepared(bearing_6309());
  const life::IsoReport& iso = *ready.life.iso;
  const auto of = [&](const char* name) {
    const auto inputs = design::calculator_inputs(ready, name, 1);
    return nlohmann::json(inputs.at("bearing"));
  };
  CHECK(of("iso281")["Dw"].get<double>() == Approx(iso.geometry.element_diameter));
  CHECK(of("iso281")["P"].get<double>() == Approx(iso.equivalent->P));
  CHECK(of("static-safety")["C0"].get<double>() == Approx(*iso.C0));
  CHECK(of("static-safety")["type"] == "deep_groove");
  CHECK(of("minimum-load")["rule"] == "ball_share");
  CHECK(of("kinematics")["Z"] == ready.bearing.element_count());
  CHECK(of("iso16281")["Qi"].size() == ready.statics.balls.size());
  CHECK(of("clearance")["bore"].get<double>() == Approx(ready.as_built.envelope.bore));
  CHECK(design::calculator_inputs(ready, "load-capacity", 1).size() == 2);
  CHECK_THROWS_AS(design::calculator_inputs(ready, "roller-inertia", 1), InputError);
  CHECK_THROWS_AS(design::calculator_inputs(ready, "line-contact", 1), InputError);
}

TEST_CASE("inputs of calculators from a deck: each name of the list → inputs for balls or rollers",
          "[unit][extension]") {
  runs::DeckRequest request;
  request.text = std::string(deck::template_text("cylindrical"));
  request.in_memory = true;
  const runs::Prepared rollers = runs::prepare(request);
  const runs::Prepared balls = prepared(bearing_6309());
  for (const std::string_view name : design::deck_calculators()) {
    int accepted = 0;
    for (const runs::Prepared* one : {&rollers, &balls}) try {
        accepted += design::calculator_inputs(*one, std::string(name), 1).empty() ? 0 : 1;
      } catch (const InputError&) {  // of the other kind of element, or without oil
      }
    INFO(name);
    CHECK((accepted > 0 || name == "film"));
  }
}

TEST_CASE("inputs of calculators from a deck: the contact of one element", "[unit][extension]") {
  deck::Deck deck = bearing_6309();
  const runs::Prepared dry = prepared(deck);
  CHECK_THROWS_AS(design::calculator_inputs(dry, "film", 1), InputError);
  CHECK_THROWS_AS(design::calculator_inputs(dry, "hertz", 99), InputError);
  CHECK_THROWS_AS(design::calculator_inputs(dry, "units", 1), InputError);
  std::size_t loaded = 0;
  for (std::size_t k = 0; k < dry.statics.balls.size(); ++k)
    if (dry.statics.balls[k].Q[1] > dry.statics.balls[loaded].Q[1]) loaded = k;
  const auto hertz = design::calculator_inputs(dry, "hertz", static_cast<int>(loaded) + 1);
  CHECK(hertz["inner race"]["load"].get<double>() == dry.statics.balls[loaded].Q[1]);
  CHECK(hertz["inner race"]["body2"]["Ry"].get<double>() ==
        Approx(-dry.bearing.balls().groove_factor[1] * dry.bearing.balls().diameter));
  CHECK(hertz["outer race"]["body2"]["Rx"].get<double>() < 0.0);
  deck.set_all(Sets{{"kTrac", "1"}, {"strParam", "10"}, {"reRaceFilm", "1e-9"}});
  const auto film = design::calculator_inputs(prepared(deck), "film", static_cast<int>(loaded) + 1);
  CHECK(film["inner race"]["inputs"]["load"].get<double>() > 0.0);
  CHECK(film["inner race"]["inputs"]["u"].get<double>() > 0.0);
}
