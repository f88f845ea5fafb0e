#include "agore/animation.hpp"

#include "base/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>

namespace adore::agore {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// First number with a point in a text: "ADORE 0.1" -> 0, 1. False when there is none.
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

/// Mean over the frames around each one; exact for steady turning, and rid of most of the rounding
/// to three digits.
std::vector<double> averaged(const std::vector<double>& values) {
  constexpr std::size_t kReach = 2;
  std::vector<double> out(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t reach = std::min({kReach, i, values.size() - 1 - i});
    double sum = 0.0;
    for (std::size_t j = i - reach; j <= i + reach; ++j) sum += values[j];
    out[i] = sum / static_cast<double>(2 * reach + 1);
  }
  return out;
}

template <class Angle>
std::vector<double> angle_history(const results::Sol8File& file, Angle angle) {
  std::vector<double> values;
  values.reserve(file.frames.size());
  for (const auto& frame : file.frames) values.push_back(angle(frame));
  return averaged(continuous(std::move(values)));
}

/// Where each pocket sits in the cage: mean direction over the file, because single frames are
/// coarse.
std::vector<double> find_pockets(const Animation& animation) {
  const double pitch_radius = 0.5 * animation.file.geometry.pitch_diameter;
  std::vector<double> angles;
  for (std::size_t k = 0; k < static_cast<std::size_t>(animation.file.elements); ++k) {
    double sine = 0.0, cosine = 0.0;
    for (std::size_t i = 0; i < animation.frames(); ++i) {
      const auto& element = animation.frame(i).elements[k];
      // The pocket's y axis points against the azimuth.
      const double angle =
          element.theta + element.pocket_vector[1] / pitch_radius - animation.cage_angle[i];
      sine += std::sin(angle);
      cosine += std::cos(angle);
    }
    angles.push_back(std::atan2(sine, cosine));
  }
  return angles;
}

void find_guide(Animation& animation) {
  const auto& g = animation.file.geometry;
  const bool outer = g.cage_outer_clearance > 0.0, inner = g.cage_inner_clearance > 0.0;
  // The file does not say where the lands are; the narrower gap is the one that guides.
  if (inner && (!outer || g.cage_inner_clearance <= g.cage_outer_clearance))
    animation.guide = Guide::Inner;
  else if (outer)
    animation.guide = Guide::Outer;
  animation.guide_clearance = animation.guide == Guide::Inner   ? g.cage_inner_clearance
                              : animation.guide == Guide::Outer ? g.cage_outer_clearance
                                                                : 0.0;
}

std::vector<double> over_shaft(std::vector<double> speeds, const Animation& animation) {
  const double shaft = shaft_speed(animation);
  for (double& s : speeds) s = shaft == 0.0 ? kNone : s / shaft;
  return speeds;
}

}  // namespace

void check_version(const std::string& version, const std::string& file) {
  int major = 0, minor = 0, lowest_major = 0, lowest_minor = 0;
  find_version(kLowestVersion, lowest_major, lowest_minor);
  if (!find_version(version, major, minor))
    throw InputError(
        fmt::format("{} does not name the program version that wrote it (found '{}'); versions "
                    "from {} are accepted",
                    file, version, kLowestVersion));
  if (major < lowest_major || (major == lowest_major && minor < lowest_minor))
    throw InputError(fmt::format(
        "{} was written by version '{}'; versions from {} are accepted, so run the deck again",
        file, version, kLowestVersion));
}

