#include "adrplot/plot_window.hpp"
#include "desktop/dialogs.hpp"
#include "desktop/project.hpp"
#include "desktop/project_words.hpp"

#include <QHeaderView>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <exception>

/// Runs of a project above the tree of pages.
namespace adore::adrplot {

/// The list of runs is hidden until a project is opened.
QWidget* PlotWindow::makePages() {
  auto* pages = new QWidget(this);
  auto* column = new QVBoxLayout(pages);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  run_list_ = new QTreeWidget(pages);
  run_list_->setObjectName("runs");
  run_list_->setAccessibleName(tr("Runs of the project"));
  run_list_->setHeaderLabel(tr("Runs of the project"));
  run_list_->setRootIsDecorated(false);
  run_list_->setFrameShape(QFrame::NoFrame);
  run_list_->hide();
  column->addWidget(run_list_);
  column->addWidget(tree_, 1);
  const auto open = [this](QTreeWidgetItem* item) { openRun(item->data(0, kRunRole).toString()); };
  connect(run_list_, &QTreeWidget::itemClicked, this, open);
  connect(run_list_, &QTreeWidget::itemActivated, this, open);  // Return
  return pages;
}

bool PlotWindow::openProject(const std::filesystem::path& path) {
  const auto list = [this](const desktop::Project& project) {
    project_file_ = project.file();
    listRuns(project.runs());
  };
  return desktop::open_project(this, kApp, path, list, [this](const std::filesystem::path& run) {
    openRun(QString::fromStdString(run.string()));
  });
}

void PlotWindow::listRuns(const std::vector<desktop::Project::Entry>& runs) {
  constexpr int kLineLimit = 8;
  run_list_->clear();
  for (const desktop::Project::Entry& run : runs) {
    auto* item = new QTreeWidgetItem(run_list_, {desktop::run_label(run)});
    item->setData(0, kRunRole, QString::fromStdString(run.path.string()));
    item->setToolTip(0, QString::fromStdString(run.path.string()));
    item->setDisabled(run.missing);
  }
  run_list_->setVisible(!runs.empty());
  const int lines = std::min(run_list_->topLevelItemCount(), kLineLimit);
  if (lines > 0)
    run_list_->setFixedHeight(run_list_->header()->sizeHint().height() +
                              lines * run_list_->sizeHintForRow(0) + 2 * run_list_->frameWidth());
  selectCurrentRun();
}

/// New runs of the project, and those that are there or missing now.
void PlotWindow::reloadProject() {
  if (project_file_.empty()) return;
  try {
    listRuns(desktop::Project::open(project_file_).runs());
  } catch (const std::exception& error) {
    desktop::show_message(this, QString::fromUtf8(error.what()), true);
  }
}

/// The page of the same file as now, so that runs can be compared.
void PlotWindow::openRun(const QString& folder) {
  const std::filesystem::path wanted = run_folder(folder.toStdString() + "/.");
  const std::filesystem::path file = document() ? document()->path.filename() : "";
  const int page = page_;
  const auto of_run = [&](const auto& one) {
    return one->on_disk && run_folder(one->path) == wanted;
  };
  if (std::none_of(documents_.begin(), documents_.end(), of_run)) openFolder(folder);
  auto shown = std::find_if(documents_.begin(), documents_.end(), [&](const auto& one) {
    return of_run(one) && one->path.filename() == file;
  });
  const bool same = shown != documents_.end();
  if (!same) shown = std::find_if(documents_.begin(), documents_.end(), of_run);
  if (shown == documents_.end()) return selectCurrentRun();
  current_ = static_cast<int>(shown - documents_.begin());
  page_ = same ? std::clamp(page, 1, std::max(1, pageCount())) : 1;
  fillTree();
}

/// Selects the run of the current file.
void PlotWindow::selectCurrentRun() {
  const Document* const doc = document();
  const std::filesystem::path folder =
      doc != nullptr && doc->on_disk ? run_folder(doc->path) : std::filesystem::path();
  run_list_->clearSelection();
  for (int i = 0; i < run_list_->topLevelItemCount(); ++i) {
    QTreeWidgetItem* item = run_list_->topLevelItem(i);
    if (run_folder(item->data(0, kRunRole).toString().toStdString() + "/.") == folder)
      run_list_->setCurrentItem(item);
  }
}

void PlotWindow::askForProject() {
  desktop::ask_file(this, kApp, tr("Open project"), desktop::kProjectFile,
                    [this](const QString& name) { openProject(name.toStdString()); });
}

}  // namespace adore::adrplot
