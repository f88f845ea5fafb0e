#include "adrinput/viewers.hpp"

#include "desktop/dialogs.hpp"
#include "desktop/one_window.hpp"

#include <QDir>
#include <QFileInfo>

#include <exception>

namespace adore::adrinput {

void show_in_viewer(QWidget* parent, const Launch& launch, const QString& program,
                    const QString& project, const QStringList& files) {
  try {
    QStringList arguments;
    for (const QString& file : files)  // the window may have been started elsewhere
      arguments << (file.startsWith("--") ? file
                                          : QDir::cleanPath(QFileInfo(file).absoluteFilePath()));
    if (desktop::send_to_open_window(program, project, arguments))
      return;  // it has a window already
    launch(program, QStringList{"--project", project} + arguments);
  } catch (const std::exception& error) {
    desktop::show_message(parent, QString::fromUtf8(error.what()), true);
  }
}

}  // namespace adore::adrinput
