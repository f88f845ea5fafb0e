#include "desktop/window_place.hpp"

#include <QEvent>
#include <QGuiApplication>
#include <QScreen>
#include <QSettings>
#include <QWidget>

#include <utility>

namespace adore::desktop {
namespace {

constexpr QSize kFrame{16, 48};  // of usual window managers, title bar included
constexpr const char* kGeometry = "window/geometry";

}  // namespace

QSize size_within(QSize preferred, QSize available) {
  return preferred.boundedTo(available - kFrame);
}

void resize_to_fit_screen(QWidget& window, QSize preferred) {
  const QScreen* screen = window.screen();
  const bool real = screen != nullptr && QGuiApplication::platformName() != "offscreen";
  window.resize(real ? size_within(preferred, screen->availableSize()) : preferred);
}

WindowGeometryStore::WindowGeometryStore(QWidget& window, QString app)
    : QObject(&window), window_(window), app_(std::move(app)) {
  const QByteArray stored = QSettings("Adore", app_).value(kGeometry).toByteArray();
  if (!stored.isEmpty()) window_.restoreGeometry(stored);
  window_.installEventFilter(this);
}

bool WindowGeometryStore::eventFilter(QObject* object, QEvent* event) {
  if (object == &window_ && event->type() == QEvent::Close)
    QSettings("Adore", app_).setValue(kGeometry, window_.saveGeometry());
  return false;
}

}  // namespace adore::desktop
