#include <QApplication>
#include <QDialog>
#include <QEvent>
#include <catch2/catch.hpp>

/// Every dialog that a test opens must fit on a screen of 700 x 450 with the frame of a window
/// manager, at its smallest size. (Messages find their size and scroll, desktop/dialog_room.hpp.)
namespace {

class SmallScreen : public QObject {
 public:
  using QObject::QObject;
  bool eventFilter(QObject* object, QEvent* event) override {
    if (event->type() != QEvent::Show && event->type() != QEvent::LayoutRequest) return false;
    const auto* dialog = qobject_cast<const QDialog*>(object);
    if (dialog == nullptr || !dialog->isWindow() || dialog->inherits("QMessageBox")) return false;
    const QSize least = dialog->minimumSizeHint().expandedTo(dialog->minimumSize());
    if (least.width() > 700 - 16 || least.height() > 450 - 48)
      FAIL_CHECK("a dialog of " << least.width() << " x " << least.height() << ": "
                                << dialog->objectName().toStdString() << " "
                                << dialog->windowTitle().toStdString());
    return false;
  }
};

void look_at_dialogs() { qApp->installEventFilter(new SmallScreen(qApp)); }

}  // namespace

Q_COREAPP_STARTUP_FUNCTION(look_at_dialogs)
