#include "base/errors.hpp"
#include "dynamics/effect_makers.hpp"
#include "dynamics/effects/contact_damping.hpp"
#include "dynamics/effects/pockets.hpp"
#include "dynamics/effects/roller_pocket_films.hpp"
#include "dynamics/effects/roller_pocket_forces.hpp"
#include "dynamics/effects/roller_pocket_set.hpp"
#include "dynamics/effects/scene_pieces.hpp"
#include "tribology/cage_oil.hpp"
#include "tribology/traction_law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <type_traits>

/// Effects "pocket contact" and "pocket traction" of rollers (roller_pocket_set.hpp), with their
/// films and with normal forces of others.
namespace adore::dynamics {
namespace {

template <bool Traction>
class RollerPocketBlock final : public EffectBlock {
 public:
  RollerPocketBlock(const RollerPocketSet& set, const tribology::TractionLaw& law,
                    const RollerPocketDamping& damping, HeatByPart& heat, LastContactValues& kept)
      : set_(set), law_(law), damping_(damping), heat_(heat), kept_(kept) {
    if (law.is_user_law()) asked_.reserve(set.max_contact_count());
  }
  void apply(Evaluation& e) noexcept override {
    kept_.none();
    if constexpr (Traction)
      law_.visit_regularized([&](const auto& friction) {
        run_friction_passes(asked_, friction, [&](const auto& law) { apply_with(law, e); });
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
        if (!set_.has_surface(i, k) || set_.is_certainly_open(i, k, at)) continue;
        const double width = set_.slice_width(i);
        set_.for_slices(
            i, k, at, 0.0, [&](const contact::PocketSlice& slice, double load, double energy) {
              if (!(load > 0.0)) return;
              const Vec3* leaning = slice.aside.isZero(0.0) ? nullptr : &slice.aside;
              const double N =
                  push(friction, e, i, at,
                       {slice.m, slice.point, load, energy, -slice.gap, slice.middle, leaning},
                       damping_.slice, width * slice.fraction);
              if constexpr (kOnlyNotes<Friction>) return;
              kept_.add(i, k, N);
              if (leaning != nullptr || !slice.edge.isZero(0.0))
                push_middle(e, i, at, slice.middle, N * slice.aside + load * slice.edge);
            });
      }
      set_.for_ends(i, at, [&](const contact::RollerEndContact& touch, double load, double energy) {
        push(friction, e, i, at,
             {touch.out, touch.point, load, energy, -touch.gap, Vec3::Zero(), nullptr},
             damping_.end, 1.0);
      });
    }
  }
  /// In the pocket frame.
  struct Touch {
    const Vec3 &into, &point;
    double load, energy, approach;  ///< elastic
    const Vec3& middle;
    const Vec3* aside;  ///< of a leaning slice; else null
  };
  /// @param weight of the stiffness: width of a slice, else 1
  /// @return total normal force [N]
  template <class Friction>
  double push(const Friction& friction, Evaluation& e, std::size_t i,
              const RollerPocketSet::Place& at, const Touch& touch,
              const contact::DampingLaw<>& damping, double weight) noexcept;
  /// Forces `aside` and `edge` of a slice, at its middle (contact/roller_pocket.hpp).
  void push_middle(Evaluation& e, std::size_t i, const RollerPocketSet::Place& at,
                   const Vec3& middle, const Vec3& force) noexcept;

