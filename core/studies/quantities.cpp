#include "studies/quantities.hpp"

#include "base/constants.hpp"
#include "base/counted.hpp"
#include "base/errors.hpp"
#include "results/reader_killed.hpp"
#include "results/results_h5.hpp"
#include "studies/cage_whirl.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace adore::studies {
namespace {

bool is_whirl(const std::string& name) {
  return std::find(kWhirlFigures.begin(), kWhirlFigures.end(), name) != kWhirlFigures.end();
}

/// Stored steps within shares of the run's time.
struct Window {
  std::size_t first = 0, count = 0;
};

class Channels {
 public:
  explicit Channels(const std::filesystem::path& folder)
      : file_(folder / "RESULTS.h5"), times_(file_.read("time")) {}

  [[nodiscard]] Window window(double from, double to) const {
    Window out;
    if (times_.empty()) return out;
    const double begin = times_.front(), span = times_.back() - begin;
    const double low = begin + from * span, high = begin + to * span;
    // An instant at the very end belongs to it, despite rounding.
    const double slack = 1e-12 * span;
    const auto first = std::lower_bound(times_.begin(), times_.end(), low - slack);
    const auto last = std::upper_bound(first, times_.end(), high + slack);
    out.first = static_cast<std::size_t>(first - times_.begin());
    out.count = static_cast<std::size_t>(last - first);
    return out;
  }

  [[nodiscard]] double value(const Quantity& quantity) const {
    const auto* info = file_.find(quantity.channel);
    if (info == nullptr)
      throw InputError(fmt::format("{}: the run does not store this channel", quantity.channel));
    const Window in = window(quantity.from, quantity.to);
    std::vector<double> values = file_.read(quantity.channel, in.first, in.count);
    std::size_t width = info->size();
    if (!quantity.places.empty()) {
      const std::size_t at = place(quantity, info->dimensions);
      std::vector<double> one;
      for (std::size_t i = 0; i < in.count; ++i) one.push_back(values[i * width + at]);
      values = std::move(one);
      width = 1;
    }
    const std::vector<double> times(times_.begin() + static_cast<long>(in.first),
                                    times_.begin() + static_cast<long>(in.first + in.count));
    return statistic(quantity.statistic, quantity.percent, times, values, width);
  }

  /// Of the second half of the run: the first belongs to the start.
  [[nodiscard]] Whirl whirl() const {
    const Window in = window(0.5, 1.0);
    const auto y = file_.read("cage.y_over_clearance", in.first, in.count);
    const auto z = file_.read("cage.z_over_clearance", in.first, in.count);
    const auto position = file_.read("cage.position", in.first, in.count);
    const auto velocity = file_.read("cage.velocity", in.first, in.count);
    const auto omega = file_.read("cage.angular_velocity", in.first, in.count);
    const std::size_t cages = in.count > 0 ? y.size() / in.count : 0;
    if (cages != 1) throw InputError("whirl results need a one-piece cage");
    // The clearance, from the two forms of the position.
    double ratio = 0.0, size = 0.0;
    for (std::size_t i = 0; i < in.count; ++i) {
      const double here = std::hypot(position[3 * i + 1], position[3 * i + 2]);
      if (here > size) {
        size = here;
        ratio = std::hypot(y[i], z[i]) / here;
      }
    }
    std::vector<CageInstant> instants;
    for (std::size_t i = 0; i < in.count; ++i)
      instants.push_back(
          {y[i], z[i], ratio * velocity[3 * i + 1], ratio * velocity[3 * i + 2], omega[3 * i]});
    return classify_whirl(instants);
  }

 private:
  static std::size_t place(const Quantity& quantity, const std::vector<std::size_t>& dimensions) {
    if (quantity.places.size() != dimensions.size())
      throw InputError(fmt::format("{}: the channel has {}, but \"at\" gives {}", quantity.channel,
                                   counted(dimensions.size(), "index", "indices"),
                                   quantity.places.size()));
    std::size_t at = 0;
    for (std::size_t k = 0; k < dimensions.size(); ++k) {
      if (quantity.places[k] > dimensions[k])
        throw InputError(fmt::format("{}: index {} must be from 1 to {}, but \"at\" contains {}",
                                     quantity.channel, k + 1, dimensions[k], quantity.places[k]));
      at = at * dimensions[k] + quantity.places[k] - 1;
    }
    return at;
  }

