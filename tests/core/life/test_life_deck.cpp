#include "deck/templates.hpp"
#include "life/bearing_life.hpp"
#include "life/capacity.hpp"
#include "life/iso281.hpp"
#include "listing/print_life.hpp"
#include "results/channels.hpp"
#include "setup/build_bearing.hpp"
#include "setup/build_life.hpp"
#include "setup/run_control.hpp"
#include "statics/ball_statics.hpp"
#include "thermal/operating.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

using namespace adore;

namespace {

life::BearingLife life_of(const deck::Deck& deck, const bearing::LifeChoices& choices = {}) {
  const bearing::Bearing bearing = setup::build_bearing(deck);
  return life::ball_bearing_life(bearing, setup::build_life_inputs(deck, choices),
                                 statics::solve_ball_statics(bearing));
}

/// A load that takes every contact over the fatigue limit, in the deck's units.
void load(deck::Deck& deck) {
  const double newton = deck.units() == deck::UnitSystem::SI ? 1.0 : 4.4482216152605;
  deck.set("appLoadX", fmt::format("{}", 6000.0 / newton));
  deck.set("appLoadZ", fmt::format("{}", 1500.0 / newton));
}

/// Every life constant of records 8.6.0 to 8.6.3 at a value of its own.
deck::Deck with_constants(deck::Deck deck) {
  deck.set("kLifeCons", "1");
  for (const auto& [name, value] : std::initializer_list<std::pair<const char*, const char*>>{
           {"sProb", "0.95"},    {"brgWbDis", "1.2"},  {"fco1", "1.05"},    {"fcLP1", "0.97"},
           {"shExLP1", "10.0"},  {"depExLP1", "2.2"},  {"fcGZ1", "1.02"},   {"shExGZ1", "9.2"},
           {"fcIH1", "0.99"},    {"shExIH1", "10.1"},  {"depExIH1", "2.1"}, {"wbDis1", "1.15"},
           {"fco2", "0.95"},     {"fcLP2", "1.03"},    {"shExLP2", "10.4"}, {"depExLP2", "2.4"},
           {"fcGZ2", "0.98"},    {"shExGZ2", "8.9"},   {"fcIH2", "1.01"},   {"shExIH2", "10.2"},
           {"depExIH2", "2.3"},  {"wbDis2", "1.12"},   {"fcLPre", "1.04"},  {"shExLPre", "10.6"},
           {"depExLPre", "2.5"}, {"fcGZre", "1.01"},   {"shExGZre", "9.1"}, {"fcIHre", "0.96"},
           {"shExIHre", "9.9"},  {"depExIHre", "2.0"}, {"wbDisRe", "1.18"}})
    deck.set(name, value);
  deck.complete();
  load(deck);
  return deck;
}

std::vector<double> all_lives(const life::BearingLife& life) {
  std::vector<double> out;
  for (const life::ModelLives& model : life.state.model)
    for (const life::PartLives& at : model.modified) {
      for (const double part : at.part)
        if (!std::isnan(part)) out.push_back(part);
      out.push_back(at.L10);
      out.push_back(at.L_S);
    }
  return out;
}

}  // namespace

TEST_CASE("life: SI and English decks of one bearing → equal lives", "[physics][life]") {
  deck::Deck si = with_constants(deck::new_deck("ball"));
  deck::Deck english = with_constants(deck::new_deck("ball-english"));
  constexpr double kPsi = 6894.757293168361;
  si.set("res1", fmt::format("{}", -20000.0 * kPsi));
  english.set("res1", "-20000");
  const std::vector<double> a = all_lives(life_of(si)), b = all_lives(life_of(english));
  REQUIRE(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    INFO("life " << i);
    if (std::isinf(a[i]))
      CHECK(std::isinf(b[i]));
    else  // 1e-10 of the loads, times exponents up to 11
      CHECK(b[i] == Approx(a[i]).epsilon(1e-9));
  }
}

