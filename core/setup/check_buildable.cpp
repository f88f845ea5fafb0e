#include "base/constants.hpp"
#include "bearing/material_laws.hpp"
#include "contact/ball_pocket.hpp"
#include "contact/tapered_geometry.hpp"
#include "setup/build_bearing.hpp"
#include "setup/check_rollers.hpp"
#include "setup/deck_text.hpp"
#include "setup/race_motions.hpp"
#include "setup/read_cage.hpp"
#include "tribology/film_law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>

namespace adore::setup {
namespace {

using deck::Deck;

/// One switch that only some codes are simulated of.
struct Gate {
  const char* variable;
  long long supported;  ///< the code that is simulated
  const char* asks_for;
};

// A deck with another code parses and checks clean, but cannot run.
constexpr Gate kAlways[] = {
    {"kRaceFlex", 0, "a flexible outer race"},
};
/// A code that hands a part of the physics to a routine of the user.
struct Request {
  std::string_view variable;
  long long code;
  int routine;  ///< ADRXn
  const char* otherwise;
  bool motion_only;
};

constexpr Request kRequests[] = {
    {"kReMat", 2, 0, "0, 1 or a code of the material table", false},
    {"kRaceMat1", 2, 0, "0, 1 or a code of the material table", false},
    {"kRaceMat2", 2, 0, "0, 1 or a code of the material table", false},
    {"kHsngMat", 2, 0, "0, 1 or a code of the material table", false},
    {"kShftMat", 2, 0, "0, 1 or a code of the material table", false},
    {"kCageMat", 2, 0, "0, 1 or a code of the material table", false},
    {"kDOF", 6, 1, "a value from 0 to 5", true},
    {"kRaceGeoImp1", 3, 6, "0, 1 or 2", false},
    {"kRaceGeoImp2", 3, 6, "0, 1 or 2", false},
    {"kTrac", -1, 7, "0 or a lubricant", true},
    {"kCPTrac", -1, 7, "0", true},
    {"kCRTrac", -1, 7, "0", true},
    {"kRFTrac", -1, 7, "0", true},
    {"kRRTrac", -1, 7, "0", true},
    {"kReGeoImp", 3, 8, "0, 1 or 2", false},
    {"kCagePocImp", 4, 8, "0, 1, 2 or 3", true},
    {"kReIP", 3, 8, "0, 1 or 2", true},
};

class Checker {
 public:
  explicit Checker(const Deck& deck) : deck_(deck) {}

  void gates(std::span<const Gate> gates) {
    for (const Gate& gate : gates)
      if (deck_.has(gate.variable) && deck_.integer(gate.variable) != gate.supported)
        error(gate.variable,
              fmt::format("specifies {}, which this version does not simulate yet", gate.asks_for),
              fmt::format("set {} to {}", gate.variable, gate.supported));
  }

  void error(const char* variable, std::string message, std::string remedy) {
    issues_.push_back(
        deck_.issue(Severity::Error, variable, std::move(message), std::move(remedy)));
  }
  void warning(const char* variable, std::string message, std::string remedy = {}) {
    issues_.push_back(
        deck_.issue(Severity::Warning, variable, std::move(message), std::move(remedy)));
  }

  /// A warning of a value without effect: finding deck.no_effect.
  void no_effect(const std::string& variable, std::string message, std::string remedy,
                 int index = 1) {
    Issue issue =
        deck_.issue(Severity::Warning, variable, std::move(message), std::move(remedy), index);
    issue.code = "deck.no_effect";
    add(std::move(issue));
  }

  void note(const char* variable, std::string message) {
    issues_.push_back(deck_.issue(Severity::Note, variable, std::move(message), {}));
  }

  void add(Issue issue) { issues_.push_back(std::move(issue)); }

  std::vector<Issue> take() { return std::move(issues_); }

