#pragma once

#include <Eigen/Core>

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

/// Conservation ledgers: lists of named items. Whoever shows a ledger walks the list; nobody but
/// the maker of an item knows which items there are.
namespace adore::scene {

/// Sign of an item in the balance
///   residual = work - heat - taken + switches - (stored - start),
/// which shrinks with the integrator's tolerance.
enum class LedgerKind : unsigned char {
  Start,   ///< stored at the start of the run
  Stored,  ///< stored now
  Work,    ///< came in from outside since the start
  Heat,    ///< dissipated since the start
  Switch,  ///< stored after less stored before, over all changes of the model between steps
  Taken,   ///< went with inertia that the model leaves out
  Note     ///< for information, no term of the balance
};

/// Kind of this item, defined once next to its source. Lives as long as the program.
struct LedgerTerm {
  LedgerKind kind;
  std::string_view id;     ///< channel energy.<id>; of heat that no race owns also power.<id>
  std::string_view label;  ///< of the channel: "heat in the pockets"
  /// In RUN.json and PRINT.txt: "kinetic energy now"; for heat its source: "cage pockets". The
  /// second is that of the inner race if each race has a separate item, otherwise empty.
  std::array<std::string_view, 2> name;
  std::string_view help;         ///< of the channel
  std::string_view frame = "-";  ///< of the channel: "N" where the value depends on the frame
  [[nodiscard]] constexpr bool per_race() const noexcept { return !name[1].empty(); }
};

/// The items that some ledger may hold, each of them there as long as the program.
using LedgerTerms = std::span<const LedgerTerm* const>;

template <class Value>
struct LedgerItem {
  const LedgerTerm* term;
  int race;     ///< 0 outer, 1 inner; 0 for what no race owns
  Value value;  ///< [unit of the ledger]
  Value rate;   ///< now, of heat [unit of the ledger/s]; else 0
  /// "heat, cage pockets"
  [[nodiscard]] std::string name() const {
    return (term->kind == LedgerKind::Heat ? "heat, " : "") + std::string(place());
  }
  /// "cage pockets"
  [[nodiscard]] std::string_view place() const {
    return term->name[static_cast<std::size_t>(race)];
  }
};

/// Value: double for energy [J], Eigen::Vector3d for momenta [N s, N m s] in the base frame.
template <class Value>
class Ledger {
 public:
  using Item = LedgerItem<Value>;
  void add(const LedgerTerm& term, const Value& value, int race = 0, const Value& rate = zero()) {
    items_.push_back({&term, race, value, rate});
  }
  /// Adds to the item of that term, which is made when there is none.
  void accumulate(const LedgerTerm& term, const Value& value) {
    for (Item& item : items_)
      if (item.term == &term) {
        item.value += value;
        return;
      }
    add(term, value);
  }
  /// Without items; keeps its memory.
  void clear() noexcept { items_.clear(); }
  [[nodiscard]] const std::vector<Item>& items() const noexcept { return items_; }
  /// Of all items of a kind, in their order.
  [[nodiscard]] Value sum(LedgerKind kind) const { return signed_sum(zero(), kind, 1.0); }
  /// Rate of heat now, all items.
  [[nodiscard]] Value heat_rate() const {
    Value total = zero();
    for (const Item& item : items_)
      if (item.term->kind == LedgerKind::Heat) total += item.rate;
    return total;
  }
  /// Inflow minus outflow since the start: expected stored energy now, minus the start.
  [[nodiscard]] Value flow() const {
    Value total = signed_sum(zero(), LedgerKind::Work, 1.0);
    total = signed_sum(total, LedgerKind::Heat, -1.0);
    total = signed_sum(total, LedgerKind::Taken, -1.0);
    return signed_sum(total, LedgerKind::Switch, 1.0);
  }
  [[nodiscard]] Value residual() const {
    return flow() - (sum(LedgerKind::Stored) - sum(LedgerKind::Start));
  }
  /// By LedgerTerm::id; null when nothing made such an item.
  [[nodiscard]] const Item* find(std::string_view id, int race = 0) const noexcept {
    for (const Item& item : items_)
      if (item.term->id == id && item.race == race) return &item;
    return nullptr;
  }
  /// 0 when nothing made such an item.
  [[nodiscard]] Value value(std::string_view id, int race = 0) const {
    const Item* item = find(id, race);
    return item == nullptr ? zero() : item->value;
  }
  [[nodiscard]] Value rate(std::string_view id, int race = 0) const {
    const Item* item = find(id, race);
    return item == nullptr ? zero() : item->rate;
  }

 private:
  [[nodiscard]] static Value zero() {
    if constexpr (std::is_same_v<Value, double>)
      return 0.0;
    else
      return Value::Zero();
  }
  [[nodiscard]] Value signed_sum(Value total, LedgerKind kind, double sign) const {
    for (const Item& item : items_)
      if (item.term->kind == kind) total += sign * item.value;
    return total;
  }
  std::vector<Item> items_;
};

using EnergyLedger = Ledger<double>;

/// Momentum of elements and cage together in the base frame, moments about its origin. The races
/// are prescribed: what they exert is external.
struct MomentumLedger {
  Ledger<Eigen::Vector3d> linear, angular;       ///< [N s, N m s]
  double linear_size = 0.0, angular_size = 0.0;  ///< Σ over bodies of the momentum's size, now
};

}  // namespace adore::scene
