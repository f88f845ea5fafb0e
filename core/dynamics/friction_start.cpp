#include "dynamics/friction_start.hpp"

#include "base/errors.hpp"
#include "base/rotation.hpp"
#include "dynamics/elements.hpp"
#include "dynamics/race_load.hpp"
#include "dynamics/state_access.hpp"
#include "statics/friction_flow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace adore::dynamics {
namespace {

constexpr std::size_t kX = 0, kR = 1, kTilt = 2, kSkew = 3, kSpin = 4;
using Vec = Eigen::Matrix<double, 5, 1>;
using Mat = Eigen::Matrix<double, 5, 5>;

constexpr double kStays = 1e-9;  ///< [rad]
constexpr int kMostSteps = 80;
constexpr double kBalanced = 1e-7;   ///< of the first residual
constexpr double kRounding = 1e-12;  ///< residuals that a balanced roller keeps are 1e-16 to 1e-13
/// Differences and longest step of (x, r, φ, ψ, ω_s) in units of half the diameter, 1 and 1/T.
const Vec kDifference = (Vec() << 1e-8, 1e-8, 1e-7, 1e-7, 1e-7).finished();
const Vec kLongestStep = (Vec() << 1e-3, 1e-3, 3e-4, 3e-4, 1e-4).finished();

/// Places of the elements in the state: rollers, or balls without attitude, whose u is (x, r, ω).
class Elements {
 public:
  Elements(const StateLayout& layout, bool balls) : balls_(balls) {
    for (std::size_t q = 0; q < kQuantities.size(); ++q)
      slices_[static_cast<Quantity>(q)] =
          find(layout, "element." + std::string(kQuantities[q].name));
    for (std::size_t i = 0; !balls && i < slices_.elements(); ++i)
      attitude_.push_back(find(layout, fmt::format("element{}.quaternion", i + 1)));
  }
  [[nodiscard]] std::size_t count() const noexcept { return slices_.elements(); }

  [[nodiscard]] Vec read(const std::vector<double>& y, std::size_t i) const {
    if (balls_) {
      Vec u;
      for (std::size_t k = 0; k < kOfBall.size(); ++k)
        u[static_cast<Eigen::Index>(k)] = at(y, kOfBall[k], i);
      return u;
    }
    const Mat3 axes = rotation_matrix(quaternion_at(y.data(), attitude_[i]));
    const double theta = at(y, Quantity::Theta, i);
    const Vec3 a(axes(0, 0), -std::sin(theta) * axes(1, 0) + std::cos(theta) * axes(2, 0),
                 -std::cos(theta) * axes(1, 0) - std::sin(theta) * axes(2, 0));
    Vec3 omega(at(y, Quantity::OmegaX, i), at(y, Quantity::OmegaR, i),
               at(y, Quantity::OmegaTheta, i));
    omega[0] -= at(y, Quantity::ThetaDot, i);
    Vec u;
    u << at(y, Quantity::X, i), at(y, Quantity::R, i), std::atan2(a[1], a[0]), -std::asin(a[2]),
        omega.dot(a);
    return u;
  }
  void write(std::vector<double>& y, std::size_t i, const Vec& u) const {
    if (balls_) {
      for (std::size_t k = 0; k < kOfBall.size(); ++k)
        component(y, slices_[kOfBall[k]], i) = u[static_cast<Eigen::Index>(k)];
      return;
    }
    const double c = std::cos(u[kSkew]);
    const Vec3 a(std::cos(u[kTilt]) * c, std::sin(u[kTilt]) * c, -std::sin(u[kSkew]));
    component(y, slices_[Quantity::X], i) = u[kX];
    component(y, slices_[Quantity::R], i) = u[kR];
    component(y, slices_[Quantity::OmegaX], i) = at(y, Quantity::ThetaDot, i) + u[kSpin] * a[0];
    component(y, slices_[Quantity::OmegaR], i) = u[kSpin] * a[1];
    component(y, slices_[Quantity::OmegaTheta], i) = u[kSpin] * a[2];
    store_at(y.data(), attitude_[i],
             multiply(multiply(quaternion_about(Vec3::UnitX(), at(y, Quantity::Theta, i)),
                               quaternion_about(Vec3::UnitY(), -u[kTilt])),
                      quaternion_about(Vec3::UnitZ(), u[kSkew])));
  }
  /// In the order of u: tilt is a rotation about -y (e_θ), skew one about z (e_r), spin one about
  /// a.
  [[nodiscard]] Vec rates(const std::vector<double>& dydt, std::size_t i, const Vec& u,
                          const Scales& scales) const {
    const double T = scales.time, L = scales.length, c = std::cos(u[kTilt]), s = std::sin(u[kTilt]);
    const Vec3 w(at(dydt, Quantity::OmegaX, i), at(dydt, Quantity::OmegaR, i),
                 at(dydt, Quantity::OmegaTheta, i));
    Vec F;
    // An element in modes 1 and 2 moves to its balance by a rate of its place.
    F.head<2>() << (T * at(dydt, Quantity::XDot, i) + at(dydt, Quantity::X, i)) * T / L,
        (T * at(dydt, Quantity::RDot, i) + at(dydt, Quantity::R, i)) * T / L;
    if (balls_)
      F.tail<3>() = T * T * w;
    else
      F.tail<3>() << T * T * w[2], T * T * (c * w[1] - s * w[0]), T * T * (c * w[0] + s * w[1]);
    return F;
  }