  results::H5Reader file_;
  std::vector<double> times_;
};

double whirl_figure(const Whirl& whirl, const std::string& name) {
  if (name == kWhirlFigures[0]) return whirl.ratio;
  if (name == kWhirlFigures[1]) return whirl.deviation;
  if (name == kWhirlFigures[2]) return whirl.orbit;
  return static_cast<double>(whirl.of);
}

/// Mean over time of each of `width` series, averaged over them, of f(value).
template <class F>
double time_mean(const std::vector<double>& times, const std::vector<double>& values,
                 std::size_t width, F&& f) {
  const std::size_t n = times.size();
  const double span = n > 1 ? times.back() - times.front() : 0.0;
  double sum = 0.0, weights = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    double weight = 1.0;
    if (span > 0.0)
      weight = 0.5 * (times[std::min(i + 1, n - 1)] - times[i > 0 ? i - 1 : 0]) / span;
    for (std::size_t k = 0; k < width; ++k) {
      const double value = values[i * width + k];
      if (std::isnan(value)) continue;
      sum += weight * f(value);
      weights += weight;
    }
  }
  return weights > 0.0 ? sum / weights : kNaN;
}

}  // namespace

bool needs_channels(const std::vector<Quantity>& quantities) {
  return std::any_of(quantities.begin(), quantities.end(), [](const Quantity& quantity) {
    return !quantity.channel.empty() || is_whirl(quantity.name);
  });
}

double percentile_of_sorted(const std::vector<double>& sorted, double percent) {
  if (sorted.empty()) return kNaN;
  const double at = percent / 100.0 * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  if (below + 1 >= sorted.size()) return sorted.back();
  const double share = at - static_cast<double>(below);
  // Not a + share (b - a): an infinite and a finite life would give NaN.
  return share == 0.0 ? sorted[below] : (1.0 - share) * sorted[below] + share * sorted[below + 1];
}

double statistic(Statistic of, double percent, const std::vector<double>& times,
                 const std::vector<double>& values, std::size_t width) {
  std::vector<double> known;
  for (const double value : values)
    if (!std::isnan(value)) known.push_back(value);
  if (known.empty()) return kNaN;
  const auto [least, largest] = std::minmax_element(known.begin(), known.end());
  switch (of) {
    case Statistic::Mean:
      return time_mean(times, values, width, [](double v) { return v; });
    case Statistic::Rms:
      return std::sqrt(time_mean(times, values, width, [](double v) { return v * v; }));
    case Statistic::Deviation: {
      const double mean = time_mean(times, values, width, [](double v) { return v; });
      return std::sqrt(
          time_mean(times, values, width, [mean](double v) { return (v - mean) * (v - mean); }));
    }
    case Statistic::Least:
      return *least;
    case Statistic::Largest:
      return *largest;
    case Statistic::LargestSize:
      return std::max(std::abs(*least), std::abs(*largest));
    case Statistic::Span:
      return *largest - *least;
    case Statistic::Last:
      return width == 1 ? values.back()
                        : time_mean({0.0}, {values.end() - static_cast<long>(width), values.end()},
                                    width, [](double v) { return v; });
    case Statistic::Percentile:
      std::sort(known.begin(), known.end());
      return percentile_of_sorted(known, percent);
  }
  return kNaN;
}

QuantityValues answer(const std::vector<Quantity>& quantities, const results::KeyResults& summary,
                      const std::filesystem::path& folder,
                      const std::function<std::string(const Quantity&)>& why) {
  QuantityValues out;
  std::optional<Channels> channels;
  std::optional<Whirl> whirl;
  const auto file = [&]() -> const Channels& {
    if (!channels) {
      if (!std::filesystem::exists(folder / "RESULTS.h5"))
        throw InputError("a quasi-static run (mode below 0) stores no time histories (channels)");
      channels.emplace(folder);
    }
    return *channels;
  };
  const auto miss = [&](const Quantity& quantity, const std::string& reason) {
    out.missing += fmt::format("{}{}: {}", out.missing.empty() ? "" : "; ", quantity.name, reason);
    return kNaN;
  };
  bool lacks_result = false;
  for (const Quantity& quantity : quantities) {
    double value = kNaN;
    try {
      if (!quantity.channel.empty()) {
        value = file().value(quantity);
      } else if (is_whirl(quantity.name)) {
        if (!whirl) whirl = file().whirl();
        value = whirl_figure(*whirl, quantity.name);
      } else {
        const auto found = std::find_if(
            summary.begin(), summary.end(),
            [&](const results::KeyResult& result) { return result.of.id == quantity.name; });
        if (found != summary.end()) {
          value = found->value;
        } else {
          const std::string known = why(quantity);
          value = miss(quantity, known.empty() ? "the run does not have this key result" : known);
          lacks_result = true;
        }
      }
    } catch (const results::ReaderKilled&) {
      throw;
    } catch (const InputError& error) {
      value = miss(quantity, error.what());
    }
    out.values.push_back(value);
  }
  if (lacks_result && !summary.empty()) {
    out.missing += "; the run has ";
    for (const results::KeyResult& result : summary)
      out.missing += fmt::format("{}{}", &result == &summary.front() ? "" : ", ", result.of.id);
  }
  return out;
}

}  // namespace adore::studies
