#pragma once

#include <string>
#include <vector>

/// Amplitude spectra of stored curves.
namespace adore::adrplot {

enum class Window : unsigned char { None, Hann, FlatTop };
enum class SpectrumScale : unsigned char { Relative, Units, Decibel };

/// "Hann window", "flat top window", "no window"
[[nodiscard]] std::string window_name(Window window);

struct SpectrumOptions {
  Window window = Window::Hann;
  SpectrumScale scale = SpectrumScale::Relative;
};

/// Samples at equal intervals of time.
struct Samples {
  std::vector<double> values;
  double start = 0.0, step = 0.0;  ///< [s]
  bool resampled = false;          ///< between stored steps of unequal length, by straight lines
  std::string note;                ///< processing applied or, without values, the reason
};

/// Stored values at equal intervals. Increments are equal if they agree to 0.1 % of their mean plus
/// the rounding of seven digits of the times; a shorter last one (the end of a run is seldom a
/// multiple of the step) is dropped. Otherwise the values are interpolated linearly at the same
/// number of points, with a note: frequencies above half the inverse of the longest increment are
/// lost. No values if there are fewer than 16, if one is missing, or if the times do not increase.
[[nodiscard]] Samples equal_samples(const std::vector<double>& times,
                                    const std::vector<double>& values);

/// Amplitudes of the sines in equally spaced samples: mean removed, window w, discrete Fourier
/// transform X; amplitude 2 |X| / Σ w, in the samples' unit (the last of an even number |X| / Σ w).
/// Exact for a sine at one of the frequencies; between two of them the window decides: none up to
/// 36 % low, Hann 15 %, flat top 0.1 %. Frequencies k/(n dt), k = 1 .. n/2.
/// Flat top: five-term cosine sum of ISO 18431-2 (a0 = 1, 1.93, 1.29, 0.388, 0.0322). [seen in
/// textbooks of vibration analysis]
struct Spectrum {
  std::vector<double> frequency;  ///< [Hz]
  std::vector<double> amplitude;
};
[[nodiscard]] Spectrum amplitude_spectrum(const std::vector<double>& samples, double step,
                                          Window window = Window::None);

/// The same relative to its largest amplitude (all zero for a constant signal), or in dB.
void scale_spectrum(Spectrum& spectrum, SpectrumScale scale);

/// Less the straight line of least squares: mean and trend.
[[nodiscard]] std::vector<double> without_trend(const std::vector<double>& samples);

/// Spectra of pieces of the samples that follow each other and overlap by half: how the frequencies
/// change over a run. Each piece is taken without its mean and trend, as is usual for averaged
/// spectra of pieces (Welch 1967; Bendat and Piersol, Random Data, "trend removal"): motion slower
/// than a piece is nearly straight in it and would fill the first lines of all of them. A sine with
/// one period in a piece loses with it, by its phase, up to 46 % under a Hann window; one with two
/// periods gains up to 5 %.
struct Waterfall {
  std::vector<double> frequency;               ///< [Hz]
  std::vector<double> time;                    ///< middle of each piece [s]
  std::vector<std::vector<double>> amplitude;  ///< [piece][frequency]
};
[[nodiscard]] Waterfall waterfall(const Samples& samples, Window window, std::size_t pieces = 24);

}  // namespace adore::adrplot
