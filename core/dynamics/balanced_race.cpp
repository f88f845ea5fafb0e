#include "dynamics/balanced_race.hpp"

#include "base/symmetric_eigen.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace adore::dynamics {

void BalancedRace::set_time(double t) noexcept {
  if (rotating_load_fraction_ == 0.0) return;
  const double angle = rotating_load_speed_ * t, y = load_at_start_[1], z = load_at_start_[2];
  const double c = std::cos(angle), s = std::sin(angle);
  const Vec3 turned(0.0, c * y - s * z, s * y + c * z);
  load_ = load_at_start_ + rotating_load_fraction_ * (turned - Vec3(0.0, y, z));
  load_rate_ = rotating_load_fraction_ * rotating_load_speed_ * Vec3(0.0, -turned[2], turned[1]);
}

void BalancedRace::estimate_velocity(const Mat3& stiffness, const Vec3& drift,
                                     double element_mass) noexcept {
  Mat3 K = 0.5 * (stiffness + stiffness.transpose());
  for (int k = 0; k < 3; ++k)
    if (!free_axes_[static_cast<std::size_t>(k)]) {
      K.row(k).setZero();
      K.col(k).setZero();
    }
  const SymmetricEigen<3> eigen = symmetric_eigen<3>(K);
  const double largest = eigen.values[2];
  Mat3 inverse = Mat3::Zero();
  stiffness_ = K;
  stiff_projection_.setZero();
  for (int k = 0; k < 3; ++k) {
    const double value = eigen.values[k];
    if (!(value > 1e-9 * largest)) continue;
    const Mat3 along = eigen.vectors.col(k) * eigen.vectors.col(k).transpose();
    inverse += along / value;
    stiff_projection_ += along;
  }
  velocity_ = inverse * (drift + load_rate_ + user_load_rate_);
  rate_ = 0.5 * std::sqrt(std::max(K.trace(), 0.0) / (3.0 * element_mass));
  resist(Mat3::Zero());
}

Vec3 BalancedRace::residual(const Vec3& of_elements) const noexcept {
  Vec3 out = load() + of_elements;
  for (int k = 0; k < 3; ++k)
    if (!free_axes_[static_cast<std::size_t>(k)]) out[k] = 0.0;
  return out;
}

void BalancedRace::resist(const Mat3& friction) noexcept {
  mobility_.setZero();
  if (!(rate_ > 0.0)) return;
  // Directions without stiffness stay where they are: any value on their diagonal makes M regular.
  const Mat3 M = stiff_projection_ * (stiffness_ / rate_ + friction) * stiff_projection_ +
                 stiffness_.trace() / rate_ * (Mat3::Identity() - stiff_projection_);
  mobility_ = stiff_projection_ * M.inverse() * stiff_projection_;
}

Vec3 BalancedRace::pull(const Vec3& of_elements) const noexcept {
  return mobility_ * residual(of_elements);
}

}  // namespace adore::dynamics
