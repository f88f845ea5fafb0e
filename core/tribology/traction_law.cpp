#include "tribology/traction_law.hpp"

#include "tribology/dry_inlet.hpp"

#include <cmath>

namespace adore::tribology {
namespace {

/// Coefficients that are zero in exact arithmetic (A + D) may come out of a text file like this.
constexpr double kZeroCoefficient = 1e-12;

}  // namespace

MetalLaw TractionLaw::make_metal_law(const bearing::TractionCurve& c) noexcept {
  if (c.form == bearing::TractionCurve::Form::TwoSlope) return TwoSlopeLaw{c.A, c.B, c.C, c.u0};
  return ExponentialLaw{c.A, c.B, c.C, c.D};
}

TractionLaw::TractionLaw(const bearing::TractionCurve& c) noexcept {
  const MetalLaw law = make_metal_law(c);
  if (law.slopes)
    law_ = law.two_slope;
  else
    law_ = law.exponential;
  if (std::abs(law.at_rest()) > kZeroCoefficient)
    regularization_slip_squared_ = kRegularizationSlip * kRegularizationSlip;
}

TractionLaw::TractionLaw(const UserTractionRoutine& routine, TractionKind kind, int race) noexcept
    : law_(UserTractionLaw{&routine, static_cast<int>(kind), race}) {
  if (std::abs(routine.at_rest) > kZeroCoefficient)
    regularization_slip_squared_ = kRegularizationSlip * kRegularizationSlip;
}

bool TractionLaw::is_user_law() const noexcept {
  return std::holds_alternative<UserTractionLaw>(law_);
}

bool TractionLaw::has_film() const noexcept {
  return visit([](const auto& law) { return kHasFilm<std::decay_t<decltype(law)>>; });
}

double TractionLaw::critical_film() const noexcept {
  return visit([](const auto& law) {
    if constexpr (kHasFilm<std::decay_t<decltype(law)>>)
      return law.film.critical;
    else
      return 0.0;
  });
}

LocalFilm<double> TractionLaw::film(const ContactConditions<double>& contact) const {
  return visit([&](const auto& law) -> LocalFilm<double> {
    if constexpr (kHasFilm<std::decay_t<decltype(law)>>)
      if (law.film.meniscus > kDryMeniscus) return law.film.at(contact);
    return {0.0, 0.0, 0.0, 1.0};
  });
}

const void* TractionLaw::address() const noexcept {
  return visit([](const auto& law) { return static_cast<const void*>(&law); });
}

double TractionLaw::coefficient(double slip, double pressure) const {
  return visit([&](const auto& law) {
    ContactConditions<double> contact;
    contact.peak_pressure = pressure;
    return law.at(contact)(slip, pressure);
  });
}

double TractionLaw::slip_scale() const noexcept {
  const double start = visit([](const auto& law) { return law.start(); });
  return is_slip_regularized() ? 0.0 : start;
}

double TractionLaw::kink() const noexcept {
  return visit([](const auto& law) { return law.kink(); });
}

}  // namespace adore::tribology
