#include "contact/groove.hpp"

#include "base/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace adore::contact {
namespace {

constexpr std::array<const char*, 2> kRaceName{"outer", "inner"};
constexpr double kRightAngle = 1.5707963267948968;  // just above 90 degrees

constexpr double kWidest = 10.0;  // of grooves, as the deck allows

/// 1/(f D) must exceed the curvature of the outer race along rolling, 2 cos α/(dm + D cos α); the
/// inner race's bends the other way. Below 1 every angle will do.
double largest_groove_factor(const bearing::BallGeometry& balls, int race, double angle) {
  const double across = balls.diameter * std::cos(angle);
  if (race == bearing::kInner || !(across > 0.0)) return kWidest;
  return std::clamp((balls.pitch_diameter + across) / (2.0 * across), 1.0, kWidest);
}

void check_groove_factor(double factor, int race, double largest) {
  if (!(factor > 0.5 && factor < largest)) {
    throw InputError(fmt::format(
        "ball bearing: the {} groove factor is {}; the groove radius divided by the ball diameter "
        "must be above 0.5 (otherwise the ball does not fit into the groove) and below {:.4g} "
        "(otherwise the major axis of the contact ellipse is along the groove)",
        kRaceName[static_cast<std::size_t>(race)], factor, largest));
  }
}

void check(const bearing::BallGeometry& balls) {
  if (!(std::isfinite(balls.diameter) && balls.diameter > 0.0)) {
    throw InputError(fmt::format("ball bearing: the ball diameter is {} m; it must be positive",
                                 balls.diameter));
  }
  if (!(std::isfinite(balls.pitch_diameter) && balls.pitch_diameter > balls.diameter)) {
    throw InputError(fmt::format(
        "ball bearing: the pitch diameter is {} m; it must be larger than the ball diameter, {} m",
        balls.pitch_diameter, balls.diameter));
  }
  if (!(balls.contact_angle >= 0.0 && balls.contact_angle <= kRightAngle)) {
    throw InputError(fmt::format(
        "ball bearing: the free contact angle is {} rad; it must be between 0 and 90 degrees",
        balls.contact_angle));
  }
  for (int race = 0; race < 2; ++race) {
    check_groove_factor(balls.groove_factor[static_cast<std::size_t>(race)], race,
                        largest_groove_factor(balls, race, balls.contact_angle));
  }
}

}  // namespace

GrooveGeometry groove_geometry(const bearing::BallGeometry& balls) {
  check(balls);
  GrooveGeometry g;
  g.ball_radius = 0.5 * balls.diameter;
  for (std::size_t j = 0; j < 2; ++j) {
    g.groove_radius[j] = balls.groove_factor[j] * balls.diameter;
    g.offset[j] = (balls.groove_factor[j] - 0.5) * balls.diameter;
    const double sign =
        j == bearing::kOuter ? -1.0 : 1.0;  // the inner groove centre lies outside the ball circle
    if (balls.contact_angle > 0.0) {
      g.centre_radius[j] =
          0.5 * balls.pitch_diameter + sign * g.offset[j] * std::cos(balls.contact_angle);
      g.centre_x[j] = sign * g.offset[j] * std::sin(balls.contact_angle);
    } else {
      g.centre_radius[j] =
          0.5 * balls.pitch_diameter + sign * (g.offset[j] - 0.25 * balls.clearance);
      g.centre_x[j] = 0.0;
    }
    if (balls.groove_plane) {
      g.centre_x[j] = (*balls.groove_plane)[j];
    }
  }
  return g;
}

bearing::BallGeometry geometry_with_ball_growth(const bearing::BallGeometry& balls, double growth) {
  bearing::BallGeometry out = balls;
  out.diameter += growth;
  for (double& factor : out.groove_factor) factor *= balls.diameter / out.diameter;
  return out;
}

GrooveGeometry groove_with_ball_growth(const GrooveGeometry& nominal, double growth) noexcept {
  GrooveGeometry out = nominal;
  out.ball_radius += 0.5 * growth;
  for (double& offset : out.offset) offset -= 0.5 * growth;
  return out;
}

RelativeCurvature race_curvature(const bearing::BallGeometry& balls, int race,
                                 double contact_angle) {
  const auto j = static_cast<std::size_t>(race);
  check_groove_factor(balls.groove_factor[j], race,
                      largest_groove_factor(balls, race, contact_angle));
  const double D = balls.diameter;
  const double sign = race == bearing::kInner ? 1.0 : -1.0;
  const double c = std::cos(contact_angle);
  const double rolling = 2.0 / D + sign * 2.0 * c / (balls.pitch_diameter - sign * D * c);
  const double transverse = 2.0 / D - 1.0 / (balls.groove_factor[j] * D);
  return {transverse, rolling};
}

