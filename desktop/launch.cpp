#include "desktop/launch.hpp"

#include "base/errors.hpp"

#include <QCoreApplication>
#include <QProcess>
#include <QStandardPaths>

#include <utility>

namespace adore::desktop {
namespace {

bool start_detached(const QString& path, const QStringList& arguments) {
  QProcess process;
  process.setProgram(path);
  process.setArguments(arguments);
  // A window that holds a pipe of this program would keep its reader waiting.
  process.setStandardInputFile(QProcess::nullDevice());
  process.setStandardOutputFile(QProcess::nullDevice());
  process.setStandardErrorFile(QProcess::nullDevice());
  return process.startDetached();
}

Starter& starter() {
  static Starter start = &start_detached;
  return start;
}

QString path_of(const QString& program) {
  const QString here = QCoreApplication::applicationDirPath();
  QString path = QStandardPaths::findExecutable(program, {here});
  if (path.isEmpty()) path = QStandardPaths::findExecutable(program);
  if (path.isEmpty())
    throw InputError(program.toStdString() + " is neither in " + here.toStdString() +
                     " nor in the PATH; install it next to this program");
  return path;
}

}  // namespace

Starter set_program_starter(Starter start) {
  return std::exchange(starter(), start ? std::move(start) : &start_detached);
}

void start_program(const QString& program, const QStringList& arguments) {
  const QString path = path_of(program);
  if (!starter()(path, arguments)) throw InputError(path.toStdString() + " could not be started");
}

QString output_of_program(const QString& program, const QStringList& arguments) {
  QProcess process;
  process.start(path_of(program), arguments, QIODevice::ReadOnly);
  process.waitForFinished(-1);
  if (process.error() == QProcess::FailedToStart || process.exitStatus() != QProcess::NormalExit ||
      process.exitCode() != 0) {
    const QString words = QString::fromUtf8(process.readAllStandardError()).trimmed();
    throw InputError(words.isEmpty() ? program.toStdString() + " ended with an error"
                                     : words.section('\n', -1).toStdString());
  }
  return QString::fromUtf8(process.readAllStandardOutput());
}

}  // namespace adore::desktop
