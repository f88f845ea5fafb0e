#include "core/integrators/problems.hpp"
#include "integrators/arrow_jacobian.hpp"

#include <Eigen/Dense>
#include <catch2/catch.hpp>

#include <random>

using namespace adore::integrators;
using namespace adore::test;

namespace {

/// Blocks of different sizes whose rows are scattered, and a border of three.
const std::vector<int> kScattered{2, 0, -1, 1, 0, 2, 1, -1, 0, 2, 2, -1, 3};

struct Pair {
  ArrowMatrix arrow;
  Eigen::MatrixXd dense;
};
Pair random_pair(std::span<const int> block_of, int size, unsigned seed, bool ring = false) {
  Pair pair{ArrowMatrix(std::make_shared<ArrowShape>(block_of, size, ring)),
            Eigen::MatrixXd::Zero(size, size)};
  const int blocks = pair.arrow.shape().blocks();
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j < size; ++j) {
      const int a = block_of.empty() ? kBorder : block_of[i];
      const int b = block_of.empty() ? kBorder : block_of[j];
      const bool neighbours = ring && ((a + 1) % blocks == b || (b + 1) % blocks == a);
      if (a != b && a != kBorder && b != kBorder && !neighbours) continue;
      pair.arrow.at(i, j) = pair.dense(i, j) = value(generator);
    }
  }
  return pair;
}

/// `n` masses on nonlinear springs, each in its own pocket of a carrier with friction between them:
/// y = x_0..x_n-1, v_0..v_n-1, X, V, and the friction's heat as a quadrature.
class Carrier final : public OdeSystem {
 public:
  /// @param ring springs between neighboring masses, the last and the first are neighbors
  explicit Carrier(int n, bool ring = false)
      : n_(n),
        ring_(ring),
        scales_(static_cast<std::size_t>(2 * n) + 2, 1.0),
        blocks_(scales_.size(), kBorder) {
    for (int i = 0; i < 2 * n; ++i) blocks_[i] = i % n;
  }
  [[nodiscard]] int size() const noexcept override { return 2 * n_ + 3; }
  [[nodiscard]] int controlled_size() const noexcept override { return 2 * n_ + 2; }
  [[nodiscard]] std::span<const double> scales() const noexcept override { return scales_; }
  [[nodiscard]] std::span<const int> blocks() const noexcept override {
    return told_ ? std::span<const int>(blocks_) : std::span<const int>();
  }
  [[nodiscard]] bool blocks_form_ring() const noexcept override { return told_ && ring_; }
  EvalStatus rhs(double t, const double* y, double* f) noexcept override {
    return rhs_with_contributions(RhsPart::Whole, t, y, f, nullptr);
  }
  EvalStatus rhs_with_contributions(RhsPart part, double t, const double* y, double* f,
                                    double* shares) noexcept override {
    if (part == RhsPart::Stiff) return OdeSystem::rhs_with_contributions(part, t, y, f, shares);
    ++calls;
    const double* v = y + n_;
    const double X = y[2 * n_], V = y[2 * n_ + 1];
    f[2 * n_] = V;
    f[2 * n_ + 1] = -X;
    f[2 * n_ + 2] = 0.0;
    for (int i = 0; i < n_; ++i) {
      const double d = y[i] - (1.0 + i) * X, friction = std::tanh(v[i] - V);
      f[i] = v[i];
      f[n_ + i] = -kStiffness * d * (1.0 + d * d) - friction;
      const double share = 1e-2 * (kStiffness * d * (1.0 + d * d) + friction);
      f[2 * n_ + 1] += share;
      f[2 * n_ + 2] += friction * (v[i] - V);
      if (shares) shares[2 * i] = 0.0, shares[2 * i + 1] = share;
    }
    for (int i = 0; ring_ && i < n_; ++i) {
      const int next = (i + 1) % n_;
      const double d = y[next] - y[i], pull = 0.3 * kStiffness * (d + d * d * d) + v[next] - v[i];
      f[n_ + i] += pull;
      f[n_ + next] -= pull;
      f[2 * n_ + 2] += (v[next] - v[i]) * (v[next] - v[i]);
    }
    return EvalStatus::Ok;
  }
  [[nodiscard]] bool has_stiff_part() const noexcept override { return true; }
  EvalStatus rhs_stiff(double, const double* y, double* f) noexcept override {
    std::fill_n(f, size(), 0.0);
    for (int i = 0; i < n_; ++i) {
      const double d = y[i] - (1.0 + i) * y[2 * n_];
      f[i] = y[n_ + i];
      f[n_ + i] = -kStiffness * d * (1.0 + d * d);
    }
    return EvalStatus::Ok;
  }
  void hide_blocks() { told_ = false; }
  [[nodiscard]] std::vector<double> start() const {
    std::vector<double> y(static_cast<std::size_t>(size()), 0.0);
    for (int i = 0; i < n_; ++i) y[n_ + i] = 0.1 * std::cos(1.0 + i);
    y[2 * n_ + 1] = 0.2;
    return y;
  }
  long calls = 0;

