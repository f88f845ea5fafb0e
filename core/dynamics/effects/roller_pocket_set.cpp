#include "dynamics/effects/roller_pocket_set.hpp"

#include "contact/roller_shape.hpp"
#include "dynamics/effects/pockets.hpp"
#include "dynamics/roller_start.hpp"

namespace adore::dynamics {

RollerPocketSet::RollerPocketSet(const SceneBuilder& scene,
                                 const std::vector<contact::SegmentPocket>& placed) {
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
  for (const contact::SegmentPocket& place : placed) {
    const bearing::PocketDeviation own = cage.deviation_of(place.element);
    const auto [low, high] = contact::pocket_wall_limits(cage.outer_diameter, cage.inner_diameter,
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
    const Vec3 axis = passive_rotation_y(cage.cone_angle) *
                      Vec3(std::cos(rollers.axis_angle), 0.0, -std::sin(rollers.axis_angle));
    for (std::size_t k = 0; k < 2; ++k)
      pocket.end_wall[k] =
          0.5 * (width - D) - contact::end_contact_at_wall(nominal[k], 0.0, Vec3::Zero(), axis).gap;
    if (!cage.pocket_faces.empty())
      pocket.faces = contact::paired_faces(contact::widened(cage.pocket_faces, own.clearance[0]),
                                           rotation_sign_);
    else if (cage.pocket == bearing::PocketShape::Cylindrical)
      pocket.round = contact::RoundPocket{0.5 * width,
                                          low,
                                          high,
                                          place.half,
                                          contact::half_pocket_edge(cage, rollers.pitch_diameter),
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
  const SliceGapBound bound = slice_gap_bound(i, k, at);
  const contact::RollerSlice* best = &slices.front();
  double least = bound(*best);
  for (const contact::RollerSlice& slice : slices)
    if (const double here = bound(slice); here < least) {
      least = here;
      best = &slice;
    }
  const contact::RollerSlice* const first = best;
  const double enough = gap_of(*first);
  best = nullptr;
  for (const contact::RollerSlice& slice : slices) {
    if (bound(slice) > enough) continue;
    const double gap = &slice == first ? enough : gap_of(slice);
    if (gap >= out.gap) continue;
    out.gap = gap;
    best = &slice;
  }
  if (best != nullptr)
    take(contact::slice_at_face(face, at.q + best->s * at.u, at.u, best->radius,
                                0.5 * roller_of(i).slice_width));
  return out;
}

void RollerPocketSet::report(std::size_t i, const Place& at,
                             std::vector<PocketContactSnapshot>& out) const {
  out.clear();
  out.reserve(surfaces(i));
  for (std::size_t k = 0; k < surfaces(i); ++k) {
    PocketContactSnapshot& one = out.emplace_back();
    if (!has_surface(i, k)) continue;
    double moment = 0.0;
    if (!is_certainly_open(i, k, at))
      for_slices(i, k, at, 0.0, [&](const contact::PocketSlice& slice, double load, double) {
        one.force += load;
        moment += load * slice.position;
      });
    const Nearest nearest = this->nearest(i, k, at);
    one.gap = nearest.gap;
    one.position = one.force > 0.0 ? moment / one.force : nearest.position;
    one.theta = contact::round_pocket_angle(nearest.m, rotation_sign_);
  }
}

}  // namespace adore::dynamics
