#include "base/errors.hpp"
#include "bearing/element_inertia.hpp"
#include "bearing/given_surface.hpp"
#include "contact/race_errors.hpp"
#include "contact/wavy_groove_model.hpp"
#include "statics/ball_model.hpp"

#include <fmt/format.h>

#include <cmath>

namespace adore::statics {
namespace {

/// The groove as it is at one azimuth. Its slope is returned.
double deform_groove(const BallModel& m, std::size_t j, const bearing::RaceErrors& errors,
                     double psi, contact::GrooveGeometry& groove) {
  const double sign = j == bearing::kOuter ? 1.0 : -1.0;
  const double bottom = groove.centre_radius[j] + sign * groove.groove_radius[j];
  const contact::LocalRaceError e = contact::race_error_at(errors, bottom, psi);
  const double angle = m.balls.contact_angle;
  const contact::RaceSurface race = contact::race_with_error(
      contact::groove_race(static_cast<int>(j), groove.groove_radius[j], groove.centre_x[j],
                           groove.centre_radius[j]),
      e, m.balls.diameter, {sign * std::sin(angle), sign * std::cos(angle)});
  groove.offset[j] += race.groove_radius - groove.groove_radius[j];
  groove.groove_radius[j] = race.groove_radius;
  groove.centre_x[j] = race.groove_x;
  groove.centre_radius[j] = race.groove_centre_radius;
  return e.radius_slope;
}

/// The seat of ball k, and whether it differs from the nominal one.
bool make_seat(const BallModel& m, const bearing::Bearing& b, const BallStaticsOptions& options,
               std::size_t k, BallInGrooves& seat) {
  const auto& errors = b.imperfections;
  const double growth = k < errors.ball_diameter.size() ? errors.ball_diameter[k] : 0.0;
  const bearing::Inertia own_inertia = bearing::inertia_of(b, k);
  bool differs = growth != 0.0 || (k == 0 && b.first_inertia);
  std::array<bool, 2> curved_otherwise{growth != 0.0, growth != 0.0};
  seat = m;  // the base: nominal
  if (growth != 0.0) {
    if (!(std::isfinite(growth) && growth > -0.5 * m.diameter)) {
      throw InputError(
          fmt::format("ball {}: the diameter deviation is {} m and the nominal diameter {} m; "
                      "their sum must be above 0",
                      k + 1, growth, m.diameter));
    }
    seat.diameter += growth;
    seat.groove.ball_radius += 0.5 * growth;
    seat.gamma *= seat.diameter / m.diameter;
  }
  if (differs) {
    const double ratio = m.mass > 0.0 ? own_inertia.mass / m.mass : 1.0;
    seat.mass = own_inertia.mass;
    seat.inertia = own_inertia.moments.x();
    seat.base_centrifugal *= ratio;
    seat.window *= ratio;
  }
  for (std::size_t j = 0; j < 2; ++j) {
    seat.groove.offset[j] -= 0.5 * growth;
    if (errors.race[j].ideal()) {
      continue;
    }
    differs = true;
    if (bearing::table_of(errors.race[j].given.get()) != nullptr) {
      struct Kept {
        std::shared_ptr<const bearing::SurfaceSeries> given;
        contact::WavyGroove groove;
      };
      const auto race = static_cast<int>(j);
      auto kept = std::make_shared<Kept>(
          Kept{errors.race[j].given,
               contact::make_wavy_groove(m.balls, race, errors.race[j], options.fixed_angle[j])});
      if (growth != 0.0)
        kept->groove.ratios = contact::ratios_with_ball_growth(
            m.balls, growth, race, errors.race[j], options.fixed_angle[j]);
      seat.table[j] = std::shared_ptr<const contact::WavyGroove>(kept, &kept->groove);
      seat.azimuth_in_race = m.azimuth[k];
      continue;
    }
    const double slope = deform_groove(m, j, errors.race[j], m.azimuth[k], seat.groove);
    if (j == bearing::kInner) {
      seat.inner_slope = slope;
    }
    curved_otherwise[j] =
        curved_otherwise[j] || seat.groove.groove_radius[j] != m.groove.groove_radius[j];
  }
  bearing::BallGeometry own = m.balls;
  own.diameter = seat.diameter;
  for (std::size_t j = 0; j < 2; ++j) {
    own.groove_factor[j] = seat.groove.groove_radius[j] / seat.diameter;
    if (!(seat.groove.offset[j] > 0.0 && own.groove_factor[j] < 1.0)) {
      throw InputError(fmt::format(
          "ball {}: its diameter of {:.9g} m does not fit the {} groove of radius {:.9g} m at this "
          "azimuth; the groove radius must be above half the ball diameter and below the ball "
          "diameter. Reduce the imperfections of the balls (5G.1) or of the curvature factor of "
          "the race (5G.2)",
          k + 1, seat.diameter, j == 0 ? "outer" : "inner", seat.groove.groove_radius[j]));
    }
  }
  for (std::size_t j = 0; j < 2; ++j) {
    if (!curved_otherwise[j]) {
      continue;
    }
    const double E_star = bearing::contact_modulus(b.element_material, b.race_material[j]);
    const double angle =
        options.curvature == Curvature::Fixed ? options.fixed_angle[j] : m.balls.contact_angle;
    seat.hertz[j] = HertzSeries(own, static_cast<int>(j), E_star, angle, options.curvature);
    const double f = own.groove_factor[j];
    seat.surface_radius[j] = 2.0 * f * seat.diameter / (2.0 * f + 1.0);
  }
  return differs;
}

}  // namespace

void add_imperfect_balls(BallModel& m, const bearing::Bearing& bearing,
                         const BallStaticsOptions& options) {
  const auto& errors = bearing.imperfections;
  if (errors.ball_diameter.empty() && !bearing.first_inertia && errors.race[0].ideal() &&
      errors.race[1].ideal()) {
    return;
  }
  m.own_number.assign(m.azimuth.size(), 0);
  BallInGrooves seat;
  for (std::size_t k = 0; k < m.azimuth.size(); ++k) {
    if (make_seat(m, bearing, options, k, seat)) {
      m.own.push_back(seat);
      m.own_number[k] = m.own.size();
    }
  }
}

}  // namespace adore::statics
