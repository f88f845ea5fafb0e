#pragma once

#include "bearing/bearing.hpp"
#include "tribology/rounded_law.hpp"
#include "tribology/traction_laws.hpp"

#include <cstddef>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

/// A traction law as a value, chosen at set-up from the list of traction_laws.hpp.
namespace adore::tribology {

class TractionLaw {
 public:
  TractionLaw() = default;                                    ///< frictionless
  TractionLaw(const bearing::TractionCurve& curve) noexcept;  // NOLINT: a curve is a law
  /// A routine of the user, which outlives the law. @param race of contacts of one race, else -1
  TractionLaw(const UserTractionRoutine& routine, TractionKind kind, int race = -1) noexcept;
  /// A lubricant's film, with the curve where it breaks down.
  /// @param table numbers that the film points at, kept as long as the law
  template <class Film>
  TractionLaw(const bearing::TractionCurve& metal, const ContactFilmModel& film, const Film& fluid,
              std::shared_ptr<const std::vector<double>> table = nullptr)
      : law_(FilmTractionLaw<Film>{make_metal_law(metal), film, fluid}),
        regularization_slip_squared_(kRegularizationSlip * kRegularizationSlip),
        table_(std::move(table)) {}

  /// f(law) with the law's own type: once per block of contacts, not per contact.
  template <class F>
  decltype(auto) visit(F&& f) const {
    return std::visit(std::forward<F>(f), law_);
  }
  /// f(RegularizedLaw) of contacts without a film, for which the law needs only
  /// `contact`; T double, or a vector: one contact a lane. A law with a film gives that of its
  /// metal contact.
  template <class T = double, class F>
  decltype(auto) visit_regularized(F&& f, const ContactConditions<T>& contact = {}) const {
    const auto with = [&](const auto& dry) {
      return std::forward<F>(f)(
          RegularizedLaw<decltype(dry.at(contact))>{dry.at(contact), regularization_slip_squared_});
    };
    return std::visit(
        [&](const auto& law) {
          if constexpr (kHasFilm<std::decay_t<decltype(law)>>)
            return with(law.metal);
          else
            return with(law);
        },
        law_);
  }
  /// Place in TractionLawList, and the law there, for the race kernels.
  [[nodiscard]] std::size_t index() const noexcept { return law_.index(); }
  [[nodiscard]] const void* address() const noexcept;

  /// κ(u), u >= 0, not rounded, for reports. @param pressure [Pa], read by laws that depend on it
  [[nodiscard]] double coefficient(double slip, double pressure = 0.0) const;
  /// Addend of u² before the root [m²/s²]: ε², ε = kRegularizationSlip, when κ(0) ≠ 0 or
  /// there is a film; otherwise (1e-12 m/s)², so that κ(s)/s is finite at rest.
  [[nodiscard]] double regularization_slip_squared() const noexcept {
    return regularization_slip_squared_;
  }
  /// Is slip rounded?
  [[nodiscard]] bool is_slip_regularized() const noexcept {
    return regularization_slip_squared_ > kNoRegularization;
  }
  /// Slip over which the law starts [m/s]: u0 of two slopes, 1/C of the exponential; 0 when κ(0) ≠
  /// 0 or C = 0, and with a film.
  [[nodiscard]] double slip_scale() const noexcept;
  [[nodiscard]] double kink() const noexcept;
  [[nodiscard]] bool has_film() const noexcept;
  [[nodiscard]] bool is_user_law() const noexcept;
  /// Thickness below which the contact is metallic [m]; 0 without a film.
  [[nodiscard]] double critical_film() const noexcept;
  /// The film of a contact; 0 without.
  [[nodiscard]] LocalFilm<double> film(const ContactConditions<double>& contact) const;

 private:
  static MetalLaw make_metal_law(const bearing::TractionCurve& curve) noexcept;

  TractionLawsIn<std::variant> law_;
  double regularization_slip_squared_ = kNoRegularization;
  std::shared_ptr<const std::vector<double>> table_;
};

}  // namespace adore::tribology
