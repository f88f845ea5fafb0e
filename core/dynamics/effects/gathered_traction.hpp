#pragma once

#include "tribology/laws/user_law.hpp"
#include "tribology/rounded_law.hpp"
#include "tribology/traction_law.hpp"

#include <cstddef>
#include <type_traits>
#include <vector>

/// ADRX7 of contacts that are found one after another: pockets, lands, flanges, contacts between
/// elements. A block goes through its contacts twice. The first pass stores slip and load of all
/// contacts with friction, without forces; the routine is called once for all of them; the
/// second pass uses the answers in the same order and adds forces. Both passes are the same code on
/// the same state, so that they meet the same contacts, and the second has the arithmetic of a
/// built-in law. A built-in law needs only one pass.
/// The routine gets slip and load of these contacts; pressure, widths, entrainment and curvature
/// are 0. Decision 431.
namespace adore::dynamics {

class UserTractionBatch {
 public:
  /// First pass: κ is not known yet.
  struct RecordPass {
    UserTractionBatch* to;
    double load = 0.0;
    double operator()(double slip, double) const {
      to->slip_.push_back(slip);
      to->load_.push_back(load);
      return 0.0;
    }
    [[nodiscard]] RecordPass under(double newtons) const { return {to, newtons}; }
  };
  /// Second pass.
  struct ReplayPass {
    UserTractionBatch* from;
    double operator()(double, double) const { return from->kappa_[from->next_++]; }
    [[nodiscard]] ReplayPass under(double) const { return *this; }
  };

  /// Room for this many contacts; more are allowed.
  void reserve(std::size_t contacts) {
    for (auto* values : {&slip_, &load_, &kappa_, &zeros_}) values->reserve(contacts);
  }
  void clear() noexcept {
    slip_.clear();
    load_.clear();
    next_ = 0;
  }
  /// @param race of the contacts, -1: not one
  void ask(const tribology::UserTractionRoutine& of, int kind, int race) {
    const std::size_t n = slip_.size();
    kappa_.assign(n, 0.0);
    if (n == 0) return;
    if (zeros_.size() < n) zeros_.resize(n, 0.0);
    const double* none = zeros_.data();
    const auto count = static_cast<long>(n);
    of.ask(of.routine,
           {kind, race, count, 1, count, slip_.data(), of.wants_pressure ? none : nullptr,
            load_.data(), none, none, none, none, none, slip_.data(), kappa_.data()});
  }

 private:
  std::vector<double> slip_, load_, kappa_, zeros_;
  std::size_t next_ = 0;
};

template <class Friction>
inline constexpr bool kIsOfUser =
    std::is_same_v<Friction, tribology::RegularizedLaw<tribology::UserTractionLaw::Here<double>>>;

/// Is this the first pass?
template <class Friction>
inline constexpr bool kOnlyNotes =
    std::is_same_v<std::remove_cvref_t<Friction>,
                   tribology::RegularizedLaw<UserTractionBatch::RecordPass>>;

/// N κ(s)/s, the friction force over the slip, from u² [N s/m].
/// @param friction tribology::RegularizedLaw
template <class Friction>
[[nodiscard, gnu::always_inline]] inline double friction_over_slip(const Friction& friction,
                                                                   double N, double square) {
  if constexpr (requires { friction.law.under(N); }) {
    return N * Friction{friction.law.under(N), friction.floor}(square);
  } else if constexpr (kIsOfUser<Friction>) {  // one contact, for reports
    Friction here = friction;
    here.law.contact.load = N;
    return N * here(square);
  } else {
    return N * friction(square);
  }
}

/// pass(friction) with the law as it is, or twice with what a routine of the user answers.
/// @param friction of TractionLaw::visit_regularized; @param race -1: that of the law
template <class Friction, class Pass>
[[gnu::always_inline]] inline void run_friction_passes(UserTractionBatch& asked,
                                                       const Friction& friction, const Pass& pass,
                                                       int race = -1) {
  if constexpr (kIsOfUser<Friction>) {
    using Asked = UserTractionBatch;
    const tribology::UserTractionLaw::Here<double>& law = friction.law;
    asked.clear();
    pass(tribology::RegularizedLaw<Asked::RecordPass>{{&asked}, friction.floor});
    asked.ask(*law.of, law.kind, race < 0 ? law.race : race);
    pass(tribology::RegularizedLaw<Asked::ReplayPass>{{&asked}, friction.floor});
  } else {
    pass(friction);
  }
}
/// The same for an unchanged law; null: pass(nullptr).
template <class Pass>
inline void run_traction_passes(UserTractionBatch& asked, const tribology::TractionLaw* law,
                                const Pass& pass, int race = -1) {
  if (law == nullptr) return pass(nullptr);
  law->visit_regularized(
      [&](const auto& friction) { run_friction_passes(asked, friction, pass, race); });
}

}  // namespace adore::dynamics
