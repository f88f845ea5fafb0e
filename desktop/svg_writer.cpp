#include "desktop/svg_writer.hpp"

#include <QBrush>
#include <QBuffer>
#include <QFont>
#include <QGradient>
#include <QImage>
#include <QPaintDevice>
#include <QPaintEngine>
#include <QPainter>
#include <QPainterPath>
#include <QPen>
#include <QPixmap>

#include <algorithm>
#include <cmath>
#include <optional>

namespace adore::desktop {
namespace {

QString number(double value) {
  return QString::number(std::round(value * 1000.0) / 1000.0, 'g', 9);
}

class SvgEngine final : public QPaintEngine {
 public:
  SvgEngine() : QPaintEngine(AllFeatures) {}
  bool begin(QPaintDevice*) override { return true; }
  bool end() override { return true; }
  Type type() const override { return User; }

  void updateState(const QPaintEngineState& now) override {
    if (now.state() & DirtyPen) pen_ = now.pen();
    if (now.state() & DirtyBrush) brush_ = now.brush();
    if (now.state() & DirtyTransform) transform_ = now.transform();
    if (now.state() & DirtyFont) font_ = now.font();
    if (now.state() & DirtyOpacity) opacity_ = now.opacity();
    if (now.state() & DirtyClipEnabled) clips_ = now.isClipEnabled();
    if (now.state() & (DirtyClipPath | DirtyClipRegion)) take_clip(now);
  }
  void drawPath(const QPainterPath& path) override {
    const QPainterPath mapped = transform_.map(path);
    if (mapped.isEmpty()) return;
    const QString inside = clip(), filled = fill();  // definitions come before their use
    body += QString("<path d=\"%1\" %2%3%4%5/>\n")
                .arg(outline(mapped), inside, filled, stroke(),
                     mapped.fillRule() == Qt::OddEvenFill ? " fill-rule=\"evenodd\"" : "");
  }
  void drawPolygon(const QPointF* points, int count, PolygonDrawMode mode) override {
    QPainterPath path;
    if (count < 1) return;
    path.moveTo(points[0]);
    for (int i = 1; i < count; ++i) path.lineTo(points[i]);
    if (mode != PolylineMode) path.closeSubpath();
    const QBrush brush = brush_;
    if (mode == PolylineMode) brush_ = Qt::NoBrush;
    drawPath(path);
    brush_ = brush;
  }
  void drawTextItem(const QPointF& at, const QTextItem& item) override {
    const QFont font = item.font();
    const double size = font.pixelSize() > 0 ? font.pixelSize() : font.pointSizeF() * 96.0 / 72.0;
    const QTransform t = QTransform::fromTranslate(at.x(), at.y()) * transform_;
    const QString inside = clip();  // around the text, whose transformation would move it
    if (!inside.isEmpty()) body += "<g " + inside + ">";
    body +=
        QString(
            "<text transform=\"matrix(%1 %2 %3 %4 %5 %6)\" font-family=\"%7\" "
            "font-size=\"%8\"%9 fill=\"%10\" fill-opacity=\"%11\" "
            "xml:space=\"preserve\">%12</text>\n")
            .arg(number(t.m11()), number(t.m12()), number(t.m21()), number(t.m22()), number(t.dx()),
                 number(t.dy()), font.family().toHtmlEscaped(), number(size))
            .arg(font.bold() ? QString(" font-weight=\"bold\"") : QString(), pen_.color().name(),
                 number(pen_.color().alphaF() * opacity_), item.text().toHtmlEscaped());
    if (!inside.isEmpty()) body += "</g>\n";
  }
  void drawPixmap(const QRectF& target, const QPixmap& pixmap, const QRectF& source) override {
    drawImage(target, pixmap.toImage(), source, Qt::AutoColor);
  }
  void drawImage(const QRectF& target, const QImage& image, const QRectF& source,
                 Qt::ImageConversionFlags) override {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    image.copy(source.toRect()).save(&buffer, "PNG");
    const QRectF place = transform_.mapRect(target);
    const QString inside = clip();
    body += QString(
                "<image x=\"%1\" y=\"%2\" width=\"%3\" height=\"%4\" %6"
                "preserveAspectRatio=\"none\" href=\"data:image/png;base64,%5\"/>\n")
                .arg(number(place.x()), number(place.y()), number(place.width()),
                     number(place.height()), QString::fromLatin1(bytes.toBase64()), inside);
  }
  QString body;

