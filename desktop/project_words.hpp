#pragma once

#include "desktop/project.hpp"

#include <QString>

#include <filesystem>
#include <functional>

class QWidget;

namespace adore::desktop {

/// Opens a project in a window that shows its runs: remembers it among the recent files of the
/// application, lists the runs, opens the first one that is there, and reports missing ones in the
/// status bar. False, after a message, if PROJECT.json is damaged or newer. A project without runs
/// that are there gets a message, too.
bool open_project(QWidget* window, const QString& app, const std::filesystem::path& path,
                  const std::function<void(const Project&)>& list_runs,
                  const std::function<void(const std::filesystem::path&)>& open_run);

/// "out", "out (missing)"
[[nodiscard]] QString run_label(const Project::Entry& run);

/// Message after a project was opened: it lists no runs, or runs that are missing. Empty: none.
[[nodiscard]] QString missing_runs_message(const Project& project);

}  // namespace adore::desktop
