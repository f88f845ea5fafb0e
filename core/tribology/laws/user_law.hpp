#pragma once

#include "base/scalar_lanes.hpp"
#include "tribology/laws/contact_point.hpp"

/// A traction law that a routine of the user evaluates (ADRX7): plain numbers and pointers, since
/// the race kernels see it.
namespace adore::tribology {

/// The five kinds of contact with separate traction laws.
enum class TractionKind : unsigned char {
  ElementRace,
  ElementCage,
  CageRace,
  RollerFlange,
  ElementElement
};

/// Input of a routine: contacts in parallel, point k of contact i at [k * stride + i]. SI;
/// members as in user/adore_user.h.
struct UserTractionInput {
  int kind = 0, race = -1;
  long n = 0, points = 0, stride = 0;
  const double* slip = nullptr;
  const double* pressure = nullptr;  ///< null: not formed
  const double *load = nullptr, *peak_pressure = nullptr, *half_major = nullptr,
               *half_minor = nullptr, *entrainment = nullptr, *curvature = nullptr,
               *middle_slip = nullptr;
  double* kappa = nullptr;  ///< points * stride, to be filled
};

/// The routine. ask() fills κ, with zeros once the routine has failed; it does not throw.
struct UserTractionRoutine {
  void* routine = nullptr;
  void (*ask)(void* routine, const UserTractionInput& in) = nullptr;
  double slip_scale = 0.0;  ///< slip over which κ rises from 0 [m/s]; 0: none
  double at_rest = 0.0;     ///< κ(0)
  bool wants_pressure = true;
};

struct UserTractionLaw {
  const UserTractionRoutine* of = nullptr;
  int kind = 0, race = -1;

  static constexpr bool kDependsOnPressure = true;

  /// One contact, or one a lane: asks for them at once.
  template <class T>
  struct Here {
    const UserTractionRoutine* of;
    int kind, race;
    ContactConditions<T> contact;
    T operator()(const T& slip, const T& pressure) const {
      using Lanes = ScalarLanes<T>;
      constexpr int n = Lanes::kCount;
      double in[9][n], kappa[n];
      const T* values[9] = {&slip,
                            &pressure,
                            &contact.load,
                            &contact.peak_pressure,
                            &contact.half_major,
                            &contact.half_minor,
                            &contact.entrainment,
                            &contact.curvature,
                            &contact.slip};
      for (int k = 0; k < 9; ++k)
        for (int lane = 0; lane < n; ++lane) in[k][lane] = Lanes::get(*values[k], lane);
      of->ask(of->routine, {kind, race, n, 1, n, in[0], of->wants_pressure ? in[1] : nullptr, in[2],
                            in[3], in[4], in[5], in[6], in[7], in[8], kappa});
      return Lanes::from(kappa);
    }
  };
  template <class T>
  Here<T> at(const ContactConditions<T>& contact) const {
    return {of, kind, race, contact};
  }
  [[nodiscard]] double kink() const { return 0.0; }
  [[nodiscard]] double start() const { return of->slip_scale; }
  [[nodiscard]] double at_rest() const { return of->at_rest; }
};

}  // namespace adore::tribology
