#include "results/accuracy_errors.hpp"

#include "results/mean_load.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace adore::results {
namespace {

double difference(double a, double b, double scale) {
  if (std::isnan(a) || std::isnan(b)) return -1.0;
  const double d = std::abs(a - b);
  return d == 0.0 ? 0.0 : scale > 0.0 ? d / scale : -1.0;
}

}  // namespace

double AccuracyErrors::largest() const {
  double out = 0.0;
  for (const AccuracyQuantity& q : kAccuracyQuantities) out = std::max(out, this->*q.member);
  return out;
}

AccuracyErrors larger(const AccuracyErrors& a, const AccuracyErrors& b) {
  AccuracyErrors out;
  for (const AccuracyQuantity& q : kAccuracyQuantities)
    out.*q.member = std::max(a.*q.member, b.*q.member);
  return out;
}

AccuracyErrors compare_results(const KeyResults& run, const KeyResults& reference) {
  const auto of = [&](std::string_view id) { return value_of(run, id); };
  const auto is = [&](std::string_view id) { return value_of(reference, id); };
  const auto relative = [&](std::string_view id) {
    return difference(of(id), is(id), std::abs(is(id)));
  };
  AccuracyErrors out;
  constexpr const char* kWhirl = "mean_swept_whirl_ratio";  // by windings it jumps
  const double cage = std::abs(is("mean_cage_ratio"));
  out.speed = std::max(relative("mean_orbital_ratio"), relative("mean_cage_ratio"));
  out.whirl = difference(of(kWhirl), is(kWhirl), std::max(cage, std::abs(is(kWhirl))));
  out.peak = relative("peak_load_N");
  double race = 0.0, change = 0.0;
  for (const char* id : {"mean_load_x_N", "mean_load_y_N", "mean_load_z_N"}) {
    race += is(id) * is(id);
    change += (of(id) - is(id)) * (of(id) - is(id));
  }
  // Preloaded contacts without an external load: their own load is what a departure is measured by.
  const double load = std::max(std::sqrt(race), kLoadFloor * std::abs(is("mean_largest_load_N")));
  out.load = std::max(relative("mean_largest_load_N"), difference(std::sqrt(change), 0.0, load));
  const double heat = std::abs(is("mean_power_loss_W"));
  out.heat = -1.0;
  for (const char* id :
       {"mean_heat_outer_race_W", "mean_heat_inner_race_W", "mean_heat_elsewhere_W"})
    out.heat = std::max(out.heat, difference(of(id), is(id), heat));
  const double life = is("run_life_hours");
  out.life = std::isfinite(life) && std::isfinite(of("run_life_hours")) ? relative("run_life_hours")
                                                                        : -1.0;
  return out;
}

}  // namespace adore::results
