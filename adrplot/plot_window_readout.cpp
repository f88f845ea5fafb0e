#include "adrplot/plot_window.hpp"
#include "desktop/chart_view.hpp"

#include <QCursor>
#include <QLabel>
#include <QStatusBar>

#include <algorithm>

/// The values under the mouse, at the foot of the window.
namespace adore::adrplot {
namespace {

constexpr int kLow = 600;  ///< height of windows in which the chart needs the foot's room
constexpr int kGrip = 40;  ///< of the window's corner, and margins
constexpr int kMargin = 4;

}  // namespace

void PlotWindow::makeReadout() {
  readout_placeholder_ = new QWidget(this);
  statusBar()->addWidget(readout_placeholder_, 1);
  readout_ = new QLabel(this);
  readout_->setObjectName("readout");
  readout_->setWordWrap(true);
  readout_->setMinimumWidth(1);
  readout_->setAutoFillBackground(true);
  readout_->setAttribute(Qt::WA_TransparentForMouseEvents);  // the chart below is pointed at
  readout_->hide();
  connect(statusBar(), &QStatusBar::messageChanged, this, [this] { showReadout(); });
}

/// Height for the values of all panels, reserved in advance: a status bar that grows while the
/// mouse moves would move the chart. In a low window the values are drawn over the chart, only
/// while there are some.
void PlotWindow::fitReadout() {
  const QFontMetrics metrics(readout_->font());
  constexpr int kMostHeight = 1000;
  // Other positions have longer numbers.
  const int width = std::max(100, static_cast<int>(0.95 * (this->width() - kGrip)));
  int height = metrics.lineSpacing();
  const desktop::ChartScene& scene = view_->chartScene();
  if (!scene.plotAreas().empty())
    for (const double part : {0.0, 0.5, 1.0}) {
      const QRectF& area = scene.plotAreas().front();
      const QPointF place(area.left() + part * area.width(), area.center().y());
      const QRect room(0, 0, width, kMostHeight);
      height = std::max(
          height, metrics.boundingRect(room, Qt::TextWordWrap, scene.readout(place)).height());
    }
  // The chart stays larger than the values of very many curves; values of spectrograms are read in
  // the picture.
  const auto& panels = scene.page().panels;
  if (std::any_of(panels.begin(), panels.end(),
                  [](const auto& panel) { return panel.rows.has_value(); }))
    height = std::min(height, 2 * metrics.lineSpacing());
  const int line = metrics.lineSpacing() + 2;
  readout_->setFixedHeight(std::min(height + 2, std::max(line, this->height() / 5)));
  readout_placeholder_->setFixedHeight(this->height() < kLow ? line : readout_->height());
  showReadout();
}

/// Over the status bar and, if it is too low for all values, over the end of the window that is
/// farther from the pointer.
void PlotWindow::showReadout() {
  readout_->resize(std::max(100, width() - kGrip), readout_->height());
  readout_->setText(elidedReadout());
  const bool message = !statusBar()->currentMessage().isEmpty();
  readout_->setVisible(!readout_->text().isEmpty() && !message);
  if (readout_->isHidden()) return;
  const int top = height() - readout_->height() - kMargin;
  const bool over_chart = readout_->height() > readout_placeholder_->height();
  const bool under = mapFromGlobal(QCursor::pos()).y() >= top;
  readout_->move(kMargin, under && over_chart ? centralWidget()->y() : top);
  readout_->raise();
}

/// As many values as fit, and the number of the others.
QString PlotWindow::elidedReadout() const {
  const QFontMetrics metrics(readout_->font());
  constexpr int kMostHeight = 100000;
  const int width = std::max(100, readout_->width());
  const auto cut = [&](qsizetype count) {
    const qsizetype left = values_.size() - count;
    return values_.first(count).join("") + (left > 0 ? tr(" … %1 more").arg(left) : QString());
  };
  const auto fits = [&](qsizetype count) {
    const QRect room(0, 0, width, kMostHeight);
    return metrics.boundingRect(room, Qt::TextWordWrap, cut(count)).height() <= readout_->height();
  };
  if (fits(values_.size())) return cut(values_.size());
  qsizetype most = 0;
  for (qsizetype beyond = values_.size(); beyond - most > 1;) {
    const qsizetype middle = (most + beyond) / 2;
    (fits(middle) ? most : beyond) = middle;
  }
  return most > 0 ? cut(most) : metrics.elidedText(cut(1), Qt::ElideMiddle, width);
}

}  // namespace adore::adrplot
