#include "desktop/project_words.hpp"

#include "desktop/project.hpp"

#include <QObject>
#include <QStringList>

namespace adore::desktop {

QString problem_of_runs(const Project& project) {
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

}  // namespace adore::desktop
