#include "setup/build_bearing.hpp"

#include "base/constants.hpp"
#include "contact/cage_inertia.hpp"
#include "contact/groove.hpp"
#include "contact/roller_pocket_play.hpp"
#include "contact/roller_shape.hpp"
#include "deck/lookup.hpp"
#include "setup/build_rollers.hpp"
#include "setup/check_pockets.hpp"
#include "setup/deck_text.hpp"
#include "setup/grade_oil.hpp"
#include "setup/lubricated.hpp"
#include "setup/race_motions.hpp"
#include "setup/read_cage.hpp"
#include "setup/user_lubricant.hpp"
#include "tribology/traction_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace adore::setup {
namespace {

using bearing::Bearing;
using bearing::Material;
using bearing::Part;
using deck::Deck;

/// A value in SI; one that does not act is read for the listing only.
double si_where(bool acts, const Deck& deck, std::string_view name) {
  const deck::ReportOnly quiet(deck, !acts);
  return deck.si(name);
}

/// Material of one part: its code, and for code 1 the deck's own record, whose variables share a
/// prefix and a suffix.
Material material(const Deck& deck, const char* code_variable, Part part, const std::string& prefix,
                  const std::string& suffix, const UserHooks* user) {
  const int code = static_cast<int>(deck.integer(code_variable));
  if (code == 2 && has_routine(user, 0))
    return user->material(part, bearing::material_from_table(0, part));
  if (code != 1) return bearing::material_from_table(code, part);
  const bool contact =
      part == Part::RollingElement || part == Part::OuterRace || part == Part::InnerRace;
  const bool wears = deck.integer("mode") >= 0 && part != Part::Housing && part != Part::Shaft;
  auto value = [&](const char* stem, bool acts = true) {
    const std::string name = prefix + stem + suffix;
    return deck.has(name) ? si_where(acts, deck, name) : 0.0;
  };
  Material out;
  out.code = 1;
  out.name = "given in the deck";
  out.density = value("Den");
  out.elastic_modulus = value("EM");
  out.poisson_ratio = value("PR");
  out.thermal_expansion = value("CTE");
  // Conduction of the rings, and patches of contacts that move over elements and races.
  const bool heat = deck.integer("kTherm") > 0;
  out.conductivity = value("TC", heat);
  out.specific_heat = value("SH", heat && contact);
  out.elastic_strain_limit = value("ESL", part != Part::Cage || deck.integer("mode") >= 0);
  out.wear_coefficient = value("WC", wears);
  out.fatigue_limit_stress = value("VM", contact);
  if (const std::string hardness = prefix + "H" + suffix; deck.has(hardness)) {
    const deck::ReportOnly quiet(deck, !wears);
    out.hardness = bearing::hardness_from_hrc(deck.real(hardness));
  }
  out.provenance = "deck";
  return out;
}

/// Record X3: single properties instead of those of the material.
void replace_properties(const Deck& deck, Bearing& bearing) {
  const std::array<Material*, 3> parts{&bearing.race_material[0], &bearing.race_material[1],
                                       &bearing.element_material};
  for (std::size_t k = 0; k < parts.size(); ++k) {
    Material& part = *parts[k];
    std::string replaced;
    for (const auto& [name, symbol, value] :
         {std::tuple{"matEM", "elastic modulus", &Material::elastic_modulus},
          std::tuple{"matPR", "Poisson ratio", &Material::poisson_ratio},
          std::tuple{"matDen", "density", &Material::density},
          std::tuple{"matCTE", "thermal expansion", &Material::thermal_expansion}}) {
      const int index = static_cast<int>(k) + 1;
      const deck::Value* given = deck::find_value(deck, name, 1, index);
      if (given == nullptr || std::holds_alternative<std::monostate>(*given)) continue;
      part.*value = deck.si(name, 1, index);
      replaced += (replaced.empty() ? "" : ", ") + std::string(symbol);
    }
    if (!replaced.empty()) part.name += fmt::format(" with given {}", replaced);
  }
}

/// Solid ball: m = ρπD³/6, I = m D²/10.
bearing::Inertia ball_inertia(double diameter, double density) {
  bearing::Inertia out;
  out.mass = density * kPi * diameter * diameter * diameter / 6.0;
  out.moments.setConstant(out.mass * diameter * diameter / 10.0);
  return out;
}

/// Hollow cylinder between two diameters: polar m(R²+r²)/2, transverse m(3(R²+r²)+w²)/12. The ideal
/// ring of N6: its groove is a small part of it and enters nothing but reports while races are
/// prescribed.
bearing::Inertia ring_inertia(double outer, double inner, double width, double density) {
  const double R2 = outer * outer / 4.0, r2 = inner * inner / 4.0;
  bearing::Inertia out;
  out.mass = density * kPi * (R2 - r2) * width;
  out.moments.x() = out.mass * (R2 + r2) / 2.0;
  out.moments.y() = out.moments.z() = out.mass * (3.0 * (R2 + r2) + width * width) / 12.0;
  return out;
}

/// `acts`: some result of this run depends on it.
bearing::TractionCurve curve(const Deck& deck, const char* type_variable, const std::string& stem,
                             bool acts) {
  const deck::ReportOnly quiet(deck, !acts);
  const int type = static_cast<int>(deck.integer(type_variable));
  const bool asymptote = type == 2;  // has three coefficients
  const std::array<double, 4> tc{deck.si(stem + "1"), deck.si(stem + "2"), deck.si(stem + "3"),
                                 si_where(!asymptote, deck, stem + "4")};
  return with_variable_location(deck, stem + "1",
                                [&] { return tribology::traction_curve(type, tc); });
}

/// Records 10.3 and 10.4.
bearing::Lubrication lubrication(const Deck& deck) {
  bearing::Lubrication out;
  out.code = static_cast<int>(deck.integer("kTrac"));
  constexpr int kUserLubricant = 9, kHotWalls = 12;
  if (out.code == kHotWalls) out.hot_walls = deck.integer("iTherm") == 1;
  out.meniscus = deck.si("strParam");
  out.critical_film = si_where(out.meniscus > 0.0, deck, "reRaceFilm");
  if (out.code == kGradeOil) {
    const std::optional<bearing::OilByGrade> oil = grade_oil_of(deck);
    if (!oil)
      throw InputError({deck.issue(Severity::Error, "kTrac",
                                   "selects the oil of record X2, but this record is missing",
                                   "give the oil in ADORE.json, such as {\"version\": 1, "
                                   "\"oilGrade\": 68}")});
    out.code = kUserLubricant;
    out.user = bearing::film_oil(*oil, 0.5 * (deck.si("raceTemp1") + deck.si("raceTemp2")));
    return out;
  }
  if (out.code != kUserLubricant) return out;
  bearing::UserLubricant user = user_lubricant(deck);
  const bool cools = deck.integer("kTherm") > 0 && deck.integer("kCoolant") == 1;
  user.density = si_where(cools || deck.integer("kChrn") == 1, deck, "lubDen");
  user.specific_heat = si_where(cools, deck, "lubSpHeat");
  out.user = user;
  return out;
}

/// Records 10.7A and 10.7B.
bearing::Churning churning(const Deck& deck) {
  bearing::Churning out;
  out.code = static_cast<int>(deck.integer("kChrn"));
  if (out.code == 2) {
    out.density = deck.si("chnDen");
    out.viscosity = deck.si("chnVis");
    return out;
  }
  for (const auto& [name, value] :
       {std::pair{"denRatio", &out.density_ratio}, std::pair{"visRatio", &out.viscosity_ratio}}) {
    *value = deck.si(name);
    if (!(*value > 0.0))
      throw InputError(
          {deck.issue(Severity::Error, name,
                      "is not above 0, so the medium causes no drag on elements and cage",
                      "give a ratio above 0, or set kChrn to 0")});
  }
  return out;
}

/// Records 7.0, 9.6 and 10.6; empty without films, and in segments (N72).
std::optional<bearing::CageFilms> cage_films(const Deck& deck, const Bearing& bearing) {
  if (deck.integer("nCseg") != 1) return {};
  bearing::CageFilms out;
  out.pockets = deck.integer("kPocHydro") == 1;
  const bool guided = std::any_of(
      bearing.cage->lands.begin(), bearing.cage->lands.end(),
      [](const bearing::GuideLand& land) { return land.guide != bearing::GuideLand::Guide::None; });
  out.lands = guided && deck.integer("kGsHydro") == 1;
  if (!out.pockets && !out.lands) return {};
  if (!bearing.lubrication) {
    out.pocket_viscosity = si_where(out.pockets, deck, "pocVis");
    out.land_viscosity = si_where(out.lands, deck, "gsVis");
  }
  if (out.pockets) out.largest_pocket_film = deck.si("pocLubFilm");
  constexpr double kThinnest = 1e-7;  // [m], decision 304
  out.critical_film =
      std::max(kThinnest, bearing.lubrication ? bearing.lubrication->critical_film : 0.0);
  return out;
}

/// Records 3.5, 9.7 and 9.8.
bearing::ThermalInputs thermal_inputs(const Deck& deck) {
  bearing::ThermalInputs out;
  const bool motion = deck.integer("mode") >= 0;
  out.coolant = static_cast<int>(deck.integer("kCoolant"));
  out.base = static_cast<int>(deck.integer("kBaseTemp"));
  out.base_temperature = deck.si("baseTemp");
  const bool flows = out.coolant > 0;
  out.flow = si_where(flows, deck, "cFlowRate");
  {
    const deck::ReportOnly quiet(deck, !flows || !(out.flow > 0.0));
    out.convection_given = deck.integer("kHTC") == 1;
    out.element_convection = si_where(out.convection_given, deck, "reHTC");
    out.cage_convection =
        si_where(out.convection_given && deck.integer("nCseg") > 0, deck, "cageHTC");
    if (flows && out.flow > 0.0 && out.convection_given)
      for (const auto& [name, value] :
           {std::pair{"reHTC", out.element_convection}, std::pair{"cageHTC", out.cage_convection}})
        if (!(value > 0.0) && (name[0] == 'r' || deck.integer("nCseg") > 0))
          throw InputError(
              {deck.issue(Severity::Error, name, "prevents heat transfer to the coolant",
                          "give a value above 0, or set kHTC = 0 to compute it")});
  }
  if (out.coolant == 2) {
    out.density = deck.si("xRo");
    out.viscosity = si_where(!out.convection_given, deck, "xMu");
    out.specific_heat = deck.si("xCp");
    out.conductivity = si_where(!out.convection_given, deck, "xK");
  }
  {
    out.geometry_every = static_cast<int>(deck.integer("kGeoMod"));
    const deck::ReportOnly quiet(deck, !motion);  // a steady state has no steps
    out.average_time = deck.si("aveTime");
    out.skip_time = si_where(out.geometry_every > 0, deck, "skipTime");
  }
  return out;
}

/// Guide faces of roller pockets (record 7.3).
std::vector<bearing::RollerPocketFace> pocket_faces(const Deck& deck) {
  std::vector<bearing::RollerPocketFace> faces;
  for (int i = 1; i <= deck.integer("kPocType"); ++i) {
    bearing::RollerPocketFace face;
    for (int k = 0; k < 3; ++k) {
      face.angles[k] = deck.si(fmt::format("bPocGsAng{}", k + 1), i);
      face.centre[k] = deck.si(fmt::format("bPocGsCen{}", k + 1), i);
    }
    face.width = deck.si("bPocGsLen1", i);
    face.length = deck.si("bPocGsLen2", i);
    faces.push_back(face);
  }
  return faces;
}

/// Record 7.7 where the deck gives it, else from the ideal shape. In a quasi-static solution, which
/// only reports it, a shape that cannot be cut leaves it zero.
bearing::Inertia cage_mass(const Deck& deck, const Bearing& bearing, bool dynamic) {
  if (deck.has("cageMass")) return read_inertia(deck, "cage", "");
  try {
    return with_variable_location(deck, "bPocCls1", [&] { return contact::cage_inertia(bearing); });
  } catch (const InputError&) {
    if (dynamic) throw;
    return {};
  }
}

bearing::Cage cage(const Deck& deck, const Bearing& bearing, const UserHooks* user) {
  bearing::Cage out =
      read_cage(deck, [&](std::string_view variable, int i) { return deck.si(variable, i); });
  // Guide faces count as windows of their smallest clearance.
  if (bearing.rollers() && deck.integer("kPocType") > 0) {
    out.pocket_faces = pocket_faces(deck);
    out.pocket_clearance_1 =
        contact::roller_pocket_play(out.pocket_faces, contact::roller_profile(*bearing.rollers()));
  }
  out.material = material(deck, "kCageMat", Part::Cage, "cage", "", user);
  if (deck.has("avRatio")) {
    const deck::ReportOnly quiet(deck, deck.integer("mode") < 0);  // statics moves no cage
    const auto start = [&deck](int piece) {
      bearing::CageStartState one;
      one.whirl_ratio = deck.si("wvRatio", piece);
      one.speed_ratio = deck.si("avRatio", piece);
      for (int k = 0; k < 3; ++k) {
        one.start_offset[k] = deck.si("cageGcPos", piece, k + 1);
        one.start_angles[k] = deck.si("cageAngPos", piece, k + 1);
      }
      return one;
    };
    static_cast<bearing::CageStartState&>(out) = start(1);
    for (int piece = 2; piece <= out.segments.count; ++piece)
      out.later_segment_starts.push_back(start(piece));
  }
  return out;
}

bearing::StaticConstraints constraints(const Deck& deck) {
  bearing::StaticConstraints out;
  constexpr const char* kFlags[] = {"kFS1", "kFS2", "kFS3", "kFS4", "kFS5"};
  constexpr const char* kLoads[] = {"appLoadX", "appLoadY", "appLoadZ", "appMomY", "appMomZ"};
  constexpr const char* kDisplacements[] = {"appDispX", "appDispY", "appDispZ", "appMis12",
                                            "appMis22"};
  for (int i = 0; i < 5; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const bool given = deck.integer(kFlags[i]) == 1;
    out.displacement_given[k] = given;
    out.load[k] = si_where(!given, deck, kLoads[i]);
    if (given) out.displacement[k] = deck.si(kDisplacements[i]);
  }
  out.outer_misalignment = {deck.si("appMis11"), deck.si("appMis21")};
  return out;
}

bearing::Mounting mounting(const Deck& deck, const UserHooks* user) {
  bearing::Mounting out;
  out.fit = {deck.si("raceFit1"), deck.si("raceFit2")};
  out.housing = material(deck, "kHsngMat", Part::Housing, "hsng", "", user);
  out.shaft = material(deck, "kShftMat", Part::Shaft, "shft", "", user);
  out.housing_temperature = deck.si("hsngTemp");
  out.shaft_temperature = deck.si("shftTemp");
  out.material_laws = deck.has("kMatPropMod") && deck.integer("kMatPropMod") == 1;
  return out;
}

/// Balls or rollers with their inertia.
void build_elements(const Deck& deck, Bearing& out) {
  const bool first_only = deck.has("bReMass") && deck.integer("kReIP") == 1;
  if (out.type == bearing::Type::Ball) {
    out.elements = build_ball_geometry(deck);
    out.element_inertia = ball_inertia(out.balls().diameter, out.element_material.density);
    if (deck.has("bReMass"))
      (first_only ? out.first_inertia.emplace() : out.element_inertia) =
          read_inertia(deck, "bRe", "");
    return;
  }
  out.elements = build_roller_geometry(deck);
  const RollerMassProperties mass =
      roller_mass_properties(*out.rollers(), out.element_material.density);
  out.element_inertia = mass.inertia;
  out.roller_mass_offset = mass.mass_offset;
  if (!deck.has("bReMass")) return;
  if (first_only) {
    out.first_inertia = read_inertia(deck, "bRe", "");
    return;
  }
  out.element_inertia = read_inertia(deck, "bRe", "");
  out.roller_mass_offset = -out.element_inertia.geometric_centre.x();
}

/// Of the groove bottoms, or of straight raceways under the middle of the rollers.
std::array<double, 2> raceway_diameters(const Bearing& b) {
  if (b.rollers())
    return {2.0 * b.rollers()->race_radius(bearing::kOuter),
            2.0 * b.rollers()->race_radius(bearing::kInner)};
  return {b.balls().pitch_diameter + b.balls().diameter,
          b.balls().pitch_diameter - b.balls().diameter};
}

}  // namespace

