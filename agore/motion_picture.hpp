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

/// A whole frame: heading, picture area, data area with the present moment marked, and the time bar
/// that fills. On a screen everything that stands still (headings, curves, rings of the races) is
/// drawn once into a backdrop, which every frame copies, so that a frame is quick.
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
  /// Places of the pictures (one for each view) and of the curves inside `area`.
  [[nodiscard]] static std::vector<QRectF> pictureAreas(const QRectF& area, std::size_t views);
  [[nodiscard]] static QRectF dataArea(const QRectF& area, std::size_t views = 1);
  /// Place of the key that several views share where they are too low for their own; empty: none.
  [[nodiscard]] static QRectF sharedKeyArea(const QRectF& area, std::size_t views);
  /// Time at a position on one of the curves' panels, as painted last; none beside them.
  [[nodiscard]] std::optional<double> timeAt(const QRectF& area, QPointF position) const;
  [[nodiscard]] std::size_t frameAt(double time) const;  ///< the nearest one
  /// Of the images of moving parts that all views keep [bytes].
  [[nodiscard]] double keptBytes() const { return stamps_->bytes(); }

 private:
  /// Where the pictures themselves are drawn; beside their frames and titles, if several.
  [[nodiscard]] static std::vector<QRectF> innerAreas(const QRectF& area, std::size_t views);
  void makeDataPage(QSizeF size, const ViewOptions& options);
  /// Headings, titles of several views, the data area's curves.
  void paintSetting(QPainter& painter, const QRectF& area, const ViewOptions& options);
  /// The backdrop for this frame, with as little drawn anew as its key says.
  const QImage& backdrop(const QRectF& area, double ratio, std::size_t frame,
                         const ViewOptions& options);
  void paintMoment(QPainter& painter, const QRectF& data, std::size_t frame,
                   const ViewOptions& options);
  void paintTimeBar(QPainter& painter, const QRectF& bar, std::size_t frame,
                    const ViewOptions& options) const;

  Animation animation_;
  desktop::ChartScene data_{desktop::ChartStyle::Compact};
  /// What a part of the window that stands still depends on.
  struct Setting {
    QSizeF size;
    double ratio = 0.0;
    View view{};
    int element = 0;
    std::size_t flange_race = 0;
    bool dark = false;
    std::vector<View> beside;
    bool operator==(const Setting&) const = default;
  };
  [[nodiscard]] static Setting setting(QSizeF size, double ratio, const ViewOptions& options);

  QImage backdrop_;
  Setting setting_, data_setting_;
  std::vector<StillKey> still_;  ///< of each view
  std::vector<Kept> kept_;       ///< of each view
  std::shared_ptr<Stamps> stamps_ = std::make_shared<Stamps>();
  SharedKey shared_key_;
};

}  // namespace adore::agore
