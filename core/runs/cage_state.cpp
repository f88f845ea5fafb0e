#include "runs/cage_state.hpp"

#include "base/counted.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace adore::runs {

CageStateMonitor::CageStateMonitor(const bearing::Bearing& bearing, double unit_length)
    : has_cage_(bearing.cage.has_value()) {
  if (!has_cage_) return;
  const results::CageLengthScale scale = results::cage_length_scale(*bearing.cage, unit_length);
  scale_ = scale.length;
  of_ = scale.of;
}

void CageStateMonitor::follow(const dynamics::StateLayout& layout) {
  if (!has_cage_) return;
  for (const dynamics::StateLayout::Group& group : layout.groups()) {
    if (!group.name.starts_with("cage")) continue;
    if (group.name.ends_with(".position")) {
      ++segment_count_;
      position_index_ = group.slice.first;
    } else if (group.name.ends_with(".velocity")) {
      velocity_index_ = group.slice.first;
    } else if (group.name.ends_with(".omega")) {
      omega_index_ = group.slice.first;
    }
  }
}

void CageStateMonitor::add_step(double time, std::span<const double> y) {
  if (segment_count_ != 1 || velocity_index_ < 0 || omega_index_ < 0) return;
  if (instant_count_++ % sampling_interval_ != 0) return;
  if (instants_.size() == kMaxInstants) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < instants_.size(); i += 2, ++kept) {
      instants_[kept] = instants_[i];
      times_[kept] = times_[i];
    }
    instants_.resize(kept);
    times_.resize(kept);
    sampling_interval_ *= 2;
  }
  const auto at = [&](int first, int axis) { return y[static_cast<std::size_t>(first + axis)]; };
  times_.push_back(time);
  instants_.push_back({at(position_index_, 1) / scale_, at(position_index_, 2) / scale_,
                       at(velocity_index_, 1) / scale_, at(velocity_index_, 2) / scale_,
                       at(omega_index_, 0)});
}

std::optional<Finding> CageStateMonitor::finding() const {
  if (!has_cage_ || segment_count_ == 0) return std::nullopt;
  if (segment_count_ > 1)
    return make_finding(
               "cage.not_judged",
               "State of the cage: not determined, because the cage segments have no common center")
        .of("cage");
  std::size_t first = 0;
  if (!times_.empty()) {
    const double middle = 0.5 * (times_.front() + times_.back());
    while (first < times_.size() && times_[first] < middle) ++first;
  }
  const std::vector<results::CageInstant> late(instants_.begin() + static_cast<long>(first),
                                               instants_.end());
  double turned = 0.0;
  for (std::size_t i = first + 1; i < instants_.size(); ++i)
    turned += 0.5 * (instants_[i].omega + instants_[i - 1].omega) * (times_[i] - times_[i - 1]);
  const double turns = std::abs(turned) / (2.0 * std::numbers::pi);
  if (turns < kMinCageRevolutions)
    return make_finding("cage.not_judged",
                        fmt::format("State of the cage: not determined, because the cage makes "
                                    "only {} in the second half of the run. Increase the length of "
                                    "the run by a factor of at least {:.3g}",
                                    counted(fmt::format("{:.3g}", turns), "revolution"),
                                    turns > 0.0 ? std::ceil(kMinCageRevolutions / turns) : 2.0))
        .measure(turns)
        .of("cage");
  const results::Whirl whirl = results::classify_whirl(late);
  const double scatter = std::abs(whirl.deviation / whirl.ratio);
  const std::string orbit =
      fmt::format("The orbit of the cage center is {:.3g} times the clearance ({})", whirl.orbit,
                  results::name_of(of_));
  const std::string span = fmt::format("The evaluation covers the last {} of the cage",
                                       counted(fmt::format("{:.3g}", turns), "revolution"));
  switch (whirl.of) {
    case results::WhirlClass::Resting:
      return make_finding(
                 "cage.centered",
                 fmt::format("State of the cage: centered. {}, below the limit of {:g}. {}", orbit,
                             results::kRestingOrbit, span))
          .measure(whirl.orbit, results::kRestingOrbit)
          .of("cage");
    case results::WhirlClass::Whirling:
      return make_finding("cage.whirling",
                          fmt::format("State of the cage: whirling at {:.3g} times the cage speed. "
                                      "{}, above the limit of {:g}. The relative scatter of the "
                                      "whirl speed is {:.3g}, below the limit of {:g}. {}",
                                      whirl.ratio, orbit, results::kRestingOrbit, scatter,
                                      results::kSteadyDeviation, span))
          .measure(whirl.orbit, results::kRestingOrbit)
          .of("cage");
    case results::WhirlClass::Irregular:
      break;
  }
  return make_finding(
             "cage.unstable",
             fmt::format("State of the cage: unstable. {}, above the limit of {:g}. The relative "
                         "scatter of the whirl speed is {:.3g}, above the limit of {:g}. {}",
                         orbit, results::kRestingOrbit, scatter, results::kSteadyDeviation, span))
      .measure(scatter, results::kSteadyDeviation)
      .of("cage");
}

}  // namespace adore::runs
