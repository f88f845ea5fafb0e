#include "life/iso281.hpp"

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "contact/groove.hpp"
#include "contact/hertz.hpp"
#include "life/constants.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace adore::life {
namespace {

bool is_ball(IsoType type) { return type == IsoType::RadialBall || type == IsoType::ThrustBall; }
bool is_thrust(IsoType type) {
  return type == IsoType::ThrustBall || type == IsoType::ThrustRoller;
}
bool is_axial(const IsoGeometry& g) {
  return is_thrust(g.type) && g.contact_angle > 0.5 * kPi - 1e-9;
}

/// ri (2re - Dw) / (re (2ri - Dw)) over D_w.
double groove_ratio(const IsoGeometry& g) {
  const double i = g.conformity_inner, e = g.conformity_outer;
  if (!(i > 0.5 && e > 0.5))
    throw InputError(fmt::format(
        "ISO 281 rating: the groove factors are {} and {}; both must be above 0.5", i, e));
  return i * (2.0 * e - 1.0) / (e * (2.0 * i - 1.0));
}

double interpolate(const std::vector<std::pair<double, double>>& table, double x) {
  if (x <= table.front().first) return table.front().second;
  for (std::size_t k = 1; k < table.size(); ++k)
    if (x <= table[k].first) {
      const auto& [x0, y0] = table[k - 1];
      const auto& [x1, y1] = table[k];
      return y0 + (y1 - y0) * (x - x0) / (x1 - x0);
    }
  return table.back().second;
}

/// Load whose worse race reaches a pressure, and that both races share [N].
double load_at_pressure(const bearing::BallGeometry& balls, double E, double nu, double pressure,
                        double contact_angle) {
  double least = 0.0;
  for (int race = 0; race < 2; ++race) {
    const contact::HertzConstants h = contact::hertz_constants(
        contact::race_curvature(balls, race, contact_angle), 0.5 * E / (1.0 - nu * nu));
    const double load = std::pow(pressure * 2.0 * kPi * h.a_hat * h.b_hat / 3.0, 3.0);
    least = race == 0 ? load : std::min(least, load);
  }
  return least;
}

bearing::BallGeometry balls_of(const IsoGeometry& g) {
  bearing::BallGeometry balls;
  balls.count = g.count;
  balls.diameter = 1e-3 * g.element_diameter;
  balls.pitch_diameter = 1e-3 * g.pitch_diameter;
  balls.groove_factor = {g.conformity_outer, g.conformity_inner};
  return balls;
}

double size_factor(IsoType type, double pitch_mm) {
  if (pitch_mm <= 100.0) return 1.0;
  return std::pow(100.0 / pitch_mm, is_ball(type) ? 0.5 : 0.3);
}

}  // namespace

double iso_gamma(const IsoGeometry& g) {
  if (!(g.element_diameter > 0.0 && g.pitch_diameter > g.element_diameter && g.count > 0))
    throw InputError(fmt::format(
        "ISO 281 rating: {} elements of {} mm on a pitch diameter of {} mm are not possible. All "
        "values must be above 0, and the pitch diameter must be larger than the element diameter",
        g.count, g.element_diameter, g.pitch_diameter));
  const double ratio = g.element_diameter / g.pitch_diameter;
  return is_axial(g) ? ratio : ratio * std::cos(g.contact_angle);
}

double iso_fc(const IsoGeometry& g) {
  const LifeConstants& c = constants();
  const double gamma = iso_gamma(g);
  const double m = 1.0 - gamma, p = 1.0 + gamma;
  const double sine = std::sin(g.contact_angle);
  if (is_ball(g.type)) {
    const double conformity =
        std::pow(2.0 * g.conformity_inner / (2.0 * g.conformity_inner - 1.0), 0.41);
    const double grooves = std::pow(groove_ratio(g), 0.41);
    const double ratio = std::pow(m / p, 1.72);
    const auto bracket = [](double x) { return std::pow(1.0 + std::pow(x, 10.0 / 3.0), -0.3); };
    const double base = c.point_constant.value * conformity * std::pow(gamma, 0.3);
    if (g.type == IsoType::RadialBall) {
      const double reduction = g.rows > 1 ? c.reduction_ball_double : c.reduction_ball;
      return base * 0.41 * reduction * std::pow(m, 1.39) / std::cbrt(p) *
             bracket(1.04 * ratio * grooves);
    }
    const double eta = 1.0 - sine / 3.0;
    const double reduction = c.reduction_ball_double;  // 0.90, the value of thrust ball bearings
    if (is_axial(g)) return base * eta * reduction * bracket(grooves);
    return base * eta * reduction * std::pow(m, 1.39) / std::cbrt(p) * bracket(ratio * grooves);
  }
  const double base = c.line_constant.value * std::pow(gamma, 2.0 / 9.0);
  const double ratio = std::pow(m / p, 143.0 / 108.0);
  const auto bracket = [](double x) { return std::pow(1.0 + std::pow(x, 4.5), -2.0 / 9.0); };
  const double race = std::pow(m, 29.0 / 27.0) / std::pow(p, 0.25);
  if (g.type == IsoType::RadialRoller)
    return base * 0.377 * c.reduction_roller * race * bracket(1.04 * ratio);
  const double eta = 1.0 - 0.15 * sine;
  if (is_axial(g))
    return c.thrust_roller_constant * c.reduction_thrust_roller * eta * std::pow(gamma, 2.0 / 9.0);
  return base * eta * c.reduction_thrust_roller * race * bracket(ratio);
}

