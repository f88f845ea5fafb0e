#include "desktop/figure.hpp"

#include "base/errors.hpp"
#include "desktop/page_export.hpp"
#include "desktop/pdf_pages.hpp"
#include "desktop/svg_writer.hpp"

#include <QFileInfo>
#include <QFontDatabase>
#include <QPainter>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace adore::desktop {
namespace {

constexpr double kInch = 25.4, kPointsPerInch = 72.0;  // [mm], [pt]
constexpr double kTextPixels = 11.0;                   // axis titles of ChartStyle::Compact

/// Pixels of the layout, in which the letters have their usual number of pixels.
QSizeF layout_of(const Figure& figure) {
  return figure.paper() * kTextPixels * kPointsPerInch / (figure.letters * kInch);
}

/// A scene with the fonts and colors of a figure, for as long as it lives.
class FigureScene {
 public:
  FigureScene(const ChartPage& page, const Figure& figure, const ChartZoom* zoom)
      : font_(figure.font), size_(layout_of(figure)), scene_(ChartStyle::Compact) {
    scene_.setTheme(figure.gray ? gray_theme() : theme(ThemeKind::Light));
    scene_.setPageSize(size_);
    ChartPage titled = page;
    if (!page.about.empty() && page.about != kAllChannels) titled.title += ", " + page.about;
    scene_.setPage(std::move(titled));
    if (zoom != nullptr) scene_.setZoom(*zoom);
  }

  [[nodiscard]] QSizeF size() const { return size_; }
  void paint(QPainter& painter, const QRectF& target) {
    paint_vector(scene_, painter, target, size_);
  }

 private:
  PictureFont font_;
  QSizeF size_;
  ChartScene scene_;
};

QImage image_of(FigureScene& scene, const Figure& figure, double dpi) {
  const QSizeF dots = figure.paper() * dpi / kInch;
  QImage image(dots.toSize(), QImage::Format_RGB32);
  image.fill(Qt::white);
  image.setDotsPerMeterX(static_cast<int>(std::lround(1000.0 * dpi / kInch)));
  image.setDotsPerMeterY(image.dotsPerMeterX());
  QPainter painter(&image);
  scene.paint(painter, QRectF(QPointF(0, 0), QSizeF(image.size())));
  return image;
}

void check_length(const char* what, double value) {
  if (value >= kLeastFigure && value <= kLargestFigure) return;
  throw InputError(fmt::format("{} of a figure: {:g} mm; give a number from {:g} to {:g}", what,
                               value, kLeastFigure, kLargestFigure));
}

}  // namespace

Figure with_height(Figure figure, const ChartPage& page) {
  if (figure.height > 0.0) return figure;
  const auto panels = static_cast<double>(std::max<std::size_t>(page.panels.size(), 1));
  figure.height = (0.75 + 0.2 * (panels - 1.0)) * figure.width;
  return figure;
}

void check_figure(const Figure& figure) {
  check_length("width", figure.width);
  check_length("height", figure.paper().height());
  if (!(figure.letters >= kLeastLetters && figure.letters <= kLargestLetters))
    throw InputError(
        fmt::format("letter size of a figure: {:g} pt; give a number from {:g} to {:g}",
                    figure.letters, kLeastLetters, kLargestLetters));
  constexpr double kLeastWidth = 220.0, kLeastHeight = 150.0;  // pixels that axes and legend need
  const QSizeF layout = layout_of(figure);
  if (const double over = std::max(kLeastWidth / layout.width(), kLeastHeight / layout.height());
      over > 1.0)
    throw InputError(fmt::format(
        "letters of {:g} pt are too large for a figure of {:g} x {:g} mm; give at most {:.1f} pt",
        figure.letters, figure.width, figure.paper().height(),
        std::floor(10.0 * figure.letters / over) / 10.0));
  if (!figure.font.empty() &&
      !QFontDatabase::families().contains(QString::fromStdString(figure.font), Qt::CaseInsensitive))
    throw InputError(fmt::format(
        "the font \"{}\" is not installed; \"fc-list : family\" lists the installed fonts",
        figure.font));
}

QImage figure_image(const ChartPage& page, const Figure& wanted, double dpi,
                    const ChartZoom* zoom) {
  const Figure figure = with_height(wanted, page);
  check_figure(figure);
  FigureScene scene(page, figure, zoom);
  return image_of(scene, figure, dpi);
}

void save_figure(const ChartPage& page, const std::filesystem::path& path, const Figure& wanted,
                 Replace replace, const ChartZoom* zoom) {
  const Figure figure = with_height(wanted, page);
  check_figure(figure);
  if (replace == Replace::OwnPictures) check_replaceable(path);
  const QString suffix = QFileInfo(QString::fromStdString(path.string())).suffix().toLower();
  const QString title = QString::fromStdString(page.title);
  FigureScene scene(page, figure, zoom);
  if (suffix == "svg") {
    const auto draw = [&](QPainter& painter) {
      scene.paint(painter, QRectF(QPointF(0, 0), scene.size()));
    };
    save_bytes(render_svg(scene.size(), draw, {title, figure.paper()}), path);
  } else if (suffix == "pdf") {
    const auto draw = [&](QPainter& painter) {
      scene.paint(painter, QRectF(QPointF(0, 0), scene.size()));
    };
    save_bytes(render_pdf(scene.size(), draw, {title, figure.paper()}), path);
  } else {
    save_image(image_of(scene, figure, kFigureDpi), path, replace);
  }
}

}  // namespace adore::desktop
