#include "drawing/outline_model.hpp"

#include "contact/roller_shape.hpp"
#include "contact/tapered_geometry.hpp"
#include "deck/lookup.hpp"
#include "setup/build_bearing.hpp"
#include "setup/build_rollers.hpp"
#include "setup/read_cage.hpp"
#include "statics/roller_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace adore::drawing {
namespace {

using bearing::Type;
using deck::Deck;

constexpr double kWall = 0.35;  // of the element diameter: ring behind a raceway without envelope
constexpr double kEffectiveModulus =
    1.1e11;  // of steel on steel [Pa]; the places of flanges do not depend on it

bool is_number(const Deck& deck, std::string_view name) {
  const deck::Value* value = deck::find_value(deck, name);
  return value != nullptr &&
         (std::holds_alternative<double>(*value) || std::holds_alternative<long long>(*value));
}

/// Names without which there is no rolling element to draw, by type.
std::vector<std::string> needed(Type type) {
  std::vector<std::string> names = {"nRe", "bReDia", "rmsAspHt1", "rmsAspHt2"};
  const auto add = [&](std::initializer_list<const char*> more) {
    names.insert(names.end(), more.begin(), more.end());
  };
  if (type == Type::Ball)
    add({"pitchDia", "raceCurFac1", "raceCurFac2", "shimThickness1", "shimThickness2",
         "shoulderDia1", "shoulderDia2", "freeConAng", "freeIntCls"});
  else
    add({"bReCrn", "bReLen"});
  if (type == Type::Cylindrical || type == Type::Spherical) add({"pitchDia", "freeIntCls"});
  if (type == Type::Cylindrical || type == Type::Tapered)
    add({"bReCenLen", "raceLandLmt1", "raceLandLmt2"});
  if (type == Type::Tapered || type == Type::SphericalTapered) add({"raceTaper1", "raceTaper2"});
  if (type == Type::Spherical || type == Type::SphericalTapered)
    add({"raceCurFac1", "raceCurFac2"});
  if (type == Type::Spherical) add({"freeConAng"});
  return names;
}

[[noreturn]] void refuse(const Deck& deck, std::string_view name, std::string message,
                         std::string remedy) {
  throw InputError({deck.issue(Severity::Error, name, std::move(message), std::move(remedy))});
}

/// Rejects a value that a roller needs, when a deck is incomplete or half typed.
void demand_number(const Deck& deck, const std::string& name) {
  if (!is_number(deck, name))
    refuse(deck, name, "no value yet", "enter a value to see the drawing");
}

/// Variables that build_roller_geometry() reads in addition to needed(): crowns of raceways, and
/// the flanges that the deck has.
void demand_rollers(const Deck& deck, Type type) {
  if (type == Type::Cylindrical || type == Type::Tapered)
    for (const char* race : {"1", "2"}) {
      demand_number(deck, std::string("raceCrn") + race);
      if (deck.si(std::string("raceCrn") + race) > 0.0)
        demand_number(deck, std::string("raceCenLen") + race);
    }
  for (const char* race : {"1", "2"}) {
    int sides = 0;
    for (const char* side : {"1", "2"}) {
      const std::string code = std::string(side) + race;
      demand_number(deck, "kFlngInd" + code);
      if (deck.integer("kFlngInd" + code) != 1) continue;
      ++sides;
      demand_number(deck, "flngAng" + code);
      demand_number(deck, "flngHt" + code);
    }
    if (sides == 2) demand_number(deck, std::string("flngCls") + race);
  }
}

void check_pitch(const Deck& deck, const OutlineModel& m) {
  if (!(m.pitch > m.diameter) || m.pitch > 1000.0 * m.diameter)
    refuse(deck, "pitchDia", "not a possible pitch diameter",
           "enter a value between bReDia and 1000 times bReDia");
}

void read_rollers(const Deck& deck, OutlineModel& m) {
  demand_rollers(deck, m.type);
  m.rollers = setup::build_roller_geometry(deck);
  m.pitch = m.rollers->pitch_diameter;
  m.length = m.rollers->length;
  m.angle = m.rollers->axis_angle;
  m.profile = contact::roller_profile(*m.rollers);
  contact::check_roller_profile(m.profile);
  bearing::Bearing b;
  b.type = m.type;
  b.elements = *m.rollers;
  m.races = statics::race_surfaces(b);
  if (!m.rollers->has_flange(0) && !m.rollers->has_flange(1)) return;
  try {
    m.flanges = statics::flange_end_pairs(m.type, *m.rollers,
                                          {kEffectiveModulus, kEffectiveModulus}, m.profile);
  } catch (const std::exception& error) {
    m.remarks.push_back(fmt::format("Flanges are not drawn: {}.", error.what()));
  }
}

void read_envelope(const Deck& deck, OutlineModel& m) {
  const double bore = 0.5 * value_or_zero(deck, "brgBore");
  const double outside = 0.5 * value_or_zero(deck, "brgOD");
  const double wall = kWall * m.diameter;
  m.ring_radius = {outside, bore};
  if (!(outside > m.raceway(0))) {
    m.ring_radius[0] = m.raceway(0) + wall;
    m.remarks.emplace_back(
        "brgOD must be larger than the outer raceway diameter. An outer ring with an assumed "
        "outside diameter is drawn.");
  }
  if (!(bore < m.raceway(1)) || !(bore > 0.0)) {
    m.ring_radius[1] = std::max(m.raceway(1) - wall, 0.2 * m.raceway(1));
    m.remarks.emplace_back(
        "brgBore must be above 0 and smaller than the inner raceway diameter. An inner ring with "
        "an assumed bore is drawn.");
  }
  for (std::size_t j = 0; j < 2; ++j) {
    m.ring_width[j] = value_or_zero(deck, j == 0 ? "raceWidth1" : "raceWidth2");
    if (m.ring_width[j] > 0.0 && m.ring_width[j] < 50.0 * m.diameter) continue;
    m.ring_width[j] = 1.2 * m.length;
    m.remarks.push_back(
        fmt::format("raceWidth{} has an implausible value. The ring is drawn with a width of 1.2 "
                    "times the element length.",
                    j + 1));
  }
  const double shaft = 0.5 * value_or_zero(deck, "shftID");
  m.shaft_bore = shaft > 0.0 && shaft < m.ring_radius[1] ? shaft : 0.0;
  const double housing = 0.5 * value_or_zero(deck, "hsngOD");
  m.housing = housing > m.ring_radius[0] ? housing : 0.0;
  // A housing that would dwarf the bearing is cut off.
  const double most = m.ring_radius[0] + 4.0 * m.diameter;
  if (m.housing > most) {
    m.housing = most;
    m.remarks.emplace_back(
        "The housing is too large for the drawing; only a part of its wall is drawn.");
  }
}

}  // namespace

