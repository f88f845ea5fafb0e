#include "statics/roller_equilibrium.hpp"

#include "statics/ball_forces.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace adore::statics {
namespace {

using D = RollerDual;
using T3 = Triple<D>;

D dot(const T3& a, const T3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
T3 cross(const T3& a, const T3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
T3 minus(const T3& a, const T3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

/// Base frame to azimuth frame: y' = y cos ψ + z sin ψ, r = -y sin ψ + z cos ψ.
T3 to_azimuth(const T3& v, const RollerState& at) {
  return {v[0], v[1] * at.cos + v[2] * at.sin, v[2] * at.cos - v[1] * at.sin};
}
T3 to_base(const T3& v, const RollerState& at) {
  return {v[0], v[1] * at.cos - v[2] * at.sin, v[1] * at.sin + v[2] * at.cos};
}

struct Roller {
  T3 centre, axis;
  D over_tilt_x, over_tilt_r;  ///< da/dθ in (x, r)
};

Roller roller_at(const RollerModel& m, const RollerState& at) {
  const D x = D::variable(at.e(0), 0);
  const D r = D::variable(0.5 * m.rollers.pitch_diameter + at.e(1), 1);
  const D tilt = D::variable(at.e(2) - m.rollers.axis_angle, 2);
  const D s = sine(tilt);
  const D c = cosine(tilt);
  return {{x, D(0.0), r}, {c, D(0.0), s}, -s, c};
}

/// Roller relative to one race.
struct Relative {
  T3 d, A, e, y;
  D x, r, t, f;
  D seen;             ///< r less what a race that is not round has grown where the roller is now
  double lean = 0.0;  ///< dR/dψ of that race
};

/// A race that is not round: `ahead` is the azimuth of the roller in it minus that of its body.
void look_from(const RollerBody& body, std::size_t j, const D& ahead, Relative& out) {
  out.seen = out.r;
  if (j == 1 && body.inner_slope != 0.0) {
    out.lean = body.inner_slope;
    out.seen = out.r - body.inner_slope * ahead;
  }
}

Relative relative(const Roller& roller, const RollerState& at, const RacePlace<D>& race,
                  const RollerBody& body, std::size_t j) {
  Relative out;
  out.d = minus(roller.centre, to_azimuth(race.centre, at));
  out.A = to_azimuth(race.axis, at);
  out.x = dot(out.d, out.A);
  const T3 across = minus(out.d, {out.x * out.A[0], out.x * out.A[1], out.x * out.A[2]});
  out.r = square_root(dot(across, across));
  const D over_r = 1.0 / out.r;
  out.e = {across[0] * over_r, across[1] * over_r, across[2] * over_r};
  out.y = cross(out.e, out.A);
  out.t = dot(roller.axis, out.e);
  out.f = dot(roller.axis, out.y);
  look_from(body, j, -out.e[1], out);
  return out;
}

/// First order (reference family D): x' = x - q_x, r' = r - w, t = θ - g, w = z cos ψ - y sin ψ, g
/// =
/// -(θ_y cos ψ + θ_z sin ψ).
Relative linear_relative(const Roller& roller, const RollerState& at, const RacePlace<D>& race,
                         const RollerBody& body, std::size_t j) {
  Relative out;
  const auto& q = race.q;
  out.x = roller.centre[0] - q[0];
  out.r = roller.centre[2] - (q[2] * at.cos - q[1] * at.sin);
  out.t = D::variable(at.e(2), 2) + (q[3] * at.cos + q[4] * at.sin);
  look_from(body, j, (q[1] * at.cos + q[2] * at.sin) / out.r, out);
  return out;
}

PairPotential potential(const RollerModel& m, const RollerBody& body, std::size_t j,
                        const Vec4& p) {
  PairPotential sum;
  if (m.contact == RollerContact::Point) {
    add_point(body.point[j], p, sum);
  } else if (m.linear) {
    add_slices_linear(m.slices(j, body), p, sum);
  } else {
    add_slices(m.slices(j, body), p, sum);
  }
  return sum;
}

/// Gradient of U as dual numbers of roller and race coordinates.
std::array<D, 4> dual_gradient(const PairPotential& u, const Relative& at) {
  const std::array<const D*, 4> p{&at.x, &at.seen, &at.t, &at.f};
  std::array<D, 4> g;
  for (std::size_t i = 0; i < 4; ++i) {
    g[i].v = u.gradient(static_cast<Eigen::Index>(i));
    for (std::size_t k = 0; k < 8; ++k) {
      for (std::size_t j = 0; j < 4; ++j) {
        g[i].d[k] +=
            u.hessian(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) * p[j]->d[k];
      }
    }
  }
  return g;
}

Vec4 values(const Relative& at) { return {at.x.v, at.seen.v, at.t.v, at.f.v}; }

void add_linear(const std::array<D, 4>& g, const Relative& rel, const RollerState& at, bool inner,
                RollerForces& sum) {
  sum.residual[0] += -g[0];
  sum.residual[1] += -g[1];
  sum.residual[2] += -g[2];
  if (inner) {
    sum.load[0] += -g[0];
    sum.load[1] += g[1] * at.sin;
    sum.load[2] += -g[1] * at.cos;
    sum.load[3] += g[2] * at.cos;
    sum.load[4] += g[2] * at.sin;
    if (rel.lean != 0.0) {
      const D sideways = rel.lean * g[1] / rel.r;
      sum.load[1] += -(sideways * at.cos);
      sum.load[2] += -(sideways * at.sin);
    }
  }
}

/// `gripped`: what the contact pushes along the bearing is taken by its own friction.
void add_exact(const std::array<D, 4>& g, const Roller& roller, const Relative& rel,
               const RollerState& at, bool inner, bool gripped, RollerForces& sum) {
  D side = (g[2] * rel.f - g[3] * rel.t) / rel.r;
  if (rel.lean != 0.0) {
    side += rel.lean * g[1] / rel.r;
  }
  T3 force;
  T3 turning;  // v of M = -a × v
  for (std::size_t k = 0; k < 3; ++k) {
    force[k] = -(g[0] * rel.A[k] + g[1] * rel.e[k] + side * rel.y[k]);
    turning[k] = g[2] * rel.e[k] + g[3] * rel.y[k];
  }
  if (gripped) {
    force[0] = D(0.0);
  }
  sum.residual[0] += force[0];
  sum.residual[1] += force[2];
  sum.residual[2] += -(turning[0] * roller.over_tilt_x + turning[2] * roller.over_tilt_r);
  if (inner) {
    const T3 arm = cross(rel.d, force);
    const T3 own = cross(roller.axis, turning);
    const T3 moment = to_base(minus(arm, own), at);
    const T3 push = to_base(force, at);
    for (std::size_t k = 0; k < 3; ++k) {
      sum.load[k] += push[k];
    }
    sum.load[3] += moment[1];
    sum.load[4] += moment[2];
  }
}

/// What the line search of one roller works on, tilt scaled to a length.
struct Scaled {
  Eigen::Vector3d force;
  Eigen::Matrix3d stiffness;
};
/// A roller that friction holds axially, with no flange against it, does not move that way.
bool is_gripped(const RollerModel& m, const RollerForces& f) { return m.grips && !f.flange_loaded; }

Scaled scaled(const RollerModel& m, const RollerForces& f) {
  Scaled out;
  const Eigen::Vector3d lever(1.0, 1.0, m.lever);
  for (Eigen::Index i = 0; i < 3; ++i) {
    const D& r = f.residual[static_cast<std::size_t>(i)];
    out.force(i) = r.v / lever(i);
    for (Eigen::Index j = 0; j < 3; ++j) {
      out.stiffness(i, j) = -r.d[static_cast<std::size_t>(j)] / (lever(i) * lever(j));
    }
  }
  if (is_gripped(m, f)) {
    out.stiffness.col(0).setZero();
  }
  return out;
}

Eigen::Vector3d unscaled(const RollerModel& m, Eigen::Vector3d step) {
  step(2) /= m.lever;
  return step;
}

/// Newton step; where the stiffness is singular, unloaded modes stay and loaded ones walk.
Eigen::Vector3d roller_step(const RollerModel& m, const Scaled& s, double k_ref, double nothing) {
  const Eigen::Matrix3d K = 0.5 * (s.stiffness + s.stiffness.transpose());
  const double d0 = K(0, 0);
  const double d1 = K(0, 0) * K(1, 1) - K(0, 1) * K(0, 1);
  const double det = K.determinant();
  const double small = 1e-7 * k_ref;
  if (d0 > small && d1 > small * d0 && det > small * d1) {
    return s.stiffness.partialPivLu().solve(s.force);
  }
  const double across = K(1, 1) * K(2, 2) - K(1, 2) * K(1, 2);
  if (K.col(0).isZero(0.0) && s.force(0) == 0.0 && K(1, 1) > small && across > small * K(1, 1)) {
    const Eigen::Matrix2d rest = s.stiffness.bottomRightCorner<2, 2>();
    const Eigen::Vector2d step = rest.partialPivLu().solve(s.force.tail<2>());
    return {0.0, step(0), step(1)};
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(K);
  Eigen::Vector3d step = Eigen::Vector3d::Zero();
  Eigen::Vector3d unresisted = Eigen::Vector3d::Zero();
  for (Eigen::Index k = 0; k < 3; ++k) {
    const Eigen::Vector3d mode = eigen.eigenvectors().col(k);
    const double load = mode.dot(s.force);
    const double stiffness = std::abs(eigen.eigenvalues()(k));
    if (stiffness > 1e-9 * k_ref) {
      step += mode * (load / stiffness);
    } else if (std::abs(load) > nothing) {
      unresisted += mode * load;
    }
  }
  if (unresisted.squaredNorm() > 0.0) {
    step += unresisted * (m.longest_step / unresisted.norm());
  }
  return step;
}

/// Where a roller stands when nothing is known: in the middle between both races; at speed against
/// the outer race.
Eigen::Vector3d first_place(const RollerModel& m, const RollerState& state, const RacePair& races) {
  const auto& q = races.inner.q;
  const double moved = 0.5 * (q[2].v * state.cos - q[1].v * state.sin);
  const double turned = -0.5 * (q[3].v * state.cos + q[4].v * state.sin);
  const double from_outer = -0.5 * (m.outer_tilt[0] * state.cos + m.outer_tilt[1] * state.sin);
  const bool held = m.rollers.axis_angle != 0.0;
  return {held ? 0.5 * q[0].v : 0.0, moved, turned + from_outer};
}

bool newton(const RollerModel& m, const RacePair& races, RollerState& state, RollerForces& forces) {
  constexpr int kIterations = 120;
  const double nothing = m.load_floor;
  forces = roller_forces(m, state, races, false);
  for (int n = 0; n < kIterations; ++n) {
    const Scaled now = scaled(m, forces);
    const double size = now.force.norm();
    if (!std::isfinite(size)) {
      return false;
    }
    const double k_ref = reference_stiffness(m, std::max(forces.total, nothing));
    // Rounding of positions of the size of the pitch radius, through the stiffness.
    const double noise = 2e-16 * m.rollers.pitch_diameter * now.stiffness.diagonal().maxCoeff();
    if (size <= std::max({nothing, noise, 1e-15 * forces.total})) {
      return true;
    }
    Eigen::Vector3d step = roller_step(m, now, k_ref, nothing);
    const double length = step.norm();
    if (!std::isfinite(length) || length == 0.0) {
      return false;
    }
    if (length > m.longest_step) {
      step *= m.longest_step / length;
    }
    // The force along the step must fall to between 90 % and -50 % of its first value.
    const double first = step.dot(now.force);
    double low = 0.0;
    double high = 0.0;
    double t = 1.0;
    RollerState trial = state;
    bool accepted = false;
    for (int attempt = 0; attempt < 50; ++attempt) {
      trial.e = state.e + t * unscaled(m, step);
      if (trial.e.head<2>().norm() > 0.5 * m.rollers.diameter || std::abs(trial.e(2)) > 0.5) {
        return false;
      }
      forces = roller_forces(m, trial, races, false);
      const double slope = step.dot(scaled(m, forces).force);
      const bool closed = high > 0.0 && high - low <= 1e-13 * high;
      if (slope < -0.5 * first && first > 0.0 && !closed) {
        high = t;
        t = low + (high - low) * std::clamp(first / (first - slope), 0.05, 0.5);
      } else if (slope > 0.9 * first && high > 0.0 && !closed) {
        low = t;
        t = 0.5 * (low + high);
      } else {
        accepted = true;
        break;
      }
    }
    if (!accepted) {
      return size <= 1e-9 * std::max(forces.total, nothing);
    }
    const bool at_rounding = t * length <= 1e-16 * m.rollers.pitch_diameter;
    state.e = trial.e;
    if (at_rounding) {
      return true;
    }
  }
  return scaled(m, forces).force.norm() <= 1e-9 * std::max(forces.total, nothing);
}

/// Follows the race: -K⁻¹ ∂R/∂q, without the modes that nothing holds.
Eigen::Matrix<double, 3, 5> following(const RollerModel& m, const RollerForces& f) {
  const Scaled s = scaled(m, f);
  Eigen::Matrix<double, 3, 5> by_race;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const double lever = i == 2 ? m.lever : 1.0;
    for (Eigen::Index k = 0; k < 5; ++k) {
      by_race(i, k) =
          f.residual[static_cast<std::size_t>(i)].d[static_cast<std::size_t>(k) + 3] / lever;
    }
  }
  Eigen::Matrix<double, 3, 5> out = Eigen::Matrix<double, 3, 5>::Zero();
  const double k_ref = s.stiffness.diagonal().cwiseAbs().maxCoeff();
  if (!(k_ref > 0.0)) {
    return out;
  }
  // A spring of 1e-13 of the stiffness keeps free modes still and changes nothing else that can be
  // seen.
  const Eigen::Matrix3d K = s.stiffness + 1e-13 * k_ref * Eigen::Matrix3d::Identity();
  out = K.partialPivLu().solve(by_race);
  out.row(2) /= m.lever;
  return out;
}

}  // namespace

RacePlace<RollerDual> outer_place(const RollerModel& m) {
  RacePlace<D> place;
  if (m.outer_tilt[0] != 0.0 || m.outer_tilt[1] != 0.0) {
    place.axis = tilted_axis(D(m.outer_tilt[0]), D(m.outer_tilt[1]));
  }
  place.q = {D(0.0), D(0.0), D(0.0), D(m.outer_tilt[0]), D(m.outer_tilt[1])};
  return place;
}

RacePlace<RollerDual> inner_place(const Vec5& q) {
  RacePlace<D> place;
  for (int k = 0; k < 5; ++k) {
    place.q[static_cast<std::size_t>(k)] = D::variable(q(k), k + 3);
  }
  place.centre = {place.q[0], place.q[1], place.q[2]};
  place.axis = tilted_axis(place.q[3], place.q[4]);
  return place;
}

Vec4 relative_pose(const RollerModel& m, const RollerState& at, std::size_t j,
                   const RacePair& races) {
  const Roller roller = roller_at(m, at);
  const RollerBody& body = m.body(at.number);
  const auto& race = j == 0 ? races.outer : races.inner;
  return values(m.linear ? linear_relative(roller, at, race, body, j)
                         : relative(roller, at, race, body, j));
}

RollerForces roller_forces(const RollerModel& m, const RollerState& at, const RacePair& races,
                           bool exact_derivatives) {
  RollerForces sum;
  const Roller roller = roller_at(m, at);
  const RollerBody& body = m.body(at.number);
  for (std::size_t j = 0; j < 2; ++j) {
    const RacePlace<D>& race = j == 0 ? races.outer : races.inner;
    const Relative rel =
        m.linear ? linear_relative(roller, at, race, body, j) : relative(roller, at, race, body, j);
    const Vec4 p = values(rel);
    PairPotential u = potential(m, body, j, p);
    const double of_race = u.total;
    sum.largest = std::max(sum.largest, of_race);
    PairPotential ends;
    for (const FlangePair& flange : body.flanges) {
      if (flange.race == static_cast<int>(j)) {
        add_flange(flange, p, exact_derivatives, m.grips ? ends : u);
      }
    }
    sum.flange_loaded = sum.flange_loaded || ends.total > 0.0 || u.total > of_race;
    sum.total += u.total + ends.total;
    if (u.total > 0.0) {
      const auto g = dual_gradient(u, rel);
      if (m.linear) {
        add_linear(g, rel, at, j == 1, sum);
      } else {
        add_exact(g, roller, rel, at, j == 1, m.grips, sum);
      }
    }
    if (ends.total > 0.0) {
      add_exact(dual_gradient(ends, rel), roller, rel, at, j == 1, false, sum);
    }
  }
  if (m.moving) {
    sum.residual[0] += D(m.guide[0]);
    sum.residual[1] += D(m.centrifugal + m.guide[1]);
    sum.residual[2] += m.centrifugal * m.mass_offset * roller.over_tilt_r + m.gyroscopic;
    sum.total += m.centrifugal;
  }
  return sum;
}

bool solve_roller(const RollerModel& m, const RacePair& races, RollerState& state,
                  RollerForces& forces) {
  if (!m.moving) {
    RollerState middle = state;
    middle.e = first_place(m, state, races);
    forces = roller_forces(m, middle, races);
    if (forces.total == 0.0) {
      state.e = middle.e;
      state.idle = true;
      state.known = false;
      return true;
    }
  }
  state.idle = false;
  if (state.known && newton(m, races, state, forces)) {
    return true;
  }
  state.e = first_place(m, state, races);
  state.known = newton(m, races, state, forces);
  return state.known;
}

RaceScales race_scales(const RollerModel& m) {
  return {0.5 * m.rollers.pitch_diameter, m.longest_step, 0.5 * m.rollers.diameter,
          m.rollers.pitch_diameter, m.centrifugal};
}

double reference_stiffness(const RollerModel& m, double load) {
  const double delta = line_approach(m, std::max(load, 1e-300));
  return load > 0.0 ? 10.0 / 9.0 * load / delta : 0.0;
}

bool update_race(const RollerModel& m, const Vec5& q, RollerRace& state) {
  const RacePlace<D> outer = outer_place(m);
  const RacePlace<D> inner = inner_place(q);
  const RacePair races{outer, inner};
  const Vec5 change = q - state.q;
  state.load.setZero();
  state.stiffness.setZero();
  state.largest_contact = 0.0;
  RollerForces forces;
  for (RollerState& roller : state.elements) {
    if (roller.known) {
      const Eigen::Vector3d shift = roller.follow * change;
      if (shift.head<2>().norm() + m.lever * std::abs(shift(2)) < m.longest_step) {
        roller.e += shift;
      }
    }
    if (!solve_roller(m, races, roller, forces)) {
      return false;
    }
    if (!m.body(roller.number).flanges.empty() && forces.flange_loaded) {
      forces = roller_forces(m, roller, races);
    }
    roller.follow = following(m, forces);
    if (forces.total == 0.0) {
      continue;
    }
    Eigen::Matrix<double, 5, 3> by_roller;
    for (Eigen::Index i = 0; i < 5; ++i) {
      const D& load = forces.load[static_cast<std::size_t>(i)];
      state.load(i) += load.v;
      for (Eigen::Index k = 0; k < 3; ++k) {
        by_roller(i, k) = load.d[static_cast<std::size_t>(k)];
      }
      for (Eigen::Index k = 0; k < 5; ++k) {
        state.stiffness(i, k) += load.d[static_cast<std::size_t>(k) + 3];
      }
    }
    state.stiffness += by_roller * roller.follow;
    state.largest_contact = std::max(state.largest_contact, forces.largest);
  }
  state.q = q;
  return true;
}

}  // namespace adore::statics
