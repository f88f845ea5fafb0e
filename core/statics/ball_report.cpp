#include "statics/ball_report.hpp"

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "statics/race_text.hpp"

#include <Eigen/LU>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace adore::statics {
namespace {

constexpr std::array<const char*, 2> kRaceName{"outer", "inner"};

/// Row of the no-slip condition at race j for the unknowns (ω_m, ω_x, ω_r), all absolute:
///   Ω η' - r ω_m (e_θ·t) - (Ω a - ω)·c h = 0,  η' distance from the race axis, c = t × n the major
///   axis of the ellipse.
struct SlipRow {
  Eigen::RowVector3d coefficients;
  double right = 0.0;
  Triple<double> normal{};
  double axis_normal = 0.0;  ///< a·n
};

SlipRow slip_row(const BallModel& m, const BallSite& site, std::size_t j,
                 const BallForces<double>& f, double r, double a_half) {
  const auto& p = f.position[j];
  const auto& c = f.contact[j];
  const Triple<double> major = c.n_k * p.e - c.n_e * p.a;
  const BallInGrooves& seat = m.seat(site.own);
  const double rho = seat.surface_radius[j];
  const double ball = seat.groove.ball_radius;
  const double a2 = a_half * a_half;
  const double height = a2 / (rho + std::sqrt(rho * rho - a2)) + std::sqrt(ball * ball - a2);
  const double arm = p.eta + seat.groove.centre_radius[j];
  SlipRow row;
  row.coefficients << -r * cross(p.a, p.e).z, height * major.x, height * major.y;
  row.right = -m.race_speed[j] * (arm + c.n_e * height);
  row.normal = c.n_k * p.a + c.n_e * p.e;
  row.axis_normal = c.n_k;
  return row;
}

void report_speeds(const BallModel& m, const BallSite& site, const BallForces<double>& f, double r,
                   StaticBall& s) {
  if (!m.moving) {
    return;
  }
  const BallInGrooves& seat = m.seat(site.own);
  const bool outer = f.contact[0].load > 0.0;
  const bool inner = f.contact[1].load > 0.0;
  if (outer && inner && !m.per_ball_speeds) {
    // Nominal orbit: the spin that rolls on both races at the ball's own angles, for reports only.
    BallForces<double> own = f;
    BallModel per_ball = m;
    per_ball.per_ball_speeds = true;
    add_inertia(per_ball, site, r - 0.5 * m.balls.pitch_diameter, own);
    s.pitch_angle = std::atan2(own.beta.sin, own.beta.cos);
    s.spin_speed = own.spin;
    s.omega_x = f.orbital - own.spin * own.beta.cos;
    s.omega_r = own.spin * own.beta.sin;
    return;
  }
  if (!(outer && inner)) {
    s.pitch_angle = kNaN;
    s.omega_x = s.orbital_speed;
    if (outer) {
      const Direction<double> straight{0.0, 1.0};
      const double spin = (f.orbital - m.race_speed[0]) *
                          (1.0 + seat.gamma * f.contact[0].alpha.cos) /
                          (seat.gamma * cos_between(straight, f.contact[0].alpha));
      s.spin_speed = spin;
      s.omega_x = f.orbital - spin;
      if (m.exact) {
        const SlipRow row = slip_row(m, site, 0, f, r, s.a[0]);
        s.omega_x = (row.right - row.coefficients(0) * f.orbital) / row.coefficients(1);
        s.spin_speed = f.orbital - s.omega_x;
      }
    }
    return;
  }
  s.pitch_angle = std::atan2(f.beta.sin, f.beta.cos);
  s.spin_speed = f.spin;
  s.omega_x = f.orbital - f.spin * f.beta.cos;
  s.omega_r = f.spin * f.beta.sin;
  if (!m.exact || s.Q[1] < seat.window) {
    return;
  }
  Eigen::Matrix3d A;
  Eigen::Vector3d b;
  std::array<SlipRow, 2> rows;
  for (std::size_t j = 0; j < 2; ++j) {
    rows[j] = slip_row(m, site, j, f, r, s.a[j]);
    A.row(static_cast<Eigen::Index>(j)) = rows[j].coefficients;
    b(static_cast<Eigen::Index>(j)) = rows[j].right;
  }
  if (site.law.axis == SpinLaw::Axis::OuterControl ||
      site.law.axis == SpinLaw::Axis::InnerControl) {
    const std::size_t j = site.law.axis == SpinLaw::Axis::OuterControl ? 0 : 1;
    A.row(2) << 0.0, rows[j].normal.x, rows[j].normal.y;
    b(2) = m.race_speed[j] * rows[j].axis_normal;
  } else {
    A.row(2) << -f.beta.sin, f.beta.sin, f.beta.cos;  // (ω_x - ω_m) sin β + ω_r cos β = 0
    b(2) = 0.0;
  }
  const Eigen::Vector3d speeds = A.partialPivLu().solve(b);
  s.orbital_speed = speeds(0);
  s.omega_x = speeds(1);
  s.omega_r = speeds(2);
  s.spin_speed = std::copysign(std::hypot(speeds(1) - speeds(0), speeds(2)), f.spin);
}

/// Share of the load of a Hertz ellipse beyond ξ = x/a on its major axis: the pressure
/// sqrt(1 - ξ² - η²), integrated over η, leaves ¾ (1 - ξ²) per ξ.
double load_beyond(double xi) {
  const double s = std::clamp(xi, -1.0, 1.0);
  return 0.25 * (2.0 - 3.0 * s + s * s * s);
}

/// N94: far edge against the shoulder, near edge against the groove-centre plane.
void report_edges(const BallModel& m, const BallInGrooves& seat, std::size_t j, StaticBall& s) {
  const double shoulder = 0.5 * m.balls.shoulder_diameter[j];
  const contact::ContactEdges edges =
      contact::contact_edges(seat.groove, static_cast<int>(j), s.alpha[j], s.a[j], shoulder);
  s.inner_chord[j] = edges.centre_chord;
  s.shoulder_depth[j] = shoulder > 0.0 ? edges.shoulder_depth : kNaN;
  if (edges.shoulder_depth < 0.0) {
    const double radius = seat.groove.groove_radius[j];
    const double sign = j == 0 ? 1.0 : -1.0;
    const double below = sign * (seat.groove.centre_radius[j] - shoulder);
    const double edge = std::acos(std::clamp(-below / radius, -1.0, 1.0));
    s.beyond[j] = s.Q[j] * load_beyond((edge - std::abs(s.alpha[j])) / (s.a[j] / radius));
  }
}

/// The contact surface, an arc through the ends of the ellipse, needs a ball that is longer than
/// these.
void check_ellipse(const BallInGrooves& seat, std::size_t j, const StaticBall& s) {
  const double radius = seat.groove.ball_radius;
  if (s.a[j] < radius) {
    return;
  }
  throw SolverError(fmt::format(
      "bearing equilibrium: at a contact load of {:.6g} N at the {} race, the semi-major axis of "
      "the contact ellipse, {:.4g} m, reaches the ball radius of {:.4g} m. The groove conforms "
      "closely to the ball (groove factor {:.6g}, pressure only {:.3g} Pa). Hertz theory is not "
      "valid for such an ellipse. Enter a larger groove factor or less load",
      s.Q[j], kRaceName[j], s.a[j], radius, seat.groove.groove_radius[j] / (2.0 * radius),
      s.p_max[j]));
}

/// Gap between the ball and the other half of a split race. A shim g ground off shifts the arcs of
/// the halves by g against each other, towards and past the split, which stands g/2 from the arc
/// centre in use on the side of the contact. Where the ball's nearest point of the other arc would
/// lie beyond the split, the ridge is the nearest.
/// @param xi from the arc in use, along the race axis
double gap_to_other_half(const BallModel& m, const BallInGrooves& seat, std::size_t j, double xi,
                         double eta) {
  const double shim = m.balls.shim[j];
  if (!(shim > 0.0)) {
    return kNaN;
  }
  const double radius = seat.groove.groove_radius[j];
  const double towards = std::abs(xi);  // along the axis, to the side of the contact
  const double from_other = towards - shim;
  const double length = std::hypot(from_other, eta);
  if (radius * from_other < -0.5 * shim * length) {
    return seat.groove.offset[j] - length;
  }
  const double ridge = std::sqrt(radius * radius - 0.25 * shim * shim);
  return std::hypot(towards - 0.5 * shim, std::abs(eta) - ridge) - seat.groove.ball_radius;
}

template <class Predicate>
std::vector<std::size_t> balls_that(const std::vector<StaticBall>& balls, Predicate predicate) {
  std::vector<std::size_t> numbers;
  for (std::size_t k = 0; k < balls.size(); ++k) {
    if (predicate(balls[k])) {
      numbers.push_back(k + 1);
    }
  }
  return numbers;
}

/// Balls on both halves of a split race, and ellipses that the split cuts.
void note_split_race(const BallModel& m, std::size_t j, const std::vector<StaticBall>& balls,
                     std::vector<Finding>& notes) {
  if (!(m.balls.shim[j] > 0.0)) return;
  const auto note = [&](const char* code, const std::vector<std::size_t>& numbers,
                        std::string text) -> Finding& {
    notes.push_back(make_finding(code, std::move(text)));
    return notes.back().of(fmt::format("{}, {} race", number_list(numbers, "ball"), kRaceName[j]));
  };
  const auto dual = balls_that(balls, [&](const StaticBall& b) { return b.second[j].Q > 0.0; });
  if (!dual.empty()) {
    double heaviest = 0.0;
    for (const StaticBall& b : balls) heaviest = std::max(heaviest, b.second[j].Q);
    note("statics.dual_contact", dual,
         fmt::format("{}: dual contact with both halves of the split {} race; the load of the "
                     "second contact is up to {:.4g} N",
                     number_list(dual, "ball"), kRaceName[j], heaviest))
        .measure(heaviest);
  }
  const auto forward = balls_that(
      balls, [&](const StaticBall& b) { return b.alpha[j] > 0.0 && !(b.second[j].Q > 0.0); });
  const auto backward = balls_that(
      balls, [&](const StaticBall& b) { return b.alpha[j] < 0.0 && !(b.second[j].Q > 0.0); });
  if (!forward.empty() && !backward.empty())
    note("statics.split_race", forward,
         fmt::format("the balls touch both halves of the split {} race: {} on one half, {} on the "
                     "other half",
                     kRaceName[j], number_list(forward, "ball"), number_list(backward, "ball")));
  const auto cut = balls_that(
      balls, [&](const StaticBall& b) { return b.share[j] < 1.0 && !(b.second[j].Q > 0.0); });
  if (!cut.empty())
    note("statics.dual_contact", cut,
         fmt::format("{}: the split of the {} race cuts the contact ellipse, so dual contact is "
                     "possible",
                     number_list(cut, "ball"), kRaceName[j]));
}

/// One contact of a ball, and where it is cut by a split.
struct Contact {
  double Q, alpha, delta, a, b, p_max, K, share, E_integral;
};
/// @param whole load of the whole ellipse
Contact contact_of(const BallInGrooves& seat, std::size_t j, double alpha, double delta,
                   double load, double whole) {
  const contact::HertzConstants hertz = seat.hertz[j].at(alpha);
  const double cube_root = std::cbrt(whole);
  Contact c{load, alpha,   delta,        hertz.a_hat * cube_root, hertz.b_hat * cube_root,
            0.0,  hertz.K, load / whole, hertz.E_integral};
  c.p_max = 1.5 * whole / (std::numbers::pi * c.a * c.b);
  return c;
}

/// Both contacts of a ball with a split race, the one with more load first. @returns the half
std::size_t report_halves(const BallModel& m, const BallInGrooves& seat, std::size_t j,
                          const GroovePosition<double>& p, Contact& first, SecondContact& second) {
  std::array<ContactState<double>, 2> state;
  std::array<double, 2> whole{};
  for (std::size_t h = 0; h < 2; ++h) {
    state[h] = half_contact_state(m, seat, j, p, h);
    if (!(state[h].load > 0.0)) continue;
    GroovePosition<double> of_half = p;
    of_half.xi -= m.half[j][h].shift;
    whole[h] = contact_state(m, seat, j, of_half).load;
  }
  const std::size_t heavy = state[1].load > state[0].load ? 1 : 0;
  const auto of = [&](std::size_t h) {
    const ContactState<double>& c = state[h];
    return contact_of(seat, j, contact::contact_angle(static_cast<int>(j), c.n_k, c.n_e),
                      c.approach, c.load, whole[h]);
  };
  first = of(heavy);
  if (const std::size_t light = 1 - heavy; state[light].load > 0.0) {
    const Contact c = of(light);
    second = {c.Q, c.alpha, c.delta, c.a, c.b, c.p_max, c.K, c.share, 0.0, 0.0};
  }
  return heavy;
}

}  // namespace

