#include "runs/kept_races.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace adore::runs {
namespace {

/// The one list of them.
template <class Races, class Visit>
void visit(Races& races, Visit&& visit) {
  constexpr std::array<const char*, 2> kRaces{"outer race ", "inner race "};
  constexpr std::array<const char*, 3> kAxes{"x", "y", "z"};
  for (std::size_t j = 0; j < 2; ++j) {
    const std::string race = kRaces[j];
    auto& one = races[j];
    for (std::size_t k = 0; k < 3; ++k) {
      visit(race + "prescribed " + kAxes[k], one.position[static_cast<int>(k)]);
      visit(race + "prescribed velocity " + kAxes[k], one.velocity[static_cast<int>(k)]);
    }
    for (std::size_t k = 0; k < 4; ++k)
      visit(race + "prescribed attitude " + static_cast<char>('1' + k), one.attitude[k]);
    visit(race + "prescribed speed", one.speed);
    visit(race + "turned", one.angle);
    visit(race + "turned at other speeds", one.turned_before);
  }
}

}  // namespace

void keep_races(const dynamics::PrescribedRaces& races, std::map<std::string, double>& out) {
  visit(races, [&](const std::string& name, double value) { out[name] = value; });
}

std::optional<dynamics::PrescribedRaces> kept_races(const std::map<std::string, double>& from) {
  dynamics::PrescribedRaces out;
  bool all = true;
  visit(out, [&](const std::string& name, double& value) {
    const auto found = from.find(name);
    if (found == from.end())
      all = false;
    else
      value = found->second;
  });
  if (!all) return std::nullopt;
  return out;
}

std::vector<std::string> jumps_of_races(const dynamics::PrescribedRaces& before,
                                        const dynamics::PrescribedRaces& now,
                                        const scene::ScenePlan& plan, results::UnitSystem units,
                                        bool moved) {
  // Below them it is rounding.
  constexpr double kPlace = 1e-12, kShare = 1e-9;  // [m], of a speed
  constexpr std::array kRace{"outer", "inner"};
  const bearing::RaceMotions& laws = plan.race_motions;
  std::vector<std::string> out;
  for (std::size_t j = 0; j < 2; ++j) {
    if (j == 1 && plan.has(scene::Effect::RaceBalance)) continue;
    const auto& free = laws.free[j];
    Vec3 way = now[j].position - before[j].position;
    for (int k = 0; k < 3; ++k)
      if (free && !free->translation_held[static_cast<std::size_t>(k)]) way[k] = 0.0;
    const bool turns = !free || free->rotation_held[0];
    const bool spins = turns && laws.variation[j] &&
                       std::abs(now[j].speed - before[j].speed) > kShare * std::abs(now[j].speed);
    const bool law = laws.vibration[j] || laws.turning_load;
    std::string what;
    if (way.norm() > kPlace && !(moved && !law))
      what = fmt::format("{:.4g} {} from its last position",
                         results::from_si(way.norm(), results::unit::kLength, units),
                         results::unit_name(results::unit::kLength, units));
    if (spins)
      what += fmt::format("{}at {:.6g} rpm instead of {:.6g}", what.empty() ? "" : " and ",
                          now[j].speed * 30.0 / std::numbers::pi,
                          before[j].speed * 30.0 / std::numbers::pi);
    if (what.empty()) continue;
    out.push_back(fmt::format(
        "the {} race jumps at the start of the continuation: it is now {}, as the deck specifies{}",
        kRace[j], what,
        law || spins
            ? ". The time of records 9.3 and 9.4 counts from the start of the files, so a changed "
              "frequency changes the phase. The first revolutions contain the impact"
            : ". The first revolutions contain the impact"));
  }
  return out;
}

}  // namespace adore::runs