  const RollerPocketSet& set_;
  tribology::TractionLaw law_;
  RollerPocketDamping damping_;
  UserTractionBatch asked_;
  HeatByPart& heat_;
  LastContactValues& kept_;
};

template <bool Traction>
template <class Friction>
double RollerPocketBlock<Traction>::push(const Friction& friction, Evaluation& e, std::size_t i,
                                         const RollerPocketSet::Place& at, const Touch& touch,
                                         const contact::DampingLaw<>& damping,
                                         double weight) noexcept {
  BodyState& cage = e.segments[set_.segment(i)];
  const std::size_t roller = set_.element(i);
  const Vec3 to_mass = set_.mass_offset() * e.attitude[roller].col(0);
  const Vec3 m = at.to_base * touch.into;
  const Vec3 arm = at.to_base * (touch.point - at.q) - to_mass;
  const Vec3 X = e.element_centre(roller) + arm;
  const auto apart = [&](const Vec3& from) -> Vec3 {  // cage - roller velocity
    return cage.velocity_at(e.element_centre(roller) + from) - e.element_velocity(roller) -
           e.element_omega(roller).cross(from);
  };
  Vec3 slip = apart(arm);
  const double opens = slip.dot(m);
  double load = touch.load;
  if (contact::is_damped(damping)) {
    double rate = -opens;
    if (touch.aside != nullptr)
      rate += apart(at.to_base * (touch.middle - at.q) - to_mass).dot(at.to_base * *touch.aside);
    const double k = weight * contact::power_law_stiffness(load, touch.energy, touch.approach);
    load = contact::damped_load(damping, touch.load, k, touch.approach, rate);
    if constexpr (!kOnlyNotes<Friction>) heat_.damping += (load - touch.load) * rate;
  }
  Vec3 f = -load * m;
  if constexpr (Traction) {
    slip -= opens * m;
    const double square = slip.squaredNorm(), per_slip = friction_over_slip(friction, load, square);
    if constexpr (kOnlyNotes<Friction>) return load;
    f += per_slip * slip;
    heat_.add(roller, per_slip * square);
    cage.load_slip += load * std::sqrt(square);
  }
  e.add_force(roller, e.to_cylindrical(roller, f));
  e.add_moment(roller, e.to_cylindrical(roller, arm.cross(f)));
  cage.add_force(-f, X);
  e.elastic += touch.energy;
  return load;
}

template <bool Traction>
void RollerPocketBlock<Traction>::push_middle(Evaluation& e, std::size_t i,
                                              const RollerPocketSet::Place& at, const Vec3& middle,
                                              const Vec3& force) noexcept {
  const std::size_t roller = set_.element(i);
  const Vec3 arm = at.to_base * (middle - at.q) - set_.mass_offset() * e.attitude[roller].col(0);
  const Vec3 f = at.to_base * force;
  e.add_force(roller, e.to_cylindrical(roller, f));
  e.add_moment(roller, e.to_cylindrical(roller, arm.cross(f)));
  e.segments[set_.segment(i)].add_force(-f, e.element_centre(roller) + arm);
}

class RollerPockets final : public SceneEffect, public NonRaceContacts {
 public:
  void declare(SceneBuilder& scene) override {
    demand(scene.plan.has(Effect::CageMotion),
           "contacts of the cage are to be computed, but its motion is not");
    demand(scene.rollers != nullptr, "roller pockets need rollers");
    for (HeatByPart* heat : {&heat_, &film_heat_})
      heat->part.assign(static_cast<std::size_t>(scene.bearing.element_count()), 0.0);
    const bool traction = scene.plan.has(Effect::PocketTraction);
    demand(!traction || scene.bearing.pocket_traction.has_value(),
           "the pocket traction is switched on, but has no traction curve");
    constexpr std::string_view kCost = "pocket contacts";
    const bearing::Cage& cage = *scene.bearing.cage;
    const double mass = reduced_mass(scene.bearing.element_inertia.mass, cage.inertia.mass);
    const auto law = [&](double share) {
      return damping_law(scene, scene.bearing.element_material, cage.material, mass, share);
    };
    damping_ = {law(1.0 / scene.bearing.rollers()->length), law(1.0)};
    scene::UserContactForce* const user = scene.options.user ? scene.options.user->pocket : nullptr;
    const bool damped = contact::is_damped(damping_.end);
    if (traction || user != nullptr || damped)
      scene.block<ResetHeatByPart>(Phase::Force, kCost, {}, heat_);
    std::optional<tribology::TractionLaw> friction;
    if (traction)
      friction =
          traction_of(scene, tribology::TractionKind::ElementCage, *scene.bearing.pocket_traction);
    const contact::CagePieces pieces = pieces_of(scene);
    const auto add = [&](std::optional<RollerPocketSet>& set,
                         const std::vector<contact::SegmentPocket>& pockets,
                         std::optional<RollerPocketForces>& forces, LastContactValues& kept) {
      set.emplace(scene, pockets);
      kept.size(pockets.size(),
                static_cast<std::size_t>(bearing::pocket_surfaces(*scene.bearing.cage, true)));
      std::vector<BodyId> partners(pieces.pockets.size(), BodyId{BodyId::Kind::Segment, -1});
      for (const contact::SegmentPocket& pocket : pockets)
        partners[pocket.element].index = pocket.piece;
      std::vector<BodyId> same = partners;
      if (friction)
        scene.block<RollerPocketBlock<true>>(Phase::Force, kCost,
                                             CoupledBodies(std::move(partners)), *set, *friction,
                                             damping_, heat_, kept);
      else
        scene.block<RollerPocketBlock<false>>(Phase::Force, kCost,
                                              CoupledBodies(std::move(partners)), *set,
                                              tribology::TractionLaw(), damping_, heat_, kept);
      if (user == nullptr) return;
      forces.emplace(*user, set->max_contact_count());
      scene.block<UserRollerPocketBlock>(
          Phase::Force, "user routine ADRX3", CoupledBodies(std::move(same)), *set,
          friction ? &*friction : nullptr, damping_, *forces, heat_, kept);
    };
    add(set_, pieces.pockets, forces_[0], kept_[0]);
    if (!pieces.last_halves.empty()) add(last_halves_, pieces.last_halves, forces_[1], kept_[1]);
    if (traction || user != nullptr) scene.energy("pockets.heat", kPocketHeat, &heat_.sum);
    if (damped) scene.energy("pockets.damping", kPocketDamping, &heat_.damping);
    if (scene.plan.has(Effect::PocketFilm)) {  // of a cage of one piece
      const bearing::CageFilms& films = *scene.bearing.cage_films;
      oil_.emplace();
      oil_->viscosity = tribology::cage_film_viscosity(scene.bearing, films.pocket_viscosity);
      oil_->largest = films.largest_pocket_film;
      oil_->critical = std::min(films.critical_film, 0.25 * films.largest_pocket_film);
      scene.block<RollerPocketFilmBlock>(Phase::Force, "films of the cage",
                                         BodyId{BodyId::Kind::Segment, 0}, *set_, *oil_,
                                         film_heat_);
      scene.energy("pocket films.heat", *pocket_film_terms()[0], &film_heat_.sum);
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
            "the center of roller {} is outside its cage pocket (axial {:.4g} m, circumferential "
            "{:.4g} m, radial {:.4g} m from the pocket center); check the start position of the "
            "cage, its pocket clearance and the largest step (stpMax)",
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
      set_->report(i, at, snapshot.elements[i].pocket);
      kept_[0].give(i, snapshot.elements[i].pocket);
      snapshot.elements[i].pocket_to_centre = at.q;
      snapshot.elements[i].pocket_heat = heat_.part[i] + (oil_ ? film_heat_.part[i] : 0.0);
    }
    if (!last_halves_) return;
    snapshot.cages.resize(last_halves_->size());
    for (std::size_t i = 0; i < last_halves_->size(); ++i) {
      auto& half = snapshot.cages[last_halves_->segment(i)].last_half;
      last_halves_->report(i, last_halves_->locate(e, i), half);
      kept_[1].give(i, half);
    }
  }

