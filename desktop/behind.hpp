#pragma once

#include <QObject>

/// Windows that open automatically at the end of a task, while the user may be typing elsewhere.
namespace adore::desktop {

/// Option of a viewer, also for existing ones: the keyboard focus does not change.
inline constexpr const char* kBehind = "--behind";

/// As long as it lives, and until a window of this program is chosen, windows open without taking
/// the keyboard, behind those that are there.
class OpenWithoutFocusGuard : public QObject {
 public:
  OpenWithoutFocusGuard();
  bool eventFilter(QObject* object, QEvent* event) override;
};

}  // namespace adore::desktop
