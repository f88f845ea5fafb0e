#include "validation/tolerance.hpp"

#include "base/errors.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <string>

namespace adore::validation {
namespace {

using Json = nlohmann::json;
using Scale = ToleranceRule::Scale;

bool starts(std::string_view text, std::string_view with) {
  return text.substr(0, with.size()) == with;
}
bool ends(std::string_view text, std::string_view with) {
  return text.size() >= with.size() && text.substr(text.size() - with.size()) == with;
}
bool has(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

/// Name of a tolerance entry applies to the key itself and to its variants ("M" to "M_continuum").
bool names(std::string_view entry, std::string_view key) {
  return entry == key || (starts(key, entry) && key[entry.size()] == '_');
}

/// Groups of keys that the tolerance entries rel_GROUP and abs_GROUP of README.md speak of.
bool in_group(std::string_view group, std::string_view key) {
  if (group == "depths") return has(key, "depth") || ends(key, "_offset");
  if (group == "continuum") return has(key, "continuum");
  if (group == "quaternion") return starts(key, "quaternion");
  if (group == "omega_of_magnitude") return starts(key, "omega");
  if (group == "force_N")
    return key == "Fx" || key == "Fy" || key == "Fz" || key == "Fc" || starts(key, "Q") ||
           starts(key, "F_");
  if (group == "moment_Nm")
    return key == "My" || key == "Mz" || key == "gyro_moment" || starts(key, "M_") ||
           starts(key, "roller_moment");
  if (group == "displacement_m")
    return key == "ux" || key == "uy" || key == "uz" || starts(key, "delta") ||
           has(key, "displacement");
  if (group == "rotation_rad") return key == "thy" || key == "thz" || has(key, "tilt");
  if (group == "angle_rad")
    return starts(key, "alpha") || starts(key, "azimuth") || key == "pitch_angle" ||
           starts(key, "spin_roll");
  return names(group, key);
}

double number(const Json& tolerance, const char* name) {
  return tolerance.contains(name) && tolerance[name].is_number() ? tolerance[name].get<double>()
                                                                 : 0.0;
}

/// README.md, life_* and thermal_*: rel, rel_KEY, abs, abs_KEY, relative, absolute; each entry by
/// separately. rollers_*: the same, relative to the largest entry of the array.
ToleranceRule readme_rule(const Json& tolerance, std::string_view key) {
  ToleranceRule rule;
  if (tolerance.is_number()) {
    rule.relative = tolerance.get<double>();
    return rule;
  }
  rule.relative = std::max(number(tolerance, "rel"), number(tolerance, "relative"));
  rule.absolute = std::max(number(tolerance, "abs"), number(tolerance, "absolute"));
  if (tolerance.contains("rel_omega_of_magnitude") && !tolerance.contains("rel"))
    rule.relative = number(tolerance, "rel_omega_of_magnitude");
  for (const auto& [name, value] : tolerance.items()) {
    if (!value.is_number()) continue;
    if (starts(name, "rel_") && in_group(std::string_view(name).substr(4), key)) {
      rule.relative = value.get<double>();
      if (name == "rel_omega_of_magnitude") rule.scale = Scale::Norm;
    }
    if (starts(name, "abs_") && in_group(std::string_view(name).substr(4), key)) {
      rule.absolute = value.get<double>();
      if (name == "abs_quaternion") rule.relative = 0.0;
    }
  }
  if (tolerance.contains("stiffness_rel_to_sqrt_KiiKjj") && starts(key, "stiffness_") &&
      key != "stiffness_dof_order") {
    rule.relative = number(tolerance, "stiffness_rel_to_sqrt_KiiKjj");
    rule.absolute = 0.0;
    rule.scale = Scale::Diagonal;
  }
  return rule;
}

/// cage_motion_README: max(relative · max|e over the array|, absolute_KEY or else absolute);
/// azimuths modulo 360 degrees.
ToleranceRule cage_motion_rule(const Json& tolerance, std::string_view key) {
  ToleranceRule rule;
  rule.scale = Scale::Channel;
  rule.relative = number(tolerance, "relative");
  rule.absolute = number(tolerance, "absolute");
  const std::string own = fmt::format("absolute_{}", key);
  if (tolerance.contains(own)) rule.absolute = number(tolerance, own.c_str());
  if (ends(key, "_deg")) rule.period = 360.0;
  return rule;
}

/// tribology_README: a number is relative for every key (max norm for arrays); an object has one
/// entry per key, a number or {"abs": value}.
ToleranceRule tribology_rule(const Json& tolerance, std::string_view key) {
  ToleranceRule rule;
  rule.scale = Scale::Channel;
  if (tolerance.is_number()) {
    rule.relative = tolerance.get<double>();
    return rule;
  }
  const std::string name(key);
  if (!tolerance.contains(name))
    throw InputError(fmt::format("the case has no tolerance for the expected quantity {}", name));
  const Json& own = tolerance[name];
  if (own.is_number())
    rule.relative = own.get<double>();
  else
    rule.absolute = number(own, "abs");
  return rule;
}

bool is_contact_time(std::string_view key) {
  return starts(key, "contact_") && ends(key, "_times");
}

/// dynamics_README: the entries name groups of keys.
ToleranceRule dynamics_rule(const Json& the_case, std::string_view path, std::string_view key) {
  const Json& tolerance = the_case.at("tolerance");
  const Json& expected = the_case.at("expected");
  ToleranceRule rule;
  rule.strings = false;
  rule.scale = Scale::Channel;
  rule.ignore = has(key, "residual") || starts(key, "note") ||
                starts(path, "last_sample_minus_steady") || key == "fft_bin_Hz";
  for (const char* name : {"relative", "relative_to_channel_max", "scalars_relative",
                           "frequencies_relative", "trajectory_relative_to_max"})
    if (tolerance.contains(name)) rule.relative = number(tolerance, name);
  if (tolerance.contains("trajectory_relative_to_peak") && expected.contains(std::string(key)) &&
      expected[std::string(key)].is_array())
    rule.relative = number(tolerance, "trajectory_relative_to_peak");
  if (is_contact_time(key)) {
    if (tolerance.contains("times_relative_to_last"))
      rule.relative = number(tolerance, "times_relative_to_last");
    if (tolerance.contains("times_relative_to_T")) {
      rule.relative = 0.0;
      rule.absolute =
          number(tolerance, "times_relative_to_T") * expected.at("t").back().get<double>();
    }
  }
  if (starts(key, "peak_pocket_force_") && tolerance.contains("peak_force_relative"))
    rule.relative = number(tolerance, "peak_force_relative");
  if (starts(path, "steady_state") && tolerance.contains("steady_state_relative")) {
    rule.relative = number(tolerance, "steady_state_relative");
    if (starts(key, "eigenvalues") || key == "max_real_part") {
      double largest = 0.0;
      for (const char* part : {"eigenvalues_real", "eigenvalues_imag"})
        for (const Json& value : expected.at("steady_state").at(part))
          largest = std::max(largest, std::abs(value.get<double>()));
      rule.relative = 0.0;
      rule.absolute = number(tolerance, "eigenvalues_relative_to_largest") * largest;
    }
  }
  if (key == "fft_peak_Hz") {
    rule.relative = 0.0;
    rule.absolute = number(tolerance, "fft_bins") * expected.at("fft_bin_Hz").get<double>();
  }
  constexpr std::array<std::array<std::string_view, 3>, 6> kAbsolute = {
      {{"force_absolute", "F_c", "F_t"},
       {"moment_c_t_absolute", "M_c", "M_t"},
       {"moment_n_absolute", "M_n", ""},
       {"turns_absolute", "whirl_turns", ""},
       {"r_dot_absolute", "r_dot", ""},
       {"", "", ""}}};
  for (const auto& [name, first, second] : kAbsolute) {
    if (name.empty() || (key != first && key != second) || !tolerance.contains(std::string(name)))
      continue;
    rule.relative = 0.0;
    rule.absolute = number(tolerance, std::string(name).c_str());
  }
  if (key == "heat" && tolerance.contains("heat_relative"))
    rule.relative = number(tolerance, "heat_relative");
  if (tolerance.contains("absolute_for_zero_channels")) {
    const Json& zero = tolerance["absolute_for_zero_channels"];
    rule.absolute = std::max(rule.absolute, number(zero, std::string(key).c_str()));
  }
  if (starts(key, "angles_") && tolerance.contains("angles_modulo_2pi"))
    rule.period = 6.283185307179586476925;
  return rule;
}

}  // namespace

ToleranceRule tolerance_rule(std::string_view family, std::string_view path, const Json& the_case) {
  const std::size_t dot = path.rfind('.');
  const std::string_view key = dot == std::string_view::npos ? path : path.substr(dot + 1);
  if (!the_case.contains("tolerance")) throw InputError("the case has no tolerance");
  const Json& tolerance = the_case["tolerance"];
  if (starts(family, "dynamics_")) return dynamics_rule(the_case, path, key);
  if (starts(family, "cage_") || starts(family, "motion_")) return cage_motion_rule(tolerance, key);
  if (starts(family, "tribology_")) {
    const std::string_view top = path.substr(0, path.find('.'));
    return tribology_rule(tolerance, top);
  }
  ToleranceRule rule = readme_rule(tolerance, key);
  if (starts(family, "rollers_") && rule.scale == Scale::Entry) rule.scale = Scale::Channel;
  return rule;
}

}  // namespace adore::validation
