#include "base/constants.hpp"
#include "deck/templates.hpp"
#include "life/load_damage.hpp"
#include "setup/build_bearing.hpp"
#include "setup/build_life.hpp"
#include "statics/ball_statics.hpp"
#include "statics/roller_statics.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <string>

using namespace adore;
using namespace adore::life;

namespace {

struct Subject {
  bearing::Bearing bearing;
  BearingContacts contacts;
  LifeCalculator calculator;
};

Subject subject_of(const char* type, bearing::LifeChoices choices) {
  const deck::Deck deck = deck::new_deck(type);
  bearing::Bearing bearing = setup::build_bearing(deck);
  const bool rollers = bearing.rollers() != nullptr;
  const bearing::LifeInputs inputs = setup::build_life_inputs(deck, choices);
  BearingContacts contacts = rollers
                                 ? life_contacts(statics::solve_roller_statics(bearing), bearing)
                                 : life_contacts(statics::solve_ball_statics(bearing), bearing);
  LifeCalculator calculator(
      rollers ? roller_life_geometry(*bearing.rollers()) : ball_life_geometry(bearing.balls()),
      life_parameters(inputs, rollers, bearing.element_material, bearing.race_material));
  return {std::move(bearing), std::move(contacts), std::move(calculator)};
}

std::array<std::vector<double>, 2> loads_of(const BearingContacts& contacts) {
  std::array<std::vector<double>, 2> out;
  for (std::size_t j = 0; j < 2; ++j) {
    out[j].assign(contacts.race[j].patches.size() / contacts.slices, 0.0);
    for (std::size_t at = 0; at < contacts.race[j].patches.size(); ++at)
      out[j][at / contacts.slices] += std::max(contacts.race[j].patches[at].Q, 0.0);
  }
  return out;
}

/// Life hours of a run whose loads are those of the contacts times factor(t).
template <class Factor>
double hours_of(Subject& subject, const Factor& factor, long every, long offset) {
  const auto& choices = subject.calculator.parameters().choices;
  LoadDamage damage(subject.calculator, subject.contacts);
  const std::array<std::vector<double>, 2> nominal = loads_of(subject.contacts);
  StepDamageAccumulator run(damage);
  const double speed = 2.0 * kPi * 100.0;
  const auto rate_of = [&](double f) {  // the full model, whatever it is: a contact law of its own
    BearingContacts now = subject.contacts;
    for (RaceContacts& race : now.race)
      for (ContactPatch& patch : race.patches) {
        const double r = std::cbrt(f);
        patch = {patch.Q * f, patch.a * r, patch.b * r, patch.p_max * r};
      }
    const LifeState state = subject.calculator.evaluate(now, choices.stored_model);
    const PartLives& lives = state.of(choices.stored_model, choices.stored_modification);
    DamageParts parts = lives.part;
    if (!lives.elements_counted) parts[2] = std::numeric_limits<double>::infinity();
    return damage_rate(speed, parts);
  };
  const auto loads = [&](double f) {
    std::array<std::vector<double>, 2> out = nominal;
    for (auto& race : out)
      for (double& load : race) load *= f;
    return out;
  };
  run.evaluate(0.0, loads(factor(0.0)), rate_of(factor(0.0)), true);
  for (long k = 1; k <= 20000; ++k) {
    const double t = 1e-6 * static_cast<double>(k), f = factor(t);
    const auto now = loads(f);
    run.step(t, now[0], now[1]);
    if ((k + offset) % every == 0) run.evaluate(t, now, rate_of(f), true);
  }
  DamageParts slopes{};
  for (std::size_t i = 0; i < slopes.size(); ++i)
    slopes[i] = subject.calculator.parameters().part[i].point_slope.value;
  CHECK(run.steps() == 20000);
  return run.damage().life_hours(slopes);
}

}  // namespace

TEST_CASE("load table: damage at the equilibrium's own loads is that of the life model",
          "[unit][life]") {
  for (const char* type : {"ball", "cylindrical", "tapered", "spherical"})
    for (const LifeModel model : {LifeModel::Original, LifeModel::Updated, LifeModel::Zaretsky}) {
      CAPTURE(type, static_cast<int>(model));
      bearing::LifeChoices choices;
      choices.stored_model = model;
      Subject subject = subject_of(type, choices);
      const LoadDamage damage(subject.calculator, subject.contacts);
      const auto loads = loads_of(subject.contacts);
      const DamageParts found = damage.at(loads[0], loads[1]);
      const PartLives lives =
          subject.calculator.evaluate(subject.contacts, model).of(model, LifeModification::None);
      // Lightly loaded rollers carry on fewer slices than the table's, which is that of the
      // heaviest one: c of the run takes up a factor of 2.
      const double most = std::string(type) == "ball" ? 1.01 : 2.5;
      const auto agree = [&](std::size_t part) {
        CHECK(found[part] * lives.part[part] < most);
        CHECK(found[part] * lives.part[part] > 1.0 / most);
      };
      agree(0);
      agree(1);
      if (lives.elements_counted)
        agree(2);
      else
        CHECK(found[2] == 0.0);
    }
}

