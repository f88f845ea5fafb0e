#pragma once

#include <cstddef>

/// Limits of everything that is read, in one place: a file of another person must not exhaust the
/// stack, the memory, the disk or the time of whoever opens it.
namespace adore {

/// Levels of a JSON or TOML value. Walking, printing, comparing and destroying such a value is
/// recursive. RUN.json and reference cases need about ten.
inline constexpr int kMaxNesting = 64;

/// Names of the nested keys of a value, joined by dots. Messages and tables store one per value.
inline constexpr std::size_t kMaxKeyPathBytes = 1000;

}  // namespace adore
