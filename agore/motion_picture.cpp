#include "agore/motion_picture.hpp"

#include "agore/race_speeds.hpp"
#include "agore/view_layout.hpp"
#include "desktop/axis_scale.hpp"
#include "desktop/svg_writer.hpp"

#include <QFontMetricsF>
#include <QPaintDevice>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace adore::agore {
namespace {

constexpr int kSmallLetters = 11;  // letters of two lines in the space of one
constexpr double kHeading = 58, kMargin = 22;
constexpr double kTileFoot = 2;  // of one of several views: its frame

/// Of one of several views, for its title.
double tile_top(const QRectF& tile) { return tile.height() < 200.0 ? 20.0 : 28.0; }

/// Low pictures have a low time bar.
bool low(const QRectF& area) { return area.height() < 520.0; }
double bar_space(const QRectF& area) { return low(area) ? 44.0 : 58.0; }

/// Values of all curves at the nearest time, as text under the title of the data area: one line or,
/// if too narrow, two; only the values, in the order of the legends, if these are shown, too.
QStringList present_values(const desktop::ChartScene& scene, double time, double width) {
  const desktop::ChartPage& page = scene.page();
  QStringList parts, values;
  const std::size_t at = desktop::nearest_index(page.x, time);
  for (const auto& panel : page.panels)
    for (const auto& curve : panel.curves) {
      if (at >= curve.y.size()) continue;
      const bool first = &curve == &panel.curves.front();
      const std::string name = curve.name.empty()                ? panel.title
                               : first && page.panels.size() > 1 ? panel.title + " " + curve.name
                                                                 : curve.name;
      // Changes below the size of an atom are rounding.
      const bool nothing = std::abs(curve.y[at]) < desktop::min_axis_span(panel.unit);
      const std::string value =
          std::isfinite(curve.y[at])
              ? desktop::pretty_quantity(nothing ? 0.0 : curve.y[at], panel.unit, 3)
              : std::string("none");
      parts << QString::fromStdString(name + ": " + value);
      values << QString::fromStdString(value);
    }
  const QFontMetricsF metrics(desktop::ui_font(12)), small(desktop::ui_font(kSmallLetters));
  const QString whole = parts.join("   ");
  if (parts.isEmpty() || metrics.horizontalAdvance(whole) <= width) {
    const QString note = QString::fromStdString(scene.showsBandNote() ? page.band_note : page.note);
    if (note.isEmpty() || small.horizontalAdvance(note) > width) return {whole};
    return {whole, note};
  }
  QStringList lines;
  for (const QString& part : parts) {
    const QString longer = lines.isEmpty() ? part : lines.back() + "   " + part;
    if (!lines.isEmpty() && small.horizontalAdvance(longer) <= width)
      lines.back() = longer;
    else
      lines << part;
  }
  const bool fit = lines.size() <= 2 && std::all_of(lines.begin(), lines.end(), [&](const auto& l) {
                     return small.horizontalAdvance(l) <= width;
                   });
  return fit ? lines : QStringList{metrics.elidedText(values.join(" · "), Qt::ElideRight, width)};
}

}  // namespace

MotionPicture::MotionPicture(Animation animation) : animation_(std::move(animation)) {}

double MotionPicture::progressAt(double time) const {
  const double span = animation_.time.back() - animation_.time.front();
  return span > 0.0 ? std::clamp((time - animation_.time.front()) / span, 0.0, 1.0) : 1.0;
}

namespace {

/// Positions of several pictures of one size, with the number of columns for the largest squares.
std::vector<QRectF> tiles_of(const QRectF& all, std::size_t views) {
  int columns = 1;
  double best = 0.0;
  const int n = static_cast<int>(views);
  for (int c = 1; c <= n; ++c) {
    const int rows = (n + c - 1) / c;
    const double side = std::min(all.width() / c, all.height() / rows);
    if (side > best) best = side, columns = c;
  }
  const int rows = (n + columns - 1) / columns;
  const QSizeF size(all.width() / columns, all.height() / rows);
  std::vector<QRectF> out;
  for (int i = 0; i < n; ++i)
    out.emplace_back(QPointF(all.left() + size.width() * (i % columns),
                             all.top() + size.height() * static_cast<double>(i / columns)),
                     size);
  for (QRectF& tile : out) tile.adjust(3.0, 3.0, -3.0, -3.0);
  return out;
}

double data_width(const QRectF& area) { return std::clamp(0.36 * area.width(), 200.0, 560.0); }

double head_of(const ShownParts& shown) { return shown.heading ? kHeading : 0.5 * kMargin; }

/// Of all pictures, without a key that they share.
QRectF pictures_area(const QRectF& area, const ShownParts& shown) {
  return {area.left() + kMargin, area.top() + head_of(shown),
          area.width() - 2.0 * kMargin - (shown.chart ? data_width(area) + 10.0 : 0.0),
          area.height() - head_of(shown) - bar_space(area)};
}

}  // namespace