 private:
  [[nodiscard]] static QString outline(const QPainterPath& path) {
    QString d;
    for (int i = 0; i < path.elementCount(); ++i) {
      const QPainterPath::Element e = path.elementAt(i);
      const char* letter = e.type == QPainterPath::MoveToElement    ? "M"
                           : e.type == QPainterPath::LineToElement  ? "L"
                           : e.type == QPainterPath::CurveToElement ? "C"
                                                                    : " ";
      d += letter + number(e.x) + ',' + number(e.y);
    }
    return d;
  }
  /// The clip in page coordinates, independent of later transformations of the painter.
  void take_clip(const QPaintEngineState& now) {
    QPainterPath added;
    if (now.state() & DirtyClipPath)
      added = now.clipPath();
    else
      added.addRegion(now.clipRegion());
    added = transform_.map(added);
    named_clip_.clear();
    switch (now.clipOperation()) {
      case Qt::NoClip:
        clip_.reset();
        break;
      case Qt::ReplaceClip:
        clip_ = added;
        break;
      case Qt::IntersectClip:
        clip_ = clip_ ? clip_->intersected(added) : added;
        break;
    }
  }
  [[nodiscard]] QString clip() {
    if (!clip_ || !clips_) return {};
    if (named_clip_.isEmpty()) {
      named_clip_ = QString("c%1").arg(++names_);
      body += QString("<clipPath id=\"%1\"><path d=\"%2\"/></clipPath>\n")
                  .arg(named_clip_, outline(*clip_));
    }
    return QString("clip-path=\"url(#%1)\" ").arg(named_clip_);
  }
  /// Defines the brush's gradient. @return empty for kinds that SVG does not have
  QString define(const QGradient& gradient) {
    if (gradient.coordinateMode() != QGradient::LogicalMode) return {};
    const QTransform t = brush_.transform() * transform_;
    const QString name = QString("g%1").arg(++names_);
    QString kind, place;
    if (gradient.type() == QGradient::LinearGradient) {
      const auto& line = static_cast<const QLinearGradient&>(gradient);
      kind = "linearGradient";
      place = QString("x1=\"%1\" y1=\"%2\" x2=\"%3\" y2=\"%4\"")
                  .arg(number(line.start().x()), number(line.start().y()),
                       number(line.finalStop().x()), number(line.finalStop().y()));
    } else if (gradient.type() == QGradient::RadialGradient) {
      const auto& shine = static_cast<const QRadialGradient&>(gradient);
      kind = "radialGradient";
      place =
          QString("cx=\"%1\" cy=\"%2\" r=\"%3\" fx=\"%4\" fy=\"%5\"")
              .arg(number(shine.center().x()), number(shine.center().y()), number(shine.radius()),
                   number(shine.focalPoint().x()), number(shine.focalPoint().y()));
    } else {
      return {};
    }
    body += QString(
                "<%1 id=\"%2\" gradientUnits=\"userSpaceOnUse\" %3 "
                "gradientTransform=\"matrix(%4 %5 %6 %7 %8 %9)\">")
                .arg(kind, name, place, number(t.m11()), number(t.m12()), number(t.m21()),
                     number(t.m22()), number(t.dx()))
                .arg(number(t.dy()));
    for (const QGradientStop& stop : gradient.stops())
      body += QString("<stop offset=\"%1\" stop-color=\"%2\" stop-opacity=\"%3\"/>")
                  .arg(number(stop.first), stop.second.name(), number(stop.second.alphaF()));
    body += QString("</%1>\n").arg(kind);
    return name;
  }
  [[nodiscard]] QString fill() {
    if (brush_.style() == Qt::NoBrush) return "fill=\"none\" ";
    QColor colour = brush_.color();
    if (const QGradient* gradient = brush_.gradient()) {
      if (const QString name = define(*gradient); !name.isEmpty())
        return QString("fill=\"url(#%1)\" fill-opacity=\"%2\" ").arg(name, number(opacity_));
      const auto stops = gradient->stops();
      if (!stops.isEmpty()) colour = stops[stops.size() / 2].second;
    }
    return QString("fill=\"%1\" fill-opacity=\"%2\" ")
        .arg(colour.name(), number(colour.alphaF() * opacity_));
  }
  [[nodiscard]] QString stroke() const {
    if (pen_.style() == Qt::NoPen) return {};
    const double scale = pen_.isCosmetic() ? 1.0 : std::sqrt(std::abs(transform_.determinant()));
    const double width = std::max(pen_.widthF(), 0.5) * scale;
    QString text =
        QString(
            "stroke=\"%1\" stroke-opacity=\"%2\" stroke-width=\"%3\" "
            "stroke-linejoin=\"round\"")
            .arg(pen_.color().name(), number(pen_.color().alphaF() * opacity_), number(width));
    if (pen_.style() != Qt::SolidLine) {
      QStringList dashes;
      for (const double dash : pen_.dashPattern()) dashes << number(dash * width);
      text += " stroke-dasharray=\"" + dashes.join(' ') + '"';
    }
    return text;
  }
  QPen pen_;
  QBrush brush_;
  QFont font_;
  QTransform transform_;
  double opacity_ = 1.0;
  std::optional<QPainterPath> clip_;  ///< in numbers of the page
  bool clips_ = true;                 ///< is it switched on?
  QString named_clip_;                ///< its name in the document; empty: none yet
  int names_ = 0;
};

class SvgDevice final : public QPaintDevice {
 public:
  explicit SvgDevice(QSizeF size) : size_(size) {}
  QPaintEngine* paintEngine() const override { return &engine_; }
  [[nodiscard]] QString body() const { return engine_.body; }

