#pragma once

#include <QProxyStyle>

namespace adore::desktop {

/// Fusion with scroll bars whose handle stands out from its track: in Fusion's own a handle lighter
/// than the track is easily taken for the track. Boxes and rings to be ticked have an edge that is
/// seen: Fusion's has a contrast of 1.2 in dark colors.
class ScrollStyle : public QProxyStyle {
  Q_OBJECT
 public:
  ScrollStyle();
  void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                          QPainter* painter, const QWidget* widget) const override;
  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
  QRect subControlRect(ComplexControl control, const QStyleOptionComplex* option, SubControl part,
                       const QWidget* widget) const override;
  int pixelMetric(PixelMetric metric, const QStyleOption* option,
                  const QWidget* widget) const override;
};

}  // namespace adore::desktop
