#include "adrplot/spectrogram_page.hpp"

#include "adrplot/sentence_words.hpp"
#include "adrplot/spectrum_page.hpp"
#include "adrplot/vibration_values.hpp"
#include "base/counted.hpp"
#include "desktop/axis_scale.hpp"
#include "signal/spectrogram.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <functional>
#include <limits>

namespace adore::adrplot {
namespace {

/// End of the first view: shortly after the last amplitude above a twentieth of the largest, at
/// least ten lines of the spectra.
constexpr double kVisibleShare = 0.05;
double end_of_view(const std::vector<double>& frequency, const std::vector<double>& ends) {
  double last = frequency[std::min<std::size_t>(10, frequency.size() - 1)];
  for (const double end : ends) last = std::max(last, end);
  return std::min(frequency.back(), 1.15 * last);
}

constexpr double kSteady = 0.01;

/// Revolutions per second while a piece lasts.
double speed_of_piece(const RunMotion& motion, const signal::Spectrogram& of, std::size_t i) {
  const MarkEventCounts shaft{"", motion.times, motion.turns};
  return frequency_between(shaft, of.time[i] - 0.5 * of.length, of.time[i] + 0.5 * of.length);
}

/// Vertical places of the pieces: their times [s] or shaft speeds [rpm], in increasing order.
struct Places {
  bool speed = false;
  std::vector<double> at;
  std::vector<std::size_t> piece;
};

/// Speeds that do not increase or decrease from piece to piece have no axis: time is used.
Places places_of(const RunMotion& motion, const signal::Spectrogram& of, bool over_speed) {
  Places out;
  for (std::size_t i = 0; i < of.time.size(); ++i) out.piece.push_back(i);
  if (over_speed && !motion.turns.empty()) {
    for (const std::size_t i : out.piece) out.at.push_back(60.0 * speed_of_piece(motion, of, i));
    if (out.at.size() > 1 && out.at.back() < out.at.front()) {
      std::reverse(out.at.begin(), out.at.end());
      std::reverse(out.piece.begin(), out.piece.end());
    }
    out.speed = out.at.size() > 1 && std::adjacent_find(out.at.begin(), out.at.end(),
                                                        std::greater_equal<>()) == out.at.end();
  }
  if (!out.speed) {
    out.at = of.time;
    std::sort(out.piece.begin(), out.piece.end());
  }
  return out;
}

/// Position of marks: vertical for a shaft with constant speed, else at the frequencies of each
/// piece.
std::vector<desktop::ChartMark> marks_of(const RunMotion& motion, bool steady,
                                         const signal::Spectrogram& of, const Places& places) {
  std::vector<desktop::ChartMark> out = mean_marks(motion.marks);
  if (steady) return out;
  for (desktop::ChartMark& mark : out) {
    const auto turns =
        std::find_if(motion.marks.begin(), motion.marks.end(),
                     [&](const MarkEventCounts& one) { return one.label == mark.label; });
    for (std::size_t row = 0; row < places.at.size(); ++row) {
      const double middle = of.time[places.piece[row]], half = 0.5 * of.length;
      mark.way.emplace_back(frequency_between(*turns, middle - half, middle + half),
                            places.at[row]);
    }
    mark.x = mark.way.back().first;
  }
  return out;
}

/// Colors end 80 dB below the largest value, or where 5 % of the values are lower.
double lowest_color(const desktop::ChartPanel& panel, double highest) {
  constexpr double kRange = 80.0, kBelow = 0.05;
  std::vector<double> values;
  for (const desktop::ChartCurve& row : panel.curves)
    values.insert(values.end(), row.y.begin(), row.y.end());
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(kBelow * (values.size() - 1.0));
  std::nth_element(values.begin(), at, values.end());
  const double low = std::max(highest - kRange, *at);
  return low < highest ? low : highest - 1.0;
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

bool has_constant_speed(const std::vector<double>& times, const std::vector<double>& turns) {
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

void to_spectrogram(desktop::ChartPage& page, const RunMotion& motion,
                    const SpectrumOptions& options, const std::string& of) {
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
  const BridgedValues bridged = bridge_gaps(times, source.curves.front().y, options.window);
  if (!bridged.why_none.empty()) {
    page.panels.clear();
    add_note(page, capitalize_first(bridged.why_none));
    return;
  }
  add_note(page, bridged.told);
  const signal::Samples samples = signal::equally_spaced_samples(times, bridged.values);
  page.panels.clear();
  if (!samples.values.empty() && is_only_rounding(bridged.values, source.unit, source.least_span)) {
    add_note(page, name + ": no vibration (only rounding errors).");
    return;
  }
  const std::string sampled = sampling_note(samples, times.size());
  const signal::Spectrogram gram =
      signal::spectrogram(samples, options.window, signal::default_pieces(samples.values.size()));
  if (gram.time.empty()) return add_note(page, sampled);
  double largest = 0.0;
  std::vector<double> ends;
  for (const auto& piece : gram.amplitude)
    largest = std::max(largest, *std::max_element(piece.begin(), piece.end()));
  for (const auto& piece : gram.amplitude)
    ends.push_back(highest_frequency_above(gram.frequency, piece, kVisibleShare * largest));
  // Races without relative rotation have no speed.
  const bool steady =
      turns.empty() || !(turns.back() > turns.front()) || has_constant_speed(times, turns);
  const Places rows = places_of(motion, gram, options.over_speed && !steady);
  const SpectrumScale scale = resolved_scale(options.scale, SpectrumScale::Decibel);
  const bool decibel = scale == SpectrumScale::Decibel;
  desktop::ChartPanel panel{name, spectrum_unit(scale, source.unit), {}, false};
  double highest = 0.0;
  for (std::size_t row = 0; row < rows.at.size(); ++row) {
    const std::size_t piece = rows.piece[row];
    desktop::ChartCurve curve{desktop::pretty_quantity(gram.time[piece], "s", 4), {}, {}};
    if (!steady) curve.name += ", " + rpm_text(speed_of_piece(motion, gram, piece));
    for (const double a : gram.amplitude[piece])
      curve.y.push_back(scaled_amplitude(a, largest, scale));
    panel.curves.push_back(std::move(curve));
  }
  highest = scaled_amplitude(largest, largest, scale);
  panel.rows = desktop::ChartMapRows{rows.speed ? "Shaft speed" : "Time",
                                     rows.speed ? "rpm" : "s",
                                     rows.at,
                                     "Amplitude",
                                     decibel ? lowest_color(panel, highest) : 0.0,
                                     highest};
  page.x = gram.frequency;
  page.title = name + ": spectrogram";
  page.view_low = 0.0;
  page.view_high = decibel ? gram.frequency.back() : end_of_view(gram.frequency, ends);
  page.x_title = "Frequency";
  page.x_unit = "Hz";
  page.marks = marks_of(motion, steady, gram, rows);
  std::string told = fmt::format("{} ({}) of {} each, line spacing {}; mean and trend are removed.",
                                 capitalize_first(counted(gram.time.size(), "spectrum", "spectra")),
                                 signal::window_name(options.window),
                                 desktop::pretty_quantity(gram.length, "s", 3),
                                 desktop::pretty_quantity(gram.frequency.front(), "Hz", 3));
  if (options.over_speed && !rows.speed)
    told += steady
                ? " The shaft speed is constant, so the axis is time."
                : " The shaft speed does not increase or decrease steadily, so the axis is time.";
  if (!steady)
    told += fmt::format(" The marks follow the shaft speed ({} to {}).",
                        rpm_text(speed_of_piece(motion, gram, 0)),
                        rpm_text(speed_of_piece(motion, gram, gram.time.size() - 1)));
  page.note = told + (page.note.empty() ? "" : " ") + page.note;
  add_note(page, sampled);
  const std::string note = page.note;
  if (!decibel) choose_frequency_axis(page, ends, kVisibleShare);
  page.note = note + (page.log_x ? " Logarithmic frequency axis." : "");
  if (page.view_high < page.x.back())
    page.note += fmt::format(" Amplitudes outside the initial view are below {} % of the maximum.",
                             desktop::pretty_number(100.0 * kVisibleShare, 2));
  page.panels.push_back(std::move(panel));
}

}  // namespace adore::adrplot
