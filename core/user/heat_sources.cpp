#include "user/heat_sources.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string_view>

namespace adore::user {

void HeatSources::add(int kind, int element, int race, double heat, const Place& place,
                      const char* name) {
  kind_.push_back(kind);
  element_.push_back(element);
  race_.push_back(race);
  heat_.push_back(heat);
  for (const double one : {place.x, place.y, place.z}) place_.push_back(one);
  for (const double one : {place.across, place.along}) size_.push_back(one);
  name_.push_back(name);
}

HeatSources::Geometry HeatSources::geometry_of(const bearing::Bearing& bearing) {
  Geometry out;
  out.element_radius = 0.5 * bearing.element_diameter();
  if (const bearing::RollerGeometry* rollers = bearing.rollers()) {
    out.rollers = true;
    out.half_length = 0.5 * rollers->length;
  }
  const double share = bearing.element_diameter() / bearing.pitch_diameter();
  if (bearing.speed[0] * (1.0 + share) + bearing.speed[1] * (1.0 - share) < 0.0)
    out.rotation_sign = -1.0;
  if (!bearing.cage) return out;
  for (const bearing::GuideLand& land : bearing.cage->lands)
    out.lands.push_back({land.edge - std::copysign(0.5 * land.width, land.edge),
                         0.5 * land.diameter,
                         land.guide == bearing::GuideLand::Guide::Outer   ? 0
                         : land.guide == bearing::GuideLand::Guide::Inner ? 1
                                                                          : -1});
  return out;
}

HeatSources::HeatSources(const scene::Snapshot& snapshot, const Geometry& geometry)
    : step_size_(snapshot.step_size), total_heat_(snapshot.energy.heat_rate()) {
  std::array<TermHeatSum, 3> of_races{{{"heat"}, {"rolling_heat"}, {"contact_damping"}}};
  for (std::size_t j = 0; j < 2; ++j)
    for (const scene::ElementSnapshot& one : snapshot.elements) {
      load_.push_back(one.race[j].load);
      angle_.push_back(one.race[j].angle);
    }
  for (std::size_t i = 0; i < snapshot.elements.size(); ++i) {
    const scene::ElementSnapshot& one = snapshot.elements[i];
    x_.push_back(one.x);
    r_.push_back(one.r);
    theta_.push_back(one.theta);
    const double s = std::sin(one.theta), c = std::cos(one.theta);
    const auto put = [&](const scene::RaceContactSnapshot& contact, std::size_t j, double rolling,
                         double damping) {
      if (!(contact.load > 0.0)) return;
      // One radius from the centre along the contact normal, which both angles measure from the
      // radial plane: positive when the inner race pushes towards +x.
      const double reach = j == 0 ? geometry.element_radius : -geometry.element_radius;
      const double x = one.x + reach * std::sin(contact.angle);
      const double r = one.r + reach * std::cos(contact.angle);
      const std::array parts{contact.heat, rolling, damping};
      add(ADORE_ELEMENT_RACE, static_cast<int>(i), static_cast<int>(j),
          std::accumulate(parts.begin(), parts.end(), 0.0),
          {x, -r * s, r * c, contact.half_major, contact.half_minor},
          j == 0 ? "outer race contact" : "inner race contact");
      for (std::size_t k = 0; k < parts.size(); ++k) of_races[k].sum[j] += parts[k];
    };
    for (std::size_t j = 0; j < 2; ++j) {
      // Rolling and damping of the first contact include those of the second.
      const scene::RaceContactSnapshot second =
          one.second.empty() ? scene::RaceContactSnapshot() : one.second[j];
      put(one.race[j], j, one.race[j].rolling_heat - second.rolling_heat,
          one.race[j].damping_heat - second.damping_heat);
      put(second, j, second.rolling_heat, second.damping_heat);
    }
  }
  double of_pockets = 0.0, of_lands = 0.0;
  for (std::size_t i = 0; i < snapshot.elements.size(); ++i) {
    of_pockets += snapshot.elements[i].pocket_heat;
    add_flanges(snapshot, i, geometry);
    add_pocket(snapshot, i, geometry);
  }
  for (const scene::CageSnapshot& cage : snapshot.cages)
    for (std::size_t k = 0; k < cage.lands.size(); ++k) {
      of_lands += cage.lands[k].heat;
      add_land(cage, k, geometry);
    }
  // What is left of the ledger, of contacts and films together.
  struct Shared {
    std::string_view id, film;
    double& detail;
  };
  std::array<Shared, 2> shared{Shared{"pocket_heat", "pocket_film_heat", of_pockets},
                               Shared{"land_heat", "land_film_heat", of_lands}};
  for (const auto& item : snapshot.energy.items()) {
    if (item.term->kind != scene::LedgerKind::Heat) continue;
    double rest = item.rate;
    const auto j = static_cast<std::size_t>(item.race);
    for (const TermHeatSum& one : of_races)
      if (item.term->id == one.id) rest -= one.sum[j];
    for (const TermHeatSum& one : flange_heat_sums_)
      if (item.term->id == one.id)
        rest -= item.term->per_race() ? one.sum[j] : one.sum[0] + one.sum[1];
    for (Shared& one : shared)
      if (item.term->id == one.id || item.term->id == one.film) {
        const double taken = item.term->id == one.id ? std::min(one.detail, rest) : one.detail;
        rest -= taken;
        one.detail -= taken;
      }
    add(-1, -1, item.term->per_race() ? item.race : -1, rest, {}, item.place().data());
  }
}

namespace {

/// A vector of the frame of an azimuth (x, -e_θ, e_r) in the base frame.
scene::Vec3 from_azimuth(double theta, const scene::Vec3& v) {
  const double s = std::sin(theta), c = std::cos(theta);
  return {v[0], c * v[1] - s * v[2], s * v[1] + c * v[2]};
}
scene::Vec3 centre_of(const scene::ElementSnapshot& one) {
  return from_azimuth(one.theta, {one.x, 0.0, one.r});
}
scene::Vec3 axis_of(const scene::ElementSnapshot& one) {
  return from_azimuth(one.theta, one.oriented ? one.x_axis : scene::Vec3(scene::Vec3::UnitX()));
}
scene::Vec3 turned(const scene::Quat& q, const scene::Vec3& v) {
  const scene::Vec3 u(q[1], q[2], q[3]);
  return v + 2.0 * u.cross(u.cross(v) + q[0] * v);
}

}  // namespace

void HeatSources::add_flanges(const scene::Snapshot& snapshot, std::size_t i,
                              const Geometry& geometry) {
  const scene::ElementSnapshot& one = snapshot.elements[i];
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t side = 0; side < 2; ++side) {
      const scene::FlangeContactSnapshot& flange = one.flange[j][side];
      if (!flange.present || flange.heat + flange.damping_heat == 0.0) continue;
      const scene::Vec3 axis = axis_of(one), outwards = from_azimuth(one.theta, {0.0, 0.0, 1.0});
      const scene::Vec3 radial = (outwards - axis.dot(outwards) * axis).normalized();
      const double to_race = (j == 0 ? 1.0 : -1.0) * (geometry.element_radius - flange.height);
      const scene::Vec3 at = centre_of(one) +
                             (side == 0 ? -1.0 : 1.0) * geometry.half_length * axis +
                             to_race * radial;
      add(ADORE_ROLLER_FLANGE, static_cast<int>(i), static_cast<int>(j),
          flange.heat + flange.damping_heat, {at[0], at[1], at[2], 0.0, 0.0},
          j == 0 ? "outer race flange" : "inner race flange");
      flange_heat_sums_[0].sum[j] += flange.heat;
      flange_heat_sums_[1].sum[j] += flange.damping_heat;
    }
}

