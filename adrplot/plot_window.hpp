#pragma once

#include "adrplot/curve_dialog.hpp"
#include "adrplot/formula_document.hpp"
#include "adrplot/plot_document.hpp"
#include "desktop/project.hpp"

#include <QList>
#include <QMainWindow>
#include <QStringList>

#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

class QComboBox;
class QLabel;
class QMenu;
class QProgressDialog;
class QScrollArea;
class QDockWidget;
class QMimeData;
class QTableView;
class QTimer;
class QToolBar;
class QTreeWidget;

namespace adore {
struct Finding;
}

namespace adore::desktop {
class ChartScene;
class ChartView;
class FindingsBar;
class RunLink;
struct LinkState;
enum class ChartAction : unsigned char;
}  // namespace adore::desktop

namespace adore::adrplot {

struct ChannelRef;
class ChannelTree;
class StatisticsModel;

/// Main window of AdrPlot: files and their pages in a tree, one page as charts, and the navigation
/// buttons.
class PlotWindow : public QMainWindow {
  Q_OBJECT
 public:
  explicit PlotWindow(QWidget* parent = nullptr);
  ~PlotWindow() override;

  /// Reads a file and shows its first page. False, after a message with the reason, if the file is
  /// rejected.
  bool openFile(const std::filesystem::path& path, const results::SolRange& range = {});
  /// The same for results in memory.
  void addFile(results::SolFile file, const results::SolRange& range = {});

  /// Lists the runs of a project above the pages and opens the first one that is there. False,
  /// after a message, if PROJECT.json is damaged or newer.
  bool openProject(const std::filesystem::path& path);
  /// All plot files of a folder: SOL1 to SOL7, or those listed in RUN.json or SWEEP.csv.
  void openFolder(const QString& folder, const results::SolRange& range = {});
  /// Opens the files of a dialog or a drop; for a single file the user selects the steps.
  void openFiles(const QStringList& paths);
  /// Files requested by another program: reloaded if open, and brought to the front.
  void showFiles(const QStringList& paths, bool to_front = true);
  /// Curves of open files as a separate chart in the tree.
  void addChart(const std::vector<CurvePick>& picks, Combine how);
  /// Curves to a panel of the user-defined chart that is shown. On another page they begin a new
  /// chart: with a panel it has the curves of the page, too.
  void addToChart(std::vector<CurvePick> picks, std::optional<std::size_t> panel);
  /// A curve of the chart (none: all of its panel) to another panel, or to a new one.
  void moveCurve(std::size_t panel, std::optional<std::size_t> curve,
                 std::optional<std::size_t> target);
  void removeCurve(std::size_t panel, std::size_t curve);
  /// A computed channel: a page of the file "formulas".
  void addFormula(const FormulaChannel& channel);
  /// Files, charts, formulas and view as a file (session.hpp). False after a message.
  bool saveSession(const QString& path);
  bool openSession(const QString& path);

  [[nodiscard]] int fileCount() const { return static_cast<int>(documents_.size()); }
  [[nodiscard]] int pageCount() const;
  [[nodiscard]] int currentPage() const { return page_; }  ///< 1-based; 0 while no file is open
  [[nodiscard]] desktop::ChartView& view() { return *view_; }
  void showPage(int number);
  void setAbscissa(Abscissa abscissa);
  void setDomain(Domain domain);
  void setSpectrum(const SpectrumOptions& spectrum);
  /// Which curve of a page its spectrogram is of (PageOptions::spectrogram_of).
  void setSpectrogramCurve(const std::string& curve);
  void setLogAxes(std::optional<bool> abscissa, std::optional<bool> values);
  /// Exports the page, or all pages of all SOL files of its run, by the suffix of the name
  /// (desktop/page_export.hpp). For all pages PDF gives one file, other formats one per page,
  /// numbered. `seen`: only values of visible curves in the visible range. False after a message.
  bool exportTo(const QString& path, bool all_pages, bool seen = false);
  /// `adore report` of the runs whose files are open, into a folder. False after a message.
  bool reportTo(const QString& folder);

