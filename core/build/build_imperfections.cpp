#include "build/build_imperfections.hpp"

#include "base/random_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace adore::build {
namespace {

using bearing::ElementErrors;
using bearing::Harmonic;
using bearing::RaceErrors;
using deck::Deck;

/// Amplitude, waves per turn and phase of the variables stem1j, stem2j, stem3j; nothing when the
/// record in force has none.
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
    return rms == 0.0 ? 0.0 : rms * table_.normal(element, static_cast<std::uint64_t>(column));
  }

 private:
  const Deck& deck_;
  RandomTable table_;
};

void check_positive(double value, const char* what, std::size_t element) {
  if (value > 0.0) return;
  throw InputError(
      fmt::format("rolling element {}: its deviation (records 5G.1) leaves a {} of {} m; it must "
                  "stay above 0. Give smaller deviations",
                  element + 1, what, value));
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

double diameter_deviation(const Deck& deck, const Deviations& random, ElementErrors kind,
                          std::size_t k) {
  return kind == ElementErrors::Random ? random.at("reDiaVar", k, RandomColumn::Diameter)
                                       : deck.si(fmt::format("reDiaVar{}", k + 1));
}

void element_errors(const Deck& deck, std::uint64_t seed, bearing::Bearing& b) {
  bearing::Imperfections& out = b.imperfections;
  const long long code = deck.integer("kReGeoImp");
  if (code != 1 && code != 2) return;
  out.elements = static_cast<ElementErrors>(code);
  if (out.elements == ElementErrors::Random) out.seed = seed;
  const Deviations random(deck, seed);
  const auto count = static_cast<std::size_t>(b.element_count());
  if (!b.rollers) {
    for (std::size_t k = 0; k < count; ++k) {
      out.ball_diameter.push_back(diameter_deviation(deck, random, out.elements, k));
      check_positive(b.balls.diameter + out.ball_diameter.back(), "diameter", k);
    }
    return;
  }
  bearing::RollerGeometry& rollers = *b.rollers;
  rollers.deviation.clear();
  for (std::size_t k = 0; k < count; ++k) {
    bearing::RollerDeviation own;
    if (out.elements == ElementErrors::Random)
      own = random_roller(random, k, rollers);
    else
      own.diameter = diameter_deviation(deck, random, out.elements, k);
    check_positive(rollers.diameter + own.diameter, "diameter", k);
    check_positive(rollers.length + own.length, "length", k);
    check_positive(rollers.crown_radius + own.crown_radius, "crown radius", k);
    rollers.deviation.push_back(own);
  }
}

}  // namespace

void build_imperfections(const Deck& deck, std::uint64_t seed, bearing::Bearing& bearing) {
  element_errors(deck, seed, bearing);
  for (std::size_t race = 0; race < 2; ++race) {
    const long long code = deck.integer(fmt::format("kRaceGeoImp{}", race + 1));
    if (code != 1 && code != 2) continue;
    bearing.imperfections.race_given[race] = true;
    bearing.imperfections.race[race] = race_errors(deck, race, code == 1);
  }
}

}  // namespace adore::build