TEST_CASE("load table: damage over load has the exponent of the model", "[physics][life]") {
  Subject subject = subject_of("ball", {});  // original theory: third power
  const LoadDamage damage(subject.calculator, subject.contacts);
  auto loads = loads_of(subject.contacts);
  const DamageParts one = damage.at(loads[0], loads[1]);
  for (const double factor : {1e-3, 0.3, 1.7, 40.0}) {
    auto more = loads;
    for (auto& race : more)
      for (double& load : race) load *= factor;
    const DamageParts at = damage.at(more[0], more[1]);
    CAPTURE(factor);
    CHECK(at[0] / one[0] == Approx(factor * factor * factor).epsilon(0.005));
  }
  for (auto& race : loads)
    for (double& load : race) load = -1.0;
  CHECK(damage.at(loads[0], loads[1])[1] == 0.0);
}

TEST_CASE(
    "life of a run: vibrating load → integral of the damage, independent of the evaluation points",
    "[physics][life]") {
  // Mean of (1 + a sin)³ is 1 + 3/2 a²: the mean load alone would give a life 1.54 times as long.
  constexpr double kShare = 0.6;
  const auto factor = [](double t) { return 1.0 + kShare * std::sin(2.0 * kPi * 9973.0 * t); };
  Subject subject = subject_of("ball", {});
  const double still = hours_of(
      subject, [](double) { return 1.0; }, 64, 0);
  const double expected = still / (1.0 + 1.5 * kShare * kShare);
  for (const auto& [every, offset] : {std::pair{64L, 0L}, {64L, 31L}, {500L, 7L}, {20000L, 0L}}) {
    CAPTURE(every, offset);
    CHECK(hours_of(subject, factor, every, offset) == Approx(expected).epsilon(0.003));
  }
}

TEST_CASE("batches: spread of the life is the standard error of the mean damage rate",
          "[unit][life]") {
  const DamageParts slopes{1.1, 1.1, 1.1};
  DamageBatches few;
  for (int k = 0; k < 3; ++k) few.add({1e-6, 0.0, 0.0}, 1e-4, DamageBatches::kFirstLength);
  CHECK(std::isnan(few.relative_error(slopes)));
  // Damage of equal parts has no spread, however long the run.
  DamageBatches even;
  for (int k = 0; k < 1000; ++k) even.add({1e-6, 2e-6, 0.0}, 1e-4, 0.01);
  CHECK(even.count() >= DamageBatches::kBatches / 2);
  CHECK(even.count() < DamageBatches::kBatches);
  CHECK(even.revolutions_per_batch() == Approx(1.0));
  CHECK(even.relative_error(slopes) < 0.01);
  // Rates 0 and 2 in turn: standard deviation 1 of a mean 1.
  DamageBatches uneven;
  for (int k = 0; k < 8; ++k)
    uneven.add({k % 2 == 0 ? 0.0 : 2e-6, 0.0, 0.0}, 1e-4, DamageBatches::kFirstLength);
  CHECK(uneven.count() == 8);
  CHECK(uneven.relative_error(slopes) == Approx(1.0 / std::sqrt(7.0)));
  std::map<std::string, double> state;
  uneven.save(state);
  DamageBatches again;
  again.restore(state);
  CHECK(again.relative_error(slopes) == uneven.relative_error(slopes));
  again.restore({});
  CHECK(again.count() == 0);
}

TEST_CASE("damage of steps: continued from MASTER → same as without a break", "[unit][life]") {
  Subject subject = subject_of("ball", {});
  const LoadDamage table(subject.calculator, subject.contacts);
  const auto nominal = loads_of(subject.contacts);
  const DamageRate rate = damage_rate(600.0, {70.0, 30.0, std::numeric_limits<double>::infinity()});
  const auto advance = [&](StepDamageAccumulator& run, long from, long to) {
    for (long k = from; k < to; ++k) {
      auto loads = nominal;
      for (auto& race : loads)
        for (double& load : race) load *= 1.0 + 0.3 * std::sin(0.7 * static_cast<double>(k));
      const double t = 1e-6 * static_cast<double>(k);
      if (k == 0 || run.due()) run.evaluate(t, loads, rate, true);
      run.step(t + 1e-6, loads[0], loads[1]);
    }
  };
  StepDamageAccumulator whole(table), first(table), second(table);
  advance(whole, 0, 1000);
  advance(first, 0, 333);
  std::map<std::string, double> state;
  first.save(state);
  second.restore(state);
  advance(second, 333, 1000);
  CHECK(second.damage().damage() == whole.damage().damage());
  CHECK(second.steps() == whole.steps());
  CHECK(second.evaluations() == whole.evaluations());
  // Other loads or another model: its table is another one, and the full model is asked at once.
  state["life.steps.table"] += 1.0;
  StepDamageAccumulator other(table);
  other.restore(state);
  CHECK(other.due());
  CHECK(other.damage().damage() == first.damage().damage());
}
