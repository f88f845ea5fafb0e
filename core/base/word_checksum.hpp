#pragma once

#include "base/checksum.hpp"

#include <cstddef>
#include <cstring>

namespace adore {

/// The checksum after one more word. The shift brings high bits, which a product never moves down,
/// to the low ones.
[[nodiscard]] constexpr std::uint64_t add_to_word_checksum(std::uint64_t word,
                                                           std::uint64_t before) noexcept {
  before = (before ^ word) * 0x9e3779b97f4a7c15U;
  return before ^ before >> 32U;
}

/// As checksum(), of words of 8 bytes in place of bytes, in a sixth of the time. Bytes after the
/// last whole word count as bytes: only the last part may have them.
[[nodiscard]] inline std::uint64_t word_checksum(std::string_view text,
                                                 std::uint64_t before) noexcept {
  std::size_t at = 0;
  for (std::uint64_t word = 0; at + sizeof word <= text.size(); at += sizeof word) {
    std::memcpy(&word, text.data() + at, sizeof word);
    before = add_to_word_checksum(word, before);
  }
  return checksum(text.substr(at), before);
}

/// The same of the bytes of numbers.
[[nodiscard]] inline std::uint64_t word_checksum_of_values(std::span<const double> values,
                                                           std::uint64_t before) noexcept {
  return word_checksum({reinterpret_cast<const char*>(values.data()), values.size_bytes()}, before);
}

}  // namespace adore
