#include "dynamics/effects/neighbours.hpp"

#include "base/errors.hpp"
#include "bearing/element_inertia.hpp"
#include "contact/conformal.hpp"
#include "dynamics/effect_makers.hpp"
#include "dynamics/effects/gathered_traction.hpp"
#include "dynamics/effects/kept_values.hpp"
#include "dynamics/effects/scene_pieces.hpp"
#include "tribology/traction_law.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <vector>

/// Balls that touch the ones before and after them in a bearing without cage (nCseg = 0, record
/// 10.5.3). Centers q_i, q_j of neighbors, d = |q_j - q_i|, n = (q_j - q_i)/d, overlap δ = r_i +
/// r_j - d:
///   N = law(δ), Hertz of two spheres (Q = 4/3 E* √R δ^1.5, 1/R = 1/r_i + 1/r_j, E* = E/(2(1 -
///   ν²)), continued by contact/conformal.hpp where the patch grows beyond half a radius) along n,
///   apart;
///   friction at the point that divides q_i q_j like the radii, from i at the lever d r_i/(r_i +
///   r_j): u = velocity of j less that of i there, its part along n removed; N κ(s)/s u on i, the
///   opposite on j, s the rounded slip (tribology/rounded_law.hpp). One point for both, so that
///   angular momentum is conserved.
/// Heat = friction · u >= 0. With damping (contact_damping.hpp) N is the total force. Without, N is
/// minus the gradient of law.energy over both centers: without friction energy is conserved. Zero
/// load and zero heat without overlap. Limits: an overlap of half the sum of the radii is not a
/// valid state. With two balls there is one contact. The spacing of the static solution determines
/// the first contacts. Source: resources/docs/theory/cage_and_motion.md, section 7; decision 230.
namespace adore::dynamics {
namespace {

constexpr const LedgerTerm* kTerms[] = {&kElementHeat, &kElementDamping};

using Pair = NeighbourPair;

struct PairContact {
  Vec3 n = Vec3::Zero();  ///< from i to the other
  double distance = 0.0;  ///< of the centers [m]
};
PairContact pair_contact(const Evaluation& e, const Pair& pair) noexcept {
  const Vec3 between = e.element_centre(pair.other) - e.element_centre(pair.i);
  const double distance = between.norm();
  return {between / distance, distance};
}

struct PairOfBalls : Pair {
  double reach = 0.0;  ///< r_i + r_j [m]
  double share = 0.5;  ///< r_i/(r_i + r_j)
  contact::CappedHertz law;
  contact::DampingLaw<> damping;
};

/// Velocity of the other ball less that of i where they touch, across n.
Vec3 slip_of(const Evaluation& e, const PairOfBalls& pair, const PairContact& c) noexcept {
  const Vec3 arm = (pair.share * c.distance) * c.n;
  const Vec3 unequal = 2.0 * arm - c.distance * c.n;  // levers of equal balls are opposite
  const Vec3 slip = e.element_velocity(pair.other) - e.element_velocity(pair.i) -
                    (e.element_omega(pair.other) + e.element_omega(pair.i)).cross(arm) +
                    e.element_omega(pair.other).cross(unequal);
  return slip - slip.dot(c.n) * c.n;
}

template <bool Traction>
class PairBlock final : public EffectBlock {
 public:
  PairBlock(const std::vector<PairOfBalls>& pairs, const tribology::TractionLaw& law, double& heat,
            double& damping, LastContactValues& kept)
      : pairs_(pairs), law_(law), heat_(heat), damping_(damping), kept_(kept) {}
  void apply(Evaluation& e) noexcept override {
    kept_.none();
    damping_ = 0.0;
    law_.visit_regularized([&](const auto& friction) {
      run_friction_passes(asked_, friction, [&](const auto& law) { apply_with(law, e); });
    });
  }

 private:
  template <class Friction>
  void apply_with(const Friction& friction_per_slip, Evaluation& e) noexcept;

