#include "statics/friction.hpp"

#include "bearing/material.hpp"
#include "contact/groove.hpp"
#include "contact/roller_shape.hpp"
#include "statics/ball_statics.hpp"
#include "statics/kinematics.hpp"
#include "statics/roller_statics.hpp"
#include "tribology/contact_film.hpp"
#include "tribology/ellipse_traction.hpp"
#include "tribology/film_law.hpp"
#include "tribology/traction_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <optional>

namespace adore::statics {
namespace {

using bearing::Bearing;
using tribology::EllipseGeometry;
using tribology::EllipseKinematics;

constexpr double kStraight = 1e6;  ///< radius of a surface without curvature [m]

/// The root of an increasing function between two bounds by regula falsi with halving (Illinois).
template <class F>
double root_between(const F& f, double low, double high) {
  double at_low = f(low), at_high = f(high);
  if (at_low >= 0.0) return low;
  if (at_high <= 0.0) return high;
  double x = 0.5 * (low + high);
  for (int n = 0; n < 60; ++n) {
    x = (low * at_high - high * at_low) / (at_high - at_low);
    const double y = f(x);
    if (y == 0.0) break;
    if (y < 0.0) {
      low = x;
      at_low = y;
      at_high *= 0.5;
    } else {
      high = x;
      at_high = y;
      at_low *= 0.5;
    }
    if (high - low <= 1e-12 * (std::abs(low) + std::abs(high))) break;
  }
  return x;
}

/// Traction of an ellipse that creeps freely.
tribology::EllipseTraction free_traction(const tribology::TractionLaw& law,
                                         const EllipseGeometry& g, EllipseKinematics m,
                                         const tribology::EllipseRule& rule) {
  // u_t of a surface point is u + range; no creep beyond it leaves force in one direction only.
  const double middle = m.W_c * g.height(0.0), edge = m.W_c * g.height(g.a);
  const double spin = std::abs(m.W_n) * g.a;
  const double low = std::min(middle, edge) - spin, high = std::max(middle, edge) + spin;
  if (!(high > low)) return {};
  m.u_t = root_between(
      [&](double u) {
        m.u_t = u;
        return tribology::ellipse_traction(law, g, m, rule).F_t;
      },
      low, high);
  return tribology::ellipse_traction(law, g, m, rule);
}

/// Does the film alone carry the traction of a contact (no metal contact)?
bool is_film(const tribology::TractionLaw& law, const tribology::FilmContact& film) {
  tribology::ContactPoint<double> point;
  point.load = film.load;
  point.peak_pressure = film.peak_pressure;
  point.half_major = film.k * film.half_width;
  point.half_minor = film.half_width;
  point.entrainment = film.speed;
  point.curvature = 1.0 / film.radius;
  return law.has_film() && law.film(point).thinnest > 0.0 && law.film(point).share >= 1.0;
}

/// What a lubricant's law needs that all contacts of a race share.
class Oil {
 public:
  explicit Oil(const Bearing& bearing) : bearing_(bearing) {
    if (!bearing.lubrication) return;
    oil_ = tribology::lubricant_of(*bearing.lubrication);
    for (std::size_t j = 0; j < 2; ++j) {
      temperature_[j] = 0.5 * (bearing.race_temperature[j] + bearing.element_temperature);
      modulus_[j] =
          2.0 * bearing::contact_modulus(bearing.element_material, bearing.race_material[j]);
      tribology::FilmSurface surface;
      surface.radius = 0.5 * bearing.element_diameter();  // contacts say theirs
      surface.modulus = modulus_[j];
      surface.wall_temperature = temperature_[j];
      for (const bool line : {false, true}) {
        surface.line = line;
        rolling_[j][line ? 1 : 0] =
            tribology::rolling_resistance(*oil_, *bearing.lubrication, surface);
      }
    }
  }
  [[nodiscard]] bool given() const { return oil_.has_value(); }
  /// Of contacts with one race. Visco-elastic films take the first one's shape for all of a race:
  /// their surfaces take the better part of a second to make. @param width_over_pressure b/p0
  /// [m/Pa]
  [[nodiscard]] tribology::TractionLaw law(std::size_t j, bool line, double radius,
                                           double width_over_pressure, double race_speed) const {
    if (!given()) return bearing_.race_traction;
    std::optional<tribology::TractionLaw>& kept = kept_[j];
    if (kept && oil_->model == tribology::LubricantModel::ViscoElastic) return *kept;
    tribology::FilmSurface surface;
    surface.line = line;
    surface.radius = radius;
    surface.modulus = modulus_[j];
    surface.wall_temperature = temperature_[j];
    surface.race_speed = std::max(race_speed, 1e-6);
    surface.width_over_pressure = width_over_pressure;
    surface.walls = {tribology::film_wall(bearing_.race_material[j]),
                     tribology::film_wall(bearing_.element_material)};
    kept = tribology::film_law(bearing_.race_traction, *oil_, *bearing_.lubrication, surface);
    return *kept;
  }
  /// κ of slip and peak pressure of a slice of a line, with the film of the whole line.
  [[nodiscard]] std::function<double(double, double)> line_law(
      const tribology::TractionLaw& law, const tribology::FilmContact& contact) const {
    tribology::ContactPoint<double> point;
    point.load = contact.load;
    point.peak_pressure = contact.peak_pressure;
    point.half_minor = contact.half_width;
    point.entrainment = contact.speed;
    point.curvature = 1.0 / contact.radius;
    // A film points into its law, which therefore stays with the function.
    const auto kept = std::make_shared<const tribology::TractionLaw>(law);
    return kept->visit([&](const auto& one) -> std::function<double(double, double)> {
      if constexpr (tribology::kHasFilm<std::decay_t<decltype(one)>>) {
        return [here = one.at(point), kept](double slip, double pressure) {
          return here.strip(pressure)(slip);
        };
      } else {
        return [kept](double slip, double) { return kept->coefficient(slip); };
      }
    });
  }
  /// Power of the oil in the inlet; of lines over their length.
  [[nodiscard]] double rolling(std::size_t j, const tribology::FilmContact& contact,
                               double length) const {
    if (!oil_ || !(bearing_.lubrication->meniscus > 0.0)) return 0.0;
    if (!(contact.load > 0.0) || contact.speed == 0.0) return 0.0;
    tribology::ContactPoint<double> point;
    point.load = contact.load;
    point.peak_pressure = contact.peak_pressure;
    point.half_major = contact.k * contact.half_width;
    point.half_minor = contact.half_width;
    point.entrainment = contact.speed;
    point.curvature = 1.0 / contact.radius;
    const double force = rolling_[j][contact.line ? 1 : 0].force(point);
    return 2.0 * force * contact.speed * (contact.line ? length : 1.0);
  }
  /// The same of a point contact whose strips along rolling resist as lines do, each under its own
  /// load, pressure and width: (3 Q/4a)(1 - y²), p √(1 - y²), b √(1 - y²).
  [[nodiscard]] double rolling_of_strips(std::size_t j,
                                         const tribology::FilmContact& contact) const {
    if (!oil_ || !(contact.load > 0.0) || contact.speed == 0.0) return 0.0;
    constexpr int kStrips = 40;
    const double a = contact.k * contact.half_width;
    double sum = 0.0;
    for (int i = 0; i < kStrips; ++i) {
      const double y = (2.0 * i + 1.0) / kStrips - 1.0, chord2 = 1.0 - y * y;
      tribology::FilmContact strip = contact;
      strip.line = true;
      strip.load = 0.75 * contact.load / a * chord2;
      strip.peak_pressure = contact.peak_pressure * std::sqrt(chord2);
      strip.half_width = contact.half_width * std::sqrt(chord2);
      sum += rolling(j, strip, 2.0 * a / kStrips);
    }
    return sum;
  }
  [[nodiscard]] const std::string& name() const { return oil_->name; }

