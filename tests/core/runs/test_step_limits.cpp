#include "integrators/stability.hpp"
#include "integrators/stepper.hpp"
#include "runs/step_limits.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <string>

using namespace adore;
using namespace adore::runs;

namespace {

/// One turn in which a contact vibrates 450 times, as in a ball bearing at 10,000 rpm.
constexpr double kOmega = 2800.0, kTurn = 1.0;

StepRequest request_of(const std::string& method, double shortest, double longest) {
  StepRequest out;
  out.method = method;
  out.minimum = shortest / kOmega;
  out.maximum = longest / kOmega;
  out.turn = kTurn;
  out.bands = {{"along", 0.9 * kOmega, kOmega}, {"across", 0.1 * kOmega, 0.12 * kOmega}};
  return out;
}

class Vibration final : public integrators::OdeSystem {
 public:
  explicit Vibration(double omega) : omega_(omega), scales_{1.0, omega} {}
  [[nodiscard]] int size() const noexcept override { return 2; }
  [[nodiscard]] int controlled_size() const noexcept override { return 2; }
  [[nodiscard]] std::span<const double> scales() const noexcept override { return scales_; }
  integrators::EvalStatus rhs(double, const double* y, double* d) noexcept override {
    d[0] = y[1];
    d[1] = -omega_ * omega_ * y[0];
    return integrators::EvalStatus::Ok;
  }
  [[nodiscard]] bool has_stiff_part() const noexcept override { return true; }
  integrators::EvalStatus rhs_stiff(double t, const double* y, double* d) noexcept override {
    return rhs(t, y, d);
  }
  [[nodiscard]] double amplitude(std::span<const double> y) const {
    return std::hypot(y[0], y[1] / omega_);
  }

 private:
  double omega_;
  std::array<double, 2> scales_;
};

/// Factor by which a vibration far below the tolerance changes in a turn.
double growth_by_stepper(const std::string& method, const StepLimits& limits, double omega) {
  Vibration system(omega);
  const auto stepper = integrators::make_stepper(method);
  integrators::StepControl control;
  control.minimum = limits.minimum;
  control.maximum = limits.maximum;
  control.highest_order = limits.highest_order;
  control.tolerance = 1.0;
  const double start = 1e-6;
  stepper->start(system, 0.0, std::vector<double>{start, 0.0}, control);
  while (stepper->time() < kTurn) (void)stepper->step(kTurn);
  return system.amplitude(stepper->state()) / start;
}

}  // namespace

TEST_CASE(
    "Step limits: no method lets a vibration grow; limits of the deck are changed only if it would",
    "[physics][runs]") {
  for (const std::string_view name : integrators::stepper_names()) {
    const std::string method(name);
    const StepRequest request = request_of(method, 1e-3, 0.7);
    const StepLimits limits = stable_step_limits(request);
    INFO(step_limits_text(request, limits, 1.0 / kOmega));
    CHECK(limits.minimum <= limits.maximum);
    CHECK(limits.growth <= kGrowthPerTurn);
    if (limits.action == StepAction::Refused) {
      CHECK(method == "rkf1");
      continue;
    }
    for (const double omega : {kOmega, 0.95 * kOmega, 0.11 * kOmega})
      CHECK(growth_by_stepper(method, limits, omega) <= kGrowthPerTurn * 1.001);
    if (limits.action == StepAction::Kept) continue;
    CHECK(limits.growth_asked > kGrowthPerTurn);
    StepLimits asked;
    asked.minimum = request.minimum;
    asked.maximum = request.maximum;
    // CVODE picks orders as it sees fit, and pece3 damps at the longest step but not below it.
    if (method.starts_with("cvode") || method == "pece3") continue;
    CHECK(growth_by_stepper(method, asked, limits.frequency) > kGrowthPerTurn);
  }
}

TEST_CASE("Step limits: damping that a method cannot follow → shorter steps",
          "[physics][runs][damping]") {
  // λ = (-ζ ± √(ζ² - 1)) ω for ζ = 2: the fast decay is 3.73 times as fast as ω.
  const auto limits_of = [](const char* method, double damping) {
    StepRequest request = request_of(method, 1e-3, 1.7);
    request.bands = {{"along", 0.9 * kOmega, kOmega}};
    if (damping > 0.0) request.bands.push_back({"along, damped", 0.9 * kOmega, kOmega, damping});
    return stable_step_limits(request);
  };
  const double fast = 2.0 + std::sqrt(3.0);
  for (const auto& [method, reach] : {std::pair{"rk4", 2.785}, {"rkf5", 0.0}, {"pece2", 0.0}}) {
    INFO(method);
    const StepLimits elastic = limits_of(method, 0.0), damped = limits_of(method, 2.0);
    CHECK(damped.action == StepAction::Shortened);
    CHECK(damped.maximum < elastic.maximum);
    CHECK(damped.growth <= kGrowthPerTurn);
    if (reach > 0.0) CHECK(damped.maximum * kOmega * fast == Approx(reach).epsilon(0.07));
    // What the limits allow does not grow, what is above does.
    const double phase = damped.maximum * kOmega;
    CHECK(integrators::amplification(method, phase, integrators::kOwnOrder, 2.0) <= 1.0);
    CHECK(integrators::amplification(method, 1.7, integrators::kOwnOrder, 2.0) > 1.0);
  }
  CHECK(limits_of("arkode-dirk", 2.0).action == StepAction::Kept);
  // Weak damping changes nothing for a method that reaches far to the left, too.
  CHECK(limits_of("rk4", 0.2).action == StepAction::Kept);
}

