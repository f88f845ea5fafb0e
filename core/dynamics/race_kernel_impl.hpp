#pragma once

#include "dynamics/race_kernel.hpp"
#include "dynamics/simd_math.hpp"
#include "tribology/ellipse_breaks.hpp"

#include <cstddef>

/// All contacts with one race, one ball per vector lane. Included by one translation unit per
/// instruction set; see race_contacts.hpp for the equations' source, frames and signs.
///
/// Local basis of one contact: k = race axis, e = radial unit vector of the ball about that axis,
/// t = k × e = rolling direction. Then n = n_k k + n_e e, c = t × n = n_k e - n_e k.
namespace adore::dynamics {
namespace {

inline V root(V x) { return x * inverse_sqrt(stdx::max(x, V(1e-30))); }

struct Vec {
  V x, r, t;  ///< components on e_x, e_r, e_θ of each ball's azimuth
};
inline V dot(const Vec& a, const Vec& b) { return a.x * b.x + a.r * b.r + a.t * b.t; }
inline Vec to_azimuth(const double* base, V s, V c) {
  return {V(base[0]), c * base[2] - s * base[1], -c * base[1] - s * base[2]};
}

/// κ(s)/s, given s and 1/s.
struct TwoSlopeLaw {
  V A, B, C, u0;
  explicit TwoSlopeLaw(const RaceKernelInput& in) : A(in.A), B(in.B), C(in.C), u0(in.u0) {}
  V operator()(V s, V inverse) const {
    const V below = stdx::min(s, u0);
    return (A + B * below + C * (s - below)) * inverse;
  }
};
struct ExponentialLaw {
  V A, B, C, D;
  explicit ExponentialLaw(const RaceKernelInput& in) : A(in.A), B(in.B), C(in.C), D(in.D) {}
  V operator()(V s, V inverse) const { return ((A + B * s) * exponential(-C * s) + D) * inverse; }
};

struct Ellipse {
  V load, approach, a, b;
  V u_c, u_t, W_c, W_t,
      W_n;  ///< slip at the ball centre and relative rotation, as EllipseKinematics
};
struct Traction {
  V F_c = 0.0, F_t = 0.0, M_c = 0.0, M_t = 0.0, M_n = 0.0, heat = 0.0, load_slip = 0.0;
};

struct Pick {
  [[gnu::always_inline]] V operator()(const V::mask_type& condition, V a, V b) const {
    stdx::where(condition, b) = a;
    return b;
  }
};

/// The integral of one contact per lane. At fixed ξ only the moments Σ (κ/s) v^k, k = 0, 1, 2, are
/// needed over η because u_t is constant there and u_c = mean - swing v.
template <class Law>
class Integral {
 public:
  Integral(const RaceKernelInput& in, const Ellipse& ellipse)
      : in_(in),
        e_(ellipse),
        law_(in),
        floor_(in.slip_floor),
        rho2_(in.rho * in.rho),
        offset_(in.ball_radius) {
    if (in.height == KernelHeight::ThroughEdge) {
      offset_ = root(V(in.ball_radius * in.ball_radius) - e_.a * e_.a);
      if (in.rho > 0.0) offset_ -= root(rho2_ - e_.a * e_.a);
    } else {
      if (in.height == KernelHeight::HalfApproach) offset_ -= 0.5 * e_.approach;
      offset_ -= in.rho;
    }
  }

  [[gnu::always_inline]] Traction product_rule() {
    for (int i = 0; i < in_.major_nodes; ++i) {
      add_row(in_.s[i] * e_.a, in_.chord[i] * e_.b, in_.weight_s[i] * e_.load);
    }
    return sum_;
  }

