#include "adrplot/plot_window.hpp"

#include "adrplot/finding_pages.hpp"
#include "adrplot/spectrogram_page.hpp"
#include "desktop/chart_view.hpp"
#include "desktop/dialogs.hpp"
#include "desktop/file_drops.hpp"
#include "desktop/findings_bar.hpp"
#include "desktop/menu_keys.hpp"
#include "desktop/window_place.hpp"
#include "results/run_findings.hpp"

#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QProgressDialog>
#include <QScopedValueRollback>
#include <QScrollArea>
#include <QScrollBar>
#include <QSplitter>
#include <QStatusBar>
#include <QTabWidget>
#include <QTimer>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <exception>
#include <set>

namespace adore::adrplot {
namespace {

constexpr int kLeastChart = 100;  ///< height of a chart that scrolls

}  // namespace

PlotWindow::PlotWindow(QWidget* parent) : QMainWindow(parent) {
  setWindowTitle("AdrPlot");
  desktop::accept_file_drops(*this, [this](const QStringList& files) { openFiles(files); });
  desktop::resize_to_fit_screen(*this, {1280, 860});

  tree_ = new QTreeWidget(this);
  tree_->setObjectName("pages");
  tree_->setHeaderHidden(true);
  tree_->setMinimumWidth(180);
  tree_->setFrameShape(QFrame::NoFrame);
  note_ = new QLabel(this);
  note_->setObjectName("note");
  note_->setWordWrap(true);
  note_->setMargin(8);
  note_->hide();
  view_ = new desktop::ChartView(this);
  // On a low screen the chart scrolls: the lines below it never make the window grow.
  auto* chart = new QScrollArea(this);
  chart->setObjectName("chart");
  chart->setWidget(view_);
  chart->setWidgetResizable(true);
  chart->setFrameShape(QFrame::NoFrame);
  chart->setFocusPolicy(Qt::NoFocus);
  chart->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  chart->setMinimumSize(view_->minimumWidth() + chart->verticalScrollBar()->sizeHint().width(),
                        kLeastChart);
  auto* side = new QWidget(this);
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(note_);
  findings_ = new desktop::FindingsBar(this);
  connect(findings_, &desktop::FindingsBar::chosen, this, &PlotWindow::goToFinding);
  column->addWidget(findings_);
  column->addWidget(chart, 1);
  cursor_label_ = new QLabel(this);
  cursor_label_->setObjectName("cursors");
  cursor_label_->setMargin(8);
  cursor_label_->setWordWrap(true);
  cursor_label_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  cursors_area_ = new QScrollArea(this);  // a spectrogram has many lines
  cursors_area_->setWidget(cursor_label_);
  cursors_area_->setWidgetResizable(true);
  cursors_area_->setFrameShape(QFrame::NoFrame);
  cursors_area_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  cursors_area_->hide();
  column->addWidget(cursors_area_);
  makeReadout();
  auto* tabs = new QTabWidget(this);
  tabs->setAccessibleName(tr("Files and channels"));
  tabs->setObjectName("side");
  tabs->setDocumentMode(true);
  tabs->setMinimumWidth(180);
  tabs->addTab(makePages(), tr("Pages"));
  makeChannelTab(tabs);
  makeStatistics();
  auto* splitter = new QSplitter(this);
  splitter->addWidget(tabs);
  splitter->addWidget(side);
  splitter->setStretchFactor(1, 1);
  splitter->setSizes({270, 1010});
  setCentralWidget(splitter);
  tree_->setAccessibleName(tr("Files and pages"));
  makeLink();
  makeButtons();
  makeMenus();
  new desktop::MenuKeys(*this);
  file_check_timer_ = new QTimer(this);
  file_check_timer_->setInterval(1000);
  connect(file_check_timer_, &QTimer::timeout, this, &PlotWindow::checkForFileChanges);
  connect(view_, &desktop::ChartView::cursorsChanged, this, [this] {
    cursor_label_->setText(view_->cursorReport());
    fitCursors();
    offerChartActions();
  });
  connect(view_, &desktop::ChartView::viewChanged, this, &PlotWindow::offerChartActions);

  connect(tree_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
    if (!item || item->data(0, kPageRole).toInt() < 1) return;
    current_ = item->data(0, kFileRole).toInt();
    page_ = item->data(0, kPageRole).toInt();
    values_.clear();  // of the page before
    showCurrentPage();
    sendElement();
  });
  connect(view_, &desktop::ChartView::runsChosen, this, &PlotWindow::showRuns);
  // The panel under the pointer provides the curve of the spectrogram.
  connect(view_, &desktop::ChartView::panelClicked, this, [this](std::size_t index) {
    const desktop::ChartPage& page = view_->chartScene().page();
    if (!page.choices.empty() || page.equal_axes || index >= page.panels.size()) return;
    for (const desktop::ChartCurve& curve : page.panels[index].curves)
      if (!curve.hidden && !curve.y.empty()) {
        options_.spectrogram_of = curve_name(page.panels[index], curve);
        return;
      }
  });
  connect(view_, &desktop::ChartView::readoutChanged, this, [this](const QStringList& values) {
    values_ = values;
    showReadout();
  });
  connect(view_, &desktop::ChartView::curvesChanged, this, [this] {
    values_.clear();  // of other curves
    fitReadout();
    updateCurveNameActions();
  });
  showCurrentPage();
}