QRectF MotionPicture::sharedLegendArea(const QRectF& area, std::size_t views,
                                       const ShownParts& shown) {
  if (views <= 1 || !shown.key) return {};
  const QRectF all = pictures_area(area, shown), tile = tiles_of(all, views).front();
  if (tile.height() - tile_top(tile) - kTileFoot >= kTooLowBeside) return {};
  if (!shown.chart) {  // below the pictures, in wide lines
    constexpr double kPart = 0.2;
    const double height = std::min(SharedLegend::height(), kPart * all.height());
    return {all.left(), all.bottom() - height, all.width(), height};
  }
  // Below the curves: the space next to the pictures belongs to them.
  // The numbers of the axis need some of it; the key has smaller letters then.
  constexpr double kLeastChart = 164.0, kLeastKey = 0.4;
  const double both = all.height();
  const double height =
                   std::min(SharedLegend::height(), std::max(kLeastKey * both, both - kLeastChart)),
               width = data_width(area);
  return {area.right() - kMargin - width, area.bottom() - bar_space(area) - height, width, height};
}

QRectF MotionPicture::dataArea(const QRectF& area, std::size_t views, const ShownParts& shown) {
  if (!shown.chart) return {};
  const double width = data_width(area), top = area.top() + head_of(shown);
  const double bottom =
      area.bottom() - bar_space(area) - sharedLegendArea(area, views, shown).height();
  return {area.right() - kMargin - width, top, width, std::min(bottom - top, 1.25 * width)};
}

std::vector<QRectF> MotionPicture::pictureAreas(const QRectF& area, std::size_t views,
                                                const ShownParts& shown) {
  QRectF all = pictures_area(area, shown);
  if (views <= 1) return {all};
  if (!shown.chart) all.setHeight(all.height() - sharedLegendArea(area, views, shown).height());
  return tiles_of(all, views);
}

std::optional<double> MotionPicture::timeAt(const QRectF& area, QPointF position,
                                            const ShownParts& shown) const {
  if (!shown.chart) return std::nullopt;
  const QRectF data = dataArea(area, 1, shown);
  const QPointF inside = position - data.topLeft();
  if (!chart_scene_.panelAt(inside)) return std::nullopt;
  return chart_scene_.abscissaAt(inside.x());
}

std::optional<std::size_t> MotionPicture::elementAt(const QRectF& area, QPointF position,
                                                    std::size_t frame,
                                                    const ViewOptions& options) const {
  const std::vector<QRectF> tiles = innerAreas(area, 1 + options.beside.size(), options.shown);
  for (std::size_t i = 0; i < tiles.size(); ++i)
    if (tiles[i].contains(position))
      return element_at(tiles[i], position, animation_, frame, options.tile(i));
  return std::nullopt;
}

std::size_t MotionPicture::frameAt(double time) const {
  return desktop::nearest_index(animation_.time, time);
}

QRectF MotionPicture::timeBar(const QRectF& area) {
  return {area.left() + kMargin, area.bottom() - (low(area) ? 17 : 26), area.width() - 2 * kMargin,
          10};
}