 private:
  static constexpr double kStiffness = 400.0;
  int n_;
  bool ring_, told_ = true;
  std::vector<double> scales_;
  std::vector<int> blocks_;
};

}  // namespace

TEST_CASE("Arrow matrix: solution equals that of a dense matrix", "[unit][integrators]") {
  std::vector<int> no_border{0, 1, 2, 0, 1, 2, 2};
  std::vector<int> bearing;
  for (int part = 0; part < 9; ++part)
    for (int i = 0; i < 12; ++i) bearing.push_back(i);
  bearing.insert(bearing.end(), 14, kBorder);
  for (const std::vector<int>& block_of :
       {kScattered, no_border, bearing, std::vector<int>(5, kBorder), std::vector<int>{}}) {
    const int size = block_of.empty() ? 6 : static_cast<int>(block_of.size());
    for (unsigned seed = 0; seed < 20; ++seed) {
      auto [arrow, dense] = random_pair(block_of, size, seed);
      // As in a step: the pivots of the blocks stay well away from zero.
      arrow.scale_and_add_identity(-0.4);
      dense = Eigen::MatrixXd::Identity(size, size) - 0.4 * dense;
      Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(size, -1.0, 2.0);
      const Eigen::VectorXd expected = dense.fullPivLu().solve(b);
      REQUIRE(arrow.factor());
      arrow.solve(b.data());
      // A condition of a few thousand at most, times rounding.
      CHECK((b - expected).norm() < 1e-11 * expected.norm());
    }
  }
}

TEST_CASE("Arrow matrix: ring of blocks with a border → solution equals that of a dense matrix",
          "[unit][integrators]") {
  for (const int blocks : {1, 2, 3, 4, 5, 6, 7, 8, 11, 18})
    for (const int border : {0, 1, 5}) {
      std::vector<int> block_of;
      for (int part = 0; part < 4; ++part)
        for (int b = 0; b < blocks; ++b)
          if (part < 2 + b % 3) block_of.push_back(b);  // two to four rows each, scattered
      for (int k = 0; k < border; ++k)
        block_of.insert(block_of.begin() + k * 3 % static_cast<int>(block_of.size()), kBorder);
      const int size = static_cast<int>(block_of.size());
      for (unsigned seed = 0; seed < 10; ++seed) {
        auto [arrow, dense] = random_pair(block_of, size, seed, true);
        arrow.scale_and_add_identity(-0.15);
        dense = Eigen::MatrixXd::Identity(size, size) - 0.15 * dense;
        Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(size, -1.0, 2.0);
        const Eigen::VectorXd expected = dense.fullPivLu().solve(b);
        REQUIRE(arrow.factor());
        arrow.solve(b.data());
        INFO(blocks << " blocks, border " << border << ", seed " << seed);
        CHECK((b - expected).norm() < 1e-11 * expected.norm());
      }
    }
  // Blocks that are no neighbors have no element, and sets that are displaced together stand
  // apart.
  const std::vector<int> one_each{0, 1, 2, 3, 4, 5, 6};
  ArrowMatrix ring(std::make_shared<ArrowShape>(one_each, 7, true));
  CHECK_NOTHROW(ring.at(0, 6));
  CHECK_NOTHROW(ring.at(6, 0));
  CHECK_THROWS_AS(ring.at(6, 1), std::out_of_range);
  CHECK_THROWS_AS(ring.at(2, 4), std::out_of_range);
  for (int n = 1; n < 30; ++n) {
    std::vector<int> block_of;
    for (int b = 0; b < n; ++b) block_of.push_back(b);
    const ArrowShape shape(block_of, n, true);
    int members = 0;
    for (const std::vector<int>& set : shape.independent_block_sets()) {
      members += static_cast<int>(set.size());
      for (const int a : set)
        for (const int b : set) {
          const int way = std::abs(a - b);
          if (a != b) CHECK(std::min(way, n - way) >= 3);
        }
    }
    CHECK(members == n);
    CHECK(shape.independent_block_sets().size() <= (n == 5 ? 5 : 4));
  }
}

