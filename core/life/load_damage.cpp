#include "life/load_damage.hpp"

#include "base/errors.hpp"
#include "life/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

namespace adore::life {
namespace {

constexpr std::size_t kElements = bearing::kElementPart;

/// The contact under `ratio` times its load.
ContactPatch under_load(const ContactPatch& patch, double ratio, bool line) {
  const double stretch = line ? std::sqrt(ratio) : std::cbrt(ratio);
  return {patch.Q * ratio, line ? patch.a : patch.a * stretch, patch.b * stretch,
          patch.p_max * stretch};
}

/// Element with the largest load at the race.
std::size_t heaviest_element(const RaceContacts& race, std::size_t slices) {
  std::size_t out = 0;
  double most = -1.0;
  for (std::size_t at = 0; at < race.patches.size(); at += slices) {
    double load = 0.0;
    for (std::size_t k = 0; k < slices; ++k) load += std::max(race.patches[at + k].Q, 0.0);
    if (load > most) {
      most = load;
      out = at / slices;
    }
  }
  return out;
}

double damage_of(double life) { return life > 0.0 ? 1.0 / life : 0.0; }  // NaN: not counted

/// Balls on split races, which have two tracks: with the contact of the larger load alone.
BearingContacts on_one_track(const BearingContacts& of, bool line) {
  BearingContacts out = of;
  if (line || of.slices == 1) return out;
  out.slices = 1;
  for (std::size_t j = 0; j < 2; ++j) {
    const std::vector<ContactPatch>& from = of.race[j].patches;
    std::vector<ContactPatch>& patches = out.race[j].patches;
    patches.clear();
    for (std::size_t at = 0; at < from.size(); at += of.slices)
      patches.push_back(*std::max_element(
          from.begin() + static_cast<std::ptrdiff_t>(at),
          from.begin() + static_cast<std::ptrdiff_t>(at + of.slices),
          [](const ContactPatch& a, const ContactPatch& b) { return a.Q < b.Q; }));
  }
  return out;
}

}  // namespace

LoadDamage::LoadDamage(LifeCalculator& calculator, const BearingContacts& contacts) {
  const BearingContacts reference = on_one_track(contacts, calculator.parameters().line);
  const LifeParameters& parameters = calculator.parameters();
  for (std::size_t j = 0; j < 2; ++j) race_rotates_[j] = reference.race[j].rotating;
  for (std::size_t i = 0; i < kDamageParts; ++i)
    weibull_slope_[i] =
        (parameters.line ? parameters.part[i].slope : parameters.part[i].point_slope).value;
  shared_track_ = parameters.choices.shared_track;
  for (std::size_t j = 0; j < 2; ++j) make_table(calculator, reference, j);
}

void LoadDamage::make_table(LifeCalculator& calculator, const BearingContacts& reference,
                            std::size_t race) {
  const bool line = calculator.parameters().line;
  const bearing::LifeChoices& choices = calculator.parameters().choices;
  const std::size_t slices = reference.slices;
  const RaceContacts& contacts = reference.race[race];
  const std::size_t heaviest = heaviest_element(contacts, slices);
  double load = 0.0;
  for (std::size_t k = 0; k < slices && !contacts.patches.empty(); ++k)
    load += std::max(contacts.patches[heaviest * slices + k].Q, 0.0);

  constexpr int kCoarse = (kBelow + kAbove) * kEvaluatedPerOctave;
  std::vector<double> race_damage, element_damage;  // at equal ratios of load
  BearingContacts one = reference;
  for (RaceContacts& all : one.race)
    for (auto* patches : {&all.patches, &all.ellipses})
      for (ContactPatch& patch : *patches) patch.Q = patch.p_max = 0.0;
  const auto set_loads = [&](double ratio) {
    for (std::size_t at = 0; at < contacts.patches.size(); ++at)
      one.race[race].patches[at] =
          under_load(contacts.patches[heaviest * slices + at % slices], ratio, line);
    for (ContactPatch& ellipse : one.race[race].ellipses)
      ellipse = under_load(contacts.ellipses[heaviest], ratio, false);
  };
  if (load > 0.0) try {
      for (int m = 0; m <= kCoarse; ++m) {
        set_loads(std::exp2(static_cast<double>(m) / kEvaluatedPerOctave - kBelow));
        const LifeState state = calculator.evaluate(one, choices.stored_model);
        const PartLives& lives = state.of(choices.stored_model, choices.stored_modification);
        race_damage.push_back(damage_of(lives.part[race]));
        element_damage.push_back(lives.elements_counted ? damage_of(lives.part[kElements]) : 0.0);
      }
    } catch (
        const InputError&) {  // no model holds under such loads; should they come, c takes it up
    }
  const double power = line ? 4.0 : 3.0;
  const double step = std::exp2(power / kEvaluatedPerOctave);
  if (race_damage.empty()) {
    race_damage = {1.0};
    element_damage = {calculator.parameters().choices.stored_model != LifeModel::Original ? 1.0
                                                                                          : 0.0};
  }
  while (race_damage.size() <= static_cast<std::size_t>(kCoarse)) {
    race_damage.push_back(race_damage.back() * step);
    element_damage.push_back(element_damage.back() * step);
  }

  const auto between = [](const std::vector<double>& damage, double place) {
    const auto k = std::min(static_cast<std::size_t>(place), damage.size() - 2);
    const double part = place - static_cast<double>(k), low = damage[k], high = damage[k + 1];
    if (!(low > 0.0) || !(high > 0.0)) return low + part * (high - low);  // below a fatigue limit
    return low * std::pow(high / low, part);
  };
  Table& table = table_[race];
  table.reference = load > 0.0 ? load : 1.0;
  for (int k = 0; k <= kLast; ++k) {
    const double octave = std::floor(static_cast<double>(k) / kPerOctave);
    const double within = static_cast<double>(k) / kPerOctave - octave;
    const double place = kEvaluatedPerOctave * (octave + std::log2(1.0 + within));
    const double damage = between(race_damage, place);
    table.race.push_back(race_rotates_[race] ? damage : std::pow(damage, weibull_slope_[race]));
    table.element.push_back(between(element_damage, place));
  }
}

LoadDamage::MeanDamage LoadDamage::mean(const Table& table,
                                        std::span<const double> loads) noexcept {
  constexpr int kBias = 1023, kMantissa = 52;
  constexpr int kFine = 5;  // bits: kPerOctave
  static_assert(1 << kFine == kPerOctave);
  constexpr int kRest = kMantissa - kFine;
  constexpr double kPart = 1.0 / static_cast<double>(std::uint64_t{1} << kRest);
  const double scale = 1.0 / table.reference;
  MeanDamage sum;
  for (const double load : loads) {
    if (!(load > 0.0)) continue;
    // Exponent and leading bits of the ratio are the place in the table, the rest is the way to the
    // next place.
    const double ratio = load * scale;
    const auto bits = std::bit_cast<std::uint64_t>(ratio);
    const auto place = static_cast<std::int64_t>(bits >> kRest) -
                       (static_cast<std::int64_t>(kBias - kBelow) << kFine);
    if (place < 0) continue;
    if (place >= kLast) {
      const double over = ratio * (1.0 / static_cast<double>(1 << kAbove));
      const double factor = over * over * over * over;
      sum.race += table.race.back() * factor;
      sum.element += table.element.back() * factor;
      continue;
    }
    const double part = static_cast<double>(bits & ((std::uint64_t{1} << kRest) - 1)) * kPart;
    const auto k = static_cast<std::size_t>(place);
    sum.race += table.race[k] + part * (table.race[k + 1] - table.race[k]);
    sum.element += table.element[k] + part * (table.element[k + 1] - table.element[k]);
  }
  const double count = loads.empty() ? 1.0 : static_cast<double>(loads.size());
  return {sum.race / count, sum.element / count};
}

DamageParts LoadDamage::at(std::span<const double> outer,
                           std::span<const double> inner) const noexcept {
  const std::array<MeanDamage, 2> sums{mean(table_[0], outer), mean(table_[1], inner)};
  DamageParts out{};
  for (std::size_t j = 0; j < 2; ++j)
    out[j] = race_rotates_[j] || !(sums[j].race > 0.0)
                 ? sums[j].race
                 : std::pow(sums[j].race, 1.0 / weibull_slope_[j]);
  const double e = weibull_slope_[kElements], a = sums[0].element, b = sums[1].element;
  out[kElements] = shared_track_ || !(a > 0.0) || !(b > 0.0)
                       ? a + b
                       : std::pow(std::pow(a, e) + std::pow(b, e), 1.0 / e);
  return out;
}

double LoadDamage::stamp() const noexcept {
  double out = 0.0;
  for (const Table& table : table_)
    out += table.reference + std::accumulate(table.race.begin(), table.race.end(), 0.0) +
           std::accumulate(table.element.begin(), table.element.end(), 0.0);
  return out;
}

void DamageBatches::add(const DamageParts& damage, double seconds, double revolutions) {
  for (std::size_t i = 0; i < kDamageParts; ++i) open_batch_.damage[i] += damage[i];
  open_batch_.seconds += seconds;
  open_batch_.revolutions += revolutions;
  if (open_batch_.revolutions < length_) return;
  batches_.push_back(open_batch_);
  open_batch_ = {};
  if (batches_.size() < kBatches) return;
  for (std::size_t k = 0; k < kBatches / 2; ++k) {
    Batch joined = batches_[2 * k];
    const Batch& next = batches_[2 * k + 1];
    for (std::size_t i = 0; i < kDamageParts; ++i) joined.damage[i] += next.damage[i];
    joined.seconds += next.seconds;
    joined.revolutions += next.revolutions;
    batches_[k] = joined;
  }
  batches_.resize(kBatches / 2);
  length_ *= 2.0;
}

double DamageBatches::relative_error(const DamageParts& slopes) const {
  constexpr std::size_t kMinBatches = 4;
  const auto count = static_cast<double>(batches_.size());
  if (batches_.size() < kMinBatches) return std::numeric_limits<double>::quiet_NaN();
  double mean = 0.0, square = 0.0;
  for (const Batch& batch : batches_) {
    DamageSum one;
    one.add(batch.damage, batch.seconds, batch.revolutions);
    const double rate = 1.0 / one.life_mega_revolutions(slopes);
    mean += rate / count;
    square += rate * rate / count;
  }
  if (!(mean > 0.0)) return std::numeric_limits<double>::quiet_NaN();
  return std::sqrt(std::max(square - mean * mean, 0.0) / (count - 1.0)) / mean;
}

void DamageBatches::save(std::map<std::string, double>& state) const {
  const auto put = [&](const std::string& key, const Batch& batch) {
    for (std::size_t i = 0; i < kDamageParts; ++i)
      state[fmt::format("{}.damage.{}", key, i)] = batch.damage[i];
    state[key + ".seconds"] = batch.seconds;
    state[key + ".revolutions"] = batch.revolutions;
  };
  state["life.batches"] = static_cast<double>(batches_.size());
  state["life.batch length"] = length_;
  put("life.batch.open", open_batch_);
  for (std::size_t k = 0; k < batches_.size(); ++k)
    put(fmt::format("life.batch.{}", k), batches_[k]);
}

void DamageBatches::restore(const std::map<std::string, double>& state) {
  *this = {};
  if (state.count("life.batches") == 0) return;
  const auto get = [&](const std::string& key) {
    Batch out;
    for (std::size_t i = 0; i < kDamageParts; ++i)
      out.damage[i] = stored(state, fmt::format("{}.damage.{}", key, i));
    out.seconds = stored(state, key + ".seconds");
    out.revolutions = stored(state, key + ".revolutions");
    return out;
  };
  length_ = stored(state, "life.batch length");
  open_batch_ = get("life.batch.open");
  const double count = std::clamp(stored(state, "life.batches"), 0.0, double{kBatches});
  for (int k = 0; k < static_cast<int>(count); ++k)
    batches_.push_back(get(fmt::format("life.batch.{}", k)));
}

void StepDamageAccumulator::step(double time, std::span<const double> outer,
                                 std::span<const double> inner) noexcept {
  const DamageParts now = loads_.at(outer, inner);
  const double passed = started_ ? std::max(time - time_, 0.0) : 0.0;
  DamageParts damage{};
  for (std::size_t i = 0; i < kDamageParts; ++i) {
    const double more = 0.5 * passed * (s_[i] + now[i]);
    load_damage_integral_[i] += more;
    damage[i] = c_[i] * more;
    evaluation_due_ = evaluation_due_ || (now[i] > 0.0 && !calibration_known_[i]);
  }
  if (in_damage_window_ && passed > 0.0) {
    ++counted_steps_;
    batches_.add(damage, passed, passed * revolutions_per_second_);
  }
  s_ = now;
  time_ = time;
  ++steps_since_evaluation_;
}

bool StepDamageAccumulator::due() const noexcept {
  return evaluation_due_ || steps_since_evaluation_ >= kStepsPerEvaluation;
}

void StepDamageAccumulator::evaluate(double time, const std::array<std::vector<double>, 2>& loads,
                                     const DamageRate& rate, bool counted) {
  const DamageParts now = loads_.at(loads[0], loads[1]);
  DamageParts c = c_, damage{};
  for (std::size_t i = 0; i < kDamageParts; ++i) {
    if (now[i] > 0.0) {
      c[i] = rate.damage[i] / now[i];
      if (!calibration_known_[i]) c_[i] = c[i];
      calibration_known_[i] = true;
    }
    damage[i] = load_damage_integral_[i] * 0.5 * (c_[i] + c[i]);
    const double larger = std::max(c_[i], c[i]);
    if (in_damage_window_ && larger > 0.0) {
      change_weight_ += damage[i];
      weighted_change_ += damage[i] * std::abs(c[i] - c_[i]) / larger;
    }
  }
  const double seconds = time_ - last_evaluation_time_;
  if (in_damage_window_ && started_)
    damage_sum_.add(damage, seconds, 0.5 * seconds * (revolutions_per_second_ + rate.turns));
  c_ = c;
  revolutions_per_second_ = rate.turns;
  s_ = now;
  load_damage_integral_ = {};
  time_ = last_evaluation_time_ = time;
  steps_since_evaluation_ = 0;
  started_ = true;
  in_damage_window_ = counted;
  evaluation_due_ = false;
  ++evaluations_;
}

DamageSum StepDamageAccumulator::damage() const {
  DamageSum out = damage_sum_;
  if (!in_damage_window_) return out;
  DamageParts damage{};
  for (std::size_t i = 0; i < kDamageParts; ++i) damage[i] = load_damage_integral_[i] * c_[i];
  out.add(damage, time_ - last_evaluation_time_,
          (time_ - last_evaluation_time_) * revolutions_per_second_);
  return out;
}

double StepDamageAccumulator::mean_calibration_change() const noexcept {
  return change_weight_ > 0.0 ? weighted_change_ / change_weight_ : 0.0;
}

/// The only list of the values in MASTER in addition to sum and batches.
template <class Self, class Visit>
void StepDamageAccumulator::visit(Self& self, Visit visit) {
  visit("life.steps.time", self.time_);
  visit("life.steps.evaluated", self.last_evaluation_time_);
  visit("life.steps.turns", self.revolutions_per_second_);
  visit("life.steps.change", self.weighted_change_);
  visit("life.steps.weight", self.change_weight_);
  for (std::size_t i = 0; i < kDamageParts; ++i) {
    visit(fmt::format("life.steps.s.{}", i), self.s_[i]);
    visit(fmt::format("life.steps.integral.{}", i), self.load_damage_integral_[i]);
    visit(fmt::format("life.steps.c.{}", i), self.c_[i]);
  }
}

void StepDamageAccumulator::save(std::map<std::string, double>& state) const {
  if (!started_) return;
  damage_sum_.save(state);
  batches_.save(state);
  visit(*this, [&](const std::string& key, double value) { state[key] = value; });
  state["life.steps.table"] = loads_.stamp();
  state["life.steps.counted"] = in_damage_window_ ? 1.0 : 0.0;
  state["life.steps.due"] = evaluation_due_ ? 1.0 : 0.0;
  state["life.steps.since"] = static_cast<double>(steps_since_evaluation_);
  state["life.steps.number"] = static_cast<double>(counted_steps_);
  state["life.steps.evaluations"] = static_cast<double>(evaluations_);
  for (std::size_t i = 0; i < kDamageParts; ++i)
    state[fmt::format("life.steps.known.{}", i)] = calibration_known_[i] ? 1.0 : 0.0;
}

void StepDamageAccumulator::restore(const std::map<std::string, double>& state) {
  if (state.count("life.steps.table") == 0) return;  // of a version that sampled: starts here
  damage_sum_.restore(state);
  batches_.restore(state);
  visit(*this, [&](const std::string& key, double& value) { value = stored(state, key); });
  in_damage_window_ = stored(state, "life.steps.counted") > 0.5;
  evaluation_due_ = stored(state, "life.steps.due") > 0.5;
  steps_since_evaluation_ = std::lround(stored(state, "life.steps.since"));
  counted_steps_ = std::lround(stored(state, "life.steps.number"));
  evaluations_ = std::lround(stored(state, "life.steps.evaluations"));
  for (std::size_t i = 0; i < kDamageParts; ++i)
    calibration_known_[i] = stored(state, fmt::format("life.steps.known.{}", i)) > 0.5;
  started_ = true;
  if (stored(state, "life.steps.table") == loads_.stamp()) return;
  // Other loads or another model: what is open is damage of the old ones, and c starts anew.
  damage_sum_ = damage();
  load_damage_integral_ = {};
  last_evaluation_time_ = time_;
  calibration_known_ = {};
  s_ = {};
  evaluation_due_ = true;
}

}  // namespace adore::life