void MotionPicture::paint(QPainter& painter, const QRectF& area, std::size_t frame,
                          const ViewOptions& options) {
  for (std::size_t i = 0; i <= options.beside.size(); ++i) check_view(animation_, options.tile(i));
  const std::vector<QRectF> tiles = innerAreas(area, 1 + options.beside.size(), options.shown);
  view_caches_.resize(std::max(view_caches_.size(), tiles.size()));
  for (ViewCache& kept : view_caches_) kept.stamps = sprite_cache_;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  if (is_raster_target(painter)) {
    const double ratio = painter.device()->devicePixelRatioF();
    painter.drawImage(area.topLeft(), backdrop(area, ratio, frame, options));
  } else {
    painter.fillRect(area, theme_of(options).surface);
    paintStaticParts(painter, area, options);
    for (std::size_t i = 0; i < tiles.size(); ++i)
      paint_picture(painter, tiles[i], animation_, frame, options.tile(i), &view_caches_[i],
                    Layers::Still);
  }
  for (std::size_t i = 0; i < tiles.size(); ++i)
    paint_picture(painter, tiles[i], animation_, frame, options.tile(i), &view_caches_[i],
                  Layers::Moving);
  if (const QRectF place = sharedLegendArea(area, tiles.size(), options.shown); !place.isEmpty()) {
    std::vector<PictureLegendEntry> entries;
    for (std::size_t i = 0; i < tiles.size(); ++i) {
      const std::vector<PictureLegendEntry>& own = view_caches_[i].key.omittedEntries();
      entries.insert(entries.end(), own.begin(), own.end());
    }
    shared_legend_.draw(painter, place, theme_of(options), std::move(entries));
  }
  if (options.shown.chart)
    paintCurrentTime(painter, dataArea(area, tiles.size(), options.shown), frame, options);
  paintTimeBar(painter, timeBar(area), frame, options);
  painter.restore();
}

std::vector<QRectF> MotionPicture::innerAreas(const QRectF& area, std::size_t views,
                                              const ShownParts& shown) {
  std::vector<QRectF> tiles = pictureAreas(area, views, shown);
  if (tiles.size() > 1)
    for (QRectF& tile : tiles) tile.adjust(4.0, tile_top(tile), -4.0, -kTileFoot);
  return tiles;
}

MotionPicture::BackdropKey MotionPicture::backdrop_key(QSizeF size, double ratio,
                                                       const ViewOptions& options) {
  BackdropKey out{size,         ratio, options.view, options.element, options.flange_race,
                  options.dark, {},    options.shown};
  for (const AdditionalView& side : options.beside) out.beside.push_back(side.view);
  return out;
}

const QImage& MotionPicture::backdrop(const QRectF& area, double ratio, std::size_t frame,
                                      const ViewOptions& options) {
  const desktop::Theme& t = theme_of(options);
  const BackdropKey now = backdrop_key(area.size(), ratio, options);
  const QRectF all(QPointF(0.0, 0.0), area.size());
  const auto draw = [&](const auto& what) {
    QPainter once(&backdrop_);
    once.setRenderHint(QPainter::Antialiasing);
    what(once);
  };
  if (!(now == backdrop_key_) || backdrop_.isNull()) {
    backdrop_ = QImage((area.size() * ratio).toSize(), QImage::Format_RGB32);
    backdrop_.setDevicePixelRatio(ratio);
    backdrop_.fill(t.surface);
    draw([&](QPainter& once) { paintStaticParts(once, all, options); });
    backdrop_key_ = now;
    static_layer_keys_.clear();
  }
  const std::vector<QRectF> tiles = innerAreas(all, 1 + options.beside.size(), options.shown);
  static_layer_keys_.resize(tiles.size());
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    const ViewOptions own = options.tile(i);
    const StaticLayerKey key = static_layer_key(tiles[i], animation_, frame, own);
    if (key == static_layer_keys_[i]) continue;
    static_layer_keys_[i] = key;
    draw([&](QPainter& once) {
      once.fillRect(tiles[i], t.surface);
      paint_picture(once, tiles[i], animation_, frame, own, &view_caches_[i], Layers::Still);
    });
  }
  return backdrop_;
}

