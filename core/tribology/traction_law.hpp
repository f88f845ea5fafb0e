#pragma once

#include "bearing/bearing.hpp"
#include "tribology/rounded_law.hpp"
#include "tribology/traction_laws.hpp"

#include <cstddef>
#include <utility>
#include <variant>

/// A traction law as a value, chosen at set-up from the list of traction_laws.hpp.
namespace adore::tribology {

class TractionLaw {
 public:
  TractionLaw() = default;                                    ///< frictionless
  TractionLaw(const bearing::TractionCurve& curve) noexcept;  // NOLINT: a curve is a law
  /// A lubricant's film, with the curve where it breaks down.
  TractionLaw(const bearing::TractionCurve& metal, const HeatedFilm& film) noexcept;

  /// f(law) with the law's own type: once per block of contacts, not per contact.
  template <class F>
  decltype(auto) visit(F&& f) const {
    return std::visit(std::forward<F>(f), law_);
  }
  /// f(RoundedLaw) of contacts without a film, of which the law needs to know nothing but
  /// `contact`; T double, or a vector: one contact a lane. A law with a film gives that of its
  /// metal contact.
  template <class T = double, class F>
  decltype(auto) visit_rounded(F&& f, const ContactPoint<T>& contact = {}) const {
    return std::visit(
        [&](const auto& law) {
          return std::forward<F>(f)(
              RoundedLaw<decltype(dry(law).at(contact))>{dry(law).at(contact), floor_});
        },
        law_);
  }
  /// Place in TractionLawList, and the law there, for the race kernels.
  [[nodiscard]] std::size_t index() const noexcept { return law_.index(); }
  [[nodiscard]] const void* address() const noexcept;

  /// κ(u), u >= 0, not rounded, for reports. @param pressure [Pa], read by laws that depend on it
  [[nodiscard]] double coefficient(double slip, double pressure = 0.0) const;
  /// What is added to u² before the root [m²/s²]: ε², ε = kRegularisationSlip, when κ(0) ≠ 0; else
  /// (1e-12 m/s)², so that κ(s)/s is finite at rest.
  [[nodiscard]] double slip_floor() const noexcept { return floor_; }
  /// Is slip rounded?
  [[nodiscard]] bool rounded() const noexcept { return floor_ > kNoRounding; }
  /// Slip over which the law starts [m/s]: u0 of two slopes, 1/C of the exponential; 0 when κ(0) ≠
  /// 0 or C = 0.
  [[nodiscard]] double slip_scale() const noexcept;
  [[nodiscard]] double kink() const noexcept;
  /// Has it a film? How thick is it in the middle of this contact [m]; 0 without.
  [[nodiscard]] bool has_film() const noexcept;
  [[nodiscard]] double film(const ContactPoint<double>& contact) const;

 private:
  TractionLawsIn<std::variant> law_;
  double floor_ = kNoRounding;
};

}  // namespace adore::tribology
