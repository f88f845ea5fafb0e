#pragma once

#include <optional>
#include <string_view>

namespace adore::bearing {

struct Cage;

/// Shape of a cage pocket. Rollers know the cylindrical one, a cylinder about the roller, and the
/// rectangular one, a window of parallel faces or of pairs of guide faces (record 7.3).
enum class PocketShape : unsigned char { Cylindrical, Spherical, Elongated, Rectangular, Conical };

/// Shape of kPocType: 0 to 4 for balls in the order above; for rollers -1 is cylindrical, 0 a
/// window, 1 to 3 the number of pairs of guide faces. A code that means nothing (an unfinished
/// deck) reads as the shape of 0.
[[nodiscard]] PocketShape pocket_shape(long long code, bool rollers) noexcept;

/// The inverse of it: kPocType of a cage.
[[nodiscard]] int pocket_code(const Cage& cage, bool rollers) noexcept;

/// Surfaces of a pocket that an element may touch, each with separate results.
[[nodiscard]] int pocket_surfaces(const Cage& cage, bool rollers) noexcept;

/// "cylindrical" ... "conical", as inputs and listings name it.
[[nodiscard]] std::string_view name_of(PocketShape shape) noexcept;
[[nodiscard]] std::optional<PocketShape> parse_pocket_shape(std::string_view name) noexcept;

}  // namespace adore::bearing
