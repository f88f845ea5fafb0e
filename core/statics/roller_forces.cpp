#include "statics/roller_forces.hpp"

#include <algorithm>
#include <type_traits>

namespace adore::statics {
namespace {

PairPotential race_potential(const RollerModel& m, const RollerContactGeometry& body, std::size_t j,
                             const Vec4& p) {
  PairPotential sum;
  add_race(m, body, j, p, sum);
  return sum;
}

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
  const Triple<S> push = g[0] * rel.A + g[1] * rel.e + side * rel.y;
  const Triple<S> turning = g[2] * rel.e + g[3] * rel.y;  // v of M = -a × v
  const Triple<S> force{gripped ? S(0.0) : -push.x, -push.y, -push.z};
  sum.residual[0] += force.x;
  sum.residual[1] += force.z;
  sum.residual[2] += -(turning.x * roller.over_tilt_x + turning.z * roller.over_tilt_r);
  if (std::is_same_v<S, RollerDual> && inner) {
    const contact::MeridianRotation turn = azimuth_rotation(at);
    const Triple<S> moment = turn.from_meridian(cross(rel.d, force) - cross(roller.axis, turning));
    const Triple<S> on_race = turn.from_meridian(force);
    sum.load[0] += on_race.x;
    sum.load[1] += on_race.y;
    sum.load[2] += on_race.z;
    sum.load[3] += moment.y;
    sum.load[4] += moment.z;
  }
}

}  // namespace

PairPotential flange_potential(const RollerContactGeometry& body, std::size_t j, const Vec4& p,
                               bool with_curvature) {
  PairPotential sum;
  for (const FlangeEndPair& flange : body.flanges) {
    if (flange.race == static_cast<int>(j)) {
      add_flange_force(flange, p, with_curvature, sum);
    }
  }
  return sum;
}

template <class S>
Contacts contacts_at(const RollerModel& m, const RollerState& at, const Pose<S>& pose) {
  Contacts out;
  const RollerContactGeometry& body = m.body(at.number);
  out.total = m.moving ? m.centrifugal : 0.0;
  for (std::size_t j = 0; j < 2; ++j) {
    const Vec4 p = pose.seen_from[j].values();
    out.race[j] = race_potential(m, body, j, p);
    out.flanges[j] = flange_potential(body, j, p, false);
    out.largest = std::max(out.largest, out.race[j].total);
    out.total += out.race[j].total + out.flanges[j].total;
    out.flange_loaded = out.flange_loaded || out.flanges[j].total > 0.0;
  }
  return out;
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
    const double field = m.mass * (m.field.z() * at.cos - m.field.y() * at.sin);
    const double outward = m.centrifugal + field;
    const double guided = m.centrifugal > 0.0 ? outward / m.centrifugal : 1.0;
    sum.residual[0] += S(guided * m.guide[0]);
    sum.residual[1] += S(outward + guided * m.guide[1]);
    sum.residual[2] += outward * m.mass_offset * pose.roller.over_tilt_r + m.gyroscopic;
  }
  return sum;
}

template Contacts contacts_at(const RollerModel&, const RollerState&, const Pose<PlaceDual>&);
template Forces<PlaceDual> forces_of(const RollerModel&, const RollerState&, const Pose<PlaceDual>&,
                                     const Contacts&);
template Forces<RollerDual> forces_of(const RollerModel&, const RollerState&,
                                      const Pose<RollerDual>&, const Contacts&);

}  // namespace adore::statics
