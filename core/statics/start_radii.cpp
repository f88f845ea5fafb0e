#include "statics/start_radii.hpp"

#include "bearing/given_surface.hpp"
#include "contact/race_errors.hpp"
#include "contact/race_table.hpp"
#include "statics/roller_races.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace adore::statics {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

/// Values and slopes at n azimuths k 2π/n.
struct RadiusNodes {
  std::vector<double> value, slope;
};

/// The series through them, of n waves at most.
bearing::AzimuthSeries series_through(const RadiusNodes& nodes) {
  const std::size_t n = nodes.value.size(), samples = 4 * n;
  bearing::AzimuthSeries out;
  out.least = *std::min_element(nodes.value.begin(), nodes.value.end());
  out.largest = *std::max_element(nodes.value.begin(), nodes.value.end());
  if (std::all_of(nodes.value.begin(), nodes.value.end(), [](double v) { return v == 0.0; }) &&
      std::all_of(nodes.slope.begin(), nodes.slope.end(), [](double s) { return s == 0.0; }))
    return out;
  const auto count = static_cast<double>(n);
  std::vector<double> at(samples, 0.0);
  for (std::size_t i = 0; i < samples; ++i)
    for (std::size_t k = 0; k < n; ++k) {
      const double x = kTurn * (static_cast<double>(i) / static_cast<double>(samples) -
                                static_cast<double>(k) / count);
      const double half = std::sin(0.5 * x);
      const double ratio =
          std::abs(half) < 1e-12 ? 1.0 : std::sin(0.5 * count * x) / (count * half);
      at[i] += (nodes.value[k] + nodes.slope[k] * std::sin(x)) * ratio * ratio;
    }
  for (std::size_t wave = 0; wave <= n; ++wave) {
    double c = 0.0, s = 0.0;
    for (std::size_t i = 0; i < samples; ++i) {
      const double angle =
          kTurn * static_cast<double>(wave * i % samples) / static_cast<double>(samples);
      c += at[i] * std::cos(angle);
      s += at[i] * std::sin(angle);
    }
    const double scale = (wave == 0 ? 1.0 : 2.0) / static_cast<double>(samples);
    out.pairs.push_back(scale * c);
    out.pairs.push_back(scale * s);
  }
  return out;
}

/// Height of a ball that is not round over its mean, in a direction of its azimuth frame.
double height_of(const bearing::SurfaceSeries* form, double azimuth, double latitude) {
  const bearing::SurfaceTable* const t = bearing::table_of(form);
  if (t == nullptr) return 0.0;
  const contact::SurfaceDeviationTable table{t->height.data(), nullptr, t->around, t->across,
                                             t->first,         t->step, 1.0};
  return contact::table_value(table, table.height, azimuth, latitude).value;
}

/// Contact angles; of an open contact that of the other one.
std::array<double, 2> angles_of(const StaticBall& ball, double free_angle) {
  std::array<double, 2> out = ball.alpha;
  for (std::size_t j = 0; j < 2; ++j)
    if (!std::isfinite(out[j]))
      out[j] = std::isfinite(ball.alpha[1 - j]) ? ball.alpha[1 - j] : free_angle;
  return out;
}

}  // namespace

double race_growth(const contact::RaceSurface& race) {
  return 1.0 / (race.shape == contact::RaceSurface::Shape::Groove
                    ? std::abs(contact::nominal_groove_normal(race)[1])
                    : race.cos_angle);
}

std::optional<bearing::Bearing> with_start_radii(const bearing::Bearing& b, Forms forms) {
  bearing::Bearing out = b;
  const auto count = static_cast<std::size_t>(b.element_count());
  for (std::size_t j = 0; j < 2; ++j) {
    bearing::RaceErrors& errors = out.imperfections.race[j];
    if (bearing::table_of(errors.given.get()) != nullptr ||
        (!errors.given && errors.land_offset.amplitude != 0.0))
      return std::nullopt;
    const double sign = j == bearing::kOuter ? -1.0 : 1.0;
    const double own_azimuth = j == bearing::kOuter ? 0.0 : std::numbers::pi;
    const double growth = sign * race_growth(race_surfaces(b)[j]);
    const double race_radius = b.rollers()->race_radius(static_cast<int>(j));
    RadiusNodes radius, taper, factor;
    for (std::size_t k = 0; k < count; ++k) {
      contact::LocalRaceError race, roller;
      if (!errors.ideal())
        race = contact::race_error_at(errors, race_radius,
                                      kTurn * static_cast<double>(k) / static_cast<double>(count));
      if (k < forms.size() && forms[k]) {
        bearing::RaceErrors own;
        own.given = forms[k];
        roller = contact::race_error_at(own, race_radius, own_azimuth);
      }
      radius.value.push_back(race.radius + growth * roller.radius);
      radius.slope.push_back(race.radius_slope + growth * roller.radius_slope);
      taper.value.push_back(race.taper + sign * roller.taper);
      taper.slope.push_back(race.taper_slope + sign * roller.taper_slope);
      factor.value.push_back(race.curvature_factor);
      factor.slope.push_back(race.curvature_factor_slope);
    }
    auto given = std::make_shared<bearing::SurfaceSeries>();
    given->radius = series_through(radius);
    given->taper = series_through(taper);
    given->curvature_factor = series_through(factor);
    errors.given = std::move(given);
  }
  return out;
}

StaticSolution solve_balls_with_friction(const bearing::Bearing& b,
                                         const BallStaticsOptions& options, Forms forms,
                                         FrictionBalance& balance) {
  StaticSolution out = solve_ball_statics(b, options);
  if (forms.empty()) {
    balance = solve_ball_friction_balance(b, options, out);
    return out;
  }
  bearing::Bearing at_start = b;
  std::vector<double>& diameter = at_start.imperfections.ball_diameter;
  std::vector<std::array<double, 2>> height(out.balls.size(), {0.0, 0.0});
  for (int round = 0; round < 2; ++round) {
    diameter = b.imperfections.ball_diameter;
    diameter.resize(out.balls.size(), 0.0);
    for (std::size_t k = 0; k < out.balls.size() && k < forms.size(); ++k) {
      const std::array<double, 2> angle = angles_of(out.balls[k], b.balls().contact_angle);
      height[k] = {height_of(forms[k].get(), 0.0, angle[0]),
                   height_of(forms[k].get(), std::numbers::pi, -angle[1])};
      diameter[k] += height[k][0] + height[k][1];
    }
    out = solve_ball_statics(at_start, options);
  }
  balance = solve_ball_friction_balance(at_start, options, out);
  for (std::size_t k = 0; k < out.balls.size(); ++k) {
    StaticBall& ball = out.balls[k];
    const std::array<double, 2> angle = angles_of(ball, b.balls().contact_angle);
    const double inward = 0.5 * (height[k][0] - height[k][1]);
    ball.x -= inward * std::sin(0.5 * (angle[0] + angle[1]));
    ball.r -= inward * std::cos(0.5 * (angle[0] + angle[1]));
  }
  return out;
}

}  // namespace adore::statics
