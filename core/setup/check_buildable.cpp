#include "bearing/material_laws.hpp"
#include "setup/build_bearing.hpp"
#include "setup/deck_text.hpp"
#include "setup/race_motions.hpp"

#include <fmt/format.h>

#include <cmath>
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
    {"kRaceFlex", 0, "a flexible outer race (announced by the classic program, never available)"},
};
constexpr Gate kDynamic[] = {
    {"kTrac", 0, "a lubricant's traction model (or user routine ADRX7)"},
    {"kTherm", 0, "the thermal analysis"},
    {"kChrn", 0, "churning and drag"},
};
constexpr Gate kCage[] = {
    {"kCageGsImp", 0, "cage guide-land imperfections"},
    {"kRaceGsImp", 0, "race guide-land imperfections"},
    {"kPocHydro", 0, "pocket hydrodynamics"},
    {"kGsHydro", 0, "guide-land hydrodynamics"},
    {"kCPTrac", 0, "a user routine for element to cage traction"},
    {"kCRTrac", 0, "a user routine for cage to race traction"},
};

constexpr Gate kNoCage[] = {
    {"kRRTrac", 0, "a user routine for element to element traction"},
};

class Checker {
 public:
  explicit Checker(const Deck& deck) : deck_(deck) {}

  void gates(std::span<const Gate> gates) {
    for (const Gate& gate : gates)
      if (deck_.has(gate.variable) && deck_.integer(gate.variable) != gate.supported)
        error(gate.variable,
              fmt::format("asks for {}, which this version does not simulate yet", gate.asks_for),
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

  void note(const char* variable, std::string message) {
    issues_.push_back(deck_.issue(Severity::Note, variable, std::move(message), {}));
  }

  void add(Issue issue) { issues_.push_back(std::move(issue)); }

  std::vector<Issue> take() { return std::move(issues_); }

 private:
  const Deck& deck_;
  std::vector<Issue> issues_;
};

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
        check.warning(amplitude.c_str(),
                      fmt::format("has no effect: with {} = 0 waves and a phase {} of {:.6g} "
                                  "degrees, a sin(phase) is zero everywhere",
                                  waves, phase, deck.real(phase)),
                      fmt::format("give {}, or a phase of 90 degrees for a constant", waves));
      if (deck.real(waves) == std::round(deck.real(waves))) continue;
      const std::string step =
          "is not a whole number of waves per turn: the surface has a step where the turn closes, "
          "at the z axis of the race";
      if (deck.integer("mode") >= 0)
        check.error(waves.c_str(), step + ", over which no element rolls",
                    "give a whole number of waves per turn");
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
                    fmt::format("lies outside of what is known of {}: {}; the value at the nearer "
                                "end is used",
                                material.name, laws));
  }
}

/// The same deviation in all pockets; that of single ones is looked at in operation.
void check_pocket_errors(const Deck& deck, Checker& check) {
  if (!deck.has("bPocClsVar1") || deck.integer("kCagePocImp") != 2) return;
  if (deck.integer("kBrg") != 1 && deck.integer("kPocType") > 0) return;  // guide faces
  const double given = deck.si("bPocCls1"), left = given + deck.si("bPocClsVar1");
  if (given >= 0.0 && left < 0.0)
    check.warning("bPocClsVar1",
                  fmt::format("makes every pocket smaller than its rolling element, which it "
                              "clamps: bPocCls1 + bPocClsVar1 is {}",
                              length_text(deck, left)));
}

/// What the motion of rollers leaves out.
void check_moving_rollers(const Deck& deck, Checker& check) {
  if (deck.integer("kReGeoImp") == 3)
    check.error("kReGeoImp", "asks for user routine ADRX8, which this version does not call yet",
                "use 0, 1 or 2");
  else if (deck.integer("kReGeoImp") != 0)
    check.note(
        "kReGeoImp",
        "the contacts of each roller are those of its own shape; mass and moments of inertia "
        "stay those of the nominal roller");
  if (deck.has("kCagePocImp") && deck.integer("kCagePocImp") != 0 && deck.integer("kPocType") > 0)
    check.error(
        "kCagePocImp",
        "asks for imperfections of pockets with guide faces (record 7.3), which this version "
        "does not simulate",
        "set it to 0, or kPocType to 0 or -1");
  if (deck.has("reFlngTC1") && deck.integer("kRFTrac") != 0)
    check.error("kRFTrac", "asks for a user routine for roller to flange traction",
                "set kRFTrac to 0");
}

}  // namespace

