#pragma once

#include "contact/roller_race_sum.hpp"
#include "tribology/laws/rolling_resistance.hpp"

#include <cstddef>

/// Boundary between motion (dynamics/effects/roller_races.cpp), the friction equilibrium
/// (roller_friction.cpp) and the translation units that are compiled once per instruction set:
/// plain numbers and pointers only (reason in dynamics/race_kernel.hpp).
namespace adore::statics {

/// On one roller, in its meridian frame; moment about its middle.
struct RollerKernelAction {
  double force[3], moment[3];
  double load, energy, heat, load_slip;
  double fastest;  ///< largest slip of slices that press, squared [m²/s²]; 0 without traction
  double turning;  ///< with slopes: contact::RollerRaceSums::turning [J/rad]
  double damping;  ///< power that damping takes [W]
};

/// Storage for the loaded slices of all rollers before a call of a user law: in sequence,
/// in whole vectors, for one call. Sized at set-up (SliceScratch in user_points.hpp).
struct UserLawSlices {
  double* contact[7];              ///< ContactConditions in the order of UserTractionInput
  double *slip, *inverse, *kappa;  ///< s, rounded, and 1/s
  double* kept[11];                ///< contact::LoadedSlice
  int* vectors_of;                 ///< of each roller
};

/// Other loads on the same contacts.
struct RollerResistanceLoad {
  double force[3], moment[3];  ///< on one roller, in its meridian frame, about its middle
  double heat;                 ///< [W]
};

struct RollerKernelInput {
  const contact::RaceSlicesView* slices;  ///< of each roller, or of all
  bool alike;                             ///< one for all
  std::size_t n;
  const contact::RollerPose* rollers;
  const contact::RaceAzimuthSlope* slopes;  ///< of each roller on a race with errors, or null
  RollerKernelAction* out;
  bool traction;
  // Law of traction: one of tribology::TractionLawList.
  std::size_t law_index;
  const void* law;
  double regularization_slip_squared;  ///< ε² of the rounded slip sqrt(u² + ε²) [m²/s²], > 0
  const UserLawSlices* user;           ///< of a law of the user; else null
  /// Of a law with a film: rolling resistance of the oil, of the same films; null: none.
  const tribology::RollingResistance* rolling;
  RollerResistanceLoad* rolled;  ///< meaning of the above
};

/// Rolling resistance of the oil with a traction law without a film (statics/roller_rolling.hpp).
struct RollingResistanceInput {
  const contact::RaceSlicesView* slices;  ///< as in RollerKernelInput
  bool alike;
  std::size_t n;
  const contact::RollerPose* rollers;
  RollerResistanceLoad* out;
  const tribology::RollingResistance* law;
};

/// Slices of one roller for a report; rows of whole vectors, which hold 0 before.
struct RollerSliceRows {
  double *load, *width;              ///< Q [N]; on the land [m]
  double *peak, *half_width;         ///< p [Pa], b [m] of the line
  double *curvature, *slip, *speed;  ///< Σρ [1/m], |u|, entrainment [m/s]
  double* n[3];                      ///< from the roller into the race, meridian frame
};
/// Writes the slices that press. The roller need not touch.
struct RollerReportInput {
  const contact::RaceSlicesView* slices;
  const contact::RollerPose* roller;
  const contact::RaceAzimuthSlope* slope;  ///< of a race with errors; null: none
  RollerSliceRows rows;
};

using RollerKernel = void (*)(const RollerKernelInput&) noexcept;
using RollingResistanceKernel = void (*)(const RollingResistanceInput&) noexcept;
using RollerReportKernel = void (*)(const RollerReportInput&) noexcept;

void roller_kernel_baseline(const RollerKernelInput& in) noexcept;
void roller_rolling_resistance_baseline(const RollingResistanceInput& in) noexcept;
void roller_report_baseline(const RollerReportInput& in) noexcept;
#if defined(__x86_64__)
void roller_kernel_avx2(const RollerKernelInput& in) noexcept;
void roller_rolling_resistance_avx2(const RollingResistanceInput& in) noexcept;
void roller_report_avx2(const RollerReportInput& in) noexcept;
void roller_kernel_avx512(const RollerKernelInput& in) noexcept;
void roller_rolling_resistance_avx512(const RollingResistanceInput& in) noexcept;
void roller_report_avx512(const RollerReportInput& in) noexcept;
#endif

}  // namespace adore::statics
