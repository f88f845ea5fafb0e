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

/// The whole run of a saved deck: start, progress, cancel, what came out, and the way to the plots,
/// the animation and PRINT.txt.
class RunPanel : public QWidget {
  Q_OBJECT
 public:
  explicit RunPanel(QWidget* parent = nullptr);

  /// Starts a viewer; desktop::start_program unless a test looks on.
  Launch launch;

  /// Runs the deck file, whose content is `deck`, with the ADORE.json beside it, which holds
  /// `options`. Results go there too, in place of those that this panel computed of the same deck;
  /// others are replaced only after a question (a box named "replace-results", decision 748).
  void start(const std::filesystem::path& file, const deck::Deck& deck,
             const RunOptionValues& options);
  /// The same into a folder of its own below the deck's, "run-001" and on.
  void startInNewFolder(const std::filesystem::path& file, const deck::Deck& deck,
                        const RunOptionValues& options);
  /// Goes on up to its end with the run whose MASTER and FINAL stand in `folder`; empty: beside the
  /// deck.
  void continueRun(const std::filesystem::path& file, const deck::Deck& deck,
                   const RunOptionValues& options, const std::filesystem::path& folder = {});
  /// Goes on with the run or sweep that this panel made last; where others were broken off, too, or
  /// it made none and several were, asks which (a dialog named "continue-which").
  void continueAny(const std::filesystem::path& file, const deck::Deck& deck,
                   const RunOptionValues& options);
  /// Says in an action what continueAny() would go on with for the deck in the form.
  void nameContinuation(QAction& action) const;
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
  /// An entry of the findings of the last run was clicked.
  void findingChosen(const adore::Finding& finding);

 private:
  void show(const facade::Progress& progress);
  void show(const RunEnd& end);
  void showNote();
  void showStored();
  void showSweep(const facade::SweepOutcome& sweep);
  void begin(const std::filesystem::path& file, const deck::Deck& deck,
             const RunOptionValues& options);
  void launchRun(bool overwrite);
  void launchRequest(facade::RunRequest request);
  [[nodiscard]] std::filesystem::path resultFolder() const;
  void askToReplace();
  /// A run or a sweep that can go on.
  struct Way {
    std::filesystem::path folder;
    QString state;  ///< what is said of it where there is a choice
    bool sweep = false;
  };
  [[nodiscard]] std::vector<Way> waysToGoOn(const std::filesystem::path& file,
                                            const deck::Deck& deck) const;
  void goOn(const Way& way, const std::filesystem::path& file, const deck::Deck& deck,
            const RunOptionValues& options);
  void continueSweep(const std::filesystem::path& folder, const deck::Deck& deck,
                     const RunOptionValues& options, const std::filesystem::path& file);
  void noteMade(bool whole);
  [[nodiscard]] bool madeHere() const;
  [[nodiscard]] bool mayReplace() const;
  /// The report that stands beside the deck, as far as it can be told from another one.
  [[nodiscard]] std::optional<std::filesystem::file_time_type> reportTime() const;
  void enableButtons();
  void enableViewers();
  void watchResults();
  /// @param behind the keyboard stays in this window
  void showPlots(bool behind);
  void showAnimation(bool behind);
  void view(const QString& program, QStringList files, bool behind);
  /// Of the run that is told here; where there was none, of the deck in the form.
  [[nodiscard]] RunResults results() const;

  QPushButton *start_, *cancel_, *plots_, *animation_, *listing_;
  QToolButton* more_;
  QCheckBox *plots_at_end_, *animation_at_end_;
  QProgressBar* bar_;
  QLabel* note_;
  desktop::FindingsBar* findings_;
  QPlainTextEdit* view_;
  QFileSystemWatcher* watcher_;
  QTimer* look_;  ///< a pause for a program to finish writing
  QString headline_;
  std::filesystem::path file_;        ///< the deck that runs
  std::filesystem::path out_;         ///< where its results go; empty: beside it
  std::filesystem::path shown_file_;  ///< the deck in the form; empty: it has no name yet
  deck::Deck shown_;
  std::filesystem::file_time_type began_;
  /// The last run that this panel made in a folder.
  struct Made {
    std::filesystem::file_time_type report;  ///< of RUN.json: later ones are of somebody else
    deck::Deck deck;
    RunOptionValues options;
    bool whole = false;  ///< not cancelled
  };
  std::map<std::filesystem::path, Made> made_;
  bool replace_unasked_ = false;
  deck::Deck computed_;
  RunOptionValues computed_options_;
  bool stale_ = false, another_ = false;
  bool tells_sweep_ = false;  ///< what is told of is one
  bool stored_ = false;       ///< the run has done a step
  SolverRun run_;             ///< last: ends before the widgets that it reports to
};

}  // namespace adore::adrinput
