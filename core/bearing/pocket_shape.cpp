#include "bearing/pocket_shape.hpp"

#include "bearing/bearing.hpp"

#include <array>
#include <cstddef>

namespace adore::bearing {
namespace {

/// In the order of PocketShape, which is that of kPocType of balls.
constexpr std::array<std::string_view, 5> kShapeNames{"cylindrical", "spherical", "elongated",
                                                      "rectangular", "conical"};

}  // namespace

PocketShape pocket_shape(long long code, bool rollers) noexcept {
  if (rollers) return code < 0 ? PocketShape::Cylindrical : PocketShape::Rectangular;
  const bool known = code >= 0 && code < static_cast<long long>(kShapeNames.size());
  return known ? static_cast<PocketShape>(code) : PocketShape::Cylindrical;
}

int pocket_code(const Cage& cage, bool rollers) noexcept {
  if (!rollers) return static_cast<int>(cage.pocket);
  if (!cage.pocket_faces.empty()) return static_cast<int>(cage.pocket_faces.size());
  return cage.pocket == PocketShape::Cylindrical ? -1 : 0;
}

int pocket_surfaces(const Cage& cage, bool rollers) noexcept {
  if (!cage.pocket_faces.empty()) return 2 * static_cast<int>(cage.pocket_faces.size());
  if (cage.pocket != PocketShape::Rectangular) return 1;
  return rollers ? 2 : 4;
}

std::string_view name_of(PocketShape shape) noexcept {
  return kShapeNames[static_cast<std::size_t>(shape)];
}

std::optional<PocketShape> parse_pocket_shape(std::string_view name) noexcept {
  for (std::size_t i = 0; i < kShapeNames.size(); ++i)
    if (kShapeNames[i] == name) return static_cast<PocketShape>(i);
  return std::nullopt;
}

}  // namespace adore::bearing
