#include "adrplot/band_dialog.hpp"
#include "adrplot/curve_dialog.hpp"
#include "adrplot/plot_window.hpp"
#include "adrplot/range_dialog.hpp"
#include "desktop/dialogs.hpp"

#include <QFileDialog>
#include <QFileInfo>
#include <QSettings>

#include <exception>

/// Dialogs for files, steps, curves, and the band of envelopes.
namespace adore::adrplot {

void PlotWindow::askForFile() {
  desktop::ask_files(this, kApp, tr("Open plot files"),
                     "SOL[1-7] RESULTS.h5 RUN.json ACCURACY.json *.csv *.adrplot PROJECT.json",
                     [this](const QStringList& names) { openFiles(names); });
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

void PlotWindow::askForBand() {
  auto* dialog = new BandDialog(options_.spectrum.band, this);
  dialog->setObjectName("bandDialog");
  connect(dialog, &QDialog::accepted, this, [this, dialog] {
    options_.spectrum.band = dialog->band();
    showCurrentPage();
  });
  dialog->open();
}

void PlotWindow::askForCurves() {
  std::vector<const PlotDocument*> files;
  for (const auto& doc : documents_)
    if (doc->on_disk) files.push_back(doc.get());
  if (files.empty()) return askForFile();
  auto* dialog = new CurveDialog(files, options_, last_curve_choice_, this);
  dialog->setObjectName("curveDialog");
  dialog->setModal(true);
  connect(dialog, &QDialog::accepted, this, [this, dialog] {
    last_curve_choice_ = dialog->choice();
    addChart(dialog->picks(), dialog->how());
  });
  dialog->open();
}

}  // namespace adore::adrplot
