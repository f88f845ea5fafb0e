#pragma once

#include "dynamics/effects/gathered_traction.hpp"
#include "dynamics/effects/heat_by_part.hpp"
#include "dynamics/effects/kept_values.hpp"
#include "dynamics/effects/roller_pocket_set.hpp"
#include "dynamics/effects/user_forces.hpp"
#include "tribology/traction_law.hpp"

#include <cmath>
#include <optional>
#include <type_traits>

/// Rollers in pockets whose normal forces are another's.
namespace adore::dynamics {

/// A contact that ADRX3 is asked for: one slice, or one end of a pocket.
struct RollerPocketTouch {
  std::size_t pocket = 0, roller = 0, surface = 0;
  bool at_end = false;
  Vec3 point, normal;  ///< into the wall
  Vec3 middle, aside;  ///< of a leaning slice, per newton; zero
  Vec3 friction, arm;  ///< on the roller; from its mass centre to the point
  double slip = 0.0, heat = 0.0;
};
using RollerPocketForces = UserForces<RollerPocketTouch>;

/// ADRX3 (user_forces.hpp): every slice, and both ends of a pocket, whose surfaces are
/// numbered behind those of its wall.
class UserRollerPocketBlock final : public EffectBlock {
 public:
  UserRollerPocketBlock(const RollerPocketSet& set, const tribology::TractionLaw* friction,
                        const RollerPocketDamping& damping, RollerPocketForces& forces,
                        HeatByPart& heat, LastContactValues& kept)
      : set_(set), damping_(damping), forces_(forces), heat_(heat), kept_(kept) {
    if (friction != nullptr) friction_ = *friction;
  }
  void apply(Evaluation& e) noexcept override {
    run_traction_passes(asked_, friction_ ? &*friction_ : nullptr,
                        [&](const auto& law) { collect_all(law, e); });
    const bool valid =
        forces_.ask(e.t, [&](const RollerPocketTouch& touch, const UserForceDifference& by) {
          BodyState& cage = e.segments[set_.segment(touch.pocket)];
          const Vec3 f = by.ratio * touch.friction - by.force * touch.normal;
          add(e, cage, touch.roller, f, touch.arm);
          if (!touch.aside.isZero(0.0))
            add(e, cage, touch.roller, by.force * touch.aside, touch.middle);
          cage.load_slip += by.force * touch.slip;
          heat_.add(touch.roller, by.ratio * touch.heat + by.heat);
          heat_.damping += by.damping;
          if (!touch.at_end) kept_.add(touch.pocket, touch.surface, by.force);
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
        if (!set_.has_surface(i, k) || set_.is_certainly_open(i, k, at)) continue;
        set_.for_slices(
            i, k, at, 0.0, [&](const contact::PocketSlice& slice, double load, double energy) {
              if (load > 0.0 && slice.gap < 0.0)
                collect(friction, e, i, at, k, slice.m, slice.point, slice.middle, slice.aside,
                        slice.gap, load, set_.slice_width(i) * slice.fraction, energy);
            });
      }
      set_.for_ends(i, at, [&](const contact::RollerEndContact& touch, double load, double energy) {
        const std::size_t surface = set_.surfaces(i) + (touch.out[0] > 0.0 ? 1 : 0);
        collect(friction, e, i, at, surface, touch.out, touch.point, Vec3::Zero(), Vec3::Zero(),
                touch.gap, load, 1.0, energy);
      });
    }
  }
  /// Geometry in the pocket frame.
  template <class Friction>
  void collect(const Friction& friction, const Evaluation& e, std::size_t i,
               const RollerPocketSet::Place& at, std::size_t surface, const Vec3& into,
               const Vec3& point, const Vec3& middle, const Vec3& aside, double gap, double load,
               double weight, double energy) noexcept {
    const BodyState& cage = e.segments[set_.segment(i)];
    const std::size_t roller = set_.element(i);
    const Vec3 to_mass = set_.mass_offset() * e.attitude[roller].col(0);
    RollerPocketTouch t;
    t.pocket = i;
    t.roller = roller;
    t.surface = surface;
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
    const double k = weight * contact::power_law_stiffness(load, energy, -gap);
    forces_.collect(t, roller, surface, gap, rate, load,
                    damped_contact(t.at_end ? damping_.end : damping_.slice, load, k, -gap, -rate));
  }

  const RollerPocketSet& set_;
  std::optional<tribology::TractionLaw> friction_;
  RollerPocketDamping damping_;
  UserTractionBatch asked_;
  RollerPocketForces& forces_;
  HeatByPart& heat_;
  LastContactValues& kept_;
};

}  // namespace adore::dynamics
