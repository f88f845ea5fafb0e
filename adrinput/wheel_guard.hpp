#pragma once

#include <QObject>

class QWidget;

namespace adore::adrinput {

/// The mouse wheel must not change values of a form: a list or a number reacts to the wheel only
/// while it has the focus, after a click or a key.
class WheelGuard : public QObject {
 public:
  explicit WheelGuard(QWidget* field);
  bool eventFilter(QObject* object, QEvent* event) override;
};

}  // namespace adore::adrinput
