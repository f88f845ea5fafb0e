#include "results/batch_means.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <random>

using namespace adore::results;

namespace {

/// x_i = φ x_(i-1) + ε_i, ε normal with variance 1, from its stationary distribution.
class Series {
 public:
  Series(double phi, unsigned seed) : phi_(phi), random_(seed) {
    x_ = normal_(random_) / std::sqrt(1.0 - phi * phi);
  }
  double next() { return x_ = phi_ * x_ + normal_(random_); }

 private:
  double phi_, x_ = 0.0;
  std::mt19937 random_;
  std::normal_distribution<double> normal_;
};

}  // namespace

TEST_CASE("ratio_half_width(): AR(1) series of known variance → 95 % interval",
          "[unit][accuracy]") {
  // Variance of the mean of N values of an AR(1) series: 1 / ((1 - φ)² N) for N (1 - φ) >> 1.
  constexpr int kSeries = 400, kValues = 4096;
  for (const double phi : {0.0, 0.5, 0.9, 0.98}) {
    const double exact = 1.0 / ((1.0 - phi) * std::sqrt(static_cast<double>(kValues)));
    int covered = 0;
    double width = 0.0;
    for (int s = 0; s < kSeries; ++s) {
      Series series(phi, 100U + static_cast<unsigned>(s));
      BatchSums<1> batches;
      double sum = 0.0;
      for (int i = 0; i < kValues; ++i) {
        const double x = 3.0 + series.next();
        sum += x;
        batches.add(0.5, {0.5 * x});
      }
      const double half = batches.half_width(0);
      width += half / kSeries;
      if (std::abs(sum / kValues - 3.0) <= half) ++covered;
    }
    CAPTURE(phi, covered, width / (1.96 * exact));
    CHECK(covered >= 0.92 * kSeries);
    CHECK(covered <= 0.995 * kSeries);
    CHECK(width > 1.0 * 1.96 * exact);
    CHECK(width < 1.5 * 1.96 * exact);
  }
}

TEST_CASE("ratio_half_width(): proportional sums → no error; too few batches → none computed",
          "[unit][accuracy]") {
  const std::vector<double> s{1, 2, 3, 4, 5, 6, 7, 8};
  std::vector<double> a;
  for (const double one : s) a.push_back(0.4 * one);
  CHECK(ratio_half_width(a, s) < 1e-15);
  CHECK(std::isnan(ratio_half_width(std::vector<double>(7, 1.0), std::vector<double>(7, 1.0))));
  CHECK(std::isnan(ratio_half_width(a, std::vector<double>(8, 0.0))));
  // A drift is scatter: twice as steep, twice the error.
  a.front() += 0.1;
  const double one = ratio_half_width(a, s);
  a.front() += 0.1;
  CHECK(ratio_half_width(a, s) == Approx(2.0 * one));
}

TEST_CASE(
    "paired_scatter(): two AR(1) series on one trend and period → 95 % interval of the "
    "difference, without either",
    "[unit][accuracy]") {
  constexpr int kPairs = 400, kValues = 4096;
  constexpr double kPhi = 0.9;
  const double exact = std::sqrt(2.0 / kValues) / (1.0 - kPhi);
  int covered = 0;
  double width = 0.0, fall = 0.0, own = 0.0;
  for (unsigned s = 0; s < kPairs; ++s) {
    Series first(kPhi, 100U + s), second(kPhi, 9000U + s);
    BatchSums<1> one, other;
    double sum = 0.0;
    for (int i = 0; i < kValues; ++i) {
      const double same = 50.0 * std::exp(-i / 700.0) + 30.0 * std::sin(i / 500.0);
      const double x = first.next(), y = second.next();
      sum += x - y;
      one.add(0.5, {0.5 * (same + x)});
      other.add(0.5, {0.5 * (same + y)});
    }
    const PairedScatter scatter = paired_scatter(one.rate(0), other.rate(0));
    width += scatter.half_width / kPairs;
    fall += scatter.fall / kPairs;
    own += one.half_width(0) / kPairs;
    if (std::abs(sum / kValues) <= scatter.half_width) ++covered;
  }
  CAPTURE(covered, width / (1.96 * exact), fall);
  CHECK(covered >= 0.93 * kPairs);
  CHECK(width > 1.0 * 1.96 * exact);
  CHECK(width < 1.3 * 1.96 * exact);
  CHECK(fall == Approx(0.45).margin(0.05));
  CHECK(own > 5.0 * width);  // trend and period count as scatter of a single run
}

