#include "statics/contact_films.hpp"

#include "base/constants.hpp"
#include "bearing/material.hpp"
#include "contact/groove.hpp"
#include "contact/roller_shape.hpp"
#include "statics/contact_laws.hpp"
#include "statics/roller_statics.hpp"

#include <algorithm>
#include <cmath>

namespace adore::statics {
namespace {

class Films {
 public:
  explicit Films(const bearing::Bearing& bearing)
      : bearing_(bearing), oil_(tribology::lubricant_of(*bearing.lubrication)) {
    out_.lubricant = oil_.name;
    out_.provenance = oil_.provenance;
    out_.critical_film = bearing.lubrication->critical_film;
    out_.meniscus = bearing.lubrication->meniscus;
    out_.lambda = {kNaN, kNaN};
    for (std::size_t j = 0; j < 2; ++j) {
      out_.temperature[j] = 0.5 * (bearing.race_temperature[j] + bearing.element_temperature);
      inlet_[j] = tribology::inlet_oil(oil_, out_.temperature[j], out_.meniscus);
      out_.viscosity[j] = inlet_[j].viscosity;
      out_.alpha[j] = inlet_[j].alpha;
      modulus_[j] =
          2.0 * bearing::contact_modulus(bearing.element_material, bearing.race_material[j]);
    }
  }

  /// @param load of the whole contact [N]
  void add(std::size_t race, double load, double roughness, tribology::LubricatedContact contact) {
    contact.modulus = modulus_[race];
    ElementFilm one{tribology::contact_film(inlet_[race], contact), std::abs(contact.speed), kNaN};
    if (load > 0.0) {
      if (roughness > 0.0) one.lambda = one.film.minimum / roughness;
      if (one.film.minimum < out_.critical_film) ++out_.metal[race];
      out_.thickest[race] = std::max(out_.thickest[race], one.film.central / contact.radius);
      if (load > heaviest_[race]) {
        heaviest_[race] = load;
        out_.lambda[race] = one.lambda;
      }
    }
    out_.race[race].push_back(one);
  }
  [[nodiscard]] LubricantFilms take() { return std::move(out_); }

 private:
  const bearing::Bearing& bearing_;
  tribology::Lubricant oil_;
  std::array<tribology::InletOil, 2> inlet_;
  std::array<double, 2> modulus_{}, heaviest_{};
  LubricantFilms out_;
};

}  // namespace

LubricantFilms contact_films(const bearing::Bearing& bearing, const StaticSolution& solution) {
  Films films(bearing);
  const bearing::BallGeometry& balls = bearing.balls();
  for (const StaticBall& ball : solution.balls)
    for (std::size_t j = 0; j < 2; ++j) {
      tribology::LubricatedContact contact;
      if (ball.Q[j] > 0.0) {
        const double angle = std::abs(ball.alpha[j]);
        contact.load = ball.Q[j];
        contact.radius =
            1.0 / contact::race_curvature(balls, static_cast<int>(j), angle).along_minor;
        contact.k = ball.a[j] / ball.b[j];
        contact.half_width = ball.b[j];
        contact.peak_pressure = ball.p_max[j];
        contact.speed = ball_entrainment(bearing, ball, j);
        const double spin = std::isfinite(ball.spin_roll[j]) ? std::abs(ball.spin_roll[j]) : 0.0;
        contact.slip = 0.375 * ball.a[j] * spin * std::abs(contact.speed) / (0.5 * balls.diameter);
      }
      films.add(j, ball.Q[j], balls.roughness[j], contact);
    }
  return films.take();
}

LubricantFilms contact_films(const bearing::Bearing& bearing, const RollerSolution& solution) {
  Films films(bearing);
  const bearing::RollerGeometry& g = *bearing.rollers();
  for (std::size_t k = 0; k < solution.rollers.size(); ++k)
    for (std::size_t j = 0; j < 2; ++j) {
      const RollerRaceContact& at = solution.rollers[k].race[j];
      tribology::LubricatedContact contact;
      if (at.load > 0.0 && at.length > 0.0) {
        const contact::RollerRaceCurvature curvature =
            contact::roller_race_curvature(g, contact::roller_profile(g, g.deviation_of(k)),
                                           static_cast<int>(j), g.race_profile_radius(j));
        contact.line = !at.slice_load.empty();
        contact.load = contact.line ? at.load / at.length : at.load;
        contact.radius = 1.0 / curvature.rolling;
        contact.k = at.half_width > 0.0 ? 0.5 * at.length / at.half_width : 1.0;
        contact.half_width = at.half_width;
        contact.peak_pressure = at.peak_pressure;
        contact.speed =
            (bearing.speed[j] - solution.orbital_speed) * g.race_radius(static_cast<int>(j));
      }
      films.add(j, at.load, g.roughness[j], contact);
    }
  return films.take();
}

}  // namespace adore::statics
