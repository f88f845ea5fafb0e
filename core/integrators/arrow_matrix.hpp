#pragma once

#include <memory>
#include <span>
#include <vector>

namespace adore::integrators {

/// Block number of a component that belongs to no block.
inline constexpr int kBorder = -1;

/// Rows of the blocks and of the border of an arrow matrix, as plain numbers:
///
///   [ A_0            B_0 ]    A_b: block
///   [      A_1       B_1 ]    B_b: the border acts on the block
///   [           ...  ... ]    C_b: the block acts on the border
///   [ C_0  C_1  ...   D  ]    D:   border
///
/// Rows of a block may be anywhere and blocks may differ in size. Without blocks everything is
/// border: a dense matrix. In a ring each block also meets the one before and after it, the last
/// one the first: cyclic block-tridiagonal with a border.
class ArrowShape {
 public:
  struct Place {
    int block = kBorder;
    int rank = 0;  ///< position within the block or the border
  };
  /// @param block_of block number 0, 1, ... or kBorder of each row; empty: `size` rows of border.
  /// @param ring neighboring blocks meet
  /// @throws std::invalid_argument when the length is not `size`, or a number is below kBorder or
  /// not below `size`.
  ArrowShape(std::span<const int> block_of, int size, bool ring = false);

  [[nodiscard]] int size() const noexcept { return static_cast<int>(place_.size()); }
  [[nodiscard]] int blocks() const noexcept { return static_cast<int>(rows_.size()); }
  [[nodiscard]] int border() const noexcept { return static_cast<int>(border_.size()); }
  [[nodiscard]] int largest_block_size() const noexcept { return largest_block_size_; }
  [[nodiscard]] Place place(int row) const noexcept {
    return place_[static_cast<std::size_t>(row)];
  }
  [[nodiscard]] std::span<const int> rows(int block) const noexcept {
    return rows_[static_cast<std::size_t>(block)];
  }
  [[nodiscard]] std::span<const int> border_rows() const noexcept { return border_; }

  /// Blocks whose rows depend on a component of `block`, itself first.
  [[nodiscard]] std::span<const int> dependent_blocks(int block) const noexcept {
    return dependent_blocks_[static_cast<std::size_t>(block)];
  }
  /// Sets of blocks such that no two of a set meet a common block: their components can be
  /// displaced together. One set without a ring; three, four (or, of five blocks, five) in a ring.
  [[nodiscard]] const std::vector<std::vector<int>>& independent_block_sets() const noexcept {
    return independent_block_sets_;
  }

  // How a solver takes it apart: a ring is cut open by counting its last block to the border.
  /// Blocks that are eliminated one after the other, each linked with the next one in a ring.
  [[nodiscard]] int chain() const noexcept { return cut_ ? blocks() - 1 : blocks(); }
  /// Does block b of the chain meet block b + 1 of it?
  [[nodiscard]] bool linked(int b) const noexcept { return cut_ && b + 1 < chain(); }
  /// The rows that are left: those of the block that was cut out, then the border.
  [[nodiscard]] std::span<const int> corner_rows() const noexcept { return corner_; }
  /// Position of a row among those; -1: it is in the chain.
  [[nodiscard]] int corner_rank(int row) const noexcept {
    return corner_rank_[static_cast<std::size_t>(row)];
  }

 private:
  void set_up_ring(bool ring);

  std::vector<Place> place_;
  std::vector<std::vector<int>> rows_;
  std::vector<int> border_;
  int largest_block_size_ = 0;
  bool cut_ = false;
  std::vector<int> corner_, corner_rank_;
  std::vector<std::vector<int>> dependent_blocks_, independent_block_sets_;
};

/// Arrow matrix with its LU decomposition; O(blocks) in memory and time, every part dense, row
/// pivoting within each A_b and within the border's Schur complement. That is stable while each
/// A_b (in a ring: what elimination of those before it leaves of it) is well away from singular, as
/// in I - γJ of an implicit step.
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
  /// @throws std::out_of_range for an element of two blocks that do not meet: there is none.
  [[nodiscard]] double& at(int row, int column);
  /// Takes the values of a matrix of the same shape, not its decomposition.
  void copy_values(const ArrowMatrix& other) noexcept { values_ = other.values_; }

  /// Replaces the values by the decomposition; false when a part is singular.
  [[nodiscard]] bool factor() noexcept;
  /// x := M⁻¹ x, size() values in the order of the rows, after factor().
  void solve(double* x) noexcept;

 private:
  /// For a block of the chain: A_b, to and from the remaining part, to and from the next block.
  struct Parts {
    std::size_t A, B, C, next, back;
  };
  std::shared_ptr<const ArrowShape> shape_;
  std::vector<Parts> parts_;  ///< start of the parts of each block in values_, stored by rows
  std::size_t D_ = 0;
  std::vector<double> values_;
  std::vector<std::vector<int>> pivots_;  ///< of each block, then of the border
  std::vector<double> block_x_, last_x_, corner_x_;
};

}  // namespace adore::integrators
