#pragma once

#include "core/dynamics/system_fixture.hpp"

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

/// Spectra of a bearing whose races have waves.
namespace adore::wave_record {

/// Force that the inner race puts on the bearing over time, with what turned meanwhile.
struct Record {
  std::vector<double> axial;
  std::vector<std::complex<double>> radial;                ///< y + i z
  double time = 0.0, step = 0.0, cage = 0.0, shaft = 0.0;  ///< [s], mean speeds [rad/s]

  /// Square of the amplitude of one frequency, under a Hann window.
  template <class Value>
  [[nodiscard]] static double power(const std::vector<Value>& of, double step, double frequency) {
    std::complex<double> sum = 0.0;
    double weight = 0.0;
    const auto n = static_cast<double>(of.size());
    for (std::size_t k = 0; k < of.size(); ++k) {
      const double window =
          0.5 - 0.5 * std::cos(2 * std::numbers::pi * (static_cast<double>(k) + 0.5) / n);
      sum += window * of[k] * std::polar(1.0, -frequency * step * static_cast<double>(k));
      weight += window;
    }
    return std::norm(sum / weight);
  }
};

template <class Value>
std::vector<Value> about_mean(std::vector<Value> values) {
  Value mean = 0.0;
  double weight = 0.0;
  const auto n = static_cast<double>(values.size());
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double window =
        0.5 - 0.5 * std::cos(2 * std::numbers::pi * (static_cast<double>(k) + 0.5) / n);
    mean += window * values[k];
    weight += window;
  }
  for (Value& value : values) value -= mean / weight;
  return values;
}

/// Of a system whose elements are in force balance (mode 1): their own vibration is not in it.
inline Record record_of(dynamics::System& system, double turns_of_cage) {
  std::vector<double> y = system.initial_state();
  fixture::Adapter adapter(system);
  system.set_start(0.0, y);
  system.between_steps(0.0, y);
  Record out;
  const scene::Snapshot start = system.snapshot(0.0, y);
  const double cage = start.elements[0].theta_dot;
  out.time = turns_of_cage * 2 * std::numbers::pi / std::abs(cage);
  constexpr int samples = 1024;
  out.step = out.time / samples;
  const auto stepper = integrators::make_stepper("rkf5");
  integrators::StepControl control;
  control.maximum = out.step;
  control.minimum = 1e-13;
  control.tolerance = 1e-5;
  stepper->start(adapter, 0.0, y, control);
  double first = 0.0, last = 0.0;
  for (int k = 0; k < samples; ++k) {
    const double until = (k + 0.5) * out.step;
    while (stepper->time() < until) stepper->step(until);
    const auto state = stepper->state();
    const scene::Snapshot s = system.snapshot(until, {state.data(), state.size()});
    out.axial.push_back(s.races[1].applied_force[0]);
    out.radial.emplace_back(s.races[1].applied_force[1], s.races[1].applied_force[2]);
    double theta = 0.0;
    for (const auto& ball : s.elements) theta += ball.theta;
    theta /= static_cast<double>(s.elements.size());
    (k == 0 ? first : last) = theta;
  }
  out.cage = (last - first) / ((samples - 1) * out.step);
  out.shaft = system.bearing().speed[1];
  return out;
}

/// Root of the mean square.
template <class Value>
double rms(const std::vector<Value>& of) {
  double sum = 0.0;
  for (const auto& v : of) sum += std::norm(v);
  return std::sqrt(sum / static_cast<double>(of.size()));
}

}  // namespace adore::wave_record