TEST_CASE(
    "paired_scatter(): bounded phase difference of a steady whirl → interval falls with the span",
    "[unit][accuracy]") {
  constexpr int kPairs = 400, kBatches = 48;
  std::mt19937 random(11);
  std::normal_distribution<double> phase;
  int covered = 0;
  double width = 0.0;
  for (int s = 0; s < kPairs; ++s) {
    RatioSeries one{1.0, std::vector<double>(kBatches, 1.0), std::vector<double>(kBatches, 1.0)};
    RatioSeries other = one;
    const double first = phase(random);
    double before = first;
    for (double& a : other.a) {
      const double now = phase(random);
      a += now - before;
      before = now;
    }
    const PairedScatter scatter = paired_scatter(one, other);
    width += scatter.half_width / kPairs;
    if (std::abs(before - first) / kBatches <= scatter.half_width) ++covered;
  }
  const double exact = 1.96 * std::sqrt(2.0) / kBatches;
  CAPTURE(covered, width / exact);
  CHECK(covered >= 0.93 * kPairs);
  CHECK(width > 1.0 * exact);
  CHECK(width < 2.0 * exact);  // 8 independent blocks: 3.3
}

TEST_CASE(
    "paired_scatter(): runs that part late → variance of the second half; correlation as "
    "long as the span → slow fall; unmatched batches → none",
    "[unit][accuracy]") {
  RatioSeries one{1.0, std::vector<double>(32, 1.0), std::vector<double>(32, 1.0)};
  CHECK(paired_scatter(one, one).half_width == 0.0);
  RatioSeries late = one, drift = one;
  for (std::size_t b = 16; b < 32; ++b) late.a[b] += b % 2 == 0 ? 0.1 : -0.08;
  CHECK(paired_scatter(one, late).late == Approx(2.0));
  for (double& a : drift.a) a += 0.1;
  const PairedScatter constant = paired_scatter(one, drift);
  CHECK(constant.fall == kLeastFall);
  CHECK(constant.half_width >= 0.1);
  RatioSeries twice{2.0, std::vector<double>(16, 2.0), std::vector<double>(16, 2.0)};
  CHECK(paired_scatter(one, twice).half_width == 0.0);  // joined to batches of 2
  twice.seconds = 1.5;
  CHECK(std::isnan(paired_scatter(one, twice).half_width));
  CHECK(std::isnan(paired_scatter(one, {}).half_width));
}

TEST_CASE("BatchSums: batches of equal duration, whatever the intervals", "[unit][accuracy]") {
  BatchSums<2> even, uneven;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> length(0.1, 3.0);
  even.add(1.0, {1.0, 2.0});
  uneven.add(1.0, {1.0, 2.0});
  for (int i = 1; i < 1000; ++i) even.add(1.0, {1.0, 2.0});
  double time = 1.0;
  while (time < 1000.0) {
    const double dt = std::min(length(random), 1000.0 - time);
    uneven.add(dt, {dt, 2.0 * dt});
    time += dt;
  }
  for (const auto* one : {&even, &uneven}) {
    CHECK(one->batch_seconds() == 16.0);
    CHECK(one->count() == 62);  // 1000 / 16
    for (const double sum : one->series(1)) CHECK(sum == Approx(32.0).epsilon(1e-9));
  }
  std::map<std::string, double> state;
  uneven.save(state, "x");
  BatchSums<2> back;
  back.restore(state, "x");
  uneven.add(25.0, {3.0, 1.0});
  back.add(25.0, {3.0, 1.0});
  CHECK(back.series(0) == uneven.series(0));
  CHECK(back.half_width(0, 1) == uneven.half_width(0, 1));
}
