#include "dynamics/system.hpp"

#include "base/errors.hpp"
#include "base/rotation.hpp"
#include "dynamics/effects/races.hpp"
#include "dynamics/state_access.hpp"
#include "dynamics/system_impl.hpp"
#include "scene/user_laws.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace adore::dynamics {

bool System::Impl::evaluate_blocks(double t, const double* y, double* dydt) noexcept {
  begin(t, y, dydt);
  for (const Assembly::Block& b : parts.blocks) {
    b.block->apply(e);
    if (!e.valid) return false;
  }
  for (const Integral& integral : integrals) dydt[integral.index] = *integral.rate;
  return user == nullptr || !user_refuses();
}

bool System::Impl::user_refuses() const noexcept { return user->refused() || user->failed(); }

void System::Impl::begin(double t, const double* y, double* dydt) noexcept {
  is_checked = false;
  if (user != nullptr) {
    (void)user->refused();  // remains of an evaluation that ended early
    user->time = t;
  }
  e.begin(t, y, dydt);
}

RhsStatus System::Impl::status(bool valid) const noexcept {
  if (valid) return RhsStatus::Ok;
  return user != nullptr && user->failed() ? RhsStatus::Fail : RhsStatus::Retry;
}

bool System::Impl::evaluate_timed(double t, const double* y, double* dydt) noexcept {
  parts.cost.begin_sample();
  begin(t, y, dydt);
  for (const Assembly::Block& b : parts.blocks) {
    const auto start = CostLedger::Clock::now();
    b.block->apply(e);
    parts.cost.add_sampled(b.entry, CostLedger::Clock::now() - start);
    if (!e.valid) return false;
  }
  for (const Integral& integral : integrals) dydt[integral.index] = *integral.rate;
  parts.cost.end_sample();
  return user == nullptr || !user_refuses();
}

/// The effect of a block on the elements is the difference of the forces on them.
bool System::Impl::evaluate_with_contributions(double t, const double* y, double* dydt,
                                               double* shares) noexcept {
  const auto border = static_cast<std::size_t>(border_count);
  const std::size_t elements = e.sin_theta.size();
  std::fill_n(shares, border * elements, 0.0);
  begin(t, y, dydt);
  for (std::size_t b = 0; b < parts.blocks.size(); ++b) {
    const std::vector<int>& partner = partner_of[b];
    if (!partner.empty())
      for (std::size_t k = 0; k < before.size(); ++k)
        std::copy(e.actions[k].begin(), e.actions[k].end(), before[k].begin());
    parts.blocks[b].block->apply(e);
    if (!e.valid) return false;
    if (partner.empty()) continue;
    for (std::size_t i = 0; i < elements; ++i) {
      if (partner[i] < 0) continue;
      const auto change = [&](std::size_t k) { return e.actions[k][i] - before[k][i]; };
      const Vec3 force = e.to_base(i, change(0), change(1), change(2));
      const Vec3 moment = e.to_base(i, change(3), change(4), change(5));
      const auto k = static_cast<std::size_t>(partner[i]);
      parts.border[k].body->add_rate_contribution(e, i, force, moment,
                                                  shares + i * border + border_rank[k]);
    }
  }
  for (const Integral& integral : integrals) dydt[integral.index] = *integral.rate;
  return user == nullptr || !user_refuses();
}

void System::Impl::remember() noexcept {
  std::copy_n(e.y, checked.size(), checked.begin());
  if (e.dydt != rates.data()) std::copy_n(e.dydt, rates.size(), rates.begin());
  e.dydt = rates.data();
  checked_time = e.t;
  is_checked = true;
}

bool System::Impl::knows(double t, std::span<const double> y) const noexcept {
  return is_checked && t == checked_time && std::equal(y.begin(), y.end(), checked.begin());
}

const Evaluation& System::Impl::evaluate(double t, std::span<const double> y) {
  demand(static_cast<int>(y.size()) == parts.layout.size(),
         "the number of state variables is wrong");
  if (knows(t, y)) {
    e.y = y.data();
    return e;
  }
  if (!evaluate_blocks(t, y.data(), rates.data())) throw_invalid(t, y.data());
  return e;
}

bool System::Impl::is_valid(double t, std::span<const double> y) noexcept {
  return evaluate_blocks(t, y.data(), rates.data());
}

