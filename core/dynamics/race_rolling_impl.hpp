#pragma once

#include "dynamics/race_kernel_impl.hpp"

/// Rolling resistance of all contacts with one race, one ball per vector lane; included with
/// race_kernel_impl.hpp, in the same translation units.
namespace adore::dynamics {
namespace {

template <class Race, class Balls>
template <class Law>
inline void Contacts<Race, Balls>::add_rolling_resistance(const Lanes& at, const Balls& balls,
                                                          const Law& law, Totals& totals) const {
  const auto& touch = groove_.touch();
  const tribology::EllipseMotion<V>& m = ellipse_.motion;
  const V h = ellipse_.surface.height(V(0.0));
  const V along = m.u_t - m.W_c * h, across = m.u_c + m.W_t * h;
  tribology::ContactConditions<V> point;
  point.load = load_;
  // Open contacts next to closed ones have no ellipse.
  point.peak_pressure =
      1.5 * load_ / (std::numbers::pi * stdx::max(ellipse_.a * ellipse_.b, V(1e-30)));
  point.half_major = ellipse_.a;
  point.half_minor = ellipse_.b;
  point.entrainment = m.entrainment;
  point.slip = stdx::sqrt(along * along + across * across);
  point.curvature = m.curvature;
  const V radius = balls.radius();
  V F = law.force(point);
  if constexpr (Race::kSplit) F *= share_.load;
  const V force_t = (2.0 / (m.curvature * radius) - 1.0) * F, M_c = F * radius;
  const V moment_k = -M_c * touch.n_e, moment_e = M_c * touch.n_k;  // c = n_k e - n_e k
  const Vec force = in_azimuth(V(0.0), V(0.0), force_t);
  const Vec moment = in_azimuth(moment_k, moment_e, V(0.0));
  add(at.F_x, force.x);
  add(at.F_r, force.y);
  add(at.F_theta, force.z);
  add(at.M_x, moment.x);
  add(at.M_r, moment.y);
  add(at.M_theta, moment.z);
  // On the race about P_j: -(d × F + M), d = ξ k + R e.
  add_race_reaction(
      force,
      in_azimuth(place_.distance * force_t + moment_k, moment_e - place_.axial * force_t, V(0.0)),
      totals);
  totals.heat += force_t * m.u_t + M_c * m.W_c;
}

template <class Race, class Balls>
RaceKernelSums sum_rolling_contacts(const RaceKernelInput& in) {
  Totals totals;
  for_vectors<ArrayAccess::Both>(in, [&](const Lanes& at) {
    const Balls balls(in, at);
    Contacts<Race, Balls> contacts(in, at, balls);
    if (contacts.open()) return;
    contacts.compute_load(in, at, balls);
    contacts.add_rolling_resistance(at, balls, *in.rolling, totals);
  });
  return reduce_totals(totals);
}

inline RaceKernelSums run_rolling_kernel(const RaceKernelInput& in) {
  if (in.half.is_split()) return sum_rolling_contacts<SplitRaceHalf, DifferentBalls>(in);
  if (in.own != nullptr) return sum_rolling_contacts<WavyRace, DifferentBalls>(in);
  return in.wavy != nullptr ? sum_rolling_contacts<WavyRace, IdenticalBalls>(in)
                            : sum_rolling_contacts<RoundRace, IdenticalBalls>(in);
}

}  // namespace
}  // namespace adore::dynamics
