#include "desktop/bootstrap.hpp"

#include "base/errors.hpp"
#include "base/terminal_text.hpp"
#include "desktop/dialog_room.hpp"
#include "desktop/theme.hpp"

#include <QFontDatabase>
#include <QIcon>
#include <QLocale>
#include <fmt/core.h>

#include <clocale>
#include <cstdlib>

// Outside every namespace, as Qt's resource macro asks.
static void load_resources() { Q_INIT_RESOURCE(desktop); }

namespace adore::desktop {
namespace {

void set_up(const QString& name) {
  load_resources();
  QLocale::setDefault(QLocale::c());
  QApplication::setOrganizationName("Adore");
  QApplication::setApplicationName(name);
  // Window class and icon of this program for the desktop.
  QGuiApplication::setDesktopFileName(name);
  QApplication::setWindowIcon(QIcon(":/adore/icons/" + name + ".png"));
  for (const char* file : {"DejaVuSans.ttf", "DejaVuSans-Bold.ttf"})
    demand(QFontDatabase::addApplicationFont(QString(":/adore/fonts/") + file) >= 0,
           "a shipped font does not load");
  apply_theme(preferred_theme());
  qApp->installEventFilter(new DialogSizeLimiter(qApp));
}

/// Pictures made without a session need no session folder and no window manager, so Qt's remarks
/// about them only worry people.
void quiet_about_session(QtMsgType type, const QMessageLogContext& context, const QString& text) {
  if (text.startsWith("QStandardPaths: XDG_RUNTIME_DIR")) return;
  if (text.startsWith("This plugin does not support propagateSizeHints")) return;
  print(stderr, "{}\n", qFormatLogMessage(type, context, text).toStdString());
  if (type == QtFatalMsg) std::abort();
}

bool has_display() {
#ifdef Q_OS_LINUX
  return qEnvironmentVariableIsSet("QT_QPA_PLATFORM") || !qEnvironmentVariableIsEmpty("DISPLAY") ||
         !qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY");
#else
  return true;
#endif
}

}  // namespace

std::unique_ptr<QApplication> make_application(int& argc, char** argv, const std::string& name,
                                               Display display) {
  if (display == Display::Headless) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    qInstallMessageHandler(quiet_about_session);
  }
  if (!has_display())
    throw InputError(
        name +
        " has no display; start it in a desktop session, or use --render DIR to write pictures");
  auto app = std::make_unique<QApplication>(argc, argv);
  // Qt sets the user's locale for the whole process; C functions in libraries and user routines
  // would then read 7.5 as 7 and write 7,5.
  std::setlocale(LC_NUMERIC, "C");
  set_up(QString::fromStdString(name));
  return app;
}

void ensure_headless_application() {
  if (QCoreApplication::instance()) return;
  static int argc = 1;
  static char program[] = "adore";
  static char* argv[] = {program, nullptr};
  // Exists as long as the process: static objects of Qt must not outlive a static application
  // object.
  static const QApplication* const app =
      make_application(argc, argv, "adore", Display::Headless).release();
  demand(app != nullptr, "no application object");
}

}  // namespace adore::desktop
