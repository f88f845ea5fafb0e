#pragma once

#include "contact/angle_law.hpp"
#include "contact/damping_law.hpp"
#include "contact/split_race.hpp"
#include "tribology/ellipse_sum.hpp"
#include "tribology/laws/rolling_resistance.hpp"

#include <cstddef>

namespace adore::contact {
struct WavyGroove;
template <class C>
struct HertzConstantRatios;
}  // namespace adore::contact

/// Boundary between race_contacts.cpp and the translation units that are compiled once per
/// instruction set. Plain numbers and pointers only: a header with inline library code (Eigen,
/// std::vector) included there could leave AVX instructions in functions that the linker then uses
/// everywhere. What the kernels share with the rest (contact/ball_groove.hpp, ellipse_sum.hpp, the
/// traction laws) are templates over the scalar type, and the vector types of the instruction sets
/// differ.
namespace adore::dynamics {

/// Values of each ball if balls differ: as in RaceKernelInput.
struct BallConstants {
  double offset, K, major, minor, ball_radius, rho;
  contact::HertzAngleLaw follow;
  const contact::HertzConstantRatios<double>* ratios;  ///< of a race with errors; else null
};

/// Storage for the points of a user law, all contacts of the race, before the only
/// call, and for κ afterwards. Sized at set-up (UserScratch in user_points.hpp).
struct UserPoints {
  double *slip, *inverse, *pressure, *kappa;  ///< of each point, stride values each
  double* row;                                ///< four numbers of each row of the rule, likewise
  /// Of each contact, stride values each: ContactConditions in the order of UserTractionInput.
  double* contact[7];
  /// The contacts of a vector of balls between the passes, kKeptValues numbers a ball; aligned.
  double* kept;
  int* rows_of;        ///< of the vector whose first ball it is; -1: all are open
  std::size_t stride;  ///< >= n
};
/// Most numbers a ball that its contact keeps.
inline constexpr std::size_t kKeptValues = 64;

struct RaceKernelInput {
  // Groove, load and ellipse: Q = K δ^1.5, a = major sqrt(δ), b = minor sqrt(δ).
  double centre_radius, offset, K, major, minor;
  const contact::HertzAngleLaw* follow;  ///< of K and the ellipse; nullptr: frozen, as above
  double ball_radius;
  double rho;  ///< radius of the contact surface [m], 0 = flat
  tribology::SurfacePosition place;
  contact::DampingLaw<> damping;
  bool damped;
  bool traction;
  // Law of traction: one of tribology::TractionLawList.
  std::size_t law_index;
  const void* law;
  double regularization_slip_squared;  ///< ε² of the rounded slip sqrt(u² + ε²) [m²/s²], > 0
  double slip_scale;                   ///< of the law, for the break points of a split rule [m/s]
  tribology::EllipseNodes nodes;
  struct UserPoints* points;                    ///< of a law of the user; else null
  const tribology::RollingResistance* rolling;  ///< read by rolling kernels alone
  // Race pose and motion, base frame.
  double centre[3], axis[3], velocity[3], speed;
  bool tilts;
  double tilt[3];
  const contact::WavyGroove* wavy;  ///< null: a race of revolution
  double zero[3];                   ///< start of azimuths in a wavy race
  const BallConstants* own;         ///< of all balls of the bearing; null: they are identical
  contact::SplitRaceHalf half;      ///< of a split race, whose kernels read `own`
  // Balls and results (see race_contacts.hpp).
  std::size_t n;
  const double *x, *r, *sin_theta, *cos_theta, *x_dot, *r_dot, *theta_dot;
  const double *omega_x, *omega_r, *omega_theta;
  double *F_x, *F_r, *F_theta, *M_x, *M_r, *M_theta;
  double *load, *heat, *load_slip;
};

struct RaceKernelSums {
  double force[3], moment[3];  ///< on the race, base frame, about P_j
  double elastic_energy, heat, load_slip;
  double damping;  ///< power that damping takes
};

using RaceKernel = RaceKernelSums (*)(const RaceKernelInput&) noexcept;

RaceKernelSums race_kernel_baseline(const RaceKernelInput& in) noexcept;
/// Both races at once (race_pair_impl.hpp): the outer, then the inner of each array.
using RacePairKernel = void (*)(const RaceKernelInput*, RaceKernelSums*) noexcept;
void race_pair_baseline(const RaceKernelInput* in, RaceKernelSums* sums) noexcept;
/// Rolling resistance alone (race_rolling_impl.hpp): `load` and `heat` are not written, heat of the
/// sums is its own.
RaceKernelSums race_rolling_baseline(const RaceKernelInput& in) noexcept;
#if defined(__x86_64__)
RaceKernelSums race_kernel_avx2(const RaceKernelInput& in) noexcept;
void race_pair_avx2(const RaceKernelInput* in, RaceKernelSums* sums) noexcept;
RaceKernelSums race_rolling_avx2(const RaceKernelInput& in) noexcept;
RaceKernelSums race_kernel_avx512(const RaceKernelInput& in) noexcept;
void race_pair_avx512(const RaceKernelInput* in, RaceKernelSums* sums) noexcept;
RaceKernelSums race_rolling_avx512(const RaceKernelInput& in) noexcept;
#endif

}  // namespace adore::dynamics
