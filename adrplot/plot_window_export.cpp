#include "adrplot/plot_window.hpp"
#include "base/counted.hpp"
#include "desktop/chart_view.hpp"
#include "desktop/dialogs.hpp"
#include "desktop/image_export.hpp"
#include "desktop/launch.hpp"
#include "desktop/page_export.hpp"
#include "desktop/theme.hpp"

#include <QClipboard>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>
#include <QImage>
#include <QLabel>
#include <QTableView>

#include <algorithm>
#include <exception>

/// Pages of the window as files, on paper and in the clipboard.
namespace adore::adrplot {
namespace {

/// The name of the file with its folder, used to find its pictures. Without a dot: after one
/// ("SWEEP.csv") no suffix is added, and a picture would get the name of its data.
QString besideFile(const PlotDocument& doc) {
  const QFileInfo file(QString::fromStdString(doc.path.string()));
  QString name = file.completeBaseName();
  if (name.isEmpty()) name = file.fileName();
  return file.absoluteDir().filePath(name.replace('.', '-'));
}

template <class Number>
QString told(Number number, const char* one) {
  return QString::fromStdString(counted(number, one));
}

/// The most values that a curve of a page has.
qulonglong valuesOf(const desktop::ChartPage& page) {
  std::size_t out = 0;
  for (const desktop::ChartPanel& panel : page.panels)
    for (const desktop::ChartCurve& curve : panel.curves) out = std::max(out, curve.y.size());
  return out;
}

}  // namespace

bool PlotWindow::exportTo(const QString& path, bool all_pages, bool seen) {
  Document* doc = document();
  if (!doc) return false;
  desktop::ChartScene scene;  // a copy: the visible scene does not change
  scene.setTheme(desktop::current_theme());
  const QSizeF size = view_->viewport()->size();
  const int shown = page_;
  const auto show = [&](int page) {
    page_ = page;
    desktop::ChartPage chart = currentPageChart();
    page_ = shown;
    const auto& panels = view_->chartScene().page().panels;
    for (std::size_t p = 0; page == shown && p < std::min(panels.size(), chart.panels.size()); ++p)
      for (std::size_t c = 0; c < std::min(panels[p].curves.size(), chart.panels[p].curves.size());
           ++c)
        chart.panels[p].curves[c].hidden = panels[p].curves[c].hidden;
    scene.setPage(std::move(chart));
  };
  try {
    if (!all_pages) {
      show(shown);
      scene.setZoom(view_->chartScene().zoom());
      const bool numbers = QFileInfo(path).suffix().toLower() == "csv";
      const bool whole = !scene.zoomed() || scene.whole();
      scene.setPageSize(size);
      if (numbers && seen) {
        scene.setZoom(view_->chartScene().zoom());
        const desktop::ChartPage part = desktop::seen_part(scene);
        desktop::save_bytes(QByteArray::fromStdString(desktop::page_csv(part)), path.toStdString());
        desktop::tell_in_foot(
            this, tr("Exported the visible curves in the visible range to %1 (%2 each).")
                      .arg(path, told(valuesOf(part), "value")));
      } else {
        desktop::save_page(scene, path.toStdString(), size);
        desktop::tell_in_foot(this, !numbers ? tr("Saved %1.").arg(path)
                                    : whole
                                        ? tr("Exported all curves to %1 (%2 each).")
                                              .arg(path, told(valuesOf(scene.page()), "value"))
                                        : tr("Exported all curves to %1 (%2 each), including "
                                             "values outside the visible range.")
                                              .arg(path, told(valuesOf(scene.page()), "value")));
      }
    } else if (QFileInfo(path).suffix().toLower() == "pdf") {
      desktop::save_pdf(scene, path.toStdString(), doc->pages.size(), size,
                        [&](std::size_t i) { show(static_cast<int>(i) + 1); });
      desktop::tell_in_foot(this, tr("Saved %1 in %2.").arg(told(pageCount(), "page"), path));
    } else {
      const QFileInfo info(path);
      for (int page = 1; page <= pageCount(); ++page) {
        show(page);
        desktop::save_page(scene,
                           info.dir()
                               .filePath(QString("%1-%2.%3")
                                             .arg(info.completeBaseName())
                                             .arg(page, 2, 10, QChar('0'))
                                             .arg(info.suffix()))
                               .toStdString(),
                           size);
      }
      desktop::tell_in_foot(this, tr("Saved %1 as numbered files in %2.")
                                      .arg(told(pageCount(), "page"), info.absolutePath()));
    }
    return true;
  } catch (const std::exception& error) {
    page_ = shown;
    desktop::show_message(this, QString::fromUtf8(error.what()), true);
    return false;
  }
}

bool PlotWindow::reportTo(const QString& folder) {
  QStringList words{"report", "--progress", "none", "--out", folder};
  for (const auto& each : documents_) {
    const QString run = QString::fromStdString(each->path.parent_path().string());
    if (each->on_disk && !words.contains(run)) words += run;
  }
  try {
    desktop::tell_in_foot(this, tr("Wrote %1.")
                                    .arg(desktop::output_of_program("adore-pictures", words)
                                             .trimmed()
                                             .replace('\n', tr(" and "))));
    return true;
  } catch (const std::exception& error) {
    desktop::show_message(this, QString::fromUtf8(error.what()), true);
    return false;
  }
}

void PlotWindow::askForReport() {
  Document* doc = document();
  if (!doc) return askForFile();
  auto* dialog =
      new QFileDialog(this, tr("Folder for report.html and report.pdf"),
                      QFileInfo(QString::fromStdString(doc->path.string())).absolutePath());
  dialog->setObjectName("report");
  desktop::delete_when_done(*dialog);
  dialog->setFileMode(QFileDialog::Directory);
  dialog->setOption(QFileDialog::ShowDirsOnly);
  connect(
      dialog, &QFileDialog::fileSelected, this, [this](const QString& folder) { reportTo(folder); },
      Qt::QueuedConnection);
  dialog->open();
}

void PlotWindow::askForExport(bool all_pages) {
  Document* doc = document();
  if (!doc) return askForFile();
  const QString seen = tr("Values of the visible range (*.csv)");
  auto* dialog = new QFileDialog(
      this, all_pages ? tr("Export all pages") : tr("Export page"), QString(),
      tr("PDF (*.pdf);;SVG (*.svg);;PNG (*.png);;JPEG (*.jpg);;All values (*.csv)") +
          (all_pages ? QString() : ";;" + seen));
  dialog->setObjectName("export");
  desktop::delete_when_done(*dialog);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix("pdf");
  connect(dialog, &QFileDialog::filterSelected, dialog, [dialog](const QString& filter) {
    dialog->setDefaultSuffix(filter.section("*.", 1).section(')', 0, 0));
  });
  const QString name = besideFile(*doc);
  dialog->selectFile(all_pages ? name + "-pages"
                               : QString("%1-page-%2").arg(name, QString::number(page_)));
  connect(dialog, &QFileDialog::fileSelected, this,
          [this, all_pages, dialog, seen](const QString& path) {
            exportTo(path, all_pages, dialog->selectedNameFilter() == seen);
          });
  dialog->open();
}

void PlotWindow::exportPage() { askForExport(false); }

void PlotWindow::exportAll() { askForExport(true); }

namespace {

/// As other programs read it: a line each, and minus signs that are ones to them.
QString plain(QString text) {
  return text.replace(QChar::ParagraphSeparator, '\n')
      .replace(QChar::LineSeparator, '\n')
      .replace(QChar(0x2212), '-');
}

}  // namespace

void PlotWindow::copyPicture() {
  if (!document()) return;
  if (statistics_->hasFocus()) return copyTable();
  // Selected text of the statistics is copied.
  if (cursors_->hasSelectedText()) {
    QGuiApplication::clipboard()->setText(plain(cursors_->selectedText()));
    desktop::tell_in_foot(this, tr("Copied the selected text."));
    return;
  }
  QGuiApplication::clipboard()->setImage(view_->chartScene().image(view_->viewport()->size()));
  desktop::tell_in_foot(this, tr("Copied the picture."));
}

void PlotWindow::copyStatistics() {
  if (cursors_->text().isEmpty()) {
    desktop::tell_in_foot(this, tr("Set a cursor first: Ctrl+click (A), Ctrl+Shift+click (B)."));
    return;
  }
  QGuiApplication::clipboard()->setText(plain(cursors_->text()));
  desktop::tell_in_foot(this, tr("Copied the values at the cursors."));
}

void PlotWindow::print() {
  if (!document()) return askForFile();
  desktop::print_page(this, [this](QPainter& painter, const QRectF& paper) {
    const QSizeF page = view_->viewport()->size();
    desktop::paint_vector(view_->chartScene(), painter, paper, page);
  });
}

void PlotWindow::savePicture() {
  Document* doc = document();
  if (!doc) return askForFile();
  const QString fallback = QString("%1-page-%2.jpg").arg(besideFile(*doc), QString::number(page_));
  const QSizeF size = view_->viewport()->size();
  desktop::save_picture(
      this, kApp, fallback, [this] { return view_->chartScene().image(view_->viewport()->size()); },
      size,
      [this, size](QPainter& painter) {
        desktop::paint_vector(view_->chartScene(), painter, QRectF(QPointF(0, 0), size), size);
      });
}

}  // namespace adore::adrplot
