#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

#include <cmath>
#include <optional>

/// Steps towards a balance of friction, of statics (roller_friction.hpp) and of the start of a
/// motion (dynamics/friction_start.hpp): linearly implicit steps of the flow du/dτ = F(u), F the
/// rates in units of the scales of u, J = ∂F/∂u. Its pseudo time grows as F falls, so that far from
/// the balance the flow is followed and near it the steps are Newton's.
namespace adore::statics {

inline constexpr double kLargestSkew = 0.01;  ///< of a balance that is taken [rad]
inline constexpr double kFirstPseudoTime = 1e3;

/// @param ratio |F| over that of the first step
/// @param longest largest size of each component; empty: the step is not finite
template <int N>
[[nodiscard]] std::optional<Eigen::Matrix<double, N, 1>> pseudo_time_step(
    Eigen::Matrix<double, N, N> J, const Eigen::Matrix<double, N, 1>& F, double ratio,
    const Eigen::Matrix<double, N, 1>& longest) {
  J.diagonal().array() -= ratio / kFirstPseudoTime;
  Eigen::Matrix<double, N, 1> d = J.partialPivLu().solve(-F);
  const double over = (d.array().abs() / longest.array()).maxCoeff();
  if (!std::isfinite(over)) return std::nullopt;
  if (over > 1.0) d /= over;
  return d;
}

/// ∂F/∂u of component k if the others follow it at once: J_kk - J_ko J_oo⁻¹ J_ok. Above 0 the
/// component leaves the balance.
template <int N>
[[nodiscard]] double condensed_slope(const Eigen::Matrix<double, N, N>& J, int k) {
  Eigen::Matrix<double, N - 1, N - 1> among;
  Eigen::Matrix<double, N - 1, 1> by_k, on_k;
  const auto other = [k](int a) { return a < k ? a : a + 1; };
  for (int a = 0; a < N - 1; ++a) {
    by_k[a] = J(other(a), k);
    on_k[a] = J(k, other(a));
    for (int b = 0; b < N - 1; ++b) among(a, b) = J(other(a), other(b));
  }
  return J(k, k) - on_k.dot(among.partialPivLu().solve(by_k));
}

}  // namespace adore::statics
