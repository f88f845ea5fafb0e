#include "desktop/file_drops.hpp"

#include <QApplication>
#include <QDragMoveEvent>
#include <QMimeData>
#include <QWidget>
#include <QWindow>

namespace adore::desktop {
namespace {

/// Stands before the window system's events of one window.
class FileDrops : public QObject {
 public:
  explicit FileDrops(QWidget& window) : QObject(&window), window_(window) {
    window.installEventFilter(this);
  }
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (watched == &window_) {
      if (event->type() == QEvent::Show && window_.windowHandle() != nullptr)
        window_.windowHandle()->installEventFilter(this);  // once, however often
      return false;
    }
    const auto type = event->type();
    if (type != QEvent::DragEnter && type != QEvent::DragMove && type != QEvent::Drop) return false;
    auto* drag = static_cast<QDropEvent*>(event);
    if (!drag->mimeData()->hasUrls()) return false;
    const QWidget* const modal = QApplication::activeModalWidget();
    if (modal != nullptr && modal != &window_) {
      drag->ignore();
    } else if (type == QEvent::DragMove) {
      drag->acceptProposedAction();
    } else {
      QCoreApplication::sendEvent(&window_, event);
    }
    return true;
  }

 private:
  QWidget& window_;
};

}  // namespace

void take_files_anywhere(QWidget& window) {
  window.setAcceptDrops(true);
  new FileDrops(window);
}

}  // namespace adore::desktop
