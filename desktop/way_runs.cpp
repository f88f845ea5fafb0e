#include "desktop/way_runs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace adore::desktop {
namespace {

/// That many points of a revolution of 500 are narrow enough for the parts of a picture; their
/// boxes take a tenth of the memory of the points.
constexpr std::size_t kPoints = 16;

}  // namespace

PathIndex::PathIndex(const std::vector<double>& x, const std::vector<double>& y)
    : x_(&x), y_(&y), count_(std::min(x.size(), y.size())) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  boxes_.reserve((count_ + kPoints - 1) / kPoints);
  for (std::size_t first = 0; first < count_; first += kPoints) {
    Box box{kFar, -kFar, kFar, -kFar};
    for (std::size_t i = first; i < std::min(first + kPoints + 1, count_); ++i) {
      if (!std::isfinite(x[i]) || !std::isfinite(y[i])) continue;
      box.left = std::min(box.left, x[i]);
      box.right = std::max(box.right, x[i]);
      box.low = std::min(box.low, y[i]);
      box.high = std::max(box.high, y[i]);
    }
    boxes_.push_back(box);
  }
}

PointRange PathIndex::stretch(std::size_t index) const {
  return {index * kPoints, std::min((index + 1) * kPoints + 1, count_)};
}

std::optional<std::size_t> PathIndex::nearest(double x, double y, double& most) const {
  std::optional<std::size_t> out;
  for (std::size_t run = 0; run < boxes_.size(); ++run) {
    const Box& box = boxes_[run];
    const double across = std::max({0.0, box.left - x, x - box.right}),
                 along = std::max({0.0, box.low - y, y - box.high});
    if (!(across * across + along * along <= most)) continue;
    for (std::size_t i = run * kPoints; i < std::min((run + 1) * kPoints, count_); ++i) {
      const double dx = (*x_)[i] - x, dy = (*y_)[i] - y;
      const double away = dx * dx + dy * dy;
      if (!(away <= most)) continue;
      most = away;
      out = i;
    }
  }
  return out;
}

}  // namespace adore::desktop
