#include "adrplot/plot_window.hpp"
#include "desktop/chart_view.hpp"

#include <QAction>
#include <QMenu>

#include <algorithm>

/// Key commands for the mouse actions of a chart: each is in a menu, which shows its key.
namespace adore::adrplot {

using desktop::ChartDeed;

/// The key is the chart's alone: in the list of pages arrows and letters find pages.
void PlotWindow::addDeed(QMenu* menu, ChartDeed deed, const QString& text,
                         const QList<QKeySequence>& keys) {
  auto* action = menu->addAction(text, this, [this, deed] { view_->perform(deed); });
  action->setData(static_cast<int>(deed));
  action->setShortcuts(keys);
  action->setShortcutContext(Qt::WidgetShortcut);
  view_->addAction(action);
  deeds_.emplace_back(action, deed);
}

void PlotWindow::makeKeyMenus(QMenu* view) {
  const auto menu = [view](const QString& title) {
    auto* out = view->addMenu(title);
    out->setToolTipsVisible(true);
    return out;
  };
  QMenu* move = menu(tr("&Move"));
  addDeed(move, ChartDeed::MoveLeft, tr("&Left"), {Qt::Key_Left});
  addDeed(move, ChartDeed::MoveRight, tr("&Right"), {Qt::Key_Right});
  addDeed(move, ChartDeed::FarLeft, tr("&Far Left"), {Qt::SHIFT | Qt::Key_Left});
  addDeed(move, ChartDeed::FarRight, tr("Far Ri&ght"), {Qt::SHIFT | Qt::Key_Right});
  addDeed(move, ChartDeed::MoveUp, tr("&Up"), {Qt::Key_Up});
  addDeed(move, ChartDeed::MoveDown, tr("&Down"), {Qt::Key_Down});
  QMenu* panel = menu(tr("&Panel"));
  addDeed(panel, ChartDeed::PanelAbove, tr("Panel &Above"), {Qt::CTRL | Qt::Key_Up});
  addDeed(panel, ChartDeed::PanelBelow, tr("Panel &Below"), {Qt::CTRL | Qt::Key_Down});
  addDeed(panel, ChartDeed::EnlargeValues, tr("&Enlarge Values"),
          {Qt::CTRL | Qt::Key_Plus, Qt::CTRL | Qt::Key_Equal});
  addDeed(panel, ChartDeed::ReduceValues, tr("&Reduce Values"), {Qt::CTRL | Qt::Key_Minus});
  QMenu* read = menu(tr("&Read Values"));
  addDeed(read, ChartDeed::ReadBack, tr("&Previous Point"), {Qt::CTRL | Qt::Key_Left});
  addDeed(read, ChartDeed::ReadOn, tr("&Next Point"), {Qt::CTRL | Qt::Key_Right});
  addDeed(read, ChartDeed::ReadFarBack, tr("Se&veral Points Back"),
          {Qt::CTRL | Qt::SHIFT | Qt::Key_Left});
  addDeed(read, ChartDeed::ReadFarOn, tr("Several Points &Forward"),
          {Qt::CTRL | Qt::SHIFT | Qt::Key_Right});
  read->addSeparator();
  addDeed(read, ChartDeed::CursorA, tr("Toggle Cursor &A"), {Qt::Key_A});
  addDeed(read, ChartDeed::CursorB, tr("Toggle &Cursor B"), {Qt::Key_B});
}

void PlotWindow::offerDeeds() {
  for (const auto& [action, deed] : deeds_) {
    const QString reason = view_->whyNot(deed);
    action->setEnabled(reason.isEmpty());
    action->setToolTip(reason);
  }
}

QAction* PlotWindow::nameAction(qsizetype number) {
  while (names_.size() <= number) {
    auto* action = names_menu_->addAction(QString());
    action->setCheckable(true);
    if (const auto digit = names_.size() + 1; digit <= 9) {
      action->setShortcut(QKeySequence(static_cast<int>(Qt::Key_0 + digit)));
      action->setShortcutContext(Qt::WidgetShortcut);
      view_->addAction(action);
    }
    connect(action, &QAction::triggered, this, [this, place = names_.size()] {
      const auto names = view_->namedCurves();
      if (place >= static_cast<qsizetype>(names.size())) return;
      const auto& name = names[static_cast<std::size_t>(place)];
      view_->toggleCurve(name.panel, name.curve);
    });
    names_ << action;
  }
  return names_[number];
}

void PlotWindow::offerNames() {
  const auto names = view_->namedCurves();
  const auto& panels = view_->chartScene().page().panels;
  const auto count = static_cast<qsizetype>(names.size());
  for (qsizetype i = 0; i < std::max(count, names_.size()); ++i) {
    QAction* action = nameAction(i);
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
  names_menu_->menuAction()->setEnabled(count > 0);
  names_menu_->menuAction()->setToolTip(count > 0 ? QString()
                                                  : tr("This page has no named curves."));
}

}  // namespace adore::adrplot
