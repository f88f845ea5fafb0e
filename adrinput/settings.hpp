#pragma once

#include <QSettings>

namespace adore::adrinput {

/// Settings that persist between starts of the program.
[[nodiscard]] inline QSettings settings() { return QSettings("Adore", "adrinput"); }

}  // namespace adore::adrinput
