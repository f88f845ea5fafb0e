#include "runs/step_limits.hpp"

#include "integrators/stability.hpp"
#include "integrators/stepper.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numbers>

namespace adore::runs {
namespace {

constexpr double kPointsPerDecade = 80.0;
constexpr double kLowestPhase = 1e-4;
/// Largest factor by which a step of the deck is lengthened.
constexpr double kMaxLengthening = 8.0;
/// Of methods that choose their order, where the deck's least step is too long.
constexpr double kMinStepRatio = 0.1;
const double kMaxLogGrowth = std::log(kGrowthPerTurn);
const double kStepFactor = std::pow(10.0, 1.0 / kPointsPerDecade);

/// kCountedPeriods of a frequency [rad/s -> s].
double counted_time(double highest) {
  return highest > 0.0 ? kCountedPeriods * 2.0 * std::numbers::pi / highest
                       : std::numeric_limits<double>::infinity();
}

/// Orders that a method chooses from; 1 for a method of one order.
int orders_of(const std::string& method) {
  if (method == "cvode-adams") return 12;
  if (method == "cvode-bdf") return 5;
  return 1;
}

/// ln of the amplification per step over phases in equal ratios; of a method that changes its order
/// the largest of all orders up to a bound.
class GrowthCurve {
 public:
  GrowthCurve(const std::string& method, double highest_phase, double damping)
      : value_(static_cast<std::size_t>(orders_of(method))) {
    const bool own = value_.size() == 1;
    for (double phase = kLowestPhase;; phase *= kStepFactor) {
      phase_.push_back(phase);
      double largest = 0.0;
      for (std::size_t k = 0; k < value_.size(); ++k) {
        const int order = own ? integrators::kOwnOrder : static_cast<int>(k) + 1;
        largest = std::max(largest, integrators::amplification(method, phase, order, damping));
        value_[k].push_back(std::log(std::max(largest, 1e-300)));
      }
      if (phase > highest_phase) break;
    }
  }
  struct Peak {
    double value = -std::numeric_limits<double>::infinity(), phase = 0.0;
  };
  /// Largest between two phases, the points around them included.
  [[nodiscard]] Peak largest(int order, double from, double to) const {
    const std::vector<double>& value = value_[static_cast<std::size_t>(order) - 1];
    const auto place = [&](double phase) {
      const double k = std::log10(std::max(phase, kLowestPhase) / kLowestPhase) * kPointsPerDecade;
      return std::min(static_cast<std::size_t>(k), value.size() - 1);
    };
    Peak peak;
    for (std::size_t k = place(from); k <= std::min(place(to) + 1, value.size() - 1); ++k)
      if (value[k] > peak.value) peak = {value[k], phase_[k]};
    return peak;
  }

 private:
  std::vector<double> phase_;
  std::vector<std::vector<double>> value_;  ///< [order - 1][phase]
};

/// One for each band; those of equal damping share it.
class GrowthCurves {
 public:
  GrowthCurves(const StepRequest& request, double highest_phase) {
    for (const VibrationBand& band : request.bands) {
      auto& curve = by_damping_[band.damping];
      if (!curve)
        curve = std::make_shared<const GrowthCurve>(request.method, highest_phase, band.damping);
      by_band_.push_back(curve);
    }
  }
  [[nodiscard]] const GrowthCurve& operator[](std::size_t band) const { return *by_band_[band]; }

 private:
  std::map<double, std::shared_ptr<const GrowthCurve>> by_damping_;
  std::vector<std::shared_ptr<const GrowthCurve>> by_band_;
};

struct Growth {
  double per_turn = -std::numeric_limits<double>::infinity();  ///< ln of the factor
  double frequency = 0.0;
  std::size_t band = 0;
};

class GrowthLimit {
 public:
  GrowthLimit(const StepRequest& request, const GrowthCurves& curves, int order)
      : request_(request),
        curves_(curves),
        order_(order),
        time_(std::min(request.turn, counted_time(highest_frequency(request)))) {}

  static double highest_frequency(const StepRequest& request) {
    double highest = 0.0;
    for (const VibrationBand& band : request.bands) highest = std::max(highest, band.highest);
    return highest;
  }

