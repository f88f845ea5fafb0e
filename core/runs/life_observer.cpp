#include "runs/life_observer.hpp"

#include "life/statistics.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace adore::runs {
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

void LifeObserver::update_bearing() {
  const life::LifeParameters parameters = calculator_.parameters();
  calculator_ = calculator_of(bearing_, parameters);
}

void LifeObserver::set_reference(const life::BearingContacts& contacts) {
  run_.emplace(life::LoadDamage(calculator_, contacts));
}

life::LifeState LifeObserver::state_at(const scene::Snapshot& snapshot) {
  life::BearingContacts contacts = life::life_contacts(snapshot, bearing_);
  for (std::size_t j = 0; j < 2; ++j)  // of the instant; else that of the start
    if (!contacts.film_parameter[j]) contacts.film_parameter[j] = film_parameter_[j];
  return calculator_.evaluate(contacts, calculator_.parameters().choices.stored_model);
}

void LifeObserver::evaluate(const scene::Snapshot& snapshot) {
  const bearing::LifeChoices& choices = calculator_.parameters().choices;
  const life::LifeState state = state_at(snapshot);
  const life::PartLives& lives = state.of(choices.stored_model, choices.stored_modification);
  life::DamageParts parts = lives.part;
  if (!lives.elements_counted)
    parts[bearing::kElementPart] = std::numeric_limits<double>::infinity();
  std::array<std::vector<double>, 2> loads;
  for (const scene::ElementSnapshot& element : snapshot.elements)
    for (std::size_t j = 0; j < 2; ++j)
      loads[j].push_back(life::equivalent_split_race_load(
          element.race[j].load, element.second.empty() ? 0.0 : element.second[j].load));
  const double turned = std::abs(snapshot.shaft_rotation) / (2.0 * std::numbers::pi);
  run_->evaluate(snapshot.time, loads, life::damage_rate(state.relative_speed, parts),
                 turned >= choices.skip_turns);
}

void LifeObserver::observe(const scene::Snapshot& snapshot) {
  const bearing::LifeChoices& choices = calculator_.parameters().choices;
  const life::LifeState state = state_at(snapshot);
  life_hours_ = life::life_hours(state.of(choices.stored_model, choices.stored_modification).L_S,
                                 state.relative_speed);
  step_ = snapshot.step;
}

listing::RunLife LifeObserver::run_life() const {
  const life::LifeParameters& p = calculator_.parameters();
  listing::RunLife out;
  out.skipped_turns = p.choices.skip_turns;
  out.model = p.choices.stored_model;
  out.modification = p.choices.stored_modification;
  for (std::size_t i = 0; i < out.slopes.size(); ++i) out.slopes[i] = p.part[i].slope.value;
  if (!run_) return out;
  out.damage = run_->damage();
  out.steps = run_->steps();
  out.evaluations = run_->evaluations();
  out.change = run_->mean_calibration_change();
  out.batches = run_->batches().count();
  out.revolutions_per_batch = run_->batches().revolutions_per_batch();
  out.relative_error = run_->batches().relative_error(out.slopes);
  return out;
}

void LifeObserver::save(std::map<std::string, double>& state) const {
  if (run_) run_->save(state);
  state["life.step"] = static_cast<double>(step_);
  state["life.per_hour"] = life_hours_ > 0.0 ? 1.0 / life_hours_ : -1.0;  // 0: infinite
  if (std::isfinite(life_hours_)) state["life.hours"] = life_hours_;      // to the last bit
}

void LifeObserver::restore(const std::map<std::string, double>& state) {
  if (state.count("life.per_hour") == 0) return;
  if (run_) run_->restore(state);
  if (state.count("life.step") > 0) step_ = std::lround(life::stored(state, "life.step"));
  const double per_hour = life::stored(state, "life.per_hour");
  life_hours_ = per_hour > 0.0    ? 1.0 / per_hour
                : per_hour == 0.0 ? std::numeric_limits<double>::infinity()
                                  : 0.0;
  if (const auto found = state.find("life.hours"); found != state.end())
    life_hours_ = found->second;
}

}  // namespace adore::runs
