#include "agore/race_speeds.hpp"
#include "base/constants.hpp"
#include "base/counted.hpp"
#include "results/channels.hpp"
#include "results/run_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

/// The curves next to the pictures: from RESULTS.h5, from the SOL file of the body, or from SOL8.
namespace adore::agore {
namespace {

constexpr double kWholeTurn = 2.0 * std::numbers::pi;

/// d(angle)/dt between the neighbors of each value; one-sided at the ends.
std::vector<double> slope(const std::vector<double>& angle, const std::vector<double>& time) {
  const std::size_t n = std::min(angle.size(), time.size());
  std::vector<double> out(n, kNaN);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t low = i > 0 ? i - 1 : 0, high = std::min(i + 1, n - 1);
    if (time[high] > time[low]) out[i] = (angle[high] - angle[low]) / (time[high] - time[low]);
  }
  return out;
}

void divide(std::vector<double>& values, const std::vector<double>& by) {
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = i < by.size() && std::abs(by[i]) > 0.0 ? values[i] / by[i] : kNaN;
}

// --- RESULTS.h5

History of_motion(const Animation& animation, const std::string& id, std::size_t place) {
  History out;
  out.time = animation.motion->times();
  out.value = animation.motion->series(id, place, &out.unit);
  if (animation.motion->has(id + "_low") && animation.motion->has(id + "_high")) {
    out.low = animation.motion->series(id + "_low", place);
    out.high = animation.motion->series(id + "_high", place);
  }
  return out;
}

/// The larger one of both at each time.
void take_larger(History& out, const History& other) {
  const auto larger = [](std::vector<double>& mine, const std::vector<double>& others) {
    for (std::size_t i = 0; i < std::min(mine.size(), others.size()); ++i)
      mine[i] = std::max(mine[i], others[i]);
  };
  larger(out.value, other.value);
  larger(out.low, other.low);
  larger(out.high, other.high);
}

std::vector<double> race_speed(const Animation& animation, std::size_t race) {
  return slope(animation.motion->series("race.rotation", race), animation.motion->times());
}

/// Divisor of the ratios [rad/s].
std::vector<double> divisor_of_motion(const Animation& animation) {
  if (races_rotate_together(animation)) return race_speed(animation, 1);
  return slope(animation.motion->series("shaft_rotation", 0), animation.motion->times());
}

/// Ratios in the SOL file of a cage after the end of RESULTS.h5 have another divisor (N54).
std::function<History(const Animation&)> if_same_divisor(
    const Animation& animation, std::function<History(const Animation&)> alone) {
  if (animation.alone && cage_speed_divisor(*animation.alone) == SpeedDivisor::FasterRace)
    return {};
  return alone;
}

/// From a ratio over the faster race, as files have it (N54), to one as all others here are.
void change_divisor(History& out, const Animation& animation) {
  const std::vector<double> outer = race_speed(animation, 0), inner = race_speed(animation, 1),
                            divisor = divisor_of_motion(animation);
  for (std::size_t i = 0; i < out.value.size(); ++i) {
    const double faster = std::abs(outer.at(i)) > std::abs(inner.at(i)) ? outer[i] : inner[i];
    out.value[i] = std::abs(divisor.at(i)) > 0.0 ? out.value[i] * faster / divisor[i] : kNaN;
  }
}

/// Values of RESULTS.h5, and after its end those of SOL8 or a SOL file; `alone` null: those files
/// do not contain it, and the curve ends before the frames.
History with_rest(const Animation& animation, History exact,
                  const std::function<History(const Animation&)>& alone) {
  if (!animation.alone || exact.time.empty()) return exact;
  constexpr double kRounding = 1e-6;  // of times in SOL files
  const double end = exact.time.back();
  const auto add = [&](double time, double value) {
    if (!(time - end > kRounding * std::abs(end))) return;
    exact.time.push_back(time);
    exact.value.push_back(value);
    for (std::vector<double>* band : {&exact.low, &exact.high})
      if (!band->empty()) band->push_back(kNaN);
  };
  if (!alone) {
    for (std::size_t i = animation.exact; i < animation.frames(); ++i) add(animation.time[i], kNaN);
    return exact;
  }
  const History more = alone(*animation.alone);
  for (std::size_t i = 0; i < more.time.size(); ++i) add(more.time[i], more.value.at(i));
  return exact;
}

// --- SOL1-SOL6 next to SOL8 without RESULTS.h5

constexpr double kRpm = kWholeTurn / 60.0;

/// A file of the same run for a body: its values of some columns.
struct Stored {
  std::vector<double> time, revolutions;
  std::vector<std::vector<double>> columns;
  std::vector<std::string> units;
};

std::optional<Stored> stored_beside(const Animation& animation, int index,
                                    const std::vector<std::string>& ids) {
  for (const std::filesystem::path& path :
       results::run_folder(animation.file.path.parent_path()).plots) {
    try {
      results::SolRange range{1, 1, 1};
      const results::SolFile head = results::read_sol(path, range);
      if (head.header.run_id != animation.file.run_id || head.header.index != index ||
          head.header.elements != animation.file.elements)
        continue;
      const std::vector<results::SolColumn> columns = results::sol_columns(head.header);
      std::vector<std::size_t> places;
      Stored out;
      for (const std::string& id : ids) {
        const auto found = std::find_if(columns.begin(), columns.end(),
                                        [&](const auto& column) { return column.id == id; });
        if (found == columns.end()) return std::nullopt;
        places.push_back(static_cast<std::size_t>(found - columns.begin()));
        out.units.push_back(results::unit_of_column(head, *found));
      }
      range = {};
      range.columns = places;
      std::sort(range.columns.begin(), range.columns.end());
      range.columns.erase(std::unique(range.columns.begin(), range.columns.end()),
                          range.columns.end());
      const results::SolFile file = results::read_sol(path, range);
      out.columns.resize(ids.size());
      for (const auto& step : file.steps) {
        out.time.push_back(step.time);
        out.revolutions.push_back(step.revolutions);
        for (std::size_t i = 0; i < places.size(); ++i) {
          const std::size_t at = file.place(places[i]);
          out.columns[i].push_back(at < step.values.size() ? step.values[at] : kNaN);
        }
      }
      return out;
    } catch (const std::exception&) {
      continue;  // another file may be good
    }
  }
  return std::nullopt;
}

int cage_index(const Animation& animation) { return animation.file.elements + 1; }
/// For a cage without segments, or none.
int race_index(const Animation& animation, std::size_t race) {
  return animation.file.elements + (animation.has_cage ? 1 : 0) + 1 + static_cast<int>(race);
}

/// Whirl near the axis is left out.
void keep_clear_of_axis(History& whirl, const std::vector<double>& radius, double clearance) {
  if (!(clearance > 0.0))
    for (const double r : radius)
      if (std::isfinite(r)) clearance = std::max(clearance, r);
  const double least = kNearAxis * clearance;
  for (std::size_t i = 0; i < std::min(radius.size(), whirl.value.size()); ++i) {
    if (radius[i] >= least) continue;
    for (std::vector<double>* values : {&whirl.value, &whirl.low, &whirl.high})
      if (i < values->size()) (*values)[i] = kNaN;
    whirl.least_radius = least;
  }
  if (!whirl.value.empty() && std::none_of(whirl.value.begin(), whirl.value.end(),
                                           [](double value) { return std::isfinite(value); }))
    whirl.unknown = "The cage center stays too close to the axis for a whirl.";
}

std::optional<History> one_column(const Animation& animation, int index, const std::string& id) {
  auto stored = stored_beside(animation, index, {id});
  if (!stored) return std::nullopt;
  return History{std::move(stored->time), std::move(stored->columns.front()), stored->units.front(),
                 ""};
}

/// A speed in rpm over inner minus outer race.
std::optional<History> speed_column(const Animation& animation, int index, const std::string& id) {
  auto stored = stored_beside(animation, index, {id});
  if (!stored) return std::nullopt;
  History out{stored->time, std::move(stored->columns.front()), "", ""};
  for (double& value : out.value) value *= kRpm;
  std::vector<double> turned;
  for (const double rev : stored->revolutions) turned.push_back(kWholeTurn * rev);
  divide(out.value, slope(turned, stored->time));
  return out;
}

// --- SOL8

template <class Value>
History of_frames(const Animation& animation, std::string unit, Value value) {
  History out{animation.time, {}, std::move(unit), ""};
  for (const auto& frame : animation.file.frames) out.value.push_back(value(frame));
  return out;
}

/// Largest shaft rotation between frames [rev].
double turns_per_frame(const Animation& animation) {
  double most = 0.0;
  const auto& frames = animation.file.frames;
  for (std::size_t i = 1; i < frames.size(); ++i)
    most = std::max(most, std::abs(frames[i].revolutions - frames[i - 1].revolutions));
  return most;
}

/// Speeds from angles of SOL8, unless the body may turn farther between frames than an angle can
/// show. `ratio`: approximate speed relative to the shaft.
History by_differences(const Animation& animation, const std::vector<double>& angle, double ratio) {
  constexpr double kMostTurn = 0.45;  // of half a revolution, minus rounding
  History out{animation.time, std::vector<double>(animation.frames(), kNaN), "", ""};
  if (is_outer_race_rotating(animation)) {
    out.unknown = "Unknown without RESULTS.h5 because the outer race rotates.";
    return out;
  }
  const double turn = ratio * turns_per_frame(animation);
  if (turn > kMostTurn) {
    out.unknown = fmt::format(
        "Unknown: about {} between two SOL8 frames are too many to derive a speed from the angles.",
        counted(fmt::format("{:.2g}", turn), "revolution"));
    return out;
  }
  const double shaft = shaft_speed(animation);
  if (shaft == 0.0) {
    out.unknown = "No relative rotation of the races.";
    return out;
  }
  out.value = rate(angle, animation.time);
  for (double& value : out.value) value /= shaft;
  return out;
}

}  // namespace