  [[gnu::always_inline]] Traction split_rule() {
    const V law2 = in_.slip_scale * in_.slip_scale, sweep = 0.5 * e_.W_n * e_.b;
    const V sweep2 = sweep * sweep;
    const V width = stdx::sqrt(stdx::sqrt(law2 * law2 + sweep2 * sweep2));
    const V at_end = e_.u_t - e_.W_c * height(e_.a), centre = e_.u_t - e_.W_c * height(V(0.0));
    const V swing = e_.W_n * e_.a;
    const auto at =
        tribology::ellipse_breaks(at_end - swing, centre, at_end + swing, width, Pick{});
    const V ends[tribology::kEllipsePieces + 1] = {V(-1.0), at.s1, at.s2, at.s3, at.s4, V(1.0)};
    for (int piece = 0; piece < tribology::kEllipsePieces; ++piece) {
      const V length = ends[piece + 1] - ends[piece];
      if (stdx::none_of(length > 0.0)) continue;
      const V load = 0.75 * length * e_.load;
      for (int i = 0; i < in_.major_nodes; ++i) {
        const V s = ends[piece] + length * in_.s[i];
        const V outside = stdx::max(1.0 - s * s, V(0.0));
        add_row(s * e_.a, root(outside) * e_.b, in_.weight_s[i] * outside * load);
      }
    }
    return sum_;
  }

 private:
  /// h(ξ) = offset, or offset + sqrt(ρ² - ξ²) when curved.
  [[gnu::always_inline]] V height(V xi) const {
    return in_.rho > 0.0 ? offset_ + root(rho2_ - xi * xi) : offset_;
  }

  [[gnu::always_inline]] void add_row(V xi, V half_width, V load) {
    const V h = height(xi);
    const V u_t = e_.u_t + e_.W_n * xi - e_.W_c * h;
    const V mean = e_.u_c + e_.W_t * h;
    const V swing = e_.W_n * half_width;
    const V fixed = u_t * u_t + floor_;
    V g0 = 0.0, g1 = 0.0, g2 = 0.0, speed = 0.0;
    for (int j = 0; j < in_.minor_nodes; ++j) {
      const V u_c = mean - swing * in_.v[j];
      const V square = u_c * u_c + fixed;
      const V inverse = inverse_sqrt(square);
      const V slip = square * inverse;
      const V g = law_(slip, inverse);
      g0 += g * in_.weight_v[j];
      g1 += g * in_.weight_v1[j];
      g2 += g * in_.weight_v2[j];
      speed += slip * in_.weight_v[j];
    }
    const V f_t = load * (g0 * u_t);
    const V f_c = load * (mean * g0 - swing * g1);
    const V f_cv = load * (mean * g1 - swing * g2);
    sum_.F_c += f_c;
    sum_.F_t += f_t;
    sum_.M_c -= h * f_t;
    sum_.M_t += h * f_c;
    sum_.M_n += xi * f_t - half_width * f_cv;
    sum_.heat += u_t * f_t + mean * f_c - swing * f_cv;
    sum_.load_slip += load * speed;
  }