TEST_CASE("life: every variable of the records changes its results", "[physics][life]") {
  const deck::Deck base = with_constants(deck::new_deck("ball"));
  bearing::LifeChoices choices;
  choices.elements = bearing::ElementLife::All;  // so that element constants show in the bearing
  choices.film_parameter = 1.5;                  // so that the asperity constants do
  const std::vector<double> before = all_lives(life_of(base, choices));
  for (const char* name :
       {"sProb",    "brgWbDis",  "fco1",     "fcLP1",      "shExLP1", "depExLP1", "fcGZ1",
        "shExGZ1",  "fcIH1",     "shExIH1",  "depExIH1",   "wbDis1",  "fco2",     "fcLP2",
        "shExLP2",  "depExLP2",  "fcGZ2",    "shExGZ2",    "fcIH2",   "shExIH2",  "depExIH2",
        "wbDis2",   "fcLPre",    "shExLPre", "depExLPre",  "fcGZre",  "shExGZre", "fcIHre",
        "shExIHre", "depExIHre", "wbDisRe",  "facStrLimit"}) {
    deck::Deck changed = base;
    changed.set(name, std::to_string(changed.real(name) * 0.98));
    INFO(name);
    CHECK(all_lives(life_of(changed, choices)) != before);
  }
  for (const char* name : {"res1", "res2"}) {
    deck::Deck changed = base;
    changed.set(name, "-5.0e7");
    INFO(name);
    CHECK(all_lives(life_of(changed, choices)) != before);
  }
}

TEST_CASE("life: factors of materials given in the deck → all used", "[physics][life]") {
  deck::Deck base = deck::new_deck("ball");
  for (const char* code : {"kReMat", "kRaceMat1", "kRaceMat2"}) base.set(code, "1");
  base.complete();
  load(base);
  for (const auto& [prefix, suffix] : std::initializer_list<std::pair<const char*, const char*>>{
           {"re", ""}, {"race", "1"}, {"race", "2"}})
    for (const auto& [stem, value] : std::initializer_list<std::pair<const char*, const char*>>{
             {"Den", "7800"}, {"EM", "2.07e11"}, {"PR", "0.3"}, {"VM", "6.84e8"}, {"H", "62"}})
      base.set(std::string(prefix) + stem + suffix, value);
  for (const char* name :
       {"rmsAspSlope1", "rmsAspSlope2", "aspTrac1",    "aspTrac2",    "facMat1",    "facMat2",
        "facMatRe",     "facCont1",     "facCont2",    "facContRe",   "facProc1",   "facProc2",
        "facProcRe",    "facMatLF1",    "facMatLF2",   "facMatLFre",  "facProcLF1", "facProcLF2",
        "facProcLFre",  "hardnessLF1",  "hardnessLF2", "hardnessLFre"})
    base.set(name, std::string(name).find("Slope") != std::string::npos ? "0.02" : "0.9");
  bearing::LifeChoices choices;
  choices.film_parameter = 1.5;
  const std::vector<double> before = all_lives(life_of(base, choices));
  for (const char* name :
       {"rmsAspSlope1", "rmsAspSlope2", "aspTrac1",   "aspTrac2",    "facMat1",
        "facMat2",      "facMatRe",     "facCont1",   "facCont2",    "facContRe",
        "facProc1",     "facProc2",     "facProcRe",  "facMatLF1",   "facMatLF2",
        "facMatLFre",   "facProcLF1",   "facProcLF2", "facProcLFre", "hardnessLF1",
        "hardnessLF2",  "hardnessLFre", "raceVM1",    "raceVM2",     "reVM"}) {
    deck::Deck changed = base;
    changed.set(name, std::to_string(changed.real(name) * 1.1));
    INFO(name);
    CHECK(all_lives(life_of(changed, choices)) != before);
  }
}

TEST_CASE("life: multiplier of zero → error with record and variable", "[unit][life]") {
  deck::Deck deck = with_constants(deck::new_deck("ball"));
  deck.set("fcGZ2", "0");
  CHECK_THROWS_WITH(setup::build_life_inputs(deck),
                    Catch::Contains("8.6.2") && Catch::Contains("fcGZ2"));
  CHECK(setup::build_run_options({{"sol7Life", "ih-tallian"}}).life.stored_modification ==
        bearing::LifeModification::Tallian);
  CHECK_THROWS_WITH(setup::build_run_options({{"sol7Life", "best"}}),
                    Catch::Contains("lpu") && Catch::Contains("sol7Life"));
}

