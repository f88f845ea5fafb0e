#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace adore {

/// Fowler, Noll and Vo's FNV-1a over 64 bits: finds damage, not malice. Parts follow each other
/// with `before` the sum of the part before.
[[nodiscard]] constexpr std::uint64_t checksum(
    std::string_view text, std::uint64_t before = 0xcbf29ce484222325U) noexcept {
  for (const char c : text) before = (before ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  return before;
}

/// The same of the bytes of numbers.
[[nodiscard]] inline std::uint64_t checksum_of_values(std::span<const double> values,
                                                      std::uint64_t before) noexcept {
  return checksum({reinterpret_cast<const char*>(values.data()), values.size_bytes()}, before);
}

}  // namespace adore