 private:
  static Slice find(const StateLayout& layout, const std::string& name) {
    for (const StateLayout::Group& group : layout.groups())
      if (group.name == name) return group.slice;
    throw InternalError("the state has no " + name);
  }
  [[nodiscard]] double at(const std::vector<double>& y, Quantity q, std::size_t i) const {
    return y[static_cast<std::size_t>(slices_.at(q, i))];
  }
  static constexpr std::array kOfBall{Quantity::X, Quantity::R, Quantity::OmegaX, Quantity::OmegaR,
                                      Quantity::OmegaTheta};
  bool balls_;
  ElementSlices slices_;
  std::vector<Slice> attitude_;  ///< of rollers
};

struct Roller {
  Vec first, u, F;
  Mat J;
  double size_at_first = 0.0, size = 0.0;
  bool done = false;
};

/// Does skew leave the balance if the others follow it at once?
bool runs_away(const Roller& of) {
  return std::abs(of.u[kSkew]) > kStays && statics::condensed_slope<5>(of.J, kSkew) > 0.0;
}

class Balance {
 public:
  Balance(System& system, std::vector<double>& y)
      : system_(system),
        balls_(system.bearing().rollers() == nullptr),
        rollers_(system.layout(), balls_),
        y_(y),
        dydt_(y.size()),
        all_(rollers_.count()) {
    const Scales& s = system.scales();
    unit_ << s.length, s.length, 1.0, 1.0, 1.0 / s.time;
    if (balls_) unit_[kTilt] = unit_[kSkew] = unit_[kSpin];
  }
  FrictionBalanceResult find();

 private:
  [[nodiscard]] bool evaluate() {
    return system_.rhs(0.0, y_.data(), dydt_.data()) == RhsStatus::Ok;
  }
  [[nodiscard]] bool measure(bool first);
  [[nodiscard]] bool differences();
  void step(Roller& of) const;

