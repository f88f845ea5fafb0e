#pragma once

#include "base/simd_tiles.hpp"
#include "contact/ball_groove.hpp"
#include "contact/wavy_groove.hpp"
#include "dynamics/ball_race_motion.hpp"
#include "dynamics/race_kernel.hpp"
#include "dynamics/race_kernel_user.hpp"
#include "tribology/ellipse_sum.hpp"
#include "tribology/traction_laws.hpp"

#include <cstddef>
#include <new>
#include <type_traits>

/// All contacts with one race, one ball per vector lane. Included by one translation unit per
/// instruction set; see race_contacts.hpp for the equations' source, frames and signs.
///
/// Local basis of one contact: k, e, t of contact/ball_groove.hpp.
namespace adore::contact {

/// Lane by lane.
template <>
struct TableLookup<SimdReal> {
  using V = SimdReal;
  [[nodiscard]] static TableAtContact<V> at(const SurfaceDeviationTable& table,
                                            const AzimuthDirection<V>& psi, const V& n_k,
                                            const V& n_e) {
    TableAtContact<V> out;
    for (int lane = 0; lane < static_cast<int>(V::size()); ++lane) {
      const TableAtContact<double> one = TableLookup<double>::at(
          table, AzimuthDirection<double>{psi.cosine[lane], psi.sine[lane]}, n_k[lane], n_e[lane]);
      out.height[lane] = one.height;
      out.height_psi[lane] = one.height_psi;
      out.height_phi[lane] = one.height_phi;
      out.factor[lane] = one.factor;
      out.factor_psi[lane] = one.factor_psi;
      out.factor_phi[lane] = one.factor_phi;
    }
    return out;
  }
};

}  // namespace adore::contact

namespace adore::dynamics {
namespace {

using V = SimdReal;
using Vec = contact::Triple<V>;  ///< on e_x, e_r, e_θ of each ball's azimuth

inline Vec to_azimuth(const double* base, V s, V c) {
  return contact::to_azimuth(contact::Triple<double>{base[0], base[1], base[2]}, s, c);
}
inline V get(const double* from) { return V(from, stdx::element_aligned); }
inline void put(double* to, V value) { value.copy_to(to, stdx::element_aligned); }
inline void add(double* to, V value) { put(to, get(to) + value); }

struct Totals {
  V force_x = 0.0, force_y = 0.0, force_z = 0.0, moment_x = 0.0, moment_y = 0.0, moment_z = 0.0;
  V elastic_energy = 0.0, heat = 0.0, load_slip = 0.0, damping = 0.0;
};

/// One vector of balls: where its lanes are read and written.
struct Lanes {
  std::size_t first;  ///< ball of the first lane
  const double *x, *r, *sin_theta, *cos_theta, *x_dot, *r_dot, *theta_dot;
  const double *omega_x, *omega_r, *omega_theta;
  double *F_x, *F_r, *F_theta, *M_x, *M_r, *M_theta, *load, *heat, *load_slip;
  int used;  ///< lanes that are balls; the others hold copies and count as open contacts
};

/// Coefficients of a polynomial of contact/angle_law.hpp.
using Terms = double[contact::HertzAngleLaw::kTerms];
struct LaneTerms {
  V c[contact::HertzAngleLaw::kTerms];
};

/// All lanes are on one race: its pose and motion are numbers.
class SingleRaceLanes {
 public:
  explicit SingleRaceLanes(const RaceKernelInput& in) : input_(in) {}
  double centre_radius() const { return input_.centre_radius; }
  Vec axis(V s, V c) const { return to_azimuth(input_.axis, s, c); }
  Vec centre(V s, V c) const { return to_azimuth(input_.centre, s, c); }
  Vec velocity(V s, V c) const { return to_azimuth(input_.velocity, s, c); }
  double speed() const { return input_.speed; }
  bool tilts() const { return input_.tilts; }
  Vec tilt(V s, V c) const { return to_azimuth(input_.tilt, s, c); }
  /// Of the nominal ball where balls differ.
  const contact::DampingLaw<>& damping() const { return input_.damping; }