std::vector<Issue> check_buildable(const Deck& deck) {
  Checker check(deck);
  const bool dynamic = deck.integer("mode") >= 0;
  check.gates(kAlways);
  if (dynamic) check.gates(kDynamic);
  const bool rollers = deck.integer("kBrg") != 1;
  if (dynamic && rollers) check_moving_rollers(deck, check);
  if (dynamic && !rollers && deck.integer("kReGeoImp") != 0)
    check.error("kReGeoImp",
                "asks for the motion of rolling elements with geometric imperfections, which this "
                "version does not simulate yet",
                "set kReGeoImp to 0");
  const long long segments = deck.integer("nCseg");
  if (dynamic && segments > 1)
    check.error("nCseg", "asks for a segmented cage, which this version does not simulate yet",
                "set nCseg to 1 for a cage of one piece, or to 0 for a bearing without cage");
  if (dynamic && segments == 0) {
    check.gates(kNoCage);
    if (rollers)
      check.error(
          "nCseg",
          "asks for rollers that touch each other, which this version does not simulate yet",
          "set nCseg to 1");
    if (deck.real("qFac") > 0.0)
      check.error("qFac",
                  "asks for lightly loaded balls in force balance, which knows races and pockets "
                  "but no contact between balls (nCseg = 0)",
                  "set qFac to 0");
    if (deck.integer("mode") > 0)
      check.error("mode",
                  "asks for balls in force balance, which knows races and pockets but no contact "
                  "between balls (nCseg = 0)",
                  "set mode to 0");
  }
  if (dynamic && segments > 0) check.gates(kCage);
  for (Issue& issue : check_race_motions(deck)) check.add(std::move(issue));
  for (Issue& issue : check_element_inertia(deck)) check.add(std::move(issue));
  for (const char* material :
       {"kReMat", "kRaceMat1", "kRaceMat2", "kHsngMat", "kShftMat", "kCageMat"})
    if (deck.integer(material) == 2)
      check.error(material, "asks for user routine ADRX0, which this version does not call yet",
                  "use 0, 1 or a code of the material table");
  for (const auto& [code, routine] :
       {std::pair{"kReGeoImp", "ADRX8"}, {"kRaceGeoImp1", "ADRX6"}, {"kRaceGeoImp2", "ADRX6"}})
    if ((!dynamic || std::string_view(routine) == "ADRX6") && deck.integer(code) == 3)
      check.error(
          code,
          fmt::format("asks for user routine {}, which this version does not call yet", routine),
          "use 0, 1 or 2");
  if (dynamic && deck.has("kCagePocImp") && deck.integer("kCagePocImp") == 4)
    check.error("kCagePocImp", "asks for user routine ADRX8, which this version does not call yet",
                "use 0, 1, 2 or 3");
  if (dynamic && deck.integer("kDOF") == 6)
    check.error("kDOF", "asks for user routine ADRX1, which this version does not call yet",
                "use 0 to 5");
  check_waves(deck, check);
  check_law_ranges(deck, check);
  check_pocket_errors(deck, check);
  if (!deck.user_lines.empty())
    check.warning("runID",
                  "the deck has lines after its last record, for user routines that this version "
                  "does not call");

  if (deck.integer("kBrg") == 1)
    for (const char* flange : {"kFlngInd11", "kFlngInd21", "kFlngInd12", "kFlngInd22"})
      if (deck.integer(flange) != 0)
        check.warning(flange, "a ball bearing has no roller flanges: no effect");
  return check.take();
}

}  // namespace adore::setup