  const std::vector<PairOfBalls>& pairs_;
  tribology::TractionLaw law_;
  UserTractionBatch asked_;
  double& heat_;
  double& damping_;
  LastContactValues& kept_;
};

template <bool Traction>
template <class Friction>
void PairBlock<Traction>::apply_with([[maybe_unused]] const Friction& friction_per_slip,
                                     Evaluation& e) noexcept {
  if constexpr (Traction) heat_ = 0.0;
  for (const PairOfBalls& pair : pairs_) {
    const PairContact c = pair_contact(e, pair);
    const double overlap = pair.reach - c.distance;
    if (!(overlap > 0.0)) continue;
    e.valid = e.valid && overlap < 0.5 * pair.reach;
    double N = contact::load(pair.law, overlap);
    if (contact::is_damped(pair.damping)) {
      const double elastic = N,
                   rate = (e.element_velocity(pair.i) - e.element_velocity(pair.other)).dot(c.n);
      N = contact::damped_load(pair.damping, elastic, contact::slope(pair.law, overlap), overlap,
                               rate);
      if constexpr (!kOnlyNotes<Friction>) damping_ += (N - elastic) * rate;
    }
    Vec3 on_first = -N * c.n;
    if constexpr (!kOnlyNotes<Friction>) e.elastic += contact::energy(pair.law, overlap);
    if constexpr (Traction) {
      const Vec3 arm = (pair.share * c.distance) * c.n;
      const Vec3 other_arm = arm - c.distance * c.n;
      const Vec3 slip = slip_of(e, pair, c);
      const Vec3 friction = friction_over_slip(friction_per_slip, N, slip.squaredNorm()) * slip;
      if constexpr (kOnlyNotes<Friction>) continue;
      on_first += friction;
      heat_ += friction.dot(slip);
      e.add_moment(pair.i, e.to_cylindrical(pair.i, arm.cross(friction)));
      e.add_moment(pair.other, e.to_cylindrical(pair.other, friction.cross(other_arm)));
    }
    kept_.add(pair.i, 0, N);
    e.add_force(pair.i, e.to_cylindrical(pair.i, on_first));
    e.add_force(pair.other, e.to_cylindrical(pair.other, -on_first));
  }
}

class Neighbours final : public SceneEffect, public NonRaceContacts {
 public:
  void declare(SceneBuilder& scene) override {
    const bearing::Bearing& bearing = scene.bearing;
    const double mass = bearing.element_inertia.mass;
    const contact::DampingLaw<> damping = damping_law(
        scene, bearing.element_material, bearing.element_material, reduced_mass(mass, mass));
    for (const Pair& pair : neighbour_pairs(static_cast<std::size_t>(bearing.element_count()))) {
      const double mine = bearing::element_radius(bearing, pair.i);
      const double other = bearing::element_radius(bearing, pair.other);
      pairs_.push_back({pair, mine + other, mine / (mine + other),
                        contact::ball_pocket_law(bearing.element_material, bearing.element_material,
                                                 2.0 * mine, {1.0 / other, 1.0 / other})
                            .law,
                        damping});
    }
    kept_.size(pairs_.size(), 1);
    constexpr std::string_view kCost = "contacts between elements";
    if (scene.plan.has(Effect::ElementTraction)) {
      demand(bearing.element_traction.has_value(),
             "the traction between elements is switched on, but has no traction curve");
      scene.block<PairBlock<true>>(Phase::Force, kCost, {}, pairs_, friction_of(scene), heat_,
                                   damped_, kept_);
      scene.energy("elements.heat", kElementHeat, &heat_);
    } else {
      scene.block<PairBlock<false>>(Phase::Force, kCost, {}, pairs_, tribology::TractionLaw(),
                                    heat_, damped_, kept_);
    }
    if (contact::is_damped(damping)) scene.energy("elements.damping", kElementDamping, &damped_);
    scene.neighbours_meet();
    scene.supports(*this);
    if (scene.plan.has(Effect::ElementTraction)) friction_.emplace(friction_of(scene));
  }

  static tribology::TractionLaw friction_of(const SceneBuilder& scene) {
    return traction_of(scene, tribology::TractionKind::ElementElement,
                       *scene.bearing.element_traction);
  }

  /// N' n nᵀ - N/d (I - n nᵀ) while the other one stands still.
  void resist(const Evaluation& e, std::size_t i, Mat3& stiffness) noexcept override {
    for_pairs_of(i, e.elements.n, pairs_, [&](const PairOfBalls& pair) {
      const PairContact c = pair_contact(e, pair);
      const double overlap = pair.reach - c.distance;
      if (!(overlap > 0.0)) return;
      const Vec3 n = e.to_cylindrical(i, c.n);
      const double across = contact::load(pair.law, overlap) / c.distance;
      stiffness += (contact::slope(pair.law, overlap) + across) * n * n.transpose();
      stiffness.diagonal().array() -= across;
    });
  }
  /// Twice friction over slip (held_elements.hpp).
  void damp(const Evaluation& e, std::size_t i, Eigen::Matrix2d& damping) noexcept override {
    if (!friction_) return;
    for_pairs_of(i, e.elements.n, pairs_, [&](const PairOfBalls& pair) {
      const PairContact c = pair_contact(e, pair);
      const double overlap = pair.reach - c.distance;
      if (!(overlap > 0.0)) return;
      const Eigen::Vector2d n = e.to_cylindrical(i, c.n).head<2>();
      friction_->visit_regularized([&](const auto& per_slip) {
        damping += 2.0 *
                   friction_over_slip(per_slip, contact::load(pair.law, overlap),
                                      slip_of(e, pair, c).squaredNorm()) *
                   (Eigen::Matrix2d::Identity() - n * n.transpose());
      });
    });
  }

  [[nodiscard]] std::string why_invalid(const Evaluation& e) const override {
    for (const PairOfBalls& pair : pairs_)
      if (!(pair_contact(e, pair).distance > 0.5 * pair.reach))
        return fmt::format(
            "elements {} and {} overlap by more than their radius; check the number of elements, "
            "speeds and the largest step (stpMax)",
            pair.i + 1, pair.other + 1);
    return {};
  }

  void report(const Evaluation& e, Snapshot& snapshot) const override {
    for (const PairOfBalls& pair : pairs_) {
      const double gap = pair_contact(e, pair).distance - pair.reach;
      snapshot.elements[pair.i].to_next = {kept_.at[pair.i], gap};
    }
  }

  void look(const Evaluation&, Look& out) const override {
    out[ExtremeQuantity::PairForce] = kept_.at;
  }

 private:
  std::vector<PairOfBalls> pairs_;
  LastContactValues kept_;
  std::optional<tribology::TractionLaw> friction_;
  double heat_ = 0.0, damped_ = 0.0;  ///< now [W]
};

}  // namespace

std::unique_ptr<SceneEffect> make_element_contact(const ScenePlan& plan) {
  if (!plan.has(Effect::ElementContact) || plan.rollers) return nullptr;
  return std::make_unique<Neighbours>();
}
std::span<const LedgerTerm* const> element_contact_terms() { return kTerms; }

}  // namespace adore::dynamics
