#pragma once

#include "dynamics/race_kernel_impl.hpp"
#include "dynamics/slip_kernel.hpp"
#include "tribology/largest_slip.hpp"

/// Largest slip of all contacts with one race, one ball per vector lane (slip_kernel.hpp).
namespace adore::dynamics {
namespace {

template <class Race, class Balls>
void slip_all(const RaceKernelInput& in) {
  for_vectors<Use::Both>(in, [&](const Lanes& at) {
    const Balls balls(in, at);
    Contacts<Race, Balls> contacts(in, at, balls);
    V slip = 0.0;
    if (!contacts.open()) {
      contacts.press(in, at, balls);
      slip = stdx::sqrt(tribology::largest_slip_square(contacts.ellipse()));
      stdx::where(!(contacts.load() > 0.0), slip) = 0.0;
    }
    put(at.load, slip);
  });
}

inline void slip_on_race(const RaceKernelInput& in) {
  if (in.half.is_split())
    slip_all<HalfRace, DifferentBalls>(in);
  else if (in.own != nullptr)
    slip_all<WavyRace, DifferentBalls>(in);
  else if (in.wavy != nullptr)
    slip_all<WavyRace, AlikeBalls>(in);
  else
    slip_all<RoundRace, AlikeBalls>(in);
}

}  // namespace
}  // namespace adore::dynamics
