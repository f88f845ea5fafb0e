#include "integrators/predictor_corrector.hpp"
#include "integrators/tableau.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace adore::integrators;

namespace {

/// A rooted tree, written as its branches; every tree of an order appears once.
struct Tree {
  std::vector<int> branches;  ///< indices into the list of all trees, not increasing
  int order = 1;
  double gamma = 1.0;  ///< density: order times the densities of the branches
};

std::vector<Tree> trees_up_to(int most) {
  std::vector<Tree> all{Tree{}};
  std::vector<std::size_t> end_of_order{0, 1};  // trees of order n are [end[n-1], end[n])
  for (int n = 2; n <= most; ++n) {
    std::vector<Tree> found;
    std::vector<int> branches;
    const auto grow = [&](auto&& self, int left, int largest) -> void {
      if (left == 0) {
        Tree tree{branches, n, static_cast<double>(n)};
        for (const int b : branches) tree.gamma *= all[b].gamma;
        found.push_back(tree);
        return;
      }
      for (int b = largest; b >= 0; --b) {
        if (all[b].order > left) continue;
        branches.push_back(b);
        self(self, left - all[b].order, b);
        branches.pop_back();
      }
    };
    grow(grow, n - 1, static_cast<int>(all.size()) - 1);
    all.insert(all.end(), found.begin(), found.end());
    end_of_order.push_back(all.size());
  }
  return all;
}

/// Elementary weights of all trees at every stage: Φ_i(t) = Π over branches of Σ_j a_ij
/// Φ_j(branch).
std::vector<std::vector<double>> stage_weights(const Tableau& tableau,
                                               const std::vector<Tree>& trees) {
  std::vector<std::vector<double>> phi;
  for (const Tree& tree : trees) {
    std::vector<double> value(tableau.stages, 1.0);
    for (const int b : tree.branches) {
      for (int i = 0; i < tableau.stages; ++i) {
        double sum = 0.0;
        for (int j = 0; j < i; ++j) sum += tableau.a[i][j] * phi[b][j];
        value[i] *= sum;
      }
    }
    phi.push_back(value);
  }
  return phi;
}

/// Largest |Σ b_i Φ_i(t) - 1/γ(t)| over the trees of one order.
double defect(const std::array<double, kMaxStages>& b, int order, const Tableau& tableau,
              const std::vector<Tree>& trees, const std::vector<std::vector<double>>& phi) {
  double worst = 0.0;
  for (std::size_t t = 0; t < trees.size(); ++t) {
    if (trees[t].order != order) continue;
    double sum = 0.0;
    for (int i = 0; i < tableau.stages; ++i) sum += b[i] * phi[t][i];
    worst = std::max(worst, std::abs(sum - 1.0 / trees[t].gamma));
  }
  return worst;
}

}  // namespace

TEST_CASE("Rooted trees: numbers of the literature", "[unit][integrators]") {
  const auto trees = trees_up_to(8);
  const long expected[] = {1, 1, 2, 4, 9, 20, 48, 115};
  for (int n = 1; n <= 8; ++n) {
    CHECK(std::count_if(trees.begin(), trees.end(), [&](const Tree& t) { return t.order == n; }) ==
          expected[n - 1]);
  }
}

TEST_CASE("Fehlberg pairs: both weights meet all conditions of their order and no more",
          "[unit][integrators]") {
  const auto trees = trees_up_to(8);
  for (int p = 1; p <= 7; ++p) {
    const Tableau& tableau = fehlberg(p);
    const auto phi = stage_weights(tableau, trees);
    INFO("order " << p);
    REQUIRE(tableau.order == p);
    // Rounding of sums with terms up to about 30 in size: 1e-13 is some ten units in the last
    // place.
    for (int n = 1; n <= p; ++n) CHECK(defect(tableau.b, n, tableau, trees, phi) < 1e-13);
    for (int n = 1; n <= p + 1; ++n) CHECK(defect(tableau.b_high, n, tableau, trees, phi) < 1e-13);
    // The propagated solution is of order p exactly; the smallest leading defect of the seven is
    // that of order 7.
    CHECK(defect(tableau.b, p + 1, tableau, trees, phi) > 1e-6);
  }
}

TEST_CASE("Classical method: order 4 exactly, estimate of order 3", "[unit][integrators]") {
  const auto trees = trees_up_to(5);
  const Tableau& tableau = classical();
  const auto phi = stage_weights(tableau, trees);
  for (int n = 1; n <= 4; ++n) CHECK(defect(tableau.b, n, tableau, trees, phi) < 1e-15);
  CHECK(defect(tableau.b, 5, tableau, trees, phi) > 1e-3);
  for (int n = 1; n <= 3; ++n) CHECK(defect(tableau.b_high, n, tableau, trees, phi) < 1e-15);
  CHECK(defect(tableau.b_high, 4, tableau, trees, phi) > 1e-3);
  CHECK(tableau.error_order() == 4);
  CHECK(fehlberg(4).error_order() == 5);
  for (int i = 0; i < tableau.stages; ++i) {
    CHECK(tableau.a[tableau.stages - 1][i] == tableau.b[i]);
    double sum = 0.0;
    for (int j = 0; j < i; ++j) sum += tableau.a[i][j];
    CHECK(sum == Approx(tableau.c[i]).margin(1e-15));
  }
}

