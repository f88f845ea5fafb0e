#include "signal/envelope.hpp"
#include "signal/impulsive_band.hpp"
#include "signal/spectrum.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

using namespace adore::signal;

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kStep = 1e-4;  // [s]: frequencies up to 5 kHz

std::vector<double> values(std::size_t count, auto&& value) {
  std::vector<double> out;
  for (std::size_t i = 0; i < count; ++i) out.push_back(value(kStep * static_cast<double>(i)));
  return out;
}

/// Impacts, each with a decaying vibration of 3.4 kHz, 90 times per second.
double impacts(double t) {
  constexpr double kRate = 90.0, kDecay = 1500.0;  // [Hz], [1/s]
  const double since = t - std::floor(t * kRate) / kRate;
  return std::exp(-kDecay * since) * std::sin(kTurn * 3400.0 * since);
}

}  // namespace

TEST_CASE("impulsive_band: impacts below a strong tone and noise → band of their resonance",
          "[unit]") {
  std::mt19937 random(7);  // NOLINT: the same in each run
  std::normal_distribution<double> noise(0.0, 0.02);
  const std::vector<double> y = values(16384, [&](double t) {
    return 20.0 + 30.0 * t + 8.0 * std::sin(kTurn * 35.0 * t) + impacts(t) + noise(random);
  });
  const ImpulsiveBand band = impulsive_band(y, kStep);
  CHECK(band.low < 3400.0);
  CHECK(band.high > 3400.0);
  CHECK(band.kurtosis > kImpulsive);
  // The envelope spectrum of that band has its highest line at the rate of the impacts.
  const Spectrum s =
      amplitude_spectrum(envelope(y, kStep, band.low, band.high), kStep, Window::Hann);
  const auto at = std::max_element(s.amplitude.begin(), s.amplitude.end()) - s.amplitude.begin();
  CHECK(s.frequency[static_cast<std::size_t>(at)] == Approx(90.0).margin(1.0));
}

TEST_CASE("impulsive_band: modulated tone → band around it, kurtosis of the modulation", "[unit]") {
  constexpr double kDepth = 0.4;
  const std::vector<double> y = values(8192, [](double t) {
    return 10.0 * std::sin(kTurn * 60.0 * t) +
           (1.0 + kDepth * std::cos(kTurn * 87.5 * t)) * std::cos(kTurn * 2200.0 * t);
  });
  const ImpulsiveBand band = impulsive_band(y, kStep);
  CHECK(band.low < 2200.0 - 87.5);
  CHECK(band.high > 2200.0 + 87.5);
  // |c| = 1 + m cos: mean of |c|^4 over the square of that of |c|^2, less 2.
  const double m2 = kDepth * kDepth, square = 1.0 + m2 / 2.0;
  CHECK(band.kurtosis ==
        Approx((1.0 + 3.0 * m2 + 3.0 / 8.0 * m2 * m2) / (square * square) - 2.0).margin(0.01));
  CHECK(band.change * std::sqrt(50.0 + square / 2.0) ==
        Approx(kDepth / std::sqrt(2.0)).epsilon(0.02));
}

TEST_CASE("impulsive_band: slow motion only, constant or few values → none", "[unit]") {
  const auto none = [](const std::vector<double>& y) {
    const ImpulsiveBand band = impulsive_band(y, kStep);
    return band.low == 0.0 && band.high == 0.0;
  };
  CHECK(none(values(4096, [](double t) { return 5.0 * t; })));
  CHECK(none(values(4096, [](double) { return 3.0; })));
  CHECK(none(values(4096, [](double t) { return t + std::sin(kTurn * 10.0 * t); })));
  CHECK(none(values(kMinBandSamples - 1, impacts)));
  CHECK_FALSE(none(values(kMinBandSamples * 8, impacts)));
}
