#pragma once

#include <cstddef>
#include <optional>
#include <vector>

/// A path of very many points, searchable by position.
namespace adore::desktop {

/// Points `first` to before `end`.
struct PointRange {
  std::size_t first = 0, end = 0;
};

/// A way in runs of a few neighboring points and the boxes that hold them: what is far from a
/// place or from a part of a picture is passed over without a look at its points.
class PathIndex {
 public:
  /// Extent of a run, with the stroke to the next one. For an empty run left is right of right.
  struct Box {
    double left, right, low, high;
  };

  PathIndex() = default;
  /// Keeps a reference to the points.
  PathIndex(const std::vector<double>& x, const std::vector<double>& y);

  [[nodiscard]] const std::vector<double>& x() const { return *x_; }
  [[nodiscard]] const std::vector<double>& y() const { return *y_; }
  [[nodiscard]] const std::vector<Box>& boxes() const { return boxes_; }
  /// Points of the run `index` and the first one of the next.
  [[nodiscard]] PointRange stretch(std::size_t index) const;
  /// The last of the points nearest to a position, with a squared distance of at most `most`, which
  /// becomes that square.
  [[nodiscard]] std::optional<std::size_t> nearest(double x, double y, double& most) const;

 private:
  const std::vector<double>* x_ = nullptr;
  const std::vector<double>* y_ = nullptr;
  std::size_t count_ = 0;
  std::vector<Box> boxes_;
};

}  // namespace adore::desktop
