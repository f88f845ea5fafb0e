#include "drawing/outline.hpp"

#include "base/errors.hpp"
#include "deck/lookup.hpp"
#include "drawing/outline_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <exception>

namespace adore::drawing {
namespace {

bool starts(std::string_view text, std::string_view with) {
  return text.substr(0, with.size()) == with;
}

bool one_of(std::string_view text, std::initializer_list<std::string_view> list) {
  return std::find(list.begin(), list.end(), text) != list.end();
}

/// Reasons are shown as they are: whole sentences without the file and line of an issue.
std::string sentence(const InputError& error) {
  if (error.issues().empty()) return error.what();
  std::string out;
  for (const Issue& issue : error.issues()) {
    if (!out.empty()) out += " ";
    out += issue.variable;
    if (!issue.value.empty()) out += " = " + issue.value;
    if (!issue.variable.empty() || !issue.value.empty()) out += ": ";
    out += issue.message;
    if (!issue.remedy.empty()) out += "; " + issue.remedy;
    out += ".";
  }
  return out;
}

using Painter = Drawing (*)(const deck::Deck&);
constexpr std::array<Painter, 8> kPainters = {&draw_cross_section, &draw_side_view, &draw_element,
                                              &draw_pocket,        &draw_lands,     &draw_flanges,
                                              &draw_traction,      &draw_loads};

bool any_flange(const deck::Deck& deck) {
  if (deck.integer("kBrg") == 1) return false;  // balls do not touch any
  return deck.integer("kFlngInd11") > 0 || deck.integer("kFlngInd21") > 0 ||
         deck.integer("kFlngInd12") > 0 || deck.integer("kFlngInd22") > 0;
}

View view_for_options(std::string_view variable) {
  if (one_of(variable,
             {"nRe", "nCseg", "kRaceGeoImp1", "kRaceGeoImp2", "kPltElemInd", "kNumPltElem"}))
    return View::AdditionalView;
  if (starts(variable, "kFlngInd")) return View::Flange;
  if (variable == "kReGeoImp") return View::Element;
  if (starts(variable, "kFS") || one_of(variable, {"kVarLoad", "kVarSpeed", "kRotFrame"}))
    return View::Loads;
  return View::CrossSection;
}

View view_for_cage(std::string_view record, std::string_view variable) {
  if (one_of(record, {"7.2.i", "7.5.i", "7.6.i"}) ||
      one_of(variable, {"kCageGsImp", "kRaceGsImp", "kGsHydro", "nGL", "iCageGuide"}))
    return View::Lands;
  if (one_of(record, {"7.3.i", "7.4"}) || starts(variable, "bPoc") ||
      one_of(variable, {"kPocType", "kCagePocImp", "kPocHydro"}))
    return View::Pocket;
  if (record == "7.0.1" || variable == "cageAngCut") return View::AdditionalView;
  if (record == "7.0" && variable.empty()) return View::Pocket;
  return View::CrossSection;
}

}  // namespace

std::string_view title_of(View view) {
  constexpr std::array<std::string_view, 8> kTitles = {
      "Cross-section", "Side view", "Element", "Pocket", "Lands", "Flanges", "Traction", "Loads"};
  return kTitles[static_cast<std::size_t>(view)];
}

std::vector<View> views_of(const deck::Deck& deck) {
  std::vector<View> out = {View::CrossSection, View::AdditionalView, View::Element};
  if (deck.integer("nCseg") > 0) out.push_back(View::Pocket);
  if (deck.integer("nCseg") > 0 && deck.integer("nGL") > 0) out.push_back(View::Lands);
  if (any_flange(deck)) out.push_back(View::Flange);
  out.push_back(View::Traction);
  out.push_back(View::Loads);
  return out;
}

Drawing draw(View view, const deck::Deck& deck) {
  Drawing out;
  try {
    out = kPainters[static_cast<std::size_t>(view)](deck);
  } catch (const InputError& error) {
    out.reason = sentence(error);
  }
  out.view = view;
  return out;
}

View view_of_variable(std::string_view record, std::string_view variable) {
  if (starts(record, "10.")) {
    const bool curve = one_of(record.substr(0, 4), {"10.0", "10.1", "10.2", "10.5"});
    return curve ? View::Traction : View::CrossSection;
  }
  if (record == "11") return View::Loads;
  if (one_of(record, {"3.2", "3.3", "3.4"})) return view_for_options(variable);
  if (starts(record, "7.")) return view_for_cage(record, variable);
  if (record == "5F") return View::Flange;
  if (starts(record, "5G.1")) return View::Element;
  if (starts(record, "5G.2")) return View::AdditionalView;
  if (starts(record, "5") && record != "5A" && starts(variable, "bRe")) return View::Element;
  if (one_of(record, {"5B.1", "5D.1", "5C", "5E"}) && variable.empty()) return View::Element;
  if (record == "6.1") return View::Element;
  if (record == "2.2" || one_of(record, {"9.1.1", "9.1.2", "9.2"}) || starts(record, "9.3") ||
      starts(record, "9.4") || starts(record, "9.5"))
    return View::Loads;
  if (starts(record, "9.6")) return View::AdditionalView;
  return View::CrossSection;
}

std::vector<Part> parts_of(std::string_view record, std::string_view variable) {
  if (variable.empty() || variable == "recID") return {};
  const char last = variable.back();
  const auto race = [&] { return last == '2' ? Part::InnerRing : Part::OuterRing; };
  if (one_of(record, {"8.1", "8.6.3", "8.6.6", "6.1"}) ||
      one_of(variable, {"kReMat", "reTemp", "kReIP", "reHTC", "bReDia", "reDiaVar", "kReGeoImp",
                        "nRe", "kAngVel", "angVelOrient"}) ||
      starts(record, "5G.1"))
    return {Part::Element};
  if (one_of(record, {"8.2.1", "6.2.1", "8.6.1", "8.6.4"}) || starts(record, "5G.2.1"))
    return {Part::OuterRing};
  if (one_of(record, {"8.2.2", "6.2.2", "8.6.2", "8.6.5"}) || starts(record, "5G.2.2"))
    return {Part::InnerRing};
  if (record == "8.3" || one_of(variable, {"kShftMat", "shftTemp", "shftID"})) return {Part::Shaft};
  if (record == "8.4" || one_of(variable, {"kHsngMat", "hsngTemp", "hsngOD"}))
    return {Part::Housing};
  if (one_of(record, {"8.5", "7.7"}) || starts(record, "9.6") ||
      one_of(variable, {"kCageMat", "kCageIP", "cageTemp", "cageHTC", "nCseg", "kCagePocImp",
                        "kPocType", "kPocHydro", "nGL"}))
    return {Part::Cage};
  if (variable == "kRaceFlex") return {Part::OuterRing};
  if (starts(variable, "kFlngInd")) return {race()};
  for (const std::string_view stem :
       {"kRaceMat",      "raceTemp",   "kRaceIP",     "kRaceGeoImp", "res",        "raceWidth",
        "raceFit",       "rpm",        "raceAngAcc",  "startTime",   "endTime",    "raceSpeedAmp",
        "raceSpeedFreq", "raceVibAmp", "raceVibFreq", "rotLoadFrac", "rotLoadRpm", "shoulderDia",
        "shimThickness", "raceCurFac", "raceLandLmt", "raceCenLen",  "raceCrn",    "raceTaper",
        "rmsAspHt",      "flng",       "rpmRange",    "kFD",         "kMD"})
    if (starts(variable, stem)) return {race()};
  return {};
}

std::string label_of(const deck::Deck& deck, std::string_view variable, int instance, int index) {
  std::string out(variable);
  const deck::VariableRef ref = deck::find_present_variable(deck, variable, instance);
  if (ref.record == nullptr) return out;
  if (!ref.record->repeat.empty()) out += fmt::format("[{}]", instance);
  if (ref.spec().length != "1") out += fmt::format("[{}]", index);
  const deck::Value* value = deck::find_value(deck, variable, instance, index);
  if (value == nullptr) return out;
  const std::string text = deck::value_text(*value);
  if (text.empty()) return out;
  out += " = " + text;
  const deck::VariableSpec& spec = ref.spec();
  const bool pure = !spec.unitless_when.empty() &&
                    deck::evaluate(spec.unitless_when, deck::condition_scope(deck));
  const std::string_view unit =
      deck.units() == deck::UnitSystem::English ? spec.unit.en : spec.unit.si;
  if (!pure && !unit.empty() && unit != "-") out += fmt::format(" {}", unit);
  return out;
}

}  // namespace adore::drawing
