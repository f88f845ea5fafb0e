#include "runs/law_ranges.hpp"

#include "bearing/material.hpp"
#include "bearing/material_laws.hpp"
#include "contact/groove.hpp"
#include "contact/roller_shape.hpp"
#include "contact/slice_contact.hpp"
#include "life/contact_strength.hpp"
#include "tribology/lubricant_range.hpp"
#include "tribology/thermal_reduction.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace adore::runs {
namespace {

/// Friction coefficients, ∫κ p u dA over ∫p u dA of a contact, weighted by load × slip, over all
/// instants that were looked at.
struct CoefficientUse {
  double slip_power = 0.0;  ///< Σ load × slip of all contacts [W]
  /// Of it at coefficients of oil films above traction.coefficient and above traction.impossible.
  double above_warning = 0.0, above_limit = 0.0;
};

using bearing::Bearing;
using validity::Bounds;
using validity::kNoBound;
using validity::Range;

constexpr std::array<const char*, 2> kRace{"outer race", "inner race"};
/// Contacts whose films, and rollers whose skew is judged, over the heaviest load of the instant.
constexpr double kLoadedShare = 0.1;
/// Share of load × slip from which a coefficient is judged.
constexpr double kJudgedShare = 0.01;

/// Ranges by name, looked up once.
struct Ranges {
  const Range &film_thickness = validity::range("film.thickness"),
              &film_viscosity = validity::range("film.viscosity"),
              &film_speed = validity::range("film.speed"),
              &film_load = validity::range("film.load"),
              &film_material = validity::range("film.material"),
              &film_ellipticity = validity::range("film.ellipticity"),
              &film_heating = validity::range("film.heating"),
              &pressure = validity::range("traction.pressure"),
              &unmeasured = validity::range("traction.unmeasured"),
              &oil_temperature = validity::range("traction.temperature"),
              &coefficient = validity::range("traction.coefficient"),
              &impossible = validity::range("traction.impossible"),
              &medium = validity::range("drag.temperature"),
              &reynolds = validity::range("drag.reynolds"), &spin = validity::range("drag.spin"),
              &taylor = validity::range("hydro.taylor"),
              &land_length = validity::range("hydro.length"),
              &ellipse = validity::range("hertz.ellipse"), &width = validity::range("hertz.width"),
              &shoulder = validity::range("hertz.shoulder"),
              &yield = validity::range("hertz.yield"), &skew = validity::range("guidance.skew"),
              &strips = validity::range("rolling.strips"),
              &groove = validity::range("conformity.groove"),
              &material = validity::range("materials.temperature"),
              &tempering = validity::range("materials.tempering"),
              &life_pressure = validity::range("life.pressure"),
              &life_load = validity::range("life.load");
};
const Ranges& registered() {
  static const Ranges kRanges;
  return kRanges;
}

/// One loaded contact of an element and a race, SI.
struct Contact {
  std::size_t race = 0, element = 0;
  double load = 0.0, length = 0.0;  ///< length of a line; 0: a point
  double peak = 0.0, half_major = 0.0, half_minor = 0.0;
  double beyond = 0.0;                 ///< of the ellipse over the shoulder; <= 0: none
  double radius = 0.0;                 ///< of both bodies along rolling
  double film = 0.0, speed = 0.0;      ///< in the middle; of both surfaces. 0: no film
  double heat = 0.0, load_slip = 0.0;  ///< [W]; 0: not known
  bool of_oil = false;                 ///< its coefficient is that of the oil's film
};

}  // namespace

struct LawValidityMonitor::Impl {
  const Bearing& bearing;
  const std::string element;
  validity::RangeMonitor watch, coefficients;
  life::MaxPressureContacts peaks{};  ///< of all instants
  std::array<double, 2> peak_time{kNoBound, kNoBound};
  CoefficientUse use;
  /// Of other watches and of the motion that this one continues.
  std::vector<validity::Finding> others;
  double given_largest = 0.0, given_time = kNoBound;
  std::string given_body;

