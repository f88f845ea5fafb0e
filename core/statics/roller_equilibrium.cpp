#include "statics/roller_equilibrium.hpp"

#include "statics/ball_forces.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <vector>

namespace adore::statics {
namespace {

/// Derivatives over the roller only, while it is brought into equilibrium; one unused, so that
/// loops fill vector registers.
using PlaceDual = Dual<4>;
/// Derivatives over the roller (0: x, 1: r, 2: tilt) and the inner race (3-7).
using RollerDual = Dual<8>;

template <class S>
using Triple = std::array<S, 3>;

template <class S>
S dot(const Triple<S>& a, const Triple<S>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class S>
Triple<S> cross(const Triple<S>& a, const Triple<S>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
template <class S>
Triple<S> minus(const Triple<S>& a, const Triple<S>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// Base frame to azimuth frame: y' = y cos ψ + z sin ψ, r = -y sin ψ + z cos ψ.
template <class S>
Triple<S> to_azimuth(const Triple<S>& v, const RollerState& at) {
  return {v[0], v[1] * at.cos + v[2] * at.sin, v[2] * at.cos - v[1] * at.sin};
}
template <class S>
Triple<S> to_base(const Triple<S>& v, const RollerState& at) {
  return {v[0], v[1] * at.cos - v[2] * at.sin, v[1] * at.sin + v[2] * at.cos};
}

/// Coordinate k of the roller (0-2) or of the inner race (3-7).
template <class S>
S coordinate(double value, int k) {
  if constexpr (std::is_same_v<S, RollerDual>) {
    return S::variable(value, k);
  } else if constexpr (std::is_same_v<S, PlaceDual>) {
    return k < 3 ? S::variable(value, k) : S(value);
  } else {
    return value;
  }
}

/// Pose of a race in the base frame.
template <class S>
struct RacePlace {
  Triple<S> centre{};
  Triple<S> axis{S(1.0), S(0.0), S(0.0)};
  std::array<S, 5> q{};  ///< displacement (linear kinematics)
};
/// Outer and inner.
template <class S>
using Races = std::array<RacePlace<S>, 2>;

template <class S>
Races<S> races_at(const RollerModel& m, const Vec5& q) {
  Races<S> races;
  auto& [outer, inner] = races;
  if (m.outer_tilt[0] != 0.0 || m.outer_tilt[1] != 0.0) {
    outer.axis = tilted_axis(S(m.outer_tilt[0]), S(m.outer_tilt[1]));
  }
  outer.q = {S(0.0), S(0.0), S(0.0), S(m.outer_tilt[0]), S(m.outer_tilt[1])};
  for (int k = 0; k < 5; ++k) {
    inner.q[static_cast<std::size_t>(k)] = coordinate<S>(q(k), k + 3);
  }
  inner.centre = {inner.q[0], inner.q[1], inner.q[2]};
  inner.axis = tilted_axis(inner.q[3], inner.q[4]);
  return races;
}

template <class S>
struct Roller {
  Triple<S> centre, axis;
  S over_tilt_x, over_tilt_r;  ///< da/dθ in (x, r)
};

template <class S>
Roller<S> roller_at(const RollerModel& m, const RollerState& at) {
  const S x = coordinate<S>(at.e(0), 0);
  const S r = coordinate<S>(0.5 * m.rollers.pitch_diameter + at.e(1), 1);
  const S tilt = coordinate<S>(at.e(2) - m.rollers.axis_angle, 2);
  const S s = sine(tilt);
  const S c = cosine(tilt);
  return {{x, S(0.0), r}, {c, S(0.0), s}, -s, c};
}

/// Roller relative to one race.
template <class S>
struct Relative {
  Triple<S> d, A, e, y;
  S x, r, t, f;
  S seen;             ///< r less what a race that is not round has grown where the roller is now
  double lean = 0.0;  ///< dR/dψ of that race

  [[nodiscard]] Vec4 values() const {
    return {value_of(x), value_of(seen), value_of(t), value_of(f)};
  }
};

/// A race that is not round: `ahead` is the azimuth of the roller in it minus that of its body.
template <class S>
void look_from(const RollerBody& body, std::size_t j, const S& ahead, Relative<S>& out) {
  out.seen = out.r;
  if (j == 1 && body.inner_slope != 0.0) {
    out.lean = body.inner_slope;
    out.seen = out.r - body.inner_slope * ahead;
  }
}

/// First order (reference family D): x' = x - q_x, r' = r - w, t = θ - g, w = z cos ψ - y sin ψ, g
/// =
/// -(θ_y cos ψ + θ_z sin ψ).
template <class S>
Relative<S> linear_relative(const Roller<S>& roller, const RollerState& at,
                            const RacePlace<S>& race, const RollerBody& body, std::size_t j) {
  Relative<S> out;
  const auto& q = race.q;
  out.x = roller.centre[0] - q[0];
  out.r = roller.centre[2] - (q[2] * at.cos - q[1] * at.sin);
  out.t = coordinate<S>(at.e(2), 2) + (q[3] * at.cos + q[4] * at.sin);
  look_from(body, j, (q[1] * at.cos + q[2] * at.sin) / out.r, out);
  return out;
}

template <class S>
Relative<S> relative(const RollerModel& m, const Roller<S>& roller, const RollerState& at,
                     const RacePlace<S>& race, std::size_t j) {
  const RollerBody& body = m.body(at.number);
  if (m.linear) {
    return linear_relative(roller, at, race, body, j);
  }
  Relative<S> out;
  out.d = minus(roller.centre, to_azimuth(race.centre, at));
  out.A = to_azimuth(race.axis, at);
  out.x = dot(out.d, out.A);
  const Triple<S> across = minus(out.d, {out.x * out.A[0], out.x * out.A[1], out.x * out.A[2]});
  out.r = square_root(dot(across, across));
  const S over_r = 1.0 / out.r;
  out.e = {across[0] * over_r, across[1] * over_r, across[2] * over_r};
  out.y = cross(out.e, out.A);
  out.t = dot(roller.axis, out.e);
  out.f = dot(roller.axis, out.y);
  look_from(body, j, -out.e[1], out);
  return out;
}

/// A roller at one pose as seen from both races.
template <class S>
struct Pose {
  Roller<S> roller;
  std::array<Relative<S>, 2> seen_from;
};
template <class S>
Pose<S> pose_of(const RollerModel& m, const RollerState& at, const Races<S>& races) {
  const Roller<S> roller = roller_at<S>(m, at);
  return {roller, {relative(m, roller, at, races[0], 0), relative(m, roller, at, races[1], 1)}};
}

/// What the races do to a roller, by relative coordinates.
struct Contacts {
  std::array<PairPotential, 2> race, flanges;
  double largest = 0.0;        ///< contact load [N]
  double total = 0.0;          ///< sum of contact loads and the centrifugal force [N]
  bool flange_loaded = false;  ///< some flange pushes
};

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

/// `with_curvature`: roller_flanges.hpp.
template <class S>
PairPotential flange_potential(const RollerModel& m, const RollerState& at, std::size_t j,
                               const Pose<S>& pose, bool with_curvature) {
  PairPotential sum;
  for (const FlangePair& flange : m.body(at.number).flanges) {
    if (flange.race == static_cast<int>(j)) {
      add_flange(flange, pose.seen_from[j].values(), with_curvature, sum);
    }
  }
  return sum;
}

template <class S>
Contacts contacts_at(const RollerModel& m, const RollerState& at, const Pose<S>& pose) {
  Contacts out;
  out.total = m.moving ? m.centrifugal : 0.0;
  for (std::size_t j = 0; j < 2; ++j) {
    out.race[j] = potential(m, m.body(at.number), j, pose.seen_from[j].values());
    out.flanges[j] = flange_potential(m, at, j, pose, false);
    out.largest = std::max(out.largest, out.race[j].total);
    out.total += out.race[j].total + out.flanges[j].total;
    out.flange_loaded = out.flange_loaded || out.flanges[j].total > 0.0;
  }
  return out;
}

/// What they make of it.
template <class S>
struct Forces {
  std::array<S, 3> residual;  ///< generalised force on the roller: x, r, tilt [N, N, N m]
  std::array<S, 5> load;      ///< share of the load on the inner race [N, N m]; RollerDual only
};

/// Gradient of U as numbers of roller and race coordinates.
template <class S>
std::array<S, 4> gradient_of(const PairPotential& u, const Relative<S>& at) {
  const std::array<const S*, 4> p{&at.x, &at.seen, &at.t, &at.f};
  std::array<S, 4> g;
  for (std::size_t i = 0; i < 4; ++i) {
    g[i].v = u.gradient(static_cast<Eigen::Index>(i));
    for (std::size_t j = 0; j < 4; ++j) {
      const double slope = u.hessian(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
      for (std::size_t k = 0; k < g[i].d.size(); ++k) {
        g[i].d[k] += slope * p[j]->d[k];
      }
    }
  }
  return g;
}

template <class S>
void add_linear(const std::array<S, 4>& g, const Relative<S>& rel, const RollerState& at,
                bool inner, Forces<S>& sum) {
  sum.residual[0] += -g[0];
  sum.residual[1] += -g[1];
  sum.residual[2] += -g[2];
  if (std::is_same_v<S, RollerDual> && inner) {
    sum.load[0] += -g[0];
    sum.load[1] += g[1] * at.sin;
    sum.load[2] += -g[1] * at.cos;
    sum.load[3] += g[2] * at.cos;
    sum.load[4] += g[2] * at.sin;
    if (rel.lean != 0.0) {
      const S sideways = rel.lean * g[1] / rel.r;
      sum.load[1] += -(sideways * at.cos);
      sum.load[2] += -(sideways * at.sin);
    }
  }
}

/// `gripped`: what the contact pushes along the bearing is taken by its own friction.
template <class S>
void add_exact(const std::array<S, 4>& g, const Roller<S>& roller, const Relative<S>& rel,
               const RollerState& at, bool inner, bool gripped, Forces<S>& sum) {
  S side = (g[2] * rel.f - g[3] * rel.t) / rel.r;
  if (rel.lean != 0.0) {
    side += rel.lean * g[1] / rel.r;
  }
  Triple<S> force;
  Triple<S> turning;  // v of M = -a × v
  for (std::size_t k = 0; k < 3; ++k) {
    force[k] = -(g[0] * rel.A[k] + g[1] * rel.e[k] + side * rel.y[k]);
    turning[k] = g[2] * rel.e[k] + g[3] * rel.y[k];
  }
  if (gripped) {
    force[0] = S(0.0);
  }
  sum.residual[0] += force[0];
  sum.residual[1] += force[2];
  sum.residual[2] += -(turning[0] * roller.over_tilt_x + turning[2] * roller.over_tilt_r);
  if (std::is_same_v<S, RollerDual> && inner) {
    const Triple<S> arm = cross(rel.d, force);
    const Triple<S> own = cross(roller.axis, turning);
    const Triple<S> moment = to_base(minus(arm, own), at);
    const Triple<S> push = to_base(force, at);
    for (std::size_t k = 0; k < 3; ++k) {
      sum.load[k] += push[k];
    }
    sum.load[3] += moment[1];
    sum.load[4] += moment[2];
  }
}

template <class S>
Forces<S> forces_of(const RollerModel& m, const RollerState& at, const Pose<S>& pose,
                    const Contacts& contacts) {
  Forces<S> sum;
  const auto add = [&](const PairPotential& u, std::size_t j, bool gripped) {
    if (!(u.total > 0.0)) {
      return;
    }
    const Relative<S>& rel = pose.seen_from[j];
    const auto g = gradient_of(u, rel);
    if (m.linear) {
      add_linear(g, rel, at, j == 1, sum);
    } else {
      add_exact(g, pose.roller, rel, at, j == 1, gripped, sum);
    }
  };
  for (std::size_t j = 0; j < 2; ++j) {
    add(contacts.race[j], j, m.grips);
    add(contacts.flanges[j], j, false);
  }
  if (m.moving) {
    sum.residual[0] += S(m.guide[0]);
    sum.residual[1] += S(m.centrifugal + m.guide[1]);
    sum.residual[2] += m.centrifugal * m.mass_offset * pose.roller.over_tilt_r + m.gyroscopic;
  }
  return sum;
}

/// What the line search of one roller works on, tilt scaled to a length.
struct Scaled {
  Eigen::Vector3d force;
  Eigen::Matrix3d stiffness;
};
/// A roller that friction holds axially, with no flange against it, does not move that way.
bool is_gripped(const RollerModel& m, const Contacts& c) { return m.grips && !c.flange_loaded; }

template <class S>
Scaled scaled(const RollerModel& m, const Forces<S>& f, const Contacts& contacts) {
  Scaled out;
  const Eigen::Vector3d lever(1.0, 1.0, m.lever);
  for (Eigen::Index i = 0; i < 3; ++i) {
    const S& r = f.residual[static_cast<std::size_t>(i)];
    out.force(i) = r.v / lever(i);
    for (Eigen::Index j = 0; j < 3; ++j) {
      out.stiffness(i, j) = -r.d[static_cast<std::size_t>(j)] / (lever(i) * lever(j));
    }
  }
  if (is_gripped(m, contacts)) {
    out.stiffness.col(0).setZero();
  }
  return out;
}

Eigen::Vector3d unscaled(const RollerModel& m, Eigen::Vector3d step) {
  step(2) /= m.lever;
  return step;
}

/// Newton step. A contact with load Q is held along its normal by some Q/δ, but across it only by Q
/// over its radii: for light contacts that is 1e-8 of the former and less, and along a valley of
/// the potential that is as curved as the groove. Such weak modes, and those that nothing holds,
/// move only where their load is more than RollerModel::weak_floor, and only once the others are in
/// balance; without stiffness they walk along the load.
struct Step {
  Eigen::Vector3d step = Eigen::Vector3d::Zero();
  bool balanced = false;  ///< but for the modes that stay
};
Step roller_step(const RollerModel& m, const Scaled& s, double k_ref, double rounding) {
  constexpr double kWeak = 1e-6;
  Step out;
  const Eigen::Matrix3d K = 0.5 * (s.stiffness + s.stiffness.transpose());
  const double d0 = K(0, 0);
  const double d1 = K(0, 0) * K(1, 1) - K(0, 1) * K(0, 1);
  const double det = K.determinant();
  const double small = 1e-7 * k_ref;
  if (d0 > small && d1 > small * d0 && det > small * d1) {
    out.step = s.stiffness.partialPivLu().solve(s.force);
    return out;
  }
  const double across = K(1, 1) * K(2, 2) - K(1, 2) * K(1, 2);
  if (K.col(0).isZero(0.0) && s.force(0) == 0.0 && K(1, 1) > small && across > small * K(1, 1)) {
    const Eigen::Matrix2d rest = s.stiffness.bottomRightCorner<2, 2>();
    out.step.tail<2>() = rest.partialPivLu().solve(s.force.tail<2>());
    return out;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(K);
  const double stiffest = eigen.eigenvalues().cwiseAbs().maxCoeff();
  if (!(stiffest > 1e-9 * k_ref)) {  // touches nothing: walks until it does, without turning
    const double load = s.force.head<2>().norm();
    if (load > rounding) {
      out.step.head<2>() = s.force.head<2>() * (m.longest_step / load);
    }
    out.balanced = !(load > rounding);
    return out;
  }
  Eigen::Vector3d weak = Eigen::Vector3d::Zero();
  double load_of_rest = 0.0, load_of_weak = 0.0;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const Eigen::Vector3d mode = eigen.eigenvectors().col(k);
    const double load = mode.dot(s.force);
    const double stiffness = std::abs(eigen.eigenvalues()(k));
    if (stiffness > kWeak * stiffest) {
      out.step += mode * (load / stiffness);
      load_of_rest = std::hypot(load_of_rest, load);
    } else if (std::abs(load) > m.weak_floor) {
      weak += mode * (load / std::max(stiffness, 1e-13 * stiffest));
      load_of_weak = std::hypot(load_of_weak, load);
    }
  }
  out.balanced = load_of_weak == 0.0 && load_of_rest <= rounding;
  if (load_of_rest <= 10.0 * load_of_weak) {
    const double length = weak.norm();
    out.step += length > m.longest_step ? weak * (m.longest_step / length) : weak;
  }
  return out;
}

/// In the middle between both races.
Eigen::Vector3d middle_place(const RollerModel& m, const RollerState& state, const Vec5& q) {
  const double moved = 0.5 * (q(2) * state.cos - q(1) * state.sin);
  const double turned = -0.5 * (q(3) * state.cos + q(4) * state.sin);
  const double from_outer = -0.5 * (m.outer_tilt[0] * state.cos + m.outer_tilt[1] * state.sin);
  const bool held = m.rollers.axis_angle != 0.0;
  return {held ? 0.5 * q(0) : 0.0, moved, turned + from_outer};
}

/// Largest penetration of a roller into race j; negative: the gap.
double penetration(const RollerModel& m, const RollerState& at, std::size_t j, const Vec5& q) {
  const Vec4 p = relative_pose(m, at, j, q);
  const RollerBody& body = m.body(at.number);
  PairPotential unused;
  if (m.contact == RollerContact::Point) {
    SliceResult contact;
    add_point(body.point[j], p, unused, &contact);
    return contact.delta;
  }
  std::vector<SliceResult> each(body.slices.size());
  if (m.linear) {
    add_slices_linear(m.slices(j, body), p, unused, each);
  } else {
    add_slices(m.slices(j, body), p, unused, each);
  }
  return std::max_element(each.begin(), each.end(),
                          [](const auto& a, const auto& b) { return a.delta < b.delta; })
      ->delta;
}

/// Where a roller stands when nothing is known: at speed on the outer race, about as deep as its
/// centrifugal force presses it, if the inner race does not touch it there; else in the middle.
Eigen::Vector3d first_place(const RollerModel& m, const RollerState& state, const Vec5& q) {
  if (m.moving) {
    RollerState seated = state;
    seated.e = {0.0, 0.0, -(m.outer_tilt[0] * state.cos + m.outer_tilt[1] * state.sin)};
    const double missing = line_approach(m, m.centrifugal) - penetration(m, seated, 0, q);
    seated.e(0) = missing * std::sin(m.rollers.race_angle[0]);
    seated.e(1) = missing * std::cos(m.rollers.race_angle[0]);
    if (penetration(m, seated, 1, q) <= 0.0) {
      return seated.e;
    }
  }
  return middle_place(m, state, q);
}

/// A roller in equilibrium.
struct Balance {
  Contacts contacts;
  Eigen::Vector3d rest = Eigen::Vector3d::Zero();  ///< last step, which is left to be taken
};

/// `accuracy`: residual force over the sum of loads from which one more step, not evaluated, is
/// enough; 0: down to rounding.
bool newton(const RollerModel& m, const Races<PlaceDual>& races, double accuracy,
            RollerState& state, Balance& found) {
  constexpr int kIterations = 120;
  const double nothing = m.load_floor;
  Contacts& contacts = found.contacts;
  found.rest.setZero();
  const auto evaluate = [&](const RollerState& at) {
    const auto pose = pose_of(m, at, races);
    contacts = contacts_at(m, at, pose);
    return scaled(m, forces_of(m, at, pose, contacts), contacts);
  };
  Scaled now = evaluate(state);
  for (int n = 0; n < kIterations; ++n) {
    const double size = now.force.norm();
    if (!std::isfinite(size)) {
      return false;
    }
    const double k_ref = reference_stiffness(m, std::max(contacts.total, nothing));
    // Rounding of positions of the size of the pitch radius, through the stiffness.
    const double noise = 2e-16 * m.rollers.pitch_diameter * now.stiffness.diagonal().maxCoeff();
    const double rounding = std::max({nothing, noise, 1e-15 * contacts.total});
    if (size <= rounding) {
      return true;
    }
    auto [step, balanced] = roller_step(m, now, k_ref, rounding);
    const double length = step.norm();
    if (balanced) {
      return true;
    }
    if (!std::isfinite(length) || length == 0.0) {
      return false;
    }
    if (size <= accuracy * contacts.total && length <= 1e-2 * m.longest_step) {
      found.rest = unscaled(m, step);
      return true;
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
      now = evaluate(trial);
      const double slope = step.dot(now.force);
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
      return size <= 1e-9 * std::max(contacts.total, nothing);
    }
    const bool at_rounding = t * length <= 1e-16 * m.rollers.pitch_diameter;
    state.e = trial.e;
    if (at_rounding) {
      return true;
    }
  }
  return now.force.norm() <= 1e-9 * std::max(contacts.total, nothing);
}

/// Follows the race: -K⁻¹ ∂R/∂q, without the modes that nothing holds.
Eigen::Matrix<double, 3, 5> following(const RollerModel& m, const Forces<RollerDual>& f,
                                      const Contacts& contacts) {
  const Scaled s = scaled(m, f, contacts);
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

/// Finds the roller's equilibrium. Newton on a convex potential with a line search on the
/// directional derivative; directions that nothing holds or loads stay where they are, loaded ones
/// are walked until something touches. False when there is no equilibrium.
bool solve_roller(const RollerModel& m, const Vec5& q, const Races<PlaceDual>& races,
                  double accuracy, RollerState& state, Balance& found) {
  if (!m.moving) {
    RollerState middle = state;
    middle.e = middle_place(m, state, q);
    found = {contacts_at(m, middle, pose_of(m, middle, races))};
    if (found.contacts.total == 0.0) {
      state.e = middle.e;
      state.idle = true;
      state.known = false;
      return true;
    }
  }
  state.idle = false;
  if (state.known && newton(m, races, accuracy, state, found)) {
    return true;
  }
  const Eigen::Vector3d first = first_place(m, state, q);
  const Eigen::Vector3d middle = middle_place(m, state, q);
  state.e = first;
  state.known = newton(m, races, accuracy, state, found);
  if (!state.known && first != middle) {
    state.e = middle;
    state.known = newton(m, races, accuracy, state, found);
  }
  return state.known;
}

}  // namespace

void follow_race(const RollerModel& m, const Vec5& change, RollerState& state) {
  const Eigen::Vector3d shift = state.follow * change;
  if (shift.head<2>().norm() + m.lever * std::abs(shift(2)) < m.longest_step) {
    state.e += shift;
  }
}

Vec4 relative_pose(const RollerModel& m, const RollerState& at, std::size_t j, const Vec5& q) {
  return relative(m, roller_at<double>(m, at), at, races_at<double>(m, q)[j], j).values();
}

RaceScales race_scales(const RollerModel& m) {
  return {0.5 * m.rollers.pitch_diameter, m.longest_step, 0.5 * m.rollers.diameter,
          m.rollers.pitch_diameter, m.centrifugal};
}

double reference_stiffness(const RollerModel& m, double load) {
  const double delta = line_approach(m, std::max(load, 1e-300));
  return load > 0.0 ? 10.0 / 9.0 * load / delta : 0.0;
}

bool update_race(const RollerModel& m, const Vec5& q, RollerRace& state, double accuracy) {
  const Races<PlaceDual> held = races_at<PlaceDual>(m, q);
  const Races<RollerDual> races = races_at<RollerDual>(m, q);
  const Vec5 change = q - state.q;
  state.load.setZero();
  state.stiffness.setZero();
  state.largest_contact = 0.0;
  for (RollerState& roller : state.elements) {
    if (roller.known) {
      follow_race(m, change, roller);
    }
    Balance found;
    if (!solve_roller(m, q, held, accuracy, roller, found)) {
      return false;
    }
    Contacts& contacts = found.contacts;
    const auto pose = pose_of(m, roller, races);
    for (std::size_t j = 0; j < 2; ++j) {
      if (contacts.flanges[j].total > 0.0) {
        contacts.flanges[j] = flange_potential(m, roller, j, pose, true);
      }
    }
    const Forces<RollerDual> forces = forces_of(m, roller, pose, contacts);
    roller.follow = following(m, forces, contacts);
    roller.e += found.rest;
    if (contacts.total == 0.0) {
      continue;
    }
    Eigen::Matrix<double, 5, 3> by_roller;
    for (Eigen::Index i = 0; i < 5; ++i) {
      const RollerDual& load = forces.load[static_cast<std::size_t>(i)];
      state.load(i) += load.v;
      for (Eigen::Index k = 0; k < 3; ++k) {
        by_roller(i, k) = load.d[static_cast<std::size_t>(k)];
      }
      for (Eigen::Index k = 0; k < 5; ++k) {
        state.stiffness(i, k) += load.d[static_cast<std::size_t>(k) + 3];
      }
    }
    state.load += by_roller * found.rest;
    state.stiffness += by_roller * roller.follow;
    state.largest_contact = std::max(state.largest_contact, contacts.largest);
  }
  state.q = q;
  return true;
}

}  // namespace adore::statics
