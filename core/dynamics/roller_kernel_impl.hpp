#pragma once

#include "base/simd_math.hpp"
#include "contact/roller_race_damping.hpp"
#include "contact/roller_race_simd.hpp"
#include "dynamics/roller_kernel.hpp"
#include "dynamics/slice_law.hpp"
#include "tribology/traction_laws.hpp"

#include <cstddef>

/// All slices of all rollers against one race, a slice a lane. Included by one translation unit per
/// instruction set; contact/roller_race.hpp states the contact.
namespace adore::dynamics {
namespace {

using V = SimdReal;
using Lanes = contact::SliceLanes<V>;

inline void put(const contact::RollerRaceSums<V>& sums, RollerKernelAction& out) {
  out.force[0] = Lanes::sum(sums.force.x);
  out.force[1] = Lanes::sum(sums.force.y);
  out.force[2] = Lanes::sum(sums.force.z);
  out.moment[0] = Lanes::sum(sums.moment.x);
  out.moment[1] = Lanes::sum(sums.moment.y);
  out.moment[2] = Lanes::sum(sums.moment.z);
  out.load = Lanes::sum(sums.load);
  out.energy = Lanes::sum(sums.energy);
  out.heat = Lanes::sum(sums.heat);
  out.load_slip = Lanes::sum(sums.load_slip);
}

template <class Traction>
void evaluate_rollers(const RollerKernelInput& in, const Traction& traction) {
  if (in.slopes != nullptr) {
    for (std::size_t i = 0; i < in.n; ++i) {
      if (in.rollers[i].open) {
        in.out[i] = {};
        continue;
      }
      const auto sums =
          contact::roller_race_sums<V>(in.slices[i], in.rollers[i], traction, in.slopes[i]);
      put(sums, in.out[i]);
      in.out[i].turning = Lanes::sum(sums.turning);
    }
    return;
  }
  for (std::size_t i = 0; i < in.n; ++i) {
    if (in.rollers[i].open)
      in.out[i] = {};
    else
      put(contact::roller_race_sums<V>(in.slices[in.alike ? 0 : i], in.rollers[i], traction),
          in.out[i]);
  }
}

template <class Law>
void evaluate_with_law(const RollerKernelInput& in) {
  with_slice_law<V>(*static_cast<const Law*>(in.law), in.slip_floor,
                    [&](const auto& traction) { evaluate_rollers(in, traction); });
}

template <class... Laws>
void evaluate_with_laws(const RollerKernelInput& in, tribology::TypeList<Laws...>) {
  std::size_t index = 0;
  (void)((index++ == in.law_index && (evaluate_with_law<Laws>(in), true)) || ...);
}

/// Once per race: the law is chosen here, and nowhere below.
inline void evaluate_rollers(const RollerKernelInput& in) {
  if (in.traction)
    evaluate_with_laws(in, tribology::TractionLawList());
  else
    evaluate_rollers(in, nullptr);
}

inline void damp_rollers(const RollerDampingInput& in) {
  for (std::size_t i = 0; i < in.n; ++i) {
    const contact::RollerPose& at = in.rollers[i];
    RollerDampingAction& out = in.out[i];
    out = {};
    if (at.open) continue;
    const contact::RaceSlices& slices = in.slices[in.alike ? 0 : i];
    const auto sums = in.slopes == nullptr
                          ? contact::roller_damping_sums<V>(slices, at, in.damping)
                          : contact::roller_damping_sums<V>(slices, at, in.damping, in.slopes[i]);
    out.force[0] = Lanes::sum(sums.force.x);
    // Growing ψ is -y of the meridian frame, and what presses more pushes back.
    out.force[1] = Lanes::sum(sums.force.y) + Lanes::sum(sums.turning) / at.r;
    out.force[2] = Lanes::sum(sums.force.z);
    out.moment[0] = Lanes::sum(sums.moment.x);
    out.moment[1] = Lanes::sum(sums.moment.y);
    out.moment[2] = Lanes::sum(sums.moment.z);
    out.heat = Lanes::sum(sums.heat);
  }
}

}  // namespace
}  // namespace adore::dynamics
