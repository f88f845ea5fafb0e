#pragma once

#include "agore/agore_window.hpp"
#include "agore/short_run.hpp"
#include "support/message.hpp"

#include <QCoreApplication>

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

}  // namespace adore::test
