#include "setup/build_rollers.hpp"

#include "contact/roller_inertia.hpp"
#include "contact/roller_shape.hpp"
#include "contact/tapered_geometry.hpp"
#include "setup/check_rollers.hpp"
#include "setup/deck_text.hpp"
#include "setup/lubricated.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace adore::setup {
namespace {

using bearing::Type;
using deck::Deck;

double given(const Deck& deck, const std::string& name) {
  return deck.has(name) ? deck.si(name) : 0.0;
}

/// A crown that starts inside the contact must reach its end.
void read_race_crowns(const Deck& deck, bearing::RollerGeometry& out) {
  for (std::size_t j = 0; j < 2; ++j) {
    const std::string crown = fmt::format("raceCrn{}", j + 1);
    out.race_crown_radius[j] = deck.si(crown);
    if (!(out.race_crown_radius[j] > 0.0)) continue;  // then raceCenLen plays no part
    out.race_central_length[j] = deck.si(fmt::format("raceCenLen{}", j + 1));
    const double reach =
        0.5 * (std::max(out.length, out.land_width[j]) - out.race_central_length[j]);
    if (!(out.race_crown_radius[j] > reach))
      throw InputError({deck.issue(Severity::Error, crown,
                                   "is too small: the crown would end within the "
                                   "raceway width",
                                   fmt::format("give more than {}, or 0 for a straight raceway",
                                               length_text(deck, reach)))});
  }
}

void read_profile(const Deck& deck, Type type, bearing::RollerGeometry& out) {
  const bool barrel = type == Type::Spherical || type == Type::SphericalTapered;
  out.shape = barrel ? bearing::RollerShape::Arc : bearing::RollerShape::Crowned;
  out.diameter = deck.si("bReDia");
  out.length = deck.si("bReLen");
  out.crown_radius = deck.si("bReCrn");
  if (!barrel && out.crown_radius == 0.0) {  // a straight roller: bReCenLen plays no part
    constexpr double kStraight = 1e10;       // [m]
    out.crown_radius = kStraight;
    out.central_length = out.length;
  } else {
    out.central_length = given(deck, "bReCenLen");
  }
  out.corner_radius = {given(deck, "bReCorRad1"), given(deck, "bReCorRad2")};
  out.end_radius = {given(deck, "bReEndRad1"), given(deck, "bReEndRad2")};
  if (barrel) {
    out.groove_factor = {deck.si("raceCurFac1"), deck.si("raceCurFac2")};
  } else {
    out.land_width = {deck.si("raceLandLmt1"), deck.si("raceLandLmt2")};
    for (const char* name : {"raceLandLmt1", "raceLandLmt2"}) {
      if (!(deck.si(name) > 0.0))
        throw InputError({deck.issue(Severity::Error, name, "is not a valid raceway width",
                                     "give the usable raceway width; a value of bReLen (roller "
                                     "length) or more does not limit the contact")});
    }
    read_race_crowns(deck, out);
  }
}

/// Contact angles and pitch circle of each type; cones share their apex (N38).
void read_races(const Deck& deck, Type type, bearing::RollerGeometry& out) {
  if (type == Type::Tapered || type == Type::SphericalTapered) {
    out.race_angle = {deck.si("raceTaper1"), deck.si("raceTaper2")};
    const contact::TaperedGeometry g = with_variable_location(deck, "raceTaper1", [&] {
      return contact::tapered_geometry(out.diameter, out.race_angle);
    });
    out.pitch_diameter = g.pitch_diameter;
    out.half_angle = g.half_angle;
    out.axis_angle = g.axis_angle;
    return;
  }
  out.pitch_diameter = deck.si("pitchDia");
  out.clearance = deck.si("freeIntCls");
  if (type == Type::Spherical) {
    out.axis_angle = deck.si("freeConAng");
    out.race_angle = {out.axis_angle, out.axis_angle};
  }
}

void read_flanges(const Deck& deck, bearing::RollerGeometry& out) {
  for (std::size_t race = 0; race < 2; ++race) {
    for (std::size_t side = 0; side < 2; ++side) {
      const std::string code = fmt::format("{}{}", side + 1, race + 1);
      if (deck.integer("kFlngInd" + code) != 1) continue;
      bearing::Flange flange;
      flange.layback = deck.si("flngAng" + code);
      flange.height = deck.si("flngHt" + code);
      out.flange[race][side] = flange;
    }
    if (out.flange[race][0] && out.flange[race][1])
      out.flange_play[race] = deck.si(fmt::format("flngCls{}", race + 1));
  }
}

}  // namespace

bearing::RollerGeometry build_roller_geometry(const Deck& deck) {
  const auto type = static_cast<Type>(deck.integer("kBrg"));
  bearing::RollerGeometry out;
  out.count = static_cast<int>(deck.integer("nRe"));
  read_profile(deck, type, out);
  read_races(deck, type, out);
  read_flanges(deck, out);
  check_roller_shape(deck, out);
  const deck::ReportOnly quiet(deck, !is_lubricated(deck));
  out.roughness = {deck.si("rmsAspHt1"), deck.si("rmsAspHt2")};
  return out;
}

RollerMassProperties roller_mass_properties(const bearing::RollerGeometry& rollers,
                                            double density) {
  const contact::RollerInertia i =
      contact::roller_inertia(contact::roller_profile(rollers), density);
  RollerMassProperties out;
  out.inertia.mass = i.mass;
  out.inertia.moments = {i.axial, i.transverse, i.transverse};
  out.mass_offset = i.mass_centre;
  return out;
}

}  // namespace adore::setup
