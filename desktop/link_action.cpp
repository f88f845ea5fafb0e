#include "desktop/link_action.hpp"

#include "desktop/run_link.hpp"

#include <QAction>
#include <QMenu>
#include <QSettings>

namespace adore::desktop {
namespace {
constexpr const char* kLinked = "linkTime";
}

QAction* add_link_action(QMenu& view, RunLink& link, const QString& app) {
  QAction* action = view.addAction(QObject::tr("Lin&k Time with Other Windows"));
  action->setObjectName("linkAction");
  action->setCheckable(true);
  action->setToolTip(
      QObject::tr("Windows that show the same run share the time of cursor A or of the frame, and "
                  "the selected rolling element."));
  action->setChecked(QSettings("Adore", app).value(kLinked, true).toBool());
  link.setActive(action->isChecked());
  QObject::connect(action, &QAction::toggled, &link, &RunLink::setActive);
  QObject::connect(action, &QAction::triggered, &link,
                   [app](bool on) { QSettings("Adore", app).setValue(kLinked, on); });
  return action;
}

}  // namespace adore::desktop
