#include "results/channel_bands.hpp"
#include "results/channels.hpp"
#include "results/motion.hpp"
#include "scene/no_film.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

/// The table itself. Adding a quantity is one entry here (and one column in sol_columns.cpp when a
/// classic file has it); the items of the energy ledger come from the effects that make them.
namespace adore::results {
namespace {

using Source = ChannelSource;

/// All values of a channel in a separate loop, in the order of StepRecord: Get is called with the
/// indices that its `Per` needs.
template <Per P, int components, class Get>
void fill(Source s, const Shape& shape, double* out) {
  const auto some = [&](std::size_t& index, int count, auto&& inner) {
    for (index = 0; index < static_cast<std::size_t>(count); ++index) inner();
  };
  const auto values = [&] { some(s.component, components, [&] { *out++ = Get{}(s); }); };
  if constexpr (P == Per::Run || P == Per::Thermal)
    values();
  else if constexpr (P == Per::Element)
    some(s.element, shape.elements, values);
  else if constexpr (P == Per::Pair)
    some(s.element, shape.pairs, values);
  else if constexpr (P == Per::Contact)
    some(s.element, shape.elements, [&] { some(s.race, 2, values); });
  else if constexpr (P == Per::Second)
    some(s.element, shape.split ? shape.elements : 0, [&] { some(s.race, 2, values); });
  else if constexpr (P == Per::Flange)
    some(s.element, shape.rollers ? shape.elements : 0,
         [&] { some(s.race, 2, [&] { some(s.side, 2, values); }); });
  else if constexpr (P == Per::Pocket)
    some(s.element, shape.elements + shape.last_halves,
         [&] { some(s.surface, shape.pocket_surfaces, values); });
  else if constexpr (P == Per::Cage)
    some(s.cage, shape.cages, values);
  else if constexpr (P == Per::Land)
    some(s.cage, shape.cages, [&] { some(s.land, shape.lands, values); });
  else
    some(s.race, 2, values);
}
template <Per P, int components, class Get>
constexpr ChannelValues each(Get) {
  return {P, components, &fill<P, components, Get>};
}

OrbitMotion cage_orbit(const Source& s) {
  const scene::CageSnapshot& cage = s.cage_body();
  return orbit_motion(cage.position, cage.velocity, cage.acceleration);
}
OrbitMotion race_orbit(const Source& s) {
  const scene::RaceSnapshot& race = s.race_body();
  return orbit_motion(race.position, race.velocity, race.acceleration);
}
/// A speed over that of the faster race (N54); 0 when both races stand still.
double over_race_speed(const Source& s, double speed) {
  const double base = faster_race_speed(*s.snapshot);
  return base == 0.0 ? 0.0 : speed / base;
}
/// A life as a plot file of fixed width stores it: 9.9999999E+30 stands for infinity (N77).
double plotted_life(double life) { return std::isinf(life) ? 9.9999999e30 : life; }
double cage_clearance(const Source& s) {
  return cage_scale_length(*s.bearing->cage, s.unit_length);
}
/// Guide land values; lands that the cage does not have show 0.
template <class Get>
double land_value(const Source& s, std::size_t land, Get get) {
  const auto& lands = s.cage_body().lands;
  return land < lands.size() ? get(lands[land]) : 0.0;
}
double race_wear(const Source& s, double load_slip) {
  return average_wear_rate(s.bearing->race_material[s.race], load_slip, s.snapshot->time);
}

constexpr auto kTable = std::to_array<Channel>({
    // Rolling elements.
    {"element.orbital_acceleration", "orbital acceleration", &unit::kRotationRate, "N", false,
     each<Per::Element, 1>([](const Source& s) { return s.ball().theta_ddot; }),
     "second derivative of the azimuth of the mass center"},
    {"element.radial_acceleration", "radial acceleration", &unit::kAcceleration, "N", false,
     each<Per::Element, 1>([](const Source& s) { return s.ball().ar; }),
     "second derivative of the orbit radius"},
    {"element.axial_acceleration", "axial acceleration", &unit::kAcceleration, "N", false,
     each<Per::Element, 1>([](const Source& s) { return s.ball().ax; }),
     "acceleration of the mass center along the bearing axis"},
    {"element.orbital_velocity", "orbital velocity", &unit::kRotation, "N", false,
     each<Per::Element, 1>([](const Source& s) { return s.ball().theta_dot; }),
     "time derivative of the azimuth of the mass center"},
    {"element.radial_velocity", "radial velocity", &unit::kSpeed, "N", false,
     each<Per::Element, 1>([](const Source& s) { return s.ball().vr; }),
     "time derivative of the orbit radius"},
    {"element.axial_velocity", "axial velocity", &unit::kSpeed, "N", false,
     each<Per::Element, 1>([](const Source& s) { return s.ball().vx; }),
     "velocity of the mass center along the bearing axis"},
    {"element.orbital_position", "orbital position", &unit::kAngle, "N", false,
     each<Per::Element, 1>([](const Source& s) { return s.ball().theta; }),
     "azimuth of the mass center about +X, measured from +Z; not reset after a revolution"},
    {"element.radial_position", "radial position", &unit::kLength, "N", false,
     each<Per::Element, 1>([](const Source& s) { return s.ball().r; }),
     "distance of the mass center from the bearing axis"},
    {"element.axial_position", "axial position", &unit::kLength, "N", false,
     each<Per::Element, 1>([](const Source& s) { return s.ball().x; }),
     "position of the mass center along the bearing axis"},
    {"element.theta", "orientation theta", &unit::kAngle, "A", true,
     each<Per::Element, 1>([](const Source& s) { return direction_theta(s.ball().x_axis); }),
     "angle theta of the principal x axis of the element; 0 if the orientation is not integrated"},
    {"element.phi", "orientation phi", &unit::kAngle, "A", false,
     each<Per::Element, 1>([](const Source& s) { return direction_phi(s.ball().x_axis); }),
     "angle phi of the principal x axis of the element; 0 if the orientation is not integrated"},
    {"element.rotation", "total rotation", &unit::kAngle, "A", false,
     each<Per::Element, 1>([](const Source& s) { return s.ball().total_rotation; }),
     "rotation of the element about its principal x axis; 0 if the orientation is not integrated"},
    {"element.angular_velocity", "angular velocity", &unit::kRotation, "A", false,
     each<Per::Element, 1>([](const Source& s) { return s.ball().omega.norm(); }),
     "magnitude of the angular velocity vector"},
    {"element.angular_velocity_theta", "angular velocity theta", &unit::kAngle, "A", true,
     each<Per::Element, 1>([](const Source& s) { return direction_theta(s.ball().omega); }),
     "angle theta of the angular velocity vector"},
    {"element.angular_velocity_phi", "angular velocity phi", &unit::kAngle, "A", false,
     each<Per::Element, 1>([](const Source& s) { return direction_phi(s.ball().omega); }),
     "angle phi of the angular velocity vector"},
    {"element.orientation", "orientation quaternion", &unit::kPure, "N", false,
     each<Per::Element, 4>([](const Source& s) { return s.ball().orientation[s.component]; }),
     "rotation from the body frame to the base frame; identity if the orientation is not "
     "integrated"},
    {"element.angular_velocity_vector", "angular velocity vector", &unit::kRotation, "A", false,
     each<Per::Element, 3>(
         [](const Source& s) { return s.ball().omega[static_cast<int>(s.component)]; }),
     "absolute angular velocity"},
    {"element.pocket_to_centre", "pocket center to element center", &unit::kLength, "P", false,
     each<Per::Element, 3>(
         [](const Source& s) { return s.ball().pocket_to_centre[static_cast<int>(s.component)]; }),
     "vector from pocket center to element center; 0 without a cage"},
    {"element.pocket_heat", "pocket heat", &unit::kPower, "-", false,
     each<Per::Element, 1>([](const Source& s) { return s.ball().pocket_heat; }),
     "heat that friction and oil film dissipate in the pocket of the element"},
    // Element / race contacts, outer then inner.
    {"contact.load", "contact load", &unit::kForce, "-", false,
     each<Per::Contact, 1>([](const Source& s) { return s.contact().load; }), "normal load Q"},
    {"contact.angle", "contact angle", &unit::kAngle, "A", false,
     each<Per::Contact, 1>([](const Source& s) { return s.contact().angle; }), "0 without contact"},
    {"contact.spin_to_roll", "spin to roll ratio", &unit::kPure, "-", false,
     each<Per::Contact, 1>([](const Source& s) { return s.contact().spin_to_roll; }),
     "component of the relative angular velocity normal to the contact, divided by the component "
     "in the contact plane"},
    {"contact.slip", "largest slip velocity", &unit::kSpeed, "-", false,
     each<Per::Contact, 1>([](const Source& s) { return s.contact().max_slip; }),
     "largest slip velocity within the contact"},
    {"contact.heat", "contact heat", &unit::kPower, "-", false,
     each<Per::Contact, 1>([](const Source& s) { return s.contact().heat; }),
     "heat dissipated in the contact"},
    {"contact.rolling_heat", "rolling resistance heat", &unit::kPower, "-", false,
     each<Per::Contact, 1>([](const Source& s) { return s.contact().rolling_heat; }),
     "power of the rolling resistance of the oil; for a split race, the sum of both halves"},
    {"contact.damping_heat", "contact damping heat", &unit::kPower, "-", false,
     each<Per::Contact, 1>([](const Source& s) { return s.contact().damping_heat; }),
     "power dissipated by contact damping"},
    {"contact.film", "film thickness", &unit::kLength, "-", false,
     each<Per::Contact, 1>([](const Source& s) { return s.contact().film; }),
     "film thickness in the middle of the contact; 0 with a hypothetical traction law"},
    {"contact.least_film", "least film thickness", &unit::kLength, "-", false,
     each<Per::Contact, 1>([](const Source& s) { return s.contact().least_film; }),
     "smallest film thickness within the contact; 0 with a hypothetical traction law"},
    {"contact.film_parameter", "film parameter", &unit::kPure, "-", false,
     each<Per::Contact, 1>([](const Source& s) {
       const double lambda = s.contact().film_parameter;
       return lambda > scene::kNoFilmLeft ? lambda : 0.0;
     }),
     "smallest film thickness divided by the composite roughness; 0 without film or roughness"},
    {"contact.load_slip", "integral of load times slip", &unit::kPower, "-", false,
     each<Per::Contact, 1>([](const Source& s) { return s.contact().load_slip; }),
     "pressure times slip speed, integrated over the contact"},
    {"contact.temperature_rise", "contact temperature rise", &unit::kTemperature, "-", false,
     each<Per::Contact, 1>([](const Source& s) { return s.contact().temperature_rise; }),
     "contact temperature minus race temperature"},
    {"contact.temperature", "race contact temperature", &unit::kTemperature, "-", false,
     each<Per::Contact, 1>([](const Source& s) { return s.contact().contact_temperature; }),
     "race temperature plus contact temperature rise"},
    {"contact.half_major", "contact half width, transverse", &unit::kLength, "-", false,
     each<Per::Contact, 1>([](const Source& s) { return s.contact().half_major; }),
     "balls: half axis a of the contact ellipse; rollers: half the contact length"},
    {"contact.half_minor", "contact half width, rolling", &unit::kLength, "-", false,
     each<Per::Contact, 1>([](const Source& s) { return s.contact().half_minor; }),
     "balls: half axis b of the contact ellipse; rollers: half width of the slice with the largest "
     "pressure"},
    {"contact.pressure", "largest contact pressure", &unit::kPressure, "-", false,
     each<Per::Contact, 1>([](const Source& s) { return s.contact().max_pressure; }),
     "balls: pressure at the center of the contact ellipse; rollers: pressure of the slice with "
     "the largest pressure"},
    {"contact.edge", "contact edge position", &unit::kLength, "-", false,
     each<Per::Contact, 1>([](const Source& s) { return s.contact().edge; }),
     "depth s of the edge of the contact below the race shoulder"},
    {"contact.peak_position", "place of the largest pressure", &unit::kLength, "-", false,
     each<Per::Contact, 1>([](const Source& s) { return s.contact().peak_position; }),
     "axial distance of the largest pressure from the middle of the roller; 0 for balls"},
    // Balls on split races: contacts above are those with the half that carries more.
    {"second_contact.load", "second contact load", &unit::kForce, "-", false,
     each<Per::Second, 1>([](const Source& s) { return s.second().load; }),
     "normal load on the less loaded half of a split race; 0 without contact"},
    {"second_contact.angle", "second contact angle", &unit::kAngle, "A", false,
     each<Per::Second, 1>([](const Source& s) { return s.second().angle; }), "0 without contact"},
    {"second_contact.spin_to_roll", "second contact spin to roll ratio", &unit::kPure, "-", false,
     each<Per::Second, 1>([](const Source& s) { return s.second().spin_to_roll; }),
     "component of the relative angular velocity normal to the contact, divided by the component "
     "in the contact plane"},
    {"second_contact.heat", "second contact heat", &unit::kPower, "-", false,
     each<Per::Second, 1>([](const Source& s) { return s.second().heat; }),
     "heat dissipated in the contact"},
    {"second_contact.slip", "second contact slip velocity", &unit::kSpeed, "-", false,
     each<Per::Second, 1>([](const Source& s) { return s.second().max_slip; }),
     "largest slip velocity within the contact ellipse"},
    {"second_contact.film", "second contact film thickness", &unit::kLength, "-", false,
     each<Per::Second, 1>([](const Source& s) { return s.second().film; }),
     "film thickness; 0 with a hypothetical traction law"},
    {"second_contact.load_slip", "second contact load times slip", &unit::kPower, "-", false,
     each<Per::Second, 1>([](const Source& s) { return s.second().load_slip; }),
     "pressure times slip speed, integrated over the contact"},
    {"second_contact.temperature_rise", "second contact temperature rise", &unit::kTemperature, "-",
     false, each<Per::Second, 1>([](const Source& s) { return s.second().temperature_rise; }),
     "contact temperature minus race temperature"},
    {"second_contact.temperature", "second contact temperature", &unit::kTemperature, "-", false,
     each<Per::Second, 1>([](const Source& s) { return s.second().contact_temperature; }),
     "race temperature plus contact temperature rise"},
    {"second_contact.half_major", "second contact half width, transverse", &unit::kLength, "-",
     false, each<Per::Second, 1>([](const Source& s) { return s.second().half_major; }),
     "half axis a of the untruncated contact ellipse"},
    {"second_contact.half_minor", "second contact half width, rolling", &unit::kLength, "-", false,
     each<Per::Second, 1>([](const Source& s) { return s.second().half_minor; }),
     "half axis b of the untruncated contact ellipse"},
    {"second_contact.pressure", "second contact largest pressure", &unit::kPressure, "-", false,
     each<Per::Second, 1>([](const Source& s) { return s.second().max_pressure; }),
     "pressure at the center of the untruncated contact ellipse"},
    // Roller ends at the flanges of the races, -x side then +x side.
    {"flange.force", "flange force", &unit::kForce, "-", false,
     each<Per::Flange, 1>([](const Source& s) { return s.flange().force; }),
     "normal force between roller end and flange; 0 where the race has no flange"},
    {"flange.gap", "flange gap", &unit::kLength, "-", false,
     each<Per::Flange, 1>(
         [](const Source& s) { return std::isfinite(s.flange().gap) ? s.flange().gap : 0.0; }),
     "distance between roller end and flange, negative in contact; 0 where the race has no flange"},
    {"flange.heat", "flange heat", &unit::kPower, "-", false,
     each<Per::Flange, 1>([](const Source& s) { return s.flange().heat; }),
     "heat dissipated in the contact of roller end and flange"},
    {"flange.damping_heat", "flange damping heat", &unit::kPower, "-", false,
     each<Per::Flange, 1>([](const Source& s) { return s.flange().damping_heat; }),
     "power dissipated by contact damping"},
    {"flange.slip", "flange slip velocity", &unit::kSpeed, "-", false,
     each<Per::Flange, 1>([](const Source& s) { return s.flange().slip; }),
     "slip velocity of the contact point; 0 without contact"},
    {"flange.load_slip", "flange load times slip", &unit::kPower, "-", false,
     each<Per::Flange, 1>([](const Source& s) { return s.flange().load_slip; }),
     "load times slip speed; 0 without contact"},
    {"flange.height", "flange contact height", &unit::kLength, "-", false,
     each<Per::Flange, 1>([](const Source& s) { return s.flange().height; }),
     "height of the point on the flange face that is nearest to the roller end"},
    // Pockets, one value per guide surface.
    {"pocket.force", "pocket force", &unit::kForce, "-", false,
     each<Per::Pocket, 1>([](const Source& s) { return s.pocket().force; }),
     "normal force of the cage on the element"},
    {"pocket.gap", "pocket gap", &unit::kLength, "-", false,
     each<Per::Pocket, 1>([](const Source& s) { return s.pocket().gap; }),
     "gap between element and pocket; negative in contact"},
    {"pocket.theta", "pocket contact angle theta", &unit::kAngle, "P", false,
     each<Per::Pocket, 1>([](const Source& s) { return s.pocket().theta; }),
     "0: the cage drives the element; 180 deg: the element drives the cage"},
    {"pocket.phi", "pocket contact angle phi", &unit::kAngle, "P", false,
     each<Per::Pocket, 1>([](const Source& s) { return s.pocket().phi; }),
     "conical pocket: cone angle; spherical pocket: latitude of the contact; cylindrical pocket: "
     "0"},
    {"pocket.position", "pocket contact position", &unit::kLength, "P", false,
     each<Per::Pocket, 1>([](const Source& s) { return s.pocket().position; }),
     "axial position of the contact on the roller surface; 0 for balls"},
    // Elements and the ones behind them in the ring, without cage.
    {"neighbour.force", "force between elements", &unit::kForce, "-", false,
     each<Per::Pair, 1>([](const Source& s) { return s.pair().force; }),
     "normal force on the next rolling element"},
    {"neighbour.gap", "gap between elements", &unit::kLength, "-", false,
     each<Per::Pair, 1>([](const Source& s) { return s.pair().gap; }),
     "gap to the next rolling element; negative in contact"},
    // Cage.
    {"cage.whirl_ratio", "whirl ratio", &unit::kPure, "N", false,
     each<Per::Cage, 1>(
         [](const Source& s) { return over_race_speed(s, cage_orbit(s).theta_dot); }),
     "whirl speed of the cage center divided by the speed of the faster race; for a cage segment, "
     "the center of the complete cage is used"},
    {"cage.radial_velocity", "radial velocity", &unit::kSpeed, "N", false,
     each<Per::Cage, 1>([](const Source& s) { return cage_orbit(s).r_dot; }),
     "radial velocity of the cage center; for a cage segment, the center of the complete cage is "
     "used"},
    {"cage.axial_velocity", "axial velocity", &unit::kSpeed, "N", false,
     each<Per::Cage, 1>([](const Source& s) { return s.cage_body().velocity.x(); }),
     "axial velocity of the cage center; for a cage segment, the center of the complete cage is "
     "used"},
    {"cage.land1_force", "land 1 force", &unit::kForce, "-", false,
     each<Per::Cage, 1>(
         [](const Source& s) { return land_value(s, 0, [](const auto& l) { return l.force; }); }),
     "normal force between cage and race"},
    {"cage.land1_gap", "land 1 gap", &unit::kLength, "-", false,
     each<Per::Cage, 1>(
         [](const Source& s) { return land_value(s, 0, [](const auto& l) { return l.gap; }); }),
     "gap between cage and race; negative in contact"},
    {"cage.land1_angle", "land 1 contact angle", &unit::kAngle, "K", false,
     each<Per::Cage, 1>(
         [](const Source& s) { return land_value(s, 0, [](const auto& l) { return l.angle; }); }),
     "azimuth of the smallest gap"},
    {"cage.land2_force", "land 2 force", &unit::kForce, "-", false,
     each<Per::Cage, 1>(
         [](const Source& s) { return land_value(s, 1, [](const auto& l) { return l.force; }); }),
     "normal force between cage and race"},
    {"cage.land2_gap", "land 2 gap", &unit::kLength, "-", false,
     each<Per::Cage, 1>(
         [](const Source& s) { return land_value(s, 1, [](const auto& l) { return l.gap; }); }),
     "gap between cage and race; negative in contact"},
    {"cage.land2_angle", "land 2 contact angle", &unit::kAngle, "K", false,
     each<Per::Cage, 1>(
         [](const Source& s) { return land_value(s, 1, [](const auto& l) { return l.angle; }); }),
     "azimuth of the smallest gap"},
    {"cage.orbital_acceleration", "orbital acceleration", &unit::kRotationRate, "N", false,
     each<Per::Cage, 1>([](const Source& s) { return cage_orbit(s).theta_ddot; }),
     "angular acceleration of the cage center about the bearing axis; for a cage segment, the "
     "center of the complete cage is used"},
    {"cage.radial_acceleration", "radial acceleration", &unit::kAcceleration, "N", false,
     each<Per::Cage, 1>([](const Source& s) { return cage_orbit(s).r_ddot; }),
     "second derivative of the radial position"},
    {"cage.axial_acceleration", "axial acceleration", &unit::kAcceleration, "N", false,
     each<Per::Cage, 1>([](const Source& s) { return s.cage_body().acceleration.x(); }),
     "axial acceleration of the cage center; for a cage segment, the center of the complete cage "
     "is used"},
    {"cage.x_over_clearance", "x position / clearance", &unit::kPure, "N", false,
     each<Per::Cage, 1>(
         [](const Source& s) { return s.cage_body().position.x() / cage_clearance(s); }),
     "position of the cage divided by the mean radial clearance of the guide lands; without guided "
     "lands, divided by half of pocket clearance I"},
    {"cage.y_over_clearance", "y position / clearance", &unit::kPure, "N", false,
     each<Per::Cage, 1>(
         [](const Source& s) { return s.cage_body().position.y() / cage_clearance(s); }),
     "position of the cage divided by the mean radial clearance of the guide lands; without guided "
     "lands, divided by half of pocket clearance I"},
    {"cage.z_over_clearance", "z position / clearance", &unit::kPure, "N", false,
     each<Per::Cage, 1>(
         [](const Source& s) { return s.cage_body().position.z() / cage_clearance(s); }),
     "position of the cage divided by the mean radial clearance of the guide lands; without guided "
     "lands, divided by half of pocket clearance I"},
    {"cage.orbital_position", "orbital position", &unit::kAngle, "N", true,
     each<Per::Cage, 1>([](const Source& s) { return cage_orbit(s).theta; }),
     "azimuth of the cage center; for a cage segment, the center of the complete cage is used"},
    {"cage.radial_position", "radial position", &unit::kLength, "N", false,
     each<Per::Cage, 1>([](const Source& s) { return cage_orbit(s).r; }),
     "radial position of the cage center; for a cage segment, the center of the complete cage is "
     "used"},
    {"cage.axial_position", "axial position", &unit::kLength, "N", false,
     each<Per::Cage, 1>([](const Source& s) { return s.cage_body().position.x(); }),
     "axial position of the cage center; for a cage segment, the center of the complete cage is "
     "used"},
    {"cage.theta", "orientation theta", &unit::kAngle, "N", true,
     each<Per::Cage, 1>(
         [](const Source& s) { return direction_theta(body_x_axis(s.cage_body().orientation)); }),
     "angle theta of the cage axis"},
    {"cage.phi", "orientation phi", &unit::kAngle, "N", false,
     each<Per::Cage, 1>(
         [](const Source& s) { return direction_phi(body_x_axis(s.cage_body().orientation)); }),
     "angle phi of the cage axis"},
    {"cage.rotation", "total rotation", &unit::kAngle, "K", false,
     each<Per::Cage, 1>([](const Source& s) { return s.cage_body().total_rotation; }),
     "rotation about the cage axis"},
    {"cage.speed_ratio", "angular velocity ratio", &unit::kPure, "N", false,
     each<Per::Cage, 1>(
         [](const Source& s) { return std::abs(over_race_speed(s, s.cage_body().omega.norm())); }),
     "magnitude of the angular velocity of the cage divided by the speed of the faster race"},
    {"cage.angular_velocity_theta", "angular velocity theta", &unit::kAngle, "N", true,
     each<Per::Cage, 1>([](const Source& s) { return direction_theta(s.cage_body().omega); }),
     "angle theta of the angular velocity vector"},
    {"cage.angular_velocity_phi", "angular velocity phi", &unit::kAngle, "N", false,
     each<Per::Cage, 1>([](const Source& s) { return direction_phi(s.cage_body().omega); }),
     "angle phi of the angular velocity vector"},
    {"cage.position", "position", &unit::kLength, "N", false,
     each<Per::Cage, 3>(
         [](const Source& s) { return s.cage_body().position[static_cast<int>(s.component)]; }),
     "position of the cage center; for a cage segment, the center of the complete cage is used"},
    {"cage.velocity", "velocity", &unit::kSpeed, "N", false,
     each<Per::Cage, 3>(
         [](const Source& s) { return s.cage_body().velocity[static_cast<int>(s.component)]; }),
     "velocity of the cage center; for a cage segment, the center of the complete cage is used"},
    {"cage.orientation", "orientation quaternion", &unit::kPure, "N", false,
     each<Per::Cage, 4>([](const Source& s) { return s.cage_body().orientation[s.component]; }),
     "rotation from the body frame to the base frame"},
    {"cage.angular_velocity", "angular velocity vector", &unit::kRotation, "N", false,
     each<Per::Cage, 3>(
         [](const Source& s) { return s.cage_body().omega[static_cast<int>(s.component)]; }),
     "absolute angular velocity"},
    {"cage.to_next", "gap to the next segment", &unit::kLength, "-", false,
     each<Per::Cage, 1>([](const Source& s) { return s.cage_body().to_next; }),
     "smallest circumferential gap between the ends of neighboring segments; negative: overlap; 0 "
     "for a one-piece cage"},
    {"land.force", "guide land force", &unit::kForce, "-", false,
     each<Per::Land, 1>([](const Source& s) {
       return land_value(s, s.land, [](const auto& l) { return l.force; });
     }),
     "normal force between cage and race"},
    {"land.gap", "guide land gap", &unit::kLength, "-", false,
     each<Per::Land, 1>([](const Source& s) {
       return land_value(s, s.land, [](const auto& l) { return l.gap; });
     }),
     "gap between cage and race; negative in contact"},
    {"land.angle", "guide land contact angle", &unit::kAngle, "K", false,
     each<Per::Land, 1>([](const Source& s) {
       return land_value(s, s.land, [](const auto& l) { return l.angle; });
     }),
     "azimuth of the smallest gap"},
    {"land.film_force", "guide land film force", &unit::kForce, "-", false,
     each<Per::Land, 1>([](const Source& s) {
       return land_value(s, s.land, [](const auto& l) { return l.film_force; });
     }),
     "force of the oil film between cage and race; 0 without hydrodynamics (kGsHydro)"},
    {"land.attitude", "guide land attitude angle", &unit::kAngle, "-", false,
     each<Per::Land, 1>([](const Source& s) {
       return land_value(s, s.land, [](const auto& l) { return l.attitude; });
     }),
     "angle from the position of the smallest gap to the direction of the film force"},
    {"land.heat", "guide land heat", &unit::kPower, "-", false,
     each<Per::Land, 1>([](const Source& s) {
       return land_value(s, s.land, [](const auto& l) { return l.heat; });
     }),
     "heat that friction and oil film dissipate at the guide land"},
    // Races, outer then inner.
    {"race.whirl_speed", "whirl speed", &unit::kRotation, "N", false,
     each<Per::Race, 1>([](const Source& s) { return race_orbit(s).theta_dot; }),
     "whirl speed of the mass center about the bearing axis"},
    {"race.radial_velocity", "radial velocity", &unit::kSpeed, "N", false,
     each<Per::Race, 1>([](const Source& s) { return race_orbit(s).r_dot; }),
     "radial velocity of the mass center"},
    {"race.axial_velocity", "axial velocity", &unit::kSpeed, "N", false,
     each<Per::Race, 1>([](const Source& s) { return s.race_body().velocity.x(); }),
     "axial velocity of the mass center"},
    {"race.applied_force_x", "applied force x", &unit::kForce, "N", false,
     each<Per::Race, 1>([](const Source& s) { return s.race_body().applied_force.x(); }),
     "force on this race"},
    {"race.applied_force_y", "applied force y", &unit::kForce, "N", false,
     each<Per::Race, 1>([](const Source& s) { return s.race_body().applied_force.y(); }),
     "force on this race"},
    {"race.applied_force_z", "applied force z", &unit::kForce, "N", false,
     each<Per::Race, 1>([](const Source& s) { return s.race_body().applied_force.z(); }),
     "force on this race"},
    {"race.applied_moment_x", "applied moment x", &unit::kMoment, "N", false,
     each<Per::Race, 1>([](const Source& s) { return s.race_body().applied_moment.x(); }),
     "moment on this race about its center"},
    {"race.applied_moment_y", "applied moment y", &unit::kMoment, "N", false,
     each<Per::Race, 1>([](const Source& s) { return s.race_body().applied_moment.y(); }),
     "moment on this race about its center"},
    {"race.applied_moment_z", "applied moment z", &unit::kMoment, "N", false,
     each<Per::Race, 1>([](const Source& s) { return s.race_body().applied_moment.z(); }),
     "moment on this race about its center"},
    {"race.orbital_acceleration", "orbital acceleration", &unit::kRotationRate, "N", false,
     each<Per::Race, 1>([](const Source& s) { return race_orbit(s).theta_ddot; }),
     "angular acceleration of the mass center about the bearing axis"},
    {"race.radial_acceleration", "radial acceleration", &unit::kAcceleration, "N", false,
     each<Per::Race, 1>([](const Source& s) { return race_orbit(s).r_ddot; }),
     "second derivative of the radial position"},
    {"race.axial_acceleration", "axial acceleration", &unit::kAcceleration, "N", false,
     each<Per::Race, 1>([](const Source& s) { return s.race_body().acceleration.x(); }),
     "axial acceleration of the mass center"},
    {"race.x", "x position", &unit::kLength, "N", false,
     each<Per::Race, 1>([](const Source& s) { return s.race_body().position.x(); }),
     "displacement of the mass center from its position in the unmounted bearing"},
    {"race.y", "y position", &unit::kLength, "N", false,
     each<Per::Race, 1>([](const Source& s) { return s.race_body().position.y(); }),
     "displacement of the mass center from its position in the unmounted bearing"},
    {"race.z", "z position", &unit::kLength, "N", false,
     each<Per::Race, 1>([](const Source& s) { return s.race_body().position.z(); }),
     "displacement of the mass center from its position in the unmounted bearing"},
    {"race.orbital_position", "orbital position", &unit::kAngle, "N", true,
     each<Per::Race, 1>([](const Source& s) { return race_orbit(s).theta; }),
     "azimuth of the mass center"},
    {"race.radial_position", "radial position", &unit::kLength, "N", false,
     each<Per::Race, 1>([](const Source& s) { return race_orbit(s).r; }),
     "radial position of the mass center"},
    {"race.axial_position", "axial position", &unit::kLength, "N", false,
     each<Per::Race, 1>([](const Source& s) { return s.race_body().position.x(); }),
     "axial position of the mass center"},
    {"race.theta", "orientation theta", &unit::kAngle, "N", true,
     each<Per::Race, 1>(
         [](const Source& s) { return direction_theta(body_x_axis(s.race_body().orientation)); }),
     "angle theta of the race axis"},
    {"race.phi", "orientation phi", &unit::kAngle, "N", false,
     each<Per::Race, 1>(
         [](const Source& s) { return direction_phi(body_x_axis(s.race_body().orientation)); }),
     "angle phi of the race axis"},
    {"race.rotation", "total rotation", &unit::kAngle, "N", false,
     each<Per::Race, 1>([](const Source& s) { return s.race_body().total_rotation; }),
     "rotation about the race axis"},
    {"race.angular_velocity", "angular velocity", &unit::kRotation, "N", false,
     each<Per::Race, 1>([](const Source& s) { return s.race_body().omega.norm(); }),
     "magnitude of the angular velocity vector"},
    {"race.angular_velocity_theta", "angular velocity theta", &unit::kAngle, "N", true,
     each<Per::Race, 1>([](const Source& s) { return direction_theta(s.race_body().omega); }),
     "angle theta of the angular velocity vector"},
    {"race.angular_velocity_phi", "angular velocity phi", &unit::kAngle, "N", false,
     each<Per::Race, 1>([](const Source& s) { return direction_phi(s.race_body().omega); }),
     "angle phi of the angular velocity vector"},
    {"race.orientation", "orientation quaternion", &unit::kPure, "N", false,
     each<Per::Race, 4>([](const Source& s) { return s.race_body().orientation[s.component]; }),
     "rotation from the body frame to the base frame"},
    {"race.wear_rate", "average wear rate", &unit::kVolumeFlow, "-", false,
     each<Per::Race, 1>([](const Source& s) {
       return race_wear(s, s.snapshot->power.qv_race[s.race] + s.snapshot->power.qv_flange[s.race]);
     }),
     "wear rate of the race and its flanges, averaged since time zero"},
    {"race.flange_wear_rate", "average wear rate of the flanges", &unit::kVolumeFlow, "-", false,
     each<Per::Race, 1>(
         [](const Source& s) { return race_wear(s, s.snapshot->power.qv_flange[s.race]); }),
     "wear rate of the flanges of the race, averaged since time zero; 0 without flanges"},
    {"race.temperature", "bulk temperature", &unit::kTemperature, "-", false,
     each<Per::Race, 1>([](const Source& s) { return s.bearing->race_temperature[s.race]; }),
     "bulk temperature of the race"},
    // The whole bearing.
    {"power.loss", "power loss", &unit::kPower, "-", false,
     each<Per::Run, 1>([](const Source& s) { return s.snapshot->power.total_loss; }),
     "current total dissipation"},
    {"power.churning_fraction", "churning fraction", &unit::kPure, "-", false,
     each<Per::Run, 1>([](const Source& s) { return s.snapshot->power.churning_fraction; }),
     "churning and drag losses divided by the power loss"},
    {"power.life", "fatigue life", &unit::kLife, "-", false,
     each<Per::Run, 1>([](const Source& s) { return plotted_life(s.snapshot->power.life_hours); }),
     "fatigue life for the loads of the last life prediction (kLifeFreq); 9.9999999E+30: infinite "
     "life; 0: no life model is active"},
    {"power.element1_wear_rate", "average wear rate, rolling element 1", &unit::kVolumeFlow, "-",
     false, each<Per::Run, 1>([](const Source& s) {
       const scene::PowerSnapshot& p = s.snapshot->power;
       return average_wear_rate(
           s.bearing->element_material,
           p.qv_element1[0] + p.qv_element1[1] + p.qv_element1_flange[0] + p.qv_element1_flange[1],
           s.snapshot->time);
     }),
     "wear rate of rolling element 1 at both races and their flanges, averaged since time zero"},
    {"power.cage_wear_rate", "average wear rate, cage", &unit::kVolumeFlow, "-", false,
     each<Per::Run, 1>([](const Source& s) {
       return s.bearing->cage ? average_wear_rate(s.bearing->cage->material,
                                                  s.snapshot->power.qv_cage, s.snapshot->time)
                              : 0.0;
     }),
     "wear rate of the cage at pockets and guide lands, averaged since time zero"},
    {"power.element_temperature", "rolling element bulk temperature", &unit::kTemperature, "-",
     false, each<Per::Run, 1>([](const Source& s) { return s.bearing->element_temperature; }),
     "rolling elements"},
    {"power.cage_temperature", "cage bulk temperature", &unit::kTemperature, "-", false,
     each<Per::Run, 1>([](const Source& s) { return s.bearing->cage_temperature; }), "cage"},
    // Thermal analysis.
    {"thermal.coolant_inlet", "coolant inlet temperature", &unit::kTemperature, "-", false,
     each<Per::Thermal, 1>([](const Source& s) { return s.thermal().coolant_in; }),
     "temperature of the last thermal step"},
    {"thermal.coolant_exit", "coolant exit temperature", &unit::kTemperature, "-", false,
     each<Per::Thermal, 1>([](const Source& s) { return s.thermal().coolant_out; }),
     "temperature of the last thermal step"},
    {"thermal.outside_diameter", "bearing outside diameter temperature", &unit::kTemperature, "-",
     false, each<Per::Thermal, 1>([](const Source& s) { return s.thermal().outside; }),
     "temperature of the outer race at the housing"},
    {"thermal.bore", "bearing bore temperature", &unit::kTemperature, "-", false,
     each<Per::Thermal, 1>([](const Source& s) { return s.thermal().bore; }),
     "temperature of the inner race at the shaft"},
    {"thermal.housing", "housing outside diameter temperature", &unit::kTemperature, "-", false,
     each<Per::Thermal, 1>([](const Source& s) { return s.thermal().housing; }),
     "temperature of the last thermal step"},
    {"thermal.total_heat", "average total heat", &unit::kPower, "-", false,
     each<Per::Thermal, 1>([](const Source& s) { return s.thermal().heat; }),
     "heat averaged over the last thermal step"},
    {"thermal.coolant_heat", "average heat to the coolant", &unit::kPower, "-", false,
     each<Per::Thermal, 1>([](const Source& s) { return s.thermal().coolant_heat; }),
     "heat averaged over the last thermal step"},
    {"thermal.outer_heat", "average heat to the outer race", &unit::kPower, "-", false,
     each<Per::Thermal, 1>([](const Source& s) { return s.thermal().race_heat[0]; }),
     "heat through the race, averaged over the last thermal step"},
    {"thermal.inner_heat", "average heat to the inner race", &unit::kPower, "-", false,
     each<Per::Thermal, 1>([](const Source& s) { return s.thermal().race_heat[1]; }),
     "heat through the race, averaged over the last thermal step"},
    // SOL7 has fixed columns; these are in RESULTS.h5.
    {"thermal.outer_raceway", "outer raceway surface temperature", &unit::kTemperature, "-", false,
     each<Per::Thermal, 1>([](const Source& s) { return s.thermal().raceway[0]; }),
     "temperature of the last thermal step"},
    {"thermal.inner_raceway", "inner raceway surface temperature", &unit::kTemperature, "-", false,
     each<Per::Thermal, 1>([](const Source& s) { return s.thermal().raceway[1]; }),
     "temperature of the last thermal step"},
    {"thermal.outer_film", "outer contact film temperature", &unit::kTemperature, "-", false,
     each<Per::Thermal, 1>([](const Source& s) { return s.thermal().film[0]; }),
     "mean temperature of all contacts in the last thermal step; NaN before the first thermal step "
     "and with thermalModel=ladder"},
    {"thermal.inner_film", "inner contact film temperature", &unit::kTemperature, "-", false,
     each<Per::Thermal, 1>([](const Source& s) { return s.thermal().film[1]; }),
     "mean temperature of all contacts in the last thermal step; NaN before the first thermal step "
     "and with thermalModel=ladder"},
    {"thermal.housing_mean", "housing mean temperature", &unit::kTemperature, "-", false,
     each<Per::Thermal, 1>([](const Source& s) { return s.thermal().housing_mean; }),
     "temperature of the last thermal step"},
    {"thermal.shaft_mean", "shaft mean temperature", &unit::kTemperature, "-", false,
     each<Per::Thermal, 1>([](const Source& s) { return s.thermal().shaft_mean; }),
     "temperature of the last thermal step"},
    {"thermal.medium", "temperature of oil or air in the bearing", &unit::kTemperature, "-", false,
     each<Per::Thermal, 1>([](const Source& s) { return s.thermal().medium; }),
     "temperature of the last thermal step"},
});

}  // namespace

std::span<const Channel> channels() {
  static const std::vector<Channel> all = with_band_channels(kTable);
  return all;
}

ChannelTable::ChannelTable(scene::LedgerTerms energy)
    : channels_(channels().begin(), channels().end()) {
  using scene::LedgerKind;
  const auto ids = std::make_shared<std::deque<std::string>>();
  const auto add = [&](const char* group, const scene::LedgerTerm* term, const UnitPair& unit,
                       ChannelValues values, std::string_view help) {
    channels_.push_back({ids->emplace_back(fmt::format("{}.{}", group, term->id)), term->label,
                         &unit, term->frame, false, values, help, term});
  };
  constexpr auto rate =
      each<Per::Run, 1>([](const Source& s) { return s.snapshot->energy.rate(s.term->id); });
  constexpr auto value =
      each<Per::Run, 1>([](const Source& s) { return s.snapshot->energy.value(s.term->id); });
  constexpr auto of_races = each<Per::Race, 1>([](const Source& s) {
    return s.snapshot->energy.value(s.term->id, static_cast<int>(s.race));
  });
  for (const scene::LedgerTerm* term : energy)
    if (term->kind == LedgerKind::Heat && !term->per_race())
      add("power", term, unit::kPower, rate, "current dissipation");
  for (const scene::LedgerTerm* term : energy)
    add("energy", term, unit::kEnergy, term->per_race() ? of_races : value, term->help);
  channels_.push_back(
      {"energy.residual", "energy residual", &unit::kEnergy, "-", false,
       each<Per::Run, 1>([](const Source& s) { return s.snapshot->energy.residual(); }),
       "work minus heat minus change of stored energy"});
  ids_ = ids;
}

ChannelTable ChannelTable::only(std::span<const std::string_view> ids) const {
  ChannelTable out = *this;
  std::erase_if(out.channels_, [&](const Channel& channel) {
    return std::find(ids.begin(), ids.end(), channel.id) == ids.end();
  });
  return out;
}

}  // namespace adore::results