TEST_CASE("Arrow matrix: singular part or wrong structure → reported", "[unit][integrators]") {
  auto [arrow, dense] = random_pair(kScattered, 13, 1);
  for (const int j : {1, 4, 8}) arrow.at(4, j) = 0.0;
  CHECK_FALSE(arrow.factor());
  CHECK_THROWS_AS(arrow.at(0, 1), std::out_of_range);
  CHECK_THROWS_AS(ArrowShape(kScattered, 12), std::invalid_argument);
  CHECK_THROWS_AS(ArrowShape(std::vector<int>{0, -2}, 2), std::invalid_argument);
  CHECK_THROWS_AS(ArrowShape(std::vector<int>{0, 7}, 2), std::invalid_argument);
}

TEST_CASE("Arrow Jacobian: equals the dense one at constant cost", "[unit][integrators]") {
  for (const auto& [n, ring] : {std::pair{3, false},
                                {12, false},
                                {40, false},
                                {2, true},
                                {5, true},
                                {12, true},
                                {40, true}}) {
    Carrier told(n, ring), untold(n, ring);
    untold.hide_blocks();
    std::vector<double> y = told.start(), f(y.size());
    for (std::size_t i = 0; i < y.size(); ++i)
      y[i] += 0.05 * std::sin(1.0 + static_cast<double>(i));
    const std::vector<double> before = y;
    told.rhs(0.0, y.data(), f.data());
    ArrowJacobian by_colour(told, RhsPart::Whole), one_by_one(untold, RhsPart::Whole);
    ArrowMatrix arrow(by_colour.shape()), dense(one_by_one.shape());
    told.calls = untold.calls = 0;
    REQUIRE(by_colour(0.0, y.data(), f.data(), arrow) == Outcome::Ok);
    CHECK(y == before);
    REQUIRE(one_by_one(0.0, y.data(), f.data(), dense) == Outcome::Ok);
    const int sets = !ring ? 1 : n < 6 ? n : n % 3 == 0 ? 3 : 4;
    CHECK(told.calls == 2 * sets + 2 + 1);  // block, border, shares at the point
    CHECK(told.calls == by_colour.evaluations());
    CHECK(untold.calls == 2 * n + 2);
    double worst = 0.0;
    const auto blocks = told.blocks();
    for (int i = 0; i < told.controlled_size(); ++i) {
      for (int j = 0; j < told.controlled_size(); ++j) {
        const int way = std::abs(blocks[i] - blocks[j]);
        const bool apart = blocks[i] != kBorder && blocks[j] != kBorder &&
                           (ring ? std::min(way, n - way) > 1 : way > 0);
        const double value = apart ? 0.0 : arrow.at(i, j);
        worst = std::max(worst, std::abs(value - dense.at(i, j)));
      }
    }
    // Forward differences: rounding of rates of some 1e3 over steps of 1.5e-8 and more.
    CHECK(worst < 1e-4);
  }
}

