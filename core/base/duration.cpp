#include "base/duration.hpp"

#include <fmt/format.h>

#include <cmath>

namespace adore {

std::string duration_text(double seconds) {
  constexpr double kLongest = 40.0 * 86400.0;
  if (!(seconds >= 0.0 && seconds < kLongest)) return "unknown";
  if (seconds < 59.95) return fmt::format("{:.1f} s", seconds);
  const long s = std::lround(seconds);
  return s < 3600 ? fmt::format("{} min {:02} s", s / 60, s % 60)
                  : fmt::format("{} h {:02} min", s / 3600, s / 60 % 60);
}

std::string revolutions_text(double turns) {
  const std::string number = fmt::format("{:.4g}", turns);
  return number + (number == "1" ? " revolution" : " revolutions");
}

}  // namespace adore
