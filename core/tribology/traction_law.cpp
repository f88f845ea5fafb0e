#include "tribology/traction_law.hpp"

#include <cmath>

namespace adore::tribology {
namespace {

/// Coefficients that are zero in exact arithmetic (A + D) may come out of a text file like this.
constexpr double kZeroCoefficient = 1e-12;

}  // namespace

TractionLaw::TractionLaw(const bearing::TractionCurve& c) noexcept {
  if (c.form == bearing::TractionCurve::Form::TwoSlope)
    law_ = TwoSlopeLaw{c.A, c.B, c.C, c.u0};
  else
    law_ = ExponentialLaw{c.A, c.B, c.C, c.D};
  const double at_rest = visit([](const auto& law) { return law.at_rest(); });
  if (std::abs(at_rest) > kZeroCoefficient) floor_ = kRegularisationSlip * kRegularisationSlip;
}

TractionLaw::TractionLaw(const bearing::TractionCurve& metal, const HeatedFilm& film) noexcept
    : TractionLaw(metal) {
  if (const auto* slopes = std::get_if<TwoSlopeLaw>(&law_))
    law_ = HeatedFilmLaw<TwoSlopeLaw>{*slopes, film};
  else
    law_ = HeatedFilmLaw<ExponentialLaw>{std::get<ExponentialLaw>(law_), film};
}

bool TractionLaw::has_film() const noexcept {
  return visit([](const auto& law) {
    return requires { law.film; };
  });
}

double TractionLaw::film(const ContactPoint<double>& contact) const {
  return visit([&](const auto& law) {
    if constexpr (requires { law.film; })
      return law.at(contact).thickness;
    else
      return 0.0;
  });
}

const void* TractionLaw::address() const noexcept {
  return visit([](const auto& law) { return static_cast<const void*>(&law); });
}

double TractionLaw::coefficient(double slip, double pressure) const {
  return visit([&](const auto& law) {
    ContactPoint<double> contact;
    contact.peak_pressure = pressure;
    return law.at(contact)(slip, pressure);
  });
}

double TractionLaw::slip_scale() const noexcept {
  return rounded() ? 0.0 : visit([](const auto& law) { return law.start(); });
}

double TractionLaw::kink() const noexcept {
  return visit([](const auto& law) { return law.kink(); });
}

}  // namespace adore::tribology