TEST_CASE("life page: origins, infinite lives and the film statement", "[unit][life]") {
  deck::Deck light = deck::new_deck("ball");
  light.set("appLoadX", "60");
  light.set("appLoadZ", "0");
  light.set("rpm2", "100");
  const life::BearingLife life = life_of(light);
  REQUIRE(
      std::isinf(life.state.of(bearing::LifeModel::Harris, bearing::LifeModification::None).L10));
  listing::Report report("page", deck::UnitSystem::SI);
  listing::print_life(report, life);
  const std::string text = report.take();
  for (const char* part :
       {"INFINITE", "CALIBRATED", "recalled", "derived", "no lubricant film is computed",
        "Original Lundberg-Palmgren", "Gupta-Zaretsky type", "Tallian-type", "ISO 16281", "Cu"})
    CHECK_THAT(text, Catch::Contains(part));
  const auto json = listing::life_json(life);
  CHECK(json["lives"]["Ioannides-Harris type"]["basic"]["L10 [hr]"] == "infinite");
  CHECK(json["parameters"]["outer race"]["STLE"]["material"]["origin"] == "recalled");
  scene::Snapshot snapshot;
  snapshot.power.life_hours = std::numeric_limits<double>::infinity();
  results::ChannelSource source;
  source.snapshot = &snapshot;
  double shown = 0.0;
  results::channels()[results::channel_index("power.life")].get(source, {}, &shown);
  CHECK(shown == 9.9999999e30);
}

TEST_CASE("life: record 9.0, survival probability and factors → expected directions",
          "[physics][life]") {
  using bearing::LifeModel;
  using bearing::LifeModification;
  deck::Deck base = deck::new_deck("ball");
  load(base);
  const life::BearingLife before = life_of(base);
  const auto with = [&](const char* name, const char* value) {
    deck::Deck changed = base;
    changed.set(name, value);
    return life_of(changed);
  };
  const auto ratio = [&](const life::BearingLife& after, LifeModel m, LifeModification f,
                         std::size_t part) {
    return after.state.of(m, f).part[part] / before.state.of(m, f).part[part];
  };
  // Compression (below 0) on the inner race lengthens its STLE life by the factor, nothing else.
  const life::BearingLife pressed = with("res2", "-1.0e8");
  const double tau = before.race[1].peaks.max_shear * before.race[1].p_max;
  CHECK(ratio(pressed, LifeModel::Original, LifeModification::Stle, 1) ==
        Approx(std::pow(tau / (tau - 0.5e8), 9.0)).epsilon(1e-9));
  CHECK(ratio(pressed, LifeModel::Original, LifeModification::Stle, 0) == 1.0);
  CHECK(ratio(pressed, LifeModel::Original, LifeModification::None, 1) == 1.0);
  CHECK(ratio(with("res2", "1.0e8"), LifeModel::Zaretsky, LifeModification::Stle, 1) < 1.0);
  // A higher limit lengthens Ioannides-Harris alone; none is the calibration's shortest.
  const life::BearingLife high = with("facStrLimit", "1.28");
  CHECK(high.parameters.part[1].fatigue_limit.value == Approx(1.28 * 684e6));
  CHECK(ratio(high, LifeModel::Harris, LifeModification::None, 1) > 1.5);
  CHECK(ratio(high, LifeModel::Zaretsky, LifeModification::None, 1) == 1.0);
  CHECK(ratio(with("facStrLimit", "0"), LifeModel::Harris, LifeModification::None, 1) < 0.5);
  // Survival shortens the life of the bearing, not L10.
  deck::Deck sure = base;
  sure.set("kLifeCons", "1");
  sure.complete();
  for (const char* name : {"fco1", "fco2", "fcLP1", "fcLP2", "fcLPre", "fcGZ1", "fcGZ2", "fcGZre",
                           "fcIH1", "fcIH2", "fcIHre"})
    sure.set(name, "1");
  for (const char* name : {"brgWbDis", "wbDis1", "wbDis2", "wbDisRe"}) sure.set(name, "1.2");
  sure.set("sProb", "0.99");
  const life::PartLives lives = life_of(sure).state.of(LifeModel::Original, LifeModification::None);
  CHECK(lives.L_S / lives.L10 ==
        Approx(std::pow(std::log(1.0 / 0.99) / std::log(1.0 / 0.9), 1.0 / 1.2)).epsilon(1e-9));
}