  void look(const Evaluation&, Look& out) const override {
    sample_pocket_forces(kept_[0], last_halves_, kept_[1], out);
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
      if (!set.has_surface(i, k) || set.is_certainly_open(i, k, at)) continue;
      set.for_slices(i, k, at, 0.0, [&](const contact::PocketSlice& slice, double load, double) {
        if (load > 0.0 && slice.gap < 0.0) add(slice.m, (10.0 / 9.0) * load / -slice.gap);
      });
    }
    set.for_ends(i, at, [&](const contact::RollerEndContact& touch, double load, double) {
      add(touch.out, 1.5 * load / -touch.gap);
    });
  }

  std::optional<RollerPocketSet> set_;
  std::optional<RollerPocketSet> last_halves_;  ///< of segments that are cut through their pockets
  std::array<std::optional<RollerPocketForces>, 2> forces_;  ///< ADRX3 of both sets
  std::array<LastContactValues, 2> kept_;                    ///< likewise, by pocket and surface
  std::optional<RollerPocketOil> oil_;                       ///< kPocHydro
  RollerPocketDamping damping_;
  HeatByPart heat_, film_heat_;  ///< now, of the pocket of each roller
};

}  // namespace

std::unique_ptr<SceneEffect> make_roller_pockets(const ScenePlan& plan) {
  if (!plan.rollers || !plan.has(Effect::PocketContact)) return nullptr;
  return std::make_unique<RollerPockets>();
}

}  // namespace adore::dynamics
