#include "runs/stored_races.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace adore::runs {
namespace {

/// Visits each stored value with its name in FINAL and MASTER.
template <class Races, class Visitor>
void visit_values(Races& races, Visitor&& visitor) {
  constexpr std::array<const char*, 2> kRaces{"outer race ", "inner race "};
  constexpr std::array<const char*, 3> kAxes{"x", "y", "z"};
  for (std::size_t j = 0; j < 2; ++j) {
    const std::string race = kRaces[j];
    auto& one = races[j];
    for (std::size_t k = 0; k < 3; ++k) {
      visitor(race + "prescribed " + kAxes[k], one.position[static_cast<int>(k)]);
      visitor(race + "prescribed velocity " + kAxes[k], one.velocity[static_cast<int>(k)]);
    }
    for (std::size_t k = 0; k < 4; ++k)
      visitor(race + "prescribed attitude " + static_cast<char>('1' + k), one.attitude[k]);
    visitor(race + "prescribed speed", one.speed);
    visitor(race + "turned", one.angle);
    visitor(race + "turned at other speeds", one.turned_before);
  }
}

}  // namespace

void store_races(const dynamics::PrescribedRaces& races, std::map<std::string, double>& out) {
  visit_values(races, [&](const std::string& name, double value) { out[name] = value; });
}

std::optional<dynamics::PrescribedRaces> stored_races(const std::map<std::string, double>& from) {
  dynamics::PrescribedRaces out;
  bool all = true;
  visit_values(out, [&](const std::string& name, double& value) {
    const auto found = from.find(name);
    if (found == from.end())
      all = false;
    else
      value = found->second;
  });
  if (!all) return std::nullopt;
  return out;
}

std::vector<std::string> describe_race_jumps(const dynamics::PrescribedRaces& before,
                                             const dynamics::PrescribedRaces& now,
                                             const scene::ScenePlan& plan,
                                             results::UnitSystem units, bool moved) {
  // Below them it is rounding.
  constexpr double kPositionRounding = 1e-12, kSpeedRounding = 1e-9;  // [m], of a speed
  constexpr std::array kRace{"outer", "inner"};
  const bearing::RaceMotions& laws = plan.race_motions;
  std::vector<std::string> out;
  for (std::size_t j = 0; j < 2; ++j) {
    if (j == 1 && plan.has(scene::Effect::RaceBalance)) continue;
    const auto& free = laws.free[j];
    Vec3 shift = now[j].position - before[j].position;
    for (int k = 0; k < 3; ++k)
      if (free && !free->translation_held[static_cast<std::size_t>(k)]) shift[k] = 0.0;
    const bool prescribed_turn = !free || free->rotation_held[0];
    const bool speed_jumps =
        prescribed_turn && laws.variation[j] &&
        std::abs(now[j].speed - before[j].speed) > kSpeedRounding * std::abs(now[j].speed);
    const bool law = laws.vibration[j] || laws.rotating_load_parameters;
    std::string what;
    if (shift.norm() > kPositionRounding && !(moved && !law))
      what = fmt::format("{:.4g} {} from its last position",
                         results::from_si(shift.norm(), results::unit::kLength, units),
                         results::unit_name(results::unit::kLength, units));
    if (speed_jumps)
      what += fmt::format("{}at {:.6g} rpm instead of {:.6g}", what.empty() ? "" : " and ",
                          now[j].speed * 30.0 / std::numbers::pi,
                          before[j].speed * 30.0 / std::numbers::pi);
    if (what.empty()) continue;
    out.push_back(fmt::format(
        "at the start of the continuation the {} race jumps, as the deck specifies: it is {}{}",
        kRace[j], what,
        law || speed_jumps ? ". Time in records 9.3 and 9.4 is counted from the start of the first "
                             "run, so a changed frequency also changes the phase. The jump acts as "
                             "an impact in the first revolutions"
                           : ". The jump acts as an impact in the first revolutions"));
  }
  return out;
}

}  // namespace adore::runs
