#include "studies/accuracy_judgement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace adore::studies {
namespace {

/// Errors over the limits above which a row of the short first round is tried last.
constexpr double kUnlikelyFactor = 5.0;

}  // namespace

results::AccuracyErrors significant_errors(const results::AccuracyErrors& errors,
                                           const results::AccuracyErrors& noise) {
  const auto of = [](double error, double known) {
    return error > kBeyondNoise * std::max(known, 0.0) ? error : std::min(error, 0.0);
  };
  results::AccuracyErrors out;
  for (const results::AccuracyQuantity& q : results::kAccuracyQuantities)
    out.*q.member = of(errors.*q.member, noise.*q.member);
  return out;
}

double error_to_limit_ratio(const results::AccuracyErrors& errors,
                            const results::AccuracyErrors& noise, double target) {
  const results::AccuracyErrors out = significant_errors(errors, noise);
  double worst = 0.0;
  for (const results::AccuracyQuantity& q : results::kAccuracyQuantities)
    worst = std::max(worst, out.*q.member / std::max(target, kBeyondNoise * noise.*q.member));
  return worst;
}

results::AccuracyErrors estimate_noise(const std::vector<NearbyRuns>& methods) {
  constexpr std::array<double, 2> kStudent{4.303, 2.776};  // two-sided 95 %; 2 and 4 degrees
  if (methods.empty()) return results::AccuracyErrors::none();
  const double factor = kStudent.at(std::min(methods.size(), kStudent.size()) - 1) / kBeyondNoise;
  const auto of = [&](double results::AccuracyErrors::*quantity) {
    double sum = 0.0;
    int pairs = 0;
    for (const NearbyRuns& runs : methods)
      for (std::size_t i = 0; i < runs.size(); ++i)
        for (std::size_t j = 0; j < i; ++j, ++pairs) {
          const double d = results::compare_results(runs[i], runs[j]).*quantity;
          if (d < 0.0) return -1.0;
          sum += d * d;
        }
    return pairs > 0 ? factor * std::sqrt(sum / pairs) : -1.0;
  };
  results::AccuracyErrors out;
  for (const results::AccuracyQuantity& q : results::kAccuracyQuantities)
    out.*q.member = of(q.member);
  return out;
}

void judge_rows(std::vector<AccuracyRow>& rows, const results::AccuracyErrors& noise,
                double target) {
  const auto over = [&](const AccuracyRow& row) {
    return error_to_limit_ratio(row.errors, noise, target);
  };
  for (AccuracyRow& row : rows) {
    row.front =
        row.failure.empty() &&
        std::none_of(rows.begin(), rows.end(), [&](const AccuracyRow& other) {
          return other.failure.empty() && other.seconds < row.seconds && over(other) <= over(row);
        });
    row.order = 0.0;
  }
  for (AccuracyRow& row : rows)
    for (const AccuracyRow& other : rows) {
      if (!row.failure.empty() || !other.failure.empty()) continue;
      const bool next = other.setting.method == row.setting.method &&
                        other.setting.as_long_as_stable == row.setting.as_long_as_stable &&
                        std::abs(other.setting.tolerance / row.setting.tolerance - 10.0) < 1.0;
      if (!next || row.at_longest > kAtLongest || other.at_longest > kAtLongest) continue;
      const double steps = std::log(static_cast<double>(row.steps) /
                                    std::max(1.0, static_cast<double>(other.steps)));
      const double errors = std::log(significant_errors(other.errors, noise).largest() /
                                     significant_errors(row.errors, noise).largest());
      if (steps > 0.05 && std::isfinite(errors)) row.order = errors / steps;
    }
}

std::vector<std::size_t> candidates(const std::vector<AccuracyRow>& rows,
                                    const results::AccuracyErrors& noise, double target,
                                    std::size_t most) {
  std::vector<std::size_t> out;
  for (std::size_t k = 0; k < rows.size(); ++k)
    if (rows[k].failure.empty() && !rows[k].setting.own) out.push_back(k);
  const auto rank = [&](std::size_t k) {
    const double over = error_to_limit_ratio(rows[k].errors, noise, target);
    return std::pair(over > kUnlikelyFactor         ? 2
                     : rows[k].front || over <= 1.0 ? 0
                                                    : 1,
                     rows[k].seconds);
  };
  std::stable_sort(out.begin(), out.end(),
                   [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
  out.resize(std::min(out.size(), most));
  return out;
}

}  // namespace adore::studies