 private:
  const Deck& deck_;
  std::vector<Issue> issues_;
};

/// A code for a user routine needs a plug-in that has it. Code is loaded from the command line
/// only: the deck cannot name it.
void check_requests(const Deck& deck, const UserHooks* user, Checker& check) {
  const bool dynamic = deck.integer("mode") >= 0;
  const deck::ReportOnly quiet(deck,
                               !dynamic);  // reading this value is not an effect in an equilibrium
  for (const Request& request : kRequests) {
    const std::string variable(request.variable);
    if (!deck.has(variable) || deck.integer(variable) != request.code) continue;
    if ((request.motion_only && !dynamic) || has_routine(user, request.routine)) continue;
    const std::string asks = fmt::format("needs user routine ADRX{}", request.routine);
    const std::string otherwise = fmt::format("set {} to {}", variable, request.otherwise);
    check.error(variable.c_str(),
                user == nullptr ? asks + ", but no plug-in was given"
                                : fmt::format("{}, which {} does not have or does not activate",
                                              asks, user->source),
                fmt::format("give a plug-in that has the missing routine, with --user PLUG-IN "
                            "(`adore user new adrx{}` writes an example), or {}",
                            request.routine, otherwise));
  }
}

/// The contact law of a half (contact/split_race.hpp) has no waves.
void check_split_races(const Deck& deck, Checker& check) {
  for (const char* race : {"1", "2"}) {
    const std::string shim = std::string("shimThickness") + race;
    const std::string errors = std::string("kRaceGeoImp") + race;
    if (!deck.has(shim) || !(deck.si(shim) > 0.0) || deck.integer(errors) == 0) continue;
    check.error(shim.c_str(),
                fmt::format("a split race cannot have geometric errors ({} = {})", errors,
                            deck.integer(errors)),
                fmt::format("give {} = 0 or {} = 0", shim, errors));
  }
}

/// A wave that does not close: allowed, but hardly meant. In motion no finite force lifts an
/// element over its step.
void check_waves(const Deck& deck, Checker& check) {
  for (const char* race : {"1", "2"}) {
    const bool sinusoidal = deck.integer(std::string("kRaceGeoImp") + race) == 2;
    for (const char* stem : {"rndVar", "cFacVar", "rlOffset", "rlTaper"}) {
      const std::string amplitude = std::string(stem) + "1" + race;
      const std::string waves = std::string(stem) + "2" + race;
      const bool wave = sinusoidal || std::string_view(stem) != "rndVar";
      if (!wave || !deck.has(amplitude) || deck.real(amplitude) == 0.0) continue;
      const std::string phase = std::string(stem) + "3" + race;
      if (deck.real(waves) == 0.0 && std::abs(std::sin(deck.si(phase))) < 1e-9)
        check.no_effect(
            amplitude,
            fmt::format("has no effect: {} = 0 waves and phase {} = {:.6g} degrees make "
                        "the deviation zero everywhere",
                        waves, phase, deck.real(phase)),
            fmt::format("give a number of waves in {}, or a phase of 90 degrees for a "
                        "constant deviation",
                        waves));
      if (deck.real(waves) == std::round(deck.real(waves))) continue;
      const std::string step =
          "is not a whole number of waves per revolution: the surface has a step at the z axis of "
          "the race";
      if (deck.integer("mode") >= 0)
        check.error(waves.c_str(), step, "give a whole number of waves per revolution");
      else
        check.warning(waves.c_str(), step);
    }
  }
}

/// Temperatures outside the laws of a table material: the laws are clamped there.
void check_law_ranges(const Deck& deck, Checker& check) {
  if (!deck.has("kMatPropMod") || deck.integer("kMatPropMod") != 1) return;
  using bearing::Part;
  struct Place {
    const char* temperature;
    const char* code;
    Part part;
  };
  constexpr Place kPlaces[] = {
      {"hsngTemp", "kHsngMat", Part::Housing},     {"shftTemp", "kShftMat", Part::Shaft},
      {"raceTemp1", "kRaceMat1", Part::OuterRace}, {"raceTemp2", "kRaceMat2", Part::InnerRace},
      {"reTemp", "kReMat", Part::RollingElement},  {"cageTemp", "kCageMat", Part::Cage}};
  for (const Place& place : kPlaces) {
    const int code = static_cast<int>(deck.integer(place.code));
    if (code == 1 || code == 2 || !deck.has(place.temperature) || !deck.has(place.code)) continue;
    const bearing::Material material = bearing::material_from_table(code, place.part);
    const double T = deck.si(place.temperature);
    std::string laws;
    for (const bearing::ClampedLaw& law : bearing::clamped_laws(material, T))
      laws += fmt::format("{}{} ({} to {})", laws.empty() ? "" : ", ", law.property,
                          temperature_text(deck, law.T_min), temperature_text(deck, law.T_max));
    if (!laws.empty())
      check.warning(place.temperature,
                    fmt::format("is outside the known range of the properties of {}: {}. The value "
                                "at the nearer end of the range is used for each property",
                                material.name, laws));
  }
}

/// The same deviation in all pockets; that of single ones is looked at in operation.
void check_pocket_errors(const Deck& deck, Checker& check) {
  if (!deck.has("bPocClsVar1") || deck.integer("kCagePocImp") != 2) return;
  if (deck.integer("kBrg") != 1 && deck.integer("kPocType") > 0) return;  // bPocCls1 has no part
  const double given = deck.si("bPocCls1"), left = given + deck.si("bPocClsVar1");
  if (given >= 0.0 && left < 0.0)
    check.warning("bPocClsVar1", fmt::format("makes every pocket smaller than its rolling "
                                             "element, which is then clamped: bPocCls1 + "
                                             "bPocClsVar1 = {}",
                                             length_text(deck, left)));
}

/// Errors of a guide land and of its race: waves that close, on lands that stay nearly round.
void check_land_errors(const Deck& deck, Checker& check) {
  const deck::ReportOnly quiet(deck);
  const bearing::Cage cage =
      read_cage(deck, [&](std::string_view name, int instance) { return deck.si(name, instance); });
  constexpr double kMaxWaveShare = 0.05;  // of the radius, and of the slope
  constexpr double kMaxWaves = 1000.0;
  for (std::size_t i = 0; i < cage.lands.size(); ++i) {
    const bearing::GuideLand& land = cage.lands[i];
    if (land.guide == bearing::GuideLand::Guide::None) continue;
    const int index = static_cast<int>(i) + 1;
    const double radius = 0.5 * land.diameter;
    if (!land.ideal() && deck.integer("kGsHydro") == 1)
      check.error("kGsHydro",
                  "computes films of round guide lands only, but a guide land has shape errors",
                  "set kGsHydro to 0, or set kCageGsImp and kRaceGsImp to 0");
    for (const auto& [stem, errors] :
         {std::pair{"cageGsRadVar", &land.of_cage}, {"raceGsRadVar", &land.of_race}}) {
      if (errors->ideal()) continue;
      const std::array<double, 3>& v = errors->variation;
      const auto variable = [stem = stem](int k) { return fmt::format("{}{}", stem, k); };
      const auto error = [&](int k, std::string message, std::string remedy) {
        check.add(
            deck.issue(Severity::Error, variable(k), std::move(message), std::move(remedy), index));
      };
      if (errors->roundness == bearing::RaceErrors::Roundness::Elliptical) {
        for (const int k : {1, 2})
          if (std::abs(v[static_cast<std::size_t>(k - 1)]) > kMaxWaveShare * radius)
            error(k,
                  fmt::format("makes land {} too elliptical: the contact law of guide lands is "
                              "valid for deviations up to 1/20 of the radius",
                              index),
                  fmt::format("give an absolute value of at most {}",
                              length_text(deck, kMaxWaveShare * radius)));
        continue;
      }
      if (v[1] != std::round(v[1]))
        error(
            2,
            fmt::format(
                "is not a whole number of waves per revolution: the profile of land {} has a step",
                index),
            "give a whole number of waves per revolution");
      if (std::abs(v[1]) > kMaxWaves)
        error(
            2,
            fmt::format("exceeds the number of waves that the contact law of guide land {} allows",
                        index),
            fmt::format("give at most {:g} waves per revolution", kMaxWaves));
      if (v[1] == 0.0 && std::abs(std::sin(v[2])) < 1e-9)
        check.no_effect(
            variable(1),
            fmt::format("has no effect: {} = 0 waves and phase {} = {:.6g} degrees make the "
                        "deviation zero everywhere",
                        variable(2), variable(3), v[2] * 180.0 / std::numbers::pi),
            fmt::format("give a number of waves in {}, or a phase of 90 degrees for a constant "
                        "deviation",
                        variable(2)),
            index);
      const double most = kMaxWaveShare * radius / std::max(1.0, std::abs(v[1]));
      if (std::abs(v[0]) > most)
        error(1,
              fmt::format("makes the waves on guide land {} too high or too steep: the contact law "
                          "is valid for slopes up to 1/20 and heights up to 1/20 of the radius",
                          index),
              fmt::format("give an absolute value of at most {}", length_text(deck, most)));
    }
  }
}

/// Do the cuts of a segmented cage leave of bars and pockets what contacts need? Half pockets: an
/// opening that the element does not touch on both sides at once.
bool cut_fits(const Deck& deck, const bearing::Cage& cage, double angle) {
  const double D = deck.si("bReDia");
  const double d_m = deck.has("pitchDia") ? deck.si("pitchDia")
                                          : contact::tapered_geometry(
                                                D, {deck.si("raceTaper1"), deck.si("raceTaper2")})
                                                .pitch_diameter;
  const bool rollers = deck.integer("kBrg") != 1;
  const double width = D + cage.pocket_clearance_1;
  const bool elongated = !rollers && cage.pocket == bearing::PocketShape::Elongated;
  const double reach = width + (elongated ? std::max(cage.pocket_clearance_2, 0.0) : 0.0);
  if (!cage.segments.through_pockets)
    return angle < 2.0 * kPi / static_cast<double>(deck.integer("nRe")) -
                       2.0 * std::asin(std::min(reach / d_m, 1.0));
  const double edge = 0.5 * d_m * std::tan(0.5 * angle);
  if (!(2.0 * edge < reach)) return false;
  if (rollers)
    return cage.pocket == bearing::PocketShape::Rectangular ||
           width * width - 4.0 * edge * edge >= D * D;
  const auto [low, high] =
      contact::pocket_wall_limits(cage.outer_diameter, cage.inner_diameter, d_m);
  return contact::cut_opening_half_width({cage.pocket, D, cage.pocket_clearance_1,
                                          cage.pocket_clearance_2, low, high, 1, edge}) >= 0.5 * D;
}

void check_segments(const Deck& deck, Checker& check) {
  const deck::ReportOnly quiet(deck);
  const bearing::Cage cage =
      read_cage(deck, [&](std::string_view name, int instance) { return deck.si(name, instance); });
  const double cut = cage.segments.cut_angle;
  if (cut == 0.0)
    check.warning("cageAngCut",
                  "leaves no gap between the segments. Contact between segments is not modeled, so "
                  "the ends of moving segments overlap",
                  "give the angle of the cut between two segments");
  for (std::size_t i = 0; i < cage.lands.size(); ++i)
    if (cage.lands[i].guide != bearing::GuideLand::Guide::None && cage.lands[i].clearance < 0.0)
      check.error("cageGsCls",
                  fmt::format("gives guide land {} an interference with its race around the full "
                              "circumference, which only a one-piece cage can have",
                              i + 1),
                  "give 0 or more");
  if (deck.has("cageMass") && deck.real("cageGeoCenZ") == 0.0)
    check.warning("cageGeoCenZ",
                  "puts the mass center of every segment on the bearing axis. Record 7.7 describes "
                  "one segment, with the z axis through the middle of the segment",
                  "give the distance of the mass center from the bearing axis as a negative value, "
                  "or set kCageIP to 0");
  const bool faces = deck.integer("kBrg") != 1 && deck.integer("kPocType") > 0;
  if (faces || cut_fits(deck, cage, cut)) return;
  double most = 0.0, bad = cut;
  for (int n = 0; n < 40; ++n) {
    const double middle = 0.5 * (most + bad);
    (cut_fits(deck, cage, middle) ? most : bad) = middle;
  }
  const std::string limit = fmt::format("give at most {:.4g} degrees",
                                        std::floor(most * 180.0 / std::numbers::pi * 1e4) / 1e4);
  if (!cage.segments.through_pockets)
    check.error("cageAngCut", "is wider than the bars between the pockets", limit);
  else
    check.error(
        "cageAngCut",
        "makes the half pockets too narrow: the opening touches the rolling element on both sides",
        fmt::format("{}, or cut the cage between the pockets (positive numbers in lSeg)",
                    most > 0.0 ? limit : "give more pocket clearance"));
}

/// Limits of the motion of unequal elements.
void check_moving_elements(const Deck& deck, bool rollers, Checker& check) {
  if (deck.integer("kReGeoImp") == 0) return;
  if (rollers)
    check.note("kReGeoImp",
               "the contacts of each roller use its actual shape; mass and moments of inertia are "
               "those of the nominal roller");
  else if (deck.integer("kTrac") != 0)
    check.note("kReGeoImp",
               "the contacts of each ball use its actual diameter; film thickness and traction of "
               "the lubricant are those of the nominal ball");
}

void check_lubricant(const Deck& deck, Checker& check) {
  const deck::ReportOnly quiet(deck);
  if (deck.integer("kTrac") <= 0) return;
  if (deck.si("strParam") == 0.0)
    check.note("strParam",
               "leaves no oil at the contact inlets: the contacts have no film, and record 10.1 "
               "defines their traction. For flooded inlets, enter 10 or more");
  else if (deck.si("reRaceFilm") < tribology::kThinnestFilm)
    check.note("reRaceFilm",
               fmt::format("is a thickness of only a few molecules. Below {:g} nm there is no "
                           "liquid film, and record 10.1 defines the traction of the contacts",
                           1e9 * tribology::kThinnestFilm));
}

/// Which films of the pockets act.
void check_pocket_films(const Deck& deck, Checker& check) {
  const deck::ReportOnly quiet(deck);
  if (!(deck.si("pocLubFilm") > 0.0))
    check.error("pocLubFilm",
                "leaves no film in the pockets, but kPocHydro = 1 needs one. pocLubFilm is the "
                "largest distance from the pocket wall at which an element has a film",
                "give the largest film thickness, e.g. half the pocket clearance, or set "
                "kPocHydro to 0");
}

}  // namespace

std::vector<Issue> check_buildable(const Deck& deck, const UserHooks* user) {
  Checker check(deck);
  const bool dynamic = deck.integer("mode") >= 0;
  check.gates(kAlways);
  const bool rollers = deck.integer("kBrg") != 1;
  check_lubricant(deck, check);
  if (dynamic) check_moving_elements(deck, rollers, check);
  const long long segments = deck.integer("nCseg");
  if (dynamic && segments > 1) check_segments(deck, check);
  if (dynamic && segments > 0) check_land_errors(deck, check);
  if (dynamic && segments == 1 && deck.integer("kPocHydro") == 1) check_pocket_films(deck, check);
  for (Issue& issue : check_race_motions(deck)) check.add(std::move(issue));
  for (Issue& issue : check_element_inertia(deck)) check.add(std::move(issue));
  if (rollers)
    for (Issue& issue : check_flanges(deck)) check.add(std::move(issue));
  check_requests(deck, user, check);
  check_split_races(deck, check);
  check_waves(deck, check);
  check_law_ranges(deck, check);
  check_pocket_errors(deck, check);
  if (!deck.user_lines.empty() && user == nullptr)
    check.warning(
        "runID",
        "the deck has lines for user routines after its last record, but no plug-in was given",
        "give a plug-in with --user PLUG-IN, or remove the lines for user routines");

  if (deck.integer("kBrg") == 1)
    for (const char* flange : {"kFlngInd11", "kFlngInd21", "kFlngInd12", "kFlngInd22"})
      if (deck.integer(flange) != 0)
        check.no_effect(flange, "has no effect, because a ball bearing has no roller flanges", {});
  return check.take();
}

}  // namespace adore::setup
