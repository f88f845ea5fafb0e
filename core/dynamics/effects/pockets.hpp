#pragma once

#include "contact/ball_pocket.hpp"
#include "contact/conformal.hpp"
#include "dynamics/effect.hpp"

#include <optional>

/// Balls in the cylindrical pockets of a one-piece cage.
///
/// Normal: N = law(-gap) on the ball along -m, gap and m of contact/ball_pocket.hpp. Friction acts
/// at the ball surface point p = r_b m (not shortened by the penetration): slip u = cage velocity -
/// ball velocity there, its part along m removed; friction on the ball N κ(|u|) u/|u|; opposite
/// force on the cage at the same point of space. Heat = friction · u. The force is minus the
/// gradient of law.energy with respect to ball and cage pose. Limit: the ball centre is inside the
/// hole; otherwise the state is not valid.
namespace adore::dynamics {

/// Epicyclic speed of the cage at the free contact angle, signed [rad/s].
[[nodiscard]] double nominal_cage_speed(const bearing::Bearing& bearing) noexcept;

class PocketSet {
 public:
  /// @param azimuths of the pocket centres in the cage frame [rad]
  PocketSet(const bearing::Bearing& bearing, const std::vector<double>& azimuths);

  /// Centres of all balls in their pocket frames, kept for the other calls.
  void locate(const Evaluation& e) noexcept;
  [[nodiscard]] Vec3 centre(std::size_t i) const noexcept { return {qx_[i], qy_[i], qz_[i]}; }
  /// Is the ball centre inside the hole of the wall and within one radius of its height?
  [[nodiscard]] bool inside(std::size_t i) const noexcept {
    const double d2 = qx_[i] * qx_[i] + qy_[i] * qy_[i];
    return d2 < hole2_ && qz_[i] > wall_.z_low - ball_radius_ &&
           qz_[i] < wall_.z_high + ball_radius_;
  }
  /// Conservative and cheap: the gap is never less than ρ - r_b - √(x²+y²).
  [[nodiscard]] bool surely_open(std::size_t i) const noexcept {
    return qx_[i] * qx_[i] + qy_[i] * qy_[i] < play2_;
  }
  [[nodiscard]] contact::WallPoint wall_point(std::size_t i) const noexcept {
    return contact::nearest_wall(wall_, centre(i), ball_radius_);
  }
  [[nodiscard]] Vec3 to_base(std::size_t i, const Vec3& v,
                             const Mat3& cage_to_base) const noexcept {
    return cage_to_base *
           Vec3(v[0], cos_[i] * v[1] - sin_[i] * v[2], sin_[i] * v[1] + cos_[i] * v[2]);
  }
  [[nodiscard]] std::size_t size() const noexcept { return sin_.size(); }
  /// The cage segment that pocket i is in.
  [[nodiscard]] int segment(std::size_t i) const noexcept { return segment_[i]; }
  [[nodiscard]] const BodyState& body(const Evaluation& e, std::size_t i) const noexcept {
    return e.segments[static_cast<std::size_t>(segment_[i])];
  }
  [[nodiscard]] BodyState& body(Evaluation& e, std::size_t i) const noexcept {
    return e.segments[static_cast<std::size_t>(segment_[i])];
  }
  [[nodiscard]] const contact::CappedHertz& law() const noexcept { return law_; }
  [[nodiscard]] double ball_radius() const noexcept { return ball_radius_; }
  /// The same of one ball.
  void locate(const Evaluation& e, std::size_t i) noexcept;
  /// Force, gap and angles of pocket i; call locate() first.
  [[nodiscard]] PocketContactSnapshot report(std::size_t i) const;

 private:
  void locate_one(const Evaluation& e, std::size_t i) noexcept;

  contact::CylindricalPocket wall_;
  contact::CappedHertz law_;
  double ball_radius_ = 0.0, pitch_radius_ = 0.0, rotation_sign_ = 1.0;
  double hole2_ = 0.0, play2_ = 0.0;  ///< ρ², (ρ - r_b)² [m²]; play2_ 0 for a pocket without play
  std::vector<double> sin_, cos_;     ///< of the pocket azimuths
  std::vector<double> qx_, qy_, qz_;
  std::vector<int> segment_;  ///< of each pocket
};

/// One contact of a ball with its pocket wall, base axes.
struct PocketAction {
  double N = 0.0;                 ///< normal force [N]
  double friction_per_slip = 0;   ///< friction force over slip speed [N s/m], 0 without traction
  double slip = 0.0, heat = 0.0;  ///< [m/s, W]
  Vec3 m, arm, point;             ///< normal into the wall; ball centre -> contact; contact
  Vec3 on_ball, friction;         ///< whole force on the ball; its friction part [N]
};

/// Contact i at the located state; `wall` from set.wall_point(i), gap < 0.
template <bool Traction>
[[nodiscard]] inline PocketAction pocket_action(const PocketSet& set, const SlipFriction& law,
                                                const Evaluation& e, std::size_t i,
                                                const contact::WallPoint& wall) noexcept {
  PocketAction a;
  a.N = contact::load(set.law(), -wall.gap);
  const BodyState& cage = set.body(e, i);
  a.m = set.to_base(i, wall.m, cage.to_base);
  a.arm = set.ball_radius() * a.m;
  a.point = e.element_centre(i) + a.arm;
  a.on_ball = -a.N * a.m;
  if constexpr (Traction) {
    Vec3 slip = cage.velocity_at(a.point) - e.element_velocity(i) - e.element_omega(i).cross(a.arm);
    slip -= slip.dot(a.m) * a.m;
    a.slip = slip.norm();
    a.friction_per_slip = a.N * law.per_slip(a.slip);
    a.friction = a.friction_per_slip * slip;
    a.heat = a.friction.dot(slip);
    a.on_ball += a.friction;
  }
  return a;
}

/// Effects "pocket contact" and "pocket traction". Not valid when a ball's centre left the hole.
class PocketContact final : public SceneEffect {
 public:
  void declare(SceneBuilder& scene) override;
  [[nodiscard]] std::string why_invalid(const Evaluation& e) const override;
  void report(const Evaluation& e, Snapshot& snapshot) const override;

  [[nodiscard]] PocketSet& set() noexcept { return *set_; }
  /// Has no friction without pocket traction.
  [[nodiscard]] const std::optional<SlipFriction>& friction() const noexcept { return friction_; }

 private:
  std::optional<PocketSet> set_;
  std::optional<SlipFriction> friction_;
  double heat_ = 0.0;  ///< now [W]
};

}  // namespace adore::dynamics
