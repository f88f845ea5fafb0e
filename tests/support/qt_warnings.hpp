#pragma once

#include <QAction>
#include <QCoreApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QStringList>

#include <array>
#include <mutex>
#include <string>
#include <utility>

/// Warnings of Qt during the use of a window: each is a fault.
namespace adore::test {

class QtWarnings {
 public:
  QtWarnings() {
    texts().clear();
    before_ = qInstallMessageHandler(&QtWarnings::take);
  }
  ~QtWarnings() { qInstallMessageHandler(before_); }
  QtWarnings(const QtWarnings&) = delete;
  QtWarnings& operator=(const QtWarnings&) = delete;

  /// Those since the last call.
  [[nodiscard]] static std::string taken() {
    const std::scoped_lock guard(mutex());
    return std::exchange(texts(), {}).join("\n").toStdString();
  }

 private:
  static QStringList& texts() {
    static QStringList all;
    return all;
  }
  static std::mutex& mutex() {
    static std::mutex one;
    return one;
  }
  static void take(QtMsgType type, const QMessageLogContext& /*where*/, const QString& text) {
    // Of the platform without a screen, not of a program.
    if (type == QtDebugMsg || type == QtInfoMsg || text.startsWith("This plugin does not support"))
      return;
    const std::scoped_lock guard(mutex());
    texts() << text;
  }
  QtMessageHandler before_ = nullptr;
};

inline constexpr std::array<QSize, 7> kWindowSizes{
    QSize(640, 400),  QSize(700, 450),  QSize(800, 600),  QSize(1024, 700),
    QSize(1280, 800), QSize(1600, 900), QSize(1920, 1080)};

/// Warnings of Qt while every dock and every switch of the menus is changed, in every size.
inline std::string warned_by_switches(QMainWindow& window) {
  std::string out;
  const auto trigger = [&](QAction* action) {
    if (!action->isCheckable() || !action->isEnabled() || !action->isVisible()) return;
    action->trigger();
    for (int round = 0; round < 3; ++round) QCoreApplication::processEvents();
    const std::string said = QtWarnings::taken();
    if (!said.empty())
      out += action->text().toStdString() + " at " + std::to_string(window.width()) + " x " +
             std::to_string(window.height()) + ": " + said + "\n";
  };
  for (const QSize size : kWindowSizes) {
    window.resize(size);
    QCoreApplication::processEvents();
    for (int twice = 0; twice < 2; ++twice) {
      for (QDockWidget* dock : window.findChildren<QDockWidget*>())
        trigger(dock->toggleViewAction());
      for (QAction* action : window.findChildren<QAction*>())
        if (qobject_cast<QDockWidget*>(action->parent()) == nullptr) trigger(action);
    }
  }
  return out;
}

}  // namespace adore::test
