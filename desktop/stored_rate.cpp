#include "desktop/stored_rate.hpp"

#include "desktop/axis_scale.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace adore::desktop {

double median_interval(const std::vector<double>& times) {
  if (times.size() < 2) return 0.0;
  std::vector<double> steps;
  for (std::size_t i = 1; i < times.size(); ++i) steps.push_back(times[i] - times[i - 1]);
  std::nth_element(steps.begin(), steps.begin() + std::ssize(steps) / 2, steps.end());
  return steps[steps.size() / 2];
}

double values_per_period(const std::vector<double>& times, double frequency) {
  const double interval = median_interval(times);
  return frequency > 0.0 && interval > 0.0 ? 1.0 / (interval * frequency) : 0.0;
}

std::string coarse_storage_note(const std::vector<double>& times, double frequency, long every,
                                bool beside_bands) {
  const double values = values_per_period(times, frequency);
  if (!(values > 0.0) || values >= kTrueShape) return {};
  return fmt::format(
      "Coarse: the fastest contact vibration, {}, has {:.2g} {} steps per period. Shape and peaks "
      "are not reliable{}.",
      pretty_quantity(frequency, "Hz", 3), values, every > 1 ? "drawn" : "stored",
      beside_bands ? " in lines without min–max band" : "");
}

}  // namespace adore::desktop
