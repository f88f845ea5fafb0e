#include "adrinput/run_motion_values.hpp"

#include "base/counted.hpp"
#include "base/errors.hpp"
#include "desktop/axis_scale.hpp"
#include "desktop/chart_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace adore::adrinput {
namespace {

constexpr std::array kRaces{"outer race", "inner race"};
constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr double kRpm = 30.0 / std::numbers::pi;  // of rad/s
constexpr int kDigits = 4;

std::string speed(double rad_per_s) {
  return desktop::pretty_number(rad_per_s * kRpm, kDigits) + " rpm";
}

/// Index of the largest finite value; nothing: there is none.
std::optional<std::size_t> largest(const std::vector<double>& values) {
  std::optional<std::size_t> out;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::isfinite(values[i]) && (!out || values[i] > values[*out])) out = i;
  return out;
}

std::string joined(const std::vector<std::string>& parts, const char* between) {
  std::string out;
  for (const std::string& part : parts) out += (out.empty() ? "" : between) + part;
  return out;
}

}  // namespace

RunMotionValues::RunMotionValues(const std::filesystem::path& results_h5)
    : reader_(results_h5), times_(reader_.read("time")), turns_(reader_.read("shaft_rotation")) {
  if (times_.empty())
    throw InputError(results_h5.string() + ": the file contains no complete step yet");
  if (!std::is_sorted(times_.begin(), times_.end()) ||
      !std::all_of(times_.begin(), times_.end(), [](double t) { return std::isfinite(t); }))
    throw InputError(results_h5.string() + ": the times of the stored steps do not increase");
  numbers_ = reader_.step_numbers();
  if (const auto* load = reader_.find("contact.load"); load && load->dimensions.size() == 2)
    elements_ = static_cast<int>(load->dimensions.front());
}

std::size_t RunMotionValues::step_at(double time) const {
  return desktop::nearest_index(times_, time);
}

std::string RunMotionValues::position(std::size_t step) const {
  const long number = step < numbers_.size() ? numbers_[step] : static_cast<long>(step);
  const std::string turns =
      desktop::pretty_number(std::abs(turns_.at(step)) / (2.0 * std::numbers::pi), kDigits);
  return fmt::format("Step {} ({}, {}).", number, desktop::pretty_quantity(times_.at(step), "s", 5),
                     counted(turns, "revolution"));
}

/// Empty: the run does not have this channel.
std::vector<double> RunMotionValues::values(const char* channel, std::size_t step) const {
  return reader_.find(channel) ? reader_.read(channel, step, 1) : std::vector<double>();
}

std::string RunMotionValues::describe_element(std::size_t step, int element) const {
  if (element < 1 || element > elements_) return {};
  const auto load = values("contact.load", step), pressure = values("contact.pressure", step),
             angle = values("contact.angle", step);
  std::string out;
  for (std::size_t race = 0; race < kRaces.size(); ++race) {
    const std::size_t at = 2 * static_cast<std::size_t>(element - 1) + race;
    if (at >= load.size() || !std::isfinite(load[at])) continue;
    std::vector<std::string> parts{desktop::pretty_quantity(load[at], "N", kDigits)};
    if (at < pressure.size() && pressure[at] > 0.0)
      parts.push_back(desktop::pretty_quantity(pressure[at], "Pa", kDigits));
    if (load[at] > 0.0 && at < angle.size() && std::isfinite(angle[at]))
      parts.push_back(desktop::pretty_number(angle[at] * kDegrees, kDigits) + "°");
    out += fmt::format("{}{} {}", out.empty() ? "" : "; ", kRaces.at(race), joined(parts, ", "));
  }
  return out.empty() ? out : fmt::format("Element {}: {}.", element, out);
}

std::string RunMotionValues::describe_largest(std::size_t step) const {
  std::vector<std::string> parts;
  const auto add = [&](const char* channel, const char* name, const char* unit) {
    const auto all = values(channel, step);
    const auto at = largest(all);
    if (!at || !(all[*at] > 0.0)) return;
    parts.push_back(fmt::format("{} {} (element {}, {})", name,
                                desktop::pretty_quantity(all[*at], unit, kDigits), *at / 2 + 1,
                                kRaces.at(*at % 2)));
  };
  add("contact.load", "contact load", "N");
  add("contact.pressure", "contact pressure", "Pa");
  return parts.empty() ? std::string() : "Largest " + joined(parts, ", ") + ".";
}

std::string RunMotionValues::describe_bearing(std::size_t step) const {
  std::vector<std::string> parts;
  const auto race = values("race.angular_velocity", step);
  for (const std::size_t i : {std::size_t{1}, std::size_t{0}})
    if (i < race.size() && std::abs(race[i]) * kRpm > 0.05)
      parts.push_back(fmt::format("{} {}", i == 1 ? "Inner race" : "Outer race", speed(race[i])));
  if (const auto cage = values("cage.angular_velocity", step); !cage.empty())
    parts.push_back("Cage " + speed(std::abs(cage.front())));
  if (const auto power = values("power.loss", step); !power.empty() && std::isfinite(power.front()))
    parts.push_back("Power loss " + desktop::pretty_quantity(power.front(), "W", kDigits));
  return parts.empty() ? std::string() : joined(parts, ". ") + ".";
}

std::vector<std::string> RunMotionValues::describe(std::size_t step, int element) const {
  std::vector<std::string> out{describe_element(step, element), describe_largest(step),
                               describe_bearing(step)};
  std::erase_if(out, [](const std::string& line) { return line.empty(); });
  return out;
}

}  // namespace adore::adrinput
