#include "desktop/scroll_style.hpp"

#include "desktop/theme.hpp"

#include <QPainter>
#include <QStyleFactory>
#include <QStyleOptionSlider>

namespace adore::desktop {
namespace {

constexpr int kThickness = 13;
constexpr int kShortest = 28;  // handle, for a document of any length

}  // namespace

ScrollStyle::ScrollStyle() : QProxyStyle(QStyleFactory::create("Fusion")) {}

int ScrollStyle::pixelMetric(PixelMetric metric, const QStyleOption* option,
                             const QWidget* widget) const {
  if (metric == PM_ScrollBarExtent) return kThickness;
  if (metric == PM_ScrollBarSliderMin) return kShortest;
  return QProxyStyle::pixelMetric(metric, option, widget);
}

void ScrollStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option,
                                QPainter* painter, const QWidget* widget) const {
  QProxyStyle::drawPrimitive(element, option, painter, widget);
  if (element != PE_IndicatorCheckBox && element != PE_IndicatorRadioButton) return;
  const Theme& theme = current_theme();
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setPen(option->state.testFlag(State_Enabled) ? theme.muted : theme.frame);
  painter->setBrush(Qt::NoBrush);
  const QRectF edge = QRectF(option->rect).adjusted(0.5, 0.5, -0.5, -0.5);
  if (element == PE_IndicatorCheckBox)
    painter->drawRect(edge);
  else
    painter->drawEllipse(edge);
  painter->restore();
}

/// No arrows: the whole bar is track.
QRect ScrollStyle::subControlRect(ComplexControl control, const QStyleOptionComplex* option,
                                  SubControl part, const QWidget* widget) const {
  const auto* bar = qstyleoption_cast<const QStyleOptionSlider*>(option);
  if (control != CC_ScrollBar || bar == nullptr)
    return QProxyStyle::subControlRect(control, option, part, widget);
  const bool upright = bar->orientation == Qt::Vertical;
  const int track = upright ? bar->rect.height() : bar->rect.width();
  const qint64 range = qint64(bar->maximum) - bar->minimum;
  int length = track;
  if (range > 0)
    length = qBound(qMin(kShortest, track),
                    int(qint64(track) * bar->pageStep / (range + bar->pageStep)), track);
  const int at = sliderPositionFromValue(bar->minimum, bar->maximum, bar->sliderPosition,
                                         track - length, bar->upsideDown);
  const auto piece = [&](int from, int size) {
    const QRect rect = upright ? QRect(0, from, bar->rect.width(), size)
                               : QRect(from, 0, size, bar->rect.height());
    return visualRect(bar->direction, bar->rect, rect.translated(bar->rect.topLeft()));
  };
  switch (part) {
    case SC_ScrollBarGroove:
      return bar->rect;
    case SC_ScrollBarSlider:
      return piece(at, length);
    case SC_ScrollBarSubPage:
      return piece(0, at);
    case SC_ScrollBarAddPage:
      return piece(at + length, track - at - length);
    default:
      return {};
  }
}

void ScrollStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                                     QPainter* painter, const QWidget* widget) const {
  const auto* bar = qstyleoption_cast<const QStyleOptionSlider*>(option);
  if (control != CC_ScrollBar || bar == nullptr)
    return QProxyStyle::drawComplexControl(control, option, painter, widget);
  const Theme& theme = current_theme();
  painter->fillRect(bar->rect, theme.window);
  if (bar->maximum <= bar->minimum) return;
  const bool held =
      bar->state.testFlag(State_Sunken) && bar->activeSubControls == SC_ScrollBarSlider;
  const bool hovered = bar->state.testFlag(State_MouseOver);
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setPen(Qt::NoPen);
  painter->setBrush(held ? theme.accent : hovered ? theme.muted : theme.frame);
  const QRectF handle =
      QRectF(subControlRect(control, option, SC_ScrollBarSlider, widget)).adjusted(3, 2, -3, -2);
  painter->drawRoundedRect(handle, 3.5, 3.5);
  painter->restore();
}

}  // namespace adore::desktop
