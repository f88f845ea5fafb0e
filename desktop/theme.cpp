#include "desktop/theme.hpp"

#include "desktop/scroll_style.hpp"

#include <QApplication>
#include <QPalette>
#include <QSettings>

namespace adore::desktop {
namespace {

Theme make_light() {
  Theme t{};
  t.kind = ThemeKind::Light;
  t.window = QColor("#f3f5f8");
  t.surface = QColor("#ffffff");
  t.raised = QColor("#e8ecf2");
  t.text = QColor("#1d2530");
  t.muted = QColor("#5b6675");
  t.grid = QColor("#e3e7ed");
  t.frame = QColor("#b6bfcb");
  t.accent = QColor("#1f6fb2");
  t.steel_light = QColor("#d5dbe3");
  t.steel_dark = QColor("#93a0b0");
  t.cage = QColor("#d9a441");
  t.red = QColor("#d1242f");
  t.green = QColor("#1a8f4c");
  t.blue = QColor("#1351b4");
  t.light_blue = QColor("#3f8ae0");
  t.curves = {QColor("#0072b2"), QColor("#d55e00"), QColor("#009e73"), QColor("#8a2a6b"),
              QColor("#5a3a00"), QColor("#4aa8e0"), QColor("#1b1f5b"), QColor("#8a94a0")};
  return t;
}

Theme make_dark() {
  Theme t{};
  t.kind = ThemeKind::Dark;
  t.window = QColor("#171b21");
  t.surface = QColor("#1e242c");
  t.raised = QColor("#2a323d");
  t.text = QColor("#e7ecf2");
  t.muted = QColor("#98a5b5");
  t.grid = QColor("#2d3642");
  t.frame = QColor("#4a5665");
  t.accent = QColor("#4ea1e6");
  t.steel_light = QColor("#8f9cac");
  t.steel_dark = QColor("#566373");
  t.cage = QColor("#c08f36");
  t.red = QColor("#ff5b5b");
  t.green = QColor("#3ecf7c");
  t.blue = QColor("#5f97ff");
  t.light_blue = QColor("#8fc4ff");
  t.curves = {QColor("#56b4e9"), QColor("#ff8a3d"), QColor("#1fae7a"), QColor("#e9b8dc"),
              QColor("#f3e36b"), QColor("#5b74d8"), QColor("#b06a9a"), QColor("#98a5b5")};
  return t;
}

Theme make_gray() {
  Theme t = make_light();
  for (QColor* colour : {&t.text, &t.muted, &t.grid, &t.frame, &t.accent, &t.steel_light,
                         &t.steel_dark, &t.cage, &t.red, &t.green, &t.blue, &t.light_blue}) {
    const int gray = qGray(colour->rgb());
    *colour = QColor(gray, gray, gray);
  }
  t.text = QColor(Qt::black);
  t.curves = {QColor("#000000"), QColor("#5c5c5c"), QColor("#000000"), QColor("#8a8a8a"),
              QColor("#3c3c3c"), QColor("#747474"), QColor("#000000"), QColor("#a0a0a0")};
  t.dashes = true;
  return t;
}

/// Of pictures.
QString& font_family() {
  static QString family = "DejaVu Sans";
  return family;
}

ThemeKind& chosen() {
  static ThemeKind kind = ThemeKind::Light;
  return kind;
}

}  // namespace

const Theme& theme(ThemeKind kind) {
  static const Theme light = make_light(), dark = make_dark();
  return kind == ThemeKind::Dark ? dark : light;
}

const Theme& gray_theme() {
  static const Theme gray = make_gray();
  return gray;
}

QList<qreal> dash_pattern(const Theme& theme, std::size_t curve) {
  static const std::array<QList<qreal>, 8> kDashes{
      QList<qreal>{}, {6, 3}, {2, 2}, {}, {8, 3, 2, 3}, {4, 2}, {8, 2, 1, 2, 1, 2}, {2, 2}};
  return theme.dashes ? kDashes[curve % kDashes.size()] : QList<qreal>{};
}

const Theme& current_theme() { return theme(chosen()); }

void apply_theme(ThemeKind kind) {
  chosen() = kind;
  const Theme& t = theme(kind);
  QApplication::setStyle(new ScrollStyle);
  QPalette palette;
  palette.setColor(QPalette::Window, t.window);
  palette.setColor(QPalette::Base, t.surface);
  palette.setColor(QPalette::AlternateBase, t.raised);
  palette.setColor(QPalette::Button, t.raised);
  palette.setColor(QPalette::ToolTipBase, t.raised);
  for (const auto role :
       {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText})
    palette.setColor(role, t.text);
  palette.setColor(QPalette::PlaceholderText, t.muted);
  // White on the bright accent of the dark theme would have a contrast of 2.8; of this one 5.6.
  palette.setColor(QPalette::Highlight, kind == ThemeKind::Dark ? QColor("#2b6ca6") : t.accent);
  palette.setColor(QPalette::HighlightedText, QColor(Qt::white));
  palette.setColor(QPalette::Link, t.accent);
  // Disabled controls are pale but readable.
  const QColor idle(kind == ThemeKind::Dark ? "#8793a2" : "#858e9b");
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    palette.setColor(QPalette::Disabled, role, idle);
  QApplication::setPalette(palette);
  QApplication::setFont(ui_font(13));
}

ThemeKind desktop_theme_kind() {
  if (QGuiApplication::platformName() == "offscreen") return ThemeKind::Light;
  const QPalette palette = QGuiApplication::palette();
  const bool dark =
      palette.color(QPalette::Window).lightness() < palette.color(QPalette::WindowText).lightness();
  return dark ? ThemeKind::Dark : ThemeKind::Light;
}

namespace {

QSettings shared_settings() { return QSettings("Adore", "desktop"); }

}  // namespace

void remember_theme(ThemeKind kind) {
  shared_settings().setValue("theme", kind == ThemeKind::Dark ? "dark" : "light");
}

ThemeKind preferred_theme() {
  if (QGuiApplication::platformName() == "offscreen") return ThemeKind::Light;
  const QString chosen = shared_settings().value("theme").toString();
  return chosen == "dark"    ? ThemeKind::Dark
         : chosen == "light" ? ThemeKind::Light
                             : desktop_theme_kind();
}

QFont ui_font(int pixel_size, bool bold) {
  QFont font(font_family());
  font.setPixelSize(pixel_size);
  font.setBold(bold);
  return font;
}

PictureFont::PictureFont(const std::string& family) : before_(font_family()) {
  if (!family.empty()) font_family() = QString::fromStdString(family);
}

PictureFont::~PictureFont() { font_family() = before_; }

QString fitted_line(const QString& text, const QFontMetricsF& metrics, qreal width) {
  if (metrics.horizontalAdvance(text) <= width) return text;
  QString closer = text;
  closer.replace("   ·   ", " · ");
  const qsizetype first = closer.indexOf(" · ");
  const QString rest = first < 0 ? QString() : closer.mid(first);
  const qreal room = width - metrics.horizontalAdvance(rest);
  constexpr qreal kLeast = 60.0;
  if (first < 0 || room < kLeast) return metrics.elidedText(closer, Qt::ElideRight, width);
  return metrics.elidedText(closer.left(first), Qt::ElideRight, room) + rest;
}

FittedHeading fitted_heading(const QString& text, const QFontMetricsF& metrics, qreal width,
                             qreal free) {
  const QString apart = "   ·   ", close = " · ";
  QStringList parts = text.split(apart), beside;
  const auto fits = [&](const QStringList& some, qreal room) {
    return metrics.horizontalAdvance(some.join(close)) <= room;
  };
  while (parts.size() > 1 && !fits(parts, width) &&
         fits(QStringList(parts.back()) + beside, free)) {
    beside.prepend(parts.back());
    parts.removeLast();
  }
  return {fitted_line(parts.join(apart), metrics, width), beside.join(close)};
}

}  // namespace adore::desktop
