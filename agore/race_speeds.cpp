#include "agore/race_speeds.hpp"

#include "desktop/axis_scale.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace adore::agore {
namespace {

constexpr double kRaceTurn = 2.0 * std::numbers::pi;
constexpr const char* kRaceRotation = "race.rotation";

/// Rotation of a body at the frames where it is known.
struct Turns {
  std::vector<double> time, turns;
};

/// Inner minus outer race.
Turns of_both(const Animation& animation) {
  Turns out;
  for (const auto& frame : animation.file.frames) {
    out.time.push_back(frame.time);
    out.turns.push_back(frame.revolutions);
  }
  return out;
}

/// Only RESULTS.h5 counts revolutions of a race.
bool counts_turns(const Animation& animation) {
  return animation.motion && animation.motion->has(kRaceRotation) && animation.exact > 1;
}

Turns of_race(const Animation& animation, std::size_t race) {
  Turns out;
  for (std::size_t i = 0; i < animation.exact; ++i) {
    out.time.push_back(animation.time[i]);
    out.turns.push_back(animation.value(kRaceRotation, i, race) / kRaceTurn);
  }
  return out;
}

double spread(const std::vector<double>& values) {
  if (values.empty()) return 0.0;
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return *high - *low;
}

/// Speeds over equal parts of the frames [rpm], with those at both ends, to which the outer two
/// parts are continued straight.
std::vector<double> speeds_of(const Turns& of) {
  constexpr std::size_t kParts = 20;
  if (of.time.size() < 2) return {};
  const std::size_t parts = std::min(kParts, of.time.size() - 1);
  std::vector<double> middle, speed;
  for (std::size_t i = 0; i < parts; ++i) {
    const std::size_t from = i * (of.time.size() - 1) / parts,
                      to = (i + 1) * (of.time.size() - 1) / parts;
    if (!(of.time[to] > of.time[from])) continue;
    middle.push_back(0.5 * (of.time[from] + of.time[to]));
    speed.push_back(60.0 * (of.turns[to] - of.turns[from]) / (of.time[to] - of.time[from]));
  }
  if (speed.size() < 2) return speed;
  const auto at = [&](double time, std::size_t i, std::size_t j) {
    return speed[i] + (speed[j] - speed[i]) * (time - middle[i]) / (middle[j] - middle[i]);
  };
  const std::size_t last = speed.size() - 1;
  const double begins = at(of.time.front(), 0, 1), ends = at(of.time.back(), last, last - 1);
  speed.insert(speed.begin(), begins);
  speed.push_back(ends);
  return speed;
}

struct SpeedWords {
  bool steady = true;
  std::string text;  ///< "10000", "from 0 to 5000", "between -300 and 800"; empty: no frames
};

/// A varying speed is described by its first and last value or, if those are not the extremes, by
/// the extremes. `least`: smaller speeds are rounding [rpm].
SpeedWords words_of(const Turns& of, double least = 0.0) {
  constexpr double kSteady = 0.01;
  const std::vector<double> speeds = speeds_of(of);
  if (speeds.empty()) return {};
  const auto [low, high] = std::minmax_element(speeds.begin(), speeds.end());
  const double span = *high - *low, size = std::max(std::abs(*low), std::abs(*high));
  if (size <= least) return {true, "0"};
  // Parts of a run are accurate to three digits; for a race at rest only rounding remains.
  const auto words = [size](double value) {
    if (std::abs(value) < 1e-3 * size) return desktop::pretty_number(0.0, 3);
    const double digit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 2.0);
    return desktop::pretty_number(digit * std::round(value / digit), 3);
  };
  if (span <= kSteady * size) {
    const double mean =
        60.0 * (of.turns.back() - of.turns.front()) / (of.time.back() - of.time.front());
    return {true, desktop::pretty_number(mean, 3)};
  }
  const double begins = speeds.front(), ends = speeds.back();
  if (std::abs(ends - begins) > (1.0 - kSteady) * span)
    return {false, "from " + words(begins) + " to " + words(ends)};
  return {false, "between " + words(*low) + " and " + words(*high)};
}

}  // namespace

bool is_outer_race_rotating(const Animation& animation) {
  constexpr double kRounding = 0.02;  // of angles in SOL8 [rad]
  if (!counts_turns(animation)) return spread(animation.race_angle[0]) > kRounding;
  return spread(of_race(animation, 0).turns) > 1e-6 * spread(of_race(animation, 1).turns);
}

bool races_rotate_together(const Animation& animation) {
  if (!counts_turns(animation)) return false;
  return spread(of_both(animation).turns) <= 1e-6 * spread(of_race(animation, 0).turns);
}

std::string speed_text(const Animation& animation) {
  const auto joined = [](const SpeedWords& words) {
    return (words.steady ? "at " : "") + words.text;
  };
  if (!is_outer_race_rotating(animation)) {
    const SpeedWords words = words_of(of_both(animation));
    return words.text.empty() || words.text == "0" ? std::string()
                                                   : "runs " + joined(words) + " rpm";
  }
  if (!counts_turns(animation)) {
    const SpeedWords words = words_of(of_both(animation));
    return words.text.empty() ? std::string()
                              : "races " + joined(words) + " rpm relative to each other";
  }
  const std::array<Turns, 2> races{of_race(animation, 0), of_race(animation, 1)};
  double size = 0.0;
  for (const Turns& race : races)
    for (const double speed : speeds_of(race)) size = std::max(size, std::abs(speed));
  const SpeedWords outer = words_of(races[0], 1e-6 * size), inner = words_of(races[1], 1e-6 * size);
  return "races " + joined(outer) + " (outer) and " + (outer.steady ? inner.text : joined(inner)) +
         " rpm (inner)";
}

std::string divisor_text(const Animation& animation, SpeedDivisor over) {
  if (over == SpeedDivisor::FasterRace) return "the faster race";
  const bool alike = races_rotate_together(animation);
  const Turns of = alike ? of_race(animation, 1) : of_both(animation);
  const SpeedWords words = words_of(of);
  const std::string name = alike                               ? "both races, "
                           : is_outer_race_rotating(animation) ? "inner minus outer race, "
                                                               : "inner race, ";
  if (over == SpeedDivisor::Mean && !words.steady)
    return name +
           desktop::pretty_number(
               60.0 * (of.turns.back() - of.turns.front()) / (of.time.back() - of.time.front()),
               3) +
           " rpm on average";
  return name + words.text + " rpm";
}

}  // namespace adore::agore
