#pragma once

#include <QColor>
#include <QImage>
#include <QPainter>

#include <array>
#include <compare>
#include <functional>
#include <map>

/// Drawings that only move from frame to frame (rings, ends of rollers, balls), kept as images.
/// Shades and curves are set once; a frame copies pixels. (Qt, besides, hands every shaded or
/// translucent fill of more than a hundred spans to helpers, which costs a core more than the
/// fill.)
///
/// An image lies on whole pixels, so it is kept for places between them: in quarters of a pixel
/// where it is small, in halves where it is large. What is drawn is nowhere farther off than 1/8
/// and 1/4 of a pixel each way.
namespace adore::agore {

class Stamps {
 public:
  /// What a drawing looks like: equal ones are equal pictures.
  struct Look {
    int kind = 0;
    std::array<double, 2> sizes{};  ///< [pixels]
    std::array<QRgb, 3> colours{};
    auto operator<=>(const Look&) const = default;
  };
  /// Draws what `paint` draws about `middle`, where it reaches `reach` pixels each way at most.
  void draw(QPainter& painter, QPointF middle, double reach, const Look& look,
            const std::function<void(QPainter&, QPointF)>& paint);
  /// Images that are kept.
  [[nodiscard]] std::size_t size() const { return images_.size(); }

 private:
  struct Key {
    Look look;
    int right = 0, down = 0;  ///< between pixels, in parts of one
    double ratio = 0.0;
    auto operator<=>(const Key&) const = default;
  };
  std::map<Key, QImage> images_;
  double pixels_ = 0.0;  ///< of all images
};

}  // namespace adore::agore
