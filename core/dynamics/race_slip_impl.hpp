#pragma once

#include "dynamics/race_kernel_impl.hpp"
#include "dynamics/slip_kernel.hpp"
#include "tribology/largest_slip.hpp"

/// Largest slip of all contacts with one race, one ball per vector lane (slip_kernel.hpp).
namespace adore::dynamics {
namespace {

template <class Race, class Balls>
void find_contact_slips(const RaceKernelInput& in) {
  for_vectors<ArrayAccess::Both>(in, [&](const Lanes& at) {
    const Balls balls(in, at);
    Contacts<Race, Balls> contacts(in, at, balls);
    V slip = 0.0;
    if (!contacts.open()) {
      contacts.compute_load(in, at, balls);
      slip = stdx::sqrt(tribology::largest_slip_square(contacts.ellipse()));
      stdx::where(!(contacts.load() > 0.0), slip) = 0.0;
    }
    put(at.load, slip);
  });
}

inline void run_slip_kernel(const RaceKernelInput& in) {
  if (in.half.is_split())
    find_contact_slips<SplitRaceHalf, DifferentBalls>(in);
  else if (in.own != nullptr)
    find_contact_slips<WavyRace, DifferentBalls>(in);
  else if (in.wavy != nullptr)
    find_contact_slips<WavyRace, IdenticalBalls>(in);
  else
    find_contact_slips<RoundRace, IdenticalBalls>(in);
}

}  // namespace
}  // namespace adore::dynamics
