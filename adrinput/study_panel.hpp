#pragma once

#include "adrinput/study_document.hpp"
#include "adrinput/study_run.hpp"
#include "adrinput/viewers.hpp"

#include <QStringList>
#include <QWidget>

class QCheckBox;
class QComboBox;
class QLabel;
class QPlainTextEdit;
class QProgressBar;
class QPushButton;
class QSpinBox;
class QTimer;

namespace adore::adrinput {

/// Next to the form: errors of the study, or its number of runs; the plan; progress of the run; the
/// report.
class StudyPanel : public QWidget {
  Q_OBJECT
 public:
  explicit StudyPanel(StudyDocument& document, QWidget* parent = nullptr);

  /// Starts AdrPlot; desktop::start_program unless a test looks on.
  Launch launch;
  /// `adore`, whose processes compute the runs
  std::filesystem::path program;

  /// The document changed: checks follow after a short pause.
  void changed();
  void checkNow();
  [[nodiscard]] const StudyDocument::Finding& finding() const { return finding_; }
  [[nodiscard]] bool busy() const { return run_.busy(); }
  [[nodiscard]] QString text() const;
  [[nodiscard]] QString note() const;
  /// Of a saved study without mistakes.
  void startPlan();
  void startRun(bool retry_failed = false, bool over_budget = false);
  /// Its progress, if it was started.
  void showStatus();

 public slots:
  void cancel();
  void openResults();

 signals:
  /// The buttons were pressed: the window saves first.
  void planRequested();
  void runRequested();
  void retryRequested();
  void overBudgetRunRequested();
  void checkFinished();
  void goToProblem();
  void finished();

 private:
  void show(const studies::StudyProgress& progress);
  void show(const StudyEnd& end);
  void enableButtons();
  [[nodiscard]] StudyRun::Request request() const;

  StudyDocument& document_;
  StudyDocument::Finding finding_;
  QLabel *state_, *note_;
  QPushButton *plan_, *start_, *cancel_, *results_, *retry_, *over_budget_button_;
  QComboBox* engine_;
  QSpinBox* workers_;
  QProgressBar* bar_;
  QPlainTextEdit* view_;
  QTimer* delay_timer_;
  long failed_runs_ = 0;
  std::string started_study_,
      over_budget_study_;  ///< texts of the study: when it was started, when it exceeded the budget
  bool planning_ = false, started_ = false, complete_ = false;
  StudyRun run_;  ///< last: ends before the widgets that it reports to
};

}  // namespace adore::adrinput