 public slots:
  void askForFile();
  void askForFolder();
  void askForProject();
  void askForCurves();
  void askForFormula();
  void askForBand();
  void askForSession(bool save);
  void showStatistics(bool on);
  void exportStatistics();
  void closeFile();
  void copyPicture();       ///< or the selected text of the statistics
  void copyCursorReport();  ///< values at the cursors and between them, as text
  void exportPage();
  void exportAll();
  /// A figure for print: asks for its size, then for its name.
  void exportFigure();
  void askForReport();
  /// Reads the file again whenever it has grown.
  void follow(bool on);
  void previousPage();
  void nextPage();
  void askForPage();
  void reload();
  void print();
  void savePicture();
  void switchTheme();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct Document : PlotDocument {
    results::SolRange range;              ///< of the steps that were read
    bool on_disk = true;                  ///< else a user-defined chart or formulas
    std::string seen;                     ///< size and time of the file when it was read
    std::shared_ptr<UserChart> own = {};  ///< of a user-defined chart
  };
  [[nodiscard]] static QString nameOf(const Document& document);
  void addDocument(PlotDocument document, const results::SolRange& range, bool on_disk = true,
                   std::shared_ptr<UserChart> own = {});
  void showRuns(const std::vector<long>& runs);
  void makeMenus();
  void makeChartMenu(QMenu* menu);
  /// Key commands of the chart while it has the focus.
  void makeKeyMenus(QMenu* view);
  void addChartAction(QMenu* menu, desktop::ChartAction chart_action, const QString& text,
                      const QList<QKeySequence>& keys);
  /// Actions without effect are disabled and have a tooltip with the reason.
  void offerChartActions();
  /// The names of the legends, to be hidden or shown.
  void updateCurveNameActions();
  QAction* curveNameAction(qsizetype number);
  void makeButtons();
  void askForExport(bool all_pages);
  void checkForFileChanges();
  void reloadCurrentFile(bool asked);
  /// Of the files that are not looked at, those that another run has replaced: the tree names
  /// bodies and pages.
  void reloadReplacedFiles();
  /// A page with the options and logarithmic axes of the window.
  [[nodiscard]] desktop::ChartPage chartOf(const PlotDocument& file, int page) const;
  /// The visible page and zoom in light colors, also of a dark window.
  [[nodiscard]] std::unique_ptr<desktop::ChartScene> sceneForPaper();
  void saveShownPage(const QString& path, bool seen);
  void savePagesOfRun(const QString& path);
  /// SOL1 to SOL7 of the run of the shown one of them, open or not; else the shown file alone.
  [[nodiscard]] std::vector<PlotDocument> filesOfRun();
  void makeChoiceBoxes(QToolBar* bar);
  /// Enables the choices that apply to a page; the others have a tooltip with the reason.
  void enableChoices(PageKind kind, const desktop::ChartPage& chart);
  /// The possible curves of a spectrogram.
  void fillSpectrogramCurves(const desktop::ChartPage& chart);
  void fillTree();
  void showCurrentPage();
  /// Shows the findings of the run of the current file. Those of the page come first.
  void showFindings();
  void markPagesWithWarnings();
  /// Goes to the page of a finding, with a cursor at its time.
  void goToFinding(const Finding& finding);
  void makeReadout();
  void fitReadout();
  void showReadout();
  [[nodiscard]] QString elidedReadout() const;
  void fitCursors();
  void askForRange(const QString& path);
  // Runs of a project (plot_window_project.cpp).
  QWidget* makePages();
  void listRuns(const std::vector<desktop::Project::Entry>& runs);
  void reloadProject();
  void openRun(const QString& folder);
  void selectCurrentRun();
  // Linked windows of the run (plot_window_link.cpp).
  void makeLink();
  void joinLink();
  [[nodiscard]] const PlotDocument* linkedFile();
  [[nodiscard]] const RunMotion& linkedMotion();
  void sendCursorTime();
  void sendElement();
  void applyLinkState(const desktop::LinkState& change);
  void showLinkedTime();
  void showElement(int number);
  void emphasizeLinkedElement(desktop::ChartPage& page) const;
  /// User-defined charts and formulas follow the element that was selected in another window.
  [[nodiscard]] desktop::ChartPage buildPage(const PlotDocument& file, int page) const;
  [[nodiscard]] std::vector<const PlotDocument*> openFiles() const;
  /// Shows charts as they were made until the next selection in another window.
  void stopFollowingElement() { followed_element_ = 0; }
  // User-defined charts and channels.
  void makeStatistics();
  void fillStatistics();
  void copyStatisticsRows();
  [[nodiscard]] std::pair<double, double> statisticsRange() const;
  void makeChannelTab(QWidget* pages);
  void fillChannels();
  void handleDrop(const QMimeData* data, std::optional<std::size_t> panel);
  void showChartMenu(const QPoint& at);
  void addUserChart(std::shared_ptr<UserChart> chart);
  [[nodiscard]] CurvePick curvePickOf(const ChannelRef& ref) const;
  [[nodiscard]] std::vector<CurvePick> selectedPicks();
  [[nodiscard]] FormulaInput formulaInputOf(const ChannelRef& ref) const;
  void openFormulaDialog(const std::vector<ChannelRef>& channels);
  void showPageOf(const ChannelRef& ref);
  [[nodiscard]] UserChart userChartOfPage();
  [[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> curvePositions(
      const UserChart& chart) const;
  void updateUserChart();
  [[nodiscard]] int formulaDocumentIndex() const;
  /// Number of a file among those on disk; -1: formulas, -2: unknown.
  [[nodiscard]] int sessionNumber(const PlotDocument& file) const;
  [[nodiscard]] std::shared_ptr<const PlotDocument> copyDocument(int document) const;
  [[nodiscard]] Document* document();
  /// Shows how far a long reading is, with a button that stops it. False: it was pressed.
  bool showReadingProgress(double part);

  static constexpr const char* kApp = "adrplot";  ///< name of the settings and recent files
  enum TreeRole { kPageRole = Qt::UserRole, kFileRole, kRunRole };

  std::vector<std::unique_ptr<Document>> documents_;
  int current_ = -1, page_ = 0;
  PageOptions options_;
  CurveChoice last_curve_choice_;  ///< for the chart made last
  desktop::ChartView* view_;
  std::vector<FormulaChannel> formulas_;
  ChannelTree* channel_tree_ = nullptr;
  QDockWidget* statistics_dock_ = nullptr;
  QTableView* statistics_table_ = nullptr;
  StatisticsModel* statistics_model_ = nullptr;
  QAction* statistics_action_ = nullptr;
  std::pair<double, double> statistics_range_;  ///< that the table shows
  desktop::RunLink* link_ = nullptr;
  std::optional<RunMotion> motion_;    ///< of the run that is shown, when needed
  std::optional<double> linked_time_;  ///< of cursor A, here or in another window [s]
  int followed_element_ = 0;           ///< selected last in another window; 0: none
  double linked_cursor_ =
      std::numeric_limits<double>::quiet_NaN();  ///< cursor A as told or received last
  bool taking_ = false;                          ///< changes now are not of the user
  QTreeWidget* tree_;
  QTreeWidget* run_list_ = nullptr;
  std::filesystem::path project_file_;  ///< its file; empty: none
  desktop::FindingsBar* findings_;
  std::string findings_file_stamp_;  ///< folder and time of the RUN.json that they are of
  QLabel* note_;
  QLabel* cursor_label_;
  QScrollArea* cursors_area_;
  QLabel* readout_;               ///< values under the mouse
  QWidget* readout_placeholder_;  ///< space of the status bar for these values
  QStringList values_;            ///< all of them, by part
  QTimer* file_check_timer_ = nullptr;
  bool unreadable_ = false;  ///< the followed file cannot be read at the moment; see the status bar
  std::unique_ptr<QProgressDialog> reading_progress_dialog_;
  std::optional<bool> log_x_, log_y_;  ///< none: start of the page
  QAction* log_x_action_ = nullptr;
  QAction* log_y_action_ = nullptr;
  QList<QAction*> spectrum_actions_;
  QAction* band_action_ = nullptr;  ///< of envelopes
  QComboBox* abscissa_ = nullptr;
  QComboBox* orbit_axes_box_ = nullptr;
  QComboBox* domain_ = nullptr;
  QComboBox* spectrogram_curve_box_ = nullptr;  ///< that a spectrogram is of
  QAction* spectrogram_curve_action_ = nullptr;
  QMenu* spectrogram_curve_menu_ = nullptr;  ///< the same, if the buttons do not fit
  QMenu* curve_names_menu_ = nullptr;        ///< curves of the legends
  QList<QAction*> curve_name_actions_;       ///< as many as a page ever had; the others are hidden
  std::vector<std::pair<QAction*, desktop::ChartAction>> chart_actions_;
  QAction* orbit_action_ = nullptr;
  QAction* follow_action_ = nullptr;
};

}  // namespace adore::adrplot
