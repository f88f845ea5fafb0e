#pragma once

#include "contact/roller_race_sum.hpp"
#include "statics/roller_rolling.hpp"
#include "tribology/rounded_law.hpp"
#include "tribology/traction_laws.hpp"

/// Slices of rollers in a lubricant (contact/roller_race_sum.hpp): each has the film of its
/// load per length, speed and slip, the mean traction over its strip along rolling, and the rolling
/// resistance of the same film (laws/rolling_resistance.hpp), which is formed once. Two vectors of
/// slices are taken together, by floats where the law's film may be (laws/film_law_of.hpp, decision
/// 570): relative errors of κ and F are a few 1e-6. Seen by the roller kernels.
namespace adore::statics {

/// Slices that wait for their film.
template <class T>
struct PendingSlices {
  static constexpr int kMost = 2;
  int count = 0;
  contact::LoadedSlice<T> slice[kMost];
  contact::SliceContactState<T> place[kMost];
};

template <class Law>
struct FilmOnSlices {
  const Law& law;
  double floor;                                 ///< ε² of the rounded slip [m²/s²]
  const tribology::RollingResistance* rolling;  ///< null: none

  template <class T>
  static tribology::ContactConditions<T> point(const contact::SliceContactState<T>& s) {
    return {s.load_per_length, s.peak_pressure, T(0.0),     s.half_width,
            s.entrainment,     s.slip,          s.curvature};
  }
  /// κ(s)/s and F per length of all that wait. A call, so that a kernel has one copy of each law.
  template <class T>
  [[gnu::noinline]] void answer(const PendingSlices<T>& at, T* over_slip, T* resistance) const {
    if (answer_in_floats(at, over_slip, resistance)) return;
    for (int k = 0; k < at.count; ++k) {
      const auto contact = point(at.place[k]);
      const auto inlet = law.film.inlet_logarithms(contact);
      const auto film = law.film.at(contact, inlet);
      const auto here = law.at(contact, film);  // to which its strip points
      const auto strip = here.strip(contact.peak_pressure);
      over_slip[k] = tribology::RegularizedLaw<decltype(strip)>{strip, floor}(
          at.slice[k].square, contact.peak_pressure);
      if (rolling != nullptr) resistance[k] = rolling->force(contact, inlet, film.factor);
    }
  }

 private:
  /// False: the film does not take floats here.
  template <class T>
  [[gnu::always_inline]] bool answer_in_floats(const PendingSlices<T>& at, T* over_slip,
                                               T* resistance) const {
    if constexpr (requires { law.fluid.single_until; }) {
      using M = ScalarMath<T>;
      using To = SinglePrecisionOf<T>;
      using S = typename To::Type;
      const int b = at.count - 1;  // one alone stands for two
      const T most = M::max(at.place[0].peak_pressure, at.place[b].peak_pressure);
      if (law.fluid.single_until < 0.0 || M::any(most > law.fluid.single_until)) return false;
      const auto first = point(at.place[0]), last = point(at.place[b]);
      const auto pack = [&](T tribology::ContactConditions<T>::*of) __attribute__((always_inline)) {
        return To::pack(first.*of, last.*of);
      };
      using C = tribology::ContactConditions<T>;
      const tribology::ContactConditions<S> contact{
          pack(&C::load),       pack(&C::peak_pressure), S(0.0),
          pack(&C::half_minor), pack(&C::entrainment),   pack(&C::slip),
          pack(&C::curvature)};
      const auto inlet = law.film.inlet_logarithms(contact);
      const auto film = law.film.at(contact, inlet);
      T inverse_of[2], slip_of[2], kappa_of[2];
      for (int k = 0; k < 2; ++k)
        slip_of[k] = M::sqrt_and_inverse(at.slice[k == 0 ? 0 : b].square + floor, inverse_of[k]);
      S kappa;
      if (!law.at(contact, film)
               .try_strip_mean(contact.peak_pressure, To::pack(slip_of[0], slip_of[1]), kappa))
        return false;
      To::unpack(kappa, kappa_of[0], kappa_of[1]);
      for (int k = 0; k < at.count; ++k) over_slip[k] = kappa_of[k] * inverse_of[k];
      if (rolling != nullptr) {
        T F[2];
        To::unpack(rolling->force(contact, inlet, film.factor), F[0], F[1]);
        for (int k = 0; k < at.count; ++k) resistance[k] = F[k];
      }
      return true;
    }
    return false;
  }
};

/// Forces of the oil on one roller.
template <class T>
struct RollerOilForces {
  const contact::RollerPose* at = nullptr;
  contact::RollerRaceSums<T> traction, rolling;  ///< forces, moments and heats
};

/// Takes slices from roller_race_sums, of one roller after the other, and the last of a roller with
/// the first of the next; one type for all laws.
template <class T>
class OilSliceBatcher {
 public:
  using Answer = void (*)(const void* films, const PendingSlices<T>&, T* over_slip, T* resistance);

  OilSliceBatcher(const void* films, Answer answer, bool rolls)
      : films_(films), answer_(answer), rolls_(rolls) {}

  /// Slices that come are of this roller.
  void begin(RollerOilForces<T>& of) { now_ = &of; }

  [[gnu::always_inline]] void keep(const contact::LoadedSlice<T>& slice,
                                   const contact::SliceContactState<T>& at) {
    waiting_.slice[waiting_.count] = slice;
    waiting_.place[waiting_.count] = at;
    owner_[waiting_.count] = now_;
    if (++waiting_.count == PendingSlices<T>::kMost) add();
  }
  [[nodiscard]] bool has_pending_slices(const RollerOilForces<T>& one) const {
    for (int k = 0; k < waiting_.count; ++k)
      if (owner_[k] == &one) return true;
    return false;
  }
  void finish() {
    if (waiting_.count > 0) add();
  }

 private:
  [[gnu::noinline]] void add() {
    T over_slip[PendingSlices<T>::kMost], resistance[PendingSlices<T>::kMost];
    answer_(films_, waiting_, over_slip, resistance);
    for (int k = 0; k < waiting_.count; ++k) {
      RollerOilForces<T>& of = *owner_[k];
      contact::add_loaded_slice(of.traction, waiting_.slice[k], over_slip[k]);
      if (rolls_)
        add_rolling_resistance(waiting_.slice[k], waiting_.place[k], resistance[k], *of.at,
                               of.rolling);
    }
    waiting_.count = 0;
  }

  const void* films_;
  Answer answer_;
  bool rolls_;
  RollerOilForces<T>* now_ = nullptr;
  PendingSlices<T> waiting_;
  RollerOilForces<T>* owner_[PendingSlices<T>::kMost];
};

/// Receiver for roller_race_sums; its input is treated as constant.
template <class T>
struct OilSliceForwarder {
  OilSliceBatcher<T>& to;
  [[gnu::always_inline]] void keep(const contact::LoadedSlice<T>& slice,
                                   const contact::SliceContactState<T>& at) const {
    to.keep(slice, at);
  }
};

}  // namespace adore::statics
