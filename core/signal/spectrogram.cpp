#include "signal/spectrogram.hpp"

#include "signal/spectrum.hpp"

#include <algorithm>
#include <cmath>

namespace adore::signal {
namespace {

/// The largest number up to n without prime factors above 5: its transform is fast.
std::size_t smooth_length(std::size_t n) {
  for (; n > 1; --n) {
    std::size_t rest = n;
    for (const std::size_t factor : {2U, 3U, 5U})
      while (rest % factor == 0) rest /= factor;
    if (rest == 1) return n;
  }
  return 1;
}

}  // namespace

Pieces default_pieces(std::size_t samples) {
  constexpr std::size_t kMaxPieces = 300, kMaxValues = 4'000'000;
  Pieces out;
  out.length = std::max(kMinSamples, smooth_length(samples / 10));
  const std::size_t most = std::clamp<std::size_t>(
      kMaxValues / std::max<std::size_t>(1, out.length / 2), 20, kMaxPieces);
  const std::size_t beyond = samples > out.length ? samples - out.length : 0;
  out.hop = std::max({std::size_t{1}, out.length / 8, (beyond + most - 1) / most});
  return out;
}

Spectrogram spectrogram(const Samples& samples, Window window, Pieces pieces) {
  Spectrogram out;
  const std::size_t n = samples.values.size();
  if (pieces.length < 4 || pieces.hop == 0 || n < pieces.length) return out;
  out.length = samples.step * static_cast<double>(pieces.length);
  for (std::size_t first = 0; first + pieces.length <= n; first += pieces.hop) {
    const auto begin = samples.values.begin() + static_cast<std::ptrdiff_t>(first);
    const std::vector<double> values(begin, begin + static_cast<std::ptrdiff_t>(pieces.length));
    Spectrum piece = amplitude_spectrum(without_trend(values), samples.step, window);
    double size = 0.0;
    for (const double v : values) size = std::max(size, std::abs(v));
    // After a linear trend only rounding remains.
    if (*std::max_element(piece.amplitude.begin(), piece.amplitude.end()) <= 2e-13 * size)
      std::fill(piece.amplitude.begin(), piece.amplitude.end(), 0.0);
    out.frequency = std::move(piece.frequency);
    out.amplitude.push_back(std::move(piece.amplitude));
    out.time.push_back(
        samples.start +
        samples.step * (static_cast<double>(first) + 0.5 * static_cast<double>(pieces.length - 1)));
  }
  return out;
}

}  // namespace adore::signal