SpeedDivisor cage_speed_divisor(const Animation& animation) {
  if (animation.motion && animation.motion->has("cage.speed_ratio")) return SpeedDivisor::Races;
  if (!stored_beside(animation, cage_index(animation), {"cage.speed_ratio"}))
    return SpeedDivisor::Mean;
  return is_outer_race_rotating(animation) ? SpeedDivisor::FasterRace : SpeedDivisor::Races;
}

SpeedDivisor element_speed_divisor(const Animation& animation, std::size_t element) {
  const bool stored = animation.motion || stored_beside(animation, static_cast<int>(element) + 1,
                                                        {"element.orbital_velocity"});
  return stored ? SpeedDivisor::Races : SpeedDivisor::Mean;
}

History land_force(const Animation& animation, std::size_t land, int segment) {
  if (animation.motion && animation.motion->has("land.force")) {
    const auto parts = static_cast<std::size_t>(std::max(animation.segments, 1));
    const std::size_t lands = animation.motion->channel("land.force")->width / parts;
    return with_rest(
        animation,
        of_motion(animation, "land.force", static_cast<std::size_t>(segment) * lands + land),
        [&](const Animation& alone) { return land_force(alone, land, segment); });
  }
  if (auto stored = one_column(animation, cage_index(animation),
                               land == 0 ? "cage.land1_force" : "cage.land2_force"))
    return *stored;
  return of_frames(animation, animation.file.units[2],
                   [land](const auto& f) { return f.land_force[land]; });
}