  std::optional<tribology::Lubricant> oil;
  std::array<tribology::InletOil, 2> inlet;
  std::array<double, 2> oil_temperature{}, modulus{}, radius{};
  std::optional<tribology::ChurningMedium> medium;
  Bounds measured;
  std::string measured_from;

  explicit Impl(const Bearing& b) : bearing(b), element(b.rollers() ? "roller" : "ball") {
    follow();
    geometry();
  }

  void follow();
  void geometry();
  void temperatures(double time);
  void contact(const Contact& c, double heaviest, double time);
  /// A contact of the quasi-static solution.
  template <class Solution>
  void equilibrium(Contact c, const Solution& solution, const statics::FrictionEstimate* friction,
                   double heaviest) {
    if (solution.films) {
      const auto& film = solution.films->race[c.race][c.element];
      c.film = film.film.central;
      c.speed = film.speed;
    }
    contact(c, heaviest, kNoBound);
    if (friction == nullptr) return;
    const statics::FrictionOfContact& at = friction->race[c.race][c.element];
    coefficient(at.spin + at.sliding, at.load_slip, at.of_oil, kNoBound, [&] { return body(c); });
  }
  void yields(validity::RangeMonitor& out) const;
  /// @param body callable -> name of the contact, called where it is kept
  template <class Name>
  void coefficient(double heat, double load_slip, bool of_oil, double time, const Name& body);
  void drag(double orbit, double r, double spin, std::size_t i, double time);
  void land(const scene::Snapshot& at);
  [[nodiscard]] std::string body(const Contact& c) const {
    return fmt::format("{} {}, {}", element, c.element + 1, kRace[c.race]);
  }
};

void LawValidityMonitor::Impl::follow() {
  if (bearing.lubrication && !oil) {
    oil = tribology::lubricant_of(*bearing.lubrication);
    if (!bearing.lubrication->user) {
      const tribology::PressureRange& range = tribology::pressure_range(bearing.lubrication->code);
      if (range.measured_to) measured.most = *range.measured_to;
      measured_from = range.measured_to ? oil->name + ", " + range.provenance : range.source;
    }
  }
  for (std::size_t j = 0; j < 2; ++j) {
    oil_temperature[j] = 0.5 * (bearing.race_temperature[j] + bearing.element_temperature);
    if (oil)
      inlet[j] = tribology::inlet_oil(*oil, oil_temperature[j], bearing.lubrication->meniscus);
    modulus[j] = 2.0 * bearing::contact_modulus(bearing.element_material, bearing.race_material[j]);
    if (const bearing::RollerGeometry* g = bearing.rollers())
      radius[j] =
          1.0 / contact::roller_race_curvature(*g, contact::roller_profile(*g, g->deviation_of(0)),
                                               static_cast<int>(j), g->race_profile_radius(j))
                    .rolling;
  }
  if (bearing.churning) medium = tribology::churning_medium(bearing);
}

void LawValidityMonitor::Impl::geometry() {
  if (!bearing.rollers())
    for (std::size_t j = 0; j < 2; ++j)
      watch.offer(registered().groove, bearing.balls().groove_factor[j], kNoBound,
                  [&] { return std::string(kRace[j]); });
}

