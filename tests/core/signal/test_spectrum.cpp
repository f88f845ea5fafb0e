#include "signal/spectrum.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

using namespace adore::signal;

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr std::size_t kCount = 1000;
constexpr double kStep = 1e-4;  // [s]

/// @param periods within all samples
std::vector<double> sine(double periods, double amplitude, double phase = 0.3, double mean = 0.0) {
  std::vector<double> out;
  for (std::size_t i = 0; i < kCount; ++i)
    out.push_back(mean +
                  amplitude * std::cos(kTurn * periods * static_cast<double>(i) / kCount + phase));
  return out;
}

double highest(const Spectrum& spectrum) {
  return *std::max_element(spectrum.amplitude.begin(), spectrum.amplitude.end());
}

}  // namespace

TEST_CASE("amplitude_spectrum: sine at a line → its amplitude at its frequency", "[unit]") {
  for (const Window window : {Window::None, Window::Hann, Window::FlatTop})
    for (const std::size_t line : {12U, 40U, 333U}) {
      const Spectrum s =
          amplitude_spectrum(sine(static_cast<double>(line), 0.3, 1.1, 5e3), kStep, window);
      INFO(window_name(window) << ", line " << line);
      REQUIRE(s.amplitude.size() == kCount / 2);
      CHECK(s.frequency[line - 1] ==
            Approx(static_cast<double>(line) / (static_cast<double>(kCount) * kStep)));
      CHECK(s.amplitude[line - 1] == Approx(0.3).epsilon(1e-8));
      CHECK(s.amplitude[line + 5] < 1e-9);
    }
}

TEST_CASE("amplitude_spectrum: sine between two lines → loss of its window", "[unit]") {
  // Closed forms at half a line: None 2/pi, Hann 8/(3 pi), flat top from its five terms.
  for (const auto& [window, part] : {std::pair{Window::None, 2.0 / std::numbers::pi},
                                     {Window::Hann, 8.0 / (3.0 * std::numbers::pi)},
                                     {Window::FlatTop, 0.9990}}) {
    INFO(window_name(window));
    CHECK(highest(amplitude_spectrum(sine(200.5, 2.0), kStep, window)) ==
          Approx(2.0 * part).epsilon(3e-3));
  }
}

TEST_CASE("amplitude_spectrum: sum of squares → mean square of the samples (Parseval)", "[unit]") {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  for (const std::size_t n : {1000U, 1001U}) {
    std::vector<double> noise(n);
    for (double& v : noise) v = 3.0 + normal(random);
    double mean = 0.0, square = 0.0;
    for (const double v : noise) mean += v / static_cast<double>(n);
    for (const double v : noise) square += (v - mean) * (v - mean) / static_cast<double>(n);
    const Spectrum s = amplitude_spectrum(noise, kStep);
    double sum = 0.0;
    for (std::size_t k = 0; k < s.amplitude.size(); ++k)
      sum += (2 * (k + 1) == n ? 1.0 : 0.5) * s.amplitude[k] * s.amplitude[k];
    CHECK(sum == Approx(square).epsilon(1e-10));
  }
  // A sine is 1/2 A^2 for any window, with its noise bandwidth.
  for (const Window window : {Window::None, Window::Hann, Window::FlatTop}) {
    double sum = 0.0;
    for (const double a : amplitude_spectrum(sine(100.3, 2.0), kStep, window).amplitude)
      sum += 0.5 * a * a;
    INFO(window_name(window));
    CHECK(sum / noise_bandwidth(window, kCount) == Approx(2.0).epsilon(2e-3));
  }
  CHECK(noise_bandwidth(Window::Hann, kCount) == Approx(1.5));
  CHECK(noise_bandwidth(Window::FlatTop, kCount) == Approx(3.7702).epsilon(1e-3));
}

TEST_CASE("amplitude_spectrum: constant or too short → no lines", "[unit]") {
  CHECK(highest(amplitude_spectrum(std::vector<double>(100, 0.1), kStep, Window::Hann)) == 0.0);
  CHECK(amplitude_spectrum({1.0, 2.0, 3.0}, kStep).amplitude.empty());
  CHECK(amplitude_spectrum(std::vector<double>(100, 0.1), 0.0).amplitude.empty());
}

TEST_CASE("decibels: ratio to the reference, limited below", "[unit]") {
  CHECK(decibels(10.0, 1.0, -160.0) == Approx(20.0));
  CHECK(decibels(1e-3, 1e-6, -160.0) == Approx(60.0));
  CHECK(decibels(0.0, 1.0, -160.0) == -160.0);
  CHECK(decibels(1e-12, 1.0, -160.0) == -160.0);
}