TEST_CASE("life: every life in PRINT and RUN.json has its origin", "[unit][life]") {
  deck::Deck deck = deck::new_deck("ball");
  load(deck);
  const life::BearingLife life = life_of(deck);
  const auto json = listing::life_json(life)["lives"];
  for (const auto& [model, forms] : json.items())
    for (const auto& [form, entry] : forms.items()) {
      INFO(model << " " << form);
      const std::string origin = entry["origin"];
      CHECK_THAT(origin,
                 Catch::StartsWith(model == "Original Lundberg-Palmgren" ? "seen" : "calibrated"));
      if (form == "STLE") CHECK_THAT(origin, Catch::EndsWith("recalled"));
      if (form == "Tallian-type") CHECK_THAT(origin, Catch::EndsWith("derived"));
    }
  listing::Report report("page", deck::UnitSystem::SI);
  listing::print_life(report, life);
  const std::string text = report.take();
  const auto line_of = [&](const std::string& start, std::size_t after) {
    const std::size_t at = text.find(start, after);
    REQUIRE(at != std::string::npos);
    return text.substr(at, text.find('\n', at) - at);
  };
  for (const auto& [model, word] : {std::pair{"Original Lundberg-Palmgren ", "seen"},
                                    {"Updated Lundberg-Palmgren ", "calibrated"},
                                    {"Gupta-Zaretsky type ", "calibrated"},
                                    {"Ioannides-Harris type ", "calibrated"}}) {
    CHECK_THAT(line_of(model, 0), Catch::Contains(word));
    const std::size_t from = text.find(model);
    CHECK_THAT(line_of("with STLE factors", from), Catch::Contains("+ recalled"));
    CHECK_THAT(line_of("with Tallian-type factors", from), Catch::Contains("+ derived"));
  }
}

TEST_CASE(
    "life: material laws → lives follow the modulus of the hot parts, and the page reports it",
    "[physics][life]") {
  deck::Deck deck = deck::new_deck("ball");
  load(deck);
  deck.set("mode", "-1");
  deck.set("kTherm", "1");
  deck.complete();
  for (const char* name :
       {"roomTemp", "hsngTemp", "shftTemp", "raceTemp1", "raceTemp2", "reTemp", "cageTemp"})
    deck.set(name, "450");
  const auto hot_life = [&](const char* laws) {
    deck.set("kMatPropMod", laws);
    const bearing::Bearing bearing = thermal::operating_bearing(setup::build_bearing(deck));
    return life::ball_bearing_life(bearing, setup::build_life_inputs(deck),
                                   statics::solve_ball_statics(bearing));
  };
  const life::BearingLife cold = hot_life("0"), hot = hot_life("1");
  const auto updated = [](const life::BearingLife& life) {
    return life.state.of(bearing::LifeModel::Updated, bearing::LifeModification::None).L10;
  };
  const double E = hot.parameters.part[1].elastic_modulus;
  CHECK(cold.parameters.part[1].elastic_modulus == 207e9);
  // materials.json: 207e9 - 53037790 d - 25871.734 d², d = 450 - 293.15 K.
  CHECK(E == Approx(207e9 - 53037790.0 * 156.85 - 25871.734 * 156.85 * 156.85).epsilon(1e-9));
  // Room temperature is 450 K too, so that nothing grows: E*^-6.3 at the same loads; they move a
  // little with the contact angles.
  CHECK(updated(hot) / updated(cold) == Approx(std::pow(E / 207e9, -6.3)).epsilon(0.05));
  const auto page = [](const life::BearingLife& life) {
    listing::Report report("page", deck::UnitSystem::SI);
    listing::print_life(report, life);
    return report.take();
  };
  // Beginnings of sentences: the rest may be on the next line.
  CHECK_THAT(
      page(hot),
      Catch::Contains("Moduli, pressures and ellipses are those at the temperature of each part") &&
          Catch::Contains("Poisson's ratio, fatigue limit and life factors"));
  CHECK_THAT(page(cold), Catch::Contains("The moduli are those at room temperature"));
}

TEST_CASE("life: contact angle above 90 degrees → a life; capacities are smooth at 90 degrees",
          "[physics][life]") {
  deck::Deck deck = deck::new_deck("ball");
  deck.set("mode", "-1");
  deck.complete();
  for (const auto& [name, value] : {std::pair{"freeConAng", "88.0"},
                                    {"appLoadX", "20000.0"},
                                    {"appLoadZ", "0.0"},
                                    {"rpm2", "20000.0"}})
    deck.set(name, value);
  const life::BearingLife past = life_of(deck);
  CHECK(past.race[1].angle > 0.5 * std::numbers::pi);
  CHECK(past.race[1].gamma < 0.0);
  for (std::size_t race = 0; race < 2; ++race) {
    CHECK(std::isfinite(past.race[race].Q_c));
    CHECK(past.race[race].Q_c > 0.0);
  }
  const auto capacity = [](double degrees, bool inner) {
    life::CapacityGeometry g;
    g.diameter = 0.0127;
    g.cos_alpha = std::cos(degrees * std::numbers::pi / 180.0);
    g.gamma = g.diameter * g.cos_alpha / 0.060;
    g.count = 12;
    g.inner = inner;
    g.profile_radius = 0.5 * g.diameter;
    g.groove_radius = 0.52 * g.diameter;
    return life::point_capacity(g);
  };
  CHECK(capacity(89.9, true) == Approx(capacity(90.1, true)).epsilon(2e-3));
  // Past 90 degrees the inner race is curved as an outer one is before.
  CHECK(capacity(95.0, true) == Approx(capacity(85.0, false)).epsilon(1e-9));
}

