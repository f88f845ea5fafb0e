#include "adrinput/solver_run.hpp"

#include "runs/output_folder.hpp"

#include <exception>
#include <memory>
#include <utility>

namespace adore::adrinput {

void SolverRun::start(runs::RunRequest request) {
  auto end = std::make_shared<RunEnd>();
  const auto report = [this](const runs::Progress& progress) {
    background_task_.report([this, progress] {
      if (progressed) progressed(progress);
    });
  };
  background_task_.start(
      [request = std::move(request), report, end](const std::stop_token& token) {
        try {
          if (studies::is_sweep(request))
            end->sweep = studies::run_sweep(request, 0, report, token);
          else
            end->outcome = runs::run(request, report, token);
        } catch (const runs::ResultsExist& found) {
          end->reason = found.what();
          end->results_exist = true;
        } catch (const std::exception& error) {
          end->reason = error.what();
        }
      },
      [this, end] {
        if (ended) ended(*end);
      });
}

}  // namespace adore::adrinput
