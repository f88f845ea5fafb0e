#include "validation/run_down.hpp"

#include "base/errors.hpp"
#include "results/h5_reader.hpp"
#include "runs/run.hpp"
#include "runs/temporary_folder.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace adore::validation {
namespace {

constexpr double kRpm = std::numbers::pi / 30.0;

/// Seconds from the last speed to the first: J ∫ dω/T by the trapezoidal rule.
double time_down(const std::vector<TorqueAtSpeed>& at, double inertia) {
  double sum = 0.0;
  for (std::size_t k = 1; k < at.size(); ++k)
    sum += 0.5 * (at[k].speed - at[k - 1].speed) * (1.0 / at[k].total + 1.0 / at[k - 1].total);
  return inertia * sum;
}

/// Of both races at the last stored step.
double at_the_end(const results::H5Reader& file, const char* channel) {
  const std::vector<double> values = file.read(channel);
  return values.at(values.size() - 2) + values.back();
}

/// n of -dω/dt ~ ωⁿ from speeds that fall over the steps of a run.
double exponent_of(const std::vector<double>& time, const std::vector<double>& speed) {
  constexpr int kIntervals = 24;
  // The first hundredth is the start: the balls find their slip.
  const double from = 0.99 * speed.front(), to = speed.back();
  const double ratio = std::pow(to / from, 1.0 / kIntervals);
  std::vector<double> at, rate;
  double before = 0.0, wanted = from;
  int found = 0;
  for (std::size_t k = 1; k < time.size(); ++k)
    while (found <= kIntervals && speed[k] <= wanted * (1.0 + 1e-12)) {
      const double share = (speed[k - 1] - wanted) / (speed[k - 1] - speed[k]);
      const double t = time[k - 1] + share * (time[k] - time[k - 1]);
      if (found > 0) {
        at.push_back(wanted / std::sqrt(ratio));
        rate.push_back(wanted * (1.0 / ratio - 1.0) / (t - before));
      }
      before = t;
      wanted *= ratio;
      ++found;
    }
  if (at.size() < 3)
    throw SolverError("the speed of the disc does not decrease enough to compute the exponent");
  return fit_power_exponent(at, rate);
}

}  // namespace

double fit_power_exponent(const std::vector<double>& x, const std::vector<double>& y) {
  const auto n = static_cast<double>(x.size());
  double u = 0.0, v = 0.0, uu = 0.0, uv = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double a = std::log(x[k]), b = std::log(y[k]);
    u += a;
    v += b;
    uu += a * a;
    uv += a * b;
  }
  return (n * uv - u * v) / (n * uu - u * u);
}

RunDown run_down(const runs::DeckRequest& moving, const std::vector<TorqueAtSpeed>& at,
                 double inertia) {
  const runs::TemporaryFolder folder;
  const std::filesystem::path routine = folder.path() / "rolling.json";
  runs::RunRequest request;
  static_cast<runs::DeckRequest&>(request) = moving;
  request.changes.emplace_back("rpm2", fmt::format("{:#.12g}", at.back().speed / kRpm));
  request.changes.emplace_back("raceMIx2", fmt::format("{:#.12g}", inertia));
  request.out = folder.path() / "run";
  request.until = fmt::format("{:.12g}s", time_down(at, inertia));
  const runs::RunOutcome outcome = runs::run(request);
  if (outcome.status != runs::RunStatus::Done) throw SolverError(outcome.message);
  const results::H5Reader file(*request.out / "RESULTS.h5");
  const std::vector<double> both = file.read("race.angular_velocity");  // outer, inner
  std::vector<double> speed;
  for (std::size_t k = 1; k < both.size(); k += 2) speed.push_back(both[k]);
  RunDown out;
  out.exponent = exponent_of(file.read("time"), speed);
  out.time = outcome.time;
  out.end_speed = speed.back();
  out.energy_residual = std::abs(outcome.energy_residual) / outcome.energy_scale;
  const double rolling = at_the_end(file, "energy.rolling_heat");
  out.rolling = rolling / (rolling + at_the_end(file, "energy.heat"));
  out.steps = outcome.steps;
  return out;
}

}  // namespace adore::validation
