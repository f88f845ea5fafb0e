#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

/// State by name: which component of y is what.
namespace adore::dynamics {

struct Slice {
  int first = 0, count = 0;
};

/// Kind of error scale of state components (N7, N11).
enum class ScaleKind : unsigned char { Length, Velocity, Angle, Rate };

/// Grown while a System is built, then constant. Controlled components come first, quadratures
/// last.
class StateLayout {
 public:
  /// Adds `count` components called "<name>[k] [unit]", k = 1..count (count 1: "<name> [unit]"),
  /// with one error scale.
  Slice add(std::string name, std::string_view unit, int count, double scale);
  /// From here on components are quadratures (no error control).
  void begin_quadratures();
  [[nodiscard]] int size() const noexcept { return size_; }
  [[nodiscard]] int controlled_size() const noexcept {
    return controlled_count_ < 0 ? size_ : controlled_count_;
  }
  [[nodiscard]] std::string component_name(int index) const;
  [[nodiscard]] std::span<const double> scales() const noexcept { return scales_; }
  void set_scale(const Slice& slice, double scale);
  struct Group {
    std::string name, unit;
    Slice slice;
  };
  [[nodiscard]] const std::vector<Group>& groups() const noexcept { return groups_; }

 private:
  int size_ = 0, controlled_count_ = -1;
  std::vector<Group> groups_;
  std::vector<double> scales_;
};

}  // namespace adore::dynamics
