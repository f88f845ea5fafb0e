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

ArrowShape::ArrowShape(std::span<const int> block_of, int size, bool ring) {
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
  for (const auto& rows : rows_)
    largest_block_size_ = std::max(largest_block_size_, static_cast<int>(rows.size()));
  set_up_ring(ring);
}

void ArrowShape::set_up_ring(bool ring) {
  const int n = blocks();
  cut_ = ring && n > 1;
  if (cut_) corner_ = rows_.back();
  corner_.insert(corner_.end(), border_.begin(), border_.end());
  corner_rank_.assign(place_.size(), -1);
  for (std::size_t k = 0; k < corner_.size(); ++k)
    corner_rank_[static_cast<std::size_t>(corner_[k])] = static_cast<int>(k);
  // Around the ring in groups of four, then of three: members of a set stand three apart or more.
  const int fours = n % 3;
  const bool groups = n != 5 && n > 2;
  for (int b = 0; b < n; ++b) {
    dependent_blocks_.push_back({b});
    std::size_t set = 0;
    if (cut_) {
      for (const int other : {(b + n - 1) % n, (b + 1) % n})
        if (other != b && other != dependent_blocks_.back().back())
          dependent_blocks_.back().push_back(other);
      set = static_cast<std::size_t>(!groups ? b : b < 4 * fours ? b % 4 : (b - 4 * fours) % 3);
    }
    if (set >= independent_block_sets_.size()) independent_block_sets_.resize(set + 1);
    independent_block_sets_[set].push_back(b);
  }
}

ArrowMatrix::ArrowMatrix(std::shared_ptr<const ArrowShape> shape) : shape_(std::move(shape)) {
  const std::size_t m = shape_->corner_rows().size();
  std::size_t end = 0;
  for (int b = 0; b < shape_->chain(); ++b) {
    const std::size_t n = shape_->rows(b).size();
    const std::size_t next = shape_->linked(b) ? n * shape_->rows(b + 1).size() : 0;
    parts_.push_back({end, end + n * n, end + n * n + n * m, end + n * n + 2 * n * m,
                      end + n * n + 2 * n * m + next});
    end += n * n + 2 * n * m + 2 * next;
    pivots_.emplace_back(n);
  }
  D_ = end;
  values_.assign(end + m * m, 0.0);
  pivots_.emplace_back(m);
  block_x_.resize(static_cast<std::size_t>(shape_->largest_block_size()));
  last_x_.resize(block_x_.size());
  corner_x_.resize(m);
}

void ArrowMatrix::set_zero() noexcept { std::fill(values_.begin(), values_.end(), 0.0); }

void ArrowMatrix::scale_and_add_identity(double factor) noexcept {
  for (double& v : values_) v *= factor;
  for (int b = 0; b < shape_->chain(); ++b) {
    const std::size_t n = shape_->rows(b).size();
    for (std::size_t i = 0; i < n; ++i) values_[parts_[b].A + i * (n + 1)] += 1.0;
  }
  const std::size_t m = shape_->corner_rows().size();
  for (std::size_t i = 0; i < m; ++i) values_[D_ + i * (m + 1)] += 1.0;
}

double& ArrowMatrix::at(int row, int column) {
  const auto [row_block, i] = shape_->place(row);
  const auto [column_block, j] = shape_->place(column);
  if (row_block != kBorder && column_block != kBorder) {
    const auto met = shape_->dependent_blocks(column_block);
    if (std::find(met.begin(), met.end(), row_block) == met.end()) {
      throw std::out_of_range("an arrow matrix has no element between block " +
                              std::to_string(row_block) + " and block " +
                              std::to_string(column_block));
    }
  }
  const int m = static_cast<int>(shape_->corner_rows().size());
  const int corner_i = shape_->corner_rank(row), corner_j = shape_->corner_rank(column);
  if (corner_i >= 0 && corner_j >= 0) return values_[D_ + corner_i * m + corner_j];
  const int row_size = row_block == kBorder ? 0 : static_cast<int>(shape_->rows(row_block).size());
  if (corner_j >= 0) return values_[parts_[row_block].B + i * m + corner_j];
  const int n = static_cast<int>(shape_->rows(column_block).size());
  if (corner_i >= 0) return values_[parts_[column_block].C + corner_i * n + j];
  if (row_block == column_block) return values_[parts_[row_block].A + i * row_size + j];
  if (column_block == row_block + 1) return values_[parts_[row_block].next + i * n + j];
  return values_[parts_[column_block].back + i * n + j];
}