void HeatSources::add_pocket(const scene::Snapshot& snapshot, std::size_t i,
                             const Geometry& geometry) {
  const scene::ElementSnapshot& one = snapshot.elements[i];
  if (one.pocket_heat == 0.0) return;
  std::vector<const scene::PocketContactSnapshot*> surfaces;
  for (const scene::PocketContactSnapshot& surface : one.pocket) surfaces.push_back(&surface);
  // A pocket that is cut between two segments: its leading half is at the end of the one before.
  const std::size_t pieces = snapshot.cages.size();
  const std::size_t of_each = pieces > 1 ? snapshot.elements.size() / pieces : 0;
  if (of_each > 0 && i % of_each == 0)
    for (const scene::PocketContactSnapshot& surface :
         snapshot.cages[(i / of_each + pieces - 1) % pieces].last_half)
      surfaces.push_back(&surface);
  double force = 0.0;
  const scene::PocketContactSnapshot* nearest = nullptr;
  for (const scene::PocketContactSnapshot* surface : surfaces) {
    force += surface->force;
    if (nearest == nullptr || surface->gap < nearest->gap) nearest = surface;
  }
  const auto put = [&](double heat, const scene::PocketContactSnapshot& surface) {
    const double along = geometry.rotation_sign * std::cos(surface.theta);
    const scene::Vec3 m = geometry.rollers
                              ? scene::Vec3(0.0, along, std::sin(surface.theta))
                              : scene::Vec3(std::cos(surface.phi) * std::sin(surface.theta),
                                            std::cos(surface.phi) * along, std::sin(surface.phi));
    const scene::Vec3 at = centre_of(one) + geometry.element_radius * from_azimuth(one.theta, m) +
                           (geometry.rollers ? surface.position : 0.0) * axis_of(one);
    add(ADORE_ELEMENT_CAGE, static_cast<int>(i), -1, heat, {at[0], at[1], at[2], 0.0, 0.0},
        "cage pocket");
  };
  if (nearest == nullptr) return;
  if (!(force > 0.0)) return put(one.pocket_heat, *nearest);
  for (const scene::PocketContactSnapshot* surface : surfaces)
    if (surface->force > 0.0) put(one.pocket_heat * surface->force / force, *surface);
}

void HeatSources::add_land(const scene::CageSnapshot& cage, std::size_t k,
                           const Geometry& geometry) {
  const scene::LandSnapshot& land = cage.lands[k];
  if (land.heat == 0.0 || k >= geometry.lands.size()) return;
  const Geometry::Land& of = geometry.lands[k];
  const scene::Vec3 at =
      cage.position + turned(cage.orientation, {of.x, -of.radius * std::sin(land.angle),
                                                of.radius * std::cos(land.angle)});
  add(ADORE_CAGE_RACE, -1, of.race, land.heat, {at[0], at[1], at[2], 0.0, 0.0}, "guide land");
}

adore_adrx9 HeatSources::arguments() const {
  adore_adrx9 out{};
  out.step_size = step_size_;
  out.total_heat = total_heat_;
  out.n = static_cast<std::int64_t>(x_.size());
  out.x = x_.data();
  out.r = r_.data();
  out.theta = theta_.data();
  out.load = load_.data();
  out.contact_angle = angle_.data();
  out.sources = static_cast<std::int64_t>(heat_.size());
  out.source_kind = kind_.data();
  out.source_element = element_.data();
  out.source_race = race_.data();
  out.source_heat = heat_.data();
  out.source_place = place_.data();
  out.source_size = size_.data();
  out.source_name = name_.data();
  return out;
}

}  // namespace adore::user
