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
  [[nodiscard]] const std::string& currentRecord() const { return current_record_; }
  /// Front page (design_page.hpp), in place of the record.
  void showDesign();
  [[nodiscard]] bool isDesignShown() const;
  [[nodiscard]] DesignPage& design() { return *design_page_; }
  /// The record, or kDesignPage.
  [[nodiscard]] std::string currentPage() const;
  /// QMainWindow::saveState() with the docks that the front page hides.
  [[nodiscard]] QByteArray dockState() const;
  [[nodiscard]] RecordPage* page() { return record_page_; }
  [[nodiscard]] QScrollArea& pageArea() { return *scroll_area_; }
  [[nodiscard]] EvaluationPanel& planPanel() { return *plan_panel_; }
  [[nodiscard]] EvaluationPanel& staticsPanel() { return *statics_panel_; }
  [[nodiscard]] RunPanel& runPanel() { return *run_panel_; }
  [[nodiscard]] AccuracyPanel& accuracyPanel() { return *accuracy_panel_; }
  [[nodiscard]] SolutionCharts& solutionCharts() { return *solution_charts_; }
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
  [[nodiscard]] DrawingPanel& drawingPanel() { return *drawing_panel_; }
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
  void estimateInternalGeometry();
  void save();
  /// Parks the deck with its errors in a file that AdrInput opens again.
  void saveDraft();
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
  void openFindDialog();
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
  void recoveryRequested();

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  void openDroppedFile(const QStringList& files);
  void makeCentralWidget();
  QWidget* makeDesignPage();
  void hideDesign();
  /// The form of a record, without showing it.
  void buildRecordPage(const std::string& record);
  void makeDocks();
  QWidget* makeButtons();
  void makeFileMenu();
  void makeOtherMenus();
  void makeNotices(QBoxLayout* column);
  void makeCompareMenu(QMenu* file);
  void makeStudyMenu();
  void makeUnitsMenu(QMenu* view);
  void makeUnitChoices(QMenu* view);
  void applyAccuracySettings();
  void showCharts();
  /// Computes the scales for the times of a run, if they are shown.
  void requestTimeScales();
  /// Checks whether a run can start, if this is still unknown.
  void requestStartCheck();
  void goToEnablingOption(const Cell& cell);
  /// True if the deck can be computed; else a message gives the reason.
  bool readyToCompute();
  void refreshNotices();
  void checkFile();
  void compareWithFile(const std::filesystem::path& path, const QString& name);
  void makeToolBar();
  /// Continues with a deck without errors, after it is saved.
  void withSavedDeck(std::function<void()> then);
  void updateTabOrder();
  void showChangedRecord(const std::string& record);
  void showUnits();
  void refresh();
  void refreshProblems();
  void showPanel(const QWidget* panel);
  void goToProblem(int row);
  /// To the field that a finding of a run names, or that its kind has.
  void goToFinding(const Finding& finding);
  void goToAdjacentProblem(int by);
  void saveTo(const std::filesystem::path& path, std::function<void()> then = nullptr);
  void showSaveErrors(const std::vector<Issue>& issues, const QString& otherwise);
  bool writeTo(const std::filesystem::path& path);
  void askForName(std::function<void()> then);
  /// Continues at once, or after the user has saved or discarded the changes.
  void resolveUnsavedChanges(std::function<void()> then);
  /// Continues at once, or after the user has agreed to stop the active run.
  void confirmStopRun(std::function<void()> then);
  void addRecentFile(const std::filesystem::path& path);
  void invalidateResults(bool reread = false);

  static constexpr int kDrawingWidth = 300;  ///< of the drawing next to the form
  /// For a window whose form needs the space of list and drawing.
  static constexpr int kNarrow = 1100;
  Document document_;
  std::string visited_problem_;  ///< its text
  std::string current_record_;
  std::string shown_original_;  ///< content of the panel "File as opened"
  RecordPage* record_page_ = nullptr;
  RecordList* list_ = nullptr;
  QScrollArea* scroll_area_ = nullptr;
  QTabWidget* tabs_ = nullptr;
  DesignPage* design_page_ = nullptr;
  QWidget* buttons_ = nullptr;
  QByteArray saved_dock_state_;  ///< state of the docks when the front page hid them
  QListWidget* problem_list_ = nullptr;
  QPlainTextEdit* original_view_ = nullptr;
  EvaluationPanel *plan_panel_ = nullptr, *statics_panel_ = nullptr;
  RunPanel* run_panel_ = nullptr;
  AccuracyPanel* accuracy_panel_ = nullptr;
  SolutionCharts* solution_charts_ = nullptr;
  QDockWidget* charts_dock_ = nullptr;
  DrawingPanel* drawing_panel_ = nullptr;
  LubricantPanel* lubricant_panel_ = nullptr;
  QDockWidget* drawing_dock_ = nullptr;
  QAction *undo_ = nullptr, *redo_ = nullptr;
  QTimer* check_timer_ = nullptr;
  TimeScale* time_scale_ = nullptr;
  StartCheck* start_check_ = nullptr;
  NoticeBar *session_notice_ = nullptr, *file_notice_ = nullptr, *units_notice_ = nullptr,
            *search_notice_ = nullptr;
  FileWatch* file_watch_ = nullptr;
  QPointer<CompareDialog> compare_dialog_;
  QPointer<FindDialog> find_dialog_;
  QAction* other_units_ = nullptr;
  bool close_confirmed_ = false;
};

}  // namespace adore::adrinput
