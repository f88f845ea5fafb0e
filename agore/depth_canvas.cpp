#include "agore/depth_canvas.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace adore::agore {
namespace {

QRgb mixed(const QColor& a, const QColor& b, double part) {
  const auto channel = [part](int from, int to) {
    return std::clamp(static_cast<int>(std::lround(from + part * (to - from))), 0, 255);
  };
  return qRgb(channel(a.red(), b.red()), channel(a.green(), b.green()),
              channel(a.blue(), b.blue()));
}

/// Bodies of a damaged file that are far outside the picture are not drawn.
bool drawable(const DepthCanvas::Point& p) {
  constexpr float kFar = 1e7F;
  return std::abs(p.x) < kFar && std::abs(p.y) < kFar && std::abs(p.depth) < kFar;
}

}  // namespace

Shades shades_of(const QColor& colour) {
  constexpr int kItself = 190;
  const QColor shadow = colour.darker(330), shine = colour.lighter(150);
  Shades out{};
  for (int i = 0; i < 256; ++i)
    out[static_cast<std::size_t>(i)] =
        i < kItself ? mixed(shadow, colour, static_cast<double>(i) / kItself)
                    : mixed(colour, shine, static_cast<double>(i - kItself) / (255 - kItself));
  return out;
}

float light_of(float x, float y, float z) {
  // Directions of the lamp and of the bisector between lamp and viewer, unit vectors.
  const float lamp = -0.37F * x + 0.53F * y + 0.763F * z;
  const float half = -0.197F * x + 0.282F * y + 0.939F * z;
  float shine = std::max(0.0F, half);
  for (int i = 0; i < 5; ++i) shine *= shine;  // to the 32nd power
  return std::clamp(62.0F + 138.0F * std::max(0.0F, lamp) + 62.0F * shine, 0.0F, 255.0F);
}

void DepthCanvas::reset(QSize size, QRgb paper) {
  width_ = size.width(), height_ = size.height();
  const auto pixels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  colour_.assign(pixels, paper);
  depth_.assign(pixels, -std::numeric_limits<float>::infinity());
  drawn_ = drawn_since_restore_ = QRect();
}

void DepthCanvas::restore(const DepthCanvas& other) {
  if (size() != other.size()) {
    *this = other;
    drawn_since_restore_ = QRect();
    return;
  }
  for (int row = drawn_since_restore_.top(); row <= drawn_since_restore_.bottom(); ++row) {
    const auto from = static_cast<std::ptrdiff_t>(row) * width_ + drawn_since_restore_.left();
    const auto to = from + drawn_since_restore_.width();
    std::copy(other.colour_.begin() + from, other.colour_.begin() + to, colour_.begin() + from);
    std::copy(other.depth_.begin() + from, other.depth_.begin() + to, depth_.begin() + from);
  }
  drawn_ = other.drawn_;
  drawn_since_restore_ = QRect();
}

void DepthCanvas::touch(int left, int top, int right, int bottom) {
  const QRect box = QRect(QPoint(left, top), QPoint(right, bottom)) & QRect(0, 0, width_, height_);
  drawn_ |= box;
  drawn_since_restore_ |= box;
}

void DepthCanvas::triangle(const Point& a, const Point& b, const Point& c, const Shades& shades) {
  const float area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  if (!(std::abs(area) > 1e-6F) || !drawable(a) || !drawable(b) || !drawable(c)) return;
  const float lowest = std::min({a.y, b.y, c.y}), highest = std::max({a.y, b.y, c.y});
  const int top = std::max(0, static_cast<int>(std::ceil(lowest - 0.5F)));
  const int bottom = std::min(height_ - 1, static_cast<int>(std::floor(highest - 0.5F)));
  if (top > bottom) return;
  const float leftmost = std::min({a.x, b.x, c.x}), rightmost = std::max({a.x, b.x, c.x});
  const int first_column = std::max(0, static_cast<int>(std::ceil(leftmost - 0.5F)));
  const int last_column = std::min(width_ - 1, static_cast<int>(std::ceil(rightmost - 0.5F)) - 1);
  if (first_column > last_column) return;
  touch(first_column, top, last_column, bottom);
  // depth and light are linear over the picture
  const float part = 1.0F / area;
  const auto slopes = [&](float va, float vb, float vc) {
    return std::array<float, 2>{((vb - va) * (c.y - a.y) - (vc - va) * (b.y - a.y)) * part,
                                ((vc - va) * (b.x - a.x) - (vb - va) * (c.x - a.x)) * part};
  };
  const auto deep = slopes(a.depth, b.depth, c.depth), lit = slopes(a.light, b.light, c.light);
  struct Edge {
    float low, high, x, y, slope;
    Edge(const Point& p, const Point& q)
        : low(std::min(p.y, q.y)),
          high(std::max(p.y, q.y)),
          x(p.x),
          y(p.y),
          slope((q.x - p.x) / (q.y - p.y)) {}
  };
  const std::array<Edge, 3> edges{Edge(a, b), Edge(b, c), Edge(c, a)};
  for (int row = top; row <= bottom; ++row) {
    const float y = static_cast<float>(row) + 0.5F;
    float left = std::numeric_limits<float>::infinity(), right = -left;
    for (const Edge& edge : edges) {
      if (y < edge.low || y >= edge.high) continue;
      const float x = edge.x + (y - edge.y) * edge.slope;
      left = std::min(left, x), right = std::max(right, x);
    }
    if (!(left <= right)) continue;
    const int first = std::max(0, static_cast<int>(std::ceil(left - 0.5F)));
    const int last = std::min(width_ - 1, static_cast<int>(std::ceil(right - 0.5F)) - 1);
    const float x = static_cast<float>(first) + 0.5F;
    float depth = a.depth + (x - a.x) * deep[0] + (y - a.y) * deep[1];
    float light = a.light + (x - a.x) * lit[0] + (y - a.y) * lit[1];
    const std::size_t line = static_cast<std::size_t>(row) * static_cast<std::size_t>(width_);
    float* const depths = depth_.data() + line;
    QRgb* const colours = colour_.data() + line;
    for (int i = first; i <= last; ++i, depth += deep[0], light += lit[0]) {
      if (depth <= depths[i]) continue;
      depths[i] = depth;
      colours[i] = shades[static_cast<std::size_t>(std::clamp(light, 0.0F, 255.0F))];
    }
  }
}

