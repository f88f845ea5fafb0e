#pragma once

#include <QObject>

/// Windows that open because something has finished, while somebody may be typing elsewhere.
namespace adore::desktop {

/// Option of a viewer, and of what is handed over to one: the keyboard stays where it is.
inline constexpr const char* kBehind = "--behind";

/// As long as it lives, and until a window of this program is chosen, windows open without taking
/// the keyboard, behind those that are there.
class OpensBehind : public QObject {
 public:
  OpensBehind();
  bool eventFilter(QObject* object, QEvent* event) override;
};

}  // namespace adore::desktop
