#include "base/errors.hpp"
#include "desktop/figure.hpp"
#include "desktop/lines_page.hpp"
#include "support/qt_app.hpp"

#include <QFile>
#include <QImage>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <catch2/catch.hpp>

#include <fstream>

using namespace adore;
using namespace adore::desktop;
using adore::testing::lines_page;

namespace {

QByteArray bytes_of(const std::filesystem::path& path) {
  QFile file(QString::fromStdString(path.string()));
  REQUIRE(file.open(QIODevice::ReadOnly));
  return file.readAll();
}

double number_after(const QByteArray& text, const QString& pattern) {
  const auto found = QRegularExpression(pattern).match(QString::fromUtf8(text));
  REQUIRE(found.hasMatch());
  return found.captured(1).toDouble();
}

}  // namespace

TEST_CASE("figure: SVG → size in millimeters, letters of the given size, font and title",
          "[gui][desktop]") {
  test::use_qt();
  QTemporaryDir folder;
  const std::filesystem::path file = std::filesystem::path(folder.path().toStdString()) / "f.svg";
  for (const double width : {85.0, 170.0})
    for (const double letters : {6.0, 8.0}) {
      save_figure(lines_page(), file, {width, 0.0, letters}, Replace::OwnPictures);
      const QByteArray svg = bytes_of(file);
      CHECK(number_after(svg, "width=\"([0-9.]+)mm\"") == Approx(width));
      const double panels = static_cast<double>(lines_page().panels.size());
      CHECK(number_after(svg, "height=\"([0-9.]+)mm\"") ==
            Approx((0.75 + 0.2 * (panels - 1.0)) * width));
      CHECK(svg.contains("<title>Lines</title>"));
      // Axis titles have 11 units of the view box.
      const double unit = width / number_after(svg, "viewBox=\"0 0 ([0-9.]+) ");
      CHECK(svg.contains("font-size=\"11\""));
      CHECK(11.0 * unit == Approx(letters * 25.4 / 72.0).epsilon(2e-3));
    }
  save_figure(lines_page(), file, {85.0, 60.0, 8.0, "DejaVu Serif"}, Replace::OwnPictures);
  CHECK(bytes_of(file).contains("font-family=\"DejaVu Serif\""));
  CHECK_FALSE(bytes_of(file).contains("font-family=\"DejaVu Sans\""));
  CHECK(ui_font(13).family() == "DejaVu Sans");  // of everything else
}

TEST_CASE("figure: PDF and PNG → given size on paper", "[gui][desktop]") {
  test::use_qt();
  QTemporaryDir folder;
  const std::filesystem::path base = folder.path().toStdString();
  save_figure(lines_page(), base / "f.pdf", {85.0, 60.0}, Replace::OwnPictures);
  const QByteArray pdf = bytes_of(base / "f.pdf");
  CHECK(number_after(pdf.left(4096), "MediaBox \\[0 0 ([0-9.]+)") ==
        Approx(85.0 / 25.4 * 72.0).margin(0.5));
  save_figure(lines_page(), base / "f.png", {85.0, 60.0}, Replace::OwnPictures);
  const QImage png(folder.filePath("f.png"));
  CHECK(std::abs(png.width() - 85.0 / 25.4 * kFigureDpi) <= 1.0);
  CHECK(std::abs(png.height() - 60.0 / 25.4 * kFigureDpi) <= 1.0);
  CHECK(std::abs(png.dotsPerMeterX() - 23622) <= 1);
}

TEST_CASE("figure: gray style → no color, curves with different dashes", "[gui][desktop]") {
  test::use_qt();
  Figure figure{85.0};
  figure.gray = true;
  const QImage gray = figure_image(lines_page(), figure, 300.0);
  bool colored = false, black = false;
  for (int y = 0; y < gray.height(); ++y)
    for (int x = 0; x < gray.width(); ++x) {
      const QRgb c = gray.pixel(x, y);
      // Glyphs may be smoothed for the colors of a screen.
      colored =
          colored || std::abs(qRed(c) - qGreen(c)) > 60 || std::abs(qBlue(c) - qGreen(c)) > 60;
      black = black || qGray(c) < 40;
    }
  CHECK_FALSE(colored);
  CHECK(black);
  CHECK(dash_pattern(gray_theme(), 0) != dash_pattern(gray_theme(), 1));
  CHECK(dash_pattern(gray_theme(), 1) != dash_pattern(gray_theme(), 2));
  CHECK(dash_pattern(theme(ThemeKind::Light), 1).isEmpty());
}

TEST_CASE("figure: sizes and fonts that are impossible → rejected with the limits",
          "[gui][desktop]") {
  test::use_qt();
  CHECK_THROWS_WITH(check_figure({10.0, 60.0}),
                    Catch::Contains("width") && Catch::Contains("30 to 500"));
  CHECK_THROWS_WITH(check_figure({85.0, 5.0}), Catch::Contains("height"));
  CHECK_THROWS_WITH(check_figure({85.0, 60.0, 30.0}), Catch::Contains("4 to 24"));
  CHECK_THROWS_WITH(check_figure({40.0, 40.0, 20.0}), Catch::Contains("give at most"));
  CHECK_THROWS_WITH(check_figure({85.0, 60.0, 8.0, "No Such Font"}), Catch::Contains("fc-list"));
  CHECK_NOTHROW(check_figure({85.0, 60.0, 8.0, "dejavu serif", true}));
}

TEST_CASE("figure: files of other programs are kept, own ones are replaced", "[gui][desktop]") {
  test::use_qt();
  QTemporaryDir folder;
  const std::filesystem::path base = folder.path().toStdString();
  for (const char* name : {"f.svg", "f.pdf", "f.png"}) {
    save_figure(lines_page(), base / name, {85.0}, Replace::OwnPictures);
    CHECK_NOTHROW(save_figure(lines_page(), base / name, {90.0}, Replace::OwnPictures));
    std::ofstream(base / name) << "<?xml version=\"1.0\"?><svg/>";
    CHECK_THROWS_AS(save_figure(lines_page(), base / name, {85.0}, Replace::OwnPictures),
                    InputError);
    CHECK_NOTHROW(save_figure(lines_page(), base / name, {85.0}, Replace::Anything));
  }
}
