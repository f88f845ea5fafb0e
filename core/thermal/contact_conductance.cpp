#include "thermal/contact_conductance.hpp"

#include "base/constants.hpp"
#include "contact/elliptic.hpp"
#include "statics/ball_statics.hpp"
#include "statics/contact_films.hpp"
#include "statics/roller_statics.hpp"
#include "tribology/lubricant.hpp"

#include <algorithm>
#include <cmath>

namespace adore::thermal {
namespace {

struct Patch {
  double across = 0.0, along = 0.0, peak_pressure = 0.0, speed = 0.0;
  double film = 0.0;  ///< [m]
};

class Sum {
 public:
  explicit Sum(const bearing::Bearing& b) : b_(b) {
    if (b.lubrication) oil_ = tribology::lubricant_of(*b.lubrication);
  }
  void add(std::size_t race, const Patch& patch) {
    if (!(patch.across > 0.0 && patch.along > 0.0)) return;
    double film = 0.0;
    if (oil_ && patch.film > 0.0) {
      const double T = 0.5 * (b_.race_temperature[race] + b_.element_temperature);
      const double p = 2.0 / 3.0 * patch.peak_pressure * 1e-9;
      constexpr double kInletAndOutlet = 1.25;
      film = 0.5 * patch.film /
             (kInletAndOutlet * oil_->conductivity.at(T) * (1.0 + 1.72 * p / (1.0 + 0.76 * p)) *
              kPi * patch.across * patch.along);
    }
    const auto through = [&](const bearing::Material& body) {
      const double G = patch_conductance(body, patch.across, patch.along, patch.speed);
      return G > 0.0 ? 1.0 / (1.0 / G + film) : 0.0;
    };
    out[race].first += through(b_.element_material);
    out[race].second += through(b_.race_material[race]);
  }
  RaceConductance out{};

 private:
  const bearing::Bearing& b_;
  std::optional<tribology::Lubricant> oil_;
};

double film_contact_of(const std::optional<statics::LubricantFilms>& films, std::size_t race,
                       std::size_t element) {
  return films ? films->race[race][element].film.central : 0.0;
}

template <class Solution>
std::optional<statics::LubricantFilms> films_of(const bearing::Bearing& b,
                                                const Solution& solution) {
  if (!b.lubrication) return std::nullopt;
  return solution.films ? solution.films : statics::contact_films(b, solution);
}

}  // namespace

double patch_conductance(const bearing::Material& body, double across, double along, double speed) {
  const double large = std::max(across, along), small = std::min(across, along),
               ratio = small / large;
  const double still =
      2.0 * kPi * body.conductivity * large / contact::complete_elliptic(ratio * ratio).K;
  constexpr double kMean = 0.8194;  // 3/4 × (π/2)/B(1/2, 7/4)
  const double moving =
      kMean * kPi * across * along *
      std::sqrt(kPi * body.conductivity * body.density * std::max(body.specific_heat, 0.0) *
                std::abs(speed) / (2.0 * along));
  return std::hypot(still, moving);
}

RaceConductance race_conductance(const bearing::Bearing& b,
                                 const statics::StaticSolution& solution) {
  Sum sum(b);
  const auto films = films_of(b, solution);
  for (std::size_t i = 0; i < solution.balls.size(); ++i) {
    const auto add = [&](const statics::StaticBall& ball) {
      for (std::size_t j = 0; j < 2; ++j) {
        if (!(ball.Q[j] > 0.0)) continue;
        const double radius =
            ball.r + (j == 0 ? 0.5 : -0.5) * b.element_diameter() * std::cos(ball.alpha[j]);
        sum.add(j,
                {ball.share[j] * ball.a[j], ball.b[j], ball.p_max[j],
                 std::abs(b.speed[j] - ball.orbital_speed) * radius, film_contact_of(films, j, i)});
      }
    };
    add(solution.balls[i]);
    if (statics::has_second_contact(solution.balls[i]))
      add(statics::ball_at_second_contacts(solution.balls[i]));
  }
  return sum.out;
}

RaceConductance race_conductance(const bearing::Bearing& b,
                                 const statics::RollerSolution& solution) {
  Sum sum(b);
  const auto films = films_of(b, solution);
  for (std::size_t i = 0; i < solution.rollers.size(); ++i)
    for (std::size_t j = 0; j < 2; ++j) {
      const statics::RollerRaceContact& contact = solution.rollers[i].race[j];
      if (!(contact.load > 0.0)) continue;
      sum.add(j, {0.5 * contact.length, contact.half_width, contact.peak_pressure,
                  std::abs(b.speed[j] - solution.orbital_speed) *
                      b.rollers()->race_radius(static_cast<int>(j)),
                  film_contact_of(films, j, i)});
    }
  return sum.out;
}

}  // namespace adore::thermal
