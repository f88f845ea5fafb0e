#include "listing/print_flange_wear.hpp"

#include "base/errors.hpp"
#include "bearing/material.hpp"
#include "contact/race_surface.hpp"
#include "contact/roller_shape.hpp"
#include "contact/slice_circle.hpp"
#include "statics/roller_flanges.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace adore::listing {
namespace {

using Vec3 = Eigen::Vector3d;

/// Place and size of a loaded contact [m].
struct Place {
  double height = 0.0;       ///< up the face
  double radius = 0.0;       ///< from the bearing axis
  double from_axis = 0.0;    ///< from the roller axis
  double half_length = 0.0;  ///< of the ellipse up the face; 0: no contact
};

Place place_of(const statics::FlangeEndPair& pair, const scene::Snapshot& snapshot,
               const bearing::Bearing& bearing, double load) {
  const auto j = static_cast<std::size_t>(pair.race);
  const scene::ElementSnapshot& roller = snapshot.elements.front();
  const double s = std::sin(roller.theta), c = std::cos(roller.theta);
  // Azimuth frame: x, y = -e_θ, z = e_r.
  const Vec3 &v = roller.x_axis, axis(v[0], v[1] * c - v[2] * s, v[1] * s + v[2] * c);
  const Vec3 centre =
      Vec3(roller.x, -roller.r * s, roller.r * c) - bearing.roller_mass_offset * axis;
  const scene::Quat& q = snapshot.races[j].orientation;
  const contact::RacePose pose{snapshot.races[j].position,
                               Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix()};
  const Vec3 C = pose.point(centre), of_race = pose.direction(axis);
  double r = 0.0;
  const contact::MeridianRotation turn = contact::meridian_rotation(C[1], C[2], r);
  const contact::Triple<double> a = turn.to_meridian({of_race[0], of_race[1], of_race[2]});
  const Vec3 in_meridian(a.x, a.y, a.z);
  const contact::FlangeContact at =
      contact::flange_contact_for_forces(pair.face, pair.end, {C[0], 0.0, r}, in_meridian);
  if (!(at.gap < 0.0)) return {};
  const contact::FlangeLoad hertz = contact::flange_load(
      pair.end, in_meridian, at,
      bearing::contact_modulus(bearing.element_material, bearing.race_material[j]));
  // The longer axis goes along the flatter direction; a corner is a tube around the end.
  const bool longest_up = at.mode == contact::FlangeContact::Mode::Face &&
                          at.surface == contact::FlangeContact::Surface::Cap &&
                          hertz.curvature.along < hertz.curvature.across;
  const double size = longest_up ? hertz.hertz.a_hat : hertz.hertz.b_hat;
  return {at.height, std::hypot(at.point[1], at.point[2]), at.from_axis, size * std::cbrt(load)};
}

/// Volume per friction length and load [m³/J].
double wear_per_work(const bearing::Material& material) {
  return material.hardness > 0.0 ? material.wear_coefficient / material.hardness : 0.0;
}

void print_contact(Report& report, const Place& place, bool outer, double of_flange, double of_end,
                   double load_slip) {
  constexpr int kPlaces = 9;
  const double outward = outer ? -1.0 : 1.0;  // up the face, away from the bearing axis
  const auto depth = [](double rate, double r) {
    return r > 0.0 ? rate / (2.0 * std::numbers::pi * r) : std::numeric_limits<double>::quiet_NaN();
  };
  std::vector<Report::Row> rows;
  for (int k = 0; k < kPlaces; ++k) {
    const double s = 2.0 * k / (kPlaces - 1) - 1.0, y = s * place.half_length;
    const double line = 0.75 * load_slip / place.half_length * (1.0 - s * s);  // q u [W/m]
    const double radius = place.radius + outward * y, from_axis = place.from_axis - y;
    rows.push_back({std::to_string(k + 1),
                    {place.height + y, radius, depth(of_flange * line, radius), from_axis,
                     depth(of_end * line, from_axis)}});
  }
  report.table("place",
               {{"height", &unit::kLength},
                {"radius", &unit::kLength},
                {"flange", &unit::kSpeed},
                {"from axis", &unit::kLength},
                {"end", &unit::kSpeed}},
               rows);
  report.item("Current wear rate of the flange from contact with roller 1", of_flange * load_slip,
              unit::kVolumeFlow);
  report.item("Current wear rate of the end of roller 1 at this flange", of_end * load_slip,
              unit::kVolumeFlow);
}

}  // namespace

void print_flange_wear(Report& report, const scene::Snapshot& snapshot,
                       const bearing::Bearing& bearing) {
  const bearing::RollerGeometry* rollers = bearing.rollers();
  if (rollers == nullptr || !(rollers->has_flange(0) || rollers->has_flange(1))) return;
  std::array<double, 2> E_star{};
  for (std::size_t j = 0; j < 2; ++j)
    E_star[j] = bearing::contact_modulus(bearing.element_material, bearing.race_material[j]);
  const auto pairs = statics::flange_end_pairs(
      bearing.type, *rollers, E_star, contact::roller_profile(*rollers, rollers->deviation_of(0)));
  for (const statics::FlangeEndPair& pair : pairs) {
    const auto j = static_cast<std::size_t>(pair.race);
    const scene::FlangeContactSnapshot& flange =
        snapshot.elements.front().flange[j][static_cast<std::size_t>(pair.side)];
    report.heading(fmt::format(
        "1c. Wear depth per time on the end of roller 1 and on the {} race flange, {}x side",
        j == 0 ? "outer" : "inner", pair.side == 0 ? "-" : "+"));
    const Place place =
        flange.force > 0.0 ? place_of(pair, snapshot, bearing, flange.force) : Place{};
    if (!(place.half_length > 0.0))
      report.item("No contact", "no wear");
    else
      print_contact(report, place, j == 0, wear_per_work(bearing.race_material[j]),
                    wear_per_work(bearing.element_material), flange.load_slip);
  }
}

}  // namespace adore::listing
