#include "base/errors.hpp"
#include "dynamics/state_access.hpp"
#include "dynamics/system_impl.hpp"
#include "scene/ledger_terms.hpp"

#include <cmath>
#include <utility>

/// Conservation ledgers of a System: what bodies and effects store now, and the integrals that are
/// items of a ledger.
namespace adore::dynamics {

double System::Impl::stored_energy() const {
  EnergyLedger stored;
  stored.add(terms::kKinetic, 0.0);
  stored.add(terms::kElastic, e.elastic);
  for (const auto& effect : parts.effects) effect->store(e, stored);
  return stored.sum(LedgerKind::Stored);
}

Momenta System::Impl::momenta() const {
  Momenta out;
  for (const auto& effect : parts.effects) effect->carry(e, out);
  return out;
}

EnergyLedger System::Impl::energy_ledger() const {
  EnergyLedger energy;
  form_energy_ledger(energy);
  return energy;
}

void System::Impl::form_energy_ledger(EnergyLedger& energy) const {
  energy.clear();
  energy.add(terms::kStart, stored_at_start);
  energy.add(terms::kKinetic, 0.0);
  energy.add(terms::kElastic, e.elastic);
  for (const auto& effect : parts.effects) effect->store(e, energy);
  for (const EnergyItem& item : energy_items) {
    const bool heat = item.term->kind == LedgerKind::Heat;
    energy.add(*item.term, e.y[item.index], item.race, heat ? *item.rate : 0.0);
  }
}

MomentumLedger System::Impl::momentum_ledger() const {
  const Momenta now = momenta();
  MomentumLedger out;
  out.linear_size = now.linear_size;
  out.angular_size = now.angular_size;
  out.linear.add(terms::kMomentumStart, momenta_at_start.linear);
  out.linear.add(terms::kMomentumNow, now.linear);
  out.angular.add(terms::kMomentumStart, momenta_at_start.angular);
  out.angular.add(terms::kMomentumNow, now.angular);
  for (const MomentumItem& item : momentum_items)
    (item.angular ? out.angular : out.linear).add(*item.term, vector_at(e.y, {item.first, 3}));
  return out;
}

System::EnergyBalance System::energy_balance() noexcept {
  Impl& s = *impl_;
  s.remember();  // the end of a step, which is checked and reported next
  EnergyLedger& stored = s.account;
  stored.clear();
  stored.add(terms::kKinetic, 0.0);
  stored.add(terms::kElastic, s.e.elastic);
  for (const auto& effect : s.parts.effects) effect->store(s.e, stored);
  EnergyBalance out;
  out.elastic = s.e.elastic;
  const auto count = [&](double amount, double sign) {
    out.balance += sign * amount;
    out.size += std::abs(amount);
  };
  for (const EnergyLedger::Item& item : stored.items())
    if (item.term->kind == LedgerKind::Stored) count(item.value, 1.0);
  for (const Impl::EnergyItem& item : s.energy_items) switch (item.term->kind) {
      case LedgerKind::Work:
      case LedgerKind::Switch:
        count(s.e.y[item.index], -1.0);
        break;
      case LedgerKind::Heat:
      case LedgerKind::Taken:
        count(s.e.y[item.index], 1.0);
        break;
      case LedgerKind::Start:
      case LedgerKind::Stored:
      case LedgerKind::Note:
        break;
    }
  return out;
}

void System::set_start(double t, std::span<const double> y) {
  Impl& s = *impl_;
  for (const auto& effect : s.parts.effects) effect->resume(y);
  s.is_checked = false;
  s.evaluate(t, y);
  const EnergyLedger energy = s.energy_ledger();
  s.stored_at_start = energy.sum(LedgerKind::Stored) - energy.flow();
  const MomentumLedger momenta = s.momentum_ledger();
  s.momenta_at_start.linear = momenta.linear.sum(LedgerKind::Stored) - momenta.linear.flow();
  s.momenta_at_start.angular = momenta.angular.sum(LedgerKind::Stored) - momenta.angular.flow();
}

void System::continue_from(System& before, double t, std::span<double> y) {
  Impl &s = *impl_, &old = *before.impl_;
  demand(s.parts.layout.size() == old.parts.layout.size(),
         "a change of geometry changed the number of state variables");
  go_on(before.prescribed_races(t, y), t, y);
  s.parts.cost = old.parts.cost;  // of the same blocks
  s.scales = old.scales;
  s.apply_scales();
  for (const auto& effect : s.parts.effects) effect->resume(y);
  s.stored_at_start = old.stored_at_start;
  s.momenta_at_start = old.momenta_at_start;
  s.is_checked = false;
}

}  // namespace adore::dynamics
