#pragma once

#include "signal/sampling.hpp"
#include "signal/window.hpp"

#include <cstddef>
#include <vector>

/// Short-time Fourier transform: spectra over a run.
namespace adore::signal {

/// Amplitude spectra (spectrum.hpp) of pieces of equal length, each without its mean and trend, as
/// is usual for spectra of pieces (Welch 1967; Bendat and Piersol, Random Data, "trend removal"):
/// motion slower than a piece is nearly straight in it and would fill the first lines of all of
/// them. A sine with one period in a piece loses with it, by its phase, up to 46 % under a Hann
/// window; one with two periods gains up to 5 %.
struct Spectrogram {
  std::vector<double> frequency;               ///< [Hz]
  std::vector<double> time;                    ///< middle of each piece [s]
  std::vector<std::vector<double>> amplitude;  ///< [piece][frequency]
  double length = 0.0;                         ///< of a piece [s]
};

/// Pieces of `length` samples, each `hop` samples after the one before.
struct Pieces {
  std::size_t length = 0, hop = 0;
};
/// A piece is a tenth of the samples, or longer if that is less than kMinSamples; pieces overlap by
/// seven eighths, less if there would be more than 300 pieces or 4 million values.
[[nodiscard]] Pieces default_pieces(std::size_t samples);

/// Empty for samples shorter than a piece.
[[nodiscard]] Spectrogram spectrogram(const Samples& samples, Window window, Pieces pieces);

}  // namespace adore::signal
