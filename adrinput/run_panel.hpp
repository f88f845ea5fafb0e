#pragma once

#include "adrinput/evaluation.hpp"
#include "adrinput/run_results.hpp"
#include "adrinput/solver_run.hpp"
#include "adrinput/viewers.hpp"
#include "deck/deck.hpp"

#include <QStringList>
#include <QWidget>

#include <filesystem>
#include <map>
#include <optional>
#include <vector>

class QAction;
class QCheckBox;
class QFileSystemWatcher;
class QLabel;
class QPlainTextEdit;
class QProgressBar;
class QPushButton;
class QTimer;
class QToolButton;

namespace adore::desktop {
class FindingsBar;
}

namespace adore::adrinput {

class RunTimeBar;

/// The run of a saved deck: start, progress, cancel, results, and commands to open plots, animation
/// and PRINT.txt.
class RunPanel : public QWidget {
  Q_OBJECT
 public:
  explicit RunPanel(QWidget* parent = nullptr);

  /// Starts a viewer; desktop::start_program unless a test looks on.
  Launch launch;

  /// Runs the deck file, whose content is `deck`, with the ADORE.json of its folder, which contains
  /// `options`. Results are stored there and replace those that this panel computed for the same
  /// deck; others are replaced only after a question (a box named "replace-results", decision 748).
  void start(const std::filesystem::path& file, const deck::Deck& deck,
             const RunOptionValues& options);
  /// The same in a new folder of the deck's folder, "run-001" and so on.
  void startInNewFolder(const std::filesystem::path& file, const deck::Deck& deck,
                        const RunOptionValues& options);
  /// Continues the run with MASTER and FINAL in `folder` to its end; empty: folder of the deck.
  void continueRun(const std::filesystem::path& file, const deck::Deck& deck,
                   const RunOptionValues& options, const std::filesystem::path& folder = {});
  /// Continues the last run or sweep of this panel; if there are other interrupted ones, asks which
  /// (a dialog named "continue-which").
  void continueInterruptedRun(const std::filesystem::path& file, const deck::Deck& deck,
                              const RunOptionValues& options);
  /// Sets the text of an action to the run that continueInterruptedRun() would continue.
  void updateContinueAction(QAction& action) const;
  /// Runs the deck for each value of `range`, "appLoadZ=500:1500:5", a folder each.
  void sweep(const std::filesystem::path& file, const deck::Deck& deck,
             const RunOptionValues& options, const QString& range);
  /// The file `now` was opened: results of another deck are marked.
  void setOpenedFile(const std::filesystem::path& now);
  /// The current deck: results of an older one are marked as out of date. Existing files of its
  /// folder can be opened, regardless of their origin.
  void setDeck(const std::filesystem::path& file, const deck::Deck& deck,
               const RunOptionValues& options);
  [[nodiscard]] bool busy() const { return run_.busy(); }
  [[nodiscard]] QString text() const;
  /// Time and values of a run with motion.
  [[nodiscard]] RunTimeBar& timeBar() { return *time_bar_; }

 public slots:
  void cancel();
  void openPlots();
  void openAnimation();
  void showListing();

  /// Of the last run, or where the next one writes.
  [[nodiscard]] std::filesystem::path resultFolder() const;

 signals:
  /// The Run button or an entry of the menu next to it was used.
  void wanted();
  void newFolderRequested();
  void continueRequested();
  void sweepRequested();
  void finished();
  /// An entry of the findings of the last run was clicked.
  void findingChosen(const adore::Finding& finding);

 private:
  void show(const runs::Progress& progress);
  void show(const RunEnd& end);
  void showNote();
  void showStoredFindings();
  void showSweep(const studies::SweepOutcome& sweep);
  void begin(const std::filesystem::path& file, const deck::Deck& deck,
             const RunOptionValues& options);
  void launchRun(bool overwrite);
  void launchRequest(runs::RunRequest request);
  void askToReplace();
  /// A run or a sweep that can be continued.
  struct Continuation {
    std::filesystem::path folder;
    QString state;  ///< its text if there is a choice
    bool sweep = false;
  };
  [[nodiscard]] std::vector<Continuation> continuationChoices(const std::filesystem::path& file,
                                                              const deck::Deck& deck) const;
  void continueFrom(const Continuation& way, const std::filesystem::path& file,
                    const deck::Deck& deck, const RunOptionValues& options);
  void continueSweep(const std::filesystem::path& folder, const deck::Deck& deck,
                     const RunOptionValues& options, const std::filesystem::path& file);
  void recordFolderRun(bool whole);
  [[nodiscard]] bool computedByThisWindow() const;
  [[nodiscard]] bool canReplaceResults() const;
  /// The report in the folder of the deck, as far as it can be distinguished from another one.
  [[nodiscard]] std::optional<std::filesystem::file_time_type> reportTime() const;
  void enableButtons();
  void enableViewers();
  void watchResults();
  /// @param behind the keyboard stays in this window
  void showPlots(bool behind);
  void showAnimation(bool behind);
  void view(const QString& program, QStringList files, bool behind);
  /// Of the run shown here; without one, of the deck in the form.
  [[nodiscard]] RunResults results() const;

  QPushButton *start_, *cancel_, *plots_, *animation_, *listing_;
  QToolButton* more_runs_button_;
  QCheckBox *plots_at_end_, *animation_at_end_;
  QProgressBar* bar_;
  QLabel* note_;
  desktop::FindingsBar* findings_;
  RunTimeBar* time_bar_;
  QPlainTextEdit* view_;
  QFileSystemWatcher* watcher_;
  QTimer* delay_timer_;  ///< a pause for a program to finish writing
  QString headline_;
  std::filesystem::path file_;            ///< the deck that runs
  std::filesystem::path result_folder_;   ///< folder of the results; empty: folder of the deck
  std::filesystem::path form_deck_file_;  ///< the deck in the form; empty: no name yet
  deck::Deck form_deck_;
  std::filesystem::file_time_type run_start_time_;
  /// The last run that this panel made in a folder.
  struct FolderRun {
    std::filesystem::file_time_type report;  ///< of RUN.json: later ones are from another program
    deck::Deck deck;
    RunOptionValues options;
    bool whole = false;  ///< not cancelled
  };
  std::map<std::filesystem::path, FolderRun> folder_runs_;
  bool replace_without_asking_ = false;
  deck::Deck computed_deck_;
  RunOptionValues computed_options_;
  bool stale_ = false, results_of_other_deck_ = false;
  bool shows_sweep_ = false;       ///< true if results of a sweep are shown
  bool has_stored_steps_ = false;  ///< the run has done a step
  SolverRun run_;                  ///< last: ends before the widgets that it reports to
};

}  // namespace adore::adrinput