void LawValidityMonitor::Impl::temperatures(double time) {
  const Ranges& r = registered();
  if (oil)
    for (std::size_t j = 0; j < 2; ++j) {
      const auto place = [&] { return fmt::format("inlet of the {}", kRace[j]); };
      watch.offer(r.oil_temperature, oil_temperature[j], time, place, std::nullopt, oil->name);
      if (bearing.lubrication->meniscus > 0.0)
        watch.offer(r.film_viscosity, inlet[j].viscosity, time, place, std::nullopt, oil->name);
    }
  if (medium && medium->T_max > 0.0)
    watch.offer(
        r.medium, medium->temperature, time, [] { return std::string("medium"); },
        Bounds{medium->T_min, medium->T_max}, medium->name);
  struct Part {
    const bearing::Material& material;
    double T;
    const char* name;
    bool hard;
  };
  const Part parts[] = {
      {bearing.race_material[0], bearing.race_temperature[0], kRace[0], true},
      {bearing.race_material[1], bearing.race_temperature[1], kRace[1], true},
      {bearing.element_material, bearing.element_temperature, "rolling elements", true},
      {bearing.mounting.housing, bearing.mounting.housing_temperature, "housing", false},
      {bearing.mounting.shaft, bearing.mounting.shaft_temperature, "shaft", false}};
  for (const Part& part : parts) {
    const auto name = [&] { return std::string(part.name); };
    constexpr const char* kSteel = "100";  // 52100 in materials.json
    if (part.hard && part.material.table_key == kSteel)
      watch.offer(r.tempering, part.T, time, name);
    if (!bearing.mounting.material_laws) continue;
    for (const bearing::ClampedLaw& law : bearing::clamped_laws(part.material, part.T))
      watch.offer(r.material, part.T, time, name, Bounds{law.T_min, law.T_max},
                  fmt::format("{} of {}", law.property, part.material.name));
  }
}

void LawValidityMonitor::Impl::contact(const Contact& c, double heaviest, double time) {
  const Ranges& r = registered();
  const auto name = [&] { return body(c); };
  const double half = 0.5 * bearing.element_diameter();
  if (c.length > 0.0)
    watch.offer(r.width, c.half_minor / half, time, name);
  else {
    watch.offer(r.ellipse, c.half_major / half, time, name);
    watch.offer(r.shoulder, c.beyond, time, name);
  }
  if (life::MaxPressureContact& most = peaks[c.race]; c.peak > most.pressure) {
    most = {static_cast<int>(c.element) + 1, c.peak,
            c.length > 0.0 ? 0.0 : c.half_minor / c.half_major};
    peak_time[c.race] = time;
  }
  watch.offer(r.life_pressure, c.peak, time, name);
  if (oil && !bearing.lubrication->user) {
    if (std::isnan(measured.most))
      watch.offer(r.unmeasured, c.peak, time, name, std::nullopt, measured_from);
    else
      watch.offer(r.pressure, c.peak, time, name, measured, measured_from);
  }
  if (!oil || !(c.film > 0.0) || c.load < kLoadedShare * heaviest) return;
  const std::size_t j = c.race;
  const double u = std::abs(c.speed), E = modulus[j], R = c.radius;
  watch.offer(r.film_thickness, c.film / R, time, name);
  watch.offer(r.film_material, inlet[j].alpha * E, time, name, std::nullopt, oil->name);
  watch.offer(r.film_heating,
              tribology::thermal_loading(inlet[j].viscosity, oil->base_beta(oil_temperature[j]), u,
                                         oil->conductivity.at(oil_temperature[j])),
              time, name);
  if (c.length > 0.0) return;  // the other bounds are those of points
  watch.offer(r.film_speed, inlet[j].viscosity * u / (E * R), time, name);
  watch.offer(r.film_load, c.load / (E * R * R), time, name);
  watch.offer(r.film_ellipticity, c.half_major / c.half_minor, time, name);
}

void LawValidityMonitor::Impl::yields(validity::RangeMonitor& out) const {
  const life::RaceStrength strength = life::contact_strength(bearing, peaks);
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t body = 0; body < 2; ++body) {
      const life::ContactStrength& one = strength[j][body];
      if (one.element == 0 || !(one.elastic_limit > 0.0)) continue;
      out.offer(registered().yield, one.von_mises / one.elastic_limit, peak_time[j], [&] {
        return body == 0 ? fmt::format("{}, {} {}", kRace[j], element, one.element)
                         : fmt::format("{} {}, {}", element, one.element, kRace[j]);
      });
    }
}

template <class Name>
void LawValidityMonitor::Impl::coefficient(double heat, double load_slip, bool of_oil, double time,
                                           const Name& at) {
  if (!(load_slip > 0.0)) return;
  const Ranges& r = registered();
  const double kappa = heat / load_slip;
  use.slip_power += load_slip;
  if (!of_oil) {
    if (kappa > given_largest) {
      given_largest = kappa;
      given_time = time;
      given_body = at();
    }
    return;
  }
  if (r.coefficient.bounds.contains(kappa)) return;
  use.above_warning += load_slip;
  coefficients.offer(r.coefficient, kappa, time, at);
  if (r.impossible.bounds.contains(kappa)) return;
  use.above_limit += load_slip;
  coefficients.offer(r.impossible, kappa, time, at);
}