 protected:
  const RaceKernelInput& input_;
};

/// Identical balls: their constants are numbers.
class IdenticalBalls : public SingleRaceLanes {
 public:
  using Scalar = double;
  static constexpr bool kAlike = true;
  IdenticalBalls(const RaceKernelInput& in, const Lanes&) : SingleRaceLanes(in) {}
  double offset() const { return input_.offset; }
  double K() const { return input_.K; }
  double major() const { return input_.major; }
  double minor() const { return input_.minor; }
  double radius() const { return input_.ball_radius; }
  double rho() const { return input_.rho; }
  struct ScalarTerms {
    const Terms& c;
  };
  ScalarTerms follow(const Terms contact::HertzAngleLaw::*of) const { return {input_.follow->*of}; }
  const contact::HertzConstantRatios<double>& ratios() const { return input_.wavy->ratios; }
};

/// Balls that differ: one value a lane.
class DifferentBalls : public SingleRaceLanes {
 public:
  using Scalar = V;
  static constexpr bool kAlike = false;
  DifferentBalls(const RaceKernelInput& in, const Lanes& at) : SingleRaceLanes(in) {
    for (int lane = 0; lane < static_cast<int>(V::size()); ++lane)
      ball_[lane] = in.own + at.first + (lane < at.used ? lane : at.used - 1);
  }
  V offset() const { return of(&BallConstants::offset); }
  V K() const { return of(&BallConstants::K); }
  V major() const { return of(&BallConstants::major); }
  V minor() const { return of(&BallConstants::minor); }
  V radius() const { return of(&BallConstants::ball_radius); }
  V rho() const { return of(&BallConstants::rho); }
  LaneTerms follow(const Terms contact::HertzAngleLaw::*of) const {
    return gather_lanes([&](const BallConstants& one, int k) { return (one.follow.*of)[k]; });
  }
  contact::HertzConstantRatios<V> ratios() const {
    contact::HertzConstantRatios<V> out;
    for (int k = 0; k < contact::HertzAngleLaw::kTerms; ++k) {
      out.stiffness[k] = V([&](auto lane) { return ball_[lane]->ratios->stiffness[k]; });
      out.major[k] = V([&](auto lane) { return ball_[lane]->ratios->major[k]; });
      out.minor[k] = V([&](auto lane) { return ball_[lane]->ratios->minor[k]; });
    }
    return out;
  }

 private:
  V of(double BallConstants::*member) const {
    return V([&](auto lane) { return ball_[lane]->*member; });
  }
  template <class Term>
  LaneTerms gather_lanes(const Term& term) const {
    LaneTerms out;
    for (int k = 0; k < contact::HertzAngleLaw::kTerms; ++k)
      out.c[k] = V([&](auto lane) { return term(*ball_[lane], k); });
    return out;
  }

  const BallConstants* ball_[V::size()];
};

/// Alike balls on both races: `half` lanes on the outer and then as many on the inner.
class BothRacesLanes {
 public:
  using Scalar = V;
  static constexpr bool kAlike = true;
  BothRacesLanes(const RaceKernelInput* in, int half)
      : outer_(in[0]), inner_(in[1]), on_outer_(V([](auto lane) {
                                                  return static_cast<double>(lane);
                                                }) < static_cast<double>(half)) {}
  V offset() const { return of(&RaceKernelInput::offset); }
  V K() const { return of(&RaceKernelInput::K); }
  V major() const { return of(&RaceKernelInput::major); }
  V minor() const { return of(&RaceKernelInput::minor); }
  V radius() const { return outer_.ball_radius; }
  V rho() const { return of(&RaceKernelInput::rho); }
  LaneTerms follow(const Terms contact::HertzAngleLaw::*term) const {
    LaneTerms out;
    for (int k = 0; k < contact::HertzAngleLaw::kTerms; ++k)
      out.c[k] = pick((outer_.follow->*term)[k], (inner_.follow->*term)[k]);
    return out;
  }
  V centre_radius() const { return of(&RaceKernelInput::centre_radius); }
  Vec axis(V s, V c) const { return of(&RaceKernelInput::axis, s, c); }
  Vec centre(V s, V c) const { return of(&RaceKernelInput::centre, s, c); }
  Vec velocity(V s, V c) const { return of(&RaceKernelInput::velocity, s, c); }
  V speed() const { return of(&RaceKernelInput::speed); }
  contact::DampingLaw<V> damping() const {
    const contact::DampingLaw<>&a = outer_.damping, &b = inner_.damping;
    return {pick(a.impact, b.impact), pick(a.material, b.material), pick(a.onset, b.onset)};
  }
  bool tilts() const { return outer_.tilts || inner_.tilts; }
  Vec tilt(V s, V c) const { return of(&RaceKernelInput::tilt, s, c); }

