#pragma once

#include "bearing/bearing.hpp"
#include "bearing/material.hpp"
#include "statics/ball_statics.hpp"
#include "tribology/contact_film.hpp"
#include "tribology/ellipse_traction.hpp"
#include "tribology/film_law.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <string>

/// Laws of traction and rolling resistance of the contacts of an equilibrium: those of motion
/// (tribology/film_law.hpp).
namespace adore::statics {

/// What a lubricant's law needs that all contacts of a race share.
class ContactLaws {
 public:
  explicit ContactLaws(const bearing::Bearing& bearing) : bearing_(bearing) {
    if (!bearing.lubrication) return;
    oil_ = tribology::lubricant_of(*bearing.lubrication);
    for (std::size_t j = 0; j < 2; ++j) {
      temperature_[j] = 0.5 * (bearing.race_temperature[j] + bearing.element_temperature);
      modulus_[j] =
          2.0 * bearing::contact_modulus(bearing.element_material, bearing.race_material[j]);
      tribology::RaceFilmInputs surface;
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
    tribology::RaceFilmInputs surface;
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
      const tribology::TractionLaw& law, const tribology::LubricatedContact& contact) const {
    tribology::ContactConditions<double> point;
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
  /// Force of the oil in the inlet on each surface, with the sign of the entrainment; of lines per
  /// length [N, N/m].
  [[nodiscard]] double rolling_resistance_force(std::size_t j,
                                                const tribology::LubricatedContact& contact) const {
    if (!oil_ || !(bearing_.lubrication->meniscus > 0.0)) return 0.0;
    if (!(contact.load > 0.0) || contact.speed == 0.0) return 0.0;
    tribology::ContactConditions<double> point;
    point.load = contact.load;
    point.peak_pressure = contact.peak_pressure;
    point.half_major = contact.k * contact.half_width;
    point.half_minor = contact.half_width;
    point.entrainment = contact.speed;
    point.curvature = 1.0 / contact.radius;
    return rolling_[j][contact.line ? 1 : 0].force(point);
  }
  /// Its power; of lines over their length [W].
  [[nodiscard]] double rolling(std::size_t j, const tribology::LubricatedContact& contact,
                               double length) const {
    return 2.0 * rolling_resistance_force(j, contact) * contact.speed *
           (contact.line ? length : 1.0);
  }
  /// The same of a point contact whose strips along rolling resist as lines do, each under its own
  /// load, pressure and width: (3 Q/4a)(1 - y²), p √(1 - y²), b √(1 - y²).
  [[nodiscard]] double rolling_power_of_strips(std::size_t j,
                                               const tribology::LubricatedContact& contact) const {
    if (!oil_ || !(contact.load > 0.0) || contact.speed == 0.0) return 0.0;
    constexpr int kStrips = 40;
    const double a = contact.k * contact.half_width;
    double sum = 0.0;
    for (int i = 0; i < kStrips; ++i) {
      const double y = (2.0 * i + 1.0) / kStrips - 1.0, chord2 = 1.0 - y * y;
      tribology::LubricatedContact strip = contact;
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
  const bearing::Bearing& bearing_;
  std::optional<tribology::Lubricant> oil_;
  std::array<std::array<tribology::RollingResistance, 2>, 2> rolling_;  ///< of points, of lines
  std::array<double, 2> temperature_{}, modulus_{};
  mutable std::array<std::optional<tribology::TractionLaw>, 2> kept_;
};

/// Mean speed of both surfaces along the rolling direction at the centre of a loaded contact,
/// against the row [m/s]; by the spin rule that of the race, which does not slip there.
[[nodiscard]] inline double ball_entrainment(const bearing::Bearing& bearing,
                                             const StaticBall& ball, std::size_t j) {
  const double arm = (j == 0 ? 0.5 : -0.5) * bearing.element_diameter();
  const double x = arm * std::sin(ball.alpha[j]), r = arm * std::cos(ball.alpha[j]);
  const double race = (bearing.speed[j] - ball.orbital_speed) * (ball.r + r);
  if (ball.omega_theta == 0.0) return race;  // balls in balance creep (ball_friction.hpp)
  return 0.5 * (race + (ball.omega_x - ball.orbital_speed) * r - ball.omega_r * x);
}

/// What films read of a loaded contact of a ball, with the whole ellipse where a split cuts it.
[[nodiscard]] inline tribology::LubricatedContact film_contact_of(const bearing::Bearing& bearing,
                                                                  const StaticBall& ball,
                                                                  std::size_t j) {
  const bearing::BallGeometry& balls = bearing.balls();
  tribology::LubricatedContact film;
  film.load = ball.Q[j] / ball.share[j];
  film.radius =
      1.0 /
      contact::race_curvature(balls, static_cast<int>(j), std::abs(ball.alpha[j])).along_minor;
  film.k = ball.a[j] / ball.b[j];
  film.half_width = ball.b[j];
  film.peak_pressure = ball.p_max[j];
  film.speed = ball_entrainment(bearing, ball, j);
  return film;
}

/// Contact of a loaded ball with race j: n from the ball into the race, c = e_θ × n on (e_x, e_r),
/// surface of motion (ContactSurface::CurvedEdge), traction law.
struct BallContact {
  double n_x = 0.0, n_r = 0.0;
  tribology::EllipseGeometry ellipse;
  tribology::LubricatedContact film;
  tribology::TractionLaw law;
  double share = 1.0;  ///< of the whole ellipse above (StaticBall::share)
};
[[nodiscard]] inline BallContact ball_contact(const bearing::Bearing& bearing,
                                              const ContactLaws& laws, const StaticBall& ball,
                                              std::size_t j) {
  const bearing::BallGeometry& balls = bearing.balls();
  const double R = 0.5 * balls.diameter, side = j == 0 ? 1.0 : -1.0;
  const double fastest =
      0.5 * balls.pitch_diameter * std::max(std::abs(bearing.speed[0]), std::abs(bearing.speed[1]));
  BallContact out;
  out.n_x = side * std::sin(ball.alpha[j]);
  out.n_r = side * std::cos(ball.alpha[j]);
  out.share = ball.share[j];
  out.ellipse = {ball.Q[j] / out.share, ball.a[j], ball.b[j], 0.0, 0.0};
  tribology::set_contact_surface(out.ellipse, tribology::ContactSurface::CurvedEdge, R,
                                 2.0 * balls.groove_factor[j] * R, ball.delta[j]);
  out.film = film_contact_of(bearing, ball, j);
  out.law = laws.law(j, false, out.film.radius, ball.b[j] / ball.p_max[j], fastest);
  return out;
}

}  // namespace adore::statics
