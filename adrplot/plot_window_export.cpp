#include "adrplot/figure_dialog.hpp"
#include "adrplot/plot_window.hpp"
#include "base/counted.hpp"
#include "desktop/chart_view.hpp"
#include "desktop/dialogs.hpp"
#include "desktop/image_export.hpp"
#include "desktop/launch.hpp"
#include "desktop/page_export.hpp"
#include "desktop/theme.hpp"
#include "results/run_folder.hpp"

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

std::unique_ptr<desktop::ChartScene> PlotWindow::sceneForPaper() {
  auto scene = std::make_unique<desktop::ChartScene>();
  scene->setTheme(desktop::theme(desktop::ThemeKind::Light));
  scene->setPageSize(view_->viewport()->size());
  scene->setPage(view_->chartScene().page());
  scene->setZoom(view_->chartScene().zoom());
  return scene;
}

bool PlotWindow::exportTo(const QString& path, bool all_pages, bool seen) {
  if (!document()) return false;
  try {
    if (all_pages)
      savePagesOfRun(path);
    else
      saveShownPage(path, seen);
    return true;
  } catch (const std::exception& error) {
    desktop::show_message(this, QString::fromUtf8(error.what()), true);
    return false;
  }
}

void PlotWindow::saveShownPage(const QString& path, bool seen) {
  const auto scene = sceneForPaper();
  const bool numbers = QFileInfo(path).suffix().toLower() == "csv";
  if (numbers && seen) {
    const desktop::ChartPage part = desktop::visible_part(*scene);
    desktop::save_bytes(QByteArray::fromStdString(desktop::page_csv(part)), path.toStdString());
    desktop::show_in_status_bar(
        this, tr("Exported the visible curves in the visible range to %1 (%2 each).")
                  .arg(path, told(valuesOf(part), "value")));
    return;
  }
  desktop::save_page(*scene, path.toStdString(), view_->viewport()->size());
  const bool whole = !scene->zoomed() || scene->whole();
  desktop::show_in_status_bar(this,
                              !numbers ? tr("Saved %1.").arg(path)
                              : whole  ? tr("Exported all curves to %1 (%2 each).")
                                            .arg(path, told(valuesOf(scene->page()), "value"))
                                      : tr("Exported all curves to %1 (%2 each), including values "
                                           "outside the visible range.")
                                            .arg(path, told(valuesOf(scene->page()), "value")));
}

std::vector<PlotDocument> PlotWindow::filesOfRun() {
  const Document& shown = *document();
  if (!shown.on_disk) return {shown};
  std::vector<PlotDocument> out;
  bool found = false;
  for (const auto& file : results::run_folder(shown.path.parent_path()).plots) {
    const auto open = std::find_if(documents_.begin(), documents_.end(), [&](const auto& each) {
      return each->on_disk && each->path == file;
    });
    found = found || file == shown.path;
    out.push_back(open != documents_.end() ? PlotDocument(**open) : open_document(file));
  }
  if (!found) return {shown};  // RUN.json, a table, or all channels of RESULTS.h5
  return out;
}

void PlotWindow::savePagesOfRun(const QString& path) {
  const std::vector<PlotDocument> files = filesOfRun();
  struct Page {
    const PlotDocument* file;
    int number;
  };
  std::vector<Page> pages;
  for (const PlotDocument& file : files)
    for (std::size_t n = 0; n < file.pages.size(); ++n)
      pages.push_back({&file, static_cast<int>(n) + 1});
  desktop::ChartScene scene;
  scene.setTheme(desktop::theme(desktop::ThemeKind::Light));
  const QSizeF size = view_->viewport()->size();
  const auto show = [&](const Page& page) {
    const bool shown = page.number == page_ && page.file->path == document()->path;
    scene.setPage(shown ? view_->chartScene().page() : chartOf(*page.file, page.number));
  };
  const QString of_files =
      files.size() > 1 ? tr(" of %1").arg(told(files.size(), "file")) : QString();
  const QFileInfo info(path);
  if (info.suffix().toLower() == "pdf") {
    desktop::save_pdf(scene, path.toStdString(), pages.size(), size,
                      [&](std::size_t i) { show(pages[i]); });
    desktop::show_in_status_bar(
        this, tr("Saved %1 in %2.").arg(told(pages.size(), "page") + of_files, path));
    return;
  }
  for (const Page& page : pages) {
    show(page);
    QString name = info.completeBaseName();
    if (files.size() > 1) name += "-" + QString::fromStdString(page.file->path.filename().string());
    name += QString("-%1.%2").arg(page.number, 2, 10, QChar('0')).arg(info.suffix());
    desktop::save_page(scene, info.dir().filePath(name).toStdString(), size);
  }
  desktop::show_in_status_bar(this,
                              tr("Saved %1 as numbered files in %2.")
                                  .arg(told(pages.size(), "page") + of_files, info.absolutePath()));
}

