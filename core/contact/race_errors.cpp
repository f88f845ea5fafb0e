#include "contact/race_errors.hpp"

#include "base/errors.hpp"

#include <fmt/format.h>

#include <cmath>

namespace adore::contact {
namespace {

RaceWave race_wave(double amplitude, double waves, double phase) {
  return {amplitude, waves, phase, std::cos(phase), std::sin(phase)};
}
RaceWave race_wave(const Harmonic& wave) {
  return race_wave(wave.amplitude, wave.waves, wave.phase);
}

RaceFourierSeries race_sum(const bearing::AzimuthSeries& series) {
  return {series.pairs.data(), static_cast<int>(series.pairs.size() / 2)};
}

}  // namespace

RaceErrorModel make_race_error_model(const RaceErrors& errors, double nominal_radius) {
  RaceErrorModel form;
  form.nominal_radius = nominal_radius;
  if (errors.given) {
    form.is_summed = true;
    form.radius_sum = race_sum(errors.given->radius);
    form.taper_sum = race_sum(errors.given->taper);
    form.curvature_sum = race_sum(errors.given->curvature_factor);
    return form;
  }
  const auto& v = errors.variation;
  if (errors.roundness == RaceErrors::Roundness::Elliptical) {
    const double along = nominal_radius + v[0], across = nominal_radius + v[1];
    form.is_oval = true;
    form.oval = {1 / (along * along), 1 / (across * across), v[2], std::cos(v[2]), std::sin(v[2])};
  } else if (errors.roundness == RaceErrors::Roundness::Sinusoidal) {
    form.radius = race_wave(v[0], v[1], v[2]);
  }
  form.land_offset = race_wave(errors.land_offset);
  form.taper = race_wave(errors.taper);
  form.curvature_factor = race_wave(errors.curvature_factor);
  return form;
}

void check_integer_wave_counts(const RaceErrors& errors) {
  if (errors.given) return;
  const double radius =
      errors.roundness == RaceErrors::Roundness::Sinusoidal ? errors.variation[1] : 0.0;
  for (const double waves :
       {radius, errors.land_offset.waves, errors.taper.waves, errors.curvature_factor.waves})
    if (waves != std::round(waves))
      throw InputError(
          fmt::format("a race has {} waves per revolution, so its profile has a step at the end of "
                      "the last wave. Give a rotating race a whole number of waves",
                      waves));
}

RaceSurface race_with_error(const RaceSurface& ideal, const LocalRaceError& error,
                            double curvature_diameter,
                            const std::array<double, 2>& nominal_normal) noexcept {
  RaceSurface race = ideal;
  race.land_offset += error.land_offset;
  if (race.shape == RaceSurface::Shape::Groove) {
    const GrooveChange<double> change =
        groove_change(error.radius, error.curvature_factor, curvature_diameter, nominal_normal[0],
                      nominal_normal[1]);
    race.groove_radius += change.radius;
    race.groove_x += change.x;
    race.groove_centre_radius += change.centre_radius;
    return race;
  }
  const double mid_radius =
      ideal.radius - ideal.mid_x * ideal.sin_angle / ideal.cos_angle + error.radius;
  if (error.taper != 0.0) {
    const double angle = std::atan2(ideal.sin_angle, ideal.cos_angle) - error.taper;
    race.cos_angle = std::cos(angle);
    race.sin_angle = std::sin(angle);
  }
  race.radius = mid_radius + race.mid_x * race.sin_angle / race.cos_angle;
  return race;
}

WavyRace make_wavy_race(const RaceErrors& errors, const RaceSurface& ideal, double nominal_radius,
                        double crown_radius) {
  check_integer_wave_counts(errors);
  WavyRace out{
      make_race_error_model(errors, nominal_radius), ideal, 2.0 * crown_radius, {}, errors.given};
  if (ideal.shape == RaceSurface::Shape::Groove) out.normal = nominal_groove_normal(ideal);
  return out;
}

WavyRace::LocalSurface WavyRace::at(const AzimuthDirection<double>& psi) const noexcept {
  const LocalRaceError e = race_error_at(form, psi);
  LocalSurface here{race_with_error(ideal, e, curvature_diameter, normal), {}};
  const GrooveChange<double> groove = groove_change(e.radius_slope, e.curvature_factor_slope,
                                                    curvature_diameter, normal[0], normal[1]);
  here.slope = {e.radius_slope, -e.taper_slope,       groove.radius,
                groove.x,       groove.centre_radius, e.land_offset_slope};
  return here;
}

}  // namespace adore::contact
