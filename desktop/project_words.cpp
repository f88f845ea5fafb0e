#include "desktop/project_words.hpp"

#include "desktop/chrome.hpp"
#include "desktop/dialogs.hpp"

#include <QObject>
#include <QStringList>

#include <algorithm>
#include <exception>
#include <optional>

namespace adore::desktop {

QString missing_runs_message(const Project& project) {
  const auto runs = project.runs();
  if (runs.empty())
    return QObject::tr("The project lists no runs. Add them in AdrInput (File > Add to Project).");
  QStringList missing;
  for (const Project::Entry& run : runs)
    if (run.missing) missing << QString::fromStdString(run.name);
  return missing.isEmpty()
             ? QString()
             : QObject::tr("Runs of the project without files: %1.").arg(missing.join(", "));
}

QString run_label(const Project::Entry& run) {
  const QString name = QString::fromStdString(run.name);
  return run.missing ? QObject::tr("%1 (missing)").arg(name) : name;
}

bool open_project(QWidget* window, const QString& app, const std::filesystem::path& path,
                  const std::function<void(const Project&)>& list_runs,
                  const std::function<void(const std::filesystem::path&)>& open_run) {
  std::optional<Project> project;
  try {
    project = Project::open(path);
  } catch (const std::exception& error) {
    show_message(window, QString::fromUtf8(error.what()), true);
    return false;
  }
  remember_file(app, QString::fromStdString(project->file().string()));
  list_runs(*project);
  const auto runs = project->runs();
  const auto first =
      std::find_if(runs.begin(), runs.end(), [](const auto& run) { return !run.missing; });
  if (first != runs.end()) open_run(first->path);
  const QString problem = missing_runs_message(*project);
  if (first == runs.end())
    show_message(window, problem);  // nothing else is shown
  else
    show_in_status_bar(window, problem);  // the list has them, too
  return true;
}

}  // namespace adore::desktop
