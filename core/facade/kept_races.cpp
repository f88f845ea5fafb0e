#include "facade/kept_races.hpp"

#include <array>
#include <cstddef>

namespace adore::facade {
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

}  // namespace adore::facade
