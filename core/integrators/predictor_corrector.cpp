#include "integrators/predictor_corrector.hpp"

#include <algorithm>
#include <cmath>

namespace adore::integrators {
namespace {

// Five-point Gauss–Legendre rule on [0, 1]; exact to degree 9.
constexpr int kNodes = 5;
constexpr double kNode[kNodes] = {0.046910077030668003601, 0.23076534494715845448, 0.5,
                                  0.76923465505284154552, 0.95308992296933199640};
constexpr double kNodeWeight[kNodes] = {0.11846344252809454376, 0.23931433524968323402,
                                        0.28444444444444444444, 0.23931433524968323402,
                                        0.11846344252809454376};

// Trials in a row that may fail before the past is thought misleading and the start is repeated.
constexpr int kPatience = 4;
// A step so much shorter than the one before replaces the newest derivative instead of joining it
// in the history: differences over such a sliver would be rounding noise.
constexpr double kSliver = 1e-3;

}  // namespace

AdamsWeights adams_weights(const double* times, int k, double h) noexcept {
  std::array<double, kMaxAdamsOrder> x{};  // past points; the step runs from 0 to 1
  for (int j = 0; j < k; ++j) x[j] = (times[j] - times[0]) / h;

  AdamsWeights w;
  std::array<double, kMaxAdamsOrder> denominator{};
  for (int j = 0; j < k; ++j) {
    double d = 1.0;
    double at_end = 1.0;
    for (int m = 0; m < k; ++m) {
      if (m != j) {
        d *= x[j] - x[m];
        at_end *= 1.0 - x[m];
      }
    }
    denominator[j] = d;
    w.extrapolate[j] = at_end / d;
  }
  double end_lower = 1.0;  // Π (1 - x_m) over k - 1 points, then over all k
  for (int m = 0; m + 1 < k; ++m) end_lower *= 1.0 - x[m];
  const double end_all = end_lower * (1.0 - x[k - 1]);
  for (int g = 0; g < kNodes; ++g) {
    for (int j = 0; j < k; ++j) {
      double basis = kNodeWeight[g] / denominator[j];
      for (int m = 0; m < k; ++m) {
        if (m != j) basis *= kNode[g] - x[m];
      }
      w.predict[j] += basis;
    }
    double product = kNodeWeight[g];
    for (int m = 0; m + 1 < k; ++m) product *= kNode[g] - x[m];
    w.correct += product / end_lower;
    w.correct_higher += product * (kNode[g] - x[k - 1]) / end_all;
  }
  return w;
}

PredictorCorrector::PredictorCorrector(std::string name, int order)
    : ExplicitStepper(std::move(name), order) {}

void PredictorCorrector::prepare() {
  const int n = width();
  memory_.assign(static_cast<std::size_t>(n) * order(), 0.0);
  for (int j = 0; j < order(); ++j) history_[j] = memory_.data() + static_cast<std::size_t>(j) * n;
  for (auto* v : {&predicted_, &extrapolated_derivative_, &y_sub_, &f_sub_}) v->assign(n, 0.0);
  stages_.resize(fehlberg(4), n);
  forget_past();
}

void PredictorCorrector::forget_past() {
  known_ = 1;
  times_[0] = t_;
  std::copy(f_.begin(), f_.end(), history_[0]);
}

ExplicitStepper::Trial PredictorCorrector::attempt(double h, double /*t_new*/) {
  return is_starting() ? attempt_start(h) : attempt_adams(h);
}

ExplicitStepper::Trial PredictorCorrector::attempt_adams(double h) {
  const int k = order();
  const AdamsWeights w = adams_weights(times_.data(), k, h);
  const double* const* past = history_.data();
  combine(predicted_.data(), y_.data(), h, w.predict.data(), past, k, width());
  combine(extrapolated_derivative_.data(), nullptr, 1.0, w.extrapolate.data(), past, k, width());
  const Outcome outcome = evaluate_(t_ + h, predicted_.data(), f_new_.data());
  if (outcome != Outcome::Ok) return {outcome, 0.0};
  const double correct = h * w.correct;
  const double estimate = h * (w.correct - w.correct_higher);
  for (int i = 0; i < width(); ++i) {
    const double surprise = f_new_[i] - extrapolated_derivative_[i];
    y_new_[i] = predicted_[i] + correct * surprise;
    error_[i] = estimate * surprise;
  }
  return {Outcome::Ok, weighted_maximum(error_.data(), weights_.data(), width())};
}

// One grid interval of the start. The error counted is the sum over the substeps.
Outcome PredictorCorrector::substeps(double h, int count, double& error) {
  error = 0.0;
  std::copy(y_.begin(), y_.end(), y_sub_.begin());
  std::copy(f_.begin(), f_.end(), f_sub_.begin());
  const double part = h / count;
  for (int i = 0; i < count; ++i) {
    const Outcome outcome = stages_.run(evaluate_, t_ + i * part, part, t_ + (i + 1) * part,
                                        y_sub_.data(), f_sub_.data(), y_new_.data(), error_.data());
    if (outcome != Outcome::Ok) return outcome;
    error += weighted_maximum(error_.data(), weights_.data(), width());
    if (i + 1 == count) break;
    y_sub_.swap(y_new_);
    const Outcome end = evaluate_(t_ + (i + 1) * part, y_sub_.data(), f_sub_.data());
    if (end != Outcome::Ok) return end;
  }
  return Outcome::Ok;
}

ExplicitStepper::Trial PredictorCorrector::attempt_start(double h) {
  const int most = has_constant_step() ? 4096 : 64;
  double before = 0.0;
  for (int count = 1;; count *= 2) {
    double error = 0.0;
    const Outcome outcome = substeps(h, count, error);
    const bool last = count >= most;
    if (outcome != Outcome::Ok) {
      if (last || outcome == Outcome::Fail) return {outcome, 0.0};
      continue;
    }
    const bool only_rounding_left = before > 0.0 && error > 0.5 * before && error < 100.0;
    if (error <= 1.0 || last || only_rounding_left) return {Outcome::Ok, error};
    before = error;
  }
}

void PredictorCorrector::accepted(double h) {
  const int k = order();
  const bool sliver = known_ > 1 && h < kSliver * (times_[0] - times_[1]);
  if (!sliver) {
    known_ = std::min(known_ + 1, k);
    std::rotate(history_.begin(), history_.begin() + (k - 1), history_.begin() + k);
    std::copy_backward(times_.begin(), times_.begin() + (k - 1), times_.begin() + k);
  }
  times_[0] = t_;
  std::copy(f_.begin(), f_.end(), history_[0]);
}

void PredictorCorrector::save(Memory& memory) const {
  memory["points of the past"] = known_;
  for (int j = 0; j < known_; ++j) {
    const std::string point = "past[" + std::to_string(j) + "]";
    memory[point + " time"] = times_[j];
    for (int i = 0; i < evaluate_.system().size(); ++i)
      memory[point + " rate[" + std::to_string(i) + "]"] = history_[j][i];
  }
}

void PredictorCorrector::restore(const Memory& memory) {
  known_ = static_cast<int>(std::clamp(memory.at("points of the past"), 1.0, 1.0 * order()));
  for (int j = 0; j < known_; ++j) {
    const std::string point = "past[" + std::to_string(j) + "]";
    times_[j] = memory.at(point + " time");
    for (int i = 0; i < evaluate_.system().size(); ++i)
      history_[j][i] = memory.at(point + " rate[" + std::to_string(i) + "]");
  }
}

void PredictorCorrector::rejected(int in_a_row) {
  if (in_a_row % kPatience == 0 && order() > 1 && known_ > 1) {
    forget_past();
    ++counters_.restarts;
  }
}

double PredictorCorrector::growth(double error) {
  if (is_starting()) return 1.0;  // an even grid to begin with
  const double factor = 0.9 * std::pow(std::max(error, 1e-8), -1.0 / (order() + 1));
  return std::clamp(factor, 0.3, 2.0);
}

}  // namespace adore::integrators
