#include "statics/friction.hpp"

#include "contact/roller_shape.hpp"
#include "statics/ball_friction.hpp"
#include "statics/contact_laws.hpp"
#include "statics/free_traction.hpp"
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
#include <string>
#include <utility>

namespace adore::statics {
namespace {

using bearing::Bearing;
using tribology::EllipseGeometry;
using tribology::EllipseKinematics;

constexpr double kFlatRadius = 1e6;  ///< radius of a surface without curvature [m]

/// Does the film alone carry the traction of a contact (no metal contact)?
bool is_film(const tribology::TractionLaw& law, const tribology::LubricatedContact& film) {
  tribology::ContactConditions<double> point;
  point.load = film.load;
  point.peak_pressure = film.peak_pressure;
  point.half_major = film.k * film.half_width;
  point.half_minor = film.half_width;
  point.entrainment = film.speed;
  point.curvature = 1.0 / film.radius;
  return law.has_film() && law.film(point).thinnest > 0.0 && law.film(point).share >= 1.0;
}

FrictionEstimate begin(const Bearing& bearing, const ContactLaws& oil) {
  FrictionEstimate out;
  out.speed = std::abs(bearing.speed[1] - bearing.speed[0]);
  const auto acts = [](const bearing::TractionCurve& of) {
    return tribology::max_traction_coefficient(of) > 0.0;
  };
  out.resists = acts(bearing.race_traction) || bearing.churning ||
                (bearing.flange_traction && acts(*bearing.flange_traction));
  const std::string curve = fmt::format("traction curve of record 10.1 (maximum {:.4g})",
                                        tribology::max_traction_coefficient(bearing.race_traction));
  out.oil = oil.given();
  if (out.oil) {
    out.law = fmt::format("film of {}; for films thinner than the critical thickness, {}",
                          oil.name(), curve);
  } else {
    out.law = curve;
  }
  if (bearing.cage)
    out.notes.emplace_back(
        "the friction of the cage in pockets and at lands is not included, because its loads need "
        "a dynamic run (mode 0 to 2)");
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
  if (!(speed > 0.0)) return "the races do not rotate relative to each other";
  if (resists || power() > 0.0) return {};
  return "the deck has no friction: the traction curves of record 10 are 0, and there is no film "
         "and no churning medium";
}

namespace {

/// Adds one contact; of a second contact with a split race (ball_at_second_contacts) to what the
/// first has.
void add_contact(const Bearing& bearing, const ContactLaws& oil, const tribology::EllipseRule& rule,
                 const StaticBall& ball, std::size_t j, const BallMotion& motion,
                 FrictionOfContact& one) {
  BallContact at = ball_contact(bearing, oil, ball, j);
  EllipseKinematics m = contact_kinematics(bearing, at, motion, ball.r, j);
  if (motion.balanced)
    at.film.speed = m.entrainment;
  else
    m.entrainment = at.film.speed;  // no slip at the centre: that of the race
  const auto traction = [&](const EllipseGeometry& surface, bool balanced) {
    if (balanced) return tribology::ellipse_traction(at.law, surface, m, rule);
    EllipseKinematics free = m;
    free.W_t = 0.0;
    return free_traction(at.law, surface, free, rule);
  };
  const tribology::EllipseTraction found = traction(at.ellipse, motion.balanced);
  one.load_slip += at.share * found.load_slip;
  one.of_oil = is_film(at.law, at.film);
  EllipseGeometry flat = at.ellipse;
  flat.rho = 0.0;
  const double spin = std::min(traction(flat, false).heat, found.heat);
  one.spin += at.share * spin;
  one.sliding += at.share * (found.heat - spin);
  one.rolling += at.share * oil.rolling(j, at.film, 0.0);
}

}  // namespace

FrictionEstimate friction_estimate(const Bearing& bearing, const StaticSolution& solution,
                                   const FrictionBalance& balance) {
  const ContactLaws oil(bearing);
  FrictionEstimate out = begin(bearing, oil);
  const tribology::EllipseRule rule = tribology::make_split_ellipse_rule(30, 8);
  double orbit = 0.0, spin = 0.0;
  for (std::size_t k = 0; k < solution.balls.size(); ++k) {
    const StaticBall& ball = solution.balls[k];
    const BallMotion motion = balance.motion_of(k, ball);
    const auto share = 1.0 / static_cast<double>(solution.balls.size());
    orbit += share * motion.orbit;
    spin += share * std::hypot(motion.omega[0] - bearing.speed[0], motion.omega[1]);
    for (std::size_t j = 0; j < 2; ++j) {
      FrictionOfContact& one = out.race[j].emplace_back();
      if (!(ball.Q[j] > 0.0)) continue;
      add_contact(bearing, oil, rule, ball, j, motion, one);
      if (ball.second[j].Q > 0.0)
        add_contact(bearing, oil, rule, ball_at_second_contacts(ball), j, motion, one);
    }
  }
  add_drag(bearing, orbit, spin, out);
  for (std::string& note : sentences_of(balance.findings())) out.notes.push_back(std::move(note));
  if (!balance.balls.empty() && balance.failure.empty() && balance.left.empty())
    out.notes.emplace_back(
        "ball speeds, spin axes, loads and heat are calculated from friction equilibrium; kAngVel "
        "is not used");
  return out;
}

double rolling_point_strip_ratio(const Bearing& bearing, const StaticSolution& solution) {
  const ContactLaws oil(bearing);
  double points = 0.0, strips = 0.0;
  for (const StaticBall& ball : solution.balls)
    for (std::size_t j = 0; j < 2; ++j) {
      if (!(ball.Q[j] > 0.0)) continue;
      const tribology::LubricatedContact film = film_contact_of(bearing, ball, j);
      points += ball.share[j] * oil.rolling(j, film, 0.0);
      strips += ball.share[j] * oil.rolling_power_of_strips(j, film);
    }
  return strips > 0.0 ? points / strips : 0.0;
}

double rolling_resistance_excess(double over_strips) {
  constexpr double kExcessExponent = 0.35;
  return std::pow(std::max(over_strips, 1.0), kExcessExponent);
}

FrictionEstimate friction_estimate(const Bearing& bearing, const RollerSolution& solution) {
  const ContactLaws oil(bearing);
  FrictionEstimate out = begin(bearing, oil);
  const bearing::RollerGeometry& rollers = *bearing.rollers();
  const double R = 0.5 * rollers.diameter;
  const double race_speed = 0.5 * rollers.pitch_diameter *
                            std::max(std::abs(bearing.speed[0]), std::abs(bearing.speed[1]));
  // About the roller axis and in the orbiting frame; signs as for balls: against the outer race.
  const double orbit = solution.orbital_speed;
  const double axis_r = std::sin(-rollers.axis_angle), axis_x = std::cos(rollers.axis_angle);
  double orbits = 0.0, spins = 0.0;
  for (std::size_t i = 0; i < solution.rollers.size(); ++i) {
    const StaticRoller& roller = solution.rollers[i];
    orbits += roller.balanced ? roller.orbital_speed : orbit;
    spins += std::abs(roller.balanced ? roller.spin_speed : solution.spin_speed);
    for (std::size_t j = 0; j < 2; ++j) {
      FrictionOfContact& one = out.race[j].emplace_back();
      if (roller.balanced) out.flange[j] += roller.heat.flange[j];
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
                                : kFlatRadius;
      const contact::RollerRaceCurvature curvature = contact::roller_race_curvature(
          rollers, contact::roller_profile(rollers, rollers.deviation_of(i)), static_cast<int>(j),
          rollers.groove_factor[j] > 0.0 ? groove : std::numeric_limits<double>::infinity());
      const double k = at.half_width > 0.0 ? 0.5 * at.length / at.half_width : 1.0;
      const bool line = !at.slice_load.empty();
      tribology::LubricatedContact film;
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
      const double crown = std::min(rollers.crown_radius, kFlatRadius);
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
            const double rounded = std::hypot(slip, std::sqrt(law.regularization_slip_squared()));
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
      double all = heat_of(g);  // last: it leaves the load x slip of the contact
      if (roller.balanced) {
        all = roller.heat.traction[j];
        one.load_slip = roller.heat.load_slip[j];
      }
      one.spin = std::min(flat_heat, all);
      one.of_oil = is_film(law, film);
      one.sliding = all - one.spin;
      one.rolling = roller.balanced ? roller.heat.rolling[j] : oil.rolling(j, film, at.length);
      if (roller.balanced) continue;
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
  const auto count = static_cast<double>(std::max<std::size_t>(solution.rollers.size(), 1));
  add_drag(bearing, orbits / count, spins / count, out);
  const std::vector<std::string> without = sentences_of(solution.friction.findings());
  out.notes.insert(out.notes.end(), without.begin(), without.end());
  if (without.empty() && solution.friction.computed)
    out.notes.emplace_back(
        "roller skew, speeds, loads and heat are calculated from friction equilibrium");
  return out;
}

}  // namespace adore::statics
