#pragma once

#include "studies/campaign.hpp"

#include <QObject>

#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>

class QThread;

namespace adore::adrinput {

/// How a plan or a run of a study ended.
struct StudyEnd {
  std::optional<studies::Plan> plan;
  std::string text;  ///< of the plan, or the report
  std::optional<studies::CampaignOutcome> outcome;
  std::string reason;        ///< why there is nothing; empty: there is
  bool over_budget = false;  ///< the reason: it may be started all the same
  bool interrupted = false;
};

/// `adore study plan` and `run` in the background: the same functions, the same folder, so that
/// either goes on with what the other began. Reports arrive in the thread of this object.
class StudyRun : public QObject {
  Q_OBJECT
 public:
  explicit StudyRun(QObject* parent = nullptr) : QObject(parent) {}
  /// Stops what is under way and waits for it; finished runs are recorded.
  ~StudyRun() override;

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
  void stop() { stop_.request_stop(); }
  [[nodiscard]] bool busy() const { return thread_ != nullptr; }

 private:
  void start(const Request& request, bool plan_only);

  QThread* thread_ = nullptr;
  std::stop_source stop_;
};

}  // namespace adore::adrinput
