#include "validation/trajectory.hpp"

#include "base/errors.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <memory>

namespace adore::validation {
namespace {

void count_start(StepperWork& work, const integrators::Stepper& stepper) {
  work.start_evaluations += stepper.counters().evaluations;
}
void count(StepperWork& work, const integrators::Stepper& stepper) {
  const integrators::Counters& counters = stepper.counters();
  work.add({0, counters.steps, counters.rejected, counters.evaluations});
}

/// The solution from a known point to a later time, by a separate stepper.
State advance(const Problem& problem, double t0, const State& y0, double t, StepperWork& work) {
  if (t <= t0) return y0;
  const auto stepper = integrators::make_stepper(problem.stepper);
  integrators::StepControl control;
  control.initial = t - t0;
  control.maximum = t - t0;
  control.tolerance = problem.tolerance;
  stepper->start(problem.system, t0, y0, control);
  count_start(work, *stepper);
  while (stepper->time() < t) (void)stepper->step(t);
  count(work, *stepper);
  const auto y = stepper->state();
  return {y.begin(), y.end()};
}

class Solver {
 public:
  Solver(const Problem& problem, std::span<const double> times) : problem_(problem), times_(times) {
    demand(!times.empty(), "a problem needs times");
    control_.tolerance = problem.tolerance;
    const double whole = times.back() - times.front();
    control_.maximum =
        problem.longest_step > 0.0 ? problem.longest_step : std::max(0.1 * whole, 1e-300);
  }

  Solution run() {
    t_ = times_.front();
    y_ = problem_.start;
    solution_.samples.push_back(y_);
    for (const auto& event : problem_.events) sign_.push_back(sign(event(t_, y_.data())));
    restart();
    for (std::size_t i = 1; i < times_.size(); ++i) {
      while (t_ < times_[i])
        if (!step(times_[i])) return finish();
      solution_.samples.push_back(y_);
    }
    return finish();
  }

 private:
  Solution finish() {
    if (stepper_) count(solution_.work, *stepper_);
    return std::move(solution_);
  }

  static int sign(double value) { return (value > 0.0) - (value < 0.0); }

  void restart() {
    if (stepper_) count(solution_.work, *stepper_);
    stepper_.reset();
    if (!(t_ < times_.back())) return;
    stepper_ = integrators::make_stepper(problem_.stepper);
    stepper_->start(problem_.system, t_, y_, control_);
    count_start(solution_.work, *stepper_);
  }

  /// False when an event ended the solution.
  bool step(double t_stop) {
    (void)stepper_->step(t_stop);
    const double t = stepper_->time();
    const State y(stepper_->state().begin(), stepper_->state().end());
    int first = -1;
    double when = t;
    State at;
    for (std::size_t k = 0; k < problem_.events.size(); ++k) {
      const int now = sign(problem_.events[k](t, y.data()));
      if (sign_[k] == 0) sign_[k] = now;  // started on the event: the first step decides
      if (now == 0 || now == sign_[k]) continue;
      State candidate;
      const double root = locate(k, t, candidate);
      if (first >= 0 && root >= when) continue;
      first = static_cast<int>(k);
      when = root;
      at = std::move(candidate);
    }
    if (first < 0) {
      t_ = t;
      y_ = y;
      return true;
    }
    t_ = when;
    y_ = std::move(at);
    const auto k = static_cast<std::size_t>(first);
    sign_[k] = -sign_[k];
    solution_.events.push_back({first, t_, sign_[k] > 0, y_});
    if (problem_.at_event && problem_.at_event(first, t_, y_)) return false;
    restart();
    return true;
  }

  /// Root of event k in (t_, t_end], on the far side of the sign change. Illinois iteration on
  /// exact re-integration.
  double locate(std::size_t k, double t_end, State& y) {
    const auto& event = problem_.events[k];
    double a = t_, b = t_end;
    State y_b = advance(problem_, t_, y_, b, solution_.work);
    double fa = event(a, y_.data()), fb = event(b, y_b.data());
    if (sign(fa) != sign_[k]) fa = 1e-3 * sign_[k] * std::abs(fb);  // stands on the event itself
    const double width = 4e-16 * std::max(std::abs(t_end), times_.back() - times_.front());
    for (int i = 0; i < 100 && b - a > width; ++i) {
      double c = b - fb * (b - a) / (fb - fa);
      if (!(c > a && c < b) || i % 8 == 7) c = 0.5 * (a + b);
      State y_c = advance(problem_, t_, y_, c, solution_.work);
      const double fc = event(c, y_c.data());
      if (sign(fc) == sign_[k]) {
        a = c;
        fa = fc;
        fb *= 0.5;
      } else {
        b = c;
        fb = fc;
        y_b = std::move(y_c);
        fa *= 0.5;
        if (fc == 0.0) break;
      }
    }
    y = std::move(y_b);
    return b;
  }

  const Problem& problem_;
  std::span<const double> times_;
  integrators::StepControl control_;
  std::unique_ptr<integrators::Stepper> stepper_;
  Solution solution_;
  std::vector<int> sign_;
  double t_ = 0.0;
  State y_;
};

}  // namespace

Json Solution::channel(int component, double factor) const {
  Json values = Json::array();
  for (const State& y : samples) values.push_back(factor * y[static_cast<std::size_t>(component)]);
  return values;
}

Json Solution::times_of(int event, bool rising) const {
  Json values = Json::array();
  for (const Event& e : events)
    if (e.index == event && e.rising == rising) values.push_back(e.t);
  return values;
}

std::vector<double> sample_times(const Json& the_case) {
  for (const char* part : {"/expected/t", "/inputs/times"}) {
    const Json::json_pointer where(part);
    if (the_case.contains(where)) return the_case[where].get<std::vector<double>>();
  }
  throw InputError(
      "this calculator integrates over time and needs \"times\": a list of sample times [s], "
      "counted from the start of the motion");
}

Solution solve(const Problem& problem, std::span<const double> times) {
  return Solver(problem, times).run();
}

}  // namespace adore::validation
