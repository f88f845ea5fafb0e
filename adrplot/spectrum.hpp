#pragma once

#include "signal/sampling.hpp"
#include "signal/spectrum.hpp"

#include <string>
#include <string_view>

/// Units and notes of the spectra of stored curves.
namespace adore::adrplot {

using signal::Window;

/// Units: amplitude in the unit of the curve. Decibel: 20 log10 of the amplitude over 1 of that
/// unit. Relative: over the largest amplitude of the curve.
enum class SpectrumScale : unsigned char { Units, Decibel, Relative };

struct SpectrumOptions {
  Window window = Window::Hann;
  SpectrumScale scale = SpectrumScale::Units;
  bool over_speed = false;  ///< spectrograms: shaft speed instead of time
};

/// Processing of the samples, or the reason why there are none.
[[nodiscard]] std::string sampling_note(const signal::Samples& samples, std::size_t stored);

/// Unit of the amplitudes of a curve: "N", "dB re 1 N", "of largest".
[[nodiscard]] std::string spectrum_unit(SpectrumScale scale, const std::string& unit);

/// Are values of this unit levels in decibels, which have no logarithmic axis?
[[nodiscard]] inline bool is_decibel(std::string_view unit) { return unit.starts_with("dB"); }

/// An amplitude on a scale; `largest` of the curve or spectrogram. Levels end 160 dB below the
/// largest: rounding of sixteen digits.
[[nodiscard]] double scaled_amplitude(double amplitude, double largest, SpectrumScale scale);
void scale_spectrum(signal::Spectrum& spectrum, SpectrumScale scale);

}  // namespace adore::adrplot
