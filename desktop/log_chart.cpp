#include "desktop/log_chart.hpp"

#include "desktop/image_export.hpp"

#include <QChart>
#include <QGraphicsScene>
#include <QImage>
#include <QLineSeries>
#include <QLogValueAxis>
#include <QPainter>
#include <QPen>

#include <algorithm>
#include <iterator>

namespace adore::desktop {
namespace {

/// Repeated after ten; the first seven differ for colour-blind readers too.
constexpr const char* kColours[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#8c6d00",
                                    "#56b4e9", "#444444", "#e69f00", "#7b3fb3", "#a30d0d"};

QLogValueAxis* add_axis(QChart& chart, const std::string& title, Qt::Alignment side) {
  auto* axis = new QLogValueAxis;
  axis->setTitleText(QString::fromStdString(title));
  axis->setLabelFormat("%g");
  chart.addAxis(axis, side);
  return axis;
}

/// Labels at powers of ten, or of two where ten would leave one or none.
void set_range(QLogValueAxis& axis, double low, double high) {
  constexpr double kDecades = 100.0;
  const bool wide = high >= kDecades * low;
  axis.setBase(wide ? 10.0 : 2.0);
  axis.setMinorTickCount(wide ? 8 : 0);
  axis.setRange(low, high);
}

}  // namespace

bool save_log_chart(const LogChart& data, const std::filesystem::path& file) {
  QChart chart;
  chart.setTitle(QString::fromStdString(data.title));
  QLogValueAxis* across = add_axis(chart, data.x_title, Qt::AlignBottom);
  QLogValueAxis* up = add_axis(chart, data.y_title, Qt::AlignLeft);
  double low_x = 1e300, high_x = 0.0, low_y = 1e300, high_y = 0.0;
  std::size_t colour = 0;
  for (const ChartCurve& curve : data.curves) {
    auto* line = new QLineSeries;
    line->setName(QString::fromStdString(curve.name));
    line->setPointsVisible(true);
    line->setPen(QPen(QColor(kColours[colour++ % std::size(kColours)]), 2.0));
    chart.addSeries(line);
    line->attachAxis(across);
    line->attachAxis(up);
    for (std::size_t i = 0; i < std::min(curve.x.size(), curve.y.size()); ++i) {
      line->append(curve.x[i], curve.y[i]);
      low_x = std::min(low_x, curve.x[i]), high_x = std::max(high_x, curve.x[i]);
      low_y = std::min(low_y, curve.y[i]), high_y = std::max(high_y, curve.y[i]);
    }
  }
  if (!(high_x > 0.0 && high_y > 0.0)) return false;
  set_range(*across, low_x / 1.5, high_x * 1.5);
  set_range(*up, low_y / 2.0, high_y * 2.0);
  chart.legend()->setAlignment(Qt::AlignRight);

  QGraphicsScene scene;
  scene.addItem(&chart);
  chart.resize(1280, 800);
  scene.setSceneRect(0, 0, 1280, 800);
  QImage image(1280, 800, QImage::Format_RGB32);
  image.fill(Qt::white);
  {
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    scene.render(&painter);
  }
  scene.removeItem(&chart);
  save_image(image, file);
  return true;
}

}  // namespace adore::desktop
