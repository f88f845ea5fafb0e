#include "setup/unused_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <string_view>

namespace adore::setup {
namespace {

using deck::Deck;

/// Conditions of the reasons.
struct Scene {
  bool motion = false;      ///< mode >= 0
  bool heat = false;        ///< a thermal analysis
  bool convection = false;  ///< its coefficients are given
  bool balls = false, cage = false, guided = false, flanges = false, segments = false;
};

Scene scene_of(const Deck& deck) {
  Scene out;
  out.motion = deck.integer("mode") >= 0;
  out.heat = deck.integer("kTherm") > 0;
  out.convection = out.heat && deck.integer("kHTC") == 1;
  out.balls = deck.integer("kBrg") == 1;
  out.cage = deck.integer("nCseg") > 0;
  for (int i = 1; i <= deck.integer("nGL"); ++i)
    out.guided = out.guided || deck.integer("iCageGuide", i) > 0;
  for (const char* flange : {"kFlngInd11", "kFlngInd21", "kFlngInd12", "kFlngInd22"})
    out.flanges = out.flanges || (!out.balls && deck.integer(flange) > 0);
  out.segments = deck.integer("nCseg") > 1;
  return out;
}

bool is_one_of(std::string_view name, std::initializer_list<std::string_view> names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool starts_with_one_of(std::string_view name, std::initializer_list<std::string_view> stems) {
  return std::any_of(stems.begin(), stems.end(),
                     [&](std::string_view stem) { return name.starts_with(stem); });
}

/// Materials (records 8.1 to 8.5).
std::string of_material(std::string_view name, const Scene& scene) {
  if (name.ends_with("TC") || name.ends_with("TC1") || name.ends_with("TC2") ||
      name.ends_with("SH") || name.ends_with("SH1") || name.ends_with("SH2"))
    return !scene.heat
               ? "no heat flow is computed, so conductivity and specific heat are only printed"
               : "this value gives only the heat capacity of the cage, which is used with run "
                 "option thermalTransient=on";
  if (name.starts_with("cage"))
    return scene.motion ? "fatigue of the cage is not computed"
                        : "a quasi-static solution does not move or wear the cage";
  if (name.starts_with("hsng") || name.starts_with("shft"))
    return "only the fits of housing and shaft are computed, not their contact stresses";
  if (!scene.motion) return "a quasi-static solution has no sliding and no wear";
  return {};
}

/// A clause without subject; empty where no rule knows.
std::string reason(const deck::NoPart& value, const Scene& scene) {
  const std::string_view record = value.record;
  const std::string_view name =
      std::string_view(value.variable).substr(0, value.variable.find('['));
  // Missing parts.
  if (starts_with_one_of(name, {"kFlngInd"})) return "a ball bearing has no roller flanges";
  if (is_one_of(name, {"kRFTrac", "kRFTracType"}) && !scene.flanges)
    return "there is no roller flange";
  if (is_one_of(name, {"kRRTrac", "kRRTracType"}) && scene.cage)
    return "the cage separates the rolling elements";
  if (is_one_of(name, {"kCPTrac", "kCPTracType", "kPocHydro"}) && !scene.cage)
    return "there is no cage";
  if (is_one_of(name, {"kPocHydro", "kGsHydro"}) && scene.segments)
    return "hydrodynamic forces are not available for a segmented cage";
  if (is_one_of(name, {"kCRTrac", "kCRTracType", "kGsHydro"}) && !scene.guided)
    return "no race guides a cage";
  if (record.starts_with("10") && record.ends_with("D") && name.ends_with("TC4"))
    return "the asymptotic traction law has only three coefficients";
  if ((record.starts_with("10.2") || name == "kRFTracType") && scene.flanges && !scene.motion)
    return "without thrust the flanges of cylindrical rollers have no load in the equilibrium";
  if (name == "reRaceFilm")
    return "without oil at the contact inlets (strParam = 0) there is no film";
  if (record.starts_with("10") && !scene.motion)
    return "a quasi-static solution includes the friction of elements and races, but not of the "
           "cage";
  if (name == "iTherm") return "only visco-elastic traction (kTrac 12) has a thermal correction";
  if (record == "5F" && scene.balls) return "a ball bearing has no roller flanges";
  if (name.starts_with("flngCls"))
    return "this race does not have flanges at both ends of the rollers";
  if (record == "5F") return "the race does not have this flange";
  if (record.starts_with("10.2") && !scene.flanges) return "there is no roller flange";
  // Values that an option fixes or replaces.
  if (is_one_of(name, {"appLoadX", "appLoadY", "appLoadZ", "appMomY", "appMomZ", "appDispX",
                       "appDispY", "appDispZ", "appMis12", "appMis22"}))
    return "kFS1 to kFS5 select the other quantity (load or displacement) for this direction";
  if (name == "bReCenLen") return "a straight roller (bReCrn = 0) has no central land";
  if (name == "freeIntCls") return "freeConAng above 0 sets the clearance";
  if (name.starts_with("rpmRange"))
    return "the stiffness table has one speed only, so the last speed is not used";
  if (name == "pltNames8") return "kAGraf = 0 stores no animation";
  if (name.starts_with("pltNames") && scene.motion)
    return "no monitored body belongs to this plot file, so it is not written";
  if (name == "angVelOrient") return "the angle of the spin axis is an input only with kAngVel = 2";
  if (name == "bPocCls2") return "a pocket of this shape has only one clearance";
  if (name == "bPocThknsVar" && scene.motion && scene.cage)
    return "the widths of the pocket guide faces do not depend on the wall thickness";
  if (name == "bPocClsVar2") return "a pocket of this shape has only one clearance";
  if (starts_with_one_of(name,
                         {"rotLoadRpm", "raceVibFreq", "raceSpeedFreq", "startTime", "endTime"}))
    return "the amplitude of this motion or load is 0 for this race";
  if (name == "cageAngCut" && !scene.segments) return "a one-piece cage has no cut";
  if (scene.motion && is_one_of(name, {"cageGsRadVar3", "raceGsRadVar3"}))
    return "this guide land is elliptical (needs only two values), or no race guides it";
  if (scene.motion && starts_with_one_of(name, {"cageGsRadVar", "raceGsRadVar"}))
    return "no race guides this land";
  if (name == "pocLubFilm") return "pocket hydrodynamics are off (kPocHydro)";
  if (record.starts_with("5G.1D")) return "the bearing has no rolling element with this number";
  if (name == "kAngVel")
    return "rollers roll without slip about axes that follow from the geometry";
  if (starts_with_one_of(name, {"rmsAspHt", "rmsAspSlope", "aspTrac"}))
    return "without a lubricant (kTrac) no film is computed";
  if (name == "cFlowRate") return "there is no coolant (kCoolant)";
  if (is_one_of(name, {"kHTC", "reHTC", "cageHTC", "xMu", "xK"}))
    return scene.convection ? "convection coefficients are given"
                            : "convection coefficients are computed, or no coolant flows";
  if (is_one_of(name, {"aveTime", "skipTime"}))
    return scene.motion ? "the geometry does not change" : "a steady state has no thermal steps";
  if (record == "9.7" || record == "9.8" || record == "3.5" || name == "kTherm")
    return "no thermal steps are computed: record 9.1.3 gives the temperatures, and only "
           "kMatPropMod of record 3.5 has an effect";
  if (record == "8.1" || record == "8.2.1" || record == "8.2.2" || record == "8.3" ||
      record == "8.4" || record == "8.5")
    return of_material(name, scene);
  if (name.starts_with("raceCenLen")) return "a raceway without crown (raceCrn = 0) is straight";
  if (record.starts_with("6.2") || (name.starts_with("kRaceIP") && scene.motion))
    return "record 2.2 (kDCR, kFD, kMD) fixes this race in each direction that needs this value";
  if (name == "qFac" && scene.motion) return "modes 1 and 2 keep every element in force balance";
  if (scene.motion) return {};
  // Quasi-static.
  if (name == "kFnOpt" || record == "2.3")
    return "a quasi-static solution writes PRINT.txt and RUN.json only";
  if (record == "1" || record == "2.2") return "a quasi-static solution has no time steps";
  if (record.starts_with("7") || name == "kCageMat")
    return "a quasi-static solution uses size and clearance of the cage, but not its motion or "
           "forces";
  if (record == "9.6" || record == "9.6.k") return "a quasi-static solution does not move the cage";
  return {};
}

}  // namespace

std::vector<deck::NoPart> find_unused_values(const Deck& deck) {
  std::vector<deck::NoPart> out = deck::values_not_read(deck);
  const deck::ReportOnly quiet(deck);
  const Scene scene = scene_of(deck);
  for (deck::NoPart& value : out) {
    if (!value.because.empty()) continue;
    value.because = reason(value, scene);
    if (value.because.empty()) value.because = kNoReason;
  }
  return out;
}

bool requests_effect(const deck::NoPart& value) {
  if (value.record.starts_with("7") && value.variable.starts_with("bPoc") &&
      value.variable.find("Var") != std::string::npos)
    return value.value != "0.0";  // a deviation of the pockets
  if (value.variable.starts_with("raceMass")) return true;
  if (!value.switched_on || value.variable.ends_with("TracType") || value.variable == "kAngVel")
    return false;
  return value.record != "2.2" &&
         (value.record != "1" || is_one_of(value.variable, {"kDCR", "kDOF", "kIcOpt", "kTherm"}));
}

std::optional<Issue> note_unused_values(const std::vector<deck::NoPart>& values, const Deck& deck,
                                        const std::vector<Issue>& said) {
  std::string names;
  const auto is_said = [&](const deck::NoPart& value) {
    return std::any_of(said.begin(), said.end(),
                       [&](const Issue& issue) { return issue.variable == value.variable; });
  };
  for (const deck::NoPart& value : values)
    if (requests_effect(value) && !is_said(value))
      names += fmt::format("{}{} = {} ({})", names.empty() ? "" : ", ", value.variable, value.value,
                           value.because);
  if (names.empty()) return std::nullopt;
  Issue out;
  out.severity = Severity::Note;
  out.file = deck.file;
  out.code = "deck.unused";
  out.message = fmt::format("without effect on this run: {}", names);
  out.remedy = "PRINT.txt and RUN.json list all values without effect";
  return out;
}

}  // namespace adore::setup
