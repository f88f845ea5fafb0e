#pragma once

#include <QCoreApplication>
#include <QMessageBox>
#include <QWidget>

namespace adore::test {

/// Text of the message that a window shows, which is then closed; empty where there is none.
inline QString take_message(QWidget& window) {
  auto* box = window.findChild<QMessageBox*>("message");
  if (box == nullptr) return {};
  const QString text = box->text();
  box->close();
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  return text;
}

}  // namespace adore::test
