#include "signal/envelope.hpp"
#include "signal/orders.hpp"
#include "signal/sampling.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

using namespace adore::signal;

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr std::size_t kCount = 8000;
constexpr double kStep = 1e-4;  // [s]: 0.8 s

std::vector<double> values(auto&& value) {
  std::vector<double> out;
  for (std::size_t i = 0; i < kCount; ++i) out.push_back(value(kStep * static_cast<double>(i)));
  return out;
}

std::pair<double, double> highest(const Spectrum& s) {
  const auto at = std::max_element(s.amplitude.begin(), s.amplitude.end()) - s.amplitude.begin();
  return {s.frequency[static_cast<std::size_t>(at)], s.amplitude[static_cast<std::size_t>(at)]};
}

}  // namespace

TEST_CASE("envelope: amplitude-modulated tone → line A m at the modulation frequency", "[unit]") {
  // A carrier of 2 kHz modulated at 87.5 Hz, below a tone of 300 Hz that is five times as large.
  constexpr double kSize = 2.0, kDepth = 0.4;
  const std::vector<double> y = values([](double t) {
    return 40.0 + 10.0 * std::sin(kTurn * 300.0 * t) +
           kSize * (1.0 + kDepth * std::cos(kTurn * 87.5 * t)) * std::cos(kTurn * 2000.0 * t);
  });
  const std::vector<double> e = envelope(y, kStep, 1500.0, 2500.0);
  REQUIRE(e.size() == kCount);
  for (std::size_t i = 0; i < kCount; ++i)
    CHECK(e[i] ==
          Approx(kSize * (1.0 + kDepth * std::cos(kTurn * 87.5 * kStep * static_cast<double>(i)))));
  const auto [frequency, amplitude] = highest(amplitude_spectrum(e, kStep, Window::Hann));
  CHECK(frequency == Approx(87.5));
  CHECK(amplitude == Approx(kSize * kDepth).epsilon(1e-9));
  // The highest line of the plain spectrum is the low tone.
  CHECK(highest(amplitude_spectrum(y, kStep, Window::Hann)).first == Approx(300.0));
}

TEST_CASE("envelope: band without lines or no samples → empty", "[unit]") {
  const std::vector<double> y = values([](double t) { return t; });
  CHECK(envelope(y, kStep, 2000.1, 2000.2).empty());
  CHECK(envelope(y, kStep, 300.0, 200.0).empty());
  CHECK(envelope({1.0, 2.0}, kStep, 0.0, 1e4).empty());
}

TEST_CASE("order_spectrum: tone that follows a run-up → one line at its order", "[unit]") {
  // The shaft accelerates from 10 to 50 revolutions per second: 24 revolutions in 0.8 s.
  constexpr double kOrder = 5.25;  // 126 periods: at a line
  std::vector<double> turns, y;
  const auto angle = [](double t) { return 10.0 * t + 25.0 * t * t; };
  const double whole = angle(kStep * static_cast<double>(kCount - 1));
  for (std::size_t i = 0; i < kCount; ++i) {
    // As many revolutions as kCount equal steps of 24 revolutions.
    turns.push_back(angle(kStep * static_cast<double>(i)) / whole * 24.0 *
                    static_cast<double>(kCount - 1) / static_cast<double>(kCount));
    y.push_back(3.0 * std::sin(kTurn * kOrder * turns.back()));
  }
  const Spectrum orders = order_spectrum(turns, y, Window::Hann);
  CHECK(highest(orders).first == Approx(kOrder).epsilon(1e-9));
  CHECK(highest(orders).second == Approx(3.0).epsilon(1e-4));
  // The frequency spectrum of the same values is spread.
  CHECK(highest(amplitude_spectrum(y, kStep, Window::Hann)).second < 1.0);
}

