#pragma once

#include "dynamics/evaluation.hpp"

#include <cstddef>

/// The forces of an evaluation once more, ahead of the equations of motion: for effects whose rates
/// follow from forces (held_elements.hpp).
namespace adore::dynamics {

struct Assembly;

class ForcePass {
 public:
  enum class Which : unsigned char {
    OnRaces,  ///< blocks that couple elements with a race
    Others    ///< the rest of Phase::Force
  };
  /// @param elements_alone leaves out what acts on cage and races alone
  ForcePass(const Assembly& parts, bool elements_alone)
      : parts_(&parts), elements_alone_(elements_alone) {}
  /// Adds what these blocks do; the caller clears it (Evaluation::clear_actions). No allocation.
  void apply(Evaluation& e, Which which) const noexcept;
  /// Of every NonRaceContacts; damp() after the forces.
  void resist(const Evaluation& e, std::size_t i, Mat3& stiffness) const noexcept;
  void damp(const Evaluation& e, std::size_t i, Eigen::Matrix2d& damping) const noexcept;

 private:
  const Assembly* parts_;
  bool elements_alone_;
};

}  // namespace adore::dynamics
