#include "integrators/arrow_matrix.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace adore::integrators {
namespace {

// Decomposes the n x n matrix a, stored by rows, with row pivoting.
bool lu_factor(double* a, int n, int* pivots) noexcept {
  for (int k = 0; k < n; ++k) {
    int best = k;
    for (int i = k + 1; i < n; ++i) {
      if (std::abs(a[i * n + k]) > std::abs(a[best * n + k])) best = i;
    }
    pivots[k] = best;
    if (best != k) std::swap_ranges(a + k * n, a + (k + 1) * n, a + best * n);
    const double* pivot_row = a + k * n;
    if (!(std::abs(pivot_row[k]) > 0.0) || !std::isfinite(pivot_row[k])) return false;
    const double inverse = 1.0 / pivot_row[k];
    for (int i = k + 1; i < n; ++i) {
      double* row = a + i * n;
      if (row[k] == 0.0) continue;
      const double factor = row[k] *= inverse;
      for (int j = k + 1; j < n; ++j) row[j] -= factor * pivot_row[j];
    }
  }
  return true;
}

// x := a⁻¹ x for `columns` right-hand sides stored by rows.
void lu_solve(const double* a, int n, const int* pivots, double* x, int columns) noexcept {
  for (int k = 0; k < n; ++k) {
    if (pivots[k] != k) {
      std::swap_ranges(x + k * columns, x + (k + 1) * columns, x + pivots[k] * columns);
    }
  }
  const auto subtract = [&](int to, int from, double factor) {
    for (int j = 0; j < columns; ++j) x[to * columns + j] -= factor * x[from * columns + j];
  };
  for (int i = 1; i < n; ++i) {
    for (int k = 0; k < i; ++k) subtract(i, k, a[i * n + k]);
  }
  for (int i = n - 1; i >= 0; --i) {
    for (int k = i + 1; k < n; ++k) subtract(i, k, a[i * n + k]);
    const double inverse = 1.0 / a[i * n + i];
    for (int j = 0; j < columns; ++j) x[i * columns + j] *= inverse;
  }
}

// out := out - a x for an m x n matrix by rows and `columns` right-hand sides by rows.
void subtract_product(double* out, const double* a, const double* x, int m, int n,
                      int columns) noexcept {
  for (int i = 0; i < m; ++i) {
    for (int k = 0; k < n; ++k) {
      const double factor = a[i * n + k];
      if (factor == 0.0) continue;
      for (int j = 0; j < columns; ++j) out[i * columns + j] -= factor * x[k * columns + j];
    }
  }
}

}  // namespace

ArrowShape::ArrowShape(std::span<const int> block_of, int size) {
  if (!block_of.empty() && static_cast<int>(block_of.size()) != size) {
    throw std::invalid_argument("an arrow matrix of " + std::to_string(size) + " rows got " +
                                std::to_string(block_of.size()) + " block numbers");
  }
  for (int row = 0; row < size; ++row) {
    const int block = block_of.empty() ? kBorder : block_of[static_cast<std::size_t>(row)];
    if (block < kBorder || block >= size) {
      throw std::invalid_argument(
          "row " + std::to_string(row) + " of an arrow matrix has the block number " +
          std::to_string(block) + "; valid are -1 for the border and 0 to " +
          std::to_string(size - 1));
    }
    if (block >= blocks()) rows_.resize(static_cast<std::size_t>(block) + 1);
    std::vector<int>& group = block == kBorder ? border_ : rows_[static_cast<std::size_t>(block)];
    place_.push_back({block, static_cast<int>(group.size())});
    group.push_back(row);
  }
  for (const auto& rows : rows_) largest_ = std::max(largest_, static_cast<int>(rows.size()));
}