 private:
  const Bearing& bearing_;
  std::optional<tribology::Lubricant> oil_;
  std::array<std::array<tribology::RollingResistance, 2>, 2> rolling_;  ///< of points, of lines
  std::array<double, 2> temperature_{}, modulus_{};
  mutable std::array<std::optional<tribology::TractionLaw>, 2> kept_;
};

/// What films read of a loaded contact of a ball.
tribology::FilmContact film_of(const Bearing& bearing, const StaticBall& ball, std::size_t j) {
  const bearing::BallGeometry& balls = bearing.balls();
  const double side = j == 0 ? 1.0 : -1.0;
  tribology::FilmContact film;
  film.load = ball.Q[j];
  film.radius =
      1.0 /
      contact::race_curvature(balls, static_cast<int>(j), std::abs(ball.alpha[j])).along_minor;
  film.k = ball.a[j] / ball.b[j];
  film.half_width = ball.b[j];
  film.peak_pressure = ball.p_max[j];
  film.speed = (bearing.speed[j] - ball.orbital_speed) *
               (ball.r + side * 0.5 * balls.diameter * std::cos(ball.alpha[j]));
  return film;
}

FrictionEstimate begin(const Bearing& bearing, const Oil& oil) {
  FrictionEstimate out;
  out.speed = std::abs(bearing.speed[1] - bearing.speed[0]);
  const auto acts = [](const bearing::TractionCurve& of) {
    return tribology::largest_traction(of) > 0.0;
  };
  out.resists = acts(bearing.race_traction) || bearing.churning ||
                (bearing.flange_traction && acts(*bearing.flange_traction));
  const std::string curve = fmt::format("the curve of record 10.1, {:.4g} at most",
                                        tribology::largest_traction(bearing.race_traction));
  out.oil = oil.given();
  if (out.oil) {
    out.law = fmt::format("film of {}, below the critical film {}", oil.name(), curve);
  } else {
    out.law = curve;
  }
  if (bearing.cage)
    out.notes.emplace_back(
        "friction of the cage in pockets and at lands is not in these figures: its loads follow "
        "from the motion (mode 0 to 2)");
  return out;
}

void add_drag(const Bearing& bearing, double orbit, double spin, FrictionEstimate& out) {
  if (!bearing.churning) return;
  const tribology::BearingDrag drag(bearing);
  const tribology::DragPower power = tribology::drag_power(drag, bearing, orbit, spin, orbit);
  out.element_drag = power.elements;
  out.cage_drag = power.cage;
  out.medium = drag.medium().name;
  out.medium_provenance = drag.medium().provenance;
}

}  // namespace

FrictionOfContact FrictionEstimate::of_race(int j) const noexcept {
  FrictionOfContact sum;
  for (const FrictionOfContact& one : race[static_cast<std::size_t>(j)]) {
    sum.spin += one.spin;
    sum.sliding += one.sliding;
    sum.rolling += one.rolling;
  }
  return sum;
}

double FrictionEstimate::power() const noexcept {
  return of_race(0).total() + of_race(1).total() + flange[0] + flange[1] + drag();
}

std::string FrictionEstimate::why_none() const {
  if (!(speed > 0.0)) return "the races do not turn against each other";
  if (resists || power() > 0.0) return {};
  return "nothing in the deck resists: the curves of record 10 are 0, no film carries, no medium "
         "drags";
}

FrictionEstimate friction_estimate(const Bearing& bearing, const StaticSolution& solution) {
  const Oil oil(bearing);
  FrictionEstimate out = begin(bearing, oil);
  const bearing::BallGeometry& balls = bearing.balls();
  const double R = 0.5 * balls.diameter;
  const tribology::EllipseRule rule = tribology::make_split_ellipse_rule(30, 8);
  const double race_speed =
      0.5 * balls.pitch_diameter * std::max(std::abs(bearing.speed[0]), std::abs(bearing.speed[1]));
  double orbit = 0.0, spin = 0.0;
  for (const StaticBall& ball : solution.balls) {
    const auto share = 1.0 / static_cast<double>(solution.balls.size());
    orbit += share * ball.orbital_speed;
    spin += share * std::hypot(ball.omega_x - bearing.speed[0], ball.omega_r);
    for (std::size_t j = 0; j < 2; ++j) {
      FrictionOfContact& one = out.race[j].emplace_back();
      if (!(ball.Q[j] > 0.0)) continue;
      const double alpha = ball.alpha[j];
      const double groove = 2.0 * balls.groove_factor[j] * R;
      EllipseGeometry g{ball.Q[j], ball.a[j], ball.b[j], 0.0, 0.0};
      tribology::set_contact_surface(g, tribology::ContactSurface::CurvedEdge, R, groove,
                                     ball.delta[j]);
      // n from the ball into the race, c = e_θ × n; W: race less ball, (x, r).
      const double side = j == 0 ? 1.0 : -1.0;
      const double n_x = side * std::sin(alpha), n_r = side * std::cos(alpha);
      const double W_x = bearing.speed[j] - ball.omega_x, W_r = -ball.omega_r;
      EllipseKinematics m{};
      m.W_n = W_x * n_x + W_r * n_r;
      m.W_c = -W_x * n_r + W_r * n_x;
      const tribology::FilmContact film = film_of(bearing, ball, j);
      m.entrainment = film.speed;
      const tribology::TractionLaw law =
          oil.law(j, false, film.radius, ball.b[j] / ball.p_max[j], race_speed);
      const tribology::EllipseTraction traction = free_traction(law, g, m, rule);
      const double all = traction.heat;
      one.load_slip = traction.load_slip;
      one.of_oil = is_film(law, film);
      EllipseGeometry flat = g;
      flat.rho = 0.0;
      one.spin = std::min(free_traction(law, flat, m, rule).heat, all);
      one.sliding = all - one.spin;
      one.rolling = oil.rolling(j, film, 0.0);
    }
  }
  add_drag(bearing, orbit, spin, out);
  return out;
}

double rolling_over_strips(const Bearing& bearing, const StaticSolution& solution) {
  const Oil oil(bearing);
  double points = 0.0, strips = 0.0;
  for (const StaticBall& ball : solution.balls)
    for (std::size_t j = 0; j < 2; ++j) {
      if (!(ball.Q[j] > 0.0)) continue;
      const tribology::FilmContact film = film_of(bearing, ball, j);
      points += oil.rolling(j, film, 0.0);
      strips += oil.rolling_of_strips(j, film);
    }
  return strips > 0.0 ? points / strips : 0.0;
}

double rolling_excess(double over_strips) {
  constexpr double kShare = 0.35;
  return std::pow(std::max(over_strips, 1.0), kShare);
}

FrictionEstimate friction_estimate(const Bearing& bearing, const RollerSolution& solution) {
  const Oil oil(bearing);
  FrictionEstimate out = begin(bearing, oil);
  const bearing::RollerGeometry& rollers = *bearing.rollers();
  const double R = 0.5 * rollers.diameter;
  const double race_speed = 0.5 * rollers.pitch_diameter *
                            std::max(std::abs(bearing.speed[0]), std::abs(bearing.speed[1]));
  // About the roller axis and in the orbiting frame; signs as for balls: against the outer race.
  const double orbit = solution.orbital_speed;
  const double axis_r = std::sin(-rollers.axis_angle), axis_x = std::cos(rollers.axis_angle);
  for (std::size_t i = 0; i < solution.rollers.size(); ++i) {
    const StaticRoller& roller = solution.rollers[i];
    for (std::size_t j = 0; j < 2; ++j) {
      FrictionOfContact& one = out.race[j].emplace_back();
      const RollerRaceContact& at = roller.race[j];
      if (!(at.load > 0.0) || !(at.length > 0.0)) continue;
      const double side = j == 0 ? 1.0 : -1.0;
      const double angle = rollers.race_angle[j];
      const double n_x = side * std::sin(angle), n_r = side * std::cos(angle);
      const double turn = bearing.speed[j] - orbit;  // of the race against the row
      const double u = turn * rollers.race_radius(static_cast<int>(j));
      // Rolling: the roller turns about its axis with the surface speed of the race.
      const double spin = side * u / R;
      const double W_x = turn - spin * axis_x, W_r = -spin * axis_r;
      EllipseKinematics m{};
      m.W_n = W_x * n_x + W_r * n_r;
      m.W_c = -W_x * n_r + W_r * n_x;
      m.entrainment = u;
      const double groove = rollers.groove_factor[j] > 0.0
                                ? 2.0 * rollers.groove_factor[j] * rollers.crown_radius
                                : kStraight;
      const contact::RollerRaceCurvature curvature = contact::roller_race_curvature(
          rollers, contact::roller_profile(rollers, rollers.deviation_of(i)), static_cast<int>(j),
          rollers.groove_factor[j] > 0.0 ? groove : std::numeric_limits<double>::infinity());
      const double k = at.half_width > 0.0 ? 0.5 * at.length / at.half_width : 1.0;
      const bool line = !at.slice_load.empty();
      tribology::FilmContact film;
      film.line = line;
      film.load = line ? at.load / at.length : at.load;
      film.radius = 1.0 / curvature.rolling;
      film.k = k;
      film.half_width = at.half_width;
      film.peak_pressure = at.peak_pressure;
      film.speed = u;
      const tribology::TractionLaw law = oil.law(
          j, line, film.radius, at.half_width / std::max(at.peak_pressure, 1.0), race_speed);
      const auto slice_law = oil.line_law(law, film);
      EllipseGeometry g{at.load, 0.5 * at.length, at.half_width, 0.0, R};
      const double crown = std::min(rollers.crown_radius, kStraight);
      g.rho = tribology::surface_radius(crown, groove);
      if (!(g.rho > g.a)) g.rho = 0.0;
      const auto heat_of = [&](const EllipseGeometry& surface) {
        if (!line) {
          const tribology::EllipseTraction traction =
              free_traction(law, surface, m, tribology::make_split_ellipse_rule(30, 8));
          one.load_slip = traction.load_slip;
          return traction.heat;
        }
        const auto sum = [&](double creep, bool heat) {
          double total = 0.0;
          one.load_slip = 0.0;
          for (std::size_t s = 0; s < at.slice_load.size(); ++s) {
            if (!(at.slice_load[s] > 0.0)) continue;
            const double xi = solution.slice_position[s];
            if (surface.rho > 0.0 && std::abs(xi) >= surface.rho) continue;
            const double slip = creep + m.W_n * xi - m.W_c * surface.height(xi);
            const double kappa = slice_law(std::abs(slip), at.slice_pressure[s]);
            // A start of the law with friction at rest is rounded over a small slip.
            const double rounded = std::hypot(slip, std::sqrt(law.slip_floor()));
            total += at.slice_load[s] * kappa * (heat ? slip * slip : slip) / rounded;
            one.load_slip += at.slice_load[s] * std::abs(slip);
          }
          return total;
        };
        const double reach = std::abs(m.W_n) * g.a + std::abs(m.W_c) * R * 2.0;
        const double creep = root_between([&](double c) { return sum(c, false); }, -reach, reach);
        return sum(creep, true);
      };
      EllipseGeometry flat = g;
      flat.rho = 0.0;
      const double flat_heat = heat_of(flat);
      const double all = heat_of(g);  // last: it leaves the load x slip of the contact
      one.spin = std::min(flat_heat, all);
      one.of_oil = is_film(law, film);
      one.sliding = all - one.spin;
      one.rolling = oil.rolling(j, film, at.length);
      for (std::size_t at_end = 0; at_end < 2; ++at_end) {
        const RollerFlangeContact& flange = roller.flange[j][at_end];
        if (!bearing.flange_traction || !flange.present || !(flange.load > 0.0) ||
            !std::isfinite(flange.radius))
          continue;
        // The contact from the bearing axis: up the inclined roller axis to its end, then across.
        const double end = (at_end == 0 ? -0.5 : 0.5) * rollers.length;
        const double from_bearing_axis =
            roller.r + end * std::sin(roller.tilt) + side * flange.radius * std::cos(roller.tilt);
        const double slip = std::abs(turn * from_bearing_axis - side * spin * flange.radius);
        out.flange[j] +=
            flange.load * slip * tribology::TractionLaw(*bearing.flange_traction).coefficient(slip);
      }
    }
  }
  add_drag(bearing, orbit, std::abs(solution.spin_speed), out);
  return out;
}

}  // namespace adore::statics
