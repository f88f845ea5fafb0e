#pragma once

#include "bearing/bearing.hpp"

#include <cstddef>
#include <vector>

/// Mass and inertia of rolling elements: identical, given (record 6.1), or of balls of unequal
/// diameter (bearing/element_inertia.hpp).
///
/// The nine quantities of an element are those of its reference point: the center of a ball, of a
/// roller the point of its axis at the mass center, from which contacts count
/// (Bearing::roller_mass_offset). Its mass center is `arm` from there in body axes: zero but for
/// unbalanced elements, and of rollers zero along the axis unless element 1 has its own inertia.
namespace adore::dynamics {

using Vec3 = bearing::Vec3;
using Mat3 = Eigen::Matrix3d;

struct ElementMass {
  double mass = 0.0;                ///< [kg]
  Mat3 inertia = Mat3::Zero();      ///< about the mass center, body axes [kg m²]
  Mat3 inverse = Mat3::Zero();      ///< of it
  Vec3 arm = Vec3::Zero();          ///< [m]
  bool has_eccentric_mass = false;  ///< the arm is not 0
};

class ElementMasses {
 public:
  ElementMasses() = default;
  explicit ElementMasses(const bearing::Bearing& bearing);
  [[nodiscard]] const ElementMass& operator[](std::size_t element) const noexcept {
    return distinct_masses_[element < distinct_masses_.size() ? element
                                                              : distinct_masses_.size() - 1];
  }
  /// All have the same mass and inertia.
  [[nodiscard]] bool all_equal() const noexcept { return distinct_masses_.size() == 1; }
  /// Some mass center is not at the reference point.
  [[nodiscard]] bool has_eccentric_mass() const noexcept;

 private:
  std::vector<ElementMass>
      distinct_masses_;  ///< one for all, of element 1 and of the others, or each its own
};

}  // namespace adore::dynamics
