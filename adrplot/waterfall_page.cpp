#include "adrplot/waterfall_page.hpp"

#include "adrplot/sentence_words.hpp"
#include "adrplot/spectrum_page.hpp"
#include "base/counted.hpp"
#include "desktop/axis_scale.hpp"
#include "desktop/even_digits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>

namespace adore::adrplot {
namespace {

/// Offset of each curve as a fraction of the largest amplitude.
constexpr double kDistance = 0.2;

/// In dB this is all that is drawn of a line.
constexpr double kDecibels = 60.0;

/// End of the first view: shortly after the last amplitude above a quarter of that distance, at
/// least ten lines of the spectra.
constexpr double kVisible = 0.25 * kDistance;
double end_of_view(const Waterfall& fall, const std::vector<double>& ends) {
  double last = fall.frequency[std::min<std::size_t>(10, fall.frequency.size() - 1)];
  for (const double end : ends) last = std::max(last, end);
  return std::min(fall.frequency.back(), 1.15 * last);
}

/// Drawn height of an amplitude on the lowest line.
double height_of(double amplitude, double largest, SpectrumScale scale) {
  if (scale == SpectrumScale::Units) return amplitude;
  const double part = largest > 0.0 ? amplitude / largest : 0.0;
  if (scale == SpectrumScale::Relative) return part;
  return part > 0.0 ? std::max(-kDecibels, 20.0 * std::log10(part)) : -kDecibels;
}

constexpr double kSteady = 0.01;

/// Position of marks for spectra at a `distance`: vertical for a shaft with constant speed, else at
/// the frequencies of each piece.
std::vector<desktop::ChartMark> marks_of(const RunMotion& motion, bool steady,
                                         const Waterfall& fall, double distance, double foot) {
  std::vector<desktop::ChartMark> out = mean_marks(motion.marks);
  if (steady) return out;
  const double half = 0.5 / fall.frequency.front();  // of a piece [s]
  for (desktop::ChartMark& mark : out) {
    const auto turns = std::find_if(motion.marks.begin(), motion.marks.end(),
                                    [&](const MarkTurns& one) { return one.label == mark.label; });
    for (std::size_t i = 0; i < fall.time.size(); ++i) {
      const double frequency = frequency_between(*turns, fall.time[i] - half, fall.time[i] + half);
      mark.way.emplace_back(frequency, distance * static_cast<double>(i) + foot);
    }
    mark.x = mark.way.back().first;
    // Upright from the foot of the panel, and to its top.
    constexpr double kFar = 1e3;  // of distances
    mark.way.insert(mark.way.begin(), {mark.way.front().first, foot - distance});
    mark.way.emplace_back(mark.x, foot + kFar * distance);
  }
  return out;
}

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

}  // namespace

std::pair<double, double> speed_range(const std::vector<double>& times,
                                      const std::vector<double>& turns) {
  if (turns.size() != times.size() || turns.size() < 2) return {};
  // Averaged over parts of the run: single steps have few digits.
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

std::string curve_name(const desktop::ChartPanel& panel, const desktop::ChartCurve& curve) {
  if (curve.name.empty()) return panel.title;
  return curve.name.starts_with(panel.title) ? curve.name : panel.title + ", " + curve.name;
}

std::optional<std::size_t> choice_of(const std::vector<std::string>& choices,
                                     const std::string& wanted) {
  const std::string text = lower(wanted);
  if (text.empty()) return std::nullopt;
  for (std::size_t i = 0; i < choices.size(); ++i)
    if (lower(choices[i]) == text) return i;
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error == std::errc() && end == text.data() + text.size())
    return number >= 1 && number <= choices.size() ? std::optional(number - 1) : std::nullopt;
  for (std::size_t i = 0; i < choices.size(); ++i)
    if (lower(choices[i]).find(text) != std::string::npos) return i;
  return std::nullopt;
}

void to_waterfall(desktop::ChartPage& page, const RunMotion& motion, const SpectrumOptions& options,
                  const std::string& of) {
  const std::vector<double>&times = motion.times, &turns = motion.turns;
  std::vector<std::pair<std::size_t, std::size_t>> places;
  for (std::size_t p = 0; p < page.panels.size(); ++p)
    for (std::size_t c = 0; c < page.panels[p].curves.size(); ++c) {
      const desktop::ChartCurve& curve = page.panels[p].curves[c];
      if (std::none_of(curve.y.begin(), curve.y.end(), [](double v) { return std::isfinite(v); }))
        continue;
      places.emplace_back(p, c);
      page.choices.push_back(curve_name(page.panels[p], curve));
    }
  if (places.empty()) {
    page.panels.clear();
    page.note = "The curves of this page have no values.";
    return;
  }
  page.chosen = choice_of(page.choices, of).value_or(0);
  const auto [in_panel, at] = places[page.chosen];
  desktop::ChartPanel source = std::move(page.panels[in_panel]);
  source.curves = {source.curves[at]};
  const std::string name = page.choices[page.chosen];
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
    page.note += (page.note.empty() ? "" : " ") + name + ": no vibration (only rounding errors).";
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
  desktop::ChartPanel panel{name, unit, {}, false};
  // Races without relative rotation have no speed.
  const bool steady = turns.empty() || !(turns.back() > turns.front()) || keeps_speed(times, turns);
  const MarkTurns shaft{"", times, turns};
  const auto speed_at = [&](double time) {  // while its piece lasts
    const double half = 0.5 / fall.frequency.front();
    return frequency_between(shaft, time - half, time + half);
  };
  for (std::size_t i = 0; i < fall.time.size(); ++i) {
    desktop::ChartCurve curve{desktop::even_quantity(fall.time[i], "s", 3), {}, {}};
    if (!steady) curve.name += ", " + rpm_text(speed_at(fall.time[i]));
    curve.lift = distance * static_cast<double>(i);
    curve.foot = decibel ? -kDecibels : 0.0;
    for (const double a : fall.amplitude[i])
      curve.y.push_back(height_of(a, largest, scale) + curve.lift);
    panel.curves.push_back(std::move(curve));
  }
  panel.one_colour = true;
  panel.scale_bar = true;
  page.x = fall.frequency;
  page.title = name + ": waterfall";
  page.view_low = 0.0;
  page.view_high = decibel ? fall.frequency.back() : end_of_view(fall, ends);
  page.x_title = "Frequency";
  page.x_unit = "Hz";
  page.marks = marks_of(motion, steady, fall, distance, decibel ? -kDecibels : 0.0);
  // The bar shows the distance of the lines, the names their order.
  std::string drawn = fmt::format(
      "{} ({}) of {} each, line spacing {}. Mean and trend are removed: the lowest line may be 50 "
      "% too low.",
      capital(counted(fall.time.size(), "spectrum", "spectra")), window_name(options.window),
      desktop::pretty_quantity(1.0 / fall.frequency.front(), "s", 3),
      desktop::pretty_quantity(fall.frequency.front(), "Hz", 3));
  if (!steady)
    drawn +=
        fmt::format(" The marks follow the shaft speed ({} to {}).",
                    rpm_text(speed_at(fall.time.front())), rpm_text(speed_at(fall.time.back())));
  if (decibel)
    drawn += " 0 dB is the maximum of all spectra. Values below " +
             desktop::pretty_quantity(-kDecibels, "dB", 3) + " are not drawn.";
  page.note = drawn + (page.note.empty() ? "" : " ") + page.note;
  const std::string note = page.note;
  choose_frequency_axis(page, ends, kVisible);
  // The end of each line is visible.
  page.note = note + (page.log_x ? " Logarithmic frequency axis." : "");
  if (page.view_high < page.x.back())
    page.note += fmt::format(" Lines outside the initial view are below {} % of the maximum.",
                             desktop::pretty_number(100.0 * kVisible, 2));
  page.panels.push_back(std::move(panel));
}

}  // namespace adore::adrplot