TEST_CASE("Fehlberg pairs: rows sum to the nodes, and the last row is as declared",
          "[unit][integrators]") {
  for (int p = 1; p <= 7; ++p) {
    const Tableau& tableau = fehlberg(p);
    bool last_is_b = tableau.b[tableau.stages - 1] == 0.0;
    for (int i = 0; i < tableau.stages; ++i) {
      double sum = 0.0;
      for (int j = 0; j < tableau.stages; ++j) sum += tableau.a[i][j];
      CHECK(std::abs(sum - tableau.c[i]) < 1e-13);  // as above
      last_is_b = last_is_b && tableau.a[tableau.stages - 1][i] == tableau.b[i];
    }
    CHECK(tableau.last_stage_is_end == last_is_b);
  }
  CHECK_THROWS_WITH(fehlberg(8), Catch::Contains("orders 1 to 7"));
}

TEST_CASE("Fehlberg pairs of order 5 to 7: no error in a pure quadrature", "[unit][integrators]") {
  // Why OdeSystem::step_guard exists. The difference of the weights, gathered by node, vanishes.
  for (int p = 1; p <= 7; ++p) {
    const Tableau& tableau = fehlberg(p);
    double seen = 0.0;
    for (int i = 0; i < tableau.stages; ++i) {
      double at_node = 0.0;
      for (int j = 0; j < tableau.stages; ++j) {
        if (tableau.c[j] == tableau.c[i]) at_node += tableau.b[j] - tableau.b_high[j];
      }
      seen = std::max(seen, std::abs(at_node));
    }
    CHECK((seen < 1e-15) == (p >= 5));
    // The second opinion exists just there; it sees no polynomial below its degree and the next one
    // well.
    const auto q = quadrature_error_weights(tableau);
    const int nodes = p < 5 ? 0 : p == 5 ? 5 : p == 6 ? 6 : 7;
    CHECK(std::count_if(q.begin(), q.end(), [](double w) { return w != 0.0; }) == nodes);
    for (int degree = 0; degree < nodes; ++degree) {
      double sum = 0.0;
      for (int i = 0; i < tableau.stages; ++i) sum += q[i] * std::pow(tableau.c[i], degree);
      CHECK((std::abs(sum) < 1e-13) == (degree < nodes - 1));
    }
  }
}

TEST_CASE("Adams weights: classical formulas on an even grid", "[unit][integrators]") {
  const double times[] = {3.0, 2.5, 2.0, 1.5, 1.0, 0.5, 0.0, -0.5};
  // Bashforth 4 and Moulton 4: (55, -59, 37, -9)/24 and 9/24 on the newest value.
  const AdamsWeights four = adams_weights(times, 4, 0.5);
  const double bashforth[] = {55.0 / 24, -59.0 / 24, 37.0 / 24, -9.0 / 24};
  for (int j = 0; j < 4; ++j) CHECK(four.predict[j] == Approx(bashforth[j]).epsilon(1e-13));
  CHECK(four.correct == Approx(9.0 / 24).epsilon(1e-13));
  CHECK(four.correct_higher == Approx(251.0 / 720).epsilon(1e-13));
  CHECK(adams_weights(times, 8, 0.5).correct_higher == Approx(1070017.0 / 3628800).epsilon(1e-12));
}

TEST_CASE("Adams weights: polynomials integrated exactly on an uneven grid",
          "[unit][integrators]") {
  const double times[] = {1.0, 0.93, 0.7, 0.55, 0.2, 0.15, -0.4, -0.6};
  const double h = 0.37;
  for (int k = 1; k <= 8; ++k) {
    const AdamsWeights w = adams_weights(times, k, h);
    for (int degree = 0; degree <= k; ++degree) {
      const auto f = [&](double t) { return std::pow(t, degree); };
      const double exact =
          (std::pow(1.0 + h, degree + 1) - std::pow(1.0, degree + 1)) / (degree + 1);
      double predicted = 0.0;
      double extrapolated = 0.0;
      for (int j = 0; j < k; ++j) {
        predicted += h * w.predict[j] * f(times[j]);
        extrapolated += w.extrapolate[j] * f(times[j]);
      }
      const double surprise = f(1.0 + h) - extrapolated;
      INFO("order " << k << ", degree " << degree);
      // The corrector of order k is exact to degree k - 1, the one above to degree k. Weights reach
      // some hundreds on this grid, hence 1e-11.
      if (degree < k) CHECK(std::abs(predicted + h * w.correct * surprise - exact) < 1e-11);
      CHECK(std::abs(predicted + h * w.correct_higher * surprise - exact) < 1e-11);
      if (degree == k) CHECK(std::abs(predicted + h * w.correct * surprise - exact) > 1e-7);
    }
  }
}
