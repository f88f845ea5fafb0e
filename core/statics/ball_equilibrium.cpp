#include "statics/ball_equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#ifndef ADORE_CLONES  // core/CMakeLists.txt
#define ADORE_CLONES
#endif

namespace adore::statics {
namespace {

/// Longest last step of a ball that is taken without being evaluated, over the offsets' sum.
constexpr double kMaxUnevaluatedStep = 2.5e-3;

struct Point {
  double x = 0.0, rho = 0.0;
};

struct Residual {
  double axial = 0.0, radial = 0.0;
  double scale = 0.0;       ///< sum of the forces that balance
  double shallowest = 0.0;  ///< smallest approach of a loaded contact [m]
  Eigen::Matrix2d jacobian;
  bool rolls = true;

  [[nodiscard]] double size() const { return std::sqrt(axial * axial + radial * radial); }
};

using D2 = Dual<2>;

Residual residual_at(const BallModel& m, const BallSite& site, const Point& at,
                     const RacesInAzimuthFrame<double>& races) {
  const auto f = ball_forces(m, site, D2::variable(at.x, 0), D2::variable(at.rho, 1), races);
  Residual r;
  r.axial = f.axial.v;
  r.radial = f.radial.v;
  r.scale = f.contact[0].load.v + f.contact[1].load.v + f.centrifugal.v;
  for (const auto& c : f.contact) {
    if (c.load.v > 0.0 && (r.shallowest == 0.0 || c.approach.v < r.shallowest)) {
      r.shallowest = c.approach.v;
    }
  }
  r.jacobian << f.axial.d[0], f.axial.d[1], f.radial.d[0], f.radial.d[1];
  r.rolls = f.rolls;
  return r;
}

/// Newton with backtracking; true when the residual force vanishes to rounding, or when it is below
/// `accuracy` of the loads and the next step is short.
ADORE_CLONES
bool newton(const BallModel& m, const BallSite& site, const RacesInAzimuthFrame<double>& races,
            double accuracy, Point& at) {
  constexpr int kMaxIterations = 40;
  // Rounding of a position of the size of the pitch radius, through the stiffness, is what can be
  // asked for.
  const double position_noise =
      (m.exact ? 4e-16 * m.balls.pitch_diameter : 1e-16 * m.balls.diameter);
  const double longest = 0.25 * m.offset_sum();
  Point trial = at;
  double dx = 0.0, dr = 0.0, length = 0.0, step = 1.0;
  int iterations = 0, halvings = 0;
  Residual now;
  // The residual is evaluated in one place, because this function contains a copy of its code.
  for (;;) {
    const Residual then = residual_at(m, site, trial, races);
    if (iterations > 0 && !(then.size() <= (1.0 - 1e-4 * step) * now.size())) {
      constexpr int kMaxHalvings = 16;
      if (++halvings == kMaxHalvings)  // rounding floor
        return now.size() <= 1e-9 * now.scale || length <= 100.0 * position_noise;
      step *= 0.5;
      trial = {at.x + step * dx, at.rho + step * dr};
      continue;
    }
    at = trial;
    now = then;
    if (iterations++ == kMaxIterations) return now.size() <= 1e-9 * now.scale;
    if (!std::isfinite(now.size())) {
      return false;
    }
    if (now.size() <= 1e-15 * now.scale) {
      return true;
    }
    const double determinant =
        now.jacobian(0, 0) * now.jacobian(1, 1) - now.jacobian(0, 1) * now.jacobian(1, 0);
    if (determinant == 0.0) {
      return false;
    }
    dx = -(now.jacobian(1, 1) * now.axial - now.jacobian(0, 1) * now.radial) / determinant;
    dr = -(now.jacobian(0, 0) * now.radial - now.jacobian(1, 0) * now.axial) / determinant;
    length = std::sqrt(dx * dx + dr * dr);
    if (!std::isfinite(length)) {
      return false;
    }
    if (length <= position_noise ||
        (now.size() <= accuracy * now.scale && length <= kMaxUnevaluatedStep * m.offset_sum())) {
      return true;
    }
    if (length <=
        1e-7 * now.shallowest) {  // quadratic: what is left after this step is below rounding
      at.x += dx;
      at.rho += dr;
      return true;
    }
    step = std::min(1.0, longest / length);
    halvings = 0;
    trial = {at.x + step * dx, at.rho + step * dr};
  }
}

struct LineOfCentres {
  Point start;
  double closure;  ///< by how much the ball is squeezed between the races [m]
};

/// Halves of both races.
using Halves = std::array<std::size_t, 2>;

/// Ball on the line of groove centres, squeezed by both races in the ratio of their compliances, at
/// least as deep in the outer race as its centrifugal force asks for.
/// @param halves of split races
LineOfCentres line_of_centres(const BallModel& m, const BallSite& site,
                              const RacesInAzimuthFrame<double>& races, Point at,
                              const Halves& halves = {}) {
  const BallInGrooves& own = m.seat(site.own);
  const double K_o = own.hertz[0].reference().K;
  const double K_i = own.hertz[1].reference().K;
  const double soft_o = std::pow(K_o, -2.0 / 3.0);
  const double soft_i = std::pow(K_i, -2.0 / 3.0);
  LineOfCentres result{at, 0.0};
  for (int pass = 0; pass < 3; ++pass) {
    const auto p = groove_positions(m, site, result.start.x, result.start.rho, races);
    std::array<Point, 2> v;  // ball centre minus groove centre, in the plane of this azimuth
    for (std::size_t j = 0; j < 2; ++j) {
      const auto& a = p[j].a;
      const auto& e = p[j].e;
      const double xi = p[j].xi - m.half[j][halves[j]].shift;
      v[j] = {xi * a.x + p[j].eta * e.x, xi * a.y + p[j].eta * e.y};
    }
    const Point outer{result.start.x - v[0].x, result.start.rho - v[0].rho};
    const Point inner{result.start.x - v[1].x, result.start.rho - v[1].rho};
    const double ax = inner.x - outer.x;
    const double ar = inner.rho - outer.rho;
    const double distance = std::hypot(ax, ar);
    result.closure = distance - own.offset_sum();
    const double sunk = soft_o * std::cbrt(own.base_centrifugal * own.base_centrifugal);
    double outer_length =
        own.groove.offset[0] +
        std::max(result.closure * soft_o / (soft_o + soft_i), std::max(sunk, 0.0));
    if (distance == 0.0) {
      result.start = {outer.x, outer.rho + outer_length};
    } else {
      result.start = {outer.x + ax * outer_length / distance,
                      outer.rho + ar * outer_length / distance};
    }
  }
  return result;
}

/// A place where the ball is in no half by more than its offset, which is inside of circles of that
/// radius about the centres of all halves: projected onto one after the other. The rest of the
/// overlap, 0 where there is room for the ball, is `closure`.
LineOfCentres between_halves(const BallModel& m, const BallSite& site,
                             const RacesInAzimuthFrame<double>& races) {
  constexpr int kMaxPasses = 60;
  LineOfCentres out{};
  for (int pass = 0; pass < kMaxPasses; ++pass) {
    out.closure = 0.0;
    for (std::size_t j = 0; j < 2; ++j)
      for (const contact::SplitRaceHalf& half : m.half[j]) {
        const auto p = groove_positions(m, site, out.start.x, out.start.rho, races);
        const double xi = p[j].xi - half.shift, length = std::hypot(xi, p[j].eta);
        const double over = length - m.seat(site.own).groove.offset[j];
        if (!(over > 0.0)) continue;
        out.closure = std::max(out.closure, over);
        const double share = over / length;
        out.start.x -= share * (xi * p[j].a.x + p[j].eta * p[j].e.x);
        out.start.rho -= share * (xi * p[j].a.y + p[j].eta * p[j].e.y);
      }
    if (out.closure <= 4e-16 * m.balls.pitch_diameter) break;
  }
  return out;
}

/// Of a ball with room between split races: outwards until it touches the outer one.
Point touching_outer(const BallModel& m, const BallSite& site,
                     const RacesInAzimuthFrame<double>& races, Point at) {
  const auto p = groove_positions(m, site, at.x, at.rho, races);
  const double s = m.seat(site.own).groove.offset[0];
  double room = std::numeric_limits<double>::infinity();
  for (const contact::SplitRaceHalf& half : m.half[0]) {
    const double xi = p[0].xi - half.shift;
    room = std::min(room, std::sqrt(std::max(0.0, s * s - xi * xi)) - p[0].eta);
  }
  return {at.x + room * p[0].e.x, at.rho + room * p[0].e.y};
}

/// Starts of a ball between split races: between each pair of halves, and where it has most room.
std::vector<Point> split_starts(const BallModel& m, const BallSite& site,
                                const RacesInAzimuthFrame<double>& races) {
  std::vector<Point> out;
  const auto count = [&](std::size_t j) { return m.half[j][0].is_split() ? 2U : 1U; };
  for (std::size_t outer = 0; outer < count(0); ++outer)
    for (std::size_t inner = 0; inner < count(1); ++inner)
      out.push_back(line_of_centres(m, site, races, {}, {outer, inner}).start);
  out.push_back(between_halves(m, site, races).start);
  // Least force first: others may lead to an equilibrium on the wrong side of a split.
  const auto force = [&](const Point& at) { return residual_at(m, site, at, races).size(); };
  std::stable_sort(out.begin(), out.end(),
                   [&](const Point& a, const Point& b) { return force(a) < force(b); });
  return out;
}

}  // namespace

bool solve_ball(const BallModel& m, const RacePose<double>& pose, BallState& ball,
                double accuracy) {
  const RacesInAzimuthFrame<double> races = races_in_azimuth_frame(m, ball.site, pose);
  const Point nominal{};
  ball.idle = false;
  if (m.base_centrifugal == 0.0 && m.split) {
    const LineOfCentres place = between_halves(m, ball.site, races);
    if (place.closure <= 4e-16 * m.balls.pitch_diameter) {
      const Point at = touching_outer(m, ball.site, races, place.start);
      ball.x = at.x;
      ball.rho = at.rho;
      ball.idle = true;
      ball.known = false;
      ball.follow.setZero();
      return true;
    }
  }
  if (m.base_centrifugal == 0.0 && !m.split) {
    const LineOfCentres line = line_of_centres(m, ball.site, races, nominal);
    if (line.closure <= 4e-16 * m.balls.pitch_diameter) {
      ball.x = line.start.x;
      ball.rho = line.start.rho;
      ball.idle = true;
      ball.known = false;
      ball.follow.setZero();
      return true;
    }
  }
  if (ball.known) {
    Point at{ball.x, ball.rho};
    if (newton(m, ball.site, races, accuracy, at)) {
      ball.x = at.x;
      ball.rho = at.rho;
      return true;
    }
  }
  const LineOfCentres line = line_of_centres(m, ball.site, races, nominal);
  const BallInGrooves& own = m.seat(ball.site.own);
  const double seat = std::cbrt(own.base_centrifugal * own.base_centrifugal) *
                      std::pow(own.hertz[0].reference().K, -2.0 / 3.0);
  std::vector<Point> starts =
      m.split ? split_starts(m, ball.site, races) : std::vector<Point>{line.start};
  starts.push_back(Point{
      own.groove.centre_x[0],
      own.groove.centre_radius[0] - 0.5 * m.balls.pitch_diameter + own.groove.offset[0] + seat});
  if (!m.field.isZero(0.0)) {  // it may press the ball against the inner race alone
    const double force = own.mass * m.field.norm();
    const double depth =
        std::cbrt(force * force) * std::pow(own.hertz[1].reference().K, -2.0 / 3.0);
    const auto positions = groove_positions(m, ball.site, 0.0, 0.0, races);
    const auto& [xi, eta, a, e] = positions[1];
    starts.push_back(
        {-(xi * a.x + eta * e.x), -(xi * a.y + eta * e.y) - own.groove.offset[1] - depth});
  }
  // Of a ball at rest that split races squeeze less than the projections above can tell.
  const double nothing = m.split && m.base_centrifugal == 0.0
                             ? own.hertz[0].reference().K * std::pow(1e-11 * own.offset_sum(), 1.5)
                             : -1.0;
  for (Point at : starts) {
    if (newton(m, ball.site, races, accuracy, at)) {
      ball.idle = residual_at(m, ball.site, at, races).scale <= nothing;
      ball.x = at.x;
      ball.rho = at.rho;
      ball.known = !ball.idle;
      if (ball.idle) ball.follow.setZero();
      return true;
    }
  }
  ball.known = false;
  return false;
}

ADORE_CLONES
BallLoadContribution ball_share(const BallModel& m, const RacePose<RaceDual>& race, BallState& ball,
                                bool last_step) {
  BallLoadContribution share;
  if (ball.idle) {
    return share;
  }
  const auto f = ball_forces(m, ball.site, RaceDual::variable(ball.x, 0),
                             RaceDual::variable(ball.rho, 1), race);
  Eigen::Matrix2d on_ball;
  Eigen::Matrix<double, 2, 5> on_ball_race;
  Eigen::Matrix<double, 5, 2> on_race_ball;
  on_ball << f.axial.d[0], f.axial.d[1], f.radial.d[0], f.radial.d[1];
  for (std::size_t k = 0; k < 5; ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    share.load(i) = f.race[k].v;
    on_race_ball(i, 0) = f.race[k].d[0];
    on_race_ball(i, 1) = f.race[k].d[1];
    on_ball_race(0, i) = f.axial.d[k + 2];
    on_ball_race(1, i) = f.radial.d[k + 2];
    for (std::size_t l = 0; l < 5; ++l) {
      share.stiffness(i, static_cast<Eigen::Index>(l)) = f.race[k].d[l + 2];
    }
  }
  if (ball.site.law.axis == SpinLaw::Axis::LeastHeat && f.spin.v != 0.0) {
    ball.site.pitch_guess = std::atan2(f.beta.sin.v, f.beta.cos.v) - ball.site.axis_shift;
  }
  share.largest_load = std::max(f.contact[0].load.v, f.contact[1].load.v);
  const double determinant = on_ball(0, 0) * on_ball(1, 1) - on_ball(0, 1) * on_ball(1, 0);
  if (determinant != 0.0) {
    Eigen::Matrix2d inverse;
    inverse << on_ball(1, 1), -on_ball(0, 1), -on_ball(1, 0), on_ball(0, 0);
    inverse /= determinant;
    ball.follow = -inverse * on_ball_race;
    share.stiffness += on_race_ball * ball.follow;
    const Eigen::Vector2d step = -inverse * Eigen::Vector2d(f.axial.v, f.radial.v);
    if (last_step && step.norm() <= kMaxUnevaluatedStep * m.offset_sum()) {
      ball.x += step(0);
      ball.rho += step(1);
      share.load += on_race_ball * step;
    }
  }
  return share;
}

}  // namespace adore::statics
