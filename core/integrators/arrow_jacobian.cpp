#include "integrators/arrow_jacobian.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace adore::integrators {

ArrowJacobian::ArrowJacobian(OdeSystem& system, RhsPart part)
    : system_(&system),
      part_(part),
      shape_(std::make_shared<ArrowShape>(system.blocks(), system.controlled_size(),
                                          system.blocks_form_ring())),
      f_(static_cast<std::size_t>(system.size())) {
  const auto shares = static_cast<std::size_t>(shape_->blocks()) * shape_->border();
  shares_.resize(shares);
  unperturbed_shares_.resize(shares);
  const auto together = static_cast<std::size_t>(std::max(1, shape_->blocks()));
  kept_.resize(together);
  moved_.resize(together);
  columns_.reserve(together);
}

Outcome ArrowJacobian::evaluate(double t, const double* y, bool with_shares) {
  ++evaluations_;
  EvalStatus status = EvalStatus::Ok;
  if (with_shares) {
    status = system_->rhs_with_contributions(part_, t, y, f_.data(), shares_.data());
  } else {
    status = part_ == RhsPart::Whole ? system_->rhs(t, y, f_.data())
                                     : system_->rhs_stiff(t, y, f_.data());
  }
  if (status == EvalStatus::Fail) return Outcome::Fail;
  if (status == EvalStatus::Retry) return Outcome::Retry;
  const bool finite =
      all_finite(f_.data(), shape_->size()) &&
      (!with_shares || all_finite(shares_.data(), static_cast<int>(shares_.size())));
  return finite ? Outcome::Ok : Outcome::Retry;
}

Outcome ArrowJacobian::displaced(double t, double* y, std::span<const int> columns,
                                 bool with_shares) {
  const double root = std::sqrt(std::numeric_limits<double>::epsilon());
  Outcome outcome = Outcome::Ok;
  for (std::size_t k = 0; k < columns.size(); ++k) kept_[k] = y[columns[k]];
  for (const double side : {root, -root}) {
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const double scale = std::abs(system_->scales()[static_cast<std::size_t>(columns[k])]);
      y[columns[k]] = kept_[k] + side * std::max(std::abs(kept_[k]), scale);
      moved_[k] = y[columns[k]] - kept_[k];
    }
    outcome = evaluate(t, y, with_shares);
    if (outcome != Outcome::Retry) break;
  }
  for (std::size_t k = 0; k < columns.size(); ++k) y[columns[k]] = kept_[k];
  return outcome;
}

Outcome ArrowJacobian::operator()(double t, double* y, const double* f0, ArrowMatrix& J) {
  J.set_zero();
  const auto border = shape_->border_rows();
  const std::size_t m = border.size();
  const bool shared = !shares_.empty();
  if (shared) {
    if (const Outcome at_point = evaluate(t, y, true); at_point != Outcome::Ok) return at_point;
    unperturbed_shares_ = shares_;
  }
  for (int rank = 0; rank < shape_->largest_block_size(); ++rank)
    for (const std::vector<int>& together : shape_->independent_block_sets()) {
      columns_.clear();
      for (const int b : together) {
        if (const auto rows = shape_->rows(b); rank < static_cast<int>(rows.size())) {
          columns_.push_back(rows[static_cast<std::size_t>(rank)]);
        }
      }
      if (columns_.empty()) continue;
      if (const Outcome o = displaced(t, y, columns_, shared); o != Outcome::Ok) return o;
      for (std::size_t k = 0; k < columns_.size(); ++k) {
        const int column = columns_[k];
        const int block = shape_->place(column).block;
        for (const int met : shape_->dependent_blocks(block))
          for (const int row : shape_->rows(met))
            J.at(row, column) = (f_[row] - f0[row]) / moved_[k];
        const std::size_t first = static_cast<std::size_t>(block) * m;
        for (std::size_t i = 0; shared && i < m; ++i) {
          J.at(border[i], column) =
              (shares_[first + i] - unperturbed_shares_[first + i]) / moved_[k];
        }
      }
    }
  for (const int column : border) {
    if (const Outcome o = displaced(t, y, {&column, 1}, false); o != Outcome::Ok) return o;
    for (int row = 0; row < shape_->size(); ++row) {
      J.at(row, column) = (f_[row] - f0[row]) / moved_[0];
    }
  }
  return Outcome::Ok;
}

}  // namespace adore::integrators