bearing::BallGeometry build_ball_geometry(const Deck& deck) {
  bearing::BallGeometry out;
  out.count = static_cast<int>(deck.integer("nRe"));
  out.diameter = deck.si("bReDia");
  out.pitch_diameter = deck.si("pitchDia");
  out.groove_factor = {deck.si("raceCurFac1"), deck.si("raceCurFac2")};
  out.shim = {deck.si("shimThickness1"), deck.si("shimThickness2")};
  out.shoulder_diameter = {deck.si("shoulderDia1"), deck.si("shoulderDia2")};
  // Until films are computed.
  const bool film = is_lubricated(deck);
  out.roughness = {si_where(film, deck, "rmsAspHt1"), si_where(film, deck, "rmsAspHt2")};
  const contact::FreeAngleAndClearance free = with_variable_location(deck, "freeIntCls", [&] {
    return contact::free_angle_and_clearance(
        out.diameter, out.groove_factor, out.shim, deck.si("freeConAng"),
        si_where(!(deck.si("freeConAng") > 0.0), deck, "freeIntCls"));
  });
  out.contact_angle = free.contact_angle;
  out.clearance = free.clearance;
  if (!(deck.si("freeConAng") > 0.0)) out.groove_plane = {0.0, 0.0};
  return out;
}

