#pragma once

#include "agore/agore_window.hpp"
#include "agore/short_run.hpp"

#include <QCoreApplication>
#include <QMessageBox>

namespace adore::test {

/// Shows a short run in a window, and paints it once: the curves have their place.
inline agore::PictureWidget* show_painted(agore::AgoreWindow& window) {
  window.setAnimation(agore::prepare(synthetic_sol8(short_run(61))));
  window.resize(1100, 700);
  window.show();
  QCoreApplication::processEvents();
  auto* canvas = window.findChild<agore::PictureWidget*>();
  canvas->grab();
  return canvas;
}

/// The message that the window shows, closed; empty where there is none.
inline QString take_message(QWidget& window) {
  auto* box = window.findChild<QMessageBox*>("message");
  if (!box) return {};
  const QString text = box->text();
  box->close();
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  return text;
}

}  // namespace adore::test
