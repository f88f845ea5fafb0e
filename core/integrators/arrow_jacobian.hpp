#pragma once

#include "integrators/arrow_matrix.hpp"
#include "integrators/step_tools.hpp"

namespace adore::integrators {

/// Jacobian of the controlled components by forward differences in the arrow of
/// OdeSystem::blocks(). Components of different blocks do not meet, so the k-th components of all
/// blocks are displaced together: largest block + border evaluations, and one more for the shares
/// at the point itself where there are blocks and a border, however many blocks there are. In a
/// ring those of every third or fourth block are: three or four times the largest block. What a
/// block does to the border would be mixed in this; it comes from the shares of
/// OdeSystem::rhs_with_contributions.
class ArrowJacobian {
 public:
  ArrowJacobian() = default;
  ArrowJacobian(OdeSystem& system, RhsPart part);

  [[nodiscard]] const std::shared_ptr<const ArrowShape>& shape() const noexcept { return shape_; }
  [[nodiscard]] RhsPart part() const noexcept { return part_; }
  /// Fills J at (t, y), where the part has the value f0. A point that the model rejects is replaced
  /// by the other side. Retry: the model rejects the neighbors on both sides. `y` is displaced
  /// during the call and restored.
  [[nodiscard]] Outcome operator()(double t, double* y, const double* f0, ArrowMatrix& J);
  /// Evaluations of the part so far.
  [[nodiscard]] long evaluations() const noexcept { return evaluations_; }

 private:
  [[nodiscard]] Outcome evaluate(double t, const double* y, bool with_shares);
  /// Displaces `columns`, evaluates, gives them back. The actual displacements are in moved_.
  [[nodiscard]] Outcome displaced(double t, double* y, std::span<const int> columns,
                                  bool with_shares);

  OdeSystem* system_ = nullptr;
  RhsPart part_ = RhsPart::Whole;
  std::shared_ptr<const ArrowShape> shape_;
  std::vector<double> f_, shares_, unperturbed_shares_;
  std::vector<double> kept_, moved_;
  std::vector<int> columns_;
  long evaluations_ = 0;
};

}  // namespace adore::integrators
