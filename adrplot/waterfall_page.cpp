#include "adrplot/waterfall_page.hpp"

#include "adrplot/sentence_words.hpp"
#include "adrplot/spectrum_page.hpp"
#include "base/counted.hpp"
#include "desktop/axis_scale.hpp"
#include "desktop/even_digits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace adore::adrplot {
namespace {

/// Each curve stands this part of the largest amplitude above the one before.
constexpr double kDistance = 0.2;

/// In dB this is all that is drawn of a line.
constexpr double kDecibels = 60.0;

/// Where the first view ends: a little beyond the last amplitude above a quarter of that distance,
/// ten lines of the spectra at least.
constexpr double kVisible = 0.25 * kDistance;
double end_of_view(const Waterfall& fall, const std::vector<double>& ends) {
  double last = fall.frequency[std::min<std::size_t>(10, fall.frequency.size() - 1)];
  for (const double end : ends) last = std::max(last, end);
  return std::min(fall.frequency.back(), 1.15 * last);
}

/// What is drawn of an amplitude, on the lowest line.
double height_of(double amplitude, double largest, SpectrumScale scale) {
  if (scale == SpectrumScale::Units) return amplitude;
  const double part = largest > 0.0 ? amplitude / largest : 0.0;
  if (scale == SpectrumScale::Relative) return part;
  return part > 0.0 ? std::max(-kDecibels, 20.0 * std::log10(part)) : -kDecibels;
}

constexpr double kSteady = 0.01;

/// Turns per second around the middle of a piece, over a 24th of the run: files hold seven digits
/// of a turn, single steps too few. 0: not known.
double speed_at(const std::vector<double>& times, const std::vector<double>& turns, double time) {
  if (turns.size() != times.size() || turns.size() < 2) return 0.0;
  const auto after = std::upper_bound(times.begin() + 1, times.end() - 1, time);
  const auto at = static_cast<std::size_t>(after - times.begin());
  const std::size_t half = std::max<std::size_t>(1, times.size() / 48);
  const std::size_t from = at > half ? at - half : 0, to = std::min(at + half, times.size() - 1);
  const double span = times[to] - times[from];
  return span > 0.0 ? (turns[to] - turns[from]) / span : 0.0;
}

}  // namespace

std::pair<double, double> speed_range(const std::vector<double>& times,
                                      const std::vector<double>& turns) {
  if (turns.size() != times.size() || turns.size() < 2) return {};
  // By parts of the run: single steps hold few digits.
  constexpr std::size_t kParts = 20;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (std::size_t part = 0; part < kParts; ++part) {
    const std::size_t from = part * (times.size() - 1) / kParts,
                      to = (part + 1) * (times.size() - 1) / kParts;
    if (to == from || !(times[to] > times[from])) continue;
    const double speed = (turns[to] - turns[from]) / (times[to] - times[from]);
    low = std::min(low, speed);
    high = std::max(high, speed);
  }
  return high >= low ? std::pair(low, high) : std::pair(0.0, 0.0);
}

bool keeps_speed(const std::vector<double>& times, const std::vector<double>& turns) {
  if (turns.size() != times.size() || turns.size() < 2) return false;
  const double span = times.back() - times.front();
  const double mean = span > 0.0 ? (turns.back() - turns.front()) / span : 0.0;
  if (!(mean > 0.0)) return false;
  const auto [low, high] = speed_range(times, turns);
  return high - mean <= kSteady * mean && mean - low <= kSteady * mean;
}

std::string rpm_text(double speed) {
  const double rpm = 60.0 * speed;
  const double size = std::abs(rpm);
  const int decimals = size >= 1000.0 ? 0 : size >= 100.0 ? 1 : size >= 10.0 ? 2 : 3;
  return fmt::format("{:.{}f} rpm", rpm, decimals);
}

