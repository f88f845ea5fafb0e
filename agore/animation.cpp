#include "agore/animation.hpp"

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "results/run_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace adore::agore {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

/// First number with a point in a text: "ADORE 0.1" -> 0, 1. False without one.
bool find_version(const std::string& text, int& major, int& minor) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] < '0' || text[i] > '9') continue;
    const char* end = text.data() + text.size();
    const auto first = std::from_chars(text.data() + i, end, major);
    if (first.ec != std::errc()) return false;
    minor = 0;
    if (first.ptr != end && *first.ptr == '.') std::from_chars(first.ptr + 1, end, minor);
    return true;
  }
  return false;
}

template <class Angle>
std::vector<double> angle_history(const results::Sol8File& file, Angle angle) {
  std::vector<double> values;
  values.reserve(file.frames.size());
  for (const auto& frame : file.frames) values.push_back(angle(frame));
  return continuous(std::move(values));
}

/// Position of each pocket in the cage: mean direction over the file, because single frames are
/// coarse.
std::vector<double> find_pockets(const Animation& animation) {
  const double pitch_radius = 0.5 * animation.file.geometry.pitch_diameter;
  std::vector<double> angles;
  for (std::size_t k = 0; k < static_cast<std::size_t>(animation.file.elements); ++k) {
    double sine = 0.0, cosine = 0.0;
    const std::size_t looks = animation.motion ? animation.exact : animation.frames();
    for (std::size_t i = 0; i < looks; ++i) {
      const auto& element = animation.frame(i).elements[k];
      // Seen from the cage's center, which may be far from the axis.
      const auto& centre = animation.part(i, animation.pocket_part[k]).position;
      const double y = -element.r * std::sin(element.theta) - centre[1],
                   z = element.r * std::cos(element.theta) - centre[2];
      // The pocket's y axis points against the azimuth.
      const double angle = std::atan2(-y, z) + element.pocket_vector[1] / pitch_radius -
                           animation.cage_part_angle(i, animation.pocket_part[k]);
      sine += std::sin(angle);
      cosine += std::cos(angle);
    }
    angles.push_back(std::atan2(sine, cosine));
  }
  return angles;
}

/// Dimensions of RESULTS.h5 in the unit of the file; 0 if missing.
double size_of(const Animation& animation, const std::string& name) {
  if (!animation.motion) return 0.0;
  const auto& geometry = animation.motion->geometry();
  const auto found = geometry.find(name);
  if (found == geometry.end() || !std::isfinite(found->second)) return 0.0;
  const bool english = animation.file.units[0] == "in";
  return found->second / (english ? 0.0254 : 1.0);
}

/// Existing lands and the race that guides the cage, from RESULTS.h5. For SOL8 they are estimated:
/// a land with force and angle 0 in all frames does not exist; contacts are in the direction of the
/// cage displacement (outer race) or opposite (inner race). Without contacts the land with the
/// smaller gap is assumed to guide.
void find_guide(Animation& animation) {
  const auto& g = animation.file.geometry;
  if (animation.motion && animation.motion->geometry().contains("lands")) {
    const auto lands = static_cast<int>(animation.motion->geometry().at("lands"));
    for (int i = 0; i < std::min(lands, 2); ++i) {
      const std::string name = fmt::format("land{}_", i + 1);
      animation.land[static_cast<std::size_t>(i)] = true;
      const auto guide = animation.motion->geometry().find(name + "guide");
      if (animation.guide != Guide::None || guide == animation.motion->geometry().end()) continue;
      animation.guide = guide->second == 1.0   ? Guide::Outer
                        : guide->second == 2.0 ? Guide::Inner
                                               : Guide::None;
      animation.guide_clearance = size_of(animation, name + "clearance");
    }
    return;
  }
  double votes = 0.0;
  for (std::size_t i = 0; i < animation.frames(); ++i) {
    const auto& frame = animation.frame(i);
    for (std::size_t land = 0; land < 2; ++land) {
      if (frame.land_force[land] == 0.0 && frame.land_angle[land] == 0.0) continue;
      animation.land[land] = true;
      if (!(frame.land_force[land] > 0.0)) continue;
      const auto& p = frame.cage.position;
      votes += std::cos(animation.cage_angle[i] + frame.land_angle[land] - std::atan2(-p[1], p[2]));
    }
  }
  if (!animation.land[0] && !animation.land[1]) return;
  const bool outer = g.cage_outer_clearance > 0.0, inner = g.cage_inner_clearance > 0.0;
  if (votes != 0.0)
    animation.guide = votes > 0.0 ? Guide::Outer : Guide::Inner;
  else if (inner && (!outer || g.cage_inner_clearance <= g.cage_outer_clearance))
    animation.guide = Guide::Inner;
  else if (outer)
    animation.guide = Guide::Outer;
  animation.guide_clearance = animation.guide == Guide::Inner   ? g.cage_inner_clearance
                              : animation.guide == Guide::Outer ? g.cage_outer_clearance
                                                                : 0.0;
}

