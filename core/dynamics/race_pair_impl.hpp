#pragma once

#include "dynamics/race_kernel_impl.hpp"

/// Both races of alike balls, in the same translation units as race_kernel_impl.hpp: balls that
/// fill no vector of one race go together in one, where they fit (18 balls, vectors of eight: five
/// for six). Constants of the race are one a lane there, so that products are fused in other
/// places: last digits differ from those of one race after the other.
namespace adore::dynamics {
namespace {

/// The last `rest` balls of both races, those of the outer first.
template <class Visit>
void visit_both_tails(const RaceKernelInput* in, std::size_t first, int rest, const Visit& visit) {
  const Arrays outer(in[0]), inner(in[1]);
  TailCopies copies;
  copies.read(outer, 2 * rest,
              [&](int i) { return first + static_cast<std::size_t>(i < rest ? i : i - rest); });
  copies.begin(outer, first, rest);
  visit(copies.lanes(first, 2 * rest));
  for (int array = 0; array < kTargets; ++array) {
    if (outer.target[array] == nullptr) continue;
    const double* const values = copies.target[array];
    for (int i = 0; i < rest; ++i) {
      const std::size_t ball = first + static_cast<std::size_t>(i);
      if (array < kAdded) {
        outer.target[array][ball] = values[i] + values[rest + i];
      } else {
        outer.target[array][ball] = values[i];
        inner.target[array][ball] = values[rest + i];
      }
    }
  }
}

/// Sums of the lanes of both tails, which continue those of the whole vectors.
class TailTotals {
 public:
  TailTotals(Totals* of, int rest) : of_(of), tail_count_(rest) {
    for (V Totals::*member : kMembers) {
      double lanes[3 * kLanes];
      (of[0].*member).copy_to(lanes, stdx::element_aligned);
      (of[1].*member).copy_to(lanes + kLanes, stdx::element_aligned);
      for (int i = 0; i < kLanes; ++i)
        lanes[2 * kLanes + i] = i < rest ? lanes[i] : i < 2 * rest ? lanes[kLanes + i - rest] : 0.0;
      all.*member = get(lanes + 2 * kLanes);
    }
  }
  void write_back() const {
    for (V Totals::*member : kMembers) {
      double lanes[kLanes];
      (all.*member).copy_to(lanes, stdx::element_aligned);
      for (int i = 0; i < tail_count_; ++i) {
        (of_[0].*member)[i] = lanes[i];
        (of_[1].*member)[i] = lanes[tail_count_ + i];
      }
    }
  }
  Totals all;

 private:
  static constexpr int kLanes = static_cast<int>(V::size());
  static constexpr V Totals::*kMembers[] = {
      &Totals::force_x,   &Totals::force_y,  &Totals::force_z,        &Totals::moment_x,
      &Totals::moment_y,  &Totals::moment_z, &Totals::elastic_energy, &Totals::heat,
      &Totals::load_slip, &Totals::damping};
  Totals* of_;
  int tail_count_;
};

template <class Law>
void evaluate_pair_for_law(const RaceKernelInput* in, RaceKernelSums* sums) {
  if constexpr (!tribology::kHasFilm<Law> && !std::is_same_v<Law, tribology::UserTractionLaw>) {
    const InlinedLaw<Law> law;
    Totals totals[2];
    std::size_t first = 0;
    for (int j = 0; j < 2; ++j)
      first = for_whole_vectors(in[j], [&](const Lanes& at) {
        evaluate<RoundRace>(in[j], at, IdenticalBalls(in[j], at), law, totals[j]);
      });
    const auto rest = static_cast<int>(in[0].n - first);
    if (rest > 0) {
      TailTotals tail(totals, rest);
      visit_both_tails(in, first, rest, [&](const Lanes& at) {
        evaluate<RoundRace>(in[0], at, BothRacesLanes(in, rest), law, tail.all);
      });
      tail.write_back();
    }
    for (int j = 0; j < 2; ++j) sums[j] = reduce_totals(totals[j]);
  }
}

template <class... Laws>
void evaluate_pair(const RaceKernelInput* in, RaceKernelSums* sums, tribology::TypeList<Laws...>) {
  std::size_t index = 0;
  (void)((index++ == in[0].law_index && (evaluate_pair_for_law<Laws>(in, sums), true)) || ...);
}

/// @param in outer and inner race: alike balls on races of revolution, one dry law
inline void evaluate_pair(const RaceKernelInput* in, RaceKernelSums* sums) {
  if (2 * (in[0].n % V::size()) <= V::size()) {
    evaluate_pair(in, sums, tribology::TractionLawList());
    return;
  }
  for (int j = 0; j < 2; ++j) sums[j] = evaluate_race(in[j]);
}

}  // namespace
}  // namespace adore::dynamics
