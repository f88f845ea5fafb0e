#pragma once

#include "contact/ball_pocket.hpp"
#include "contact/cage_pieces.hpp"
#include "contact/conformal.hpp"
#include "contact/damping_law.hpp"
#include "contact/line_contact.hpp"
#include "contact/roller_flange.hpp"
#include "contact/roller_pocket.hpp"
#include "contact/roller_pocket_play.hpp"
#include "dynamics/effect.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

/// Rollers in the pockets of a cage or of its segments: windows with a fore and an aft face, pairs
/// of guide faces (record 7.3), or round pockets. Geometry of contact/roller_pocket.hpp.
///
/// Normal load of a slice, δ = -gap: on faces K_l L^(-1/9) w δ^(10/9), K_l of both materials
/// (contact/line_contact.hpp), in round pockets the elastic foundation of contact/conformal.hpp.
/// Friction at the same point: slip u = cage velocity - roller velocity there without its part
/// along m, N κ(s)/s u on the roller, s the rounded slip; the cage gets the opposite. Heat =
/// friction · u. With damping (contact_damping.hpp) N is the total force; of slices d(gap)/dt is
/// the power of the elastic force over N, what leans included. Ends of the pockets (decision 213):
/// planes across the pocket's x, half of clearance I away from the ends of the nominal roller in
/// its middle; Hertz load of the corner as a sphere. They keep the cage on its rollers, and are no
/// guide surfaces of the outputs (N105). Limits: the middle of the roller stays between faces and
/// ends and within half a diameter of the wall. A pocket that is cut between two segments is two
/// halves (contact/cage_pieces.hpp): each has the faces on its side and half the stiffness of both
/// ends; its open side holds nothing. Limit: the roller stays within a diameter of the middle
/// there.
namespace adore::dynamics {

struct RollerPocket {
  contact::PocketFrame frame;
  std::vector<contact::PocketFace> faces;  ///< none: round
  std::optional<contact::RoundPocket> round;
  double half_window = 0.0;          ///< least distance of a wall from the middle along y [m]
  double z_low = 0.0, z_high = 0.0;  ///< ends of the wall [m]
  std::array<double, 2> end_wall{};  ///< of the ends at -x and +x, from the middle [m]
  std::size_t element = 0, segment = 0;
  int half = 0;
};

/// Slices of one roller.
struct PocketRoller {
  std::vector<contact::RollerSlice> slices;
  contact::RollerBounds bounds;
  double slice_width = 0.0;
  std::array<contact::RollerEnd, 2> end;
  std::array<double, 2> end_constant{};  ///< Q = K δ^1.5 at the ends of the pocket [N m^-1.5]
};

/// Losses of both kinds of contacts in a pocket.
struct RollerPocketDamping {
  contact::DampingLaw<> slice, end;
};

class RollerPocketSet {
 public:
  RollerPocketSet(const SceneBuilder& scene, const std::vector<contact::SegmentPocket>& placed);