/// Which segment each pocket belongs to: equal shares in element order.
void find_parts(Animation& animation) {
  const int n = animation.file.elements;
  animation.pocket_part.assign(static_cast<std::size_t>(n), 0);
  animation.segments = animation.has_cage ? 1 : 0;
  if (!animation.motion || animation.motion->segment_frames().empty()) return;
  const int parts = static_cast<int>(animation.motion->segment_frames().front().size());
  animation.segments = parts;
  // The first pocket of the first segment is not always that of element 1. The z axis of a segment
  // is at its angular middle, so its pockets are those nearest to it.
  const int per = std::max(1, n / parts);
  const double pitch_radius = 0.5 * animation.file.geometry.pitch_diameter;
  constexpr std::size_t kLooks = 40;
  const std::size_t every = std::max<std::size_t>(1, animation.frames() / kLooks);
  double best = std::numeric_limits<double>::infinity();
  for (int first = 0; first < n; ++first) {
    double off = 0.0;
    std::vector<int> part;
    for (int k = 0; k < n; ++k) {
      part.push_back(std::min((k - first + n) % n / per, parts - 1));
      double cosine = 0.0, looks = 0.0;
      for (std::size_t i = 0; i < animation.frames(); i += every) {
        const auto& element = animation.frame(i).elements[static_cast<std::size_t>(k)];
        const double angle = element.theta + element.pocket_vector[1] / pitch_radius -
                             animation.part(i, part.back()).angles[0];
        cosine += std::cos(angle), ++looks;
      }
      off += 1.0 - cosine / looks;
    }
    if (off < best) {
      best = off;
      animation.pocket_part = part;
    }
  }
}

/// Contacts of all elements at the frames.
std::optional<ContactFrames> contacts_of(const Animation& animation) {
  const auto* load = animation.motion->channel("contact.load");
  const auto* slip = animation.motion->channel("contact.slip");
  const auto n = static_cast<std::size_t>(animation.file.elements);
  if (load == nullptr || slip == nullptr || load->width != 2 * n || slip->width != 2 * n)
    return std::nullopt;
  ContactFrames out;
  out.load_unit = load->unit;
  out.slip_unit = slip->unit;
  for (std::size_t i = 0; i < animation.exact; ++i) {
    std::vector<ContactFrame>& contacts = out.frames.emplace_back(n);
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t j = 0; j < 2; ++j) {
        contacts[k].load[j] = load->at(i, 2 * k + j);
        contacts[k].slip[j] = slip->at(i, 2 * k + j);
        out.largest_load = std::max(out.largest_load, contacts[k].load[j]);
        out.largest_of_race[j] = std::max(out.largest_of_race[j], contacts[k].load[j]);
      }
  }
  return out;
}

