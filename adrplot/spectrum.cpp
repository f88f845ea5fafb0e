#include "adrplot/spectrum.hpp"

#include "desktop/axis_scale.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace adore::adrplot {

std::string sampling_note(const signal::Samples& samples, std::size_t stored) {
  switch (samples.fault) {
    case signal::SamplingFault::TooFew:
      return fmt::format("The frequency spectrum needs at least {} stored steps; {} {} loaded.",
                         signal::kMinSamples, stored, stored == 1 ? "is" : "are");
    case signal::SamplingFault::MissingValues:
      return "No frequency spectrum: some values are missing.";
    case signal::SamplingFault::TimesNotIncreasing:
      return "No frequency spectrum: the stored times do not increase.";
    case signal::SamplingFault::None:
      break;
  }
  if (samples.last_dropped) return "The shorter last step is not included.";
  if (!samples.resampled) return {};
  const auto seconds = [](double value) { return desktop::pretty_quantity(value, "s", 3); };
  return fmt::format(
      "Resampled every {} by linear interpolation (steps of {} to {}): amplitudes are up to 20 % "
      "too low at {} and unreliable above {}.",
      seconds(samples.step), seconds(samples.shortest), seconds(samples.longest),
      desktop::pretty_quantity(0.25 / samples.longest, "Hz", 3),
      desktop::pretty_quantity(0.5 / samples.longest, "Hz", 3));
}

std::string spectrum_title(Domain domain) {
  return domain == Domain::Envelope ? "envelope spectrum"
         : domain == Domain::Orders ? "order spectrum"
                                    : "amplitude spectrum";
}

std::string spectrum_unit(SpectrumScale scale, const std::string& unit) {
  if (scale == SpectrumScale::Relative) return "of largest";
  if (scale == SpectrumScale::Units) return unit;
  return "dB re 1" + (unit.empty() ? "" : " " + desktop::pretty_unit(unit));
}

double scaled_amplitude(double amplitude, double largest, SpectrumScale scale) {
  constexpr double kFloor = -160.0;  // [dB]
  if (scale == SpectrumScale::Units) return amplitude;
  if (scale == SpectrumScale::Relative) return largest > 0.0 ? amplitude / largest : 0.0;
  const double floor = largest > 0.0 ? signal::decibels(largest, 1.0, -1e4) + kFloor : kFloor;
  return signal::decibels(amplitude, 1.0, floor);
}

void scale_spectrum(signal::Spectrum& spectrum, SpectrumScale scale) {
  if (spectrum.amplitude.empty()) return;
  const double largest = *std::max_element(spectrum.amplitude.begin(), spectrum.amplitude.end());
  for (double& a : spectrum.amplitude) a = scaled_amplitude(a, largest, scale);
}

}  // namespace adore::adrplot
