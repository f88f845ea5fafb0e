#include "adrplot/spectrum_source.hpp"

#include "adrplot/spectrogram_page.hpp"
#include "base/counted.hpp"
#include "desktop/axis_scale.hpp"
#include "signal/envelope.hpp"
#include "signal/impulsive_band.hpp"
#include "signal/orders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace adore::adrplot {
namespace {

constexpr double kMinLines = 4.0;  ///< of a band

std::string hertz(double frequency) { return desktop::pretty_quantity(frequency, "Hz", 3); }

std::string band_text(const PassBand& band) { return hertz(band.low) + " to " + hertz(band.high); }

/// Rotation counted as positive.
std::vector<double> forward(std::vector<double> turns) {
  if (!turns.empty() && turns.back() < turns.front())
    for (double& turn : turns) turn = -turn;
  return turns;
}

}  // namespace

PartRotation rotation_of(const RunMotion& motion, OrderReference part) {
  PartRotation out;
  out.part = part == OrderReference::Cage      ? "cage"
             : part == OrderReference::Element ? "element"
                                               : "shaft";
  const auto none = [&out](std::string why) {
    out.turns.clear();
    out.why_none = std::move(why);
    return out;
  };
  if (out.part == "shaft") {
    out.turns = motion.turns;
    out.source = motion.source;
    if (motion.oscillates) return none("The shaft oscillates, so there are no orders.");
    if (out.turns.empty() || out.turns.size() != motion.times.size())
      return none(
          "The speed of the shaft is not known, so there are no orders. It is read from result "
          "files or from a table column with the unit rpm.");
  } else {
    const std::string label = out.part == "cage" ? "FTF" : "BSF";
    out.source = out.part == "cage" ? "element.orbital_position in RESULTS.h5"
                                    : "element.angular_velocity_vector in RESULTS.h5";
    for (const MarkEventCounts& mark : motion.marks)
      if (mark.label == label) out.turns = forward(event_counts_of(mark, motion.times));
    if (out.turns.empty())
      return none(
          fmt::format("The speed of the {} is not known, so there are no orders. It is read "
                      "from RESULTS.h5 of the run in the same folder.",
                      out.part));
  }
  for (std::size_t i = 1; i < out.turns.size(); ++i)
    if (!(out.turns[i] > out.turns[i - 1]))
      return none(
          fmt::format("The {} stops or reverses at {}, so there are no orders. Open steps with "
                      "rotation in one direction only.",
                      out.part, desktop::pretty_quantity(motion.times[i - 1], "s", 4)));
  return out;
}

SpectrumSource::SpectrumSource(const RunMotion& motion, const SpectrumOptions& options,
                               Domain domain)
    : motion_(motion),
      domain_(domain),
      band_(options.band),
      automatic_band_(options.band.automatic()),
      over_orders_(domain == Domain::Orders ||
                   (domain == Domain::Envelope && options.orders_of != OrderReference::Automatic)) {
  if (!over_orders_) return;
  part_rotation_ = rotation_of(motion, options.orders_of);
  std::tie(min_part_speed_, max_part_speed_) = speed_range(motion.times, part_rotation_.turns);
}

void SpectrumSource::consider_band(const std::string& curve, const std::vector<double>& values) {
  if (domain_ != Domain::Envelope || !automatic_band_) return;
  const signal::Samples samples = signal::equally_spaced_samples(motion_.times, values);
  const signal::ImpulsiveBand band = signal::impulsive_band(samples.values, samples.step);
  if (!signal::is_better_band(band, {band_.low, band_.high, kurtosis_, change_})) return;
  band_ = {band.low, band.high};
  kurtosis_ = band.kurtosis, change_ = band.change;
  band_curve_ = curve;
}

SpectrumSamples SpectrumSource::envelope_of(SpectrumSamples of) const {
  const signal::Samples& samples = of.samples;
  const auto n = static_cast<double>(samples.values.size());
  const double nyquist = 0.5 / samples.step, spacing = 1.0 / (n * samples.step);
  const auto none = [](std::string why) { return SpectrumSamples{{}, 0.0, std::move(why)}; };
  if (automatic_band_ && band_.automatic()) {
    if (samples.values.size() < signal::kMinBandSamples)
      return none(fmt::format(
          "No envelope spectrum: an automatic band needs at least {}. This curve has {}. Load more "
          "steps or enter a band.",
          counted(signal::kMinBandSamples, "stored step"), samples.values.size()));
    return none(fmt::format("No envelope spectrum: the curve has no vibration from {} to {}.",
                            hertz(nyquist / 16.0), hertz(nyquist)));
  }
  if (band_.high > nyquist * (1.0 + 1e-9))
    return none(
        fmt::format("No envelope spectrum: the band, {}, exceeds {} (half of the sampling rate). "
                    "Enter a band below this frequency.",
                    band_text(band_), hertz(nyquist)));
  if (band_.high - band_.low < kMinLines * spacing)
    return none(
        fmt::format("No envelope spectrum: the band, {}, is narrower than {} lines ({} "
                    "each). Enter a wider band or load more steps.",
                    band_text(band_), kMinLines, hertz(spacing)));
  of.samples.values =
      signal::envelope(signal::without_trend(samples.values), samples.step, band_.low, band_.high);
  of.highest = band_.high - band_.low;
  return of;
}

