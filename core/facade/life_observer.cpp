#include "facade/life_observer.hpp"

#include "life/statistics.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace adore::facade {
namespace {

life::LifeCalculator calculator_of(const bearing::Bearing& bearing,
                                   const life::LifeParameters& parameters) {
  return {bearing.rollers() != nullptr ? life::roller_life_geometry(*bearing.rollers())
                                       : life::ball_life_geometry(bearing.balls()),
          parameters};
}

}  // namespace

LifeObserver::LifeObserver(const bearing::Bearing& bearing, const life::LifeParameters& parameters,
                           const std::array<std::optional<double>, 2>& film_parameter)
    : bearing_(bearing),
      calculator_(calculator_of(bearing, parameters)),
      film_parameter_(film_parameter) {}

void LifeObserver::follow_bearing() {
  const life::LifeParameters parameters = calculator_.parameters();
  calculator_ = calculator_of(bearing_, parameters);
}

void LifeObserver::observe(const scene::Snapshot& snapshot) {
  const bearing::LifeChoices& choices = calculator_.parameters().choices;
  life::BearingContacts contacts = life::life_contacts(snapshot, bearing_);
  for (std::size_t j = 0; j < 2; ++j)  // of the instant; else that of the start
    if (!contacts.film_parameter[j]) contacts.film_parameter[j] = film_parameter_[j];
  const life::LifeState state = calculator_.evaluate(contacts, choices.stored_model);
  const life::PartLives& lives = state.of(choices.stored_model, choices.stored_modification);
  hours_ = life::life_hours(lives.L_S, state.relative_speed);

  life::DamageParts parts = lives.part;
  if (!lives.elements_counted)
    parts[bearing::kElementPart] = std::numeric_limits<double>::infinity();
  const life::DamageRate rate = life::damage_rate(state.relative_speed, parts);
  const double turns = std::abs(snapshot.shaft_rotation) / (2.0 * std::numbers::pi);
  const bool inside = turns >= choices.skip_turns;
  if (started_ && inside) damage_.add_between(snapshot.time - time_, rate_, rate);
  started_ = inside;
  rate_ = rate;
  time_ = snapshot.time;
  step_ = snapshot.step;
}

listing::RunLife LifeObserver::run_life() const {
  const life::LifeParameters& p = calculator_.parameters();
  listing::RunLife out;
  out.damage = damage_;
  out.skipped_turns = p.choices.skip_turns;
  out.model = p.choices.stored_model;
  out.modification = p.choices.stored_modification;
  for (std::size_t i = 0; i < out.slopes.size(); ++i) out.slopes[i] = p.part[i].slope.value;
  return out;
}

void LifeObserver::save(std::map<std::string, double>& state) const {
  damage_.save(state);
  state["life.started"] = started_ ? 1.0 : 0.0;
  state["life.time"] = time_;
  state["life.step"] = static_cast<double>(step_);
  state["life.turns_rate"] = rate_.turns;
  for (std::size_t i = 0; i < rate_.damage.size(); ++i)
    state[fmt::format("life.rate.{}", i)] = rate_.damage[i];
  state["life.per_hour"] = hours_ > 0.0 ? 1.0 / hours_ : -1.0;  // 0: infinite
  if (std::isfinite(hours_)) state["life.hours"] = hours_;      // to the last bit
}

void LifeObserver::restore(const std::map<std::string, double>& state) {
  if (state.count("life.started") == 0) return;
  damage_.restore(state);
  started_ = life::stored(state, "life.started") > 0.5;
  time_ = life::stored(state, "life.time");
  if (state.count("life.step") > 0) step_ = std::lround(life::stored(state, "life.step"));
  rate_.turns = life::stored(state, "life.turns_rate");
  for (std::size_t i = 0; i < rate_.damage.size(); ++i)
    rate_.damage[i] = life::stored(state, fmt::format("life.rate.{}", i));
  const double per_hour = life::stored(state, "life.per_hour");
  hours_ = per_hour > 0.0    ? 1.0 / per_hour
           : per_hour == 0.0 ? std::numeric_limits<double>::infinity()
                             : 0.0;
  if (const auto found = state.find("life.hours"); found != state.end()) hours_ = found->second;
}

}  // namespace adore::facade
