#pragma once

#include <QObject>

class QWidget;

namespace adore::adrinput {

/// Scrolling over a form must not change it: a list or a number takes the wheel only while it has
/// the focus, and gets that by a click or a key.
class WheelGuard : public QObject {
 public:
  explicit WheelGuard(QWidget* field);
  bool eventFilter(QObject* object, QEvent* event) override;
};

}  // namespace adore::adrinput