StaticBall ball_at_second_contacts(const StaticBall& ball) {
  StaticBall out = ball;
  for (std::size_t j = 0; j < 2; ++j) {
    const SecondContact& second = ball.second[j];
    out.Q[j] = second.Q;
    out.alpha[j] = second.Q > 0.0 ? second.alpha : kNaN;
    out.delta[j] = second.delta;
    out.a[j] = second.a, out.b[j] = second.b, out.p_max[j] = second.p_max;
    out.K[j] = second.K, out.share[j] = second.share;
    out.inner_chord[j] = second.Q > 0.0 ? second.inner_chord : kNaN;
    out.shoulder_depth[j] = second.Q > 0.0 ? second.shoulder_depth : kNaN;
    out.beyond[j] = 0.0;
    out.second[j] = {};
  }
  return out;
}

std::vector<StaticBall> StaticSolution::second_contacts() const {
  std::vector<StaticBall> out;
  for (const StaticBall& ball : balls)
    if (has_second_contact(ball)) out.push_back(ball_at_second_contacts(ball));
  return out;
}

StaticBall report_ball(const BallModel& m, const std::array<double, 5>& q, const BallState& ball) {
  StaticBall s;
  const BallSite& site = ball.site;
  const BallInGrooves& seat = m.seat(site.own);
  const auto f = ball_forces<double>(m, site, ball.x, ball.rho, inner_race_pose<double>(m, q));
  s.x = ball.x;
  s.r = 0.5 * m.balls.pitch_diameter + ball.rho;
  s.inner_contact = !ball.idle && f.contact[1].load > 0.0;
  s.inner_race_control = site.law.axis == SpinLaw::Axis::InnerControl;
  s.axis_shift = site.axis_shift;
  s.race_control_ratio = kNaN;
  std::array<double, 2> capacity{};
  for (std::size_t j = 0; j < 2; ++j) {
    const auto& c = f.contact[j];
    const bool loaded = !ball.idle && c.load > 0.0;
    const double alpha = contact::contact_angle(static_cast<int>(j), c.n_k, c.n_e);
    s.alpha[j] = loaded ? alpha : kNaN;
    s.delta[j] = c.approach;
    s.spin_roll[j] = kNaN;
    s.friction[j] = loaded ? std::abs(c.friction) / c.load : kNaN;
    s.shoulder_depth[j] = kNaN;
    s.inner_chord[j] = kNaN;
    s.other_half[j] = kNaN;
    const contact::HertzConstants hertz = loaded
                                              ? local_hertz_constants(seat, j, f.position[j], alpha)
                                              : seat.hertz[j].at(m.balls.contact_angle);
    s.K[j] = hertz.K;
    if (!loaded) {
      continue;
    }
    s.Q[j] = c.load;
    const double cube_root = std::cbrt(c.load);
    s.a[j] = hertz.a_hat * cube_root;
    s.b[j] = hertz.b_hat * cube_root;
    s.p_max[j] = 1.5 * c.load / (std::numbers::pi * s.a[j] * s.b[j]);
    capacity[j] = c.load * s.a[j] * hertz.E_integral;
    if (m.half[j][0].is_split()) {
      const GroovePosition<double>& p = f.position[j];
      Contact first{};
      const std::size_t half = report_halves(m, seat, j, p, first, s.second[j]);
      s.Q[j] = first.Q, s.alpha[j] = first.alpha, s.delta[j] = first.delta;
      s.a[j] = first.a, s.b[j] = first.b, s.p_max[j] = first.p_max;
      s.K[j] = first.K, s.share[j] = first.share;
      s.other_half[j] = gap_to_other_half(m, seat, j, p.xi - m.half[j][half].shift, p.eta);
      if (s.second[j].Q > 0.0) {
        StaticBall other = ball_at_second_contacts(s);
        check_ellipse(seat, j, other);
        report_edges(m, seat, j, other);
        s.second[j].inner_chord = other.inner_chord[j];
        s.second[j].shoulder_depth = other.shoulder_depth[j];
      }
    }
    check_ellipse(seat, j, s);
    report_edges(m, seat, j, s);
  }
  s.edge = {s.shoulder_depth[0], s.inner_chord[1]};
  s.orbital_speed = f.orbital;
  s.centrifugal_force = ball.idle ? 0.0 : f.centrifugal;
  s.gyroscopic_moment = f.gyroscopic;
  s.pitch_angle = kNaN;
  report_speeds(m, site, f, s.r, s);
  if (capacity[0] > 0.0 && capacity[1] > 0.0) {
    const auto& outer = f.contact[0].alpha;
    const auto& inner = f.contact[1].alpha;
    s.race_control_ratio = capacity[0] * cos_between(inner, outer) / capacity[1];
    if (m.moving) {
      const Direction<double> beta{std::sin(s.pitch_angle), std::cos(s.pitch_angle)};
      s.spin_roll[0] = seat.gamma * outer.sin - (1.0 + seat.gamma * outer.cos) *
                                                    sin_between(outer, beta) /
                                                    cos_between(outer, beta);
      s.spin_roll[1] = seat.gamma * inner.sin + (1.0 - seat.gamma * inner.cos) *
                                                    sin_between(inner, beta) /
                                                    cos_between(inner, beta);
    }
  }
  return s;
}