bool PlotWindow::reportTo(const QString& folder) {
  QStringList words{"report", "--progress", "none", "--out", folder};
  for (const auto& each : documents_) {
    const QString run = QString::fromStdString(each->path.parent_path().string());
    if (each->on_disk && !words.contains(run)) words += run;
  }
  try {
    desktop::show_in_status_bar(this, tr("Wrote %1.")
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

void PlotWindow::exportFigure() {
  Document* doc = document();
  if (!doc) return askForFile();
  auto* dialog = new FigureDialog(view_->chartScene().page(), view_->chartScene().zoom(), this);
  dialog->setObjectName("figure");
  connect(
      dialog, &QDialog::accepted, this,
      [this, dialog, name = QString("%1-figure-%2").arg(besideFile(*doc), QString::number(page_))] {
        auto* files = new QFileDialog(this, tr("Export figure"), QString(),
                                      tr("PDF (*.pdf);;SVG (*.svg);;PNG, 600 dpi (*.png)"));
        files->setObjectName("export");
        desktop::delete_when_done(*files);
        files->setAcceptMode(QFileDialog::AcceptSave);
        files->setDefaultSuffix("pdf");
        connect(files, &QFileDialog::filterSelected, files, [files](const QString& filter) {
          files->setDefaultSuffix(filter.section("*.", 1).section(')', 0, 0));
        });
        files->selectFile(name);
        connect(files, &QFileDialog::fileSelected, this,
                [this, figure = dialog->figure()](const QString& path) {
                  try {
                    const desktop::ChartZoom zoom = view_->chartScene().zoom();
                    desktop::save_figure(view_->chartScene().page(), path.toStdString(), figure,
                                         desktop::Replace::Anything, &zoom);
                    desktop::show_in_status_bar(this, tr("Saved %1.").arg(path));
                  } catch (const std::exception& error) {
                    desktop::show_message(this, QString::fromUtf8(error.what()), true);
                  }
                });
        files->open();
      });
  dialog->open();
}

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
  if (statistics_table_->hasFocus()) return copyStatisticsRows();
  // Selected text of the statistics is copied.
  if (cursor_label_->hasSelectedText()) {
    QGuiApplication::clipboard()->setText(plain(cursor_label_->selectedText()));
    desktop::show_in_status_bar(this, tr("Copied the selected text."));
    return;
  }
  QGuiApplication::clipboard()->setImage(sceneForPaper()->image(view_->viewport()->size()));
  desktop::show_in_status_bar(this, tr("Copied the picture."));
}

void PlotWindow::copyCursorReport() {
  if (cursor_label_->text().isEmpty()) {
    desktop::show_in_status_bar(this,
                                tr("Set a cursor first: Ctrl+click (A), Ctrl+Shift+click (B)."));
    return;
  }
  QGuiApplication::clipboard()->setText(plain(cursor_label_->text()));
  desktop::show_in_status_bar(this, tr("Copied the values at the cursors."));
}

void PlotWindow::print() {
  if (!document()) return askForFile();
  desktop::print_page(this, [this](QPainter& painter, const QRectF& paper) {
    desktop::paint_vector(*sceneForPaper(), painter, paper, view_->viewport()->size());
  });
}

void PlotWindow::savePicture() {
  Document* doc = document();
  if (!doc) return askForFile();
  const QString fallback = QString("%1-page-%2.jpg").arg(besideFile(*doc), QString::number(page_));
  const QSizeF size = view_->viewport()->size();
  desktop::save_picture(
      this, kApp, fallback, [this] { return sceneForPaper()->image(view_->viewport()->size()); },
      size,
      [this, size](QPainter& painter) {
        desktop::paint_vector(*sceneForPaper(), painter, QRectF(QPointF(0, 0), size), size);
      });
}

}  // namespace adore::adrplot
