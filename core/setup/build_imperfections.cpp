#include "setup/build_imperfections.hpp"

#include "base/random_table.hpp"
#include "contact/roller_pocket_play.hpp"
#include "setup/check_rollers.hpp"
#include "setup/deck_text.hpp"
#include "setup/user_surfaces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace adore::setup {
namespace {

using bearing::ElementErrorSource;
using bearing::Harmonic;
using bearing::RaceErrors;
using deck::Deck;

/// Amplitude, waves per revolution and phase of the variables stem1j, stem2j, stem3j; nothing when
/// the record in force has none.
Harmonic wave(const Deck& deck, const std::string& stem, std::size_t race) {
  const auto name = [&](int i) { return fmt::format("{}{}{}", stem, i, race + 1); };
  if (!deck.has(name(1))) return {};
  return {deck.si(name(1)), deck.si(name(2)), deck.si(name(3))};
}

RaceErrors race_errors(const Deck& deck, std::size_t race, bool elliptical) {
  RaceErrors out;
  out.roundness =
      elliptical ? RaceErrors::Roundness::Elliptical : RaceErrors::Roundness::Sinusoidal;
  for (std::size_t i = 0; i < 3; ++i)
    out.variation[i] = deck.si(fmt::format("rndVar{}{}", i + 1, race + 1));
  out.curvature_factor = wave(deck, "cFacVar", race);
  out.land_offset = wave(deck, "rlOffset", race);
  out.taper = wave(deck, "rlTaper", race);
  return out;
}

/// One column of the random table times its rms value; zeros where the record has no such variable.
class Deviations {
 public:
  Deviations(const Deck& deck, std::uint64_t seed) : deck_(deck), table_(seed) {}

  [[nodiscard]] double at(const char* variable, std::size_t element, RandomColumn column) const {
    const double rms = deck_.has(variable) ? deck_.si(variable) : 0.0;
    return rms == 0.0 ? 0.0
                      : rms * table_.standard_normal(element, static_cast<std::uint64_t>(column));
  }

