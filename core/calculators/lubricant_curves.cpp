#include "calculators/lubricant_curves.hpp"

#include "calculators/json_access.hpp"
#include "contact/hertz.hpp"
#include "tribology/contact_film.hpp"
#include "tribology/ellipse_traction.hpp"
#include "tribology/film_law.hpp"
#include "tribology/law_spread.hpp"
#include "tribology/lubricant_range.hpp"
#include "tribology/traction_curve.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace adore::calculators {
namespace {

constexpr int kPoints = 61;

/// `count` values from low to high, evenly in their logarithm.
std::vector<double> logarithmic(double low, double high, int count = kPoints) {
  std::vector<double> out;
  for (int i = 0; i < count; ++i)
    out.push_back(low * std::pow(high / low, static_cast<double>(i) / (count - 1)));
  return out;
}

void check(const LubricantContact& c) {
  const std::pair<const char*, double> positive[] = {{"T", c.temperature},
                                                     {"radius", c.radius},
                                                     {"across", c.across},
                                                     {"Eprime", c.modulus},
                                                     {"pressure", c.pressure}};
  for (const auto& [name, value] : positive)
    if (!(value > 0.0) || !std::isfinite(value))
      throw InputError(
          fmt::format("{} = {:g}: must be above 0. Enter a larger number", name, value));
  const std::pair<const char*, double> not_negative[] = {{"speed", c.speed},
                                                         {"roughness", c.roughness},
                                                         {"criticalFilm", c.critical_film},
                                                         {"meniscus", c.meniscus}};
  for (const auto& [name, value] : not_negative)
    if (!(value >= 0.0) || !std::isfinite(value))
      throw InputError(
          fmt::format("{} = {:g}: must not be negative. Enter 0 or more", name, value));
  if (c.user) {
    const std::pair<const char*, double> users[] = {{"refTemp", c.user->T0},
                                                    {"refVis", c.user->viscosity},
                                                    {"lubTherCond", c.user->conductivity},
                                                    {"refTracVis", c.user->traction_viscosity}};
    for (const auto& [name, value] : users)
      if (!(value > 0.0) || !std::isfinite(value))
        throw InputError(fmt::format(
            "{} of the lubricant = {:g}: must be above 0. Enter a larger number", name, value));
  }
  if (c.radius > c.across)
    throw InputError(
        fmt::format("\"radius\" = {:g} m, \"across\" = {:g} m: the radius along the rolling "
                    "direction must not exceed the radius across it. Exchange the two values",
                    c.radius, c.across));
  if (c.metal.size() != 4)
    throw InputError("\"metal\" must have four values: the traction coefficients of record 10.1C");
}

bearing::Lubrication lubrication_of(const LubricantContact& contact) {
  bearing::Lubrication out;
  out.code = contact.code;
  out.user = contact.user;
  out.critical_film = contact.critical_film;
  out.meniscus = contact.meniscus;
  out.stress_limit = contact.stress_limit;
  out.recommended = contact.recommended;
  return out;
}

/// The contact at one load, with its oil.
struct Point {
  explicit Point(const LubricantContact& c)
      : contact(c), oil(tribology::lubricant_of(lubrication_of(c))) {
    const contact::RelativeCurvature rho{1.0 / c.across, 1.0 / c.radius};
    const contact::HertzConstants hertz = contact::hertz_constants(rho, 0.5 * c.modulus);
    // p0 = 3 Q/(2 π a b), a b = a_hat b_hat Q^(2/3).
    load = std::pow(c.pressure * kPi * hertz.a_hat * hertz.b_hat / 1.5, 3.0);
    a = hertz.a_hat * std::cbrt(load);
    b = hertz.b_hat * std::cbrt(load);
    inlet = tribology::inlet_oil(oil, c.temperature, c.meniscus);
  }
  [[nodiscard]] tribology::ContactFilm film(double speed, double slip) const {
    tribology::LubricatedContact f;
    f.load = load;
    f.radius = contact.radius;
    f.k = a / b;
    f.half_width = b;
    f.peak_pressure = contact.pressure;
    f.speed = speed;
    f.slip = slip;
    f.modulus = contact.modulus;
    return tribology::contact_film(inlet, f);
  }
  [[nodiscard]] tribology::TractionLaw law() const {
    tribology::RaceFilmInputs surface;
    surface.radius = contact.radius;
    surface.modulus = contact.modulus;
    surface.wall_temperature = contact.temperature;
    surface.race_speed = std::max(contact.speed, 1e-6);
    surface.width_over_pressure = b / contact.pressure;
    return tribology::film_law(
        tribology::traction_curve(contact.metal_type, {contact.metal[0], contact.metal[1],
                                                       contact.metal[2], contact.metal[3]}),
        oil, lubrication_of(contact), surface);
  }
  [[nodiscard]] double traction(const tribology::TractionLaw& law, double slip) const {
    const tribology::EllipseGeometry g{load, a, b, 0.0, 0.0};
    tribology::EllipseKinematics m{};
    m.u_t = slip;
    m.entrainment = contact.speed;
    m.curvature = 1.0 / contact.radius;
    static const tribology::EllipseRule rule = tribology::make_ellipse_rule(16, 8);
    return tribology::ellipse_traction(law, g, m, rule).F_t / load;
  }

