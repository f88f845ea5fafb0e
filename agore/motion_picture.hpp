#pragma once

#include "agore/kept.hpp"
#include "agore/views.hpp"
#include "desktop/chart_scene.hpp"

#include <QImage>
#include <QPainter>

#include <memory>
#include <optional>
#include <vector>

namespace adore::agore {

/// A complete frame: heading, picture area, data area with the current time marked, and the time
/// bar. On a screen all constant parts (headings, curves, rings of the races) are drawn once into a
/// backdrop that every frame copies, for speed.
class MotionPicture {
 public:
  explicit MotionPicture(Animation animation);

  [[nodiscard]] const Animation& animation() const { return animation_; }
  [[nodiscard]] std::size_t frames() const { return animation_.frames(); }
  void paint(QPainter& painter, const QRectF& area, std::size_t frame, const ViewOptions& options);
  [[nodiscard]] QImage image(QSize size, std::size_t frame, const ViewOptions& options);
  /// The same as lines, surfaces and text; bodies of the 3D view stay pixels.
  [[nodiscard]] QByteArray svg(QSize size, std::size_t frame, const ViewOptions& options);
  /// A picture of that size, as large as it fits on the paper, as lines, surfaces and text.
  void paintOnPaper(QPainter& painter, const QRectF& paper, QSizeF size, std::size_t frame,
                    const ViewOptions& options);
  /// Part of the simulated time shown so far, 0 to 1.
  [[nodiscard]] double progress(std::size_t frame) const {
    return progressAt(animation_.time.at(frame));
  }
  [[nodiscard]] double progressAt(double time) const;
  /// The time bar inside `area`, so that a window can be clicked there.
  [[nodiscard]] static QRectF timeBar(const QRectF& area);
  /// Areas of the pictures (one for each view) and of the curves inside `area`.
  [[nodiscard]] static std::vector<QRectF> pictureAreas(const QRectF& area, std::size_t views,
                                                        const ShownParts& shown = {});
  /// Empty if the curves are hidden.
  [[nodiscard]] static QRectF dataArea(const QRectF& area, std::size_t views = 1,
                                       const ShownParts& shown = {});
  /// Area of the common key of views that are too low for separate keys; empty: none.
  [[nodiscard]] static QRectF sharedLegendArea(const QRectF& area, std::size_t views,
                                               const ShownParts& shown = {});
  /// Time at a position on a panel of the curves, as painted last; none elsewhere.
  [[nodiscard]] std::optional<double> timeAt(const QRectF& area, QPointF position,
                                             const ShownParts& shown = {}) const;
  /// Element (from 0) at a position, in a view that shows all of them.
  [[nodiscard]] std::optional<std::size_t> elementAt(const QRectF& area, QPointF position,
                                                     std::size_t frame,
                                                     const ViewOptions& options) const;
  [[nodiscard]] std::size_t frameAt(double time) const;  ///< the nearest one
  /// Of the images of moving parts that all views keep [bytes].
  [[nodiscard]] double cachedImageBytes() const { return sprite_cache_->bytes(); }

 private:
  /// Area of the pictures, without the frames and titles of several pictures.
  [[nodiscard]] static std::vector<QRectF> innerAreas(const QRectF& area, std::size_t views,
                                                      const ShownParts& shown);
  static void paintHeading(QPainter& painter, const QRectF& area, const Animation& animation,
                           const ViewOptions& options);
  void makeDataPage(QSizeF size, const ViewOptions& options);
  /// Headings, titles of several views, the data area's curves.
  void paintStaticParts(QPainter& painter, const QRectF& area, const ViewOptions& options);
  /// The backdrop for this frame; only parts whose key has changed are drawn again.
  const QImage& backdrop(const QRectF& area, double ratio, std::size_t frame,
                         const ViewOptions& options);
  void paintCurrentTime(QPainter& painter, const QRectF& data, std::size_t frame,
                        const ViewOptions& options);
  void paintTimeBar(QPainter& painter, const QRectF& bar, std::size_t frame,
                    const ViewOptions& options) const;

  Animation animation_;
  desktop::ChartScene chart_scene_{desktop::ChartStyle::Compact};
  /// Dependencies of a constant part of the window.
  struct BackdropKey {
    QSizeF size;
    double ratio = 0.0;
    View view{};
    int element = 0;
    std::size_t flange_race = 0;
    bool dark = false;
    std::vector<View> beside;
    ShownParts shown;
    bool operator==(const BackdropKey&) const = default;
  };
  [[nodiscard]] static BackdropKey backdrop_key(QSizeF size, double ratio,
                                                const ViewOptions& options);

  QImage backdrop_;
  BackdropKey backdrop_key_, chart_scene_key_;
  std::vector<StaticLayerKey> static_layer_keys_;  ///< of each view
  std::vector<ViewCache> view_caches_;             ///< of each view
  std::shared_ptr<SpriteCache> sprite_cache_ = std::make_shared<SpriteCache>();
  SharedLegend shared_legend_;
};

}  // namespace adore::agore