  [[nodiscard]] Growth growth(double h) const {
    Growth out;
    for (std::size_t b = 0; b < request_.bands.size(); ++b) {
      const VibrationBand& band = request_.bands[b];
      const auto peak = curves_[b].largest(order_, h * band.lowest, h * band.highest);
      // Below the first phase of the curve the growth per time is at most that of its first point.
      const double per_turn = peak.value * time_ / std::max(h, kLowestPhase / band.highest);
      if (per_turn > out.per_turn)
        out = {per_turn, std::clamp(peak.phase / h, band.lowest, band.highest), b};
    }
    return out;
  }
  [[nodiscard]] bool is_stable(double h) const { return growth(h).per_turn <= kMaxLogGrowth; }
  /// Worst case within the limits. The smallest steps cannot cause growth, so the search stops
  /// when all phases are below the curve.
  [[nodiscard]] Growth worst(double minimum, double maximum) const {
    Growth out = growth(maximum);
    const double least =
        std::max({minimum, kLowestPhase / highest_frequency(request_), 1e-6 * maximum});
    for (double h = maximum / kStepFactor; h >= least; h /= kStepFactor)
      if (const Growth here = growth(h); here.per_turn > out.per_turn) out = here;
    return out;
  }
  /// Longest step up to `h` that is stable, as is every shorter one; 0: none.
  [[nodiscard]] double stable_below(double h) const {
    const double least = kLowestPhase / highest_frequency(request_);
    double longest = 0.0;
    for (double step = std::min(least, h);; step = std::min(step * kStepFactor, h)) {
      if (!is_stable(step)) return longest;
      longest = step;
      if (step >= h) return longest;
    }
  }
  /// Nearest stable step in ratios, from `h` up or down; 0: none within the limit.
  [[nodiscard]] double nearest_stable(double h, double ratio) const {
    const double most = kMaxLengthening * h;
    const double least = std::min(h, kLowestPhase / highest_frequency(request_));
    for (double step = h; step <= most && step >= least; step *= ratio)
      if (is_stable(step)) return step;
    return 0.0;
  }