void LawValidityMonitor::Impl::drag(double orbit, double r, double spin, std::size_t i,
                                    double time) {
  if (!medium) return;
  const tribology::Medium& m = medium->medium;
  const double D = bearing.element_diameter(), nu = m.viscosity / m.density;
  const auto name = [&] { return fmt::format("{} {}", element, i + 1); };
  watch.offer(registered().reynolds, std::abs(orbit - bearing.speed[0]) * r * D / nu, time, name);
  if (!bearing.rollers())
    watch.offer(registered().spin, std::abs(spin) * 0.25 * D * D / nu, time, name);
}

void LawValidityMonitor::Impl::land(const scene::Snapshot& at) {
  if (!bearing.cage || !bearing.cage_films || !bearing.cage_films->lands) return;
  const bearing::Cage& cage = *bearing.cage;
  const double T = bearing.cage_temperature;
  const double given = bearing.cage_films->land_viscosity;
  const double mu = given > 0.0 ? given : oil ? oil->base_viscosity(T) : 0.0;
  const double rho = oil ? oil->density.at(T) : 0.0;
  if (at.cages.empty()) return;
  for (std::size_t i = 0; i < cage.lands.size(); ++i) {
    const bearing::GuideLand& land = cage.lands[i];
    if (land.guide == bearing::GuideLand::Guide::None) continue;
    const std::size_t j = land.guide == bearing::GuideLand::Guide::Outer ? 0 : 1;
    const auto name = [&] { return fmt::format("guide land {}", i + 1); };
    const double R = 0.5 * land.diameter, c = 0.5 * land.clearance;
    watch.offer(registered().land_length, land.width / land.diameter, at.time, name);
    const double v = std::abs(at.cages[0].omega.x() - at.races[j].omega.x()) * R;
    if (mu > 0.0 && rho > 0.0 && c > 0.0)
      watch.offer(registered().taylor, rho * v * c / mu * std::sqrt(c / R), at.time, name);
  }
}

LawValidityMonitor::LawValidityMonitor(const Bearing& bearing)
    : impl_(std::make_unique<Impl>(bearing)) {}
LawValidityMonitor::~LawValidityMonitor() = default;
LawValidityMonitor::LawValidityMonitor(LawValidityMonitor&&) noexcept = default;

void LawValidityMonitor::update_bearing() { impl_->follow(); }

void LawValidityMonitor::check(const scene::Snapshot& at) {
  Impl& s = *impl_;
  const bool rollers = s.bearing.rollers() != nullptr;
  const double critical = s.oil ? s.bearing.lubrication->critical_film : 0.0;
  s.temperatures(at.time);
  double heaviest = 0.0;
  for (const scene::ElementSnapshot& one : at.elements)
    for (const scene::RaceContactSnapshot& c : one.race) heaviest = std::max(heaviest, c.load);
  for (std::size_t i = 0; i < at.elements.size(); ++i) {
    const scene::ElementSnapshot& one = at.elements[i];
    for (std::size_t j = 0; j < 2; ++j) {
      const scene::RaceContactSnapshot& in = one.race[j];
      if (!(in.load > 0.0)) continue;
      Contact c;
      c.race = j;
      c.element = i;
      c.load = in.load;
      c.length = rollers ? 2.0 * in.half_major : 0.0;
      c.peak = in.max_pressure;
      c.half_major = in.half_major;
      c.half_minor = in.half_minor;
      c.radius = rollers ? s.radius[j]
                         : 1.0 / contact::race_curvature(s.bearing.balls(), static_cast<int>(j),
                                                         std::abs(in.angle))
                                     .along_minor;
      c.film = in.film;
      c.speed = in.rolling_speed;
      if (!rollers) c.beyond = -in.edge;
      s.contact(c, heaviest, at.time);
      constexpr double kMetalShare = 1.05;  // of the critical film: no metal contact (film_law_of)
      s.coefficient(in.heat, in.load_slip, s.oil && in.least_film > kMetalShare * critical, at.time,
                    [&] { return s.body(c); });
      for (const scene::FlangeContactSnapshot& flange : one.flange[j])
        s.coefficient(flange.heat, flange.load_slip, false, at.time,
                      [&] { return fmt::format("flange of the {}, roller {}", kRace[j], i + 1); });
    }
    if (rollers && one.oriented && one.race[1].load > 0.0 &&
        one.race[1].load >= kLoadedShare * heaviest)
      s.watch.offer(registered().skew, std::abs(contact::roller_skew(one.x_axis)), at.time,
                    [&] { return fmt::format("roller {}", i + 1); });
    s.drag(one.theta_dot, one.r,
           std::hypot(one.omega.x() - s.bearing.speed[0], one.omega.y(), one.omega.z()), i,
           at.time);
  }
  s.land(at);
}

