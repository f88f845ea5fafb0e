#include "adrplot/plot_window.hpp"

#include "adrplot/waterfall_page.hpp"
#include "desktop/chart_view.hpp"
#include "desktop/dialogs.hpp"
#include "desktop/file_drops.hpp"
#include "desktop/menu_keys.hpp"
#include "desktop/window_place.hpp"

#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QProgressDialog>
#include <QScrollArea>
#include <QScrollBar>
#include <QSplitter>
#include <QStatusBar>
#include <QTimer>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <exception>

namespace adore::adrplot {
namespace {

constexpr int kLeastChart = 100;  ///< height of a chart that scrolls

}  // namespace

PlotWindow::PlotWindow(QWidget* parent) : QMainWindow(parent) {
  setWindowTitle("AdrPlot");
  desktop::take_files_anywhere(*this, [this](const QStringList& files) { openSeveral(files); });
  desktop::open_at_size(*this, {1280, 860});

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
  column->addWidget(chart, 1);
  cursors_ = new QLabel(this);
  cursors_->setObjectName("cursors");
  cursors_->setMargin(8);
  cursors_->setWordWrap(true);
  cursors_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  cursors_area_ = new QScrollArea(this);  // a waterfall has many lines
  cursors_area_->setWidget(cursors_);
  cursors_area_->setWidgetResizable(true);
  cursors_area_->setFrameShape(QFrame::NoFrame);
  cursors_area_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  cursors_area_->hide();
  column->addWidget(cursors_area_);
  makeReadout();
  auto* splitter = new QSplitter(this);
  splitter->addWidget(tree_);
  splitter->addWidget(side);
  splitter->setStretchFactor(1, 1);
  splitter->setSizes({270, 1010});
  setCentralWidget(splitter);
  tree_->setAccessibleName(tr("Files and pages"));
  makeButtons();
  makeMenus();
  new desktop::MenuKeys(*this);
  growth_ = new QTimer(this);
  growth_->setInterval(1000);
  connect(growth_, &QTimer::timeout, this, &PlotWindow::lookForGrowth);
  connect(view_, &desktop::ChartView::cursorsChanged, this, [this] {
    cursors_->setText(view_->cursorReport());
    fitCursors();
    offerDeeds();
  });
  connect(view_, &desktop::ChartView::viewChanged, this, &PlotWindow::offerDeeds);

  connect(tree_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
    if (!item || item->data(0, kPageRole).toInt() < 1) return;
    current_ = item->data(0, kFileRole).toInt();
    page_ = item->data(0, kPageRole).toInt();
    values_.clear();  // of the page before
    showCurrent();
  });
  connect(view_, &desktop::ChartView::runsChosen, this, &PlotWindow::showRuns);
  // The panel that somebody points at is the one whose waterfall is wanted.
  connect(view_, &desktop::ChartView::panelClicked, this, [this](std::size_t index) {
    const desktop::ChartPage& page = view_->chartScene().page();
    if (!page.choices.empty() || page.equal_axes || index >= page.panels.size()) return;
    for (const desktop::ChartCurve& curve : page.panels[index].curves)
      if (!curve.hidden && !curve.y.empty()) {
        options_.waterfall_of = curve_name(page.panels[index], curve);
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
    offerNames();
  });
  showCurrent();
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
    showCurrent();
  else
    tree_->setCurrentItem(item);
}

void PlotWindow::setAbscissa(Abscissa abscissa) {
  abscissa_->setCurrentIndex(static_cast<int>(abscissa));
}

void PlotWindow::setDomain(Domain domain) { domain_->setCurrentIndex(static_cast<int>(domain)); }

void PlotWindow::setWaterfallOf(const std::string& curve) {
  options_.waterfall_of = curve;
  if (options_.domain == Domain::Waterfall) showCurrent();
}

void PlotWindow::setLogAxes(std::optional<bool> abscissa, std::optional<bool> values) {
  log_x_ = abscissa;
  log_y_ = values;
  showCurrent();
}

desktop::ChartPage PlotWindow::currentPageChart() {
  desktop::ChartPage chart = document()->build(page_, options_);
  if (!chart.equal_axes) {
    chart.log_x = log_x_.value_or(chart.log_x);
    for (auto& panel : chart.panels)
      panel.log = panel.unit != "dB" && log_y_.value_or(panel.log);  // dB are logarithms
  }
  return chart;
}

void PlotWindow::showCurrent() {
  Document* doc = document();
  desktop::ChartPage chart;
  if (doc) {
    try {
      chart = currentPageChart();
    } catch (const std::exception& error) {
      chart = {};
      chart.title = doc->pages[static_cast<std::size_t>(page_ - 1)].title;
      chart.note = error.what();
      reading_.reset();
    }
    const PageKind kind = doc->pages[static_cast<std::size_t>(page_ - 1)].kind;
    orbit_action_->setVisible(kind == PageKind::Orbit);
    offerChoices(kind, chart);
    offerCurves(chart);
    // Races that do not turn against each other have no turns.
    const bool no_turns = kind == PageKind::History && options_.domain == Domain::History &&
                          options_.abscissa == Abscissa::Revolutions && chart.x_title == "Time";
    abscissa_->setItemText(0, no_turns ? tr("over time (no turns)") : tr("over revolutions"));
    note_->setText(doc->note.empty()
                       ? QString()
                       : tr("This file is incomplete: %1.").arg(QString::fromStdString(doc->note)));
    setWindowTitle(
        QString("%1 — page %2 of %3 — AdrPlot").arg(nameOf(*doc)).arg(page_).arg(pageCount()));
  } else {
    chart.title = "AdrPlot";
    chart.note =
        "Open a plot file (SOL1 to SOL7, RUN.json, SWEEP.csv, ACCURACY.json) or a study's folder, "
        "or drop one here.";
    orbit_action_->setVisible(false);
    offerCurves(chart);
  }
  note_->setVisible(!note_->text().isEmpty());
  {
    const QSignalBlocker quiet_x(log_x_action_), quiet_y(log_y_action_);
    log_x_action_->setChecked(chart.log_x);
    log_y_action_->setChecked(std::any_of(chart.panels.begin(), chart.panels.end(),
                                          [](const auto& panel) { return panel.log; }));
  }
  view_->showPage(std::move(chart));
  offerNames();
  view_->setMinimumHeight(static_cast<int>(view_->chartScene().leastHeight()));
  fitReadout();
}

/// What the cursors tell, in a third of the window at most, beside the least of the chart.
void PlotWindow::fitCursors() {
  const int needed = cursors_->heightForWidth(std::max(view_->width(), 100));
  cursors_area_->setFixedHeight(std::clamp(needed, 0, std::max(0, height() - kLeastChart) / 3));
  cursors_area_->setVisible(!cursors_->text().isEmpty());
}

void PlotWindow::resizeEvent(QResizeEvent* event) {
  QMainWindow::resizeEvent(event);
  fitReadout();
  fitCursors();
}

/// How long the status line tells that pages end [ms].
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