ArrowMatrix::ArrowMatrix(std::shared_ptr<const ArrowShape> shape) : shape_(std::move(shape)) {
  const auto m = static_cast<std::size_t>(shape_->border());
  std::size_t end = 0;
  for (int b = 0; b < shape_->blocks(); ++b) {
    const std::size_t n = shape_->rows(b).size();
    parts_.push_back({end, end + n * n, end + n * n + n * m});
    end += n * n + 2 * n * m;
    pivots_.emplace_back(n);
  }
  D_ = end;
  values_.assign(end + m * m, 0.0);
  pivots_.emplace_back(m);
  block_x_.resize(static_cast<std::size_t>(shape_->largest_block()));
  border_x_.resize(m);
}

void ArrowMatrix::set_zero() noexcept { std::fill(values_.begin(), values_.end(), 0.0); }

void ArrowMatrix::scale_and_add_identity(double factor) noexcept {
  for (double& v : values_) v *= factor;
  for (int b = 0; b < shape_->blocks(); ++b) {
    const std::size_t n = shape_->rows(b).size();
    for (std::size_t i = 0; i < n; ++i) values_[parts_[b].A + i * (n + 1)] += 1.0;
  }
  const auto m = static_cast<std::size_t>(shape_->border());
  for (std::size_t i = 0; i < m; ++i) values_[D_ + i * (m + 1)] += 1.0;
}

double& ArrowMatrix::at(int row, int column) {
  const auto [row_block, i] = shape_->place(row);
  const auto [column_block, j] = shape_->place(column);
  const int m = shape_->border();
  if (row_block == kBorder && column_block == kBorder) return values_[D_ + i * m + j];
  const int block = row_block == kBorder ? column_block : row_block;
  const int n = static_cast<int>(shape_->rows(block).size());
  if (row_block == kBorder) return values_[parts_[block].C + i * n + j];
  if (column_block == kBorder) return values_[parts_[block].B + i * m + j];
  if (row_block != column_block) {
    throw std::out_of_range("an arrow matrix has no element between block " +
                            std::to_string(row_block) + " and block " +
                            std::to_string(column_block));
  }
  return values_[parts_[block].A + i * n + j];
}

// B_b becomes W_b = A_b⁻¹ B_b, D the decomposition of S = D - Σ C_b W_b.
bool ArrowMatrix::factor() noexcept {
  const int m = shape_->border();
  for (int b = 0; b < shape_->blocks(); ++b) {
    const int n = static_cast<int>(shape_->rows(b).size());
    double* A = values_.data() + parts_[b].A;
    double* B = values_.data() + parts_[b].B;
    if (!lu_factor(A, n, pivots_[b].data())) return false;
    if (m == 0) continue;
    lu_solve(A, n, pivots_[b].data(), B, m);
    subtract_product(values_.data() + D_, values_.data() + parts_[b].C, B, m, n, m);
  }
  return lu_factor(values_.data() + D_, m, pivots_.back().data());
}

void ArrowMatrix::solve(double* x) noexcept {
  const int m = shape_->border();
  const auto border_rows = shape_->border_rows();
  for (int i = 0; i < m; ++i) border_x_[i] = x[border_rows[i]];
  for (int b = 0; b < shape_->blocks(); ++b) {
    const auto rows = shape_->rows(b);
    const int n = static_cast<int>(rows.size());
    for (int i = 0; i < n; ++i) block_x_[i] = x[rows[i]];
    lu_solve(values_.data() + parts_[b].A, n, pivots_[b].data(), block_x_.data(), 1);
    for (int i = 0; i < n; ++i) x[rows[i]] = block_x_[i];
    if (m == 0) continue;
    subtract_product(border_x_.data(), values_.data() + parts_[b].C, block_x_.data(), m, n, 1);
  }
  if (m == 0) return;
  lu_solve(values_.data() + D_, m, pivots_.back().data(), border_x_.data(), 1);
  for (int i = 0; i < m; ++i) x[border_rows[i]] = border_x_[i];
  for (int b = 0; b < shape_->blocks(); ++b) {
    const double* W = values_.data() + parts_[b].B;
    for (const int row : shape_->rows(b)) {
      for (int j = 0; j < m; ++j) x[row] -= W[j] * border_x_[j];
      W += m;
    }
  }
}

}  // namespace adore::integrators