double iso_dynamic_rating(const IsoGeometry& g) {
  const double cosine = is_axial(g) ? 1.0 : std::cos(g.contact_angle);
  const double tangent = !is_thrust(g.type) || is_axial(g) ? 1.0 : std::tan(g.contact_angle);
  const double rows = is_thrust(g.type) ? 1.0 : g.rows;
  const double D = g.element_diameter;
  if (is_ball(g.type)) {
    const double size = D <= 25.4 ? std::pow(D, 1.8) : 3.647 * std::pow(D, 1.4);
    return g.rating_factor * iso_fc(g) * std::pow(rows * cosine, 0.7) * tangent *
           std::pow(g.count, 2.0 / 3.0) * size;
  }
  return g.rating_factor * iso_fc(g) * std::pow(rows * g.length * cosine, 7.0 / 9.0) * tangent *
         std::pow(g.count, 0.75) * std::pow(D, 29.0 / 27.0);
}

double iso_static_factor(double gamma) { return interpolate(constants().static_factor, gamma); }

double iso_static_factor_from_pressure(double gamma) {
  bearing::BallGeometry balls;
  balls.diameter = 1e-3;  // f_0 does not depend on the size
  balls.pitch_diameter = balls.diameter / gamma;
  balls.groove_factor = {0.53, 0.52};
  return load_at_pressure(balls, 207e9, 0.3, 4.2e9, 0.0) / 5.0;
}

double iso_thrust_static_rating(const IsoGeometry& g) {
  const double gamma = is_axial(g) ? 0.0 : iso_gamma(g);
  const double sine = std::sin(g.contact_angle);
  if (!is_ball(g.type))
    return 220.0 * (1.0 - gamma) * g.count * g.length * g.element_diameter * sine;
  constexpr double kModulus = 207e9, kPoisson = 0.3, kPressure = 4.2e9;
  return g.count * sine *
         load_at_pressure(balls_of(g), kModulus, kPoisson, kPressure, g.contact_angle);
}

double iso_self_aligning_static_rating(const IsoGeometry& g) {
  constexpr double kModulus = 207e9, kPoisson = 0.3, kPressure = 4.6e9, kSelfAligningDivisor = 5.0;
  return g.rows * g.count * std::cos(g.contact_angle) *
         load_at_pressure(balls_of(g), kModulus, kPoisson, kPressure, g.contact_angle) /
         kSelfAligningDivisor;
}

std::optional<double> iso_static_rating(const IsoGeometry& g) {
  const double cosine = std::cos(g.contact_angle);
  if (g.type == IsoType::RadialBall)
    return iso_static_factor(iso_gamma(g)) * g.rows * g.count * g.element_diameter *
           g.element_diameter * cosine;
  if (g.type == IsoType::RadialRoller)
    return 44.0 * (1.0 - iso_gamma(g)) * g.rows * g.count * g.length * g.element_diameter * cosine;
  return std::nullopt;
}