std::vector<Finding> ball_notes(const BallModel& m, const std::vector<StaticBall>& balls) {
  std::vector<Finding> notes;
  const auto note = [&](const char* code, const std::vector<std::size_t>& numbers,
                        const char* text) -> Finding& {
    const std::string list = number_list(numbers, "ball");
    notes.push_back(make_finding(code, fmt::format("{}: {}", list, text)));
    return notes.back().of(list);
  };
  const auto outer_only =
      balls_that(balls, [](const StaticBall& b) { return b.Q[0] > 0.0 && !b.inner_contact; });
  if (!outer_only.empty()) {
    note("statics.outer_only", outer_only,
         "contact with the outer race only, at the point where the normal of the outer groove is "
         "parallel to the centrifugal force");
  }
  const auto unloaded =
      balls_that(balls, [](const StaticBall& b) { return b.Q[0] == 0.0 && b.Q[1] == 0.0; });
  if (!unloaded.empty()) {
    note("statics.unloaded", unloaded,
         "no load. The position at rest is assumed: contact with the outer race, on the line "
         "between the groove centers");
  }
  const auto steep = balls_that(balls, [](const StaticBall& b) {
    return std::abs(b.alpha[0]) > 0.5 * std::numbers::pi ||
           std::abs(b.alpha[1]) > 0.5 * std::numbers::pi;
  });
  if (!steep.empty()) {
    double largest = 0.0;
    for (const std::size_t k : steep)
      for (const double alpha : balls[k - 1].alpha)
        if (std::isfinite(alpha)) largest = std::max(largest, std::abs(alpha));
    note("statics.steep_angle", steep,
         "the contact angle exceeds 90 degrees, which is not possible in a real groove")
        .measure(largest * 180.0 / std::numbers::pi, 90.0);
  }
  for (std::size_t j = 0; j < 2; ++j) {
    note_split_race(m, j, balls, notes);
  }
  return notes;
}

void fill_summary(const BallModel& m, StaticSolution& s) {
  s.max_load = s.max_deflection = s.max_stiffness = 0.0;
  double heaviest = -1.0;
  for (const StaticBall& ball : s.balls) {
    for (std::size_t j = 0; j < 2; ++j) {
      s.max_load = std::max(s.max_load, ball.Q[j]);
      if (ball.Q[j] > 0.0) {
        s.max_deflection = std::max(s.max_deflection, ball.delta[j]);
        s.max_stiffness = std::max(s.max_stiffness, 1.5 * ball.Q[j] / ball.delta[j]);
      }
    }
    if (ball.inner_contact && ball.Q[1] > heaviest) {
      heaviest = ball.Q[1];
      s.race_control_ratio = ball.race_control_ratio;
      s.hertz = {m.hertz[0].at(ball.alpha[0]), m.hertz[1].at(ball.alpha[1])};
    }
  }
  if (heaviest < 0.0) {
    s.hertz = {m.hertz[0].reference(), m.hertz[1].reference()};
  }
}

}  // namespace adore::statics
