#pragma once

#include <QObject>

class QDialog;
class QMessageBox;

namespace adore::desktop {

/// Dialogs of a program fit its screen of any size: none opens larger, and the text of a higher
/// message scrolls. One for the application.
class DialogRoom : public QObject {
 public:
  explicit DialogRoom(QObject* parent) : QObject(parent) {}
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  static void bound(QDialog& dialog);
  static void letTextScroll(QMessageBox& box);
};

}  // namespace adore::desktop
