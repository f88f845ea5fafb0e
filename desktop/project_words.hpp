#pragma once

#include <QString>

namespace adore::desktop {

class Project;

/// Message after a project was opened: it lists no runs, or runs that are missing. Empty: none.
[[nodiscard]] QString problem_of_runs(const Project& project);

}  // namespace adore::desktop
