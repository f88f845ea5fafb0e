#include "adrinput/study_run.hpp"

#include "base/interrupted.hpp"
#include "studies/report.hpp"

#include <csignal>
#include <exception>
#include <memory>
#include <pthread.h>

namespace adore::adrinput {
namespace {

studies::CampaignRequest campaign_of(const StudyRun::Request& request) {
  studies::CampaignRequest out;
  out.study = studies::open_study(request.file);
  out.engine = request.engine;
  out.program = request.program;
  out.workers = request.workers;
  out.retry_failed = request.retry_failed;
  out.over_budget = request.over_budget;
  return out;
}

void compute(const StudyRun::Request& request, bool plan_only, const studies::StudySink& sink,
             const std::stop_token& stop, StudyEnd& end) {
  try {
    const studies::CampaignRequest campaign = campaign_of(request);
    if (plan_only) {
      end.plan = studies::make_plan(campaign, stop);
      end.text = studies::plan_text(campaign, *end.plan);
    } else {
      end.outcome = studies::run_campaign(campaign, sink, stop);
      end.text = studies::write_report(campaign.study).text;
    }
  } catch (const studies::OverBudget& error) {
    end.reason = error.what();
    end.over_budget = true;
  } catch (const Interrupted&) {
    end.interrupted = true;
  } catch (const std::exception& error) {
    end.reason = error.what();
  }
}

}  // namespace

void StudyRun::start(const Request& request, bool plan_only) {
  auto end = std::make_shared<StudyEnd>();
  const auto report = [this](const studies::StudyProgress& progress) {
    background_task_.report([this, progress] {
      if (progressed) progressed(progress);
    });
  };
  background_task_.start(
      [request, plan_only, report, end](const std::stop_token& token) {
        // A worker that dies during communication is detected by its end; the signal would end this
        // process.
        sigset_t pipes;
        sigemptyset(&pipes);
        sigaddset(&pipes, SIGPIPE);
        pthread_sigmask(SIG_BLOCK, &pipes, nullptr);
        compute(request, plan_only, report, token, *end);
      },
      [this, end] {
        if (ended) ended(*end);
      });
}

}  // namespace adore::adrinput
