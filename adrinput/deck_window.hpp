#pragma once

#include "adrinput/document.hpp"

#include <QMainWindow>
#include <QPointer>

#include <functional>

class QBoxLayout;
class QDockWidget;
class QListWidget;
class QMenu;
class QPlainTextEdit;
class QPushButton;
class QScrollArea;
class QTabWidget;
class QTimer;

namespace adore::adrinput {

class AccuracyPanel;
class CompareDialog;
class DesignPage;
class DrawingPanel;
class FindDialog;
class LubricantPanel;
class EvaluationPanel;
class FileWatch;
class NoticeBar;
class RecordList;
class RecordPage;
class RunPanel;
class SolutionCharts;
class StartCheck;
class TimeScale;

/// Main window of AdrInput: the records on the left, the form of one of them, and below it
/// problems, plan and quasi-static solution.
class DeckWindow : public QMainWindow {
  Q_OBJECT
 public:
  explicit DeckWindow(QWidget* parent = nullptr);
  ~DeckWindow() override;

  [[nodiscard]] Document& document() { return document_; }
  /// Reads a deck, or DATA.txt in a folder. False, after a message with the reason, when that is
  /// impossible.
  bool openFile(const std::filesystem::path& path);
  void showRecord(const std::string& record);
  [[nodiscard]] const std::string& currentRecord() const { return current_; }
  /// Front page (design_page.hpp), in place of the record.
  void showDesign();
  [[nodiscard]] bool designShown() const;
  [[nodiscard]] DesignPage& design() { return *design_; }
  /// The record, or kDesignPage.
  [[nodiscard]] std::string currentPage() const;
  /// QMainWindow::saveState() with the docks that the front page hides.
  [[nodiscard]] QByteArray dockState() const;
  [[nodiscard]] RecordPage* page() { return page_; }
  [[nodiscard]] QScrollArea& pageArea() { return *scroll_; }
  [[nodiscard]] EvaluationPanel& planPanel() { return *plan_; }
  [[nodiscard]] EvaluationPanel& staticsPanel() { return *statics_; }
  [[nodiscard]] RunPanel& runPanel() { return *run_; }
  [[nodiscard]] AccuracyPanel& accuracyPanel() { return *accuracy_; }
  [[nodiscard]] SolutionCharts& solutionCharts() { return *charts_; }
  /// Goes to a value. If the deck does not have it: to the option that would show it, with its
  /// name.
  void goTo(const Cell& cell);
  /// Shows a page if the deck has it.
  void showPage(const std::string& record);
  /// Panels that an earlier session left open and that are still empty.
  void hideEmptyPanels();
  /// Place where a session asks about unsaved decks.
  [[nodiscard]] NoticeBar& sessionNotice() { return *session_notice_; }
  /// Restores a snapshot (document.hpp) after the current deck is saved or discarded.
  void restoreDeck(const std::string& bytes, std::function<void()> then);
  /// Shows the differences from another deck; `name`: its name in sentences.
  void compareWith(deck::Deck other, const QString& name);
  [[nodiscard]] DrawingPanel& drawingPanel() { return *drawing_; }
  /// The slower checks, which follow a change after a short pause, now.
  void checkNow();

 public slots:
  void goBack();
  void nextRecord();
  void newDeck(const QString& template_name);
  void openStudyFile(const std::filesystem::path& file);
  void askForFile();
  /// Lists the deck and its run in PROJECT.json of a folder that the user selects.
  void addToProject();
  /// Lists the decks of a project.
  void askForProject();
  void newFromCatalogue();
  /// Puts a proposal for the inside into the deck, from its bore, outside diameter and widths.
  void proposeInside();
  void save();
  /// Parks the deck with its errors in a file that AdrInput opens again.
  void parkDraft();
  void studyAccuracy();
  void saveAs();
  void saveAndExit();
  void undo();
  void redo();
  void nextProblem();
  void previousProblem();
  void showPlan();
  void runQuasiStatic();
  /// Saves the deck if necessary, then runs it.
  void runDeck();
  void runInNewFolder();
  void continueRun();
  void askForSweep();
  /// The value of an input at which a result meets a target.
  void askForFind();
  void switchTheme();
  /// A separate window for a study of this deck, after that has a name.
  void newStudy(const QString& kind);
  void openStudy();
  void compareWithSaved();
  void askForComparison();

