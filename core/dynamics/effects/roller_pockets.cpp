#include "base/errors.hpp"
#include "contact/ball_pocket.hpp"
#include "contact/cage_pieces.hpp"
#include "contact/conformal.hpp"
#include "contact/line_contact.hpp"
#include "contact/roller_flange.hpp"
#include "contact/roller_pocket.hpp"
#include "contact/roller_pocket_play.hpp"
#include "contact/roller_shape.hpp"
#include "dynamics/effect_makers.hpp"
#include "dynamics/effects/contact_damping.hpp"
#include "dynamics/effects/pockets.hpp"
#include "dynamics/effects/scene_pieces.hpp"
#include "dynamics/roller_start.hpp"
#include "tribology/cage_oil.hpp"
#include "tribology/pocket_film.hpp"
#include "tribology/traction_law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>

/// Rollers in the pockets of a cage or of its segments: windows with a fore and an aft face, pairs
/// of guide faces (record 7.3), or round pockets. Geometry of contact/roller_pocket.hpp.
///
/// Normal load of a slice, δ = -gap: on faces K_l L^(-1/9) w δ^(10/9), K_l of both materials
/// (contact/line_contact.hpp), in round pockets the elastic foundation of contact/conformal.hpp.
/// Friction at the same point: slip u = cage velocity - roller velocity there without its part
/// along m, N κ(s)/s u on the roller, s the rounded slip; the cage gets the opposite. Heat =
/// friction · u.
/// Ends of the pockets (decision 213): planes across the pocket's x, half of clearance I away from
/// the ends of the nominal roller in its middle; Hertz load of the corner as a sphere. They keep
/// the cage on its rollers, and are no guide surfaces of the outputs (N105). Limits: the middle of
/// the roller stays between faces and ends and within half a diameter of the wall.
/// A pocket that is cut between two segments is two halves (contact/cage_pieces.hpp): each has the
/// faces on its side and half the stiffness of both ends; its open side holds nothing. Limit: the
/// roller stays within a diameter of the middle there.
namespace adore::dynamics {
namespace {

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

class RollerPocketSet {
 public:
  RollerPocketSet(const SceneBuilder& scene, const std::vector<contact::PlacedPocket>& placed);

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
  [[nodiscard]] std::size_t most_contacts() const noexcept {
    std::size_t out = 0;
    for (std::size_t i = 0; i < size(); ++i) out += surfaces(i) * roller_of(i).slices.size() + 2;
    return out;
  }
  /// Does the cut leave surface k?
  [[nodiscard]] bool is_there(std::size_t i, std::size_t k) const noexcept {
    const RollerPocket& pocket = pockets_[i];
    return pocket.half == 0 || pocket.round || pocket.half * pocket.faces[k].normal[1] > 0.0;
  }
  /// Is surface k farther than `reach` from the roller, whatever its slices?
  [[nodiscard]] bool surely_open(std::size_t i, std::size_t k, const Place& at,
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
  struct SliceBound {
    double middle, lean;
    [[nodiscard]] double operator()(const contact::RollerSlice& slice) const noexcept {
      return middle - slice.s * lean - slice.radius;
    }
  };
  [[nodiscard]] SliceBound slice_bound(std::size_t i, std::size_t k,
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
    const SliceBound bound = slice_bound(i, k, at);
    for (const contact::RollerSlice& slice : roller.slices) {
      if (bound(slice) > reach) continue;
      const Vec3 p = at.q + slice.s * at.u;
      if (pocket.round) {
        const contact::PocketSlice c =
            contact::slice_in_round(*pocket.round, p, at.u, slice.radius);
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
      const contact::EndTouch touch =
          contact::end_at_wall(roller.end[k], pockets_[i].end_wall[k], at.q, at.u);
      if (!(touch.gap < 0.0)) continue;
      const double share = pockets_[i].half == 0 ? 1.0 : 0.5;
      const double load = contact::hertz_load(share * roller.end_constant[k], -touch.gap);
      visit(touch, load, -0.4 * load * touch.gap);
    }
  }
  [[nodiscard]] std::vector<PocketContactSnapshot> report(std::size_t i, const Place& at) const;

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

RollerPocketSet::RollerPocketSet(const SceneBuilder& scene,
                                 const std::vector<contact::PlacedPocket>& placed) {
  const bearing::Bearing& bearing = scene.bearing;
  const bearing::RollerGeometry& rollers = *bearing.rollers();
  const bearing::Cage& cage = *bearing.cage;
  const double D = rollers.diameter;
  mass_offset_ = bearing.roller_mass_offset;
  radius_ = 0.5 * D;
  rotation_sign_ = nominal_cage_speed(bearing) < 0.0 ? -1.0 : 1.0;
  E_star_ = bearing::contact_modulus(bearing.element_material, cage.material);
  law_ = contact::power_law(contact::line_constant(E_star_), rollers.length);
  const int count = scene.rollers->options.slices;
  const std::size_t shapes =
      rollers.deviation.empty() ? 1 : static_cast<std::size_t>(rollers.count);
  for (std::size_t i = 0; i < shapes; ++i) {
    const contact::RollerProfile profile =
        contact::roller_profile(rollers, rollers.deviation_of(i));
    PocketRoller roller;
    roller.slices = contact::pocket_slices(profile, count);
    roller.slice_width = profile.length / count;
    const double half = 0.5 * profile.length, taper = half * std::tan(profile.half_angle);
    roller.bounds = {half, 0.5 * profile.diameter + taper, 0.5 * profile.diameter - taper};
    for (std::size_t k = 0; k < 2; ++k) {
      roller.end[k] = contact::roller_end(profile, static_cast<int>(k));
      roller.end_constant[k] = 4.0 / 3.0 * E_star_ *
                               std::sqrt(std::max(roller.end[k].corner_radius, contact::kEdgeTube));
    }
    rollers_.push_back(std::move(roller));
  }
  const contact::RollerProfile ideal = contact::roller_profile(rollers);
  const std::array<contact::RollerEnd, 2> nominal{contact::roller_end(ideal, 0),
                                                  contact::roller_end(ideal, 1)};
  for (const contact::PlacedPocket& place : placed) {
    const bearing::PocketDeviation own = cage.deviation_of(place.element);
    const auto [low, high] = contact::wall_height(cage.outer_diameter, cage.inner_diameter,
                                                  rollers.pitch_diameter, own.thickness);
    const double width = D + cage.pocket_clearance_1 + own.clearance[0];
    RollerPocket pocket;
    pocket.element = place.element;
    pocket.segment = static_cast<std::size_t>(place.piece);
    pocket.half = place.half;
    pocket.frame = contact::pocket_frame({place.azimuth + own.angular, 0.5 * rollers.pitch_diameter,
                                          own.axial, cage.cone_angle, own.tilt});
    pocket.z_low = low;
    pocket.z_high = high;
    pocket.half_window = 0.5 * width;
    // The nominal roller has half of the clearance at each end, however it lies in its pocket.
    const Vec3 axis = passive_y(cage.cone_angle) *
                      Vec3(std::cos(rollers.axis_angle), 0.0, -std::sin(rollers.axis_angle));
    for (std::size_t k = 0; k < 2; ++k)
      pocket.end_wall[k] =
          0.5 * (width - D) - contact::end_at_wall(nominal[k], 0.0, Vec3::Zero(), axis).gap;
    if (!cage.pocket_faces.empty())
      pocket.faces = contact::paired_faces(contact::widened(cage.pocket_faces, own.clearance[0]),
                                           rotation_sign_);
    else if (cage.pocket == bearing::PocketShape::Cylindrical)
      pocket.round = contact::RoundPocket{0.5 * width,
                                          low,
                                          high,
                                          place.half,
                                          contact::cut_edge(cage, rollers.pitch_diameter),
                                          std::tan(rollers.half_angle),
                                          std::cos(rollers.half_angle)};
    else
      pocket.faces = contact::window_faces(width, low, high, rotation_sign_, rollers.half_angle);
    pockets_.push_back(std::move(pocket));
  }
}

RollerPocketSet::Nearest RollerPocketSet::nearest(std::size_t i, std::size_t k,
                                                  const Place& at) const {
  Nearest out;
  const auto take = [&out](const contact::PocketSlice& slice) {
    out = {slice.gap, slice.position, slice.m};
  };
  const RollerPocket& pocket = pockets_[i];
  if (pocket.round || std::isfinite(pocket.faces[k].half_length)) {
    for_slices(i, k, at, out.gap, [&](const contact::PocketSlice& slice, double, double) {
      if (slice.fraction > 0.0 && slice.gap < out.gap) take(slice);
    });
    return out;
  }
  const contact::PocketFace& face = pocket.faces[k];
  const std::vector<contact::RollerSlice>& slices = roller_of(i).slices;
  const auto gap_of = [&](const contact::RollerSlice& slice) {
    return contact::gap_at_face(face, at.q + slice.s * at.u, at.u, slice.radius);
  };
  const SliceBound bound = slice_bound(i, k, at);
  const double enough = gap_of(*std::min_element(
      slices.begin(), slices.end(),
      [&](const auto& one, const auto& other) { return bound(one) < bound(other); }));
  const contact::RollerSlice* best = nullptr;
  for (const contact::RollerSlice& slice : slices) {
    if (bound(slice) > enough) continue;
    const double gap = gap_of(slice);
    if (gap >= out.gap) continue;
    out.gap = gap;
    best = &slice;
  }
  if (best != nullptr)
    take(contact::slice_at_face(face, at.q + best->s * at.u, at.u, best->radius,
                                0.5 * roller_of(i).slice_width));
  return out;
}

std::vector<PocketContactSnapshot> RollerPocketSet::report(std::size_t i, const Place& at) const {
  std::vector<PocketContactSnapshot> out;
  out.reserve(surfaces(i));
  for (std::size_t k = 0; k < surfaces(i); ++k) {
    PocketContactSnapshot& one = out.emplace_back();
    if (!is_there(i, k)) continue;
    double moment = 0.0;
    for_slices(i, k, at, 0.0, [&](const contact::PocketSlice& slice, double load, double) {
      one.force += load;
      moment += load * slice.position;
    });
    const Nearest nearest = this->nearest(i, k, at);
    one.gap = nearest.gap;
    one.position = one.force > 0.0 ? moment / one.force : nearest.position;
    one.theta = contact::round_pocket_angle(nearest.m, rotation_sign_);
  }
  return out;
}

template <bool Traction>
class RollerPocketBlock final : public EffectBlock {
 public:
  RollerPocketBlock(const RollerPocketSet& set, const tribology::TractionLaw& law, double& heat)
      : set_(set), law_(law), heat_(heat) {
    if (law.is_of_user()) asked_.reserve(set.most_contacts());
  }
  void apply(Evaluation& e) noexcept override {
    if constexpr (Traction)
      law_.visit_rounded([&](const auto& friction) {
        in_passes(asked_, friction, [&](const auto& law) { apply_with(law, e); });
      });
    else
      apply_with(nullptr, e);
  }

 private:
  template <class Friction>
  void apply_with(const Friction& friction, Evaluation& e) noexcept {
    for (std::size_t i = 0; i < set_.size(); ++i) {
      const RollerPocketSet::Place at = set_.locate(e, i);
      if (!set_.is_inside(i, at.q)) {
        e.valid = false;
        return;
      }
      for (std::size_t k = 0; k < set_.surfaces(i); ++k) {
        if (!set_.is_there(i, k) || set_.surely_open(i, k, at)) continue;
        set_.for_slices(i, k, at, 0.0,
                        [&](const contact::PocketSlice& slice, double load, double energy) {
                          if (!(load > 0.0)) return;
                          push(friction, e, i, at, slice.m, slice.point, load, energy);
                          if (!kOnlyNotes<Friction> && !slice.aside.isZero(0.0))
                            lean(e, i, at, slice, load);
                        });
      }
      set_.for_ends(i, at, [&](const contact::EndTouch& touch, double load, double energy) {
        push(friction, e, i, at, touch.out, touch.point, load, energy);
      });
    }
  }
  /// A contact of load on roller i at a point, both in the pocket frame.
  template <class Friction>
  void push(const Friction& friction, Evaluation& e, std::size_t i,
            const RollerPocketSet::Place& at, const Vec3& into, const Vec3& point, double load,
            double energy) noexcept;
  /// What a leaning slice is pushed aside (contact/roller_pocket.hpp).
  void lean(Evaluation& e, std::size_t i, const RollerPocketSet::Place& at,
            const contact::PocketSlice& slice, double load) noexcept;

  const RollerPocketSet& set_;
  tribology::TractionLaw law_;
  GatheredTraction asked_;
  double& heat_;
};

template <bool Traction>
template <class Friction>
void RollerPocketBlock<Traction>::push(const Friction& friction, Evaluation& e, std::size_t i,
                                       const RollerPocketSet::Place& at, const Vec3& into,
                                       const Vec3& point, double load, double energy) noexcept {
  BodyState& cage = e.segments[set_.segment(i)];
  const std::size_t roller = set_.element(i);
  const Vec3 m = at.to_base * into;
  const Vec3 arm = at.to_base * (point - at.q) - set_.mass_offset() * e.attitude[roller].col(0);
  const Vec3 X = e.element_centre(roller) + arm;
  Vec3 f = -load * m;
  if constexpr (Traction) {
    Vec3 slip =
        cage.velocity_at(X) - e.element_velocity(roller) - e.element_omega(roller).cross(arm);
    slip -= slip.dot(m) * m;
    const double square = slip.squaredNorm(), per_slip = friction_over_slip(friction, load, square);
    if constexpr (kOnlyNotes<Friction>) return;
    f += per_slip * slip;
    heat_ += per_slip * square;
    cage.load_slip += load * std::sqrt(square);
  }
  e.add_force(roller, e.to_cylindrical(roller, f));
  e.add_moment(roller, e.to_cylindrical(roller, arm.cross(f)));
  cage.add_force(-f, X);
  e.elastic += energy;
}

template <bool Traction>
void RollerPocketBlock<Traction>::lean(Evaluation& e, std::size_t i,
                                       const RollerPocketSet::Place& at,
                                       const contact::PocketSlice& slice, double load) noexcept {
  const std::size_t roller = set_.element(i);
  const Vec3 arm =
      at.to_base * (slice.middle - at.q) - set_.mass_offset() * e.attitude[roller].col(0);
  const Vec3 f = at.to_base * (load * slice.aside);
  e.add_force(roller, e.to_cylindrical(roller, f));
  e.add_moment(roller, e.to_cylindrical(roller, arm.cross(f)));
  e.segments[set_.segment(i)].add_force(-f, e.element_centre(roller) + arm);
}

/// A contact that ADRX3 is asked for: one slice, or one end of a pocket.
struct UserTouch {
  std::size_t pocket = 0, roller = 0;
  bool at_end = false;
  Vec3 point, normal;  ///< into the wall
  Vec3 middle, aside;  ///< of a leaning slice, per newton; zero
  Vec3 friction, arm;  ///< on the roller; from its mass centre to the point
  double slip = 0.0, heat = 0.0;
};
using UserTouches = UserForces<UserTouch>;

/// ADRX3 or damping (user_forces.hpp): every slice, and both ends of a pocket, whose surfaces are
/// numbered behind those of its wall.
class UserRollerPocketBlock final : public EffectBlock {
 public:
  UserRollerPocketBlock(const RollerPocketSet& set, const tribology::TractionLaw* friction,
                        UserTouches& forces, double& heat, double& along)
      : set_(set), forces_(forces), heat_(heat), along_(along) {
    if (friction != nullptr) friction_ = *friction;
  }
  void apply(Evaluation& e) noexcept override {
    if (friction_)
      friction_->visit_rounded([&](const auto& friction) {
        in_passes(asked_, friction, [&](const auto& law) { collect_all(law, e); });
      });
    else
      collect_all(nullptr, e);
    const bool valid =
        forces_.ask(e.t, [&](const UserTouch& touch, double more, double difference, double rate) {
          BodyState& cage = e.segments[set_.segment(touch.pocket)];
          const Vec3 f = more * touch.friction - difference * touch.normal;
          add(e, cage, touch.roller, f, touch.arm);
          if (!touch.aside.isZero(0.0))
            add(e, cage, touch.roller, difference * touch.aside, touch.middle);
          cage.load_slip += difference * touch.slip;
          heat_ += more * touch.heat;
          along_ -= difference * rate;
        });
    if (!valid) e.valid = false;
  }

 private:
  static void add(Evaluation& e, BodyState& cage, std::size_t roller, const Vec3& f,
                  const Vec3& arm) noexcept {
    e.add_force(roller, e.to_cylindrical(roller, f));
    e.add_moment(roller, e.to_cylindrical(roller, arm.cross(f)));
    cage.add_force(-f, e.element_centre(roller) + arm);
  }
  template <class Friction>
  void collect_all(const Friction& friction, const Evaluation& e) noexcept {
    forces_.clear();
    for (std::size_t i = 0; i < set_.size(); ++i) {
      const RollerPocketSet::Place at = set_.locate(e, i);
      if (!set_.is_inside(i, at.q)) continue;
      for (std::size_t k = 0; k < set_.surfaces(i); ++k) {
        if (!set_.is_there(i, k) || set_.surely_open(i, k, at)) continue;
        set_.for_slices(i, k, at, 0.0, [&](const contact::PocketSlice& slice, double load, double) {
          if (load > 0.0 && slice.gap < 0.0)
            collect(friction, e, i, at, k, slice.m, slice.point, slice.middle, slice.aside,
                    slice.gap, load);
        });
      }
      set_.for_ends(i, at, [&](const contact::EndTouch& touch, double load, double) {
        const std::size_t surface = set_.surfaces(i) + (touch.out[0] > 0.0 ? 1 : 0);
        collect(friction, e, i, at, surface, touch.out, touch.point, Vec3::Zero(), Vec3::Zero(),
                touch.gap, load);
      });
    }
  }
  /// Geometry in the pocket frame.
  template <class Friction>
  void collect(const Friction& friction, const Evaluation& e, std::size_t i,
               const RollerPocketSet::Place& at, std::size_t surface, const Vec3& into,
               const Vec3& point, const Vec3& middle, const Vec3& aside, double gap,
               double load) noexcept {
    const BodyState& cage = e.segments[set_.segment(i)];
    const std::size_t roller = set_.element(i);
    const Vec3 to_mass = set_.mass_offset() * e.attitude[roller].col(0);
    UserTouch t;
    t.pocket = i;
    t.roller = roller;
    t.at_end = surface >= set_.surfaces(i);
    t.normal = at.to_base * into;
    t.arm = at.to_base * (point - at.q) - to_mass;
    t.middle = at.to_base * (middle - at.q) - to_mass;
    t.aside = at.to_base * aside;
    t.friction.setZero();
    const auto apart = [&](const Vec3& arm) -> Vec3 {  // cage - roller velocity
      return cage.velocity_at(e.element_centre(roller) + arm) - e.element_velocity(roller) -
             e.element_omega(roller).cross(arm);
    };
    const Vec3 u = apart(t.arm);
    double rate = u.dot(t.normal);
    if (!aside.isZero(0.0)) rate -= apart(t.middle).dot(t.aside);
    if constexpr (!std::is_null_pointer_v<Friction>) {
      const Vec3 slip = u - u.dot(t.normal) * t.normal;
      const double square = slip.squaredNorm(),
                   per_slip = friction_over_slip(friction, load, square);
      t.friction = per_slip * slip;
      t.slip = std::sqrt(square);
      t.heat = per_slip * square;
    }
    forces_.collect(t, roller, surface, gap, rate, load);
  }

  const RollerPocketSet& set_;
  std::optional<tribology::TractionLaw> friction_;
  GatheredTraction asked_;
  UserTouches& forces_;
  double &heat_, &along_;
};

/// Films in the pockets of rollers (kPocHydro), slice by slice: wedge of a line contact, entrained
/// with half the slip, squeeze of a cylinder and shear (tribology/pocket_film.hpp), with the reach,
/// fading and least film of those of balls (cage_films.cpp, decision 304). The ends of the pockets
/// have none.
struct RollerPocketOil {
  double viscosity = 0.0, largest = 0.0, critical = 0.0;

  struct Action {
    Vec3 m, arm, point, slip, force;  ///< base axes; force on the roller
    double stiffness = 0.0, squeeze = 0.0, shear = 0.0;
  };
  [[nodiscard]] Action at(const RollerPocketSet& set, const Evaluation& e, std::size_t i,
                          const RollerPocketSet::Place& place,
                          const contact::PocketSlice& slice) const noexcept {
    Action out;
    const BodyState& cage = e.segments[set.segment(i)];
    const std::size_t roller = set.element(i);
    const double width = slice.fraction * set.slice_width(i), R = set.reduced_radius(i);
    const double above = slice.gap - critical, half = 0.5 * critical;
    const double h = above >= half    ? slice.gap
                     : above <= -half ? critical
                                      : critical + (above + half) * (above + half) / (4.0 * half);
    const double s = std::clamp(2.0 * (1.0 - slice.gap / largest), 0.0, 1.0);
    const double fade = s * s * (3.0 - 2.0 * s), fade_slope = 12.0 * s * (1.0 - s) / largest;
    out.m = place.to_base * slice.m;
    out.arm =
        place.to_base * (slice.point - place.q) - set.mass_offset() * e.attitude[roller].col(0);
    out.point = e.element_centre(roller) + out.arm;
    out.slip = e.element_velocity(roller) + e.element_omega(roller).cross(out.arm) -
               cage.velocity_at(out.point);
    const double closing = out.slip.dot(out.m);  // -dh/dt, a roller's own spin is across m
    const Vec3 sliding = out.slip - closing * out.m;
    const double wedge = tribology::line_wedge(viscosity, 0.5 * sliding.norm(), R, width, h);
    const double squeeze = tribology::cylinder_squeeze(viscosity, R, width, h, -closing);
    out.shear = fade * tribology::line_shear(viscosity, 1.0, R, width, h);
    out.squeeze = fade * tribology::cylinder_squeeze(viscosity, R, width, h, -1.0);
    out.stiffness = fade * (wedge + 1.5 * squeeze) / h + fade_slope * (wedge + squeeze);
    out.force = -out.shear * sliding - fade * (wedge + squeeze) * out.m;
    return out;
  }
  /// visit(action) of all slices that are near enough.
  template <class Visit>
  void for_films(const RollerPocketSet& set, const Evaluation& e, std::size_t i,
                 const Visit& visit) const {
    const RollerPocketSet::Place place = set.locate(e, i);
    if (!set.is_inside(i, place.q)) return;
    for (std::size_t k = 0; k < set.surfaces(i); ++k) {
      if (!set.is_there(i, k) || set.surely_open(i, k, place, largest)) continue;
      set.for_slices(i, k, place, largest, [&](const contact::PocketSlice& slice, double, double) {
        if (slice.gap < largest && slice.fraction > 0.0) visit(at(set, e, i, place, slice));
      });
    }
  }
};

class RollerPocketFilmBlock final : public EffectBlock {
 public:
  RollerPocketFilmBlock(const RollerPocketSet& set, const RollerPocketOil& oil, double& heat)
      : set_(set), oil_(oil), heat_(heat) {}
  void apply(Evaluation& e) noexcept override {
    heat_ = 0.0;
    for (std::size_t i = 0; i < set_.size(); ++i) {
      const std::size_t roller = set_.element(i);
      oil_.for_films(set_, e, i, [&](const RollerPocketOil::Action& a) {
        e.add_force(roller, e.to_cylindrical(roller, a.force));
        e.add_moment(roller, e.to_cylindrical(roller, a.arm.cross(a.force)));
        e.segments[set_.segment(i)].add_force(-a.force, a.point);
        heat_ -= a.force.dot(a.slip);
      });
    }
  }

 private:
  const RollerPocketSet& set_;
  const RollerPocketOil& oil_;
  double& heat_;
};

class RollerPockets final : public SceneEffect, public ElementSupport {
 public:
  void declare(SceneBuilder& scene) override {
    demand(scene.plan.has(Effect::CageMotion), "the plan has cage contacts but no cage motion");
    demand(scene.rollers != nullptr, "roller pockets need rollers");
    const bool traction = scene.plan.has(Effect::PocketTraction);
    demand(!traction || scene.bearing.pocket_traction.has_value(),
           "pocket traction is on without a traction curve");
    constexpr std::string_view kCost = "pocket contacts";
    const OtherForce other =
        other_force(scene, scene.options.user ? scene.options.user->pocket : nullptr,
                    "user routine ADRX3", heat_);
    if (traction || other.of_user) scene.block<NoHeatYet>(Phase::Force, kCost, {}, heat_);
    std::optional<tribology::TractionLaw> friction;
    if (traction)
      friction =
          traction_of(scene, tribology::TractionKind::ElementCage, *scene.bearing.pocket_traction);
    const contact::CagePieces pieces = pieces_of(scene);
    const auto add = [&](std::optional<RollerPocketSet>& set,
                         const std::vector<contact::PlacedPocket>& pockets,
                         std::optional<UserTouches>& forces) {
      set.emplace(scene, pockets);
      std::vector<BodyId> partners(pieces.pockets.size(), BodyId{BodyId::Kind::Segment, -1});
      for (const contact::PlacedPocket& pocket : pockets)
        partners[pocket.element].index = pocket.piece;
      std::vector<BodyId> same = partners;
      if (friction)
        scene.block<RollerPocketBlock<true>>(Phase::Force, kCost, Partners(std::move(partners)),
                                             *set, *friction, heat_);
      else
        scene.block<RollerPocketBlock<false>>(Phase::Force, kCost, Partners(std::move(partners)),
                                              *set, tribology::TractionLaw(), heat_);
      if (other.routine == nullptr) return;
      forces.emplace(*other.routine, set->most_contacts());
      scene.block<UserRollerPocketBlock>(Phase::Force, other.cost, Partners(std::move(same)), *set,
                                         friction ? &*friction : nullptr, *forces, heat_,
                                         *other.along);
    };
    add(set_, pieces.pockets, forces_[0]);
    if (!pieces.last_halves.empty()) add(last_halves_, pieces.last_halves, forces_[1]);
    if (traction || other.of_user) scene.energy("pockets.heat", kPocketHeat, &heat_);
    if (scene.plan.has(Effect::PocketFilm)) {  // of a cage of one piece
      const bearing::CageFilms& films = *scene.bearing.cage_films;
      oil_.emplace();
      oil_->viscosity = tribology::film_viscosity(scene.bearing, films.pocket_viscosity);
      oil_->largest = films.largest_pocket_film;
      oil_->critical = std::min(films.critical_film, 0.25 * films.largest_pocket_film);
      scene.block<RollerPocketFilmBlock>(Phase::Force, "films of the cage",
                                         BodyId{BodyId::Kind::Segment, 0}, *set_, *oil_,
                                         film_heat_);
      scene.energy("pocket films.heat", *pocket_film_terms()[0], &film_heat_);
    }
    scene.supports(*this);
  }

  [[nodiscard]] std::string why_invalid(const Evaluation& e) const override {
    for (const auto* set : {&set_, &last_halves_}) {
      if (!set->has_value()) continue;
      for (std::size_t i = 0; i < (*set)->size(); ++i) {
        const RollerPocketSet::Place at = (*set)->locate(e, i);
        if ((*set)->is_inside(i, at.q)) continue;
        return fmt::format(
            "the middle of roller {} is outside its cage pocket (axial {:.4g} m, against the "
            "rotation {:.4g} m, radial {:.4g} m from the pocket centre); check the cage's start "
            "position, its pocket clearance and the largest step",
            (*set)->element(i) + 1, at.q[0], at.q[1], at.q[2]);
      }
    }
    return {};
  }

  /// dN/dδ m mᵀ of what is touched.
  void resist(const Evaluation& e, std::size_t i, Mat3& stiffness) noexcept override {
    resist(*set_, i, e, stiffness);
    for (std::size_t k = 0; last_halves_ && k < last_halves_->size(); ++k)
      if (last_halves_->element(k) == i) resist(*last_halves_, k, e, stiffness);
    if (!oil_) return;
    oil_->for_films(*set_, e, i, [&](const RollerPocketOil::Action& a) {
      const Vec3 m = e.to_cylindrical(i, a.m);
      stiffness += a.stiffness * m * m.transpose();
    });
  }
  /// Of the films.
  void damp(const Evaluation& e, std::size_t i, Eigen::Matrix2d& damping) noexcept override {
    if (!oil_) return;
    oil_->for_films(*set_, e, i, [&](const RollerPocketOil::Action& a) {
      const Eigen::Vector2d m = e.to_cylindrical(i, a.m).head<2>();
      damping += a.shear * Eigen::Matrix2d::Identity() + a.squeeze * m * m.transpose();
    });
  }

  void report(const Evaluation& e, Snapshot& snapshot) const override {
    for (std::size_t i = 0; i < e.elements.n; ++i) {
      const RollerPocketSet::Place at = set_->locate(e, i);
      snapshot.elements[i].pocket = set_->report(i, at);
      snapshot.elements[i].pocket_to_centre = at.q;
    }
    const auto add_user = [](const std::optional<UserTouches>& forces, const auto& pocket) {
      if (forces)
        forces->for_differences(
            [&](const UserTouch& touch, std::size_t surface, double difference) {
              if (!touch.at_end) pocket(touch.pocket).at(surface).force += difference;
            });
    };
    add_user(
        forces_[0], [&](std::size_t i) -> auto& { return snapshot.elements[i].pocket; });
    if (!last_halves_) return;
    snapshot.cages.resize(last_halves_->size());
    const auto last_half = [&](std::size_t i) -> auto& {
      return snapshot.cages[last_halves_->segment(i)].last_half;
    };
    for (std::size_t i = 0; i < last_halves_->size(); ++i)
      last_half(i) = last_halves_->report(i, last_halves_->locate(e, i));
    add_user(forces_[1], last_half);
  }

 private:
  static void resist(const RollerPocketSet& set, std::size_t i, const Evaluation& e,
                     Mat3& stiffness) noexcept {
    const RollerPocketSet::Place at = set.locate(e, i);
    if (!set.is_inside(i, at.q)) return;
    const auto add = [&](const Vec3& into, double slope) {
      const Vec3 m = e.to_cylindrical(set.element(i), at.to_base * into);
      stiffness += slope * m * m.transpose();
    };
    for (std::size_t k = 0; k < set.surfaces(i); ++k) {
      if (!set.is_there(i, k) || set.surely_open(i, k, at)) continue;
      set.for_slices(i, k, at, 0.0, [&](const contact::PocketSlice& slice, double load, double) {
        if (load > 0.0 && slice.gap < 0.0) add(slice.m, (10.0 / 9.0) * load / -slice.gap);
      });
    }
    set.for_ends(i, at, [&](const contact::EndTouch& touch, double load, double) {
      add(touch.out, 1.5 * load / -touch.gap);
    });
  }

  std::optional<RollerPocketSet> set_;
  std::optional<RollerPocketSet> last_halves_;  ///< of segments that are cut through their pockets
  std::array<std::optional<UserTouches>, 2> forces_;  ///< ADRX3 of both sets
  std::optional<RollerPocketOil> oil_;                ///< kPocHydro
  double heat_ = 0.0, film_heat_ = 0.0;               ///< now [W]
};

}  // namespace

std::unique_ptr<SceneEffect> make_roller_pockets(const ScenePlan& plan) {
  if (!plan.rollers || !plan.has(Effect::PocketContact)) return nullptr;
  return std::make_unique<RollerPockets>();
}

}  // namespace adore::dynamics
