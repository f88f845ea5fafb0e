#pragma once

#include "dynamics/evaluation.hpp"

#include <cstddef>

/// The forces of an evaluation once more, ahead of the equations of motion: for effects whose rates
/// follow from forces (held_rollers.hpp).
namespace adore::dynamics {

struct Assembly;

class ForcePass {
 public:
  enum class Which : unsigned char {
    OnRaces,  ///< blocks that couple elements with a race
    Others    ///< the rest of Phase::Force
  };
  explicit ForcePass(const Assembly& parts) : parts_(&parts) {}
  /// Adds what these blocks do; the caller clears it (Evaluation::clear_actions). No allocation.
  void apply(Evaluation& e, Which which) const noexcept;
  /// Adds the stiffness on (x, r, θ) of what effects say of element i (SceneEffect::resist) [N/m].
  void resist(const Evaluation& e, std::size_t i, Mat3& stiffness) const noexcept;

 private:
  const Assembly* parts_;
};

}  // namespace adore::dynamics
