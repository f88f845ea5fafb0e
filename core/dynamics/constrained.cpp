#include "dynamics/constrained.hpp"

#include "base/errors.hpp"
#include "base/symmetric_eigen.hpp"
#include "contact/groove_spring.hpp"
#include "contact/hertz.hpp"
#include "contact/wavy_groove.hpp"
#include "dynamics/stiff_inverse.hpp"
#include "statics/dual.hpp"

#include <fmt/format.h>

namespace adore::dynamics {
namespace {

RacePose in_frame(const Mat3& frame, const RacePose& pose) noexcept {
  return {frame * pose.centre, frame * pose.axis, frame * pose.zero,
          pose.to_base * frame.transpose()};
}

constexpr int kMaxIterations = 200;
constexpr int kMaxHalvings = 40;

}  // namespace

Mat3 azimuth_frame(double theta) noexcept {
  Mat3 rows;
  rows.row(0) = Vec3::UnitX().transpose();
  rows.row(1) = radial_direction(theta).transpose();
  rows.row(2) = circumferential_direction(theta).transpose();
  return rows;
}

GrooveContact ConstrainedBall::contact_with(int race, const RacePose& pose,
                                            const Vec2& at) const noexcept {
  using adore::contact::Triple;
  const auto j = static_cast<std::size_t>(race);
  if (half_[j][0].is_split()) return split_contact(race, pose, at);
  if (Vec3 per_turn; wavy_grooves_[j] != nullptr) return wavy_contact(race, pose, at, per_turn);
  const Triple<double> k{pose.axis[0], pose.axis[1], pose.axis[2]};
  const Triple<double> d{at[0] - pose.centre[0], at[1] - pose.centre[1], -pose.centre[2]};
  const auto s = adore::contact::groove_spring(d, k, groove_.centre_radius[j], groove_.offset[j],
                                               K_[j], law_[j].follows ? &law_[j] : nullptr);
  const auto vector = [](const Triple<double>& v) { return Vec3(v.x, v.y, v.z); };

  GrooveContact c;
  c.approach = s.touch.approach;
  c.normal = vector(s.normal);
  const Vec3 side = vector(s.side), around = vector(s.around);
  c.bending =
      (side * side.transpose() + s.place.lift / s.place.distance * around * around.transpose()) /
      s.touch.length;
  if (!(c.approach > 0.0)) return c;
  c.load = s.load;
  c.energy = adore::contact::point_contact_energy(c.load, c.approach);
  c.angle = adore::contact::contact_angle(race, s.touch.n_k, s.touch.n_e);
  c.force = vector(s.force);
  c.stiffness << s.xx, s.xy, s.xz, s.xy, s.yy, s.yz, s.xz, s.yz, s.zz;
  return c;
}

/// The gradient of V as in the kernel, with dual numbers for the ball's place and the race's turn.
GrooveContact ConstrainedBall::wavy_contact(int race, const RacePose& pose, const Vec2& at,
                                            Vec3& per_turn) const noexcept {
  namespace con = adore::contact;
  using D = statics::Dual<4>;
  using con::Triple;
  const auto j = static_cast<std::size_t>(race);
  const auto fixed = [](const Vec3& v) { return Triple<D>{D(v[0]), D(v[1]), D(v[2])}; };
  const Triple<D> k = fixed(pose.axis);
  const Triple<D> d{D::variable(at[0] - pose.centre[0], 0), D::variable(at[1] - pose.centre[1], 1),
                    D::variable(-pose.centre[2], 2)};
  const Triple<D> zero = fixed(pose.zero) + D::variable(0.0, 3) * fixed(pose.axis.cross(pose.zero));
  const auto place = con::groove_coordinates(d, k, groove_.centre_radius[j]);
  con::WavyGrooveContact<D> wavy = con::wavy_groove_contact(
      *wavy_grooves_[j], wavy_grooves_[j]->ratios, con::azimuth_in_race(k, place.e, zero),
      place.axial, place.lift, groove_.offset[j]);
  const con::BallGrooveContact<D>& touch = wavy.touch;
  const Triple<D> t = cross(k, place.e);
  const Triple<D> n = touch.n_k * k + touch.n_e * place.e;
  if (wavy_grooves_[j]->forms != nullptr) {
    const auto base = [&](const Triple<D>& v) {
      const Vec3 out = pose.to_base * Vec3(v.x.v, v.y.v, v.z.v);
      return Triple<double>{out[0], out[1], out[2]};
    };
    const Triple<D> c_axis = cross(t, n);
    const con::Lobe lobe =
        con::lobe_at(*wavy_grooves_[j]->forms, ball_index_, base(n), base(c_axis), base(t));
    // To first order in the direction; how g turns is left out of the stiffness.
    const auto along = [&](const Triple<D>& axis) {
      const Triple<D> fixed_axis{D(axis.x.v), D(axis.y.v), D(axis.z.v)};
      const D part = dot(n, fixed_axis);
      return part - part.v;
    };
    con::add_lobe(wavy, D(lobe.height) + lobe.c * along(c_axis) + lobe.t * along(t), D(lobe.c),
                  D(lobe.t));
  }

  GrooveContact c;
  const auto split = [](const Triple<D>& v, Vec3& value, Mat3& over_place, Vec3& over_turn) {
    const std::array<const D*, 3> parts{&v.x, &v.y, &v.z};
    for (int row = 0; row < 3; ++row) {
      const D& part = *parts[static_cast<std::size_t>(row)];
      value[row] = part.v;
      for (int column = 0; column < 3; ++column)
        over_place(row, column) = part.d[static_cast<std::size_t>(column)];
      over_turn[row] = part.d[3];
    }
  };
  c.approach = touch.approach.v;
  split(n, c.normal, c.bending, per_turn);
  per_turn.setZero();
  if (!(c.approach > 0.0)) return c;
  const D root = statics::square_root(touch.approach);
  con::PolynomialValue<D> K{D(K_[j]), D(0.0)};
  if (law_[j].follows) K = con::polynomial_with_slope(law_[j].K, touch.n_e);
  const D load = con::point_contact_load(K.value * wavy.stiffness, touch.approach, root);
  const D across = con::angle_gradient_force(K.slope * wavy.stiffness, touch.approach, root,
                                             touch.n_k, touch.length);
  const D push = con::wavy_tangential_force(wavy, load, across, touch.approach, place.distance);
  c.load = load.v;
  c.energy = con::point_contact_energy(c.load, c.approach);
  c.angle = con::contact_angle(race, touch.n_k.v, touch.n_e.v);
  const D lean = con::wavy_transverse_force(wavy, load, load, touch.approach);
  const Triple<D> force = push * t - load * n + (across + lean) * cross(t, n);
  split(force, c.force, c.stiffness, per_turn);
  c.stiffness *= -1.0;
  return c;
}

/// The gradient of V of contact/split_race.hpp, with dual numbers for the ball's place.
GrooveContact ConstrainedBall::split_contact(int race, const RacePose& pose,
                                             const Vec2& at) const noexcept {
  namespace con = adore::contact;
  using D = statics::Dual<3>;
  using con::Triple;
  const auto j = static_cast<std::size_t>(race);
  const auto fixed = [](const Vec3& v) { return Triple<D>{D(v[0]), D(v[1]), D(v[2])}; };
  const Triple<D> k = fixed(pose.axis);
  const Triple<D> d{D::variable(at[0] - pose.centre[0], 0), D::variable(at[1] - pose.centre[1], 1),
                    D::variable(-pose.centre[2], 2)};
  const auto place = con::groove_coordinates(d, k, groove_.centre_radius[j]);
  const Triple<D> t = cross(k, place.e);
  const auto fill = [](const Triple<D>& v, Vec3& value, Mat3& over_place) {
    const std::array<const D*, 3> parts{&v.x, &v.y, &v.z};
    for (int row = 0; row < 3; ++row) {
      const D& part = *parts[static_cast<std::size_t>(row)];
      value[row] = part.v;
      for (int column = 0; column < 3; ++column)
        over_place(row, column) = part.d[static_cast<std::size_t>(column)];
    }
  };
  std::array<GrooveContact, 2> both;
  for (std::size_t h = 0; h < 2; ++h) {
    const con::SplitRaceHalf& half = half_[j][h];
    GrooveContact& c = both[h];
    const con::BallGrooveContact<D> touch =
        con::ball_groove_contact(D(place.axial - half.shift), place.lift, groove_.offset[j]);
    const Triple<D> n = touch.n_k * k + touch.n_e * place.e;
    c.approach = touch.approach.v;
    fill(n, c.normal, c.bending);
    if (!(c.approach > 0.0)) continue;
    const D root = statics::square_root(touch.approach);
    con::PolynomialValue<D> K{D(K_[j]), D(0.0)};
    if (law_[j].follows) K = con::polynomial_with_slope(law_[j].K, touch.n_e);
    const D load = con::point_contact_load(K.value, touch.approach, root);
    const auto share =
        con::split_load_fractions(half, load, root, touch.n_k, touch.n_e, touch.length);
    const D across = share.energy * con::angle_gradient_force(K.slope, touch.approach, root,
                                                              touch.n_k, touch.length) +
                     share.turned;
    c.load = share.load.v * load.v;
    c.energy = share.energy.v * con::point_contact_energy(load.v, c.approach);
    c.angle = con::contact_angle(race, touch.n_k.v, touch.n_e.v);
    fill(across * cross(t, n) - (share.load * load) * n, c.force, c.stiffness);
    c.stiffness *= -1.0;
  }
  const bool second = both[1].load > both[0].load ||
                      (both[0].load == both[1].load && both[1].approach > both[0].approach);
  GrooveContact out = both[second ? 1 : 0];
  const GrooveContact& other = both[second ? 0 : 1];
  out.energy += other.energy;
  out.force += other.force;
  out.stiffness += other.stiffness;
  return out;
}

double ConstrainedBall::orbital_speed_at(const Orbit& orbit, double r) const noexcept {
  return orbit.kept == Orbit::Kept::Speed ? orbit.value : orbit.value / (mass_ * r * r);
}

BallBalance ConstrainedBall::evaluate(const std::array<RacePose, 2>& races, double theta,
                                      const Orbit& orbit, const Vec2& force,
                                      const Vec2& x_r) const noexcept {
  BallBalance b;
  b.x = x_r[0];
  b.r = x_r[1];
  const Mat3 frame = azimuth_frame(theta);
  Vec3 contact_force = Vec3::Zero();
  Mat3 stiffness = Mat3::Zero();
  for (std::size_t j = 0; j < 2; ++j) {
    b.contact[j] = contact_with(static_cast<int>(j), in_frame(frame, races[j]), x_r);
    contact_force += b.contact[j].force;
    stiffness += b.contact[j].stiffness;
    b.potential += b.contact[j].energy;
  }
  b.speed = orbital_speed_at(orbit, b.r);
  const double centrifugal = mass_ * b.r * b.speed * b.speed;
  b.residual = contact_force.head<2>() + force + Vec2(0.0, centrifugal);
  b.stiffness = stiffness.topLeftCorner<2, 2>();
  b.per_theta = -b.r * stiffness.block<2, 1>(0, 2);
  b.per_theta[1] += contact_force[2];  // e_r turns with θ
  b.force_theta = contact_force[2];
  b.potential -= force.dot(x_r);
  if (orbit.kept == Orbit::Kept::Speed) {
    b.stiffness(1, 1) -= mass_ * b.speed * b.speed;
    b.per_orbit[1] = 2.0 * mass_ * b.r * b.speed;
    b.potential -= 0.5 * centrifugal * b.r;
  } else {
    b.stiffness(1, 1) += 3.0 * centrifugal / b.r;
    b.per_orbit[1] = 2.0 * b.speed / b.r;
    b.potential += 0.5 * centrifugal * b.r;
  }
  return b;
}

/// Outer contact with approach 0 and no axial normal component: l(p) = s, n_x(p) = 0 by Newton. On
/// an untilted race x is that of the groove's center plane.
Vec2 ConstrainedBall::unloaded_position(const RacePose& race, double theta,
                                        const Vec2& guess) const noexcept {
  const Mat3 frame = azimuth_frame(theta);
  const RacePose outer = in_frame(frame, race);
  Vec2 place(outer.centre[0], outer.centre[1] + groove_.centre_radius[0] + groove_.offset[0]);
  for (int k = 0; k < 50; ++k) {
    const GrooveContact c = contact_with(0, outer, place);
    const Vec2 miss(c.approach, c.normal[0]);
    Mat2 rows;
    rows.row(0) = c.normal.head<2>().transpose();
    rows.row(1) = c.bending.block<1, 2>(0, 0);
    const double size = rows.determinant();
    if (!std::isfinite(size) || size == 0.0) return guess;
    Mat2 adjugate;
    adjugate << rows(1, 1), -rows(0, 1), -rows(1, 0), rows(0, 0);
    const Vec2 step = adjugate * miss / size;
    place -= step;
    if (step.norm() < 1e-15 * groove_.ball_radius) break;
  }
  return place;
}

BallBalance ConstrainedBall::solve(const std::array<RacePose, 2>& races, double theta,
                                   const Orbit& orbit, const Vec2& force,
                                   const Vec2& guess) const noexcept {
  BallBalance b;
  if (orbit.value == 0.0 && force.isZero(0.0)) {
    const Vec2 bottom = unloaded_position(races[0], theta, guess);
    b = evaluate(races, theta, orbit, force, bottom);
    b.solved = !(b.contact[1].load > 0.0);
    if (b.solved) return b;
  }
  b = evaluate(races, theta, orbit, force, guess);
  int iteration = 0;
  for (; iteration < kMaxIterations; ++iteration) {
    // Rounding of l (about 1e-17 m) times the contact stiffness bounds what |G| can reach.
    const double reachable =
        1e-15 * groove_.centre_radius[0] * std::abs(b.stiffness.trace()) + 1e-300;
    const double size = b.residual.norm();
    if (size <= 0.02 * reachable) break;

    const double largest = std::max({b.contact[0].approach, b.contact[1].approach, 0.0});
    const double limit = std::max(3.0 * largest, 0.02 * groove_.offset[0]);
    const SymmetricEigen<2> eigen = symmetric_eigen<2>(b.stiffness);
    Vec2 step = Vec2::Zero();
    for (int k = 0; k < 2; ++k) {
      const Vec2 direction = eigen.vectors.col(k);
      step +=
          direction * direction.dot(b.residual) / std::max(std::abs(eigen.values[k]), kNoStiffness);
    }
    if (step.norm() > limit) step *= limit / step.norm();

    bool better = false;
    for (int halving = 0; halving < kMaxHalvings; ++halving, step *= 0.5) {
      const BallBalance next = evaluate(races, theta, orbit, force, Vec2(b.x, b.r) + step);
      const bool downhill = next.potential < b.potential - 1e-4 * step.dot(b.residual) ||
                            next.residual.norm() < 0.9999 * size;
      if (!downhill || !std::isfinite(next.potential)) continue;
      b = next;
      better = true;
      break;
    }
    if (!better) break;  // rounding: no smaller residual can be found
  }
  b.iterations = iteration;
  const double reachable = 1e-15 * groove_.centre_radius[0] * std::abs(b.stiffness.trace());
  b.solved = b.residual.norm() <= 100.0 * reachable;
  return b;
}

BallSensitivity sensitivity(const BallBalance& balance, double theta) noexcept {
  const Mat2 inverse = stiff_inverse<2>(balance.stiffness, kNoStiffness);
  return {inverse * balance.per_theta, inverse * balance.per_orbit,
          inverse * balance.contact[1].stiffness.topRows<2>() * azimuth_frame(theta)};
}

QuasiStaticTransition hold(const ConstrainedBall& ball, const std::array<RacePose, 2>& races,
                           double theta, const Orbit& orbit, const Vec2& force, const Vec2& place,
                           const Vec2& rates) noexcept {
  QuasiStaticTransition result;
  result.energy_before = 0.5 * ball.mass() * rates.squaredNorm() +
                         ball.evaluate(races, theta, orbit, force, place).potential;
  result.after = ball.solve(races, theta, orbit, force, place);
  result.jump = result.after.potential - result.energy_before;
  return result;
}

void suppress_accelerations(int kdof, std::array<double, 6>& element, std::array<double, 6>& cage) {
  if (kdof < 0 || kdof > 5)
    throw InputError(fmt::format(
        "kDOF = {} is not a code of suppressed motions; give a value from 0 to 5", kdof));
  if (kdof == 0) return;
  if (kdof == 5) {
    element.fill(0.0);
    return;
  }
  const auto suppress = [&](std::array<double, 6>& accelerations) {
    accelerations[0] = 0.0;
    if (kdof == 2 || kdof == 4) accelerations[4] = accelerations[5] = 0.0;
  };
  suppress(element);
  if (kdof <= 2) suppress(cage);
}

}  // namespace adore::dynamics
