#pragma once

#include <QString>

class QAction;
class QMenu;

namespace adore::desktop {

class RunLink;

/// "Link Time with Other Windows" in the menu View: on at first, remembered in the settings of the
/// app.
QAction* add_link_action(QMenu& view, RunLink& link, const QString& app);

}  // namespace adore::desktop
