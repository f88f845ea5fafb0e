#include "desktop/chrome.hpp"

#include "base/version.hpp"
#include "desktop/dialogs.hpp"

#include <QFileInfo>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QScopedValueRollback>
#include <QSettings>

#include <utility>

namespace adore::desktop {
namespace {
constexpr const char* kRecent = "open/recent";
constexpr qsizetype kMost = 10, kMostOfRun = 3;
}  // namespace

QStringList recent_files(const QString& app) {
  QStringList out;
  for (const QString& name : QSettings("Adore", app).value(kRecent).toStringList())
    if (QFileInfo::exists(name)) out << name;
  return out;
}

namespace {
bool as_folder = false;      // files that open now are of a folder that is remembered itself
bool any_of_folder = false;  // one of them was opened
}  // namespace

namespace {
void remember(const QString& app, const QString& path, qsizetype most_of_folder) {
  if (as_folder) {
    any_of_folder = true;
    return;
  }
  const QFileInfo file(path);
  QStringList names = QSettings("Adore", app).value(kRecent).toStringList();
  names.removeAll(file.absoluteFilePath());
  names.prepend(file.absoluteFilePath());
  qsizetype of_folder = 0;
  names.removeIf([&](const QString& name) {
    return QFileInfo(name).absolutePath() == file.absolutePath() && ++of_folder > most_of_folder;
  });
  QSettings("Adore", app).setValue(kRecent, names.mid(0, kMost));
}
}  // namespace

void remember_file(const QString& app, const QString& path) { remember(app, path, kMost); }

void add_recent_run_file(const QString& app, const QString& path) {
  remember(app, path, kMostOfRun);
}

void remember_as_folder(const QString& app, const QString& folder,
                        const std::function<void()>& open) {
  any_of_folder = false;
  {
    const QScopedValueRollback<bool> within(as_folder, true);
    open();
  }
  if (any_of_folder) remember_file(app, folder);
}

QMenu* add_recent_menu(QMenu& file, const QString& app, std::function<void(QString)> open) {
  QMenu* menu = file.addMenu(QObject::tr("&Recent Files"));
  menu->setObjectName("recent");
  QObject::connect(menu, &QMenu::aboutToShow, menu, [menu, app, open = std::move(open)] {
    menu->clear();
    const QStringList names = recent_files(app);
    for (qsizetype i = 0; i < names.size(); ++i)
      menu->addAction(QString("&%1  %2").arg((i + 1) % 10).arg(names[i]), menu,
                      [open, name = names[i]] { open(name); });
    if (names.isEmpty()) menu->addAction(QObject::tr("No recent files"))->setEnabled(false);
  });
  return menu;
}

QMenu* add_help_menu(QMainWindow& window, const QString& name, const QString& about,
                     const QList<HelpLine>& lines) {
  QMenu* menu = window.menuBar()->addMenu(QObject::tr("&Help"));
  menu->addAction(QObject::tr("&Keys and Mouse"), Qt::Key_F1, &window, [&window, name, lines] {
    QString text = "<table cellspacing=6>";
    for (const HelpLine& line : lines)
      text += "<tr><td><b>" + line.hand.toHtmlEscaped() + "</b></td><td>" +
              line.effect.toHtmlEscaped() + "</td></tr>";
    text += "<tr><td><b>F1</b></td><td>" + QObject::tr("show this help") + "</td></tr>";
    show_help(&window, name + ": " + QObject::tr("keys and mouse"), text + "</table>");
  });
  menu->addAction(QObject::tr("&About %1").arg(name), &window, [&window, about] {
    show_message(&window, about + "\n\n" +
                              QString::fromLatin1(kProgramVersion.data(),
                                                  static_cast<qsizetype>(kProgramVersion.size())) +
                              QObject::tr(", free software under the GPL, without warranty."));
  });
  return menu;
}

}  // namespace adore::desktop