void DepthCanvas::sphere(const Point& centre, float radius, const Pole& pole, const Shades& shades,
                         const Shades& mark) {
  constexpr float kSpot = 0.93F, kLine = 0.055F;  // cosines from the pole
  if (!drawable(centre) || !(radius > 0.0F && radius < 1e6F)) return;
  const bool marked = pole.x != 0 || pole.y != 0 || pole.z != 0;
  const int top = std::max(0, static_cast<int>(std::floor(centre.y - radius)));
  const int bottom = std::min(height_ - 1, static_cast<int>(std::ceil(centre.y + radius)));
  touch(static_cast<int>(std::floor(centre.x - radius)), top,
        static_cast<int>(std::ceil(centre.x + radius)), bottom);
  for (int row = top; row <= bottom; ++row) {
    const float v = (centre.y - static_cast<float>(row) - 0.5F) / radius;
    if (std::abs(v) >= 1.0F) continue;
    const float half = std::sqrt(1.0F - v * v) * radius;
    const int first = std::max(0, static_cast<int>(std::ceil(centre.x - half - 0.5F)));
    const int last = std::min(width_ - 1, static_cast<int>(std::floor(centre.x + half - 0.5F)));
    const std::size_t line = static_cast<std::size_t>(row) * static_cast<std::size_t>(width_);
    for (int i = first; i <= last; ++i) {
      const float u = (static_cast<float>(i) + 0.5F - centre.x) / radius;
      const float w = std::sqrt(std::max(0.0F, 1.0F - u * u - v * v));
      const std::size_t at = line + static_cast<std::size_t>(i);
      const float depth = centre.depth + w * radius;
      if (depth <= depth_[at]) continue;
      depth_[at] = depth;
      const float to_pole = std::abs(u * pole.x + v * pole.y + w * pole.z);
      const bool on_mark = marked && (to_pole > kSpot || to_pole < kLine);
      colour_[at] = (on_mark ? mark : shades)[static_cast<std::size_t>(light_of(u, v, w))];
    }
  }
}

float DepthCanvas::depth_at(QPointF pixel) const {
  if (!(pixel.x() >= 0.0 && pixel.y() >= 0.0 && pixel.x() < width_ && pixel.y() < height_))
    return -std::numeric_limits<float>::infinity();
  return depth_[static_cast<std::size_t>(pixel.y()) * static_cast<std::size_t>(width_) +
                static_cast<std::size_t>(pixel.x())];
}

QImage DepthCanvas::image(int shrink, const QRect& box) const {
  const auto start = [&](int row) {
    return colour_.data() + static_cast<std::ptrdiff_t>(box.top() + row) * shrink * width_ +
           static_cast<std::ptrdiff_t>(box.left()) * shrink;
  };
  if (shrink == 1)
    return {reinterpret_cast<const uchar*>(start(0)), box.width(), box.height(),
            static_cast<qsizetype>(width_) * 4, QImage::Format_RGB32};
  QImage out(box.size(), QImage::Format_RGB32);
  for (int row = 0; row < box.height(); ++row) {
    auto* line = reinterpret_cast<QRgb*>(out.scanLine(row));
    const QRgb* from = start(row);
    for (int i = 0; i < box.width(); ++i) {
      unsigned red = 0, green = 0, blue = 0;
      for (int y = 0; y < shrink; ++y)
        for (int x = 0; x < shrink; ++x) {
          const QRgb pixel = from[y * width_ + i * shrink + x];
          red += (pixel >> 16U) & 255U, green += (pixel >> 8U) & 255U, blue += pixel & 255U;
        }
      const auto n = static_cast<unsigned>(shrink * shrink);
      line[i] = 0xff000000U | (red / n) << 16U | (green / n) << 8U | (blue / n);
    }
  }
  return out;
}

}  // namespace adore::agore
