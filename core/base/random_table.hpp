#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

/// A table of random numbers in which every entry has its place: entry (row, column) depends on the
/// seed, row and column alone, not on the order or number of look-ups, so that a deck and a seed
/// always make the same bearing. Integer arithmetic modulo 2^64 is the same on every platform; the
/// logarithm and cosine of the mathematical library may differ in their last digit, 1e-16 relative.
namespace adore {

class RandomTable {
 public:
  explicit RandomTable(std::uint64_t seed) noexcept : seed_(seed) {}

  /// The n-th word of SplitMix64 [Steele, Lea, Flood 2014]: state seed + (n+1) 0x9E3779B97F4A7C15,
  /// then two rounds of xor-shift and multiplication.
  [[nodiscard]] std::uint64_t word(std::uint64_t n) const noexcept {
    std::uint64_t z = seed_ + (n + 1) * 0x9E3779B97F4A7C15ULL;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31);
  }

  /// Standard normal deviate by Box and Muller, √(-2 ln u) cos 2πv, from words n = 2 (16 row +
  /// column) and n + 1; u in (0, 1], v in [0, 1) are their upper 53 bits. Columns 0 to 15.
  [[nodiscard]] double standard_normal(std::uint64_t row, std::uint64_t column) const noexcept {
    constexpr double kUnit = 1.0 / 9007199254740992.0;  // 2^-53
    const std::uint64_t n = 2 * (16 * row + column);
    const double u = static_cast<double>((word(n) >> 11) + 1) * kUnit;
    const double v = static_cast<double>(word(n + 1) >> 11) * kUnit;
    return std::sqrt(-2.0 * std::log(u)) * std::cos(2.0 * std::numbers::pi * v);
  }

 private:
  std::uint64_t seed_;
};

}  // namespace adore