void LawValidityMonitor::check(const statics::StaticSolution& solution,
                               const statics::FrictionEstimate* friction) {
  Impl& s = *impl_;
  s.temperatures(kNoBound);
  double heaviest = 0.0;
  for (const statics::StaticBall& ball : solution.balls)
    heaviest = std::max({heaviest, ball.Q[0], ball.Q[1]});
  for (std::size_t i = 0; i < solution.balls.size(); ++i) {
    const statics::StaticBall& ball = solution.balls[i];
    for (std::size_t j = 0; j < 2; ++j) {
      if (!(ball.Q[j] > 0.0)) continue;
      Contact c;
      c.race = j;
      c.element = i;
      c.load = ball.Q[j];
      c.peak = ball.p_max[j];
      c.half_major = ball.a[j];
      c.half_minor = ball.b[j];
      c.beyond = -ball.shoulder_depth[j];
      c.radius = 1.0 / contact::race_curvature(s.bearing.balls(), static_cast<int>(j),
                                               std::abs(ball.alpha[j]))
                           .along_minor;
      s.equilibrium(c, solution, friction, heaviest);
    }
    s.drag(ball.orbital_speed, ball.r, std::hypot(ball.omega_x - s.bearing.speed[0], ball.omega_r),
           i, kNoBound);
  }
  if (s.oil && solution.films)
    s.watch.offer(registered().strips, statics::rolling_point_strip_ratio(s.bearing, solution),
                  kNoBound, [] { return std::string("balls"); });
}

void LawValidityMonitor::check(const statics::RollerSolution& solution,
                               const statics::FrictionEstimate* friction) {
  Impl& s = *impl_;
  s.temperatures(kNoBound);
  double heaviest = 0.0;
  for (const statics::StaticRoller& roller : solution.rollers)
    for (const statics::RollerRaceContact& at : roller.race) heaviest = std::max(heaviest, at.load);
  for (std::size_t i = 0; i < solution.rollers.size(); ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      const statics::RollerRaceContact& at = solution.rollers[i].race[j];
      if (!(at.load > 0.0) || !(at.length > 0.0)) continue;
      Contact c;
      c.race = j;
      c.element = i;
      c.load = at.load;
      c.length = at.length;
      c.peak = at.peak_pressure;
      c.half_major = 0.5 * at.length;
      c.half_minor = at.half_width;
      c.radius = s.radius[j];
      s.equilibrium(c, solution, friction, heaviest);
    }
    s.drag(solution.orbital_speed, 0.5 * s.bearing.pitch_diameter(), 0.0, i, kNoBound);
  }
}

void LawValidityMonitor::check(const life::BearingLife& life) {
  if (!life.iso || !life.iso->equivalent || !(life.iso->C > 0.0)) return;
  impl_->watch.offer(registered().life_load, life.iso->equivalent->P / life.iso->C, kNoBound,
                     [] { return std::string("bearing"); });
}