ContactEdges contact_edges(const GrooveGeometry& groove, int race, double angle, double half_major,
                           double shoulder_radius) noexcept {
  const auto j = static_cast<std::size_t>(race);
  const double radius = groove.groove_radius[j], span = half_major / radius;
  ContactEdges edges;
  if (shoulder_radius > 0.0) {
    const double sign = race == bearing::kOuter ? 1.0 : -1.0;
    edges.shoulder_depth = radius * std::cos(std::abs(angle) + span) +
                           sign * (groove.centre_radius[j] - shoulder_radius);
  }
  edges.centre_chord = radius * std::sin(std::abs(angle) - span);
  return edges;
}

FreeAngleAndClearance free_angle_and_clearance(double diameter,
                                               const std::array<double, 2>& groove_factor,
                                               const std::array<double, 2>& shim,
                                               double contact_angle, double measured_clearance) {
  for (int race = 0; race < 2; ++race) {
    check_groove_factor(groove_factor[static_cast<std::size_t>(race)], race, kWidest);
  }
  const double play_of_90_degrees = 2.0 * diameter * (groove_factor[0] + groove_factor[1] - 1.0);
  if (contact_angle > 0.0) {
    return {contact_angle, play_of_90_degrees * (1.0 - std::cos(contact_angle))};
  }
  double clearance = measured_clearance;
  for (std::size_t j = 0; j < 2; ++j) {
    const double chord = (2.0 * groove_factor[j] - 1.0) * diameter;
    const double sine = shim[j] / chord;
    if (!(sine >= 0.0 && sine < 1.0)) {
      throw InputError(
          fmt::format("ball bearing: the shim of the {} race is {} m; it must not be negative and "
                      "must be below {} m (twice the distance between ball center and groove "
                      "center); otherwise the ball cannot touch the split groove",
                      kRaceName[j], shim[j], chord));
    }
    clearance += chord * (1.0 - std::sqrt((1.0 - sine) * (1.0 + sine)));
  }
  if (!(clearance < play_of_90_degrees)) {
    throw InputError(
        fmt::format("ball bearing: the diametral clearance without shims is {} m; it "
                    "must be below {} m, where the free contact angle reaches 90 degrees. Enter a "
                    "smaller clearance or larger groove factors",
                    clearance, play_of_90_degrees));
  }
  // 1 - cos α0 = clearance/play, written with the half angle so that small clearances keep their
  // digits.
  const double angle =
      clearance > 0.0 ? 2.0 * std::asin(std::sqrt(0.5 * clearance / play_of_90_degrees)) : 0.0;
  return {angle, clearance};
}

std::array<SplitRaceHalf, 2> split_race_halves(const bearing::BallGeometry& balls,
                                               const GrooveGeometry& groove, int race) {
  const auto j = static_cast<std::size_t>(race);
  const double shim = balls.shim[j];
  if (!(shim > 0.0)) return {};
  const HertzConstants hertz = hertz_constants(race_curvature(balls, race, 0.0), 1.0);
  const double side = race == bearing::kOuter ? 1.0 : -1.0;
  SplitRaceHalf half{side, 0.5 * shim, groove.groove_radius[j], 0.0,
                     hertz.a_hat * std::cbrt(hertz.K)};  // of any modulus
  SplitRaceHalf other = half;
  other.side = -side;
  other.shift = side * shim;
  if (groove.centre_x[j] == 0.0) {
    half.shift = -side * half.half_shim;
    other.shift = side * half.half_shim;
  }
  return {half, other};
}

double split_race_end_play(const std::array<double, 2>& offset, const std::array<double, 2>& shim,
                           double contact_angle) {
  const double across = (offset[0] + offset[1]) * std::cos(contact_angle);
  std::array<double, 2> along{offset[0] * std::sin(contact_angle),
                              offset[1] * std::sin(contact_angle)};
  for (std::size_t j = 0; j < 2; ++j) {
    const std::size_t k = 1 - j;
    if (!(along[j] < 0.5 * shim[j])) continue;
    along[j] = 0.5 * shim[j];
    const double rest = across - std::sqrt(offset[j] * offset[j] - along[j] * along[j]);
    along[k] =
        std::max(0.5 * shim[k], std::sqrt(std::max(0.0, offset[k] * offset[k] - rest * rest)));
  }
  return 2.0 * (along[0] + along[1]) - shim[0] - shim[1];
}

}  // namespace adore::contact