PlotWindow::~PlotWindow() = default;

PlotWindow::Document* PlotWindow::document() {
  return current_ >= 0 && current_ < fileCount()
             ? documents_[static_cast<std::size_t>(current_)].get()
             : nullptr;
}

/// A file and the folder of its run.
QString PlotWindow::nameOf(const Document& document) {
  const QString file = QString::fromStdString(document.path.filename().string());
  const QString folder = QString::fromStdString(run_folder(document.path).filename().string());
  return document.on_disk && !folder.isEmpty() ? folder + "/" + file : file;
}

int PlotWindow::pageCount() const {
  return current_ >= 0 && current_ < fileCount()
             ? static_cast<int>(documents_[static_cast<std::size_t>(current_)]->pages.size())
             : 0;
}

void PlotWindow::showPage(int number) {
  if (number < 1 || number > pageCount()) return;
  auto* item = tree_->topLevelItem(current_)->child(number - 1);
  if (tree_->currentItem() == item)
    showCurrentPage();
  else
    tree_->setCurrentItem(item);
}

void PlotWindow::setAbscissa(Abscissa abscissa) {
  abscissa_->setCurrentIndex(static_cast<int>(abscissa));
}

void PlotWindow::setDomain(Domain domain) { domain_->setCurrentIndex(static_cast<int>(domain)); }

/// The menus follow.
void PlotWindow::setSpectrum(const SpectrumOptions& spectrum) {
  constexpr std::array kWindows{Window::Hann, Window::FlatTop, Window::None};
  const auto window = std::find(kWindows.begin(), kWindows.end(), spectrum.window);
  const auto scale = std::find(kScales.begin(), kScales.end(), spectrum.scale);
  const std::array<qsizetype, 4> chosen{scale - kScales.begin(), window - kWindows.begin(),
                                        spectrum.over_speed ? 1 : 0,
                                        static_cast<qsizetype>(spectrum.orders_of)};
  options_.spectrum.band = spectrum.band;  // drawn with the others
  for (std::size_t i = 0; i < chosen.size(); ++i)
    spectrum_actions_.at(static_cast<qsizetype>(i))->menu()->actions().at(chosen.at(i))->trigger();
}

void PlotWindow::setSpectrogramCurve(const std::string& curve) {
  options_.spectrogram_of = curve;
  if (options_.domain == Domain::Spectrogram) showCurrentPage();
}

void PlotWindow::setLogAxes(std::optional<bool> abscissa, std::optional<bool> values) {
  log_x_ = abscissa;
  log_y_ = values;
  showCurrentPage();
}

desktop::ChartPage PlotWindow::chartOf(const PlotDocument& file, int page) const {
  desktop::ChartPage chart = buildPage(file, page);
  if (!chart.equal_axes) {
    chart.log_x = log_x_.value_or(chart.log_x);
    for (auto& panel : chart.panels)
      panel.log = !is_decibel(panel.unit) && !panel.rows && log_y_.value_or(panel.log);
  }
  return chart;
}