  LubricantContact contact;
  tribology::Lubricant oil;
  double load = 0.0, a = 0.0, b = 0.0;
  tribology::InletOil inlet;
};

std::optional<Json> traction_case(const Json& the_case) {
  const Json& in = the_case.at("inputs");
  LubricantContact c;
  constexpr int kMostCodes = 1000;
  c.code = whole(in, "kTrac", 1, kMostCodes);
  const auto take = [&](const char* key, double& value) {
    if (in.contains(key)) value = get(in, key);
  };
  take("T", c.temperature);
  take("radius", c.radius);
  take("across", c.across);
  take("Eprime", c.modulus);
  take("pressure", c.pressure);
  take("speed", c.speed);
  take("roughness", c.roughness);
  take("criticalFilm", c.critical_film);
  take("meniscus", c.meniscus);
  c.stress_limit = in.value("stressLimit", true);
  c.recommended = in.value("recommended", false);
  if (in.contains("metal")) c.metal = in.at("metal").get<std::vector<double>>();
  const LubricantContactResult p =
      solve_lubricant_contact(c, in.at("slip").get<std::vector<double>>());
  const tribology::Lubricant oil = tribology::lubricant_of(lubrication_of(c));
  return Json{
      {"kappa", p.traction},
      {"stressLimitRatio", oil.limiting_ratio(c.temperature)},
      {"load", p.load},
      {"halfWidth", p.half_width},
      {"k", p.ratio},
      {"mu", p.viscosity},
      {"alpha", p.alpha},
      {"hCentral", p.central},
      {"hMin", p.minimum},
      {"thermal", p.thermal},
      {"starvation", p.starvation},
      {"lambda", p.lambda},
      {"name", oil.name},
      {"provenance", oil.provenance},
      {"range", tribology::extrapolation_note(tribology::pressure_range(c.code), c.pressure)}};
}

void add_laws(const LubricantContact& contact, const std::vector<double>& slips,
              LubricantCurves& out) {
  const tribology::Oil oil = tribology::oil_of(contact.code);
  if (oil.codes.size() < 2 || !(contact.speed > 0.0) || !(contact.meniscus > 0.0)) return;
  const Point point(contact);
  tribology::LawSpreadContact at;
  at.point.load = point.load;
  at.point.peak_pressure = contact.pressure;
  at.point.half_major = point.a;
  at.point.half_minor = point.b;
  at.point.entrainment = contact.speed;
  at.point.curvature = 1.0 / contact.radius;
  at.modulus = contact.modulus;
  at.temperature = contact.temperature;
  at.meniscus = contact.meniscus;
  at.stress_limit = contact.stress_limit;
  out.laws = {
      fmt::format("Traction laws of {}", oil.name),
      "Slip",
      "m/s",
      fmt::format("Traction coefficient of each traction law at {:g} GPa", 1e-9 * contact.pressure),
      "",
      true,
      false,
      {}};
  for (const tribology::LawSpreadRow& row : tribology::law_spread(contact.code, at, slips))
    out.laws.curves.push_back(
        {fmt::format("kTrac {}{}", row.code, row.recommended ? " (recommended)" : ""), slips,
         row.kappa});
  out.recommended =
      fmt::format("{}: kTrac {} is recommended ({})", oil.name, oil.recommended, oil.why);
}

}  // namespace