TEST_CASE("Step limits: methods that damp at the usual step → unchanged", "[unit][runs]") {
  const auto action = [](const char* method) {
    return stable_step_limits(request_of(method, 1e-3, 0.7)).action;
  };
  for (const char* method : {"rkf2", "rkf5", "rkf6", "rkf7", "rk4", "pece1", "pece2", "arkode-erk",
                             "arkode-dirk", "arkode-imex"}) {
    INFO(method);
    CHECK(action(method) == StepAction::Kept);
  }
  for (const char* method : {"rkf3", "rkf4", "pece4", "pece8"}) {
    INFO(method);
    CHECK(action(method) == StepAction::Shortened);
  }
  CHECK(action("rkf1") == StepAction::Refused);
  const StepLimits bdf = stable_step_limits(request_of("cvode-bdf", 1e-3, 0.7));
  CHECK(bdf.action == StepAction::OrderHeld);
  CHECK(bdf.highest_order == 2);
  CHECK(bdf.maximum == 0.7 / kOmega);
}

TEST_CASE("Step limits: constant step → nearest stable one, also up into a stable band",
          "[unit][runs]") {
  // rkf4 damps from hω = 2.37 to 3.2 and, slow enough, below 0.3.
  StepRequest request = request_of("rkf4", 2.2, 2.2);
  request.bands.pop_back();
  request.bands[0].lowest = 0.98 * kOmega;
  const StepLimits up = stable_step_limits(request);
  CHECK(up.action == StepAction::Lengthened);
  CHECK(up.minimum == up.maximum);
  CHECK(up.maximum * kOmega > 2.35);
  CHECK(up.maximum * kOmega < 2.6);
  CHECK(growth_by_stepper("rkf4", up, kOmega) <= kGrowthPerTurn);
  request.minimum = request.maximum = 0.4 / kOmega;
  const StepLimits down = stable_step_limits(request);
  CHECK(down.action == StepAction::Shortened);
  CHECK(down.minimum == down.maximum);
  CHECK(down.maximum * kOmega < 0.4);
  CHECK(down.maximum * kOmega > 0.2);
}

TEST_CASE("Step limits: changes are reported with frequency and factor", "[unit][runs]") {
  const StepRequest request = request_of("rkf4", 1e-3, 0.7);
  const std::string text = step_limits_text(request, stable_step_limits(request), 1.0 / kOmega);
  INFO(text);
  CHECK(text.find("rkf4") == 0);
  CHECK(text.find("Hz (along)") != std::string::npos);
  CHECK(text.find("The run uses steps of up to") != std::string::npos);
  const auto keep = find_stable_methods(request);
  CHECK(std::find(keep.begin(), keep.end(), "rkf5") != keep.end());
  CHECK(std::find(keep.begin(), keep.end(), "rkf4") == keep.end());
  StepRequest idle = request;
  idle.bands.clear();
  CHECK(stable_step_limits(idle).action == StepAction::Kept);
}

TEST_CASE("Step limits: method without constant steps → never given one", "[unit][runs]") {
  // A least step that is longer than what lets no vibration grow left the two equal.
  for (const std::string_view name : integrators::stepper_names()) {
    const std::string method(name);
    if (integrators::make_stepper(method)->can_hold_constant_step()) continue;
    for (const double shortest : {1e-3, 0.1, 0.5, 0.9, 3.0, 20.0})
      for (const double longest : {21.0, 100.0, 1000.0}) {
        const StepLimits limits = stable_step_limits(request_of(method, shortest, longest));
        CAPTURE(method, shortest, longest);
        if (limits.action == StepAction::Refused) continue;
        CHECK(limits.minimum < limits.maximum);
        CHECK(limits.growth <= kGrowthPerTurn * (1.0 + 1e-9));
      }
  }
}

TEST_CASE(
    "Growth of a slow bearing is counted over 1e5 periods: no step limit goes to zero with speed",
    "[physics][runs]") {
  StepRequest request = request_of("rkf5", 1e-3, 0.5);
  request.turn = kCountedPeriods * 2.0 * std::numbers::pi / kOmega;
  const StepLimits slow = stable_step_limits(request);
  request.turn *= 1e6;
  const StepLimits slower = stable_step_limits(request);
  CHECK(slower.action == slow.action);
  CHECK(slower.maximum == slow.maximum);
  CHECK(slower.maximum > 0.1 / kOmega);
  CHECK(step_limits_text(request, slower, 1.0 / kOmega).find("in 100000 periods") !=
        std::string::npos);
}

TEST_CASE("stable_step_limits(): constant steps far below the contact period -> kept", "[unit]") {
  for (const std::string_view name : integrators::stepper_names()) {
    // CVODE has no constant steps; methods of order 1 let vibrations grow at any step.
    if (name.starts_with("cvode") || name == "rkf1" || name == "pece1") continue;
    INFO(name);
    for (const double phase : {1e-4, 7e-6, 1e-8})
      CHECK(stable_step_limits(request_of(std::string(name), phase, phase)).action ==
            StepAction::Kept);
  }
}
