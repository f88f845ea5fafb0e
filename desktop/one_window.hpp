#pragma once

#include <QObject>
#include <QString>
#include <QStringList>

#include <filesystem>
#include <functional>

class QLocalServer;

/// One window of a viewer per project: a program that wants files shown asks a window that shows
/// the project already, before it starts another one.
namespace adore::desktop {

/// Listens for files of the project in a folder. The first window of a folder gets them; after it
/// is closed, no window does until the next one opens. Exists as long as its parent.
class SingleWindowServer : public QObject {
 public:
  /// @param program "adrplot" or "agore"
  /// @param show gets the requested files, and options that begin with "--"; the window should come
  /// to the front
  SingleWindowServer(const QString& program, const QString& folder, QObject* parent,
                     std::function<void(const QStringList&)> show);
  /// Is this the window of its folder?
  [[nodiscard]] bool is_listening() const;

 private:
  QLocalServer* server_;
};

/// The folder of a file as an absolute path.
QString folder_of(const std::filesystem::path& file);

/// Passes files to the window that shows the project in `folder`, and options ("--follow") with
/// them. False if there is none.
bool send_to_open_window(const QString& program, const QString& folder, const QStringList& files);

}  // namespace adore::desktop
