#pragma once

#include <QColor>
#include <QImage>
#include <QPainter>

#include <array>
#include <compare>
#include <cstdint>
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
///
/// All views of a window keep theirs together, within one room. Where that is full, those go that
/// were not drawn for the longest time.
namespace adore::agore {

class Stamps {
 public:
  static constexpr double kRoom = 160e6;  ///< [bytes]
  /// @param room for all images [bytes]
  explicit Stamps(double room = kRoom) : room_(room) {}
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
  [[nodiscard]] double bytes() const { return bytes_; }

 private:
  struct Key {
    Look look;
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
  std::uint64_t drawings_ = 0;
};

}  // namespace adore::agore