 protected:
  int metric(PaintDeviceMetric what) const override {
    constexpr int kDpi = 96;
    switch (what) {
      case PdmWidth:
        return static_cast<int>(size_.width());
      case PdmHeight:
        return static_cast<int>(size_.height());
      case PdmWidthMM:
        return static_cast<int>(size_.width() * 25.4 / kDpi);
      case PdmHeightMM:
        return static_cast<int>(size_.height() * 25.4 / kDpi);
      case PdmNumColors:
        return 1 << 24;
      case PdmDepth:
        return 32;
      case PdmDpiX:
      case PdmDpiY:
      case PdmPhysicalDpiX:
      case PdmPhysicalDpiY:
        return kDpi;
      case PdmDevicePixelRatio:
        return 1;
      default:
        return QPaintDevice::metric(what);
    }
  }

 private:
  QSizeF size_;
  mutable SvgEngine engine_;
};

}  // namespace

QByteArray render_svg(QSizeF size, const std::function<void(QPainter&)>& draw, const Print& print) {
  SvgDevice device(size);
  {
    QPainter painter(&device);
    draw(painter);
  }
  const QString width = number(size.width()), height = number(size.height());
  const bool paper = !print.paper.isEmpty();
  const QString head =
      QString(
          "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
          "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%3\" height=\"%4\" "
          "viewBox=\"0 0 %1 %2\">\n%5<desc>Adore</desc>\n")
          .arg(width, height, paper ? number(print.paper.width()) + "mm" : width,
               paper ? number(print.paper.height()) + "mm" : height,
               print.title.isEmpty() ? QString()
                                     : "<title>" + print.title.toHtmlEscaped() + "</title>\n");
  return (head + device.body() + "</svg>\n").toUtf8();
}

}  // namespace adore::desktop
