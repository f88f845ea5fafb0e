#pragma once

#include <QProxyStyle>

namespace adore::desktop {

/// Fusion with scroll bars whose handle is distinct from its track: the original handle, lighter
/// than the track, looks like the track. Check boxes and radio buttons have a visible edge: in dark
/// colors that of Fusion has a contrast of 1.2.
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
