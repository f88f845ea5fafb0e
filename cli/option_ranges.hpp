#pragma once

#include "base/errors.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>

/// Ranges of numeric options, defined once.
namespace adore::cli {

struct OptionRange {
  std::string_view option;
  double least, most;
  std::string_view meaning;  ///< meaning of the limits; may be empty
};
inline constexpr std::array kOptionRanges{
    OptionRange{"--threads", 0, 1024, "0: all cores"},
    OptionRange{"--lubricant", 1, 20, "kTrac of record 10.0"},
    OptionRange{"--temperature", 150, 800, "in kelvin"},
    OptionRange{"--workers", 0, 1024, "0: as many runs as cores and memory allow"},
    OptionRange{"--width", 30, 500, "in mm"},
    OptionRange{"--height", 30, 500, "in mm"},
    OptionRange{"--letters", 4, 24, "in points"},
    OptionRange{"--page", 1, 10'000, ""},
    OptionRange{"--from", 1, 1e15, "counted from 1"},
    OptionRange{"--to", 1, 1e15, "counted from 1"},
    OptionRange{"--every", 1, 1e9, ""},
    OptionRange{"--frame", 1, 1e9, "counted from 1"},
    OptionRange{"--fps", 1, 240, ""},
    OptionRange{"--slow", 1e-12, 1e6, "simulated seconds per second of the movie"},
    OptionRange{"--element", 1, 10'000, "counted from 1"},
    OptionRange{"--tols", 1e-14, 0.01, "larger tolerances do not resolve the motion"},
    OptionRange{"--turns", 0.01, 1e6, "shaft revolutions"},
    OptionRange{"--pilot", 0, 1e4, "seconds of processor time; 0: no trial run"},
    OptionRange{"--points", 3, 2001, "points of the scan"},
    OptionRange{"--budget", 1, 1e6, "seconds of processor time"},
    OptionRange{"--accuracy", 1e-6, 0.5, "a fraction: 0.01 is 1 %"},
};

/// @throws InputError "--threads is -3; give a number from 0 to 1024 (0: all cores)"
inline void check_range(std::string_view option, double value) {
  for (const OptionRange& range : kOptionRanges) {
    if (range.option != option) continue;
    if (value >= range.least && value <= range.most) return;
    throw InputError(fmt::format(
        "{} is {}; give a number from {} to {}{}", option, value, range.least, range.most,
        range.meaning.empty() ? std::string() : fmt::format(" ({})", range.meaning)));
  }
  demand(false, "no range is defined for this option");
}

}  // namespace adore::cli
