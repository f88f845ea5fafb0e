#include "runs/measured_run.hpp"

#include "base/interrupted.hpp"
#include "runs/temporary_folder.hpp"
#include "scene/cost_ledger.hpp"

#include <fmt/format.h>

namespace adore::runs {

MeasuredRun measured_run(RunRequest request, double most_seconds, std::stop_token stop) {
  const TemporaryFolder folder;
  request.out = folder.path();
  std::stop_source end;
  const std::stop_callback forward(stop, [&end] { end.request_stop(); });
  MeasuredRun out;
  const double begin = scene::processor_seconds();
  const ProgressSink watch = [&](const Progress&) {
    if (scene::processor_seconds() - begin > most_seconds) {
      out.cut = true;
      end.request_stop();
    }
  };
  try {
    out.outcome = run(request, watch, end.get_token());
  } catch (const Interrupted&) {
    if (!out.cut || stop.stop_requested()) throw;
    out.outcome.status = RunStatus::Interrupted;
  }
  out.seconds = scene::processor_seconds() - begin;
  out.outcome.files.clear();
  if (stop.stop_requested()) throw Interrupted("interrupted");
  out.cut = out.cut && out.outcome.status == RunStatus::Interrupted;
  return out;
}

std::vector<std::pair<std::string, std::string>> nearby_loads(const deck::Deck& deck,
                                                              double change) {
  std::vector<std::pair<std::string, std::string>> out;
  for (const char* name : {"appLoadX", "appLoadY", "appLoadZ"})
    if (const double load = deck.real(name); load != 0.0)
      out.emplace_back(name, fmt::format("{:.17g}", load + change * load));
  return out;
}

}  // namespace adore::runs
