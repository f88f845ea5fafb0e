#pragma once

#include "signal/sampling.hpp"
#include "signal/spectrum.hpp"

#include <array>
#include <string>
#include <string_view>

/// Units and notes of the spectra of stored curves.
namespace adore::adrplot {

using signal::Window;

/// Units: amplitude in the unit of the curve. Decibel: 20 log10 of the amplitude over 1 of that
/// unit. Relative: over the largest amplitude of the curve. Automatic: units for spectra, decibels
/// for spectrograms, whose colors span several orders of magnitude.
enum class SpectrumScale : unsigned char { Units, Decibel, Relative, Automatic };

/// In the order of the menu.
inline constexpr std::array kScales{SpectrumScale::Automatic, SpectrumScale::Units,
                                    SpectrumScale::Decibel, SpectrumScale::Relative};

/// Content of a history page.
enum class Domain : unsigned char { History, Spectrum, Spectrogram, Envelope, Orders };
inline constexpr std::array kDomainNames{"history", "spectrum", "spectrogram", "envelope",
                                         "orders"};

/// Part whose revolutions are counted: orders are events per revolution. Cage: orbit of the
/// elements. Element: its spin relative to the orbit. Automatic: shaft for order spectra, none
/// (frequency in Hz) for envelope spectra.
enum class OrderReference : unsigned char { Automatic, Shaft, Cage, Element };
inline constexpr std::array kOrderReferenceNames{"automatic", "shaft", "cage", "element"};

/// Frequencies that an envelope passes [Hz].
struct PassBand {
  double low = 0.0, high = 0.0;  ///< 0, 0: selected by signal::impulsive_band()
  [[nodiscard]] bool automatic() const { return !(high > 0.0); }
};

struct SpectrumOptions {
  Window window = Window::Hann;
  SpectrumScale scale = SpectrumScale::Automatic;
  bool over_speed = false;  ///< spectrograms: shaft speed instead of time
  OrderReference orders_of = OrderReference::Automatic;
  PassBand band = {};  ///< envelopes
};

/// "Vibration: envelope spectrum": the second part.
[[nodiscard]] std::string spectrum_title(Domain domain);

/// The scale that is drawn. @param automatic for SpectrumScale::Automatic
[[nodiscard]] inline SpectrumScale resolved_scale(SpectrumScale scale, SpectrumScale automatic) {
  return scale == SpectrumScale::Automatic ? automatic : scale;
}

/// Processing of the samples, or the reason why there are none.
[[nodiscard]] std::string sampling_note(const signal::Samples& samples, std::size_t stored);

/// Unit label of spectrum amplitudes: "N", "dB re 1 N", "of largest".
/// @param scale from resolved_scale()   @param unit of the curve
[[nodiscard]] std::string spectrum_unit(SpectrumScale scale, const std::string& unit);

/// Are values of this unit levels in decibels, which have no logarithmic axis?
[[nodiscard]] inline bool is_decibel(std::string_view unit) { return unit.starts_with("dB"); }

/// Converts an amplitude to a scale from resolved_scale(); `largest` of the curve or spectrogram.
/// Levels end 160 dB below the largest: rounding of sixteen digits.
[[nodiscard]] double scaled_amplitude(double amplitude, double largest, SpectrumScale scale);
void scale_spectrum(signal::Spectrum& spectrum, SpectrumScale scale);

}  // namespace adore::adrplot