History pocket_force(const Animation& animation, std::size_t element) {
  const auto n = static_cast<std::size_t>(animation.file.elements);
  if (animation.motion && animation.motion->has("pocket.force")) {
    const results::MotionChannel* all = animation.motion->channel("pocket.force");
    const std::size_t surfaces = std::max<std::size_t>(1, all->width / n);
    History out = of_motion(animation, "pocket.force", element * surfaces);
    for (std::size_t j = 1; j < surfaces; ++j)
      take_larger(out, of_motion(animation, "pocket.force", element * surfaces + j));
    return with_rest(animation, std::move(out),
                     [&](const Animation& alone) { return pocket_force(alone, element); });
  }
  if (auto stored = one_column(animation, cage_index(animation),
                               fmt::format("pocket.force.{}.1", element + 1)))
    return *stored;
  return of_frames(animation, animation.file.units[2],
                   [element](const auto& f) { return f.elements.at(element).pocket_force; });
}

History cage_whirl(const Animation& animation, int segment) {
  if (animation.motion && animation.motion->has("cage.whirl_ratio")) {
    History out = of_motion(animation, "cage.whirl_ratio", static_cast<std::size_t>(segment));
    if (is_outer_race_rotating(animation)) change_divisor(out, animation);
    keep_clear_of_axis(
        out, animation.motion->series("cage.radial_position", static_cast<std::size_t>(segment)),
        animation.guide_clearance);
    return with_rest(animation, std::move(out),
                     if_same_divisor(animation, [&](const Animation& alone) {
                       return cage_whirl(alone, segment);
                     }));
  }
  if (auto stored = stored_beside(animation, cage_index(animation),
                                  {"cage.whirl_ratio", "cage.radial_position"})) {
    History out{std::move(stored->time), std::move(stored->columns[0]), stored->units[0], ""};
    keep_clear_of_axis(out, stored->columns[1], animation.guide_clearance);
    return out;
  }
  std::vector<double> angle, radius;
  for (const auto& frame : animation.file.frames) {
    const auto& p = frame.cage.position;
    angle.push_back(std::atan2(-p[1], p[2]));
    radius.push_back(std::hypot(p[1], p[2]));
  }
  constexpr double kFastest = 1.0;  // a cage that whirls with the shaft
  History out = by_differences(animation, continuous(std::move(angle)), kFastest);
  keep_clear_of_axis(out, radius, animation.guide_clearance);
  return out;
}