  System& system_;
  bool balls_;
  Elements rollers_;
  std::vector<double>&y_, dydt_;
  std::vector<Roller> all_;
  Vec unit_;  ///< of u
};

bool Balance::differences() {
  for (std::size_t k = 0; k < 5; ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    const double step = kDifference[column] * unit_[column];
    for (std::size_t i = 0; i < all_.size(); ++i) {
      Vec u = all_[i].u;
      u[column] += step;
      rollers_.write(y_, i, u);
    }
    if (!evaluate()) return false;
    for (std::size_t i = 0; i < all_.size(); ++i) {
      Roller& of = all_[i];
      Vec u = of.u;
      u[column] += step;
      of.J.col(column) =
          (rollers_.rates(dydt_, i, u, system_.scales()) - of.F) / kDifference[column];
    }
  }
  for (std::size_t i = 0; i < all_.size(); ++i) rollers_.write(y_, i, all_[i].u);
  return true;
}

/// Residuals of the present places; true when all are balanced.
bool Balance::measure(bool first) {
  bool all_done = true;
  for (std::size_t i = 0; i < all_.size(); ++i) {
    Roller& of = all_[i];
    of.F = rollers_.rates(dydt_, i, of.u, system_.scales());
    of.size = of.F.norm();
    if (first) of.size_at_first = of.size;
    of.done = of.size <= std::max(kBalanced * of.size_at_first, kRounding);
    all_done = all_done && of.done;
  }
  return all_done;
}

/// One linearly implicit step of du/dτ = F.
void Balance::step(Roller& of) const {
  if (of.done) return;
  if (const auto d =
          statics::pseudo_time_step<5>(of.J, of.F, of.size / of.size_at_first, kLongestStep))
    of.u += d->cwiseProduct(unit_);
}

FrictionBalanceResult Balance::find() {
  const std::vector<double> before = y_;
  for (std::size_t i = 0; i < all_.size(); ++i) all_[i].first = all_[i].u = rollers_.read(y_, i);
  bool known = false;  // differences at the last places
  for (int k = 0; k < kMostSteps; ++k) {
    known = false;
    if (!evaluate()) break;
    const bool all_done = measure(k == 0);
    known = differences();
    if (all_done || !known) break;
    for (std::size_t i = 0; i < all_.size(); ++i) {
      step(all_[i]);
      rollers_.write(y_, i, all_[i].u);
    }
  }
  FrictionBalanceResult out;
  out.rollers = all_.size();
  y_ = before;
  for (std::size_t i = 0; i < all_.size(); ++i) {
    const Roller& of = all_[i];
    if (!known || !of.done) continue;
    if (!balls_ && (std::abs(of.u[kSkew]) > statics::kLargestSkew || runs_away(of))) continue;
    rollers_.write(y_, i, of.u);
    ++out.balanced;
    if (!balls_) out.largest_skew = std::max(out.largest_skew, std::abs(of.u[kSkew]));
  }
  return out;
}

}  // namespace

FrictionBalanceResult balance_friction(System& system, std::vector<double>& y) {
  return Balance(system, y).find();
}

double balance_race(System& system, std::vector<double>& y, const Mat3& stiffness,
                    const std::array<bool, 3>& free) {
  const auto slice_of = [&](const char* name) -> const Slice* {
    for (const StateLayout::Group& group : system.layout().groups())
      if (group.name == name) return &group.slice;
    return nullptr;
  };
  const Slice* const centre = slice_of("inner race.centre");
  const Slice* const place = centre != nullptr ? centre : slice_of("inner race.position");
  const Slice* const velocity = slice_of("inner race.velocity");
  if (place == nullptr || (!free[0] && !free[1] && !free[2])) return 0.0;
  Mat3 K = stiffness;
  for (int k = 0; k < 3; ++k)
    if (!free[static_cast<std::size_t>(k)]) {
      K.row(k).setZero();
      K.col(k).setZero();
      K(k, k) = stiffness.diagonal().maxCoeff();
    }
  const double smallest = 1e-9 * K.diagonal().maxCoeff();
  if (!(std::abs(K.determinant()) > smallest * smallest * smallest)) return 0.0;
  const Mat3 inverse = K.inverse();
  constexpr int kSteps = 6;
  constexpr double kBalancedRace = 1e-6;  ///< of the force scale
  std::vector<double> dydt(y.size()), before;
  double left = 0.0;
  for (int n = 0; n <= kSteps; ++n) {
    if (system.rhs(0.0, y.data(), dydt.data()) != RhsStatus::Ok) {
      if (n > 0) y = before;
      return left;
    }
    Vec3 residual = Vec3::Zero();
    if (centre != nullptr)
      residual = system.balanced_race().asked - system.balanced_race().carried;
    else
      residual = system.bearing().race_inertia[1].mass * vector_at(dydt.data(), *velocity);
    for (int k = 0; k < 3; ++k)
      if (!free[static_cast<std::size_t>(k)]) residual[k] = 0.0;
    const double now = residual.norm() / system.scales().force;
    if (n > 0 && now > left) {  // friction that jumps with the slip
      y = before;
      return left;
    }
    left = now;
    if (left < kBalancedRace || n == kSteps) return left;
    before = y;
    store_at(y.data(), *place, Vec3(vector_at(y.data(), *place) + inverse * residual));
    (void)balance_friction(system, y);
  }
  return left;
}

}  // namespace adore::dynamics
