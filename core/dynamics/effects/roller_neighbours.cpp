#include "base/errors.hpp"
#include "contact/line_contact.hpp"
#include "contact/roller_pair.hpp"
#include "contact/roller_shape.hpp"
#include "dynamics/effect_makers.hpp"
#include "dynamics/effects/gathered_traction.hpp"
#include "dynamics/effects/kept_values.hpp"
#include "dynamics/effects/neighbours.hpp"
#include "dynamics/effects/scene_pieces.hpp"
#include "dynamics/roller_start.hpp"
#include "tribology/traction_law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

/// Rollers that touch the ones before and after them in a bearing without cage (nCseg = 0, record
/// 10.5.3). Each slice of a roller against its neighbour and each slice of the neighbour against
/// the roller, with half the load each (contact/roller_pair.hpp): action and reaction are one line
/// of force, so that both rollers are treated alike and momentum is kept.
///   Q = K_l L^(-1/9) w δ^(10/9) of a slice of width w, K_l of both materials
///   (contact/line_contact.hpp);
///   friction at the point X = p + (ρ/(ρ + ρ')) d m, where both have their share of the distance: u
///   = velocity of the other roller less that of the slice's, its part along m removed; Q κ(s)/s u
///   on the slice's roller, the opposite on the other, s the rounded slip.
/// Heat = friction · u >= 0. Damping (contact_damping.hpp) acts along ∂δ/∂p = m + ρ'_t a, with the
/// rate of approach δ̇. The force -e f_t a of a slice that reaches over the end of the other roller
/// stays elastic: it does not vanish with f, so that a ratio of damped to elastic load would have
/// no limit there. Without friction energy is kept. Limits: ends and corners of rollers do not
/// touch neighbours; an overlap of a radius is no valid state.
namespace adore::dynamics {
namespace {

struct SlicedRoller {
  contact::RollerSide side;
  std::vector<contact::RollerSlice> slices;
  double slice_width = 0.0, reach = 0.0;  ///< furthest slice from the middle [m]
  double largest_radius = 0.0;
};

struct RingModel {
  std::vector<SlicedRoller> rollers;  ///< one for all, or one by roller
  std::vector<NeighbourPair> pairs;
  contact::PowerLaw law;
  contact::DampingLaw<> damping;
  double mass_offset = 0.0, diameter = 0.0;

  [[nodiscard]] const SlicedRoller& roller(std::size_t i) const noexcept {
    return rollers[rollers.size() == 1 ? 0 : i];
  }
};

/// Axis and middle of a roller, base axes.
struct Axis {
  Vec3 a, C;
};
Axis axis_of(const Evaluation& e, const RingModel& model, std::size_t i) noexcept {
  const Vec3 a = e.attitude[i].col(0);
  return {a, e.element_centre(i) - model.mass_offset * a};
}

/// Least gap that two rollers can have, from the distance of one's middle to the other's axis.
double gap_bound(const SlicedRoller& one, const Axis& at, const SlicedRoller& other,
                 const Axis& there) noexcept {
  const Vec3 between = at.C - there.C;
  const double distance = (between - between.dot(there.a) * there.a).norm();
  const double lean = (at.a - at.a.dot(there.a) * there.a).norm();
  return distance - one.reach * lean - one.largest_radius - other.largest_radius;
}

/// visit(slice, contact, p, load [N], energy [J], axial part of the force [N]) of every slice of
/// roller `one` against `other`; the load is half of the law's.
template <class Visit>
void for_slices(const RingModel& model, const SlicedRoller& one, const Axis& at,
                const SlicedRoller& other, const Axis& there, const Visit& visit) noexcept {
  for (const contact::RollerSlice& slice : one.slices) {
    const Vec3 p = at.C + slice.s * at.a;
    const contact::RollerPairSlice c = contact::roller_pair_slice(
        p, slice.radius, 0.5 * one.slice_width, other.side, there.C, there.a);
    if (!(c.fraction > 0.0)) continue;
    const double load = 0.5 * contact::slice_load(model.law, one.slice_width, c.overlap).load;
    const double energy = (9.0 / 19.0) * load * std::max(c.overlap, 0.0);
    visit(slice, c, p, load, energy);
  }
}

template <bool Traction>
class RingBlock final : public EffectBlock {
 public:
  RingBlock(const RingModel& model, const tribology::TractionLaw& law, double& heat,
            double& damping, LastContactValues& kept)
      : model_(model), law_(law), heat_(heat), damping_(damping), kept_(kept) {}
  void apply(Evaluation& e) noexcept override {
    kept_.none();
    damping_ = 0.0;
    if constexpr (Traction) heat_ = 0.0;
    law_.visit_regularized([&](const auto& friction) {
      run_friction_passes(asked_, friction, [&](const auto& law) { apply_with(law, e); });
    });
  }

