#include "integrators/stepper.hpp"

#include "integrators/embedded_runge_kutta.hpp"
#include "integrators/predictor_corrector.hpp"
#include "integrators/sundials_stepper.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace adore::integrators {
namespace {

using namespace std::string_view_literals;

constexpr std::array kNames = {
    "rkf1"sv,        "rkf2"sv,        "rkf3"sv,  "rkf4"sv,        "rkf5"sv,      "rkf6"sv,
    "rkf7"sv,        "pece1"sv,       "pece2"sv, "pece3"sv,       "pece4"sv,     "pece5"sv,
    "pece6"sv,       "pece7"sv,       "pece8"sv, "cvode-adams"sv, "cvode-bdf"sv, "arkode-erk"sv,
    "arkode-dirk"sv, "arkode-imex"sv, "rk4"sv};
constexpr int kFirstPece = 7;
constexpr int kFirstSundials = 15;

}  // namespace

EvalStatus OdeSystem::rhs_with_contributions(RhsPart part, double t, const double* y, double* dydt,
                                             double* shares) noexcept {
  const auto numbers = blocks();
  const auto border = std::count(numbers.begin(), numbers.end(), -1);
  const int last = numbers.empty() ? -1 : *std::max_element(numbers.begin(), numbers.end());
  std::fill_n(shares, border * (last + 1), 0.0);
  return part == RhsPart::Whole ? rhs(t, y, dydt) : rhs_stiff(t, y, dydt);
}

double OdeSystem::step_guard(double t) const noexcept {
  (void)t;
  return std::numeric_limits<double>::infinity();
}

std::string OdeSystem::component_name(int index) const {
  return "y[" + std::to_string(index) + "]";
}

std::span<const std::string_view> stepper_names() { return kNames; }

std::unique_ptr<Stepper> make_stepper(std::string_view name) {
  const auto found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end()) {
    std::string valid;
    for (const auto known : kNames) valid += (valid.empty() ? "" : ", ") + std::string(known);
    throw std::invalid_argument("there is no integrator \"" + std::string(name) +
                                "\"; valid names are " + valid);
  }
  if (name == "rk4") return std::make_unique<EmbeddedRungeKutta>(std::string(name), classical());
  const int index = static_cast<int>(found - kNames.begin());
  if (index < kFirstPece) {
    return std::make_unique<EmbeddedRungeKutta>(std::string(name), fehlberg(index + 1));
  }
  if (index < kFirstSundials) {
    return std::make_unique<PredictorCorrector>(std::string(name), index - kFirstPece + 1);
  }
  if (name == "cvode-adams") return make_cvode(name, CvodeMethod::Adams);
  if (name == "cvode-bdf") return make_cvode(name, CvodeMethod::Bdf);
  if (name == "arkode-erk") return make_arkode(name, ArkodeMethod::Explicit);
  if (name == "arkode-dirk") return make_arkode(name, ArkodeMethod::DiagonallyImplicit);
  return make_arkode(name, ArkodeMethod::ImplicitExplicit);
}

std::string_view name_of_int_met(int int_met) noexcept {
  if (int_met >= 1 && int_met <= 7) return kNames[int_met - 1];
  if (int_met >= 11 && int_met <= 18) return kNames[kFirstPece + int_met - 11];
  switch (int_met) {
    case 21:
      return "cvode-adams";
    case 22:
      return "cvode-bdf";
    case 31:
      return "arkode-erk";
    case 32:
      return "arkode-dirk";
    case 33:
      return "arkode-imex";
    case 41:
      return "rk4";
    default:
      return {};
  }
}

}  // namespace adore::integrators