std::optional<EquivalentLoad> iso_equivalent_load(const IsoGeometry& g, double radial,
                                                  double axial) {
  const double Fr = std::abs(radial), Fa = std::abs(axial);
  if (is_thrust(g.type)) {
    if (Fr > 0.0) return std::nullopt;
    return EquivalentLoad{Fa, 0.0, 1.0, 0.0};
  }
  const LifeConstants& c = constants();
  const double degrees = g.contact_angle * 180.0 / kPi;
  EquivalentLoad out;
  if (g.type == IsoType::RadialRoller) {
    out.e = 1.5 * std::tan(g.contact_angle);
    out.X = 0.4;
    out.Y = g.contact_angle > 0.0 ? 0.4 / std::tan(g.contact_angle) : 0.0;
    if (g.contact_angle <= 0.0) out.X = 1.0;  // a cylindrical bearing: axial load is the flanges'
  } else if (degrees < 20.0 - 1e-9) {         // as written in degrees
    // Below 15 degrees as a deep-groove bearing; from there between the rows of 15 and of 20.
    const bool spindle = degrees > 15.0 - 1e-9;
    IsoGeometry rated = g;
    if (!spindle) rated.contact_angle = 0.0;
    const double load = iso_static_factor(iso_gamma(rated)) * Fa / *iso_static_rating(rated);
    const LifeConstants::LoadFactors& factors = spindle ? c.spindle : c.deep_groove;
    std::vector<std::pair<double, double>> e, Y;
    for (const auto& row : factors.rows) {
      e.emplace_back(row.relative_load, row.e);
      Y.emplace_back(row.relative_load, row.Y);
    }
    out = {0.0, factors.X, interpolate(Y, load), interpolate(e, load)};
    if (spindle) {
      const auto& next = c.angular.front();
      const double part = std::max(degrees - 15.0, 0.0) / (next.degrees - 15.0);
      out.X += part * (next.X - out.X);
      out.Y += part * (next.Y - out.Y);
      out.e += part * (next.e - out.e);
    }
  } else {
    std::vector<std::pair<double, double>> X, Y, e;
    for (const auto& row : c.angular) {
      X.emplace_back(row.degrees, row.X);
      Y.emplace_back(row.degrees, row.Y);
      e.emplace_back(row.degrees, row.e);
    }
    out = {0.0, interpolate(X, degrees), interpolate(Y, degrees), interpolate(e, degrees)};
  }
  out.P = Fa > out.e * Fr ? out.X * Fr + out.Y * Fa : Fr;
  return out;
}

double iso_load_exponent(IsoType type) { return is_ball(type) ? 3.0 : 10.0 / 3.0; }

double iso_reliability_factor(double survival) {
  if (!(survival > 0.0 && survival < 1.0))
    throw InputError(fmt::format(
        "ISO 281: the survival probability is {}; it must be between 0 and 1", survival));
  return 0.95 * std::pow(std::log(survival) / std::log(0.9), 2.0 / 3.0) + 0.05;
}

AisoResult iso_life_factor(IsoType type, double kappa, double load_ratio) {
  AisoResult out;
  out.outside = !(kappa >= 0.1);
  if (out.outside) return out;
  const AisoFormula& form = is_ball(type) ? constants().aiso_ball : constants().aiso_roller;
  const double k = std::min(kappa, 4.0);
  const auto band = std::find_if(form.bands.begin(), form.bands.end(),
                                 [&](const AisoKappaRange& b) { return k < b.to; });
  const AisoKappaRange& at = band == form.bands.end() ? form.bands.back() : *band;
  const double divisor = is_thrust(type) ? form.thrust_divisor : 1.0;
  const double film = form.constant - at.c / std::pow(k, at.p);
  const double bracket =
      1.0 - std::pow(film, form.inner) * std::pow(load_ratio / divisor, form.load);
  out.value = bracket <= 0.0 ? 50.0 : std::min(0.1 * std::pow(bracket, form.outer), 50.0);
  return out;
}

double iso_contamination(std::string_view code, double kappa, double pitch_mm) {
  std::string name(code);
  if (name == "grease_slight") name += pitch_mm < 500.0 ? "_small" : "_large";
  const auto& table = constants().contamination;
  const auto found = table.find(name);
  if (found == table.end()) {
    std::string known;
    for (const auto& [key, value] : table) known += (known.empty() ? "" : ", ") + key;
    throw InputError(fmt::format(
        "ISO 281: there is no contamination class \"{}\"; the classes are {}", code, known));
  }
  const auto& [C1, C2] = found->second;
  const double oil = std::min(C1 * std::pow(kappa, 0.68) * std::pow(pitch_mm, 0.55), 1.0);
  return std::max(oil * (1.0 - C2 / std::cbrt(pitch_mm)), 0.0);
}

double iso_reference_viscosity(double rpm, double pitch_mm) {
  if (!(rpm > 0.0 && pitch_mm > 0.0))
    throw InputError(fmt::format(
        "ISO 281 reference viscosity: speed {} rpm and pitch diameter {} mm must be above 0", rpm,
        pitch_mm));
  return (rpm < 1000.0 ? 45000.0 * std::pow(rpm, -0.83) : 4500.0 / std::sqrt(rpm)) /
         std::sqrt(pitch_mm);
}

double iso_fatigue_limit_simple(IsoType type, double static_rating, double pitch_mm) {
  return static_rating / (is_ball(type) ? 22.0 : 8.2) * size_factor(type, pitch_mm);
}

double iso_fatigue_limit_ball(const IsoGeometry& g, double E, double nu, double pressure) {
  const double Q_u = load_at_pressure(balls_of(g), E, nu, pressure, g.contact_angle);
  return 0.2288 * g.count * Q_u * g.rows * std::cos(g.contact_angle) *
         size_factor(g.type, g.pitch_diameter);
}

}  // namespace adore::life