 private:
  template <class Friction>
  void apply_with(const Friction& friction, Evaluation& e) noexcept {
    for (const NeighbourPair& pair : model_.pairs) {
      const SlicedRoller &one = model_.roller(pair.i), &other = model_.roller(pair.other);
      const Axis at = axis_of(e, model_, pair.i), there = axis_of(e, model_, pair.other);
      if (gap_bound(one, at, other, there) > 0.0) continue;
      const double force = press(friction, e, pair.i, one, at, pair.other, other, there) +
                           press(friction, e, pair.other, other, there, pair.i, one, at);
      kept_.add(pair.i, 0, force);
    }
  }
  /// @return normal force [N]
  template <class Friction>
  double press(const Friction& friction_per_slip, Evaluation& e, std::size_t i,
               const SlicedRoller& one, const Axis& at, std::size_t j, const SlicedRoller& other,
               const Axis& there) noexcept {
    const Vec3 centre_i = e.element_centre(i), centre_j = e.element_centre(j);
    Vec3 force = Vec3::Zero(), moment_i = Vec3::Zero(), moment_j = Vec3::Zero();
    double normal = 0.0;
    for_slices(
        model_, one, at, other, there,
        [&](const contact::RollerSlice& slice, const contact::RollerPairSlice& c, const Vec3& p,
            double load, double energy) {
          if (!(c.fraction * load > 0.0)) return;
          e.valid = e.valid && c.overlap < 0.5 * model_.diameter;
          double N = c.fraction * load;
          if constexpr (!kOnlyNotes<Friction>) e.elastic += c.fraction * energy;
          const Vec3 into = c.m + c.other_slope * there.a;  // ∂δ/∂p
          if (contact::is_damped(model_.damping)) {
            const double elastic = N, k = (10.0 / 9.0) * elastic / c.overlap;
            const Vec3 together = e.element_velocity(i) + e.element_omega(i).cross(p - centre_i) -
                                  e.element_velocity(j) - e.element_omega(j).cross(p - centre_j);
            const double rate = into.dot(together);
            N = contact::damped_load(model_.damping, elastic, one.slice_width * c.fraction * k,
                                     c.overlap, rate);
            if constexpr (!kOnlyNotes<Friction>) damping_ += (N - elastic) * rate;
          }
          const Vec3 f = -N * into - energy * c.fraction_slope * there.a;
          normal += N;
          force += f;
          moment_i += (p - centre_i).cross(f);
          moment_j -= (p - centre_j).cross(f);
          if constexpr (Traction) {
            const Vec3 X = p + (slice.radius / (slice.radius + c.other_radius) * c.distance) * c.m;
            Vec3 slip = e.element_velocity(j) + e.element_omega(j).cross(X - centre_j) -
                        e.element_velocity(i) - e.element_omega(i).cross(X - centre_i);
            slip -= slip.dot(c.m) * c.m;
            const double square = slip.squaredNorm();
            const double per_slip = friction_over_slip(friction_per_slip, N, square);
            if constexpr (kOnlyNotes<Friction>) return;
            const Vec3 pull = per_slip * slip;
            heat_ += per_slip * square;
            force += pull;
            moment_i += (X - centre_i).cross(pull);
            moment_j -= (X - centre_j).cross(pull);
          }
        });
    if constexpr (kOnlyNotes<Friction>) return 0.0;
    e.add_force(i, e.to_cylindrical(i, force));
    e.add_force(j, e.to_cylindrical(j, -force));
    e.add_moment(i, e.to_cylindrical(i, moment_i));
    e.add_moment(j, e.to_cylindrical(j, moment_j));
    return normal;
  }

  const RingModel& model_;
  tribology::TractionLaw law_;
  UserTractionBatch asked_;
  double& heat_;
  double& damping_;
  LastContactValues& kept_;
};

class RollerNeighbours final : public SceneEffect, public NonRaceContacts {
 public:
  void declare(SceneBuilder& scene) override {
    demand(scene.rollers != nullptr, "contacts between rollers need a roller bearing");
    const bearing::Bearing& bearing = scene.bearing;
    const bearing::RollerGeometry& rollers = *bearing.rollers();
    model_.diameter = rollers.diameter;
    model_.mass_offset = bearing.roller_mass_offset;
    model_.pairs = neighbour_pairs(static_cast<std::size_t>(rollers.count));
    const double E_star =
        bearing::contact_modulus(bearing.element_material, bearing.element_material);
    model_.law = contact::power_law(contact::line_constant(E_star), rollers.length);
    // Each pair of slices twice, with half the load.
    const double mass = bearing.element_inertia.mass;
    model_.damping = damping_law(scene, bearing.element_material, bearing.element_material,
                                 reduced_mass(mass, mass), 0.5 / rollers.length);
    const std::size_t shapes =
        rollers.deviation.empty() ? 1 : static_cast<std::size_t>(rollers.count);
    for (std::size_t i = 0; i < shapes; ++i)
      model_.rollers.push_back(sliced(contact::roller_profile(rollers, rollers.deviation_of(i)),
                                      scene.rollers->options.slices));
    kept_.size(model_.pairs.size(), 1);
    constexpr std::string_view kCost = "contacts between elements";
    if (scene.plan.has(Effect::ElementTraction)) {
      demand(bearing.element_traction.has_value(),
             "the traction between elements is switched on, but has no traction curve");
      scene.block<RingBlock<true>>(
          Phase::Force, kCost, {}, model_,
          traction_of(scene, tribology::TractionKind::ElementElement, *bearing.element_traction),
          heat_, damped_, kept_);
      scene.energy("elements.heat", kElementHeat, &heat_);
    } else {
      scene.block<RingBlock<false>>(Phase::Force, kCost, {}, model_, tribology::TractionLaw(),
                                    heat_, damped_, kept_);
    }
    if (contact::is_damped(model_.damping))
      scene.energy("elements.damping", kElementDamping, &damped_);
    scene.neighbours_meet();
    scene.supports(*this);
  }

