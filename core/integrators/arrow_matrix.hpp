#pragma once

#include <memory>
#include <span>
#include <vector>

namespace adore::integrators {

/// Block number of a component that belongs to no block.
inline constexpr int kBorder = -1;

/// Which rows of an arrow matrix form a block and which the border, in plain numbers:
///
///   [ A_0            B_0 ]    A_b: a block by itself
///   [      A_1       B_1 ]    B_b: the border acts on the block
///   [           ...  ... ]    C_b: the block acts on the border
///   [ C_0  C_1  ...   D  ]    D:   the border by itself
///
/// Rows of a block may lie anywhere and blocks may differ in size. Without blocks everything is
/// border: a dense matrix.
class ArrowShape {
 public:
  struct Place {
    int block = kBorder;
    int rank = 0;  ///< position within the block or the border
  };
  /// @param block_of block number 0, 1, ... or kBorder of each row; empty: `size` rows of border.
  /// @throws std::invalid_argument when the length is not `size`, or a number is below kBorder or
  /// not below `size`.
  ArrowShape(std::span<const int> block_of, int size);

  [[nodiscard]] int size() const noexcept { return static_cast<int>(place_.size()); }
  [[nodiscard]] int blocks() const noexcept { return static_cast<int>(rows_.size()); }
  [[nodiscard]] int border() const noexcept { return static_cast<int>(border_.size()); }
  [[nodiscard]] int largest_block() const noexcept { return largest_; }
  [[nodiscard]] Place place(int row) const noexcept {
    return place_[static_cast<std::size_t>(row)];
  }
  [[nodiscard]] std::span<const int> rows(int block) const noexcept {
    return rows_[static_cast<std::size_t>(block)];
  }
  [[nodiscard]] std::span<const int> border_rows() const noexcept { return border_; }

 private:
  std::vector<Place> place_;
  std::vector<std::vector<int>> rows_;
  std::vector<int> border_;
  int largest_ = 0;
};

/// Arrow matrix with its LU decomposition; O(blocks) in memory and time, every part dense, row
/// pivoting within each A_b and within the border's Schur complement. That is stable while each
/// A_b is well away from singular, as in I - γJ of an implicit step.
class ArrowMatrix {
 public:
  explicit ArrowMatrix(std::shared_ptr<const ArrowShape> shape);

  [[nodiscard]] const ArrowShape& shape() const noexcept { return *shape_; }
  [[nodiscard]] const std::shared_ptr<const ArrowShape>& shared_shape() const noexcept {
    return shape_;
  }
  void set_zero() noexcept;
  /// M := factor M + I
  void scale_and_add_identity(double factor) noexcept;
  /// @throws std::out_of_range for an element of two different blocks, which does not exist.
  [[nodiscard]] double& at(int row, int column);
  /// Takes the values of a matrix of the same shape, not its decomposition.
  void copy_values(const ArrowMatrix& other) noexcept { values_ = other.values_; }

  /// Replaces the values by the decomposition; false when a part is singular.
  [[nodiscard]] bool factor() noexcept;
  /// x := M⁻¹ x, size() values in the order of the rows, after factor().
  void solve(double* x) noexcept;

 private:
  struct Parts {
    std::size_t A, B, C;
  };
  std::shared_ptr<const ArrowShape> shape_;
  std::vector<Parts> parts_;  ///< where the parts of each block begin in values_, stored by rows
  std::size_t D_ = 0;
  std::vector<double> values_;
  std::vector<std::vector<int>> pivots_;  ///< of each block, then of the border
  std::vector<double> block_x_, border_x_;
};

}  // namespace adore::integrators