TEST_CASE("ISO: rating of the nominal bearing, independent of growth in operation", "[life]") {
  for (const double degrees : {5.0, 10.0, 14.99, 15.0, 18.0, 20.0, 25.0, 40.0, 45.0}) {
    deck::Deck deck = deck::new_deck("angular-218");
    deck.set("freeConAng", fmt::format("{}", degrees));
    load(deck);
    const auto iso_of = [&](const char* rpm, const char* ball, const char* race) {
      deck.set("rpm2", rpm);
      deck.set("reTemp", ball);
      deck.set("raceTemp2", race);
      const bearing::Bearing bearing = thermal::operating_bearing(setup::build_bearing(deck));
      const auto life = life::ball_bearing_life(bearing, setup::build_life_inputs(deck, {}),
                                                statics::solve_ball_statics(bearing));
      REQUIRE(life.iso);
      REQUIRE(life.iso->equivalent);
      return *life.iso;
    };
    const life::IsoReport made = iso_of("100.0", "293.15", "293.15");
    // Not as it is made: only with a note.
    const auto told = std::count_if(made.notes.begin(), made.notes.end(), [](const auto& note) {
      return note.message.find("is rated as a deep-groove bearing (angle 0)") != std::string::npos;
    });
    CHECK(told == (degrees < 15.0 ? 1 : 0));
    for (const auto& [rpm, ball, race] :
         {std::tuple{"8000.0", "293.15", "293.15"}, std::tuple{"3000.0", "340.0", "320.0"},
          std::tuple{"3000.0", "290.0", "330.0"}}) {
      const life::IsoReport at_work = iso_of(rpm, ball, race);
      INFO(degrees << " deg, " << rpm << " rpm, balls " << ball << " K, inner race " << race
                   << " K");
      CHECK(at_work.C == Approx(made.C).epsilon(1e-9));
      CHECK(*at_work.C0 == Approx(*made.C0).epsilon(1e-9));
      CHECK(at_work.equivalent->X == Approx(made.equivalent->X).epsilon(1e-9));
      CHECK(at_work.equivalent->Y == Approx(made.equivalent->Y).epsilon(1e-6));
      CHECK(at_work.equivalent->e == Approx(made.equivalent->e).epsilon(1e-6));
    }
    if (degrees == 20.0) {  // the first row of the standard's table
      CHECK(made.equivalent->X == Approx(0.43));
      CHECK(made.equivalent->Y == Approx(1.0));
      CHECK(made.equivalent->e == Approx(0.57));
    }
  }
}

TEST_CASE("ISO: equivalent loads of angular-contact bearings are continuous in the angle",
          "[life]") {
  life::IsoGeometry g;
  g.element_diameter = 12.7;
  g.pitch_diameter = 60.0;
  g.count = 12;
  const auto at = [&](double degrees, double radial, double axial) {
    g.contact_angle = degrees * std::numbers::pi / 180.0;
    return life::iso_equivalent_load(g, radial, axial).value();
  };
  for (const double axial : {10.0, 300.0, 1000.0, 3000.0, 30000.0}) {
    INFO(axial << " N of thrust");
    const life::EquivalentLoad fifteen = at(15.0, 0.1 * axial, axial);
    CHECK(fifteen.X == Approx(0.44));
    CHECK(fifteen.e >= 0.38);
    CHECK(fifteen.e <= 0.56);
    CHECK(fifteen.Y == Approx((1.0 - 0.44) / fifteen.e).epsilon(0.02));  // P = Fr at Fa = e Fr
    CHECK(at(17.5, 0.1 * axial, axial).Y == Approx(0.5 * (fifteen.Y + 1.0)).epsilon(0.01));
    CHECK(at(19.9999, 0.1 * axial, axial).P ==
          Approx(at(20.0, 0.1 * axial, axial).P).epsilon(1e-4));
    double before = fifteen.P;
    for (double degrees = 16.0; degrees <= 45.0; degrees += 1.0) {
      const double P = at(degrees, 0.1 * axial, axial).P;
      CHECK(P <= before * (1.0 + 1e-9));  // a steeper angle carries thrust more easily
      before = P;
    }
  }
}
