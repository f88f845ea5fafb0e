#pragma once

#include "contact/ball_pocket.hpp"
#include "contact/cage_pieces.hpp"
#include "contact/conformal.hpp"
#include "contact/damping_law.hpp"
#include "dynamics/effect.hpp"
#include "dynamics/effects/gathered_traction.hpp"
#include "dynamics/effects/heat_by_part.hpp"
#include "dynamics/effects/kept_values.hpp"
#include "dynamics/effects/scene_pieces.hpp"
#include "dynamics/effects/user_forces.hpp"
#include "tribology/traction_law.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <type_traits>

/// Balls in the pockets of a cage or of its segments. Identical round pockets with identical balls
/// have a separate fast path; other shapes, halves, pockets with deviations (record
/// 7.4) and balls of unequal diameter use the general one: the wall is that of a nominal ball, the
/// clearance that left by the ball. A ball in a cut pocket touches the halves of two segments,
/// which are two sets.
///
/// Normal: N = law(-gap) on the ball along -m, gap and m of contact/ball_pocket.hpp. Friction acts
/// at the ball surface point p = r_b m (not shortened by the penetration): slip u = cage velocity -
/// ball velocity there, its part along m removed; friction on the ball N κ(s)/s u, s the rounded
/// slip (tribology/rounded_law.hpp); opposite force on the cage at the same point of space. Heat =
/// friction · u. The force is minus the gradient of law.energy with respect to ball and cage pose.
/// With damping (contact_damping.hpp) N is the total force, and friction goes with it.
/// Limit: the ball center is inside the hole; otherwise the state is not valid.
namespace adore::dynamics {

/// In the pockets of balls or rollers.
inline constexpr LedgerTerm kPocketHeat{LedgerKind::Heat,
                                        "pocket_heat",
                                        "heat in the pockets",
                                        {"cage pockets"},
                                        "dissipated since the start"};

/// Epicyclic speed of the cage at the free contact angle, or of the rollers' axes, signed [rad/s].
[[nodiscard]] double nominal_cage_speed(const bearing::Bearing& bearing) noexcept;

class PocketSet {
 public:
  /// @param pockets where they are, without their deviations
  PocketSet(const bearing::Bearing& bearing, const std::vector<contact::SegmentPocket>& pockets);

  /// Not all round and alike: only the general functions hold.
  [[nodiscard]] bool has_shaped_pockets() const noexcept { return !shaped_pockets_.empty(); }
  [[nodiscard]] std::size_t size() const noexcept { return qx_.size(); }
  /// The element in pocket i: the same number, but for the last halves of segments.
  [[nodiscard]] std::size_t element(std::size_t i) const noexcept { return element_[i]; }
  /// For the ball in pocket i; identical round pockets have one for all.
  [[nodiscard]] double ball_radius(std::size_t i) const noexcept {
    return has_shaped_pockets() ? 0.5 * shaped_pockets_[i].pocket.ball_diameter : ball_radius_;
  }
  /// Centers of all balls, or of one, in their pocket frames, kept for the other calls.
  void locate(const Evaluation& e) noexcept;
  void locate(const Evaluation& e, std::size_t i) noexcept;
  [[nodiscard]] Vec3 centre(std::size_t i) const noexcept { return {qx_[i], qy_[i], qz_[i]}; }

  // In general.
  /// Is the ball center inside the hole of the wall and within one radius of its height?
  [[nodiscard]] bool is_inside(std::size_t i) const noexcept {
    return has_shaped_pockets() ? contact::is_inside(shaped_pockets_[i].pocket, centre(i))
                                : is_inside_round_pocket(i);
  }
  [[nodiscard]] contact::WallPoints walls(std::size_t i) const noexcept {
    if (has_shaped_pockets())
      return contact::nearest_walls(shaped_pockets_[i].pocket, centre(i), rotation_sign_);
    contact::WallPoints out;
    out.count = 1;
    out.surface[0] = wall_point(i);
    return out;
  }
  [[nodiscard]] Vec3 to_base(std::size_t i, const Vec3& v,
                             const Mat3& cage_to_base) const noexcept {
    return has_shaped_pockets()
               ? Vec3(cage_to_base * (shaped_pockets_[i].frame.cage_to_pocket.transpose() * v))
               : round_pocket_to_base(i, v, cage_to_base);
  }
  [[nodiscard]] const contact::CappedHertz& law(std::size_t i) const noexcept {
    return has_shaped_pockets() ? shaped_pockets_[i].law : law_;
  }
  /// Force, gap and angles of every surface of pocket i; replaces the content of `out`. Call
  /// locate() first.
  void report(std::size_t i, std::vector<PocketContactSnapshot>& out) const;