void to_waterfall(desktop::ChartPage& page, const std::vector<double>& times,
                  const std::vector<double>& turns, const SpectrumOptions& options) {
  const desktop::ChartPanel* found = nullptr;
  for (const auto& panel : page.panels)
    if (found == nullptr && !panel.curves.empty() &&
        std::any_of(panel.curves.front().y.begin(), panel.curves.front().y.end(),
                    [](double v) { return std::isfinite(v); }))
      found = &panel;
  if (found == nullptr) {
    page.panels.clear();
    page.note = "No curve of this page has values.";
    return;
  }
  const desktop::ChartPanel source = *found;
  const Bridged bridged = bridge_gaps(times, source.curves.front().y, options.window);
  if (!bridged.why_none.empty()) {
    page.panels.clear();
    add_note(page, capital(bridged.why_none));
    return;
  }
  add_note(page, bridged.told);
  const Samples samples = equal_samples(times, bridged.values);
  page.panels.clear();
  if (!samples.values.empty() && only_rounding(bridged.values, source.unit, source.least_span)) {
    page.note += (page.note.empty() ? "" : " ") + source.title +
                 ": nothing vibrates here; what changes, if anything, is the rounding of the "
                 "numbers.";
    return;
  }
  page.note += (page.note.empty() || samples.note.empty() ? "" : " ") + samples.note;
  const Waterfall fall = waterfall(samples, options.window);
  if (fall.time.empty()) return;
  double largest = 0.0;
  for (const auto& piece : fall.amplitude)
    largest = std::max(largest, *std::max_element(piece.begin(), piece.end()));
  const SpectrumScale scale = options.scale;
  const bool decibel = scale == SpectrumScale::Decibel;
  const std::string unit = scale == SpectrumScale::Units ? source.unit
                           : decibel                     ? "dB"
                                                         : "of largest";
  const double distance = kDistance * (scale == SpectrumScale::Units ? largest
                                       : decibel                     ? kDecibels
                                                                     : 1.0);
  std::vector<double> ends;
  for (const auto& piece : fall.amplitude)
    ends.push_back(last_above(fall.frequency, piece, kVisible * largest));
  desktop::ChartPanel panel{"Spectra, earliest at the bottom", unit, {}, false};
  // Races that do not turn against each other have no speed to tell.
  const bool steady = turns.empty() || !(turns.back() > turns.front()) || keeps_speed(times, turns);
  for (std::size_t i = 0; i < fall.time.size(); ++i) {
    desktop::ChartCurve curve{desktop::even_quantity(fall.time[i], "s", 3), {}, {}};
    if (!steady) curve.name += ", " + rpm_text(speed_at(times, turns, fall.time[i]));
    curve.lift = distance * static_cast<double>(i);
    curve.foot = decibel ? -kDecibels : 0.0;
    for (const double a : fall.amplitude[i])
      curve.y.push_back(height_of(a, largest, scale) + curve.lift);
    panel.curves.push_back(std::move(curve));
  }
  panel.one_colour = true;
  panel.scale_bar = true;
  page.x = fall.frequency;
  page.title = without_colon(page.title) + ": waterfall";
  page.view_low = 0.0;
  page.view_high = decibel ? fall.frequency.back() : end_of_view(fall, ends);
  page.x_title = "Frequency";
  page.x_unit = "Hz";
  page.note += fmt::format(
      "{}Drawn: {} ({}) of {}{}{}, from {} to {}; each stands {} above the one before "
      "and has a point every {}.",
      page.note.empty() ? "" : " ", counted(fall.time.size(), "spectrum", "spectra"),
      window_name(options.window), small(source.title),
      source.curves.front().name.empty() ? "" : ", ", source.curves.front().name,
      desktop::pretty_quantity(fall.time.front(), "s", 3),
      desktop::pretty_quantity(fall.time.back(), "s", 3) +
          (steady ? std::string()
                  : fmt::format(" ({} to {})", rpm_text(speed_at(times, turns, fall.time.front())),
                                rpm_text(speed_at(times, turns, fall.time.back())))),
      scale == SpectrumScale::Relative ? fmt::format("{:.1f} of the largest amplitude", distance)
                                       : desktop::pretty_quantity(distance, unit, 3),
      desktop::pretty_quantity(fall.frequency.front(), "Hz", 3));
  page.note += fmt::format(
      " Each is of {} without mean and trend: what is slower is in its first lines, the first may "
      "be half too low.",
      desktop::pretty_quantity(1.0 / fall.frequency.front(), "s", 3));
  if (decibel)
    page.note += " 0 dB is the largest amplitude of all; nothing below " +
                 desktop::pretty_quantity(-kDecibels, "dB", 3) + " is drawn.";
  choose_frequency_axis(page, ends, kVisible);
  if (page.view_high < page.x.back())
    page.note += fmt::format(" Beyond the first view nothing is above {} % of the largest.",
                             desktop::pretty_number(100.0 * kVisible, 2));
  page.panels.push_back(std::move(panel));
}

}  // namespace adore::adrplot