void PlotWindow::showCurrentPage() {
  Document* doc = document();
  desktop::ChartPage chart;
  if (doc) {
    try {
      chart = chartOf(*doc, page_);
    } catch (const std::exception& error) {
      chart = {};
      chart.title = doc->pages[static_cast<std::size_t>(page_ - 1)].title;
      chart.note = error.what();
      reading_progress_dialog_.reset();
    }
    const PageKind kind = doc->pages[static_cast<std::size_t>(page_ - 1)].kind;
    orbit_action_->setVisible(kind == PageKind::Orbit);
    enableChoices(kind, chart);
    fillSpectrogramCurves(chart);
    // Races without relative rotation have no revolutions.
    const bool no_turns = kind == PageKind::History && options_.domain == Domain::History &&
                          options_.abscissa == Abscissa::Revolutions && chart.x_title == "Time";
    abscissa_->setItemText(0, no_turns ? tr("over time (no rotation)") : tr("over revolutions"));
    note_->setText(doc->note.empty()
                       ? QString()
                       : tr("Incomplete file: %1.").arg(QString::fromStdString(doc->note)));
    setWindowTitle(
        QString("%1 — page %2 of %3 — AdrPlot").arg(nameOf(*doc)).arg(page_).arg(pageCount()));
  } else {
    chart.title = "AdrPlot";
    chart.note =
        "Open or drop a result file (SOL1 to SOL7, RESULTS.h5, RUN.json), a table (*.csv), a "
        "session (*.adrplot), a project (PROJECT.json) or the folder of a run or study.";
    orbit_action_->setVisible(false);
    fillSpectrogramCurves(chart);
  }
  note_->setVisible(!note_->text().isEmpty());
  showFindings();
  {
    const QSignalBlocker quiet_x(log_x_action_), quiet_y(log_y_action_);
    log_x_action_->setChecked(chart.log_x);
    log_y_action_->setChecked(std::any_of(chart.panels.begin(), chart.panels.end(),
                                          [](const auto& panel) { return panel.log; }));
  }
  emphasizeLinkedElement(chart);
  {
    const QScopedValueRollback quiet(taking_, true);
    view_->showPage(std::move(chart));
  }
  joinLink();
  showLinkedTime();
  selectCurrentRun();
  fillStatistics();
  updateCurveNameActions();
  view_->setMinimumHeight(static_cast<int>(view_->chartScene().minReadableHeight()));
  fitReadout();
}

void PlotWindow::showFindings() {
  const Document* const doc = document();
  if (doc == nullptr || !doc->on_disk) {
    findings_file_stamp_.clear();
    return findings_->setFindings({});
  }
  const std::filesystem::path report = run_folder(doc->path) / "RUN.json";
  std::error_code error;
  const auto written = std::filesystem::last_write_time(report, error);
  const std::string seen =
      report.string() + std::to_string(error ? 0 : written.time_since_epoch().count());
  if (seen != findings_file_stamp_) {
    findings_file_stamp_ = seen;
    findings_->setFindings(results::run_findings(doc->path));
    markPagesWithWarnings();
  }
  findings_->setCurrentPage(
      page_concerns(doc->pages[static_cast<std::size_t>(page_ - 1)].title, doc->subject),
      tr("This page"));
}

/// Marks the pages of warnings.
void PlotWindow::markPagesWithWarnings() {
  const Document* const here = document();
  std::set<std::string> topics;
  for (const Finding& one : findings_->findings())
    if (one.severity > Severity::Note) topics.insert(topic_of(one));
  topics.erase("");
  for (int k = 0; k < tree_->topLevelItemCount() && k < fileCount(); ++k) {
    const Document& doc = *documents_[static_cast<std::size_t>(k)];
    const bool of_run = here != nullptr && run_folder(doc.path) == run_folder(here->path);
    QTreeWidgetItem* root = tree_->topLevelItem(k);
    for (int p = 0; p < root->childCount() && p < static_cast<int>(doc.pages.size()); ++p) {
      const bool marked =
          of_run && topics.count(topic_of_page(doc.pages[static_cast<std::size_t>(p)].title,
                                               doc.subject)) > 0;
      root->child(p)->setIcon(0, marked ? desktop::warning_icon() : QIcon());
      // The list may be too narrow for the title.
      const QString title = QString::fromStdString(doc.pages[static_cast<std::size_t>(p)].title);
      root->child(p)->setToolTip(
          0, marked ? tr("%1\nA warning of the run concerns this page").arg(title) : title);
    }
  }
}

