#include "desktop/launch.hpp"

#include "base/errors.hpp"

#include <QCoreApplication>
#include <QProcess>
#include <QStandardPaths>

namespace adore::desktop {

void start_program(const QString& program, const QStringList& arguments) {
  const QString here = QCoreApplication::applicationDirPath();
  QString path = QStandardPaths::findExecutable(program, {here});
  if (path.isEmpty()) path = QStandardPaths::findExecutable(program);
  if (path.isEmpty())
    throw InputError(program.toStdString() + " is neither in " + here.toStdString() +
                     " nor in the PATH; install it beside this program");
  if (!QProcess::startDetached(path, arguments))
    throw InputError(path.toStdString() + " could not be started");
}

}  // namespace adore::desktop
