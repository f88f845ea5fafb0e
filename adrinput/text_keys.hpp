#pragma once

#include <QObject>

class QWidget;

namespace adore::adrinput {

/// Page Up, Page Down, Ctrl+Home and Ctrl+End act in a text of a window that has the focus, instead
/// of the window's shortcuts for records.
class TextKeys : public QObject {
 public:
  explicit TextKeys(QWidget& window);
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  QWidget& window_;
};

}  // namespace adore::adrinput