 private:
  V pick(double outer, double inner) const {
    V out = inner;
    stdx::where(on_outer_, out) = outer;
    return out;
  }
  V of(double RaceKernelInput::*member) const { return pick(outer_.*member, inner_.*member); }
  Vec of(const double (RaceKernelInput::*vector)[3], V s, V c) const {
    const double *a = outer_.*vector, *b = inner_.*vector;
    return contact::to_azimuth(Vec{pick(a[0], b[0]), pick(a[1], b[1]), pick(a[2], b[2])}, s, c);
  }

  const RaceKernelInput &outer_, &inner_;
  V::mask_type on_outer_;
};

/// A race of revolution.
class RoundRace {
 public:
  static constexpr bool kWavy = false, kSplit = false;
  template <class Balls>
  RoundRace(const RaceKernelInput&, const Lanes&, const Balls& balls, const Vec&,
            const contact::GrooveCoordinates<V>& place, V, V)
      : touch_(contact::ball_groove_contact(place.axial, place.lift, balls.offset())) {}
  const contact::BallGrooveContact<V>& touch() const { return touch_; }

 private:
  contact::BallGrooveContact<V> touch_;
};

/// A half of a split race (contact/split_race.hpp): the arc of a round race.
class SplitRaceHalf : public RoundRace {
 public:
  static constexpr bool kSplit = true;
  using RoundRace::RoundRace;
};

/// A race with errors.
class WavyRace {
 public:
  static constexpr bool kWavy = true, kSplit = false;
  template <class Balls>
  WavyRace(const RaceKernelInput& in, const Lanes& at, const Balls& balls, const Vec& k,
           const contact::GrooveCoordinates<V>& place, V s, V c)
      : distance_(place.distance), at_(touch_of(in, balls, k, place, s, c)) {
    if (in.wavy != nullptr && in.wavy->forms != nullptr) add_lobes(in, at, k, place.e, s, c);
  }
  const contact::BallGrooveContact<V>& touch() const { return at_.touch; }
  /// Hertz's constants, and the force of their change with the angle, of the groove as it is here.
  void scale(V& K, V& leaning, V& major, V& minor) const {
    K *= at_.stiffness;
    leaning *= at_.stiffness;
    major *= at_.major;
    minor *= at_.minor;
  }
  /// Part of the normal force on the ball along t. @param damping load beyond the elastic one
  V push(V elastic, V damping, V leaning, V approach) const {
    return contact::wavy_tangential_force(at_, elastic, leaning, approach, distance_) -
           scale_by_slope_t(damping);
  }
  /// (D/R) x: of the velocity of the ball along t relative to the race, what it adds to dδ/dt.
  V scale_by_slope_t(V x) const { return at_.turn / distance_ * x; }
  /// What tables add: to the force on the ball along c, and likewise of a velocity along c.
  V lean(V elastic, V load, V approach) const {
    return contact::wavy_transverse_force(at_, load, elastic, approach);
  }
  V scale_by_slope_c(V x) const { return at_.lean * x; }
  /// Of balls that are not round: derivatives of their radius along c and t.
  V lobe_c() const { return at_.lobe_c; }
  V lobe_t() const { return at_.lobe_t; }

 private:
  /// Balls that differ come here with round races, too: a race of no waves.
  template <class Balls>
  static contact::WavyGrooveContact<V> touch_of(const RaceKernelInput& in, const Balls& balls,
                                                const Vec& k,
                                                const contact::GrooveCoordinates<V>& place, V s,
                                                V c) {
    if constexpr (!Balls::kAlike)
      if (in.wavy == nullptr)
        return {contact::ball_groove_contact(place.axial, place.lift, balls.offset()), V(0.0),
                V(0.0)};
    return contact::wavy_groove_contact(
        *in.wavy, balls.ratios(), contact::azimuth_in_race(k, place.e, to_azimuth(in.zero, s, c)),
        place.axial, place.lift, balls.offset());
  }

