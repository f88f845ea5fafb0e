#include "design/catalogue_ratings.hpp"

#include "base/constants.hpp"
#include "life/constants.hpp"
#include "life/iso281.hpp"

#include <fmt/format.h>

#include <numbers>

namespace adore::design {
namespace {

life::IsoGeometry geometry_of(const deck::RatedBearing& b) {
  life::IsoGeometry g;
  g.element_diameter = 1e3 * b.diameter;
  g.length = 1e3 * b.length;
  g.pitch_diameter = 1e3 * b.pitch;
  g.count = static_cast<int>(b.count);
  g.rows = b.rows;
  g.contact_angle = b.angle * kDegree;
  return g;
}

}  // namespace

CatalogueRatings catalogue_ratings(const deck::RatedBearing& b) {
  life::IsoGeometry g = geometry_of(b);
  const double thrust_groove = life::constants().table_conformity_thrust;
  constexpr double kNeedle = 1.1;  // b_m
  switch (b.type) {
    case deck::RatedBearingType::FourPoint:
    case deck::RatedBearingType::DoubleAngular:
      return {life::iso_dynamic_rating(g), life::iso_static_rating(g).value(), false};
    case deck::RatedBearingType::SelfAligning:
      // The outer race is a sphere: its radius is the limit 0.5 (1/gamma + 1) D of a groove. ISO
      // 281 takes 0.53, which changes C by less than 0.5 %.
      g.conformity_inner = 0.53;
      g.conformity_outer = 0.4999 * (1.0 / life::iso_gamma(g) + 1.0);
      return {life::iso_dynamic_rating(g), life::iso_self_aligning_static_rating(g), false};
    case deck::RatedBearingType::Needle:
      g.type = life::IsoType::RadialRoller;
      g.rating_factor = kNeedle;
      return {life::iso_dynamic_rating(g), life::iso_static_rating(g).value(), false};
    case deck::RatedBearingType::ThrustBall:
      g.type = life::IsoType::ThrustBall;
      g.conformity_inner = g.conformity_outer = thrust_groove;
      return {life::iso_dynamic_rating(g), life::iso_thrust_static_rating(g), true};
    case deck::RatedBearingType::ThrustRoller:
      break;
  }
  g.type = life::IsoType::ThrustRoller;
  g.rating_factor = 1.0;
  return {life::iso_dynamic_rating(g), life::iso_thrust_static_rating(g), true};
}

std::vector<std::string> describe_ratings(const deck::RatedBearing& b) {
  const CatalogueRatings r = catalogue_ratings(b);
  const auto mm = [](double value) { return 1e3 * value; };
  return {
      fmt::format("{}, {}: bore {:g} mm, outside diameter {:g} mm, {} {:g} mm ({}).", b.designation,
                  deck::rated_bearing_type_name(b.type), mm(b.envelope.bore),
                  mm(b.envelope.outside), r.axial ? "height" : "width", mm(b.envelope.width),
                  b.source),
      fmt::format("ESTIMATED internal geometry (manufacturers do not publish it): {} {} of "
                  "{:.4g} mm on a pitch circle of {:.4g} mm, contact angle {:.3g} degrees.",
                  b.count, b.rows > 1 ? "elements per row" : "elements", mm(b.diameter),
                  mm(b.pitch), b.angle),
      fmt::format("ESTIMATED {} load ratings (ISO 281, ISO 76): C {:.3g} kN, C0 {:.3g} kN.",
                  r.axial ? "axial" : "radial", 1e-3 * r.C, 1e-3 * r.C0),
      "Decks cannot describe this bearing type yet, so the bearing cannot be simulated. Use the "
      "calculators \"static-safety\", \"reference-speed\", \"minimum-load\" and \"iso281\"."};
}

}  // namespace adore::design
