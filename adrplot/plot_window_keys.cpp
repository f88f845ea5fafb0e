#include "adrplot/plot_window.hpp"
#include "desktop/chart_view.hpp"

#include <QAction>
#include <QMenu>

#include <algorithm>

/// Key commands for the mouse actions of a chart: each is in a menu, which shows its key.
namespace adore::adrplot {

using desktop::ChartAction;

/// The key is the chart's alone: in the list of pages arrows and letters find pages.
void PlotWindow::addChartAction(QMenu* menu, ChartAction chart_action, const QString& text,
                                const QList<QKeySequence>& keys) {
  auto* action =
      menu->addAction(text, this, [this, chart_action] { view_->perform(chart_action); });
  action->setData(static_cast<int>(chart_action));
  action->setShortcuts(keys);
  action->setShortcutContext(Qt::WidgetShortcut);
  view_->addAction(action);
  chart_actions_.emplace_back(action, chart_action);
}

void PlotWindow::makeKeyMenus(QMenu* view) {
  const auto menu = [view](const QString& title) {
    auto* out = view->addMenu(title);
    out->setToolTipsVisible(true);
    return out;
  };
  QMenu* move = menu(tr("&Move"));
  addChartAction(move, ChartAction::MoveLeft, tr("&Left"), {Qt::Key_Left});
  addChartAction(move, ChartAction::MoveRight, tr("&Right"), {Qt::Key_Right});
  addChartAction(move, ChartAction::FarLeft, tr("&Far Left"), {Qt::SHIFT | Qt::Key_Left});
  addChartAction(move, ChartAction::FarRight, tr("Far Ri&ght"), {Qt::SHIFT | Qt::Key_Right});
  addChartAction(move, ChartAction::MoveUp, tr("&Up"), {Qt::Key_Up});
  addChartAction(move, ChartAction::MoveDown, tr("&Down"), {Qt::Key_Down});
  QMenu* panel = menu(tr("&Panel"));
  addChartAction(panel, ChartAction::PanelAbove, tr("Panel &Above"), {Qt::CTRL | Qt::Key_Up});
  addChartAction(panel, ChartAction::PanelBelow, tr("Panel &Below"), {Qt::CTRL | Qt::Key_Down});
  addChartAction(panel, ChartAction::EnlargeValues, tr("&Enlarge Values"),
                 {Qt::CTRL | Qt::Key_Plus, Qt::CTRL | Qt::Key_Equal});
  addChartAction(panel, ChartAction::ReduceValues, tr("&Reduce Values"),
                 {Qt::CTRL | Qt::Key_Minus});
  QMenu* read = menu(tr("&Read Values"));
  addChartAction(read, ChartAction::ReadBack, tr("&Previous Point"), {Qt::CTRL | Qt::Key_Left});
  addChartAction(read, ChartAction::ReadOn, tr("&Next Point"), {Qt::CTRL | Qt::Key_Right});
  addChartAction(read, ChartAction::ReadFarBack, tr("Se&veral Points Back"),
                 {Qt::CTRL | Qt::SHIFT | Qt::Key_Left});
  addChartAction(read, ChartAction::ReadFarOn, tr("Several Points &Forward"),
                 {Qt::CTRL | Qt::SHIFT | Qt::Key_Right});
  read->addSeparator();
  addChartAction(read, ChartAction::CursorA, tr("Toggle Cursor &A"), {Qt::Key_A});
  addChartAction(read, ChartAction::CursorB, tr("Toggle &Cursor B"), {Qt::Key_B});
}

void PlotWindow::offerChartActions() {
  for (const auto& [action, chart_action] : chart_actions_) {
    const QString reason = view_->disabledReason(chart_action);
    action->setEnabled(reason.isEmpty());
    action->setToolTip(reason);
  }
}

QAction* PlotWindow::curveNameAction(qsizetype number) {
  while (curve_name_actions_.size() <= number) {
    auto* action = curve_names_menu_->addAction(QString());
    action->setCheckable(true);
    if (const auto digit = curve_name_actions_.size() + 1; digit <= 9) {
      action->setShortcut(QKeySequence(static_cast<int>(Qt::Key_0 + digit)));
      action->setShortcutContext(Qt::WidgetShortcut);
      view_->addAction(action);
    }
    connect(action, &QAction::triggered, this, [this, place = curve_name_actions_.size()] {
      const auto names = view_->legendCurves();
      if (place >= static_cast<qsizetype>(names.size())) return;
      const auto& name = names[static_cast<std::size_t>(place)];
      view_->toggleCurve(name.panel, name.curve);
    });
    curve_name_actions_ << action;
  }
  return curve_name_actions_[number];
}

void PlotWindow::updateCurveNameActions() {
  const auto names = view_->legendCurves();
  const auto& panels = view_->chartScene().page().panels;
  const auto count = static_cast<qsizetype>(names.size());
  for (qsizetype i = 0; i < std::max(count, curve_name_actions_.size()); ++i) {
    QAction* action = curveNameAction(i);
    action->setVisible(i < count);
    action->setEnabled(i < count);
    if (i >= count) continue;
    const auto& name = names[static_cast<std::size_t>(i)];
    const desktop::ChartPanel& panel = panels[name.panel];
    QString text = QString::fromStdString(panel.curves[name.curve].name);
    if (names.front().panel != names.back().panel)
      text.prepend(QString::fromStdString(panel.title) + ": ");
    action->setText(text.replace('&', "&&"));
    action->setChecked(!panel.curves[name.curve].hidden);
  }
  curve_names_menu_->menuAction()->setEnabled(count > 0);
  curve_names_menu_->menuAction()->setToolTip(count > 0 ? QString()
                                                        : tr("This page has no named curves."));
}

}  // namespace adore::adrplot
