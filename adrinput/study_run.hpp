#pragma once

#include "adrinput/background.hpp"
#include "studies/campaign.hpp"

#include <QObject>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace adore::adrinput {

/// How a plan or a run of a study ended.
struct StudyEnd {
  std::optional<studies::Plan> plan;
  std::string text;  ///< of the plan, or the report
  std::optional<studies::CampaignOutcome> outcome;
  std::string reason;        ///< reason for a missing result; empty: there is one
  bool over_budget = false;  ///< reason of a rejection that the user may override
  bool interrupted = false;
};

/// `adore study plan` and `run` in the background: the same functions and folder, so that each
/// continues the other. Reports arrive in the thread of this object, whose end stops active runs
/// and waits for them; finished runs are recorded.
class StudyRun : public QObject {
  Q_OBJECT
 public:
  explicit StudyRun(QObject* parent = nullptr) : QObject(parent) {}

  std::function<void(const studies::StudyProgress&)> progressed;
  std::function<void(const StudyEnd&)> ended;

  struct Request {
    std::filesystem::path file, program;
    std::string engine = "local";
    int workers = 0;
    bool retry_failed = false, over_budget = false;
  };
  void plan(const Request& request) { start(request, true); }
  void run(const Request& request) { start(request, false); }
  void stop() { background_task_.stop(); }
  [[nodiscard]] bool busy() const { return background_task_.busy(); }

 private:
  void start(const Request& request, bool plan_only);

  BackgroundTask background_task_;
};

}  // namespace adore::adrinput
