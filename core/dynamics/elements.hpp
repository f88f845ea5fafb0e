#pragma once

#include "dynamics/state_layout.hpp"

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

/// Rolling elements as structures of arrays: data of each element,
/// its place in the state and its loads, every list defined once.
/// Mass center in cylindrical coordinates (x, r, θ) about the bearing axis;
/// azimuth unit vectors e_r = (0,-sin θ,cos θ), e_θ = (0,-cos θ, -sin θ); ω
/// absolute on e_x, e_r, e_θ.
namespace adore::dynamics {

/// Views of n elements; each pointer addresses n values.
struct ElementViews {
  std::size_t n = 0;
  const double *x, *r, *sin_theta, *cos_theta;  ///< center [m], azimuth
  const double *x_dot, *r_dot, *theta_dot;      ///< [m/s, m/s, rad/s]
  const double *omega_x, *omega_r,
      *omega_theta;               ///< absolute angular velocity on e_x, e_r, e_θ [rad/s]
  const double* theta = nullptr;  ///< [rad]; may be missing where only its sine
                                  ///< and cosine are read
};

/// Every array of ElementViews.
inline constexpr std::array kElementViews{
    &ElementViews::x,           &ElementViews::r,       &ElementViews::sin_theta,
    &ElementViews::cos_theta,   &ElementViews::x_dot,   &ElementViews::r_dot,
    &ElementViews::theta_dot,   &ElementViews::omega_x, &ElementViews::omega_r,
    &ElementViews::omega_theta, &ElementViews::theta};
using ElementStorage = std::array<std::vector<double>, kElementViews.size()>;

/// State variables of every element, in its order.
enum class Quantity : unsigned char {
  X,
  R,
  Theta,
  XDot,
  RDot,
  ThetaDot,
  OmegaX,
  OmegaR,
  OmegaTheta
};

struct ElementQuantity {
  std::string_view name,
      unit;  ///< of the state component "element.<name>[k] [unit]"
  ScaleKind scale;
  const double* ElementViews::*view;
};
inline constexpr std::array kQuantities{
    ElementQuantity{"x", "m", ScaleKind::Length, &ElementViews::x},
    ElementQuantity{"r", "m", ScaleKind::Length, &ElementViews::r},
    ElementQuantity{"theta", "rad", ScaleKind::Angle, &ElementViews::theta},
    ElementQuantity{"x_dot", "m/s", ScaleKind::Velocity, &ElementViews::x_dot},
    ElementQuantity{"r_dot", "m/s", ScaleKind::Velocity, &ElementViews::r_dot},
    ElementQuantity{"theta_dot", "rad/s", ScaleKind::Rate, &ElementViews::theta_dot},
    ElementQuantity{"omega_x", "rad/s", ScaleKind::Rate, &ElementViews::omega_x},
    ElementQuantity{"omega_r", "rad/s", ScaleKind::Rate, &ElementViews::omega_r},
    ElementQuantity{"omega_theta", "rad/s", ScaleKind::Rate, &ElementViews::omega_theta}};

/// Place of each quantity in the state: one slice per quantity, all
/// elements in it.
class ElementSlices {
 public:
  [[nodiscard]] Slice& operator[](Quantity q) noexcept {
    return slices_[static_cast<std::size_t>(q)];
  }
  [[nodiscard]] const Slice& operator[](Quantity q) const noexcept {
    return slices_[static_cast<std::size_t>(q)];
  }
  [[nodiscard]] std::size_t elements() const noexcept {
    return static_cast<std::size_t>(slices_[0].count);
  }
  /// Index in the state of a quantity of element i.
  [[nodiscard]] int at(Quantity q, std::size_t i) const noexcept {
    return (*this)[q].first + static_cast<int>(i);
  }

 private:
  std::array<Slice, kQuantities.size()> slices_{};
};

/// Results of contacts, n values each; forces and moments are ADDED to what is
/// there.
struct ElementForces {
  double *F_x, *F_r, *F_theta;  ///< on the element [N]
  double *M_x, *M_r, *M_theta;  ///< about its center [N m]
  double* load;                 ///< Q of this race [N] (assigned)
  double* heat;                 ///< ∫ κ p u dA [W] (assigned)
  double* load_slip;            ///< ∫ p u dA [W] (assigned); not touched when null
};

/// The arrays of ElementForces that are added to.
inline constexpr std::array kElementActions{&ElementForces::F_x,     &ElementForces::F_r,
                                            &ElementForces::F_theta, &ElementForces::M_x,
                                            &ElementForces::M_r,     &ElementForces::M_theta};
using ElementActions = std::array<std::vector<double>, kElementActions.size()>;

/// Views into the state, with the sines and cosines of the azimuths in `sin`,
/// `cos` (n values each). False: an element is on the bearing axis.
bool view_elements(const double* y, const ElementSlices& slices, double* sin, double* cos,
                   ElementViews& out) noexcept;
/// Targets of the rates of each quantity, in their order.
[[nodiscard]] inline std::array<double*, kQuantities.size()> rates_in(
    double* dydt, const ElementSlices& slices) noexcept {
  std::array<double*, kQuantities.size()> out{};
  for (std::size_t q = 0; q < out.size(); ++q)
    out[q] = dydt + slices[static_cast<Quantity>(q)].first;
  return out;
}
/// Views of the first n values of a storage.
[[nodiscard]] ElementViews view_of(const ElementStorage& storage, std::size_t n) noexcept;
/// Copies element i of `from` to place k.
void gather(const ElementViews& from, std::size_t i, ElementStorage& to, std::size_t k) noexcept;
/// Targets of the contacts' sums and values; load_slip may be null.
[[nodiscard]] ElementForces element_force_targets(ElementActions& actions, double* load,
                                                  double* heat, double* load_slip) noexcept;

}  // namespace adore::dynamics