  void add_lobes(const RaceKernelInput& in, const Lanes& at, const Vec& k, const Vec& e, V s, V c) {
    const auto& touch = at_.touch;
    const Vec t_all = cross(k, e), n_all = touch.n_k * k + touch.n_e * e;
    const Vec c_all = touch.n_k * e - touch.n_e * k;
    V height = 0.0, g_c = 0.0, g_t = 0.0;
    for (int lane = 0; lane < static_cast<int>(V::size()); ++lane) {
      const auto base = [&](const Vec& v) {
        return contact::from_azimuth(contact::Triple<double>{v.x[lane], v.y[lane], v.z[lane]},
                                     static_cast<double>(s[lane]), static_cast<double>(c[lane]));
      };
      const std::size_t ball =
          at.first + static_cast<std::size_t>(lane < at.used ? lane : at.used - 1);
      const contact::Lobe one =
          contact::lobe_at(*in.wavy->forms, ball, base(n_all), base(c_all), base(t_all));
      height[lane] = one.height;
      g_c[lane] = one.c;
      g_t[lane] = one.t;
    }
    contact::add_lobe(at_, height, g_c, g_t);
  }

  V distance_;
  contact::WavyGrooveContact<V> at_;
};

/// Traction of one vector, by a law whose integral is part of the contact's code.
template <class Law>
struct InlinedLaw {
  template <class S>
  [[gnu::always_inline]] tribology::EllipseResultants<V> operator()(
      const RaceKernelInput& in, const tribology::EllipseContact<V, S>& ellipse) const {
    return tribology::EllipseQuadrature<V, Law, S>(in.nodes, ellipse,
                                                   *static_cast<const Law*>(in.law),
                                                   in.regularization_slip_squared, in.slip_scale)
        .run();
  }
};

/// By a law with a film, whose integral is long: a call, so that a kernel has one copy of each, and
/// one of the contact for all of them.
struct CalledLaw {
  using Sum = void(const RaceKernelInput&, const tribology::EllipseContact<V, V>&,
                   tribology::EllipseResultants<V>&);
  Sum* sum;
  template <class S>
  [[gnu::always_inline]] tribology::EllipseResultants<V> operator()(
      const RaceKernelInput& in, const tribology::EllipseContact<V, S>& e) const {
    tribology::EllipseResultants<V> sums;
    sum(in, {e.load, e.a, e.b, {e.surface.offset, e.surface.rho}, e.motion}, sums);
    return sums;
  }
};
template <class Law>
[[gnu::noinline]] void integrate_film_traction(const RaceKernelInput& in,
                                               const tribology::EllipseContact<V, V>& ellipse,
                                               tribology::EllipseResultants<V>& sums) {
  sums = InlinedLaw<Law>()(in, ellipse);
}

/// The contacts of one vector of balls: what forces are made of once traction is known, of built-in
/// laws at once, of a law of the user in a second pass.
template <class Race, class Balls>
class Contacts {
 public:
  using S = typename Balls::Scalar;

  [[gnu::always_inline]] Contacts(const RaceKernelInput& in, const Lanes& at, const Balls& balls)
      : s_(get(at.sin_theta)),
        c_(get(at.cos_theta)),
        r_(get(at.r)),
        k_(balls.axis(s_, c_)),
        d_(from_centre(at, r_, balls.centre(s_, c_))),
        place_(contact::groove_coordinates(d_, k_, balls.centre_radius())),
        groove_(in, at, balls, k_, place_, s_, c_),
        approach_(groove_.touch().approach) {
    if (at.used < static_cast<int>(V::size())) {
      const V lane([](auto i) { return static_cast<double>(i); });
      stdx::where(lane >= static_cast<double>(at.used), approach_) = -1.0;
    }
  }
  [[gnu::always_inline]] bool open() const { return stdx::none_of(approach_ > 0.0); }
  /// Load, and the ellipse where there is traction.
  [[gnu::always_inline]] void compute_load(const RaceKernelInput& in, const Lanes& at,
                                           const Balls& balls);
  [[nodiscard]] const tribology::EllipseContact<V, S>& ellipse() const { return ellipse_; }
  /// Load of this race.
  [[nodiscard, gnu::always_inline]] V load() const {
    if constexpr (Race::kSplit)
      return share_.load * load_;
    else
      return load_;
  }
  [[gnu::always_inline]] void add_to(const RaceKernelInput& in, const Lanes& at,
                                     const tribology::EllipseResultants<V>& traction,
                                     Totals& totals) const;
  /// Adds rolling resistance F along t: 2 F R'/r - F on the ball at its center, with 1/R' the
  /// curvature of both bodies, and F r about c; the opposite on the race (rolling_resistance.hpp).
  template <class Law>
  [[gnu::always_inline]] void add_rolling_resistance(const Lanes& at, const Balls& balls,
                                                     const Law& law, Totals& totals) const;
  /// Of an open vector.
  [[gnu::always_inline]] static void write_open_contacts(const Lanes& at) {
    put(at.load, 0.0);
    put(at.heat, 0.0);
    if (at.load_slip != nullptr) put(at.load_slip, 0.0);
  }