/// Frames of SOL8 after the end of RESULTS.h5, of which only every second, third ... stored step
/// may be a frame; times of SOL8 are rounded.
std::vector<results::Sol8Frame> frames_behind(const results::MotionFile& motion,
                                              const std::vector<results::Sol8Frame>& frames) {
  constexpr double kRounding = 1e-6;
  std::vector<results::Sol8Frame> out;
  if (!motion.segment_frames().empty()) return out;  // for which SOL8 has no room
  const double end = motion.times().back();
  for (const results::Sol8Frame& frame : frames)
    if (frame.step > motion.frames().frames.back().step &&
        (motion.every() == 1 || frame.time - end > kRounding * std::abs(end)))
      out.push_back(frame);
  return out;
}

/// Rotation of the races between neighboring frames: relative rotation, and rotation from their
/// angles, which is known only modulo one revolution.
std::vector<double> turns_of(const results::Sol8File& file) {
  std::vector<double> out(file.frames.size(), 0.0);
  for (std::size_t i = 1; i < file.frames.size(); ++i) {
    const results::Sol8Frame &from = file.frames[i - 1], &to = file.frames[i];
    out[i] = std::abs(to.revolutions - from.revolutions);
    for (std::size_t r = 0; r < 2; ++r)
      out[i] = std::max(
          out[i],
          std::abs(std::remainder(to.races[r].angles[0] - from.races[r].angles[0], kTurn)) / kTurn);
  }
  return out;
}

/// Is there a file SOL1 to SOL6 of the same run next to SOL8?
bool curves_beside(const Animation& animation) {
  for (const std::filesystem::path& path :
       results::run_folder(animation.file.path.parent_path()).plots) {
    try {
      const results::SolFile head = results::read_sol(path, results::SolRange{1, 1, 1});
      if (head.kind != results::SolKind::Power && head.header.run_id == animation.file.run_id)
        return true;
    } catch (const std::exception&) {
      continue;  // another file may be good
    }
  }
  return false;
}

Known known_of(std::size_t frames, const std::function<bool(std::size_t)>& known) {
  std::size_t count = 0;
  for (std::size_t i = 1; i < frames; ++i) count += known(i) ? 1 : 0;
  // A last step shorter than all others does not interrupt the path.
  return count + 1 >= frames ? Known::All : 10 * count > frames ? Known::Some : Known::None;
}

void check_frames(const results::Sol8File& file, const std::string& name) {
  if (file.frames.empty())
    throw InputError(name + " contains no complete frame" +
                     (file.note.empty() ? "" : " (" + file.note + ")") +
                     "; set kAGraf, so that the run stores frames, and run the deck again");
  for (const auto& frame : file.frames)
    if (static_cast<int>(frame.elements.size()) != file.elements)
      throw InputError(fmt::format(
          "{}: step {} has {} rolling elements, but the header states {}; the file is damaged",
          name, frame.step, frame.elements.size(), file.elements));
  if (!(file.geometry.pitch_diameter > 0.0) || !(file.geometry.element_radius > 0.0))
    throw InputError(name + " has no pitch diameter or rolling element size; the file is damaged");
}

/// RESULTS.h5 of an earlier program that omits steps of the run: forces of its curves have no
/// extremes. (Quantities without extremes, such as a speed, do not jump between steps.)
bool peaks_unknown(const results::MotionFile& motion) {
  const auto& frames = motion.frames().frames;
  const std::size_t stored = motion.every() * (std::max<std::size_t>(frames.size(), 1) - 1);
  constexpr double kLeastApart = 1.5;  // on average: the last step is always stored
  if (stored == 0 || static_cast<double>(frames.back().step - frames.front().step) <
                         kLeastApart * static_cast<double>(stored))
    return false;
  constexpr std::array kForces{"contact.load", "pocket.force", "land.force", "flange.force"};
  return std::any_of(kForces.begin(), kForces.end(), [&](const std::string& id) {
    return motion.has(id) && !motion.has(id + "_high");
  });
}

