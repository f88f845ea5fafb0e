#include "desktop/file_drops.hpp"

#include <QDockWidget>
#include <QDropEvent>
#include <QMimeData>
#include <QUrl>
#include <QWidget>
#include <QWindow>

#include <utility>

namespace adore::desktop {
namespace {

/// Filters the events of the window system for one window, and for its floating docks. Qt sends
/// none to a window below a modal one.
class FileDrops : public QObject {
 public:
  FileDrops(QWidget& window, std::function<void(const QStringList&)> opened)
      : QObject(&window), window_(window), opened_(std::move(opened)) {
    window.installEventFilter(this);
  }
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (auto* widget = qobject_cast<QWidget*>(watched)) {
      if (event->type() != QEvent::Show) return false;
      if (widget->isWindow() && widget->windowHandle() != nullptr)
        widget->windowHandle()->installEventFilter(this);  // once, however often
      if (widget == &window_)
        for (auto* dock : window_.findChildren<QDockWidget*>()) {
          dock->setAcceptDrops(true);
          dock->installEventFilter(this);
        }
      return false;
    }
    const auto type = event->type();
    if (type != QEvent::DragEnter && type != QEvent::DragMove && type != QEvent::Drop) return false;
    auto* drag = static_cast<QDropEvent*>(event);
    QStringList files;
    for (const QUrl& url : drag->mimeData()->urls())
      if (url.isLocalFile()) files << url.toLocalFile();
    if (files.isEmpty()) return false;
    drag->setDropAction(Qt::CopyAction);
    drag->accept();
    if (type == QEvent::Drop) opened_(files);
    return true;
  }

 private:
  QWidget& window_;
  std::function<void(const QStringList&)> opened_;
};

}  // namespace

void accept_file_drops(QWidget& window, std::function<void(const QStringList& files)> opened) {
  window.setAcceptDrops(true);
  new FileDrops(window, std::move(opened));
}

}  // namespace adore::desktop
