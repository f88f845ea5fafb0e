#pragma once

#include <QColor>
#include <QImage>
#include <QPainter>

#include <array>
#include <compare>
#include <cstdint>
#include <functional>
#include <map>

/// Drawings that only move from frame to frame (rings, roller ends, balls), stored as images.
/// Shades and curves are computed once; a frame copies pixels. (Qt would distribute each shaded or
/// translucent fill of more than a hundred spans to threads, which costs more than the fill.)
///
/// Images have whole pixel positions, so they are stored for fractions of a pixel: quarters for
/// small ones, halves for large ones. Position errors are at most 1/8 and 1/4 pixel.
///
/// All views of a window share one cache. If it is full, the least recently used images are
/// deleted.
namespace adore::agore {

class SpriteCache {
 public:
  static constexpr double kRoom = 160e6;  ///< [bytes]
  /// @param room memory for all images [bytes]
  explicit SpriteCache(double room = kRoom) : room_(room) {}
  /// Appearance of a drawing: equal values give equal pictures.
  struct DrawingAppearance {
    int kind = 0;
    std::array<double, 2> sizes{};  ///< [pixels]
    std::array<QRgb, 3> colours{};
    auto operator<=>(const DrawingAppearance&) const = default;
  };
  /// Draws `paint` centered at `middle`, with an extent of at most `reach` pixels in each
  /// direction.
  void draw(QPainter& painter, QPointF middle, double reach, const DrawingAppearance& look,
            const std::function<void(QPainter&, QPointF)>& paint);
  /// Images that are kept.
  [[nodiscard]] std::size_t size() const { return images_.size(); }
  [[nodiscard]] double bytes() const { return bytes_; }

 private:
  struct Key {
    DrawingAppearance look;
    int right = 0, down = 0;  ///< between pixels, in parts of one
    double ratio = 0.0;
    auto operator<=>(const Key&) const = default;
  };
  struct Image {
    QImage image;
    std::uint64_t drawn = 0;  ///< when last, counted in drawings
  };
  /// Lets images go until that much is free.
  void make_room(double bytes);
  std::map<Key, Image> images_;
  double room_, bytes_ = 0.0;
  std::uint64_t draw_count_ = 0;
};

}  // namespace adore::agore
