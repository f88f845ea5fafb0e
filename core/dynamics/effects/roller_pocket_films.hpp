#pragma once

#include "dynamics/effects/heat_by_part.hpp"
#include "dynamics/effects/roller_pocket_set.hpp"
#include "tribology/pocket_film.hpp"

#include <algorithm>
#include <cmath>

namespace adore::dynamics {

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
    const double wedge = tribology::line_wedge_force(viscosity, 0.5 * sliding.norm(), R, width, h);
    const double squeeze = tribology::cylinder_squeeze_force(viscosity, R, width, h, -closing);
    out.shear = fade * tribology::line_shear_force(viscosity, 1.0, R, width, h);
    out.squeeze = fade * tribology::cylinder_squeeze_force(viscosity, R, width, h, -1.0);
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
      if (!set.has_surface(i, k) || set.is_certainly_open(i, k, place, largest)) continue;
      set.for_slices(i, k, place, largest, [&](const contact::PocketSlice& slice, double, double) {
        if (slice.gap < largest && slice.fraction > 0.0) visit(at(set, e, i, place, slice));
      });
    }
  }
};

class RollerPocketFilmBlock final : public EffectBlock {
 public:
  RollerPocketFilmBlock(const RollerPocketSet& set, const RollerPocketOil& oil, HeatByPart& heat)
      : set_(set), oil_(oil), heat_(heat) {}
  void apply(Evaluation& e) noexcept override {
    heat_.none();
    for (std::size_t i = 0; i < set_.size(); ++i) {
      const std::size_t roller = set_.element(i);
      oil_.for_films(set_, e, i, [&](const RollerPocketOil::Action& a) {
        e.add_force(roller, e.to_cylindrical(roller, a.force));
        e.add_moment(roller, e.to_cylindrical(roller, a.arm.cross(a.force)));
        e.segments[set_.segment(i)].add_force(-a.force, a.point);
        heat_.add(roller, -a.force.dot(a.slip));
      });
    }
  }

 private:
  const RollerPocketSet& set_;
  const RollerPocketOil& oil_;
  HeatByPart& heat_;
};

}  // namespace adore::dynamics
