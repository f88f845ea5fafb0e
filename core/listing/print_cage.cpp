#include "listing/print_cage.hpp"

#include "base/errors.hpp"
#include "contact/cage_inertia.hpp"
#include "contact/guide_land.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>

namespace adore::listing {
namespace {

using bearing::Bearing;
using bearing::Cage;
using bearing::CageClearance;
using bearing::GuideLand;
using bearing::PocketShape;

std::string pocket_name(const Cage& cage, bool rollers) {
  if (!rollers) return std::string(name_of(cage.pocket));
  if (cage.pocket == PocketShape::Cylindrical)
    return "cylinder around the roller (roller-guided cage)";
  const std::size_t pairs = cage.pocket_faces.size();
  if (pairs > 0) return fmt::format("{} pair{} of guide faces", pairs, pairs > 1 ? "s" : "");
  return "rectangular, parallel faces";
}

void lands(Report& report, const Cage& cage) {
  if (cage.lands.empty()) {
    report.text("There are no guide lands.");
    return;
  }
  report.heading("Guide lands");
  std::vector<Report::Row> rows;
  for (std::size_t i = 0; i < cage.lands.size(); ++i) {
    const GuideLand& land = cage.lands[i];
    const char* guide = land.guide == GuideLand::Guide::Outer   ? "outer race"
                        : land.guide == GuideLand::Guide::Inner ? "inner race"
                                                                : "none";
    rows.push_back({fmt::format("{} {}", i + 1, guide),
                    {land.diameter, land.width, land.edge, land.clearance}});
  }
  report.table("land",
               {{"cage dia", &unit::kLength},
                {"width", &unit::kLength},
                {"outer edge", &unit::kLength},
                {"dia clear", &unit::kLength}},
               rows, 14);
  for (std::size_t i = 0; i < cage.lands.size(); ++i) {
    const GuideLand& land = cage.lands[i];
    if (land.guide == GuideLand::Guide::None || land.ideal()) continue;
    const auto [c_least, c_most] =
        contact::land_deviation_range(contact::land_profile(0.5 * land.diameter, land.of_cage));
    const auto [r_least, r_most] =
        contact::land_deviation_range(contact::land_profile(0.5 * land.diameter, land.of_race));
    const bool outer = land.guide == GuideLand::Guide::Outer;
    const double c = 0.5 * land.clearance;
    report.item(fmt::format("Smallest radial clearance at land {} including form errors", i + 1),
                c + (outer ? r_least - c_most : c_least - r_most), unit::kLength);
    report.item(fmt::format("Largest radial clearance at land {} including form errors", i + 1),
                c + (outer ? r_most - c_least : c_most - r_least), unit::kLength);
  }
}

/// Mass and, of a conical cage, where its mass center lies; or why they are not known.
void mass(Report& report, const Bearing& bearing, bool given) {
  const Cage& cage = *bearing.cage;
  if (given) {
    report.item("Mass (record 7.7)", cage.inertia.mass, unit::kMass);
    return;
  }
  try {
    const contact::SolidInertia solid = contact::cage_solid_inertia(contact::cage_solid(bearing));
    report.item("Mass (from the ideal shape)", solid.mass, unit::kMass);
    if (cage.segments.several())
      report.item("Distance of the mass center of a segment from the bearing axis",
                  solid.mass_centre.z(), unit::kLength);
    if (cage.cone_angle != 0.0)
      report.item("Axial distance of the mass center from the middle of the cage",
                  solid.mass_centre.x(), unit::kLength);
    if (bearing.rollers())
      report.text(
          "Mass: the assumed pocket is as long as the roller. Its width is the mid-length roller "
          "diameter plus the pocket clearance.");
  } catch (const InputError& error) {
    report.text(fmt::format("The mass of the cage is unknown: {}.", error.what()));
  }
}

/// The clearance that a radially moving cage uses up first: of its lands or its pockets.
const CageClearance* least_play(const Bearing& bearing) {
  const CageClearance* out = nullptr;
  for (const CageClearance& play : bearing.operating->plays) {
    // Axial, or the wider end of a cone.
    const bool pocket_2 = play.name.starts_with("pocket clearance II");
    if (!pocket_2 && (out == nullptr || play.operating < out->operating)) out = &play;
  }
  return out;
}

}  // namespace

void print_cage_geometry(Report& report, const Bearing& bearing, const deck::Deck& deck) {
  if (!bearing.cage) {
    report.text("There is no cage.");
    return;
  }
  const Cage& cage = *bearing.cage;
  const bool rollers = bearing.rollers() != nullptr;
  report.heading("Cage");
  report.item("Outer diameter", cage.outer_diameter, unit::kLength);
  report.item("Inner diameter", cage.inner_diameter, unit::kLength);
  report.item("Width", cage.width, unit::kLength);
  report.item("Half cone angle (cage diameters are given at mid-width)", cage.cone_angle,
              unit::kAngle);
  report.item("Pocket shape", pocket_name(cage, rollers));
  report.item(!cage.pocket_faces.empty()
                  ? "Smallest pocket clearance between guide faces, diametral"
                  : "Pocket clearance I, diametral",
              cage.pocket_clearance_1, unit::kLength);
  if (!rollers)
    report.item("Pocket clearance II, diametral", cage.pocket_clearance_2, unit::kLength);
  report.item("Clearance to the outer race, diametral", cage.clearance_outer, unit::kLength);
  report.item("Clearance to the inner race, diametral", cage.clearance_inner, unit::kLength);
  if (cage.segments.several()) {
    report.item("Number of equal segments (mass and inertia: per segment)",
                static_cast<long>(cage.segments.count));
    report.item("Cut", cage.segments.through_pockets
                           ? fmt::format("through the pockets (first cut: pocket of element {})",
                                         cage.segments.first + 1)
                           : fmt::format("between the pockets (first cut: before element {})",
                                         cage.segments.first + 1));
    report.item("Angular width of a cut", cage.segments.cut_angle, unit::kAngle);
  }
  mass(report, bearing, deck.has("cageMass"));
  lands(report, cage);
}

void print_cage_operation(Report& report, const Bearing& bearing) {
  if (!bearing.cage || !bearing.operating) return;
  report.heading("Cage in operation");
  report.item("Cage speed (epicyclic)", bearing.operating->cage_speed, unit::kRotation);
  for (const CageClearance& play : bearing.operating->plays)
    report.item(fmt::format("Diametral clearance: {}", play.name), play.operating, unit::kLength);
  if (const CageClearance* least = least_play(bearing))
    report.item(
        "Effective cage clearance (smallest for radial motion)",
        fmt::format("{} {}, {}",
                    Report::number(from_si(least->operating, unit::kLength, report.units())),
                    unit_name(unit::kLength, report.units()), least->name));
  if (bearing.cage->inertia.mass > 0.0) {
    report.item("Cage mass", bearing.cage->inertia.mass, unit::kMass);
    report.item("Cage moment of inertia about x", bearing.cage->inertia.moments.x(),
                unit::kInertia);
    const auto& moments = bearing.cage->inertia.moments;
    if (bearing.cage->segments.several()) {
      report.item("Cage moment of inertia about y", moments.y(), unit::kInertia);
      report.item("Cage moment of inertia about z", moments.z(), unit::kInertia);
    } else {
      report.item("Cage moment of inertia about y and z", moments.y(), unit::kInertia);
    }
  }
}

nlohmann::ordered_json cage_json(const Bearing& bearing) {
  demand(bearing.cage && bearing.operating, "the bearing has no cage in operation");
  const Cage& cage = *bearing.cage;
  nlohmann::ordered_json out{{"speed [rad/s]", bearing.operating->cage_speed}};
  nlohmann::ordered_json plays = nlohmann::ordered_json::object();
  for (const CageClearance& play : bearing.operating->plays)
    plays[play.name + " [m]"] = play.operating;
  out["play, diametral"] = std::move(plays);
  if (const CageClearance* least = least_play(bearing))
    out["effective play"] = {{"of", least->name}, {"diametral [m]", least->operating}};
  const bool known = cage.inertia.mass > 0.0;
  using Json = nlohmann::ordered_json;
  if (cage.segments.several())
    out["segments, of which mass and moments are one's"] = cage.segments.count;
  out["mass [kg]"] = known ? Json(cage.inertia.mass) : Json(nullptr);
  out["moments of inertia x, y, z [kg m^2]"] =
      known ? Json({cage.inertia.moments.x(), cage.inertia.moments.y(), cage.inertia.moments.z()})
            : Json(nullptr);
  return out;
}

}  // namespace adore::listing
