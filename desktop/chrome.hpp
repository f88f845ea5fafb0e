#pragma once

#include <QString>
#include <QStringList>

#include <functional>

class QMainWindow;
class QMenu;
class QMenuBar;

/// Common menus of all windows: recent files, help, about.
namespace adore::desktop {

/// Recent files of an app, the newest first; at most ten, without deleted ones.
[[nodiscard]] QStringList recent_files(const QString& app);
void remember_file(const QString& app, const QString& path);
/// The same for one of several files of a run: at most three of one folder, so that two runs do not
/// fill the list.
void add_recent_run_file(const QString& app, const QString& path);
/// Files opened by `open` are one entry, their folder: a run of five files leaves space for others.
/// Nothing is added if opening failed.
void remember_as_folder(const QString& app, const QString& folder,
                        const std::function<void()>& open);

/// A submenu "Recent files" that is filled whenever it is opened.
QMenu* add_recent_menu(QMenu& file, const QString& app, std::function<void(QString)> open);

/// A line of the help: key or mouse action, and its effect.
struct HelpLine {
  QString hand, effect;
};

/// The menu "Help" with "Keys and mouse", shown by show_help(), and "About", a message.
QMenu* add_help_menu(QMainWindow& window, const QString& name, const QString& about,
                     const QList<HelpLine>& lines);

}  // namespace adore::desktop