void MotionPicture::paintHeading(QPainter& painter, const QRectF& area, const Animation& animation,
                                 const ViewOptions& options) {
  const desktop::Theme& t = theme_of(options);
  painter.setFont(desktop::ui_font(18, true));
  painter.setPen(t.text);
  const QString title = options.beside.empty() ? QString::fromStdString(view_title(options.view))
                                               : QString("Views of the same frame");
  const double title_width = QFontMetricsF(painter.font()).horizontalAdvance(title);
  painter.drawText(QPointF(area.left() + kMargin, area.top() + 30), title);
  painter.setFont(desktop::ui_font(13));
  painter.setPen(t.muted);
  const std::string run = animation.file.run_id.empty() ? "(no run name)" : animation.file.run_id;
  const std::string gap = "   ·   ", speed = speed_text(animation);
  const QString origin =
      QString::fromStdString(run + (speed.empty() ? speed : gap + speed) + gap +
                             animation.file.path.filename().string() + gap + animation.source);
  const QFontMetricsF metrics(painter.font());
  const double width = area.width() - 2.0 * kMargin;
  const auto heading = desktop::fitted_heading(origin, metrics, width, width - title_width - 24.0);
  painter.drawText(QPointF(area.left() + kMargin, area.top() + 50), heading.below);
  painter.drawText(
      QPointF(area.right() - kMargin - metrics.horizontalAdvance(heading.beside), area.top() + 30),
      heading.beside);
}