 signals:
  void documentChanged();
  void pageShown();
  /// The user wants to recover unsaved decks of earlier sessions.
  void unsavedWanted();

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  void openDropped(const QStringList& files);
  void makeCentre();
  QWidget* makeDesign();
  void leaveDesign();
  /// The form of a record, without showing it.
  void loadRecord(const std::string& record);
  void makeDrawing();
  QWidget* makeButtons();
  void makeFileMenu();
  void makeOtherMenus();
  void makeNotices(QBoxLayout* column);
  void makeCompareMenu(QMenu* file);
  void makeStudyMenu(QMenu* file);
  void makeUnitsMenu(QMenu* view);
  void makeUnitChoices(QMenu* view);
  void applyAccuracy();
  void showCharts();
  /// Computes the scales for the times of a run, if they are shown.
  void askForScales();
  /// Checks whether a run can start, if this is still unknown.
  void askForStart();
  void goToOptionOf(const Cell& cell);
  /// True if the deck can be computed; else a message gives the reason.
  bool readyToCompute();
  void refreshNotices();
  void checkFile();
  void compareWithFile(const std::filesystem::path& path, const QString& name);
  void makeToolBar();
  /// Continues with a deck without errors, after it is saved.
  void withSavedDeck(std::function<void()> then);
  void orderTabs();
  void showChanged(const std::string& record);
  void showUnits();
  void refresh();
  void refreshProblems();
  void showPanel(const QWidget* panel);
  void goToProblem(int row);
  /// To the field that a finding of a run names, or that its kind has.
  void goToFinding(const Finding& finding);
  void stepProblem(int by);
  void saveTo(const std::filesystem::path& path, std::function<void()> then = nullptr);
  void refuseToSave(const std::vector<Issue>& issues, const QString& otherwise);
  bool writeTo(const std::filesystem::path& path);
  void askForName(std::function<void()> then);
  /// Continues at once, or after the user has saved or discarded the changes.
  void leaveDeck(std::function<void()> then);
  /// Continues at once, or after the user has agreed to stop the active run.
  void leaveRun(std::function<void()> then);
  void remember(const std::filesystem::path& path);
  void forgetResults(bool reread = false);

  static constexpr int kDrawingWidth = 300;  ///< of the drawing next to the form
  /// For a window whose form needs the space of list and drawing.
  static constexpr int kNarrow = 1100;
  Document document_;
  std::string visited_problem_;  ///< its text
  std::string current_;
  std::string shown_original_;  ///< content of the panel "File as opened"
  RecordPage* page_ = nullptr;
  RecordList* list_ = nullptr;
  QScrollArea* scroll_ = nullptr;
  QTabWidget* tabs_ = nullptr;
  DesignPage* design_ = nullptr;
  QWidget* buttons_ = nullptr;
  QByteArray docks_;  ///< state of the docks when the front page hid them
  QListWidget* problems_ = nullptr;
  QPlainTextEdit* original_ = nullptr;
  EvaluationPanel *plan_ = nullptr, *statics_ = nullptr;
  RunPanel* run_ = nullptr;
  AccuracyPanel* accuracy_ = nullptr;
  SolutionCharts* charts_ = nullptr;
  QDockWidget* charts_dock_ = nullptr;
  DrawingPanel* drawing_ = nullptr;
  LubricantPanel* lubricant_ = nullptr;
  QDockWidget* drawing_dock_ = nullptr;
  QAction *undo_ = nullptr, *redo_ = nullptr;
  QTimer* check_ = nullptr;
  TimeScale* scale_ = nullptr;
  StartCheck* start_check_ = nullptr;
  NoticeBar *session_notice_ = nullptr, *file_notice_ = nullptr, *units_notice_ = nullptr,
            *search_notice_ = nullptr;
  FileWatch* watch_ = nullptr;
  QPointer<CompareDialog> compare_;
  QPointer<FindDialog> find_;
  QAction* other_units_ = nullptr;
  bool leaving_ = false;
};

}  // namespace adore::adrinput