// B_b becomes W_b = A_b⁻¹ B_b, the link to the next block likewise, D the decomposition of
// S = D - Σ C_b W_b.
bool ArrowMatrix::factor() noexcept {
  const int m = static_cast<int>(shape_->corner_rows().size());
  const auto part = [this](std::size_t first) { return values_.data() + first; };
  for (int b = 0; b < shape_->chain(); ++b) {
    const int n = static_cast<int>(shape_->rows(b).size());
    const Parts& own = parts_[b];
    if (!lu_factor(part(own.A), n, pivots_[b].data())) return false;
    if (m > 0) {
      lu_solve(part(own.A), n, pivots_[b].data(), part(own.B), m);
      subtract_product(part(D_), part(own.C), part(own.B), m, n, m);
    }
    if (!shape_->linked(b)) continue;
    const int n1 = static_cast<int>(shape_->rows(b + 1).size());
    const Parts& next = parts_[b + 1];
    lu_solve(part(own.A), n, pivots_[b].data(), part(own.next), n1);
    subtract_product(part(next.A), part(own.back), part(own.next), n1, n, n1);
    subtract_product(part(next.B), part(own.back), part(own.B), n1, n, m);
    subtract_product(part(next.C), part(own.C), part(own.next), m, n, n1);
  }
  return lu_factor(part(D_), m, pivots_.back().data());
}

void ArrowMatrix::solve(double* x) noexcept {
  const auto corner_rows = shape_->corner_rows();
  const int m = static_cast<int>(corner_rows.size());
  for (int i = 0; i < m; ++i) corner_x_[i] = x[corner_rows[i]];
  for (int b = 0; b < shape_->chain(); ++b) {
    const auto rows = shape_->rows(b);
    const int n = static_cast<int>(rows.size());
    for (int i = 0; i < n; ++i) block_x_[i] = x[rows[i]];
    if (b > 0 && shape_->linked(b - 1))
      subtract_product(block_x_.data(), values_.data() + parts_[b - 1].back, last_x_.data(), n,
                       static_cast<int>(shape_->rows(b - 1).size()), 1);
    lu_solve(values_.data() + parts_[b].A, n, pivots_[b].data(), block_x_.data(), 1);
    for (int i = 0; i < n; ++i) x[rows[i]] = block_x_[i];
    if (m > 0)
      subtract_product(corner_x_.data(), values_.data() + parts_[b].C, block_x_.data(), m, n, 1);
    std::swap(block_x_, last_x_);
  }
  lu_solve(values_.data() + D_, m, pivots_.back().data(), corner_x_.data(), 1);
  for (int i = 0; i < m; ++i) x[corner_rows[i]] = corner_x_[i];
  for (int b = shape_->chain() - 1; b >= 0; --b) {
    const double* W = values_.data() + parts_[b].B;
    for (const int row : shape_->rows(b)) {
      for (int j = 0; j < m; ++j) x[row] -= W[j] * corner_x_[j];
      W += m;
    }
    if (!shape_->linked(b)) continue;
    const double* U = values_.data() + parts_[b].next;
    const auto next = shape_->rows(b + 1);
    for (const int row : shape_->rows(b)) {
      for (std::size_t j = 0; j < next.size(); ++j) x[row] -= U[j] * x[next[j]];
      U += next.size();
    }
  }
}

}  // namespace adore::integrators
