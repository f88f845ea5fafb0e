#include "design/moving_deck.hpp"

#include "base/counted.hpp"
#include "base/errors.hpp"
#include "bearing/bearing.hpp"
#include "deck/lookup.hpp"
#include "deck/unit_change.hpp"
#include "runs/run_scales.hpp"
#include "setup/build_bearing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>

namespace adore::design {
namespace {

constexpr double kMillimeters = 1e3;

/// Collects the changes; lengths and other quantities in SI.
class Changes {
 public:
  Changes(const deck::Deck& deck, DynamicDeckProposal& out) : deck_(deck), out_(out) {}

  void code(const std::string& name, long long value) {
    out_.sets.emplace_back(name, fmt::format("{}", value));
  }
  void number(const std::string& name, double value) {
    out_.sets.emplace_back(name, fmt::format("{:.6g}", value));
  }
  /// @param base the name without index
  void si(const std::string& name, double value) {
    const std::string_view base = std::string_view(name).substr(0, name.find('['));
    const deck::UnitPair& unit = deck::find_variable(base).front().spec().unit;
    const bool english = deck_.units() == deck::UnitSystem::English;
    number(name, value / (english ? unit.en_factor : unit.si_factor));
  }
  void say(std::string sentence) { out_.assumptions.push_back(std::move(sentence)); }

