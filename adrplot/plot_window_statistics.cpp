#include "adrplot/plot_window.hpp"
#include "adrplot/statistics_table.hpp"
#include "desktop/chart_view.hpp"
#include "desktop/dialogs.hpp"
#include "desktop/image_export.hpp"

#include <QAction>
#include <QClipboard>
#include <QDockWidget>
#include <QFileDialog>
#include <QGuiApplication>
#include <QHeaderView>
#include <QMenu>
#include <QTableView>

#include <algorithm>
#include <cmath>
#include <exception>

/// Statistics of the visible curves below the chart.
namespace adore::adrplot {

void PlotWindow::makeStatistics() {
  statistics_dock_ = new QDockWidget(tr("Statistics"), this);
  statistics_dock_->setObjectName("statisticsDock");
  statistics_model_ = new StatisticsModel(this);
  statistics_table_ = new QTableView(statistics_dock_);
  statistics_table_->setObjectName("statistics");
  statistics_table_->setAccessibleName(tr("Statistics"));
  statistics_table_->setModel(statistics_model_);
  statistics_table_->verticalHeader()->hide();
  statistics_table_->setAlternatingRowColors(true);
  statistics_table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  statistics_table_->setContextMenuPolicy(Qt::ActionsContextMenu);
  auto* copy = new QAction(tr("&Copy"), statistics_table_);
  connect(copy, &QAction::triggered, this, &PlotWindow::copyStatisticsRows);
  auto* save = new QAction(tr("&Export as CSV..."), statistics_table_);
  connect(save, &QAction::triggered, this, &PlotWindow::exportStatistics);
  statistics_table_->addActions({copy, save});
  statistics_dock_->setWidget(statistics_table_);
  addDockWidget(Qt::BottomDockWidgetArea, statistics_dock_);
  statistics_dock_->hide();
  statistics_action_ = statistics_dock_->toggleViewAction();
  statistics_action_->setText(tr("&Statistics Table"));
  statistics_action_->setShortcut(Qt::CTRL | Qt::Key_T);
  connect(statistics_dock_, &QDockWidget::visibilityChanged, this, [this] {
    fillStatistics();
    fitCursors();
  });
  for (auto signal : {&desktop::ChartView::cursorsChanged, &desktop::ChartView::curvesChanged})
    connect(view_, signal, this, &PlotWindow::fillStatistics);
  // Also emitted while only the pointer moves.
  connect(view_, &desktop::ChartView::viewChanged, this, [this] {
    if (statisticsRange() != statistics_range_) fillStatistics();
  });
}

void PlotWindow::showStatistics(bool on) { statistics_dock_->setVisible(on); }

/// Between the cursors, else the visible range.
std::pair<double, double> PlotWindow::statisticsRange() const {
  const double a = view_->cursorAbscissa(0), b = view_->cursorAbscissa(1);
  if (std::isfinite(a) && std::isfinite(b)) return std::minmax({a, b});
  return {view_->chartScene().viewLow(), view_->chartScene().viewHigh()};
}

void PlotWindow::fillStatistics() {
  if (statistics_dock_->isHidden()) return;
  statistics_range_ = statisticsRange();
  const auto [from, to] = statistics_range_;
  const bool cursors =
      std::isfinite(view_->cursorAbscissa(0)) && std::isfinite(view_->cursorAbscissa(1));
  statistics_model_->setRows(statistics_rows(view_->chartScene().page(), from, to));
  statistics_table_->resizeColumnsToContents();
  const std::string& unit = view_->chartScene().page().x_unit;
  statistics_dock_->setWindowTitle(
      (cursors ? tr("Statistics between the cursors: %1 to %2")
               : tr("Statistics of the visible range: %1 to %2"))
          .arg(QString::fromStdString(desktop::pretty_quantity(from, unit)),
               QString::fromStdString(desktop::pretty_quantity(to, unit))));
  statistics_action_->setText(tr("&Statistics Table"));  // a dock gives its title to its action
}

/// The selected rows, else all.
void PlotWindow::copyStatisticsRows() {
  std::vector<StatisticsRow> rows;
  for (const QModelIndex& index : statistics_table_->selectionModel()->selectedRows())
    rows.push_back(statistics_model_->rows().at(static_cast<std::size_t>(index.row())));
  if (rows.empty()) rows = statistics_model_->rows();
  QGuiApplication::clipboard()->setText(QString::fromStdString(statistics_text(rows, '\t')));
  desktop::show_in_status_bar(this, tr("Copied the statistics."));
}

void PlotWindow::exportStatistics() {
  auto* dialog = new QFileDialog(this, tr("Export statistics"), QString(), tr("CSV (*.csv)"));
  dialog->setObjectName("exportStatistics");
  desktop::delete_when_done(*dialog);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix("csv");
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
    try {
      desktop::save_bytes(
          QByteArray::fromStdString(statistics_text(statistics_model_->rows(), ',')),
          path.toStdString());
      desktop::show_in_status_bar(this, tr("Saved %1.").arg(path));
    } catch (const std::exception& error) {
      desktop::show_message(this, QString::fromUtf8(error.what()), true);
    }
  });
  dialog->open();
}

}  // namespace adore::adrplot