std::string System::Impl::invalid_state_reason(const double* y) const {
  for (int i = 0; i < parts.layout.controlled_size(); ++i)
    if (!std::isfinite(y[i]))
      return fmt::format(
          "a state variable is not finite ({} = {}); reduce the tolerance (tol) or the maximum "
          "step (stpMax)",
          parts.layout.component_name(i), y[i]);
  if (user != nullptr && user->failed()) return "a user routine failed";
  for (const auto& effect : parts.effects)
    if (std::string why = effect->why_invalid(e); !why.empty()) return why;
  return "an acceleration is not finite. If this occurs at the start, look for deck values that "
         "are far too large. If it occurs later, reduce the tolerance (tol) or the maximum step "
         "(stpMax)";
}

void System::Impl::throw_invalid(double t, const double* y) const {
  throw SolverError(fmt::format("at t = {:.9g} s {}", t, invalid_state_reason(y)));
}

System::System(const bearing::Bearing& bearing, const ScenePlan& plan,
               const statics::StaticSolution& statics, const std::array<double, 2>& fixed_angle,
               const SystemOptions& options, const std::vector<EffectMaker>& more_effects,
               std::shared_ptr<const RollerStaticResult> rollers)
    : impl_(std::make_unique<Impl>(bearing, plan, statics, fixed_angle, options, more_effects,
                                   std::move(rollers))) {}
System::~System() = default;
System::System(System&&) noexcept = default;

const StateLayout& System::layout() const noexcept { return impl_->parts.layout; }
const Scales& System::scales() const noexcept { return impl_->scales; }
std::span<const double> System::contact_loads(std::size_t race) const noexcept {
  return impl_->e.load[race];
}
std::span<const double> System::other_half_loads(std::size_t race) const noexcept {
  for (const auto& effect : impl_->parts.effects)
    if (const auto* races = dynamic_cast<const Races*>(effect.get()))
      return races->other_half_loads(race);
  return {};
}
void System::look(scene::Look& out) const {
  for (const auto& effect : impl_->parts.effects) effect->look(impl_->e, out);
}
double System::speed_to_resolve(double near) const {
  double speed = std::numeric_limits<double>::infinity();
  for (const auto& effect : impl_->parts.effects)
    speed = std::min(speed, effect->speed_to_resolve(impl_->e, near));
  return speed;
}
const RaceLoad& System::balanced_race() const noexcept { return impl_->e.balance; }
CostLedger& System::cost() noexcept { return impl_->parts.cost; }
const bearing::Bearing& System::bearing() const noexcept { return impl_->bearing; }
std::span<const int> System::coupling() const noexcept { return impl_->parts.owner; }

double System::longest_step(double t) const noexcept {
  double longest = std::numeric_limits<double>::infinity();
  for (const auto& effect : impl_->parts.effects)
    longest = std::min(longest, effect->longest_step(t));
  return longest;
}

bool System::neighbours_meet() const noexcept { return impl_->parts.neighbours_meet; }

void System::set_scales(const Scales& scales) {
  demand(scales.length > 0.0 && scales.force > 0.0 && scales.time > 0.0, "scales must be positive");
  impl_->scales = scales;
  impl_->apply_scales();
}

std::vector<double> System::initial_state() const {
  std::vector<double> y(static_cast<std::size_t>(impl_->parts.layout.size()), 0.0);
  for (const auto& effect : impl_->parts.effects) effect->start(y);
  return y;
}

RhsStatus System::rhs(double t, const double* y, double* dydt) noexcept {
  Impl& s = *impl_;
  const bool valid =
      s.parts.cost.sample() ? s.evaluate_timed(t, y, dydt) : s.evaluate_blocks(t, y, dydt);
  return s.status(valid);
}

RhsStatus System::rhs_with_contributions(double t, const double* y, double* dydt,
                                         double* shares) noexcept {
  return impl_->status(impl_->evaluate_with_contributions(t, y, dydt, shares));
}

bool System::has_stiff_part() const noexcept { return impl_->stiff != nullptr; }

RhsStatus System::rhs_stiff(double t, const double* y, double* dydt) noexcept {
  Impl& s = *impl_;
  if (s.stiff == nullptr) return RhsStatus::Fail;
  s.is_checked = false;
  s.e.t = t;
  s.e.y = y;
  for (std::size_t k = 0; k < s.race_blocks; ++k) s.parts.blocks[k].block->apply(s.e);
  return s.stiff->stiff_part(s.e, y, dydt, s.parts.layout.size()) ? RhsStatus::Ok
                                                                  : RhsStatus::Retry;
}

double System::shaft_rotation(double t, std::span<const double> y) noexcept {
  Impl& s = *impl_;
  s.is_checked = false;
  s.e.t = t;
  s.e.y = y.data();
  for (std::size_t k = 0; k < s.race_blocks; ++k) s.parts.blocks[k].block->apply(s.e);
  return s.e.race[1].angle - s.e.race[0].angle;
}