Animation finish(Animation animation) {
  const auto& data = animation.file;
  for (const auto& frame : data.frames) animation.time.push_back(frame.time);
  animation.turned = turns_of(data);
  const std::size_t count = data.frames.size();
  animation.known_centres = known_of(count, [&](auto i) { return animation.is_path_known(i); });
  for (const bool past : {false, true})
    (past ? animation.known_trails : animation.known_elements) =
        known_of(count, [&](auto i) { return animation.is_path_known(i, 0, past); });
  animation.has_cage = data.geometry.cage_outer_radius > data.geometry.cage_inner_radius;
  animation.cage_angle = angle_history(data, [](const auto& f) { return f.cage.angles[0]; });
  for (std::size_t r = 0; r < 2; ++r)
    animation.race_angle[r] =
        angle_history(data, [r](const auto& f) { return f.races[r].angles[0]; });
  find_parts(animation);
  animation.pocket_angle = find_pockets(animation);
  if (animation.has_cage) find_guide(animation);
  if (animation.motion) {
    animation.contacts = contacts_of(animation);
    for (const char* name : {"contact.load", "contact.slip", "contact.heat", "contact.temperature",
                             "contact.pressure"})
      if (const auto* channel = animation.motion->channel(name))
        animation.run_ranges[name] = run_range(*channel);
    if (const auto* load = animation.motion->channel("contact.load"))
      animation.some_free = loses_contact(*load);
    animation.source =
        animation.motion->every() > 1
            ? fmt::format("one in {} of the {} stored steps (RESULTS.h5)",
                          animation.motion->every(), animation.motion->stored_steps())
            : "all stored steps, full precision (RESULTS.h5)";
    if (peaks_unknown(*animation.motion))
      animation.source += "; peaks between stored steps are missing";
    if (const std::string behind = animation.sol8_only_note(); !behind.empty())
      animation.source += "; " + behind;
  } else {
    animation.source = curves_beside(animation)
                           ? "SOL8: three-digit values of stored frames; curves from SOL files"
                           : "SOL8 only: three-digit values of stored frames";
    if (!animation.unused.empty()) animation.source += "; RESULTS.h5 is not used";
  }
  if (!animation.file.gaps.empty()) animation.source += "; " + animation.file.gaps;
  return animation;
}

}  // namespace

void check_version(const std::string& version, const std::string& file) {
  int major = 0, minor = 0, lowest_major = 0, lowest_minor = 0;
  find_version(kLowestVersion, lowest_major, lowest_minor);
  if (!find_version(version, major, minor))
    throw InputError(
        fmt::format("{} has no valid program version (found '{}'). Versions from {} are accepted",
                    file, version, kLowestVersion));
  if (major < lowest_major || (major == lowest_major && minor < lowest_minor))
    throw InputError(
        fmt::format("{} was written by version '{}', but only versions from {} are accepted. Run "
                    "the deck again",
                    file, version, kLowestVersion));
}

Animation prepare(results::Sol8File file, long most_frames) {
  const std::string name = file.path.string();
  check_version(file.version, name);
  check_frames(file, name);
  Animation animation;
  std::string why_not;
  const auto most = static_cast<std::size_t>(
      std::clamp<long>(most_frames, 1, static_cast<long>(results::MotionFile::kMostFrames)));
  if (auto motion = results::MotionFile::of_sol8(file, why_not, most)) {
    animation.motion = std::make_shared<const results::MotionFile>(std::move(*motion));
    animation.file = animation.motion->frames();
    check_frames(animation.file, name);
    animation.exact = animation.file.frames.size();
    const std::vector<results::Sol8Frame> more = frames_behind(*animation.motion, file.frames);
    if (!more.empty()) {
      animation.file.frames.insert(animation.file.frames.end(), more.begin(), more.end());
      Animation alone;
      alone.file = std::move(file);
      animation.alone = std::make_shared<const Animation>(finish(std::move(alone)));
    }
    return finish(std::move(animation));
  }
  animation.file = std::move(file);
  animation.no_contacts = why_not;
  std::error_code ignored;
  if (std::filesystem::exists(animation.file.path.parent_path() / "RESULTS.h5", ignored))
    animation.unused = why_not;
  return finish(std::move(animation));
}