void MotionPicture::paintStaticParts(QPainter& painter, const QRectF& area,
                                     const ViewOptions& options) {
  const desktop::Theme& t = theme_of(options);
  if (options.shown.heading) paintHeading(painter, area, animation_, options);
  const std::vector<QRectF> tiles = pictureAreas(area, 1 + options.beside.size(), options.shown);
  for (std::size_t i = 0; i < tiles.size() && tiles.size() > 1; ++i) {
    painter.setPen(QPen(t.grid, 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(tiles[i]);
    const bool small = tile_top(tiles[i]) < 24.0;
    painter.setFont(desktop::ui_font(small ? kSmallLetters : 12, true));
    painter.setPen(t.text);
    painter.drawText(tiles[i].adjusted(8.0, small ? 2.0 : 4.0, -8.0, 0.0),
                     Qt::AlignLeft | Qt::AlignTop,
                     QString::fromStdString(view_title(options.tile(i).view)));
  }
  if (!options.shown.chart) return;
  const QRectF data = dataArea(area, tiles.size(), options.shown);
  makeDataPage(data.size(), options);
  painter.save();
  chart_scene_.paintPage(painter, data);
  painter.restore();
}

void MotionPicture::makeDataPage(QSizeF size, const ViewOptions& options) {
  BackdropKey now = backdrop_key(size, 1.0, options);
  now.beside.clear();
  now.shown = {};
  if (now == chart_scene_key_) return;
  chart_scene_.setTheme(theme_of(options));
  chart_scene_.setPageSize(size);
  desktop::ChartPage page = data_page(animation_, options);
  // Stored values are marked if they are visibly apart: values in between are unknown.
  constexpr double kApart = 6.0;  // pixels
  page.points = static_cast<double>(page.x.size()) * kApart < size.width();
  chart_scene_.setPage(std::move(page));
  chart_scene_key_ = now;
}

/// The present moment on the curves, and their values there.
void MotionPicture::paintCurrentTime(QPainter& painter, const QRectF& area, std::size_t frame,
                                     const ViewOptions& options) {
  const desktop::Theme& t = theme_of(options);
  if (options.span_from || options.span_to) {
    QColor pale = t.accent;
    pale.setAlpha(45);
    const double from = chart_scene_.sceneXAt(options.span_from.value_or(animation_.time.front())),
                 to = chart_scene_.sceneXAt(options.span_to.value_or(animation_.time.back()));
    for (const QRectF& plot : chart_scene_.plotAreas())
      painter.fillRect(
          QRectF(area.left() + from, area.top() + plot.top(), to - from, plot.height()), pale);
  }
  painter.setPen(QPen(t.red, 1.4));
  const double x = area.left() + chart_scene_.sceneXAt(animation_.time.at(frame));
  const auto& plots = chart_scene_.plotAreas();
  for (std::size_t p = 0; p < plots.size(); ++p) {
    const QRectF& plot = plots[p];
    if (p < chart_scene_.page().panels.size() && !chart_scene_.page().panels[p].message.empty())
      continue;
    painter.drawLine(QPointF(x, area.top() + plot.top()), QPointF(x, area.top() + plot.bottom()));
  }
  painter.setFont(desktop::ui_font(12));
  painter.setPen(t.muted);
  const QStringList lines =
      present_values(chart_scene_, animation_.time.at(frame), area.width() - 20);
  const bool two = lines.size() > 1;
  if (two || QFontMetricsF(painter.font()).horizontalAdvance(lines.front()) > area.width() - 20)
    painter.setFont(desktop::ui_font(kSmallLetters));
  const double height = two ? 12.0 : 18.0;
  for (qsizetype i = 0; i < lines.size(); ++i)
    painter.drawText(
        QRectF(area.left() + 12, area.top() + (two ? 23.0 : 26.0) + height * static_cast<double>(i),
               area.width() - 12, height),
        Qt::AlignLeft | Qt::AlignVCenter, lines[i]);
}

void MotionPicture::paintTimeBar(QPainter& painter, const QRectF& bar, std::size_t frame,
                                 const ViewOptions& options) const {
  const desktop::Theme& t = theme_of(options);
  const double radius = 0.5 * bar.height();
  painter.setPen(Qt::NoPen);
  painter.setBrush(t.raised);
  painter.drawRoundedRect(bar, radius, radius);
  QRectF filled = bar;
  filled.setWidth(std::max(bar.height(), bar.width() * progress(frame)));
  painter.setBrush(t.accent);
  painter.drawRoundedRect(filled, radius, radius);
  const auto at = [&](double time) { return bar.left() + bar.width() * progressAt(time); };
  if (options.span_from || options.span_to) {
    // Brackets around the repeated range.
    painter.setPen(QPen(t.text, 2.0, Qt::SolidLine, Qt::FlatCap));
    constexpr double kOver = 3.0, kArm = 5.0;
    const auto bracket = [&](double x, double arm) {
      const double top = bar.top() - kOver, bottom = bar.bottom() + kOver;
      painter.drawPolyline(QPolygonF{{x + arm, top}, {x, top}, {x, bottom}, {x + arm, bottom}});
    };
    if (options.span_from) bracket(at(*options.span_from), kArm);
    if (options.span_to) bracket(at(*options.span_to), -kArm);
  }
  if (animation_.alone) {  // from here on of SOL8 alone
    painter.setPen(QPen(t.muted, 1.4, Qt::DashLine));
    const double x = at(animation_.time.at(animation_.exact - 1));
    painter.drawLine(QPointF(x, bar.top() - 3.0), QPointF(x, bar.bottom() + 3.0));
  }
  QString remarks;
  if (options.span_from || options.span_to)
    remarks += QString("repeat: frames %1 to %2   ·   ")
                   .arg(1 + (options.span_from ? frameAt(*options.span_from) : 0))
                   .arg(options.span_to ? 1 + frameAt(*options.span_to) : frames());
  if (animation_.behind(frame)) remarks += "from SOL8 only   ·   ";
  const auto& now = animation_.frame(frame);
  painter.setFont(desktop::ui_font(12));
  painter.setPen(t.muted);
  const QRectF line(bar.left(), bar.top() - 21, bar.width(), 18);
  painter.drawText(
      line, Qt::AlignLeft | Qt::AlignVCenter,
      QString::fromStdString(fmt::format("t = {}   ·   {} rev   ·   step {}",
                                         desktop::pretty_quantity(now.time, "s", 5),
                                         desktop::tick_text(now.revolutions, 3), now.step)));
  painter.drawText(line, Qt::AlignRight | Qt::AlignVCenter,
                   remarks + QString("frame %1 of %2").arg(frame + 1).arg(frames()));
}

QImage MotionPicture::image(QSize size, std::size_t frame, const ViewOptions& options) {
  QImage image(size, QImage::Format_RGB32);
  QPainter painter(&image);
  paint(painter, QRectF(QPointF(0, 0), QSizeF(size)), frame, options);
  return image;
}

QByteArray MotionPicture::svg(QSize size, std::size_t frame, const ViewOptions& options) {
  return desktop::render_svg(size, [&](QPainter& painter) {
    paint(painter, QRectF(QPointF(0, 0), QSizeF(size)), frame, options);
  });
}

void MotionPicture::paintOnPaper(QPainter& painter, const QRectF& paper, QSizeF size,
                                 std::size_t frame, const ViewOptions& options) {
  const double scale = std::min(paper.width() / size.width(), paper.height() / size.height());
  painter.save();
  painter.translate(paper.topLeft());
  painter.scale(scale, scale);
  paint(painter, QRectF(QPointF(0, 0), size), frame, options);
  painter.restore();
}

}  // namespace adore::agore