History cage_speed(const Animation& animation, int segment) {
  const auto part = static_cast<std::size_t>(segment);
  const auto rest = if_same_divisor(
      animation, [segment](const Animation& alone) { return cage_speed(alone, segment); });
  if (animation.motion && is_outer_race_rotating(animation) &&
      animation.motion->has("cage.angular_velocity")) {
    // The ratio in the file is a magnitude; its sign matters if both races rotate.
    History out = of_motion(animation, "cage.angular_velocity", 3 * part);
    for (double& value : out.value) value *= kRpm;
    divide(out.value, divisor_of_motion(animation));
    out.unit.clear();
    return with_rest(animation, std::move(out), rest);
  }
  if (animation.motion && animation.motion->has("cage.speed_ratio"))
    return with_rest(animation, of_motion(animation, "cage.speed_ratio", part), rest);
  if (auto stored = one_column(animation, cage_index(animation), "cage.speed_ratio"))
    return *stored;
  return by_differences(animation, animation.cage_angle, 0.6);
}

History element_orbit_speed(const Animation& animation, std::size_t element) {
  if (animation.motion) {
    History out = of_motion(animation, "element.orbital_velocity", element);
    for (double& value : out.value) value *= kRpm;
    divide(out.value, divisor_of_motion(animation));
    out.unit.clear();
    return with_rest(animation, std::move(out),
                     [&](const Animation& alone) { return element_orbit_speed(alone, element); });
  }
  if (auto stored =
          speed_column(animation, static_cast<int>(element) + 1, "element.orbital_velocity"))
    return *stored;
  std::vector<double> angle;
  for (const auto& frame : animation.file.frames) angle.push_back(frame.elements.at(element).theta);
  return by_differences(animation, continuous(std::move(angle)), 0.6);
}

History element_spin(const Animation& animation, std::size_t element) {
  const auto size = [](History out) {
    for (double& value : out.value) value = std::abs(value);
    return out;
  };
  if (animation.motion) {
    History out = of_motion(animation, "element.angular_velocity", element);
    for (double& value : out.value) value *= kRpm;
    divide(out.value, divisor_of_motion(animation));
    out.unit.clear();
    return with_rest(animation, size(std::move(out)),
                     [&](const Animation& alone) { return element_spin(alone, element); });
  }
  if (auto stored =
          speed_column(animation, static_cast<int>(element) + 1, "element.angular_velocity"))
    return size(std::move(*stored));
  const std::size_t n = animation.frames();
  std::vector<double> turned(n, 0.0);
  for (std::size_t i = 1; i < n; ++i) {
    const Mat3 a = rotation(animation.frame(i - 1).elements.at(element).angles);
    const Mat3 b = rotation(animation.frame(i).elements.at(element).angles);
    // Angle of the rotation from one frame to the next: trace(A^T B) = 1 + 2 cos(angle).
    const double trace = a.cwiseProduct(b).sum();
    turned[i] = turned[i - 1] + std::acos(std::clamp(0.5 * (trace - 1.0), -1.0, 1.0));
  }
  // Rolling without slip, at contact angle 0: (dm/D)(1 - (D/dm)^2)/2.
  const auto& g = animation.file.geometry;
  const double slender = g.pitch_diameter / (2.0 * g.element_radius);
  return size(by_differences(animation, turned, 0.5 * slender * (1.0 - 1.0 / (slender * slender))));
}

History race_position(const Animation& animation, std::size_t race, std::size_t coordinate) {
  const std::string axis(1, "xyz"[coordinate]);
  if (animation.motion)
    return with_rest(
        animation, of_motion(animation, "race." + axis, race),
        [&](const Animation& alone) { return race_position(alone, race, coordinate); });
  if (auto stored = one_column(animation, race_index(animation, race), "race." + axis))
    return *stored;
  return of_frames(animation, animation.file.units[0], [race, coordinate](const auto& f) {
    return f.races[race].position[coordinate];
  });
}

History contact_load(const Animation& animation, std::size_t element, std::size_t race,
                     const std::string& channel) {
  if (!animation.motion || !animation.motion->has(channel))
    return {{}, {}, "", "Contact loads need RESULTS.h5 in the same folder."};
  return with_rest(animation, of_motion(animation, channel, 2 * element + race), {});
}

History flange_history(const Animation& animation, const std::string& what, std::size_t element,
                       std::size_t race, std::size_t side) {
  if (!animation.motion || !animation.motion->has("flange." + what))
    return {{}, {}, "", "Flange contacts need RESULTS.h5 in the same folder."};
  History out = of_motion(animation, "flange." + what, 4 * element + 2 * race + side);
  // A gap of exactly 0: the roller's end is nowhere near.
  if (what == "gap")
    for (double& value : out.value)
      if (value == 0.0) value = kNaN;
  return with_rest(animation, std::move(out), {});
}

bool has_flange(const Animation& animation, std::size_t race, std::size_t side) {
  return animation.motion && animation.motion->geometry().contains(
                                 fmt::format("{}_flange_{}_height", race == 0 ? "outer" : "inner",
                                             side == 0 ? "minus_x" : "plus_x"));
}

}  // namespace adore::agore