Animation prepare(results::MotionFile motion) {
  Animation animation;
  animation.motion = std::make_shared<const results::MotionFile>(std::move(motion));
  animation.file = animation.motion->frames();
  check_frames(animation.file, animation.file.path.string());
  animation.exact = animation.file.frames.size();
  return finish(std::move(animation));
}

Animation open_motion(const std::filesystem::path& named, long most_frames) {
  const std::filesystem::path path = results::animation_file(named);
  if (path.extension() != ".h5") {
    // The whole run, as from RESULTS.h5.
    const long stored = results::stored_steps(path), most = std::max(most_frames, 1L);
    const long every = std::max(1L, stored / most + (stored % most > 0 ? 1 : 0));
    results::SolRange range;
    range.every = every;
    Animation out = prepare(results::read_sol8(path, range), most_frames);
    if (every > 1 && !out.motion)
      out.source += fmt::format("; one in {} of the {} stored frames", every, stored);
    return out;
  }
  return prepare(results::MotionFile::open(
      path, results::UnitSystem::SI,
      static_cast<std::size_t>(
          std::clamp<long>(most_frames, 1, static_cast<long>(results::MotionFile::kMostFrames)))));
}

RunRange run_range(const results::MotionChannel& channel) {
  constexpr std::size_t kMost = 400'000;  // values looked at for the usual ones
  RunRange out;
  out.lowest = std::numeric_limits<double>::infinity();
  std::vector<double> above;
  const std::size_t pairs = channel.values.size() / 2, every = pairs / kMost + 1;
  for (std::size_t i = 0; i < pairs; ++i) {
    const double value = std::max(channel.values[2 * i], channel.values[2 * i + 1]);
    if (!std::isfinite(value)) continue;
    out.largest = std::max(out.largest, value);
    out.lowest = std::min(out.lowest, value);
    if (value > 0.0 && i % every == 0) above.push_back(value);
  }
  if (!std::isfinite(out.lowest)) out.lowest = 0.0;
  out.usual = out.largest;
  if (above.empty()) return out;
  const auto at = above.begin() + static_cast<std::ptrdiff_t>((above.size() - 1) * 19 / 20);
  std::nth_element(above.begin(), at, above.end());
  out.usual = *at;
  return out;
}

bool loses_contact(const results::MotionChannel& load) {
  for (std::size_t i = 0; i + 1 < load.values.size(); i += 2)
    if (load.values[i] == 0.0 && load.values[i + 1] == 0.0) return true;
  return false;
}

std::vector<std::string> Animation::notes() const {
  std::vector<std::string> out;
  for (const std::string& note : {file.note, file.gaps})
    if (!note.empty()) out.push_back(note);
  if (!unused.empty()) out.push_back("RESULTS.h5 is not used: " + unused);
  return out;
}

const results::Sol8Body& Animation::part(std::size_t i, int segment) const {
  return segments > 1 ? motion->segment_frames().at(i).at(static_cast<std::size_t>(segment))
                      : file.frames.at(i).cage;
}

const results::Sol8Body& Animation::cage_part_of(std::size_t i, std::size_t element) const {
  return part(i, pocket_part.at(element));
}

double Animation::cage_part_angle(std::size_t i, int segment) const {
  return segments > 1 ? part(i, segment).angles[0] : cage_angle.at(i);
}

