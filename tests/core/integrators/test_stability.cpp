#include "core/integrators/problems.hpp"
#include "integrators/stability.hpp"
#include "integrators/stepper.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <string>

using namespace adore;
using namespace adore::integrators;

namespace {

/// y' = iω y as two real components, amplitude after constant steps.
struct Vibration {
  std::unique_ptr<Stepper> stepper;
  test::Problem problem{2, 2, [](double, const double* y, double* d) {
                          d[0] = -y[1];
                          d[1] = y[0];
                          return EvalStatus::Ok;
                        }};
  Vibration(const std::string& method, double phase) : stepper(make_stepper(method)) {
    StepControl control;
    control.minimum = control.maximum = phase;
    control.tolerance = 1e30;  // the method alone, whatever its error
    stepper->start(problem, 0.0, std::vector<double>{1.0, 0.0}, control);
  }
  double amplitude_after(int steps) {
    for (int i = 0; i < steps; ++i) (void)stepper->step(1e9);
    return std::hypot(stepper->state()[0], stepper->state()[1]);
  }
};

}  // namespace

TEST_CASE("Amplification per step: equal to that of the steppers for a vibration",
          "[physics][integrators]") {
  for (const std::string_view name : stepper_names()) {
    if (name.starts_with("cvode") || name == "arkode-imex") continue;
    for (const double phase : {0.15, 0.4, 0.7, 1.1}) {
      INFO(name << " at " << phase);
      const double factor = amplification(name, phase);
      // A start of higher order and parasitic roots die out before the ratio is taken.
      Vibration vibration(std::string(name), phase);
      const bool slow = factor > 0.98 && factor < 1.1;
      const int before = factor > 2.0 ? 40 : slow ? 4000 : 200, between = 40;
      const double first = vibration.amplitude_after(before);
      const double second = vibration.amplitude_after(between);
      CHECK(std::pow(second / first, 1.0 / between) == Approx(factor).epsilon(0.02));
      if (name.starts_with("rk") || name == "arkode-erk")
        CHECK(std::pow(second / first, 1.0 / between) == Approx(factor).epsilon(1e-9));
    }
  }
}

TEST_CASE("Amplification at small steps: leading term of the method", "[physics][integrators]") {
  // |R|² - 1 of rkf1: (255/512)² φ⁴ + (1 - 255/256) φ², of rkf4: (2/104 - 1/72) φ⁶.
  const double y = 0.05;
  CHECK(std::pow(amplification("rkf1", y), 2) - 1.0 ==
        Approx(y * y / 256.0 + std::pow(255.0 / 512.0, 2) * std::pow(y, 4)).epsilon(1e-6));
  const double z = 0.2;
  CHECK(std::pow(amplification("rkf4", z), 2) - 1.0 ==
        Approx((2.0 / 104.0 - 1.0 / 72.0) * std::pow(z, 6)).epsilon(0.02));
  // Trapezoid by one correction: |1 + z + z²/2 ...|: pece1 is 1 + z + z².
  CHECK(amplification("pece1", 0.3) == Approx(std::hypot(1.0 - 0.09, 0.3)).epsilon(1e-12));
}

TEST_CASE("Stability limits: those of the literature", "[physics][integrators]") {
  // rkf4 damps in a band only.
  CHECK(amplification("rkf4", 1.0) > 1.001);
  CHECK(amplification("rkf4", 2.6) < 1.0);
  CHECK(amplification("rkf4", 3.3) > 1.0);
  // The classical method damps up to 2 sqrt(2).
  for (const double phase : {0.1, 1.0, 2.0, 2.82}) CHECK(amplification("rk4", phase) < 1.0);
  CHECK(amplification("rk4", 2.8284) == Approx(1.0).margin(1e-3));
  CHECK(amplification("rk4", 2.84) > 1.0);
  // Backward differences: A-stable up to order 2, and no further.
  for (const double phase : {0.01, 0.3, 1.0, 10.0, 1000.0}) {
    CHECK(amplification("cvode-bdf", phase, 1) < 1.0);
    CHECK(amplification("cvode-bdf", phase, 2) < 1.0);
    CHECK(amplification("arkode-dirk", phase) < 1.0);
    CHECK(amplification("arkode-imex", phase) < 1.0);
  }
  CHECK(amplification("cvode-bdf", 1.0, 3) > 1.0);
  CHECK(amplification("cvode-bdf", 1.0, 4) > 1.1);
  // Backward Euler and BDF2 have closed forms.
  CHECK(amplification("cvode-bdf", 2.0, 1) == Approx(1.0 / std::sqrt(5.0)).epsilon(1e-12));
  // Dormand-Prince on the imaginary axis: to about 0.94 and, weakly unstable, beyond.
  CHECK(amplification("arkode-erk", 0.9) < 1.0);
  CHECK(amplification("arkode-erk", 1.1) > 1.0);
  CHECK_THROWS(amplification("euler", 1.0));
}