PrescribedRaces System::prescribed_races(double t, std::span<const double> y) noexcept {
  PrescribedRaces out;
  for (const auto& effect : impl_->parts.effects) effect->prescribe(t, out);
  (void)shaft_rotation(t, y);
  for (std::size_t j = 0; j < 2; ++j) out[j].angle = impl_->e.race[j].angle;
  return out;
}

void System::go_on(const PrescribedRaces& before, double t, std::span<double> y) {
  const PrescribedRaces now = prescribed_races(t, y);
  for (const auto& effect : impl_->parts.effects) effect->go_on(before, now, y);
  impl_->is_checked = false;
}

/// Rates follow a quaternion in proportion: a method that knows those of the end of its step need
/// not ask for them again for less.
constexpr double kUnitLength = 1e-10;

bool System::project(double, double* y) const noexcept {
  bool changed = false;
  for (const Slice& slice : impl_->parts.quaternions) {
    const Quat unit = normalize_quaternion(quaternion_at(y, slice));
    for (std::size_t k = 0; k < 4; ++k) {
      double& q = y[slice.first + static_cast<int>(k)];
      changed = changed || std::abs(q - unit[k]) > kUnitLength;
      q = unit[k];
    }
  }
  return changed;
}

void System::check_state(double t, const double* y) const {
  Impl& s = *impl_;
  if (s.knows(t, {y, s.checked.size()})) return;
  if (!s.evaluate_blocks(t, y, s.rates.data())) s.throw_invalid(t, y);
  s.remember();
}

bool System::between_steps(double t, std::span<double> y) {
  impl_->is_checked = false;
  bool changed = false;
  for (const auto& effect : impl_->parts.effects)
    changed = effect->between_steps(t, y, *impl_) || changed;
  return changed;
}

namespace {

/// As constructed, but with the memory of these vectors.
template <class Part, class... Vectors>
void renew(Part& part, Vectors Part::*... vectors) {
  Part fresh;
  (std::swap(fresh.*vectors, part.*vectors), ...);
  ((fresh.*vectors).clear(), ...);
  part = std::move(fresh);
}

void renew(scene::ElementSnapshot& element) {
  using scene::RaceContactSnapshot;
  scene::ElementSnapshot fresh;
  for (std::size_t j = 0; j < element.race.size(); ++j) {
    renew(element.race[j], &RaceContactSnapshot::slice_load, &RaceContactSnapshot::slice_pressure);
    fresh.race[j] = std::move(element.race[j]);
  }
  std::swap(fresh.second, element.second);
  std::swap(fresh.pocket, element.pocket);
  fresh.second.clear();
  fresh.pocket.clear();
  element = std::move(fresh);
}

void renew(Snapshot& snapshot) {
  Snapshot fresh;
  for (scene::ElementSnapshot& element : snapshot.elements) renew(element);
  for (scene::CageSnapshot& cage : snapshot.cages)
    renew(cage, &scene::CageSnapshot::lands, &scene::CageSnapshot::last_half);
  std::swap(fresh.elements, snapshot.elements);
  std::swap(fresh.cages, snapshot.cages);
  std::swap(fresh.energy, snapshot.energy);
  snapshot = std::move(fresh);
}

}  // namespace

Snapshot System::snapshot(double t, std::span<const double> y) {
  Snapshot out;
  snapshot(t, y, out);
  return out;
}

void System::snapshot(double t, std::span<const double> y, Snapshot& snapshot) {
  Impl& s = *impl_;
  s.evaluate(t, y);
  renew(snapshot);
  snapshot.time = t;
  s.form_energy_ledger(snapshot.energy);
  if (s.parts.wants_momentum) snapshot.momentum = s.momentum_ledger();
  snapshot.power.total_loss = snapshot.energy.heat_rate();
  for (const Slice& slice : s.parts.quaternions)
    snapshot.max_quaternion_error = std::max(snapshot.max_quaternion_error,
                                             std::abs(norm(quaternion_at(y.data(), slice)) - 1.0));
  for (const auto& effect : s.parts.effects) effect->report(s.e, snapshot);
}

std::string System::approximation_note() const {
  std::string out;
  for (const auto& effect : impl_->parts.effects) {
    const std::string one = effect->approximation_note();
    if (!one.empty()) out += (out.empty() ? "" : "; ") + one;
  }
  return out;
}

scene::QuadratureError System::quadrature_error(double t, std::span<const double> y) {
  Impl& s = *impl_;
  s.evaluate(t, y);
  scene::QuadratureError error;
  for (const auto& effect : s.parts.effects) effect->add_quadrature_error(s.e, error);
  return error;
}

}  // namespace adore::dynamics
