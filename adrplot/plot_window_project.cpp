#include "adrplot/plot_window.hpp"
#include "desktop/chrome.hpp"
#include "desktop/dialogs.hpp"
#include "desktop/project.hpp"
#include "desktop/project_words.hpp"

#include <QHeaderView>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <exception>
#include <optional>

/// Runs of a project above the tree of pages.
namespace adore::adrplot {

/// The list of runs is hidden until a project is opened.
QWidget* PlotWindow::makePages() {
  auto* pages = new QWidget(this);
  auto* column = new QVBoxLayout(pages);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  runs_ = new QTreeWidget(pages);
  runs_->setObjectName("runs");
  runs_->setAccessibleName(tr("Runs of the project"));
  runs_->setHeaderLabel(tr("Runs of the project"));
  runs_->setRootIsDecorated(false);
  runs_->setFrameShape(QFrame::NoFrame);
  runs_->hide();
  column->addWidget(runs_);
  column->addWidget(tree_, 1);
  const auto open = [this](QTreeWidgetItem* item) { openRun(item->data(0, kRunRole).toString()); };
  connect(runs_, &QTreeWidget::itemClicked, this, open);
  connect(runs_, &QTreeWidget::itemActivated, this, open);  // Return
  return pages;
}

bool PlotWindow::openProject(const std::filesystem::path& path) {
  std::optional<desktop::Project> project;
  try {
    project = desktop::Project::open(path);
  } catch (const std::exception& error) {
    desktop::show_message(this, QString::fromUtf8(error.what()), true);
    return false;
  }
  project_ = project->file();
  desktop::remember_file(kApp, QString::fromStdString(project_.string()));
  const auto runs = project->runs();
  listRuns(runs);
  const auto first =
      std::find_if(runs.begin(), runs.end(), [](const auto& run) { return !run.missing; });
  if (first != runs.end()) openRun(QString::fromStdString(first->path.string()));
  const QString problem = desktop::problem_of_runs(*project);
  if (runs.empty())
    desktop::show_message(this, problem);
  else
    desktop::tell_in_foot(this, problem);  // the list has them, too
  return true;
}

void PlotWindow::listRuns(const std::vector<desktop::Project::Entry>& runs) {
  constexpr int kLineLimit = 8;
  runs_->clear();
  for (const desktop::Project::Entry& run : runs) {
    const QString name = QString::fromStdString(run.name);
    auto* item = new QTreeWidgetItem(runs_, {run.missing ? tr("%1 (missing)").arg(name) : name});
    item->setData(0, kRunRole, QString::fromStdString(run.path.string()));
    item->setToolTip(0, QString::fromStdString(run.path.string()));
    item->setDisabled(run.missing);
  }
  runs_->setVisible(!runs.empty());
  const int lines = std::min(runs_->topLevelItemCount(), kLineLimit);
  if (lines > 0)
    runs_->setFixedHeight(runs_->header()->sizeHint().height() + lines * runs_->sizeHintForRow(0) +
                          2 * runs_->frameWidth());
  markRun();
}

/// New runs of the project, and those that are there or missing now.
void PlotWindow::reloadProject() {
  if (project_.empty()) return;
  try {
    listRuns(desktop::Project::open(project_).runs());
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
  if (shown == documents_.end()) return markRun();
  current_ = static_cast<int>(shown - documents_.begin());
  page_ = same ? std::clamp(page, 1, std::max(1, pageCount())) : 1;
  fillTree();
}

/// Selects the run of the current file.
void PlotWindow::markRun() {
  const Document* const doc = document();
  const std::filesystem::path folder =
      doc != nullptr && doc->on_disk ? run_folder(doc->path) : std::filesystem::path();
  runs_->clearSelection();
  for (int i = 0; i < runs_->topLevelItemCount(); ++i) {
    QTreeWidgetItem* item = runs_->topLevelItem(i);
    if (run_folder(item->data(0, kRunRole).toString().toStdString() + "/.") == folder)
      runs_->setCurrentItem(item);
  }
}

void PlotWindow::askForProject() {
  desktop::ask_file(this, kApp, tr("Open project"), desktop::kProjectFile,
                    [this](const QString& name) { openProject(name.toStdString()); });
}

}  // namespace adore::adrplot
