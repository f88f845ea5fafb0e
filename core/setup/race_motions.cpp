#include "setup/race_motions.hpp"

#include "deck/orbit_records.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

namespace adore::setup {
namespace {

using bearing::Vec3;
using deck::Deck;
using scene::Effect;

constexpr std::array kAxes{"x", "y", "z"};
constexpr std::array kRaces{"outer race", "inner race"};

bool moves(const Deck& deck) { return deck.integer("mode") >= 0; }

bool flag_is_free(const Deck& deck, const std::string& name) {
  return moves(deck) && deck.integer("kDCR") == 1 && deck.integer(name) == 0;
}

bool has_free_motion(const Deck& deck, int race) {
  for (int axis = 1; axis <= 3; ++axis)
    if (is_translation_free(deck, axis, race) || is_rotation_free(deck, axis, race)) return true;
  return false;
}

/// "x, y and z", empty when none is named.
std::string listed(const std::array<bool, 3>& which) {
  std::string out;
  int left = static_cast<int>(which[0]) + static_cast<int>(which[1]) + static_cast<int>(which[2]);
  for (std::size_t k = 0; k < 3; ++k) {
    if (!which[k]) continue;
    --left;
    out += kAxes[k];
    if (left > 0) out += left > 1 ? ", " : " and ";
  }
  return out;
}

std::array<bool, 3> opposite(const std::array<bool, 3>& which) {
  return {!which[0], !which[1], !which[2]};
}

bool given_and_not_zero(const Deck& deck, const std::string& name) {
  return deck.has(name) && deck.real(name) != 0.0;
}

double rpm(double speed) { return speed * 30.0 / std::numbers::pi; }

/// Start and motion of a free race, in words.
std::string free_text(const bearing::FreeRace& free) {
  std::string out;
  const auto add = [&out](std::string_view before, const std::string& which) {
    if (which.empty()) return;
    if (!out.empty()) out += ", ";
    out += fmt::format("{} {}", before, which);
  };
  add("free along", listed(opposite(free.translation_held)));
  add("free about", listed(opposite(free.rotation_held)));
  add("fixed along", listed(free.translation_held));
  add("fixed about", listed(free.rotation_held));
  return out;
}

void add_body(const bearing::Bearing& bearing, const bearing::RaceMotions& motions, std::size_t j,
              scene::ScenePlan& plan, bool driven) {
  if (motions.free[j]) {
    plan.bodies.push_back({kRaces[j], free_text(*motions.free[j]), 14});
    return;
  }
  if (j == 1 && plan.has(Effect::RaceBalance)) {
    std::array<bool, 3> free{};
    for (std::size_t k = 0; k < 3; ++k) free[k] = !bearing.constraints.displacement_given[k];
    plan.bodies.push_back(
        {kRaces[j],
         fmt::format("in force balance along {}, speed {:g} rpm{}", listed(free),
                     rpm(bearing.speed[j]), driven ? ", other motions by user routine ADRX1" : ""),
         driven ? 11 : 3});
    return;
  }
  const char* place = j == 0 ? "fixed" : "at the static position";
  std::string text = fmt::format("{}, speed {:g} rpm", place, rpm(bearing.speed[j]));
  if (motions.has_excitation(static_cast<int>(j))) text += ", with prescribed motion";
  plan.bodies.push_back({kRaces[j], text, 0});
}

}  // namespace

bool is_translation_free(const Deck& deck, int axis, int race) {
  return flag_is_free(deck, fmt::format("kFD{}{}", axis, race));
}
bool is_rotation_free(const Deck& deck, int axis, int race) {
  return flag_is_free(deck, fmt::format("kMD{}{}", axis, race));
}

bearing::Inertia read_inertia(const Deck& deck, std::string_view prefix, std::string_view suffix) {
  const auto name = [&](const char* stem) { return fmt::format("{}{}{}", prefix, stem, suffix); };
  bearing::Inertia out;
  out.mass = deck.si(name("Mass"));
  out.moments = {deck.si(name("MIx")), deck.si(name("MIy")), deck.si(name("MIz"))};
  out.geometric_centre = {deck.si(name("GeoCenX")), deck.si(name("GeoCenY")),
                          deck.si(name("GeoCenZ"))};
  out.frame = {deck.si(name("FrameX")), deck.si(name("FrameY")), deck.si(name("FrameZ"))};
  return out;
}

bearing::Inertia read_race_inertia(const Deck& deck, int race) {
  const bool by_user = deck.integer("kDOF") == 6;  // ADRX1 may free anything
  const bool turns = by_user || is_rotation_free(deck, 1, race) ||
                     is_rotation_free(deck, 2, race) || is_rotation_free(deck, 3, race);
  const bool moves = turns || is_translation_free(deck, 1, race) ||
                     is_translation_free(deck, 2, race) || is_translation_free(deck, 3, race);
  const auto read = [&](bool acts, std::initializer_list<const char*> stems) {
    const deck::ReportOnly quiet(deck, !acts);
    for (const char* stem : stems) (void)deck.si(fmt::format("race{}{}", stem, race));
  };
  read(moves || deck.integer("kRotFrame") == 1, {"Mass"});
  read(moves, {"GeoCenX", "GeoCenY", "GeoCenZ"});
  read(turns, {"MIx", "MIy", "MIz", "FrameX", "FrameY", "FrameZ"});
  const deck::ReportOnly quiet(deck);
  return read_inertia(deck, "race", race == 1 ? "1" : "2");
}

/// Parts of record 6.1 that are not used.
std::vector<Issue> check_element_inertia(const Deck& deck) {
  std::vector<Issue> out;
  const long long code = moves(deck) ? deck.integer("kReIP") : 0;
  if (code == 1 && deck.integer("kBrg") != 1)
    out.push_back(deck.issue(Severity::Note, "kReIP",
                             "element 1 moves with its actual inertia; the static solution at the "
                             "start treats all elements as identical",
                             {}));
  return out;
}

std::vector<Issue> check_race_motions(const Deck& deck) {
  std::vector<Issue> out;
  if (!moves(deck)) return out;
  const auto add = [&](Severity severity, const std::string& name, std::string message,
                       std::string remedy) {
    out.push_back(deck.issue(severity, name, std::move(message), std::move(remedy)));
  };
  const auto no_effect = [&](const std::string& name, std::string message, std::string remedy) {
    add(Severity::Warning, name, std::move(message), std::move(remedy));
    out.back().code = "deck.no_effect";
  };
  for (int race = 1; race <= 2; ++race) {
    const char* const body = kRaces[static_cast<std::size_t>(race - 1)];
    const auto clash = [&](const std::string& name, const std::string& flag, const char* what) {
      if (given_and_not_zero(deck, name))
        add(Severity::Error, name,
            fmt::format("prescribes a motion of the {}, but {} = 0 lets the race {} freely in the "
                        "same direction",
                        body, flag, what),
            fmt::format("set {} to 0, or set {} to 1", name, flag));
    };
    for (int axis = 1; axis <= 3; ++axis) {
      if (!is_translation_free(deck, axis, race)) continue;
      const std::string flag = fmt::format("kFD{}{}", axis, race);
      clash(fmt::format("raceVibAmp{}{}", axis, race), flag, "move");
      // Free along both, the race carries a load that turns; along one, nothing can turn.
      if (axis > 1 && !is_translation_free(deck, 5 - axis, race))
        clash(fmt::format("rotLoadFrac{}", race), flag, "move");
    }
    if (is_rotation_free(deck, 1, race)) {
      const std::string flag = fmt::format("kMD1{}", race);
      clash(fmt::format("raceAngAcc{}", race), flag, "rotate");
      clash(fmt::format("raceSpeedAmp{}", race), flag, "rotate");
      add(Severity::Warning, flag,
          fmt::format("lets the {} rotate freely about x. Without user routine ADRX1, no moment "
                      "drives the race, so friction slows it down",
                      body),
          fmt::format("set {} to 1 for a constant speed", flag));
    }
  }
  if (deck.integer("kRotFrame") == 1 && deck.has("brgAngVel") && deck.real("brgAngVel") == 0.0)
    no_effect("brgAngVel",
              "the base frame of record 9.5 does not rotate, so kRotFrame has no effect",
              "give the speed of the frame, or set kRotFrame to 0");
  if (deck.integer("kRotFrame") == 1 && deck.integer("kFS2") == 1 && deck.integer("kFS3") == 1)
    for (int race = 1; race <= 2; ++race)
      if (const std::string share = fmt::format("brgLoadFrac{}", race);
          given_and_not_zero(deck, share) && !is_translation_free(deck, 2, race) &&
          !is_translation_free(deck, 3, race))
        no_effect(
            share,
            "has no effect, because kFS2 and kFS3 give the position of the inner race, not its "
            "load",
            fmt::format("set {} to 0, or set kFS2 or kFS3 to 0", share));
  if (deck.integer("kVarLoad") == 1)
    for (int race = 1; race <= 2; ++race) {
      const std::string share = fmt::format("rotLoadFrac{}", race);
      if (!given_and_not_zero(deck, share) || std::abs(deck.real(share)) <= 1.0) continue;
      add(Severity::Warning, share,
          fmt::format("is above 1 in magnitude: the {} moves on a circle larger than the radial "
                      "deflection between the races, or the rotating load exceeds the applied "
                      "load. Contact loads may be many times those of the equilibrium",
                      kRaces[static_cast<std::size_t>(race - 1)]),
          "give a fraction between -1 and 1");
    }
  if (deck.integer("mode") > 0 && deck.integer("kDOF") == 5)
    add(Severity::Error, "kDOF",
        fmt::format("suppresses all motions of the elements, but mode = {} needs their force "
                    "balance",
                    deck.integer("mode")),
        "set mode to 0, or set kDOF to a value from 0 to 4");
  if (deck.integer("mode") == 2) {
    for (int axis = 1; axis <= 3; ++axis) {
      if (is_rotation_free(deck, axis, 2))
        add(Severity::Error, fmt::format("kMD{}2", axis),
            "lets the inner race rotate freely, but mode = 2 computes only its position from the "
            "force balance",
            fmt::format("set kMD{}2 to 1, or set mode to 0 or 1", axis));
      const std::string amplitude = fmt::format("raceVibAmp{}2", axis);
      const std::string given = fmt::format("kFS{}", axis);
      if (given_and_not_zero(deck, amplitude) && deck.integer(given) == 0)
        add(Severity::Error, amplitude,
            fmt::format("moves the inner race along {}, but mode = 2 computes the position of the "
                        "race in this direction from the load",
                        kAxes[static_cast<std::size_t>(axis - 1)]),
            fmt::format("set {} to 0, or set {} to 1, or set mode to 0 or 1", amplitude, given));
    }
    if (given_and_not_zero(deck, "rotLoadFrac2") &&
        (deck.integer("kFS2") == 1 || deck.integer("kFS3") == 1))
      add(Severity::Error, "rotLoadFrac2",
          "makes a fraction of the radial load of the inner race rotate. With mode = 2, a rotating "
          "load needs given loads along y and z, but kFS2 or kFS3 gives a position",
          "set rotLoadFrac2 to 0, or set kFS2 and kFS3 to 0, or set mode to 0 or 1");
    if (deck.integer("kFS1") + deck.integer("kFS2") + deck.integer("kFS3") == 3)
      add(Severity::Error, "kFS1",
          "kFS1, kFS2 and kFS3 give the position of the inner race, so mode = 2 has no load to "
          "balance",
          "set kFS1, kFS2 or kFS3 to 0, or set mode to 1");
  }
  if (deck.integer("mode") > 0)
    for (const char* code : {"kRaceIP1", "kRaceIP2"})
      if (deck.integer(code) == 1)
        no_effect(code, "has no effect: the inertia record of a race is used in mode 0 only",
                  fmt::format("set {} to 0", code));
  return out;
}

bearing::RaceMotions build_race_motions(const Deck& deck) {
  bearing::RaceMotions out;
  constexpr std::array kLoads{"appLoadX", "appLoadY", "appLoadZ"};
  for (int race = 1; race <= 2; ++race) {
    if (!has_free_motion(deck, race)) continue;
    const auto j = static_cast<std::size_t>(race - 1);
    bearing::FreeRace& free = out.free[j].emplace();
    const double sign = race == 2 ? 1.0 : -1.0;
    for (int axis = 1; axis <= 3; ++axis) {
      const auto k = static_cast<std::size_t>(axis - 1);
      free.translation_held[k] = !is_translation_free(deck, axis, race);
      free.rotation_held[k] = !is_rotation_free(deck, axis, race);
      if (!free.translation_held[k]) free.force[axis - 1] = sign * deck.si(kLoads[k]);
    }
    if (!free.rotation_held[1]) free.moment[1] = sign * deck.si("appMomY");
    if (!free.rotation_held[2]) free.moment[2] = sign * deck.si("appMomZ");
  }
  // A law of amplitude 0 moves nothing and is left out; what belongs to it is not read, and said to
  // play no part.
  if (deck.integer("kVarLoad") == 1) {
    out.rotating_load_parameters.emplace();
    for (int race = 1; race <= 2; ++race) {
      const auto j = static_cast<std::size_t>(race - 1);
      const double fraction = deck.si(fmt::format("rotLoadFrac{}", race));
      out.rotating_load_parameters->fraction[j] = fraction;
      if (fraction != 0.0)
        out.rotating_load_parameters->speed[j] = deck.si(fmt::format("rotLoadRpm{}", race));
    }
    if (out.rotating_load_parameters->fraction == std::array{0.0, 0.0})
      out.rotating_load_parameters.reset();
  }
  for (int race = 1; race <= 2; ++race) {
    const auto j = static_cast<std::size_t>(race - 1);
    const auto of_race = [&](const char* stem) { return deck.si(fmt::format("{}{}", stem, race)); };
    if (deck.integer("kVarLoad") == 2) {
      bearing::Vibration law;
      law.amplitude = {of_race("raceVibAmp1"), of_race("raceVibAmp2"), of_race("raceVibAmp3")};
      if (!law.amplitude.isZero(0.0)) {
        law.frequency = of_race("raceVibFreq");
        out.vibration[j] = law;
      }
    }
    if (deck.integer("kVarSpeed") == 1)
      if (const double acceleration = of_race("raceAngAcc"); acceleration != 0.0)
        out.ramp[j] = {acceleration, of_race("startTime"), of_race("endTime")};
    if (deck.integer("kVarSpeed") == 2)
      if (const double amplitude = of_race("raceSpeedAmp"); amplitude != 0.0)
        out.variation[j] = {amplitude, of_race("raceSpeedFreq")};
  }
  out.frame = frame_motion(deck);
  return out;
}

std::optional<bearing::FrameMotion> frame_motion(const Deck& given) {
  const Deck deck = deck::with_orbit_records(given);
  if (deck.integer("kRotFrame") != 1) return std::nullopt;
  for (const char* name : {"brgOrbitRad", "brgAngPos", "brgAngVel", "brgLoadFrac1", "brgLoadFrac2"})
    if (!deck.has(name))
      throw InputError(
          {deck.issue(Severity::Error, name, "has no value, but kRotFrame = 1 needs it",
                      "enter its value in record 9.5")});
  if (deck.real("brgOrbitRad") < 0.0)
    throw InputError({deck.issue(Severity::Error, "brgOrbitRad", "the radius is negative",
                                 "enter 0 or a positive radius")});
  const double speed = deck.si("brgAngVel");
  if (speed == 0.0) return std::nullopt;
  return bearing::FrameMotion{speed,
                              deck.si("brgOrbitRad"),
                              deck.si("brgAngPos"),
                              {deck.si("brgLoadFrac1"), deck.si("brgLoadFrac2")}};
}

Vec3 rotating_frame_load(const Deck& deck, const std::array<bearing::Inertia, 2>& races) {
  const auto frame = frame_motion(deck);
  if (!frame) return Vec3::Zero();
  const double mass = frame->load_share[1] * races[1].mass - frame->load_share[0] * races[0].mass;
  return mass * frame->field();
}

Vec3 race_weight(const Deck& deck, const std::array<bearing::Inertia, 2>& races,
                 const Vec3& gravity) {
  Vec3 out = Vec3::Zero();
  for (int axis = 1; axis <= 3; ++axis) {
    const double g = gravity[axis - 1];
    if (is_translation_free(deck, axis, 2))
      out[axis - 1] = races[1].mass * g;
    else if (is_translation_free(deck, axis, 1))
      out[axis - 1] = -races[0].mass * g;
  }
  return out;
}

void plan_race_motions(const Deck& deck, const bearing::Bearing& bearing, scene::ScenePlan& plan,
                       const std::array<bool, 2>& driven) {
  plan.race_motions = build_race_motions(deck);
  for (std::size_t j = 0; j < 2; ++j)
    if (driven[j] && !plan.race_motions.free[j] && !(j == 1 && plan.has(Effect::RaceBalance))) {
      bearing::FreeRace& held = plan.race_motions.free[j].emplace();
      held.translation_held = held.rotation_held = {true, true, true};
    }
  const bearing::RaceMotions& motions = plan.race_motions;
  const auto effect = [&](Effect id, const char* name, bool on, std::string because) {
    plan.effects.push_back({id, name, on, std::move(because)});
  };
  const long long load = deck.integer("kVarLoad"), speed = deck.integer("kVarSpeed");
  const auto law = [&](const char* name, const char* flag, long long code, bool on,
                       std::string_view nothing) {
    effect(Effect::RaceExcitation, name, on,
           fmt::format("{} = {}{}", flag, code, code != 0 && !on ? nothing : ""));
  };
  law(load == 1 ? "rotating load" : "race vibration", "kVarLoad", load,
      motions.rotating_load_parameters || motions.vibration[0] || motions.vibration[1],
      load == 1 ? ", rotLoadFrac 0" : ", all amplitudes 0");
  law("varying race speed", "kVarSpeed", speed,
      motions.ramp[0] || motions.ramp[1] || motions.variation[0] || motions.variation[1],
      speed == 1 ? ", raceAngAcc 0" : ", amplitudes 0");
  std::string because = fmt::format("kDCR = {}", deck.integer("kDCR"));
  for (std::size_t j = 0; j < 2; ++j)
    if (motions.free[j]) {
      const auto& held = motions.free[j]->rotation_held;
      because += fmt::format(", {} {}", kRaces[j], free_text(*motions.free[j]));
      if (!held[0]) because += ", no moment about x";
    }
  for (std::size_t j = 0; j < 2; ++j)
    if (driven[j]) because += fmt::format(", {} driven by ADRX1", kRaces[j]);
  effect(Effect::FreeRaces, "races that move under loads", motions.has_free_motion(), because);
  effect(Effect::TurningFrame, "rotating base frame", motions.frame.has_value(),
         fmt::format("kRotFrame = {}{}", deck.integer("kRotFrame"),
                     deck.integer("kRotFrame") == 1 && !motions.frame ? ", brgAngVel 0" : ""));
  for (std::size_t j = 0; j < 2; ++j) add_body(bearing, motions, j, plan, driven[j]);
}

}  // namespace adore::setup
