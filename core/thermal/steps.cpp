#include "thermal/steps.hpp"

#include <algorithm>
#include <cmath>

namespace adore::thermal {
namespace {

double largest_change(const std::vector<double>& from, const std::vector<double>& to) {
  double out = 0.0;
  for (std::size_t i = 0; i < std::min(from.size(), to.size()); ++i)
    out = std::max(out, std::abs(to[i] - from[i]));
  return out;
}

std::optional<double> gain(const std::vector<double>& changes) {
  std::vector<double> ratios;
  for (std::size_t i = 1; i < changes.size(); ++i)
    if (changes[i - 1] != 0.0) ratios.push_back(changes[i] / changes[i - 1]);
  constexpr std::size_t kLast = 4;
  if (ratios.size() > kLast)
    ratios.erase(ratios.begin(), ratios.end() - static_cast<std::ptrdiff_t>(kLast));
  if (ratios.empty()) return std::nullopt;
  std::sort(ratios.begin(), ratios.end());
  const std::size_t half = ratios.size() / 2;
  return ratios.size() % 2 == 1 ? ratios[half] : 0.5 * (ratios[half - 1] + ratios[half]);
}

}  // namespace

std::optional<HeatWindow::ClosedWindow> HeatWindow::add(double time, double step, double power) {
  energy_ += power * step;
  window_time_ += step;
  constexpr double kRounding = 1e-9;
  if (!(window_time_ >= average_time_ * (1.0 - kRounding))) return std::nullopt;
  ++steps_;
  const ClosedWindow out{
      steps_, time, energy_ / window_time_,
      geometry_interval_ > 0 && steps_ % geometry_interval_ == 0 && time >= skip_time_};
  energy_ = window_time_ = 0.0;
  return out;
}

ThermalStepAssessment assess_thermal_steps(const std::vector<std::vector<double>>& temperatures,
                                           const ThermalStepCriteria& rules) {
  ThermalStepAssessment out;
  out.reason = "end";
  std::vector<double> changes;
  int calm = 0, growing = 0;
  for (std::size_t n = 1; n < temperatures.size(); ++n) {
    const std::vector<double>& now = temperatures[n];
    const double change = largest_change(temperatures[n - 1], now);
    growing =
        !changes.empty() && change > changes.back() && change >= rules.tolerance ? growing + 1 : 0;
    calm = change < rules.tolerance ? calm + 1 : 0;
    changes.push_back(change);
    out.step = static_cast<int>(n);
    const bool hot = rules.limit && std::any_of(now.begin(), now.end(),
                                                [&](double T) { return T > *rules.limit; });
    if (hot || calm >= rules.converged || growing >= rules.divergent) {
      out.verdict = hot || calm < rules.converged ? StepVerdict::Divergent : StepVerdict::Stable;
      out.reason = hot ? "limit" : calm >= rules.converged ? "converged" : "growth";
      break;
    }
  }
  out.gain = gain(changes);
  const auto last = static_cast<std::size_t>(out.step);
  if (last >= 2 && !temperatures[last].empty()) {
    const double x0 = temperatures[last - 2][0], x1 = temperatures[last - 1][0],
                 x2 = temperatures[last][0], bend = x2 - 2.0 * x1 + x0;
    out.first_node_limit = bend != 0.0 ? x2 - (x2 - x1) * (x2 - x1) / bend : x2;
  }
  return out;
}

}  // namespace adore::thermal