TEST_CASE("Implicit methods: same path with and without the arrow", "[physics][integrators]") {
  for (const auto& [name, ring] : {std::pair{"cvode-bdf", false},
                                   {"arkode-dirk", false},
                                   {"arkode-imex", false},
                                   {"cvode-bdf", true},
                                   {"arkode-dirk", true}}) {
    Carrier told(12, ring), untold(12, ring);
    untold.hide_blocks();
    const auto a = make_stepper(name), b = make_stepper(name);
    for (auto [stepper, system] : {std::pair{a.get(), &told}, std::pair{b.get(), &untold}}) {
      stepper->start(*system, 0.0, system->start(), {.maximum = 0.1, .tolerance = 1e-5});
      run_to(*stepper, 2.0);
    }
    INFO(name << ": " << a->counters().steps << " steps, " << a->counters().evaluations << " and "
              << b->counters().evaluations << " evaluations");
    INFO("ring " << ring);
    CHECK(std::abs(a->counters().steps - b->counters().steps) <= b->counters().steps / 20);
    CHECK(distance(a->state(), {b->state().begin(), b->state().end()}) < 1e-4);  // ten tolerances
    if (std::string_view(name) != "arkode-imex")
      CHECK(a->counters().evaluations < b->counters().evaluations);
  }
}

TEST_CASE("Split with explicit positions → no gain of stability", "[physics][integrators]") {
  // Why the stiff part of a vibration holds its velocities as well: with the accelerations alone
  // every stage knows its positions before it solves for anything. A spring of 20 rad/s, steps of
  // 0.5 s: ten radians each.
  const auto spring = [](double, const double* y, double* f) {
    f[0] = y[1];
    f[1] = -400.0 * y[0];
    return EvalStatus::Ok;
  };
  const auto largest = [&](bool velocities) {
    Problem problem(2, 2, spring);
    problem.stiff = [&](double t, const double* y, double* f) {
      spring(t, y, f);
      if (!velocities) f[0] = 0.0;
      return EvalStatus::Ok;
    };
    const auto stepper = make_stepper("arkode-imex");
    stepper->start(problem, 0.0, std::vector<double>{1.0, 0.0},
                   {.initial = 0.5, .minimum = 0.5, .maximum = 0.5, .tolerance = 1e-3});
    double worst = 0.0;
    for (int i = 0; i < 3; ++i) {
      stepper->step(100.0);
      worst = std::max(worst, std::abs(stepper->state()[0]));
    }
    return worst;
  };
  CHECK(largest(true) < 1.01);
  CHECK(largest(false) > 1e3);
}

TEST_CASE("Implicit-explicit method: order four on both parts of a split",
          "[physics][integrators]") {
  // x'' = -k x (stiff) - 2 c x' (rest), k = 25: x = exp(-c t) cos(w t) with w² = k - c².
  const double k = 25.0, c = 0.3, w = std::sqrt(k - c * c);
  Problem problem(3, 2, [&](double, const double* y, double* f) {
    f[0] = y[1];
    f[1] = -k * y[0] - 2.0 * c * y[1];
    f[2] = y[0];
    return EvalStatus::Ok;
  });
  problem.stiff = [&](double, const double* y, double* f) {
    f[0] = y[1];
    f[1] = -k * y[0];
    f[2] = y[0];  // a quadrature has no place here: the stepper takes it with the rest
    return EvalStatus::Ok;
  };
  const auto exact = [&](double t) {
    const double e = std::exp(-c * t), cs = std::cos(w * t), s = std::sin(w * t);
    return std::vector<double>{e * cs, -e * (c * cs + w * s),
                               (c + e * (w * s - c * cs)) / k};  // ∫ exp(-ct) cos(wt), c² + w² = k
  };
  const auto stepper = make_stepper("arkode-imex");
  double error[2] = {0.0, 0.0};
  for (int i = 0; i < 2; ++i) {
    const double h = 0.02 / (1 << i);
    stepper->start(problem, 0.0, exact(0.0),
                   {.initial = h, .minimum = h, .maximum = h, .tolerance = 1e-11});
    for (int n = 1; n <= (100 << i); ++n) {
      stepper->step(2.0);
      if (n % (10 << i) == 0)
        error[i] = std::max(error[i], distance(stepper->state(), exact(stepper->time())));
    }
  }
  INFO("errors " << error[0] << ", " << error[1]);
  CHECK(error[0] < 1e-4);
  CHECK(std::log2(error[0] / error[1]) == Approx(4.0).margin(0.2));
}
