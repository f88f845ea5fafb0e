#pragma once

#include "desktop/bootstrap.hpp"
#include "desktop/launch.hpp"

#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <catch2/catch.hpp>

namespace adore::test {

/// One headless application per test program; settings go to a temporary folder, never to the
/// user's. Windows that a test opened by another program would outlive it, unseen: it fails.
inline void use_qt() {
  static const bool done = [] {
    static QTemporaryDir settings;
    QStandardPaths::setTestModeEnabled(true);
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
    desktop::set_program_starter([](const QString& path, const QStringList&) {
      FAIL_CHECK("a test started " << path.toStdString() << ": let it look on instead");
      return true;
    });
    desktop::ensure_headless_application();
    return true;
  }();
  (void)done;
}

}  // namespace adore::test