 private:
  /// Components on (k, e, t) in the azimuth frame.
  [[gnu::always_inline]] Vec in_azimuth(V along_k, V along_e, V along_t) const {
    const Vec &e = place_.e, &k = k_;
    const Vec t = cross(k, e);
    return {along_k * k.x + along_e * e.x + along_t * t.x,
            along_k * k.y + along_e * e.y + along_t * t.y,
            along_k * k.z + along_e * e.z + along_t * t.z};
  }
  /// Adds to the race what is opposite to a force on the ball and a moment `about` P_j.
  [[gnu::always_inline]] void add_race_reaction(const Vec& force, const Vec& about,
                                                Totals& totals) const {
    totals.force_x -= force.x;
    totals.force_y += s_ * force.y + c_ * force.z;
    totals.force_z -= c_ * force.y - s_ * force.z;
    totals.moment_x -= about.x;
    totals.moment_y += s_ * about.y + c_ * about.z;
    totals.moment_z -= c_ * about.y - s_ * about.z;
  }
  /// Ball center from P_j.
  [[gnu::always_inline]] static Vec from_centre(const Lanes& at, V r, const Vec& centre) {
    return {get(at.x) - centre.x, r - centre.y, -centre.z};
  }

  V s_, c_, r_;
  Vec k_, d_;
  contact::GrooveCoordinates<V> place_;
  Race groove_;
  V approach_, load_ = 0.0, elastic_ = 0.0, rate_ = 0.0, leaning_force_ = 0.0;
  tribology::EllipseContact<V, S> ellipse_{};
  /// Of half races; load_, elastic_ and the ellipse are those of the whole contact.
  struct NoSplitShare {};
  [[no_unique_address]] std::conditional_t<Race::kSplit, contact::SplitLoadFractions<V>,
                                           NoSplitShare>
      share_;
};

template <class Race, class Balls>
inline void Contacts<Race, Balls>::compute_load(const RaceKernelInput& in, const Lanes& at,
                                                const Balls& balls) {
  const auto& touch = groove_.touch();
  approach_ = stdx::max(approach_, V(0.0));
  const V root_approach = stdx::sqrt(approach_);
  V K = balls.K(), major = balls.major(), minor = balls.minor();
  if (in.follow != nullptr) {
    const auto at_angle =
        contact::polynomial_with_slope(balls.follow(&contact::HertzAngleLaw::K).c, touch.n_e);
    K = at_angle.value;
    leaning_force_ = contact::angle_gradient_force(at_angle.slope, approach_, root_approach,
                                                   touch.n_k, touch.length);
    if (in.traction) {
      major = contact::polynomial(balls.follow(&contact::HertzAngleLaw::major).c, touch.n_e);
      minor = contact::polynomial(balls.follow(&contact::HertzAngleLaw::minor).c, touch.n_e);
    }
  }
  if constexpr (Race::kWavy) groove_.scale(K, leaning_force_, major, minor);
  load_ = elastic_ = contact::point_contact_load(K, approach_, root_approach);
  if constexpr (Race::kSplit) {
    share_ = contact::split_load_fractions(in.half, elastic_, root_approach, touch.n_k, touch.n_e,
                                           touch.length);
    leaning_force_ = share_.energy * leaning_force_ + share_.turned;
  }
  if (!in.traction && !in.damped) return;
  const V theta_dot = get(at.theta_dot);
  const S radius = balls.radius();
  const BallRaceMotion<V, S> pair{balls.velocity(s_, c_),
                                  balls.tilts() ? balls.tilt(s_, c_) : Vec{},
                                  balls.speed(),
                                  balls.tilts(),
                                  {get(at.x_dot), get(at.r_dot), r_ * theta_dot},
                                  {get(at.omega_x), get(at.omega_r), get(at.omega_theta)},
                                  theta_dot,
                                  radius};
  ellipse_.motion = ellipse_motion(pair, d_, k_, cross(k_, place_.e), place_, touch, rate_);
  if (in.damped) {
    if constexpr (Race::kWavy) {
      rate_ -= groove_.scale_by_slope_t(ellipse_.motion.u_t);
      rate_ -= groove_.scale_by_slope_c(ellipse_.motion.u_c);
      rate_ -= groove_.lobe_t() * ellipse_.motion.W_c - groove_.lobe_c() * ellipse_.motion.W_t;
    }
    load_ = contact::damped_load(balls.damping(), elastic_, V(1.5 * K * root_approach), approach_,
                                 rate_);
  }
  if (!in.traction) return;
  ellipse_.load = load_;
  ellipse_.a = major * root_approach;
  ellipse_.b = minor * root_approach;
  ellipse_.surface =
      tribology::ellipse_surface(in.place, balls.rho(), radius, ellipse_.a, approach_);
}

template <class Race, class Balls>
inline void Contacts<Race, Balls>::add_to(const RaceKernelInput& in, const Lanes& at,
                                          const tribology::EllipseResultants<V>& whole_traction,
                                          Totals& totals) const {
  const auto& touch = groove_.touch();
  const V R = place_.distance, load = this->load();
  contact::MeridianForce<V> meridian{-load * touch.n_k, -load * touch.n_e};
  tribology::EllipseResultants<V> traction = whole_traction;
  if constexpr (Race::kSplit)
    for (V* sum : {&traction.F_c, &traction.F_t, &traction.M_c, &traction.M_t, &traction.M_n,
                   &traction.heat, &traction.load_slip})
      *sum *= share_.load;
  V force_t = 0.0, heat = 0.0, load_slip = 0.0;
  V moment_k = 0.0, moment_e = 0.0, moment_t = 0.0;
  if (in.traction) {
    meridian = contact::meridian_force(load, traction.F_c, touch.n_k, touch.n_e);
    force_t = traction.F_t;
    moment_k = traction.M_n * touch.n_k - traction.M_c * touch.n_e;
    moment_e = traction.M_n * touch.n_e + traction.M_c * touch.n_k;
    moment_t = traction.M_t;
    const Vec moment = in_azimuth(moment_k, moment_e, moment_t);
    heat = traction.heat;
    load_slip = traction.load_slip;
    add(at.M_x, moment.x);
    add(at.M_r, moment.y);
    add(at.M_theta, moment.z);
  }
  if (Race::kSplit || in.follow != nullptr) {
    meridian.along -= leaning_force_ * touch.n_e;
    meridian.outward += leaning_force_ * touch.n_k;
  }
  if constexpr (Race::kWavy) {
    force_t += groove_.push(elastic_, load_ - elastic_, leaning_force_, approach_);
    const V lean = groove_.lean(elastic_, load_, approach_);
    meridian.along -= lean * touch.n_e;
    meridian.outward += lean * touch.n_k;
    if (in.wavy != nullptr && in.wavy->forms != nullptr) {
      const V about_c = -load_ * groove_.lobe_t(), of_t = load_ * groove_.lobe_c();
      const V of_k = -about_c * touch.n_e, of_e = about_c * touch.n_k;
      const Vec moment = in_azimuth(of_k, of_e, of_t);
      moment_k += of_k;
      moment_e += of_e;
      moment_t += of_t;
      add(at.M_x, moment.x);
      add(at.M_r, moment.y);
      add(at.M_theta, moment.z);
    }
  }
  const V force_k = meridian.along, force_e = meridian.outward;
  const Vec force = in_azimuth(force_k, force_e, force_t);
  add(at.F_x, force.x);
  add(at.F_r, force.y);
  add(at.F_theta, force.z);
  put(at.load, load);
  put(at.heat, heat);
  if (at.load_slip != nullptr) put(at.load_slip, load_slip);

  // On the race about P_j: -(d × F + M), d = ξ k + R e.
  const V about_k = R * force_t + moment_k;
  const V about_e = moment_e - place_.axial * force_t;
  const V about_t = place_.axial * force_e - R * force_k + moment_t;
  add_race_reaction(force, in_azimuth(about_k, about_e, about_t), totals);
  if constexpr (Race::kSplit) {
    totals.elastic_energy += share_.energy * contact::point_contact_energy(elastic_, approach_);
    if (in.damped) totals.damping += share_.load * (load_ - elastic_) * rate_;
  } else {
    totals.elastic_energy += contact::point_contact_energy(elastic_, approach_);
    if (in.damped) totals.damping += (load_ - elastic_) * rate_;
  }
  totals.heat += heat;
  totals.load_slip += load_slip;
}

template <class Race, class Balls, class Law>
void evaluate(const RaceKernelInput& in, const Lanes& at, const Balls& balls, const Law& law,
              Totals& totals) {
  Contacts<Race, Balls> contacts(in, at, balls);
  if (contacts.open()) {
    Contacts<Race, Balls>::write_open_contacts(at);
    return;
  }
  contacts.compute_load(in, at, balls);
  tribology::EllipseResultants<V> traction;
  if (in.traction) traction = law(in, contacts.ellipse());
  contacts.add_to(in, at, traction, totals);
}

/// Operation on the arrays of a vector.
enum class ArrayAccess : unsigned char { Read, Write, Both };

/// The arrays of a race that are read and those that are written, the first kAdded of them added
/// to, in the order of Lanes.
inline constexpr int kSources = 10, kTargets = 9, kAdded = 6;
struct Arrays {
  explicit Arrays(const RaceKernelInput& in)
      : source{in.x,     in.r,         in.sin_theta, in.cos_theta, in.x_dot,
               in.r_dot, in.theta_dot, in.omega_x,   in.omega_r,   in.omega_theta},
        target{in.F_x,     in.F_r,  in.F_theta, in.M_x,      in.M_r,
               in.M_theta, in.load, in.heat,    in.load_slip} {}
  const double* source[kSources];
  double* target[kTargets];
};

/// Copies of what an incomplete vector works on: no lane reads or writes beyond the arrays.
struct TailCopies {
  static constexpr int kLanes = static_cast<int>(V::size());
  double source[kSources][kLanes], target[kTargets][kLanes];

