#pragma once

#include <QColor>
#include <QFont>
#include <QFontMetricsF>

#include <array>

/// Colors and fonts of every window and picture. Light on paper, dark on screen; both with the
/// same order of eight curve colors, told apart with the common color-vision deficiencies (the
/// first after Okabe and Ito, the others by lightness; tests/desktop/test_palette.cpp).
namespace adore::desktop {

enum class ThemeKind : unsigned char { Light, Dark };

struct Theme {
  ThemeKind kind;
  QColor window, surface, raised, text, muted, grid, frame, accent;
  QColor steel_light, steel_dark, cage;  ///< bodies in pictures
  QColor red, green, blue, light_blue;   ///< marks that keep their meaning in every view
  std::array<QColor, 8> curves;
};

const Theme& theme(ThemeKind kind);

/// The theme of this process: what apply_theme was last given, light at first.
const Theme& current_theme();

/// Palette, style and font of the whole application.
void apply_theme(ThemeKind kind);

/// Dark when the desktop says so (palette of the platform at start-up), light otherwise and always
/// when headless.
ThemeKind desktop_preference();

/// What a person chose in one of the windows counts in all of them, at the next start, too.
void remember_theme(ThemeKind kind);
/// What was chosen, else the desktop's.
[[nodiscard]] ThemeKind preferred_theme();

/// The shipped font, by pixel size, so that a picture looks the same on every machine.
QFont ui_font(int pixel_size, bool bold = false);

/// A line whose parts stand apart by "   ·   ", as wide as there is room: closer together, and with
/// dots in its first part, a name, or at its end where that is not enough.
QString fitted_line(const QString& text, const QFontMetricsF& metrics, qreal width);

/// Such a line below a title: what has no room there goes beside the title, from the end, before
/// anything is shortened.
struct FittedHeading {
  QString below, beside;
};
/// @param free room beside the title
FittedHeading fitted_heading(const QString& text, const QFontMetricsF& metrics, qreal width,
                             qreal free);

}  // namespace adore::desktop
