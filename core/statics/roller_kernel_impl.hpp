#pragma once

#include "base/simd_inverse_roots.hpp"
#include "base/simd_tiles.hpp"
#include "contact/roller_race_simd.hpp"
#include "statics/film_on_slices.hpp"
#include "statics/roller_kernel.hpp"
#include "statics/roller_kernel_user.hpp"
#include "statics/roller_rolling.hpp"
#include "tribology/traction_laws.hpp"

#include <cstddef>
#include <type_traits>

/// All slices of all rollers against one race, a slice a lane. Included by one translation unit per
/// instruction set; contact/roller_race.hpp states the contact.
namespace adore::statics {
namespace {

using V = SimdReal;
using Lanes = contact::SliceLanes<V>;

inline void store_resistance_load(const contact::RollerRaceSums<V>& sums,
                                  RollerResistanceLoad& out) {
  out.force[0] = Lanes::sum(sums.force.x);
  out.force[1] = Lanes::sum(sums.force.y);
  out.force[2] = Lanes::sum(sums.force.z);
  out.moment[0] = Lanes::sum(sums.moment.x);
  out.moment[1] = Lanes::sum(sums.moment.y);
  out.moment[2] = Lanes::sum(sums.moment.z);
  out.heat = Lanes::sum(sums.heat);
}

/// Slices that wait for traction.
inline void store_traction(const contact::RollerRaceSums<V>& sums, RollerKernelAction& out) {
  out.force[0] = Lanes::sum(sums.force.x);
  out.force[1] = Lanes::sum(sums.force.y);
  out.force[2] = Lanes::sum(sums.force.z);
  out.moment[0] = Lanes::sum(sums.moment.x);
  out.moment[1] = Lanes::sum(sums.moment.y);
  out.moment[2] = Lanes::sum(sums.moment.z);
  out.heat = Lanes::sum(sums.heat);
}

inline void put(const contact::RollerRaceSums<V>& sums, RollerKernelAction& out) {
  store_traction(sums, out);
  out.load = Lanes::sum(sums.load);
  out.energy = Lanes::sum(sums.energy);
  out.load_slip = Lanes::sum(sums.load_slip);
  out.fastest = stdx::hmax(sums.fastest);
  out.damping = Lanes::sum(sums.damping);
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

/// Of a law of the user: both passes (roller_kernel_user.hpp).
inline void evaluate_rollers_user_law(const RollerKernelInput& in) {
  const auto& law = *static_cast<const tribology::UserTractionLaw*>(in.law);
  const UserLawSlices& user = *in.user;
  std::size_t column = 0;
  for (std::size_t i = 0; i < in.n; ++i) {
    user.vectors_of[i] = 0;
    in.out[i] = {};
    if (in.rollers[i].open) continue;
    const std::size_t before = column;
    const UserSliceCollector collect{user, in.regularization_slip_squared, column};
    if (in.slopes != nullptr) {
      const auto sums =
          contact::roller_race_sums<V>(in.slices[i], in.rollers[i], collect, in.slopes[i]);
      put(sums, in.out[i]);
      in.out[i].turning = Lanes::sum(sums.turning);
    } else {
      put(contact::roller_race_sums<V>(in.slices[in.alike ? 0 : i], in.rollers[i], collect),
          in.out[i]);
    }
    user.vectors_of[i] = static_cast<int>((column - before) / V::size());
  }
  call_user_routine(law, user, column);
  column = 0;
  for (std::size_t i = 0; i < in.n; ++i) {
    if (user.vectors_of[i] == 0) continue;
    contact::RollerRaceSums<V> sums;
    for (int k = user.vectors_of[i]; k > 0; --k, column += V::size())
      add_user_law_results(user, column, sums);
    store_traction(sums, in.out[i]);
  }
}

using AnswerOfOil = OilSliceBatcher<V>::Answer;

/// Rollers in a lubricant, two at a time: slices of one may wait for those of the next.
/// @param films FilmOnSlices of the law, which `answer` knows
[[gnu::noinline]] inline void evaluate_rollers_in_oil(const RollerKernelInput& in,
                                                      const void* films, AnswerOfOil answer) {
  struct Roller {
    std::size_t index = 0;
    contact::RollerRaceSums<V> sums;
    RollerOilForces<V> oil;
  };
  Roller two[2];
  OilSliceBatcher<V> slices(films, answer, in.rolling != nullptr);
  const auto put_roller = [&](Roller& one) {
    if (one.oil.at == nullptr) return;
    if (slices.has_pending_slices(one.oil)) slices.finish();
    RollerKernelAction& out = in.out[one.index];
    one.sums.force = one.sums.force + one.oil.traction.force;
    one.sums.moment = one.sums.moment + one.oil.traction.moment;
    one.sums.heat = one.oil.traction.heat;
    put(one.sums, out);
    out.turning = in.slopes != nullptr ? Lanes::sum(one.sums.turning) : 0.0;
    if (in.rolling != nullptr) store_resistance_load(one.oil.rolling, in.rolled[one.index]);
  };
  int which = 0;
  for (std::size_t i = 0; i < in.n; ++i) {
    const contact::RollerPose& at = in.rollers[i];
    in.out[i] = {};
    if (in.rolling != nullptr) in.rolled[i] = {};
    if (at.open) continue;
    Roller& one = two[which];
    put_roller(one);
    one.index = i;
    one.oil = {&at, {}, {}};
    slices.begin(one.oil);
    const OilSliceForwarder<V> hands{slices};
    one.sums = in.slopes != nullptr
                   ? contact::roller_race_sums<V>(in.slices[i], at, hands, in.slopes[i])
                   : contact::roller_race_sums<V>(in.slices[in.alike ? 0 : i], at, hands);
    which = 1 - which;
  }
  for (Roller& one : two) put_roller(one);
}

template <class Law>
void evaluate_with_law(const RollerKernelInput& in) {
  const Law& law = *static_cast<const Law*>(in.law);
  if constexpr (std::is_same_v<Law, tribology::UserTractionLaw>) {
    evaluate_rollers_user_law(in);
  } else if constexpr (tribology::kHasFilm<Law>) {
    using Films = FilmOnSlices<Law>;
    const Films films{law, in.regularization_slip_squared, in.rolling};
    evaluate_rollers_in_oil(
        in, &films, [](const void* of, const PendingSlices<V>& waiting, V* over_slip, V* F) {
          static_cast<const Films*>(of)->answer(waiting, over_slip, F);
        });
  } else {
    const auto here = law.at(tribology::ContactConditions<V>{});
    evaluate_rollers(
        in, tribology::RegularizedLaw<decltype(here)>{here, in.regularization_slip_squared});
  }
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

inline void evaluate_rolling_resistance(const RollingResistanceInput& in) {
  for (std::size_t i = 0; i < in.n; ++i) {
    const contact::RollerPose& at = in.rollers[i];
    RollerResistanceLoad& out = in.out[i];
    out = {};
    if (at.open) continue;
    contact::RollerRaceSums<V> sums;
    const SliceRollingResistance<V> rolling{*in.law, at, sums};
    (void)contact::roller_race_sums<V>(in.slices[in.alike ? 0 : i], at, rolling);
    store_resistance_load(sums, out);
  }
}

/// Takes the slices of one vector, from `first` on.
struct SliceReporter {
  const RollerSliceRows& rows;
  std::size_t first;

  [[gnu::always_inline]] void keep(const contact::LoadedSlice<V>& slice,
                                   const contact::SliceContactState<V>& at) const {
    const auto put = [this](const V& from, double* row) {
      from.copy_to(row + first, stdx::element_aligned);
    };
    put(slice.Q, rows.load);
    put(at.width, rows.width);
    put(at.peak_pressure, rows.peak);
    put(at.half_width, rows.half_width);
    put(at.curvature, rows.curvature);
    put(at.slip, rows.slip);
    put(at.entrainment, rows.speed);
    put(slice.n.x, rows.n[0]);
    put(slice.n.y, rows.n[1]);
    put(slice.n.z, rows.n[2]);
  }
};

/// Vector by vector, since sums skip those that do not press.
inline void report_slices(const RollerReportInput& in) {
  contact::RaceSlicesView some = *in.slices;
  some.count = Lanes::kSize;
  contact::RaceAzimuthSlope slope = in.slope != nullptr ? *in.slope : contact::RaceAzimuthSlope{};
  for (std::size_t k = 0; k < in.slices->count; k += Lanes::kSize) {
    const SliceReporter report{in.rows, k};
    if (in.slope != nullptr)
      (void)contact::roller_race_sums<V>(some, *in.roller, report, slope);
    else
      (void)contact::roller_race_sums<V>(some, *in.roller, report);
    some.s += Lanes::kSize;
    some.radius += Lanes::kSize;
    some.width += Lanes::kSize;
    if (slope.rise != nullptr) slope.rise += Lanes::kSize;
  }
}

}  // namespace
}  // namespace adore::statics