double value_or_zero(const Deck& deck, std::string_view name, int instance, int index) {
  const deck::Value* value = deck::find_value(deck, name, instance, index);
  if (value == nullptr || std::holds_alternative<std::monostate>(*value) ||
      std::holds_alternative<std::string>(*value))
    return 0.0;
  const double number = deck.si(name, instance, index);
  return std::isfinite(number) ? number : 0.0;
}

double OutlineModel::raceway(int race) const {
  const double sigma = race == 0 ? 1.0 : -1.0;
  if (rollers) return rollers->race_radius(race);
  const auto j = static_cast<std::size_t>(race);
  return groove.centre_radius[j] + sigma * groove.groove_radius[j];
}

std::optional<OutlineCage> outline_cage(const Deck& deck) {
  if (deck.integer("nCseg") < 1) return {};
  OutlineCage cage{setup::read_cage(
      deck, [&](std::string_view variable, int i) { return value_or_zero(deck, variable, i); })};
  if (!(cage.inner_diameter > 0.0) || !(cage.outer_diameter > cage.inner_diameter) ||
      !(cage.width > 0.0))
    return {};
  if (std::abs(cage.cone_angle) > 1.0) cage.cone_angle = 0.0;
  cage.cut = value_or_zero(deck, "cageAngCut");
  if (deck.integer("kBrg") != 1)
    cage.face_pairs = static_cast<int>(std::clamp(deck.integer("kPocType"), 0LL, 3LL));
  cage.segments = static_cast<int>(std::min(deck.integer("nCseg"), 1000LL));
  return cage;
}

OutlineModel outline_model(const Deck& deck) {
  OutlineModel m;
  const long long code = deck.integer("kBrg");
  if (code < 1 || code > 5) refuse(deck, "kBrg", "not a bearing type", "enter 1 to 5");
  m.type = static_cast<Type>(code);
  for (const std::string& name : needed(m.type)) demand_number(deck, name);
  m.count = static_cast<int>(std::clamp(deck.integer("nRe"), 0LL, 100000LL));
  m.diameter = deck.si("bReDia");
  if (!(m.diameter > 0.0) || !std::isfinite(m.diameter))
    refuse(deck, "bReDia", "not a valid diameter", "enter a value above 0");
  if (m.type == Type::Ball) {
    m.pitch = deck.si("pitchDia");
    check_pitch(deck, m);
    for (const char* factor : {"raceCurFac1", "raceCurFac2"})
      if (!(deck.si(factor) > 0.5) || deck.si(factor) > 10.0)
        refuse(deck, factor, "not a possible groove factor",
               "enter a value above 0.5 and up to 10");
    m.balls = setup::build_ball_geometry(deck);
    m.balls->groove_plane.reset();  // drawn where the balls touch, for any origin of displacements
    m.groove = contact::groove_geometry(*m.balls);
    m.length = m.diameter;
    m.angle = m.balls->contact_angle;
  } else {
    read_rollers(deck, m);
  }
  check_pitch(deck, m);
  if (std::abs(value_or_zero(deck, "freeIntCls")) > m.diameter)
    refuse(deck, "freeIntCls", "larger than the element diameter", "check the value and its unit");
  read_envelope(deck, m);
  m.cage = outline_cage(deck);
  if (deck.integer("nCseg") > 0 && !m.cage)
    m.remarks.emplace_back(
        "The cage is not drawn. cageDia1 must be larger than cageDia2, and cageWidth must be above "
        "0.");
  return m;
}

}  // namespace adore::drawing