LubricantContactResult solve_lubricant_contact(const LubricantContact& contact,
                                               const std::vector<double>& slips) {
  check(contact);
  const Point point(contact);
  LubricantContactResult out;
  out.load = point.load;
  out.half_width = point.b;
  out.ratio = point.a / point.b;
  out.viscosity = point.inlet.viscosity;
  out.alpha = point.inlet.alpha;
  const tribology::ContactFilm film = point.film(contact.speed, 0.0);
  out.central = film.central;
  out.minimum = film.minimum;
  out.thermal = film.thermal;
  out.starvation = film.starvation;
  out.lambda = contact.roughness > 0.0 ? film.minimum / contact.roughness : 0.0;
  if (slips.empty()) return out;
  const tribology::TractionLaw law = point.law();
  for (const double slip : slips) out.traction.push_back(point.traction(law, slip));
  return out;
}

LubricantCurves lubricant_curves(const LubricantContact& contact) {
  check(contact);
  const tribology::Lubricant oil = tribology::lubricant_of(lubrication_of(contact));
  LubricantCurves out;
  out.name = oil.name;
  out.provenance = oil.provenance;
  if (!contact.user)
    out.extrapolation_note =
        tribology::extrapolation_note(tribology::pressure_range(contact.code), kLargestPressure);
  out.conditions = fmt::format(
      "{:.0f} K; radius {:.3g} mm along and {:.3g} mm across the rolling direction; {:.2g} GPa and "
      "{:g} m/s unless varied; roughness {:.2g} µm",
      contact.temperature, 1e3 * contact.radius, 1e3 * contact.across, 1e-9 * contact.pressure,
      contact.speed, 1e6 * contact.roughness);

  out.traction = {"Traction coefficient versus slip",
                  "Slip",
                  "m/s",
                  "Traction coefficient",
                  "",
                  true,
                  false,
                  {}};
  const std::vector<double> slips = logarithmic(1e-3, 10.0);
  for (const double pressure : {0.8e9, 1.2e9, 1.6e9, kLargestPressure}) {
    LubricantContact c = contact;
    c.pressure = pressure;
    out.traction.curves.push_back({fmt::format("{:g} GPa", 1e-9 * pressure), slips,
                                   solve_lubricant_contact(c, slips).traction});
  }

  if (!contact.user) add_laws(contact, slips, out);

  const std::array<double, 3> temperatures{contact.temperature - 30.0, contact.temperature,
                                           contact.temperature + 30.0};
  out.viscosity = {
      "Viscosity versus pressure", "Pressure", "GPa", "Viscosity", "Pa·s", false, true, {}};
  out.film = {
      "Central film thickness versus speed", "Mean speed", "m/s", "Film", "µm", true, true, {}};
  out.lambda = {"Film parameter versus speed", "Mean speed", "m/s", "Lambda", "", true, true, {}};
  const std::vector<double> speeds = logarithmic(0.1, 100.0);
  for (const double T : temperatures) {
    const std::string name = fmt::format("{:.0f} K", T);
    NamedCurve viscosity{name, {}, {}}, film{name, speeds, {}}, lambda{name, speeds, {}};
    for (int i = 0; i < kPoints; ++i) {
      const double p = 1e-9 * kLargestPressure * i / (kPoints - 1);
      viscosity.x.push_back(p);
      viscosity.y.push_back(oil.viscosity_under_pressure(1e9 * p, T));
    }
    LubricantContact c = contact;
    c.temperature = T;
    const Point point(c);
    for (const double u : speeds) {
      const tribology::ContactFilm h = point.film(u, 0.0);
      constexpr double kFloor = 0.1;  // of the heating, reached without a corner
      out.beyond_heating = out.beyond_heating || h.thermal < kFloor + 1e-3;
      film.y.push_back(1e6 * h.central);
      lambda.y.push_back(contact.roughness > 0.0 ? h.minimum / contact.roughness : 0.0);
    }
    out.viscosity.curves.push_back(std::move(viscosity));
    out.film.curves.push_back(std::move(film));
    out.lambda.curves.push_back(std::move(lambda));
  }
  return out;
}

std::vector<Adapter> lubricant_adapters() { return {{"lubricant_traction", traction_case}}; }

}  // namespace adore::calculators