GuideLandContact Animation::land_contact(std::size_t i, int segment, std::size_t which) const {
  if (segments <= 1) return {frame(i).land_force.at(which), frame(i).land_angle.at(which)};
  const results::MotionChannel* force = motion->channel("land.force");
  if (force == nullptr) return {};
  const std::size_t lands = force->width / static_cast<std::size_t>(segments);
  if (which >= lands) return {};
  const std::size_t place = static_cast<std::size_t>(segment) * lands + which;
  return {force->at(i, place), value("land.angle", i, place)};
}

std::string Animation::sol8_only_note() const {
  return behind(frames() - 1) ? fmt::format("frames from {} on are only in SOL8", exact + 1)
                              : std::string();
}

const std::vector<ContactFrame>* Animation::contacts_at(std::size_t i) const {
  return contacts && i < contacts->frames.size() ? &contacts->frames[i] : nullptr;
}

std::string Animation::missing_loads_reason(std::size_t i) const {
  return behind(i) ? sol8_only_note() : no_contacts;
}

bool Animation::is_path_known(std::size_t i) const { return i > 0 && turned.at(i) <= kKnownTurn; }

bool Animation::is_path_known(std::size_t i, std::size_t element, bool past_others) const {
  // For larger angles the difference of two angles may lack a revolution.
  constexpr double kSure = 0.25;
  if (i == 0 || turned.at(i) > kSure) return false;
  const double half_pitch = 0.5 / std::max(1, file.elements);
  const double most = past_others ? std::min(half_pitch, kKnownTurn) : kKnownTurn;
  const double step =
      file.frames[i].elements.at(element).theta - file.frames[i - 1].elements.at(element).theta;
  return std::abs(std::remainder(step, kTurn)) <= most * kTurn;
}

std::string Animation::segment_remark(int segment) const {
  return segments > 1 ? fmt::format(", segment {} of {}", segment + 1, segments) : std::string();
}

double Animation::value(const std::string& channel, std::size_t i, std::size_t place) const {
  const results::MotionChannel* found = motion ? motion->channel(channel) : nullptr;
  return found != nullptr && place < found->width && i < exact ? found->at(i, place) : kNaN;
}

std::vector<double> continuous(std::vector<double> angle) {
  for (std::size_t i = 1; i < angle.size(); ++i)
    angle[i] = angle[i - 1] + std::remainder(angle[i] - angle[i - 1], kTurn);
  return angle;
}

std::vector<double> rate(const std::vector<double>& angle, const std::vector<double>& time) {
  const std::size_t n = std::min(angle.size(), time.size());
  std::vector<double> out(n, kNaN);
  if (n < 3) return out;
  constexpr double kSpan = 1.0;  // [rad]; the file's rounding of 0.005 rad is then 1 % at most
  const double per_frame = std::abs(angle[n - 1] - angle[0]) / static_cast<double>(n - 1);
  const std::size_t widest = std::max<std::size_t>(1, (n - 1) / 20);
  const std::size_t wanted =
      per_frame > 0.0 ? static_cast<std::size_t>(std::min(1e6, std::ceil(0.5 * kSpan / per_frame)))
                      : widest;
  const std::size_t reach = std::clamp<std::size_t>(wanted, 1, widest);
  for (std::size_t i = 0; i < n; ++i) {
    // At the ends the window stays as wide and moves inward: half a window would double the
    // rounding.
    const std::size_t low = std::min(i > reach ? i - reach : 0, n - 1 - 2 * reach);
    const std::size_t high = low + 2 * reach;
    const double span = time[high] - time[low];
    if (span > 0.0) out[i] = (angle[high] - angle[low]) / span;
  }
  return out;
}

double shaft_speed(const Animation& animation) {
  const auto& first = animation.file.frames.front();
  const auto& last = animation.file.frames.back();
  return last.time > first.time
             ? kTurn * (last.revolutions - first.revolutions) / (last.time - first.time)
             : 0.0;
}

Mat3 rotation(const std::array<double, 3>& angles) {
  return passive_matrix({angles[0], angles[1], angles[2]}).transpose();
}

}  // namespace adore::agore