  // For identical round pockets.
  [[nodiscard]] bool is_inside_round_pocket(std::size_t i) const noexcept {
    const double d2 = qx_[i] * qx_[i] + qy_[i] * qy_[i];
    return d2 < hole_radius_squared_ && qz_[i] > wall_.z_low - ball_radius_ &&
           qz_[i] < wall_.z_high + ball_radius_;
  }
  /// Conservative and cheap: the gap is never less than ρ - r_b - √(x²+y²).
  [[nodiscard]] bool is_certainly_open(std::size_t i) const noexcept {
    return qx_[i] * qx_[i] + qy_[i] * qy_[i] < clearance_squared_;
  }
  [[nodiscard]] contact::WallPoint wall_point(std::size_t i) const noexcept {
    return contact::nearest_wall(wall_, centre(i), ball_radius_);
  }
  [[nodiscard]] Vec3 round_pocket_to_base(std::size_t i, const Vec3& v,
                                          const Mat3& cage_to_base) const noexcept {
    return cage_to_base *
           Vec3(v[0], cos_[i] * v[1] - sin_[i] * v[2], sin_[i] * v[1] + cos_[i] * v[2]);
  }
  /// The cage segment that pocket i is in.
  [[nodiscard]] int segment(std::size_t i) const noexcept { return segment_[i]; }
  [[nodiscard]] const BodyState& body(const Evaluation& e, std::size_t i) const noexcept {
    return e.segments[static_cast<std::size_t>(segment_[i])];
  }
  [[nodiscard]] BodyState& body(Evaluation& e, std::size_t i) const noexcept {
    return e.segments[static_cast<std::size_t>(segment_[i])];
  }
  [[nodiscard]] const contact::CappedHertz& law() const noexcept { return law_; }

 private:
  struct ShapedPocket {
    contact::BallPocket pocket;
    contact::PocketFrame frame;
    contact::CappedHertz law;
  };
  void locate_in_round_pocket(const Evaluation& e, std::size_t i) noexcept;
  void locate_in_shaped_pocket(const Evaluation& e, std::size_t i) noexcept;

