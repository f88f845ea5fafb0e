#include "core/runs/deck_runs.hpp"
#include "deck/deck.hpp"
#include "deck/templates.hpp"
#include "runs/prepare.hpp"
#include "statics/friction.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

/// Rolling resistance of the oil in runs of decks, beside that of their equilibrium.
using namespace adore;
using deck::Deck;
using testing::Ran;
using testing::run_deck;

namespace {

Deck oiled(const char* type, const char* code) {
  Deck deck = deck::new_deck(type);
  deck.set("maxStps", "40");
  deck.set("nStps", "2");
  deck.set("kTrac", code);
  deck.complete();
  if (deck.has("reRaceFilm")) {
    deck.set("reRaceFilm", "1.0e-8");
    deck.set("strParam", "10.0");
  }
  return deck;
}

/// Mean power of an item of the energy ledger [W]; 0: there is none.
double mean_power(const Ran& ran, const std::string& item) {
  const auto& energy = ran.report.at("conservation").at("energy");
  for (const auto& [name, value] : energy.items())
    if (name.starts_with(item)) return value.get<double>() / ran.outcome.time;
  return 0.0;
}

statics::FrictionEstimate of_equilibrium(Deck deck) {
  deck.set("mode", "-1");
  deck.complete();
  runs::DeckRequest request;
  request.text = deck::write_deck(deck);
  const runs::Prepared prepared = runs::prepare(request);
  REQUIRE(prepared.friction);
  return *prepared.friction;
}

}  // namespace

TEST_CASE("rolling resistance: same in motion and equilibrium, all types", "[validation][film]") {
  const testing::TemporaryFolder folder;
  for (const char* type : {"ball", "cylindrical", "spherical", "tapered", "spherical-tapered"}) {
    CAPTURE(type);
    const Deck deck = oiled(type, "3");
    const Ran ran = run_deck(deck, folder / type);
    CHECK(ran.outcome.status == runs::RunStatus::Done);
    CHECK(std::abs(ran.outcome.energy_residual) < 1e-4 * ran.outcome.energy_scale);
    const statics::FrictionEstimate still = of_equilibrium(deck);
    const double outer = mean_power(ran, "heat, rolling resistance at the outer race"),
                 inner = mean_power(ran, "heat, rolling resistance at the inner race");
    CAPTURE(still.torque());
    // Slip heats the inlets of a motion; barrels slide over their width (5.6 %), the others hardly.
    CHECK(outer == Approx(still.of_race(0).rolling).epsilon(0.07));
    CHECK(inner == Approx(still.of_race(1).rolling).epsilon(0.07));
  }
}

TEST_CASE("rolling resistance: only with oil, can be left out, listed in the plan",
          "[unit][film]") {
  const testing::TemporaryFolder folder;
  const auto entry_of = [](const Deck& deck, const char* off) {
    runs::DeckRequest request;
    request.text = deck::write_deck(deck);
    if (off != nullptr) request.options.emplace_back("effectsOff", off);
    const runs::Prepared prepared = runs::prepare(request);
    const auto& effects = prepared.plan.effects;
    const auto found = std::find_if(effects.begin(), effects.end(), [](const auto& one) {
      return one.effect == scene::Effect::RollingResistance;
    });
    return found != effects.end() ? *found : scene::EffectEntry{};
  };
  const scene::EffectEntry wet = entry_of(oiled("ball", "3"), nullptr),
                           dry = entry_of(oiled("ball", "0"), nullptr),
                           off = entry_of(oiled("ball", "3"), "ball / race rolling resistance");
  CHECK(wet.on);
  CHECK_THAT(wet.because, Catch::Contains("kTrac = 3"));
  CHECK_FALSE(dry.on);
  CHECK(dry.name.empty());  // no oil, no line in the plan
  CHECK_FALSE(off.on);
  CHECK_THAT(off.because, Catch::Contains("effectsOff"));
  const Ran ran = run_deck(oiled("ball", "0"), folder / "dry");
  CHECK(mean_power(ran, "heat, rolling resistance at the outer race") == 0.0);
}