 private:
  const StepRequest& request_;
  const GrowthCurves& curves_;
  int order_ = 1;
  double time_;  ///< over which growth is counted [s]
};

void set_growth(StepLimits& out, const StepRequest& request, const GrowthLimit& asked,
                const GrowthLimit& in_force) {
  const Growth before = asked.worst(request.minimum, request.maximum);
  out.growth_asked = std::exp(std::min(before.per_turn, 700.0));
  out.frequency = before.frequency;
  out.vibration = request.bands[before.band].name;
  out.growth = std::exp(std::min(in_force.worst(out.minimum, out.maximum).per_turn, 700.0));
}

/// Moves the step limits to stable steps.
void move_steps(StepLimits& out, const StepRequest& request, const GrowthLimit& limit) {
  const bool constant = request.minimum == request.maximum;
  const double down = constant ? limit.nearest_stable(request.maximum, 1.0 / kStepFactor)
                               : limit.stable_below(request.maximum);
  if (down >= request.maximum) return;
  const auto shorten = [&] {
    out.action = StepAction::Shortened;
    out.maximum = down;
    out.minimum = constant ? down : std::min(request.minimum, down);
    if (down * GrowthLimit::highest_frequency(request) < kMinPhase)
      out.action = StepAction::Refused;
  };
  if (!constant && down >= request.minimum) return shorten();
  // The deck forbids steps that short. A band of stable steps may be nearer.
  const double up = limit.nearest_stable(request.minimum, kStepFactor);
  const double ratio_down = down > 0.0 ? request.maximum / down : 1e300;
  if (up == 0.0 || up / request.minimum > ratio_down) return shorten();
  out.action = StepAction::Lengthened;
  out.minimum = out.maximum = up;
  while (!constant && out.maximum * kStepFactor <= request.maximum &&
         limit.is_stable(out.maximum * kStepFactor))
    out.maximum *= kStepFactor;
}

}  // namespace

StepLimits stable_step_limits(const StepRequest& request) {
  StepLimits out;
  out.minimum = request.minimum;
  out.maximum = request.maximum;
  if (request.bands.empty() || !(request.turn > 0.0)) return out;
  const double highest = GrowthLimit::highest_frequency(request);
  const GrowthCurves curves(request, kMaxLengthening * request.maximum * highest);
  const int orders = orders_of(request.method);
  const GrowthLimit free(request, curves, orders);
  if (orders == 1) {
    move_steps(out, request, free);
    set_growth(out, request, free, free);
    return out;
  }
  double longest = 0.0;
  for (int order = orders; order >= 1 && longest < request.maximum; --order) {
    const double step = GrowthLimit(request, curves, order).stable_below(request.maximum);
    if (step <= longest * kStepFactor) continue;
    longest = step;
    out.highest_order = order;
  }
  if (out.highest_order == orders && longest >= request.maximum) {
    out.highest_order = 0;
    set_growth(out, request, free, free);
    return out;
  }
  out.action = longest * highest < kMinPhase ? StepAction::Refused : StepAction::OrderHeld;
  out.maximum = std::max(longest, kLowestPhase / highest);
  // They cannot hold a constant step: below the deck's least step there must be room for shorter
  // ones.
  out.minimum = request.minimum < out.maximum ? request.minimum : kMinStepRatio * out.maximum;
  set_growth(out, request, free, GrowthLimit(request, curves, std::max(out.highest_order, 1)));
  return out;
}

namespace {

/// "per turn", or the number of periods over which growth is counted for a slow bearing.
std::string counted_over(const StepRequest& request) {
  return request.turn <= counted_time(GrowthLimit::highest_frequency(request))
             ? "per revolution"
             : fmt::format("in {:.0f} periods", kCountedPeriods);
}

std::string growth_text(double factor) {
  if (factor > 1e6) return "more than a millionfold";
  return fmt::format("{:.3g}-fold", factor);
}

std::string steps_text(double minimum, double maximum, double time_scale) {
  const auto one = [&](double h) {
    return fmt::format("{:.4g} s ({:.4g} time scales)", h, h / time_scale);
  };
  return minimum == maximum ? "constant steps of " + one(maximum)
                            : "steps of up to " + one(maximum);
}

}  // namespace

std::string step_limits_text(const StepRequest& request, const StepLimits& limits,
                             double time_scale) {
  if (limits.frequency == 0.0)
    return request.method + ": there is no contact vibration that could limit the step";
  const std::string asked = steps_text(request.minimum, request.maximum, time_scale);
  const std::string hertz =
      fmt::format("{:.4g} Hz ({})", limits.frequency / (2.0 * std::numbers::pi), limits.vibration);
  if (limits.action == StepAction::Kept)
    return fmt::format(
        "{} keeps contact vibrations bounded with {}: the amplitude of the least stable vibration, "
        "{}, changes by a factor of {:.4g} {}",
        request.method, asked, hertz, limits.growth, counted_over(request));
  const std::string why = fmt::format(
      "{} with {}, as the deck specifies, lets the contact vibration of {} grow {} {}",
      request.method, asked, hertz, growth_text(limits.growth_asked), counted_over(request));
  const std::string now = steps_text(limits.minimum, limits.maximum, time_scale);
  switch (limits.action) {
    case StepAction::Shortened:
      return fmt::format("{}. The run uses {}, which limit the growth to a factor of {:.4g}", why,
                         now, limits.growth);
    case StepAction::Lengthened:
      return fmt::format(
          "{}. The run uses {}{}, with which the method damps these vibrations (factor {:.4g} {})",
          why, now,
          limits.minimum < limits.maximum ? fmt::format(" and not below {:.4g} s", limits.minimum)
                                          : "",
          limits.growth, counted_over(request));
    case StepAction::OrderHeld:
      return fmt::format(
          "{}. The run uses orders up to {} and {}, which limit the growth to a "
          "factor of {:.4g}",
          why, limits.highest_order, now, limits.growth);
    default:
      return fmt::format("{}. The method would need {} (number of steps per revolution: {:.2g})",
                         why, now, request.turn / limits.maximum);
  }
}

std::vector<std::string> find_stable_methods(StepRequest request) {
  std::vector<std::string> out;
  for (const std::string_view name : integrators::stepper_names()) {
    request.method = name;
    if (name.starts_with("cvode")) continue;
    if (stable_step_limits(request).action == StepAction::Kept) out.emplace_back(name);
  }
  return out;
}

}  // namespace adore::runs