Bearing build_bearing(const Deck& deck, std::uint64_t seed, const UserHooks* user) {
  std::vector<Issue> issues = check_buildable(deck, user);
  std::erase_if(issues, [](const Issue& issue) { return issue.severity != Severity::Error; });
  if (!issues.empty()) throw InputError(std::move(issues));

  Bearing out;
  out.run_id = deck.text("runID");
  out.element_material = material(deck, "kReMat", Part::RollingElement, "re", "", user);
  out.race_material = {material(deck, "kRaceMat1", Part::OuterRace, "race", "1", user),
                       material(deck, "kRaceMat2", Part::InnerRace, "race", "2", user)};
  replace_properties(deck, out);
  if (deck.has("startAngle")) (void)deck.si("startAngle");  // acts in statics, which has no deck
  out.type = static_cast<bearing::Type>(deck.integer("kBrg"));
  out.envelope = {deck.si("brgBore"),
                  deck.si("brgOD"),
                  deck.si("shftID"),
                  deck.si("hsngOD"),
                  {deck.si("raceWidth1"), deck.si("raceWidth2")}};
  build_elements(deck, out);
  const auto [groove_bottom_outer, groove_bottom_inner] = raceway_diameters(out);
  const char* const cones =
      deck.has("raceTaper1") ? ", which follows from bReDia, raceTaper1 and raceTaper2" : "";
  // An interference of the size of the elements puts the races into each other.
  const double clearance = out.rollers() ? out.rollers()->clearance : out.balls().clearance;
  if (deck.has("freeIntCls") && clearance <= -2.0 * out.element_diameter())
    throw InputError({deck.issue(Severity::Error, "freeIntCls",
                                 "puts the outer raceway inside the inner raceway",
                                 fmt::format("give a value above {} (minus two element diameters)",
                                             length_text(deck, -2.0 * out.element_diameter())))});
  // Without material between groove and bore or outside, the ideal ring would have a negative mass.
  if (out.envelope.outer_diameter <= groove_bottom_outer)
    throw InputError(
        {deck.issue(Severity::Error, "brgOD", "is not larger than the outer raceway diameter",
                    fmt::format("give more than the raceway diameter, {}{}",
                                length_text(deck, groove_bottom_outer), cones))});
  if (out.envelope.bore >= groove_bottom_inner)
    throw InputError(
        {deck.issue(Severity::Error, "brgBore", "is not smaller than the inner raceway diameter",
                    fmt::format("give less than the raceway diameter, {}{}",
                                length_text(deck, groove_bottom_inner), cones))});
  out.race_inertia = {ring_inertia(out.envelope.outer_diameter, groove_bottom_outer,
                                   out.envelope.race_width[0], out.race_material[0].density),
                      ring_inertia(groove_bottom_inner, out.envelope.bore,
                                   out.envelope.race_width[1], out.race_material[1].density)};
  for (const std::size_t j : {0UL, 1UL})
    if (deck.has(j == 0 ? "raceMass1" : "raceMass2"))
      out.race_inertia[j] = read_race_inertia(deck, j == 0 ? 1 : 2);
  const bool dynamic = deck.integer("mode") >= 0;
  if (dynamic || deck.has("reRaceTC1"))
    out.race_traction = curve(deck, "kTracType", "reRaceTC", true);
  if (is_lubricated(deck)) out.lubrication = lubrication(deck);
  if (deck.integer("kChrn") > 0) out.churning = churning(deck);
  if (deck.integer("kTherm") > 0) out.thermal = thermal_inputs(deck);
  if (deck.integer("nCseg") > 0) out.cage = cage(deck, out, user);
  if (dynamic && deck.integer("nCseg") == 0)
    out.element_traction = curve(deck, "kRRTracType", "reReTC", true);
  if (dynamic && out.cage) {
    out.pocket_traction = curve(deck, "kCPTracType", "reCageTC", true);
    const bool guided = std::any_of(out.cage->lands.begin(), out.cage->lands.end(),
                                    [](const bearing::GuideLand& land) {
                                      return land.guide != bearing::GuideLand::Guide::None;
                                    });
    out.cage_films = cage_films(deck, out);
    if (guided) out.land_traction = curve(deck, "kCRTracType", "cageRaceTC", true);
  }
  out.constraints = constraints(deck);
  if ((dynamic || deck.has("reFlngTC1")) && out.rollers() != nullptr &&
      (out.rollers()->has_flange(0) || out.rollers()->has_flange(1))) {
    // At rest the flanges of cylindrical rollers carry nothing without thrust.
    const bool acts = dynamic || out.type != bearing::Type::Cylindrical ||
                      out.constraints.load[0] != 0.0 || out.constraints.displacement[0] != 0.0;
    out.flange_traction = curve(deck, "kRFTracType", "reFlngTC", acts);
  }
  if (deck.has("gravityVecX"))
    out.gravity = {deck.si("gravityVecX"), deck.si("gravityVecY"), deck.si("gravityVecZ")};
  const bearing::Vec3 of_fields = rotating_frame_load(deck, out.race_inertia) +
                                  race_weight(deck, out.race_inertia, out.gravity);
  for (std::size_t k = 0; k < 3; ++k)
    if (!out.constraints.displacement_given[k])
      out.constraints.load[k] += of_fields[static_cast<int>(k)];
  constexpr bearing::SpinRule kRules[] = {bearing::SpinRule::MinimumHeat,
                                          bearing::SpinRule::RaceControl,
                                          bearing::SpinRule::Prescribed};
  {
    const deck::ReportOnly quiet(deck, out.rollers() != nullptr);
    out.spin_rule = kRules[deck.integer("kAngVel")];
    out.spin_angle = si_where(out.spin_rule == bearing::SpinRule::Prescribed, deck, "angVelOrient");
  }
  out.speed = {deck.si("rpm1"), deck.si("rpm2")};
  out.room_temperature = deck.si("roomTemp");
  out.race_temperature = {deck.si("raceTemp1"), deck.si("raceTemp2")};
  out.element_temperature = deck.si("reTemp");
  out.cage_temperature = deck.si("cageTemp");
  out.mounting = mounting(deck, user);
  build_imperfections(deck, seed, out, user);
  if (out.cage) {
    check_pockets(deck, out);
    out.cage->inertia = cage_mass(deck, out, dynamic);
  }
  return out;
}

}  // namespace adore::setup
