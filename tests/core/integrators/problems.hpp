#pragma once

#include "integrators/stepper.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

/// Small systems with known answers, shared by the tests of the steppers.
namespace adore::test {

using integrators::EvalStatus;

class Problem final : public integrators::OdeSystem {
 public:
  using Function = std::function<EvalStatus(double, const double*, double*)>;
  Problem(int size, int controlled, Function f)
      : size_(size), scales_(static_cast<std::size_t>(controlled), 1.0), f_(std::move(f)) {}

  [[nodiscard]] int size() const noexcept override { return size_; }
  [[nodiscard]] int controlled_size() const noexcept override {
    return static_cast<int>(scales_.size());
  }
  [[nodiscard]] std::span<const double> scales() const noexcept override { return scales_; }
  EvalStatus rhs(double t, const double* y, double* dydt) noexcept override {
    last_t = std::max(last_t, t);
    return f_(t, y, dydt);
  }
  [[nodiscard]] bool has_stiff_part() const noexcept override { return static_cast<bool>(stiff); }
  EvalStatus rhs_stiff(double t, const double* y, double* dydt) noexcept override {
    return stiff(t, y, dydt);
  }
  bool project(double t, double* y) noexcept override { return projection && projection(t, y); }
  [[nodiscard]] double step_guard(double t) const noexcept override {
    return guard ? guard(t) : std::numeric_limits<double>::infinity();
  }
  [[nodiscard]] std::string component_name(int i) const override {
    return "quantity<" + std::to_string(i) + ">";
  }

  Function stiff;
  std::function<bool(double, double*)> projection;
  std::function<double(double)> guard;
  double last_t = -1e300;  ///< latest time at which the right-hand side was asked

 private:
  int size_;
  std::vector<double> scales_;
  Function f_;
};

/// Kepler orbit of eccentricity 0.3 with unit semi-axis; the forces are its "stiff" part.
inline constexpr double kEccentricity = 0.3;
inline Problem kepler() {
  Problem p(4, 4, [](double, const double* y, double* f) {
    const double r2 = y[0] * y[0] + y[1] * y[1];
    const double r3 = r2 * std::sqrt(r2);
    f[0] = y[2];
    f[1] = y[3];
    f[2] = -y[0] / r3;
    f[3] = -y[1] / r3;
    return EvalStatus::Ok;
  });
  p.stiff = [](double, const double* y, double* f) {
    const double r2 = y[0] * y[0] + y[1] * y[1];
    const double r3 = r2 * std::sqrt(r2);
    f[0] = f[1] = 0.0;
    f[2] = -y[0] / r3;
    f[3] = -y[1] / r3;
    return EvalStatus::Ok;
  };
  return p;
}
inline std::vector<double> kepler_exact(double t) {
  const double e = kEccentricity;
  double E = t;
  for (int i = 0; i < 60; ++i) E -= (E - e * std::sin(E) - t) / (1.0 - e * std::cos(E));
  const double b = std::sqrt(1.0 - e * e);
  const double rate = 1.0 / (1.0 - e * std::cos(E));
  return {std::cos(E) - e, b * std::sin(E), -std::sin(E) * rate, b * std::cos(E) * rate};
}

/// Unit mass falling on a Hertz spring: y'' = -1 + 1e4 max(0, -y)^1.5, from y = 1. The contact is
/// C1 at y = 0 and its frequency there is some tens of that of the fall. Component 2 is a
/// quadrature: the work of gravity.
inline Problem bouncing_mass() {
  const auto contact = [](double y) {
    const double d = std::max(0.0, -y);
    return 1e4 * d * std::sqrt(d);
  };
  Problem p(3, 2, [contact](double, const double* y, double* f) {
    f[0] = y[1];
    f[1] = -1.0 + contact(y[0]);
    f[2] = -y[1];
    return EvalStatus::Ok;
  });
  p.stiff = [contact](double, const double* y, double* f) {
    f[0] = f[2] = 0.0;
    f[1] = contact(y[0]);
    return EvalStatus::Ok;
  };
  return p;
}

/// Quaternion (w, x, y, z) under a constant body rate, kept at unit norm by projection; exact
/// solution beside it.
inline constexpr double kRate[3] = {0.7, -1.1, 0.4};
inline Problem rotation() {
  Problem p(4, 4, [](double, const double* q, double* f) {
    const double a = kRate[0], b = kRate[1], c = kRate[2];
    f[0] = 0.5 * (-q[1] * a - q[2] * b - q[3] * c);
    f[1] = 0.5 * (q[0] * a + q[2] * c - q[3] * b);
    f[2] = 0.5 * (q[0] * b + q[3] * a - q[1] * c);
    f[3] = 0.5 * (q[0] * c + q[1] * b - q[2] * a);
    return EvalStatus::Ok;
  });
  p.stiff = [](double, const double* q, double* f) {
    f[0] = -0.5 * q[1] * kRate[0];
    f[1] = 0.5 * q[0] * kRate[0];
    f[2] = f[3] = 0.0;
    return EvalStatus::Ok;
  };
  p.projection = [](double, double* q) {
    const double norm = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    if (norm == 1.0) return false;
    for (int i = 0; i < 4; ++i) q[i] /= norm;
    return true;
  };
  return p;
}
inline std::vector<double> rotation_exact(double t) {
  const double w = std::sqrt(kRate[0] * kRate[0] + kRate[1] * kRate[1] + kRate[2] * kRate[2]);
  const double s = std::sin(0.5 * w * t) / w;
  return {std::cos(0.5 * w * t), s * kRate[0], s * kRate[1], s * kRate[2]};
}

inline double distance(std::span<const double> a, const std::vector<double>& b) {
  double worst = 0.0;
  for (std::size_t i = 0; i < b.size(); ++i) worst = std::max(worst, std::abs(a[i] - b[i]));
  return worst;
}

/// Integrates to t_end; returns the number of steps.
inline long run_to(integrators::Stepper& stepper, double t_end) {
  long steps = 0;
  for (; stepper.time() < t_end; ++steps) stepper.step(t_end);
  return steps;
}

/// Design order in terms of how the global error follows the tolerance (variable-order methods
/// follow it directly).
inline double tolerance_exponent(const integrators::Stepper& stepper) {
  const double p = stepper.name().starts_with("cvode") ? 3.0 : stepper.order();
  return p / (p + 1.0);
}

}  // namespace adore::test