  std::vector<ShapedPocket> shaped_pockets_;
  contact::CylindricalPocket wall_;
  contact::CappedHertz law_;
  double ball_radius_ = 0.0, pitch_radius_ = 0.0, rotation_sign_ = 1.0;
  double hole_radius_squared_ = 0.0,
         clearance_squared_ =
             0.0;  ///< ρ², (ρ - r_b)² [m²]; clearance_squared_ 0 for a pocket without play
  std::vector<double> sin_, cos_;  ///< of the pocket azimuths
  std::vector<double> qx_, qy_, qz_;
  std::vector<int> segment_;  ///< of each pocket
  std::vector<std::size_t> element_;
};

/// Contacts that a ball can have with its pocket.
inline constexpr std::size_t kMostWalls = std::tuple_size_v<decltype(contact::WallPoints::surface)>;

/// One contact of a ball with its pocket wall, base axes.
struct PocketAction {
  double N = 0.0;                 ///< normal force, damping included [N]
  double rate = 0.0;              ///< of approach, where there is damping or traction [m/s]
  double damping = 0.0;           ///< power that damping takes [W]
  double friction_per_slip = 0;   ///< friction force over slip speed [N s/m], 0 without traction
  double slip = 0.0, heat = 0.0;  ///< [m/s, W]
  Vec3 m, arm, point;             ///< normal into the wall; ball center -> contact; contact
  Vec3 on_ball, friction;         ///< whole force on the ball; its friction part [N]
};

/// Contact of ball i with a wall that it overlaps by `overlap` along m, a unit vector in base axes.
/// @param friction per newton and slip, of the square of the slip (tribology::RegularizedLaw), or
/// nullptr without traction
template <class Friction>
[[nodiscard]] inline PocketAction pocket_action(const contact::CappedHertz& law,
                                                const contact::DampingLaw<>& damping,
                                                const Friction& friction, const Evaluation& e,
                                                std::size_t i, const BodyState& cage,
                                                double ball_radius, const Vec3& m,
                                                double overlap) noexcept {
  PocketAction a;
  a.N = contact::load(law, overlap);
  a.m = m;
  a.arm = ball_radius * a.m;
  a.point = e.element_centre(i) + a.arm;
  Vec3 slip = cage.velocity_at(a.point) - e.element_velocity(i) - e.element_omega(i).cross(a.arm);
  a.rate = -slip.dot(a.m);
  if (contact::is_damped(damping)) {
    const double elastic = a.N;
    a.N = contact::damped_load(damping, elastic, contact::slope(law, overlap), overlap, a.rate);
    a.damping = (a.N - elastic) * a.rate;
  }
  a.on_ball = -a.N * a.m;
  if constexpr (!std::is_null_pointer_v<Friction>) {
    slip += a.rate * a.m;
    const double square = slip.squaredNorm();
    a.slip = std::sqrt(square);
    a.friction_per_slip = friction_over_slip(friction, a.N, square);
    a.friction = a.friction_per_slip * slip;
    a.heat = a.friction.dot(slip);
    a.on_ball += a.friction;
  }
  return a;
}

/// One contact for ADRX3, of a pocket of a set.
struct UserPocketTouch {
  std::size_t pocket, surface;
  PocketAction action;
};
using UserPocketForces = UserForces<UserPocketTouch>;

/// Effects "pocket contact" and "pocket traction", of balls. Not valid when a ball's center left
/// the hole.
class PocketContact final : public SceneEffect, public NonRaceContacts {
 public:
  void declare(SceneBuilder& scene) override;
  [[nodiscard]] std::string why_invalid(const Evaluation& e) const override;
  void report(const Evaluation& e, Snapshot& snapshot) const override;
  void look(const Evaluation& e, Look& out) const override;
  /// N' m mᵀ, and N over the distance from the pocket axis across it (an estimate where the wall
  /// does not go round that axis).
  void resist(const Evaluation& e, std::size_t i, Mat3& stiffness) noexcept override;
  void damp(const Evaluation& e, std::size_t i, Eigen::Matrix2d& damping) noexcept override;
  /// Pockets that belong to one piece of the cage. @pre declared
  [[nodiscard]] PocketSet& set() noexcept { return *pocket_set_; }

 private:
  /// visit(set, its pocket of element i): one, or the halves of two segments.
  template <class Visit>
  void for_pockets(std::size_t i, const Visit& visit) {
    visit(*pocket_set_, i);
    if (!end_half_pockets_) return;
    for (std::size_t k = 0; k < end_half_pockets_->size(); ++k)
      if (end_half_pockets_->element(k) == i) visit(*end_half_pockets_, k);
  }
  void add_block(SceneBuilder& scene, PocketSet& set, LastContactValues& kept,
                 std::vector<BodyId> partners);

  std::optional<PocketSet> pocket_set_;
  std::optional<PocketSet> end_half_pockets_;  ///< of segments that are cut through their pockets
  std::optional<tribology::TractionLaw> friction_;
  contact::DampingLaw<> damping_;
  std::array<std::optional<UserPocketForces>, 2> user_forces_;  ///< ADRX3 of both sets
  std::array<LastContactValues, 2> kept_;                       ///< likewise, by pocket and surface
  HeatByPart heat_;  ///< now, of the pocket of each element
};

}  // namespace adore::dynamics
