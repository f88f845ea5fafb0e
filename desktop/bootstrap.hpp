#pragma once

#include <QApplication>

#include <memory>
#include <string>

/// Common initialization of Qt: apps, drawing program, and tests.
namespace adore::desktop {

enum class Display : unsigned char {
  Window,   ///< a person looks at it
  Headless  ///< pictures only: never asks for a display
};

/// The application object with organization, shipped fonts and theme. Without a display it uses the
/// offscreen platform. Numbers have a decimal point in all locales.
/// @throws InputError if a window is needed but the session has no display.
std::unique_ptr<QApplication> make_application(int& argc, char** argv, const std::string& name,
                                               Display display);

/// For programs that are not Qt apps: makes a headless application once, unless one exists.
void ensure_headless_application();

}  // namespace adore::desktop
