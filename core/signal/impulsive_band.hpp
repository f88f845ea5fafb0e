#pragma once

#include <cstddef>
#include <vector>

/// Frequency band of modulated or impulsive vibration, for envelopes.
namespace adore::signal {

/// Fewer samples have no band with enough lines.
inline constexpr std::size_t kMinBandSamples = 64;

struct ImpulsiveBand {
  double low = 0.0, high = 0.0;  ///< [Hz]; equal: none
  /// Spectral kurtosis mean(|c|^4) / mean(|c|^2)^2 - 2 of the complex envelope c: -1 for one tone,
  /// 0 for Gaussian noise, large for impacts (Antoni, Mech. Syst. Signal Process. 21, 2007).
  double kurtosis = 0.0;
  double change = 0.0;  ///< standard deviation of |c| over the root mean square of the samples
};

/// Bands above this kurtosis are impulsive.
inline constexpr double kImpulsive = 1.0;

/// Is `a` the better band? Impulsive bands by their kurtosis, then the others by their change.
[[nodiscard]] bool is_better_band(const ImpulsiveBand& a, const ImpulsiveBand& b);

/// The best band among halves, quarters, eighths and sixteenths of the range up to half of the
/// sampling rate. The lowest band of each division contains the slow motion and is left out, as are
/// bands with less than 1 % of the mean square of the strongest one, and bands below 1e-4 of the
/// root mean square of the samples. Narrow bands are preferred unless the change is 10 % larger.
/// The samples without trend are tapered over an eighth at both ends, and the kurtosis is that of
/// the middle three quarters, because the transform is periodic. A remainder of at most an eighth
/// of the samples is not used. No band: fewer than kMinBandSamples, no vibration there, or a
/// straight line to 1e-9 of the largest sample.
[[nodiscard]] ImpulsiveBand impulsive_band(const std::vector<double>& samples, double step);

}  // namespace adore::signal