SpectrumSamples SpectrumSource::samples_over_angle(const std::vector<double>& turns,
                                                   const std::vector<double>& values,
                                                   double highest) const {
  // As many angles as the slowest part of the run needs, so that none of its vibration is folded.
  constexpr double kMaxOversampling = 4.0;
  const auto n = static_cast<double>(values.size());
  const double span = motion_.times.back() - motion_.times.front();
  const double mean = (part_rotation_.turns.back() - part_rotation_.turns.front()) / span;
  const double more = min_part_speed_ > 0.0
                          ? std::clamp(mean / min_part_speed_, 1.0, kMaxOversampling)
                          : kMaxOversampling;
  const signal::AngleSamples angles =
      signal::angle_samples(turns, values, static_cast<std::size_t>(std::ceil(more * n)));
  SpectrumSamples out;
  out.samples.values = angles.values;
  out.samples.start = angles.start, out.samples.step = angles.step;
  out.highest = std::min(0.5 * (n - 1.0) / span, highest) / max_part_speed_;
  if (out.samples.values.empty()) out.why_none = "The values have no order spectrum.";
  return out;
}

SpectrumSamples SpectrumSource::samples_of(const std::vector<double>& values, bool still) const {
  SpectrumSamples out{signal::equally_spaced_samples(motion_.times, values)};
  if (out.samples.values.empty()) out.why_none = sampling_note(out.samples, motion_.times.size());
  if (over_orders_ && out.why_none.empty()) out.why_none = part_rotation_.why_none;
  if (!out.why_none.empty()) {
    out.samples.values.clear();
    return out;
  }
  if (domain_ == Domain::Orders) return samples_over_angle(part_rotation_.turns, values, INFINITY);
  if (domain_ != Domain::Envelope || still) return out;
  out = envelope_of(std::move(out));
  if (!over_orders_ || out.samples.values.empty()) return out;
  std::vector<double> times;
  for (std::size_t i = 0; i < out.samples.values.size(); ++i)
    times.push_back(std::min(out.samples.start + out.samples.step * static_cast<double>(i),
                             motion_.times.back()));
  return samples_over_angle(event_counts_of({"", motion_.times, part_rotation_.turns}, times),
                            out.samples.values, out.highest);
}

std::string SpectrumSource::unit() const {
  return over_orders_ ? part_rotation_.part + " orders" : std::string("Hz");
}

std::string SpectrumSource::note() const {
  std::string out;
  if (domain_ == Domain::Envelope) {
    out = "Envelope of the band " + band_text(band_);
    if (automatic_band_)
      out += kurtosis_ > signal::kImpulsive
                 ? fmt::format(" (automatic: most impulsive, kurtosis {}{})",
                               desktop::pretty_number(kurtosis_, 2),
                               band_curve_.empty() ? "" : ", " + band_curve_)
                 : fmt::format(" (automatic: strongest modulation{})",
                               band_curve_.empty() ? "" : ", " + band_curve_);
    out += ".";
  }
  if (!over_orders_ || !part_rotation_.why_none.empty()) return out;
  const std::string low = rpm_text(min_part_speed_), high = rpm_text(max_part_speed_);
  out += fmt::format("{}Speed of the {}: {}{}.", out.empty() ? "" : " ", part_rotation_.part,
                     low == high ? low : low + " to " + high,
                     part_rotation_.source.empty() ? "" : " (" + part_rotation_.source + ")");
  if (domain_ != Domain::Orders) return out;
  const auto n = static_cast<double>(motion_.times.size());
  const double highest =
      0.5 * (n - 1.0) / (motion_.times.back() - motion_.times.front()) / max_part_speed_;
  return out + fmt::format(
                   " Resampled at equal angles: amplitudes are up to 4 % too low at order "
                   "{}, and orders end at {}.",
                   desktop::pretty_number(0.25 * highest, 3), desktop::pretty_number(highest, 3));
}

std::vector<desktop::ChartMark> SpectrumSource::marks() const {
  if (!over_orders_) return mean_marks(motion_.marks);
  std::vector<desktop::ChartMark> out;
  if (part_rotation_.turns.empty()) return out;
  const double from = motion_.times.front(), to = motion_.times.back();
  const double speed = frequency_between({"", motion_.times, part_rotation_.turns}, from, to);
  for (const MarkEventCounts& mark : motion_.marks)
    if (const double events = frequency_between(mark, from, to); events > 0.0 && speed > 0.0)
      out.push_back({events / speed, mark.label});
  return out;
}

}  // namespace adore::adrplot