  const RaceKernelInput& in_;
  const Ellipse& e_;
  Law law_;
  V floor_, rho2_, offset_;
  Traction sum_;
};

struct Totals {
  V force_x = 0.0, force_y = 0.0, force_z = 0.0, moment_x = 0.0, moment_y = 0.0, moment_z = 0.0;
  V elastic_energy = 0.0, heat = 0.0, load_slip = 0.0;
};

/// One vector of balls: where its lanes are read and written.
struct Lanes {
  const double *x, *r, *sin_theta, *cos_theta, *x_dot, *r_dot, *theta_dot;
  const double *omega_x, *omega_r, *omega_theta;
  double *F_x, *F_r, *F_theta, *M_x, *M_r, *M_theta, *load, *heat, *load_slip;
  int used;  ///< lanes that are balls; the others hold copies and count as open contacts
};

inline V get(const double* from) { return V(from, stdx::element_aligned); }
inline void put(double* to, V value) { value.copy_to(to, stdx::element_aligned); }
inline void add(double* to, V value) { put(to, get(to) + value); }

template <class Law>
void evaluate(const RaceKernelInput& in, const Lanes& at, Totals& totals) {
  const V s = get(at.sin_theta), c = get(at.cos_theta);
  const Vec k = to_azimuth(in.axis, s, c);
  const Vec centre = to_azimuth(in.centre, s, c);
  const V r = get(at.r);
  const Vec d{get(at.x) - centre.x, r - centre.r, -centre.t};  // ball centre from P_j

  // Cylindrical about the race axis. R - Rc is formed from d_r - Rc and a small excess, so that
  // rounding of R does not reach the approach.
  const V axial = dot(d, k);
  const Vec p{d.x - axial * k.x, d.r - axial * k.r, d.t - axial * k.t};
  const V across = p.x * p.x + p.t * p.t;
  const V inverse_R = inverse_sqrt(stdx::max(p.r * p.r + across, V(1e-30)));
  const V R = (p.r * p.r + across) * inverse_R;
  const V lift = (p.r - in.centre_radius) + across / (R + p.r);
  const V l2 = stdx::max(axial * axial + lift * lift, V(1e-30));
  const V inverse_l = inverse_sqrt(l2);
  V approach = l2 * inverse_l - in.offset;
  if (at.used < static_cast<int>(V::size())) {
    const V lane([](auto i) { return static_cast<double>(i); });
    stdx::where(lane >= static_cast<double>(at.used), approach) = -1.0;
  }
  if (stdx::none_of(approach > 0.0)) {
    put(at.load, 0.0);
    put(at.heat, 0.0);
    if (at.load_slip != nullptr) put(at.load_slip, 0.0);
    return;
  }
  approach = stdx::max(approach, V(0.0));
  const V root_approach = stdx::sqrt(approach);
  const V load = in.K * approach * root_approach;
  const V n_k = axial * inverse_l, n_e = lift * inverse_l;
  const Vec e{p.x * inverse_R, p.r * inverse_R, p.t * inverse_R};
  const Vec t{k.r * e.t - k.t * e.r, k.t * e.x - k.x * e.t, k.x * e.r - k.r * e.x};

  V force_k = -load * n_k, force_e = -load * n_e, force_t = 0.0;
  V heat = 0.0, load_slip = 0.0;
  Vec moment{0.0, 0.0, 0.0};
  V moment_k = 0.0, moment_e = 0.0, moment_t = 0.0;
  if (in.traction) {
    const Vec race_velocity = to_azimuth(in.velocity, s, c);
    Vec w{race_velocity.x - get(at.x_dot), race_velocity.r - get(at.r_dot),
          race_velocity.t - r * get(at.theta_dot)};
    Vec omega{get(at.omega_x), get(at.omega_r), get(at.omega_theta)};
    if (in.tilts) {  // across k: W_k below is not touched
      const Vec tilt = to_azimuth(in.tilt, s, c);
      w = {w.x + (tilt.r * d.t - tilt.t * d.r), w.r + (tilt.t * d.x - tilt.x * d.t),
           w.t + (tilt.x * d.r - tilt.r * d.x)};
      omega = {omega.x - tilt.x, omega.r - tilt.r, omega.t - tilt.t};
    }
    const V W_k = in.speed - dot(omega, k), W_e = -dot(omega, e);
    Ellipse ellipse;
    ellipse.load = load;
    ellipse.approach = approach;
    ellipse.a = in.major * root_approach;
    ellipse.b = in.minor * root_approach;
    ellipse.u_c = n_k * dot(w, e) - n_e * dot(w, k);
    ellipse.u_t = dot(w, t) + in.speed * R;
    ellipse.W_c = n_k * W_e - n_e * W_k;
    ellipse.W_t = -dot(omega, t);
    ellipse.W_n = n_k * W_k + n_e * W_e;
    Integral<Law> integral(in, ellipse);
    const Traction traction = in.split ? integral.split_rule() : integral.product_rule();
    force_k -= traction.F_c * n_e;
    force_e += traction.F_c * n_k;
    force_t = traction.F_t;
    moment_k = traction.M_n * n_k - traction.M_c * n_e;
    moment_e = traction.M_n * n_e + traction.M_c * n_k;
    moment_t = traction.M_t;
    moment = {moment_k * k.x + moment_e * e.x + moment_t * t.x,
              moment_k * k.r + moment_e * e.r + moment_t * t.r,
              moment_k * k.t + moment_e * e.t + moment_t * t.t};
    heat = traction.heat;
    load_slip = traction.load_slip;
    add(at.M_x, moment.x);
    add(at.M_r, moment.r);
    add(at.M_theta, moment.t);
  }
  const Vec force{force_k * k.x + force_e * e.x + force_t * t.x,
                  force_k * k.r + force_e * e.r + force_t * t.r,
                  force_k * k.t + force_e * e.t + force_t * t.t};
  add(at.F_x, force.x);
  add(at.F_r, force.r);
  add(at.F_theta, force.t);
  put(at.load, load);
  put(at.heat, heat);
  if (at.load_slip != nullptr) put(at.load_slip, load_slip);

  // On the race about P_j: -(d × F + M), d = axial k + R e.
  const V about_k = R * force_t + moment_k;
  const V about_e = moment_e - axial * force_t;
  const V about_t = axial * force_e - R * force_k + moment_t;
  const Vec about{about_k * k.x + about_e * e.x + about_t * t.x,
                  about_k * k.r + about_e * e.r + about_t * t.r,
                  about_k * k.t + about_e * e.t + about_t * t.t};
  totals.force_x -= force.x;
  totals.force_y += s * force.r + c * force.t;
  totals.force_z -= c * force.r - s * force.t;
  totals.moment_x -= about.x;
  totals.moment_y += s * about.r + c * about.t;
  totals.moment_z -= c * about.r - s * about.t;
  totals.elastic_energy += 0.4 * load * approach;
  totals.heat += heat;
  totals.load_slip += load_slip;
}

/// The last, incomplete vector works on copies: no lane reads or writes beyond the arrays.
template <class Law>
void evaluate_tail(const RaceKernelInput& in, std::size_t first, int used, Totals& totals) {
  constexpr int kLanes = static_cast<int>(V::size());
  double copies[19][kLanes];
  const double* sources[10] = {in.x,     in.r,         in.sin_theta, in.cos_theta, in.x_dot,
                               in.r_dot, in.theta_dot, in.omega_x,   in.omega_r,   in.omega_theta};
  double* targets[9] = {in.F_x,     in.F_r,  in.F_theta, in.M_x,      in.M_r,
                        in.M_theta, in.load, in.heat,    in.load_slip};
  for (int array = 0; array < 10; ++array) {
    for (int i = 0; i < kLanes; ++i) {
      copies[array][i] = sources[array][first + static_cast<std::size_t>(i < used ? i : used - 1)];
    }
  }
  for (int array = 0; array < 9; ++array) {
    for (int i = 0; i < kLanes; ++i) {
      const bool add_to = array < 6 && i < used;
      copies[10 + array][i] = add_to ? targets[array][first + static_cast<std::size_t>(i)] : 0.0;
    }
  }
  Lanes at{copies[0],  copies[1],  copies[2],  copies[3],  copies[4],  copies[5],  copies[6],
           copies[7],  copies[8],  copies[9],  copies[10], copies[11], copies[12], copies[13],
           copies[14], copies[15], copies[16], copies[17], copies[18], used};
  evaluate<Law>(in, at, totals);
  for (int array = 0; array < 9; ++array) {
    if (targets[array] == nullptr) continue;
    for (int i = 0; i < used; ++i)
      targets[array][first + static_cast<std::size_t>(i)] = copies[10 + array][i];
  }
}

template <class Law>
RaceKernelSums evaluate_all(const RaceKernelInput& in) {
  constexpr std::size_t kLanes = V::size();
  Totals totals;
  std::size_t i = 0;
  for (; i + kLanes <= in.n; i += kLanes) {
    const Lanes at{in.x + i,
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
                   static_cast<int>(kLanes)};
    evaluate<Law>(in, at, totals);
  }
  if (i < in.n) evaluate_tail<Law>(in, i, static_cast<int>(in.n - i), totals);
  return {
      {stdx::reduce(totals.force_x), stdx::reduce(totals.force_y), stdx::reduce(totals.force_z)},
      {stdx::reduce(totals.moment_x), stdx::reduce(totals.moment_y), stdx::reduce(totals.moment_z)},
      stdx::reduce(totals.elastic_energy),
      stdx::reduce(totals.heat),
      stdx::reduce(totals.load_slip)};
}

inline RaceKernelSums evaluate_race(const RaceKernelInput& in) {
  return in.two_slope ? evaluate_all<TwoSlopeLaw>(in) : evaluate_all<ExponentialLaw>(in);
}

}  // namespace
}  // namespace adore::dynamics
