#include "adrinput/accuracy_panel.hpp"
#include "adrinput/deck_window.hpp"
#include "adrinput/design_form.hpp"
#include "adrinput/design_page.hpp"
#include "adrinput/evaluation.hpp"
#include "adrinput/find_dialog.hpp"
#include "adrinput/record_page.hpp"
#include "adrinput/run_panel.hpp"
#include "adrinput/solution_charts.hpp"
#include "adrinput/sweep_range.hpp"
#include "desktop/dialogs.hpp"
#include "runs/unused_request.hpp"

#include <QDockWidget>
#include <QInputDialog>
#include <QTabWidget>

#include <cmath>
#include <exception>

/// Results of the window: plan, equilibrium with its charts, accuracy, runs and sweeps.
namespace adore::adrinput {

bool DeckWindow::readyToCompute() {
  if (isDesignShown()) design_page_->form().commitFields();
  document_.end_undo_step();  // includes the text being typed
  if (!document_.has_errors()) return true;
  desktop::show_message(this, tr("The deck has errors. Correct them first (F8)."), true);
  return false;
}

void DeckWindow::showPanel(const QWidget* panel) {
  tabs_->show();
  for (int i = 0; i < tabs_->count(); ++i)
    if (tabs_->widget(i) == panel || tabs_->widget(i)->isAncestorOf(panel))
      tabs_->setCurrentIndex(i);
}

void DeckWindow::showPlan() {
  showPanel(plan_panel_);
  if (!readyToCompute()) return;
  plan_panel_->start(document_.deck(), document_.path(), document_.options());
}

void DeckWindow::runQuasiStatic() {
  showPanel(statics_panel_);
  if (!readyToCompute()) return;
  statics_panel_->start(document_.deck(), document_.path(), document_.options());
}

void DeckWindow::showCharts() {
  if (statics_panel_->tables() == nullptr) return;
  solution_charts_->setSolution(*statics_panel_->tables());
  solution_charts_->setStale(statics_panel_->stale());
  if (isDesignShown()) {  // which has the space of the docks
    charts_dock_->setProperty("waiting", true);
    return;
  }
  if (!drawing_dock_->isHidden() || !charts_dock_->isHidden()) {
    const int made = width() < kNarrow ? kDrawingWidth * 2 / 3 : kDrawingWidth;
    const bool as_made = std::abs(drawing_dock_->width() - made) < kDrawingWidth / 10;
    charts_dock_->show();
    charts_dock_->raise();
    // Legends of curves need more space than the drawing; a width chosen by the user is kept.
    const int wanted = width() < kNarrow ? 0 : width() / 3;
    if (as_made)
      resizeDocks({charts_dock_}, {std::max(wanted, solution_charts_->fullChartWidth())},
                  Qt::Horizontal);
  }
}

void DeckWindow::hideEmptyPanels() {
  if (statics_panel_->tables() != nullptr || charts_dock_->isHidden()) return;
  charts_dock_->hide();
  if (!drawing_dock_->isHidden()) drawing_dock_->raise();
}

void DeckWindow::studyAccuracy() {
  showPanel(accuracy_panel_);
  if (accuracy_panel_->busy() || !readyToCompute()) return;
  accuracy_panel_->start(document_.deck(), document_.options());
}

void DeckWindow::applyAccuracySettings() {
  try {
    document_.change(accuracy_panel_->recommended());
    record_page_->sync(true);
  } catch (const std::exception& error) {
    desktop::show_message(this, QString::fromUtf8(error.what()), true);
  }
}

void DeckWindow::runDeck() {
  showPanel(run_panel_);
  if (run_panel_->busy() || !readyToCompute()) return;
  withSavedDeck(
      [this] { run_panel_->start(document_.path(), document_.deck(), document_.options()); });
}

void DeckWindow::withSavedDeck(std::function<void()> then) {
  if (document_.path().empty()) return askForName(std::move(then));
  if (document_.modified()) return saveTo(document_.path(), std::move(then));
  then();
}

void DeckWindow::runInNewFolder() {
  showPanel(run_panel_);
  if (run_panel_->busy() || !readyToCompute()) return;
  withSavedDeck([this] {
    run_panel_->startInNewFolder(document_.path(), document_.deck(), document_.options());
  });
}

void DeckWindow::continueRun() {
  showPanel(run_panel_);
  if (run_panel_->busy() || !readyToCompute()) return;
  withSavedDeck([this] {
    run_panel_->continueInterruptedRun(document_.path(), document_.deck(), document_.options());
  });
}

void DeckWindow::openFindDialog() {
  if (!readyToCompute()) return;
  delete find_dialog_;
  find_dialog_ = new FindDialog(document_, this);
  connect(find_dialog_, &FindDialog::solutionApplied, this, [this] { record_page_->sync(true); });
  find_dialog_->show();
}

void DeckWindow::askForSweep() {
  showPanel(run_panel_);
  if (run_panel_->busy() || !readyToCompute()) return;
  auto* dialog = new QInputDialog(this);
  dialog->setObjectName("sweep");
  desktop::delete_when_done(*dialog);
  dialog->setWindowTitle(tr("Sweep"));
  const auto tell = [this, dialog](const QString& typed) {
    QString told = tr("e.g. appLoadZ=500:1500:5 or appLoadZ=0.5 kN:1.5 kN:5");
    try {
      if (!typed.trimmed().isEmpty())
        told = QString::fromStdString(parse_sweep_range(document_, typed.toStdString()).told);
    } catch (const InputError&) {
      const QString unit = QString::fromStdString(sweep_unit(document_, typed.toStdString()));
      if (!unit.isEmpty()) told = tr("Numbers without a unit are in %1.").arg(unit);
    }
    const std::string none = runs::why_no_step(document_.deck());
    const QString end = QString::fromStdString(none.substr(0, none.find(' ')));
    if (!none.empty() && !typed.trimmed().startsWith(end))
      told += tr("\nThe runs have no motion (%1). The table contains static loads,\nbut no mean "
                 "values, speed ratios or heat.")
                  .arg(QString::fromStdString(none));
    dialog->setLabelText(tr("Variable, first value, last value, number of runs:\n%1").arg(told));
  };
  tell({});
  connect(dialog, &QInputDialog::textValueChanged, this, tell);
  connect(dialog, &QInputDialog::textValueSelected, this, [this](const QString& typed) {
    try {
      const QString range =
          QString::fromStdString(parse_sweep_range(document_, typed.toStdString()).set);
      withSavedDeck([this, range] {
        run_panel_->sweep(document_.path(), document_.deck(), document_.options(), range);
      });
    } catch (const InputError& error) {
      desktop::show_message(this, QString::fromUtf8(error.what()), true);
    }
  });
  dialog->open();
}

}  // namespace adore::adrinput