 private:
  const deck::Deck& deck_;
  DynamicDeckProposal& out_;
};

/// A cage that has room between the races [m].
struct CageProposal {
  double outer = 0.0, inner = 0.0, width = 0.0;
  double to_outer_race = 0.0, to_inner_race = 0.0;  ///< diametral clearances
  double pocket = 0.0;                              ///< clearance
  double cone = 0.0;                                ///< half angle [rad]
  int guide = 0;                                    ///< race of the lands: 0 none, 1 outer, 2 inner
  long long material = 0;
};

double rounded(double length) { return std::round(length * 1e6) * 1e-6; }

CageProposal ball_cage(const bearing::Bearing& b) {
  const bearing::BallGeometry& g = b.balls();
  const double D = g.diameter, dm = g.pitch_diameter, land = 0.005 * dm;
  const double roof = g.shoulder_diameter[0] > 0.0 ? g.shoulder_diameter[0] : dm + 0.5 * D;
  const double floor = g.shoulder_diameter[1] > 0.0 ? g.shoulder_diameter[1] : dm - 0.5 * D;
  CageProposal out;
  out.outer = std::min(roof - land, dm + 0.6 * D);
  out.inner = std::max(dm - 0.25 * D, floor + 2.0 * land);
  out.width = std::min(1.4 * D, std::max(b.envelope.race_width[0], 1.1 * D));
  out.to_outer_race = roof - out.outer;
  out.to_inner_race = out.inner - floor;
  out.pocket = 0.02 * D;
  out.guide = 1;
  out.material = 205;
  return out;
}

/// Diameter of the flanges of a race; nothing without flanges on both sides.
std::optional<double> flange_diameter(const bearing::RollerGeometry& g, std::size_t race) {
  if (!g.flange[race][0] || !g.flange[race][1]) return std::nullopt;
  const double height = std::max(g.flange[race][0]->height, g.flange[race][1]->height);
  return race == 0 ? g.pitch_diameter + g.diameter + 0.5 * g.clearance - 2.0 * height
                   : g.pitch_diameter - g.diameter - 0.5 * g.clearance + 2.0 * height;
}

CageProposal cylindrical_cage(const bearing::Bearing& b) {
  const bearing::RollerGeometry& g = *b.rollers();
  const double D = g.diameter, dm = g.pitch_diameter, land = 0.005 * dm;
  const std::optional<double> roof = flange_diameter(g, 0), floor = flange_diameter(g, 1);
  CageProposal out;
  out.outer = roof ? *roof - land : dm + 0.5 * D;
  out.inner = !roof && floor ? *floor + land : dm - 0.2 * D;
  out.width = std::min(1.33 * g.length, std::max(b.envelope.race_width[0], 1.05 * g.length));
  out.to_outer_race = roof.value_or(dm + D) - out.outer;
  out.to_inner_race = out.inner - floor.value_or(dm - D);
  out.pocket = 0.023 * D;
  out.guide = roof ? 1 : floor ? 2 : 0;
  out.material = 162;
  return out;
}

CageProposal tapered_cage(const bearing::Bearing& b) {
  const bearing::RollerGeometry& g = *b.rollers();
  const double D = g.diameter, dm = g.pitch_diameter;
  CageProposal out;
  out.outer = dm + 0.42 * D;
  out.inner = dm - 0.21 * D;
  out.width = 1.21 * g.length;
  out.to_outer_race = out.to_inner_race = 0.05 * dm;
  out.pocket = 0.026 * D;
  out.cone = g.axis_angle;
  return out;
}

CageProposal spherical_cage(const bearing::Bearing& b) {
  const bearing::RollerGeometry& g = *b.rollers();
  const double D = g.diameter, dm = g.pitch_diameter;
  CageProposal out;
  out.outer = dm + 0.38 * D;
  out.inner = dm - 0.286 * D;
  const double room = std::max(b.envelope.race_width[0] - g.length, 0.06 * g.length);
  out.width = std::min(1.27 * g.length, g.length + 0.85 * room);
  out.to_outer_race = 0.033 * dm;
  out.to_inner_race = 0.005 * dm;
  out.pocket = 0.0114 * D;
  out.guide = 2;
  out.material = 161;
  return out;
}

CageProposal propose_cage(const bearing::Bearing& b) {
  CageProposal out;
  switch (b.type) {
    case bearing::Type::Ball:
      out = ball_cage(b);
      break;
    case bearing::Type::Cylindrical:
      out = cylindrical_cage(b);
      break;
    case bearing::Type::Tapered:
    case bearing::Type::SphericalTapered:
      out = tapered_cage(b);
      break;
    case bearing::Type::Spherical:
      out = spherical_cage(b);
      break;
  }
  for (double* length :
       {&out.outer, &out.inner, &out.width, &out.to_outer_race, &out.to_inner_race, &out.pocket})
    *length = rounded(*length);
  if (!(out.outer > out.inner))
    throw InputError(
        "there is not enough space for a cage between the races. Enter the cage in records 7.0 to "
        "7.2");
  return out;
}

void add_cage(Changes& changes, const bearing::Bearing& b) {
  const CageProposal cage = propose_cage(b);
  changes.code("nCseg", 1);
  changes.code("kPocType", 0);
  for (const char* ideal :
       {"kCagePocImp", "kCageGsImp", "kRaceGsImp", "kPocHydro", "kGsHydro", "kCageIP"})
    changes.code(ideal, 0);
  changes.code("kCageMat", cage.material);
  changes.code("nGL", cage.guide == 0 ? 0 : 2);
  changes.si("cageDia1", cage.outer);
  changes.si("cageDia2", cage.inner);
  changes.si("cageWidth", cage.width);
  changes.si("cageCls1", cage.to_outer_race);
  changes.si("cageCls2", cage.to_inner_race);
  changes.si("bPocCls1", cage.pocket);
  changes.si("bPocCls2", 0.0);
  changes.si("cageAngCut", 0.0);
  changes.si("cageConeAng", cage.cone);
  std::string material;
  for (const deck::OptionSpec& one : deck::option_table("@materials"))
    if (one.code == fmt::format("{}", cage.material)) material = one.meaning;
  if (cage.material == 0) material = "mild steel";
  changes.say(
      fmt::format("ESTIMATED cage of {}: outer diameter {:.4g} mm, inner diameter {:.4g} mm, width "
                  "{:.4g} mm. Pocket clearance: {:.3g} mm.",
                  material, cage.outer * kMillimeters, cage.inner * kMillimeters,
                  cage.width * kMillimeters, cage.pocket * kMillimeters));
  if (cage.guide > 0) {
    const double diameter = cage.guide == 1 ? cage.outer : cage.inner;
    const double clearance = cage.guide == 1 ? cage.to_outer_race : cage.to_inner_race;
    const bool rollers = b.rollers() != nullptr;
    const double width =
        rounded(rollers ? 0.45 * (cage.width - b.rollers()->length) : 0.12 * cage.width);
    changes.number("iCageGuide[1]", cage.guide);
    changes.number("iCageGuide[2]", cage.guide);
    for (int land = 1; land <= 2; ++land) {
      const auto name = [&](const char* variable) { return fmt::format("{}[{}]", variable, land); };
      changes.si(name("cageGsDia"), diameter);
      changes.si(name("cageGsWidth"), width);
      changes.si(name("cageGsPos"), (land == 1 ? -0.5 : 0.5) * cage.width);
      changes.si(name("cageGsCls"), clearance);
    }
    changes.say(
        fmt::format("Two lands guide the cage at the {} race with a clearance of {:.3g} mm.",
                    cage.guide == 1 ? "outer" : "inner", clearance * kMillimeters));
  } else {
    changes.say("The rollers guide the cage; the cage has no guide lands.");
  }
  // The elements' speed, and off the center so that the motion does not start symmetric.
  changes.si("pocLubFilm", 1e-6);
  changes.number("wvRatio", 1.0);
  changes.number("avRatio", 1.0);
  changes.si("cageGcPos[1]", 0.0);
  changes.si("cageGcPos[2]", 0.0);
  changes.si("cageGcPos[3]", -rounded(0.1 * std::min(cage.pocket, 0.5 * cage.to_outer_race)));
  for (int k = 1; k <= 3; ++k) changes.si(fmt::format("cageAngPos[{}]", k), 0.0);
  changes.code("kCPTrac", 0);
  changes.code("kCPTracType", 2);
  const auto curve = [&](const std::string& stem, double most) {
    changes.number(stem + "1", 0.0);
    changes.number(stem + "2", most);
    changes.si(stem + "3", 10.0 * most);
    changes.number(stem + "4", 0.0);
  };
  curve("reCageTC", 0.08);
  std::string friction = "ESTIMATED dry friction coefficient of the cage: 0.08 in the pockets";
  if (cage.guide > 0) {
    changes.code("kCRTrac", 0);
    changes.code("kCRTracType", 2);
    curve("cageRaceTC", 0.06);
    friction += ", 0.06 at the lands";
  }
  changes.say(friction + ".");
}

void add_friction(Changes& changes, const deck::Deck& deck, const bearing::Bearing& b) {
  const bearing::TractionCurve& c = b.race_traction;
  const bool none = c.A == 0.0 && c.B == 0.0 && c.C == 0.0 && c.D == 0.0;
  if (deck.integer("kTrac") != 0 || !none) return;
  changes.code("kTracType", 1);
  changes.number("reRaceTC1", 0.0);
  changes.number("reRaceTC2", 0.06);
  changes.number("reRaceTC3", 0.04);
  changes.si("reRaceTC4", 0.5);
  changes.say(
      "ESTIMATED friction coefficient between elements and races: 0.06 at a slip of 0.5 m/s, 0.04 "
      "at much higher slip; the deck specifies no friction.");
}

void add_gravity(Changes& changes, const deck::Deck& deck) {
  if (deck.has("gravityVecZ") &&
      (deck.real("gravityVecX") != 0.0 || deck.real("gravityVecY") != 0.0 ||
       deck.real("gravityVecZ") != 0.0))
    return;
  changes.si("gravityVecX", 0.0);
  changes.si("gravityVecY", 0.0);
  changes.si("gravityVecZ", -9.81);
  changes.say("Gravity of 9.81 m/s² along -z: the shaft is horizontal.");
}

void add_outputs(Changes& changes, const deck::Deck& deck, bool own_cage) {
  const long long count = deck.integer("nRe");
  const long long segments = own_cage ? deck.integer("nCseg") : 1;
  const long long third = count / 3 + 1;
  changes.code("kNumPltElem", third == 1 ? 3 : 4);
  int place = 0;
  const auto body = [&](long long index) {
    changes.code(fmt::format("kPltElemInd[{}]", ++place), index);
  };
  body(1);
  if (third != 1) body(third);
  body(count + 1);
  body(count + segments + 2);
  changes.say(fmt::format("Monitored bodies: elements 1 and {}, cage, inner race.", third));
  for (const char* each : {"kPltFreq", "kAGraf"}) changes.code(each, 1);
  for (const char* ends : {"kPrtFreq", "kLifeFreq", "kDCR", "kDOF", "kIcOpt"})
    changes.code(ends, 0);
}

/// The run: end, and steps. @param time of the scale [s]
void add_run(Changes& changes, const runs::RunScales& scales) {
  constexpr double kStep = 1.7;    // of the classical Runge-Kutta method, below its stability limit
  constexpr long kMostSteps = 20;  // times the expected number
  const double end = kDynamicDeckRevolutions / scales.turns_per_second;
  const double length = std::ceil(end / scales.time);
  const long steps = static_cast<long>(length / kStep);
  const long between = std::max(1L, steps / kDynamicDeckStoredSteps);
  changes.code("mode", 0);
  changes.code("intMet", 41);
  changes.code("nStps", between);
  changes.code("maxStps", kMostSteps * std::max(steps / between, 1L));
  changes.number("stpInit", 0.05);
  changes.number("stpMin", 5e-4);
  changes.number("stpMax", kStep);
  changes.number("fTime", length);
  changes.number("tol", 1e-5);
  changes.number("qFac", 0.0);
  changes.say(
      fmt::format("Mode 0: the motion is simulated for {} ({:.3g} ms), with about {} stored "
                  "frames. Both races keep the position of the static solution.",
                  counted(fmt::format("{:.3g}", kDynamicDeckRevolutions), "revolution"), end * 1e3,
                  steps / between));
}

}  // namespace

DynamicDeckProposal propose_dynamic_deck(const deck::Deck& deck,
                                         const std::map<std::string, std::string>& options) {
  if (deck.real("rpm1") == deck.real("rpm2"))
    throw InputError("the races do not rotate relative to each other. Enter a speed (rpm2)");
  const bearing::Bearing bearing = setup::build_bearing(deck);
  const bool own_cage = deck.integer("nCseg") > 0;
  DynamicDeckProposal out;
  Changes changes(deck, out);
  if (own_cage)
    changes.say("The deck keeps its cage.");
  else
    add_cage(changes, bearing);
  add_friction(changes, deck, bearing);
  add_gravity(changes, deck);
  add_outputs(changes, deck, own_cage);
  changes.code("kStif", 0);
  deck::Deck moving = deck;
  DynamicDeckProposal draft = out;
  Changes first(deck, draft);
  add_run(first, {1.0, 1.0});  // any times: only the scale is wanted
  moving.set_all(draft.sets);
  add_run(changes, runs::run_scales(moving, options));
  return out;
}

}  // namespace adore::design