  /// Ball of a lane; lanes beyond those `used` copy the last.
  template <class BallOf>
  void read(const Arrays& from, int used, const BallOf& ball_of) {
    for (int array = 0; array < kSources; ++array)
      for (int i = 0; i < kLanes; ++i)
        source[array][i] = from.source[array][ball_of(i < used ? i : used - 1)];
  }
  /// Lanes below `used` start from the present sums, all others from 0.
  void begin(const Arrays& from, std::size_t first, int used) {
    for (int array = 0; array < kTargets; ++array)
      for (int i = 0; i < kLanes; ++i)
        target[array][i] = array < kAdded && i < used
                               ? from.target[array][first + static_cast<std::size_t>(i)]
                               : 0.0;
  }
  [[nodiscard]] Lanes lanes(std::size_t first, int used) {
    return {first,     source[0], source[1], source[2], source[3], source[4], source[5],
            source[6], source[7], source[8], source[9], target[0], target[1], target[2],
            target[3], target[4], target[5], target[6], target[7], target[8], used};
  }
};

/// The last, incomplete vector of a race.
template <ArrayAccess kUse, class Visit>
void visit_tail(const RaceKernelInput& in, std::size_t first, int used, const Visit& visit) {
  const Arrays arrays(in);
  TailCopies copies;
  if (kUse != ArrayAccess::Write)
    copies.read(arrays, used, [&](int i) { return first + static_cast<std::size_t>(i); });
  if (kUse != ArrayAccess::Read) copies.begin(arrays, first, used);
  visit(copies.lanes(first, used));
  for (int array = 0; kUse != ArrayAccess::Read && array < kTargets; ++array) {
    if (arrays.target[array] == nullptr) continue;
    for (int i = 0; i < used; ++i)
      arrays.target[array][first + static_cast<std::size_t>(i)] = copies.target[array][i];
  }
}

/// Complete vectors. @returns the first ball that is in none
template <class Visit>
std::size_t for_whole_vectors(const RaceKernelInput& in, const Visit& visit) {
  constexpr std::size_t kLanes = V::size();
  std::size_t i = 0;
  for (; i + kLanes <= in.n; i += kLanes) {
    visit(Lanes{i,
                in.x + i,
                in.r + i,
                in.sin_theta + i,
                in.cos_theta + i,
                in.x_dot + i,
                in.r_dot + i,
                in.theta_dot + i,
                in.omega_x + i,
                in.omega_r + i,
                in.omega_theta + i,
                in.F_x + i,
                in.F_r + i,
                in.F_theta + i,
                in.M_x + i,
                in.M_r + i,
                in.M_theta + i,
                in.load + i,
                in.heat + i,
                in.load_slip == nullptr ? nullptr : in.load_slip + i,
                static_cast<int>(kLanes)});
  }
  return i;
}

template <ArrayAccess kUse, class Visit>
void for_vectors(const RaceKernelInput& in, const Visit& visit) {
  const std::size_t i = for_whole_vectors(in, visit);
  if (i < in.n) visit_tail<kUse>(in, i, static_cast<int>(in.n - i), visit);
}

inline RaceKernelSums reduce_totals(const Totals& totals) {
  return {
      {stdx::reduce(totals.force_x), stdx::reduce(totals.force_y), stdx::reduce(totals.force_z)},
      {stdx::reduce(totals.moment_x), stdx::reduce(totals.moment_y), stdx::reduce(totals.moment_z)},
      stdx::reduce(totals.elastic_energy),
      stdx::reduce(totals.heat),
      stdx::reduce(totals.load_slip),
      stdx::reduce(totals.damping)};
}

template <class Race, class Balls, class Law>
RaceKernelSums evaluate_all(const RaceKernelInput& in, const Law& law) {
  Totals totals;
  for_vectors<ArrayAccess::Both>(
      in, [&](const Lanes& at) { evaluate<Race>(in, at, Balls(in, at), law, totals); });
  return reduce_totals(totals);
}

/// Of a law of the user: both passes (race_kernel_user.hpp).
template <class Race, class Balls>
RaceKernelSums evaluate_user_law(const RaceKernelInput& in) {
  using S = typename Balls::Scalar;
  using Kept = Contacts<Race, Balls>;
  static_assert(sizeof(Kept) <= kKeptValues * sizeof(V));
  const auto& law = *static_cast<const tribology::UserTractionLaw*>(in.law);
  UserPoints& points = *in.points;
  for_vectors<ArrayAccess::Read>(in, [&](const Lanes& at) {
    const Balls balls(in, at);
    Kept& contacts = *new (points.kept + at.first * kKeptValues) Kept(in, at, balls);
    if (contacts.open()) {
      mark_open_contacts(points, at.first);
      return;
    }
    contacts.compute_load(in, at, balls);
    if (in.traction)
      collect_points<S>(in, contacts.ellipse(), law.of->wants_pressure, points, at.first);
    else
      points.rows_of[at.first] = 0;
  });
  call_user_routine(law, points, in.n, in.nodes.minor);
  Totals totals;
  for_vectors<ArrayAccess::Write>(in, [&](const Lanes& at) {
    if (points.rows_of[at.first] < 0) {
      Kept::write_open_contacts(at);
      return;
    }
    const Kept& contacts =
        *std::launder(reinterpret_cast<const Kept*>(points.kept + at.first * kKeptValues));
    tribology::EllipseResultants<V> traction;
    if (in.traction) traction = replay_points<S>(in, contacts.ellipse(), points, at.first);
    contacts.add_to(in, at, traction, totals);
  });
  return reduce_totals(totals);
}

template <class Law, class Race, class Balls>
RaceKernelSums evaluate_for_law(const RaceKernelInput& in) {
  if constexpr (std::is_same_v<Law, tribology::UserTractionLaw>)
    return evaluate_user_law<Race, Balls>(in);
  else if constexpr (tribology::kHasFilm<Law>)
    return evaluate_all<Race, Balls>(in, CalledLaw{integrate_film_traction<Law>});
  else
    return evaluate_all<Race, Balls>(in, InlinedLaw<Law>());
}

template <class Race, class Balls, class... Laws>
RaceKernelSums evaluate_race(const RaceKernelInput& in, tribology::TypeList<Laws...>) {
  RaceKernelSums sums{};
  std::size_t index = 0;
  (void)((index++ == in.law_index && (sums = evaluate_for_law<Laws, Race, Balls>(in), true)) ||
         ...);
  return sums;
}

/// Once per race, or half of one: groove, balls and law are chosen here, and nowhere below.
inline RaceKernelSums evaluate_race(const RaceKernelInput& in) {
  constexpr tribology::TractionLawList kLaws;
  if (in.half.is_split()) return evaluate_race<SplitRaceHalf, DifferentBalls>(in, kLaws);
  if (in.own != nullptr) return evaluate_race<WavyRace, DifferentBalls>(in, kLaws);
  return in.wavy != nullptr ? evaluate_race<WavyRace, IdenticalBalls>(in, kLaws)
                            : evaluate_race<RoundRace, IdenticalBalls>(in, kLaws);
}

}  // namespace
}  // namespace adore::dynamics