TEST_CASE("angle_samples: loss of a tone → (pi / p)^4 of p stored values per period", "[unit]") {
  for (const double p : {8.0, 16.0, 32.0}) {
    std::vector<double> turns, y;
    for (std::size_t i = 0; i < 4000; ++i) {
      const auto k = static_cast<double>(i);
      turns.push_back((k + 0.4 * std::sin(k / 100.0)) / 100.0);
      y.push_back(std::sin(kTurn * turns.back() * 100.0 / p));
    }
    const double part = highest(order_spectrum(turns, y, Window::FlatTop)).second;
    INFO(p << " values per period: " << part);
    CHECK(1.0 - part < 1.2 * std::pow(std::numbers::pi / p, 4.0) + 2e-3);
    CHECK(part < 1.002);
  }
}

TEST_CASE("angle_samples: more angles than values → vibration of the slow part not folded",
          "[unit]") {
  // From 10 to 50 revolutions per second; 4 kHz is order 400 to 80 and no order below 80.
  std::vector<double> turns;
  for (std::size_t i = 0; i < kCount; ++i) {
    const double t = kStep * static_cast<double>(i);
    turns.push_back(10.0 * t + 25.0 * t * t);
  }
  const std::vector<double> y = values([](double t) { return std::sin(kTurn * 4000.0 * t); });
  const auto largest_below = [&](std::size_t count) {
    const AngleSamples angles = angle_samples(turns, y, count);
    const Spectrum orders = amplitude_spectrum(angles.values, angles.step, Window::Hann);
    double out = 0.0;
    for (std::size_t k = 0; k < orders.frequency.size() && orders.frequency[k] < 70.0; ++k)
      out = std::max(out, orders.amplitude[k]);
    return out;
  };
  CHECK(angle_samples(turns, y, 3 * kCount).values.size() == 3 * kCount);
  CHECK(largest_below(3 * kCount) < 0.2 * largest_below(0));
}

TEST_CASE("angle_samples: turns that do not increase or missing values → empty", "[unit]") {
  std::vector<double> turns, y;
  for (int i = 0; i < 100; ++i) turns.push_back(0.01 * i), y.push_back(i);
  CHECK(angle_samples(turns, y).values.size() == 100);
  std::vector<double> back = turns;
  back[50] = back[49];
  CHECK(angle_samples(back, y).values.empty());
  y[3] = std::numeric_limits<double>::quiet_NaN();
  CHECK(angle_samples(turns, y).values.empty());
}

TEST_CASE("equally_spaced_samples: faults, shorter last step, unequal steps", "[unit]") {
  std::vector<double> t, y;
  for (int i = 0; i < 100; ++i) t.push_back(1e-3 * i), y.push_back(2.0 * i);
  CHECK(equally_spaced_samples({0.0, 1.0}, {0.0, 1.0}).fault == SamplingFault::TooFew);
  std::vector<double> gap = y;
  gap[5] = std::numeric_limits<double>::quiet_NaN();
  CHECK(equally_spaced_samples(t, gap).fault == SamplingFault::MissingValues);
  std::vector<double> back = t;
  back[5] = back[4];
  CHECK(equally_spaced_samples(back, y).fault == SamplingFault::TimesNotIncreasing);
  const Samples plain = equally_spaced_samples(t, y);
  CHECK_FALSE((plain.resampled || plain.last_dropped));
  CHECK(plain.step == Approx(1e-3));
  std::vector<double> ended = t;
  ended.back() -= 4e-4;
  const Samples dropped = equally_spaced_samples(ended, y);
  CHECK(dropped.last_dropped);
  CHECK(dropped.values.size() == 99);
  std::vector<double> uneven = t;
  for (std::size_t i = 1; i + 1 < uneven.size(); i += 2) uneven[i] += 3e-4;
  std::vector<double> line;
  for (const double time : uneven) line.push_back(5.0 * time);
  const Samples resampled = equally_spaced_samples(uneven, line);
  CHECK(resampled.resampled);
  CHECK(resampled.shortest == Approx(7e-4));
  CHECK(resampled.longest == Approx(1.3e-3));
  for (std::size_t i = 0; i < resampled.values.size(); ++i)
    CHECK(resampled.values[i] ==
          Approx(5.0 * (resampled.start + resampled.step * static_cast<double>(i))).margin(1e-12));
}
