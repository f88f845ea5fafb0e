#pragma once

#include <QColor>
#include <QFont>
#include <QFontMetricsF>
#include <QList>
#include <QString>

#include <array>
#include <string>

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
  bool dashes = false;  ///< curves differ by their dashes (dash_pattern), not by color
};

const Theme& theme(ThemeKind kind);

/// Gray on white, for print in black.
const Theme& gray_theme();

/// Dashes of a curve in units of its line width; empty: a solid line, always without `dashes`.
QList<qreal> dash_pattern(const Theme& theme, std::size_t curve);

/// The theme of this process: that of the last apply_theme(), light at first.
const Theme& current_theme();

/// Palette, style and font of the whole application.
void apply_theme(ThemeKind kind);

/// Dark if the desktop prefers it (palette of the platform at start-up), else light; always light
/// without a display.
ThemeKind desktop_theme_kind();

/// A choice in one of the windows applies to all of them, also at the next start.
void remember_theme(ThemeKind kind);
/// The choice of the user, else that of the desktop.
[[nodiscard]] ThemeKind preferred_theme();

/// The shipped font, by pixel size, so that a picture looks the same on every machine.
QFont ui_font(int pixel_size, bool bold = false);

/// Family of ui_font() for as long as it lives; empty: no change. For pictures that are drawn by
/// one thread.
class PictureFont {
 public:
  explicit PictureFont(const std::string& family);
  ~PictureFont();
  PictureFont(const PictureFont&) = delete;
  PictureFont& operator=(const PictureFont&) = delete;

 private:
  QString before_;
};

/// A line whose parts are separated by "   ·   ", fitted to a width: closer together, and if
/// necessary with dots in its first part, a name, or at its end.
QString fitted_line(const QString& text, const QFontMetricsF& metrics, qreal width);

/// Such a line below a title: parts that do not fit are placed next to the title, from the end,
/// before anything is shortened.
struct FittedHeading {
  QString below, beside;
};
/// @param free width next to the title
FittedHeading fitted_heading(const QString& text, const QFontMetricsF& metrics, qreal width,
                             qreal free);

}  // namespace adore::desktop
