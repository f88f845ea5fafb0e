#pragma once

#include "facade/prepare.hpp"

#include <functional>
#include <stop_token>
#include <string>
#include <vector>

/// Work-precision study: what accuracy costs in time, for the user's own deck. Every method takes
/// the steps that a run with it would take: the deck's limits, changed where its stability asks for
/// it (judge_steps); only the references may go below stpMin.
namespace adore::facade {

struct AccuracyRequest : DeckRequest {
  std::vector<std::string> methods{"rkf3",  "rkf5",        "rkf7",     "pece4",
                                   "pece8", "cvode-adams", "cvode-bdf"};
  std::vector<double> tolerances{1e-4, 1e-5, 1e-6, 1e-7, 1e-8};
  double span = 100.0;  ///< simulated time over the time scale; contact vibration keeps its phase,
                        ///< so longer spans compare luck
};

struct AccuracyRow {
  std::string method;
  double tolerance = 0.0;
  double error = 0.0;       ///< largest |y - y_ref| / scale over the controlled state at the end
  double load_error = 0.0;  ///< largest |Q - Q_ref| over the largest Q_ref
  double energy_residual = 0.0;  ///< |residual| [J]
  long steps = 0, rejected = 0, evaluations = 0;
  long at_minimum = 0;   ///< steps of stpMin, accepted above the tolerance
  double seconds = 0.0;  ///< computing time of the integration
  std::string failure;   ///< empty, or why the method gave up
};

struct AccuracyStudy {
  std::string steps;      ///< limits of the deck's steps
  std::string reference;  ///< how the reference was made
  double reference_check =
      0.0;  ///< difference of the reference to a second tight solution, same measure as `error`
  double span_seconds = 0.0, span_revolutions = 0.0;
  std::vector<AccuracyRow> rows;
};

/// @throws InputError (quasi-static deck, unknown method), SolverError when no reference can be
/// computed.
AccuracyStudy study_accuracy(const AccuracyRequest& request,
                             const std::function<void(const AccuracyRow&)>& row_done = {},
                             std::stop_token stop = {});

[[nodiscard]] std::string accuracy_table(const AccuracyStudy& study);
[[nodiscard]] std::string accuracy_csv(const AccuracyStudy& study);

}  // namespace adore::facade
