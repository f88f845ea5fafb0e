#pragma once

#include "desktop/bootstrap.hpp"

#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>

namespace adore::test {

/// One headless application per test program; settings go to a temporary folder, never to the
/// user's.
inline void use_qt() {
  static const bool done = [] {
    static QTemporaryDir settings;
    QStandardPaths::setTestModeEnabled(true);
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
    desktop::ensure_headless_application();
    return true;
  }();
  (void)done;
}

}  // namespace adore::test
