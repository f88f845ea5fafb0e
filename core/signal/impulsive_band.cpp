#include "signal/impulsive_band.hpp"

#include "signal/sampling.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>

namespace adore::signal {
namespace {

constexpr std::size_t kDivisions = 4, kMinLines = 16;
constexpr double kEnd = 0.125;  // of the samples

/// Falls to 0 at both ends (Tukey).
void taper(std::vector<double>& samples) {
  const auto n = static_cast<double>(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double end = std::min(static_cast<double>(i), n - 1.0 - static_cast<double>(i));
    if (end < kEnd * n) samples[i] *= 0.5 * (1.0 - std::cos(std::numbers::pi * end / (kEnd * n)));
  }
}

struct Moments {
  double first = 0.0, second = 0.0, fourth = 0.0;  ///< of |c|
};

/// Of the lines [from, from + count), over the middle of the samples. Twice as many values as lines
/// give the exact mean of |c|^4.
Moments moments_of(const std::vector<std::complex<double>>& transform, std::size_t from,
                   std::size_t count, std::size_t samples) {
  const std::size_t size = 2 * std::bit_ceil(count);
  std::vector<std::complex<double>> lines(size), envelope;
  for (std::size_t k = 0; k < count; ++k) lines[k] = transform[from + k];
  Eigen::FFT<double> fft;
  fft.inv(envelope, lines);
  const double scale = 2.0 * static_cast<double>(size) / static_cast<double>(samples);
  const auto first = static_cast<std::size_t>(kEnd * static_cast<double>(size));
  const auto used = static_cast<double>(size - 2 * first);
  Moments out;
  for (std::size_t i = first; i < size - first; ++i) {
    const double square = scale * scale * std::norm(envelope[i]);
    out.first += std::sqrt(square) / used;
    out.second += square / used;
    out.fourth += square * square / used;
  }
  return out;
}

}  // namespace

bool is_better_band(const ImpulsiveBand& a, const ImpulsiveBand& b) {
  if (!(a.high > a.low) || !(b.high > b.low)) return a.high > a.low;
  if (std::max(a.kurtosis, b.kurtosis) > kImpulsive) return a.kurtosis > b.kurtosis;
  const double wider = a.high - a.low > 1.01 * (b.high - b.low) ? 1.1 : 1.0;
  return a.change > wider * b.change;
}

ImpulsiveBand impulsive_band(const std::vector<double>& samples, double step) {
  constexpr double kMinEnergy = 1e-2, kMinAmplitude = 1e-4, kRounding = 1e-9;
  if (samples.size() < kMinBandSamples || !(step > 0.0)) return {};
  // A length with small prime factors.
  const std::size_t part = std::bit_floor(samples.size()) / 8;
  std::vector<double> used(
      samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(samples.size() / part * part));
  used = without_trend(used);
  double square = 0.0;
  for (const double s : used) square += s * s / static_cast<double>(used.size());
  // The remainder of a straight line is rounding.
  const double largest =
      std::abs(*std::max_element(samples.begin(), samples.end(),
                                 [](double a, double b) { return std::abs(a) < std::abs(b); }));
  if (!(std::sqrt(square) > kRounding * largest)) return {};
  taper(used);
  Eigen::FFT<double> fft;
  std::vector<std::complex<double>> transform;
  fft.fwd(transform, used);
  const std::size_t lines = used.size() / 2;
  const double spacing = 1.0 / (static_cast<double>(used.size()) * step);
  std::vector<std::pair<ImpulsiveBand, double>> bands;  // from narrow to wide, with mean square
  double strongest = 0.0;
  for (std::size_t division = kDivisions; division >= 1; --division) {
    const std::size_t parts = std::size_t{1} << division, count = lines / parts;
    if (count < kMinLines) continue;
    for (std::size_t i = 1; i < parts; ++i) {
      const Moments m = moments_of(transform, i * count, count, used.size());
      if (!(m.second > kMinAmplitude * kMinAmplitude * square)) continue;
      const auto from = static_cast<double>(i * count), width = static_cast<double>(count);
      bands.push_back(
          {{from * spacing, (from + width) * spacing, m.fourth / (m.second * m.second) - 2.0,
            std::sqrt(std::max(0.0, m.second - m.first * m.first) / square)},
           m.second});
      strongest = std::max(strongest, m.second);
    }
  }
  ImpulsiveBand best;
  for (const auto& [band, energy] : bands)
    if (energy >= kMinEnergy * strongest && is_better_band(band, best)) best = band;
  return best;
}

}  // namespace adore::signal