  [[nodiscard]] std::size_t size() const noexcept { return pockets_.size(); }
  [[nodiscard]] double mass_offset() const noexcept { return mass_offset_; }
  [[nodiscard]] std::size_t element(std::size_t i) const noexcept { return pockets_[i].element; }
  [[nodiscard]] std::size_t segment(std::size_t i) const noexcept { return pockets_[i].segment; }
  /// Mid length of roller i and its axis in its pocket frame.
  struct Place {
    Vec3 q, u;
    Mat3 to_base;  ///< pocket -> base
  };
  [[nodiscard]] Place locate(const Evaluation& e, std::size_t i) const noexcept {
    const RollerPocket& pocket = pockets_[i];
    const BodyState& cage = e.segments[pocket.segment];
    const Vec3 a = e.attitude[pocket.element].col(0);
    const Vec3 C = e.element_centre(pocket.element) - mass_offset_ * a;
    const Mat3 to_base = cage.to_base * pocket.frame.cage_to_pocket.transpose();
    const Vec3 in_cage = cage.to_base.transpose() * (C - cage.position);
    return {pocket.frame.cage_to_pocket * (in_cage - pocket.frame.centre), to_base.transpose() * a,
            to_base};
  }
  [[nodiscard]] bool is_inside(std::size_t i, const Vec3& q) const noexcept {
    const RollerPocket& pocket = pockets_[i];
    const double reach = pocket.half * q[1] < 0.0 ? 2.0 * radius_ : pocket.half_window;
    return std::abs(q[0]) < std::min(pocket.end_wall[0], pocket.end_wall[1]) &&
           std::abs(q[1]) < reach && q[2] > pocket.z_low - radius_ &&
           q[2] < pocket.z_high + radius_;
  }
  [[nodiscard]] std::size_t surfaces(std::size_t i) const noexcept {
    return pockets_[i].round ? 1 : pockets_[i].faces.size();
  }
  /// Slices on all surfaces, and both ends, of all pockets.
  [[nodiscard]] std::size_t max_contact_count() const noexcept {
    std::size_t out = 0;
    for (std::size_t i = 0; i < size(); ++i) out += surfaces(i) * roller_of(i).slices.size() + 2;
    return out;
  }
  /// Does the cut leave surface k?
  [[nodiscard]] bool has_surface(std::size_t i, std::size_t k) const noexcept {
    const RollerPocket& pocket = pockets_[i];
    return pocket.half == 0 || pocket.round || pocket.half * pocket.faces[k].normal[1] > 0.0;
  }
  /// Is surface k farther than `reach` from the roller, whatever its slices?
  [[nodiscard]] bool is_certainly_open(std::size_t i, std::size_t k, const Place& at,
                                       double reach = 0.0) const noexcept {
    const RollerPocket& pocket = pockets_[i];
    const PocketRoller& roller = roller_of(i);
    return (pocket.round ? contact::gap_bound(*pocket.round, at.q, at.u, roller.bounds)
                         : contact::gap_bound(pocket.faces[k], at.q, at.u, roller.bounds)) > reach;
  }
  /// Of the roller against the wall, and the width of a slice [m].
  [[nodiscard]] double reduced_radius(std::size_t i) const noexcept {
    const RollerPocket& pocket = pockets_[i];
    constexpr double kMostConforming = 100.0;
    if (!pocket.round) return radius_;
    return std::min(1.0 / std::max(1.0 / radius_ - 1.0 / pocket.round->radius, 1e-30),
                    kMostConforming * radius_);
  }
  [[nodiscard]] double slice_width(std::size_t i) const noexcept {
    return roller_of(i).slice_width;
  }
  /// Never more than the gaps of the slices at a surface; of a round pocket no bound is known.
  struct SliceGapBound {
    double middle, lean;
    [[nodiscard]] double operator()(const contact::RollerSlice& slice) const noexcept {
      return middle - slice.s * lean - slice.radius;
    }
  };
  [[nodiscard]] SliceGapBound slice_gap_bound(std::size_t i, std::size_t k,
                                              const Place& at) const noexcept {
    constexpr double kRounding = 1e-15;  // [m]
    const RollerPocket& pocket = pockets_[i];
    if (pocket.round) return {-std::numeric_limits<double>::infinity(), 0.0};
    const contact::PocketFace& face = pocket.faces[k];
    return {face.normal.dot(face.centre - at.q) - kRounding, face.normal.dot(at.u)};
  }
  /// visit(slice, load [N], energy [J]) of every slice of a surface that may be as near as `reach`.
  template <class Visit>
  void for_slices(std::size_t i, std::size_t k, const Place& at, double reach,
                  const Visit& visit) const {
    const RollerPocket& pocket = pockets_[i];
    const PocketRoller& roller = roller_of(i);
    const SliceGapBound bound = slice_gap_bound(i, k, at);
    for (const contact::RollerSlice& slice : roller.slices) {
      if (bound(slice) > reach) continue;
      const Vec3 p = at.q + slice.s * at.u;
      if (pocket.round) {
        const contact::PocketSlice c =
            contact::slice_in_round_pocket(*pocket.round, p, at.u, slice.radius);
        const contact::LandLaw law{E_star_, pocket.round->radius_at(slice.s) - slice.radius};
        const double e = law.clearance - c.gap;
        const bool open = !(c.gap < 0.0);
        visit(c, open ? 0.0 : roller.slice_width * contact::land_load_per_length(law, e),
              open ? 0.0 : roller.slice_width * contact::land_energy_per_length(law, e));
        continue;
      }
      const contact::PocketSlice c =
          contact::slice_at_face(pocket.faces[k], p, at.u, slice.radius, 0.5 * roller.slice_width);
      const double width = c.fraction * roller.slice_width;
      const double load = contact::slice_load(law_, width, -c.gap).load;
      visit(c, load, -(9.0 / 19.0) * load * c.gap);
    }
  }
  /// visit(touch, load [N], energy [J]) of both ends of a pocket that are touched.
  template <class Visit>
  void for_ends(std::size_t i, const Place& at, const Visit& visit) const {
    const PocketRoller& roller = roller_of(i);
    for (std::size_t k = 0; k < 2; ++k) {
      if (contact::end_gap_bound(roller.end[k], pockets_[i].end_wall[k], at.q, at.u) > 0.0)
        continue;
      const contact::RollerEndContact touch =
          contact::end_contact_at_wall(roller.end[k], pockets_[i].end_wall[k], at.q, at.u);
      if (!(touch.gap < 0.0)) continue;
      const double share = pockets_[i].half == 0 ? 1.0 : 0.5;
      const double load = contact::hertz_load(share * roller.end_constant[k], -touch.gap);
      visit(touch, load, -0.4 * load * touch.gap);
    }
  }
  /// Force, gap and angle of every surface of pocket i; replaces the content of `out`.
  void report(std::size_t i, const Place& at, std::vector<PocketContactSnapshot>& out) const;

 private:
  /// The slice that is nearest to surface k.
  struct Nearest {
    double gap = std::numeric_limits<double>::infinity(), position = 0.0;  ///< [m]
    Vec3 m = Vec3::Zero();
  };
  [[nodiscard]] Nearest nearest(std::size_t i, std::size_t k, const Place& at) const;
  [[nodiscard]] const PocketRoller& roller_of(std::size_t i) const noexcept {
    return rollers_[rollers_.size() == 1 ? 0 : pockets_[i].element];
  }
  std::vector<RollerPocket> pockets_;
  std::vector<PocketRoller> rollers_;  ///< one for all, or one by roller
  contact::PowerLaw law_;
  double E_star_ = 0.0, mass_offset_ = 0.0, radius_ = 0.0, rotation_sign_ = 1.0;
};

}  // namespace adore::dynamics
