#include "adrplot/curve_dialog.hpp"
#include "adrplot/plot_window.hpp"
#include "adrplot/range_dialog.hpp"
#include "desktop/dialogs.hpp"

#include <QFileDialog>
#include <QFileInfo>
#include <QSettings>

#include <exception>

/// Dialogs before reading: files, steps, curves.
namespace adore::adrplot {

void PlotWindow::askForFile() {
  desktop::ask_files(this, kApp, tr("Open plot files"), "SOL[1-7] RUN.json SWEEP.csv ACCURACY.json",
                     [this](const QStringList& names) { openSeveral(names); });
}

void PlotWindow::askForFolder() {
  auto* dialog = new QFileDialog(this, tr("Open the plot files of a folder"),
                                 QSettings("Adore", kApp).value("open/folder").toString());
  dialog->setObjectName("folder");
  desktop::delete_when_done(*dialog);
  dialog->setFileMode(QFileDialog::Directory);
  dialog->setOption(QFileDialog::ShowDirsOnly);
  connect(
      dialog, &QFileDialog::fileSelected, this,
      [this](const QString& folder) { openFolder(folder); }, Qt::QueuedConnection);
  dialog->open();
}

void PlotWindow::askForRange(const QString& path) {
  if (!has_steps(path.toStdString())) {
    openFile(path.toStdString());
    return;
  }
  long stored = 0;
  try {
    // The origin is checked before the user enters numbers.
    if (results::sol_kind(path.toStdString()) == results::SolKind::Animation)
      plot_pages(results::SolKind::Animation, {});
    stored = results::stored_steps(path.toStdString());
  } catch (const std::exception& error) {
    desktop::show_message(this, QString::fromUtf8(error.what()), true);
    return;
  }
  auto* dialog = new RangeDialog(QFileInfo(path).fileName(), stored, this);
  dialog->setObjectName("range");
  connect(dialog, &QDialog::accepted, this,
          [this, dialog, path] { openFile(path.toStdString(), dialog->range()); });
  dialog->open();
}

void PlotWindow::askForCurves() {
  std::vector<const PlotDocument*> files;
  for (const auto& doc : documents_)
    if (doc->on_disk) files.push_back(doc.get());
  if (files.empty()) return askForFile();
  auto* dialog = new CurveDialog(files, options_, chosen_curves_, this);
  dialog->setObjectName("curveDialog");
  dialog->setModal(true);
  connect(dialog, &QDialog::accepted, this, [this, dialog] {
    chosen_curves_ = dialog->choice();
    addChart(dialog->picks(), dialog->how());
  });
  dialog->open();
}

void PlotWindow::addChart(const std::vector<CurvePick>& picks, Combine how) {
  // Copies share the data read from files, and outlive them in the tree.
  auto files = std::make_shared<std::vector<PlotDocument>>();
  std::vector<std::size_t> of;
  for (const CurvePick& pick : picks) {
    of.push_back(files->size());
    files->push_back(*pick.file);
  }
  const auto build = [files, of, picks, how](int, const PageOptions& options) {
    std::vector<CurvePick> own = picks;
    for (std::size_t i = 0; i < own.size(); ++i) own[i].file = &(*files)[of[i]];
    return combine_curves(own, how, options);
  };
  try {
    (void)build(1, options_);
  } catch (const std::exception& error) {
    desktop::show_message(this, QString::fromUtf8(error.what()), true);
    return;
  }
  int number = 1;
  for (const auto& document : documents_) number += document->on_disk ? 0 : 1;
  PlotDocument chart;
  chart.path = QString("chart-%1").arg(number).toStdString();
  chart.subject = "own chart";
  chart.pages = {
      {how == Combine::Difference ? "Differences" : "Selected curves", PageKind::History}};
  chart.build = build;
  addDocument(std::move(chart), {}, false);
}

}  // namespace adore::adrplot