void PlotWindow::goToFinding(const Finding& finding) {
  const std::string topic = topic_of(finding);
  const Document* const here = document();
  if (here == nullptr) return;
  const std::filesystem::path folder = run_folder(here->path);
  const int element = desktop::parse_element_number(finding.body);
  // The best page: of this run and topic, with a panel of the quantity, over time if the finding
  // has one, of its element.
  int best = -1, best_page = 0, best_score = 0;
  for (int k = 0; k < fileCount(); ++k) {
    const Document& one = *documents_[static_cast<std::size_t>(k)];
    if (run_folder(one.path) != folder) continue;
    for (std::size_t p = 0; p < one.pages.size(); ++p) {
      if (topic.empty() || topic_of_page(one.pages[p].title, one.subject) != topic) continue;
      const bool of_element = element > 0 && one.subject.ends_with(" " + std::to_string(element));
      const bool over_time = one.pages[p].kind == PageKind::History;
      const auto& panels = one.pages[p].panels;
      const bool shows = std::any_of(panels.begin(), panels.end(), [&](const std::string& title) {
        return panel_concerns(title, finding);
      });
      const int score = 1 + (shows ? 8 : 0) + (of_element ? 4 : 0) +
                        (finding.time && over_time ? 2 : 0) + (k == current_ ? 1 : 0);
      if (score <= best_score) continue;
      best = k;
      best_page = static_cast<int>(p) + 1;
      best_score = score;
    }
  }
  if (best >= 0) {
    if (finding.time) setAbscissa(Abscissa::Time);
    if (QTreeWidgetItem* item = tree_->topLevelItem(best)->child(best_page - 1))
      tree_->setCurrentItem(item);
  }
  // Its curves are drawn thick until another page or finding is chosen.
  desktop::ChartPage emphasized = view_->chartScene().page();
  if (!emphasized.equal_axes) {
    for (desktop::ChartPanel& panel : emphasized.panels)
      for (desktop::ChartCurve& curve : panel.curves) curve.heavy = false;
    for (const auto& [panel, curve] : concerned_curves(emphasized, finding))
      emphasized.panels[panel].curves[curve].heavy = true;
    view_->chartScene().setPage(std::move(emphasized), true);
  }
  const desktop::ChartPage& page = view_->chartScene().page();
  if (finding.time && page.x_unit == "s" && page.x_title == "Time")
    view_->setCursorAbscissa(0, *finding.time);
  statusBar()->showMessage(desktop::finding_text(finding), 20000);
}

/// Cursor values, in at most a third of the window, next to the smallest chart.
void PlotWindow::fitCursors() {
  const int needed = cursor_label_->heightForWidth(std::max(view_->width(), 100));
  cursors_area_->setFixedHeight(std::clamp(needed, 0, std::max(0, height() - kLeastChart) / 3));
  // The table has the same values.
  cursors_area_->setVisible(!cursor_label_->text().isEmpty() && statistics_dock_->isHidden());
}

void PlotWindow::resizeEvent(QResizeEvent* event) {
  QMainWindow::resizeEvent(event);
  fitReadout();
  fitCursors();
}

/// Duration of the message at the first and last page [ms].
static constexpr int kTold = 4000;

void PlotWindow::previousPage() {
  if (!document()) return askForFile();
  if (page_ <= 1) return statusBar()->showMessage(tr("This is the first plot."), kTold);
  showPage(page_ - 1);
}

void PlotWindow::nextPage() {
  if (!document()) return askForFile();
  if (page_ >= pageCount()) return statusBar()->showMessage(tr("This is the last plot."), kTold);
  showPage(page_ + 1);
}

void PlotWindow::askForPage() {
  if (!document()) return askForFile();
  desktop::ask_number(this, tr("Plot number"), tr("Plot (1 to %1):").arg(pageCount()), page_, 1,
                      pageCount(), [this](int number) { showPage(number); });
}

void PlotWindow::switchTheme() {
  using desktop::ThemeKind;
  desktop::apply_theme(desktop::current_theme().kind == ThemeKind::Dark ? ThemeKind::Light
                                                                        : ThemeKind::Dark);
  desktop::remember_theme(desktop::current_theme().kind);
  view_->chartScene().setTheme(desktop::current_theme());
}

}  // namespace adore::adrplot
