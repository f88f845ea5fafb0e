#include "runs/run_cost.hpp"

#include "base/interrupted.hpp"
#include "runs/temporary_folder.hpp"
#include "scene/cost_ledger.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace adore::runs {
namespace {

struct Look {
  double share = 0.0, time = 0.0, seconds = 0.0;  ///< of the run; simulated [s]; of the processor
};

}  // namespace

RunCost run_cost(const RunRequest& request, double budget, std::stop_token stop) {
  const TemporaryFolder folder;
  RunRequest pilot = request;
  pilot.out = folder.path();
  pilot.go_on = false;
  std::stop_source end;
  const std::stop_callback forward(stop, [&end] { end.request_stop(); });
  std::vector<Look> looks;
  const double begin = scene::processor_seconds();
  RunCost out;
  const ProgressSink watch = [&](const Progress& at) {
    if (at.runs > 0) {  // a table before the motion
      if (scene::processor_seconds() - begin > budget) end.request_stop();
      return;
    }
    looks.push_back({at.fraction, at.time, scene::processor_seconds() - begin});
    out.end_time = at.end_time;
    if (looks.back().seconds - looks.front().seconds > budget) end.request_stop();
  };
  try {
    const RunOutcome outcome = run(pilot, watch, end.get_token());
    if (stop.stop_requested()) throw Interrupted("interrupted");
    const double all = scene::processor_seconds() - begin;
    out.pilot_turns = std::abs(outcome.revolutions);
    out.pilot_time = outcome.time;
    out.whole = outcome.status == RunStatus::Done || outcome.status == RunStatus::Untrusted;
    if (out.whole || looks.size() < 3 || outcome.status == RunStatus::Failed) {
      out.seconds = all;
      if (!out.whole) out.failure = outcome.message;
      return out;
    }
    const Look& last = looks.back();
    const Look& half = *std::find_if(looks.begin(), looks.end(), [&](const Look& look) {
      return look.seconds >= 0.5 * (looks.front().seconds + last.seconds);
    });
    const Look& from = half.share < last.share ? half : looks.front();
    if (!(last.share > from.share)) {
      out.failure = "the pilot run made no progress";
      return out;
    }
    const double rate = (last.seconds - from.seconds) / (last.share - from.share);
    out.seconds = all + rate * (1.0 - last.share);
  } catch (const Interrupted&) {
    if (stop.stop_requested()) throw;
    out.failure =
        "computing the stiffness table, before the motion starts, takes longer than the time limit "
        "of the pilot run";
  } catch (const InputError& error) {
    out.failure = error.what();
  } catch (const SolverError& error) {
    out.failure = error.what();
  }
  return out;
}

}  // namespace adore::runs