  /// f dQ/dδ m mᵀ of what is touched.
  void resist(const Evaluation& e, std::size_t i, Mat3& stiffness) noexcept override {
    const auto add = [&](const contact::RollerSlice&, const contact::RollerPairSlice& c,
                         const Vec3&, double load, double) {
      if (!(load > 0.0)) return;
      const Vec3 m = e.to_cylindrical(i, c.m);
      stiffness += (10.0 / 9.0) * c.fraction * load / c.overlap * m * m.transpose();
    };
    for_pairs_of(i, e.elements.n, model_.pairs, [&](const NeighbourPair& pair) {
      const SlicedRoller &one = model_.roller(pair.i), &other = model_.roller(pair.other);
      const Axis at = axis_of(e, model_, pair.i), there = axis_of(e, model_, pair.other);
      if (gap_bound(one, at, other, there) > 0.0) return;
      for_slices(model_, one, at, other, there, add);
      for_slices(model_, other, there, one, at, add);
    });
  }

  [[nodiscard]] std::string why_invalid(const Evaluation& e) const override {
    for (const NeighbourPair& pair : model_.pairs)
      if (!(-contact_of(e, pair).gap < 0.5 * model_.diameter))
        return fmt::format(
            "rollers {} and {} overlap by more than their radius; check the number of elements, "
            "speeds and the largest step (stpMax)",
            pair.i + 1, pair.other + 1);
    return {};
  }

  void report(const Evaluation& e, Snapshot& snapshot) const override {
    for (const NeighbourPair& pair : model_.pairs) {
      snapshot.elements[pair.i].to_next = contact_of(e, pair);
      snapshot.elements[pair.i].to_next->force = kept_.at[pair.i];
    }
  }

  void look(const Evaluation&, Look& out) const override {
    out[ExtremeQuantity::PairForce] = kept_.at;
  }

 private:
  static SlicedRoller sliced(const contact::RollerProfile& profile, int count) {
    SlicedRoller out;
    const contact::Slicing slicing = contact::slicing(profile, count);
    out.slices = contact::roller_slices(profile, slicing);
    out.slice_width = slicing.width;
    out.side = {profile, slicing.start, slicing.start + slicing.effective_length};
    for (const contact::RollerSlice& slice : out.slices) {
      out.reach = std::max(out.reach, std::abs(slice.s));
      out.largest_radius = std::max(out.largest_radius, slice.radius);
    }
    return out;
  }

  /// Load of all slices and their least gap.
  [[nodiscard]] scene::NeighborContactSnapshot contact_of(const Evaluation& e,
                                                          const NeighbourPair& pair) const {
    scene::NeighborContactSnapshot out;
    out.gap = std::numeric_limits<double>::infinity();
    const auto look = [&](const contact::RollerSlice&, const contact::RollerPairSlice& c,
                          const Vec3&, double load, double) {
      out.force += c.fraction * load;
      out.gap = std::min(out.gap, -c.overlap);
    };
    const SlicedRoller &one = model_.roller(pair.i), &other = model_.roller(pair.other);
    const Axis at = axis_of(e, model_, pair.i), there = axis_of(e, model_, pair.other);
    for_slices(model_, one, at, other, there, look);
    for_slices(model_, other, there, one, at, look);
    if (std::isinf(out.gap)) out.gap = gap_bound(one, at, other, there);  // side by side no more
    return out;
  }

  RingModel model_;
  LastContactValues kept_;
  double heat_ = 0.0, damped_ = 0.0;  ///< now [W]
};

}  // namespace

std::unique_ptr<SceneEffect> make_roller_neighbours(const ScenePlan& plan) {
  if (!plan.rollers || !plan.has(Effect::ElementContact)) return nullptr;
  return std::make_unique<RollerNeighbours>();
}

}  // namespace adore::dynamics
