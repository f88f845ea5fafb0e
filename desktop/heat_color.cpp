#include "desktop/heat_color.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace adore::desktop {

QColor heat_color(double share) {
  constexpr std::array<std::array<double, 3>, 5> kStops{
      {{68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {253, 231, 37}}};
  const double at = std::clamp(share, 0.0, 1.0) * (kStops.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(at), kStops.size() - 2);
  const double part = at - static_cast<double>(below);
  std::array<int, 3> rgb{};
  for (std::size_t k = 0; k < 3; ++k)
    rgb[k] = static_cast<int>(
        std::lround((1.0 - part) * kStops[below][k] + part * kStops[below + 1][k]));
  return {rgb[0], rgb[1], rgb[2]};
}

}  // namespace adore::desktop
