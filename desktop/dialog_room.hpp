#pragma once

#include <QObject>

class QDialog;
class QMessageBox;

namespace adore::desktop {

/// Dialogs of a program fit its screen of any size: none opens larger, and the text of a higher
/// message scrolls. One for the application.
class DialogSizeLimiter : public QObject {
 public:
  explicit DialogSizeLimiter(QObject* parent) : QObject(parent) {}
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  static void limitToScreen(QDialog& dialog);
  static void makeTextScrollable(QMessageBox& box);
};

}  // namespace adore::desktop
