#include "statics/roller_step.hpp"

#include "base/symmetric_eigen.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace adore::statics {
namespace {

/// A roller that friction holds axially, with no flange against it, does not move that way.
bool is_gripped(const RollerModel& m, const Contacts& c) { return m.grips && !c.flange_loaded; }

}  // namespace

template <class S>
ScaledForces scaled(const RollerModel& m, const Forces<S>& f, const Contacts& contacts) {
  ScaledForces out;
  const Eigen::Vector3d lever(1.0, 1.0, m.lever);
  for (Eigen::Index i = 0; i < 3; ++i) {
    const S& r = f.residual[static_cast<std::size_t>(i)];
    out.force(i) = r.v / lever(i);
    for (Eigen::Index j = 0; j < 3; ++j) {
      out.stiffness(i, j) = -r.d[static_cast<std::size_t>(j)] / (lever(i) * lever(j));
    }
  }
  if (is_gripped(m, contacts)) {
    out.stiffness.col(0).setZero();
  }
  return out;
}

Eigen::Vector3d unscaled_step(const RollerModel& m, Eigen::Vector3d step) {
  step(2) /= m.lever;
  return step;
}

RollerStep roller_step(const RollerModel& m, const ScaledForces& s, double k_ref, double rounding) {
  constexpr double kWeakStiffness = 1e-6;
  RollerStep out;
  const Eigen::Matrix3d K = 0.5 * (s.stiffness + s.stiffness.transpose());
  const double d0 = K(0, 0);
  const double d1 = K(0, 0) * K(1, 1) - K(0, 1) * K(0, 1);
  const double det = K.determinant();
  const double small = 1e-7 * k_ref;
  if (d0 > small && d1 > small * d0 && det > small * d1) {
    out.step = s.stiffness.partialPivLu().solve(s.force);
    return out;
  }
  const double across = K(1, 1) * K(2, 2) - K(1, 2) * K(1, 2);
  if (K.col(0).isZero(0.0) && s.force(0) == 0.0 && K(1, 1) > small && across > small * K(1, 1)) {
    const Eigen::Matrix2d rest = s.stiffness.bottomRightCorner<2, 2>();
    out.step.tail<2>() = rest.partialPivLu().solve(s.force.tail<2>());
    return out;
  }
  const SymmetricEigen<3> eigen = symmetric_eigen<3>(K);
  const double stiffest = eigen.values.cwiseAbs().maxCoeff();
  if (!(stiffest > 1e-9 * k_ref)) {  // touches nothing: walks until it does, without turning
    const double load = s.force.head<2>().norm();
    if (load > rounding) {
      out.step.head<2>() = s.force.head<2>() * (m.longest_step / load);
    }
    out.balanced = !(load > rounding);
    return out;
  }
  Eigen::Vector3d weak = Eigen::Vector3d::Zero();
  double load_of_rest = 0.0, load_of_weak = 0.0;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const Eigen::Vector3d mode = eigen.vectors.col(k);
    const double load = mode.dot(s.force);
    const double stiffness = std::abs(eigen.values(k));
    if (stiffness > kWeakStiffness * stiffest) {
      out.step += mode * (load / stiffness);
      load_of_rest = std::hypot(load_of_rest, load);
    } else if (std::abs(load) > m.weak_floor) {
      weak += mode * (load / std::max(stiffness, 1e-13 * stiffest));
      load_of_weak = std::hypot(load_of_weak, load);
    }
  }
  out.balanced = load_of_weak == 0.0 && load_of_rest <= rounding;
  if (load_of_rest <= 10.0 * load_of_weak) {
    const double length = weak.norm();
    out.step += length > m.longest_step ? weak * (m.longest_step / length) : weak;
  }
  return out;
}

Eigen::Matrix<double, 3, 5> race_following_matrix(const RollerModel& m, const Forces<RollerDual>& f,
                                                  const Contacts& contacts) {
  const ScaledForces s = scaled(m, f, contacts);
  Eigen::Matrix<double, 3, 5> by_race;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const double lever = i == 2 ? m.lever : 1.0;
    for (Eigen::Index k = 0; k < 5; ++k) {
      by_race(i, k) =
          f.residual[static_cast<std::size_t>(i)].d[static_cast<std::size_t>(k) + 3] / lever;
    }
  }
  Eigen::Matrix<double, 3, 5> out = Eigen::Matrix<double, 3, 5>::Zero();
  const double k_ref = s.stiffness.diagonal().cwiseAbs().maxCoeff();
  if (!(k_ref > 0.0)) {
    return out;
  }
  // A spring of 1e-13 of the stiffness keeps free modes still and changes nothing else that can be
  // seen.
  const Eigen::Matrix3d K = s.stiffness + 1e-13 * k_ref * Eigen::Matrix3d::Identity();
  out = K.partialPivLu().solve(by_race);
  out.row(2) /= m.lever;
  return out;
}

template ScaledForces scaled(const RollerModel&, const Forces<PlaceDual>&, const Contacts&);

}  // namespace adore::statics