Animation prepare(results::Sol8File file) {
  const std::string name = file.path.string();
  check_version(file.version, name);
  if (file.frames.empty())
    throw InputError(name + " holds no complete frame" +
                     (file.note.empty() ? "" : " (" + file.note + ")") +
                     "; let the run store at least one (kAGraf)");
  for (const auto& frame : file.frames)
    if (static_cast<int>(frame.elements.size()) != file.elements)
      throw InputError(fmt::format(
          "{}: step {} holds {} rolling elements, its header says {}; the file is damaged", name,
          frame.step, frame.elements.size(), file.elements));
  Animation animation;
  animation.file = std::move(file);
  const auto& data = animation.file;
  if (!(data.geometry.pitch_diameter > 0.0) || !(data.geometry.element_radius > 0.0))
    throw InputError(name +
                     " gives no pitch diameter or rolling element size, so there is nothing to "
                     "draw; the file is damaged");
  for (const auto& frame : data.frames) animation.time.push_back(frame.time);
  animation.has_cage = data.geometry.cage_outer_radius > data.geometry.cage_inner_radius;
  animation.cage_angle = angle_history(data, [](const auto& f) { return f.cage.angles[0]; });
  for (std::size_t r = 0; r < 2; ++r)
    animation.race_angle[r] =
        angle_history(data, [r](const auto& f) { return f.races[r].angles[0]; });
  animation.pocket_angle = find_pockets(animation);
  if (animation.has_cage) find_guide(animation);
  animation.contacts = results::contacts_beside(animation.file, animation.no_contacts);
  return animation;
}

std::vector<double> continuous(std::vector<double> angle) {
  for (std::size_t i = 1; i < angle.size(); ++i)
    angle[i] = angle[i - 1] + std::remainder(angle[i] - angle[i - 1], kTurn);
  return angle;
}

std::vector<double> rate(const std::vector<double>& angle, const std::vector<double>& time) {
  const std::size_t n = std::min(angle.size(), time.size());
  std::vector<double> out(n, kNone);
  if (n < 3) return out;
  constexpr double kSpan = 1.0;  // [rad]; the file's rounding of 0.005 rad is then 1 % at most
  const double per_frame = std::abs(angle[n - 1] - angle[0]) / static_cast<double>(n - 1);
  const std::size_t widest = std::max<std::size_t>(1, (n - 1) / 20);
  const std::size_t wanted =
      per_frame > 0.0 ? static_cast<std::size_t>(std::min(1e6, std::ceil(0.5 * kSpan / per_frame)))
                      : widest;
  const std::size_t reach = std::clamp<std::size_t>(wanted, 1, widest);
  for (std::size_t i = 0; i < n; ++i) {
    // At the ends the window stays as wide and moves inwards: half a window would double the
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

std::vector<double> cage_whirl_ratio(const Animation& animation) {
  std::vector<double> angle;
  double largest = 0.0;
  for (const auto& frame : animation.file.frames) {
    const auto& p = frame.cage.position;
    angle.push_back(std::atan2(-p[1], p[2]));
    largest = std::max(largest, std::hypot(p[1], p[2]));
  }
  auto ratio = over_shaft(rate(averaged(continuous(std::move(angle))), animation.time), animation);
  for (std::size_t i = 0; i < ratio.size(); ++i) {
    const auto& p = animation.frame(i).cage.position;
    // Near the middle the direction of the centre means nothing.
    if (std::hypot(p[1], p[2]) <= 1e-3 * largest) ratio[i] = kNone;
  }
  return ratio;
}

std::vector<double> cage_speed_ratio(const Animation& animation) {
  return over_shaft(rate(animation.cage_angle, animation.time), animation);
}

std::vector<double> element_orbit_ratio(const Animation& animation, std::size_t element) {
  const auto angle = angle_history(
      animation.file, [element](const auto& f) { return f.elements.at(element).theta; });
  return over_shaft(rate(angle, animation.time), animation);
}

std::vector<double> element_spin_ratio(const Animation& animation, std::size_t element) {
  const std::size_t n = animation.frames();
  std::vector<double> turned(n, 0.0);
  for (std::size_t i = 1; i < n; ++i) {
    const Mat3 a = rotation(animation.frame(i - 1).elements.at(element).angles);
    const Mat3 b = rotation(animation.frame(i).elements.at(element).angles);
    // Angle of the rotation from one frame to the next: trace(A^T B) = 1 + 2 cos(angle).
    const double trace = a.cwiseProduct(b).sum();
    turned[i] = turned[i - 1] + std::acos(std::clamp(0.5 * (trace - 1.0), -1.0, 1.0));
  }
  auto ratio = over_shaft(rate(turned, animation.time), animation);
  for (double& r : ratio) r = std::abs(r);
  return ratio;
}

Mat3 rotation(const std::array<double, 3>& angles) {
  return passive_matrix({angles[0], angles[1], angles[2]}).transpose();
}

}  // namespace adore::agore