std::vector<validity::Finding> LawValidityMonitor::findings() const {
  validity::RangeMonitor watch = impl_->watch;
  impl_->yields(watch);
  std::vector<validity::Finding> out = watch.findings();
  const CoefficientUse& use = impl_->use;
  for (const validity::Finding& found : impl_->coefficients.findings()) {
    const bool limit = found.range == &registered().impossible;
    const double above = limit ? use.above_limit : use.above_warning;
    if (above < kJudgedShare * use.slip_power) continue;
    if (!limit && use.above_limit >= kJudgedShare * use.slip_power) continue;  // said once
    validity::Finding one = found;
    one.detail = fmt::format(
        "contacts outside this range account for {:.2g} % of the sum of load times slip speed",
        100.0 * above / use.slip_power);
    out.push_back(std::move(one));
  }
  for (const validity::Finding& before : impl_->others) {
    const auto same = std::find_if(out.begin(), out.end(), [&](const validity::Finding& found) {
      return found.range == before.range;
    });
    if (same == out.end())
      out.push_back(before);
    else if (before.excess() > same->excess())
      *same = before;
  }
  return out;
}

void LawValidityMonitor::add(const validity::Finding& finding) { impl_->others.push_back(finding); }

void LawValidityMonitor::restore(const nlohmann::json& outside_validity) {
  for (const nlohmann::json& one : outside_validity) {
    const auto number = [&](const char* key) {
      const nlohmann::json& value = one.at(key);
      return value.is_number() ? value.get<double>() : kNoBound;
    };
    const std::string id = one.at("range");
    const auto known = validity::ranges();
    const auto range =
        std::find_if(known.begin(), known.end(), [&](const Range& r) { return r.id == id; });
    if (range == known.end() || std::isnan(number("time_s"))) continue;
    impl_->others.push_back({&*range,
                             number("value_si"),
                             {number("least_si"), number("most_si")},
                             one.at("body"),
                             number("time_s"),
                             1,
                             {}});
  }
}

std::optional<Finding> LawValidityMonitor::friction_coefficient_finding() const {
  const Impl& s = *impl_;
  const double most = registered().coefficient.bounds.most;
  if (!(s.given_largest > most)) return std::nullopt;
  const bool at_rest = std::isnan(s.given_time);
  Finding out = make_finding(
      "friction.coefficient",
      fmt::format("Largest friction coefficient from the deck or a user routine: {:.3g}, at {}{}.",
                  s.given_largest, s.given_body,
                  at_rest ? std::string(", quasi-static solution")
                          : fmt::format(", t = {:.6g} s", s.given_time)));
  out.of(s.given_body).measure(s.given_largest, most);
  if (!at_rest) out.at(s.given_time);
  return out;
}

std::vector<validity::Finding> without(std::vector<validity::Finding> findings,
                                       std::initializer_list<std::string_view> described) {
  std::erase_if(findings, [&](const validity::Finding& found) {
    return std::find(described.begin(), described.end(), found.range->id) != described.end();
  });
  return findings;
}

std::string untrusted(std::span<const validity::Finding> findings) {
  for (const validity::Finding& found : findings)
    if (found.range->grade == validity::ValidityGrade::Untrusted)
      return found.text() +
             " The results of this run cannot be trusted. Set filmStressLimit = on, or choose "
             "another lubricant or temperature.";
  return {};
}

nlohmann::ordered_json validity_json(std::span<const validity::Finding> findings) {
  nlohmann::ordered_json out = nlohmann::ordered_json::array();
  const auto bound = [](double value) {
    return std::isnan(value) ? nlohmann::ordered_json() : nlohmann::ordered_json(value);
  };
  for (const validity::Finding& found : findings)
    out.push_back({{"range", found.range->id},
                   {"law", found.range->law},
                   {"quantity", found.range->quantity},
                   {"value_si", found.value},
                   {"least_si", bound(found.bounds.least)},
                   {"most_si", bound(found.bounds.most)},
                   {"body", found.body},
                   {"time_s", bound(found.time)},
                   {"consequence", found.range->consequence},
                   {"source", found.range->source}});
  return out;
}

}  // namespace adore::runs
