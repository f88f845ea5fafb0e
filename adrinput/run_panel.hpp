#pragma once

#include "adrinput/evaluation.hpp"
#include "adrinput/run_results.hpp"
#include "adrinput/solver_run.hpp"
#include "adrinput/viewers.hpp"
#include "deck/deck.hpp"

#include <QStringList>
#include <QWidget>

#include <filesystem>
#include <optional>

class QCheckBox;
class QFileSystemWatcher;
class QLabel;
class QPlainTextEdit;
class QProgressBar;
class QPushButton;
class QTimer;
class QToolButton;

namespace adore::adrinput {

/// The whole run of a saved deck: start, progress, cancel, what came out, and the way to the plots,
/// the animation and PRINT.txt.
class RunPanel : public QWidget {
  Q_OBJECT
 public:
  explicit RunPanel(QWidget* parent = nullptr);

  /// Starts a viewer; desktop::start_program unless a test looks on.
  Launch launch;

  /// Runs the deck file, whose content is `deck`, with the ADORE.json beside it, which holds
  /// `options`. Results go there too, in place of those that this panel computed before; others are
  /// replaced only after a question (a box named "replace-results").
  void start(const std::filesystem::path& file, const deck::Deck& deck,
             const RunOptionValues& options);
  /// The same into a folder of its own below the deck's, "run-001" and on.
  void startInNewFolder(const std::filesystem::path& file, const deck::Deck& deck,
                        const RunOptionValues& options);
  /// Goes on with the run whose MASTER and FINAL stand beside the deck, up to its end.
  void continueRun(const std::filesystem::path& file, const deck::Deck& deck,
                   const RunOptionValues& options);
  /// Runs the deck for each value of `range`, "appLoadZ=500:1500:5", a folder each.
  void sweep(const std::filesystem::path& file, const deck::Deck& deck,
             const RunOptionValues& options, const QString& range);
  /// The deck of the file `now` was opened: results of another one say so.
  void setAnother(const std::filesystem::path& now);
  /// The deck is this one now: results of an older one say so. What is on the disk beside it can
  /// be opened, whoever computed it.
  void setDeck(const std::filesystem::path& file, const deck::Deck& deck,
               const RunOptionValues& options);
  [[nodiscard]] bool busy() const { return run_.busy(); }
  [[nodiscard]] QString text() const;

 public slots:
  void cancel();
  void openPlots();
  void openAnimation();
  void showListing();

 signals:
  /// The Run button was pressed, or an entry of the menu beside it.
  void wanted();
  void newFolderWanted();
  void continueWanted();
  void sweepWanted();
  void finished();

 private:
  void show(const facade::Progress& progress);
  void show(const RunEnd& end);
  void showNote();
  void begin(const std::filesystem::path& file, const deck::Deck& deck,
             const RunOptionValues& options);
  void launchRun(bool overwrite);
  void launchRequest(facade::RunRequest request);
  [[nodiscard]] std::filesystem::path resultFolder() const;
  void askToReplace();
  /// The report that stands beside the deck, as far as it can be told from another one.
  [[nodiscard]] std::optional<std::filesystem::file_time_type> reportTime() const;
  void enableButtons();
  void enableViewers();
  void watchResults();
  void view(const QString& program, const QStringList& files);
  /// Of the run that is told here; where there was none, of the deck in the form.
  [[nodiscard]] RunResults results() const;

  QPushButton *start_, *cancel_, *plots_, *animation_, *listing_;
  QToolButton* more_;
  QCheckBox *plots_at_end_, *animation_at_end_;
  QProgressBar* bar_;
  QLabel* note_;
  QPlainTextEdit* view_;
  QFileSystemWatcher* watcher_;
  QTimer* look_;  ///< a pause for a program to finish writing
  QString headline_;
  std::filesystem::path file_;        ///< the deck that runs
  std::filesystem::path out_;         ///< where its results go; empty: beside it
  std::filesystem::path shown_file_;  ///< the deck in the form; empty: it has no name yet
  deck::Deck shown_;
  std::filesystem::file_time_type began_;
  std::optional<std::filesystem::file_time_type> own_report_;  ///< of the last run made here
  deck::Deck computed_;
  RunOptionValues computed_options_;
  bool stale_ = false, another_ = false;
  bool stored_ = false;  ///< the run has done a step
  SolverRun run_;        ///< last: ends before the widgets that it reports to
};

}  // namespace adore::adrinput
