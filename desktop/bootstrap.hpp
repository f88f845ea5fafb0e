#pragma once

#include <QApplication>

#include <memory>
#include <string>

/// Starting Qt the same way everywhere: apps, the command line's pictures, and tests.
namespace adore::desktop {

enum class Display : unsigned char {
  Window,   ///< a person looks at it
  Headless  ///< pictures only: never asks for a display
};

/// The application object with organisation, shipped fonts and theme set. Headless uses the
/// offscreen platform. Numbers keep the decimal point whatever the user's locale says.
/// @throws InputError when a window is wanted but the session has no display.
std::unique_ptr<QApplication> make_application(int& argc, char** argv, const std::string& name,
                                               Display display);

/// For programs that are not Qt apps: makes a headless application once, unless one exists.
void ensure_headless_application();

}  // namespace adore::desktop