 private:
  const Deck& deck_;
  RandomTable table_;
};

std::string diameter_variable(ElementErrorSource kind, std::size_t element) {
  return kind == ElementErrorSource::Random ? "reDiaVar" : fmt::format("reDiaVar{}", element + 1);
}

void check_positive(const Deck& deck, double value, const char* what, std::size_t element,
                    const std::string& variable) {
  if (value > 0.0) return;
  throw InputError({deck.issue(
      Severity::Error, variable,
      fmt::format("rolling element {} with its deviation has a {} of {}, which must be above 0",
                  element + 1, what, length_text(deck, value)),
      "give smaller deviations")});
}

/// Origin of the factor of a groove.
std::string curvature_variable(const bearing::Bearing& b, std::size_t race) {
  return fmt::format("{}{}", b.imperfections.race[race].given ? "kRaceGeoImp" : "cFacVar1",
                     race + 1);
}

/// Each ball must fit in its grooves at every position: groove radius between half its diameter
/// and its diameter.
void check_grooves(const Deck& deck, const bearing::Bearing& b) {
  const double D = b.balls().diameter;
  for (std::size_t k = 0; k < b.imperfections.ball_diameter.size(); ++k)
    for (std::size_t j = 0; j < 2; ++j) {
      const double ratio = b.balls().groove_factor[j] * D / (D + b.imperfections.ball_diameter[k]);
      if (ratio > 0.5 && (ratio < 1.0 || b.balls().groove_factor[j] >= 1.0)) continue;
      throw InputError(
          {deck.issue(Severity::Error, diameter_variable(b.imperfections.elements, k),
                      fmt::format("ball {} with its deviation of {} does not fit the {} groove: "
                                  "the groove radius would be {:.6g} times the ball diameter",
                                  k + 1, length_text(deck, b.imperfections.ball_diameter[k]),
                                  j == 0 ? "outer" : "inner", ratio),
                      "give smaller deviations. The groove radius must be between 0.5 and 1 times "
                      "the ball diameter")});
    }
  double smallest = D, largest = D;
  for (const double growth : b.imperfections.ball_diameter) {
    smallest = std::min(smallest, D + growth);
    largest = std::max(largest, D + growth);
  }
  for (std::size_t j = 0; j < 2; ++j) {
    const auto [low, high] = b.imperfections.race[j].curvature_range();
    const double f = b.balls().groove_factor[j];
    // A groove that is open (f >= 1) has a separate limit: groove_geometry.
    if ((f + low) * D > 0.5 * largest && (f >= 1.0 || (f + high) * D < smallest)) continue;
    throw InputError(
        {deck.issue(Severity::Error, curvature_variable(b, j),
                    fmt::format("the groove factor raceCurFac{} = {:.6g} varies from {:.6g} to "
                                "{:.6g} around the race, so the balls do not fit at every azimuth",
                                j + 1, f, f + low, f + high),
                    "give an amplitude that keeps the groove factor above 0.5 and below 1")});
  }
}

/// Barrels must fit in their grooves: groove radius above the crown radius.
void check_barrel_grooves(const Deck& deck, const bearing::Bearing& b) {
  for (std::size_t j = 0; j < 2; ++j) {
    const double f = b.rollers()->groove_factor[j];
    const auto [low, high] = b.imperfections.race[j].curvature_range();
    if (f + low > 0.5) continue;
    throw InputError(
        {deck.issue(Severity::Error, curvature_variable(b, j),
                    fmt::format("the groove factor raceCurFac{} = {:.6g} varies from {:.6g} to "
                                "{:.6g} around the race, so the rollers do not fit at every "
                                "azimuth",
                                j + 1, f, f + low, f + high),
                    "give an amplitude that keeps the groove factor above 0.5")});
  }
}

bearing::RollerDeviation random_roller(const Deviations& random, std::size_t k,
                                       const bearing::RollerGeometry& nominal) {
  bearing::RollerDeviation out;
  out.diameter = random.at("reDiaVar", k, RandomColumn::Diameter);
  out.crown_radius = random.at("reCrnVar", k, RandomColumn::CrownRadius);
  out.length = random.at("reLenVar", k, RandomColumn::Length);
  out.central_length =
      std::clamp(random.at("reCLVar", k, RandomColumn::CentralLength), -nominal.central_length,
                 std::max(0.0, nominal.length + out.length - nominal.central_length));
  out.land_offset = random.at("reCLOffset", k, RandomColumn::LandOffset);
  return out;
}

double diameter_deviation(const Deck& deck, const Deviations& random, ElementErrorSource kind,
                          std::size_t k) {
  const std::string name = diameter_variable(kind, k);
  return kind == ElementErrorSource::Random ? random.at(name.c_str(), k, RandomColumn::Diameter)
                                            : deck.si(name);
}

void element_errors(const Deck& deck, std::uint64_t seed, bearing::Bearing& b) {
  bearing::Imperfections& out = b.imperfections;
  const long long code = deck.integer("kReGeoImp");
  if (code != 1 && code != 2) return;
  out.elements = static_cast<ElementErrorSource>(code);
  if (out.elements == ElementErrorSource::Random) out.seed = seed;
  const Deviations random(deck, seed);
  const auto count = static_cast<std::size_t>(b.element_count());
  if (!b.rollers()) {
    for (std::size_t k = 0; k < count; ++k) {
      out.ball_diameter.push_back(diameter_deviation(deck, random, out.elements, k));
      check_positive(deck, b.balls().diameter + out.ball_diameter.back(), "diameter", k,
                     diameter_variable(out.elements, k));
    }
    return;
  }
  bearing::RollerGeometry& rollers = *b.rollers();
  rollers.deviation.clear();
  for (std::size_t k = 0; k < count; ++k) {
    bearing::RollerDeviation own;
    if (out.elements == ElementErrorSource::Random)
      own = random_roller(random, k, rollers);
    else
      own.diameter = diameter_deviation(deck, random, out.elements, k);
    check_positive(deck, rollers.diameter + own.diameter, "diameter", k,
                   diameter_variable(out.elements, k));
    check_positive(deck, rollers.length + own.length, "length", k, "reLenVar");
    check_positive(deck, rollers.crown_radius + own.crown_radius, "crown radius", k, "reCrnVar");
    rollers.deviation.push_back(own);
  }
  check_roller_deviations(deck, rollers);
}

/// Record 7.4 by `value`, which takes a variable and its column of the random table. Guide
/// faces have separate widths (record 7.3), independent of the wall.
template <class Value>
bearing::PocketDeviation pocket_deviation(const Deck& deck, bool two, bool faces, Value&& value) {
  bearing::PocketDeviation out;
  out.clearance = {value("bPocClsVar1", RandomColumn::PocketClearance1),
                   two ? value("bPocClsVar2", RandomColumn::PocketClearance2) : 0.0};
  const deck::ReportOnly quiet(deck, deck.integer("mode") < 0);  // a play has nothing of these
  if (!faces) out.thickness = value("bPocThknsVar", RandomColumn::PocketThickness);
  out.axial = value("bPocCenVar1", RandomColumn::PocketAxial);
  out.angular = value("bPocCenVar2", RandomColumn::PocketAngular);
  out.tilt = {value("bPocAngVar1", RandomColumn::PocketTilt1),
              value("bPocAngVar2", RandomColumn::PocketTilt2),
              value("bPocAngVar3", RandomColumn::PocketTilt3)};
  return out;
}

/// kCagePocImp: 1 the first pocket, 2 all identical, 3 each separately.
void pocket_errors(const Deck& deck, std::uint64_t seed, bearing::Bearing& b) {
  if (!b.cage || !deck.has("bPocClsVar1")) return;
  const bool two = !b.rollers() && deck.integer("kPocType") >= 2;  // pockets with clearance II
  const bool faces = !b.cage->pocket_faces.empty();
  const auto given = [&deck](const char* variable, RandomColumn) { return deck.si(variable); };
  const long long code = deck.integer("kCagePocImp");
  if (code == 2) {
    bearing::PocketDeviation& all = b.cage->every_pocket;
    all = pocket_deviation(deck, two, faces, given);
    if (faces) b.cage->pocket_faces = contact::widened(b.cage->pocket_faces, all.clearance[0]);
    b.cage->pocket_clearance_1 += all.clearance[0];
    b.cage->pocket_clearance_2 += all.clearance[1];
    all.clearance = {};
  } else if (code == 1) {
    b.cage->pocket_deviation = {pocket_deviation(deck, two, faces, given)};
  } else if (code == 3) {
    const Deviations random(deck, seed);
    for (std::size_t k = 0; k < static_cast<std::size_t>(b.element_count()); ++k)
      b.cage->pocket_deviation.push_back(
          pocket_deviation(deck, two, faces, [&](const char* variable, RandomColumn column) {
            return random.at(variable, k, column);
          }));
  }
}

/// ADRX8: one call for all that the deck asks it for.
void user_errors(const Deck& deck, const UserHooks& user, bearing::Bearing& b) {
  const auto count = static_cast<std::size_t>(b.element_count());
  bearing::UserTables t(count);
  t.elements = deck.integer("kReGeoImp") == 3;
  t.pockets = b.cage && deck.has("kCagePocImp") && deck.integer("kCagePocImp") == 4;
  t.inertia = deck.has("kReIP") && deck.integer("kReIP") == 3;
  if (!t.elements && !t.pockets && !t.inertia) return;
  const bearing::Inertia ideal = b.element_inertia;
  t.mass = ideal.mass;
  t.moments = ideal.moments;
  t.geometric_centre = ideal.geometric_centre;
  t.frame = ideal.frame;
  user.imperfections(t);
  if (t.elements) {
    bearing::RollerGeometry* rollers = b.rollers();
    b.imperfections.elements = ElementErrorSource::Listed;
    if (rollers != nullptr) rollers->deviation.clear();
    for (std::size_t k = 0; k < count; ++k) {
      check_positive(deck, b.element_diameter() + t.diameter[k], "diameter", k, "kReGeoImp");
      if (rollers == nullptr) {
        b.imperfections.ball_diameter.push_back(t.diameter[k]);
        continue;
      }
      bearing::RollerDeviation own;
      own.diameter = t.diameter[k];
      own.crown_radius = t.crown_radius[k];
      own.length = t.length[k];
      own.central_length = t.central_length[k];
      own.land_offset = t.land_offset[k];
      check_positive(deck, rollers->length + own.length, "length", k, "kReGeoImp");
      check_positive(deck, rollers->crown_radius + own.crown_radius, "crown radius", k,
                     "kReGeoImp");
      rollers->deviation.push_back(own);
    }
    if (rollers != nullptr) check_roller_deviations(deck, *rollers);
  }
  if (t.pockets)
    for (std::size_t k = 0; k < count; ++k) {
      bearing::PocketDeviation own;
      own.clearance = {t.pocket_clearance_1[k], t.pocket_clearance_2[k]};
      own.thickness = t.pocket_thickness[k];
      own.axial = t.pocket_axial[k];
      own.angular = t.pocket_angular[k];
      own.tilt = {t.pocket_tilt[3 * k], t.pocket_tilt[3 * k + 1], t.pocket_tilt[3 * k + 2]};
      b.cage->pocket_deviation.push_back(own);
    }
  if (t.inertia) {
    b.element_inertia.mass = t.mass;
    b.element_inertia.moments = t.moments;
    b.element_inertia.geometric_centre = t.geometric_centre;
    b.element_inertia.frame = t.frame;
    if (b.rollers() != nullptr) b.roller_mass_offset = -t.geometric_centre.x();
  }
}

}  // namespace

void build_imperfections(const Deck& deck, std::uint64_t seed, bearing::Bearing& bearing,
                         const UserHooks* user) {
  element_errors(deck, seed, bearing);
  pocket_errors(deck, seed, bearing);
  if (has_routine(user, 8)) user_errors(deck, *user, bearing);
  if (has_routine(user, 5)) {
    apply_user_element_surfaces(*user, bearing);
    if (bearing.rollers() != nullptr) check_roller_deviations(deck, *bearing.rollers());
  }
  for (std::size_t race = 0; race < 2; ++race) {
    const long long code = deck.integer(fmt::format("kRaceGeoImp{}", race + 1));
    if (code == 3 && has_routine(user, 6)) apply_user_race_surface(*user, race, bearing);
    if (code != 1 && code != 2) continue;
    bearing.imperfections.race_given[race] = true;
    bearing.imperfections.race[race] = race_errors(deck, race, code == 1);
  }
  if (!bearing.rollers())
    check_grooves(deck, bearing);
  else if (bearing.rollers()->shape == bearing::RollerShape::Arc)
    check_barrel_grooves(deck, bearing);
}

}  // namespace adore::setup
