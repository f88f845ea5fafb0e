#include "signal/spectrogram.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace adore::signal;

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

Samples samples_of(std::size_t n, double step, auto&& value) {
  Samples out;
  out.step = step;
  for (std::size_t i = 0; i < n; ++i) out.values.push_back(value(step * static_cast<double>(i)));
  return out;
}

std::size_t highest(const std::vector<double>& piece) {
  return static_cast<std::size_t>(std::max_element(piece.begin(), piece.end()) - piece.begin());
}

}  // namespace

TEST_CASE("spectrogram: chirp → ridge at the frequency of each time", "[unit]") {
  // 200 Hz to 2 kHz in 2 s.
  constexpr double kFrom = 200.0, kRate = 900.0;
  const Samples chirp = samples_of(20'000, 1e-4, [](double t) {
    return 3.0 * std::sin(kTurn * (kFrom * t + 0.5 * kRate * t * t));
  });
  const Spectrogram s = spectrogram(chirp, Window::Hann, {500, 100});
  REQUIRE(s.time.size() == (20'000 - 500) / 100 + 1);
  REQUIRE(s.frequency.size() == 250);
  CHECK(s.length == Approx(0.05));
  CHECK(s.time.front() == Approx(0.5 * 499e-4));
  for (std::size_t i = 0; i < s.time.size(); ++i) {
    const std::size_t ridge = highest(s.amplitude[i]);
    CHECK(s.frequency[ridge] == Approx(kFrom + kRate * s.time[i]).margin(20.0));
    CHECK(s.amplitude[i][ridge] > 0.7 * 3.0);
  }
}

TEST_CASE("spectrogram: tone that begins late → no amplitude before", "[unit]") {
  const Samples late = samples_of(
      10'000, 1e-4, [](double t) { return t < 0.5 ? 0.0 : 2.0 * std::sin(kTurn * 1000.0 * t); });
  const Spectrogram s = spectrogram(late, Window::FlatTop, {500, 250});
  for (std::size_t i = 0; i < s.time.size(); ++i) {
    const double a = s.amplitude[i][49];  // 1 kHz
    if (s.time[i] < 0.47) CHECK(a == 0.0);
    if (s.time[i] > 0.53) CHECK(a == Approx(2.0).epsilon(1e-6));
  }
}

TEST_CASE("spectrogram: straight motion → zero, slow motion → low first lines", "[unit]") {
  const Samples line = samples_of(5000, 1e-4, [](double t) { return 3.0 + 200.0 * t; });
  for (const auto& piece : spectrogram(line, Window::Hann, {500, 250}).amplitude)
    CHECK(*std::max_element(piece.begin(), piece.end()) == 0.0);
  // Lines every 100 Hz; a load that grows by 100 N and swings by 5 N in 60 ms.
  const Samples slow = samples_of(12'500, 1e-5, [](double t) {
    return std::sin(kTurn * 2000.0 * t) + 800.0 * t + 5.0 * std::sin(kTurn * t / 0.06);
  });
  for (const auto& piece : spectrogram(slow, Window::Hann, {1000, 500}).amplitude) {
    for (const std::size_t k : {0U, 1U, 2U}) CHECK(piece.at(k) < 0.35);
    CHECK(piece.at(19) == Approx(1.0).epsilon(1e-3));
  }
}

TEST_CASE("spectrogram: one or two periods in a piece → stated loss and gain", "[unit]") {
  double least[2] = {9.0, 9.0}, most[2] = {0.0, 0.0};
  for (int phase = 0; phase < 16; ++phase)
    for (const std::size_t k : {0U, 1U}) {
      const Samples tone = samples_of(1000, 1e-5, [&](double t) {
        return 7.0 + std::sin(kTurn * (100.0 * static_cast<double>(k + 1) * t + phase / 16.0));
      });
      const double a = spectrogram(tone, Window::Hann, {1000, 500}).amplitude.at(0).at(k);
      least[k] = std::min(least[k], a);
      most[k] = std::max(most[k], a);
    }
  CHECK(least[0] == Approx(0.54).margin(0.01));
  CHECK(most[0] == Approx(1.0).margin(0.01));
  CHECK(least[1] == Approx(1.0).margin(0.01));
  CHECK(most[1] == Approx(1.05).margin(0.01));
}

TEST_CASE("default_pieces: any number of samples → limited pieces and values", "[unit]") {
  for (const std::size_t n : {16U, 17U, 100U, 5000U, 99'991U, 3'000'000U}) {
    const Pieces pieces = default_pieces(n);
    INFO(n);
    CHECK(pieces.length >= kMinSamples);
    CHECK(pieces.hop >= 1);
    const std::size_t count = (n - pieces.length) / pieces.hop + 1;
    CHECK(count <= 301);
    CHECK(count * pieces.length / 2 <= 4'400'000);
    if (n >= 5000) CHECK(count >= 20);
  }
}
